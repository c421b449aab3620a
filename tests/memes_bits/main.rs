//! The same bits from every way to an answer: alone, in a batch, in a hierarchy, with every instruction set.

mod bits;
mod deux;
mod hierarchie;
mod lot;
mod sonde;
mod souspassement;
mod travail;
