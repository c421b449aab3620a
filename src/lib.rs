//! The geometry kernel of a raytracer: given a ray and a list of spheres, half-spaces and rotated
//! boxes, it finds the object that the ray touches **first**, with its distance, its unit normal
//! and its texture. The names and the formulae are those of the *handout*, the French text of a
//! course project; a search finds each public name by English words.
//!
//! ```
//! use lancer_rayon::*;
//!
//! let boule = SphereGeo::new(Vecteur::new(0.0, 0.0, -5.0), 1.0, Texture(0))?;
//! let fond = PlanGeo::new(Rotation::IDENTITE, 9.0, Texture(1))?;
//! let scene: Vec<ObjetRay> = vec![boule.into(), fond.into()];
//!
//! let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
//! let touche = premiere_intersection(&scene, &rayon)?;
//! assert_eq!((touche.distance(), touche.texture()), (4.0, Texture(0)));
//! assert_eq!(touche.point(), Vecteur::new(0.0, 0.0, -4.0));
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```
//!
//! # The way through
//!
//! The pages that are named here, such as `docs/guide.md` with programs for common needs, come with
//! the sources of the crate, whose `README.md` leads to them.
//!
//! Describe objects with [`SphereGeo`], [`PlanGeo`] and [`BoiteGeo`]. Move them with
//! [`ObjetGeo::translation`], [`rotation`](ObjetGeo::rotation) and
//! [`homothetie`](ObjetGeo::homothetie), and convert them once with
//! [`vers_ray`](ObjetGeo::vers_ray). Then ask [`premiere_intersection`] for each ray.
//!
//! For everything else there is a [`Monde`] over the list of objects. From ten spheres and boxes on
//! [`Monde::new`] builds a tree, so that the time of a ray grows far more slowly than the number of
//! objects. A `Monde` answers many rays at once
//! ([`premieres_intersections`](Monde::premieres_intersections), with the same bits, and several
//! times as fast for the rays of a camera). It tells [how much of a light falls on a
//! hit](Monde::eclairement), [whether anything stands before the end of a ray](Monde::est_occulte),
//! [what a ray enters, in order](Monde::dans_l_ordre), and [whether a point is in an
//! object](Monde::contient), for all objects or [any choice of them](Monde::parmi). Rays that leave
//! a hit are asked by [`premiere_depuis`](Monde::premiere_depuis). A ray may have [an
//! end](Rayon::jusqu_a). [`ObjetRay::sortie`] tells where a ray leaves an object, and
//! [`traversee`](ObjetRay::traversee) which part of it lies within.
//!
//! # Conventions
//!
//! **Axes** are right-handed: x to the right, y up, z towards the viewer. Angles are in radians.
//!
//! **Rotations** multiply from the right, V·M, about x, then y, then z. They turn clockwise as the
//! axis points at you; [`Rotation::main_droite`] is the right-hand rule.
//!
//! ```
//! # use lancer_rayon::*;
//! # use core::f64::consts::FRAC_PI_2;
//! let quart = Rotation::new(Vecteur::new(FRAC_PI_2, 0.0, 0.0))?;
//! let tourne = quart.appliquer(Vecteur::new(1.0, 2.0, 3.0));
//! assert_eq!(tourne, Vecteur::new(1.0, 3.0, -2.0));
//! # Ok::<(), ErreurGeo>(())
//! ```
//!
//! **A half-space** is solid: it consists of the points where N·X ≤ −d, with d < 0 if the origin is
//! strictly inside.
//!
//! ```
//! # use lancer_rayon::*;
//! // The points z ≤ −2, moved to z ≤ 3.
//! let fond = PlanGeo::new(Rotation::IDENTITE, 2.0, Texture(0))?;
//! let fond = fond.translation(Vecteur::new(0.0, 0.0, 5.0))?;
//! assert_eq!(fond.vers_ray().distance(), -3.0);
//! # Ok::<(), ErreurGeo>(())
//! ```
//!
//! **A hit is an entry** from outside, against the normal (D·N < 0). An object is not hit from
//! inside or from its surface, and a ray tangent to a sphere misses. The distance t is above 0. It
//! is 0 only for a ray that carries [a bound δ on the error of its start](Rayon::flou), as one from
//! a hit does: such a ray hits at t = 0 what it might otherwise slip into through a seam.
//!
//! ```
//! # use lancer_rayon::*;
//! let autour = SphereGeo::new(Vecteur::NUL, 9.0, Texture(0))?;
//! let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
//! let touche = ObjetRay::from(autour).intersection(&rayon);
//! assert_eq!(touche, Err(NoIntersection));
//! # Ok::<(), ErreurGeo>(())
//! ```
//!
//! **Objects turn about the origin** and grow about their own centre. **At equal distance** the
//! object that is earlier in the list is hit.
//!
//! **Invalid values cannot be constructed.** Constructors and transformations refuse, by an error
//! that names the field,
//!
//! - what is not finite;
//! - a coordinate beyond ±2⁴⁵⁰, or ±2⁶⁰ for `f32`;
//! - a size outside 2⁻⁴⁵⁰ … 2⁴⁵⁰, or 2⁻⁶⁰ … 2⁶⁰.
//!
//! A [`Vecteur`] is a bare triple, which the types built from it check. No hit holds a NaN, and no
//! question panics, except of a list of more than 2³² − 1 objects.
//!
//! **A hit knows its object and its error**: [`Intersection::indice`] is the index in the list, and
//! [`Intersection::marge`] bounds how far the point is from the surface.
//! [`Intersection::secondaire`] starts a shadow, reflection or refraction ray that never hits the
//! object it leaves, with [two exceptions](Intersection::secondaire). [`BoiteRay::lieu`] says which
//! face of a box was hit, and where.
//!
//! Four functions tell how far an answer is to be trusted:
//!
//! | ask | about | it says | it costs |
//! |---|---|---|---|
//! | [`touche.marge()`](Intersection::marge) | the **point** of a hit | how far it lies from the surface at most, along the normal | nothing: each hit has it |
//! | [`objet.erreur(&rayon, &touche)`](ObjetRay::erreur) | the **distance** of a hit or a way out | how far it is off at most, along the ray | many times a hit |
//! | [`objet.est_certain(&rayon)`](ObjetRay::est_certain) | **hit or miss** of one object | whether that is certainly what exact arithmetic says | a few times a hit |
//! | [`monde.certifie(&rayon, &reponse)`](Monde::certifie) | **which object** of a list is first, or that none is | whether that is certainly what exact arithmetic says | less than two rays on average, on top of the ray |
//!
//! All of them speak of the numbers as they are stored.
//!
//! # `f32` or `f64`
//!
//! Every type that holds coordinates takes the scalar as a parameter, `f64` unless named:
//! `Vecteur<f32>`. Hits are computed in that type. Take `f32` for speed and memory, in batches
//! above all, and `f64` for distances to some 10⁻¹⁴ of the lengths involved (`docs/vitesse.md`).
//! Far from the origin O subtract an origin from the scene first: [`ObjetGeo::vers_f32`].
//!
//! Errors are bounded in both types alike, in units of u, half a unit in the last place of 1: [2⁻²⁴
//! or 2⁻⁵³](Nombre::U) (`docs/precision.md`).
//!
//! # Features
//!
//! `std` (default) brings the hardware square root; a [`Monde`] then chooses the best instruction
//! set of the machine at run time. Without `std` the crate needs `core` alone, uses the instruction
//! set that it is compiled for, and gives the same bits. `serde` reads and writes hits and misses, `Vecteur`, `Rotation`,
//! `Texture`, `Face`, `Rayon` and the describing types, through the same checks as their
//! constructors. `mint` converts [`Vecteur`] and [`Rotation`] from and to its types, and through
//! these those of glam or nalgebra. The crate allocates nothing and contains no `unsafe`.
#![no_std]

#[cfg(feature = "std")]
extern crate std;

mod algebre;
mod arbre;
mod cote_a_cote;
#[cfg(feature = "serde")]
mod ecrit;
mod monde;
mod objet;
#[doc(hidden)]
pub mod pour_les_tests;
mod question;
mod rayon;
mod texture;

pub use algebre::nombre::Nombre;
pub use algebre::refus::ErreurGeo;
pub use algebre::rotation::Rotation;
pub use algebre::vecteur::Vecteur;
pub use arbre::construction::{PlacesInsuffisantes, places};
pub use monde::reponses::{LongueursDifferentes, Reel};
pub use monde::{Monde, premiere_intersection};
pub use objet::boite::face::Face;
pub use objet::boite::{BoiteGeo, BoiteRay};
pub use objet::plan::{PlanGeo, PlanRay};
pub use objet::sphere::{SphereGeo, SphereRay};
pub use objet::{Etendue, ObjetGeo, ObjetRay};
pub use question::choix::{Choix, Parmi, Sans, Tous};
pub use rayon::Rayon;
pub use rayon::intersection::{Intersection, NoIntersection, Reponse};
pub use rayon::lumiere::Lumiere;
pub use texture::Texture;

/// Runs the example of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
