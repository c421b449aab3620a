//! A place of one's own on a surface: a sensor, a window, a point of a lamp.

use std::error::Error;

use lancer_rayon::{BoiteRay, Face, Intersection, ObjetRay, Rayon, Reel, Vecteur};

/// The place on this face of the box that is nearest to a point of the face.
pub fn capteur<R: Reel>(
    boite: BoiteRay<R>,
    face: Face,
    point: Vecteur<R>,
) -> Result<Intersection<R>, Box<dyn Error>> {
    let (milieu, normale) = boite.face(face);
    let dedans = Rayon::new(boite.centre() + (point - milieu), normale)?;
    Ok(ObjetRay::from(boite).sortie(&dedans)?)
}
