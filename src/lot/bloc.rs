//! A block of rays: what the search of a list and the walk of a tree ask of it.

use core::marker::PhantomData;

use fearless_simd::Simd;

use crate::intersection::Rang;
use crate::lot::demande::Demande;
use crate::lot::faisceau::Faisceau;
use crate::lot::groupe::Groupe;
use crate::objet::{ObjetRay, par_forme};
use crate::premier::Premier;
use crate::rayon::Rayon;
use crate::reel::{Reel, max};
use crate::seize::SEIZE;

/// Rays of a block: a tile of 8 × 8 pixels.
pub(crate) const BLOC: usize = 4 * SEIZE;

/// The memory of a block.
#[inline(always)]
pub(crate) fn groupes_vides<R: Reel>() -> [Groupe<R>; BLOC / SEIZE] {
    [const { Groupe::VIDE }; BLOC / SEIZE]
}

/// At most 64 rays, or one group of them, with the first object of each so far.
pub(crate) struct Bloc<'a, R, D> {
    /// The index of the object that is left out.
    pub(crate) sauf: Option<usize>,
    /// How many rays are here, without what stands in for missing ones; 0 if none are loaded.
    pub(crate) nombre: usize,
    groupes: &'a mut [Groupe<R>],
    demande: PhantomData<D>,
}

impl<'a, R: Reel, D: Demande<R>> Bloc<'a, R, D> {
    #[inline(always)]
    pub(crate) fn new(sauf: Option<usize>, groupes: &'a mut [Groupe<R>]) -> Self {
        Self { sauf, nombre: 0, groupes, demande: PhantomData }
    }

    /// One of its groups as a block of sixteen at most, with what they found so far; of none if none are loaded.
    #[inline(always)]
    pub(crate) fn groupe(&mut self, numero: usize) -> Bloc<'_, R, D> {
        let nombre = self.nombre.saturating_sub(numero * SEIZE).min(SEIZE);
        Bloc { nombre, ..Bloc::new(self.sauf, &mut self.groupes[numero..=numero]) }
    }

    /// Puts these rays here, with no object so far.
    #[inline(always)]
    pub(crate) fn charger(&mut self, demandes: &[D]) {
        self.nombre = demandes.len();
        for (groupe, demandes) in self.groupes.iter_mut().zip(demandes.chunks(SEIZE)) {
            groupe.charger(demandes, D::lire);
        }
    }

    /// The groups that hold rays.
    #[inline(always)]
    pub(crate) fn groupes(&self) -> &[Groupe<R>] {
        &self.groupes[..self.nombre.div_ceil(SEIZE)]
    }

    #[inline(always)]
    fn rayon(&self, i: usize) -> Rayon<R> {
        self.groupes[i / SEIZE].rayon(i % SEIZE)
    }

    /// The ray in the middle.
    #[inline(always)]
    pub(crate) fn milieu(&self) -> Rayon<R> {
        self.rayon(self.nombre / 2)
    }

    /// The beam of these rays, up to their limits if they have some; `None` if they go too far apart for
    /// one.
    #[inline(always)]
    pub(crate) fn faisceau(&self) -> Option<Faisceau<R>> {
        let reperes = [self.rayon(0), self.rayon(7), self.milieu()];
        if D::UN_SUFFIT && self.le_plus_loin() <= R::LIMITE {
            return Some(Faisceau::de_segments(self.groupes(), reperes));
        }
        Faisceau::de_rayons(self.groupes(), reperes)
    }

    /// For each ray that enters the object at this index of the list before its first so far: makes
    /// it its first.
    ///
    /// The shape is copied: nothing that is written to a group can overlap it, so that the compiler
    /// need not read it again for every ray.
    #[inline(always)]
    pub(crate) fn proposer(&mut self, objets: &[ObjetRay<R>], indice: usize) {
        let Some(objet) = objets.get(indice).filter(|_| self.sauf != Some(indice)) else { return };
        let (rang, groupes) = (Rang::de(indice), self.groupes().len());
        par_forme!(ObjetRay, objet, forme => {
            let forme = *forme;
            for groupe in &mut self.groupes[..groupes] {
                groupe.proposer(&forme, rang, D::UN_SUFFIT);
            }
        });
    }

    /// [`proposer`](Self::proposer) of every object of the list: what a block without a beam does.
    #[inline(always)]
    pub(crate) fn proposer_tous(&mut self, objets: &[ObjetRay<R>]) {
        for indice in 0..objets.len() {
            self.proposer(objets, indice);
        }
    }

    /// The largest distance before which a ray looks for an object; 0 if all are done.
    #[inline(always)]
    pub(crate) fn le_plus_loin(&self) -> R {
        let mut loin = R::ZERO;
        for groupe in self.groupes() {
            loin = max(groupe.le_plus_loin(), loin);
        }
        loin
    }

    /// The first object so far of one of its rays; none, before this limit, if they are not loaded.
    #[inline(always)]
    pub(crate) fn premier(&self, i: usize, limite: R) -> Premier<R> {
        if i < self.nombre {
            return self.groupes[i / SEIZE].premier(i % SEIZE);
        }
        Premier::avant(limite)
    }

    /// Writes the answers; a function of the instruction set, which list and hierarchy share.
    #[inline(always)]
    pub(crate) fn ecrire<S: Simd>(
        &self,
        simd: S,
        objets: &[ObjetRay<R>],
        reponses: &mut [D::Reponse],
    ) {
        simd.vectorize(
            #[inline(always)]
            || {
                for (groupe, reponses) in self.groupes.iter().zip(reponses.chunks_mut(SEIZE)) {
                    D::conclure_groupe(groupe, objets, reponses);
                }
            },
        );
    }
}
