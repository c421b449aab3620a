//! A block of rays and the nodes that its beam crosses.

use fearless_simd::Simd;

use crate::hierarchie::construction::{Arbre, Colonne, ENFANTS, Noeud, premier_enfant, somme};
use crate::hierarchie::parcours::{GRANDE_PILE, Pile, le_premier};
use crate::intersection::{Touche, rang};
use crate::lot::colonnes::{EnLigne, VOIES, max};
use crate::lot::faisceau::Faisceau;
use crate::lot::groupe::Groupe;
use crate::lot::{Recherche, Trouve, proposer};
use crate::objet::ObjetRay;
use crate::rayon::Rayon;
use crate::reel::{Reel, fois_u};
use crate::vecteur::Vecteur;

/// Up to so many objects a block without a beam is asked about all of them; of more, each ray walks alone
/// (measured).
const SEUIL_SEULS: usize = 100;

/// When a block has seen so many objects, its rays are too far apart: from there each walks alone, cut off
/// at what it has found (measured).
const ASSEZ_D_OBJETS: u32 = 128;

/// If the root has fewer children than this, they do not tell how wide a beam is, and their children
/// are counted instead.
const PEU_D_ENFANTS: u32 = 8;

/// In a tree: the nodes that the beam of the block crosses.
pub(crate) struct RechercheDansLArbre<'a, R, S> {
    pub(crate) simd: S,
    pub(crate) objets: &'a [ObjetRay<R>],
    pub(crate) arbre: &'a Arbre<'a, R>,
}

impl<R: Reel, S: Simd> Recherche<R> for RechercheDansLArbre<'_, R, S> {
    #[inline(always)]
    fn chercher(
        &mut self,
        bloc: &mut [Groupe<R>],
        rayons: &[Rayon<R>],
        touches: &mut [Touche<R>],
    ) -> Trouve {
        let Self { simd, objets, arbre } = *self;
        let sonde = SondeDeBloc::etroite(simd, rayons, bloc, arbre);
        if sonde.is_none() && arbre.objets > SEUIL_SEULS {
            return un_par_un(simd, objets, arbre, bloc, rayons, touches);
        }
        // Behind the objects with an end stand the half-spaces.
        let premier = if sonde.is_some() { arbre.bornes } else { 0 };
        for place in premier..arbre.objets {
            proposer_place(arbre, objets, bloc, place);
        }
        let (Some(sonde), Some(racine)) = (sonde, arbre.racine) else {
            return Trouve::DansLeBloc;
        };
        let mut profondeurs = EnLigne([R::ZERO; ENFANTS]);
        let EnLigne(profondeurs) = &mut profondeurs;
        let mut pile = Pile::<R, GRANDE_PILE>::VIDE;
        let mut plafond = le_plus_loin(bloc);
        let mut rang = racine;
        let mut vus = 0;
        while let Some(noeud) = arbre.noeuds.get(rang) {
            let mut traverses = sonde.traverse(simd, noeud, plafond, profondeurs);
            if rang < arbre.feuilles {
                if traverses != 0 {
                    vus += traverses.count_ones();
                    if vus > ASSEZ_D_OBJETS {
                        return un_par_un(simd, objets, arbre, bloc, rayons, touches);
                    }
                    while traverses != 0 {
                        let enfant = le_premier(traverses);
                        traverses &= traverses - 1;
                        proposer_place(arbre, objets, bloc, rang * ENFANTS + enfant);
                    }
                    plafond = le_plus_loin(bloc);
                }
            } else if let Some(proche) = pile.garder(traverses, profondeurs, noeud) {
                rang = proche;
                continue;
            }
            let Some(suivant) = pile.prendre(plafond) else { break };
            rang = suivant;
        }
        Trouve::DansLeBloc
    }
}

/// Asks each ray alone, which knows its first object so far.
#[inline(always)]
fn un_par_un<R: Reel, S: Simd>(
    simd: S,
    objets: &[ObjetRay<R>],
    arbre: &Arbre<'_, R>,
    bloc: &[Groupe<R>],
    rayons: &[Rayon<R>],
    touches: &mut [Touche<R>],
) -> Trouve {
    for (i, (rayon, touche)) in rayons.iter().zip(touches).enumerate() {
        let premier = bloc[i / VOIES].premier(i % VOIES);
        *touche = arbre.premiere_intersection(simd, objets, rayon, premier);
    }
    Trouve::DansLesTouches
}

/// Proposes to the block the object in this place among the leaves.
#[inline(always)]
fn proposer_place<R: Reel>(
    arbre: &Arbre<'_, R>,
    objets: &[ObjetRay<R>],
    bloc: &mut [Groupe<R>],
    place: usize,
) {
    if let Some([.., indices]) = arbre.noeuds.get(place / ENFANTS) {
        let indice = indices[place % ENFANTS].indice();
        if let Some(objet) = objets.get(indice) {
            proposer::<R, false>(bloc, objet, rang(indice));
        }
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
/// for M, the M·X from which depths count. Both include the slack (`docs/conception.md`, "Hierarchy").
struct SondeDeBloc<R> {
    plans: [(Vecteur<R>, R); 5],
    m: Vecteur<R>,
    depart: R,
}

impl<R: Reel> SondeDeBloc<R> {
    /// The probe of the beam of these rays; `None` if they have no beam or one that is too wide.
    #[inline(always)]
    fn etroite<S: Simd>(
        simd: S,
        rayons: &[Rayon<R>],
        bloc: &[Groupe<R>],
        arbre: &Arbre<'_, R>,
    ) -> Option<Self> {
        let faisceau = Faisceau::du_bloc(rayons, bloc)?;
        let sonde = Self::new(faisceau, arbre);
        let racine = arbre.racine.and_then(|racine| arbre.noeuds.get(racine));
        let Some(racine) = racine else { return Some(sonde) };
        let mut profondeurs = EnLigne([R::ZERO; ENFANTS]);
        let EnLigne(profondeurs) = &mut profondeurs;
        let mut traverses = sonde.traverse(simd, racine, R::INFINI, profondeurs);
        let mut enfants = presents(simd, racine);
        let (mut croises, mut tous) = (traverses.count_ones(), enfants.count_ones());
        if tous < PEU_D_ENFANTS && arbre.noeuds.len() > arbre.feuilles {
            (croises, tous) = (0, 0);
            while enfants != 0 {
                let enfant = le_premier(enfants);
                let noeud = arbre.noeuds.get(premier_enfant(racine) + enfant)?;
                if traverses & enfants & enfants.wrapping_neg() != 0 {
                    croises += sonde.traverse(simd, noeud, R::INFINI, profondeurs).count_ones();
                }
                tous += presents(simd, noeud).count_ones();
                traverses &= !(1 << enfant);
                enfants &= enfants - 1;
            }
        }
        (2 * croises <= tous).then_some(sonde)
    }

    #[inline(always)]
    fn new(faisceau: Faisceau<R>, arbre: &Arbre<'_, R>) -> Self {
        let Faisceau { s0, plans, ecart } = faisceau;
        let loin = somme(s0 - arbre.milieu) + ecart * R::depuis_f64(4.0);
        let lieu = arbre.etendue + somme(arbre.milieu) + somme(s0);
        let jeu = (lieu + loin * R::depuis_f64(32.0)) * fois_u(8.0);
        let (moins_m, w) = plans[4];
        let m = -moins_m;
        let plans = plans.map(|(p, w)| (p, p.produit_scalaire(s0) + (w + jeu)));
        Self { plans, m, depart: m.produit_scalaire(s0) + (w + jeu) }
    }

    /// Which children some ray may enter no later than `plafond`, a bit for each, and a distance before
    /// which none does.
    #[inline(always)]
    fn traverse<S: Simd>(
        &self,
        simd: S,
        noeud: &Noeud<R>,
        plafond: R,
        profondeurs: &mut Colonne<R>,
    ) -> u32 {
        let mut dehors = [-R::INFINI; ENFANTS];
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
            profondeurs[i] = max(h, R::ZERO);
        }
        let pas_dehors = R::au_plus(simd, &dehors, &[R::ZERO; ENFANTS]);
        pas_dehors & R::au_plus(simd, profondeurs, &[plafond; ENFANTS])
    }
}

/// Which children a node has, a bit for each.
#[inline(always)]
fn presents<R: Reel, S: Simd>(simd: S, noeud: &Noeud<R>) -> u32 {
    R::au_plus(simd, &noeud[0], &noeud[3])
}

/// The columns of the corners that lie lowest along P.
#[inline(always)]
fn au_plus_pres<R: Reel>(
    [bx, by, bz, hx, hy, hz, _]: &Noeud<R>,
    p: Vecteur<R>,
) -> (&Colonne<R>, &Colonne<R>, &Colonne<R>) {
    (
        if p.x < R::ZERO { hx } else { bx },
        if p.y < R::ZERO { hy } else { by },
        if p.z < R::ZERO { hz } else { bz },
    )
}
