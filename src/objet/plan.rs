//! The plane, which is a solid half-space (handout §2.2, §3 and annex A.1).

use crate::algebre::refus::{self, coefficient, coordonnee, deplacement, position, unitaire};
use crate::objet::forme::{Boule, Forme};
use crate::{ErreurGeo, Nombre, Rayon, Rotation, Texture, Vecteur};

/// The description of a half-space: the points z ≤ 0 turned by a rotation, then moved to lie at a
/// relative distance d from the origin O (handout §2.2). The distance is below 0 if the half-space
/// contains O, and above 0 if not.
///
/// ```
/// use core::f64::consts::FRAC_PI_2;
/// use lancer_rayon::{PlanGeo, Rotation, Texture, Vecteur};
///
/// // A quarter turn about x lays z ≤ 0 down as y ≤ 0: a floor, here two below the origin.
/// let couche = Rotation::new(Vecteur::new(FRAC_PI_2, 0.0, 0.0))?;
/// let sol = PlanGeo::new(couche, 2.0, Texture(0))?.vers_ray();
/// assert_eq!((sol.normale(), sol.distance()), (Vecteur::new(0.0, 1.0, 0.0), 2.0));
///
/// // The same floor laid down by a rotation, and then raised over the origin.
/// let dalle = PlanGeo::new(Rotation::IDENTITE, 2.0, Texture(0))?.rotation(couche)?.homothetie(9.0)?;
/// assert_eq!(dalle.vers_ray(), sol);
/// let plus_haut = dalle.translation(Vecteur::new(0.0, 3.0, 0.0))?;
/// assert_eq!(plus_haut.vers_ray().distance(), -1.0);
/// # Ok::<(), lancer_rayon::ErreurGeo>(())
/// ```
#[doc(alias("plane", "half_space"))]
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct PlanGeo<R = f64> {
    rotation: Rotation<R>,
    distance: R,
    texture: Texture,
}

impl<R: Nombre> PlanGeo<R> {
    /// The half-space of this rotation and this relative distance to the origin.
    ///
    /// # Errors
    /// If the distance is beyond ±2⁴⁵⁰ (`f64`) or ±2⁶⁰ (`f32`).
    pub fn new(rotation: Rotation<R>, distance: R, texture: Texture) -> Result<Self, ErreurGeo> {
        Ok(Self { rotation, distance: coordonnee("distance", distance)?, texture })
    }

    /// The rotation that laid z ≤ 0 down as this half-space; [`rotation`](Self::rotation) turns it
    /// on.
    ///
    /// Its [`axes`](Rotation::axes) are the two unit axes x and y, in the surface, and N. Measured
    /// along x and y, a pattern turns with its half-space. They come from here and not from N
    /// alone, which does not change when a floor is turned about it. In the third axis the surface
    /// lies at −d exactly, which the point of a hit reaches only to rounding: a pattern in three
    /// dimensions takes −d.
    ///
    /// ```
    /// use core::f64::consts::FRAC_PI_2;
    /// use lancer_rayon::{PlanGeo, Rotation, Texture, Vecteur};
    ///
    /// let couche = Rotation::new(Vecteur::new(FRAC_PI_2, 0.0, 0.0))?;
    /// let sol = PlanGeo::new(couche, 2.0, Texture(0))?;
    /// let point = Vecteur::new(3.0, -2.0, 5.0);
    /// let le_long = |sol: PlanGeo| {
    ///     let [x, y, _] = sol.orientation().axes();
    ///     [x.produit_scalaire(point), y.produit_scalaire(point), -sol.distance()]
    /// };
    /// assert_eq!(le_long(sol), [3.0, -5.0, -2.0]);
    ///
    /// // A quarter turn of the floor about its normal, the same N: the pattern turns.
    /// let tourne = sol.rotation(Rotation::new(Vecteur::new(0.0, FRAC_PI_2, 0.0))?)?;
    /// assert_eq!(tourne.vers_ray(), sol.vers_ray());
    /// assert_eq!(le_long(tourne), [5.0, 3.0, -2.0]);
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("rotation", "tangent", "bitangent", "uv"))]
    pub fn orientation(&self) -> Rotation<R> {
        self.rotation
    }

    /// d, the relative distance to the origin O.
    #[doc(alias = "offset")]
    #[must_use]
    pub fn distance(&self) -> R {
        self.distance
    }

    /// The texture of the object.
    #[doc(alias = "material")]
    pub fn texture(&self) -> Texture {
        self.texture
    }

    /// The half-space whose surface passes through this point, with this outward normal of any
    /// length: a wall.
    ///
    /// You cannot choose how its pattern is turned about the normal;
    /// [`orientation`](Self::orientation) tells. Seen from outside, the first axis of any
    /// half-space points to the right where the second points up.
    ///
    /// # Errors
    /// If a coordinate of the point, or the distance to the origin, is beyond the limits of
    /// [`new`](Self::new), or if the normal is zero or not finite.
    ///
    /// ```
    /// use lancer_rayon::{PlanGeo, Texture, Vecteur};
    ///
    /// let (point, vers_la_piece) = (Vecteur::new(-3.0, 1.0, 0.0), Vecteur::new(2.0, 0.0, 0.0));
    /// let mur = PlanGeo::par_un_point(point, vers_la_piece, Texture(0))?.vers_ray();
    /// assert_eq!((mur.normale(), mur.distance()), (Vecteur::new(1.0, 0.0, 0.0), 3.0));
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("from_point_normal", "wall"))]
    pub fn par_un_point(
        p: Vecteur<R>,
        normale: Vecteur<R>,
        texture: Texture,
    ) -> Result<Self, ErreurGeo> {
        let p = position(["point.x", "point.y", "point.z"], p)?;
        let champs = ["normale", "normale.x", "normale.y", "normale.z"];
        let rotation = Rotation::de_z_vers(unitaire(champs, normale.vers_f64())?);
        Self::new(rotation, -rotation.axes()[2].produit_scalaire(p), texture)
    }

    /// The half-space moved by `v` (handout §2.3): d becomes d − N·v.
    ///
    /// # Errors
    /// If `v` is not finite, or the new distance lies outside the limits of [`new`](Self::new).
    #[doc(alias("translate", "move"))]
    pub fn translation(self, v: Vecteur<R>) -> Result<Self, ErreurGeo> {
        let distance = self.distance - self.rotation.axes()[2].produit_scalaire(deplacement(v)?);
        Self::new(self.rotation, distance, self.texture)
    }

    /// The half-space turned about the origin O (handout §2.3), which leaves d as it is.
    ///
    /// # Errors
    /// None today; the signature is that of the other shapes.
    #[doc(alias("rotate", "turn"))]
    pub fn rotation(self, r: Rotation<R>) -> Result<Self, ErreurGeo> {
        Self::new(self.rotation.puis(r), self.distance, self.texture)
    }

    /// The half-space itself: it has no dimension to multiply (handout §2.3).
    ///
    /// # Errors
    /// If the coefficient is not finite and above 0, as for the other shapes.
    #[doc(alias = "scale")]
    pub fn homothetie(self, k: R) -> Result<Self, ErreurGeo> {
        coefficient(k)?;
        Ok(self)
    }

    /// The same half-space in `f32`, seen from an origin that is subtracted before anything is
    /// rounded: see [`ObjetGeo::vers_f32`](crate::ObjetGeo::vers_f32).
    ///
    /// # Errors
    /// If `origine` is not finite, or if [`translation`](Self::translation) by −`origine` or
    /// [`new`](Self::new) with the numbers in `f32` fails.
    #[doc(alias("to_f32", "narrow", "floating_origin"))]
    pub fn vers_f32(self, origine: Vecteur<R>) -> Result<PlanGeo<f32>, ErreurGeo> {
        self.vers(origine)
    }

    /// The same in a scalar that is no wider.
    pub(crate) fn vers<Q: Nombre>(self, origine: Vecteur<R>) -> Result<PlanGeo<Q>, ErreurGeo> {
        let Self { rotation, distance, texture } = self.translation(-refus::origine(origine)?)?;
        PlanGeo::new(rotation.vers(), Q::depuis_f64(distance.vers_f64()), texture)
    }

    /// The same half-space, ready for rays (handout §3).
    #[doc(alias = "into_ray")]
    pub fn vers_ray(self) -> PlanRay<R> {
        // The outward normal was that of z ≤ 0 before the rotation.
        PlanRay { normale: self.rotation.axes()[2], distance: self.distance, texture: self.texture }
    }
}

/// A half-space ready for rays: its outward unit normal N and its relative distance d (handout §3).
/// Its points are those where N·X ≤ −d.
///
/// ```
/// use lancer_rayon::{PlanGeo, Rotation, Texture, Vecteur};
///
/// let fond = PlanGeo::new(Rotation::IDENTITE, 2.0, Texture(7))?.vers_ray();
/// let (n, d) = (fond.normale(), fond.distance());
/// assert!(n.produit_scalaire(Vecteur::new(5.0, 5.0, -3.0)) <= -d);
/// assert_eq!((n, d, fond.texture()), (Vecteur::new(0.0, 0.0, 1.0), 2.0, Texture(7)));
/// # Ok::<(), lancer_rayon::ErreurGeo>(())
/// ```
#[doc(alias("plane", "half_space"))]
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct PlanRay<R = f64> {
    normale: Vecteur<R>,
    distance: R,
    texture: Texture,
}

impl<R: Nombre> PlanRay<R> {
    /// N, the unit normal, outward.
    #[doc(alias = "normal")]
    pub fn normale(&self) -> Vecteur<R> {
        self.normale
    }

    /// d, the relative distance to the origin O: below 0 if and only if O is inside, and 0 on the
    /// surface.
    #[doc(alias = "offset")]
    #[must_use]
    pub fn distance(&self) -> R {
        self.distance
    }

    /// The texture of the object.
    #[doc(alias = "material")]
    pub fn texture(&self) -> Texture {
        self.texture
    }

    /// The same numbers in `f64`.
    pub(crate) fn temoin_f64(self) -> PlanRay {
        let (normale, distance) = (self.normale.vers_f64(), self.distance.vers_f64());
        PlanRay { normale, distance, texture: self.texture }
    }

    /// The height of S over the surface, and the descent of the ray per unit of length: the
    /// numerator and the denominator of annex A.1, both times −1.
    #[inline(always)]
    pub(crate) fn hauteur_et_descente(&self, rayon: &Rayon<R>) -> (R, R) {
        // H1: the height is above 0 outside, the descent for a ray that comes nearer.
        let hauteur = self.normale.produit_scalaire(rayon.source()) + self.distance;
        (hauteur, -self.normale.produit_scalaire(rayon.direction()))
    }
}

impl<R: Nombre> Forme<R> for PlanRay<R> {
    #[inline(always)]
    fn boule(&self) -> Boule<R> {
        Boule::INFINIE
    }

    fn boite_englobante(&self) -> Option<(Vecteur<R>, Vecteur<R>)> {
        None
    }

    /// Whether the ray enters the half-space: S is outside, and N·D < 0. There is no threshold: a
    /// ray that descends at all arrives, unless its distance overflows.
    #[inline(always)]
    fn peut_entrer(&self, rayon: &Rayon<R>) -> bool {
        let (hauteur, descente) = self.hauteur_et_descente(rayon);
        (descente > R::ZERO) & (hauteur > -rayon.flou.d_emblee())
    }

    /// t = (−d − N·S)/(N·D).
    #[inline(always)]
    fn t_et_contient(&self, rayon: &Rayon<R>) -> (R, bool) {
        let (hauteur, descente) = self.hauteur_et_descente(rayon);
        let touche = (descente > R::ZERO) & (hauteur > R::ZERO); // H2: it descends from outside
        let t = if touche { hauteur / descente } else { R::INFINI }; // H3: height over descent
        (t, hauteur <= R::ZERO)
    }

    /// No tree holds it: whoever leaves it out saves nothing.
    #[inline(always)]
    fn s_eloigne(&self, _: &Rayon<R>) -> bool {
        false
    }

    #[inline(always)]
    fn des_le_depart(&self, rayon: &Rayon<R>) -> bool {
        let (hauteur, _) = self.hauteur_et_descente(rayon);
        (hauteur <= R::ZERO) & self.peut_entrer(rayon) // D2: less deep than δ, and it descends
    }

    /// t = (−d − N·S)/(N·D), for a ray that climbs from inside: the entry into the other half of
    /// space.
    #[inline(always)]
    fn t_sortie(&self, rayon: &Rayon<R>) -> R {
        let (hauteur, descente) = self.hauteur_et_descente(rayon);
        // W3: it climbs from inside.
        if (descente < R::ZERO) & (hauteur < R::ZERO) { hauteur / descente } else { R::INFINI }
    }

    /// All but a ray that climbs from the surface itself.
    fn retient(&self, rayon: &Rayon<R>) -> bool {
        let (hauteur, descente) = self.hauteur_et_descente(rayon);
        (hauteur < R::ZERO) | (descente >= R::ZERO)
    }

    #[inline(always)]
    fn plan_tangent(&self, _: &Rayon<R>, _: R) -> (Vecteur<R>, R) {
        (self.normale, -self.distance)
    }
}
