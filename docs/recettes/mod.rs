//! The programs of the recipes of `docs/README.md` that are longer than a few lines. Each stands alone, and
//! `tests/enonce/recettes.rs` checks it against a closed form.

pub mod brume;
pub mod lentille;
pub mod milieux;
pub mod particule;
pub mod verre;
