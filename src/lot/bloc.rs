//! A block of rays: what the search of a list and the walk of a tree ask of it.

use fearless_simd::Simd;

use crate::intersection::{Rang, Touche};
use crate::lot::faisceau::Faisceau;
use crate::lot::groupe::Groupe;
use crate::objet::{ObjetRay, par_forme};
use crate::premier::Premier;
use crate::rayon::Rayon;
use crate::reel::{Reel, max};
use crate::seize::SEIZE;

/// Rays of a block: a tile of 8 × 8 pixels.
pub(crate) const BLOC: usize = 4 * SEIZE;

/// At most 64 rays, with the first object of each so far.
pub(crate) struct Bloc<'a, R> {
    rayons: &'a [Rayon<R>],
    groupes: [Groupe<R>; BLOC / SEIZE],
}

impl<'a, R: Reel> Bloc<'a, R> {
    pub(crate) const VIDE: Self =
        Self { rayons: &[], groupes: [const { Groupe::VIDE }; BLOC / SEIZE] };

    /// Puts these rays here, with no object so far.
    #[inline(always)]
    pub(crate) fn charger(&mut self, rayons: &'a [Rayon<R>]) {
        self.rayons = rayons;
        for (groupe, rayons) in self.groupes.iter_mut().zip(rayons.chunks(SEIZE)) {
            groupe.charger(rayons);
        }
    }

    /// The groups that hold rays.
    #[inline(always)]
    fn groupes(&self) -> &[Groupe<R>] {
        &self.groupes[..self.rayons.len().div_ceil(SEIZE)]
    }

    /// The beam of these rays; `None` if they go too far apart for one.
    #[inline(always)]
    pub(crate) fn faisceau(&self) -> Option<Faisceau<R>> {
        let (rayons, dernier) = (self.rayons, self.rayons.len() - 1);
        let reperes = [rayons[0], rayons[7.min(dernier)], rayons[rayons.len() / 2]];
        Faisceau::de_rayons(self.groupes(), reperes)
    }

    /// For each ray that enters this object, at this index of the list, before its first so far:
    /// makes it its first. `EN_ORDRE` promises that objects come in the order of the list.
    ///
    /// The shape is copied: nothing that is written to a group can overlap it, so that the compiler
    /// need not read it again for every ray.
    #[inline(always)]
    pub(crate) fn proposer<const EN_ORDRE: bool>(&mut self, objet: &ObjetRay<R>, indice: usize) {
        let (rang, groupes) = (Rang::de(indice), self.rayons.len().div_ceil(SEIZE));
        par_forme!(ObjetRay, objet, forme => {
            let forme = *forme;
            for groupe in &mut self.groupes[..groupes] {
                groupe.proposer::<EN_ORDRE>(&forme, rang);
            }
        });
    }

    /// The largest distance of a first object so far.
    #[inline(always)]
    pub(crate) fn le_plus_loin(&self) -> R {
        let mut loin = R::ZERO;
        for groupe in self.groupes() {
            loin = max(groupe.le_plus_loin(), loin);
        }
        loin
    }

    /// Each ray with its first object so far.
    #[inline(always)]
    pub(crate) fn premiers(&self) -> impl Iterator<Item = (&Rayon<R>, Premier<R>)> {
        let premier = |i: usize| self.groupes[i / SEIZE].premier(i % SEIZE);
        self.rayons.iter().enumerate().map(move |(i, rayon)| (rayon, premier(i)))
    }

    /// Writes the answers; a function of the instruction set, which list and hierarchy share.
    #[inline(always)]
    pub(crate) fn ecrire<S: Simd>(
        &self,
        simd: S,
        objets: &[ObjetRay<R>],
        touches: &mut [Touche<R>],
    ) {
        simd.vectorize(
            #[inline(always)]
            || {
                let morceaux = self.rayons.chunks(SEIZE).zip(touches.chunks_mut(SEIZE));
                for (groupe, (rayons, touches)) in self.groupes.iter().zip(morceaux) {
                    groupe.ecrire(objets, rayons, touches);
                }
            },
        );
    }
}
