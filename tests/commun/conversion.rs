//! Between the type of a scene, f64 and bits.

use lancer_rayon::{Reel, Vecteur};

/// The same vector in f64, exactly.
pub(crate) fn large<R: Reel>(v: Vecteur<R>) -> Vecteur {
    v.vers_f64()
}

/// The nearest vector of a type.
pub(crate) fn arrondi<R: Reel>(v: Vecteur) -> Vecteur<R> {
    Vecteur::depuis_f64(v)
}

/// A scalar seen as its bits.
pub(crate) trait Bits: Reel {
    fn depuis_bits(bits: u64) -> Self;
    fn bits(self) -> u64;
}

impl Bits for f32 {
    fn depuis_bits(bits: u64) -> Self {
        // The upper half carries the exponent that the strategies choose.
        Self::from_bits((bits >> 32) as u32)
    }
    fn bits(self) -> u64 {
        u64::from(self.to_bits())
    }
}

impl Bits for f64 {
    fn depuis_bits(bits: u64) -> Self {
        Self::from_bits(bits)
    }
    fn bits(self) -> u64 {
        self.to_bits()
    }
}
