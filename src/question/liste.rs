//! Asks a list, one ray at a time: every object, or those that a choice takes. Many rays ask it in
//! `cote_a_cote/bloc.rs`.

use crate::question::choix::{Prises, Regle};
use crate::question::{Abord, Question};
use crate::{Nombre, ObjetRay, Rayon};

/// The objects that are asked: a list, and a choice of its objects. Each keeps its index in the
/// list.
#[derive(Clone, Copy)]
pub struct Liste<'a, R> {
    pub(crate) objets: &'a [ObjetRay<R>],
    pub(crate) prises: Prises<'a>,
}

/// Refuses a list with more objects than there are ranks.
#[inline(always)]
pub(crate) fn exiger_des_rangs(objets: usize) {
    assert!(objets as u64 <= u32::MAX.into(), "a list has at most 4294967295 objects");
}

impl<'a, R: Nombre> Liste<'a, R> {
    /// All objects of this list.
    #[inline(always)]
    pub(crate) fn entiere(objets: &'a [ObjetRay<R>]) -> Self {
        exiger_des_rangs(objets.len());
        Self { objets, prises: Prises::Toutes }
    }

    /// Whether the choice takes the object at this index, which is one of the list.
    #[inline(always)]
    fn prend(&self, indice: usize) -> bool {
        match self.prises {
            Prises::Toutes => true,
            Prises::Certaines { sauf, regle } => {
                indice != sauf && regle.is_none_or(|regle| prend_par_regle(regle, indice))
            }
        }
    }

    /// The object at this index; `None` if the list has none there, or the choice leaves it out.
    #[inline(always)]
    pub(crate) fn objet(&self, indice: usize) -> Option<&'a ObjetRay<R>> {
        self.objets.get(indice).filter(|_| self.prend(indice))
    }

    /// Asks every object.
    #[inline(always)]
    pub(crate) fn interroger<Q: Question<R>>(&self, rayon: &Rayon<R>, question: &mut Q) {
        self.interroger_parmi(rayon, question, 0..self.objets.len());
    }

    /// Asks the objects at these indices, until one of them settles the answer; returns whether one
    /// did.
    #[inline(always)]
    pub(crate) fn interroger_parmi<Q: Question<R>>(
        &self,
        rayon: &Rayon<R>,
        question: &mut Q,
        indices: impl Iterator<Item = usize>,
    ) -> bool {
        // A copy, which stays in registers.
        let copie = *rayon;
        for indice in indices {
            let Some(objet) = self.objets.get(indice) else { continue };
            let Some(t) = question.voir(&copie, objet, indice, Abord::Inconnu) else { continue };
            // The choice is asked after the object: asked before it, a list of six without a choice
            // takes up to 1.07 times as long (measured).
            if self.prend(indice) && question.retenir(t, indice) && question.est_reglee() {
                return true;
            }
        }
        false
    }
}

/// Asks a choice. Cold, so that a walk without a choice keeps its registers: inlined, it costs such
/// a walk up to 1.08 of its time (measured).
#[cold]
#[inline(never)]
fn prend_par_regle(regle: &dyn Regle, indice: usize) -> bool {
    regle.prend_cet_indice(indice)
}
