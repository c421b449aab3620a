//! The arithmetic of the scalar, which is `f32` or `f64` and nothing else.

use core::fmt::{Debug, Display};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Keeps [`Nombre`] to the two types on whose rounding the crate's bounds rest. Tests implement it
/// for a scalar that records what is computed.
pub trait Scelle {}

/// The arithmetic of the scalar: what [`Reel`](crate::Reel) can compute. Sealed.
///
/// Every operation is correctly rounded, so that a query gives the same bits on every machine with
/// IEEE arithmetic; the x87 of an i586 rounds differently. Fused multiply-add is absent on purpose:
/// not every machine has it.
///
/// ```
/// use lancer_rayon::Nombre;
///
/// assert_eq!(f64::U, f64::EPSILON / 2.0);
/// assert_eq!(f64::LIMITE, 2.0_f64.powi(450));
/// assert_eq!(f64::ETA, 5e-324);
/// assert_eq!((f32::INFINI.vers_f64(), f32::depuis_f64(0.1)), (f64::INFINITY, 0.1));
/// assert_eq!((9.0_f64.racine(), (-3.0_f64).absolu(), f64::ZERO), (3.0, 3.0, 0.0));
/// ```
#[doc(alias("float", "arithmetic"))]
pub trait Nombre:
    Scelle
    + Copy
    + Debug
    + Display
    + PartialOrd
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Send
    + Sync
    + 'static
{
    /// 0.
    const ZERO: Self;
    /// 1.
    #[doc(alias = "one")]
    const UN: Self;
    /// +∞, the distance of what is never touched.
    #[doc(alias = "infinity")]
    const INFINI: Self;
    /// η, the smallest number above 0, which is subnormal: 2⁻¹⁴⁹ or 2⁻¹⁰⁷⁴.
    #[doc(alias("smallest", "min_positive"))]
    const ETA: Self;
    /// u, the largest relative error of one rounding: 2⁻²⁴ or 2⁻⁵³.
    #[doc(alias = "unit_roundoff")]
    const U: Self;
    /// The largest coordinate, size or relative distance of a half-space, in scene units: 2⁶⁰ or
    /// 2⁴⁵⁰. The smallest size is 1/`LIMITE`. Within these limits no square overflows, and no
    /// square of a size loses bits.
    #[doc(alias = "limit")]
    const LIMITE: Self;

    /// Square root, correctly rounded.
    #[doc(alias = "sqrt")]
    fn racine(self) -> Self;
    /// Absolute value.
    #[doc(alias = "abs")]
    fn absolu(self) -> Self;
    /// The same number as an `f64`, exactly.
    #[doc(alias = "to_f64")]
    fn vers_f64(self) -> f64;
    /// The nearest number of this type.
    #[doc(alias = "from_f64")]
    fn depuis_f64(x: f64) -> Self;
}

/// The constant for this scalar, of one for `f32` and one for `f64`.
#[inline(always)]
pub(crate) fn selon<R: Nombre, T>(en_f32: T, en_f64: T) -> T {
    if size_of::<R>() == size_of::<f32>() { en_f32 } else { en_f64 }
}

/// n·u.
#[inline(always)]
pub(crate) fn fois_u<R: Nombre>(n: f64) -> R {
    R::depuis_f64(n) * R::U
}

/// n·u of `f32`, in either type: enough for the numbers of an `f32` scene in `f64`, whose
/// directions and normals are only unit to that.
#[inline(always)]
pub(crate) fn fois_u_simple<R: Nombre>(n: f64) -> R {
    R::depuis_f64(n * f64::from(f32::U))
}

/// The nearest `f32`, which is ±∞ beyond the largest.
#[inline(always)]
pub(crate) fn simple<R: Nombre>(x: R) -> f32 {
    x.vers_f64() as f32
}

/// 2^k, for a k between −1022 and 1023.
pub(crate) const fn puissance_de_deux(k: i32) -> f64 {
    f64::from_bits(((1023 + k) as u64) << 52)
}

/// A length added to every margin, in `f32` and in `f64`. It is more than is lost below the normal
/// numbers (lemma 8). It also keeps margins out of the subnormal numbers, with which processors
/// compute up to a hundred times as slowly. The start of a ray over a floor through O is then no
/// subnormal either, unless the normal of the floor has a coordinate that is nearly 0, below 2⁻²⁶
/// (`f64`: 2⁻¹²²), as rounding leaves one where a rotation by π should give 0.
pub const PLANCHER: (f64, f64) = (puissance_de_deux(-100), puissance_de_deux(-900));

/// [`PLANCHER`] of this type.
#[inline(always)]
pub(crate) fn plancher<R: Nombre>() -> R {
    R::depuis_f64(selon::<R, _>(PLANCHER.0, PLANCHER.1))
}

/// Whether this scalar is `f64`.
#[inline(always)]
pub(crate) fn est_double<R: Nombre>() -> bool {
    selon::<R, _>(false, true)
}

/// The larger of two numbers; b if one of them is a NaN.
#[inline(always)]
pub(crate) fn max<R: Nombre>(a: R, b: R) -> R {
    if a > b { a } else { b }
}

/// The smaller of two numbers; b if one of them is a NaN.
#[inline(always)]
pub(crate) fn min<R: Nombre>(a: R, b: R) -> R {
    if a < b { a } else { b }
}

/// Implements [`Nombre`] for a scalar with this limit and this root from `libm`.
macro_rules! nombre {
    ($nombre:ident, $limite:expr, $racine:path) => {
        impl Scelle for $nombre {}

        impl Nombre for $nombre {
            const ZERO: Self = 0.0;
            const UN: Self = 1.0;
            const INFINI: Self = Self::INFINITY;
            const ETA: Self = Self::from_bits(1);
            const U: Self = Self::EPSILON / 2.0;
            const LIMITE: Self = $limite;

            #[inline(always)]
            fn racine(self) -> Self {
                #[cfg(feature = "std")]
                return self.sqrt();
                #[cfg(not(feature = "std"))]
                return $racine(self);
            }

            #[inline(always)]
            fn absolu(self) -> Self {
                self.abs()
            }

            #[inline(always)]
            fn vers_f64(self) -> f64 {
                self.into()
            }

            #[inline(always)]
            fn depuis_f64(x: f64) -> Self {
                x as Self
            }
        }
    };
}

nombre! { f32, puissance_de_deux(60) as f32, libm::sqrtf }
nombre! { f64, puissance_de_deux(450), libm::sqrt }
