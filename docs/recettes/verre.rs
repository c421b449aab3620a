//! What light comes to through glass and water, whatever it stands on.

use lancer_rayon::{ErreurGeo, Intersection, Monde, Rayon};

use crate::milieux::{Derriere, Marche, Matiere};

/// How many surfaces light meets at most.
const SURFACES: u32 = 100;

/// The opaque thing that light comes to in a world of water, of glass and of opaque things, in this order.
pub fn au_fond(monde: Monde<'_>, rayon: Rayon) -> Result<Option<Intersection>, ErreurGeo> {
    let eau = Matiere::Pleine { priorite: 0, indice: 1.33 };
    let verre = Matiere::Pleine { priorite: 1, indice: 1.5 };
    let matieres = [eau, verre];
    let mut marche = Marche::new(monde, &matieres);
    marche.partir(rayon);
    for _ in 0..SURFACES {
        let Some(surface) = marche.avancer(f64::INFINITY)? else { return Ok(None) };
        if surface.derriere == Derriere::Opaque {
            return Ok(Some(surface.touche));
        }
        marche.passer(&surface)?;
    }
    Ok(None)
}
