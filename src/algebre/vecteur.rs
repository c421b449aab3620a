//! Vectors of space (handout §4.1 and annex A).

use core::borrow::Borrow;
use core::iter::Sum;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use crate::Nombre;
use crate::algebre::nombre::{puissance_de_deux, selon, simple};

/// A vector, or a point seen from the origin O: x to the right, y up, z towards the viewer (handout
/// §2.1).
///
/// It is a bare triple: any number may stand in it, and what is built on it (a ray, an object)
/// checks. In generic code the compiler may ask for the type of an operand,
/// `let v: Vecteur<R> = …`, and `k * v` must be written `v * k`, since only `f32` and `f64`
/// themselves can stand on the left.
///
/// ```
/// use lancer_rayon::Vecteur;
///
/// let v = Vecteur::new(1.0, 2.0, 2.0);
/// assert_eq!(v.longueur(), 3.0);
/// assert_eq!(v.produit_scalaire(Vecteur::new(0.0, 0.5, 0.0)), 1.0);
/// assert_eq!(v.longueur_carree(), 9.0);
/// assert_eq!((v - v) * 2.0 + v / 1.0, v);
/// assert_eq!((-v + v, 2.0 * v), (Vecteur::NUL, v + v));
/// assert_eq!([v, v, -v].iter().sum::<Vecteur>(), v);
///
/// assert_eq!(Vecteur::from([1.0, 2.0, 2.0]), v);
/// let [x, y, z]: [f64; 3] = v.into();
/// assert_eq!((x, y, z), v.into());
/// assert_eq!(Vecteur::from((x, y, z)), Vecteur::X * x + Vecteur::Y * y + Vecteur::Z * z);
/// ```
#[doc(alias("vector", "point"))]
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(from = "[R; 3]", into = "[R; 3]"))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "R: Nombre + serde::Serialize")))]
#[must_use]
pub struct Vecteur<R = f64> {
    /// The coordinate to the right.
    pub x: R,
    /// The coordinate up.
    pub y: R,
    /// The coordinate towards the viewer.
    pub z: R,
}

impl<R: Nombre> Vecteur<R> {
    /// (0, 0, 0): the origin O.
    #[doc(alias = "zero")]
    pub const NUL: Self = Self::new(R::ZERO, R::ZERO, R::ZERO);

    /// (1, 0, 0): to the right.
    #[doc(alias("x_axis", "unit_x"))]
    pub const X: Self = Self::new(R::UN, R::ZERO, R::ZERO);

    /// (0, 1, 0): up.
    #[doc(alias("y_axis", "unit_y", "up"))]
    pub const Y: Self = Self::new(R::ZERO, R::UN, R::ZERO);

    /// (0, 0, 1): towards the viewer.
    #[doc(alias("z_axis", "unit_z"))]
    pub const Z: Self = Self::new(R::ZERO, R::ZERO, R::UN);

    /// The vector of these three coordinates.
    #[inline(always)]
    pub const fn new(x: R, y: R, z: R) -> Self {
        Self { x, y, z }
    }

    /// The scalar product V·V′ (handout, annex A).
    #[doc(alias = "dot")]
    #[inline(always)]
    #[must_use]
    pub fn produit_scalaire(self, autre: Self) -> R {
        self.x * autre.x + self.y * autre.y + self.z * autre.z
    }

    /// V·V, the square of the length.
    #[doc(alias("length_squared", "norm_squared"))]
    #[inline(always)]
    #[must_use]
    pub fn longueur_carree(self) -> R {
        self.produit_scalaire(self)
    }

    /// The length ‖V‖ (handout, annex A), even where its square would leave the range of the type.
    #[doc(alias("length", "norm"))]
    #[inline]
    #[must_use]
    pub fn longueur(self) -> R {
        let (v, echelle) = self.mis_a_l_echelle();
        v.longueur_carree().racine() / echelle
    }

    /// The unit vector of the same direction, to 3.6u; `None` for a vector that is zero or not
    /// finite.
    ///
    /// ```
    /// # use lancer_rayon::Vecteur;
    /// assert_eq!(Vecteur::new(0.0, 1e300, 0.0).unitaire(), Some(Vecteur::new(0.0, 1.0, 0.0)));
    /// assert_eq!(Vecteur::<f64>::NUL.unitaire(), None);
    /// ```
    #[doc(alias("normalize", "unit"))]
    #[inline]
    #[must_use]
    pub fn unitaire(self) -> Option<Self> {
        self.longueur_et_unitaire().map(|(_, unitaire)| unitaire)
    }

    /// The length and the unit vector of the same direction, with one root.
    #[inline]
    pub(crate) fn longueur_et_unitaire(self) -> Option<(R, Self)> {
        // Lengths of ordinary size stand apart. Scaled by 1 they would give the same bits, but take
        // up to twice as long (measured).
        let carre = self.longueur_carree();
        if carre >= petite() && carre < R::INFINI {
            let longueur = carre.racine();
            return Some((longueur, self / longueur));
        }
        let (a_l_echelle, longueur, unitaire) = self.longueurs_et_unitaire();
        (a_l_echelle > R::ZERO && a_l_echelle < R::INFINI).then_some((longueur, unitaire))
    }

    /// The length, first of the scaled vector, and the unit vector, without a branch: the unit
    /// vector is NaN if the scaled length is 0 or not finite.
    #[inline(always)]
    pub(crate) fn longueurs_et_unitaire(self) -> (R, R, Self) {
        let (v, echelle) = self.mis_a_l_echelle();
        let longueur = v.longueur_carree().racine();
        (longueur, longueur / echelle, v / longueur)
    }

    /// The vector multiplied by a power of two, and that power. It is 1 for lengths of ordinary
    /// size; others are scaled so that the square of the length neither overflows nor loses bits.
    #[inline(always)]
    fn mis_a_l_echelle(self) -> (Self, R) {
        let carre = self.longueur_carree();
        let echelle = if carre == R::INFINI {
            petite()
        } else if carre < petite() {
            R::UN / petite()
        } else {
            R::UN
        };
        (self * echelle, echelle)
    }

    /// The vector product V ∧ V′: at a right angle to both, and x ∧ y = z.
    ///
    /// ```
    /// # use lancer_rayon::Vecteur;
    /// assert_eq!(Vecteur::<f64>::X.produit_vectoriel(Vecteur::Y), Vecteur::Z);
    /// ```
    #[doc(alias("cross", "cross_product"))]
    #[inline(always)]
    pub fn produit_vectoriel(self, autre: Self) -> Self {
        Self::new(
            self.y * autre.z - self.z * autre.y,
            self.z * autre.x - self.x * autre.z,
            self.x * autre.y - self.y * autre.x,
        )
    }

    /// Σ|V_i·V′_i|. The rounding error of the scalar product is at most 3u times this, to first
    /// order.
    #[inline(always)]
    pub(crate) fn somme_des_grandeurs(self, autre: Self) -> R {
        (self.x * autre.x).absolu() + (self.y * autre.y).absolu() + (self.z * autre.z).absolu()
    }

    /// |x| + |y| + |z|, no less than the length.
    #[inline(always)]
    pub(crate) fn norme_1(self) -> R {
        self.x.absolu() + self.y.absolu() + self.z.absolu()
    }

    /// The same vector in `f64`, exactly.
    ///
    /// ```
    /// # use lancer_rayon::Vecteur;
    /// let v = Vecteur::<f32>::depuis_f64(Vecteur::new(0.1, 0.25, 3.0));
    /// assert_eq!(v, Vecteur::new(0.1_f32, 0.25, 3.0));
    /// assert_eq!(v.vers_f64(), Vecteur::new(0.1_f32.into(), 0.25, 3.0));
    /// ```
    #[doc(alias = "as_dvec3")]
    #[inline(always)]
    pub fn vers_f64(self) -> Vecteur<f64> {
        Vecteur::new(self.x.vers_f64(), self.y.vers_f64(), self.z.vers_f64())
    }

    /// The nearest vector in `f32`: each coordinate rounded.
    #[doc(alias("to_f32", "narrow"))]
    #[inline(always)]
    pub fn vers_f32(self) -> Vecteur<f32> {
        Vecteur::new(simple(self.x), simple(self.y), simple(self.z))
    }

    /// The nearest vector of this type to one in `f64`: each coordinate rounded.
    #[doc(alias("from_f64", "cast"))]
    #[inline(always)]
    pub fn depuis_f64(v: Vecteur<f64>) -> Self {
        Self::new(R::depuis_f64(v.x), R::depuis_f64(v.y), R::depuis_f64(v.z))
    }
}

/// A power of two: in a sum above it, a square that loses bits weighs nothing. Divided by it the
/// smallest length, 2⁻¹⁴⁹ or 2⁻¹⁰⁷⁴, is 2⁻⁴⁹ or 2⁻⁴⁷⁴; multiplied by it the largest is 2²⁸ or 2⁴²⁴.
#[inline(always)]
fn petite<R: Nombre>() -> R {
    R::depuis_f64(selon::<R, _>(puissance_de_deux(-100), puissance_de_deux(-600)))
}

/// Converts between a vector and another type of three coordinates, by the expression that takes
/// that type apart and makes it.
macro_rules! trois_coordonnees {
    (|$x:ident, $y:ident, $z:ident| $($(#[$doc:meta])* $type:ty => { $($forme:tt)+ })+) => {$(
        $(#[$doc])*
        impl<R> From<$type> for Vecteur<R> {
            #[inline(always)]
            fn from($($forme)+: $type) -> Self {
                Self { x: $x, y: $y, z: $z }
            }
        }

        $(#[$doc])*
        impl<R> From<Vecteur<R>> for $type {
            #[inline(always)]
            fn from(Vecteur { x: $x, y: $y, z: $z }: Vecteur<R>) -> Self {
                $($forme)+
            }
        }
    )+};
}
#[cfg(feature = "mint")]
pub(crate) use trois_coordonnees;

trois_coordonnees! { |x, y, z|
    [R; 3] => { [x, y, z] }
    (R, R, R) => { (x, y, z) }
}

/// Operators between two vectors, or a vector and a number, and those that assign: `+` with `+=`.
macro_rules! operateurs {
    ($($binaire:ident::$f:ident, $affectation:ident::$g:ident,
       |$v:ident, $autre:ident: $type:ty| $resultat:expr;)*) => {$(
        impl<R: Nombre> $binaire<$type> for Vecteur<R> {
            type Output = Self;
            #[inline(always)]
            fn $f(self, $autre: $type) -> Self {
                let $v = self;
                $resultat
            }
        }

        impl<R: Nombre> $affectation<$type> for Vecteur<R> {
            #[inline(always)]
            fn $g(&mut self, autre: $type) {
                *self = self.$f(autre);
            }
        }
    )*};
}

operateurs! {
    Add::add, AddAssign::add_assign, |v, w: Self| Self::new(v.x + w.x, v.y + w.y, v.z + w.z);
    Sub::sub, SubAssign::sub_assign, |v, w: Self| Self::new(v.x - w.x, v.y - w.y, v.z - w.z);
    Mul::mul, MulAssign::mul_assign, |v, k: R| Self::new(v.x * k, v.y * k, v.z * k);
    Div::div, DivAssign::div_assign, |v, k: R| Self::new(v.x / k, v.y / k, v.z / k);
}

/// k·V, as V·k.
macro_rules! nombre_fois_vecteur {
    ($($reel:ident)*) => {$(
        impl Mul<Vecteur<$reel>> for $reel {
            type Output = Vecteur<$reel>;
            #[inline(always)]
            fn mul(self, v: Vecteur<$reel>) -> Vecteur<$reel> {
                v * self
            }
        }
    )*};
}

nombre_fois_vecteur! { f32 f64 }

impl<R: Nombre> Neg for Vecteur<R> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

/// The sum of vectors, or of references to them.
impl<R: Nombre, V: Borrow<Self>> Sum<V> for Vecteur<R> {
    fn sum<I: Iterator<Item = V>>(vecteurs: I) -> Self {
        vecteurs.fold(Self::NUL, |somme, v| somme + *v.borrow())
    }
}
