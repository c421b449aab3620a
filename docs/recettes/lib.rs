//! What programs on lancer-rayon need again and again. `cargo add --path ../lancer-rayon/docs/recettes` adds it to one;
//! each file also stands alone, with `milieux` beside it if it is `particule` or `verre`. `docs/guide.md` says which
//! serves what need.
//!
//! Unlike the crate it may allocate.

#![allow(missing_docs, reason = "not published: what a name does not say has a comment")]

pub mod animation;
pub mod atlas;
pub mod au_loin;
pub mod caches;
pub mod capteur;
pub mod damier;
pub mod deux_mondes;
pub mod fils;
pub mod milieux;
pub mod particule;
pub mod premier;
pub mod verre;
