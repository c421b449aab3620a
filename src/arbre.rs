//! A tree of bounding boxes over a list, with the answers of the list, to the bit.
//!
//! A leaf holds up to sixteen records, each with the box of an object or of one of its pieces
//! (`morceaux.rs`), and a node of each floor above holds up to sixteen nodes (`noeud.rs`,
//! `construction.rs`), all in the frame of the scene (`repere.rs`). A walk goes through the nodes
//! that a probe enters (`marche.rs`, `sonde.rs`): that of a ray (`parcours.rs`), or that of a block
//! of rays (`parcours_de_bloc.rs`), which may spend no more than its rays alone (`budget.rs`,
//! `pesee.rs`). Objects without a box are always asked. What may be left out is derived in
//! `docs/preuves/recherche.md`.

pub(crate) mod budget;
pub(crate) mod construction;
mod marche;
mod morceaux;
pub(crate) mod noeud;
mod parcours;
pub(crate) mod parcours_de_bloc;
mod pesee;
pub(crate) mod repere;
pub(crate) mod sonde;

use crate::Nombre;
use crate::arbre::morceaux::Coupe;
use crate::arbre::noeud::{Noeud, indice_lu};
use crate::arbre::repere::Repere;
use crate::question::liste::Liste;

/// A tree over a list of objects.
#[derive(Clone, Copy)]
pub struct Arbre<'a, R> {
    /// The leaves, then the floors above, the root last; none over a list that is as fast, or too
    /// long.
    pub(crate) noeuds: &'a [Noeud],
    /// How many nodes are leaves.
    pub(crate) feuilles: usize,
    /// The [stored](noeud::en_mot) indices of the objects without a box, the last first.
    pub(crate) sans_boite: &'a [f32],
    pub(crate) repere: Repere<R>,
    pub(crate) coupe: Coupe,
}

impl<R: Nombre> Arbre<'_, R> {
    /// The tree of a list that is asked as a list.
    pub(crate) const SANS_NOEUDS: Self = Self {
        noeuds: &[],
        feuilles: 0,
        sans_boite: &[],
        repere: Repere::QUELCONQUE,
        coupe: Coupe::AUCUNE,
    };

    /// Whether the objects are asked as a list.
    #[inline(always)]
    pub(crate) fn est_une_liste(&self) -> bool {
        self.noeuds.is_empty()
    }

    /// The objects without a box, in the order of the list, so that a shadow that is settled by the
    /// first of a list is here too.
    #[inline(always)]
    pub(crate) fn sans_boite(&self) -> impl Iterator<Item = usize> + Clone {
        self.sans_boite.iter().rev().map(|mot| indice_lu(*mot))
    }

    /// The objects that have a box: those whose index is not among those without one.
    pub(crate) fn avec_boite(&self, liste: &Liste<'_, R>) -> impl Iterator<Item = usize> + Clone {
        let mut autres = self.sans_boite().peekable();
        (0..liste.objets.len()).filter(move |indice| autres.next_if_eq(indice).is_none())
    }
}
