//! Paths of several bounces: mirrors, glass, lamps, suns, other hits and turns in mid-air, one after another; and what each
//! ray of a path knows of its start.

use lancer_rayon::pour_les_tests::{FLOU_RELATIF, PAS_D_EMBLEE, PAS_D_EMBLEE_POINT};
use lancer_rayon::{Intersection, Monde, Rayon, Reel, Vecteur};

use crate::conversion::{Bits, Mots, mots};
use crate::mesure::poids;
use crate::passages::{
    coordonnees, est_a_fleur, exiger_le_retour, exiger_un_passage, exiger_une_suite, flou_du_point,
    profondeur,
};
use crate::tolerances::u;

/// How a path goes on.
#[derive(Debug, Clone, Copy)]
pub enum Suite {
    Reflechi,
    Secondaire,
    /// A secondary ray in the direction of the one that came: into glass, and out of it.
    ToutDroit,
    Soleil,
    Lumiere,
    /// To the hit before.
    Touche,
    /// A turn in mid-air, or where the ray enters something.
    Bifurque,
}

impl Suite {
    pub const TOUTES: [Self; 7] = [
        Self::Reflechi,
        Self::Secondaire,
        Self::ToutDroit,
        Self::Soleil,
        Self::Lumiere,
        Self::Touche,
        Self::Bifurque,
    ];
}

/// One step of a path.
#[derive(Debug, Clone, Copy)]
pub struct Pas<R> {
    pub suite: Suite,
    /// A direction, or a point if `vise`.
    pub vers: Vecteur<R>,
    pub vise: bool,
    /// How far the ray goes before it turns in mid-air.
    pub distance: R,
}

/// Where a path has come to.
struct Marcheur<'a, R> {
    monde: Monde<'a, R>,
    rayon: Rayon<R>,
    /// Whether the ray is known to be inside something.
    dedans: bool,
    /// The objects that the path went into and has not left.
    verres: Vec<usize>,
    avant: Option<Intersection<R>>,
}

/// The rays of this path. `dedans` tells whether the first is known to be inside something. Each step is checked
/// against what the documentation says.
pub fn suivre<R: Bits>(
    monde: Monde<'_, R>,
    depart: Rayon<R>,
    dedans: bool,
    pas: &[Pas<R>],
) -> Vec<Rayon<R>> {
    let mut marcheur = Marcheur { monde, rayon: depart, dedans, verres: vec![], avant: None };
    let mut rayons = vec![depart];
    for pas in pas {
        let Some(suivant) = marcheur.avancer(pas) else { break };
        rayons.push(suivant);
    }
    rayons
}

impl<R: Bits> Marcheur<'_, R> {
    fn avancer(&mut self, pas: &Pas<R>) -> Option<Rayon<R>> {
        let rayon = self.rayon;
        let entree = self.monde.premiere_intersection(&rayon);
        if self.dedans || rayon.flou() == R::ZERO {
            // What the ray is inside changes nothing: the ray sees what one from `new` sees (`Rayon::dedans`), and
            // `new` keeps a direction that is unit (C13).
            let neuf =
                Rayon::new(rayon.source(), rayon.direction()).and_then(|r| r.jusqu_a(rayon.fin()));
            let neuve = self.monde.premiere_intersection(&neuf.unwrap());
            // The hits differ in the δ that they keep.
            let vu = |touche| Mots { flou: None, ..mots(touche) };
            assert_eq!(vu(&entree), vu(&neuve), "{rayon:?} of {:?}", self.monde.objets());
        }
        let entree = entree.ok().map(|touche| (touche.indice(), touche));
        // As in the recipe for glass, whatever comes first counts: a thing within, or the way out.
        let verre = self.verres.last().copied();
        let sortie = verre.and_then(|i| Some((i, self.monde.objets()[i].sortie(&rayon).ok()?)));
        let passage = match (entree, sortie) {
            (Some(entree), Some(sortie)) if sortie.1.distance() > entree.1.distance() => {
                Some(entree)
            }
            (entree, sortie) => sortie.or(entree),
        };
        let libre = passage.map_or(rayon.fin(), |(_, touche)| touche.distance());
        let t = Some(R::absolu(pas.distance)).filter(|t| *t < libre).unwrap_or(libre);
        let au_sec = verre.is_none() && self.au_sec(&rayon);
        if au_sec {
            let (t, p) = entree.map_or((t, rayon.point(t)), |(_, e)| (e.distance(), e.point()));
            self.exiger_qu_il_ne_s_enfonce_pas(p, au_plus(&rayon, t, p));
        }
        let suite = if let Suite::Bifurque = pas.suite {
            let p = rayon.point(t);
            let suite = rayon.bifurque(t, if pas.vise { pas.vers - p } else { pas.vers }).ok()?;
            assert_eq!(coordonnees(suite.source()), coordonnees(p), "{t}: {rayon:?}");
            self.exiger_ce_qu_il_sait(&suite, [au_plus(&rayon, t, p); 2]);
            suite
        } else {
            let (indice, touche) = passage?;
            let suite = self.suite_d_un_passage(pas, &touche)?;
            self.passer(indice, &touche, &suite);
            suite
        };
        if au_sec && !self.dedans {
            self.exiger_qu_il_ne_s_enfonce_pas(suite.source(), suite.flou().vers_f64());
        }
        self.rayon = suite;
        Some(suite)
    }

    fn suite_d_un_passage(&self, pas: &Pas<R>, touche: &Intersection<R>) -> Option<Rayon<R>> {
        let vers = if pas.vise { pas.vers - touche.point() } else { pas.vers };
        match pas.suite {
            Suite::Reflechi => touche.reflechi(self.rayon.direction()).ok(),
            Suite::ToutDroit => touche.secondaire(self.rayon.direction()).ok(),
            Suite::Soleil => touche.vers_soleil(vers).ok(),
            Suite::Lumiere => touche.vers_lumiere(pas.vers).ok(),
            Suite::Touche => exiger_le_retour(touche, &self.avant?),
            Suite::Secondaire | Suite::Bifurque => touche.secondaire(vers).ok(),
        }
    }

    /// Checks the ray that starts where the path enters or leaves an object, and what this ray knows.
    fn passer(&mut self, indice: usize, touche: &Intersection<R>, suite: &Rayon<R>) {
        let (objet, rayon) = (&self.monde.objets()[indice], self.rayon);
        exiger_un_passage(objet, &rayon, touche);
        exiger_une_suite(objet, &rayon, touche, suite);
        let n = touche.normale();
        let sort = n.produit_scalaire(rayon.direction()) > R::ZERO;
        let entre = n.produit_scalaire(suite.direction()) < R::ZERO;
        let (flou, p) = (rayon.flou().vers_f64(), touche.point());
        // The step off the surface is `marge`, plus at most 26.1u of it and 1.1u of the weights. Outward from a hit at
        // once, a part of δ and some u of the place come on top.
        let marge = touche.marge().vers_f64();
        let de_plus = if touche.distance() == R::ZERO && !entre {
            let tous = poids(Vecteur::new(1.0, 1.0, 1.0), p.vers_f64());
            flou * PAS_D_EMBLEE + PAS_D_EMBLEE_POINT * u::<R>() * tous
        } else {
            0.0
        };
        let arrondi = u::<R>() * (26.1 * marge + 1.1 * poids(n.vers_f64(), p.vers_f64()));
        let pas = [marge + de_plus, marge + de_plus + arrondi];
        let sans_pas = flou + flou_du_point(touche.distance(), p);
        self.exiger_ce_qu_il_sait(suite, pas.map(|pas| sans_pas + pas));
        if sort {
            self.verres.pop();
        }
        if entre {
            self.verres.push(indice);
        }
        self.dedans = entre;
        self.avant = Some(*touche);
    }

    /// δ lies between these bounds ("Closed rooms").
    fn exiger_ce_qu_il_sait(&self, suite: &Rayon<R>, [bas, haut]: [f64; 2]) {
        let flou = suite.flou().vers_f64();
        // There are eight roundings here and fewer in the crate, where two products may be subnormal. δ also grows for
        // its own roundings.
        let (arrondi, eta) = (16.0 * u::<R>(), 4.0 * R::ETA.vers_f64());
        let grandi = 1.0 + arrondi + FLOU_RELATIF * u::<R>();
        let permis = bas * (1.0 - arrondi) - eta..=haut * grandi + eta;
        assert!(
            permis.contains(&flou),
            "{flou:e} not in {permis:?}: {suite:?} after {:?}",
            self.rayon
        );
    }

    /// Whether the source lies no deeper in any object than the ray knows, from which lemma 22 starts.
    fn au_sec(&self, rayon: &Rayon<R>) -> bool {
        let mut tenants = self.monde.objets().iter().filter(|o| o.contient(rayon.source()));
        tenants.all(|objet| est_a_fleur(objet, rayon))
    }

    /// Lemma 22: no point of a path outside lies deeper in any object than `permis` and the rounding of the object.
    fn exiger_qu_il_ne_s_enfonce_pas(&self, point: Vecteur<R>, permis: f64) {
        if permis == f64::INFINITY {
            return; // The point may overflow.
        }
        for objet in self.monde.objets().iter().filter(|objet| objet.contient(point)) {
            let profond = profondeur(objet, point);
            assert!(
                profond <= permis,
                "{profond:e} > {permis:e}: {point:?} {objet:?} {:?}",
                self.rayon
            );
        }
    }
}

/// How deep the point of a ray at distance t may lie in an object: δ, 15ut and 8.1u‖P‖₁.
fn au_plus<R: Reel>(rayon: &Rayon<R>, t: R, p: Vecteur<R>) -> f64 {
    rayon.flou().vers_f64() + flou_du_point(t, p)
}
