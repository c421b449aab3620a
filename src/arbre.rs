//! A tree of bounding boxes over a list, with the answers of the list, to the bit.
//!
//! A leaf holds sixteen objects with a box, and a node of each floor above holds sixteen nodes
//! (`noeud.rs`, `construction.rs`). A walk goes through the nodes that a probe enters (`marche.rs`,
//! `sonde.rs`): that of a ray (`parcours.rs`), or of a block of rays (`parcours_de_bloc.rs`). Objects without a box are always asked. What may be left out is derived in
//! `docs/preuves/recherche.md`.

pub(crate) mod budget;
pub(crate) mod construction;
mod marche;
mod morceaux;
pub(crate) mod noeud;
mod parcours;
pub(crate) mod parcours_de_bloc;
pub(crate) mod repere;
pub(crate) mod sonde;
