//! A block of rays in the tree: the walk through the nodes that its beam crosses.

use fearless_simd::Simd;

use crate::hierarchie::construction::{
    Arbre, Colonne, ENFANTS, Noeud, Repere, TROP_LOIN, indice, jeu, simple, simples,
};
use crate::hierarchie::parcours::{GRANDE_PILE, Pile, RIEN};
use crate::intersection::{Touche, rang};
use crate::lot::colonnes::{Aligne, VOIES, max, membres};
use crate::lot::faisceau::Faisceau;
use crate::lot::groupe::Groupe;
use crate::lot::{RechercheDeBloc, proposer};
use crate::objet::ObjetRay;
use crate::rayon::Rayon;
use crate::reel::{Reel, au_plus};
use crate::vecteur::Vecteur;

/// When a block has seen so many objects, its rays are too far apart: from there each walks alone, cut off
/// at what it has found.
const ASSEZ_D_OBJETS: f64 = 112.0;

/// The same for a beam as wide as it is far; the wider, the sooner.
const ASSEZ_SI_LARGE: f64 = 20.0;

/// The slack of a beam is so many times that of a ray (lemma 17).
pub const JEU_BLOC: f64 = 2.0;

/// What is added to the slack of a beam, in u of `f32` (lemma 17).
pub const JEU_FIXE: f64 = 13.0;

/// In so small a tree a block never sees too many: 320 objects in `f32`, 160 in `f64`, where sixteen rays side by
/// side take twice as long.
const PETIT_ARBRE: usize = 1280;

/// Searches a tree, in the nodes that the beam of the block crosses.
pub(crate) struct RechercheDansLArbre<'a, R, S> {
    pub(crate) simd: S,
    pub(crate) objets: &'a [ObjetRay<R>],
    pub(crate) arbre: &'a Arbre<'a, R>,
}

impl<R: Reel, S: Simd> RechercheDeBloc<R> for RechercheDansLArbre<'_, R, S> {
    #[inline(always)]
    fn chercher(
        &mut self,
        bloc: &mut [Groupe<R>],
        rayons: &[Rayon<R>],
        touches: &mut [Touche<R>],
    ) -> bool {
        let Self { simd, objets, arbre } = *self;
        let Some(sonde) = SondeDeBloc::new(rayons, bloc, arbre.repere) else {
            return un_par_un(simd, objets, arbre, bloc, rayons, touches);
        };
        for indice in arbre.sans_bornes() {
            proposer_indice(objets, bloc, indice);
        }
        let mut attentes = [RIEN; GRANDE_PILE];
        let mut pile = Pile::new(&mut attentes);
        let mut plafond = arbre.repere.distance(le_plus_loin(bloc));
        let mut numero = arbre.racine;
        let assez = if objets.len() <= PETIT_ARBRE / size_of::<R>() {
            f64::INFINITY
        } else {
            (ASSEZ_SI_LARGE / sonde.largeur).min(ASSEZ_D_OBJETS)
        };
        let mut vus = 0;
        while let Some(noeud) = arbre.noeuds.get(numero) {
            let (traverses, Aligne(profondeurs)) = sonde.traverse(simd, noeud, plafond);
            if numero < arbre.feuilles {
                if traverses != 0 {
                    vus += traverses.count_ones();
                    if f64::from(vus) > assez {
                        return un_par_un(simd, objets, arbre, bloc, rayons, touches);
                    }
                    let [.., indices] = noeud;
                    for enfant in membres(traverses) {
                        proposer_indice(objets, bloc, indice(indices[enfant]));
                    }
                    plafond = arbre.repere.distance(le_plus_loin(bloc));
                }
            } else if let Some(proche) = pile.garder(traverses, &profondeurs, noeud) {
                numero = proche;
                continue;
            }
            let Some(suivant) = pile.prendre(plafond) else { break };
            numero = suivant;
        }
        false
    }
}

/// Searches for each ray alone, from its first object so far, and writes the answers.
#[inline(always)]
fn un_par_un<R: Reel, S: Simd>(
    simd: S,
    objets: &[ObjetRay<R>],
    arbre: &Arbre<'_, R>,
    bloc: &[Groupe<R>],
    rayons: &[Rayon<R>],
    touches: &mut [Touche<R>],
) -> bool {
    simd.vectorize(
        #[inline(always)]
        || {
            for (i, (rayon, touche)) in rayons.iter().zip(touches).enumerate() {
                let premier = bloc[i / VOIES].premier(i % VOIES);
                *touche = arbre.premiere_intersection(simd, objets, rayon, premier);
            }
        },
    );
    true
}

/// Proposes the object of this index to the block.
#[inline(always)]
fn proposer_indice<R: Reel>(objets: &[ObjetRay<R>], bloc: &mut [Groupe<R>], indice: usize) {
    if let Some(objet) = objets.get(indice) {
        proposer::<R, false>(bloc, objet, rang(indice));
    }
}

/// The largest distance of a first object so far.
#[inline(always)]
fn le_plus_loin<R: Reel>(bloc: &[Groupe<R>]) -> R {
    let mut loin = R::ZERO;
    for groupe in bloc {
        loin = max(groupe.le_plus_loin(), loin);
    }
    loin
}

/// A beam as the boxes see it. For each of the five normals P, an upper bound on P·X over all hits X;
/// for M, the M·X from which depths count. Both include the slack (`docs/conception.md`, lemmas 14 to 17).
struct SondeDeBloc {
    plans: [(Vecteur<f32>, f32); 5],
    m: Vecteur<f32>,
    depart: f32,
    /// The side of the beam one unit ahead.
    largeur: f64,
}

impl SondeDeBloc {
    /// The probe of the beam of these rays; `None` if they have no beam, or start too far away.
    #[inline(always)]
    fn new<R: Reel>(rayons: &[Rayon<R>], bloc: &[Groupe<R>], repere: Repere<R>) -> Option<Self> {
        let faisceau = Faisceau::du_bloc(rayons, bloc)?;
        let s0 = repere.point(faisceau.s0);
        let loin = s0.norme_1() + repere.longueur(faisceau.ecart) * R::depuis_f64(4.0);
        if simple(loin) > TROP_LOIN {
            return None;
        }
        let jeu = loin * R::depuis_f64(JEU_BLOC * jeu::<R>())
            + R::depuis_f64(JEU_FIXE * f64::from(f32::U));
        let limite =
            |p: Vecteur<R>, w: R| simple(p.produit_scalaire(s0) + (repere.longueur(w) + jeu));
        let (moins_m, w) = faisceau.plans[4];
        Some(Self {
            plans: faisceau.plans.map(|(p, w)| (simples(p), limite(p, w))),
            m: simples(-moins_m),
            depart: limite(-moins_m, w),
            largeur: faisceau.largeur.vers_f64(),
        })
    }

    /// Which children some ray may enter no later than `plafond`, a bit for each, and a distance before
    /// which none does.
    #[inline(always)]
    fn traverse<S: Simd>(&self, simd: S, noeud: &Noeud, plafond: f32) -> (u32, Aligne<Colonne>) {
        let (mut dehors, mut profondeurs) = ([-f32::INFINI; ENFANTS], [0.0; ENFANTS]);
        for (p, limite) in self.plans {
            let (x, y, z) = au_plus_pres(noeud, p);
            for i in 0..ENFANTS {
                let h = p.produit_scalaire(Vecteur::new(x[i], y[i], z[i])) - limite;
                dehors[i] = max(dehors[i], h);
            }
        }
        let (x, y, z) = au_plus_pres(noeud, self.m);
        for i in 0..ENFANTS {
            let h = self.m.produit_scalaire(Vecteur::new(x[i], y[i], z[i])) - self.depart;
            profondeurs[i] = max(h, 0.0);
        }
        let pas_dehors = au_plus(simd, &dehors, &[0.0; ENFANTS]);
        let avant = au_plus(simd, &profondeurs, &[plafond; ENFANTS]);
        (pas_dehors & avant, Aligne(profondeurs))
    }
}

/// The columns of the corners that lie lowest along P.
#[inline(always)]
fn au_plus_pres(
    [bx, by, bz, hx, hy, hz, _]: &Noeud,
    p: Vecteur<f32>,
) -> (&Colonne, &Colonne, &Colonne) {
    (
        if p.x < 0.0 { hx } else { bx },
        if p.y < 0.0 { hy } else { by },
        if p.z < 0.0 { hz } else { bz },
    )
}
