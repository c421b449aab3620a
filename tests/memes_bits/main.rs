//! The same bits from every way to an answer: alone, in a batch, in a hierarchy, with every instruction set.

#[path = "../commun/mod.rs"]
mod commun;
#[allow(dead_code, reason = "shared with the examples")]
#[path = "../../docs/exemples/scene.rs"]
mod scene;

mod bits;
mod deux;
mod hierarchie;
mod lot;
mod ombres;
mod souspassement;
