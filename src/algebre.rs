//! What is computed with: the scalar, vectors, rotations, numbers of twice the length, what
//! rounding may take, and the checks by which a value is refused.

pub(crate) mod arrondis;
pub(crate) mod double;
#[cfg(feature = "mint")]
mod echange;
pub(crate) mod nombre;
pub(crate) mod refus;
pub(crate) mod rotation;
pub(crate) mod vecteur;
