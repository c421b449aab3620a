//! Glass that stands on something, whatever rounding makes of their heights.

use lancer_rayon::{Intersection, Monde, NoIntersection, Rayon, Reel};

/// Where light inside glass arrives first.
pub enum Suite<R> {
    /// Another object, within the glass or flush against it. Ask `monde.sans(verre)` for the light that falls on it,
    /// and go on inside the glass. Light went through glass from the source of the ray to the `point` of this hit,
    /// whose `distance` may count from the way out.
    Touche(Intersection<R>),
    /// The way out of the glass, to `refracte` or `reflechi`.
    Sortie(Intersection<R>),
}

/// Follows a ray inside the object of index `verre`. Where a table is flush with the glass, rounding puts the table
/// before the way out or after it; either way it is the answer.
///
/// # Errors
/// The ray has no way out: it started beside an edge and is out already. Go on with `dedans.dehors()` in the air.
pub fn dans_le_verre<R: Reel>(
    monde: &Monde<'_, R>,
    verre: usize,
    dedans: &Rayon<R>,
) -> Result<Suite<R>, NoIntersection> {
    let autres = monde.sans(verre);
    let sortie = monde.objets()[verre].sortie(dedans)?;
    let jusque_la = dedans.jusqu_a(sortie.distance()).expect("above 0");
    if let Ok(touche) = autres.premiere_intersection(&jusque_la) {
        return Ok(Suite::Touche(touche));
    }
    // What lies beyond by no more than the error of this place is flush. (A ball that is lost in rounding has no side.)
    let contre = sortie.secondaire(sortie.normale());
    let contre = contre.and_then(|contre| contre.jusqu_a(contre.flou()));
    let a_fleur = contre.ok().and_then(|contre| autres.premiere_intersection(&contre).ok());
    Ok(a_fleur.map_or(Suite::Sortie(sortie), Suite::Touche))
}
