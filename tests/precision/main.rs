//! What `docs/precision.md` promises, against an oracle in exact integers.

#[path = "../commun/mod.rs"]
mod commun;

mod adversaire;
mod conclusion;
mod constantes;
mod erreur;
mod intervalle;
mod invariances;
mod oracle;
mod promesses;
