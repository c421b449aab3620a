//! The rays of a block together in the tree: the walk through the nodes that their beam crosses.

use fearless_simd::prelude::*;

use crate::hierarchie::construction::Arbre;
use crate::hierarchie::noeud::indice_lu;
use crate::hierarchie::pile::{GRANDE_PILE, Pile, RIEN};
use crate::hierarchie::sonde::SondeDeBloc;
use crate::lot::PEU_DE_RAYONS;
use crate::lot::bloc::Bloc;
use crate::lot::demande::Demande;
use crate::lot::faisceau::vont_ensemble;
use crate::premier::Premier;
use crate::rayon::Rayon;
use crate::reel::Reel;
use crate::seize::{Aligne, SEIZE, prendre};

/// Up to so many spheres and boxes for each number that a register holds, a block without a beam asks every
/// object of all its rays (`docs/performance.md`, "Thresholds", as for what follows).
const PEU_PAR_NOMBRE: usize = 6;

/// Fewer shadows than this are faster one by one, of first hits fewer than [`PEU_DE_RAYONS`].
const PEU_D_OMBRES: usize = 12;

/// A beam that crosses so many of the sixteen leaves under a node may be too wide, in `f32` and in `f64`.
const TROP_DE_FEUILLES: (u32, u32) = (12, 10);

/// A beam that meets more objects than this for each group of its rays may be too wide as well.
pub const ASSEZ_D_OBJETS: (usize, usize) = (56, 28);

/// For each step of one of its rays alone a block may meet so many objects.
const OBJETS_PAR_PAS: (usize, usize) = (10, 5);

/// Each object that a beam meets counts once for each so many nodes of the tree, rounded down, and from twice on no
/// group tries: each ray of a tile meets an object of its own there, which comes from memory.
const BEAUCOUP_DE_NOEUDS: usize = 2048;

/// The most that do not try in a row.
const PAUSE: u32 = 31;

/// Which blocks of a call try to walk together, or which groups of its rays. After a second in a row that
/// gave up 3 do not, after a third 15, and then 31: what a try in vain costs is spread over these.
#[derive(Default)]
pub(crate) struct Patience {
    abandons: u32,
    seuls: u32,
}

impl Patience {
    /// Whether the next one tries.
    #[inline(always)]
    fn essayer(&mut self) -> bool {
        let essayer = self.seuls == 0;
        self.seuls = self.seuls.saturating_sub(1);
        essayer
    }

    /// Notes how a try ended.
    #[inline(always)]
    fn noter(&mut self, jusqu_au_bout: bool) {
        self.abandons = if jusqu_au_bout { 0 } else { (self.abandons + 1).min(4) };
        self.seuls = (4_u32.pow(self.abandons.saturating_sub(1)) - 1).min(PAUSE);
    }
}

impl<R: Reel> Arbre<'_, R> {
    /// The answers to the rays of a block: of all together, else of sixteen at a time, else one by one.
    #[inline(always)]
    pub(crate) fn repondre_au_bloc<S: Simd, D: Demande<R>>(
        &self,
        simd: S,
        bloc: &mut Bloc<'_, R, D>,
        (demandes, reponses): (&[D], &mut [D::Reponse]),
        [des_blocs, des_groupes]: &mut [Patience; 2],
    ) {
        bloc.nombre = 0;
        if self.repondre_ensemble(simd, bloc, (demandes, reponses), des_blocs) {
            return;
        }
        // Shadows that try twice take up to 1.17 of the time (measured).
        let par_groupes = !D::UN_SUFFIT && demandes.len() > SEIZE && self.abondance() == 1;
        // What stands before the lamp of one ray often stands before that of the next.
        let mut dernier = Premier::avant(R::INFINI);
        let groupes = demandes.chunks(SEIZE).zip(reponses.chunks_mut(SEIZE));
        for (numero, (demandes, reponses)) in groupes.enumerate() {
            let groupe = &mut bloc.groupe(numero);
            if par_groupes
                && self.repondre_ensemble(simd, groupe, (demandes, reponses), des_groupes)
            {
                continue;
            }
            simd.vectorize(
                #[inline(always)]
                || {
                    for (voie, (demande, reponse)) in demandes.iter().zip(reponses).enumerate() {
                        let (rayon, limite) = demande.lire();
                        let mut premier = groupe.premier(voie, limite);
                        if D::UN_SUFFIT && premier.rang.is_none() {
                            premier = dernier.encore(self.objets, &rayon, premier);
                        }
                        if !D::UN_SUFFIT || premier.rang.is_none() {
                            premier = self.parcourir(simd, demande, premier, groupe.sauf, &mut 0);
                        }
                        if premier.rang.is_some() {
                            dernier = premier;
                        }
                        *reponse = D::conclure(premier, self.objets, &rayon);
                    }
                },
            );
        }
    }

    /// Answers these rays together, at most a block, and tells so; else what the block has found so far stands.
    #[inline(always)]
    pub(crate) fn repondre_ensemble<S: Simd, D: Demande<R>>(
        &self,
        simd: S,
        bloc: &mut Bloc<'_, R, D>,
        (demandes, reponses): (&[D], &mut [D::Reponse]),
        patience: &mut Patience,
    ) -> bool {
        let avec_boite = self.objets.len() - self.sans_boite.len();
        // A shape asks sixteen rays even where some are missing.
        let voies = demandes.len().next_multiple_of(SEIZE);
        let nombres = R::selon(S::f32s::LEN, S::f64s::LEN);
        let peu = avec_boite * voies <= PEU_PAR_NOMBRE * nombres * demandes.len();
        let minimum = if D::UN_SUFFIT { PEU_D_OMBRES } else { PEU_DE_RAYONS };
        if demandes.len() < minimum
            || !(peu || D::UN_SUFFIT || vont_ensemble(demandes))
            || !patience.essayer()
        {
            return false;
        }
        // A group of a block that has tried goes on with what it has found.
        if bloc.nombre == 0 {
            bloc.charger(demandes);
        }
        let jusqu_au_bout = if let Some(faisceau) = bloc.faisceau()
            && let Some(sonde) = SondeDeBloc::new(&faisceau, self.repere)
        {
            self.parcourir_en_bloc(simd, &sonde, bloc)
        } else {
            if peu {
                bloc.proposer_tous(self.objets);
            }
            peu
        };
        patience.noter(jusqu_au_bout);
        if jusqu_au_bout {
            bloc.ecrire(simd, self.objets, reponses);
        }
        jusqu_au_bout
    }

    /// How many times [`BEAUCOUP_DE_NOEUDS`] this tree has, rounded down, and 1 at least.
    #[inline(always)]
    fn abondance(&self) -> usize {
        (self.noeuds.len() / BEAUCOUP_DE_NOEUDS).max(1)
    }

    /// Finds the first object of each ray of a block, in the nodes that its beam crosses. Tells whether it
    /// came to the end; else what its rays have found so far stands.
    ///
    /// Where the beam may be too wide, the ray in the middle tells whether the rays one by one would cost more; a
    /// block of shadows gives up there.
    #[inline(always)]
    fn parcourir_en_bloc<S: Simd, D: Demande<R>>(
        &self,
        simd: S,
        sonde: &SondeDeBloc,
        bloc: &mut Bloc<'_, R, D>,
    ) -> bool {
        for &indice in self.sans_boite {
            bloc.proposer(self.objets, indice_lu(indice));
        }
        let mut attentes = [RIEN; GRANDE_PILE];
        let (mut pile, mut numero) = Pile::new(&mut attentes, self.geants, self.noeuds.len() - 1);
        let mut plafond = self.repere.distance(bloc.le_plus_loin());
        let trop = R::selon(TROP_DE_FEUILLES.0, TROP_DE_FEUILLES.1);
        let mut permis = R::selon(ASSEZ_D_OBJETS.0, ASSEZ_D_OBJETS.1) * bloc.groupes().len();
        let abondance = self.abondance();
        let (mut vus, mut pese) = (0, false);
        while let Some(noeud) = self.noeuds.get(numero) {
            let (mut traverses, Aligne(profondeurs)) = sonde.traverse(simd, noeud, plafond);
            let [.., indices] = noeud;
            let feuille = numero < self.feuilles;
            let trop_large = if feuille {
                vus += traverses.count_ones() as usize * abondance;
                vus > permis
            } else {
                !pese && traverses.count_ones() >= trop && indice_lu(indices[0]) < self.feuilles
            };
            if trop_large {
                // One shadow says little of the others: in calls of 64 up to 1.5 of the time (measured).
                if pese || D::UN_SUFFIT {
                    return false;
                }
                let selon_lui = self.objets_permis(simd, &bloc.milieu(), bloc.sauf);
                if selon_lui < permis.max(vus) {
                    return false;
                }
                (permis, pese) = (selon_lui, true);
            }
            if feuille {
                if traverses > 0 {
                    while let Some(enfant) = prendre(&mut traverses) {
                        bloc.proposer(self.objets, indice_lu(indices[enfant]));
                    }
                    let loin = bloc.le_plus_loin();
                    if D::UN_SUFFIT && loin == R::ZERO {
                        break;
                    }
                    plafond = self.repere.distance(loin);
                }
            } else if let Some(proche) = pile.garder(traverses, &profondeurs, noeud) {
                numero = proche;
                continue;
            }
            let Some(suivant) = pile.prendre(plafond) else { break };
            numero = suivant;
        }
        true
    }

    /// How many objects may be met by a block whose rays, one by one, take as many steps as this one.
    ///
    /// In the walk itself this would slow down tiles, which seldom ask it, by up to 1.05 (measured).
    #[cold]
    #[inline(never)]
    fn objets_permis<S: Simd>(&self, simd: S, rayon: &Rayon<R>, sauf: Option<usize>) -> usize {
        let mut pas = 0;
        simd.vectorize(
            #[inline(always)]
            || self.parcourir(simd, rayon, Premier::avant(R::INFINI), sauf, &mut pas),
        );
        pas * R::selon(OBJETS_PAR_PAS.0, OBJETS_PAR_PAS.1)
    }
}
