//! The six faces of a box, and where on one of them a hit lies, from which patterns are made.

use core::fmt;

use crate::algebre::arrondis::BORD;
use crate::algebre::nombre::{fois_u, max, min};
use crate::{BoiteRay, ErreurGeo, Intersection, Nombre, Rayon, Vecteur};

/// A face of a box, by the side to which it looked before the box was turned: `PlusY` was its top.
///
/// The first three are the faces of the handout (§3), in the order of
/// [`normales`](BoiteRay::normales); the last three are the opposite ones, in the same order.
/// `face as usize` is the index in [`TOUTES`](Self::TOUTES), and in any other array of six.
/// Displayed, a face is its sign and its axis; `serde` writes the name of the variant.
///
/// ```
/// use lancer_rayon::Face;
///
/// assert_eq!(Face::TOUTES.map(|face| face.to_string()), ["+x", "+y", "+z", "-x", "-y", "-z"]);
/// ```
#[doc(alias("side", "top", "bottom", "left", "right", "front", "back"))]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[must_use]
pub enum Face {
    /// The face that looked towards +x, to the right.
    PlusX,
    /// The face that looked towards +y, up.
    PlusY,
    /// The face that looked towards +z, at the viewer.
    PlusZ,
    /// The face that looked towards −x, to the left.
    MoinsX,
    /// The face that looked towards −y, down.
    MoinsY,
    /// The face that looked towards −z, away from the viewer.
    MoinsZ,
}

impl Face {
    /// All six faces.
    #[doc(alias = "all")]
    pub const TOUTES: [Self; 6] =
        [Self::PlusX, Self::PlusY, Self::PlusZ, Self::MoinsX, Self::MoinsY, Self::MoinsZ];

    /// The two coordinates of a point in the box's own axes, as [`BoiteRay::lieu`] gives it, along
    /// this face: to the right and up, as the face is seen from outside. Text therefore reads as it
    /// should on each of the six.
    ///
    /// Multiply the point by the half-lengths first, and text keeps its shape. Up is y on the four
    /// sides, −z on the top (`PlusY`) and +z on the bottom, which both have x to the right.
    ///
    /// ```
    /// use lancer_rayon::{Face, Vecteur};
    ///
    /// let p = Vecteur::new(0.25, 0.5, 1.0);
    /// assert_eq!(Face::PlusZ.le_long(p), [0.25, 0.5]);
    /// // To an eye behind the box its right is on the left.
    /// assert_eq!(Face::MoinsZ.le_long(Vecteur::new(0.25, 0.5, -1.0)), [-0.25, 0.5]);
    /// ```
    #[doc(alias("uv", "texture_coordinates"))]
    #[must_use]
    pub fn le_long<R: Nombre>(self, p: Vecteur<R>) -> [R; 2] {
        match self {
            Self::PlusX => [-p.z, p.y],
            Self::PlusY => [p.x, -p.z],
            Self::PlusZ => [p.x, p.y],
            Self::MoinsX => [p.z, p.y],
            Self::MoinsY => [p.x, p.z],
            Self::MoinsZ => [-p.x, p.y],
        }
    }

    /// The point at this place of the face, without the coordinate across it: the way back from
    /// [`le_long`](Self::le_long).
    fn place<R: Nombre>(self, [u, v]: [R; 2]) -> [R; 3] {
        match self {
            Self::PlusX => [R::ZERO, v, -u],
            Self::PlusY => [u, R::ZERO, -v],
            Self::PlusZ => [u, v, R::ZERO],
            Self::MoinsX => [R::ZERO, v, u],
            Self::MoinsY => [u, R::ZERO, v],
            Self::MoinsZ => [-u, v, R::ZERO],
        }
    }
}

impl fmt::Display for Face {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // `pad` keeps to a width.
        f.pad(["+x", "+y", "+z", "-x", "-y", "-z"][*self as usize])
    }
}

impl<R: Nombre> BoiteRay<R> {
    /// Where a hit on this box lies: the face, and the point in the box's own axes, from −1 to 1
    /// between opposite faces. Across the face the coordinate is exactly 1 or −1; the two along it
    /// are [`Face::le_long`].
    ///
    /// A pattern therefore does not speckle across a face. The coordinate across the face does not
    /// waver about the edge of a cell of a pattern in space, and no coordinate leaves [−1, 1] or is
    /// a NaN. Multiplied by [`demi_longueurs`](Self::demi_longueurs) the point is in scene units
    /// from the centre. The point turns, moves and grows with the box.
    ///
    /// The face is that of [`touche.normale()`](Intersection::normale), at an edge as well. The
    /// coordinates along it are those of S + tD, with t the distance as reported, to 6.1u(|S − C| +
    /// t) over the half-length, so that the pattern of a small box far from O is steady too. Where
    /// rounding beside an edge would take them beyond ±1 they are ±1.
    ///
    /// The other way round, a place makes a hit by [`vers_lieu`](Self::vers_lieu).
    ///
    /// `touche` must be a hit of this ray on this box. For any other hit the answer is some face
    /// and some point of it.
    ///
    /// ```
    /// use lancer_rayon::{BoiteGeo, Face, ObjetRay, Rayon, Rotation, Texture, Vecteur};
    ///
    /// let cotes = Vecteur::new(4.0, 2.0, 6.0);
    /// let boite = BoiteGeo::new(Vecteur::NUL, cotes, Rotation::IDENTITE, Texture(0))?.vers_ray();
    /// let rayon = Rayon::new(Vecteur::new(1.0, 5.0, 1.5), Vecteur::new(0.0, -1.0, 0.0))?;
    /// let touche = ObjetRay::from(boite).intersection(&rayon)?;
    ///
    /// let (face, p) = boite.lieu(&rayon, &touche);
    /// assert_eq!((face, p), (Face::PlusY, Vecteur::new(0.5, 1.0, 0.5)));
    /// assert_eq!(face.le_long(p), [0.5, -0.5]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("uv", "texture_coordinates", "which_face", "local_point", "sensor", "anchor"))]
    pub fn lieu(&self, rayon: &Rayon<R>, touche: &Intersection<R>) -> (Face, Vecteur<R>) {
        // The normal of a hit is that of a face, or leans from it by some u: one cosine is near ±1.
        let cosinus = self.normales().map(|n| n.produit_scalaire(touche.normale()));
        let [x, y, z] = cosinus.map(R::absolu);
        let axe = if x >= y && x >= z { 0 } else { 1 + usize::from(z > y) };
        let face = Face::TOUTES[if cosinus[axe] < R::ZERO { axe + 3 } else { axe }];
        // Relative to the source: S + tD − C would lose what S and C have in common (lemma 6).
        let p = (rayon.source() - self.centre()) + rayon.direction() * touche.distance();
        let mut p = self.paires().map(|(n, l)| {
            // A hit on something else may give a NaN, which becomes a limit as well.
            max(min(p.produit_scalaire(n) / l, R::UN), -R::UN)
        });
        p[axe] = if cosinus[axe] < R::ZERO { -R::UN } else { R::UN };
        (face, p.into())
    }

    /// The ray from within that leaves the box at this place, along the normal of the face: [u, v]
    /// as [`Face::le_long`] gives them. What is nearer to an edge than 40u of ‖C‖₁ and Σl_i, beyond
    /// it, or a NaN, becomes a place just within: where the centre is known less well than the box
    /// is large, the middle of the face. So subtract an origin first from what is far away.
    ///
    /// Its [`sortie`](crate::ObjetRay::sortie) is a hit at the place, from which rays start as from
    /// any other: a sensor, a patch, a point of a lamp. [`lieu`](Self::lieu) of that ray and hit
    /// gives the place back, to rounding, unless it was so moved. A box no thicker than
    /// some u of ‖C‖₁ and Σl_i may have no way out by this face.
    ///
    /// **In a box that [`temoin_f64`](crate::ObjetRay::temoin_f64) has widened** the axes are at
    /// right angles to the rounding of `f32` only: the ray to a place nearer to an edge than 40u of
    /// `f32` of ‖C‖₁ and Σl_i may leave by the face across the edge, or find no way out.
    ///
    /// # Errors
    /// If the middle of the box, moved along the face, lies outside the limits of [`Rayon::new`].
    ///
    /// ```
    /// use lancer_rayon::{BoiteGeo, Face, ObjetRay, Rotation, Texture, Vecteur};
    ///
    /// let cotes = Vecteur::new(4.0, 2.0, 6.0);
    /// let boite = BoiteGeo::new(Vecteur::NUL, cotes, Rotation::IDENTITE, Texture(0))?.vers_ray();
    ///
    /// let rayon = boite.vers_lieu(Face::PlusY, [0.5, -0.5])?;
    /// let capteur = ObjetRay::from(boite).sortie(&rayon)?;
    /// assert_eq!((capteur.point(), capteur.normale()), (Vecteur::new(1.0, 1.0, 1.5), Vecteur::Y));
    /// let (face, p) = boite.lieu(&rayon, &capteur);
    /// assert_eq!((face, face.le_long(p)), (Face::PlusY, [0.5, -0.5]));
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("from_uv", "sample", "sensor", "patch", "area_light"))]
    pub fn vers_lieu(&self, face: Face, uv: [R; 2]) -> Result<Rayon<R>, ErreurGeo> {
        let [a, b, c] = self.demi_longueurs();
        let bord = (self.centre().norme_1() + a + b + c) * fois_u(BORD);
        let du_milieu = self.paires().into_iter().zip(face.place(uv)).map(|((n, l), p)| {
            let limite = max(R::UN - bord / l, R::ZERO);
            n * (l * max(min(p, limite), -limite))
        });
        Rayon::new(self.centre() + du_milieu.sum(), self.face(face).1)
    }

    /// The centre of a face, C ± l_i·N_i, and its outward unit normal N = ±N_i: Cf_i or Co_i of the
    /// handout (§3). Its df_i or do_i, the relative distance of the plane of the face, is −N·(C
    /// ± l_i·N_i).
    #[doc(alias("face_center", "face_normal"))]
    pub fn face(&self, face: Face) -> (Vecteur<R>, Vecteur<R>) {
        let (n, l) = self.paires()[face as usize % 3];
        let n = if (face as usize) < 3 { n } else { -n };
        (self.centre() + n * l, n)
    }
}
