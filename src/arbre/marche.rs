//! The walk through a tree, of one ray or of many: the nodes that a probe enters, the nearest
//! first.

use core::iter::from_fn;
use core::ops::ControlFlow::{self, Continue};

use arrayvec::ArrayVec;
use fearless_simd::Simd;

use crate::Nombre;
use crate::arbre::Arbre;
use crate::arbre::noeud::{ENFANTS, ETAGES, Noeud, indice_lu};
use crate::arbre::sonde::Sonde;
use crate::cote_a_cote::colonne::{Colonne, Membres, retirer, retirer_le_moindre};

/// A walk visits one child of each node above the leaves at once and leaves at most fifteen. It is
/// done with these before it visits another node of that floor.
const PLACES: usize = (ENFANTS - 1) * (ETAGES - 1);

/// A node that a walk comes to, the children that the probe enters, and where it enters each.
pub(crate) struct Etape<'a> {
    pub(crate) noeud: &'a Noeud,
    /// Whether the children are objects.
    pub(crate) est_une_feuille: bool,
    pub(crate) enfants: Membres,
    pub(crate) entrees: &'a Colonne<f32>,
}

impl<R: Nombre> Arbre<'_, R> {
    /// Shows `voir` each node of this tree, which has some, that the probe enters up to `plafond`, a
    /// limit that `voir` may lower, until it breaks off.
    #[inline(always)]
    pub(crate) fn marcher<S: Simd, B>(
        &self,
        simd: S,
        sonde: &Sonde<R>,
        mut plafond: f32,
        mut voir: impl FnMut(Etape<'_>, &mut f32) -> ControlFlow<B>,
    ) -> ControlFlow<B> {
        // The nodes that wait, each with the distance at which the probe enters it.
        let mut attendent = ArrayVec::<(f32, u32), PLACES>::new();
        let mut numero = self.noeuds.len() - 1;
        while let Some(noeud) = self.noeuds.get(numero) {
            let (mut enfants, entrees) = sonde.traverse(simd, noeud, plafond);
            let est_une_feuille = numero < self.feuilles;
            voir(Etape { noeud, est_une_feuille, enfants, entrees: &entrees.0 }, &mut plafond)?;
            numero = if !est_une_feuille
                && let Some(proche) = retirer_le_moindre(&mut enfants, &entrees.0)
            {
                let [.., numeros] = noeud;
                while let Some(enfant) = retirer(&mut enfants) {
                    attendent.push((entrees.0[enfant], indice_lu(numeros[enfant]) as u32));
                }
                indice_lu(numeros[proche])
            } else {
                let suivant = from_fn(|| attendent.pop()).find(|(entree, _)| *entree <= plafond);
                let Some((_, suivant)) = suivant else { break };
                suivant as usize
            };
        }
        Continue(())
    }
}
