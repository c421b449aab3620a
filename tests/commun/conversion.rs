//! Between the type of a scene, f64 and bits.

use lancer_rayon::{Intersection, NoIntersection, Reel, Vecteur};

/// [`Vecteur::depuis_f64`], for which the tests ask on every other line.
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

/// Every bit of an answer; of a miss, bits that no hit has, which would be NaNs.
pub(crate) fn mots<R: Bits>(touche: &Result<Intersection<R>, NoIntersection>) -> [u64; 6] {
    let Ok(t) = touche else { return [u64::MAX; 6] };
    let [d, x, y, z, marge] =
        [t.distance, t.normale.x, t.normale.y, t.normale.z, t.marge()].map(R::bits);
    [d, x, y, z, marge, t.texture.0.into()]
}
