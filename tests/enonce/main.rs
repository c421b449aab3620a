//! What the handout asks: its formulae, conventions and manipulations, list by list.

mod chambre;
mod choix;
mod differentiel;
mod eclairage;
mod etendue;
mod fin;
mod intersection;
mod jeu_de_tests;
mod lampe;
mod manipulations;
mod motif;
mod origine;
mod rapports;
mod recettes;
mod reflet;
mod rotation;
mod sol;
mod totalite;
mod vecteur;
mod verre;
mod visibilite;
