//! Chords: all that a straight ray goes through, for a dose, a projection or the flight of a particle.

use std::ops::ControlFlow::Continue;

use lancer_rayon::{Choix, Monde, ObjetRay, Rayon, Reel};

/// The part of a ray in one object of the list, between two distances from its source.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corde<R> {
    pub indice: usize,
    pub de: R,
    pub a: R,
}

/// Writes the chords of a ray in the order in which they begin, at the same distance in that of the list. All of them
/// count from one source as it stands, whatever its δ, so that chords of flush objects meet to rounding, and no step
/// from face to face adds to their errors.
pub fn cordes<R: Reel, C: Choix>(
    monde: &Monde<'_, R, C>,
    rayon: &Rayon<R>,
    cordes: &mut Vec<Corde<R>>,
) {
    let fin = rayon.fin();
    let sans_fin = rayon.jusqu_a(R::INFINI).expect("+∞ is an end");
    let sortie =
        |indice: usize| match (monde.objets()[indice].sortie(&sans_fin), monde.objets()[indice]) {
            (Ok(sortie), _) => Some(if sortie.distance() < fin { sortie.distance() } else { fin }),
            // A half-space that the ray does not leave.
            (Err(_), ObjetRay::Plan(sol))
                if sol.normale().produit_scalaire(rayon.direction()) <= R::ZERO =>
            {
                Some(fin)
            }
            // The ray starts on a surface and goes away.
            (Err(_), _) => None,
        };
    cordes.clear();
    let mut noter = |indice, de| {
        cordes.extend(sortie(indice).filter(|a| *a > de).map(|a| Corde { indice, de, a }));
    };
    monde.contenants(rayon.source(), |indice| noter(indice, R::ZERO));
    // A ray inside touches nothing at once; what holds the source was noted above.
    monde.visiter(&rayon.dedans(), |indice, de| {
        noter(indice, de);
        Continue(fin)
    });
    let ordre = |corde: &Corde<R>| (corde.de, corde.indice);
    cordes.sort_by(|a, b| ordre(a).partial_cmp(&ordre(b)).expect("a distance is no NaN"));
}

/// Cuts off each chord what earlier ones cover: a ray in the common face of two objects is in both, one along a common
/// edge in four, and objects that overlap count once.
pub fn sans_recouvrement<R: Reel>(cordes: &mut Vec<Corde<R>>) {
    let mut fin = R::ZERO;
    cordes.retain_mut(|corde| {
        corde.de = if corde.de < fin { fin } else { corde.de };
        fin = if corde.a > fin { corde.a } else { fin };
        corde.a > corde.de
    });
}
