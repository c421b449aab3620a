//! The ball around an object: a test that needs neither division nor root.

use crate::reel::u;
use crate::{Reel, Vecteur};

/// Whether the ray (S, D) comes near the ball of centre C whose radius has this square.
///
/// Never false for a ray that enters the ball, whatever rounding does: SC² − (SC·D)² is off by
/// less than 32u·SC², and the factor 1 − 64u takes away twice that (derivation in
/// `docs/conception.md`). A ray whose source is in the ball passes even with C behind it.
#[inline(always)]
pub(crate) fn approche<R: Reel>(
    centre: Vecteur<R>,
    rayon_carre: R,
    s: Vecteur<R>,
    d: Vecteur<R>,
) -> bool {
    let sc = centre - s;
    let sa = sc.produit_scalaire(d);
    let sc2 = sc.longueur_carree() * (R::UN - u(64.0));
    (sc2 - sa * sa <= rayon_carre) & ((sa > R::ZERO) | (sc2 <= rayon_carre))
}
