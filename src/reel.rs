//! The scalar of the crate: `f32` or `f64`, and nothing else.

use core::fmt::{Debug, Display};
use core::ops::{Add, Div, Mul, Neg, Sub};

mod scelle {
    /// What only this crate needs of a scalar; and what keeps [`Reel`](super::Reel) to the two
    /// types whose rounding the crate's bounds rest on.
    pub trait Scelle: Sized {
        /// Of two constants the one for this type.
        #[inline(always)]
        fn selon<T>(en_f32: T, en_f64: T) -> T {
            if size_of::<Self>() == size_of::<f32>() { en_f32 } else { en_f64 }
        }

        /// The answer to this question, compiled in this crate (`compile.rs`).
        fn demander<Q: super::Question>(de: Q::De<'_, Self>) -> Q::Reponse<'_, Self>
        where
            Self: super::Reel;
    }
}

use scelle::Scelle;

/// A question whose answer this crate compiles, once for each scalar, as
/// [`compilees!`](crate::compile::compilees) writes it. Generic code would be compiled again by
/// every crate that calls it.
pub trait Question {
    type De<'a, R: Reel>;
    type Reponse<'a, R: Reel>;
    fn en_f32(de: Self::De<'_, f32>) -> Self::Reponse<'_, f32>;
    fn en_f64(de: Self::De<'_, f64>) -> Self::Reponse<'_, f64>;
}

/// The scalar type: `f32` or `f64`. Sealed.
///
/// Every operation it offers is correctly rounded, so that a query gives the same bits on every
/// machine with IEEE arithmetic; the x87 of an i586 rounds differently. Fused multiply-add is
/// absent on purpose: not every machine has it.
///
/// ```
/// use lancer_rayon::{Reel, Vecteur};
///
/// /// In either type, and with its own rounding.
/// fn moyenne<R: Reel>(a: Vecteur<R>, b: Vecteur<R>) -> Vecteur<R> {
///     (a + b) / (R::UN + R::UN)
/// }
///
/// let milieu = moyenne(Vecteur::NUL, Vecteur::<f32>::new(1.0, 2.0, 3.0));
/// assert_eq!(milieu, Vecteur::new(0.5, 1.0, 1.5));
///
/// assert_eq!(f64::U, f64::EPSILON / 2.0);
/// assert_eq!(f64::LIMITE, 2.0_f64.powi(450));
/// assert_eq!(f64::MIN_POSITIF, 5e-324);
/// assert_eq!((f32::INFINI.vers_f64(), f32::depuis_f64(0.1)), (f64::INFINITY, 0.1));
/// assert_eq!((Reel::sqrt(9.0), Reel::abs(-3.0), f64::ZERO), (3.0, 3.0, 0.0));
/// ```
#[doc(alias("float", "scalar"))]
pub trait Reel:
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
    /// The smallest number above 0, a subnormal.
    #[doc(alias = "smallest")]
    const MIN_POSITIF: Self;
    /// u, the largest relative error of one rounding: 2⁻²⁴ or 2⁻⁵³.
    #[doc(alias = "unit_roundoff")]
    const U: Self;
    /// The largest coordinate, size or relative distance of a half-space, in scene units: 2⁶⁰ or
    /// 2⁴⁵⁰. The smallest size is 1/`LIMITE`. Within these limits no square overflows, and no
    /// square of a size loses bits.
    #[doc(alias = "limit")]
    const LIMITE: Self;

    /// Square root, correctly rounded.
    fn sqrt(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// The same number as an `f64`, exactly.
    #[doc(alias = "to_f64")]
    fn vers_f64(self) -> f64;
    /// The nearest number of this type.
    #[doc(alias = "from_f64")]
    fn depuis_f64(x: f64) -> Self;
}

/// `n` times u.
#[inline(always)]
pub(crate) fn fois_u<R: Reel>(n: f64) -> R {
    R::depuis_f64(n) * R::U
}

/// `n` times u of `f32`, in either type: enough for the numbers of an `f32` scene in `f64`, whose
/// directions and normals are unit to that only.
#[inline(always)]
pub(crate) fn fois_u_simple<R: Reel>(n: f64) -> R {
    R::depuis_f64(n * f64::from(f32::U))
}

/// The nearest number of `f32`; ±∞ beyond them all.
#[inline(always)]
pub(crate) fn simple<R: Reel>(x: R) -> f32 {
    x.vers_f64() as f32
}

/// 2^k, for a k between −1022 and 1023.
pub(crate) const fn puissance_de_deux(k: i32) -> f64 {
    f64::from_bits(((1023 + k) as u64) << 52)
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

/// What the two scalars say alike, for one with this limit, this root from `libm` and these answers
/// to a [`Question`].
macro_rules! reel {
    ($reel:ident, $limite:expr, $racine:path, $reponse:ident) => {
        impl Scelle for $reel {
            #[inline]
            fn demander<Q: Question>(de: Q::De<'_, Self>) -> Q::Reponse<'_, Self> {
                Q::$reponse(de)
            }
        }

        impl Reel for $reel {
            const ZERO: Self = 0.0;
            const UN: Self = 1.0;
            const INFINI: Self = Self::INFINITY;
            const MIN_POSITIF: Self = Self::from_bits(1);
            const U: Self = Self::EPSILON / 2.0;
            const LIMITE: Self = $limite;

            #[inline(always)]
            fn sqrt(self) -> Self {
                #[cfg(feature = "std")]
                return self.sqrt();
                #[cfg(not(feature = "std"))]
                return $racine(self);
            }

            #[inline(always)]
            fn abs(self) -> Self {
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

reel! { f32, puissance_de_deux(60) as f32, libm::sqrtf, en_f32 }
reel! { f64, puissance_de_deux(450), libm::sqrt, en_f64 }
