//! A tree of bounding boxes over a list, with the answers of the list, to the bit.
//!
//! A leaf holds sixteen objects with a box, and a node of each floor above holds sixteen nodes
//! (`noeud.rs`, `construction.rs`). A ray looks at the nodes that it may enter (`parcours.rs`),
//! a block of rays at those that some ray of it may enter (`parcours_de_bloc.rs`), as their probe
//! tells (`sonde.rs`). Objects without a box are always asked. What may be left out is derived in
//! `docs/preuves/recherche.md`.

pub(crate) mod budget;
pub(crate) mod construction;
mod morceaux;
pub(crate) mod noeud;
mod parcours;
pub(crate) mod parcours_de_bloc;
mod pile;
pub(crate) mod repere;
pub(crate) mod sonde;
