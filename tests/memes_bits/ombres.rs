//! `sont_occultes` beside the first hits of the same rays: something stands before the lamp if the first object
//! does.

use commun::Bits;
use lancer_rayon::{Hierarchie, ObjetRay, Rayon, Reglage, Touche};

/// The number so many units in the last place away.
pub(crate) fn voisin<R: Bits>(x: R, de: i64) -> R {
    let unite = if size_of::<R>() == 4 { 32 } else { 0 };
    R::depuis_bits((x.bits() << unite).wrapping_add_signed(de << unite))
}

/// Asks these rays with lamps at their first hits, just beyond them and farther, with some lamps that no segment
/// reaches, and with a sun; of a list with each setting, or of a hierarchy with each instruction set. A ray that hits
/// nothing has the lamp of the ray before it.
#[track_caller]
pub(crate) fn comparer_les_ombres<R: Bits>(
    objets: &[ObjetRay<R>],
    rayons: &[Rayon<R>],
    attendues: &[Touche<R>],
    reglages: &[(String, Reglage)],
    hierarchie: Option<Hierarchie<'_, R>>,
) {
    let etranges = [R::INFINI, R::depuis_f64(f64::NAN), R::ZERO, -R::UN];
    for paquet in 0..5 {
        let mut lampe = R::UN;
        let limite = |(i, touche): (usize, &Touche<R>)| {
            lampe = touche.map_or(lampe, |touche| touche.distance());
            match paquet {
                0 => lampe,
                1 => voisin(lampe, 1),
                2 => lampe * R::depuis_f64(1.0 + (i % 9) as f64),
                3 if i % 50 == 0 => etranges[i / 50 % 4],
                3 => voisin(lampe, 1),
                _ => R::INFINI,
            }
        };
        let limites = attendues.iter().enumerate().map(limite);
        let ombres: Vec<_> = rayons.iter().copied().zip(limites).collect();
        let cachee = |(touche, (_, max)): (&Touche<R>, &(Rayon<R>, R))| {
            touche.is_ok_and(|touche| touche.distance() < *max)
        };
        let voulues: Vec<bool> = attendues.iter().zip(&ombres).map(cachee).collect();
        for (nom, reglage) in reglages {
            // The contrary, so that a place which is left out shows.
            let mut occultes: Vec<bool> = voulues.iter().map(|occulte| !occulte).collect();
            match hierarchie {
                None => reglage.sont_occultes(objets, &ombres, &mut occultes),
                Some(hierarchie) => {
                    reglage.hierarchie(hierarchie).sont_occultes(&ombres, &mut occultes)
                }
            }
            .unwrap();
            for ((ombre, occulte), voulue) in ombres.iter().zip(&occultes).zip(&voulues) {
                let (n, scalaire) = (objets.len(), std::any::type_name::<R>());
                assert_eq!(occulte, voulue, "shadow, {nom}, {scalaire}, {n} objects: {ombre:?}");
            }
        }
    }
}
