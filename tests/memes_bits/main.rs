//! The same bits from every way to an answer: alone, in a batch, in a tree, with every instruction set.

mod arbre;
mod bits;
mod eclairement;
mod lot;
mod sonde;
mod souspassement;
mod travail;
