//! The frame of a tree: where its boxes of `f32` stand, and by how much they grow.

use core::cmp::Ordering;

use arrayvec::ArrayVec;

use crate::algebre::arrondis::{JEU_DISTANCE, JEU_F32, JEU_LARGEUR};
use crate::algebre::nombre::{fois_u, fois_u_simple, max, min, puissance_de_deux, simple};
use crate::arbre::noeud::{ENFANTS, Fiche};
use crate::{Nombre, ObjetRay, Vecteur};

/// The frame of the tree, in which `f32` holds any scene: a point X of the scene stands at (X −
/// Z)·σ. No coordinate of a box is beyond ±1, except for rounding and slack.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Repere<R> {
    /// Z, a point amid most of the objects, the *many*. A side of a box is rounded in proportion to
    /// its distance from Z.
    pub(crate) milieu: Vecteur<R>,
    /// σ, what lengths are multiplied by.
    echelle: R,
    /// What is farther from Z than this is far from the many.
    pub(crate) loin: R,
    /// With this slack or more, boxes tell no objects apart.
    pub(crate) jeu_maximal: f32,
}

/// The distance from Z beyond which something is far from the many, in widths of the many.
const LARGEURS: f64 = 4.0;

/// How many objects at most tell where the many are.
const ECHANTILLONS: usize = 31;

/// Which of `objets` objects is number `k` of the sample: one in a stretch of the list of its own,
/// at a place that follows no rule, so that where kinds of objects take turns the sample has every
/// kind.
fn echantillon(k: usize, objets: usize) -> usize {
    let nombre = objets.clamp(1, ECHANTILLONS);
    let [debut, fin] = [k, k + 1].map(|k| k * objets / nombre);
    // A scramble of the bits of k: the last steps of MurmurHash3.
    let melange = (k as u32 + 1).wrapping_mul(0x9e37_79b9);
    let melange = (melange ^ melange >> 16).wrapping_mul(0x85eb_ca6b);
    let melange = (melange ^ melange >> 13).wrapping_mul(0xc2b2_ae35);
    debut + ((u64::from(melange) * (fin - debut) as u64) >> 32) as usize
}

/// Where these places, which stand in order, are closest: the middle of a quarter of them, the
/// middle one unless another is less than half as wide. (If half of the objects are far away, the
/// middle quarter may reach from here to there.)
fn la_ou_ils_sont_serres<R: Nombre>(lieux: &[R]) -> R {
    let large = lieux.len() / 4 + 1;
    let combien = (lieux.len() + 1).saturating_sub(large);
    let milieu = combien / 2;
    // From the middle outward, to both sides by turns.
    let quart = |i: usize| {
        let debut = if i.is_multiple_of(2) { milieu + i / 2 } else { milieu - i.div_ceil(2) };
        &lieux[debut..debut + large]
    };
    let serre = (0..combien).map(quart).reduce(|serre, autre| {
        let [a, b] = [serre, autre].map(|quart| quart[large - 1] - quart[0]);
        if b + b < a { autre } else { serre }
    });
    serre.map_or(R::ZERO, |serre| serre[large / 2])
}

impl<R: Nombre> Repere<R> {
    /// The frame of a tree without nodes.
    pub(crate) const QUELCONQUE: Self =
        Self { milieu: Vecteur::NUL, echelle: R::UN, loin: R::ZERO, jeu_maximal: 0.0 };

    /// The frame of these objects. Along each axis the inner three quarters of them are the many,
    /// and Z is where they stand closest.
    pub(crate) fn autour(objets: &[ObjetRay<R>]) -> Self {
        let boites = || objets.iter().filter_map(ObjetRay::boite_englobante);
        let nombre = boites().count();
        let (mut choisis, mut plus_large) = (ArrayVec::<[R; 3], ECHANTILLONS>::new(), R::ZERO);
        let mut suivant = echantillon(0, nombre);
        let [bas, haut] = extremes(boites().enumerate().map(|(i, (c, h))| {
            let c = c.into();
            plus_large = max(plus_large, h.norme_1());
            if i == suivant {
                choisis.push(c);
                suivant = echantillon(choisis.len(), nombre);
            }
            c
        }));
        // T1: no corner leaves ±1, even if Z is the last centre.
        let echelle = R::UN / ((haut - bas).norme_1() + plus_large * R::depuis_f64(2.0));
        let mut largeur = R::ZERO;
        let milieu = [0, 1, 2].map(|axe| {
            let mut lieux: ArrayVec<R, ECHANTILLONS> = choisis.iter().map(|c| c[axe]).collect();
            lieux.sort_unstable_by(|a, b| a.partial_cmp(b).unwrap_or(Ordering::Equal));
            let place = |huitiemes: usize| {
                lieux.get(huitiemes * lieux.len() / 8).copied().unwrap_or(R::ZERO)
            };
            largeur = largeur + (place(7) - place(1));
            la_ou_ils_sont_serres(&lieux)
        });
        let loin = largeur * echelle * R::depuis_f64(LARGEURS);
        Self { milieu: milieu.into(), echelle, loin, jeu_maximal: 0.0 }
    }

    /// (X − Z)·σ.
    #[inline(always)]
    pub(crate) fn dans_le_repere(self, x: Vecteur<R>) -> Vecteur<R> {
        (x - self.milieu) * self.echelle
    }

    /// The box around a slice of an object, with the part of the slack that an object of centre `c`
    /// and half-extents `h` has: the centre of the slice is `decalage` away from `c`, its
    /// half-extents are `demi`.
    pub(crate) fn boite_elargie(
        self,
        (c, h): (Vecteur<R>, Vecteur<R>),
        (decalage, demi): (Vecteur<R>, Vecteur<R>),
    ) -> (Vecteur<f32>, Vecteur<f32>) {
        let (c, h) = (self.dans_le_repere(c), h * self.echelle);
        // T2. The proof needs ρ, the radius of the ball around the object; the sum of the
        // half-extents is no less.
        let (loin, large) = (c.norme_1(), h.norme_1());
        let jeu = loin * fois_u(JEU_DISTANCE)
            + large * fois_u_simple(JEU_LARGEUR)
            + (loin + large) * fois_u_simple(JEU_F32);
        let (c, h) = (c + decalage * self.echelle, demi * self.echelle);
        let demi = h + Vecteur::new(jeu, jeu, jeu);
        ((c - demi).vers_f32(), (c + demi).vers_f32())
    }

    /// The way in the scene from `c` to the middle of the box of this record.
    pub(crate) fn vers_le_milieu(self, fiche: &Fiche, c: Vecteur<R>) -> Vecteur<R> {
        let milieu = double_centre(fiche).map(|x| R::depuis_f64(0.5 * f64::from(x)));
        (Vecteur::from(milieu) - self.dans_le_repere(c)) / self.echelle
    }

    /// The side of a leaf in this frame, if all leaves of this many records were alike among the
    /// many.
    pub(crate) fn cote_d_une_feuille(self, fiches: usize) -> f32 {
        let largeur = simple(self.loin) / LARGEURS as f32;
        largeur / libm::cbrtf(fiches as f32 / ENFANTS as f32)
    }

    /// An eighth of the surface of a box with half-extents of these sizes, times σ².
    pub(crate) fn surface(self, h: Vecteur<R>) -> f32 {
        let [x, y, z] = <[R; 3]>::from(h).map(|l| self.distance(l));
        x * y + y * z + z * x
    }

    /// A length times σ.
    #[inline(always)]
    pub(crate) fn longueur(self, l: R) -> R {
        l * self.echelle
    }

    /// The length in the scene of one in the frame.
    pub(crate) fn en_longueur(self, l: R) -> R {
        l / self.echelle
    }

    /// A length times σ, to 2u of `f32` down to its least normal number; +∞ beyond
    /// all numbers of that type.
    #[inline(always)]
    pub(crate) fn distance(self, t: R) -> f32 {
        simple(self.longueur(t))
    }
}

/// With a slack of this part of the spread of the boxes without giants, or more, boxes tell no
/// objects apart.
pub(crate) const JEU_MAXIMAL: f32 = 1.0 / 8.0;

/// More than is lost below the normal numbers (lemma 20).
pub(crate) const JEU_SOUS_NORMAL: f32 = puissance_de_deux(-100) as f32;

/// Twice the centre of a box.
#[inline(always)]
pub(crate) fn double_centre(&[x0, y0, z0, x1, y1, z1, _]: &Fiche) -> [f32; 3] {
    [x0 + x1, y0 + y1, z0 + z1]
}

/// The least and the greatest coordinates of these points.
pub(crate) fn extremes<R: Nombre>(points: impl Iterator<Item = [R; 3]>) -> [Vecteur<R>; 2] {
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
