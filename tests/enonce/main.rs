//! What the handout asks: its formulae, conventions and manipulations, list by list.

#[path = "../commun/mod.rs"]
mod commun;
#[allow(dead_code, reason = "shared with the examples")]
#[path = "../../docs/exemples/scene.rs"]
mod scene;

mod differentiel;
mod eclairage;
mod etendue;
mod intersection;
mod jeu_de_tests;
mod lampe;
mod manipulations;
mod rotation;
mod totalite;
mod vecteur;
mod visibilite;
