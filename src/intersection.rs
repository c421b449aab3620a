//! A hit and the bound on its error (handout §2.3 and §4.1).

use core::fmt;
use core::num::NonZero;

use crate::reel::Reel;
use crate::texture::Texture;
use crate::vecteur::Vecteur;

/// Where a ray first touches an object: what the handout asks for in §2.3.
///
/// Only a search makes one, so that its values always fit together.
///
/// ```
/// use lancer_rayon::{PlanGeo, Rayon, Rotation, Texture, Vecteur, premiere_intersection};
///
/// let fond = PlanGeo::new(Rotation::IDENTITE, 2.0, Texture(7))?;
/// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(3.0, 0.0, -4.0))?;
/// let touche = premiere_intersection(&[fond.into()], &rayon)?;
///
/// assert_eq!((touche.distance(), touche.normale()), (2.5, Vecteur::new(0.0, 0.0, 1.0)));
/// assert_eq!((touche.texture(), touche.objet()), (Texture(7), 0));
/// let point = rayon.point(touche.distance());
/// assert!((point - Vecteur::new(1.5, 0.0, -2.0)).longueur() < 1e-15);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[doc(alias("hit", "HitRecord"))]
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct Intersection<R = f64> {
    distance: R,
    normale: Vecteur<R>,
    marge: R,
    texture: Texture,
    objet: Rang,
}

/// A hit or a miss: the answer to every question for the first object.
#[doc(alias = "hit_or_miss")]
pub type Touche<R = f64> = Result<Intersection<R>, NoIntersection>;

// `Rang` is never 0, so the compiler marks a miss by rank 0, and `Touche` is no larger than
// `Intersection`.
const _: () = assert!(size_of::<Touche<f64>>() == 48 && size_of::<Touche<f32>>() == 28);

/// The number of an object in a list, counted from 1; objects from number 2³² on share the rank 2³²
/// − 1.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct Rang(NonZero<u32>);

/// As [`Intersection::objet`] says it.
impl fmt::Debug for Rang {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.indice().fmt(f)
    }
}

impl Rang {
    /// The rank of the object at this index of a list.
    #[inline(always)]
    pub(crate) fn de(indice: usize) -> Self {
        Self(NonZero::<u32>::MIN.saturating_add(u32::try_from(indice).unwrap_or(u32::MAX)))
    }

    /// Its place in the order of ranks; 0 of none, before any other.
    #[inline(always)]
    pub(crate) fn ordre(rang: Option<Self>) -> u32 {
        rang.map_or(0, |Self(nombre)| nombre.get())
    }

    /// The index in the list.
    #[inline(always)]
    pub(crate) fn indice(self) -> usize {
        self.0.get() as usize - 1
    }
}

impl<R: Reel> Intersection<R> {
    #[inline(always)]
    pub(crate) fn new(distance: R, contact: Contact<R>, texture: Texture, objet: Rang) -> Self {
        Self { distance, normale: contact.normale, marge: contact.marge, texture, objet }
    }

    /// t, finite and above 0: the object is touched at S + tD. As D is unit only to rounding, that
    /// is the distance in scene units to 7.6u.
    #[doc(alias = "t")]
    #[must_use]
    pub fn distance(&self) -> R {
        self.distance
    }

    /// N, the unit outward normal of the object at the hit; it points against the ray (D·N < 0), and
    /// where the ray leaves the object ([`sortie`](crate::ObjetRay::sortie)) along it.
    #[doc(alias = "normal")]
    pub fn normale(&self) -> Vecteur<R> {
        self.normale
    }

    /// The texture of the object.
    #[doc(alias = "material")]
    pub fn texture(&self) -> Texture {
        self.texture
    }

    /// The index of the object in the list that was asked; 0 for an object that was asked alone.
    ///
    /// A list has at most 2³² − 1 objects: of more, those beyond are taken for the last of these.
    #[doc(alias("index", "primitive_id"))]
    #[must_use]
    pub fn objet(&self) -> usize {
        self.objet.indice()
    }

    /// How far at most the point `rayon.point(distance)`, as computed, lies from the surface
    /// along the normal; in scene units.
    ///
    /// It is a proven bound (derived in `docs/preuves.md`), most often a few times the error
    /// itself, and never a NaN. It is +∞ where the point is beyond the range of the type, and for a
    /// sphere that is lost in rounding: always with a radius below a = 16u·(|x| + |y| + |z|) of the
    /// point, never with one of 64u·|f| + a or more, |f| the distance of the source from the
    /// centre. For a box the surface is the plane of the face that was touched.
    ///
    /// ```
    /// use lancer_rayon::{ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = SphereGeo::new(Vecteur::new(0.0, 0.0, -5.0), 1.0, Texture(0))?;
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.1, 0.05, -1.0))?;
    /// let touche = ObjetRay::from(boule).intersection(&rayon)?;
    /// assert!(touche.marge() < 1e-14);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("error_bound", "margin"))]
    #[must_use]
    pub fn marge(&self) -> R {
        self.marge
    }
}

/// What is computed once for a hit: all of an [`Intersection`] except what the search found.
#[derive(Clone, Copy)]
pub(crate) struct Contact<R> {
    pub(crate) normale: Vecteur<R>,
    pub(crate) marge: R,
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
#[doc(alias("No_intersection", "miss"))]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct NoIntersection;

impl fmt::Display for NoIntersection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the ray touches no object")
    }
}

impl core::error::Error for NoIntersection {}
