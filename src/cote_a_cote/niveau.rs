//! The instruction set, chosen at run time.

use fearless_simd::Level;

/// The widest instructions of this machine.
#[inline]
pub(crate) fn meilleur_niveau() -> Level {
    Level::try_detect().unwrap_or(Level::baseline())
}

/// Whether a call has a copy for AVX-512, or takes that for AVX2 there.
pub(crate) const AVEC_AVX_512: bool = true;
pub(crate) const SANS_AVX_512: bool = false;

/// `selon_le_niveau!(niveau, large, simd => appel)`: the call of a function that
/// [`vectorize`](fearless_simd::Simd::vectorize) compiles for the instruction set of the token
/// `simd`, once for all who call it; the level chooses the token. `large` says whether there is a
/// copy for AVX-512; without it such a machine takes that for AVX2.
///
/// It is `dispatch!` of `fearless_simd`, except on x86, in two points. SSE4.2 is left out, since it
/// gains some 5 % over SSE2 and would add a third to what is compiled. The call with SSE2 goes
/// through [`a_part`]: the caller, which is compiled for SSE2 itself, would otherwise inline it and
/// reserve stack for it, whichever arm is taken.
macro_rules! selon_le_niveau {
    ($niveau:expr, $large:expr, $simd:ident => $appel:expr) => {{
        #[cfg(all(any(target_arch = "x86", target_arch = "x86_64"), target_feature = "sse2"))]
        {
            use fearless_simd::Level;
            let niveau: Level = $niveau;
            if $large && let Some($simd) = niveau.as_avx512() {
                $appel
            } else if let Some($simd) = niveau.as_avx2() {
                $appel
            } else if let Some($simd) = Level::baseline().as_sse2() {
                $crate::cote_a_cote::niveau::a_part(
                    #[inline(always)]
                    move || $appel,
                )
            } else {
                unreachable!()
            }
        }
        #[cfg(not(all(any(target_arch = "x86", target_arch = "x86_64"), target_feature = "sse2")))]
        {
            let _: bool = $large;
            fearless_simd::dispatch!($niveau, $simd => $appel)
        }
    }};
}
pub(crate) use selon_le_niveau;

/// Calls a function that is not inlined.
#[cfg(all(any(target_arch = "x86", target_arch = "x86_64"), target_feature = "sse2"))]
#[inline(never)]
pub(crate) fn a_part<T>(f: impl FnOnce() -> T) -> T {
    f()
}
