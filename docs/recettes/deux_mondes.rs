//! One tree over what stays, and one over what moves.

use lancer_rayon::{Intersection, Monde, Rayon, Reel};

/// The first hit, and its index in a list of what stays followed by what moves.
pub fn premiere<R: Reel>(
    fixe: &Monde<'_, R>,
    mobile: &Monde<'_, R>,
    rayon: &Rayon<R>,
) -> Option<(usize, Intersection<R>)> {
    let de_fixe = fixe.premiere_intersection(rayon).ok();
    let avant = de_fixe.map_or(*rayon, |t| rayon.jusqu_a(t.distance()).expect("0 or more"));
    let de_mobile = mobile.premiere_intersection(&avant).ok();
    let apres = |touche: Intersection<R>| (fixe.objets().len() + touche.indice(), touche);
    de_mobile.map(apres).or(de_fixe.map(|touche| (touche.indice(), touche)))
}
