//! What a question is asked of: the objects of a list, or a choice of them.

use core::iter;

use crate::objet::ObjetRay;

/// The objects of a list, or some of them. Each keeps its index in the list.
#[derive(Clone, Copy)]
pub(crate) struct Liste<'a, R> {
    pub(crate) objets: &'a [ObjetRay<R>],
    pub(crate) choix: Option<Choix<'a>>,
}

/// A choice of objects by their indices.
#[derive(Clone, Copy)]
pub(crate) struct Choix<'a> {
    pub(crate) regle: Regle<'a>,
    /// The choice that this is made among.
    pub(crate) parmi: Option<&'a Self>,
}

/// What a choice takes.
#[derive(Clone, Copy)]
pub(crate) enum Regle<'a> {
    /// All but the object at this index, kept here: a predicate is borrowed from the caller.
    Sans(usize),
    /// Those whose indices this is true of.
    Si(&'a (dyn Fn(usize) -> bool + Sync)),
}

impl Choix<'_> {
    /// Whether this and all choices before take the object at this index. Cold, so that a walk without a choice keeps its
    /// registers: inlined, this costs it up to 1.08 of its time (measured).
    #[cold]
    #[inline(never)]
    pub(crate) fn contient(&self, indice: usize) -> bool {
        iter::successors(Some(self), |choix| choix.parmi).all(|choix| match choix.regle {
            Regle::Sans(sauf) => indice != sauf,
            Regle::Si(prend) => prend(indice),
        })
    }
}

impl<'a, R: Copy> Liste<'a, R> {
    /// All of these objects.
    #[inline(always)]
    pub(crate) fn entiere(objets: &'a [ObjetRay<R>]) -> Self {
        Self { objets, choix: None }
    }

    /// Whether the choice takes the object at this index.
    #[inline(always)]
    pub(crate) fn contient(self, indice: usize) -> bool {
        self.choix.is_none_or(|choix| choix.contient(indice))
    }

    /// The object at this index; none if the choice leaves it out.
    #[inline(always)]
    pub(crate) fn objet(self, indice: usize) -> Option<&'a ObjetRay<R>> {
        if self.contient(indice) { self.objets.get(indice) } else { None }
    }
}
