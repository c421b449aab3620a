//! A map around a ball.

use std::f64::consts::{PI, TAU};

use lancer_rayon::{Intersection, Rotation};

/// The cell of a map of this many columns and rows, whose poles are on the y axis of the ball before it was turned.
pub fn case(touche: &Intersection, tour: Rotation, [colonnes, lignes]: [usize; 2]) -> [usize; 2] {
    let n = tour.inverse().appliquer(touche.normale());
    // Longitude and latitude, from 0 to 1.
    let longitude = 0.5 + n.x.atan2(n.z) / TAU;
    let latitude = 0.5 - n.y.clamp(-1.0, 1.0).asin() / PI;
    let indice = |part: f64, cases: usize| ((part * cases as f64) as usize).min(cases - 1);
    [indice(longitude, colonnes), indice(latitude, lignes)]
}
