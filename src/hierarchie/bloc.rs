//! A block of rays in the tree: the walk through the nodes that its beam crosses.

use fearless_simd::Simd;

use crate::hierarchie::construction::Arbre;
use crate::hierarchie::noeud::indice_lu;
use crate::hierarchie::pile::{GRANDE_PILE, Pile, RIEN};
use crate::hierarchie::sonde::SondeDeBloc;
use crate::intersection::Touche;
use crate::lot::bloc::Bloc;
use crate::reel::Reel;
use crate::seize::Aligne;

/// When a block has seen so many objects, its rays are too far apart: from there each walks alone,
/// cut off at what it has found.
const ASSEZ_D_OBJETS: f64 = 112.0;

/// The same for a beam as wide as it is far; the wider, the sooner.
const ASSEZ_SI_LARGE: f64 = 20.0;

/// In so small a tree a block never sees too many: 320 objects in `f32`, 160 in `f64`, where
/// sixteen rays side by side take twice as long.
const PETIT_ARBRE: usize = 1280;

/// The rays of a block go too far apart for one walk. What they have found so far stands.
struct TropLoinLUnDeLAutre;

impl<R: Reel> Arbre<'_, R> {
    /// The answers to the rays of a block.
    #[inline(always)]
    pub(crate) fn repondre_au_bloc<S: Simd>(
        &self,
        simd: S,
        bloc: &mut Bloc<'_, R>,
        touches: &mut [Touche<R>],
    ) {
        match self.parcourir_ensemble(simd, bloc) {
            Ok(()) => bloc.ecrire(simd, self.objets, touches),
            Err(TropLoinLUnDeLAutre) => simd.vectorize(
                #[inline(always)]
                || {
                    for ((rayon, premier), touche) in bloc.premiers().zip(touches) {
                        let premier = self.parcourir::<S, false>(simd, rayon, premier);
                        *touche = premier.conclure(self.objets, rayon);
                    }
                },
            ),
        }
    }

    /// Finds the first object of each ray of a block, in the nodes that its beam crosses.
    #[inline(always)]
    fn parcourir_ensemble<S: Simd>(
        &self,
        simd: S,
        bloc: &mut Bloc<'_, R>,
    ) -> Result<(), TropLoinLUnDeLAutre> {
        let faisceau = bloc.faisceau().ok_or(TropLoinLUnDeLAutre)?;
        let sonde = SondeDeBloc::new(&faisceau, self.repere).ok_or(TropLoinLUnDeLAutre)?;
        for &indice in self.plans {
            self.proposer(bloc, indice_lu(indice));
        }
        let mut attentes = [RIEN; GRANDE_PILE];
        let (mut pile, mut numero) = Pile::new(&mut attentes, self.geants, self.racine);
        let mut plafond = self.repere.distance(bloc.le_plus_loin());
        let assez = if self.objets.len() <= PETIT_ARBRE / size_of::<R>() {
            f64::INFINITY
        } else {
            (ASSEZ_SI_LARGE / faisceau.largeur.vers_f64()).min(ASSEZ_D_OBJETS)
        };
        let mut vus = 0;
        while let Some(noeud) = self.noeuds.get(numero) {
            let (traverses, Aligne(profondeurs)) = sonde.traverse(simd, noeud, plafond);
            if numero < self.feuilles {
                if traverses.le_premier().is_some() {
                    vus += traverses.nombre();
                    if f64::from(vus) > assez {
                        return Err(TropLoinLUnDeLAutre);
                    }
                    let [.., indices] = noeud;
                    for enfant in traverses {
                        self.proposer(bloc, indice_lu(indices[enfant]));
                    }
                    plafond = self.repere.distance(bloc.le_plus_loin());
                }
            } else if let Some(proche) = pile.garder(traverses, &profondeurs, noeud) {
                numero = proche;
                continue;
            }
            let Some(suivant) = pile.prendre(plafond) else { break };
            numero = suivant;
        }
        Ok(())
    }

    /// Proposes the object of this index to the block.
    #[inline(always)]
    fn proposer(&self, bloc: &mut Bloc<'_, R>, indice: usize) {
        if let Some(objet) = self.objets.get(indice) {
            bloc.proposer::<false>(objet, indice);
        }
    }
}
