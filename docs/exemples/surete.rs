//! Which answers of a picture are certain: those of exact arithmetic on the numbers as stored.

use lancer_rayon::{Monde, NoIntersection, ObjetRay, PlacesInsuffisantes, Rayon, places};

/// What `f64` says of an answer in `f32`, on the same numbers, and what `f32` itself said before.
#[derive(Clone, Copy, Debug)]
pub struct Jugement {
    /// Whether `Monde::certifie` says so.
    pub certaine: bool,
    /// Whether the answer in `f64` is another object, or none, or a distance farther away than `erreur` allows.
    pub autre: bool,
    /// The relative difference of the distance from that in `f64`; none unless both name one object.
    pub ecart: Option<f64>,
}

/// The judgement of each of these rays.
pub fn juger(
    objets: &[ObjetRay<f32>],
    rayons: &[Rayon<f32>],
) -> Result<Vec<Jugement>, PlacesInsuffisantes> {
    let doubles: Vec<_> = objets.iter().map(|objet| objet.temoin_f64()).collect();
    let [mut places, mut places_doubles] = [(); 2].map(|()| vec![0.0; places(objets.len())]);
    let simple = Monde::new(objets, &mut places)?;
    let double = Monde::new(&doubles, &mut places_doubles)?;
    let jugement = |rayon: &Rayon<f32>| {
        let touche = simple.premiere_intersection(rayon);
        let (autre, ecart) = match (touche, double.premiere_intersection(&rayon.temoin_f64())) {
            (Err(NoIntersection), Err(NoIntersection)) => (false, None),
            (Ok(a), Ok(b)) if a.indice() == b.indice() => {
                let ecart = (f64::from(a.distance()) - b.distance()).abs();
                let erreur = objets[a.indice()].erreur(rayon, &a);
                (ecart > f64::from(erreur), Some(ecart / b.distance()))
            }
            (Ok(_), Ok(_) | Err(NoIntersection)) | (Err(NoIntersection), Ok(_)) => (true, None),
        };
        Jugement { certaine: simple.certifie(rayon, &touche), autre, ecart }
    };
    Ok(rayons.iter().map(jugement).collect())
}

/// How many of the judged rays are of each kind.
#[derive(Debug)]
pub struct Comptes {
    /// Rays whose answer is not certain.
    pub incertaines: usize,
    /// Rays that `f64` answers otherwise.
    pub autres: usize,
    /// The latter rays that were certain: there must be none.
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
