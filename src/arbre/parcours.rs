//! One ray in a tree.

use core::ops::ControlFlow::{self, Break, Continue};

use fearless_simd::Simd;

use crate::arbre::Arbre;
use crate::arbre::marche::Etape;
use crate::arbre::morceaux::Coupe;
use crate::arbre::noeud::indice_lu;
use crate::arbre::sonde::Sonde;
use crate::cote_a_cote::colonne::{au_plus, retirer, retirer_le_moindre};
use crate::objet::forme::Boule;
use crate::question::liste::Liste;
use crate::question::{Abord, Question};
use crate::{Nombre, Rayon};

impl<R: Nombre> Arbre<'_, R> {
    /// Asks the objects of this list that may count, and gives the question back: first those
    /// without a box, then those in the leaves that the ray may enter before the limit. Where boxes
    /// tell no objects apart, it asks the whole list.
    #[inline(always)]
    pub(crate) fn parcourir<S: Simd, Q: Question<R>>(
        &self,
        simd: S,
        liste: &Liste<'_, R>,
        rayon: &Rayon<R>,
        mut question: Q,
    ) -> Q {
        if liste.interroger_parmi(rayon, &mut question, self.sans_boite()) {
            return question;
        }
        // A copy, which stays in registers.
        let copie = *rayon;
        let Some(sonde) = Sonde::new(&copie, self.repere) else {
            self.interroger_les_boites(liste, rayon, &mut question);
            return question;
        };
        // The largest entry that still matters, in the frame of the tree.
        let plafond = sonde.plafond(self.repere, question.limite());
        let _ = self.marcher(
            simd,
            &sonde,
            plafond,
            #[inline(always)]
            |etape, plafond| {
                question.au_noeud();
                if !etape.est_une_feuille {
                    return Continue(());
                }
                self.interroger_une_feuille(
                    simd,
                    liste,
                    (&copie, &sonde),
                    etape,
                    (&mut question, plafond),
                )
            },
        );
        question
    }

    /// Asks the objects of a leaf whose boxes the ray enters up to `plafond`, which what is kept
    /// lowers; breaks off once the answer is settled.
    #[inline(always)]
    fn interroger_une_feuille<S: Simd, Q: Question<R>>(
        &self,
        simd: S,
        liste: &Liste<'_, R>,
        (rayon, sonde): (&Rayon<R>, &Sonde<R>),
        Etape { noeud, mut enfants, entrees, .. }: Etape<'_>,
        (question, plafond): (&mut Q, &mut f32),
    ) -> ControlFlow<()> {
        let flou = rayon.flou.d_emblee() > R::ZERO;
        let jusqu_ici = if flou { sonde.entree_de_la_source() } else { -f32::INFINI };
        let [.., indices] = noeud;
        // The nearest first, which most often cuts off the others; then in order.
        let mut suivant = if Q::UN_SUFFIT {
            retirer(&mut enfants)
        } else {
            retirer_le_moindre(&mut enfants, entrees)
        };
        while let Some(enfant) = suivant {
            let indice = indice_lu(indices[enfant]);
            let tient_la_source = entrees[enfant] <= jusqu_ici;
            let abord = Abord::DansSaBoite { tient_la_source };
            if let Some(objet) = liste.objet(indice)
                && let Some(t) = question.voir(rayon, objet, indice, abord)
                && (!Q::CHACUN_UNE_FOIS
                    || self.coupe == Coupe::AUCUNE
                    || self.coupe.est_ici(self.repere, (noeud, enfant), objet, rayon, t))
                && question.retenir(t, indice)
            {
                if question.est_reglee() {
                    return Break(());
                }
                *plafond = sonde.plafond(self.repere, question.limite());
                enfants &= au_plus(simd, entrees, *plafond);
            }
            suivant = retirer(&mut enfants);
        }
        Continue(())
    }

    /// Asks all objects that have a box, unless the ray passes by the ball about Z that holds all
    /// boxes, which lie within 1 of Z in the frame of the tree. It never does so if it enters one of
    /// the objects (lemma 14, for a ball that is twice as large).
    #[cold]
    fn interroger_les_boites<Q: Question<R>>(
        &self,
        liste: &Liste<'_, R>,
        rayon: &Rayon<R>,
        question: &mut Q,
    ) {
        let r = self.repere.en_longueur(R::depuis_f64(2.0));
        if (Boule { centre: self.repere.milieu, r2: r * r }).approchee(rayon) {
            liste.interroger_parmi(rayon, question, self.avec_boite(liste));
        }
    }
}
