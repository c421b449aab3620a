//! wip
#![no_std]

#[cfg(feature = "std")]
extern crate std;

mod boite;
mod erreur;
mod intersection;
mod objet;
mod plan;
mod rayon;
mod reel;
mod rotation;
mod sphere;
mod texture;
mod vecteur;

pub use boite::{BoiteGeo, BoiteRay};
pub use erreur::ErreurGeo;
pub use intersection::{Intersection, NoIntersection, premiere_intersection};
pub use objet::{ObjetGeo, ObjetRay};
pub use plan::{PlanGeo, PlanRay};
pub use rayon::Rayon;
pub use reel::Reel;
pub use rotation::Rotation;
pub use sphere::{SphereGeo, SphereRay};
pub use texture::Texture;
pub use vecteur::Vecteur;
