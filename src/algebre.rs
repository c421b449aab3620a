//! What is computed with: the scalar, vectors, rotations, numbers of twice the length, and the
//! checks by which a value is refused.

pub(crate) mod double;
#[cfg(feature = "mint")]
mod echange;
pub(crate) mod nombre;
pub(crate) mod refus;
pub(crate) mod rotation;
pub(crate) mod vecteur;
