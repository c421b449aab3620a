//! A lens, which is what two balls have in common.

use lancer_rayon::{ErreurGeo, Intersection, ObjetRay, Rayon, Reponse};

/// The ray that comes out of the lens of these balls, of index `indice`; `None` if the ray passes by the lens, or does
/// not leave it at the first face.
pub fn traverser(
    balles: &[ObjetRay; 2],
    rayon: &Rayon,
    indice: f64,
) -> Result<Option<Rayon>, ErreurGeo> {
    // The ray enters the lens at the later entry, if it leaves both balls only after that.
    let [Ok(a), Ok(b)] = balles.each_ref().map(|balle| balle.intersection(rayon)) else {
        return Ok(None);
    };
    let entree = if a.distance() > b.distance() { a } else { b };
    let Some(fin) = premiere(balles.each_ref().map(|balle| balle.sortie(rayon))) else {
        return Ok(None);
    };
    if fin.distance() <= entree.distance() {
        return Ok(None);
    }
    let dedans = entree.refracte(rayon.direction(), 1.0 / indice)?;
    // The ray leaves at the earlier way out.
    let Some(sortie) = premiere(balles.each_ref().map(|balle| balle.sortie(&dedans))) else {
        return Ok(None);
    };
    Ok(sortie.refracte(dedans.direction(), indice).ok())
}

fn premiere([a, b]: [Reponse; 2]) -> Option<Intersection> {
    let (a, b) = (a.ok()?, b.ok()?);
    Some(if a.distance() < b.distance() { a } else { b })
}
