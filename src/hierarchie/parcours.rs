//! One ray in the tree: the walk through the nodes that it crosses.

use fearless_simd::Simd;

use crate::epreuve::Epreuve;
use crate::hierarchie::construction::Arbre;
use crate::hierarchie::noeud::indice_lu;
use crate::hierarchie::pile::{Attentes, Pile};
use crate::hierarchie::sonde::Sonde;
use crate::reel::Reel;
use crate::retenus::{Retenus, demander};
use crate::seize::{Aligne, SEIZE, au_plus, prendre, prendre_le_moindre};

impl<R: Reel> Arbre<'_, R> {
    /// Keeps what the ray enters, and gives it back; if `UN_SUFFIT`, until something is kept. A tree without nodes asks its
    /// list.
    #[inline(always)]
    pub(crate) fn parcourir<S: Simd, E: Epreuve<R>, K: Retenus<R>>(
        &self,
        simd: S,
        epreuve: &E,
        mut retenus: K,
    ) -> K {
        if self.noeuds.is_empty() {
            demander(epreuve, &mut retenus, self.liste, 0..self.liste.objets.len());
            return retenus;
        }
        let sans_boite = self.sans_boite.iter().map(|indice| indice_lu(*indice));
        if demander(epreuve, &mut retenus, self.liste, sans_boite) {
            return retenus;
        }
        self.descendre(simd, epreuve, retenus)
    }

    /// The same of the objects with a box: of each leaf that the ray may enter before the last that is kept. Where boxes
    /// tell none apart, of the whole list.
    #[inline(always)]
    pub(crate) fn descendre<S: Simd, E: Epreuve<R>, K: Retenus<R>>(
        &self,
        simd: S,
        epreuve: &E,
        mut retenus: K,
    ) -> K {
        // A copy, which stays in registers.
        let copie = *epreuve.rayon();
        let Some(sonde) = Sonde::new(&copie, self.repere) else {
            demander(epreuve, &mut retenus, self.liste, 0..self.liste.objets.len());
            return retenus;
        };
        let mut attentes = Attentes::new();
        let (mut pile, mut numero) = (Pile(&mut attentes), self.noeuds.len() - 1);
        // The largest entry that still matters, in the frame of the tree.
        let mut plafond = sonde.plafond(self.repere, retenus.t());
        while let Some(noeud) = self.noeuds.get(numero) {
            let (mut traverses, Aligne(entrees)) = sonde.traverse(simd, noeud, plafond);
            if numero < self.feuilles {
                let [.., indices] = noeud;
                // The nearest first, which most often cuts off the others; then in order.
                let mut suivant = if E::UN_SUFFIT {
                    prendre(&mut traverses)
                } else {
                    prendre_le_moindre(&mut traverses, &entrees)
                };
                while let Some(enfant) = suivant {
                    let indice = indice_lu(indices[enfant]);
                    if self.liste.objet(indice).is_some_and(|objet| {
                        retenus.retenir(epreuve.t(&copie, objet, indice, true), indice)
                    }) {
                        if E::UN_SUFFIT {
                            return retenus;
                        }
                        plafond = sonde.plafond(self.repere, retenus.t());
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
        retenus
    }
}
