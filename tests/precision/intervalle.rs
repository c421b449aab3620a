//! Interval arithmetic in `f64`, rounded outward: what is proven of an interval is proven of each number in it.
//! A sum, product, quotient or root is exact to half a unit in the last place, so the next number beyond it is a bound.
//! (The well-kept crates for intervals set the rounding mode of one processor, or bind a C library.)

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};
use std::collections::BinaryHeap;

/// All numbers from `bas` to `haut`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Intervalle {
    pub(crate) bas: f64,
    pub(crate) haut: f64,
}

pub(crate) fn i(x: f64) -> Intervalle {
    x.into()
}

pub(crate) fn positif(x: Intervalle) -> Intervalle {
    x.max(i(0.0))
}

/// The sine for this cosine, or the cosine for this sine.
pub(crate) fn sinus(c: Intervalle) -> Intervalle {
    (positif(1.0 - c) * (1.0 + c)).racine()
}

/// From the first number to the second.
pub(crate) fn de_a(bas: f64, haut: f64) -> Intervalle {
    assert!(bas <= haut, "[{bas}, {haut}]");
    Intervalle { bas, haut }
}

impl From<f64> for Intervalle {
    fn from(x: f64) -> Self {
        de_a(x, x)
    }
}

impl Intervalle {
    fn autour(bas: f64, haut: f64) -> Self {
        de_a(bas.next_down(), haut.next_up())
    }

    pub(crate) fn racine(self) -> Self {
        let bas = if self.bas > 0.0 { self.bas.sqrt().next_down() } else { 0.0 };
        de_a(bas, self.haut.max(0.0).sqrt().next_up())
    }

    pub(crate) fn carre(self) -> Self {
        let grand = self.bas.abs().max(self.haut.abs());
        let petit = if self.bas <= 0.0 && self.haut >= 0.0 {
            0.0
        } else {
            self.bas.abs().min(self.haut.abs())
        };
        de_a((petit * petit).next_down().max(0.0), (grand * grand).next_up())
    }

    pub(crate) fn grandeur(self) -> Self {
        if self.bas >= 0.0 {
            self
        } else {
            let grand = self.haut.max(-self.bas);
            de_a(self.haut.min(0.0).abs(), grand)
        }
    }

    pub(crate) fn max(self, autre: Self) -> Self {
        de_a(self.bas.max(autre.bas), self.haut.max(autre.haut))
    }

    pub(crate) fn min(self, autre: Self) -> Self {
        de_a(self.bas.min(autre.bas), self.haut.min(autre.haut))
    }

    /// Two halves; where the interval reaches from 0 or over several orders of magnitude, halves by order of magnitude.
    pub(crate) fn parts(self) -> [Self; 2] {
        let Self { bas, haut } = self;
        let milieu = if bas == 0.0 {
            haut / 64.0
        } else if bas > 0.0 && haut > 4.0 * bas {
            (bas * haut).sqrt()
        } else {
            0.5 * bas + 0.5 * haut
        };
        [de_a(bas, milieu), de_a(milieu, haut)]
    }

    /// The part of the domain that this interval covers, by orders of magnitude where the domain is above 0.
    fn part_de(self, domaine: Self) -> f64 {
        let mesure =
            |x: Self| if domaine.bas > 0.0 { (x.haut / x.bas).ln() } else { x.haut - x.bas };
        mesure(self) / mesure(domaine)
    }
}

impl Add for Intervalle {
    type Output = Self;
    fn add(self, autre: Self) -> Self {
        Self::autour(self.bas + autre.bas, self.haut + autre.haut)
    }
}

impl Sub for Intervalle {
    type Output = Self;
    fn sub(self, autre: Self) -> Self {
        self + -autre
    }
}

impl Neg for Intervalle {
    type Output = Self;
    fn neg(self) -> Self {
        de_a(-self.haut, -self.bas)
    }
}

impl Mul for Intervalle {
    type Output = Self;
    fn mul(self, autre: Self) -> Self {
        let produits = [
            self.bas * autre.bas,
            self.bas * autre.haut,
            self.haut * autre.bas,
            self.haut * autre.haut,
        ];
        let bas = produits.into_iter().fold(f64::INFINITY, f64::min);
        Self::autour(bas, produits.into_iter().fold(f64::NEG_INFINITY, f64::max))
    }
}

impl Div for Intervalle {
    type Output = Self;
    fn div(self, autre: Self) -> Self {
        assert!(autre.bas > 0.0, "a divisor {autre:?}");
        let inverse = Self::autour(1.0 / autre.haut, 1.0 / autre.bas);
        self * inverse
    }
}

/// `2.0 * x` and the like.
macro_rules! avec_un_nombre {
    ($($operateur:ident, $f:ident;)*) => {$(
        impl $operateur<f64> for Intervalle {
            type Output = Self;
            fn $f(self, autre: f64) -> Self {
                $operateur::$f(self, Self::from(autre))
            }
        }
        impl $operateur<Intervalle> for f64 {
            type Output = Intervalle;
            fn $f(self, autre: Intervalle) -> Intervalle {
                $operateur::$f(Intervalle::from(self), autre)
            }
        }
    )*};
}

avec_un_nombre! { Add, add; Sub, sub; Mul, mul; Div, div; }

/// What `f` reaches on a domain: a number that it exceeds somewhere, and one that it exceeds nowhere, which is at most
/// `limite` if that can be shown. `f` gives none where all of its intervals lie outside the domain.
///
/// The box where `f` may be largest is cut in two along the axis that helps most, until the limit is shown, and until
/// `f` is found to exceed nine tenths of the limit or shown not to.
pub(crate) fn portee<const N: usize>(
    domaine: [Intervalle; N],
    limite: f64,
    f: impl Fn([Intervalle; N]) -> Option<Intervalle>,
) -> Intervalle {
    let mut atteint = f64::NEG_INFINITY;
    let mut boites = BinaryHeap::from_iter(Boite::new(domaine, &f));
    for _ in 0..1_000_000 {
        let Some(boite) = boites.pop() else { return de_a(f64::NEG_INFINITY, f64::NEG_INFINITY) };
        let Boite { haut, x } = boite;
        atteint = atteint.max(atteinte(x, limite, &f));
        if haut <= limite && (haut <= 0.9 * limite || atteint > 0.9 * limite) {
            return de_a(atteint, haut);
        }
        let coupes: Vec<_> = (0..N)
            .map(|axe| {
                let [a, b] = coupee(x, axe).map(|x| Boite::new(x, &f));
                (
                    a.as_ref().max(b.as_ref()).map_or(f64::NEG_INFINITY, |boite| boite.haut),
                    axe,
                    a,
                    b,
                )
            })
            .collect();
        let large = |axe: usize| x[axe].part_de(domaine[axe]);
        // The box is cut along the axis that helps most or, if none helps, along the widest.
        let choix = coupes.into_iter().min_by(|a, b| {
            let aide = |h: f64| if h < 0.999 * haut { h } else { f64::INFINITY };
            aide(a.0).total_cmp(&aide(b.0)).then(large(b.1).total_cmp(&large(a.1)))
        });
        let (.., a, b) = choix.expect("an axis");
        boites.extend(a.into_iter().chain(b));
    }
    panic!("not shown to be at most {limite}; {atteint} is reached; next {:?}", boites.peek());
}

/// Proves that `f` is no more than this limit on a domain, and finds a number that it exceeds there. Boxes are cut in
/// two along their longest side, which suits an `f` whose bound is costly and good.
pub(crate) fn prouver<const N: usize>(
    domaine: [Intervalle; N],
    limite: f64,
    f: impl Fn([Intervalle; N]) -> Option<Intervalle>,
) -> Intervalle {
    let mut atteint = f64::NEG_INFINITY;
    let mut boites = vec![domaine];
    for _ in 0..1_000_000 {
        let Some(x) = boites.pop() else { return de_a(atteint, limite) };
        if f(x).is_none_or(|borne| borne.haut <= limite) {
            continue;
        }
        // An order of magnitude counts about as much as half of a domain that has 0 in it.
        let large = |axe: &usize| {
            let (x, domaine) = (x[*axe], domaine[*axe]);
            let de_zero = 4.0 * (x.haut - x.bas) / (domaine.haut - domaine.bas);
            if domaine.bas > 0.0 { (x.haut / x.bas).ln() } else { de_zero }
        };
        let axe = (0..N).max_by(|a, b| large(a).total_cmp(&large(b))).expect("an axis");
        atteint = atteint.max(atteinte(x, limite, &f));
        boites.extend(coupee(x, axe));
    }
    panic!("not shown to be at most {limite}; {atteint} is reached; next {:?}", boites.last());
}

/// The box, cut in two along this axis.
fn coupee<const N: usize>(x: [Intervalle; N], axe: usize) -> [[Intervalle; N]; 2] {
    x[axe].parts().map(|part| {
        let mut x = x;
        x[axe] = part;
        x
    })
}

/// What `f` exceeds at a corner of the box or amid it, which must be no more than the limit.
fn atteinte<const N: usize>(
    x: [Intervalle; N],
    limite: f64,
    f: impl Fn([Intervalle; N]) -> Option<Intervalle>,
) -> f64 {
    let points = [x.map(|x| x.bas.into()), x.map(|x| x.parts()[0].haut.into())];
    points.into_iter().fold(f64::NEG_INFINITY, |atteint, point| {
        let ici = f(point).map_or(f64::NEG_INFINITY, |borne| borne.bas);
        assert!(ici <= limite, "{ici} at {point:?} is more than {limite}");
        atteint.max(ici)
    })
}

/// A box with an upper bound of `f` on it, by which boxes are ordered.
#[derive(Debug)]
struct Boite<const N: usize> {
    haut: f64,
    x: [Intervalle; N],
}

impl<const N: usize> Boite<N> {
    fn new(x: [Intervalle; N], f: impl Fn([Intervalle; N]) -> Option<Intervalle>) -> Option<Self> {
        f(x).map(|valeur| Self { haut: valeur.haut, x })
    }
}

impl<const N: usize> Ord for Boite<N> {
    fn cmp(&self, autre: &Self) -> Ordering {
        self.haut.total_cmp(&autre.haut)
    }
}

impl<const N: usize> PartialOrd for Boite<N> {
    fn partial_cmp(&self, autre: &Self) -> Option<Ordering> {
        Some(self.cmp(autre))
    }
}

impl<const N: usize> PartialEq for Boite<N> {
    fn eq(&self, autre: &Self) -> bool {
        self.cmp(autre).is_eq()
    }
}

impl<const N: usize> Eq for Boite<N> {}
