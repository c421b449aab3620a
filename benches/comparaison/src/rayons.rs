//! The 240,000 rays of a picture, and the rays that leave what they touch, in the orders in which a renderer
//! may have them.

use fastrand::Rng;
use lancer_rayon::{Hierarchie, Intersection, Rayon, Reel, Vecteur};

use crate::commun::conversion::arrondi;
use crate::commun::regimes::{direction, entre};
use crate::commun::scenes;
use crate::horloge::MORCEAU;

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

/// What the camera sees, in tiles.
fn vus<R: Reel>(hierarchie: &Hierarchie<'_, R>) -> Vec<(Rayon<R>, Intersection<R>)> {
    let vu = |rayon: Rayon<R>| Some((rayon, hierarchie.premiere_intersection(&rayon).ok()?));
    en_tuiles().into_iter().filter_map(vu).collect()
}

/// Reflected by what the camera sees, as by a rough mirror: off by up to 0.05; in tiles.
pub(crate) fn rugueux<R: Reel>(hierarchie: &Hierarchie<'_, R>) -> Vec<Rayon<R>> {
    let mut alea = Rng::with_seed(6);
    let reflet = |(rayon, touche): (Rayon<R>, Intersection<R>)| {
        let (d, n) = (rayon.direction().vers_f64(), touche.normale().vers_f64());
        let vers = d - n * (2.0 * d.produit_scalaire(n)) + direction(&mut alea) * 0.05;
        let dehors = vers.produit_scalaire(n) > 0.0;
        rayon.secondaire(&touche, arrondi(vers)).ok().filter(|_| dehors)
    };
    vus(hierarchie).into_iter().filter_map(reflet).collect()
}

/// What a key may order rays by: the object that they leave, and the octant of their direction.
pub(crate) type Cle = (usize, u8);

/// Scattered by what the camera sees; each part of so many rays in the order of this key, in tiles where it is
/// the same for all.
pub(crate) fn diffus<R: Reel>(
    hierarchie: &Hierarchie<'_, R>,
    cle: impl Fn(Cle) -> Cle,
) -> Vec<Rayon<R>> {
    let mut alea = Rng::with_seed(7);
    let mut rayons: Vec<(Cle, Rayon<R>)> = Vec::new();
    for (rayon, touche) in vus(hierarchie) {
        let vers = touche.normale().vers_f64() + direction(&mut alea);
        let Ok(rayon) = rayon.secondaire(&touche, arrondi(vers)) else { continue };
        let negatifs = <[R; 3]>::from(rayon.direction()).map(|x| u8::from(x < R::ZERO));
        let octant = negatifs.into_iter().fold(0, |octant, bit| 2 * octant + bit);
        rayons.push((cle((touche.objet(), octant)), rayon));
    }
    for morceau in rayons.chunks_mut(MORCEAU) {
        morceau.sort_by_key(|(cle, _)| *cle);
    }
    rayons.into_iter().map(|(_, rayon)| rayon).collect()
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
