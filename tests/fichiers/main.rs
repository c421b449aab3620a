//! What is read and written: scene files, single values, pictures, pages.
#![allow(clippy::duplicate_mod, reason = "the renderer has its own copy of the scene language")]

#[path = "../commun/mod.rs"]
mod commun;
#[allow(dead_code, reason = "shared with the examples")]
#[path = "../../docs/exemples/scene.rs"]
mod scene;

#[allow(dead_code, reason = "shared with the examples")]
#[path = "../../docs/exemples/surete.rs"]
mod surete;

mod chiffres;
mod figures;
mod lexique;
mod pixels;
mod rendu;
mod scenes;
mod serde;
