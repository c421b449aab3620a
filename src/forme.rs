//! The trait of the three shapes, and the ball that rejects most rays with neither a division nor a root.
//!
//! The *search* finds the first object that a ray enters, in the scalar of the scene. The *conclusion*
//! then computes the hit on that object in `f64`. Each shape implements both once, in its own file, for
//! one ray and for rays side by side.

use crate::intersection::{Contact, Intersection, Rang};
use crate::rayon::Rayon;
use crate::reel::{Reel, fois_u};
use crate::texture::Texture;
use crate::vecteur::Vecteur;

/// A shape, ready for rays.
///
/// A ray meets it in three steps: [`peut_entrer`](Self::peut_entrer) is cheap and rejects most
/// rays, [`t`](Self::t) is the distance of the entry, and [`conclure`](Self::conclure) is asked
/// once, for the first object of a ray.
pub(crate) trait Forme<R: Reel>: Copy {
    /// A ball around all of the shape; [`Boule::INFINIE`] if it is unbounded.
    fn boule(&self) -> Boule<R>;

    /// The centre of the shape and its half-extents along the axes, each to 16u of itself; `None` if it is
    /// unbounded.
    fn boite_englobante(&self) -> Option<(Vecteur<R>, Vecteur<R>)>;

    /// Whether the ray (S, D) may enter: never false if it does, and cheap. A bounded shape
    /// keeps this definition, on which the proof of culling rests.
    #[inline(always)]
    fn peut_entrer(&self, s: Vecteur<R>, d: Vecteur<R>) -> bool {
        self.boule().approchee(s, d)
    }

    /// The distance at which a ray that [may enter](Self::peut_entrer) enters, +∞ if it does not;
    /// computed without a branch.
    fn t(&self, s: Vecteur<R>, d: Vecteur<R>) -> R;

    /// The hit that the search found at distance `t`, computed in `f64` and without a branch. The
    /// second value is false if rounding may have spoiled it: take [`contact_rare`](Self::contact_rare).
    fn contact(&self, rayon: &Rayon<R>, t: R) -> (Contact<R>, bool);

    /// The same hit, where it takes more than the ordinary formula.
    fn contact_rare(&self, rayon: &Rayon<R>, t: R) -> Contact<R>;

    /// The distance of [`contact`](Self::contact), and whether it is that of the hit.
    fn distance_seule(&self, rayon: &Rayon<R>, t: R) -> (R, bool);

    /// The distance at which the ray (S, D) enters, +∞ if it does not.
    #[inline(always)]
    fn entree(&self, s: Vecteur<R>, d: Vecteur<R>) -> R {
        if self.peut_entrer(s, d) { self.t(s, d) } else { R::INFINI }
    }

    /// The distance of the hit that the search found at distance `t`.
    #[inline(always)]
    fn distance_conclue(&self, rayon: &Rayon<R>, t: R) -> R {
        let (distance, sur) = self.distance_seule(rayon, t);
        if sur { distance } else { self.contact_rare(rayon, t).distance }
    }

    /// The hit that the search found at distance `t`, on the object of this texture and rank.
    #[inline(always)]
    fn conclure(&self, rayon: &Rayon<R>, t: R, texture: Texture, rang: Rang) -> Intersection<R> {
        let (contact, sur) = self.contact(rayon, t);
        if sur {
            Intersection::new(contact, texture, rang)
        } else {
            Intersection::new(self.contact_rare(rayon, t), texture, rang)
        }
    }
}

/// A ball: its centre C and the square of its radius.
#[derive(Clone, Copy)]
pub(crate) struct Boule<R> {
    pub(crate) centre: Vecteur<R>,
    pub(crate) r2: R,
}

impl<R: Reel> Boule<R> {
    /// The ball around an unbounded shape.
    pub(crate) const INFINIE: Self = Self { centre: Vecteur::NUL, r2: R::INFINI };

    /// Whether the ray (S, D) comes near the ball.
    ///
    /// Never false for a ray that enters the shape, whatever rounding does: SC² − (SC·D)² is off by
    /// less than 32u·SC², a box whose normals are orthonormal to 12u pokes out of the ball by 36u·r²,
    /// and the factor 1 − 128u takes away more than both (derivation in `docs/conception.md`). A ray
    /// whose source is in the ball passes even with C behind it.
    #[inline(always)]
    pub(crate) fn approchee(self, s: Vecteur<R>, d: Vecteur<R>) -> bool {
        let sc = self.centre - s;
        let sa = sc.produit_scalaire(d);
        let sc2 = sc.longueur_carree() * (R::UN - fois_u(128.0));
        (sc2 - sa * sa <= self.r2) & ((sa > R::ZERO) | (sc2 <= self.r2))
    }
}
