//! Rays of light (handout §4.1 and annex A).

use crate::erreur::{exiger, fini, point, refus};
use crate::reel::u;
use crate::{ErreurGeo, Intersection, Reel, Vecteur};

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
    pub(crate) source: Vecteur<R>,
    pub(crate) direction: Vecteur<R>,
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
        if (direction.longueur_carree() - R::UN).abs() <= u(12.0) {
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

    /// A ray that starts where this one touched an object and cannot touch that object again, but
    /// inward at an edge of a box: for shadows, reflections (a direction outward, D·N > 0) and
    /// transparency (inward).
    ///
    /// The source is the point of the hit, moved along the normal to the side to which the
    /// direction leads, by [`marge`](Intersection::marge) and the rounding of the moved point,
    /// 2u·Σ|N_i·P_i|: from outside an object that is left is not met again, from inside it is not
    /// seen at all. A direction within 4u of the tangent plane is turned outward by 8u. There is
    /// no epsilon to choose, and nothing farther than that step is jumped over.
    ///
    /// Within rounding of an edge of a box an inward ray may touch the other face of that edge,
    /// of which the hit knows nothing.
    ///
    /// # Errors
    /// If the direction is zero or not finite, if `touche` was altered into no hit (a distance
    /// that is not a finite number above 0, a normal that is not unit), or if the start lies beyond
    /// the limits of a source, as for [`new`](Self::new); a hit whose `marge` is +∞ has none.
    ///
    /// ```
    /// use lancer_rayon::{NoIntersection, ObjetGeo, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = ObjetGeo::from(SphereGeo::new(Vecteur::new(0.1, 0.2, -5.0), 1.7, Texture(0))?).vers_ray();
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.1, 0.05, -1.0))?;
    /// let touche = boule.intersection(&rayon)?;
    ///
    /// let (d, n) = (rayon.direction(), touche.normale);
    /// let reflet = rayon.secondaire(&touche, d - n * (2.0 * d.produit_scalaire(n)))?;
    /// assert_eq!(boule.intersection(&reflet), Err(NoIntersection));
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias = "spawn_ray")]
    #[doc(alias = "shadow_ray")]
    #[doc(alias = "reflection")]
    pub fn secondaire(
        &self,
        touche: &Intersection<R>,
        direction: Vecteur<R>,
    ) -> Result<Self, ErreurGeo> {
        let Intersection { distance, normale: n, .. } = *touche;
        let attendu = "a finite number above 0";
        exiger(distance > R::ZERO && distance < R::INFINI, "touche.distance", distance, attendu)?;
        let longueur = n.longueur();
        let unitaire = (longueur - R::UN).abs() <= u(16.0);
        exiger(unitaire, "|touche.normale|", longueur, "1, to rounding")?;

        let direction = Self::new(self.source, direction)?.direction;
        let cosinus = direction.produit_scalaire(n);
        let direction = if cosinus.abs() <= u(4.0) { direction + n * u(8.0) } else { direction };
        let p = self.point(distance);
        // The bound of the hit, with room for N not being exactly unit, and the rounding of the
        // moved point.
        let pas = touche.marge() * (R::UN + u(16.0));
        let pas = pas + n.somme_des_grandeurs(p) * u(2.0);
        let pas = if cosinus < u(-4.0) { -pas } else { pas };
        Self::new(p + n * pas, direction)
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
