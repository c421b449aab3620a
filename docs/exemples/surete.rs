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

/// What `f64` says, on the same numbers, of an answer in `f32`, and what `f32` itself said before.
#[derive(Clone, Copy, Debug)]
pub struct Jugement {
    /// Whether `est_certaine` says so.
    pub certaine: bool,
    /// Whether the answer in `f64` is another object, or none, or a distance farther off than `erreur`.
    pub autre: bool,
    /// How far the distance is from that in `f64`, in parts of it; none unless both name one object.
    pub ecart: Option<f64>,
}

/// The judgement of each of these rays.
pub fn juger(objets: &[ObjetRay<f32>], rayons: &[Rayon<f32>]) -> Vec<Jugement> {
    let doubles: Vec<_> = objets.iter().map(ObjetRay::vers_f64).collect();
    let jugement = |rayon: &Rayon<f32>| {
        let touche = premiere_intersection(objets, rayon);
        let (autre, ecart) = match (touche, premiere_intersection(&doubles, &rayon.vers_f64())) {
            (Err(NoIntersection), Err(NoIntersection)) => (false, None),
            (Ok(a), Ok(b)) if a.objet() == b.objet() => {
                let ecart = (f64::from(a.distance()) - b.distance()).abs();
                let erreur = objets[a.objet()].erreur(rayon, &a);
                (ecart > f64::from(erreur), Some(ecart / b.distance()))
            }
            (Ok(_), Ok(_) | Err(NoIntersection)) | (Err(NoIntersection), Ok(_)) => (true, None),
        };
        Jugement { certaine: est_certaine(objets, rayon, &touche), autre, ecart }
    };
    rayons.iter().map(jugement).collect()
}

/// How many of the judged rays are what.
#[derive(Debug)]
pub struct Comptes {
    /// Those whose answer is not certain.
    pub incertaines: usize,
    /// Those that `f64` answers otherwise.
    pub autres: usize,
    /// Those of the latter that were certain: there must be none.
    pub tues: usize,
}

pub fn compter(jugements: &[Jugement]) -> Comptes {
    let combien = |quoi: fn(&&Jugement) -> bool| jugements.iter().filter(quoi).count();
    Comptes {
        incertaines: combien(|j| !j.certaine),
        autres: combien(|j| j.autre),
        tues: combien(|j| j.autre && j.certaine),
    }
}
