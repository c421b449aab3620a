//! What is measured of an implementation against the oracle in each regime.

use fastrand::Rng;
use lancer_rayon::pour_les_tests::ARRONDI_PERDU;
use lancer_rayon::{Intersection, ObjetRay, Rayon, Reel, SphereRay, Vecteur};

use crate::oracle::{Entree, hauteur, verite};
use crate::regimes::Regime;
use crate::tolerances::{ORTHONORMALE_GARDEE, promesses, u};

/// The answer of an implementation: distance and normal.
pub type Mesuree<R> = Option<(R, Vecteur<R>)>;

/// Counts and errors of one regime.
#[derive(Debug, Default)]
pub struct Mesure {
    /// Wrong answers outside the band of the decision: hits where there is none, and misses where there is one.
    pub fausses: u32,
    /// The error of every distance in u·κt, with u that of the type.
    pub k: Vec<f64>,
}

/// The median, the value that one in a thousand exceeds, and the largest.
pub fn quantiles(valeurs: &mut [f64]) -> [f64; 3] {
    valeurs.sort_by(f64::total_cmp);
    [0.5, 0.999, 1.0].map(|part| {
        let rang = (valeurs.len().saturating_sub(1)) as f64 * part;
        valeurs.get(rang as usize).copied().unwrap_or(f64::NAN)
    })
}

/// The largest distance of the type.
pub fn plus_grand<R: Reel>() -> f64 {
    if u::<R>() > f64::EPSILON { f64::from(f32::MAX) } else { f64::MAX }
}

/// What products that underflow may add to the error of a distance.
pub fn absolu<R: Reel>(objet: &ObjetRay<R>, entree: &Entree) -> f64 {
    match objet {
        ObjetRay::Plan(_) => absolu_fois(entree, R::ETA.vers_f64()),
        ObjetRay::Sphere(_) | ObjetRay::Boite(_) => 0.0,
    }
}

/// The same for a half-space, with an η that may have been multiplied by a number.
pub fn absolu_fois(entree: &Entree, eta: f64) -> f64 {
    promesses::PLAN_ABSOLU * eta / entree.cosinus
}

/// The same `graine` gives the same cases to every implementation.
pub fn mesurer<R: Reel>(
    regime: &Regime<R>,
    cas: u32,
    graine: u64,
    repondre: impl Fn(&ObjetRay<R>, &Rayon<R>) -> Mesuree<R>,
) -> Mesure {
    let mut alea = Rng::with_seed(graine);
    let mut mesure = Mesure::default();
    let u = u::<R>();
    for _ in 0..cas {
        let cas = (regime.cas)(&mut alea);
        let verite = verite(&cas.objet, &cas.rayon);
        let reponse = repondre(&cas.objet, &cas.rayon);
        // A distance that the type cannot hold is a miss.
        let entree = verite.entree.filter(|e| e.t.vers_f64() <= plus_grand::<R>());
        mesure.fausses += u32::from(!verite.dans_la_marge && entree.is_some() != reponse.is_some());
        let (Some(entree), Some((t, _))) = (entree, reponse) else { continue };
        mesure.k.push(entree.ecart(t).abs() / (u * entree.kappa_t));
    }
    mesure
}

/// Whether an inward ray from a hit on the face `touche` of a box may enter the box again at `encore`. It may by
/// another face, above whose plane it starts as computed, and no farther above than the hit may lie (lemma 6).
pub fn au_bord<R: Reel>(
    objet: &ObjetRay<R>,
    rayon: &Rayon<R>,
    touche: &Intersection<R>,
    depart: Vecteur<R>,
    encore: &Intersection<R>,
) -> bool {
    let ObjetRay::Boite(boite) = objet else { return false };
    let (n, autre) = (touche.normale(), encore.normale());
    if autre == n || autre == -n {
        return false;
    }
    let u = u::<R>();
    let du_depart = (depart.vers_f64() - boite.centre().vers_f64()).longueur();
    let p = rayon.point(touche.distance());
    // The step along N and the rounding of the start come on top.
    let permis = lieu_permis(objet, rayon, touche.distance())
        + u * ((ORTHONORMALE_GARDEE + 2.0) * touche.marge().vers_f64()
            + promesses::LIEU_P * p.vers_f64().longueur());
    let h = hauteur(objet, autre, depart);
    -promesses::LIEU_F * u * du_depart < h && h <= permis
}

/// How far outside its object the point `rayon.point(t)` of a hit may lie (lemma 6).
pub fn lieu_permis<R: Reel>(objet: &ObjetRay<R>, rayon: &Rayon<R>, t: R) -> f64 {
    let [s, p] = [rayon.source(), rayon.point(t)].map(Vecteur::vers_f64);
    let loin = |centre: Vecteur<R>| (s - centre.vers_f64()).longueur();
    let t = t.vers_f64();
    let de_x = match objet {
        ObjetRay::Boite(b) => promesses::LIEU_F * loin(b.centre()) + promesses::LIEU_T * t,
        ObjetRay::Sphere(s) => {
            promesses::LIEU_SPHERE * (loin(s.centre()) + s.rayon().vers_f64())
                + promesses::LIEU_P * t
        }
        ObjetRay::Plan(p) => {
            let poids = promesses::LIEU_PLAN_S * poids(p.normale().vers_f64(), s);
            let perdu = promesses::LIEU_PLAN_ABSOLU * (R::ETA.vers_f64() / u::<R>());
            poids + promesses::LIEU_PLAN_T * t + perdu
        }
    };
    u::<R>() * (de_x + promesses::LIEU_P * p.longueur())
}

/// ⟨N, P⟩, the weights of a scalar product, by which its rounding is measured.
pub fn poids(n: Vecteur, p: Vecteur) -> f64 {
    (n.x * p.x).abs() + (n.y * p.y).abs() + (n.z * p.z).abs()
}

/// The radius from which on the margin of a sphere hit at `t` is finite (lemma 8).
pub fn rayon_non_perdu<R: Reel>(sphere: &SphereRay<R>, rayon: &Rayon<R>, t: R) -> f64 {
    let [f, p] = [rayon.source() - sphere.centre(), rayon.point(t)].map(Vecteur::vers_f64);
    let p = p.x.abs() + p.y.abs() + p.z.abs();
    u::<R>() * (promesses::PERDUE * f.longueur() + p / ARRONDI_PERDU)
}
