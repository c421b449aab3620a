//! One ray in the tree: the walk through the nodes that it crosses.

use fearless_simd::Simd;

use crate::forme::Forme;
use crate::hierarchie::construction::Arbre;
use crate::hierarchie::noeud::{Noeud, indice_lu};
use crate::hierarchie::pile::{
    DEUX_ETAGES, GRANDE_PILE, PETITE_PILE, PEU_DE_NOEUDS, PILE_D_UN_ETAGE, Pile, RIEN,
};
use crate::hierarchie::sonde::Sonde;
use crate::intersection::Rang;
use crate::lot::demande::Demande;
use crate::objet::ObjetRay;
use crate::premier::Premier;
use crate::rayon::Rayon;
use crate::reel::Reel;
use crate::seize::{Aligne, SEIZE, au_plus};

impl<R: Reel> Arbre<'_, R> {
    /// The first object that the ray enters before `premier`, or `premier`; if `UN_SUFFIT`, any
    /// such object.
    ///
    /// It asks the half-spaces, then the objects of each leaf that the ray may enter before what it
    /// has found.
    #[inline(always)]
    pub(crate) fn parcourir<S: Simd, D: Demande<R>>(
        &self,
        simd: S,
        rayon: &Rayon<R>,
        premier: Premier<R>,
    ) -> Premier<R> {
        let mut recherche = Recherche { arbre: self, rayon: *rayon, premier };
        for &indice in self.plans {
            let indice = indice_lu(indice);
            // Matched as what it is, and its quotient behind a branch, for which no other step waits.
            if let Some(ObjetRay::Plan(plan)) = self.objets.get(indice)
                && plan.peut_entrer(rayon)
                && recherche.retenir(plan.t(rayon), indice)
                && D::UN_SUFFIT
            {
                return recherche.premier;
            }
        }
        let sonde = Sonde::new(rayon, self.repere);
        // No larger pile than the tree needs: to set it up costs as much as an object.
        let (mut moindre, mut petite, mut grande);
        let attentes: &mut [_] = if self.noeuds.len() <= DEUX_ETAGES {
            moindre = [RIEN; PILE_D_UN_ETAGE];
            &mut moindre
        } else if self.noeuds.len() <= PEU_DE_NOEUDS {
            petite = [RIEN; PETITE_PILE];
            &mut petite
        } else {
            grande = [RIEN; GRANDE_PILE];
            &mut grande
        };
        let (mut pile, mut numero) = Pile::new(attentes, self.geants, self.noeuds.len() - 1);
        while let Some(noeud) = self.noeuds.get(numero) {
            if numero < self.feuilles {
                if recherche.voir_feuille::<S, D>(simd, &sonde, noeud) && D::UN_SUFFIT {
                    break;
                }
            } else {
                let (traverses, Aligne(entrees)) = sonde.traverse(simd, noeud, recherche.plafond());
                if let Some(proche) = pile.garder(traverses, &entrees, noeud) {
                    numero = proche;
                    continue;
                }
            }
            let Some(suivant) = pile.prendre(recherche.plafond()) else { break };
            numero = suivant;
        }
        recherche.premier
    }
}

/// A ray in a tree, with its first object so far.
struct Recherche<'a, R> {
    arbre: &'a Arbre<'a, R>,
    /// A copy, which stays in registers.
    rayon: Rayon<R>,
    premier: Premier<R>,
}

impl<R: Reel> Recherche<'_, R> {
    /// Makes the object of this index, entered at this distance, the first if it comes before it.
    #[inline(always)]
    fn retenir(&mut self, t: R, indice: usize) -> bool {
        let trouve = Premier { t, rang: Rang::de(indice).en_nombre() };
        if trouve.precede(self.premier) {
            self.premier = trouve;
            return true;
        }
        false
    }

    /// The largest entry that still matters, in the frame of the tree.
    #[inline(always)]
    fn plafond(&self) -> f32 {
        self.arbre.repere.distance(self.premier.t)
    }

    /// Asks the objects of a leaf that the ray may enter before its first so far, and tells whether
    /// one of them came before it; if any answers, that one is the last asked.
    #[inline(always)]
    fn voir_feuille<S: Simd, D: Demande<R>>(
        &mut self,
        simd: S,
        sonde: &Sonde,
        feuille: &Noeud,
    ) -> bool {
        let (mut traverses, Aligne(entrees)) = sonde.traverse(simd, feuille, self.plafond());
        let [.., indices] = feuille;
        let mut trouve = false;
        // The nearest first, which most often cuts off the others; then in order.
        let mut suivant =
            if D::UN_SUFFIT { traverses.next() } else { traverses.prendre_le_moindre(&entrees) };
        while let Some(enfant) = suivant {
            let indice = indice_lu(indices[enfant]);
            // Its ball is not asked: a ray that crosses its box seldom passes the ball by.
            let objet = self.arbre.objets.get(indice);
            if objet.is_some_and(|objet| self.retenir(objet.t(&self.rayon), indice)) {
                trouve = true;
                if D::UN_SUFFIT {
                    break;
                }
                traverses = traverses.et(&au_plus(simd, &entrees, &[self.plafond(); SEIZE]));
            }
            suivant = traverses.next();
        }
        trouve
    }
}
