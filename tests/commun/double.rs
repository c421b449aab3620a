//! Distances with twice the digits of an f64: not the truth, but near enough to tell in a fraction of
//! a microsecond whether a case is worth asking the oracle about.

use core::ops::{Add, Div, Mul, Sub};

use lancer_rayon::{ObjetRay, Rayon, Reel, Vecteur};

/// An unevaluated sum of two f64, the second below the last place of the first.
#[derive(Debug, Clone, Copy)]
pub struct Double(f64, f64);

impl Double {
    fn somme(a: f64, b: f64) -> Self {
        let somme = a + b;
        let b_vu = somme - a;
        Self(somme, (a - (somme - b_vu)) + (b - b_vu))
    }

    fn produit(a: f64, b: f64) -> Self {
        fn moities(x: f64) -> (f64, f64) {
            let c = 134_217_729.0 * x; // 2^27 + 1
            let haut = c - (c - x);
            (haut, x - haut)
        }
        let produit = a * b;
        let ((ah, ab), (bh, bb)) = (moities(a), moities(b));
        Self(produit, ab * bb - (((produit - ah * bh) - ab * bh) - ah * bb))
    }

    fn racine(self) -> Self {
        let x = self.0.sqrt();
        let reste = self - Self::produit(x, x);
        Self::somme(x, reste.0 / (2.0 * x))
    }
}

impl Add for Double {
    type Output = Self;
    fn add(self, autre: Self) -> Self {
        let Self(s, e) = Self::somme(self.0, autre.0);
        let Self(t, f) = Self::somme(self.1, autre.1);
        let Self(s, e) = Self::somme(s, e + t);
        Self::somme(s, e + f)
    }
}

impl Sub for Double {
    type Output = Self;
    fn sub(self, autre: Self) -> Self {
        self + Self(-autre.0, -autre.1)
    }
}

impl Mul for Double {
    type Output = Self;
    fn mul(self, autre: Self) -> Self {
        let Self(p, e) = Self::produit(self.0, autre.0);
        Self::somme(p, e + (self.0 * autre.1 + self.1 * autre.0))
    }
}

impl Div for Double {
    type Output = Self;
    fn div(self, autre: Self) -> Self {
        let q = self.0 / autre.0;
        let reste = self - autre * Self(q, 0.0);
        Self::somme(q, reste.0 / autre.0)
    }
}

type Point = [Double; 3];

fn point<R: Reel>(v: Vecteur<R>) -> Point {
    [v.x, v.y, v.z].map(|x| Double(x.vers_f64(), 0.0))
}

fn scalaire(a: &Point, b: &Point) -> Double {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// How far `t` lies from the entry of this ray, and the unit in which that counts,
/// (|f| + r + t)/|N·D|; NaN where there is none.
pub fn ecart_et_kappa_t<R: Reel>(objet: &ObjetRay<R>, rayon: &Rayon<R>, t: R) -> (f64, f64) {
    let (s, d) = (point(rayon.source()), point(rayon.direction()));
    let depuis = |c: Vecteur<R>| -> Point {
        let c = point(c);
        core::array::from_fn(|i| s[i] - c[i])
    };
    let (entree, taille, cosinus) = match objet {
        ObjetRay::Sphere(sphere) => {
            let (f, r) = (depuis(sphere.centre()), Double(sphere.rayon().vers_f64(), 0.0));
            let (a, b, f2) = (scalaire(&d, &d), scalaire(&f, &d), scalaire(&f, &f));
            let c = f2 - r * r;
            let racine = (b * b - a * c).racine();
            (c / (racine - b), f2.0.sqrt() + r.0, racine.0 / r.0)
        }
        ObjetRay::Plan(plan) => {
            let (n, d_plan) = (point(plan.normale()), plan.distance().vers_f64());
            let haut = scalaire(&n, &s) + Double(d_plan, 0.0);
            let descente = Double(0.0, 0.0) - scalaire(&n, &d);
            let f: Point = core::array::from_fn(|i| s[i] + Double(d_plan, 0.0) * n[i]);
            (haut / descente, scalaire(&f, &f).0.sqrt() + d_plan.abs(), descente.0)
        }
        ObjetRay::Boite(boite) => {
            let f = depuis(boite.centre());
            let l = boite.demi_longueurs().map(R::vers_f64);
            let (mut entree, mut cosinus) = (Double(f64::NEG_INFINITY, 0.0), 0.0);
            for (n, l) in boite.normales().into_iter().zip(l) {
                let n = point(n);
                let (o, v) = (scalaire(&n, &f), scalaire(&n, &d));
                let signe = Double(v.0.signum(), 0.0);
                let ici = Double(0.0, 0.0) - (Double(l, 0.0) + o * signe) / (v * signe);
                if ici.0 > entree.0 {
                    (entree, cosinus) = (ici, v.0.abs());
                }
            }
            (entree, scalaire(&f, &f).0.sqrt() + Vecteur::from(l).longueur(), cosinus)
        }
    };
    let ecart = Double(t.vers_f64(), 0.0) - entree;
    (ecart.0, (taille + entree.0) / cosinus)
}
