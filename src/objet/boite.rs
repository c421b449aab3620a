//! The box (handout §2.2, §3 and annex A.3).

pub(crate) mod face;
mod quotient;

use crate::algebre::arrondis::{FLOU_A_COTE, FLOU_PROPRE};
use crate::algebre::nombre::{fois_u, puissance_de_deux, selon};
use crate::algebre::refus::{self, coefficient, deplacement, position, taille};
use crate::objet::boite::quotient::{Quotient, echelle_vitesse};
use crate::objet::forme::{Boule, Forme};
use crate::{ErreurGeo, Nombre, Rayon, Rotation, Texture, Vecteur};

/// The description of a box: its centre, its width, height and depth (along x, y and z before it is
/// turned) and the rotation that turns it about its centre (handout §2.2).
///
/// ```
/// use core::f64::consts::FRAC_PI_2;
/// use lancer_rayon::{BoiteGeo, Face, Rotation, Texture, Vecteur};
///
/// let marche = BoiteGeo::new(
///     Vecteur::new(0.0, 1.0, 0.0),
///     Vecteur::new(4.0, 2.0, 1.0),
///     Rotation::IDENTITE,
///     Texture(0),
/// )?;
/// let (centre, normale) = marche.vers_ray().face(Face::PlusX);
/// assert_eq!((centre, normale), (Vecteur::new(2.0, 1.0, 0.0), Vecteur::new(1.0, 0.0, 0.0)));
///
/// // Twice as large, a quarter turn about y, then back to where it stood.
/// let quart = Rotation::new(Vecteur::new(0.0, FRAC_PI_2, 0.0))?;
/// let grande = marche.homothetie(2.0)?.rotation(quart)?;
/// let grande = grande.translation(Vecteur::new(0.0, 1.0, 0.0))?.vers_ray();
/// assert_eq!(grande.centre(), Vecteur::new(0.0, 2.0, 0.0));
/// assert_eq!(grande.demi_longueurs(), [4.0, 2.0, 1.0]);
/// assert_eq!(grande.normales()[0], Vecteur::new(0.0, 0.0, 1.0));
/// # Ok::<(), lancer_rayon::ErreurGeo>(())
/// ```
#[doc(alias("box", "cuboid", "obb"))]
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct BoiteGeo<R = f64> {
    centre: Vecteur<R>,
    dimensions: Vecteur<R>,
    rotation: Rotation<R>,
    texture: Texture,
}

impl<R: Nombre> BoiteGeo<R> {
    /// C, the centre.
    #[doc(alias = "center")]
    pub fn centre(&self) -> Vecteur<R> {
        self.centre
    }

    /// The width, height and depth, along x, y and z before the box is turned.
    #[doc(alias("size", "extents"))]
    pub fn dimensions(&self) -> Vecteur<R> {
        self.dimensions
    }

    /// The rotation that turns the box about its centre; [`rotation`](Self::rotation) turns it on.
    #[doc(alias = "rotation")]
    pub fn orientation(&self) -> Rotation<R> {
        self.rotation
    }

    /// The texture of the object.
    #[doc(alias = "material")]
    pub fn texture(&self) -> Texture {
        self.texture
    }

    /// The box of this centre, these dimensions (width, height, depth) and this rotation.
    /// [`Rotation::entre`]`(Vecteur::Z, n)` turns its front towards a direction `n`.
    ///
    /// # Errors
    /// If a coordinate is beyond ±2⁴⁵⁰ (`f64`) or ±2⁶⁰ (`f32`), or a dimension outside 2⁻⁴⁵⁰ … 2⁴⁵⁰
    /// (`f64`) or 2⁻⁶⁰ … 2⁶⁰ (`f32`).
    pub fn new(
        centre: Vecteur<R>,
        dimensions: Vecteur<R>,
        rotation: Rotation<R>,
        texture: Texture,
    ) -> Result<Self, ErreurGeo> {
        Ok(Self {
            centre: position(["centre.x", "centre.y", "centre.z"], centre)?,
            dimensions: Vecteur::new(
                taille("dimensions.x", dimensions.x)?,
                taille("dimensions.y", dimensions.y)?,
                taille("dimensions.z", dimensions.z)?,
            ),
            rotation,
            texture,
        })
    }

    /// The box along the axes between two opposite corners, given in either order (handout §2.2).
    ///
    /// The centre is the mean of the corners and the dimensions are their differences, each rounded
    /// once, so that no other centre and dimensions bring both faces of a pair nearer to the
    /// corners.
    ///
    /// **Faces at one coordinate may not meet**, since a face lies where the centre and half of a
    /// dimension put it. Of neighbours that share a corner, with corners in whole centimetres up to
    /// ten metres and the metre as the unit, a third meet, a third leave a crack of up to some 10⁻¹⁵
    /// m (`f32`: 10⁻⁶ m), and a third overlap by as much. All meet if the corners are whole numbers
    /// below 2⁵¹ (`f32`: 2²²): take the width of a voxel as the unit of length. Otherwise let the
    /// solids overlap.
    ///
    /// # Errors
    /// If a coordinate of a corner is beyond the limits of [`new`](Self::new), or a dimension, the
    /// distance of the corners along an axis, is outside its limits, such as 0.
    ///
    /// ```
    /// use lancer_rayon::{BoiteGeo, Texture, Vecteur};
    ///
    /// let [coin, oppose] = [Vecteur::new(4.0, 0.0, 1.0), Vecteur::new(2.0, 3.0, 2.0)];
    /// let boite = BoiteGeo::entre_coins(coin, oppose, Texture(0))?;
    /// assert_eq!(boite.centre(), Vecteur::new(3.0, 1.5, 1.5));
    /// assert_eq!(boite.dimensions(), Vecteur::new(2.0, 3.0, 1.0));
    ///
    /// let plat = Vecteur::new(4.0, 3.0, 2.0);
    /// let erreur = BoiteGeo::entre_coins(coin, plat, Texture(0)).unwrap_err();
    /// assert_eq!(erreur.to_string(), "dimensions.x is 0.0, but must be a number above 0");
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("two_corners", "from_corners", "from_min_max", "min_max", "aabb", "voxel"))]
    pub fn entre_coins(
        coin: Vecteur<R>,
        oppose: Vecteur<R>,
        texture: Texture,
    ) -> Result<Self, ErreurGeo> {
        let coin = position(["coin.x", "coin.y", "coin.z"], coin)?;
        let oppose = position(["oppose.x", "oppose.y", "oppose.z"], oppose)?;
        let [x, y, z] = <[R; 3]>::from(oppose - coin).map(R::absolu);
        let centre = (coin + oppose) / (R::UN + R::UN);
        Self::new(centre, Vecteur::new(x, y, z), Rotation::IDENTITE, texture)
    }

    /// The box moved by `v` (handout §2.3).
    ///
    /// # Errors
    /// If `v` is not finite, or the new centre lies outside the limits of [`new`](Self::new).
    #[doc(alias("translate", "move"))]
    pub fn translation(self, v: Vecteur<R>) -> Result<Self, ErreurGeo> {
        Self::new(self.centre + deplacement(v)?, self.dimensions, self.rotation, self.texture)
    }

    /// The box turned about the origin O (handout §2.3): its centre moves, its faces turn.
    ///
    /// # Errors
    /// If the new centre lies outside the limits of [`new`](Self::new).
    #[doc(alias("rotate", "turn"))]
    pub fn rotation(self, r: Rotation<R>) -> Result<Self, ErreurGeo> {
        Self::new(r.appliquer(self.centre), self.dimensions, self.rotation.puis(r), self.texture)
    }

    /// The box of the same centre and dimensions `k` times as large (handout §2.3).
    ///
    /// # Errors
    /// If the coefficient is not finite and above 0, or a new dimension outside the limits of
    /// [`new`](Self::new).
    #[doc(alias = "scale")]
    pub fn homothetie(self, k: R) -> Result<Self, ErreurGeo> {
        Self::new(self.centre, self.dimensions * coefficient(k)?, self.rotation, self.texture)
    }

    /// The same box in `f32`, seen from an origin that is subtracted before anything is rounded:
    /// see [`ObjetGeo::vers_f32`](crate::ObjetGeo::vers_f32).
    ///
    /// # Errors
    /// If `origine` is not finite, or if [`translation`](Self::translation) by −`origine` or
    /// [`new`](Self::new) with the numbers in `f32` fails.
    #[doc(alias("to_f32", "narrow", "floating_origin"))]
    pub fn vers_f32(self, origine: Vecteur<R>) -> Result<BoiteGeo<f32>, ErreurGeo> {
        self.vers(origine)
    }

    /// The same in a scalar that is no wider.
    pub(crate) fn vers<Q: Nombre>(self, origine: Vecteur<R>) -> Result<BoiteGeo<Q>, ErreurGeo> {
        let Self { centre, dimensions, rotation, texture } =
            self.translation(-refus::origine(origine)?)?;
        let [centre, dimensions] = [centre, dimensions].map(|v| Vecteur::depuis_f64(v.vers_f64()));
        BoiteGeo::new(centre, dimensions, rotation.vers(), texture)
    }

    /// The same box, ready for rays (handout §3).
    #[doc(alias = "into_ray")]
    pub fn vers_ray(self) -> BoiteRay<R> {
        BoiteRay {
            centre: self.centre,
            normales: self.rotation.axes(),
            demi_longueurs: (self.dimensions / (R::UN + R::UN)).into(),
            texture: self.texture,
        }
    }
}

/// A box ready for rays (handout §3). The three faces are those that looked towards +x, +y and +z
/// before the box was turned; each array is in that order.
///
/// The handout stores 36 numbers. The centre, the three normals and the three half-lengths
/// determine the rest, and are all that an intersection reads.
///
/// ```
/// use lancer_rayon::{BoiteGeo, Face, Rotation, Texture, Vecteur};
///
/// let centre = Vecteur::new(1.0, 0.0, 0.0);
/// let boite = BoiteGeo::new(centre, Vecteur::new(4.0, 2.0, 6.0), Rotation::IDENTITE, Texture(7))?;
/// let boite = boite.vers_ray();
/// assert_eq!((boite.centre(), boite.texture()), (centre, Texture(7)));
/// assert_eq!(boite.normales()[0], Vecteur::new(1.0, 0.0, 0.0));
/// assert_eq!(boite.demi_longueurs(), [2.0, 1.0, 3.0]);
///
/// // From x = −1 to x = 3: the origin is inside both planes.
/// for (face, x, d) in [(Face::PlusX, 3.0, -3.0), (Face::MoinsX, -1.0, -1.0)] {
///     let (centre, normale) = boite.face(face);
///     assert_eq!(centre, Vecteur::new(x, 0.0, 0.0));
///     assert_eq!(-normale.produit_scalaire(centre), d);
/// }
/// # Ok::<(), lancer_rayon::ErreurGeo>(())
/// ```
#[doc(alias("box", "cuboid", "obb"))]
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct BoiteRay<R = f64> {
    centre: Vecteur<R>,
    normales: [Vecteur<R>; 3],
    demi_longueurs: [R; 3],
    texture: Texture,
}

impl<R: Nombre> BoiteRay<R> {
    /// C, the centre.
    #[doc(alias = "center")]
    pub fn centre(&self) -> Vecteur<R> {
        self.centre
    }

    /// N_i, the unit normals of the three faces, outward. Those of the opposite faces are −N_i.
    #[doc(alias = "normals")]
    pub fn normales(&self) -> [Vecteur<R>; 3] {
        self.normales
    }

    /// l_i, half the distance between each face and the opposite one. The corners are C ± l₁N₁ ±
    /// l₂N₂ ± l₃N₃.
    #[doc(alias("half_extents", "half_lengths", "corner", "vertex"))]
    #[must_use]
    pub fn demi_longueurs(&self) -> [R; 3] {
        self.demi_longueurs
    }

    /// The texture of the object.
    #[doc(alias = "material")]
    pub fn texture(&self) -> Texture {
        self.texture
    }

    /// The same numbers in `f64`.
    pub(crate) fn temoin_f64(self) -> BoiteRay {
        let (centre, normales) = (self.centre.vers_f64(), self.normales.map(Vecteur::vers_f64));
        let demi_longueurs = self.demi_longueurs.map(R::vers_f64);
        BoiteRay { centre, normales, demi_longueurs, texture: self.texture }
    }

    /// N_i and l_i of a pair of faces.
    #[inline(always)]
    pub(crate) fn paire(&self, axe: usize) -> (Vecteur<R>, R) {
        (self.normales[axe], self.demi_longueurs[axe])
    }

    /// N_i and l_i of all three pairs.
    #[inline(always)]
    fn paires(&self) -> [(Vecteur<R>, R); 3] {
        [self.paire(0), self.paire(1), self.paire(2)]
    }

    /// The entry and the exit of the ray between the two faces across this axis N, each l from the
    /// centre C.
    ///
    /// The axis points the way the ray goes. The speed is multiplied by [`echelle_vitesse`]; in
    /// `f32`, whose range does not hold every product of a length and a speed, it is rounded to a
    /// multiple of 2⁻¹⁰² before: only a speed below 2⁻⁷⁹ changes.
    #[inline(always)]
    fn dalle(&self, axe: usize, rayon: &Rayon<R>) -> (Quotient<R>, Quotient<R>) {
        let ((n, l), cs) = (self.paire(axe), rayon.source() - self.centre);
        let (o, vitesse) = (cs.produit_scalaire(n), rayon.direction().produit_scalaire(n));
        let o = if vitesse < R::ZERO { -o } else { o }; // B1: as if the axis were turned
        // The speed is rounded because it is scaled down to where numbers of `f32` are 2⁻¹⁴⁹ apart,
        // and up again. With a floor by minimum and maximum in its place a single ray takes up to
        // 1.3 times as long among boxes (measured).
        let descente = R::depuis_f64(selon::<R, _>(puissance_de_deux(-47), 1.0));
        // B2: so scaled that no product that is compared is lost.
        let vitesse = vitesse.absolu() * descente * (echelle_vitesse::<R>() / descente);
        (Quotient { longueur: -(l + o), vitesse }, Quotient { longueur: l - o, vitesse })
    }

    /// The last entry into the three pairs of faces, which pair that is, and the first exit.
    ///
    /// One pair has a speed of 0.5 or more, and with it an entry and an exit nearer than `loin`.
    #[inline(always)]
    fn dalles(&self, rayon: &Rayon<R>) -> (Quotient<R>, usize, Quotient<R>) {
        let (loin, vitesse) = (R::LIMITE * R::depuis_f64(8.0), echelle_vitesse());
        let mut entree = Quotient { longueur: -loin, vitesse };
        let mut sortie = Quotient { longueur: loin, vitesse };
        let mut axe_d_entree = 0; // B4: of equal entries the first axis counts
        for axe in 0..3 {
            let (e, s) = self.dalle(axe, rayon);
            if e.depasse(entree) {
                (entree, axe_d_entree) = (e, axe);
            }
            if sortie.depasse(s) {
                sortie = s;
            }
        }
        (entree, axe_d_entree, sortie)
    }

    /// The face across this axis that the ray comes to first: its normal and its distance from C.
    #[inline(always)]
    fn face_vers(&self, rayon: &Rayon<R>, axe: usize) -> (Vecteur<R>, R) {
        let [x, y, z] = self.paires();
        // By a match, since an index that differs between rays side by side would not be
        // vectorised. It comes after the loop over the axes: a batch that carried the pair through
        // that loop would take 2 to 4 % longer (measured).
        let (n, l) = match axe {
            0 => x,
            1 => y,
            _ => z,
        };
        (if n.produit_scalaire(rayon.direction()) > R::ZERO { -n } else { n }, l)
    }

    /// How high the source is over the nearest of the faces that the ray goes in by, and across
    /// which axis that face lies.
    #[inline(always)]
    fn face_de_depart(&self, rayon: &Rayon<R>) -> (R, usize) {
        let (mut hauteur, mut face) = (-R::INFINI, 0);
        for axe in 0..3 {
            let (e, _) = self.dalle(axe, rayon);
            if (e.vitesse > R::ZERO) & (e.longueur > hauteur) {
                (hauteur, face) = (e.longueur, axe);
            }
        }
        (hauteur, face)
    }

    /// δ and this many u of Σl_i: how deep a start may lie in the box by rounding.
    #[inline(always)]
    fn profond(&self, rayon: &Rayon<R>, propre: f64) -> R {
        let [a, b, c] = self.demi_longueurs;
        rayon.flou.d_emblee() + (a + b + c) * fois_u(propre)
    }
}

impl<R: Nombre> Forme<R> for BoiteRay<R> {
    /// The ball whose radius is half a diagonal of the box.
    #[inline(always)]
    fn boule(&self) -> Boule<R> {
        Boule { centre: self.centre, r2: Vecteur::from(self.demi_longueurs).longueur_carree() }
    }

    /// Σ|N_i|·l_i along each axis.
    fn boite_englobante(&self) -> Option<(Vecteur<R>, Vecteur<R>)> {
        let [(u, a), (v, b), (w, c)] = self.paires();
        let h = |x: R, y: R, z: R| x.absolu() * a + y.absolu() * b + z.absolu() * c;
        Some((self.centre, Vecteur::new(h(u.x, v.x, w.x), h(u.y, v.y, w.y), h(u.z, v.z, w.z))))
    }

    /// Half of the longest axis, as a vector.
    fn demi_axe(&self) -> Vecteur<R> {
        let [u, v, w] = self.paires();
        let plus_long = |a: (Vecteur<R>, R), b: (Vecteur<R>, R)| if b.1 > a.1 { b } else { a };
        let (n, l) = plus_long(plus_long(u, v), w);
        n * l
    }

    /// The last of the three entries, if it comes no later than the first of the three exits. Edges
    /// belong to the box.
    #[inline(always)]
    fn t_et_contient(&self, rayon: &Rayon<R>) -> (R, bool) {
        let (entree, _, sortie) = self.dalles(rayon);
        let entre = (entree.longueur > R::ZERO) & !entree.depasse(sortie);
        let contient = (entree.longueur <= R::ZERO) & (sortie.longueur >= R::ZERO);
        (if entre { entree.distance() } else { R::INFINI }, contient)
    }

    /// The source is beyond a face that the ray goes away from. That exit lies behind, and with it
    /// the first of the three.
    #[inline(always)]
    fn s_eloigne(&self, rayon: &Rayon<R>) -> bool {
        (0..3).fold(false, |loin, axe| loin | (self.dalle(axe, rayon).1.longueur < R::ZERO))
    }

    #[inline(always)]
    fn des_le_depart(&self, rayon: &Rayon<R>) -> bool {
        let (hauteur, face) = self.face_de_depart(rayon);
        let mut touche = (hauteur <= R::ZERO) & (hauteur > -self.profond(rayon, FLOU_PROPRE));
        // D3: a ray that leaves by another face as near as this, or goes along one, is nowhere
        // deeper in the box than that, and does not touch it.
        let a_cote = self.profond(rayon, FLOU_A_COTE);
        for axe in 0..3 {
            let (e, s) = self.dalle(axe, rayon);
            let loin = if axe == face { -hauteur } else { a_cote };
            touche &= (s.longueur >= loin) & ((e.vitesse > R::ZERO) | (-e.longueur >= loin));
        }
        touche
    }

    /// The first of the three exits, if it lies ahead and comes no sooner than the last of the
    /// three entries.
    #[inline(always)]
    fn t_sortie(&self, rayon: &Rayon<R>) -> R {
        let (entree, _, sortie) = self.dalles(rayon);
        // W4: the exit is ahead, and the line passes through the box.
        let sort = (sortie.longueur > R::ZERO) & !entree.depasse(sortie);
        if sort { sortie.distance() } else { R::INFINI }
    }

    /// False for a NaN, which would hide in the comparisons of quotients.
    #[inline(always)]
    fn contient(&self, point: Vecteur<R>) -> bool {
        let cp = point - self.centre;
        // `&` takes no branch.
        self.paires().into_iter().fold(true, |d, (n, l)| d & (cp.produit_scalaire(n).absolu() <= l))
    }

    #[inline(always)]
    fn plan_tangent(&self, rayon: &Rayon<R>, _: R) -> (Vecteur<R>, R) {
        self.face_vers(rayon, self.dalles(rayon).1)
    }

    /// The nearest of the faces that the ray goes in by.
    fn plan_de_depart(&self, rayon: &Rayon<R>) -> (Vecteur<R>, R) {
        self.face_vers(rayon, self.face_de_depart(rayon).1)
    }
}
