//! Sixteen rays with the first object of each so far: the search and the conclusion, side by side.
//!
//! Plain loops call the same formulae of [`Forme`] as for a single ray, and the compiler vectorises
//! them. Every instruction set rounds a sum, a product, a quotient and a root alike, so that every
//! ray gets the bits that it gets alone. What the loops call, closures too, is `inline(always)`: a
//! function that is not inlined would be compiled for the baseline instruction set.

use crate::cote_a_cote::colonne::{Colonne, LARGEUR, le_plus_grand, retirer};
use crate::objet::forme::Forme;
use crate::objet::par_forme;
use crate::question::Premier;
use crate::rayon::intersection::{Contact, Rang};
use crate::{Intersection, NoIntersection, Nombre, ObjetRay, Rayon, Reponse, Vecteur};

/// The rays of a group: a column has one number of each.
pub(crate) const VOIES: usize = LARGEUR;

/// With fewer rays than this on one object, hits are concluded one by one: 5 % faster for rays in
/// no order among 12 objects, and as fast for tiles (measured).
const COTE_A_COTE: u32 = 3;

/// Sixteen rays, their sources S and directions D, the distance of the first object of each so far,
/// and its rank. Each column fills cache lines.
#[repr(align(64))]
pub(crate) struct Groupe<R> {
    pub(crate) s: [Colonne<R>; 3],
    pub(crate) d: [Colonne<R>; 3],
    /// The δ to which each ray touches at once.
    deltas: Colonne<R>,
    t: Colonne<R>,
    rangs: Colonne<Option<Rang>>,
}

impl<R: Nombre> Groupe<R> {
    pub(crate) const VIDE: Self = Self {
        s: [[R::ZERO; VOIES]; 3],
        d: [[R::ZERO; VOIES]; 3],
        deltas: [R::ZERO; VOIES],
        t: [R::INFINI; VOIES],
        rangs: [None; VOIES],
    };

    /// Loads these rays, at most sixteen, with no object so far; the last stands in for those that
    /// are missing. Returns whether some ray has a δ above 0.
    #[inline(always)]
    pub(crate) fn charger(&mut self, rayons: &[Rayon<R>]) -> bool {
        if let Some(rayons) = rayons.first_chunk() {
            self.copier(rayons);
        } else if let Some(dernier) = rayons.last() {
            let mut complets = [*dernier; VOIES];
            complets[..rayons.len()].copy_from_slice(rayons);
            self.copier(&complets);
        }
        le_plus_grand(self.deltas) > R::ZERO
    }

    #[inline(always)]
    fn copier(&mut self, rayons: &[Rayon<R>; VOIES]) {
        self.rangs = [None; VOIES];
        for (voie, rayon) in rayons.iter().enumerate() {
            let (s, d) = (rayon.source(), rayon.direction());
            [self.s[0][voie], self.s[1][voie], self.s[2][voie]] = s.into();
            [self.d[0][voie], self.d[1][voie], self.d[2][voie]] = d.into();
            self.t[voie] = rayon.fin();
            self.deltas[voie] = rayon.flou.d_emblee();
        }
    }

    /// The ray of one lane, without its end.
    #[inline(always)]
    pub(crate) fn rayon(&self, voie: usize) -> Rayon<R> {
        let ([sx, sy, sz], [dx, dy, dz]) = (&self.s, &self.d);
        let s = Vecteur::new(sx[voie], sy[voie], sz[voie]);
        let d = Vecteur::new(dx[voie], dy[voie], dz[voie]);
        Rayon::en_nombres(s, d, R::INFINI, self.deltas[voie])
    }

    /// The first object of one ray so far.
    #[inline(always)]
    pub(crate) fn premier(&self, voie: usize) -> Premier<R> {
        Premier { t: self.t[voie], rang: self.rangs[voie] }
    }

    /// Keeps this as the first object of one ray so far.
    #[inline(always)]
    pub(crate) fn noter(&mut self, voie: usize, Premier { t, rang }: Premier<R>) {
        (self.t[voie], self.rangs[voie]) = (t, rang);
    }

    /// How many rays have found no object.
    #[inline(always)]
    pub(crate) fn sans_objet(&self) -> u32 {
        self.rangs.iter().map(|rang| u32::from(rang.is_none())).sum()
    }

    /// The largest distance before which a ray looks for an object; 0 if all are done, each at its
    /// first object where that suffices.
    #[inline(always)]
    pub(crate) fn le_plus_loin(&self, un_suffit: bool) -> R {
        let mut t = self.t;
        if un_suffit {
            for (t, rang) in t.iter_mut().zip(&self.rangs) {
                *t = if rang.is_some() { R::ZERO } else { *t };
            }
        }
        le_plus_grand(t)
    }

    /// Makes the object of this shape and rank the first of each ray that enters it before its
    /// first so far.
    ///
    /// At the same distance the object of lower rank is the first. `d_emblee` says that some ray
    /// has a δ above 0 and may start in the object.
    #[inline(always)]
    pub(crate) fn proposer(&mut self, forme: &impl Forme<R>, rang: Rang, d_emblee: bool) {
        let mut pres = false;
        for voie in 0..VOIES {
            pres |= forme.peut_entrer(&self.rayon(voie));
        }
        // Roots and quotients are computed only if at least one ray may enter.
        if !pres {
            return;
        }
        // All lanes compute a distance, and a second loop keeps those that come first: with a
        // branch for each lane neither loop would be vectorised.
        let mut t = [R::INFINI; VOIES];
        if d_emblee {
            self.toucher(forme, &mut t);
        } else {
            for (voie, t) in t.iter_mut().enumerate() {
                *t = forme.t(&self.rayon(voie));
            }
        }
        for (voie, &t) in t.iter().enumerate() {
            let (trouve, premier) = (Premier { t, rang: Some(rang) }, self.premier(voie));
            let precede = trouve.precede(premier);
            self.t[voie] = if precede { t } else { premier.t };
            self.rangs[voie] = if precede { trouve.rang } else { premier.rang };
        }
    }

    /// The distances at which these rays touch this shape, 0 if at once.
    #[inline(always)]
    fn toucher(&self, forme: &impl Forme<R>, t: &mut Colonne<R>) {
        let mut contient = false;
        for (voie, t) in t.iter_mut().enumerate() {
            let rayon = self.rayon(voie);
            let (entree, contient_la_source) = forme.t_et_contient(&rayon);
            *t = entree;
            contient |= contient_la_source & (rayon.flou.d_emblee() > R::ZERO);
        }
        if !contient {
            return;
        }
        for (voie, t) in t.iter_mut().enumerate() {
            let rayon = self.rayon(voie);
            let d_emblee = (rayon.flou.d_emblee() > R::ZERO) & forme.des_le_depart(&rayon);
            *t = if d_emblee { R::ZERO } else { *t };
        }
    }
}

/// What is said of a first object: a hit, or whether there is one.
pub(crate) trait Conclure<R: Nombre> {
    type Dit;

    /// Says it of one ray.
    fn dire(self, rayon: &Rayon<R>, objets: &[ObjetRay<R>]) -> Self::Dit;

    /// Writes it for each ray of a group, which holds these rays.
    fn ecrire(
        groupe: &Groupe<R>,
        objets: &[ObjetRay<R>],
        rayons: &[Rayon<R>],
        dits: &mut [Self::Dit],
    );
}

impl<R: Nombre> Conclure<R> for Premier<R, true> {
    type Dit = bool;

    #[inline(always)]
    fn dire(self, _: &Rayon<R>, _: &[ObjetRay<R>]) -> bool {
        self.rang.is_some()
    }

    #[inline(always)]
    fn ecrire(groupe: &Groupe<R>, _: &[ObjetRay<R>], _: &[Rayon<R>], occultes: &mut [bool]) {
        for (occulte, rang) in occultes.iter_mut().zip(&groupe.rangs) {
            *occulte = rang.is_some();
        }
    }
}

impl<R: Nombre> Conclure<R> for Premier<R> {
    type Dit = Reponse<R>;

    #[inline(always)]
    fn dire(self, rayon: &Rayon<R>, objets: &[ObjetRay<R>]) -> Reponse<R> {
        self.reponse(rayon, objets)
    }

    /// For each object that is the first of some ray, the hits of all its rays.
    #[inline(always)]
    fn ecrire(
        groupe: &Groupe<R>,
        objets: &[ObjetRay<R>],
        rayons: &[Rayon<R>],
        touches: &mut [Reponse<R>],
    ) {
        let rayons = &rayons[..touches.len()];
        let mut contacts = Contacts::VIDES;
        let mut restent = 0;
        for (voie, touche) in touches.iter_mut().enumerate() {
            *touche = Err(NoIntersection);
            restent |= u32::from(groupe.rangs[voie].is_some()) << voie;
        }
        let valides = restent;
        while let Some(voie) = retirer(&mut restent) {
            let Some(rang) = groupe.rangs[voie] else { return };
            let Some(objet) = objets.get(rang.indice()) else { return };
            let mut siens = 0;
            for voie in 0..VOIES {
                siens |= u32::from(groupe.rangs[voie] == Some(rang)) << voie;
            }
            // What stands in for missing rays has no answer.
            siens &= valides;
            restent &= !siens;
            let cote_a_cote = siens.count_ones() >= COTE_A_COTE;
            if cote_a_cote {
                par_forme!(ObjetRay, objet, forme => contacts.calculer(groupe, *forme));
            }
            let texture = objet.texture();
            while let Some(voie) = retirer(&mut siens) {
                let (rayon, t) = (&rayons[voie], groupe.t[voie]);
                // Each arm builds the hit in its place: copying one just built would stall until
                // its fields are stored.
                if cote_a_cote && contacts.de_face[voie] {
                    let contact = contacts.de(voie);
                    let delta = rayon.flou();
                    touches[voie] = Ok(Intersection { distance: t, contact, delta, texture, rang });
                } else {
                    touches[voie] = objet.touche(rayon, t, rang);
                }
            }
        }
    }
}

/// The hits of sixteen rays on one shape, computed for all lanes; the caller keeps the valid ones.
#[repr(align(64))]
struct Contacts<R> {
    normale: [Colonne<R>; 3],
    marge: Colonne<R>,
    point: [Colonne<R>; 3],
    de_face: Colonne<bool>,
}

impl<R: Nombre> Contacts<R> {
    const VIDES: Self = Self {
        normale: [[R::ZERO; VOIES]; 3],
        marge: [R::ZERO; VOIES],
        point: [[R::ZERO; VOIES]; 3],
        de_face: [false; VOIES],
    };

    #[inline(always)]
    fn calculer(&mut self, groupe: &Groupe<R>, forme: impl Forme<R>) {
        let Self { normale: [nx, ny, nz], marge, point: [px, py, pz], de_face } = self;
        for voie in 0..VOIES {
            let (contact, face) = forme.contact(&groupe.rayon(voie), groupe.t[voie]);
            [nx[voie], ny[voie], nz[voie]] = contact.normale.into();
            [px[voie], py[voie], pz[voie]] = contact.point.into();
            (marge[voie], de_face[voie]) = (contact.marge, face);
        }
    }

    /// The hit of one ray.
    #[inline(always)]
    fn de(&self, voie: usize) -> Contact<R> {
        let vecteur = |[x, y, z]: &[Colonne<R>; 3]| Vecteur::new(x[voie], y[voie], z[voie]);
        let (normale, point) = (vecteur(&self.normale), vecteur(&self.point));
        Contact { normale, marge: self.marge[voie], point }
    }
}
