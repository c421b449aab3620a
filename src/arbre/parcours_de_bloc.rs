//! The rays of a block in a tree: together through the nodes that their probe enters, as long as
//! that is narrow.

use core::iter::from_fn;
use core::ops::ControlFlow::{Break, Continue};

use fearless_simd::prelude::*;

use crate::algebre::nombre::{max, selon};
use crate::arbre::Arbre;
use crate::arbre::budget::{Budget, NOEUD_D_UN_BLOC, Releve};
use crate::arbre::marche::Etape;
use crate::arbre::morceaux::Coupe;
use crate::arbre::noeud::{ENFANTS, Noeud, indice_lu};
use crate::arbre::pesee::{Pesee, Prix};
use crate::arbre::sonde::Sonde;
use crate::cote_a_cote::bloc::{BLOC, Bloc, Ensemble, GROUPES};
use crate::cote_a_cote::colonne::{au_plus, retirer};
use crate::cote_a_cote::groupe::VOIES;
use crate::question::Premier;
use crate::question::liste::Liste;
use crate::{Nombre, ObjetRay, Rayon};

/// Fewer rays than this are asked one by one (`benches/essais.md`, "Thresholds", as for what follows).
const MOINDRE_BLOC: usize = 12;

/// Rays that are left apart ask this many objects without a box side by side, and fewer one by one.
const SANS_BOITE: usize = 4;

/// Sixteen rays are tried alone where their probe is at most this many times as wide as that of
/// their block.
const PLUS_ETROIT: f32 = 0.6;

/// A probe that enters fewer children of a node than this is not too wide.
const ENFANTS_CROISES: u32 = ENFANTS as u32 / 2;

/// How many rays of a block are asked alone to find out what they spend, and how many objects tell
/// whether they come near.
const PESES: usize = 4;
const OBJETS_CHOISIS: usize = 16;

/// How many rays of a block tell whether its probe is too wide. The more numbers a register holds,
/// the less it costs to ask an object for all rays, and the wider a probe may be.
const fn combien_d_echantillons(nombres_par_registre: usize) -> usize {
    2 + nombres_par_registre / 8
}

/// As many of these rays, evenly spread.
#[inline(always)]
fn quelques<R>(rayons: &[Rayon<R>], combien: usize) -> impl Iterator<Item = &Rayon<R>> {
    (0..combien).map(move |k| &rayons[(2 * k + 1) * rayons.len() / (2 * combien)])
}

/// The rays that are weighed, one of each quarter. Neither in a block nor from one weighing to the
/// next do they stand in one rhythm, in which the rays of a call may differ: to one lamp and to
/// others by turns.
#[inline(always)]
fn peses<R>(rayons: &[Rayon<R>], pesees: usize) -> impl Iterator<Item = &Rayon<R>> {
    const QUART: usize = BLOC / PESES;
    (0..PESES).map(move |k| {
        let place = k * QUART + (QUART / 2 + 5 * k + 7 * pesees) % QUART;
        &rayons[place * rayons.len() / BLOC]
    })
}

/// How the walk of a block ended.
enum Issue {
    AuBout,
    /// The probe is too wide.
    TropLarge,
    /// It has spent more than its rays would.
    TropCher,
}

/// Objects that were offered to a block, the last of those whose index ends in the same six bits. A
/// tree may hold an object in several pieces, and a block need ask it but once.
struct Offerts([u32; 64]);

impl Offerts {
    /// Notes that this object is offered; `source` says whether it may hold the source of a ray.
    /// Returns whether that is new: whether it was not offered before, or not as one that may hold a
    /// source.
    #[inline(always)]
    fn est_nouveau(&mut self, indice: usize, source: bool) -> bool {
        let (place, ici) = (&mut self.0[indice % 64], 2 * indice as u32 + 2 + u32::from(source));
        let vu = *place == ici || *place == (ici | 1);
        *place = if vu { *place } else { ici };
        !vu
    }
}

impl<R: Nombre> Arbre<'_, R> {
    /// What the blocks of a call may spend, before the first.
    pub(crate) fn budget<S: Simd>(&self, _: S, liste: &Liste<'_, R>) -> Budget {
        let avec_boite = liste.objets.len() - self.sans_boite.len();
        Budget::new(avec_boite, size_of::<R>(), size_of::<f32>() * S::f32s::LEN)
    }

    /// Looks for the first objects of these rays, together or else by groups whose probe is
    /// narrower, within the budget. Tells of each group how far it came.
    #[inline(always)]
    pub(crate) fn chercher_ensemble<S: Simd>(
        &self,
        simd: S,
        liste: &Liste<'_, R>,
        (budget, bloc): (&mut Budget, &mut Bloc<'_, R>),
        rayons: &[Rayon<R>],
    ) -> [Ensemble; GROUPES] {
        simd.vectorize(
            #[inline(always)]
            || {
                if rayons.len() < MOINDRE_BLOC {
                    return [Ensemble::Rien; GROUPES];
                }
                // Eight rays show whether the block is too wide, before the others are loaded.
                let au_moins = || Sonde::largeur_au_moins(quelques(rayons, 8), self.repere);
                let a_part = budget.est_entame() && budget.est_trop_large(au_moins());
                if a_part {
                    budget.laisser();
                    self.peser_au_besoin(simd, liste, budget, bloc, rayons);
                    if self.sans_boite.len() < SANS_BOITE {
                        return [Ensemble::Rien; GROUPES];
                    }
                }
                bloc.charger(rayons);
                bloc.proposer_tous(simd, liste, self.sans_boite());
                if a_part {
                    return [Ensemble::EnPartie; GROUPES];
                }
                let (sonde, largeur) = self.sonde_du_bloc(simd, bloc);
                let issue = if budget.est_trop_large(largeur) {
                    budget.laisser();
                    Issue::TropLarge
                } else if let Some(sonde) = sonde {
                    let sonde = (sonde, largeur);
                    self.descendre_en_bloc(simd, liste, sonde, (budget, bloc), rayons)
                } else {
                    // No probe of all of them tells boxes apart.
                    self.peser_au_besoin(simd, liste, budget, bloc, rayons);
                    if budget.suffit_a_la_liste() {
                        bloc.proposer_tous(simd, liste, self.avec_boite(liste));
                        Issue::AuBout
                    } else {
                        budget.reculer(largeur, 1.0);
                        Issue::TropLarge
                    }
                };
                match issue {
                    Issue::AuBout => [Ensemble::JusquAuBout; GROUPES],
                    Issue::TropCher => [Ensemble::EnPartie; GROUPES],
                    Issue::TropLarge => {
                        self.chercher_par_groupes(simd, liste, largeur, (budget, bloc), rayons)
                    }
                }
            },
        )
    }

    /// Goes on with each group whose probe is narrower than that of the block.
    #[inline(always)]
    fn chercher_par_groupes<S: Simd>(
        &self,
        simd: S,
        liste: &Liste<'_, R>,
        du_bloc: f32,
        (budget, bloc): (&mut Budget, &mut Bloc<'_, R>),
        rayons: &[Rayon<R>],
    ) -> [Ensemble; GROUPES] {
        let mut groupes = [Ensemble::EnPartie; GROUPES];
        for (i, (rayons, groupe)) in rayons.chunks(VOIES).zip(&mut groupes).enumerate() {
            bloc.demandes = i..i + 1;
            let (sonde, largeur) = self.sonde_du_bloc(simd, bloc);
            let etroite = largeur <= PLUS_ETROIT * du_bloc && !budget.est_trop_large(largeur);
            if let Some(sonde) = sonde.filter(|_| etroite) {
                let sonde = (sonde, largeur);
                let issue = self.descendre_en_bloc(simd, liste, sonde, (budget, bloc), rayons);
                if let Issue::AuBout = issue {
                    *groupe = Ensemble::JusquAuBout;
                }
            }
        }
        groupes
    }

    /// The probe of the rays that are offered objects, and how wide it is.
    #[inline(always)]
    fn sonde_du_bloc<S: Simd>(&self, simd: S, bloc: &Bloc<'_, R>) -> (Option<Sonde<R>>, f32) {
        let groupes = bloc.groupes_demandes();
        let tau0 = Sonde::tau0_commun(groupes, self.repere);
        Sonde::de_groupes(simd, groupes, tau0, self.repere)
    }

    /// Finds the first object with a box of each of these rays, which are offered objects, in the
    /// nodes that their probe enters, until it is too wide, or more is spent than permitted.
    #[inline(always)]
    fn descendre_en_bloc<S: Simd>(
        &self,
        simd: S,
        liste: &Liste<'_, R>,
        (sonde, largeur): (Sonde<R>, f32),
        (budget, bloc): (&mut Budget, &mut Bloc<'_, R>),
        rayons: &[Rayon<R>],
    ) -> Issue {
        let loin = bloc.le_plus_loin();
        if bloc.un_suffit && loin == R::ZERO {
            return Issue::AuBout;
        }
        if budget.suffit_par_une_pesee() {
            // Else nothing would ever stop the blocks of a call whose first rays were dear.
            self.peser_au_besoin(simd, liste, budget, bloc, rayons);
        }
        let (mut depense, mut permis, mut peses) = (0.0, budget.permis(rayons.len()), false);
        let par_objet = bloc.demandes.len() as Prix * budget.objet_proche;
        let mut offerts = Offerts([0; 64]);
        let marche = self.marcher(
            simd,
            &sonde,
            sonde.plafond(self.repere, loin),
            #[inline(always)]
            |etape, plafond| {
                depense += NOEUD_D_UN_BLOC;
                let entres = etape.enfants.count_ones();
                if !etape.est_une_feuille {
                    let large = entres >= ENFANTS_CROISES && permis < Prix::INFINITY && {
                        let loin = bloc.le_plus_loin();
                        entres > self.croises_par_quelques_uns(simd, rayons, loin, etape.noeud)
                    };
                    return if large { Break(Issue::TropLarge) } else { Continue(()) };
                }
                if entres == 0 {
                    return Continue(());
                }
                depense += entres as Prix * par_objet;
                if depense > permis && !peses {
                    // What the budget knows may come from the rays of other blocks.
                    peses = true;
                    self.peser(simd, liste, budget, bloc.un_suffit, rayons);
                    permis = budget.permis(rayons.len());
                }
                if depense > permis {
                    return Break(Issue::TropCher);
                }
                self.offrir_une_feuille(simd, liste, &sonde, etape, (&mut offerts, bloc));
                let loin = bloc.le_plus_loin();
                if bloc.un_suffit && loin == R::ZERO {
                    return Break(Issue::AuBout);
                }
                *plafond = sonde.plafond(self.repere, loin);
                Continue(())
            },
        );
        let issue = marche.break_value().unwrap_or(Issue::AuBout);
        let part = bloc.demandes.len() as f32 / GROUPES as f32;
        match issue {
            Issue::AuBout => budget.avancer(largeur, part, depense / rayons.len() as Prix),
            Issue::TropCher => budget.reculer(largeur, part),
            Issue::TropLarge => (),
        }
        issue
    }

    /// Offers the rays the objects of a leaf whose boxes their probe enters.
    #[inline(always)]
    fn offrir_une_feuille<S: Simd>(
        &self,
        simd: S,
        liste: &Liste<'_, R>,
        sonde: &Sonde<R>,
        Etape { noeud: [.., indices], mut enfants, entrees, .. }: Etape<'_>,
        (offerts, bloc): (&mut Offerts, &mut Bloc<'_, R>),
    ) {
        let entiers = self.coupe == Coupe::AUCUNE;
        let sources = au_plus(simd, entrees, sonde.entree_de_la_source());
        let suivant = || loop {
            let enfant = retirer(&mut enfants)?;
            let (indice, source) = (indice_lu(indices[enfant]), (sources >> enfant) & 1 == 1);
            if entiers || offerts.est_nouveau(indice, source) {
                return Some((indice, source));
            }
        };
        bloc.proposer(simd, liste, &mut from_fn(suivant));
    }

    /// Weighs some of these rays, if none were lately.
    #[inline(always)]
    fn peser_au_besoin<S: Simd>(
        &self,
        simd: S,
        liste: &Liste<'_, R>,
        budget: &mut Budget,
        bloc: &Bloc<'_, R>,
        rayons: &[Rayon<R>],
    ) {
        if !budget.est_a_jour() {
            self.peser(simd, liste, budget, bloc.un_suffit, rayons);
        }
    }

    /// Asks some of these rays alone, and of how many of some objects they come near.
    #[cold]
    #[inline(never)]
    fn peser<S: Simd>(
        &self,
        simd: S,
        liste: &Liste<'_, R>,
        budget: &mut Budget,
        un_suffit: bool,
        rayons: &[Rayon<R>],
    ) {
        simd.vectorize(
            #[inline(always)]
            || {
                let (mut combien, mut depense, mut plus_chere) = (0.0, 0.0, 0.0);
                for rayon in peses(rayons, budget.pesees) {
                    let fin = rayon.fin();
                    let ici = if un_suffit {
                        let ombre = Pesee::de(Premier::<R, true>::avant(fin));
                        self.parcourir(simd, liste, rayon, ombre).depense
                    } else {
                        let premier = Pesee::de(Premier::<R>::avant(fin));
                        self.parcourir(simd, liste, rayon, premier).depense
                    };
                    (combien, depense, plus_chere) =
                        (combien + 1.0, depense + ici, max(plus_chere, ici));
                    // Two rays of a heap take as long as some blocks.
                    if budget.suffirait_a_la_liste((depense - plus_chere) / (PESES - 1) as Prix) {
                        break;
                    }
                }
                // Without the dearest: one ray that slips through the others to a pile of boxes
                // would pay for a block that is offered all of the pile.
                let seul = (depense - plus_chere) / max(combien - 1.0, 1.0);
                let (proches, boites) = parts(liste.objets, || peses(rayons, budget.pesees));
                budget.noter(Releve { seul, proches, boites });
            },
        );
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
                let nombres_par_registre = selon::<R, _>(S::f32s::LEN, S::f64s::LEN);
                let combien = combien_d_echantillons(nombres_par_registre);
                for rayon in quelques(rayons, combien) {
                    let Some(sonde) = Sonde::new(rayon, self.repere) else { continue };
                    let plafond = sonde.plafond(self.repere, loin);
                    croises += sonde.traverse(simd, noeud, plafond).0.count_ones();
                }
            },
        );
        croises
    }
}

/// What part of some objects with a box some of these rays come near, and what part of those
/// objects are boxes.
#[inline(always)]
fn parts<'a, R: Nombre, I: Iterator<Item = &'a Rayon<R>>>(
    objets: &[ObjetRay<R>],
    rayons: impl Fn() -> I,
) -> (f32, f32) {
    // As if one more ray came near one more object: that none does is not certain.
    let (mut paires, mut proches, mut choisis, mut boites) = (1.0, 1.0, 0.0, 0.0);
    for objet in objets.iter().step_by(objets.len() / OBJETS_CHOISIS + 1) {
        match objet {
            ObjetRay::Sphere(_) => (),
            ObjetRay::Boite(_) => boites += 1.0,
            ObjetRay::Plan(_) => continue,
        }
        choisis += 1.0;
        for rayon in rayons() {
            paires += 1.0;
            proches += f32::from(u8::from(objet.peut_entrer(rayon)));
        }
    }
    (proches / paires, boites / max(choisis, 1.0))
}
