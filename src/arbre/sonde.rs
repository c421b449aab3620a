//! The probe: a ray, or many that go about the same way, as the boxes of a node see them.
//!
//! Along each axis no ray of a probe is higher than s⁺ + τd⁺, its upper edge, and none lower than
//! s⁻ + τd⁻, its lower edge. A box is left out where the upper edge has not come up to its lower
//! side, or the lower edge not down to its upper side. The edges of a single ray coincide.
//!
//! Rounding is monotone, so that a probe of many rays leaves no box out that the probe of one of
//! them enters (`docs/preuves/recherche.md`, lemmas 19 to 21).

use fearless_simd::f32x16;
use fearless_simd::prelude::*;

use crate::algebre::arrondis::{JEU_DISTANCE, JEU_F32};
use crate::algebre::nombre::{
    est_double, fois_u, fois_u_simple, max, min, puissance_de_deux, simple,
};
use crate::arbre::noeud::Noeud;
use crate::arbre::repere::{JEU_SOUS_NORMAL, Repere};
use crate::cote_a_cote::colonne::{Alignee, Colonne, Membres};
use crate::cote_a_cote::groupe::{Groupe, VOIES};
use crate::{Nombre, Rayon};

pub(crate) struct Sonde<R> {
    axes: [Axe; 3],
    /// τ₀: entries are counted from the point at this distance along a ray, in the frame of the
    /// tree.
    tau0: R,
}

/// The largest and the least coordinate along an axis, of some rays: where entries count from, and
/// the direction.
#[derive(Clone, Copy)]
struct Bornes {
    s: [f32; 2],
    d: [f32; 2],
}

/// One axis of a probe: the edge that comes to a box first if all rays go the same way, and the
/// other edge.
#[derive(Clone, Copy)]
struct Axe {
    /// The columns of a node in which the sides stand that the edges come to.
    proche: usize,
    lointain: usize,
    /// Where entries count from, with the slack, and 1/D.
    vers_proche: f32,
    inverse_proche: f32,
    vers_lointain: f32,
    inverse_lointain: f32,
    /// Whether some rays rise along the axis and others do not. Then a box may be entered by either
    /// side, and neither edge tells where rays leave it.
    partage: bool,
}

/// A ray that is this far before Z is before all boxes, which lie within 1 of Z with their slack.
const AVANT_LES_BOITES: f64 = 2.0;

/// √3 and a little more: no unit vector has a larger sum of coordinates.
const RACINE_DE_TROIS: f32 = 1.75;

const _: () = assert!(RACINE_DE_TROIS * RACINE_DE_TROIS > 3.0);

impl<R: Nombre> Sonde<R> {
    /// The probe of this ray; `None` if its slack is so large that boxes tell no objects apart.
    #[inline(always)]
    pub(crate) fn new(rayon: &Rayon<R>, repere: Repere<R>) -> Option<Self> {
        let (y, d) = (repere.dans_le_repere(rayon.source()), rayon.direction());
        // Entries of a ray from far away are counted from its point nearest to Z. In `f32` that
        // point would be off by as much as a hit, so that they are counted from the source.
        let de_loin = est_double::<R>() && y.norme_1() > repere.loin;
        let tau0 = if de_loin { -y.produit_scalaire(d) } else { R::ZERO };
        Self::d_un_rayon(rayon, tau0, repere)
    }

    /// The probe of this ray for this τ₀.
    #[inline(always)]
    pub(crate) fn d_un_rayon(rayon: &Rayon<R>, tau0: R, repere: Repere<R>) -> Option<Self> {
        let (y, d) = (repere.dans_le_repere(rayon.source()), rayon.direction());
        let s = if tau0 == R::ZERO { y } else { y + d * tau0 };
        let bornes = |s: R, d: R| Bornes { s: [simple(s); 2], d: [simple(d); 2] };
        Self::entre_bords(tau0, [bornes(s.x, d.x), bornes(s.y, d.y), bornes(s.z, d.z)], repere)
    }

    /// τ₀ of the rays of these groups: a distance at which all of them are still before all boxes,
    /// or else 0, where they start. From there on every ray lies between the edges.
    #[inline(always)]
    pub(crate) fn tau0_commun(groupes: &[Groupe<R>], repere: Repere<R>) -> R {
        // Far away the length of a widened direction counts, which is 1 to `f32` only.
        let avant_z = |rayon: Rayon<R>| {
            let (y, d) = (repere.dans_le_repere(rayon.source()), rayon.direction());
            -y.produit_scalaire(d) / d.longueur_carree()
        };
        let avant = R::depuis_f64(AVANT_LES_BOITES);
        if !est_double::<R>() || avant_z(groupes[0].rayon(0)) <= avant {
            return R::ZERO;
        }
        let mut moindres = [R::INFINI; VOIES];
        for groupe in groupes {
            for (voie, moindre) in moindres.iter_mut().enumerate() {
                *moindre = min(avant_z(groupe.rayon(voie)), *moindre);
            }
        }
        max(moindres.into_iter().fold(R::INFINI, min) - avant, R::ZERO)
    }

    /// The probe of the rays of these groups for this τ₀, and [how wide](Bornes::largeur) it is.
    #[inline(always)]
    pub(crate) fn de_groupes<S: Simd>(
        simd: S,
        groupes: &[Groupe<R>],
        tau0: R,
        repere: Repere<R>,
    ) -> (Option<Self>, f32) {
        let bornes = [
            Bornes::le_long::<0, _, _>(simd, groupes, repere, tau0),
            Bornes::le_long::<1, _, _>(simd, groupes, repere, tau0),
            Bornes::le_long::<2, _, _>(simd, groupes, repere, tau0),
        ];
        let largeur = bornes.iter().map(|bornes| bornes.largeur()).sum();
        (Self::entre_bords(tau0, bornes, repere), largeur)
    }

    /// How [wide](Self::de_groupes) a probe of rays that hold these is at least.
    #[inline(always)]
    pub(crate) fn largeur_au_moins<'a>(
        rayons: impl Iterator<Item = &'a Rayon<R>>,
        repere: Repere<R>,
    ) -> f32
    where
        R: 'a,
    {
        let mut bornes = [Bornes::VIDES; 3];
        for rayon in rayons {
            let (s, d) = (repere.dans_le_repere(rayon.source()), rayon.direction());
            for (bornes, (s, d)) in bornes.iter_mut().zip([(s.x, d.x), (s.y, d.y), (s.z, d.z)]) {
                bornes.s = elargis(bornes.s, simple(s));
                bornes.d = elargis(bornes.d, simple(d));
            }
        }
        bornes.iter().map(|bornes| bornes.largeur()).sum()
    }

    /// The probe between these edges, with its part of the slack; `None` too if some rays rise and
    /// others do not along every axis: no edge would then end a box, and even missing children would
    /// count as entered.
    #[inline(always)]
    fn entre_bords(tau0: R, [x, y, z]: [Bornes; 3], repere: Repere<R>) -> Option<Self> {
        let norme = x.le_plus_loin() + y.le_plus_loin() + z.le_plus_loin();
        let distance = simple(fois_u::<R>(JEU_DISTANCE));
        let jeu = norme * (distance + simple(fois_u_simple::<R>(JEU_F32))) + JEU_SOUS_NORMAL;
        // T3. The sources are farther away by no more than √3τ₀.
        let jeu = if est_double::<R>() {
            jeu + simple(tau0.absolu()) * (RACINE_DE_TROIS * distance)
        } else {
            jeu
        };
        let axes = [x.axe(0, jeu), y.axe(1, jeu), z.axe(2, jeu)];
        let partent = axes.iter().all(|axe| axe.partage);
        (jeu < repere.jeu_maximal && !partent).then_some(Self { axes, tau0 })
    }

    /// The largest entry that matters before this distance from the source.
    #[inline(always)]
    pub(crate) fn plafond(&self, repere: Repere<R>, t: R) -> f32 {
        simple(repere.longueur(t) - self.tau0)
    }

    /// The entry of a box that may hold a source; that of any other box is larger.
    #[inline(always)]
    pub(crate) fn entree_de_la_source(&self) -> f32 {
        simple(-self.tau0)
    }

    /// Which children some ray may enter no later than `plafond`, and a distance before which none
    /// does.
    #[inline(always)]
    pub(crate) fn traverse<S: Simd>(
        &self,
        simd: S,
        noeud: &Noeud,
        plafond: f32,
    ) -> (Membres, Alignee) {
        let colonne = |i: usize| f32x16::simd_from(simd, noeud[i]);
        let uni = |x: f32| f32x16::splat(simd, x);
        let (mut entrees, mut sorties) = (uni(self.entree_de_la_source()), uni(plafond));
        for axe in self.axes {
            // T4: times the inverse of a speed that is never 0, so that no product is a NaN.
            let une = (colonne(axe.proche) - uni(axe.vers_proche)) * uni(axe.inverse_proche);
            let autre =
                (colonne(axe.lointain) - uni(axe.vers_lointain)) * uni(axe.inverse_lointain);
            entrees = une.max(entrees);
            if axe.partage {
                entrees = autre.max(entrees);
            } else {
                sorties = autre.min(sorties);
            }
        }
        (entrees.simd_le(sorties).to_bitmask() as u32, Alignee(entrees.into()))
    }
}

/// These bounds, the larger first, with one more number between them.
#[inline(always)]
fn elargis([haut, bas]: [f32; 2], x: f32) -> [f32; 2] {
    [max(haut, x), min(bas, x)]
}

impl Bornes {
    /// The bounds of no rays.
    const VIDES: Self =
        Self { s: [f32::NEG_INFINITY, f32::INFINITY], d: [f32::NEG_INFINITY, f32::INFINITY] };

    /// The bounds of the rays of these groups along one axis.
    #[inline(always)]
    fn le_long<const AXE: usize, S: Simd, R: Nombre>(
        simd: S,
        groupes: &[Groupe<R>],
        repere: Repere<R>,
        tau0: R,
    ) -> Self {
        let milieu = <[R; 3]>::from(repere.milieu)[AXE];
        let colonne = |x: Colonne<f32>| f32x16::simd_from(simd, x);
        let [haut, bas] = [f32::NEG_INFINITY, f32::INFINITY].map(|x| colonne([x; VOIES]));
        let ([mut s1, mut d1], [mut s0, mut d0]) = ([haut; 2], [bas; 2]);
        for groupe in groupes {
            let (sources, directions) = (&groupe.s[AXE], &groupe.d[AXE]);
            let (mut s, mut d) = ([0.0; VOIES], [0.0; VOIES]);
            for voie in 0..VOIES {
                let y = repere.longueur(sources[voie] - milieu);
                let ici = if est_double::<R>() { y + directions[voie] * tau0 } else { y };
                (s[voie], d[voie]) = (simple(ici), simple(directions[voie]));
            }
            let (s, d) = (colonne(s), colonne(d));
            (s1, s0, d1, d0) = (s1.max(s), s0.min(s), d1.max(d), d0.min(d));
        }
        // Adding 0 makes 0 of −0, whose sign would be that of a ray that falls.
        let d = [d1.reduce_max() + 0.0, d0.reduce_min() + 0.0];
        Self { s: [s1.reduce_max(), s0.reduce_min()], d }
    }

    /// The largest |s|.
    #[inline(always)]
    fn le_plus_loin(self) -> f32 {
        let [haut, bas] = self.s;
        max(haut.abs(), bas.abs())
    }

    /// How far apart the edges are at a distance of 1.
    #[inline(always)]
    fn largeur(self) -> f32 {
        let Self { s: [s1, s0], d: [d1, d0] } = self;
        (s1 - s0) + (d1 - d0)
    }

    /// The edges along this axis, each moved outward by the slack; without a branch for one ray,
    /// whose edges are the same numbers.
    #[inline(always)]
    fn axe(self, axe: usize, jeu: f32) -> Axe {
        let Self { s: [s1, s0], d: [d1, d0] } = self;
        // Where all rays fall, the lower edge comes to the upper side first.
        let tombent = d1 < 0.0;
        let [proche, lointain] = if tombent { [(s0, d0), (s1, d1)] } else { [(s1, d1), (s0, d0)] };
        let jeu = jeu.copysign(d1);
        let inverse = |d: f32| 1.0 / (d + IMMOBILE.copysign(d));
        Axe {
            proche: colonne_touchee(axe, d1),
            lointain: colonne_touchee(axe, -d1),
            vers_proche: proche.0 + jeu,
            inverse_proche: inverse(proche.1),
            vers_lointain: lointain.0 - jeu,
            inverse_lointain: inverse(lointain.1),
            partage: !tombent && d0 < 0.0,
        }
    }
}

/// The column of those sides of the boxes that a ray in this direction along the axis comes to
/// first. It is computed from the sign bit, which shows the compiler that the index is in range.
#[inline(always)]
fn colonne_touchee(axe: usize, d: f32) -> usize {
    axe + 3 * (d.to_bits() >> 31) as usize
}

/// What is added to |D|, so that no quotient is infinite and 0·∞ makes no NaN. A ray that moves
/// along an axis by less than this stays in place along it, as boxes see it.
const IMMOBILE: f32 = puissance_de_deux(-120) as f32;
