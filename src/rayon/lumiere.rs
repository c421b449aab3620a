//! Lights (handout §1): lamps, which have a place, and suns, which have a direction.

use crate::algebre::refus::fini;
use crate::rayon::{DIRECTION, direction_unitaire};
use crate::{ErreurGeo, Nombre, Vecteur};

/// A light that shines on hits: what [`Monde::eclairement`](crate::Monde::eclairement) and
/// [`Monde::eclairements`](crate::Monde::eclairements) ask about.
///
/// It has no brightness and no colour, and does not tell its place: a question about a light is
/// whether it is seen, and at which angle. Keep beside it what the shading needs.
///
/// ```
/// use lancer_rayon::{Lumiere, Vecteur};
///
/// let lampe = Lumiere::lampe(Vecteur::new(0.0, 9.0, 0.0))?;
/// let soleil = Lumiere::soleil(Vecteur::new(1.0, 2.0, 0.0))?;
/// assert_ne!(lampe, soleil);
/// assert_eq!(Lumiere::<f64>::soleil(Vecteur::NUL).unwrap_err().champ, "direction");
/// # Ok::<(), lancer_rayon::ErreurGeo>(())
/// ```
#[doc(alias("light", "lamp", "sun", "point_light", "directional_light"))]
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct Lumiere<R = f64>(Ou<R>);

/// Where a light is.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Ou<R> {
    Ici(Vecteur<R>),
    /// In this direction, which is unit, farther than all objects.
    AuLoin(Vecteur<R>),
}

impl<R: Nombre> Lumiere<R> {
    /// A lamp: a point that shines to all sides.
    ///
    /// # Errors
    /// If a coordinate of the position is not finite.
    #[doc(alias("lamp", "point_light"))]
    #[inline]
    pub fn lampe(position: Vecteur<R>) -> Result<Self, ErreurGeo> {
        let position = fini(["position.x", "position.y", "position.z"], position)?;
        Ok(Self(Ou::Ici(position)))
    }

    /// A sun: a light without a place. `direction` leads to the light, and may have any length.
    ///
    /// # Errors
    /// If the direction is zero or not finite.
    #[doc(alias("sun", "directional_light"))]
    #[inline]
    pub fn soleil(direction: Vecteur<R>) -> Result<Self, ErreurGeo> {
        let direction = direction_unitaire(DIRECTION, direction)?;
        Ok(Self(Ou::AuLoin(direction)))
    }

    /// How far away the light is from this point, and the unit direction to it.
    #[inline(always)]
    pub(crate) fn vue_de(&self, source: Vecteur<R>) -> (R, Vecteur<R>) {
        match self.0 {
            Ou::Ici(position) => vue_d_une_lampe(position, source),
            Ou::AuLoin(direction) => (R::INFINI, direction),
        }
    }

    /// The same without a branch, for points side by side; the direction is NaN where a lamp stands
    /// at the point itself.
    #[inline(always)]
    pub(crate) fn vue_cote_a_cote(&self, source: Vecteur<R>) -> (R, Vecteur<R>) {
        match self.0 {
            Ou::Ici(position) => {
                let (_, distance, direction) = (position - source).longueurs_et_unitaire();
                (distance, direction)
            }
            Ou::AuLoin(direction) => (R::INFINI, direction),
        }
    }
}

/// How far away a lamp is from this point, and the unit direction to it; 0 if it stands at the point
/// itself or is not finite.
#[inline(always)]
pub(crate) fn vue_d_une_lampe<R: Nombre>(
    position: Vecteur<R>,
    source: Vecteur<R>,
) -> (R, Vecteur<R>) {
    (position - source).longueur_et_unitaire().unwrap_or((R::ZERO, Vecteur::NUL))
}
