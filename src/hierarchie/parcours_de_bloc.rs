//! The rays of a block together in the tree: the walk through the nodes that their beam crosses.

use fearless_simd::Simd;

use crate::hierarchie::construction::Arbre;
use crate::hierarchie::noeud::indice_lu;
use crate::hierarchie::pile::{GRANDE_PILE, Pile, RIEN};
use crate::hierarchie::sonde::SondeDeBloc;
use crate::lot::bloc::Bloc;
use crate::lot::demande::Demande;
use crate::premier::Premier;
use crate::reel::Reel;
use crate::seize::Aligne;

/// When a block has met so many objects in `f64`, or twice as many in `f32`, its rays are too far apart: from
/// there each walks alone, cut off at what it has found.
const ASSEZ_D_OBJETS: u32 = 112;

/// After this many blocks that did not try to walk together, one does.
const PAUSE: u32 = 31;

/// Which blocks of a call try to walk together. After a second that gave up in a row 3 do not, after a
/// third 15, and then 31: what a try in vain costs is spread over these.
#[derive(Default)]
pub(crate) struct Patience {
    abandons: u32,
    seuls: u32,
}

impl Patience {
    /// Whether the next block tries.
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
    /// The answers to the rays of a block.
    #[inline(always)]
    pub(crate) fn repondre_au_bloc<S: Simd, D: Demande<R>>(
        &self,
        simd: S,
        bloc: &mut Bloc<R, D>,
        (demandes, reponses): (&[D], &mut [D::Reponse]),
        patience: &mut Patience,
    ) {
        if patience.essayer()
            && let Some(faisceau) = bloc.faisceau()
            && let Some(sonde) = SondeDeBloc::new(&faisceau, self.repere)
        {
            let jusqu_au_bout = self.parcourir_en_bloc(simd, &sonde, bloc);
            patience.noter(jusqu_au_bout);
            if jusqu_au_bout {
                return bloc.ecrire(simd, self.objets, reponses);
            }
        }
        simd.vectorize(
            #[inline(always)]
            || {
                // What stands before the lamp of one ray often stands before that of the next.
                let mut dernier = Premier::avant(R::INFINI);
                for ((demande, mut premier), reponse) in
                    demandes.iter().zip(bloc.premiers()).zip(reponses)
                {
                    let rayon = demande.rayon();
                    if D::UN_SUFFIT && premier.rang.is_none() {
                        premier = dernier.encore(self.objets, rayon, premier);
                    }
                    if !D::UN_SUFFIT || premier.rang.is_none() {
                        premier = self.parcourir(simd, demande, premier, bloc.sauf);
                    }
                    if premier.rang.is_some() {
                        dernier = premier;
                    }
                    *reponse = D::conclure(premier, self.objets, rayon);
                }
            },
        );
    }

    /// Finds the first object of each ray of a block, in the nodes that its beam crosses. Tells whether it
    /// came to the end: if the rays go too far apart for one walk, what they have found so far stands.
    #[inline(always)]
    fn parcourir_en_bloc<S: Simd, D: Demande<R>>(
        &self,
        simd: S,
        sonde: &SondeDeBloc,
        bloc: &mut Bloc<R, D>,
    ) -> bool {
        for &indice in self.sans_boite {
            bloc.proposer(self.objets, indice_lu(indice), false);
        }
        let mut attentes = [RIEN; GRANDE_PILE];
        let (mut pile, mut numero) = Pile::new(&mut attentes, self.geants, self.noeuds.len() - 1);
        let mut plafond = self.repere.distance(bloc.le_plus_loin());
        let mut vus = 0;
        while let Some(noeud) = self.noeuds.get(numero) {
            let (traverses, Aligne(profondeurs)) = sonde.traverse(simd, noeud, plafond);
            if numero < self.feuilles {
                if traverses.nombre() > 0 {
                    vus += traverses.nombre();
                    if vus > R::selon(2 * ASSEZ_D_OBJETS, ASSEZ_D_OBJETS) {
                        return false;
                    }
                    let [.., indices] = noeud;
                    for enfant in traverses {
                        bloc.proposer(self.objets, indice_lu(indices[enfant]), false);
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
}
