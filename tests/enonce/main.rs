//! What the handout asks: its formulae, conventions and manipulations, list by list.

mod chambre;
mod choix;
mod etendue;
mod fin;
mod jeu_de_tests;
mod lampe;
mod manipulations;
mod milieux;
mod motif;
mod origine;
mod passages;
mod rapports;
mod recettes;
mod rotation;
mod sol;
mod totalite;
mod vecteur;
mod verre;
mod visibilite;
