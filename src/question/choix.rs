//! A choice of objects by their indices: what a [`Monde`](crate::Monde) is asked about, and what it
//! leaves out.

/// Which objects of a list a question is about.
///
/// [`Monde::sans`](crate::Monde::sans) and [`Monde::parmi`](crate::Monde::parmi) make one. A choice
/// is a value: it is stored, returned and shared by threads like any other, and it is `Copy` if
/// what it holds is. The trait is sealed.
#[doc(alias("filter", "mask"))]
pub trait Choix: Sync + scelle::Scelle {
    /// Whether the object at this index is one of them.
    #[doc(hidden)]
    fn prend(&self, indice: usize) -> bool;

    /// The choice as a walk takes it, which is compiled once for all choices; `None` if it takes
    /// every object.
    #[doc(hidden)]
    fn regle(&self) -> Option<&dyn Choix>;
}

mod scelle {
    pub trait Scelle {}
}

/// All objects of a list.
#[doc(alias = "all")]
#[derive(Debug, Clone, Copy)]
pub struct Tous;

/// The objects of another choice except one: what [`Monde::sans`](crate::Monde::sans) makes.
#[doc(alias("without", "except"))]
#[derive(Debug, Clone, Copy)]
pub struct Sans<C> {
    pub(crate) parmi: C,
    pub(crate) sauf: usize,
}

/// The objects of another choice that a predicate takes: what [`Monde::parmi`](crate::Monde::parmi)
/// makes.
#[doc(alias("among", "filter"))]
#[derive(Debug, Clone, Copy)]
pub struct Parmi<C, F> {
    pub(crate) parmi: C,
    pub(crate) prend: F,
}

impl scelle::Scelle for Tous {}
impl<C> scelle::Scelle for Sans<C> {}
impl<C, F> scelle::Scelle for Parmi<C, F> {}

impl Choix for Tous {
    #[inline]
    fn prend(&self, _: usize) -> bool {
        true
    }

    #[inline]
    fn regle(&self) -> Option<&dyn Choix> {
        None
    }
}

impl<C: Choix> Choix for Sans<C> {
    #[inline]
    fn prend(&self, indice: usize) -> bool {
        indice != self.sauf && self.parmi.prend(indice)
    }

    #[inline]
    fn regle(&self) -> Option<&dyn Choix> {
        Some(self)
    }
}

impl<C: Choix, F: Fn(usize) -> bool + Sync> Choix for Parmi<C, F> {
    #[inline]
    fn prend(&self, indice: usize) -> bool {
        self.parmi.prend(indice) && (self.prend)(indice)
    }

    #[inline]
    fn regle(&self) -> Option<&dyn Choix> {
        Some(self)
    }
}
