//! Rays of light (handout §4.1 and annex A).

use crate::erreur::{fini, point, refus};
use crate::{ErreurGeo, Reel, Vecteur};

/// A ray: the points R(t) = S + t·D, t ≥ 0, from the source S along the unit vector D
/// (handout, annex A).
///
/// ```
/// use lancer_rayon::{Rayon, Vecteur};
///
/// let rayon = Rayon::new(Vecteur::new(0.0, 1.0, 0.0), Vecteur::new(0.0, 0.0, -8.0))?;
/// assert_eq!(rayon.direction(), Vecteur::new(0.0, 0.0, -1.0));
/// assert_eq!(rayon.point(3.0), Vecteur::new(0.0, 1.0, -3.0));
/// # Ok::<(), lancer_rayon::ErreurGeo>(())
/// ```
#[doc(alias = "ray")]
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "RayonBrut<R>"))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "R: Reel + serde::Serialize")))]
#[cfg_attr(feature = "serde", serde(bound(deserialize = "R: Reel + serde::Deserialize<'de>")))]
#[must_use]
pub struct Rayon<R = f64> {
    source: Vecteur<R>,
    direction: Vecteur<R>,
}

impl<R: Reel> Rayon<R> {
    /// The ray from `source` in this direction, which need not be of length 1: it is brought to
    /// it, whatever its length. A direction that is already unit to rounding is kept bit for bit.
    ///
    /// # Errors
    /// If a coordinate of the source is beyond ±2⁴⁵⁰ (`f64`) or ±2⁶⁰ (`f32`), or if the direction
    /// is zero or not finite.
    pub fn new(source: Vecteur<R>, direction: Vecteur<R>) -> Result<Self, ErreurGeo> {
        let source = point(["source.x", "source.y", "source.z"], source)?;
        let direction = fini(["direction.x", "direction.y", "direction.z"], direction)?;
        // An ordinary normalisation leaves |D·D − 1| ≤ 6u; twice that is still a unit vector.
        let douze_u = R::depuis_f64(12.0) * R::U;
        if (direction.longueur_carree() - R::UN).abs() <= douze_u {
            return Ok(Self { source, direction });
        }
        match direction.unitaire() {
            Some(direction) => Ok(Self { source, direction }),
            None => Err(refus("direction", R::ZERO, "a vector other than 0")),
        }
    }

    /// S, where the ray starts.
    #[doc(alias = "origin")]
    #[inline]
    pub fn source(&self) -> Vecteur<R> {
        self.source
    }

    /// D, a unit vector.
    #[inline]
    pub fn direction(&self) -> Vecteur<R> {
        self.direction
    }

    /// R(t) = S + t·D, the point at this distance from the source, in scene units.
    #[doc(alias = "at")]
    #[inline]
    pub fn point(&self, distance: R) -> Vecteur<R> {
        self.source + self.direction * distance
    }
}

#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
#[serde(rename = "Rayon")]
#[serde(bound(deserialize = "R: Reel + serde::Deserialize<'de>"))]
struct RayonBrut<R> {
    source: Vecteur<R>,
    direction: Vecteur<R>,
}

#[cfg(feature = "serde")]
impl<R: Reel> TryFrom<RayonBrut<R>> for Rayon<R> {
    type Error = ErreurGeo;
    fn try_from(brut: RayonBrut<R>) -> Result<Self, ErreurGeo> {
        Self::new(brut.source, brut.direction)
    }
}
