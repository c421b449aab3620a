//! Which answers of a picture are certain: those of exact arithmetic on the numbers as stored.

use lancer_rayon::{NoIntersection, ObjetRay, Rayon, Reel, Touche, premiere_intersection};

/// Whether this answer of `premiere_intersection` names the object that exact arithmetic names, or
/// none as it does.
///
/// Each object must be certain, hit or miss; and no other that is hit may come within the bounds of
/// both.
pub fn est_certaine<R: Reel>(objets: &[ObjetRay<R>], rayon: &Rayon<R>, touche: &Touche<R>) -> bool {
    let bornes = |objet: &ObjetRay<R>| {
        let touche = objet.intersection(rayon).ok()?;
        let (t, erreur) = (touche.distance().vers_f64(), objet.erreur(rayon, &touche).vers_f64());
        Some([t - erreur, t + erreur])
    };
    let premier = touche.map(|touche| touche.objet());
    let fin = premier.ok().and_then(|i| bornes(&objets[i])).map_or(f64::INFINITY, |[_, fin]| fin);
    objets.iter().enumerate().all(|(i, objet)| {
        let derriere = |[debut, _]: [f64; 2]| debut > fin;
        objet.est_sur(rayon) && (premier == Ok(i) || bornes(objet).is_none_or(derriere))
    })
}

/// Rays of a picture in `f32`.
#[derive(Debug, Default)]
pub struct Pixels {
    /// Those whose answer is not certain.
    pub incertains: usize,
    /// Those whose answer in `f64` on the same numbers is another object, or none, or a distance
    /// farther off than `erreur`.
    pub autres: usize,
    /// Those of the latter that were certain: there must be none.
    pub tus: usize,
}

/// What `f64` says, on the same numbers, of the answers in `f32`, and what `f32` itself said of them
/// before.
pub fn juger(objets: &[ObjetRay<f32>], rayons: &[Rayon<f32>]) -> Pixels {
    let doubles: Vec<_> = objets.iter().map(ObjetRay::vers_f64).collect();
    let mut pixels = Pixels::default();
    for rayon in rayons {
        let touche = premiere_intersection(objets, rayon);
        let certaine = est_certaine(objets, rayon, &touche);
        let autre = match (touche, premiere_intersection(&doubles, &rayon.vers_f64())) {
            (Err(NoIntersection), Err(NoIntersection)) => false,
            (Ok(a), Ok(b)) => {
                let ecart = (f64::from(a.distance()) - b.distance()).abs();
                let erreur = objets[a.objet()].erreur(rayon, &a);
                a.objet() != b.objet() || ecart > f64::from(erreur)
            }
            (Ok(_), Err(NoIntersection)) | (Err(NoIntersection), Ok(_)) => true,
        };
        pixels.incertains += usize::from(!certaine);
        pixels.autres += usize::from(autre);
        pixels.tus += usize::from(autre && certaine);
    }
    pixels
}
