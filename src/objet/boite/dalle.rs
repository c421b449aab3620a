//! The distances to the faces of a box, axis by axis, as quotients that are compared before one is
//! divided (handout, annex A.3).

use crate::algebre::nombre::{puissance_de_deux, selon};
use crate::{Nombre, Vecteur};

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

/// The entry and the exit of a ray between two opposite faces: their axis N, half of their distance
/// l, the source S seen from the middle C, and the direction D.
///
/// The axis points the way the ray goes. The speed is multiplied by [`echelle_vitesse`]; in `f32`,
/// whose range does not hold every product of a length and a speed, it is rounded to a multiple of
/// 2⁻¹⁰² before: only a speed below 2⁻⁷⁹ changes.
#[inline(always)]
pub(crate) fn dalle<R: Nombre>(
    (n, l): (Vecteur<R>, R),
    cs: Vecteur<R>,
    d: Vecteur<R>,
) -> (Quotient<R>, Quotient<R>) {
    let (o, vitesse) = (cs.produit_scalaire(n), d.produit_scalaire(n));
    let o = if vitesse < R::ZERO { -o } else { o }; // B1: as if the axis were turned
    // The speed is rounded because it is scaled down to where numbers of `f32` are 2⁻¹⁴⁹ apart, and
    // up again. With a floor by minimum and maximum in its place a single ray takes up to 1.3 times
    // as long among boxes (measured).
    let descente = R::depuis_f64(selon::<R, _>(puissance_de_deux(-47), 1.0));
    // B2: so scaled that no product that is compared is lost.
    let vitesse = vitesse.absolu() * descente * (echelle_vitesse::<R>() / descente);
    (Quotient { longueur: -(l + o), vitesse }, Quotient { longueur: l - o, vitesse })
}

/// The last entry into three pairs of faces, which pair that is, and the first exit, as [`dalle`]
/// has them.
///
/// One pair has a speed of 0.5 or more, and with it an entry and an exit nearer than `loin`.
#[inline(always)]
pub(crate) fn dalles<R: Nombre>(
    paires: [(Vecteur<R>, R); 3],
    cs: Vecteur<R>,
    d: Vecteur<R>,
) -> (Quotient<R>, usize, Quotient<R>) {
    let (loin, vitesse) = (R::LIMITE * R::depuis_f64(8.0), echelle_vitesse());
    let mut entree = Quotient { longueur: -loin, vitesse };
    let mut sortie = Quotient { longueur: loin, vitesse };
    let mut axe_d_entree = 0; // B4: of equal entries the first axis counts
    for (axe, paire) in paires.into_iter().enumerate() {
        let (e, s) = dalle(paire, cs, d);
        if e.depasse(entree) {
            (entree, axe_d_entree) = (e, axe);
        }
        if sortie.depasse(s) {
            sortie = s;
        }
    }
    (entree, axe_d_entree, sortie)
}
