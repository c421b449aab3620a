//! The 240,000 rays of a picture, in the orders in which a renderer may have them.

use fastrand::Rng;
use lancer_rayon::{Hierarchie, Rayon, Reel, Vecteur};

use crate::commun::conversion::arrondi;
use crate::commun::regimes::{direction, entre};
use crate::commun::scenes;

const LARGEUR: usize = 600;
const HAUTEUR: usize = 400;

pub(crate) fn en_lignes<R: Reel>() -> Vec<Rayon<R>> {
    scenes::rayons_camera(LARGEUR, HAUTEUR)
}

pub(crate) fn en_tuiles<R: Reel>() -> Vec<Rayon<R>> {
    scenes::en_tuiles(&en_lignes(), LARGEUR)
}

/// As many in no order: from what the camera sees outward in any direction, and for a pixel that
/// sees nothing from anywhere to anywhere.
pub(crate) fn incoherents<R: Reel>(hierarchie: &Hierarchie<'_, R>) -> Vec<Rayon<R>> {
    let mut alea = Rng::with_seed(4);
    let mut rayons = en_lignes();
    for rayon in &mut rayons {
        let vers = direction(&mut alea);
        let nouveau = match hierarchie.premiere_intersection(rayon) {
            Ok(touche) => {
                let dehors = touche.normale().vers_f64().produit_scalaire(vers).signum();
                rayon.secondaire(&touche, arrondi(vers * dehors))
            }
            Err(_) => Rayon::new(arrondi(place(&mut alea)), arrondi(vers)),
        };
        *rayon = nouveau.expect("a scene within every limit");
    }
    alea.shuffle(&mut rayons);
    rayons
}

/// From what the camera sees to a lamp that it faces, with how far that is; in tiles.
pub(crate) fn ombres<R: Reel>(hierarchie: &Hierarchie<'_, R>) -> Vec<(Rayon<R>, R)> {
    let lampe = arrondi(Vecteur::new(-2.6, 7.2, 5.2));
    let ombre = |rayon: Rayon<R>| {
        let touche = hierarchie.premiere_intersection(&rayon).ok()?;
        rayon.vers_lumiere(&touche, lampe)
    };
    en_tuiles().into_iter().filter_map(ombre).collect()
}

/// Among the objects of `scenes::melange`.
fn place(alea: &mut Rng) -> Vecteur {
    Vecteur::new(entre(alea, -10.0, 10.0), entre(alea, -1.0, 7.0), entre(alea, -12.0, 0.0))
}
