//! The sphere (handout §2.2, §3 and annex A.2).

use crate::erreur::{ErreurGeo, coefficient, deplacement, point, taille};
use crate::forme::{Boule, Forme};
use crate::intersection::Contact;
use crate::rayon::Rayon;
use crate::reel::{Reel, affiner};
use crate::rotation::Rotation;
use crate::texture::Texture;
use crate::vecteur::Vecteur;

/// A sphere as one describes it: its centre and its radius (handout §2.2).
///
/// ```
/// use core::f64::consts::PI;
/// use lancer_rayon::{Rotation, SphereGeo, Texture, Vecteur};
///
/// let boule = SphereGeo::new(Vecteur::new(0.0, 0.0, -5.0), 1.5, Texture(0))?;
/// let double = boule.homothetie(2.0)?.vers_ray();
/// assert_eq!((double.centre(), double.rayon()), (Vecteur::new(0.0, 0.0, -5.0), 3.0));
///
/// // Half a turn about y takes it behind the origin, a translation back.
/// let demi_tour = Rotation::new(Vecteur::new(0.0, PI, 0.0))?;
/// let derriere = boule.rotation(demi_tour)?;
/// assert_eq!(derriere.vers_ray().centre(), Vecteur::new(0.0, 0.0, 5.0));
/// assert_eq!(derriere.translation(Vecteur::new(0.0, 0.0, -10.0))?, boule);
/// # Ok::<(), lancer_rayon::ErreurGeo>(())
/// ```
#[doc(alias = "ball")]
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "SphereBrute<R>"))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "R: Reel + serde::Serialize")))]
#[cfg_attr(feature = "serde", serde(bound(deserialize = "R: Reel + serde::Deserialize<'de>")))]
#[must_use]
pub struct SphereGeo<R = f64> {
    centre: Vecteur<R>,
    rayon: R,
    texture: Texture,
}

impl<R: Reel> SphereGeo<R> {
    /// The sphere of this centre and this radius.
    ///
    /// # Errors
    /// If a coordinate is beyond ±2⁴⁵⁰ (`f64`) or ±2⁶⁰ (`f32`), or the radius outside 2⁻⁴⁵⁰ … 2⁴⁵⁰
    /// (`f64`) or 2⁻⁶⁰ … 2⁶⁰ (`f32`).
    pub fn new(centre: Vecteur<R>, rayon: R, texture: Texture) -> Result<Self, ErreurGeo> {
        Ok(Self {
            centre: point(["centre.x", "centre.y", "centre.z"], centre)?,
            rayon: taille("rayon", rayon)?,
            texture,
        })
    }

    /// The sphere moved by `v` (handout §2.3).
    ///
    /// # Errors
    /// If `v` is not finite, or the new centre lies outside the limits of [`new`](Self::new).
    #[doc(alias = "translate")]
    #[doc(alias = "move")]
    pub fn translation(self, v: Vecteur<R>) -> Result<Self, ErreurGeo> {
        let v = deplacement(v)?;
        Self::new(self.centre + v, self.rayon, self.texture)
    }

    /// The sphere turned about the origin O (handout §2.3): its centre moves.
    ///
    /// # Errors
    /// If the new centre lies outside the limits of [`new`](Self::new).
    #[doc(alias = "rotate")]
    #[doc(alias = "turn")]
    pub fn rotation(self, r: Rotation<R>) -> Result<Self, ErreurGeo> {
        Self::new(r.appliquer(self.centre), self.rayon, self.texture)
    }

    /// The sphere of the same centre and a radius `k` times as large (handout §2.3).
    ///
    /// # Errors
    /// If the coefficient is not finite and above 0, or the new radius outside the limits of
    /// [`new`](Self::new).
    #[doc(alias = "scale")]
    pub fn homothetie(self, k: R) -> Result<Self, ErreurGeo> {
        Self::new(self.centre, self.rayon * coefficient(k)?, self.texture)
    }

    /// The same sphere, ready for rays (handout §3).
    #[doc(alias = "into_ray")]
    #[inline]
    pub fn vers_ray(self) -> SphereRay<R> {
        let Self { centre, rayon, texture } = self;
        SphereRay { centre, r: rayon, texture }
    }
}

/// A sphere ready for rays: its centre C and its radius r > 0 (handout §3).
///
/// ```
/// use lancer_rayon::{SphereGeo, Texture, Vecteur};
///
/// let boule = SphereGeo::new(Vecteur::NUL, 1.5, Texture(7))?.vers_ray();
/// assert_eq!((boule.centre(), boule.rayon(), boule.texture()), (Vecteur::NUL, 1.5, Texture(7)));
/// # Ok::<(), lancer_rayon::ErreurGeo>(())
/// ```
#[doc(alias = "ball")]
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct SphereRay<R = f64> {
    centre: Vecteur<R>,
    r: R,
    texture: Texture,
}

impl<R: Reel> SphereRay<R> {
    /// C, the centre.
    #[doc(alias = "center")]
    #[inline]
    pub fn centre(&self) -> Vecteur<R> {
        self.centre
    }

    /// r, the radius.
    #[doc(alias = "radius")]
    #[inline]
    #[must_use]
    pub fn rayon(&self) -> R {
        self.r
    }

    /// The texture of the object.
    #[inline]
    pub fn texture(&self) -> Texture {
        self.texture
    }

    /// The lengths of annex A.2 for the ray (S, D).
    #[inline(always)]
    fn longueurs(&self, s: Vecteur<R>, d: Vecteur<R>) -> Longueurs<R> {
        let sc = self.centre - s;
        let (r2, d2) = (self.r * self.r, d.longueur_carree());
        Longueurs {
            sa: sc.produit_scalaire(d),
            puissance: sc.longueur_carree() - r2,
            ab2: r2 * d2 - sc.produit_vectoriel(d).longueur_carree(),
            d2,
        }
    }

    /// In `f64`, the distance SB of a ray that does not graze, and whether it is that of the hit: S is
    /// outside, B comes before A, and SB does not round to 0.
    #[inline(always)]
    fn sb_ordinaire(&self, rayon: &Rayon<R>, t: R) -> (f64, bool) {
        let longueurs =
            self.vers_f64().longueurs(rayon.source().vers_f64(), rayon.direction().vers_f64());
        let somme = longueurs.somme();
        let sb = affiner(t, || longueurs.puissance / somme);
        let dehors_et_avant = (longueurs.puissance > 0.0) & longueurs.avant_a(somme);
        (sb, (dehors_et_avant | !R::RECALCULE) & (R::depuis_f64(sb) > R::ZERO))
    }

    /// In `f64`, the vector from C to the point at distance t.
    #[inline(always)]
    fn cb(&self, rayon: &Rayon<R>, t: f64) -> Vecteur<f64> {
        let (s, d) = (rayon.source().vers_f64(), rayon.direction().vers_f64());
        // Relative to the source: S + tD − C would lose what S and C have in common.
        (s - self.centre.vers_f64()) + d * t
    }

    #[inline(always)]
    fn contact_a(&self, rayon: &Rayon<R>, t: f64, normale: Vecteur<R>) -> Contact<R> {
        let sphere = self.vers_f64();
        Contact::new(rayon, t, normale, |p| {
            let (n, cp, r) = (normale.vers_f64(), p - sphere.centre, sphere.r);
            let r2 = r * r;
            // (CP − r)(CP + r), and CP + r ≥ r/0.59 unless the hit fails the test below.
            let puissance = (cp.longueur_carree() - r2).abs();
            // Rounding tilts N away from CP, above all for a small far sphere. Three errors follow:
            // the height along N differs from CP − r by travers²/2r; a ray along the tangent plane
            // of N dips below the sphere by as much; a point rounded sideways climbs by
            // arrondi·travers/r, at most (arrondi² + travers²)/2r.
            let le_long = n.produit_scalaire(cp);
            let travers2 = (cp - n * le_long).longueur_carree();
            let arrondi = 4.0 * R::U.vers_f64() * (p.x.abs() + p.y.abs() + p.z.abs());
            // The sphere is no larger than the rounding of its distance or of its place, or the
            // point came out on its far side.
            let perdue = (puissance > 0.5 * r2)
                | (travers2 > 0.0625 * r2)
                | (4.0 * arrondi > r)
                | (le_long <= 0.0);
            let hauteur = (0.6 * puissance + 2.0 * travers2 + 0.5 * arrondi * arrondi) * (1.0 / r);
            (if perdue { f64::INFINITY } else { hauteur }, 2.0 * r)
        })
    }

    #[inline(always)]
    fn vers_f64(&self) -> SphereRay<f64> {
        let SphereRay { centre, r, texture } = *self;
        SphereRay { centre: centre.vers_f64(), r: r.vers_f64(), texture }
    }
}

impl<R: Reel> Forme<R> for SphereRay<R> {
    #[inline(always)]
    fn boule(&self) -> Boule<R> {
        Boule { centre: self.centre, r2: self.r * self.r }
    }

    fn boite_englobante(&self) -> Option<(Vecteur<R>, Vecteur<R>)> {
        Some((self.centre, Vecteur::new(self.r, self.r, self.r)))
    }

    /// An entry has S outside, C ahead and AC < r.
    #[inline(always)]
    fn t(&self, s: Vecteur<R>, d: Vecteur<R>) -> R {
        let l = self.longueurs(s, d);
        let entre = (l.ab2 > R::ZERO) & (l.sa > R::ZERO) & (l.puissance > R::ZERO);
        if entre { l.sb() } else { R::INFINI }
    }

    /// Sure, unless the ray grazes or starts almost on the surface, or rounding has eaten the sphere.
    #[inline(always)]
    fn contact(&self, rayon: &Rayon<R>, t: R) -> (Contact<R>, bool) {
        let (t, sur) = self.sb_ordinaire(rayon, t);
        let cb = self.cb(rayon, t);
        // With t computed in f64, CB is r long by far more digits than f32 keeps: no root is needed.
        let longueur =
            if R::RECALCULE { self.r.vers_f64() } else { Reel::sqrt(cb.longueur_carree()) };
        let (normale, de_face) = normale(cb, longueur, rayon);
        (self.contact_a(rayon, t, normale), sur & de_face)
    }

    /// With A for B if B comes no earlier. A source that is not outside in `f64` has no distance there, and
    /// a normal that does not face the source is leaned towards it.
    #[cold]
    fn contact_rare(&self, rayon: &Rayon<R>, t: R) -> Contact<R> {
        let (s, d) = (rayon.source().vers_f64(), rayon.direction().vers_f64());
        let longueurs = self.vers_f64().longueurs(s, d);
        let dehors = longueurs.puissance > 0.0;
        let precise = affiner(t, || if dehors { longueurs.sb() } else { f64::INFINITY });
        let t = Contact::retenir(t, precise);
        let cb = self.cb(rayon, t);
        let (normale, de_face) = normale(cb, Reel::sqrt(cb.longueur_carree()), rayon);
        let normale = if de_face { normale } else { vers_la_source(cb, rayon) };
        self.contact_a(rayon, t, normale)
    }

    /// The normal decides nothing here.
    #[inline(always)]
    fn distance_seule(&self, rayon: &Rayon<R>, t: R) -> (R, bool) {
        let (t, sur) = self.sb_ordinaire(rayon, t);
        (R::depuis_f64(t), sur)
    }
}

/// The lengths of annex A.2, with A the point of the ray nearest to C.
///
/// AC comes from SC ∧ D, never from SC² − SA², which for a small or far sphere is the difference of
/// two large numbers. D·D stands where the handout has 1, since D is unit only to rounding.
struct Longueurs<R> {
    /// SA = SC·D, above 0 if C lies ahead.
    sa: R,
    /// The power of S, SC² − r²: above 0 outside.
    puissance: R,
    /// AB² = r² − AC².
    ab2: R,
    /// D·D.
    d2: R,
}

impl<R: Reel> Longueurs<R> {
    /// SB, if the ray enters the sphere.
    ///
    /// SB = SA − AB, written as power/(SA + AB), which subtracts nothing; and never past A, even
    /// where the ray grazes so closely that AB is all rounding.
    #[inline(always)]
    fn sb(&self) -> R {
        let somme = self.somme();
        let avant_a = self.avant_a(somme);
        let (haut, bas) = if avant_a { (self.puissance, somme) } else { (self.sa, self.d2) };
        haut / bas
    }

    /// SA + AB.
    #[inline(always)]
    fn somme(&self) -> R {
        self.sa + if self.ab2 > R::ZERO { self.ab2 } else { R::ZERO }.sqrt()
    }

    /// Whether power/(SA + AB) comes before A.
    #[inline(always)]
    fn avant_a(&self, somme: R) -> bool {
        self.puissance * self.d2 < self.sa * somme
    }
}

/// CB² at or below this is all rounding: the smallest sphere has r² = 2⁻⁹⁰⁰, and no square that is
/// subnormal weighs in a sum above 2⁻⁹⁰⁴.
const CB2_PERDU: f64 = f64::from_bits((1023 - 904) << 52);

/// How far the square of a length that stands for |CB| may be from CB², as a share of CB²: 2⁻³². The
/// normal is then unit to 2⁻³³, far less than the 2⁻²⁴ of a rounding in `f32`.
const ECART_LONGUEUR: f64 = f64::from_bits((1023 - 32) << 52);

/// CB over this length, and whether that is a normal: a unit vector that faces the source of the ray.
#[inline(always)]
fn normale<R: Reel>(cb: Vecteur<f64>, longueur: f64, rayon: &Rayon<R>) -> (Vecteur<R>, bool) {
    let cb2 = cb.longueur_carree();
    let normale = Vecteur::depuis_f64(cb / longueur);
    // False for a NaN as well.
    let unitaire = (longueur * longueur - cb2).abs() <= ECART_LONGUEUR * cb2;
    let de_face = normale.produit_scalaire(rayon.direction()) < R::ZERO;
    (normale, unitaire & de_face & (cb2 > CB2_PERDU))
}

/// The unit normal nearest to CB that faces the source of the ray.
///
/// Where a ray only grazes, rounding can leave CB at a right angle to D or past it. The normal is then
/// the part of CB across D, leaned by 6u towards the source: N·D rounds by no more than 3.5u, as far as a
/// directed search could find. If even this normal does not face the source, −D does.
#[cold]
fn vers_la_source<R: Reel>(cb: Vecteur<f64>, rayon: &Rayon<R>) -> Vecteur<R> {
    let d = rayon.direction().vers_f64();
    let d = d / d.longueur();
    let travers = (cb - d * cb.produit_scalaire(d)).unitaire();
    let penchee = travers.and_then(|n| (n - d * (6.0 * R::U.vers_f64())).unitaire());
    let penchee = penchee.map(Vecteur::depuis_f64);
    let de_face = |n: &Vecteur<R>| n.produit_scalaire(rayon.direction()) < R::ZERO;
    penchee.filter(de_face).unwrap_or(Vecteur::depuis_f64(-d))
}

#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
#[serde(rename = "SphereGeo", deny_unknown_fields)]
#[serde(bound(deserialize = "R: Reel + serde::Deserialize<'de>"))]
struct SphereBrute<R> {
    centre: Vecteur<R>,
    rayon: R,
    texture: Texture,
}

#[cfg(feature = "serde")]
impl<R: Reel> TryFrom<SphereBrute<R>> for SphereGeo<R> {
    type Error = ErreurGeo;
    fn try_from(brute: SphereBrute<R>) -> Result<Self, ErreurGeo> {
        Self::new(brute.centre, brute.rayon, brute.texture)
    }
}
