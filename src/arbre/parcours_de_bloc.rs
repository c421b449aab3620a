//! The rays of a block in a tree: together through the nodes that their probe enters, as long as
//! that is narrow.

use core::iter::from_fn;

use fearless_simd::prelude::*;

use crate::algebre::nombre::selon;
use crate::arbre::construction::Arbre;
use crate::arbre::morceaux::Coupe;
use crate::arbre::noeud::{ENFANTS, Noeud, indice_lu};
use crate::arbre::pile::{Attentes, Pile};
use crate::arbre::sonde::Sonde;
use crate::cote_a_cote::bloc::{Bloc, Ensemble, GROUPES};
use crate::cote_a_cote::colonne::{au_plus, prendre};
use crate::cote_a_cote::groupe::VOIES;
use crate::question::liste::Liste;
use crate::{Nombre, Rayon};

/// Rays that do not stay together ask the whole list side by side if it is short: at most this many
/// spheres and boxes for each number that a register holds (`DEVELOPING.md`, "Thresholds", as
/// for what follows).
const OBJETS_PAR_NOMBRE: usize = 6;

/// In a heap a longer list will do: for each number that a register holds, longer by this part of
/// the number of boxes that a ray crosses.
const OBJETS_PAR_CROISE: f32 = 0.6;

/// Fewer rays than this are asked one by one: eight in no order take up to twice as long together.
const MOINDRE_BLOC: usize = 12;

/// A ray goes elsewhere if the cosine between it and the ray in the middle is no more than this.
const COSINUS_MINIMAL: f64 = 0.25;

/// If more rays than this of some eight go elsewhere, the groups of a block do not stay together
/// either.
const AILLEURS: usize = 1;

/// Sixteen rays are tried alone where their probe is at most this many times as wide as that of
/// their block.
const PLUS_ETROIT: f32 = 0.6;

/// A probe that enters fewer children of a node than this is not too wide.
const ENFANTS_CROISES: u32 = ENFANTS as u32 / 2;

/// How many rays of a block tell whether its probe is too wide. The more numbers a register holds,
/// the less it costs to ask an object for all rays, and the wider a probe may be.
const fn combien_d_echantillons(nombres_par_registre: usize) -> usize {
    2 + nombres_par_registre / 8
}

/// How many numbers of this type a register of these instructions holds.
#[inline(always)]
fn nombres_par_registre<R: Nombre, S: Simd>() -> usize {
    selon::<R, _>(S::f32s::LEN, S::f64s::LEN)
}

/// How many of at most eight of these rays, evenly spread, go elsewhere than the one in the middle.
/// Rays in no order are refused here, before anything else is made of them.
#[inline(always)]
fn vont_ailleurs<R: Nombre>(rayons: &[Rayon<R>]) -> usize {
    let milieu = rayons[rayons.len() / 2].direction();
    let quelques = rayons.iter().step_by(rayons.len() / 8 + 1);
    let minimal = R::depuis_f64(COSINUS_MINIMAL);
    quelques.filter(|rayon| rayon.direction().produit_scalaire(milieu) <= minimal).count()
}

/// Objects that were offered to a block, the last of those whose index ends in the same six bits. A
/// tree may hold an object in several pieces, and a block need ask it but once.
struct Offerts([u32; 64]);

impl Offerts {
    /// Whether it is not known that this object was offered, to rays that it may hold the source of
    /// if it may now; it is from then on.
    #[inline(always)]
    fn est_nouveau(&mut self, indice: usize, source: bool) -> bool {
        let (place, ici) = (&mut self.0[indice % 64], 2 * indice as u32 + 2 + u32::from(source));
        let vu = *place == ici || *place == (ici | 1);
        *place = if vu { *place } else { ici };
        !vu
    }
}

impl<R: Nombre> Arbre<'_, R> {
    /// Looks for the first object of each of these rays: of all together, else of each group that
    /// is narrower. Tells of each group how far it came.
    #[inline(always)]
    pub(crate) fn chercher_ensemble<S: Simd>(
        &self,
        simd: S,
        liste: &Liste<'_, R>,
        bloc: &mut Bloc<'_, R>,
        rayons: &[Rayon<R>],
    ) -> [Ensemble; GROUPES] {
        simd.vectorize(
            #[inline(always)]
            || {
                if rayons.len() < MOINDRE_BLOC {
                    return [Ensemble::Rien; GROUPES];
                }
                let (ailleurs, un_suffit) = (vont_ailleurs(rayons), bloc.un_suffit);
                let vaut_la_liste = || self.mieux_vaut_la_liste(simd, liste, un_suffit, rayons);
                let mut en_liste = ailleurs > 0 && vaut_la_liste();
                if ailleurs > AILLEURS && !en_liste {
                    return [Ensemble::Rien; GROUPES];
                }
                bloc.charger(rayons);
                if !en_liste {
                    let mut sans_boite = self.sans_boite.iter().map(|mot| (indice_lu(*mot), true));
                    bloc.proposer(simd, liste, &mut sans_boite);
                }
                let mut largeur = f32::INFINITY;
                if ailleurs == 0 {
                    let (sonde, de_tous) = self.sonder(simd, bloc);
                    if self.descendre_en_bloc(simd, liste, sonde, (bloc, rayons)) {
                        return [Ensemble::JusquAuBout; GROUPES];
                    }
                    largeur = PLUS_ETROIT * de_tous;
                    en_liste = vaut_la_liste();
                }
                if en_liste {
                    bloc.proposer_la_liste(simd, liste);
                    return [Ensemble::JusquAuBout; GROUPES];
                }
                let mut groupes = [Ensemble::EnPartie; GROUPES];
                for (i, (rayons, groupe)) in rayons.chunks(VOIES).zip(&mut groupes).enumerate() {
                    bloc.demandes = i..i + 1;
                    let (sonde, la_sienne) = self.sonder(simd, bloc);
                    let sonde = sonde.filter(|_| la_sienne <= largeur);
                    if self.descendre_en_bloc(simd, liste, sonde, (bloc, rayons)) {
                        *groupe = Ensemble::JusquAuBout;
                    }
                }
                groupes
            },
        )
    }

    /// The probe of the rays that are offered objects, and how wide it is.
    #[inline(always)]
    fn sonder<S: Simd>(&self, simd: S, bloc: &Bloc<'_, R>) -> (Option<Sonde<R>>, f32) {
        let tau0 = Sonde::tau0_commun(bloc.demandes(), self.repere);
        Sonde::de_groupes(simd, bloc.demandes(), tau0, self.repere)
    }

    /// Finds the first object with a box of each of these rays, which are offered objects, in the
    /// nodes that their probe enters. Tells whether it came to the end; it gives up where there is
    /// no probe or it is too wide.
    #[inline(always)]
    fn descendre_en_bloc<S: Simd>(
        &self,
        simd: S,
        liste: &Liste<'_, R>,
        sonde: Option<Sonde<R>>,
        (bloc, rayons): (&mut Bloc<'_, R>, &[Rayon<R>]),
    ) -> bool {
        let Some(sonde) = sonde else { return false };
        let mut attentes = Attentes::new();
        let (mut pile, mut numero) = (Pile(&mut attentes), self.noeuds.len() - 1);
        let (entiers, mut offerts_deja) = (self.coupe == Coupe::AUCUNE, Offerts([0; 64]));
        let mut plafond = sonde.plafond(self.repere, bloc.le_plus_loin());
        while let Some(noeud) = self.noeuds.get(numero) {
            let (mut traverses, entrees) = sonde.traverse(simd, noeud, plafond);
            if numero < self.feuilles {
                if traverses > 0 {
                    let [.., mots] = noeud;
                    let source = [sonde.entree_de_la_source(); ENFANTS];
                    let sources = au_plus(simd, &entrees.0, &source);
                    let offerts = || loop {
                        let membre = prendre(&mut traverses)?;
                        let (indice, source) =
                            (indice_lu(mots[membre]), (sources >> membre) & 1 == 1);
                        if entiers || offerts_deja.est_nouveau(indice, source) {
                            return Some((indice, source));
                        }
                    };
                    bloc.proposer(simd, liste, &mut from_fn(offerts));
                    let loin = bloc.le_plus_loin();
                    if bloc.un_suffit && loin == R::ZERO {
                        break;
                    }
                    plafond = sonde.plafond(self.repere, loin);
                }
            } else {
                let croises = traverses.count_ones();
                if croises >= ENFANTS_CROISES
                    && croises
                        > self.croises_par_quelques_uns(simd, rayons, bloc.le_plus_loin(), noeud)
                {
                    return false;
                }
                if let Some(proche) = pile.garder(traverses, &entrees.0, noeud) {
                    numero = proche;
                    continue;
                }
            }
            let Some(suivant) = pile.prendre(plafond) else { break };
            numero = suivant;
        }
        true
    }

    /// Whether it takes less time to ask all objects for these rays side by side than to send the
    /// rays through the tree one by one. It does if there are few objects, in a heap, most of whose
    /// boxes a ray crosses, and where boxes tell no objects apart.
    fn mieux_vaut_la_liste<S: Simd>(
        &self,
        simd: S,
        liste: &Liste<'_, R>,
        un_suffit: bool,
        rayons: &[Rayon<R>],
    ) -> bool {
        let avec_boite = liste.objets.len() - self.sans_boite.len();
        let nombres = nombres_par_registre::<R, S>();
        let de_trop = avec_boite.saturating_sub(OBJETS_PAR_NOMBRE * nombres) as f32;
        // A shadow ray asks few of the objects that it crosses.
        let croises = if un_suffit { 0.0 } else { self.part_des_croises * avec_boite as f32 };
        let en_moins = croises * OBJETS_PAR_CROISE * nombres as f32;
        // Only rays that meet the heap count.
        de_trop == 0.0
            || de_trop <= en_moins && de_trop <= en_moins * self.part_qui_entre(simd, rayons)
            || Sonde::new(&rayons[0], self.repere).is_none() && self.approche(&rayons[0])
    }

    /// What part of the children of the root one of these rays crosses, about.
    fn part_qui_entre<S: Simd>(&self, simd: S, rayons: &[Rayon<R>]) -> f32 {
        let Some(racine) = self.noeuds.last() else { return 0.0 };
        let croises = self.croises_par_quelques_uns(simd, rayons, R::INFINI, racine);
        let enfants = au_plus(simd, &racine[0], &racine[3]).count_ones();
        let combien = combien_d_echantillons(nombres_par_registre::<R, S>());
        croises as f32 / (combien as u32 * enfants) as f32
    }

    /// How many children of this node [some](combien_d_echantillons) of these rays, evenly spread,
    /// cross in all before this distance.
    #[cold]
    #[inline(never)]
    fn croises_par_quelques_uns<S: Simd>(
        &self,
        simd: S,
        rayons: &[Rayon<R>],
        loin: R,
        noeud: &Noeud,
    ) -> u32 {
        let mut croises = 0;
        simd.vectorize(
            #[inline(always)]
            || {
                let combien = combien_d_echantillons(nombres_par_registre::<R, S>());
                for i in 0..combien {
                    let rayon = &rayons[i * (rayons.len() - 1) / (combien - 1)];
                    let Some(sonde) = Sonde::new(rayon, self.repere) else { continue };
                    let plafond = sonde.plafond(self.repere, loin);
                    croises += sonde.traverse(simd, noeud, plafond).0.count_ones();
                }
            },
        );
        croises
    }
}
