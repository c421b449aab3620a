//! Sixteen numbers side by side: of the rays of a group, of the balls of a row, of the children of
//! a node.

use fearless_simd::prelude::*;
use fearless_simd::{f32x16, u32x16};

/// How many. The compiler would unroll loops of eight before it could vectorise them.
pub(crate) const SEIZE: usize = 16;

/// A number for each of sixteen.
pub(crate) type Colonne<R> = [R; SEIZE];

/// A value at the start of a cache line: a column that lies across two takes longer to write and to
/// read back (`docs/performance.md`, "Thresholds").
#[repr(align(64))]
pub(crate) struct Aligne<T>(pub(crate) T);

/// Some of sixteen, a bit for each; as an iterator, the least first.
#[derive(Clone)]
pub(crate) struct Membres(u32);

impl Membres {
    /// None.
    pub(crate) const AUCUN: Self = Self(0);

    #[inline(always)]
    pub(crate) fn ajouter_si(&mut self, i: usize, est_membre: bool) {
        self.0 |= u32::from(est_membre) << i;
    }

    /// Takes out the one whose number is the least.
    #[inline(always)]
    pub(crate) fn prendre_le_moindre(&mut self, nombres: &Colonne<f32>) -> Option<usize> {
        let mut membres = self.clone();
        let mut moindre = membres.next()?;
        for membre in membres {
            if nombres[membre] < nombres[moindre] {
                moindre = membre;
            }
        }
        self.0 &= !(1 << moindre);
        Some(moindre)
    }

    #[inline(always)]
    pub(crate) fn nombre(&self) -> u32 {
        self.0.count_ones()
    }

    /// Those that are in both.
    #[inline(always)]
    pub(crate) fn et(&self, autres: &Self) -> Self {
        Self(self.0 & autres.0)
    }

    /// Those that are not among the others.
    #[inline(always)]
    pub(crate) fn sans(&self, autres: &Self) -> Self {
        Self(self.0 & !autres.0)
    }
}

impl Iterator for Membres {
    type Item = usize;

    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        let membre = self.0.trailing_zeros() as usize;
        self.0 &= self.0.wrapping_sub(1);
        (membre < SEIZE).then_some(membre)
    }
}

/// Those i with `a[i] <= b[i]`: the one step that the compiler does not vectorise by itself.
#[inline(always)]
pub(crate) fn au_plus<S: Simd>(simd: S, a: &Colonne<f32>, b: &Colonne<f32>) -> Membres {
    let (a, b) = (f32x16::simd_from(simd, *a), f32x16::simd_from(simd, *b));
    Membres(a.simd_le(b).to_bitmask() as u32)
}

/// Those i where `a[i]` has the bits of `b`.
#[inline(always)]
pub(crate) fn egaux<S: Simd>(simd: S, a: &Colonne<f32>, b: f32) -> Membres {
    let (a, b) = (a.map(f32::to_bits), [b.to_bits(); SEIZE]);
    let (a, b) = (u32x16::simd_from(simd, a), u32x16::simd_from(simd, b));
    Membres(a.simd_eq(b).to_bitmask() as u32)
}

/// The largest of sixteen numbers.
#[inline(always)]
pub(crate) fn le_plus_grand<R: Copy + PartialOrd>(mut x: Colonne<R>) -> R {
    let mut moitie = SEIZE / 2;
    while moitie > 0 {
        for i in 0..moitie {
            x[i] = if x[i] > x[i + moitie] { x[i] } else { x[i + moitie] };
        }
        moitie /= 2;
    }
    x[0]
}
