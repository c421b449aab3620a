//! What looks at the boxes of a node: the probe of a ray and the probe of a beam.

use fearless_simd::Simd;

use crate::arbre::noeud::{ENFANTS, Noeud};
use crate::arbre::repere::{JEU_DISTANCE, JEU_F32, JEU_SOUS_NORMAL, Repere};
use crate::colonne::{Aligne, Colonne, Membres, au_plus};
use crate::lot::faisceau::Faisceau;
use crate::nombre::{Nombre, fois_u, fois_u_simple, max, min, simple};
use crate::rayon::Rayon;
use crate::vecteur::Vecteur;

/// A ray as the boxes see it, with its part of the slack (`docs/preuves.md`, lemmas 6 and 20 to
/// 22).
pub(crate) struct Sonde<R> {
    axes: [Axe; 3],
    /// τ₀: entries count from the point so far along the ray, in the frame of the tree.
    depart: R,
}

/// One axis of a probe.
#[derive(Clone, Copy)]
struct Axe {
    /// The columns of a node in which the nearer sides of its boxes stand, and the farther ones.
    proche: usize,
    lointain: usize,
    /// 1/D.
    inverse: f32,
    /// Where entries count from, with the slack: for the nearer side of a box and for the farther.
    vers_proche: f32,
    vers_lointain: f32,
}

impl<R: Nombre> Sonde<R> {
    /// The probe of this ray; `None` if its slack is so large that boxes tell no objects apart.
    #[inline(always)]
    pub(crate) fn new(rayon: &Rayon<R>, repere: Repere<R>) -> Option<Self> {
        let (y, d) = (repere.point(rayon.source()), rayon.direction());
        let loin = y.norme_1();
        // T3. For a source far away entries count from the point next to Z. In `f32` that point is
        // off by as much as a hit, and the source serves.
        let depart = if R::selon(false, true) && loin > repere.loin {
            -y.produit_scalaire(d)
        } else {
            R::ZERO
        };
        let s = if depart == R::ZERO { y } else { y + d * depart };
        let jeu = loin * fois_u(JEU_DISTANCE) + s.norme_1() * fois_u_simple(JEU_F32);
        let (s, jeu) = (s.vers_f32(), simple(jeu) + JEU_SOUS_NORMAL);
        let axe = |axe: usize, s: f32, d: R| {
            // The sign of 1/D is that of D, of −0 too, and is known before the quotient.
            let d32 = simple(d);
            let jeu = jeu.copysign(d32);
            Axe {
                proche: colonne(axe, d32),
                lointain: colonne(axe, -d32),
                inverse: simple(R::UN / d),
                vers_proche: s + jeu,
                vers_lointain: s - jeu,
            }
        };
        let axes = [axe(0, s.x, d.x), axe(1, s.y, d.y), axe(2, s.z, d.z)];
        (jeu < repere.jeu_maximal).then_some(Self { axes, depart })
    }

    /// The largest entry that matters before this distance from the source.
    #[inline(always)]
    pub(crate) fn plafond(&self, repere: Repere<R>, t: R) -> f32 {
        simple(repere.longueur(t) - self.depart)
    }

    /// The entry of a box that may hold the source; that of any other box is larger.
    #[inline(always)]
    pub(crate) fn entree_de_la_source(&self) -> f32 {
        simple(-self.depart)
    }

    /// Which children the ray may enter no later than `plafond`, and where.
    #[inline(always)]
    pub(crate) fn traverse<S: Simd>(
        &self,
        simd: S,
        noeud: &Noeud,
        plafond: f32,
    ) -> (Membres, Aligne<Colonne<f32>>) {
        let ([x, y, z], source) = (self.axes, self.entree_de_la_source());
        let (px, py, pz) = (&noeud[x.proche], &noeud[y.proche], &noeud[z.proche]);
        let (lx, ly, lz) = (&noeud[x.lointain], &noeud[y.lointain], &noeud[z.lointain]);
        let (mut entrees, mut sorties) = ([0.0; ENFANTS], [plafond; ENFANTS]);
        for i in 0..ENFANTS {
            // T4. 0·∞ is a NaN, which leaves the number so far.
            let mut entree = source;
            entree = max((px[i] - x.vers_proche) * x.inverse, entree);
            entree = max((py[i] - y.vers_proche) * y.inverse, entree);
            entrees[i] = max((pz[i] - z.vers_proche) * z.inverse, entree);
            let mut sortie = plafond;
            sortie = min((lx[i] - x.vers_lointain) * x.inverse, sortie);
            sortie = min((ly[i] - y.vers_lointain) * y.inverse, sortie);
            sorties[i] = min((lz[i] - z.vers_lointain) * z.inverse, sortie);
        }
        (au_plus(simd, &entrees, &sorties), Aligne(entrees))
    }
}

/// The slack of a beam, in u of the scene's type, per unit of distance from Z to its sources and of
/// their spread (lemma 22).
pub const JEU_FAISCEAU: f64 = 60.0;

/// The slack of a side of a beam, in u of `f32`, per unit of its distance from Z (lemma 22).
pub const JEU_FACE: f64 = 3.1;

/// A beam as the boxes see it. For each of the five normals Π, an upper bound on Π·X over all hits
/// X; for Ω, the Ω·X from which depths count. Both include the slack (`docs/preuves.md`, lemmas 6
/// and 20 to 22).
pub(crate) struct SondeDeBloc {
    faces: [(Vecteur<f32>, f32); 5],
    omega: Vecteur<f32>,
    depart: f32,
}

impl SondeDeBloc {
    /// The probe of this beam; `None` if its slack is so large that boxes tell no objects apart.
    #[inline(always)]
    pub(crate) fn new<R: Nombre>(faisceau: &Faisceau<R>, repere: Repere<R>) -> Option<Self> {
        let s0 = repere.point(faisceau.s0);
        let loin = faisceau.etalement * R::depuis_f64(4.0) + faisceau.portee;
        let loin = s0.norme_1() + repere.longueur(loin);
        let jeu = loin * fois_u(JEU_FAISCEAU) + R::depuis_f64(JEU_SOUS_NORMAL.into());
        let limite = |pi: Vecteur<R>, w: R| {
            let loin = pi.produit_scalaire(s0) + repere.longueur(w);
            simple(loin + (loin.abs() * fois_u_simple(JEU_FACE) + jeu))
        };
        // T5
        let (omega, w) = faisceau.axe;
        (simple(jeu) < repere.jeu_maximal).then_some(Self {
            faces: faisceau.faces.map(|(pi, w)| (pi.vers_f32(), limite(pi, w))),
            omega: omega.vers_f32(),
            depart: limite(omega, w),
        })
    }

    /// Which children some ray may enter no later than `plafond`, and a distance before which none
    /// does.
    #[inline(always)]
    pub(crate) fn traverse<S: Simd>(
        &self,
        simd: S,
        noeud: &Noeud,
        plafond: f32,
    ) -> (Membres, Aligne<Colonne<f32>>) {
        let (mut dehors, mut profondeurs) = ([-f32::INFINI; ENFANTS], [0.0; ENFANTS]);
        for (pi, limite) in self.faces {
            let (x, y, z) = au_plus_pres(noeud, pi);
            for i in 0..ENFANTS {
                let h = pi.produit_scalaire(Vecteur::new(x[i], y[i], z[i])) - limite;
                dehors[i] = max(dehors[i], h);
            }
        }
        let (x, y, z) = au_plus_pres(noeud, self.omega);
        for i in 0..ENFANTS {
            let h = self.omega.produit_scalaire(Vecteur::new(x[i], y[i], z[i])) - self.depart;
            profondeurs[i] = max(h, 0.0);
        }
        let pas_dehors = au_plus(simd, &dehors, &[0.0; ENFANTS]);
        let avant = au_plus(simd, &profondeurs, &[plafond; ENFANTS]);
        (pas_dehors & avant, Aligne(profondeurs))
    }
}

/// The columns of the corners that lie lowest along Π: by the sign, without a branch.
#[inline(always)]
fn au_plus_pres(noeud: &Noeud, pi: Vecteur<f32>) -> (&Colonne<f32>, &Colonne<f32>, &Colonne<f32>) {
    (&noeud[colonne(0, pi.x)], &noeud[colonne(1, pi.y)], &noeud[colonne(2, pi.z)])
}

/// The column of the sides that something of this sign along this axis comes to first.
#[inline(always)]
fn colonne(axe: usize, signe: f32) -> usize {
    axe + 3 * (signe.to_bits() >> 31) as usize
}
