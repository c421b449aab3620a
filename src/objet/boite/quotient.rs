//! The distance to a face of a box as a quotient, which is compared before it is divided (handout,
//! annex A.3).

use crate::Nombre;
use crate::algebre::nombre::{puissance_de_deux, selon};

/// A power of two that multiplies speeds, so that no product of a length of a box and a speed
/// towards its faces leaves the range of the type (`docs/preuves/objets.md`, lemma 2).
#[inline(always)]
pub(crate) fn echelle_vitesse<R: Nombre>() -> R {
    R::depuis_f64(selon::<R, _>(puissance_de_deux(62), puissance_de_deux(568)))
}

/// The distance to a face as a length over a speed of 0 or more, not divided yet. The speed is
/// multiplied by [`echelle_vitesse`], so that no product below is subnormal.
///
/// Two quotients are compared by cross-multiplication, since one division costs more than the two
/// products. A ray parallel to a pair of faces then needs no case of its own: beside the pair its
/// entry is +∞ or its exit −∞, and in the plane of a face 0/0 is neither above nor below anything.
/// Neither of +∞ and −∞ is above the other: a ray beside two pairs has an entry at +∞.
#[derive(Clone, Copy)]
pub(crate) struct Quotient<R> {
    pub(crate) longueur: R,
    pub(crate) vitesse: R,
}

impl<R: Nombre> Quotient<R> {
    #[inline(always)]
    pub(crate) fn depasse(self, autre: Self) -> bool {
        // B3: products in place of quotients, the same comparison for speeds of 0 or more.
        self.longueur * autre.vitesse > autre.longueur * self.vitesse
    }

    #[inline(always)]
    pub(crate) fn distance(self) -> R {
        // B5: the length is multiplied, not the quotient, which may be subnormal.
        self.longueur * echelle_vitesse() / self.vitesse
    }
}
