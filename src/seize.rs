//! Sixteen numbers side by side: of the rays of a group, of the children of a node.

use fearless_simd::f32x16;
use fearless_simd::prelude::*;

/// How many. The compiler would unroll loops of eight before it could vectorise them.
pub(crate) const SEIZE: usize = 16;

/// A number for each of sixteen.
pub(crate) type Colonne<R> = [R; SEIZE];

/// A value at the start of a cache line: a column that lies across two takes longer to write and to
/// read back (`benches/README.md`, "Thresholds").
#[repr(align(64))]
pub(crate) struct Aligne<T>(pub(crate) T);

/// Some of sixteen, a bit for each.
pub(crate) type Membres = u32;

/// Takes out the first.
#[inline(always)]
pub(crate) fn prendre(membres: &mut Membres) -> Option<usize> {
    let premier = membres.trailing_zeros() as usize;
    *membres &= membres.wrapping_sub(1);
    (premier < SEIZE).then_some(premier)
}

/// Takes out the one whose number is the least.
#[inline(always)]
pub(crate) fn prendre_le_moindre(membres: &mut Membres, nombres: &Colonne<f32>) -> Option<usize> {
    let mut autres = *membres;
    let mut moindre = prendre(&mut autres)?;
    while let Some(membre) = prendre(&mut autres) {
        if nombres[membre] < nombres[moindre] {
            moindre = membre;
        }
    }
    *membres &= !(1 << moindre);
    Some(moindre)
}

/// Those i with `a[i] <= b[i]`. From a comparison to a mask the compiler does not vectorise by itself.
#[inline(always)]
pub(crate) fn au_plus<S: Simd>(simd: S, a: &Colonne<f32>, b: &Colonne<f32>) -> Membres {
    let (a, b) = (f32x16::simd_from(simd, *a), f32x16::simd_from(simd, *b));
    a.simd_le(b).to_bitmask() as u32
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
