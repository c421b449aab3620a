//! The true answer to "where does this ray enter this object", to judge the kernel by.
//!
//! Why it is right: it reads the values as they are stored, each an integer times a power of
//! two, and adds, subtracts and multiplies them as big integers, so that every decision (inside
//! or outside, hit or miss, which face) is the sign of a number that is known exactly. Only a
//! quotient and a square root are rounded, at [`PRECISION`] bits beyond what cancels.
//!
//! It shares no formula with the kernel. The sphere is the quadratic equation |S + tD − C|² = r² with its root b − √Δ,
//! which rounding forbids the kernel; the box is clipped face by face, each an exact half-space; the half-space is
//! N·(S + tD) + d = 0. The way out is the other root, or the first of the exits.

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

use dashu_int::IBig;
use dashu_int::ops::{BitTest, SquareRoot, UnsignedAbs};
use lancer_rayon::{BoiteRay, ObjetRay, PlanRay, Rayon, Reel, Reponse, SphereRay, Vecteur};

use crate::tolerances::{bandes, promesses, u};

/// Bits kept of a quotient or a root.
const PRECISION: isize = 256;

/// The relative rounding of an entry itself: a root, a quotient and, in scene units, the length of D.
pub const ORACLE_ARRONDI: f64 = 1.0 / ((1_u128 << 127) as f64 * (1_u128 << 127) as f64);

/// The integer `m` times 2^`e`.
#[derive(Debug, Clone)]
pub struct Exact {
    m: IBig,
    e: isize,
}

impl Exact {
    pub fn de<R: Reel>(x: R) -> Self {
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

    pub fn signe(&self) -> Ordering {
        self.m.cmp(&IBig::ZERO)
    }

    pub fn positif(&self) -> bool {
        self.signe() == Ordering::Greater
    }

    fn grandeur(&self) -> Self {
        if self.signe() == Ordering::Less { -self } else { self.clone() }
    }

    fn longueur_en_bits(&self) -> isize {
        (&self.m).unsigned_abs().bit_len() as isize
    }

    /// The exponent k of the number: its size lies between 2^(k−1) and 2^k.
    fn exposant(&self) -> isize {
        self.longueur_en_bits() + self.e
    }

    /// The leading bits of the number.
    pub fn vers_f64(&self) -> f64 {
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

pub type Point = [Exact; 3];

pub fn exacts<R: Reel>(v: Vecteur<R>) -> Point {
    [v.x, v.y, v.z].map(Exact::de)
}

/// S + tD.
pub fn exact_a<R: Reel>(rayon: &Rayon<R>, t: &Exact) -> Point {
    let (s, d) = (exacts(rayon.source()), exacts(rayon.direction()));
    core::array::from_fn(|i| &s[i] + &(t * &d[i]))
}

pub fn moins(a: &Point, b: &Point) -> Point {
    core::array::from_fn(|i| &a[i] - &b[i])
}

pub fn scalaire(a: &Point, b: &Point) -> Exact {
    let [x, y, z] = core::array::from_fn(|i| &a[i] * &b[i]);
    &(&x + &y) + &z
}

fn vectoriel([ax, ay, az]: &Point, [bx, by, bz]: &Point) -> Point {
    [&(ay * bz) - &(az * by), &(az * bx) - &(ax * bz), &(ax * by) - &(ay * bx)]
}

/// A ray as stored.
struct Droite {
    s: Point,
    d: Point,
}

/// What is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Passage {
    /// Where the ray enters from outside.
    Entree,
    /// Where the ray leaves, from inside or after it entered.
    Sortie,
}

impl Passage {
    pub const TOUS: [Self; 2] = [Self::Entree, Self::Sortie];

    /// What the library answers.
    pub fn de<R: Reel>(self, objet: &ObjetRay<R>, rayon: &Rayon<R>) -> Reponse<R> {
        match self {
            Self::Entree => objet.intersection(rayon),
            Self::Sortie => objet.sortie(rayon),
        }
    }
}

/// The truth about the entry of a ray into an object or about its way out, or that there is none.
pub struct Verite {
    pub entree: Option<Entree>,
    /// The decision is closer than the promise of the kernel covers.
    pub dans_la_marge: bool,
    marge: Marge,
}

impl Verite {
    /// The factor by which the band would have to grow to hold this decision.
    pub fn facteur(&self) -> f64 {
        match &self.marge {
            Marge::Connue(facteur) => *facteur,
            Marge::Boite(decision) => decision.facteur(self.entree.is_some()),
        }
    }
}

enum Marge {
    Connue(f64),
    Boite(Box<Decision>),
}

pub struct Entree {
    /// The parameter t in S + tD.
    pub t: Exact,
    /// The outward normal; beside an edge, the normals of all faces that the ray enters or leaves by within the band.
    normales: Vec<Point>,
    /// κt = (|f| + r + t)/v, at a flat face over v − 3.1u: times u, the unit in which the error of a distance is
    /// counted.
    pub kappa_t: f64,
    /// K of the promise.
    pub k: f64,
    /// The smallest |N·D| of these faces; for a flat face 3.1u less.
    pub cosinus: f64,
    /// |f|, the distance from the source to the centre (for a half-space, to the foot of O).
    pub f: f64,
    /// The radius; +∞ for a flat face.
    pub rayon_de_courbure: f64,
}

impl Entree {
    /// How far `t` lies from the truth.
    pub fn ecart<R: Reel>(&self, t: R) -> f64 {
        self.ecart_fois(t, 1.0)
    }

    /// The same times a number that is large enough for an error of a few subnormals to have all its digits.
    pub fn ecart_fois<R: Reel>(&self, t: R, k: f64) -> f64 {
        (&(&Exact::de(t) - &self.t) * &Exact::de(k)).vers_f64()
    }

    /// The same for t in scene units: t − t′|D|.
    pub fn ecart_mesure_fois<R: Reel>(&self, rayon: &Rayon<R>, t: R, k: f64) -> f64 {
        let d = exacts(rayon.direction());
        let entree = &self.t * &scalaire(&d, &d).racine(-PRECISION);
        (&(&Exact::de(t) - &entree) * &Exact::de(k)).vers_f64()
    }

    /// The sine of the angle to the true normal that is allowed where the distance is off by `ecart`; +∞ where the
    /// sphere is lost in its distance.
    pub fn direction_permise<R: Reel>(&self, ecart: f64) -> f64 {
        let r = self.rayon_de_courbure;
        if perdue::<R>(r, self.f) {
            return f64::INFINITY;
        }
        // D may be longer than 1 by 7.6u.
        promesses::DIRECTION * u::<R>() * (1.0 + self.f / r) + (1.0 + 8.0 * u::<R>()) * ecart / r
    }

    /// The sine of the angle between this normal and the true one: 1 beyond a right angle, +∞ if it is no normal.
    pub fn ecart_de_normale<R: Reel>(&self, normale: Vecteur<R>) -> f64 {
        if normale.unitaire().is_none() {
            return f64::INFINITY;
        }
        let normale = exacts(normale);
        let sinus = self.normales.iter().map(|n| {
            if !scalaire(&normale, n).positif() {
                return 1.0;
            }
            longueur(&vectoriel(&normale, n)) / (longueur(&normale) * longueur(n))
        });
        sinus.fold(f64::INFINITY, f64::min)
    }
}

/// Whether a sphere of this radius is lost in its distance |f|.
fn perdue<R: Reel>(r: f64, f: f64) -> bool {
    r < promesses::PERDUE * u::<R>() * f
}

/// What is sure of a speed towards a flat face: the speed less its possible error, and at least 0.
fn sur<R: Reel>(cosinus: f64) -> f64 {
    (cosinus - bandes::VITESSE * u::<R>()).max(0.0)
}

fn longueur(v: &Point) -> f64 {
    Vecteur::from(v.each_ref().map(Exact::vers_f64)).longueur()
}

/// How far a point lies above the surface that was touched, along its normal N; for a box, above the plane of the face
/// with this normal. The result is good to 3u of `f64`.
pub fn hauteur<R: Reel>(objet: &ObjetRay<R>, normale: Vecteur<R>, p: Vecteur<R>) -> f64 {
    let p = exacts(p);
    // |N|, to first order, since the square of |N|² − 1 is negligible.
    let longueur = 1.0 + 0.5 * norme_au_carre_moins_un(normale);
    match objet {
        ObjetRay::Sphere(sphere) => {
            let cp = moins(&p, &exacts(sphere.centre()));
            let cp2 = scalaire(&cp, &cp);
            let r = Exact::de(sphere.rayon());
            let puissance = &cp2 - &(&r * &r);
            // The nearer of the two s with |CP − sN| = r, in a form that does not cancel.
            let n = exacts(normale);
            let (n2, b) = (scalaire(&n, &n), scalaire(&cp, &n));
            let delta = &(&b * &b) - &(&n2 * &puissance);
            let (b, puissance) = (b.vers_f64(), puissance.vers_f64());
            longueur * puissance / (b.abs() + delta.vers_f64().max(0.0).sqrt()).copysign(b)
        }
        ObjetRay::Plan(plan) => {
            (&scalaire(&exacts(normale), &p) + &Exact::de(plan.distance())).vers_f64() / longueur
        }
        ObjetRay::Boite(boite) => {
            let axe = (0..3).find(|&axe| {
                let n = boite.normales()[axe];
                n == normale || n == -normale
            });
            let l = Exact::de(boite.demi_longueurs()[axe.expect("a normal of the box")]);
            let cp = moins(&p, &exacts(boite.centre()));
            (&scalaire(&exacts(normale), &cp) - &l).vers_f64() / longueur
        }
    }
}

/// How far outside an object a point lies; for a box, how far above the plane of the face that it lies farthest above.
/// The result is good to 3u of `f64`, in units of |N|.
pub fn dehors<R: Reel>(objet: &ObjetRay<R>, p: Vecteur<R>) -> f64 {
    let p = exacts(p);
    match objet {
        ObjetRay::Sphere(sphere) => {
            let cp = moins(&p, &exacts(sphere.centre()));
            let r = Exact::de(sphere.rayon());
            (&scalaire(&cp, &cp) - &(&r * &r)).vers_f64() / (longueur(&cp) + r.vers_f64())
        }
        ObjetRay::Plan(plan) => {
            (&scalaire(&exacts(plan.normale()), &p) + &Exact::de(plan.distance())).vers_f64()
        }
        ObjetRay::Boite(boite) => {
            let cp = moins(&p, &exacts(boite.centre()));
            let hauteurs =
                boite.normales().into_iter().zip(boite.demi_longueurs()).map(|(n, l)| {
                    let h = scalaire(&exacts(n), &cp);
                    let h = if h.positif() { h } else { -&h };
                    (&h - &Exact::de(l)).vers_f64()
                });
            hauteurs.fold(f64::NEG_INFINITY, f64::max)
        }
    }
}

/// The sine of the angle between `reflet` and what a mirror of normal N makes of D.
pub fn ecart_du_miroir<R: Reel>(d: Vecteur<R>, normale: Vecteur<R>, reflet: Vecteur<R>) -> f64 {
    let [d, n, reflet] = [d, normale, reflet].map(exacts);
    // D − 2(D·N)N/N², times N².
    let (n2, le_long) = (scalaire(&n, &n), scalaire(&d, &n));
    let double = &le_long + &le_long;
    let miroir: Point = core::array::from_fn(|i| &(&n2 * &d[i]) - &(&double * &n[i]));
    longueur(&vectoriel(&miroir, &reflet)) / (longueur(&miroir) * longueur(&reflet))
}

/// What Snell's law gives for light in the direction D at a surface of normal N, where `rapport` is the index in front
/// over the one behind: the square of the cosine behind the surface and, where that is above 0, the sine of the angle
/// between `suite` and the exact direction on the side that `passage` tells.
pub fn ecart_de_snell<R: Reel>(
    d: Vecteur<R>,
    normale: Vecteur<R>,
    rapport: R,
    passage: Passage,
    suite: Option<Vecteur<R>>,
) -> (f64, Option<f64>) {
    let ([d, n], eta) = ([d, normale].map(exacts), Exact::de(rapport));
    let (n2, d2, le_long) = (scalaire(&n, &n), scalaire(&d, &d), scalaire(&d, &n));
    // The part of D along the surface, times ηN²; then, by Pythagoras, the squared cosine times N²·D².
    let travers: Point = core::array::from_fn(|i| &eta * &(&(&n2 * &d[i]) - &(&le_long * &n[i])));
    let plein = &n2 * &d2;
    let sinus2 = &(&eta * &eta) * &(&plein - &(&le_long * &le_long));
    let carre = &plein - &sinus2;
    let cosinus2 = carre.sur(&plein).vers_f64();
    if !carre.positif() {
        return (cosinus2, None);
    }
    let droit = carre.racine(carre.exposant() / 2 - PRECISION);
    let droit = match passage {
        Passage::Entree => -&droit,
        Passage::Sortie => droit,
    };
    let vraie: Point = core::array::from_fn(|i| &travers[i] + &(&droit * &n[i]));
    let ecart = suite
        .map(exacts)
        .map(|suite| longueur(&vectoriel(&vraie, &suite)) / (longueur(&vraie) * longueur(&suite)));
    (cosinus2, ecart)
}

/// How far `cosinus` lies from N·V/|V|.
pub fn ecart_du_cosinus<R: Reel>(n: Vecteur<R>, v: Vecteur<R>, cosinus: R) -> f64 {
    let [n, v] = [n, v].map(exacts);
    let v2 = scalaire(&v, &v);
    let exact = scalaire(&n, &v).sur(&v2.racine(v2.exposant() / 2 - PRECISION));
    (&Exact::de(cosinus) - &exact).vers_f64()
}

/// How far, in scene units, these coordinates in a box, from −1 to 1, lie from those of S + tD cut off at ±1.
pub fn ecarts_du_lieu<R: Reel>(
    boite: &BoiteRay<R>,
    rayon: &Rayon<R>,
    t: R,
    lieu: Vecteur<R>,
) -> [f64; 3] {
    let f = moins(&exacts(rayon.source()), &exacts(boite.centre()));
    let (t, d, lieu) = (Exact::de(t), exacts(rayon.direction()), exacts(lieu));
    let cx: Point = core::array::from_fn(|i| &f[i] + &(&t * &d[i]));
    core::array::from_fn(|i| {
        let l = Exact::de(boite.demi_longueurs()[i]);
        let exacte = scalaire(&exacts(boite.normales()[i]), &cx);
        let exacte = if exacte > l {
            l.clone()
        } else if exacte < -&l {
            -&l
        } else {
            exacte
        };
        (&(&lieu[i] * &l) - &exacte).vers_f64()
    })
}

/// |V|² − 1.
pub fn norme_au_carre_moins_un<R: Reel>(v: Vecteur<R>) -> f64 {
    let v = exacts(v);
    (&scalaire(&v, &v) - &Exact::de(1.0)).vers_f64()
}

/// The truth about the entry of one ray into one object.
pub fn verite<R: Reel>(objet: &ObjetRay<R>, rayon: &Rayon<R>) -> Verite {
    verite_du(Passage::Entree, objet, rayon)
}

/// The truth about one object and one ray.
pub fn verite_du<R: Reel>(passage: Passage, objet: &ObjetRay<R>, rayon: &Rayon<R>) -> Verite {
    let droite = Droite { s: exacts(rayon.source()), d: exacts(rayon.direction()) };
    match objet {
        ObjetRay::Sphere(sphere) => verite_sphere(passage, sphere, &droite),
        ObjetRay::Plan(plan) => verite_plan(passage, plan, &droite),
        ObjetRay::Boite(boite) => verite_boite(passage, boite, &droite),
    }
}

fn verite_sphere<R: Reel>(passage: Passage, sphere: &SphereRay<R>, ray: &Droite) -> Verite {
    let f = moins(&ray.s, &exacts(sphere.centre()));
    let r = Exact::de(sphere.rayon());
    // a·t² − 2b·t + c = 0.
    let (a, b) = (scalaire(&ray.d, &ray.d), -&scalaire(&f, &ray.d));
    let f2 = scalaire(&f, &f);
    let r2 = &r * &r;
    let c = &f2 - &r2;
    let delta = &(&b * &b) - &(&a * &c);

    let (f_, r_) = (f2.vers_f64().sqrt(), r.vers_f64());
    // |SC| − r and |AC| − r, each as a difference of squares, where a·AC² = a·f² − b².
    let sc_r = c.vers_f64() / (f_ + r_);
    let ac2 = (&(&a * &f2) - &(&b * &b)).sur(&a).vers_f64();
    let ac_r = -delta.sur(&a).vers_f64() / (ac2.sqrt() + r_);
    let seuil = bandes::SPHERE * u::<R>() * (f_ + r_);
    let (facteur, touche) = match passage {
        Passage::Entree => (
            sc_r.abs().min(ac_r.abs().max(-b.vers_f64())),
            c.positif() && b.positif() && delta.positif(),
        ),
        // The nearest point of the ray to C is A, or S with A behind.
        Passage::Sortie if b.positif() => (ac_r.abs(), delta.positif()),
        Passage::Sortie => (sc_r.abs(), (-&c).positif()),
    };
    let facteur = facteur / seuil;
    let entree = touche.then(|| {
        // b − √Δ cancels all but c·a/2b of b, and so does b + √Δ where b is below 0.
        let annule = (2 * b.exposant() - c.exposant() - a.exposant()).max(0);
        let racine = delta.racine(b.exposant() - annule - PRECISION - 8);
        let t = match passage {
            Passage::Entree => &b - &racine,
            Passage::Sortie => &b + &racine,
        };
        let t = t.sur(&a);
        let cb: Point = core::array::from_fn(|i| &f[i] + &(&t * &ray.d[i]));
        let n = cb.each_ref().map(|x| x.sur(&r));
        let cosinus = delta.vers_f64().sqrt() / r_;
        let kappa_t = (f_ + r_ + t.vers_f64()) / cosinus;
        let k = match passage {
            Passage::Entree if perdue::<R>(r_, f_) => promesses::DISTANCE_PERDUE,
            Passage::Entree => promesses::DISTANCE_SPHERE,
            Passage::Sortie => promesses::SORTIE_SPHERE,
        };
        Entree { t, normales: vec![n], kappa_t, k, cosinus, f: f_, rayon_de_courbure: r_ }
    });
    Verite { entree, dans_la_marge: facteur <= 1.0, marge: Marge::Connue(facteur) }
}

fn verite_plan<R: Reel>(passage: Passage, plan: &PlanRay<R>, ray: &Droite) -> Verite {
    let n = exacts(plan.normale());
    let d = Exact::de(plan.distance());
    let hauteur = &scalaire(&n, &ray.s) + &d;
    let descente = -&scalaire(&n, &ray.d);
    let d_ = d.vers_f64().abs();
    let grandeurs =
        scalaire(&n.each_ref().map(Exact::grandeur), &ray.s.each_ref().map(Exact::grandeur));
    let seuil =
        bandes::PLAN * u::<R>() * grandeurs.vers_f64() + bandes::PLAN_ABSOLUE * R::ETA.vers_f64();
    let cosinus = descente.vers_f64();
    let facteur =
        (hauteur.vers_f64().abs() / seuil).min(cosinus.abs() / (bandes::VITESSE * u::<R>()));
    let (devant, vite) = match passage {
        Passage::Entree => (hauteur, descente),
        Passage::Sortie => (-&hauteur, -&descente),
    };
    let entree = (devant.positif() && vite.positif()).then(|| {
        let t = devant.sur(&vite);
        // C = −d·N.
        let f: Point = core::array::from_fn(|i| &ray.s[i] + &(&d * &n[i]));
        let f = longueur(&f);
        let cosinus = sur::<R>(cosinus.abs());
        let kappa_t = (f + d_ + t.vers_f64()) / cosinus;
        let k = promesses::DISTANCE_PLAN;
        Entree { t, normales: vec![n], kappa_t, k, cosinus, f, rayon_de_courbure: f64::INFINITY }
    });
    Verite { entree, dans_la_marge: facteur <= 1.0, marge: Marge::Connue(facteur) }
}

/// One pair of faces of a box as the ray sees it: how far its entry and its exit lie ahead along the normal, and the
/// speed v ≥ 0 towards them. The ray enters at a/v and leaves at b/v.
struct Couple {
    a: Exact,
    b: Exact,
    v: Exact,
    /// The normal against the ray; for v = 0 either of the two.
    normale: Point,
}

/// x_i·v_j − y_j·v_i for two pairs of faces i and j, each exact until its last rounding.
struct Produits {
    /// For the entries a and a.
    aa: [[f64; 3]; 3],
    /// For an exit b and an entry a.
    ba: [[f64; 3]; 3],
    /// For the exits b and b.
    bb: [[f64; 3]; 3],
    /// For −a and a: turned the other way, the ray has its exit at −a.
    moins_aa: [[f64; 3]; 3],
    /// For −b and b: its entry is then at −b.
    moins_bb: [[f64; 3]; 3],
}

impl Produits {
    fn new(longueurs: &[[Exact; 2]; 3], couples: &[Couple; 3]) -> Self {
        let fois_v = |quoi: usize| {
            longueurs.each_ref().map(|l| couples.each_ref().map(|couple| &l[quoi] * &couple.v))
        };
        let (av, bv) = (fois_v(0), fois_v(1));
        let tous = |f: &dyn Fn(usize, usize) -> Exact| {
            core::array::from_fn(|i| core::array::from_fn(|j| f(i, j).vers_f64()))
        };
        Self {
            aa: tous(&|i, j| &av[i][j] - &av[j][i]),
            ba: tous(&|i, j| &bv[i][j] - &av[j][i]),
            bb: tous(&|i, j| &bv[i][j] - &bv[j][i]),
            moins_aa: tous(&|i, j| -&(&av[i][j] + &av[j][i])),
            moins_bb: tous(&|i, j| -&(&bv[i][j] + &bv[j][i])),
        }
    }
}

/// What the band of a box is made of: lengths in a unit near |f| + ρ, and cross products of lengths and speeds, exact
/// until they are rounded here.
struct Decision {
    passage: Passage,
    a: [f64; 3],
    b: [f64; 3],
    v: [f64; 3],
    /// The cross products such as a_i·v_j − a_j·v_i.
    produits: Produits,
    alpha: f64,
    beta: f64,
}

impl Decision {
    fn new(passage: Passage, couples: &[Couple; 3], taille: f64, u: f64) -> Self {
        // With a unit near the size, a power of two, no product of a length and a speed leaves `f64`.
        let unite = ((taille.to_bits() >> 52) as isize - 1023).max(-1000);
        let reduit = |x: &Exact| Exact { m: x.m.clone(), e: x.e - unite };
        let longueurs = couples.each_ref().map(|c| [reduit(&c.a), reduit(&c.b)]);
        let produits = Produits::new(&longueurs, couples);
        let taille = taille * f64::from(-unite as i32).exp2();
        Self {
            passage,
            a: longueurs.each_ref().map(|[a, _]| a.vers_f64()),
            b: longueurs.each_ref().map(|[_, b]| b.vers_f64()),
            v: couples.each_ref().map(|c| c.v.vers_f64()),
            produits,
            alpha: bandes::BOITE_LONGUEUR * u * taille,
            beta: bandes::VITESSE * u,
        }
    }

    /// How far away the exit is, b; if the ray may go either way, the distance l − |o| to the nearer plane. Its
    /// products with the entries of the other pairs come with it.
    fn sortie(&self, i: usize, sens_connu: bool) -> (f64, &[f64; 3]) {
        if sens_connu || self.b[i] <= -self.a[i] {
            (self.b[i], &self.produits.ba[i])
        } else {
            (-self.a[i], &self.produits.moins_aa[i])
        }
    }

    /// How far away the entry is, a; if the ray may go either way, the distance |o| − l from S to the slab. Its product
    /// with the exit of another pair comes with it.
    fn entree(&self, i: usize, sens_connu: bool) -> (f64, impl Fn(usize) -> f64) {
        let approche = sens_connu || self.a[i] >= -self.b[i];
        let produit = move |j: usize| {
            if approche { -self.produits.ba[j][i] } else { self.produits.moins_bb[i][j] }
        };
        (if approche { self.a[i] } else { -self.b[i] }, produit)
    }

    /// No lengths within α and no speeds within β of these, both times `facteur`, make it a miss.
    fn touche_surement(&self, facteur: f64) -> bool {
        let (alpha, beta) = (facteur * self.alpha, facteur * self.beta);
        let connu = self.v.map(|v| v > beta);
        let entre = (0..3).any(|i| connu[i] && self.a[i] > alpha);
        // For a way out the ray may start inside.
        (entre || self.passage == Passage::Sortie)
            && (0..3).all(|j| {
                let (b, produits) = self.sortie(j, connu[j]);
                // Only entries of other pairs matter, since a pair's own entry never comes after its exit.
                let avant = |i: usize| {
                    let a = self.a[i];
                    let permis = alpha * (self.v[i] + self.v[j]) + beta * (a + b);
                    i == j || !connu[i] || a < -alpha || produits[i] >= permis
                };
                b > alpha && (0..3).all(avant)
            })
    }

    fn manque_surement(&self, facteur: f64) -> bool {
        let (alpha, beta) = (facteur * self.alpha, facteur * self.beta);
        let connu = self.v.map(|v| v > beta);
        let derriere = (0..3).any(|j| connu[j] && self.b[j] < -alpha);
        let entre =
            self.passage == Passage::Sortie || (0..3).any(|i| self.entree(i, connu[i]).0 > -alpha);
        let trop_tard = |i: usize, j: usize| {
            let (a, produit) = self.entree(i, connu[i]);
            let permis = alpha * (self.v[i] + self.v[j]) + beta * (a + self.b[j]);
            i != j && connu[j] && a > alpha && produit(j) > permis
        };
        derriere || !entre || (0..3).any(|i| (0..3).any(|j| trop_tard(i, j)))
    }

    fn surement(&self, touche: bool, facteur: f64) -> bool {
        if touche { self.touche_surement(facteur) } else { self.manque_surement(facteur) }
    }

    /// Found by bisection of the exponent, which works since a wider band holds all that a narrower one holds.
    fn facteur(&self, touche: bool) -> f64 {
        let (mut bas, mut haut) = (-40.0_f64, 40.0_f64);
        while haut - bas > 1e-3 {
            let milieu = 0.5 * (bas + haut);
            if self.surement(touche, milieu.exp2()) { bas = milieu } else { haut = milieu }
        }
        haut.exp2()
    }

    /// Whether this pair may be the last by which the ray enters: its latest possible entry is no earlier than the
    /// earliest possible entries of the others.
    fn peut_etre_la_derniere(&self, i: usize) -> bool {
        let (alpha, beta) = (self.alpha, self.beta);
        let (a, v) = (self.a[i], self.v[i]);
        if v <= beta {
            // Between the planes of a pair that it hardly approaches, the ray entered long ago.
            let (b, _) = self.sortie(i, false);
            let tard = -(b - alpha) / (v + beta);
            return b <= alpha || (0..3).all(|j| i == j || tard >= self.au_plus_tot(j));
        }
        (0..3).all(|j| {
            let (a_j, v_j) = (self.a[j], self.v[j]);
            let (somme, vitesses) = (beta * (a + a_j), alpha * (v + v_j));
            if i == j {
                true
            } else if v_j <= beta {
                (a + alpha) / (v - beta) >= self.au_plus_tot(j)
            } else if a >= -alpha {
                a_j < alpha || self.produits.aa[i][j] + vitesses + somme >= 0.0
            } else {
                a_j < alpha && self.produits.aa[i][j] + vitesses - somme >= 0.0
            }
        })
    }

    /// Whether this pair may be the first by which the ray leaves: its earliest possible exit is no later than the
    /// latest possible exits of the others.
    fn peut_etre_la_premiere(&self, i: usize) -> bool {
        let (alpha, beta) = (self.alpha, self.beta);
        let (b, v) = (self.b[i], self.v[i]);
        (0..3).all(|j| {
            let (b_j, v_j) = (self.b[j], self.v[j]);
            if i == j || v_j <= beta {
                true
            } else if v <= beta {
                let (b, _) = self.sortie(i, false);
                (b - alpha) / (v + beta) <= (b_j + alpha) / (v_j - beta)
            } else {
                self.produits.bb[i][j] <= alpha * (v + v_j) + beta * (b + b_j)
            }
        })
    }

    /// The earliest that an entry can be.
    fn au_plus_tot(&self, j: usize) -> f64 {
        let connu = self.v[j] > self.beta;
        let (a, _) = self.entree(j, connu);
        let a = a - self.alpha;
        if a > 0.0 {
            a / (self.v[j] + self.beta)
        } else if connu {
            a / (self.v[j] - self.beta)
        } else {
            f64::NEG_INFINITY
        }
    }
}

fn verite_boite<R: Reel>(passage: Passage, boite: &BoiteRay<R>, ray: &Droite) -> Verite {
    let f = moins(&ray.s, &exacts(boite.centre()));
    let f_ = longueur(&f);
    let demi_longueurs = boite.demi_longueurs();
    let rho = Vecteur::from(demi_longueurs.map(R::vers_f64)).longueur();
    let couples: [Couple; 3] = core::array::from_fn(|axe| {
        let n = exacts(boite.normales()[axe]);
        let l = Exact::de(demi_longueurs[axe]);
        let (o, v) = (scalaire(&n, &f), scalaire(&n, &ray.d));
        if v.signe() == Ordering::Less {
            Couple { a: -&(&l - &o), b: &l + &o, v: -&v, normale: n }
        } else {
            Couple { a: -&(&l + &o), b: &l - &o, v, normale: n.map(|x| -&x) }
        }
    });
    let vers = |i: usize| couples[i].v.positif();
    // Whether x/v comes after y/w, of two pairs.
    let apres = |(x, v): (&Exact, &Exact), (y, w): (&Exact, &Exact)| (x * w) > (y * v);
    let entree = |i: usize| (&couples[i].a, &couples[i].v);
    let sortie = |i: usize| (&couples[i].b, &couples[i].v);
    let en_mouvement = || (0..3).filter(|&i| vers(i));
    let derniere = en_mouvement().reduce(|i, j| if apres(entree(j), entree(i)) { j } else { i });
    let derniere = derniere.expect("D is not 0");
    // The ray is parallel to a pair and beside it; a ray in the plane of a face counts as in the box.
    let dehors = (0..3).any(|i| !vers(i) && (couples[i].a.positif() || (-&couples[i].b).positif()));
    let premiere = en_mouvement().reduce(|i, j| if apres(sortie(i), sortie(j)) { j } else { i });
    let premiere = premiere.expect("D is not 0");
    // The length, in its pair, at which the ray crosses the face that decides.
    let (longueur, axe) = match passage {
        Passage::Entree => (&couples[derniere].a, derniere),
        Passage::Sortie => (&couples[premiere].b, premiere),
    };
    let touche = !dehors && longueur.positif() && !apres(entree(derniere), sortie(premiere));

    let decision = Box::new(Decision::new(passage, &couples, f_ + rho, u::<R>()));
    let dans_la_marge = !decision.surement(touche, 1.0);
    let entree = touche.then(|| {
        let t = longueur.sur(&couples[axe].v);
        let mut normales = Vec::new();
        let mut cosinus = f64::INFINITY;
        for (i, couple) in couples.iter().enumerate() {
            let nommee = match passage {
                Passage::Entree => decision.peut_etre_la_derniere(i),
                Passage::Sortie => decision.peut_etre_la_premiere(i),
            };
            if i != axe && !nommee {
                continue;
            }
            let v = decision.v[i];
            cosinus = cosinus.min(v);
            normales.push(match passage {
                Passage::Entree => couple.normale.clone(),
                Passage::Sortie => couple.normale.each_ref().map(|x| -x),
            });
            if v <= decision.beta {
                // Rounding may turn the ray either way.
                normales.extend([couple.normale.clone(), couple.normale.each_ref().map(|x| -x)]);
            }
        }
        let cosinus = sur::<R>(cosinus);
        let kappa_t = (f_ + rho + t.vers_f64()) / cosinus;
        let k = promesses::DISTANCE_BOITE;
        Entree { t, normales, kappa_t, k, cosinus, f: f_, rayon_de_courbure: f64::INFINITY }
    });
    Verite { entree, dans_la_marge, marge: Marge::Boite(decision) }
}
