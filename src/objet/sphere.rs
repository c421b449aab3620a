//! The sphere (handout §2.2, §3 and annex A.2).

use crate::algebre::arrondis::{
    ARRONDI_PERDU, FLOU_PROPRE, LONGUEUR, PAR_RAYON, PUISSANCE_PERDUE, TRAVERS_PERDU,
};
use crate::algebre::nombre::{fois_u, max};
use crate::algebre::refus::{self, coefficient, deplacement, position, taille};
use crate::objet::forme::{Boule, Forme, Hauteur};
use crate::{ErreurGeo, Nombre, Rayon, Rotation, Texture, Vecteur};

/// The description of a sphere: its centre and its radius (handout §2.2).
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
#[must_use]
pub struct SphereGeo<R = f64> {
    centre: Vecteur<R>,
    rayon: R,
    texture: Texture,
}

impl<R: Nombre> SphereGeo<R> {
    /// C, the centre.
    #[doc(alias = "center")]
    pub fn centre(&self) -> Vecteur<R> {
        self.centre
    }

    /// r, the radius.
    #[doc(alias = "radius")]
    #[must_use]
    pub fn rayon(&self) -> R {
        self.rayon
    }

    /// The texture of the object.
    #[doc(alias = "material")]
    pub fn texture(&self) -> Texture {
        self.texture
    }

    /// The sphere of this centre and this radius.
    ///
    /// # Errors
    /// If a coordinate is beyond ±2⁴⁵⁰ (`f64`) or ±2⁶⁰ (`f32`), or the radius outside 2⁻⁴⁵⁰ … 2⁴⁵⁰
    /// (`f64`) or 2⁻⁶⁰ … 2⁶⁰ (`f32`).
    pub fn new(centre: Vecteur<R>, rayon: R, texture: Texture) -> Result<Self, ErreurGeo> {
        Ok(Self {
            centre: position(["centre.x", "centre.y", "centre.z"], centre)?,
            rayon: taille("rayon", rayon)?,
            texture,
        })
    }

    /// The sphere moved by `v` (handout §2.3).
    ///
    /// # Errors
    /// If `v` is not finite, or the new centre lies outside the limits of [`new`](Self::new).
    #[doc(alias("translate", "move"))]
    pub fn translation(self, v: Vecteur<R>) -> Result<Self, ErreurGeo> {
        Self::new(self.centre + deplacement(v)?, self.rayon, self.texture)
    }

    /// The sphere turned about the origin O (handout §2.3): its centre moves.
    ///
    /// # Errors
    /// If the new centre lies outside the limits of [`new`](Self::new).
    #[doc(alias("rotate", "turn"))]
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

    /// The same sphere in `f32`, seen from an origin that is subtracted before anything is rounded:
    /// see [`ObjetGeo::vers_f32`](crate::ObjetGeo::vers_f32).
    ///
    /// # Errors
    /// If `origine` is not finite, or if [`translation`](Self::translation) by −`origine` or
    /// [`new`](Self::new) with the numbers in `f32` fails.
    #[doc(alias("to_f32", "narrow", "floating_origin"))]
    pub fn vers_f32(self, origine: Vecteur<R>) -> Result<SphereGeo<f32>, ErreurGeo> {
        self.vers(origine)
    }

    /// The same in a scalar that is no wider.
    pub(crate) fn vers<Q: Nombre>(self, origine: Vecteur<R>) -> Result<SphereGeo<Q>, ErreurGeo> {
        let Self { centre, rayon, texture } = self.translation(-refus::origine(origine)?)?;
        let centre = Vecteur::depuis_f64(centre.vers_f64());
        SphereGeo::new(centre, Q::depuis_f64(rayon.vers_f64()), texture)
    }

    /// The same sphere, ready for rays (handout §3).
    #[doc(alias = "into_ray")]
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

/// What an entry into a sphere is computed from, with D·D where the handout has 1.
struct Termes<R> {
    /// SC·D.
    sa: R,
    /// The power of S, SC² − r².
    puissance: R,
    /// AB²·D².
    ab2: R,
    d2: R,
}

impl<R: Nombre> SphereRay<R> {
    /// C, the centre.
    #[doc(alias = "center")]
    pub fn centre(&self) -> Vecteur<R> {
        self.centre
    }

    /// r, the radius.
    #[doc(alias = "radius")]
    #[must_use]
    pub fn rayon(&self) -> R {
        self.r
    }

    /// The texture of the object.
    #[doc(alias = "material")]
    pub fn texture(&self) -> Texture {
        self.texture
    }

    /// What an entry is computed from.
    #[inline(always)]
    fn termes(&self, rayon: &Rayon<R>) -> Termes<R> {
        let (sc, d) = (self.centre - rayon.source(), rayon.direction());
        let (r2, d2) = (self.r * self.r, d.longueur_carree()); // S1: D·D, 1 but for rounding
        let sa = sc.produit_scalaire(d); // S2: A is the point of the line nearest to C
        let puissance = sc.longueur_carree() - r2; // S3: above 0 outside
        let ab2 = r2 * d2 - sc.produit_vectoriel(d).longueur_carree(); // S4: r² − AC²
        Termes { sa, puissance, ab2, d2 }
    }

    /// The same numbers in `f64`.
    pub(crate) fn temoin_f64(self) -> SphereRay {
        SphereRay { centre: self.centre.vers_f64(), r: self.r.vers_f64(), texture: self.texture }
    }
}

impl<R: Nombre> Forme<R> for SphereRay<R> {
    #[inline(always)]
    fn boule(&self) -> Boule<R> {
        Boule { centre: self.centre, r2: self.r * self.r }
    }

    fn boite_englobante(&self) -> Option<(Vecteur<R>, Vecteur<R>)> {
        Some((self.centre, Vecteur::new(self.r, self.r, self.r)))
    }

    /// SB = SA − AB, with A the point of the ray nearest to C, where S is outside, C ahead and AC <
    /// r.
    ///
    /// AC comes from SC ∧ D, never from SC² − SA², which for a small or far sphere is the
    /// difference of two large numbers. D·D stands where the handout has 1, since D is unit only to
    /// rounding. SA − AB is written as power/(SA + AB), which subtracts nothing; and B is never
    /// past A, even where the ray grazes so closely that AB is all rounding.
    #[inline(always)]
    fn t_et_contient(&self, rayon: &Rayon<R>) -> (R, bool) {
        let Termes { sa, puissance, ab2, d2 } = self.termes(rayon);
        let sa_ab = sa + ab2.racine(); // S6: (SA − AB)(SA + AB) is the power
        let avant_a = puissance * d2 < sa * sa_ab;
        let (haut, bas) = if avant_a { (puissance, sa_ab) } else { (sa, d2) };
        // S5: the line meets the sphere, ahead of a source outside.
        let touche = (ab2 > R::ZERO) & (sa > R::ZERO) & (puissance > R::ZERO);
        (if touche { haut / bas } else { R::INFINI }, puissance <= R::ZERO)
    }

    /// C is not ahead.
    #[inline(always)]
    fn s_eloigne(&self, rayon: &Rayon<R>) -> bool {
        self.termes(rayon).sa <= R::ZERO
    }

    #[inline(always)]
    fn des_le_depart(&self, rayon: &Rayon<R>) -> bool {
        let Termes { sa, puissance, ab2, .. } = self.termes(rayon);
        let profond = rayon.flou.d_emblee() + self.r * fois_u(FLOU_PROPRE);
        // D1: at a depth h the power is −(2r − h)h.
        let pres = puissance > -(self.r + self.r) * profond;
        (puissance <= R::ZERO) & pres & (sa > R::ZERO) & (ab2 > R::ZERO)
    }

    /// SA + AB where A lies ahead, else the power over SA − AB: neither subtracts anything.
    ///
    /// For a source inside, AB is taken no shorter than √(r² − SC²), so that the way out of a ray
    /// that starts there is above 0 and at most 2r away, even within rounding of the surface.
    #[inline(always)]
    fn t_sortie(&self, rayon: &Rayon<R>) -> R {
        let Termes { sa, puissance, ab2, d2 } = self.termes(rayon);
        let (interieur, devant) = (puissance < R::ZERO, sa > R::ZERO);
        // W1: from inside AB² is no less than −power·D².
        let ab = max(ab2, -puissance * d2).racine();
        // W2: no sum cancels.
        let (haut, bas) = if devant { (sa + ab, d2) } else { (puissance, sa - ab) };
        if interieur | (devant & (ab2 > R::ZERO)) { haut / bas } else { R::INFINI }
    }

    /// CB/|CB|, or 0 where CB is lost.
    #[inline(always)]
    fn plan_tangent(&self, rayon: &Rayon<R>, t: R) -> (Vecteur<R>, R) {
        // S7, relative to the source: S + tD − C would lose what S and C have in common.
        let cb = (rayon.source() - self.centre) + rayon.direction() * t;
        let cb2 = cb.longueur_carree();
        // Half of the smallest r²: what is shorter is all rounding, and its square may be
        // subnormal.
        let perdu = R::UN / (R::LIMITE * R::LIMITE * R::depuis_f64(2.0));
        (cb / if cb2 > perdu { cb2.racine() } else { R::INFINI }, self.r)
    }

    #[inline(always)]
    fn hauteur(&self, p: Vecteur<R>, n: Vecteur<R>, r: R) -> Hauteur<R> {
        // M3: from the power of P, which is 2r times the height, nearly.
        let nombre = R::depuis_f64;
        let cp = p - self.centre;
        let r2 = r * r;
        let puissance = (cp.longueur_carree() - r2).absolu();
        // Rounding tilts N away from CP, above all for a small far sphere: a ray along the tangent
        // plane of N dips below the sphere, and a point that is rounded sideways climbs.
        let le_long = n.produit_scalaire(cp);
        let travers2 = (cp - n * le_long).longueur_carree();
        let arrondi = p.norme_1() * R::U;
        // The sphere is no larger than the rounding of its distance or of its place, or the point
        // came out on its far side.
        let perdue = (puissance > nombre(PUISSANCE_PERDUE) * r2)
            | (travers2 > nombre(TRAVERS_PERDU) * r2)
            | (arrondi > nombre(ARRONDI_PERDU) * r)
            | (le_long <= R::ZERO);
        let b = nombre(PAR_RAYON) * (puissance + travers2) + arrondi * arrondi;
        let b = if perdue { R::INFINI } else { b * (R::UN / r) };
        Hauteur { b, l: nombre(LONGUEUR) * r }
    }
}
