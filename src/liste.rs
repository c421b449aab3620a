//! What a question is asked of: the objects of a list, one of them perhaps left out.

use crate::objet::ObjetRay;

/// The objects of a list without the one that is left out. Each keeps its index in the list.
#[derive(Clone, Copy)]
pub(crate) struct Liste<'a, R> {
    pub(crate) objets: &'a [ObjetRay<R>],
    /// The index of the object that is left out.
    pub(crate) sauf: Option<usize>,
}

impl<'a, R> Liste<'a, R> {
    /// All of these objects.
    #[inline(always)]
    pub(crate) fn entiere(objets: &'a [ObjetRay<R>]) -> Self {
        Self { objets, sauf: None }
    }

    /// The object at this index; none if it is left out.
    #[inline(always)]
    pub(crate) fn objet(self, indice: usize) -> Option<&'a ObjetRay<R>> {
        if self.sauf == Some(indice) { None } else { self.objets.get(indice) }
    }

    /// Every object, after its index.
    #[inline(always)]
    pub(crate) fn tous(self) -> impl Iterator<Item = (usize, &'a ObjetRay<R>)> {
        let objets = self.objets.iter().enumerate();
        objets.filter(
            #[inline(always)]
            move |(indice, _)| self.sauf != Some(*indice),
        )
    }
}
