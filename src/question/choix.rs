//! A choice of objects by their indices: what a [`Monde`](crate::Monde) is asked about, and what it
//! leaves out.

/// Which objects of a list a question is about.
///
/// [`Monde::sans`](crate::Monde::sans) and [`Monde::parmi`](crate::Monde::parmi) make one. A choice
/// is a value: it is stored, returned and shared by threads like any other, and it is `Copy` if
/// what it holds is. The trait is sealed.
#[doc(alias("filter", "mask"))]
pub trait Choix: Regle {}

impl<C: Regle> Choix for C {}

/// What a choice takes. Nobody can name this trait outside of the crate, and its functions have
/// names that no trait of a caller has: else the caller could not use theirs for a choice (E0034).
pub trait Regle {
    /// Whether the object at this index is one of them.
    fn prend_cet_indice(&self, indice: usize) -> bool;

    /// The choice as a walk takes it, which is compiled once for all choices.
    #[inline]
    fn prises_des_parcours(&self) -> Prises<'_>
    where
        Self: Sized,
    {
        Prises::Certaines { sauf: AUCUN, regle: Some(self) }
    }

    /// The choice without the object at this index, as a walk takes it.
    #[inline]
    fn prises_des_parcours_sans(&self, sauf: usize) -> Prises<'_>
    where
        Self: Sized,
    {
        let regle = match self.prises_des_parcours() {
            Prises::Toutes => None,
            Prises::Certaines { .. } => Some(self as &dyn Regle),
        };
        Prises::Certaines { sauf, regle }
    }
}

/// Which objects a walk takes.
#[derive(Clone, Copy)]
pub enum Prises<'a> {
    Toutes,
    /// Those that the rule takes, or all if there is none, except the one at an index, which costs
    /// a comparison in place of a call.
    Certaines {
        sauf: usize,
        regle: Option<&'a dyn Regle>,
    },
}

/// An index beyond every list.
const AUCUN: usize = usize::MAX;

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

impl Regle for Tous {
    #[inline]
    fn prend_cet_indice(&self, _: usize) -> bool {
        true
    }

    #[inline]
    fn prises_des_parcours(&self) -> Prises<'_> {
        Prises::Toutes
    }
}

impl<C: Choix> Regle for Sans<C> {
    #[inline]
    fn prend_cet_indice(&self, indice: usize) -> bool {
        indice != self.sauf && self.parmi.prend_cet_indice(indice)
    }

    #[inline]
    fn prises_des_parcours(&self) -> Prises<'_> {
        self.parmi.prises_des_parcours_sans(self.sauf)
    }
}

impl<C: Choix, F: Fn(usize) -> bool> Regle for Parmi<C, F> {
    #[inline]
    fn prend_cet_indice(&self, indice: usize) -> bool {
        self.parmi.prend_cet_indice(indice) && (self.prend)(indice)
    }
}
