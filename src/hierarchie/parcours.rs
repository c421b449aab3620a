//! One ray in the tree: the walk through the nodes that it crosses.

use fearless_simd::Simd;

use crate::hierarchie::construction::Arbre;
use crate::hierarchie::noeud::{en_mot, indice_lu};
use crate::hierarchie::pile::{
    DEUX_ETAGES, GRANDE_PILE, PETITE_PILE, PILE_D_UN_ETAGE, Pile, QUATRE_ETAGES, RIEN,
};
use crate::hierarchie::sonde::Sonde;
use crate::lot::demande::Epreuve;
use crate::premier::Premier;
use crate::reel::Reel;
use crate::seize::{Aligne, SEIZE, au_plus, egaux, prendre, prendre_le_moindre};

impl<R: Reel> Arbre<'_, R> {
    /// The first object that the ray enters before `premier`, or `premier`; if `UN_SUFFIT`, any
    /// such object.
    ///
    /// It asks the objects without a box, then the objects of each leaf that the ray may enter before what it
    /// has found; never the object at the index `sauf`. `pas` grows by a step for each node, and for each object
    /// that a leaf has it ask.
    #[inline(always)]
    pub(crate) fn parcourir<S: Simd, E: Epreuve<R>>(
        &self,
        simd: S,
        epreuve: &E,
        mut premier: Premier<R>,
        sauf: Option<usize>,
        pas: &mut usize,
    ) -> Premier<R> {
        // A copy, which stays in registers.
        let copie = *epreuve.rayon();
        for &indice in self.sans_boite {
            let indice = indice_lu(indice);
            if let Some(objet) = self.objets.get(indice)
                && sauf != Some(indice)
                && premier.retenir(epreuve.t(&copie, objet, indice, false), indice)
                && E::UN_SUFFIT
            {
                return premier;
            }
        }
        let sonde = Sonde::new(&copie, self.repere);
        // No larger pile than the tree needs: to set it up costs as much as an object.
        let (mut moindre, mut petite, mut grande);
        let attentes: &mut [_] = if self.noeuds.len() <= DEUX_ETAGES {
            moindre = [RIEN; PILE_D_UN_ETAGE];
            &mut moindre
        } else if self.noeuds.len() <= QUATRE_ETAGES {
            petite = [RIEN; PETITE_PILE];
            &mut petite
        } else {
            grande = [RIEN; GRANDE_PILE];
            &mut grande
        };
        let (mut pile, mut numero) = Pile::new(attentes, self.geants, self.noeuds.len() - 1);
        // The largest entry that still matters, in the frame of the tree.
        let mut plafond = self.repere.distance(premier.t);
        while let Some(noeud) = self.noeuds.get(numero) {
            *pas += 1;
            let (mut traverses, Aligne(entrees)) = sonde.traverse(simd, noeud, plafond);
            if numero < self.feuilles {
                let [.., indices] = noeud;
                if let Some(sauf) = sauf {
                    traverses &= !egaux(simd, indices, en_mot(sauf));
                }
                // The nearest first, which most often cuts off the others; then in order.
                let mut suivant = if E::UN_SUFFIT {
                    prendre(&mut traverses)
                } else {
                    prendre_le_moindre(&mut traverses, &entrees)
                };
                while let Some(enfant) = suivant {
                    *pas += 1;
                    let indice = indice_lu(indices[enfant]);
                    let objet = self.objets.get(indice);
                    if objet.is_some_and(|objet| {
                        premier.retenir(epreuve.t(&copie, objet, indice, true), indice)
                    }) {
                        if E::UN_SUFFIT {
                            return premier;
                        }
                        plafond = self.repere.distance(premier.t);
                        traverses &= au_plus(simd, &entrees, &[plafond; SEIZE]);
                    }
                    suivant = prendre(&mut traverses);
                }
            } else if let Some(proche) = pile.garder(traverses, &entrees, noeud) {
                numero = proche;
                continue;
            }
            let Some(suivant) = pile.prendre(plafond) else { break };
            numero = suivant;
        }
        premier
    }
}
