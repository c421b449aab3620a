//! What the handout asks: formulae, conventions and manipulations; and what the pages say of programs that ask it.

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
mod sans_allocation;
mod sol;
mod totalite;
mod vecteur;
mod verre;
mod visibilite;
