//! Many rays at once: a picture of 600 × 400 pixels is 240,000 of them.
//!
//! A **group** of 16 rays goes side by side through the formulae of a shape (`lot/groupe.rs`). A
//! **block** of 64 rays, a tile of 8 × 8 pixels, takes an object at a time (`lot/bloc.rs`): of a
//! list every object, of a tree those whose boxes its beam crosses (`lot/faisceau.rs`,
//! `arbre/parcours_de_bloc.rs`).

pub(crate) mod bloc;
pub(crate) mod groupe;
