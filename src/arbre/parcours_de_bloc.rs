//! The rays of a block in a tree: together through the nodes that their beam crosses, as long as
//! that is narrow.

use core::mem;

use fearless_simd::prelude::*;

use crate::arbre::construction::Arbre;
use crate::arbre::noeud::{ENFANTS, Noeud, indice_lu};
use crate::arbre::pile::{Attentes, Pile};
use crate::arbre::sonde::{Sonde, SondeDeBloc};
use crate::colonne::{au_plus, prendre};
use crate::liste::Liste;
use crate::lot::bloc::{Bloc, EnLot};
use crate::lot::faisceau::vont_ailleurs;
use crate::nombre::Nombre;
use crate::question::Premier;
use crate::rayon::Rayon;

/// A block without a beam asks every object for all its rays if there are at most this many spheres
/// and boxes for each number that a register holds, beyond this part of the boxes that a ray
/// crosses (`benches/seuils.md`, "Thresholds", as for what follows).
const OBJETS_PAR_NOMBRE: usize = 6;
const PART_DES_CROISES: f32 = 0.6;

/// If more rays than this of some eight [go elsewhere](vont_ailleurs), it is not that a few stray.
const AILLEURS: usize = 1;

/// Fewer rays than this are asked one by one: eight in no order take up to twice as long together.
const RAYONS_D_UN_BLOC: usize = 12;

/// A beam that crosses fewer children of a node than this is not too wide.
const ENFANTS_CROISES: u32 = ENFANTS as u32 / 2;

/// How many rays of a block tell whether its beam is too wide. The more numbers a register holds,
/// the less it costs to ask an object for all rays, and the wider a beam may be.
const fn rayons_temoins(nombres_par_registre: usize) -> usize {
    2 + nombres_par_registre / 8
}

/// How many numbers of this type a register of these instructions holds.
#[inline(always)]
fn nombres_par_registre<R: Nombre, S: Simd>() -> usize {
    R::selon(S::f32s::LEN, S::f64s::LEN)
}

impl<R: Nombre> Arbre<'_, R> {
    /// The answers to the rays of a block: together if they are enough and their beam is narrow
    /// enough; else one by one, from what they have found so far.
    #[inline(always)]
    pub(crate) fn repondre_au_bloc<S: Simd, Q: EnLot<R>>(
        &self,
        simd: S,
        liste: &Liste<'_, R>,
        bloc: &mut Bloc<'_, R, Q>,
        (rayons, reponses): (&[Rayon<R>], &mut [Q::Reponse]),
    ) {
        let en_bloc = rayons.len() >= RAYONS_D_UN_BLOC;
        let ensemble = en_bloc && self.chercher_ensemble(simd, liste, bloc, rayons);
        if ensemble {
            bloc.repondre(simd, liste, reponses);
            if !bloc.a_des_egares() {
                return;
            }
        }
        simd.vectorize(
            #[inline(always)]
            || {
                for (i, (rayon, reponse)) in rayons.iter().zip(reponses).enumerate() {
                    let question = if !en_bloc || bloc.est_egare(i) {
                        self.parcourir(simd, liste, rayon, Premier::avant(rayon.fin()).into())
                    } else if ensemble {
                        continue;
                    } else if Q::UN_SUFFIT && bloc.premier(i).rang.is_some() {
                        bloc.premier(i).into()
                    } else {
                        self.descendre(simd, liste, rayon, bloc.premier(i).into())
                    };
                    *reponse = Q::repondre(question, rayon, liste.objets);
                }
            },
        );
    }

    /// Loads a block with these rays and looks for the first object of each. Tells whether it came
    /// to the end; else it has asked the objects without a box and some with one.
    #[inline(always)]
    pub(crate) fn chercher_ensemble<S: Simd, Q: EnLot<R>>(
        &self,
        simd: S,
        liste: &Liste<'_, R>,
        bloc: &mut Bloc<'_, R, Q>,
        rayons: &[Rayon<R>],
    ) -> bool {
        bloc.charger(rayons);
        let (ailleurs, mut sans_boite) = (vont_ailleurs(rayons), self.sans_boite);
        let mut vont_ensemble = ailleurs == 0;
        loop {
            let faisceau = if vont_ensemble { bloc.faisceau() } else { None };
            if let Some(faisceau) = &faisceau {
                let Some(sonde) = SondeDeBloc::new(faisceau, self.repere) else {
                    bloc.interroger(liste);
                    return true;
                };
                for &indice in mem::take(&mut sans_boite) {
                    bloc.proposer(liste, indice_lu(indice), true);
                }
                if self.descendre_en_bloc(simd, liste, &sonde, bloc) {
                    return true;
                }
            }
            // Once more without those that stray, if there are some.
            vont_ensemble =
                ailleurs <= AILLEURS && !bloc.a_des_egares() && bloc.ecarter_les_egares(simd);
            if !vont_ensemble {
                break;
            }
        }
        let la_liste = self.mieux_vaut_la_liste(simd, liste, bloc)
            || Sonde::new(&rayons[0], self.repere).is_none();
        if la_liste {
            bloc.interroger(liste);
        } else {
            for &indice in sans_boite {
                bloc.proposer(liste, indice_lu(indice), true);
            }
        }
        la_liste
    }

    /// Finds the first object with a box of each ray of a block, in the nodes that its beam
    /// crosses. Tells whether it came to the end; it gives up where its beam is too wide.
    #[inline(always)]
    fn descendre_en_bloc<S: Simd, Q: EnLot<R>>(
        &self,
        simd: S,
        liste: &Liste<'_, R>,
        sonde: &SondeDeBloc,
        bloc: &mut Bloc<'_, R, Q>,
    ) -> bool {
        let mut attentes = Attentes::new();
        let (mut pile, mut numero) = (Pile(&mut attentes), self.noeuds.len() - 1);
        let mut plafond = self.repere.distance(bloc.le_plus_loin());
        while let Some(noeud) = self.noeuds.get(numero) {
            let (mut traverses, profondeurs) = sonde.traverse(simd, noeud, plafond);
            if numero < self.feuilles {
                if traverses > 0 {
                    let [.., indices] = noeud;
                    while let Some(enfant) = prendre(&mut traverses) {
                        let source = profondeurs.0[enfant] == 0.0;
                        bloc.proposer(liste, indice_lu(indices[enfant]), source);
                    }
                    let loin = bloc.le_plus_loin();
                    if Q::UN_SUFFIT && loin == R::ZERO {
                        break;
                    }
                    plafond = self.repere.distance(loin);
                }
            } else {
                let croises = traverses.count_ones();
                if croises >= ENFANTS_CROISES
                    && croises > self.croises_par_les_temoins(simd, bloc, noeud)
                {
                    return false;
                }
                if let Some(proche) = pile.garder(traverses, &profondeurs.0, noeud) {
                    numero = proche;
                    continue;
                }
            }
            let Some(suivant) = pile.prendre(plafond) else { break };
            numero = suivant;
        }
        true
    }

    /// Whether rays side by side ask every object in less time than one by one in the tree: if
    /// there are few objects, or a heap, of which a ray crosses a good part.
    #[inline(always)]
    fn mieux_vaut_la_liste<S: Simd, Q: EnLot<R>>(
        &self,
        simd: S,
        liste: &Liste<'_, R>,
        bloc: &Bloc<'_, R, Q>,
    ) -> bool {
        let avec_boite = liste.objets.len() - self.sans_boite.len();
        let nombres = nombres_par_registre::<R, S>();
        let de_trop = avec_boite.saturating_sub(OBJETS_PAR_NOMBRE * nombres) as f32;
        // A ray that one object suffices asks few of those that it crosses.
        let croises = if Q::UN_SUFFIT { 0.0 } else { self.part_des_croises * avec_boite as f32 };
        let en_moins = croises * PART_DES_CROISES * nombres as f32;
        // Of the rays that meet the heap.
        de_trop == 0.0
            || de_trop <= en_moins && de_trop <= en_moins * self.part_qui_entre(simd, bloc)
    }

    /// What part of the children of the root a ray of this block crosses, about.
    fn part_qui_entre<S: Simd, Q: EnLot<R>>(&self, simd: S, bloc: &Bloc<'_, R, Q>) -> f32 {
        let Some(racine) = self.noeuds.last() else { return 0.0 };
        let croises = self.croises_par_les_temoins(simd, bloc, racine);
        let enfants = au_plus(simd, &racine[0], &racine[3]).count_ones();
        let rayons = rayons_temoins(nombres_par_registre::<R, S>());
        croises as f32 / (rayons as u32 * enfants) as f32
    }

    /// How many children of this node [some rays](rayons_temoins) of the block cross in all.
    #[cold]
    #[inline(never)]
    fn croises_par_les_temoins<S: Simd, Q: EnLot<R>>(
        &self,
        simd: S,
        bloc: &Bloc<'_, R, Q>,
        noeud: &Noeud,
    ) -> u32 {
        let (mut croises, loin) = (0, bloc.le_plus_loin());
        simd.vectorize(
            #[inline(always)]
            || {
                for rayon in bloc.rayons_epars(rayons_temoins(nombres_par_registre::<R, S>())) {
                    let Some(sonde) = Sonde::new(&rayon, self.repere) else { continue };
                    let plafond = sonde.plafond(self.repere, loin);
                    croises += sonde.traverse(simd, noeud, plafond).0.count_ones();
                }
            },
        );
        croises
    }
}
