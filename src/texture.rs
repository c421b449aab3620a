//! The texture of an object (handout §4.1).

/// What an object is made of, as a number that this crate carries and never reads.
///
/// The handout leaves textures to a later part; that part gives the number a meaning, an index into
/// its own list of materials for instance.
///
/// ```
/// use lancer_rayon::{ObjetGeo, SphereGeo, Texture, Vecteur};
///
/// let marbre = Texture(7);
/// let boule = ObjetGeo::from(SphereGeo::new(Vecteur::NUL, 1.0, marbre)?);
/// # Ok::<(), lancer_rayon::ErreurGeo>(())
/// ```
#[doc(alias = "material")]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[must_use]
pub struct Texture(pub u32);
