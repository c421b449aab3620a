//! A pattern on a box, which follows the box wherever it is moved and turned.

use lancer_rayon::{BoiteRay, Intersection, Rayon};

/// Whether a hit on this box lies in a dark cell of a checker that fills the box, with cells of this size.
pub fn sombre(boite: &BoiteRay, rayon: &Rayon, touche: &Intersection, cote: f64) -> bool {
    let (_, lieu) = boite.lieu(rayon, touche);
    let [x, y, z] = lieu.into();
    let [a, b, c] = boite.demi_longueurs();
    [x * a, y * b, z * c].map(|x| (x / cote).floor()).iter().sum::<f64>() % 2.0 != 0.0
}
