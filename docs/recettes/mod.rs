//! The programs of the recipes of `docs/guide.md` and `docs/vitesse.md`. Each stands alone. `tests/enonce` runs them,
//! most against a closed form, and `tests/fichiers/programmes.rs` checks that the pages show what is in these files.

pub mod animation;
pub mod atlas;
pub mod au_loin;
pub mod brume;
pub mod caches;
pub mod capteur;
pub mod cordes;
pub mod damier;
pub mod deux_mondes;
pub mod fils;
pub mod lentille;
pub mod milieux;
pub mod particule;
pub mod premier;
pub mod verre;
