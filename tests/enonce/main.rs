//! What the handout asks: formulae, conventions and manipulations.

mod chambre;
mod choix;
mod coins;
mod etendue;
mod fin;
mod jeu_de_tests;
mod lampe;
mod manipulations;
mod milieux;
mod motif;
mod origine;
mod particule;
mod passages;
mod rapports;
mod recettes;
mod rotation;
mod sol;
mod totalite;
mod vecteur;
mod verre;
mod visibilite;
