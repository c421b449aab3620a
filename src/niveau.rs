//! The instruction set, chosen at run time.

use fearless_simd::Level;

/// The widest instructions of this machine.
#[inline]
pub(crate) fn meilleur_niveau() -> Level {
    Level::try_detect().unwrap_or(Level::baseline())
}

/// `selon_le_niveau!(niveau, simd => expression)`: the expression, compiled for each instruction
/// set, of which `simd` is a token; the level chooses.
///
/// It is `dispatch!` of `fearless_simd`, except on x86: without SSE4.2, which gains some 5 % over
/// SSE2 and would add a third to what is compiled; and SSE2, which a function of the baseline could
/// inline, stands in one of its own, so that nobody else pays for its frame.
macro_rules! selon_le_niveau {
    ($niveau:expr, $simd:ident => $expression:expr) => {{
        #[cfg(all(any(target_arch = "x86", target_arch = "x86_64"), target_feature = "sse2"))]
        {
            use fearless_simd::{Level, Simd};
            let niveau: Level = $niveau;
            if let Some($simd) = niveau.as_avx512() {
                $simd.vectorize(
                    #[inline(always)]
                    || $expression,
                )
            } else if let Some($simd) = niveau.as_avx2() {
                $simd.vectorize(
                    #[inline(always)]
                    || $expression,
                )
            } else if let Some($simd) = Level::baseline().as_sse2() {
                $crate::niveau::a_part(
                    #[inline(always)]
                    || $expression,
                )
            } else {
                unreachable!()
            }
        }
        #[cfg(not(all(any(target_arch = "x86", target_arch = "x86_64"), target_feature = "sse2")))]
        fearless_simd::dispatch!($niveau, $simd => $expression)
    }};
}
pub(crate) use selon_le_niveau;

/// Calls a function that is not inlined.
#[cfg(all(any(target_arch = "x86", target_arch = "x86_64"), target_feature = "sse2"))]
#[inline(never)]
pub(crate) fn a_part<T>(f: impl FnOnce() -> T) -> T {
    f()
}
