//! The nodes of a tree: sixteen children side by side, in the numbers that the caller lends.

use crate::algebre::nombre::puissance_de_deux;
use crate::cote_a_cote::colonne::{Colonne, LARGEUR};

/// Children of a node: a column has one number of each.
pub(crate) const ENFANTS: usize = LARGEUR;

/// Numbers of a record: the lower corner, the upper corner, the index.
pub(crate) const FICHE: usize = 7;

/// No tree is made of this many objects or more: this index would have the bits of +∞ in `f32`.
pub(crate) const LIMITE_INDICES: u64 = 0x7f80_0000;

/// Floors of the largest tree: 16⁸ is more than [`LIMITE_INDICES`].
pub(crate) const ETAGES: usize = 8;

/// The farthest corner of a missing child.
pub(crate) const COIN_ABSENT: f32 = puissance_de_deux(120) as f32;

/// The box of an object or of one of its pieces, and the index of the object.
pub(crate) type Fiche = [f32; FICHE];

/// Sixteen children: the lower corners of their boxes, the upper corners, and the indices of the
/// objects in a leaf, above the leaves the numbers of the nodes.
///
/// A child that is missing has a box turned inside out ([`VIDE`]), which nothing enters.
pub(crate) type Noeud = [Colonne<f32>; FICHE];

/// A node without children: each box is turned inside out, its lower corner beyond everything and
/// its upper corner below. A ray would leave such a box before it enters it.
pub(crate) const VIDE: Noeud = {
    let (bas, haut) = ([COIN_ABSENT; ENFANTS], [-COIN_ABSENT; ENFANTS]);
    [bas, bas, bas, haut, haut, haut, [0.0; ENFANTS]]
};

/// An index below 2³¹ − 2²³, stored in a column of `f32` as the number with the same bits, which is
/// finite.
pub(crate) fn en_mot(indice: usize) -> f32 {
    f32::from_bits(indice as u32)
}

/// The index that a number of a column stores. Without its sign bit it is below 2³¹, which the
/// compiler then knows.
#[inline(always)]
pub(crate) fn indice_lu(mot: f32) -> usize {
    mot.abs().to_bits() as usize
}
