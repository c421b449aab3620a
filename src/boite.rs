//! The box (handout §2.2, §3 and annex A.3).

use crate::boule::approche;
use crate::erreur::{coefficient, deplacement, point, taille};
use crate::objet::Forme;
use crate::{ErreurGeo, Intersection, Rayon, Reel, Rotation, Texture, Vecteur};

/// A box as one describes it: its centre, its width, height and depth (along x, y and z before
/// it is turned) and the rotation that turns it about its centre (handout §2.2).
///
/// ```
/// use core::f64::consts::FRAC_PI_2;
/// use lancer_rayon::{BoiteGeo, Rotation, Texture, Vecteur};
///
/// let marche = BoiteGeo::new(
///     Vecteur::new(0.0, 1.0, 0.0),
///     Vecteur::new(4.0, 2.0, 1.0),
///     Rotation::IDENTITE,
///     Texture(0),
/// )?;
/// let faces = marche.vers_ray().centres_faces();
/// assert_eq!(faces[0], Vecteur::new(2.0, 1.0, 0.0));
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
#[doc(alias = "box")]
#[doc(alias = "cuboid")]
#[doc(alias = "obb")]
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "BoiteBrute<R>"))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "R: Reel + serde::Serialize")))]
#[cfg_attr(feature = "serde", serde(bound(deserialize = "R: Reel + serde::Deserialize<'de>")))]
#[must_use]
pub struct BoiteGeo<R = f64> {
    centre: Vecteur<R>,
    dimensions: Vecteur<R>,
    rotation: Rotation<R>,
    texture: Texture,
}

impl<R: Reel> BoiteGeo<R> {
    /// The box of this centre, these dimensions (width, height, depth) and this rotation.
    ///
    /// # Errors
    /// If a coordinate is beyond ±2⁴⁵⁰ (`f64`) or ±2⁶⁰ (`f32`), or a dimension outside
    /// 2⁻⁴⁵⁰ … 2⁴⁵⁰ or 2⁻⁶⁰ … 2⁶⁰.
    pub fn new(
        centre: Vecteur<R>,
        dimensions: Vecteur<R>,
        rotation: Rotation<R>,
        texture: Texture,
    ) -> Result<Self, ErreurGeo> {
        Ok(Self {
            centre: point(["centre.x", "centre.y", "centre.z"], centre)?,
            dimensions: Vecteur::new(
                taille("dimensions.x (largeur)", dimensions.x)?,
                taille("dimensions.y (hauteur)", dimensions.y)?,
                taille("dimensions.z (profondeur)", dimensions.z)?,
            ),
            rotation,
            texture,
        })
    }

    /// The box moved by `v` (handout §2.3).
    ///
    /// # Errors
    /// If `v` is not finite, or the new centre lies outside the limits of [`new`](Self::new).
    #[doc(alias = "translate")]
    pub fn translation(self, v: Vecteur<R>) -> Result<Self, ErreurGeo> {
        let v = deplacement(v)?;
        Self::new(self.centre + v, self.dimensions, self.rotation, self.texture)
    }

    /// The box turned about the origin O (handout §2.3): its centre moves, its faces turn.
    ///
    /// # Errors
    /// If the new centre lies outside the limits of [`new`](Self::new).
    #[doc(alias = "rotate")]
    pub fn rotation(self, r: Rotation<R>) -> Result<Self, ErreurGeo> {
        let centre = r.appliquer(self.centre);
        Self::new(centre, self.dimensions, self.rotation.puis(r), self.texture)
    }

    /// The box of the same centre and dimensions `k` times as large (handout §2.3).
    ///
    /// # Errors
    /// If the coefficient is not finite and above 0, or a new dimension outside the limits of
    /// [`new`](Self::new).
    #[doc(alias = "scale")]
    pub fn homothetie(self, k: R) -> Result<Self, ErreurGeo> {
        let dimensions = self.dimensions * coefficient(k)?;
        Self::new(self.centre, dimensions, self.rotation, self.texture)
    }

    /// The same box, ready for rays (handout §3).
    #[doc(alias = "into_ray")]
    #[inline]
    pub fn vers_ray(self) -> BoiteRay<R> {
        let Vecteur { x, y, z } = self.dimensions;
        BoiteRay {
            centre: self.centre,
            normales: self.rotation.axes(),
            demi_longueurs: [x, y, z].map(|l| l / (R::UN + R::UN)),
            texture: self.texture,
        }
    }
}

/// A box ready for rays (handout §3). The three faces are those that looked towards +x, +y and
/// +z before the box was turned; each array is in that order.
///
/// The handout stores 36 numbers. The centre, the three normals and the three half-lengths
/// determine the rest, and are all that an intersection reads.
///
/// ```
/// use lancer_rayon::{BoiteGeo, Rotation, Texture, Vecteur};
///
/// let centre = Vecteur::new(1.0, 0.0, 0.0);
/// let boite = BoiteGeo::new(centre, Vecteur::new(4.0, 2.0, 6.0), Rotation::IDENTITE, Texture(7))?;
/// let boite = boite.vers_ray();
/// assert_eq!((boite.centre(), boite.texture()), (centre, Texture(7)));
/// assert_eq!(boite.normales()[0], Vecteur::new(1.0, 0.0, 0.0));
/// assert_eq!(boite.demi_longueurs(), [2.0, 1.0, 3.0]);
///
/// // From x = −1 to x = 3: the origin is inside both planes.
/// assert_eq!(boite.centres_faces()[0], Vecteur::new(3.0, 0.0, 0.0));
/// assert_eq!(boite.centres_opposes()[0], Vecteur::new(-1.0, 0.0, 0.0));
/// assert_eq!((boite.distances_faces()[0], boite.distances_opposees()[0]), (-3.0, -1.0));
/// # Ok::<(), lancer_rayon::ErreurGeo>(())
/// ```
#[doc(alias = "box")]
#[doc(alias = "cuboid")]
#[doc(alias = "obb")]
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct BoiteRay<R = f64> {
    centre: Vecteur<R>,
    normales: [Vecteur<R>; 3],
    demi_longueurs: [R; 3],
    texture: Texture,
}

impl<R: Reel> BoiteRay<R> {
    /// C, the centre.
    #[doc(alias = "center")]
    #[inline]
    pub fn centre(&self) -> Vecteur<R> {
        self.centre
    }

    /// N_i, the unit normals of the three faces, outward. Those of the opposite faces are −N_i.
    #[doc(alias = "normals")]
    #[inline]
    pub fn normales(&self) -> [Vecteur<R>; 3] {
        self.normales
    }

    /// l_i, half the distance between each face and the opposite one.
    #[doc(alias = "half_extents")]
    #[inline]
    #[must_use]
    pub fn demi_longueurs(&self) -> [R; 3] {
        self.demi_longueurs
    }

    /// Cf_i = C + l_i·N_i, the centres of the three faces.
    #[doc(alias = "face_centers")]
    pub fn centres_faces(&self) -> [Vecteur<R>; 3] {
        core::array::from_fn(|i| self.centre + self.normales[i] * self.demi_longueurs[i])
    }

    /// Co_i = C − l_i·N_i, the centres of the opposite faces.
    #[doc(alias = "opposite_face_centers")]
    pub fn centres_opposes(&self) -> [Vecteur<R>; 3] {
        core::array::from_fn(|i| self.centre - self.normales[i] * self.demi_longueurs[i])
    }

    /// df_i = −N_i·Cf_i, the relative distances to the origin of the planes of the three faces.
    #[doc(alias = "face_distances")]
    #[must_use]
    pub fn distances_faces(&self) -> [R; 3] {
        let centres = self.centres_faces();
        core::array::from_fn(|i| -self.normales[i].produit_scalaire(centres[i]))
    }

    /// do_i = N_i·Co_i, the relative distances to the origin of the planes of the opposite
    /// faces, whose normals are −N_i.
    #[doc(alias = "opposite_face_distances")]
    #[must_use]
    pub fn distances_opposees(&self) -> [R; 3] {
        let centres = self.centres_opposes();
        core::array::from_fn(|i| self.normales[i].produit_scalaire(centres[i]))
    }

    /// The texture of the object.
    #[inline]
    pub fn texture(&self) -> Texture {
        self.texture
    }

    /// How far the ray is from both faces of one pair, and its speed towards them: the entry is the
    /// first over the third, the exit the second over the third. C is the origin, and the axis
    /// goes with the ray. For a D that is [`accelere`](Self::accelere) the speed is as many times larger.
    #[inline(always)]
    fn dalle(&self, axe: usize, s: Vecteur<R>, d: Vecteur<R>) -> (R, R, R) {
        let (n, l) = (self.normales[axe], self.demi_longueurs[axe]);
        let (o, v) = ((s - self.centre).produit_scalaire(n), d.produit_scalaire(n));
        let o = if v < R::ZERO { -o } else { o };
        (-(l + o), l - o, v.abs().au_plancher())
    }

    /// D times a power of two, so that no cross product of a length and a speed leaves the normal
    /// range: a length here is 0 or, as a difference of two rounded numbers, at least u/2 of a
    /// half-length, which a speed as small as a subnormal component of D would carry below it.
    #[inline(always)]
    fn accelere(d: Vecteur<R>) -> Vecteur<R> {
        d * R::ECHELLE_VITESSE
    }

    /// The time of an entry or an exit: a length over a speed of an [`accelere`](Self::accelere) D.
    /// The length is scaled, not the quotient, which could be subnormal.
    #[inline(always)]
    fn temps((longueur, vitesse): (R, R)) -> R {
        longueur * R::ECHELLE_VITESSE / vitesse
    }

    /// The last entry of the ray, its pair of faces, and the first exit; entry and exit as quotients
    /// not divided yet, whose [`temps`](Self::temps) is the distance. D is
    /// [`accelere`](Self::accelere).
    ///
    /// They are compared by cross products, since one division costs more than all of these. It
    /// makes a ray parallel to a pair right as well: beside it the entry is +∞ or the exit −∞, and
    /// in the plane of a face 0/0 is neither above nor below anything. Of the three pairs one has a
    /// speed of 0.5 or more, and with it an entry and an exit nearer than `loin`.
    #[inline(always)]
    fn dalles(&self, s: Vecteur<R>, d: Vecteur<R>) -> ((R, R), usize, (R, R)) {
        let loin = R::LIMITE * R::depuis_f64(8.0);
        let k = R::ECHELLE_VITESSE;
        let (mut entree, mut face, mut sortie) = ((-loin, k), 0, (loin, k));
        for axe in 0..3 {
            let (vers_entree, vers_sortie, v) = self.dalle(axe, s, d);
            if vers_entree * entree.1 > entree.0 * v {
                (entree, face) = ((vers_entree, v), axe);
            }
            if vers_sortie * sortie.1 < sortie.0 * v {
                sortie = (vers_sortie, v);
            }
        }
        (entree, face, sortie)
    }

    #[inline(always)]
    fn toucher(&self, rayon: &Rayon<R>, t: R, entree: f64, axe: usize) -> Intersection<R> {
        let t = R::preciser(t, || entree);
        let (normale, l) = self.couple(axe);
        let vitesse = normale.produit_scalaire(rayon.direction());
        let normale = if vitesse > R::ZERO { -normale } else { normale };
        Intersection::new(rayon, t, normale, self.texture, |p| {
            let (n, cp) = (normale.vers_f64(), p - self.centre.vers_f64());
            let hauteur = n.produit_scalaire(cp) - l.vers_f64();
            (hauteur.abs(), n.somme_des_grandeurs(cp))
        })
    }

    /// N_i and l_i, chosen without an index, so that rays side by side may choose differently.
    #[inline(always)]
    fn couple(&self, axe: usize) -> (Vecteur<R>, R) {
        let [x, y, z] = self.normales;
        let [lx, ly, lz] = self.demi_longueurs;
        match axe {
            0 => (x, lx),
            1 => (y, ly),
            _ => (z, lz),
        }
    }

    #[inline(always)]
    fn vers_f64(&self) -> BoiteRay<f64> {
        BoiteRay {
            centre: self.centre.vers_f64(),
            normales: self.normales.map(Vecteur::vers_f64),
            demi_longueurs: self.demi_longueurs.map(R::vers_f64),
            texture: self.texture,
        }
    }
}

impl<R: Reel> Forme<R> for BoiteRay<R> {
    #[inline(always)]
    fn boule(&self) -> (Vecteur<R>, R) {
        (self.centre, Vecteur::from(self.demi_longueurs).longueur_carree())
    }

    #[inline(always)]
    fn possible(&self, s: Vecteur<R>, d: Vecteur<R>) -> bool {
        // Named first: written in its place, it costs a ray alone a tenth of its time.
        let demi_diagonale = Vecteur::from(self.demi_longueurs);
        approche(self.centre, demi_diagonale.longueur_carree(), s, d)
    }

    /// The last of the three entries, if it comes no later than the first of the three exits. Edges
    /// belong to the box.
    #[inline(always)]
    fn t(&self, s: Vecteur<R>, d: Vecteur<R>) -> R {
        let (entree, _, sortie) = self.dalles(s, Self::accelere(d));
        let touche = (entree.0 > R::ZERO) & (entree.0 * sortie.1 <= sortie.0 * entree.1);
        if touche { Self::temps(entree) } else { R::INFINI }
    }

    /// Sure, unless `f64` names a face by which the search does not see the ray enter, N·D < 0.
    #[inline(always)]
    fn conclure(&self, rayon: &Rayon<R>, t: R) -> (Intersection<R>, bool) {
        let (s, d) = (rayon.source().vers_f64(), rayon.direction().vers_f64());
        let (entree, axe, _) = self.vers_f64().dalles(s, BoiteRay::accelere(d));
        let (normale, _) = self.couple(axe);
        let vitesse = normale.produit_scalaire(rayon.direction()).vers_f64();
        let d_accord = vitesse * normale.vers_f64().produit_scalaire(d) > 0.0;
        (self.toucher(rayon, t, BoiteRay::temps(entree), axe), (entree.0 > 0.0) & d_accord)
    }

    /// On the face that the search entered by.
    #[cold]
    fn reprendre(&self, rayon: &Rayon<R>, t: R) -> Intersection<R> {
        let (s, d) = (rayon.source(), rayon.direction());
        let (_, axe, _) = self.dalles(s, Self::accelere(d));
        let d = BoiteRay::accelere(d.vers_f64());
        let (vers_entree, _, v) = self.vers_f64().dalle(axe, s.vers_f64(), d);
        self.toucher(rayon, t, BoiteRay::temps((vers_entree, v)), axe)
    }
}

#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
#[serde(rename = "BoiteGeo")]
#[serde(bound(deserialize = "R: Reel + serde::Deserialize<'de>"))]
struct BoiteBrute<R> {
    centre: Vecteur<R>,
    dimensions: Vecteur<R>,
    rotation: Rotation<R>,
    texture: Texture,
}

#[cfg(feature = "serde")]
impl<R: Reel> TryFrom<BoiteBrute<R>> for BoiteGeo<R> {
    type Error = ErreurGeo;
    fn try_from(brute: BoiteBrute<R>) -> Result<Self, ErreurGeo> {
        Self::new(brute.centre, brute.dimensions, brute.rotation, brute.texture)
    }
}
