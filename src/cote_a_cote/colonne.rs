//! Sixteen numbers side by side: the lanes of a group of rays, the children of a node.

use fearless_simd::f32x16;
use fearless_simd::prelude::*;

/// How many numbers a column has. The compiler would unroll loops of eight before it could
/// vectorise them.
pub(crate) const LARGEUR: usize = 16;

/// Sixteen numbers side by side.
pub(crate) type Colonne<R> = [R; LARGEUR];

/// A column at the start of a cache line, since one across two lines takes longer to write and to
/// read back. A pattern that takes it apart would move it to an unaligned place of the stack.
#[repr(align(64))]
pub(crate) struct Alignee(pub(crate) Colonne<f32>);

/// A set of places of a column, one bit for each place.
pub(crate) type Membres = u32;

/// Takes out the first of these places.
#[inline(always)]
pub(crate) fn retirer(membres: &mut Membres) -> Option<usize> {
    let premier = membres.trailing_zeros() as usize;
    *membres &= membres.wrapping_sub(1);
    (premier < LARGEUR).then_some(premier)
}

/// Takes out the place whose number is the least.
#[inline(always)]
pub(crate) fn retirer_le_moindre(membres: &mut Membres, nombres: &Colonne<f32>) -> Option<usize> {
    let mut autres = *membres;
    let mut moindre = retirer(&mut autres)?;
    while let Some(membre) = retirer(&mut autres) {
        if nombres[membre] < nombres[moindre] {
            moindre = membre;
        }
    }
    *membres &= !(1 << moindre);
    Some(moindre)
}

/// The places whose number is at most this. The compiler does not vectorise the step from a comparison to
/// a mask by itself.
#[inline(always)]
pub(crate) fn au_plus<S: Simd>(simd: S, nombres: &Colonne<f32>, limite: f32) -> Membres {
    let nombres = f32x16::simd_from(simd, *nombres);
    nombres.simd_le(f32x16::splat(simd, limite)).to_bitmask() as u32
}

/// The largest of sixteen numbers.
#[inline(always)]
pub(crate) fn le_plus_grand<R: Copy + PartialOrd>(mut x: Colonne<R>) -> R {
    let mut moitie = LARGEUR / 2;
    while moitie > 0 {
        for i in 0..moitie {
            x[i] = if x[i] > x[i + moitie] { x[i] } else { x[i + moitie] };
        }
        moitie /= 2;
    }
    x[0]
}
