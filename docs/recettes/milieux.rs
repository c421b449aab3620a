//! Light, or whatever goes straight from surface to surface, through media and past opaque things: glass on a table,
//! panes and voxels, ice in a sea, lenses, mist; and the chords of a straight ray, for a dose or a projection. Solids
//! may lie one in another, overlap or stand flush.

use std::ops::ControlFlow::Continue;

use lancer_rayon::{Choix, ErreurGeo, Intersection, Monde, ObjetRay, Rayon, Reel, Tous, Vecteur};

/// After this many new rays light starts anew with δ = 0. In a room of 10 m about the origin δ is then at most 2 mm in
/// `f32`.
const TOURS: u32 = 32;

/// How many faces light goes through at most in one step, since it may be caught among solids that lie within rounding
/// of each other.
const FACES_CACHEES: u32 = 100_000;

/// Objects that lie up to this many δ behind a face are looked at, and a way out this far back is here.
const A_FLEUR: f64 = 256.0;

/// A face is known to its margins, to δ and to this many u of the lengths involved.
const ERREUR: f64 = 24.0;

/// The face of an object may lie this many u of the size of its numbers beside where it was meant to be: its centre
/// and its size round, and its normals by 6u.
const ARRONDI: f64 = 16.0;

/// What an object is made of, by its index in the list. An object without an entry is opaque.
///
/// Where several media hold a place, the one of the highest priority counts, at equal priority the last in the list.
/// `indice` is the index of refraction; outside all media it is 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Matiere {
    /// It stops light.
    Opaque,
    /// All of the object is filled.
    Pleine { priorite: u32, indice: f64 },
    /// Only what it has in common with the object `avec` is filled. A lens is what two balls have in common: both are
    /// described so, each with the other.
    Commune { avec: usize, priorite: u32, indice: f64 },
}

/// The part of a straight ray that lies in the medium of an object, between two distances from its source.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corde<R> {
    pub objet: usize,
    pub de: R,
    pub a: R,
}

/// Where light arrives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surface<R> {
    /// The hit or the way out of the object `objet`. Its `indice()` is 0 for a way out, and its `distance()` may count
    /// from a later place than where the light started.
    pub touche: Intersection<R>,
    pub objet: usize,
    /// How far light has come to it.
    pub distance: R,
    pub derriere: Derriere,
}

/// What is behind a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Derriere {
    Opaque,
    /// The medium of the object of this index, or none.
    Milieu(Option<usize>),
}

/// A walk through a world. It goes straight on through all faces behind which the same medium counts, and tells where
/// another medium or an opaque thing begins. Where light comes out of a medium, faces that lie within rounding of each
/// other are one surface, so that no film of air comes between flush media, and the table is found on which a glass
/// stands. Light that starts between two such faces is in a film that is there by rounding alone, and
/// [`passer`](Self::passer) lets it out.
///
/// At one place light leaves each object at most once, unless it is turned there into it, and so passes where overlapping
/// media meet in a re-entrant edge. Bound the number of surfaces of a path all the same, since light may be trapped by
/// mirrors, as in a ball that it grazes from within, or in the tip between faces that all send it back. A walk allocates
/// until it has been in as many objects at once, and met as many at one place, as it ever does, and then no more: keep it
/// for many rays.
#[derive(Clone)]
pub struct Marche<'a, R = f64, C = Tous> {
    monde: Monde<'a, R, C>,
    matieres: &'a [Matiere],
    rayon: Rayon<R>,
    /// The objects that light is in, none of them opaque, in any order.
    dans: Vec<usize>,
    /// The same behind the surface that was found last; empty once light has gone on from it.
    apres: Vec<usize>,
    /// What light is not in, and has left where it stands or met there behind a face that sent it back. From there it
    /// goes into one of these only if it goes deeper than the error, so that it leaves each at most once at one place.
    ici: Vec<usize>,
    /// How far this place goes: the error of the face that was found last.
    erreur: R,
    /// Which way is through the face at which light waits, and through those at this place that sent it back.
    face: Option<Vecteur<R>>,
    renvois: Vec<Vecteur<R>>,
    /// How many rays there were since δ was 0.
    tours: u32,
    /// Where the ray of a chord enters an object, or leaves it.
    bords: Vec<(R, bool, usize)>,
    /// The objects that the ray of a chord is in.
    traverses: Vec<usize>,
    cordes: Vec<Corde<R>>,
}

impl<'a, R: Reel, C: Choix + Copy> Marche<'a, R, C> {
    /// A walk that goes nowhere yet.
    pub fn new(monde: Monde<'a, R, C>, matieres: &'a [Matiere]) -> Self {
        let rayon = Rayon::new(Vecteur::NUL, Vecteur::X).expect("a direction");
        let [dans, apres, ici, traverses] = [(); 4].map(|()| vec![]);
        let (bords, cordes, erreur) = (vec![], vec![], R::ZERO);
        Self {
            monde,
            matieres,
            rayon,
            dans,
            apres,
            ici,
            erreur,
            face: None,
            renvois: vec![],
            tours: 0,
            bords,
            traverses,
            cordes,
        }
    }

    /// Starts with this ray, in the media that hold its source. An opaque thing that holds it, as a table does from
    /// which light starts by coordinates, counts for nothing. Whether the ray is inside and where it ends count for
    /// nothing either.
    pub fn partir(&mut self, rayon: Rayon<R>) {
        let Self { monde, matieres, dans, .. } = self;
        dans.clear();
        monde.contenants(rayon.source(), |i| dans.extend((!opaque(matieres, i)).then_some(i)));
        self.commencer(rayon);
    }

    /// Starts with this ray in these objects, as after [`dans`](Self::dans) of another walk.
    pub fn reprendre(&mut self, rayon: Rayon<R>, dans: impl IntoIterator<Item = usize>) {
        self.dans.clear();
        self.dans.extend(dans.into_iter().filter(|&i| !opaque(self.matieres, i)));
        self.commencer(rayon);
    }

    fn commencer(&mut self, rayon: Rayon<R>) {
        self.apres.clear();
        self.ici.clear();
        // What the last face of another ray was off by says nothing of this start.
        (self.rayon, self.tours, self.erreur) = (rayon.dehors(), 0, R::ZERO);
        self.face = None;
        self.renvois.clear();
    }

    /// The world that it goes through.
    pub fn monde(&self) -> Monde<'a, R, C> {
        self.monde
    }

    /// The ray on which light goes.
    pub fn rayon(&self) -> Rayon<R> {
        self.rayon
    }

    /// The objects that light is in.
    pub fn dans(&self) -> &[usize] {
        &self.dans
    }

    /// The object whose medium light is in, before the surface at which it waits; `None` outside all media. Where light
    /// stands on a surface because it started there or its step ended there, this is known only after the next
    /// [`avancer`](Self::avancer).
    pub fn milieu(&self) -> Option<usize> {
        regne(self.matieres, &self.dans)
    }

    /// Goes this far, or to the next surface if one comes first. After a step without a surface light stands at its
    /// end, in mid-air; +∞ is a step without an end. At a surface light waits for [`passer`](Self::passer),
    /// [`entrer`](Self::entrer) or [`rester`](Self::rester). A step through 100,000 faces ends at the last of them.
    ///
    /// # Errors
    /// If `pas` is below 0 or a NaN, if light comes too far from the origin, or if an object is lost in rounding.
    pub fn avancer(&mut self, pas: R) -> Result<Option<Surface<R>>, ErreurGeo> {
        let _ = self.rayon.jusqu_a(pas).map_err(|refus| ErreurGeo { champ: "pas", ..refus })?;
        self.apres.clear();
        self.face = None;
        let mut parcouru = R::ZERO;
        for _ in 0..FACES_CACHEES {
            let reste = if parcouru > pas { R::ZERO } else { pas - parcouru };
            let premiere = self.premiere(reste)?;
            let jusque_la = premiere.map_or(reste, |(_, _, t)| t);
            if self.tours >= TOURS && jusque_la > R::ZERO && jusque_la < R::INFINI {
                let milieu = jusque_la / (R::UN + R::UN);
                if self.recommencer(milieu)? {
                    parcouru = parcouru + milieu;
                    continue;
                }
            }
            let Some((touche, objet, _)) = premiere else {
                if reste < R::INFINI {
                    self.avance_de(reste);
                    self.suivre(self.rayon.bifurque(reste, self.rayon.direction())?);
                }
                return Ok(None);
            };
            parcouru = parcouru + jusque_la;
            self.avance_de(jusque_la);
            let (touche, objet, derriere) = self.derriere(touche, objet)?;
            if derriere != Derriere::Milieu(self.milieu()) {
                return Ok(Some(Surface { touche, objet, distance: parcouru, derriere }));
            }
            self.entrer(touche.secondaire(self.rayon.direction())?);
        }
        Ok(None)
    }

    /// Turns where light stands in mid-air: it was scattered.
    ///
    /// # Errors
    /// If the direction is zero or not finite.
    pub fn tourner(&mut self, direction: Vecteur<R>) -> Result<(), ErreurGeo> {
        self.rester(self.rayon.bifurque(R::ZERO, direction)?);
        Ok(())
    }

    /// Goes on with this ray in the media before the surface: what a mirror or an opaque thing sends back, or a ray to
    /// a lamp.
    pub fn rester(&mut self, rayon: Rayon<R>) {
        let Self { dans, apres, ici, .. } = self;
        ici.retain(|i| !apres.contains(i));
        ici.extend(apres.drain(..).filter(|i| !dans.contains(i)));
        self.renvois.extend(self.face);
        self.suivre(rayon);
    }

    /// Goes on with this ray in the media behind the surface that [`avancer`](Self::avancer) found last.
    pub fn entrer(&mut self, rayon: Rayon<R>) {
        let Self { dans, apres, ici, .. } = self;
        std::mem::swap(dans, apres);
        ici.retain(|i| !dans.contains(i));
        ici.extend(apres.drain(..).filter(|i| !dans.contains(i)));
        self.suivre(rayon);
    }

    fn suivre(&mut self, rayon: Rayon<R>) {
        // `dans` tells what light is in, and questions leave that out; light may touch anything else at once.
        self.rayon = rayon.dehors();
        self.face = None;
        self.tours += 1;
    }

    /// Light goes this far, and so perhaps away from what is in `ici`.
    fn avance_de(&mut self, distance: R) {
        if distance <= self.erreur {
            return;
        }
        self.renvois.clear();
        if !self.ici.is_empty() {
            let (objets, la) = (self.monde.objets(), self.rayon.point(distance));
            self.ici.retain(|&i| objets[i].contient(la));
        }
    }

    /// Goes through the surface that was found last, by Snell's law, or is mirrored there where no light passes or an
    /// opaque thing stands; whether it passes. Light that total reflection would send back to a face which has sent it
    /// here, both at one place, is in a film that is there by rounding alone, and goes straight on.
    ///
    /// # Errors
    /// If the indices of two media differ more than a hundredfold or are not above 0, or if an object is lost in
    /// rounding.
    pub fn passer(&mut self, surface: &Surface<R>) -> Result<bool, ErreurGeo> {
        let (touche, d) = (&surface.touche, self.rayon.direction());
        let Derriere::Milieu(derriere) = surface.derriere else {
            self.rester(touche.reflechi(d)?);
            return Ok(false);
        };
        let avant = indice(self.matieres, self.milieu());
        let rapport = R::depuis_f64(avant / indice(self.matieres, derriere));
        let passe =
            if rapport == R::UN { touche.secondaire(d) } else { touche.refracte(d, rapport) };
        match passe {
            Ok(rayon) => self.entrer(rayon),
            // Total reflection.
            Err(refus) if refus.champ == "refraction" => {
                let retour = touche.reflechi(d)?;
                let revient =
                    |vers: &Vecteur<R>| vers.produit_scalaire(retour.direction()) > R::ZERO;
                if !self.renvois.iter().any(revient) {
                    self.rester(retour);
                    return Ok(false);
                }
                self.entrer(touche.secondaire(d)?);
            }
            Err(refus) => return Err(refus),
        }
        Ok(true)
    }

    /// Starts anew with δ = 0 at this distance, if light is there in what it should be in and in no wall; whether it
    /// does. At a bounce, or where a step ends on a wall, the place might lie in a seam. Where light goes along the face of
    /// a medium that holds the place by less than half of δ, that depth is its δ.
    fn recommencer(&mut self, distance: R) -> Result<bool, ErreurGeo> {
        let Self { monde, matieres, dans, rayon, .. } = self;
        let objets = monde.objets();
        let suite = Rayon::new(rayon.point(distance), rayon.direction())?;
        let place = fois_u(norme(suite.source().into()), ERREUR);
        let (mut connus, mut au_bord, mut flou) = (0, true, R::ZERO);
        monde.contenants(suite.source(), |i| {
            if dans.contains(&i) {
                connus += 1;
                return;
            }
            let dehors = place + arrondi(&objets[i]) + profondeur(&objets[i], suite.source());
            au_bord &= !opaque(matieres, i) && dehors + dehors <= rayon.flou();
            flou = if dehors > flou { dehors } else { flou };
        });
        if !au_bord || connus != dans.len() {
            return Ok(false);
        }
        (self.rayon, self.tours) = (suite.avec_flou(flou)?, 0);
        self.ici.clear();
        Ok(true)
    }

    /// The first face before this distance, of whatever object, with the object and the distance.
    fn premiere(&mut self, fin: R) -> Result<Option<(Intersection<R>, usize, R)>, ErreurGeo> {
        let (objets, depart) = (self.monde.objets(), self.rayon);
        let sans_fin = depart.jusqu_a(R::INFINI)?;
        let mut entree_ici = None;
        self.ici.retain(|&i| {
            let Some(de) = va_dans(&objets[i], &sans_fin, self.erreur) else { return true };
            let touche = |rayon: &Rayon<R>| {
                objets[i].intersection(rayon).ok().filter(|touche| touche.distance() == R::ZERO)
            };
            if de > R::ZERO || touche(&sans_fin).is_some() {
                return false;
            }
            // Deeper than δ, since it is only now that light turns into it.
            let jeu = self.erreur + arrondi(&objets[i]);
            let entree = sans_fin.avec_flou(depart.flou() + jeu + jeu).ok();
            let entree = entree.and_then(|rayon| touche(&rayon));
            entree_ici = entree.map(|touche| (touche, i, R::ZERO)).or(entree_ici);
            entree.is_some()
        });
        if entree_ici.is_some() {
            return Ok(entree_ici);
        }
        let (mut premier, mut sortie, mut ici) = (None, fin, None);
        let quittes = &mut self.ici;
        self.dans.retain(|&i| match objets[i].traversee(&sans_fin) {
            // A sea that light goes down in has its way out at +∞.
            Ok([_, a]) => {
                if a < sortie {
                    (premier, sortie) = (Some(i), a);
                }
                true
            }
            // It was left by rounding: light entered it beside an edge, or a step ended at its surface.
            Err(_) => {
                let touche = sortie_ici(&objets[i], &depart);
                ici = touche.map(|touche| (touche, i, R::ZERO)).or(ici);
                quittes.extend(touche.is_none().then_some(i));
                touche.is_some()
            }
        });
        if ici.is_some() {
            return Ok(ici);
        }
        let rayon = depart.jusqu_a(sortie)?;
        // What light is in is left out here, so that no rounding makes it touch that at once.
        let Self { monde, dans, ici, .. } = &*self;
        let entree = match (&dans[..], &ici[..]) {
            ([], []) => monde.premiere_intersection(&rayon),
            (&[i], []) | ([], &[i]) => monde.sans(i).premiere_intersection(&rayon),
            _ => monde
                .parmi(|i| !dans.contains(&i) && !ici.contains(&i))
                .premiere_intersection(&rayon),
        };
        let entree = entree.ok().map(|touche| (touche, touche.indice(), touche.distance()));
        Ok(entree.or_else(|| Some((objets[premier?].sortie(&sans_fin).ok()?, premier?, sortie))))
    }

    /// What is behind this face, and the face of the opaque thing if there is one flush with it.
    ///
    /// Light leaves what holds no place behind the face that is deeper than the error of the face, since the next ray
    /// may start beyond it. Where light comes out, or into a lower index, a film that is there by rounding alone might
    /// mirror it. So it goes into what lies so near behind that rounding may have set the two apart.
    fn derriere(
        &mut self,
        touche: Intersection<R>,
        objet: usize,
    ) -> Result<(Intersection<R>, usize, Derriere), ErreurGeo> {
        let avant = self.milieu();
        let Self { monde, matieres, dans, apres, ici, rayon, .. } = self;
        let (objets, d) = (monde.objets(), rayon.direction());
        let entre = d.produit_scalaire(touche.normale()) < R::ZERO;
        let devant = if entre { -touche.normale() } else { touche.normale() };
        let longueur = norme(touche.point().into()) + touche.distance();
        let erreur = rayon.flou() + touche.marge() + touche.marge() + fois_u(longueur, ERREUR);
        (self.erreur, self.face) = (erreur, Some(devant));
        if entre && opaque(matieres, objet) {
            return Ok((touche, objet, Derriere::Opaque));
        }
        let place = touche.point() + devant * erreur;
        apres.clear();
        // What the place along N is out of, light may still go deeper into.
        let va_plus_loin = |i: usize| {
            let de = va_dans(&objets[i], &touche.secondaire(d).ok()?, erreur)?;
            (de <= erreur).then_some(())
        };
        let garde = |i: usize| objets[i].contient(place) || va_plus_loin(i).is_some();
        apres.extend(dans.iter().copied().filter(|&i| i != objet && garde(i)));
        apres.extend(entre.then_some(objet));
        let derriere = regne(matieres, apres);
        if derriere == avant || (entre && indice(matieres, derriere) >= indice(matieres, avant)) {
            return Ok((touche, objet, Derriere::Milieu(derriere)));
        }
        let sonde = touche.secondaire(devant)?.dehors();
        let fin = erreur * R::depuis_f64(A_FLEUR);
        let sonde = sonde.jusqu_a(fin)?;
        let a_fleur = |i: usize, t: R| t <= erreur + arrondi(&objets[i]);
        let suite = touche.secondaire(d)?;
        let mut un_opaque = false;
        monde.visiter(&sonde, |i, t| {
            if a_fleur(i, t) {
                if opaque(matieres, i) {
                    un_opaque = true;
                } else if !apres.contains(&i)
                    && !ici.contains(&i)
                    && va_dans(&objets[i], &suite, erreur).is_some()
                {
                    apres.push(i);
                }
            }
            Continue(fin)
        });
        if un_opaque {
            let contre = monde.parmi(|i| opaque(matieres, i)).premiere_intersection(&sonde);
            if let Ok(contre) = contre
                && a_fleur(contre.indice(), contre.distance())
                && contre.normale().produit_scalaire(d) < R::ZERO
            {
                self.erreur = erreur + arrondi(&objets[contre.indice()]);
                return Ok((contre, contre.indice(), Derriere::Opaque));
            }
        }
        Ok((touche, objet, Derriere::Milieu(regne(matieres, apres))))
    }

    /// What this ray goes through in a straight line until it ends or comes to an opaque thing, in order. Each length
    /// counts once, for the medium that counts there; between two media there may be none. All distances count from
    /// the source of the ray as it stands, whatever its δ, so that no step from face to face adds to their errors. The
    /// walk stays where it is.
    pub fn cordes(&mut self, rayon: &Rayon<R>) -> &[Corde<R>] {
        let Self { monde, matieres, bords, traverses, cordes, .. } = self;
        let objets = monde.objets();
        bords.clear();
        cordes.clear();
        let mut fin = rayon.fin();
        let mut noter = |i: usize| {
            let part = objets[i].traversee(rayon).into_iter().filter(|[de, a]| de < a);
            bords.extend(part.flat_map(|[de, a]| [(de, true, i), (a, false, i)]));
        };
        monde.contenants(rayon.source(), |i| {
            if !opaque(matieres, i) {
                noter(i);
            }
        });
        // A ray inside touches nothing at once; what holds the source was noted above.
        monde.visiter(&rayon.dedans(), |i, t| {
            if !opaque(matieres, i) {
                noter(i);
            } else if t < fin {
                fin = t;
            }
            Continue(fin)
        });
        bords.sort_unstable_by(|a, b| a.partial_cmp(b).expect("no distance is a NaN"));
        traverses.clear();
        let mut depuis: Option<Corde<R>> = None;
        for &(t, entre, i) in bords.iter() {
            if entre {
                traverses.push(i);
            } else {
                traverses.retain(|&j| j != i);
            }
            let objet = regne(matieres, traverses);
            if depuis.map(|corde| corde.objet) == objet {
                continue;
            }
            cordes.extend(depuis.map(|corde| Corde { a: t, ..corde }));
            depuis = objet.map(|objet| Corde { objet, de: t, a: t });
        }
        // Where much happens at one place, some are of no length; and what is behind the opaque thing does not count.
        cordes.retain_mut(|corde| {
            corde.a = if corde.a < fin { corde.a } else { fin };
            corde.de < corde.a
        });
        cordes
    }
}

fn opaque(matieres: &[Matiere], objet: usize) -> bool {
    matieres.get(objet).is_none_or(|matiere| *matiere == Matiere::Opaque)
}

/// The index of refraction in the medium of this object, or outside all.
fn indice(matieres: &[Matiere], milieu: Option<usize>) -> f64 {
    match milieu.map(|i| matieres[i]) {
        Some(Matiere::Pleine { indice, .. } | Matiere::Commune { indice, .. }) => indice,
        Some(Matiere::Opaque) | None => 1.0,
    }
}

/// The object whose medium counts at a place that lies in these objects.
fn regne(matieres: &[Matiere], dans: &[usize]) -> Option<usize> {
    let rang = |i: usize| match *matieres.get(i)? {
        Matiere::Opaque => None,
        Matiere::Pleine { priorite, .. } => Some((priorite, i)),
        Matiere::Commune { avec, priorite, .. } => dans.contains(&avec).then_some((priorite, i)),
    };
    dans.iter().filter_map(|&i| rang(i)).max().map(|(_, i)| i)
}

/// The way out of an object at the start of a ray that is out of it by no more than the δ of the ray.
fn sortie_ici<R: Reel>(objet: &ObjetRay<R>, rayon: &Rayon<R>) -> Option<Intersection<R>> {
    let d = rayon.direction();
    let retour = |vers: Vecteur<R>| {
        let retour = Rayon::new(rayon.source(), vers).ok()?.avec_flou(rayon.flou()).ok()?;
        let touche = objet.intersection(&retour).ok();
        touche.filter(|touche| touche.normale().produit_scalaire(d) > R::ZERO)
    };
    let touche = retour(-d)?;
    // Light that grazes would have to go far back, and that would be another place.
    let pres = touche.distance() <= rayon.flou() * R::depuis_f64(A_FLEUR);
    retour(-touche.normale()).or(pres.then_some(touche))
}

/// Where a ray that starts within this error of an object goes deeper into it, or comes to it later.
fn va_dans<R: Reel>(objet: &ObjetRay<R>, rayon: &Rayon<R>, erreur: R) -> Option<R> {
    let [de, a] = objet.traversee(rayon).ok()?;
    // How deep it is, before the face by which it goes out.
    let profond = |sortie: Intersection<R>| {
        sortie.distance() * sortie.normale().produit_scalaire(rayon.direction())
    };
    let va = de > erreur || a == R::INFINI || profond(objet.sortie(rayon).ok()?) > erreur;
    va.then_some(de)
}

/// How far the surface of an object is from this place in it, as seen along its normals.
fn profondeur<R: Reel>(objet: &ObjetRay<R>, place: Vecteur<R>) -> R {
    let vers = |vers: Vecteur<R>| {
        let sortie = Rayon::new(place, vers).ok().and_then(|rayon| objet.sortie(&rayon).ok());
        sortie.map_or(R::INFINI, |sortie| sortie.distance())
    };
    let plus_pres = |a, b| if a < b { a } else { b };
    match objet {
        ObjetRay::Sphere(boule) => vers(place - boule.centre()),
        ObjetRay::Plan(plan) => vers(plan.normale()),
        ObjetRay::Boite(boite) => boite
            .normales()
            .into_iter()
            .flat_map(|n| [vers(n), vers(-n)])
            .fold(R::INFINI, plus_pres),
    }
}

/// How far rounding may have set the face of an object beside where it was meant to be.
fn arrondi<R: Reel>(objet: &ObjetRay<R>) -> R {
    let taille = match objet {
        ObjetRay::Sphere(boule) => norme(boule.centre().into()) + boule.rayon(),
        ObjetRay::Plan(plan) => plan.distance().absolu(),
        ObjetRay::Boite(boite) => norme(boite.centre().into()) + norme(boite.demi_longueurs()),
    };
    fois_u(taille, ARRONDI)
}

fn fois_u<R: Reel>(longueur: R, n: f64) -> R {
    longueur * (R::depuis_f64(n) * R::U)
}

fn norme<R: Reel>(p: [R; 3]) -> R {
    p.into_iter().fold(R::ZERO, |somme, x| somme + x.absolu())
}
