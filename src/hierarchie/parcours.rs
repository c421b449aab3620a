//! One ray in the tree: the walk through the nodes that it crosses.

use fearless_simd::Simd;

use crate::epreuve::Epreuve;
use crate::hierarchie::construction::Arbre;
use crate::hierarchie::noeud::{en_mot, indice_lu};
use crate::hierarchie::pile::{
    DEUX_ETAGES, GRANDE_PILE, PETITE_PILE, PILE_D_UN_ETAGE, Pile, QUATRE_ETAGES, RIEN,
};
use crate::hierarchie::sonde::Sonde;
use crate::objet::ObjetRay;
use crate::premier::Premier;
use crate::reel::Reel;
use crate::seize::{Aligne, SEIZE, au_plus, egaux, prendre, prendre_le_moindre};

impl<R: Reel> Arbre<'_, R> {
    /// The first object that the ray enters before `premier`, or `premier`; if `UN_SUFFIT`, any such object.
    #[inline(always)]
    pub(crate) fn parcourir<S: Simd, E: Epreuve<R>>(
        &self,
        simd: S,
        epreuve: &E,
        premier: Premier<R>,
    ) -> Premier<R> {
        let premier = self.demander_aux_sans_boite(epreuve, premier);
        if E::UN_SUFFIT && premier.rang.is_some() {
            return premier;
        }
        self.descendre(simd, epreuve, premier)
    }

    /// The same of the objects without a box.
    #[inline(always)]
    pub(crate) fn demander_aux_sans_boite<E: Epreuve<R>>(
        &self,
        epreuve: &E,
        premier: Premier<R>,
    ) -> Premier<R> {
        let indices = self.sans_boite.iter().map(|indice| indice_lu(*indice));
        let objets = indices.filter_map(|indice| Some((indice, self.liste.objet(indice)?)));
        demander(epreuve, premier, objets)
    }

    /// The same of the objects with a box: of each leaf that the ray may enter before what it has found, of all where
    /// boxes tell none apart.
    #[inline(always)]
    pub(crate) fn descendre<S: Simd, E: Epreuve<R>>(
        &self,
        simd: S,
        epreuve: &E,
        mut premier: Premier<R>,
    ) -> Premier<R> {
        // A copy, which stays in registers.
        let copie = *epreuve.rayon();
        let Some(sonde) = Sonde::new(&copie, self.repere) else {
            return demander(epreuve, premier, self.liste.tous());
        };
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
        let (mut pile, mut numero) = (Pile::vide(attentes), self.noeuds.len() - 1);
        // The largest entry that still matters, in the frame of the tree.
        let mut plafond = sonde.plafond(self.repere, premier.t);
        while let Some(noeud) = self.noeuds.get(numero) {
            let (mut traverses, Aligne(entrees)) = sonde.traverse(simd, noeud, plafond);
            if numero < self.feuilles {
                let [.., indices] = noeud;
                if let Some(sauf) = self.liste.sauf {
                    traverses &= !egaux(simd, indices, en_mot(sauf));
                }
                // The nearest first, which most often cuts off the others; then in order.
                let mut suivant = if E::UN_SUFFIT {
                    prendre(&mut traverses)
                } else {
                    prendre_le_moindre(&mut traverses, &entrees)
                };
                while let Some(enfant) = suivant {
                    let indice = indice_lu(indices[enfant]);
                    let objet = self.liste.objets.get(indice);
                    if objet.is_some_and(|objet| {
                        premier.retenir(epreuve.t(&copie, objet, indice, true), indice)
                    }) {
                        if E::UN_SUFFIT {
                            return premier;
                        }
                        plafond = sonde.plafond(self.repere, premier.t);
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

/// The first of these objects, each after its index, that the ray enters before `premier`, or `premier`; if
/// `UN_SUFFIT`, any such object.
#[inline(always)]
fn demander<'a, R: Reel, E: Epreuve<R>>(
    epreuve: &E,
    mut premier: Premier<R>,
    objets: impl Iterator<Item = (usize, &'a ObjetRay<R>)>,
) -> Premier<R> {
    let copie = *epreuve.rayon();
    for (indice, objet) in objets {
        if premier.retenir(epreuve.t(&copie, objet, indice, false), indice) && E::UN_SUFFIT {
            break;
        }
    }
    premier
}
