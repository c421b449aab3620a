//! Glass: whether a ray inside it meets something else before it leaves.

use lancer_rayon::{Intersection, Reel};

/// Whether what the ray inside touched comes before the way out, or has the glass standing on it.
///
/// A ray steps off a surface past all rounding. Where the step beyond the glass and the step before the other object
/// cross, no ray could start between the two: the light goes straight into the other object. With an epsilon in its
/// place light leaks, and without either it falls through the table.
pub fn avant_la_sortie<R: Reel>(touche: &Intersection<R>, sortie: &Intersection<R>) -> bool {
    let hors_de = |surface: &Intersection<R>| surface.secondaire(surface.normale());
    let (Ok(apres), Ok(avant)) = (hors_de(sortie), hors_de(touche)) else { return false };
    (avant.source() - apres.source()).produit_scalaire(touche.normale()) >= R::ZERO
}
