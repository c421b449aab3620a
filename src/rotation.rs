//! Rotations of space (handout §2.1).

use core::f64::consts::FRAC_PI_2;

use crate::reel::{Reel, simple};
use crate::refus::{ErreurGeo, exiger, fini};
use crate::vecteur::Vecteur;

/// A rotation about the origin O, held as its matrix M: a vector V, written as a row, becomes
/// V·M (handout §2.1).
///
/// However it was made, M is orthonormal to rounding: |M·Mᵀ − I| stays within 5.5u after any number
/// of compositions, and within 12u for an inverse and for a matrix that
/// [`depuis_matrice`](Self::depuis_matrice) keeps.
///
/// ```
/// use core::f64::consts::FRAC_PI_2;
/// use lancer_rayon::{Rotation, Vecteur};
///
/// // The worked example of §2.1: α about x sends (x, y, z) to (x, y cos α + z sin α, −y sin α + z cos α).
/// let quart = Rotation::new(Vecteur::new(FRAC_PI_2, 0.0, 0.0))?;
/// assert_eq!(quart.appliquer(Vecteur::new(1.0, 2.0, 3.0)), Vecteur::new(1.0, 3.0, -2.0));
///
/// let demi = quart.puis(quart);
/// assert_eq!(demi.puis(demi), Rotation::IDENTITE);
/// # Ok::<(), lancer_rayon::ErreurGeo>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "[[R; 3]; 3]", into = "[[R; 3]; 3]"))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "R: Reel + serde::Serialize")))]
#[cfg_attr(feature = "serde", serde(bound(deserialize = "R: Reel + serde::Deserialize<'de>")))]
#[must_use]
pub struct Rotation<R = f64> {
    matrice: [[R; 3]; 3],
}

/// A matrix in the type in which rotations are made; they are rounded once, at the end.
type Matrice = [[f64; 3]; 3];

const IDENTITE: Matrice = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// A matrix that is orthonormal to so many u is kept by [`Rotation::depuis_matrice`] (lemma 1).
pub const DEJA_ORTHONORMALE: f64 = 8.0;

/// How far M·Mᵀ may be from I for [`Rotation::depuis_matrice`] to take M: room for a rotation that is
/// written with four decimals, be they rounded or cut off (lemma 13).
const ECART: f64 = 1e-3;

const ANGLES: [&str; 3] = ["vecteur_rotation.x", "vecteur_rotation.y", "vecteur_rotation.z"];

/// The cosine and the sine of k quarter turns.
const QUARTS: [(f64, f64); 5] = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0), (1.0, 0.0)];

impl<R: Reel> Rotation<R> {
    /// The rotation that changes nothing.
    #[doc(alias = "identity")]
    pub const IDENTITE: Self = Self {
        matrice: [[R::UN, R::ZERO, R::ZERO], [R::ZERO, R::UN, R::ZERO], [R::ZERO, R::ZERO, R::UN]],
    };

    /// The rotation of a vecteur-rotation (handout §2.1): by r_x about the x axis, then r_y about
    /// y, then r_z about z, the axes staying where they are; M = M_x·M_y·M_z, angles in radians.
    ///
    /// The sense is that of the formula and of the worked example of §2.1: to an eye that looks
    /// the way the axis points, counter-clockwise. An angle that is the float nearest to k·π/2,
    /// |k| ≤ 4, as `90.0_f64.to_radians()` is, turns exactly. For the right-hand rule see
    /// [`main_droite`](Self::main_droite).
    ///
    /// # Errors
    /// If an angle is not finite.
    #[doc(alias("from_euler", "from_angles"))]
    pub fn new(vecteur_rotation: Vecteur<R>) -> Result<Self, ErreurGeo> {
        let r = fini(ANGLES, vecteur_rotation)?;
        let (cos, sin) = cos_sin(r.x);
        let m_x = [[1.0, 0.0, 0.0], [0.0, cos, -sin], [0.0, sin, cos]];
        let (cos, sin) = cos_sin(r.y);
        let m_y = [[cos, 0.0, sin], [0.0, 1.0, 0.0], [-sin, 0.0, cos]];
        let (cos, sin) = cos_sin(r.z);
        let m_z = [[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]];
        Ok(Self::arrondie(polie(produit(produit(m_x, m_y), m_z))))
    }

    /// The rotation of a vecteur-rotation by the right-hand rule, the thumb along the axis:
    /// `Rotation::new(-r)` with the three turns still in the order x, y, z.
    ///
    /// # Errors
    /// If an angle is not finite.
    ///
    /// ```
    /// use core::f64::consts::FRAC_PI_2;
    /// use lancer_rayon::{Rotation, Vecteur};
    ///
    /// let (r, x) = (Vecteur::new(0.0, 0.0, FRAC_PI_2), Vecteur::new(1.0, 0.0, 0.0));
    /// assert_eq!(Rotation::main_droite(r)?.appliquer(x), Vecteur::new(0.0, 1.0, 0.0));
    /// assert_eq!(Rotation::new(r)?.appliquer(x), Vecteur::new(0.0, -1.0, 0.0));
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias = "right_handed")]
    pub fn main_droite(vecteur_rotation: Vecteur<R>) -> Result<Self, ErreurGeo> {
        Self::new(-fini(ANGLES, vecteur_rotation)?)
    }

    /// The rotation of matrix M, rows first, for instance one that [`matrice`](Self::matrice)
    /// gave, which comes back bit for bit.
    ///
    /// A matrix that is orthonormal to 8u, by its rows and by its columns, is kept; any other is
    /// replaced by the nearest rotation. So four decimals are enough, in either type.
    ///
    /// # Errors
    /// If an element of M is not finite, if one of M·Mᵀ − I exceeds 1e-3, or if M is a mirror
    /// (determinant below 0).
    ///
    /// ```
    /// use lancer_rayon::{Rotation, Vecteur};
    ///
    /// let ecrite = [[0.8660, -0.5, 0.0], [0.5, 0.8660, 0.0], [0.0, 0.0, 1.0]];
    /// let r = Rotation::depuis_matrice(ecrite)?;
    /// assert!((r.axes()[0].longueur() - 1.0).abs() < 1e-15);
    /// assert!((r.matrice()[0][0] - 0.75_f64.sqrt()).abs() < 1e-4);
    ///
    /// let agrandie = ecrite.map(|ligne| ligne.map(|x| 1.01 * x));
    /// assert_eq!(Rotation::depuis_matrice(agrandie).unwrap_err().champ, "matrice: |M·Mᵀ - I|");
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("from_matrix", "from_mat3", "from_rows"))]
    pub fn depuis_matrice(matrice: [[R; 3]; 3]) -> Result<Self, ErreurGeo> {
        const CHAMPS: [[&str; 3]; 3] = [
            ["matrice[0][0]", "matrice[0][1]", "matrice[0][2]"],
            ["matrice[1][0]", "matrice[1][1]", "matrice[1][2]"],
            ["matrice[2][0]", "matrice[2][1]", "matrice[2][2]"],
        ];
        for (champs, ligne) in CHAMPS.into_iter().zip(matrice) {
            let _: Vecteur<R> = fini(champs, ligne.into())?;
        }
        let mut m = matrice.map(|ligne| ligne.map(R::vers_f64));
        let lignes = plus_grand_defaut(m);
        let attendu = "at most 1e-3, as for a rotation";
        exiger(lignes <= ECART, "matrice: |M·Mᵀ - I|", lignes, attendu)?;
        let [x, y, z] = m.map(Vecteur::from);
        let determinant = x.produit_vectoriel(y).produit_scalaire(z);
        let attendu = "above 0: a mirror is no rotation";
        exiger(determinant > 0.0, "matrice: determinant", determinant, attendu)?;
        // The columns may be three times as far off as the rows, and are the rows of the inverse.
        if lignes.max(plus_grand_defaut(transposee(m))) <= DEJA_ORTHONORMALE * R::U.vers_f64() {
            return Ok(Self { matrice });
        }
        // Each step squares what is missing: from 1e-3, three reach the last bit of an f64.
        for _ in 0..3 {
            m = polie(m);
        }
        Ok(Self::arrondie(m))
    }

    /// A rotation that takes z to this direction; none for a vector that is zero or not finite.
    pub(crate) fn de_z_vers(direction: Vecteur<R>) -> Option<Self> {
        let z = direction.vers_f64().unitaire()?;
        // Of x and y the axis that lies farther from it.
        let axe = usize::from(z.x.abs() > z.y.abs());
        let x = Vecteur::from(IDENTITE[axe]).produit_vectoriel(z).unitaire()?;
        Some(Self::arrondie(polie([x, z.produit_vectoriel(x), z].map(<[f64; 3]>::from))))
    }

    /// V·M, the vector V turned.
    #[doc(alias("rotate", "apply"))]
    pub fn appliquer(self, v: Vecteur<R>) -> Vecteur<R> {
        let [a, b, c] = self.axes();
        a * v.x + b * v.y + c * v.z
    }

    /// This rotation, then `suivante`: the product of the matrices in this order.
    #[doc(alias("then", "compose"))]
    pub fn puis(self, suivante: Self) -> Self {
        let [m, n] = [self, suivante].map(|r| r.matrice.map(|ligne| ligne.map(R::vers_f64)));
        Self::arrondie(polie(produit(m, n)))
    }

    /// The rotation that undoes this one.
    #[doc(alias = "transpose")]
    pub fn inverse(self) -> Self {
        Self { matrice: transposee(self.matrice) }
    }

    /// M, rows first.
    ///
    /// ```
    /// use lancer_rayon::{Rotation, Vecteur};
    ///
    /// let r = Rotation::new(Vecteur::new(0.1, 0.2, 0.3))?;
    /// assert_eq!(Rotation::depuis_matrice(r.matrice())?, r);
    ///
    /// let transposee = core::array::from_fn(|i| r.matrice().map(|ligne| ligne[i]));
    /// assert_eq!(r.inverse().matrice(), transposee);
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias = "matrix")]
    #[must_use]
    pub fn matrice(self) -> [[R; 3]; 3] {
        self.matrice
    }

    /// The rows of M: what the axes x, y and z become.
    ///
    /// Those of a half-space, by [`PlanGeo::orientation`](crate::PlanGeo::orientation), are two unit
    /// vectors in its surface and its normal.
    #[doc(alias("rows", "basis"))]
    pub fn axes(self) -> [Vecteur<R>; 3] {
        self.matrice.map(Vecteur::from)
    }

    /// The same rotation in `f32`, each element rounded.
    pub(crate) fn vers_f32(self) -> Rotation<f32> {
        Rotation { matrice: self.matrice.map(|ligne| ligne.map(simple)) }
    }

    fn arrondie(m: Matrice) -> Self {
        Self { matrice: m.map(|ligne| ligne.map(R::depuis_f64)) }
    }
}

impl<R: Reel> Default for Rotation<R> {
    /// The identity.
    fn default() -> Self {
        Self::IDENTITE
    }
}

impl<R: Reel> TryFrom<[[R; 3]; 3]> for Rotation<R> {
    type Error = ErreurGeo;
    fn try_from(matrice: [[R; 3]; 3]) -> Result<Self, ErreurGeo> {
        Self::depuis_matrice(matrice)
    }
}

impl<R> From<Rotation<R>> for [[R; 3]; 3] {
    fn from(r: Rotation<R>) -> Self {
        r.matrice
    }
}

/// The cosine and sine of an angle; exact at the float nearest to k quarter turns, |k| ≤ 4, so that
/// a scene turned by quarter turns stays aligned with the axes.
fn cos_sin<R: Reel>(angle: R) -> (f64, f64) {
    for (k, (cos, sin)) in QUARTS.into_iter().enumerate() {
        if angle.abs() == R::depuis_f64(k as f64 * FRAC_PI_2) {
            return (cos, if angle < R::ZERO { -sin } else { sin });
        }
    }
    let angle = angle.vers_f64();
    (libm::cos(angle), libm::sin(angle))
}

fn transposee<T: Copy>(m: [[T; 3]; 3]) -> [[T; 3]; 3] {
    core::array::from_fn(|i| core::array::from_fn(|j| m[j][i]))
}

fn produit(m: Matrice, n: Matrice) -> Matrice {
    m.map(|[a, b, c]| core::array::from_fn(|j| a * n[0][j] + b * n[1][j] + c * n[2][j]))
}

/// I − M·Mᵀ.
fn defaut(m: Matrice) -> Matrice {
    let carre = produit(m, transposee(m));
    core::array::from_fn(|i| core::array::from_fn(|j| IDENTITE[i][j] - carre[i][j]))
}

/// The largest element of |M·Mᵀ − I|. Of a finite M none on the diagonal is a NaN, and where another is,
/// by an overflow, one on the diagonal is +∞.
fn plus_grand_defaut(m: Matrice) -> f64 {
    defaut(m).into_iter().flatten().map(f64::abs).fold(0.0, f64::max)
}

/// One Newton step towards the nearest orthonormal matrix: M + (I − M·Mᵀ)·M/2.
///
/// A product of rotations is off by a rounding or two; without the step, composing a million
/// of them adds a million roundings up.
fn polie(m: Matrice) -> Matrice {
    let correction = produit(defaut(m), m);
    core::array::from_fn(|i| core::array::from_fn(|j| m[i][j] + correction[i][j] / 2.0))
}
