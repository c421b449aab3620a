//! The frame of a tree: where its boxes of `f32` stand, and by how much they grow.

use crate::objet::ObjetRay;
use crate::reel::{Reel, fois_u_simple, max, min, simple};
use crate::vecteur::Vecteur;

/// From so far away the boxes of a scene cannot be told apart: the whole tree is asked.
pub(crate) const TROP_LOIN: f32 = (1_u128 << 100) as f32;

/// The frame of the tree, in which `f32` holds any scene: a point X of the scene stands at (X −
/// Z)·σ. No coordinate of a box is beyond ±1, except for rounding and slack.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Repere<R> {
    /// Z, the middle of the centres.
    milieu: Vecteur<R>,
    /// σ, what lengths are multiplied by.
    echelle: R,
}

impl<R: Reel> Repere<R> {
    /// The frame of a tree without nodes.
    pub(crate) const QUELCONQUE: Self = Self { milieu: Vecteur::NUL, echelle: R::UN };

    /// The frame of these objects.
    pub(crate) fn autour(objets: &[ObjetRay<R>]) -> Self {
        let mut plus_large = R::ZERO;
        let centres = objets.iter().filter_map(|objet| {
            let (c, h) = objet.boite_englobante()?;
            plus_large = max(plus_large, h.norme_1());
            Some(c.into())
        });
        let [bas, haut] = extremes(centres);
        // T1. Z in the middle would need half of this. In the worst case rounding moves Z to the
        // last centre.
        let echelle = R::UN / ((haut - bas).norme_1() + plus_large * R::depuis_f64(2.0));
        Self { milieu: (bas + haut) * R::depuis_f64(0.5), echelle }
    }

    /// (X − Z)·σ.
    #[inline(always)]
    pub(crate) fn point(self, x: Vecteur<R>) -> Vecteur<R> {
        (x - self.milieu) * self.echelle
    }

    /// The box around a slice of an object, with the part of the [slack](PART_DU_JEU) that an object of centre `c` and
    /// half-extents `h` has: the centre of the slice is `decalage` away from `c`, its half-extents are `demi`.
    pub(crate) fn boite_elargie(
        self,
        (c, h): (Vecteur<R>, Vecteur<R>),
        (decalage, demi): (Vecteur<R>, Vecteur<R>),
    ) -> (Vecteur<f32>, Vecteur<f32>) {
        let (c, h) = (self.point(c), h * self.echelle);
        // T2. The proof needs ρ, the radius of the ball around the object; the sum of the
        // half-extents is no less.
        let jeu = (c.norme_1() + h.norme_1()) * fois_u_simple(PART_DU_JEU);
        let (c, h) = (c + decalage * self.echelle, demi * self.echelle);
        let demi = h + Vecteur::new(jeu, jeu, jeu);
        (simples(c - demi), simples(c + demi))
    }

    /// A length times σ.
    #[inline(always)]
    pub(crate) fn longueur(self, l: R) -> R {
        l * self.echelle
    }

    /// A distance along a ray times σ, to 2u of `f32` down to its least normal number; +∞ beyond
    /// all numbers of that type.
    #[inline(always)]
    pub(crate) fn distance(self, t: R) -> f32 {
        simple(self.longueur(t))
    }
}

/// The slack for the point of a hit, in u of `f32` (lemma 15).
pub const JEU_TOUCHE: f64 = 70.0;

/// The slack for the rounding to `f32`, in u of `f32` (lemma 15).
pub const JEU_F32: f64 = 2.2;

/// The slack, by which boxes grow so that rounding loses no hit, per unit of distance from Z to an
/// object or to the source of a ray, in u of `f32`. Derived in `docs/preuves.md`, lemmas 14 to 17.
pub(crate) const PART_DU_JEU: f64 = JEU_TOUCHE + JEU_F32;

/// The nearest vector of such numbers.
#[inline(always)]
pub(crate) fn simples<R: Reel>(v: Vecteur<R>) -> Vecteur<f32> {
    Vecteur::depuis_f64(v.vers_f64())
}

/// The least and the greatest coordinates of these points.
pub(crate) fn extremes<R: Reel>(points: impl Iterator<Item = [R; 3]>) -> [Vecteur<R>; 2] {
    // Farther than any corner of a box.
    let loin = R::LIMITE * R::LIMITE;
    let [mut bas, mut haut] = [[loin; 3], [-loin; 3]];
    for point in points {
        for axe in 0..3 {
            bas[axe] = min(bas[axe], point[axe]);
            haut[axe] = max(haut[axe], point[axe]);
        }
    }
    [bas, haut].map(Vecteur::from)
}
