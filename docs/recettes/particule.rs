//! A particle in a closed room, and a walk that is scattered in a medium. Both go by `milieux`, in steps of any length,
//! some of which end on a wall, and for as long as one likes.

use std::f64::consts::TAU;

use lancer_rayon::{Choix, ErreurGeo, Reel, Vecteur};

use crate::milieux::{Marche, Surface};

/// How many surfaces a step meets at most, since a chain of hits need not end.
const SURFACES_D_UN_PAS: u32 = 100_000;

/// Goes this far, mirrored by all that is opaque, and through media by Snell's law. Whether it came to the end of the
/// step: a particle that meets 100,000 surfaces before is caught, as in the tip between mirrors. Give it up, since its δ
/// may by then be larger than a wall is thick.
///
/// # Errors
/// As [`Marche::avancer`] and [`Marche::passer`].
pub fn avancer<R: Reel, C: Choix + Copy>(
    marche: &mut Marche<'_, R, C>,
    mut pas: R,
) -> Result<bool, ErreurGeo> {
    for _ in 0..SURFACES_D_UN_PAS {
        let Some(surface) = marche.avancer(pas)? else { return Ok(true) };
        marche.passer(&surface)?;
        // A sum of distances may round beyond the end of the step.
        pas = if surface.distance < pas { pas - surface.distance } else { R::ZERO };
    }
    Ok(false)
}

/// Goes through the medium that it is in, scattered evenly after steps of this mean length, until it comes to a surface
/// or has been scattered `au_plus` times. Returns how far it has gone, and the surface. `hasard` gives numbers from 0 up
/// to 1. In a sea, a half-space, a walk may go far: bound it.
///
/// # Errors
/// As [`Marche::avancer`].
pub fn diffuser<R: Reel, C: Choix + Copy>(
    marche: &mut Marche<'_, R, C>,
    pas_moyen: f64,
    au_plus: u32,
    mut hasard: impl FnMut() -> f64,
) -> Result<(R, Option<Surface<R>>), ErreurGeo> {
    let mut chemin = R::ZERO;
    for _ in 0..=au_plus {
        let pas = R::depuis_f64(-(1.0 - hasard()).ln() * pas_moyen);
        if let Some(surface) = marche.avancer(pas)? {
            return Ok((chemin + surface.distance, Some(surface)));
        }
        chemin = chemin + pas;
        let (z, angle) = (2.0 * hasard() - 1.0, TAU * hasard());
        let r = (1.0 - z * z).sqrt();
        marche.tourner(Vecteur::depuis_f64(Vecteur::new(r * angle.cos(), r * angle.sin(), z)))?;
    }
    Ok((chemin, None))
}
