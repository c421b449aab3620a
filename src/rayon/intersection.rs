//! A hit and the bound on its error (handout §2.3 and §4.1).

use core::fmt;
use core::num::NonZero;

use crate::{Nombre, Texture, Vecteur};

/// Where a ray first touches an object: what the handout asks for in §2.3.
///
/// A search makes one, or serde reads one that was written. It knows its point, so that the next
/// ray needs nothing else to start from: see [`secondaire`](Self::secondaire),
/// [`reflechi`](Self::reflechi), [`refracte`](Self::refracte),
/// [`vers_lumiere`](Self::vers_lumiere), [`vers_soleil`](Self::vers_soleil) and
/// [`vers_touche`](Self::vers_touche).
///
/// With the feature `serde` a hit that was written is read again, to the bit, unless it is a hit on
/// a [witness](crate::ObjetRay::temoin_f64), whose normal is not unit. JSON, which has no ±∞, does
/// not give back a hit whose point is beyond the range of the type; no ray starts from such a hit
/// either.
///
/// ```
/// use lancer_rayon::{PlanGeo, Rayon, Rotation, Texture, Vecteur, premiere_intersection};
///
/// let fond = PlanGeo::new(Rotation::IDENTITE, 2.0, Texture(7))?;
/// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(3.0, 0.0, -4.0))?;
/// let touche = premiere_intersection(&[fond.into()], &rayon)?;
///
/// assert_eq!((touche.distance(), touche.normale()), (2.5, Vecteur::new(0.0, 0.0, 1.0)));
/// assert_eq!((touche.texture(), touche.indice()), (Texture(7), 0));
/// assert_eq!(touche.point(), rayon.point(touche.distance()));
/// assert!((touche.point() - Vecteur::new(1.5, 0.0, -2.0)).longueur() < 1e-15);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[doc(alias("hit", "HitRecord"))]
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct Intersection<R = f64> {
    pub(crate) distance: R,
    pub(crate) contact: Contact<R>,
    /// The δ of the ray.
    pub(crate) delta: R,
    pub(crate) texture: Texture,
    pub(crate) rang: Rang,
}

/// A hit or a miss: the answer to every question for the first object.
#[doc(alias = "hit_or_miss")]
pub type Reponse<R = f64> = Result<Intersection<R>, NoIntersection>;

// `Rang` is never 0, so the compiler marks a miss by rank 0, and `Reponse` is no larger than
// `Intersection`.
const _: () = assert!(size_of::<Reponse<f64>>() == 80 && size_of::<Reponse<f32>>() == 44);

/// The number of an object in a list, counted from 1. A list holds at most 2³² − 1 objects, which
/// `question/liste.rs` sees to.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct Rang(NonZero<u32>);

/// Shown as [`Intersection::indice`] gives it.
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

    /// Its place in the order of ranks; 0 for none, which comes before any other.
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

impl<R: Nombre> Intersection<R> {
    /// A hit of which only the distance and the object are known so far.
    pub(crate) fn a_conclure(distance: R, rang: Rang) -> Self {
        let (normale, point) = (Vecteur::NUL, Vecteur::NUL);
        let contact = Contact { normale, marge: R::ZERO, point };
        Self { distance, contact, delta: R::ZERO, texture: Texture(0), rang }
    }

    /// t, finite and 0 or more: the object is touched at S + tD. Since D is unit only to rounding,
    /// t is the distance in scene units to a relative 7.6u. It is 0 if the ray touches [at
    /// once](crate::Rayon::flou).
    #[doc(alias = "t")]
    #[must_use]
    pub fn distance(&self) -> R {
        self.distance
    }

    /// N, the unit outward normal of the object at the hit. It points against the ray (D·N < 0), or
    /// along it where the ray leaves the object ([`sortie`](crate::ObjetRay::sortie)).
    #[doc(alias = "normal")]
    pub fn normale(&self) -> Vecteur<R> {
        self.contact.normale
    }

    /// P = S + tD, the point of the hit as computed: `rayon.point(distance)`.
    #[doc(alias("position", "location"))]
    pub fn point(&self) -> Vecteur<R> {
        self.contact.point
    }

    /// The texture of the object.
    #[doc(alias = "material")]
    pub fn texture(&self) -> Texture {
        self.texture
    }

    /// The index of the object in the list that was asked; 0 for an object that was asked alone.
    ///
    /// [`ObjetRay::intersection`](crate::ObjetRay::intersection) and
    /// [`sortie`](crate::ObjetRay::sortie) ask an object alone: keep its index beside their
    /// answers.
    #[doc(alias("index", "primitive_id", "object"))]
    #[must_use]
    pub fn indice(&self) -> usize {
        self.rang.indice()
    }

    /// A bound on how far [`point`](Self::point), as computed, lies from the surface along the
    /// normal, in scene units.
    ///
    /// The bound is proven (`docs/preuves/rayons.md`, lemma 8), most often a few times the error
    /// itself, and never a NaN. For a box the surface is the plane of the face that was touched.
    ///
    /// It is +∞ where the point is beyond the range of the type, at a flat face also where only the
    /// sum |N_x·x| + |N_y·y| + |N_z·z| is, by which its height rounds (for a box counted from the
    /// centre), and for a sphere that is lost in rounding. Let a = 16u·(|x| + |y| + |z|) of the
    /// point, as that sum is computed, and |f| the distance of the source from the centre. A sphere
    /// with a radius below a is always lost, and one with a radius of 64u·|f| + a or more never,
    /// unless it is touched [at once](crate::Rayon::flou) from deeper than 0.22 of the radius.
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
    #[doc(alias("error_bound", "margin", "epsilon"))]
    #[must_use]
    pub fn marge(&self) -> R {
        self.contact.marge
    }
}

/// What is computed once for a hit: all of an [`Intersection`] except what the search found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Contact<R> {
    pub(crate) normale: Vecteur<R>,
    pub(crate) marge: R,
    pub(crate) point: Vecteur<R>,
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
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct NoIntersection;

impl fmt::Display for NoIntersection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the ray touches no object")
    }
}

impl core::error::Error for NoIntersection {}
