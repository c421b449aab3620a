//! Conversions from and to the types of `mint`, through which glam, nalgebra and others exchange
//! their own.
//!
//! A matrix of `mint` multiplies a column from the left; that is how glam and nalgebra read it.
//! There a rotation has the transposed matrix Mᵀ, which turns vectors alike. `mint` itself makes
//! its matrices by rows from those by columns.

use mint::{ColumnMatrix3, Point3, Quaternion, Vector3};

use crate::algebre::vecteur::trois_coordonnees;
use crate::{ErreurGeo, Nombre, Rotation, Vecteur};

trois_coordonnees! { |x, y, z|
    /// The same three coordinates.
    ///
    /// ```
    /// use lancer_rayon::Vecteur;
    ///
    /// let v = mint::Vector3::from(Vecteur::new(1.0, 2.0, 3.0));
    /// assert_eq!((v.x, v.y, v.z), (1.0, 2.0, 3.0));
    /// assert_eq!(Vecteur::from(v), Vecteur::new(1.0, 2.0, 3.0));
    /// ```
    Vector3<R> => { Vector3 { x, y, z } }
    /// The same three coordinates.
    ///
    /// ```
    /// use lancer_rayon::Vecteur;
    ///
    /// let p = mint::Point3::from(Vecteur::new(1.0, 2.0, 3.0));
    /// assert_eq!((p.x, p.y, p.z), (1.0, 2.0, 3.0));
    /// assert_eq!(Vecteur::from(p), Vecteur::new(1.0, 2.0, 3.0));
    /// ```
    Point3<R> => { Point3 { x, y, z } }
}

/// Mᵀ, whose columns are the rows of M: what the axes become.
///
/// ```
/// use lancer_rayon::{Rotation, Vecteur};
///
/// let r = Rotation::new(Vecteur::new(0.1, 0.2, 0.3))?;
/// let colonnes = mint::ColumnMatrix3::from(r);
/// assert_eq!(Vecteur::from(colonnes.x), r.appliquer(Vecteur::X));
/// # Ok::<(), lancer_rayon::ErreurGeo>(())
/// ```
impl<R> From<Rotation<R>> for ColumnMatrix3<R> {
    fn from(r: Rotation<R>) -> Self {
        <[[R; 3]; 3]>::from(r).into()
    }
}

/// The rotation that turns as this matrix turns a column, as [`Rotation::depuis_matrice`] takes it:
/// column i is row i of M.
///
/// ```
/// use lancer_rayon::{Rotation, Vecteur};
///
/// // A quarter turn by the right-hand rule, from x to y.
/// let m = mint::ColumnMatrix3::from([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
/// assert_eq!(Rotation::try_from(m)?.appliquer(Vecteur::X), Vecteur::Y);
/// # Ok::<(), lancer_rayon::ErreurGeo>(())
/// ```
impl<R: Nombre> TryFrom<ColumnMatrix3<R>> for Rotation<R> {
    type Error = ErreurGeo;
    fn try_from(m: ColumnMatrix3<R>) -> Result<Self, ErreurGeo> {
        Self::depuis_matrice(m.into())
    }
}

/// The rotation of a quaternion, as [`Rotation::depuis_quaternion`] takes it.
///
/// ```
/// use lancer_rayon::{Rotation, Vecteur};
///
/// // A quarter turn by the right-hand rule, from x to y.
/// let q = mint::Quaternion { v: [0.0, 0.0, 1.0].into(), s: 1.0 };
/// assert_eq!(Rotation::try_from(q)?.appliquer(Vecteur::X), Vecteur::Y);
/// # Ok::<(), lancer_rayon::ErreurGeo>(())
/// ```
impl<R: Nombre> TryFrom<Quaternion<R>> for Rotation<R> {
    type Error = ErreurGeo;
    fn try_from(q: Quaternion<R>) -> Result<Self, ErreurGeo> {
        Self::depuis_quaternion(q.into())
    }
}
