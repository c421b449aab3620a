//! The nodes that a walk leaves for later.

use crate::hierarchie::noeud::{ETAGES, Noeud, indice_lu};
use crate::seize::{Colonne, Membres, SEIZE, prendre, prendre_le_moindre};

/// Room for the nodes that a walk leaves for later. Of each node above the leaves it visits one
/// child at once and leaves at most fifteen. It is done with these before it visits another node of
/// that floor.
pub(crate) const GRANDE_PILE: usize = (SEIZE - 1) * (ETAGES - 1);

/// Room for them where there are at most four floors. To set up a large one costs 6 ns a ray.
pub(crate) const PETITE_PILE: usize = (SEIZE - 1) * 3;

/// Trees of no more nodes than this have at most four floors.
pub(crate) const QUATRE_ETAGES: usize = SEIZE.pow(3);

/// Room for them where there are at most two floors.
pub(crate) const PILE_D_UN_ETAGE: usize = SEIZE - 1;

/// Trees of no more nodes than this have at most two floors.
pub(crate) const DEUX_ETAGES: usize = SEIZE + 1;

/// A node to look at later, and the distance at which the ray enters it.
type Attente = (f32, u32);

/// A free place of a pile.
pub(crate) const RIEN: Attente = (0.0, 0);

/// Nodes to look at later.
pub(crate) struct Pile<'a> {
    attentes: &'a mut [Attente],
    nombre: usize,
}

impl<'a> Pile<'a> {
    /// A pile in this room, empty.
    #[inline(always)]
    pub(crate) fn vide(attentes: &'a mut [Attente]) -> Self {
        Self { attentes, nombre: 0 }
    }

    /// The nearest of these children; the others are put here.
    #[inline(always)]
    pub(crate) fn garder(
        &mut self,
        mut enfants: Membres,
        entrees: &Colonne<f32>,
        [.., indices]: &Noeud,
    ) -> Option<usize> {
        let proche = prendre_le_moindre(&mut enfants, entrees)?;
        while let Some(enfant) = prendre(&mut enfants) {
            self.attentes[self.nombre] = (entrees[enfant], indice_lu(indices[enfant]) as u32);
            self.nombre += 1;
        }
        Some(indice_lu(indices[proche]))
    }

    /// The last node put here that the ray enters no later than `plafond`.
    #[inline(always)]
    pub(crate) fn prendre(&mut self, plafond: f32) -> Option<usize> {
        while let Some(nombre) = self.nombre.checked_sub(1) {
            self.nombre = nombre;
            let (entree, noeud) = self.attentes[nombre];
            if entree <= plafond {
                return Some(noeud as usize);
            }
        }
        None
    }
}
