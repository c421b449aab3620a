//! A place of one's own on a surface, such as a sensor, a window or a point of a lamp.

use std::error::Error;

use lancer_rayon::{BoiteRay, Face, Intersection, ObjetRay, Reel};

/// The place on this face of the box, with [u, v] from −1 to 1 to the right and up.
pub fn capteur<R: Reel>(
    boite: BoiteRay<R>,
    face: Face,
    uv: [R; 2],
) -> Result<Intersection<R>, Box<dyn Error>> {
    let de_l_interieur = boite.vers_lieu(face, uv)?;
    Ok(ObjetRay::from(boite).sortie(&de_l_interieur)?)
}
