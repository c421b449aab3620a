//! The two enums of the handout's §4.1, and every choice between shapes that the crate makes.

use crate::lot::{Conclusions, Groupe, proposer};
use crate::{
    BoiteGeo, BoiteRay, ErreurGeo, Intersection, NoIntersection, PlanGeo, PlanRay, Rayon, Reel,
    Rotation, SphereGeo, SphereRay, Texture, Vecteur, premiere_intersection,
};

/// An object as one describes and moves it (`Objet_geo` in the handout).
///
/// ```
/// use core::f64::consts::PI;
/// use lancer_rayon::{ObjetGeo, ObjetRay, Rotation, SphereGeo, Texture, Vecteur};
///
/// let boule = ObjetGeo::from(SphereGeo::new(Vecteur::NUL, 1.0, Texture(0))?);
/// let objet = boule.translation(Vecteur::new(0.0, 0.0, -4.0))?.homothetie(2.0)?;
/// let objet = objet.rotation(Rotation::new(Vecteur::new(0.0, PI, 0.0))?)?.vers_ray();
///
/// let ObjetRay::Sphere(boule) = objet else { panic!("a sphere stays one") };
/// assert_eq!((boule.centre(), boule.rayon()), (Vecteur::new(0.0, 0.0, 4.0), 2.0));
/// # Ok::<(), lancer_rayon::ErreurGeo>(())
/// ```
#[doc(alias = "shape")]
#[doc(alias = "Objet_geo")]
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "R: Reel + serde::Serialize")))]
#[cfg_attr(feature = "serde", serde(bound(deserialize = "R: Reel + serde::Deserialize<'de>")))]
#[must_use]
pub enum ObjetGeo<R = f64> {
    /// A sphere.
    Sphere(SphereGeo<R>),
    /// A half-space.
    #[doc(alias = "plane")]
    Plan(PlanGeo<R>),
    /// A box.
    #[doc(alias = "box")]
    Boite(BoiteGeo<R>),
}

impl<R: Reel> ObjetGeo<R> {
    /// The object moved by `v` (handout §2.3).
    ///
    /// # Errors
    /// If the moved object lies outside the limits of its constructor.
    #[doc(alias = "translate")]
    pub fn translation(self, v: Vecteur<R>) -> Result<Self, ErreurGeo> {
        Ok(match self {
            Self::Sphere(sphere) => Self::Sphere(sphere.translation(v)?),
            Self::Plan(plan) => Self::Plan(plan.translation(v)?),
            Self::Boite(boite) => Self::Boite(boite.translation(v)?),
        })
    }

    /// The object turned about the origin O (handout §2.3).
    ///
    /// # Errors
    /// If the turned object lies outside the limits of its constructor.
    #[doc(alias = "rotate")]
    pub fn rotation(self, r: Rotation<R>) -> Result<Self, ErreurGeo> {
        Ok(match self {
            Self::Sphere(sphere) => Self::Sphere(sphere.rotation(r)?),
            Self::Plan(plan) => Self::Plan(plan.rotation(r)?),
            Self::Boite(boite) => Self::Boite(boite.rotation(r)?),
        })
    }

    /// The object with its dimensions multiplied by `k`, its centre where it was; a half-space
    /// has none and stays as it is (handout §2.3).
    ///
    /// # Errors
    /// If `k` is not finite and above 0, or a dimension leaves the limits of the constructor.
    #[doc(alias = "scale")]
    pub fn homothetie(self, k: R) -> Result<Self, ErreurGeo> {
        Ok(match self {
            Self::Sphere(sphere) => Self::Sphere(sphere.homothetie(k)?),
            Self::Plan(plan) => Self::Plan(plan.homothetie(k)?),
            Self::Boite(boite) => Self::Boite(boite.homothetie(k)?),
        })
    }

    /// The same object, ready for rays (handout §3).
    #[doc(alias = "into_ray")]
    #[inline]
    pub fn vers_ray(self) -> ObjetRay<R> {
        match self {
            Self::Sphere(sphere) => ObjetRay::Sphere(sphere.vers_ray()),
            Self::Plan(plan) => ObjetRay::Plan(plan.vers_ray()),
            Self::Boite(boite) => ObjetRay::Boite(boite.vers_ray()),
        }
    }
}

/// An object ready for rays (`Objet_ray` in the handout).
///
/// ```
/// use lancer_rayon::{ObjetGeo, Rayon, SphereGeo, Texture, Vecteur};
///
/// let boule = SphereGeo::new(Vecteur::new(0.0, 0.0, -5.0), 1.0, Texture(3))?;
/// let objet = ObjetGeo::from(boule).vers_ray();
/// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
/// let touche = objet.intersection(&rayon)?;
/// assert_eq!((touche.distance, touche.texture), (4.0, Texture(3)));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[doc(alias = "primitive")]
#[doc(alias = "Objet_ray")]
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub enum ObjetRay<R = f64> {
    /// A sphere.
    Sphere(SphereRay<R>),
    /// A half-space.
    #[doc(alias = "plane")]
    Plan(PlanRay<R>),
    /// A box.
    #[doc(alias = "box")]
    Boite(BoiteRay<R>),
}

// Fifteen numbers, a texture and a tag: all of them pass through the cache for every ray.
const _: () = assert!(size_of::<ObjetRay<f64>>() <= 136);

/// What a shape answers about rays, in its own file and once, for a ray alone and for many side by
/// side.
pub(crate) trait Forme<R: Reel>: Copy {
    /// The centre of a ball around it and the square of its radius; +∞ if it has no end.
    fn boule(&self) -> (Vecteur<R>, R);

    /// Whether the ray (S, D) may enter: never false if it does, and cheap. For a shape with an end
    /// it is whether the ray [comes near](crate::boule::approche) that very ball.
    fn possible(&self, s: Vecteur<R>, d: Vecteur<R>) -> bool;

    /// The distance at which a [`possible`](Self::possible) ray enters, +∞ if it does not.
    fn t(&self, s: Vecteur<R>, d: Vecteur<R>) -> R;

    /// The hit that the search found at distance `t`, computed in `f64` and without a branch; and
    /// whether that is sure. If rounding spoiled it, [`reprendre`](Self::reprendre) concludes.
    fn conclure(&self, rayon: &Rayon<R>, t: R) -> (Intersection<R>, bool);

    /// The same hit, where it takes more than the ordinary formula.
    fn reprendre(&self, rayon: &Rayon<R>, t: R) -> Intersection<R>;
}

#[inline(always)]
fn entree<R: Reel>(forme: &impl Forme<R>, s: Vecteur<R>, d: Vecteur<R>) -> R {
    if forme.possible(s, d) { forme.t(s, d) } else { R::INFINI }
}

#[inline]
fn conclure<R: Reel>(forme: &impl Forme<R>, rayon: &Rayon<R>, t: R) -> Intersection<R> {
    let (touche, sure) = forme.conclure(rayon, t);
    if sure { touche } else { forme.reprendre(rayon, t) }
}

impl<R: Reel> ObjetRay<R> {
    /// Where the ray enters this object (handout, annex A): [`premiere_intersection`] with this
    /// object alone.
    ///
    /// # Errors
    /// [`NoIntersection`] if it does not: it misses, only touches, leaves, or starts inside or
    /// on the surface.
    #[doc(alias = "intersect")]
    #[doc(alias = "hit")]
    pub fn intersection(&self, rayon: &Rayon<R>) -> Result<Intersection<R>, NoIntersection> {
        premiere_intersection(core::slice::from_ref(self), rayon)
    }

    /// The distance at which the ray (S, D) enters this object, +∞ if it does not.
    #[inline(always)]
    pub(crate) fn t(&self, s: Vecteur<R>, d: Vecteur<R>) -> R {
        match self {
            Self::Sphere(sphere) => entree(sphere, s, d),
            Self::Plan(plan) => entree(plan, s, d),
            Self::Boite(boite) => entree(boite, s, d),
        }
    }

    /// The hit that the search found at distance `t`.
    pub(crate) fn conclure(&self, rayon: &Rayon<R>, t: R) -> Intersection<R> {
        match self {
            Self::Sphere(sphere) => conclure(sphere, rayon, t),
            Self::Plan(plan) => conclure(plan, rayon, t),
            Self::Boite(boite) => conclure(boite, rayon, t),
        }
    }

    /// Makes this object the first of those rays of the block that enter it before their first so
    /// far: one `match` for all of them.
    #[inline(always)]
    pub(crate) fn proposer_a<'a>(&'a self, bloc: &mut [Groupe<'a, R>]) {
        match self {
            Self::Sphere(sphere) => proposer(bloc, self, *sphere),
            Self::Plan(plan) => proposer(bloc, self, *plan),
            Self::Boite(boite) => proposer(bloc, self, *boite),
        }
    }

    /// The hits of those rays of the group whose first object this is; for the others anything.
    #[inline(always)]
    pub(crate) fn conclure_pour(&self, groupe: &Groupe<'_, R>, conclusions: &mut Conclusions<R>) {
        match self {
            Self::Sphere(sphere) => conclusions.remplir(groupe, *sphere),
            Self::Plan(plan) => conclusions.remplir(groupe, *plan),
            Self::Boite(boite) => conclusions.remplir(groupe, *boite),
        }
    }

    #[inline(always)]
    pub(crate) fn boule(&self) -> (Vecteur<R>, R) {
        match self {
            Self::Sphere(sphere) => sphere.boule(),
            Self::Plan(plan) => plan.boule(),
            Self::Boite(boite) => boite.boule(),
        }
    }

    #[inline(always)]
    pub(crate) fn texture(&self) -> Texture {
        match self {
            Self::Sphere(sphere) => sphere.texture(),
            Self::Plan(plan) => plan.texture(),
            Self::Boite(boite) => boite.texture(),
        }
    }
}

impl<R> From<SphereGeo<R>> for ObjetGeo<R> {
    fn from(sphere: SphereGeo<R>) -> Self {
        Self::Sphere(sphere)
    }
}

impl<R> From<PlanGeo<R>> for ObjetGeo<R> {
    fn from(plan: PlanGeo<R>) -> Self {
        Self::Plan(plan)
    }
}

impl<R> From<BoiteGeo<R>> for ObjetGeo<R> {
    fn from(boite: BoiteGeo<R>) -> Self {
        Self::Boite(boite)
    }
}

impl<R> From<SphereRay<R>> for ObjetRay<R> {
    fn from(sphere: SphereRay<R>) -> Self {
        Self::Sphere(sphere)
    }
}

impl<R> From<PlanRay<R>> for ObjetRay<R> {
    fn from(plan: PlanRay<R>) -> Self {
        Self::Plan(plan)
    }
}

impl<R> From<BoiteRay<R>> for ObjetRay<R> {
    fn from(boite: BoiteRay<R>) -> Self {
        Self::Boite(boite)
    }
}

impl<R: Reel> From<ObjetGeo<R>> for ObjetRay<R> {
    fn from(objet: ObjetGeo<R>) -> Self {
        objet.vers_ray()
    }
}
