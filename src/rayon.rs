//! Rays of light (handout §4.1 and annex A): a source and a unit direction.

use crate::reel::{Reel, fois_u};
use crate::refus::{ErreurGeo, fini, point, refus_nul};
use crate::vecteur::Vecteur;

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
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "R: Reel + serde::Serialize")))]
#[must_use]
pub struct Rayon<R = f64> {
    source: Vecteur<R>,
    direction: Vecteur<R>,
}

impl<R: Reel> Rayon<R> {
    /// The ray from `source` in this direction, which may have any length: it is brought to
    /// length 1. A direction that is already unit to rounding is kept bit for bit.
    ///
    /// # Errors
    /// If a coordinate of the source is beyond ±2⁴⁵⁰ (`f64`) or ±2⁶⁰ (`f32`), or if the direction
    /// is zero or not finite.
    pub fn new(source: Vecteur<R>, direction: Vecteur<R>) -> Result<Self, ErreurGeo> {
        Ok(Self { source: source_valide(source)?, direction: direction_unitaire(direction)? })
    }

    /// The ray of a source and a direction that were checked before.
    #[inline(always)]
    pub(crate) fn sans_verifier(source: Vecteur<R>, direction: Vecteur<R>) -> Self {
        Self { source, direction }
    }

    /// S, where the ray starts.
    #[doc(alias = "origin")]
    #[inline(always)]
    pub fn source(&self) -> Vecteur<R> {
        self.source
    }

    /// D, a unit vector.
    #[inline(always)]
    pub fn direction(&self) -> Vecteur<R> {
        self.direction
    }

    /// R(t) = S + t·D, the point at this distance from the source, in scene units. At +∞ a
    /// coordinate may be NaN.
    #[doc(alias = "at")]
    #[inline(always)]
    pub fn point(&self, distance: R) -> Vecteur<R> {
        self.source + self.direction * distance // M1
    }

    /// The same ray in `f32`, seen from an origin that is taken off before anything is rounded: the
    /// ray for objects that [`ObjetGeo::vers_f32`](crate::ObjetGeo::vers_f32) gave with this origin.
    ///
    /// # Errors
    /// If the source in `f32` is outside the limits of [`new`](Self::new), as with an `origine` that is
    /// not finite.
    ///
    /// ```
    /// use lancer_rayon::{Rayon, Vecteur};
    ///
    /// let arpenteur = Vecteur::new(500001.005, 150.0, 4200000.0115);
    /// let rayon = Rayon::new(arpenteur, Vecteur::new(0.0, -1.0, 0.0))?;
    /// let rayon = rayon.vers_f32(Vecteur::new(500000.0, 0.0, 4200000.0))?;
    /// assert_eq!(rayon.source(), Vecteur::new(1.005_f32, 150.0, 0.0115));
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("to_f32", "narrow", "floating_origin"))]
    pub fn vers_f32(self, origine: Vecteur<R>) -> Result<Rayon<f32>, ErreurGeo> {
        Rayon::new((self.source - origine).vers_f32(), self.direction.vers_f32())
    }

    /// The same ray in `f64`, exactly: to judge an answer in `f32` by one in `f64`.
    ///
    /// The direction is not made unit again. That of an `f32` stays unit to the rounding of `f32`,
    /// and distances along it are in units of its length, in both types alike. Batches and
    /// hierarchies answer it as a list does, since what they leave out presumes no more. Margins and
    /// secondary rays of its hits are not promised.
    ///
    /// ```
    /// use lancer_rayon::{Rayon, Vecteur};
    ///
    /// let rayon = Rayon::<f32>::new(Vecteur::NUL, Vecteur::new(1.0, 2.0, 3.0))?;
    /// assert_eq!(rayon.vers_f64().direction(), rayon.direction().vers_f64());
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("to_f64", "widen"))]
    pub fn vers_f64(self) -> Rayon {
        Rayon { source: self.source.vers_f64(), direction: self.direction.vers_f64() }
    }
}

/// This source; refused if it is outside the limits of a scene.
#[inline]
pub(crate) fn source_valide<R: Reel>(source: Vecteur<R>) -> Result<Vecteur<R>, ErreurGeo> {
    point(["source.x", "source.y", "source.z"], source)
}

/// A direction with |D·D − 1| within so many u is kept: an ordinary normalisation leaves 10 (lemma
/// 1).
pub const DEJA_UNITAIRE: f64 = 12.0;

/// This direction brought to length 1; refused if it is zero or not finite.
#[inline]
pub(crate) fn direction_unitaire<R: Reel>(direction: Vecteur<R>) -> Result<Vecteur<R>, ErreurGeo> {
    let direction = fini(["direction.x", "direction.y", "direction.z"], direction)?;
    if (direction.longueur_carree() - R::UN).abs() <= fois_u(DEJA_UNITAIRE) {
        return Ok(direction);
    }
    direction.unitaire().ok_or_else(|| refus_nul("direction"))
}

crate::refus::lu_par_new! {
    Rayon { source: Vecteur<R>, direction: Vecteur<R> }
}
