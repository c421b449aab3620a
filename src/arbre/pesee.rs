//! What a ray spends on a question in a tree, so that a block of rays can be compared with its rays
//! one by one.

use crate::question::{Abord, Question};
use crate::{Nombre, ObjetRay, Rayon};

/// Time that is spent, about in nanoseconds (`DEVELOPING.md`, "What a block may spend").
pub(crate) type Prix = f32;

/// What a ray takes for its probe, and before and after its walk.
const SONDE: Prix = 20.0;

/// A node that a ray looks at.
const NOEUD: Prix = 22.0;

/// An object whose box a ray crosses.
const OBJET: Prix = 38.0;

/// An object of a list.
const OBJET_D_UNE_LISTE: Prix = 4.0;

/// The least that a ray spends that enters a tree.
pub(crate) const MOINDRE: Prix = SONDE + NOEUD + OBJET;

/// A question, and what a ray has spent on it.
pub(crate) struct Pesee<Q> {
    question: Q,
    pub(crate) depense: Prix,
}

impl<Q> Pesee<Q> {
    #[inline(always)]
    pub(crate) fn de(question: Q) -> Self {
        Self { question, depense: SONDE }
    }
}

impl<R: Nombre, Q: Question<R>> Question<R> for Pesee<Q> {
    const UN_SUFFIT: bool = Q::UN_SUFFIT;
    const CHACUN_UNE_FOIS: bool = Q::CHACUN_UNE_FOIS;

    #[inline(always)]
    fn limite(&self) -> R {
        self.question.limite()
    }

    #[inline(always)]
    fn au_noeud(&mut self) {
        self.depense += NOEUD;
    }

    #[inline(always)]
    fn voir(
        &mut self,
        rayon: &Rayon<R>,
        objet: &ObjetRay<R>,
        indice: usize,
        abord: Abord,
    ) -> Option<R> {
        self.depense += match abord {
            Abord::Inconnu => OBJET_D_UNE_LISTE,
            Abord::DansSaBoite { .. } => OBJET,
        };
        self.question.voir(rayon, objet, indice, abord)
    }

    #[inline(always)]
    fn retenir(&mut self, t: R, indice: usize) -> bool {
        self.question.retenir(t, indice)
    }

    #[inline(always)]
    fn est_reglee(&self) -> bool {
        self.question.est_reglee()
    }
}
