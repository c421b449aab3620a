//! Numbers of twice the length of an `f64`, each with a bound on its own error
//! (`docs/preuves/objets.md`, lemma 16).

use crate::algebre::arrondis::{BORNE_DOUBLE, PERTE_DOUBLE, PRODUIT_DOUBLE};
use crate::algebre::nombre::{max, min};
use crate::{Nombre, Vecteur};

/// `haut` + `bas`, no farther than `erreur` from the number that it stands for; |bas| ≤ u·|haut|.
#[derive(Debug, Clone, Copy)]
pub struct Double {
    /// The number rounded to `f64`.
    pub haut: f64,
    /// What the rounding leaves over.
    pub bas: f64,
    /// The bound on the error.
    pub erreur: f64,
}

/// s + r = x + y exactly, with s their sum as computed.
fn somme(x: f64, y: f64) -> (f64, f64) {
    let s = x + y;
    let de_y = s - x;
    (s, (x - (s - de_y)) + (y - de_y))
}

impl Double {
    /// This number, exactly.
    pub fn de(x: f64) -> Self {
        Self { haut: x, bas: 0.0, erreur: 0.0 }
    }

    /// A result and its bound, both as computed.
    fn arrondi(haut: f64, bas: f64, erreur: f64) -> Self {
        let (haut, bas) = somme(haut, bas);
        Self { haut, bas, erreur: erreur * (1.0 + BORNE_DOUBLE * f64::U) }
    }

    /// The sum.
    pub fn plus(self, autre: Self) -> Self {
        let (s, r) = somme(self.haut, autre.haut);
        let m = self.bas + autre.bas;
        let n = r + m;
        Self::arrondi(s, n, self.erreur + autre.erreur + (m.abs() + n.abs()) * f64::U)
    }

    /// −x.
    pub(crate) fn oppose(self) -> Self {
        Self { haut: -self.haut, bas: -self.bas, ..self }
    }

    /// The product.
    pub fn fois(self, autre: Self) -> Self {
        let p = self.haut * autre.haut;
        // `libm` computes it without `std` too, and where the machine has no such instruction.
        let r = libm::fma(self.haut, autre.haut, -p);
        let n = r + (self.haut * autre.bas + self.bas * autre.haut);
        let (x, y) = (self.haut.abs(), autre.haut.abs());
        let erreur = x * autre.erreur + y * self.erreur + self.erreur * autre.erreur;
        // What is exact stays so: a ray may be parallel to a face, or start in its plane.
        let (exact, autre_exact) = (self.est_un_f64(), autre.est_un_f64());
        let nul = (exact && x == 0.0) || (autre_exact && y == 0.0);
        if nul || (exact && autre_exact && r == 0.0 && p.abs() > 1e-270) {
            return Self::de(p);
        }
        let arrondi = PRODUIT_DOUBLE * f64::U * f64::U * p.abs();
        Self::arrondi(p, n, erreur + arrondi + PERTE_DOUBLE * f64::ETA)
    }

    /// Whether the number is exactly `haut`.
    fn est_un_f64(self) -> bool {
        self.erreur == 0.0 && self.bas == 0.0
    }

    /// The interval in which the number lies, rounded outward; only itself if it is an `f64`
    /// exactly, and all numbers where an overflow left none.
    pub fn bornes(self) -> Intervalle {
        if self.est_un_f64() && self.haut.abs() < f64::INFINI {
            return Intervalle::de(self.haut);
        }
        let (bas, haut) =
            ((self.bas - self.erreur).next_down(), (self.bas + self.erreur).next_up());
        let (bas, haut) = ((self.haut + bas).next_down(), (self.haut + haut).next_up());
        // An unordered bound is no bound.
        Intervalle {
            bas: if bas < f64::INFINI { bas } else { -f64::INFINI },
            haut: if haut > -f64::INFINI { haut } else { f64::INFINI },
        }
    }
}

/// All numbers from one bound to another.
#[derive(Debug, Clone, Copy)]
pub struct Intervalle {
    /// The lower bound.
    pub bas: f64,
    /// The upper bound.
    pub haut: f64,
}

impl Intervalle {
    /// This number alone.
    pub(crate) const fn de(x: f64) -> Self {
        Self { bas: x, haut: x }
    }

    /// All numbers within `ecart` of this one.
    #[inline(always)]
    pub(crate) fn autour(x: f64, ecart: f64) -> Self {
        Self { bas: x - ecart, haut: x + ecart }
    }

    /// Their opposites.
    #[inline(always)]
    pub(crate) fn oppose(self) -> Self {
        Self { bas: -self.haut, haut: -self.bas }
    }

    /// The largest of their absolute values.
    #[inline(always)]
    pub(crate) fn grandeur(self) -> f64 {
        max(self.haut.abs(), self.bas.abs())
    }

    /// The lesser of two numbers, one from each interval.
    #[inline(always)]
    pub(crate) fn moindre(self, autre: Self) -> Self {
        Self { bas: min(self.bas, autre.bas), haut: min(self.haut, autre.haut) }
    }

    /// The greater of two numbers, one from each interval.
    #[inline(always)]
    pub(crate) fn plus_grand(self, autre: Self) -> Self {
        Self { bas: max(self.bas, autre.bas), haut: max(self.haut, autre.haut) }
    }

    /// The bounds of these numbers over numbers above 0, rounded.
    #[inline(always)]
    pub(crate) fn sur(self, autre: Self) -> Self {
        let de_bas = if self.bas > 0.0 { autre.haut } else { autre.bas };
        let de_haut = if self.haut > 0.0 { autre.bas } else { autre.haut };
        Self { bas: self.bas / de_bas, haut: self.haut / de_haut }
    }
}

/// A vector of doubled numbers.
pub(crate) type Triple = [Double; 3];

pub(crate) fn triple(v: Vecteur) -> Triple {
    <[f64; 3]>::from(v).map(Double::de)
}

pub(crate) fn scalaire([a, b, c]: Triple, [x, y, z]: Triple) -> Double {
    a.fois(x).plus(b.fois(y)).plus(c.fois(z))
}
