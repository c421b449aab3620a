//! The true answer to "where does this ray enter this object", to judge the kernel by.
//!
//! Why it is right: it reads the values as they are stored, each an integer times a power of
//! two, and adds, subtracts and multiplies them as big integers, so that every decision (inside
//! or outside, hit or miss, which face) is the sign of a number that is known exactly. Only a
//! quotient and a square root are rounded, at [`PRECISION`] bits beyond what cancels.
//!
//! It shares no formula with the kernel: the sphere is the quadratic equation |S + tD − C|² = r²
//! with its root b − √Δ, which rounding forbids the kernel; the box is clipped face by face, each
//! an exact half-space; the half-space is N·(S + tD) + d = 0.

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

use dashu_int::IBig;
use dashu_int::ops::{BitTest, SquareRoot, UnsignedAbs};
use lancer_rayon::{BoiteRay, ObjetRay, PlanRay, Rayon, Reel, SphereRay, Vecteur};

/// Bits kept of a quotient or a root.
const PRECISION: isize = 256;

/// The integer `m` times 2^`e`.
#[derive(Debug, Clone)]
pub(crate) struct Exact {
    m: IBig,
    e: isize,
}

impl Exact {
    pub(crate) fn de<R: Reel>(x: R) -> Self {
        let bits = x.vers_f64().to_bits();
        let (exposant, fraction) = ((bits >> 52) & 0x7ff, bits & ((1 << 52) - 1));
        assert!(exposant < 0x7ff, "{x} is not a number");
        let m = if exposant == 0 { fraction } else { fraction | (1 << 52) };
        let m = IBig::from(m);
        let e = exposant.max(1) as isize - 1075;
        Self { m: if bits >> 63 == 1 { -m } else { m }, e }
    }

    /// The same number with a smaller exponent.
    fn m_a(&self, e: isize) -> IBig {
        &self.m << usize::try_from(self.e - e).expect("the exponent only goes down")
    }

    pub(crate) fn signe(&self) -> Ordering {
        self.m.cmp(&IBig::ZERO)
    }

    pub(crate) fn positif(&self) -> bool {
        self.signe() == Ordering::Greater
    }

    fn longueur_en_bits(&self) -> isize {
        (&self.m).unsigned_abs().bit_len() as isize
    }

    /// The exponent of the number: it lies between 2^(k−1) and 2^k.
    fn exposant(&self) -> isize {
        self.longueur_en_bits() + self.e
    }

    /// Cut off to its leading bits.
    pub(crate) fn vers_f64(&self) -> f64 {
        let trop = self.longueur_en_bits() - 64;
        let (m, e) = if trop > 0 {
            (&self.m >> trop as usize, self.e + trop)
        } else {
            (self.m.clone(), self.e)
        };
        let m = i128::try_from(m).expect("64 bits") as f64;
        // In two steps, since 2^e alone may be below what an f64 holds.
        let moitie = (e / 2) as i32;
        m * f64::from(moitie).exp2() * f64::from(e as i32 - moitie).exp2()
    }

    /// The quotient, rounded down at [`PRECISION`] bits.
    fn sur(&self, diviseur: &Self) -> Self {
        let decalage = (PRECISION + diviseur.longueur_en_bits() - self.longueur_en_bits()).max(0);
        let m = (&self.m << decalage as usize) / &diviseur.m;
        Self { m, e: self.e - decalage - diviseur.e }
    }

    /// The square root, rounded down to a multiple of 2^`fin`.
    fn racine(&self, fin: isize) -> Self {
        let m = if self.e >= 2 * fin {
            self.m_a(2 * fin)
        } else {
            &self.m >> (2 * fin - self.e) as usize
        };
        Self { m: m.unsigned_abs().sqrt().into(), e: fin }
    }
}

impl Add for &Exact {
    type Output = Exact;
    fn add(self, autre: Self) -> Exact {
        let e = self.e.min(autre.e);
        Exact { m: self.m_a(e) + autre.m_a(e), e }
    }
}

impl Sub for &Exact {
    type Output = Exact;
    fn sub(self, autre: Self) -> Exact {
        self + &-autre
    }
}

impl Neg for &Exact {
    type Output = Exact;
    fn neg(self) -> Exact {
        Exact { m: -&self.m, e: self.e }
    }
}

impl Mul for &Exact {
    type Output = Exact;
    fn mul(self, autre: Self) -> Exact {
        Exact { m: &self.m * &autre.m, e: self.e + autre.e }
    }
}

impl PartialEq for Exact {
    fn eq(&self, autre: &Self) -> bool {
        (self - autre).signe() == Ordering::Equal
    }
}

impl PartialOrd for Exact {
    fn partial_cmp(&self, autre: &Self) -> Option<Ordering> {
        Some((self - autre).signe())
    }
}

type Point = [Exact; 3];

fn point<R: Reel>(v: Vecteur<R>) -> Point {
    [v.x, v.y, v.z].map(Exact::de)
}

fn moins(a: &Point, b: &Point) -> Point {
    core::array::from_fn(|i| &a[i] - &b[i])
}

fn scalaire(a: &Point, b: &Point) -> Exact {
    let [x, y, z] = core::array::from_fn(|i| &a[i] * &b[i]);
    &(&x + &y) + &z
}

/// A ray as stored.
struct Droite {
    s: Point,
    d: Point,
}

/// The true entry of a ray into an object, or the truth that there is none.
pub(crate) struct Verite {
    pub(crate) entree: Option<Entree>,
    /// The decision is closer than what the promise of the kernel covers.
    pub(crate) dans_la_marge: bool,
}

pub(crate) struct Entree {
    /// The parameter t in S + tD.
    pub(crate) t: Exact,
    /// The normal; beside an edge, those of all the faces entered within the margin.
    pub(crate) normales: Vec<Vecteur>,
    /// (|f| + r + t)/|N·D|: what an error of the distance is counted in, times u.
    pub(crate) cond: f64,
    /// |f|, from the source to the centre (for a half-space, to the foot of O).
    pub(crate) f: f64,
    /// The radius; +∞ for a flat face.
    pub(crate) rayon_de_courbure: f64,
}

impl Entree {
    /// How far `t` lies from the truth.
    pub(crate) fn ecart<R: Reel>(&self, t: R) -> f64 {
        (&Exact::de(t) - &self.t).vers_f64()
    }
}

/// How far a point lies above the surface that was touched, along its normal; for a box the
/// plane of the face of this normal.
pub(crate) fn hauteur<R: Reel>(objet: &ObjetRay<R>, normale: Vecteur<R>, p: Vecteur<R>) -> f64 {
    let p = point(p);
    match objet {
        ObjetRay::Sphere(sphere) => {
            let cp = moins(&p, &point(sphere.centre()));
            let cp2 = scalaire(&cp, &cp);
            let r = Exact::de(sphere.rayon());
            (&cp2 - &(&r * &r)).vers_f64() / (cp2.vers_f64().sqrt() + r.vers_f64())
        }
        ObjetRay::Plan(plan) => {
            (&scalaire(&point(plan.normale()), &p) + &Exact::de(plan.distance())).vers_f64()
        }
        ObjetRay::Boite(boite) => {
            let axe = (0..3).find(|&axe| {
                let n = boite.normales()[axe];
                n == normale || n == -normale
            });
            let l = Exact::de(boite.demi_longueurs()[axe.expect("a normal of the box")]);
            let cp = moins(&p, &point(boite.centre()));
            (&scalaire(&point(normale), &cp) - &l).vers_f64()
        }
    }
}

/// The truth about one object and one ray.
pub(crate) fn verite<R: Reel>(objet: &ObjetRay<R>, rayon: &Rayon<R>) -> Verite {
    let droite = Droite { s: point(rayon.source()), d: point(rayon.direction()) };
    let quatre_u = 4.0 * R::U.vers_f64();
    match objet {
        ObjetRay::Sphere(sphere) => verite_sphere(sphere, &droite, quatre_u),
        ObjetRay::Plan(plan) => verite_plan(plan, &droite, quatre_u),
        ObjetRay::Boite(boite) => verite_boite(boite, &droite, quatre_u),
    }
}

fn verite_sphere<R: Reel>(sphere: &SphereRay<R>, ray: &Droite, quatre_u: f64) -> Verite {
    let f = moins(&ray.s, &point(sphere.centre()));
    let r = Exact::de(sphere.rayon());
    // a·t² − 2b·t + c = 0.
    let (a, b) = (scalaire(&ray.d, &ray.d), -&scalaire(&f, &ray.d));
    let f2 = scalaire(&f, &f);
    let r2 = &r * &r;
    let c = &f2 - &r2;
    let delta = &(&b * &b) - &(&a * &c);

    let (f_, r_) = (f2.vers_f64().sqrt(), r.vers_f64());
    // |SC| − r and |AC| − r, where a·AC² = a·f² − b²: each as a difference of squares.
    let sc_r = c.vers_f64() / (f_ + r_);
    let ac2 = (&(&a * &f2) - &(&b * &b)).sur(&a).vers_f64();
    let ac_r = -delta.sur(&a).vers_f64() / (ac2.sqrt() + r_);
    let seuil = quatre_u * (f_ + r_);
    let dans_la_marge = sc_r.abs() <= seuil || (ac_r.abs() <= seuil && b.vers_f64() >= -seuil);

    let touche = c.positif() && b.positif() && delta.positif();
    let entree = touche.then(|| {
        // b − √Δ cancels all but c·a/2b of b.
        let annule = (2 * b.exposant() - c.exposant() - a.exposant()).max(0);
        let racine = delta.racine(b.exposant() - annule - PRECISION - 8);
        let t = (&b - &racine).sur(&a);
        let cb: Point = core::array::from_fn(|i| &f[i] + &(&t * &ray.d[i]));
        let n = Vecteur::from(cb.each_ref().map(|x| x.sur(&r).vers_f64()));
        let cosinus = delta.vers_f64().sqrt() / r_;
        let cond = (f_ + r_ + t.vers_f64()) / cosinus;
        Entree { t, normales: vec![n], cond, f: f_, rayon_de_courbure: r_ }
    });
    Verite { entree, dans_la_marge }
}

fn verite_plan<R: Reel>(plan: &PlanRay<R>, ray: &Droite, quatre_u: f64) -> Verite {
    let n = point(plan.normale());
    let d = Exact::de(plan.distance());
    let hauteur = &scalaire(&n, &ray.s) + &d;
    let descente = -&scalaire(&n, &ray.d);
    let (s_, d_) = (scalaire(&ray.s, &ray.s).vers_f64().sqrt(), d.vers_f64().abs());
    let dans_la_marge =
        hauteur.vers_f64().abs() <= quatre_u * (s_ + d_) || descente.vers_f64().abs() <= quatre_u;
    let entree = (hauteur.positif() && descente.positif()).then(|| {
        let t = hauteur.sur(&descente);
        // C = −d·N.
        let f: Point = core::array::from_fn(|i| &ray.s[i] + &(&d * &n[i]));
        let f = scalaire(&f, &f).vers_f64().sqrt();
        let cond = (f + d_ + t.vers_f64()) / descente.vers_f64();
        let normale = Vecteur::from(n.each_ref().map(Exact::vers_f64));
        Entree { t, normales: vec![normale], cond, f, rayon_de_courbure: f64::INFINITY }
    });
    Verite { entree, dans_la_marge }
}

fn verite_boite<R: Reel>(boite: &BoiteRay<R>, ray: &Droite, quatre_u: f64) -> Verite {
    let f = moins(&ray.s, &point(boite.centre()));
    let f_ = scalaire(&f, &f).vers_f64().sqrt();
    let l = boite.demi_longueurs().map(Exact::de);
    let demi_diagonale = l.iter().map(|l| l.vers_f64().powi(2)).sum::<f64>().sqrt();
    let seuil = quatre_u * (f_ + demi_diagonale);

    // The six faces N·(X − C) ≤ l, one after the other: what enters, what leaves.
    let mut entrees: Vec<(Exact, f64, Vecteur)> = Vec::new();
    let mut sorties: Vec<Exact> = Vec::new();
    let mut dehors = false;
    let mut dans_la_marge = false;
    let mut cosinus_min = f64::INFINITY;
    let mut indecises = Vec::new();
    for (axe, l) in l.iter().enumerate() {
        let n = point(boite.normales()[axe]);
        for n in [n.each_ref().map(|x| -x), n] {
            let haut = &scalaire(&n, &f) - l;
            let vitesse = scalaire(&n, &ray.d);
            // Along the plane of a face to rounding, the search cannot tell on which side.
            let v = vitesse.vers_f64().abs();
            if v <= quatre_u && haut.vers_f64().abs() <= 2.0 * seuil {
                indecises.push(Vecteur::from(n.each_ref().map(Exact::vers_f64)));
            }
            let t = || (-&haut).sur(&vitesse);
            match vitesse.signe() {
                Ordering::Less => {
                    let cosinus = -vitesse.vers_f64();
                    cosinus_min = cosinus_min.min(cosinus);
                    let normale = Vecteur::from(n.each_ref().map(Exact::vers_f64));
                    entrees.push((t(), cosinus, normale));
                }
                Ordering::Greater => sorties.push(t()),
                Ordering::Equal => {
                    dehors |= haut.positif();
                    dans_la_marge |= haut.vers_f64().abs() <= seuil;
                }
            }
        }
    }
    let (t, cosinus_t, _) =
        entrees.iter().cloned().reduce(|a, b| if b.0 > a.0 { b } else { a }).expect("D is not 0");
    let sortie = sorties.into_iter().reduce(|a, b| if b < a { b } else { a }).expect("D is not 0");
    let mou = (&sortie - &t).vers_f64();
    dans_la_marge |= mou.abs() <= seuil / cosinus_min;
    dans_la_marge |=
        t.vers_f64().abs() <= seuil / cosinus_t || sortie.vers_f64().abs() <= seuil / cosinus_min;
    // Beside an edge the other face may win: all those entered within the margin.
    let mut cosinus = cosinus_t;
    let mut normales = Vec::new();
    for (autre, c, normale) in &entrees {
        if (&t - autre).vers_f64() <= seuil / c.min(cosinus_t) {
            cosinus = cosinus.min(*c);
            normales.push(*normale);
        }
    }
    // As for a half-space, a face within 4u of parallel that matters leaves nothing to promise.
    let cosinus = if cosinus <= quatre_u || !indecises.is_empty() { 0.0 } else { cosinus };
    normales.append(&mut indecises);
    let entree = (!dehors && t.positif() && sortie >= t).then(|| {
        let cond = (f_ + demi_diagonale + t.vers_f64()) / cosinus;
        Entree { t, normales, cond, f: f_, rayon_de_courbure: f64::INFINITY }
    });
    Verite { entree, dans_la_marge }
}
