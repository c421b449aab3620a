//! The numbers that are refused, and the error that names them.

use core::fmt;

use crate::algebre::nombre::selon;
use crate::{Nombre, Vecteur};

/// A number outside the accepted range, with the field it was given for.
///
/// Constructors and transformations of rays, lights, rotations and objects return it, and so do the
/// rays from a hit.
///
/// ```
/// use lancer_rayon::{SphereGeo, Texture, Vecteur};
///
/// let erreur = SphereGeo::new(Vecteur::NUL, -1.0, Texture(0)).unwrap_err();
/// assert_eq!(erreur.champ, "rayon");
/// assert_eq!(erreur.valeur, -1.0);
/// assert_eq!(erreur.attendu, "a number above 0");
/// assert_eq!(erreur.to_string(), "rayon is -1.0, but must be a number above 0");
/// ```
#[doc(alias = "error")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ErreurGeo {
    /// The field or argument, for instance `"centre.x"`.
    #[doc(alias = "field")]
    pub champ: &'static str,
    /// The value that the field would have had, or what was computed of it, as the determinant of a
    /// matrix. An `f32` is converted exactly.
    #[doc(alias = "value")]
    pub valeur: f64,
    /// What would have been accepted, as the end of the sentence "it must be …".
    #[doc(alias = "expected")]
    pub attendu: &'static str,
}

impl fmt::Display for ErreurGeo {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // As `Debug` writes it, with an exponent: the 136 digits of 2^450 would hide the sentence.
        let Self { champ, valeur, attendu } = self;
        write!(f, "{champ} is {valeur:?}, but must be {attendu}")
    }
}

impl core::error::Error for ErreurGeo {}

/// The refusal of a vector that is 0.
pub(crate) fn refus_nul(champ: &'static str) -> ErreurGeo {
    ErreurGeo { champ, valeur: 0.0, attendu: "a vector other than 0" }
}

/// Refuses `valeur` with its name unless `accepte`.
#[inline]
pub(crate) fn exiger<R: Nombre>(
    accepte: bool,
    champ: &'static str,
    valeur: R,
    attendu: &'static str,
) -> Result<R, ErreurGeo> {
    if accepte {
        return Ok(valeur);
    }
    Err(ErreurGeo { champ, valeur: refusee(valeur.vers_f64()), attendu })
}

/// A value as an error shows it. Cold, so that the compiler lays out what is accepted first, and
/// apart from the names, so that it sees that they make an error.
#[cold]
#[inline(never)]
fn refusee(valeur: f64) -> f64 {
    // The bits of a computed NaN differ between processors.
    if valeur.is_nan() { f64::NAN } else { valeur }
}

/// A coordinate, or the relative distance of a half-space.
#[inline]
pub(crate) fn coordonnee<R: Nombre>(champ: &'static str, x: R) -> Result<R, ErreurGeo> {
    let attendu =
        selon::<R, _>("a number between -2^60 and 2^60", "a number between -2^450 and 2^450");
    exiger(x.absolu() <= R::LIMITE, champ, x, attendu)
}

/// The names of three coordinates.
type Champs = [&'static str; 3];

/// A point, whose three coordinates have these names.
#[inline]
pub(crate) fn position<R: Nombre>(champs: Champs, p: Vecteur<R>) -> Result<Vecteur<R>, ErreurGeo> {
    let [x, y, z] = champs;
    Ok(Vecteur::new(coordonnee(x, p.x)?, coordonnee(y, p.y)?, coordonnee(z, p.z)?))
}

/// Whether each coordinate of a point is within the limit.
#[inline(always)]
pub(crate) fn en_portee<R: Nombre>(p: Vecteur<R>) -> bool {
    let [x, y, z] = [p.x, p.y, p.z].map(|x| x.absolu() <= R::LIMITE);
    x & y & z
}

/// A radius or one of the three dimensions of a box.
pub(crate) fn taille<R: Nombre>(champ: &'static str, x: R) -> Result<R, ErreurGeo> {
    exiger(x > R::ZERO, champ, x, "a number above 0")?;
    let attendu =
        selon::<R, _>("a number between 2^-60 and 2^60", "a number between 2^-450 and 2^450");
    exiger(x >= R::UN / R::LIMITE && x <= R::LIMITE, champ, x, attendu)
}

/// The coefficient of a homothety.
pub(crate) fn coefficient<R: Nombre>(k: R) -> Result<R, ErreurGeo> {
    exiger(k > R::ZERO && k < R::INFINI, "coefficient", k, "a finite number above 0")
}

/// A length that may be 0.
#[inline]
pub(crate) fn positif_ou_nul<R: Nombre>(champ: &'static str, x: R) -> Result<R, ErreurGeo> {
    exiger(x >= R::ZERO && x < R::INFINI, champ, x, "a finite number, 0 or more")
}

/// The vector of a translation.
pub(crate) fn deplacement<R: Nombre>(v: Vecteur<R>) -> Result<Vecteur<R>, ErreurGeo> {
    fini(["translation.x", "translation.y", "translation.z"], v)
}

/// The origin that a conversion to `f32` subtracts.
#[inline]
pub(crate) fn origine<R: Nombre>(origine: Vecteur<R>) -> Result<Vecteur<R>, ErreurGeo> {
    fini(["origine.x", "origine.y", "origine.z"], origine)
}

/// A vector each of whose coordinates is finite.
#[inline]
pub(crate) fn fini<R: Nombre>(champs: Champs, v: Vecteur<R>) -> Result<Vecteur<R>, ErreurGeo> {
    // Not by `finis`, which would write the three names for every vector, before it looks at it.
    let [x, y, z] = champs;
    Ok(Vecteur::new(nombre_fini(x, v.x)?, nombre_fini(y, v.y)?, nombre_fini(z, v.z)?))
}

#[inline]
fn nombre_fini<R: Nombre>(champ: &'static str, x: R) -> Result<R, ErreurGeo> {
    exiger(x.absolu() < R::INFINI, champ, x, "a finite number")
}

/// Numbers each of which is finite.
#[inline]
pub(crate) fn finis<R: Nombre, const N: usize>(
    champs: [&'static str; N],
    nombres: [R; N],
) -> Result<[R; N], ErreurGeo> {
    for (champ, x) in champs.into_iter().zip(nombres) {
        nombre_fini(champ, x)?;
    }
    Ok(nombres)
}

/// A direction as a unit vector; refused by its name, or that of a coordinate, if it is zero or not
/// finite.
#[inline]
pub(crate) fn unitaire<R: Nombre>(
    [nom, x, y, z]: [&'static str; 4],
    v: Vecteur<R>,
) -> Result<Vecteur<R>, ErreurGeo> {
    fini([x, y, z], v)?.unitaire().ok_or_else(|| refus_nul(nom))
}
