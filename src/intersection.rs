//! The first object that a ray touches (handout §4.1).

use core::fmt;

use crate::reel::u;
use crate::{ObjetRay, Rayon, Reel, Texture, Vecteur};

/// Where a ray first touches an object: what the handout asks for in §2.3.
///
/// ```
/// use lancer_rayon::{Intersection, PlanGeo, Rayon, Rotation, Texture, Vecteur, premiere_intersection};
///
/// let fond = PlanGeo::new(Rotation::IDENTITE, 2.0, Texture(7))?.vers_ray();
/// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(3.0, 0.0, -4.0))?;
/// let touche = premiere_intersection(&[fond.into()], &rayon)?;
///
/// let Intersection { distance, normale, texture, .. } = touche;
/// assert_eq!((distance, normale, texture), (2.5, Vecteur::new(0.0, 0.0, 1.0), Texture(7)));
/// assert!((rayon.point(distance) - Vecteur::new(1.5, 0.0, -2.0)).longueur() < 1e-15);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[doc(alias = "hit")]
#[doc(alias = "HitRecord")]
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct Intersection<R = f64> {
    /// From the source of the ray to the object, in scene units: finite and above 0.
    pub distance: R,
    /// The direction of the surface there: unit, outward, and against the ray (D·N < 0).
    #[doc(alias = "normal")]
    pub normale: Vecteur<R>,
    /// The texture of the object.
    pub texture: Texture,
    pub(crate) marge: R,
}

impl<R: Reel> Intersection<R> {
    /// The hit of `rayon` at t > 0, rounded to R. One too small for R stays a hit, at the
    /// smallest distance.
    ///
    /// `hauteur` gives, for a point in f64, its height over the surface along the normal, and a
    /// length such that 4u of it is more than either this height or the test of the search, in
    /// R, can be off by there.
    #[inline(always)]
    pub(crate) fn new(
        rayon: &Rayon<R>,
        t: f64,
        normale: Vecteur<R>,
        texture: Texture,
        hauteur: impl FnOnce(Vecteur<f64>) -> (f64, f64),
    ) -> Self {
        let t = R::depuis_f64(t);
        let distance = if t > R::ZERO { t } else { R::PLUS_PETIT };
        // The bound is made from the very point that the caller will compute.
        let (hauteur, longueur) = hauteur(rayon.point(distance).vers_f64());
        let quatre_u: R = u(4.0);
        let marge = R::depuis_f64(hauteur + longueur * quatre_u.vers_f64());
        // Upwards, past the rounding of these last operations; a NaN comes from an overflow.
        let marge = marge + marge * quatre_u + R::depuis_f64(8.0) * R::PLUS_PETIT;
        let marge = if marge < R::INFINI { marge } else { R::INFINI };
        Self { distance, normale, texture, marge }
    }

    /// How far at most the point `rayon.point(distance)`, as computed, lies from the surface
    /// along the normal; in scene units.
    ///
    /// It is a proven bound (derived in `docs/precision.md`), most often a few times the error
    /// itself, and never a NaN. It is +∞ where the point is beyond the range of the type, and for
    /// a sphere no larger than the rounding of its distance or of its coordinates. For a box the
    /// surface is the plane of the face that was touched.
    ///
    /// ```
    /// use lancer_rayon::{ObjetGeo, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = ObjetGeo::from(SphereGeo::new(Vecteur::new(0.0, 0.0, -5.0), 1.0, Texture(0))?);
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.1, 0.05, -1.0))?;
    /// let touche = boule.vers_ray().intersection(&rayon)?;
    /// assert!(touche.marge() < 1e-14);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias = "error_bound")]
    #[doc(alias = "margin")]
    #[inline]
    #[must_use]
    pub fn marge(&self) -> R {
        self.marge
    }
}

/// The ray touches nothing: the exception `No_intersection` of the handout's §4.1.
///
/// ```
/// use lancer_rayon::{NoIntersection, ObjetRay, Rayon, Vecteur, premiere_intersection};
///
/// let vide: [ObjetRay; 0] = [];
/// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
/// assert_eq!(premiere_intersection(&vide, &rayon), Err(NoIntersection));
/// assert_eq!(NoIntersection.to_string(), "the ray touches no object");
/// # Ok::<(), lancer_rayon::ErreurGeo>(())
/// ```
#[doc(alias = "No_intersection")]
#[doc(alias = "miss")]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct NoIntersection;

impl fmt::Display for NoIntersection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the ray touches no object")
    }
}

impl core::error::Error for NoIntersection {}

/// The first object that the ray enters: its distance, its normal there, its texture
/// (handout §4.1).
///
/// A hit is an entry. An object that contains the source, or whose surface does, is not
/// touched (handout §2.3); the others still count. Of two objects at the same distance the
/// earlier in the list is the first.
///
/// # Errors
/// [`NoIntersection`] if the ray enters no object.
///
/// ```
/// use lancer_rayon::{
///     NoIntersection, ObjetGeo, Rayon, SphereGeo, Texture, Vecteur, premiere_intersection,
/// };
///
/// let boule = |z, texture| SphereGeo::new(Vecteur::new(0.0, 0.0, z), 1.0, Texture(texture));
/// let scene = [boule(-9.0, 0)?, boule(-4.0, 1)?].map(|b| ObjetGeo::from(b).vers_ray());
///
/// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
/// let touche = premiere_intersection(&scene, &rayon)?;
/// assert_eq!(touche.distance, 3.0);
/// assert_eq!(touche.normale, Vecteur::new(0.0, 0.0, 1.0));
/// assert_eq!(touche.texture, Texture(1));
///
/// let ailleurs = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 1.0, 0.0))?;
/// assert_eq!(premiere_intersection(&scene, &ailleurs), Err(NoIntersection));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[doc(alias = "cast_ray")]
#[doc(alias = "closest_hit")]
#[doc(alias = "raycast")]
#[inline]
pub fn premiere_intersection<R: Reel>(
    objets: &[ObjetRay<R>],
    rayon: &Rayon<R>,
) -> Result<Intersection<R>, NoIntersection> {
    let (s, d) = (rayon.source(), rayon.direction());
    let mut premier = None;
    let mut t_premier = R::INFINI;
    for objet in objets {
        let t = objet.t(s, d);
        if t < t_premier {
            t_premier = t;
            premier = Some(objet);
        }
    }
    match premier {
        Some(objet) => Ok(objet.conclure(rayon, t_premier)),
        None => Err(NoIntersection),
    }
}

/// Whether something is in the way of the ray before `distance_max`, the distance of a light: the
/// shadow of the handout's later parts.
///
/// It is `objets.iter().any(|o| o.intersection(rayon).is_ok_and(|i| i.distance < distance_max))`, and
/// ends with the first such object. +∞ asks whether the ray touches anything at all; a NaN has
/// nothing before it.
///
/// A [`secondaire`](Rayon::secondaire) leaves the point of a hit, and its own source is the one to
/// measure from. Towards a lamp behind the surface it leads inward, where it does not see the object
/// that it leaves: whether the surface faces the lamp, the sign of N·L says.
///
/// ```
/// use lancer_rayon::{
///     ObjetGeo, Rayon, SphereGeo, Texture, Vecteur, est_occulte, premiere_intersection,
/// };
///
/// let boule = |y, r, texture| SphereGeo::new(Vecteur::new(0.0, y, -5.0), r, Texture(texture));
/// let scene = [boule(0.0, 1.0, 0)?, boule(4.0, 0.5, 1)?].map(|b| ObjetGeo::from(b).vers_ray());
/// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.6, -5.0))?;
/// let touche = premiere_intersection(&scene, &rayon)?;
/// let eclaire = |lampe: Vecteur| -> Result<bool, Box<dyn core::error::Error>> {
///     let vers = lampe - rayon.point(touche.distance);
///     let ombre = rayon.secondaire(&touche, vers)?;
///     let distance = (lampe - ombre.source()).longueur();
///     let de_face = vers.produit_scalaire(touche.normale) > 0.0;
///     Ok(de_face && !est_occulte(&scene, &ombre, distance))
/// };
/// assert!(eclaire(Vecteur::new(0.0, 3.0, -2.0))?);
/// assert!(!eclaire(Vecteur::new(0.0, 9.0, -5.2))?); // behind the small ball
/// assert!(!eclaire(Vecteur::new(0.0, 0.0, -9.0))?); // behind the surface
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[doc(alias = "any_hit")]
#[doc(alias = "occluded")]
#[doc(alias = "shadow")]
#[inline]
#[must_use]
pub fn est_occulte<R: Reel>(objets: &[ObjetRay<R>], rayon: &Rayon<R>, distance_max: R) -> bool {
    let (s, d) = (rayon.source(), rayon.direction());
    let avant = |objet: &ObjetRay<R>, t| {
        // The distance of a hit is always finite.
        distance_max == R::INFINI || objet.conclure(rayon, t).distance < distance_max
    };
    objets.iter().any(|objet| {
        let t = objet.t(s, d);
        t < R::INFINI && avant(objet, t)
    })
}
