//! Glass: where a ray inside an object leaves it, and whether it meets something else before.

use lancer_rayon::{Intersection, ObjetRay, Rayon, Reel};

/// Where a ray inside this object leaves it: the ray shot back from beyond the object, and its hit there. No two
/// points of the object are `loin` apart.
pub fn sortir<R: Reel>(
    objet: &ObjetRay<R>,
    dedans: &Rayon<R>,
    loin: R,
) -> Option<(Rayon<R>, Intersection<R>)> {
    let retour = Rayon::new(dedans.point(loin), -dedans.direction()).ok()?;
    let sortie = objet.intersection(&retour).ok()?;
    Some((retour, sortie))
}

/// Whether what the ray inside touched comes before the way out, or has the glass standing on it.
///
/// A ray steps off a surface past all rounding. Where the step beyond the glass and the step before the other object
/// cross, no ray could start between the two: the light goes straight into the other object. With an epsilon in its
/// place light leaks, and without either it falls through the table.
pub fn avant_la_sortie<R: Reel>(
    dedans: &Rayon<R>,
    touche: &Intersection<R>,
    (retour, sortie): &(Rayon<R>, Intersection<R>),
) -> bool {
    let apres = retour.secondaire(sortie, sortie.normale());
    let avant = dedans.secondaire(touche, touche.normale());
    let (Ok(apres), Ok(avant)) = (apres, avant) else { return false };
    (avant.source() - apres.source()).produit_scalaire(touche.normale()) >= R::ZERO
}
