//! Sixteen rays, coordinate by coordinate.

use crate::rayon::Rayon;
use crate::reel::Reel;
use crate::vecteur::Vecteur;

/// Lanes: rays side by side. The compiler would unroll loops of eight before it could vectorise them.
pub(crate) const VOIES: usize = 16;

/// A value at the start of a cache line: a column that lies across two takes longer to write and to read
/// back (`docs/performance.md`, "Thresholds").
#[repr(align(64))]
pub(crate) struct Aligne<T>(pub(crate) T);

/// A number for each of sixteen rays.
pub(crate) type Voies<R> = [R; VOIES];

/// The sources S and the directions D of sixteen rays.
pub(crate) struct Colonnes<R> {
    s: [Voies<R>; 3],
    d: [Voies<R>; 3],
}

impl<R: Reel> Colonnes<R> {
    pub(crate) const VIDES: Self = Self { s: [[R::ZERO; VOIES]; 3], d: [[R::ZERO; VOIES]; 3] };

    /// Puts these rays here, at most sixteen; the last stands in for those that are missing.
    #[inline(always)]
    pub(crate) fn charger(&mut self, rayons: &[Rayon<R>]) {
        if let Some(rayons) = rayons.first_chunk() {
            self.copier(rayons);
        } else if let Some(dernier) = rayons.last() {
            let mut complets = [*dernier; VOIES];
            complets[..rayons.len()].copy_from_slice(rayons);
            self.copier(&complets);
        }
    }

    #[inline(always)]
    fn copier(&mut self, rayons: &[Rayon<R>; VOIES]) {
        for (voie, rayon) in rayons.iter().enumerate() {
            let (s, d) = (rayon.source(), rayon.direction());
            [self.s[0][voie], self.s[1][voie], self.s[2][voie]] = s.into();
            [self.d[0][voie], self.d[1][voie], self.d[2][voie]] = d.into();
        }
    }

    /// S and D of one ray.
    #[inline(always)]
    pub(crate) fn rayon(&self, voie: usize) -> (Vecteur<R>, Vecteur<R>) {
        let ([sx, sy, sz], [dx, dy, dz]) = (&self.s, &self.d);
        let s = Vecteur::new(sx[voie], sy[voie], sz[voie]);
        (s, Vecteur::new(dx[voie], dy[voie], dz[voie]))
    }
}

/// The larger of two numbers; b if one of them is a NaN.
#[inline(always)]
pub(crate) fn max<R: Reel>(a: R, b: R) -> R {
    if a > b { a } else { b }
}

/// The smaller of two numbers; b if one of them is a NaN.
#[inline(always)]
pub(crate) fn min<R: Reel>(a: R, b: R) -> R {
    if a < b { a } else { b }
}

/// The members of a set of sixteen, which has a bit for each, the least first.
#[inline(always)]
pub(crate) fn membres(mut ensemble: u32) -> impl Iterator<Item = usize> {
    core::iter::from_fn(move || {
        let membre = (ensemble != 0).then(|| le_premier(ensemble));
        ensemble &= ensemble.wrapping_sub(1);
        membre
    })
}

/// The least member of such a set.
#[inline(always)]
pub(crate) fn le_premier(ensemble: u32) -> usize {
    ensemble.trailing_zeros() as usize % VOIES
}

/// The largest of sixteen numbers.
#[inline(always)]
pub(crate) fn le_plus_grand<R: Reel>(mut x: [R; VOIES]) -> R {
    let mut moitie = VOIES / 2;
    while moitie > 0 {
        for i in 0..moitie {
            x[i] = max(x[i], x[i + moitie]);
        }
        moitie /= 2;
    }
    x[0]
}
