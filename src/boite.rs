//! The box (handout §2.2, §3 and annex A.3).

use crate::boule::approche;
use crate::erreur::{coefficient, deplacement, point, taille};
use crate::{ErreurGeo, Intersection, Rayon, Reel, Rotation, Texture, Vecteur};

/// A box as one describes it: its centre, its width, height and depth (along x, y and z before
/// it is turned) and the rotation that turns it about its centre (handout §2.2).
///
/// ```
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
#[doc(alias = "box")]
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

    /// Whether the ray comes near the box, which costs no division.
    #[inline(always)]
    pub(crate) fn possible(&self, s: Vecteur<R>, d: Vecteur<R>) -> bool {
        let demi_diagonale = Vecteur::from(self.demi_longueurs);
        approche(self.centre, demi_diagonale.longueur_carree(), s, d)
    }

    /// Where the ray crosses one pair of faces, in the axes of the box with C as the origin, the
    /// axis turned to go with the ray.
    ///
    /// A ray parallel to the pair divides by +0: the quotients are then ±∞ on the right sides, or
    /// 0/0 in the plane of a face.
    #[inline(always)]
    fn dalle(&self, axe: usize, s: Vecteur<R>, d: Vecteur<R>) -> (R, R) {
        let (n, l) = (self.normales[axe], self.demi_longueurs[axe]);
        let (o, v) = ((s - self.centre).produit_scalaire(n), d.produit_scalaire(n));
        let o = if v < R::ZERO { -o } else { o };
        (-(l + o) / v.abs(), (l - o) / v.abs())
    }

    /// The last entry of the ray, the pair of faces that it is of, and the first exit.
    ///
    /// Every comparison with a NaN is false, so that 0/0 constrains nothing.
    #[inline(always)]
    fn dalles(&self, s: Vecteur<R>, d: Vecteur<R>) -> (R, usize, R) {
        let (mut derniere_entree, mut face, mut premiere_sortie) = (-R::INFINI, 0, R::INFINI);
        for axe in 0..3 {
            let (entree, sortie) = self.dalle(axe, s, d);
            if entree > derniere_entree {
                (derniere_entree, face) = (entree, axe);
            }
            if sortie < premiere_sortie {
                premiere_sortie = sortie;
            }
        }
        (derniere_entree, face, premiere_sortie)
    }

    /// The distance of the entry, +∞ if the ray has none: the last of the three entries, if it
    /// comes no later than the first of the three exits. Edges belong to the box.
    #[inline(always)]
    pub(crate) fn t(&self, s: Vecteur<R>, d: Vecteur<R>) -> R {
        let (entree, _, sortie) = self.dalles(s, d);
        if (entree > R::ZERO) & (entree <= sortie) { entree } else { R::INFINI }
    }

    /// The hit that the search found at distance `t`, computed in `f64`.
    pub(crate) fn conclure(&self, rayon: &Rayon<R>, t: R) -> Intersection<R> {
        let d = rayon.direction();
        let large = self.vers_f64();
        let (entree, axe, _) = large.dalles(rayon.source().vers_f64(), d.vers_f64());
        // The face must be one that the ray enters, N·D < 0, as the search sees it as well.
        let vitesse = |axe: usize| self.normales[axe].produit_scalaire(d);
        let vitesse_large = self.normales[axe].vers_f64().produit_scalaire(d.vers_f64());
        let d_accord = entree > 0.0 && vitesse(axe).vers_f64() * vitesse_large > 0.0;
        let (entree, axe) =
            if d_accord { (entree, axe) } else { self.entree_selon_la_recherche(rayon) };
        let t = R::conclure(t, || entree);
        let normale = self.normales[axe];
        let normale = if vitesse(axe) > R::ZERO { -normale } else { normale };
        Intersection::new(rayon, t, normale, self.texture, |p| {
            let (n, cp) = (normale.vers_f64(), p - large.centre);
            let hauteur = n.produit_scalaire(cp) - self.demi_longueurs[axe].vers_f64();
            (hauteur.abs(), n.produit_des_grandeurs(cp))
        })
    }

    /// The face that the search entered by, and in f64 the distance there.
    #[cold]
    fn entree_selon_la_recherche(&self, rayon: &Rayon<R>) -> (f64, usize) {
        let (s, d) = (rayon.source(), rayon.direction());
        let (_, axe, _) = self.dalles(s, d);
        let (entree, _) = self.vers_f64().dalle(axe, s.vers_f64(), d.vers_f64());
        (entree, axe)
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
