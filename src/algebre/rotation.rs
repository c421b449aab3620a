//! Rotations of space (handout §2.1).

use core::f64::consts::FRAC_PI_2;

use crate::algebre::arrondis::DEJA_ORTHONORMALE;
use crate::algebre::refus::{exiger, fini, finis, unitaire};
use crate::{ErreurGeo, Nombre, Vecteur};

/// A rotation about the origin O, held as its matrix M: a vector V, written as a row, becomes V·M
/// (handout §2.1).
///
/// However it was made, M is orthonormal to rounding: |M·Mᵀ − I| stays within 5.5u after any number
/// of compositions, and within 12u for an inverse and for a matrix that
/// [`depuis_matrice`](Self::depuis_matrice) keeps.
///
/// ```
/// use core::f64::consts::FRAC_PI_2;
/// use lancer_rayon::{Rotation, Vecteur};
///
/// // The worked example of §2.1: α about x sends (x, y, z) to
/// // (x, y cos α + z sin α, −y sin α + z cos α).
/// let quart = Rotation::new(Vecteur::new(FRAC_PI_2, 0.0, 0.0))?;
/// assert_eq!(quart.appliquer(Vecteur::new(1.0, 2.0, 3.0)), Vecteur::new(1.0, 3.0, -2.0));
///
/// let demi = quart.puis(quart);
/// assert_eq!(demi.puis(demi), Rotation::IDENTITE);
/// # Ok::<(), lancer_rayon::ErreurGeo>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(into = "[[R; 3]; 3]"))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "R: Nombre + serde::Serialize")))]
#[must_use]
pub struct Rotation<R = f64> {
    matrice: [[R; 3]; 3],
}

/// A matrix in the type in which rotations are made; they are rounded once, at the end.
type Matrice<T = f64> = [[T; 3]; 3];

/// How far M·Mᵀ may be from I for [`Rotation::depuis_matrice`] to take M: room for a rotation that
/// is written with four decimals, be they rounded or cut off (lemma 13).
const ECART: f64 = 1e-3;

/// The largest sine of the angle between two directions that are parallel, in u (lemma 13).
const PARALLELES: f64 = 16.0;

const ANGLES: [&str; 3] = ["vecteur_rotation.x", "vecteur_rotation.y", "vecteur_rotation.z"];

/// The cosine and the sine of k quarter turns.
const QUARTS: [(f64, f64); 5] = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0), (1.0, 0.0)];

impl<R: Nombre> Rotation<R> {
    /// The rotation that changes nothing.
    #[doc(alias = "identity")]
    pub const IDENTITE: Self = Self {
        matrice: [[R::UN, R::ZERO, R::ZERO], [R::ZERO, R::UN, R::ZERO], [R::ZERO, R::ZERO, R::UN]],
    };

    /// The rotation of a vecteur-rotation (handout §2.1): by r_x about the x axis, then r_y about
    /// y, then r_z about z, the axes staying where they are; M = M_x·M_y·M_z, angles in radians.
    ///
    /// The sense is that of the formula and of the worked example of §2.1: clockwise as the axis
    /// points at you. Each element is off by at most its rounding and 15u of `f64`.
    /// An angle that is the float nearest to k·π/2, |k| ≤ 4, as `90.0_f64.to_radians()` is, turns
    /// exactly. For the right-hand rule see [`main_droite`](Self::main_droite).
    ///
    /// # Errors
    /// If an angle is not finite.
    #[doc(alias("from_euler", "from_angles"))]
    pub fn new(vecteur_rotation: Vecteur<R>) -> Result<Self, ErreurGeo> {
        let r = fini(ANGLES, vecteur_rotation)?;
        Ok(Self::arrondie(trois_tours([r.x, r.y, r.z].map(cos_sin))))
    }

    /// The rotation of a vecteur-rotation by the right-hand rule, the thumb along the axis:
    /// `Rotation::new(-r)` with the three turns still in the order x, y, z. In glam it is
    /// `from_euler(EulerRot::ZYX, z, y, x)`, in nalgebra `from_euler_angles(x, y, z)`.
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

    /// The rotation of a matrix M, given row by row. One that [`matrice`](Self::matrice) gave comes
    /// back bit for bit.
    ///
    /// A matrix whose rows and columns are orthonormal to 8u, as computed in `f64`, is kept; any
    /// other is replaced by the nearest rotation, so that four decimals are enough in either type.
    ///
    /// # Errors
    /// If an element of M is not finite, if one of M·Mᵀ − I exceeds 1e-3, or if M is a mirror
    /// (determinant below 0).
    ///
    /// ```
    /// use lancer_rayon::{Rotation, Vecteur};
    ///
    /// let ecrite = [[0.8660_f64, -0.5, 0.0], [0.5, 0.8660, 0.0], [0.0, 0.0, 1.0]];
    /// let r = Rotation::depuis_matrice(ecrite)?;
    /// assert!((r.axes()[0].longueur() - 1.0).abs() < 1e-15);
    /// assert!((r.matrice()[0][0] - 0.75_f64.sqrt()).abs() < 1e-4);
    ///
    /// let agrandie = ecrite.map(|ligne| ligne.map(|x| 1.01 * x));
    /// assert_eq!(Rotation::depuis_matrice(agrandie).unwrap_err().champ, "matrice");
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
            finis(champs, ligne)?;
        }
        let mut m = matrice.map(|ligne| ligne.map(R::vers_f64));
        let lignes = plus_grand_defaut(m);
        let attendu = "at most 1e-3 in each element of M·Mᵀ - I, as a rotation";
        exiger(lignes <= ECART, "matrice", lignes, attendu)?;
        let [x, y, z] = m.map(Vecteur::from);
        let determinant = x.produit_vectoriel(y).produit_scalaire(z);
        let attendu = "above 0 in its determinant: a mirror is no rotation";
        exiger(determinant > 0.0, "matrice", determinant, attendu)?;
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

    /// The rotation by this angle about this axis, which may have any length, in the sense of
    /// [`new`](Self::new): about x by α it is `new((α, 0, 0))`, and quarter turns about the three
    /// axes are exact. Each element is off by at most its rounding and 15u of `f64`, where a float
    /// that [`new`](Self::new) takes for quarter turns stands for these.
    ///
    /// The right-hand rule, which `from_axis_angle` of other crates follows, turns by −α, or about
    /// the opposite axis.
    ///
    /// # Errors
    /// If the axis is zero, or if a number is not finite.
    ///
    /// ```
    /// use core::f64::consts::FRAC_PI_2;
    /// use lancer_rayon::{Rotation, Vecteur};
    ///
    /// let r = Rotation::autour_de(Vecteur::Z * 2.0, FRAC_PI_2)?;
    /// assert_eq!(r, Rotation::new(Vecteur::new(0.0, 0.0, FRAC_PI_2))?);
    /// assert_eq!(r.appliquer(Vecteur::X), -Vecteur::Y);
    ///
    /// let main_droite = Rotation::autour_de(Vecteur::Z, -FRAC_PI_2)?;
    /// assert_eq!(main_droite.appliquer(Vecteur::X), Vecteur::Y);
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("axis_angle", "from_axis_angle", "from_scaled_axis"))]
    pub fn autour_de(axe: Vecteur<R>, angle: R) -> Result<Self, ErreurGeo> {
        let n = unitaire(["axe", "axe.x", "axe.y", "axe.z"], axe.vers_f64())?;
        let angle = exiger(angle.absolu() < R::INFINI, "angle", angle, "a finite number")?;
        Ok(Self::arrondie(tour_autour(n, cos_sin(angle))))
    }

    /// The rotation of the quaternion q = \[x, y, z, w\], w being its real part: a vector V becomes
    /// q·V·q⁻¹, so that (sin(α/2)·N, cos(α/2)) turns by α about the unit vector N by the right-hand
    /// rule. q and −q give the same rotation, and any length will do. Each element is off by its
    /// rounding and 15u of `f64` at most.
    ///
    /// This is what `q * v` is in glam and in nalgebra, and the order is that of `q.to_array()` in
    /// glam and of `q.coords` in nalgebra.
    ///
    /// # Errors
    /// If a number is not finite, or if all four are zero.
    ///
    /// ```
    /// use core::f64::consts::FRAC_1_SQRT_2;
    /// use lancer_rayon::{Rotation, Vecteur};
    ///
    /// let quart_autour_de_z = Rotation::depuis_quaternion([0.0, 0.0, FRAC_1_SQRT_2, FRAC_1_SQRT_2])?;
    /// assert_eq!(quart_autour_de_z.appliquer(Vecteur::X), Vecteur::Y);
    /// assert_eq!(quart_autour_de_z, Rotation::depuis_quaternion([0.0, 0.0, -7.0, -7.0])?);
    /// assert_eq!(Rotation::depuis_quaternion([0.0; 4]).unwrap_err().champ, "quaternion");
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("from_quat", "from_quaternion", "from_xyzw"))]
    pub fn depuis_quaternion(quaternion: [R; 4]) -> Result<Self, ErreurGeo> {
        let champs = ["quaternion.x", "quaternion.y", "quaternion.z", "quaternion.w"];
        let q = finis(champs, quaternion)?.map(R::vers_f64);
        let grand = q.into_iter().map(f64::abs).fold(0.0, f64::max);
        exiger(grand > 0.0, "quaternion", grand, "other than 0")?;
        Ok(Self::arrondie(tour_du_quaternion(q.map(|nombre| nombre / grand))))
    }

    /// The shortest turn that takes the direction `de` to the direction `vers`, both of any length:
    /// `appliquer(de)` has the direction of `vers` to 36u.
    ///
    /// Many half turns join opposite directions. Where the sine of the angle between `de` and
    /// −`vers` is 16u or less, rounding would choose the axis. The axis is then at a right angle to
    /// `vers` and to whichever of x and y lies farther from `vers` (x if both are equally far).
    ///
    /// # Errors
    /// If a direction is zero or not finite.
    ///
    /// ```
    /// use lancer_rayon::{Rotation, Vecteur};
    ///
    /// let r: Rotation = Rotation::entre(Vecteur::X, Vecteur::Y * 3.0)?;
    /// assert_eq!(r.appliquer(Vecteur::X), Vecteur::Y);
    /// assert_eq!(r.appliquer(Vecteur::Z), Vecteur::Z);
    ///
    /// let demi_tour: Rotation = Rotation::entre(Vecteur::Z, -Vecteur::Z)?;
    /// assert_eq!(demi_tour.axes(), [-Vecteur::X, Vecteur::Y, -Vecteur::Z]);
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("from_rotation_arc", "rotation_between", "shortest_arc"))]
    pub fn entre(de: Vecteur<R>, vers: Vecteur<R>) -> Result<Self, ErreurGeo> {
        let a = unitaire(["de", "de.x", "de.y", "de.z"], de.vers_f64())?;
        let b = unitaire(["vers", "vers.x", "vers.y", "vers.z"], vers.vers_f64())?;
        Ok(Self::arrondie(tour_vers(a, b, PARALLELES * R::U.vers_f64())))
    }

    /// The rotation of a camera that looks along `direction` and holds `haut` upright. It takes −z,
    /// along which an unturned camera looks, to `direction`, y to the vector nearest to `haut` at a
    /// right angle to `direction`, and x to what is then on the right. Both vectors may have any
    /// length. `direction` is met to 6.2u, and x is at a right angle to `haut` to 14u.
    ///
    /// Its inverse, from the scene to the camera, is what `look_to` of other crates gives.
    ///
    /// # Errors
    /// If a vector is zero or not finite, or if the sine of the angle between them is 16u or less,
    /// since `haut` then names no upward side.
    ///
    /// ```
    /// use lancer_rayon::{Rotation, Vecteur};
    ///
    /// let (camera, cible) = (Vecteur::new(5.0, 1.0, 0.0), Vecteur::new(0.0, 1.0, 0.0));
    /// let r = Rotation::regard(cible - camera, Vecteur::Y)?;
    /// assert_eq!(r.axes(), [-Vecteur::Z, Vecteur::Y, Vecteur::X]);
    ///
    /// let erreur = Rotation::<f64>::regard(Vecteur::Y, -Vecteur::Y).unwrap_err();
    /// assert_eq!(erreur.champ, "haut");
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("look_at", "look_to", "camera"))]
    pub fn regard(direction: Vecteur<R>, haut: Vecteur<R>) -> Result<Self, ErreurGeo> {
        let champs = ["direction", "direction.x", "direction.y", "direction.z"];
        let d = unitaire(champs, direction.vers_f64())?;
        let k =
            d.produit_vectoriel(unitaire(["haut", "haut.x", "haut.y", "haut.z"], haut.vers_f64())?);
        let (sinus, attendu) = (k.longueur(), "above 16u in the sine of its angle with direction");
        exiger(sinus > PARALLELES * R::U.vers_f64(), "haut", sinus, attendu)?;
        Ok(Self::arrondie(tour_de_camera(d, k)))
    }

    /// A rotation that takes z to this unit vector.
    pub(crate) fn de_z_vers(z: Vecteur) -> Self {
        let x = a_cote(z);
        let x = x / x.longueur();
        Self::arrondie(polie([x, z.produit_vectoriel(x), z].map(<[f64; 3]>::from)))
    }

    /// V·M, the vector V turned.
    #[doc(alias("rotate", "apply"))]
    #[inline]
    pub fn appliquer(self, v: Vecteur<R>) -> Vecteur<R> {
        let [a, b, c] = self.axes();
        a * v.x + b * v.y + c * v.z
    }

    /// This rotation, then `suivante`: the product of the matrices in this order, each element to
    /// 24u, or to 39u if one of both is an [`inverse`](Self::inverse) or was kept by
    /// [`depuis_matrice`](Self::depuis_matrice).
    #[doc(alias("then", "compose"))]
    pub fn puis(self, suivante: Self) -> Self {
        let [m, n] = [self, suivante].map(|r| r.matrice.map(|ligne| ligne.map(R::vers_f64)));
        Self::arrondie(composee(m, n))
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
    /// Those of a half-space, by [`PlanGeo::orientation`](crate::PlanGeo::orientation), are two
    /// unit vectors in its surface and its normal.
    #[doc(alias("rows", "basis"))]
    pub fn axes(self) -> [Vecteur<R>; 3] {
        self.matrice.map(Vecteur::from)
    }

    /// The same rotation in a scalar that is no wider, each element rounded.
    pub(crate) fn vers<Q: Nombre>(self) -> Rotation<Q> {
        Rotation::arrondie(self.matrice.map(|ligne| ligne.map(R::vers_f64)))
    }

    fn arrondie(m: Matrice) -> Self {
        Self { matrice: m.map(|ligne| ligne.map(R::depuis_f64)) }
    }
}

impl<R: Nombre> Default for Rotation<R> {
    /// The identity.
    fn default() -> Self {
        Self::IDENTITE
    }
}

impl<R: Nombre> TryFrom<[[R; 3]; 3]> for Rotation<R> {
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
fn cos_sin<R: Nombre>(angle: R) -> (f64, f64) {
    for (k, (cos, sin)) in QUARTS.into_iter().enumerate() {
        if angle.absolu() == R::depuis_f64(k as f64 * FRAC_PI_2) {
            return (cos, if angle < R::ZERO { -sin } else { sin });
        }
    }
    let angle = angle.vers_f64();
    (libm::cos(angle), libm::sin(angle))
}

/// The turns about x, y and z, one after the other, by angles of these cosines and sines.
///
/// This and the other makers of matrices are run in `f64`, and by tests in a scalar that records.
pub fn trois_tours<T: Nombre>([x, y, z]: [(T, T); 3]) -> Matrice<T> {
    let (nul, un) = (T::ZERO, T::UN);
    let (cos, sin) = x;
    let m_x = [[un, nul, nul], [nul, cos, -sin], [nul, sin, cos]];
    let (cos, sin) = y;
    let m_y = [[cos, nul, sin], [nul, un, nul], [-sin, nul, cos]];
    let (cos, sin) = z;
    let m_z = [[cos, -sin, nul], [sin, cos, nul], [nul, nul, un]];
    polie(produit(produit(m_x, m_y), m_z))
}

/// The turn about a unit vector by the angle of this cosine and sine.
pub fn tour_autour<T: Nombre>(n: Vecteur<T>, (cos, sin): (T, T)) -> Matrice<T> {
    polie(tour(cos, T::UN - cos, n, n * -sin))
}

/// The turn of a quaternion whose largest number is ±1.
pub fn tour_du_quaternion<T: Nombre>([x, y, z, w]: [T; 4]) -> Matrice<T> {
    let (v, deux) = (Vecteur::new(x, y, z), T::UN + T::UN);
    let (v2, w2) = (v.longueur_carree(), w * w);
    polie(tour((w2 - v2) / (w2 + v2), deux / (w2 + v2), v, v * (deux * w / (w2 + v2))))
}

/// The shortest turn from the unit vector a to the unit vector b. Where these are opposite and
/// their sine is no more than `paralleles`, it chooses the axis.
pub fn tour_vers<T: Nombre>(a: Vecteur<T>, b: Vecteur<T>, paralleles: T) -> Matrice<T> {
    if a.produit_scalaire(b) >= T::ZERO {
        return polie(arc(a, b));
    }
    // Near a half turn the axis is known only to u over the sine of the angle, though it must be at
    // a right angle to b to u. So this composes two turns: the short one to −b, and a half turn
    // about an axis at a right angle to b.
    let k = a.produit_vectoriel(b);
    let k = if k.longueur() > paralleles { k } else { a_cote(b) };
    let axe = b.produit_vectoriel(au_dessus(b, k));
    let demi_tour = tour(-T::UN, T::UN + T::UN, axe, Vecteur::NUL);
    polie(produit(arc(a, -b), demi_tour))
}

/// The turn of a camera that looks along the unit vector d and has k = d ∧ h on its right.
pub fn tour_de_camera<T: Nombre>(d: Vecteur<T>, k: Vecteur<T>) -> Matrice<T> {
    let y = au_dessus(d, k);
    polie([d.produit_vectoriel(y), y, -d].map(<[T; 3]>::from))
}

/// The first turn, then the second.
pub fn composee<T: Nombre>(m: Matrice<T>, n: Matrice<T>) -> Matrice<T> {
    polie(produit(m, n))
}

/// A vector at a right angle to this unit vector and to whichever of x and y lies farther from it;
/// no shorter than √½.
fn a_cote<T: Nombre>(v: Vecteur<T>) -> Vecteur<T> {
    let axe = if v.x.absolu() > v.y.absolu() { Vecteur::Y } else { Vecteur::X };
    axe.produit_vectoriel(v)
}

/// The unit vector at a right angle to the unit vector d and to k, along k ∧ d. k may be as short
/// as `PARALLELES` u: this is at a right angle to d all the same.
fn au_dessus<T: Nombre>(d: Vecteur<T>, k: Vecteur<T>) -> Vecteur<T> {
    let y = k.produit_vectoriel(d);
    y / y.longueur()
}

/// The matrix of the turn V ↦ a·V + b·(v·V)·v + e ∧ V: its rows are what the axes become.
fn tour<T: Nombre>(a: T, b: T, v: Vecteur<T>, e: Vecteur<T>) -> Matrice<T> {
    let axes = [(Vecteur::X, v.x), (Vecteur::Y, v.y), (Vecteur::Z, v.z)];
    axes.map(|(axe, v_i)| (axe * a + v * (b * v_i) + e.produit_vectoriel(axe)).into())
}

/// The shortest turn from a unit vector to another, at most a right angle away.
fn arc<T: Nombre>(de: Vecteur<T>, vers: Vecteur<T>) -> Matrice<T> {
    let (cos, k) = (de.produit_scalaire(vers), de.produit_vectoriel(vers));
    tour(cos, T::UN / (T::UN + cos), k, k)
}

fn transposee<T: Copy>(m: Matrice<T>) -> Matrice<T> {
    core::array::from_fn(|i| core::array::from_fn(|j| m[j][i]))
}

fn produit<T: Nombre>(m: Matrice<T>, n: Matrice<T>) -> Matrice<T> {
    m.map(|[a, b, c]| core::array::from_fn(|j| a * n[0][j] + b * n[1][j] + c * n[2][j]))
}

/// I − M·Mᵀ.
fn defaut<T: Nombre>(m: Matrice<T>) -> Matrice<T> {
    let (un, carre) = (Rotation::<T>::IDENTITE.matrice, produit(m, transposee(m)));
    core::array::from_fn(|i| core::array::from_fn(|j| un[i][j] - carre[i][j]))
}

/// The largest element of |M·Mᵀ − I|. For a finite M none on the diagonal is a NaN; where overflow
/// makes another a NaN, one on the diagonal is +∞.
fn plus_grand_defaut(m: Matrice) -> f64 {
    defaut(m).into_iter().flatten().map(f64::abs).fold(0.0, f64::max)
}

/// One Newton step towards the nearest orthonormal matrix: M + (I − M·Mᵀ)·M/2.
///
/// A product of rotations is off by a rounding or two; without the step, composing a million of
/// them would add up a million roundings.
fn polie<T: Nombre>(m: Matrice<T>) -> Matrice<T> {
    let correction = produit(defaut(m), m);
    core::array::from_fn(|i| core::array::from_fn(|j| m[i][j] + correction[i][j] / (T::UN + T::UN)))
}
