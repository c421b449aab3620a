//! A block of rays, to which a list offers all of its objects and a tree those of the leaves that its beam crosses.

use core::marker::PhantomData;

use arrayvec::ArrayVec;
use fearless_simd::Simd;

use crate::intersection::Rang;
use crate::liste::Liste;
use crate::lot::demande::Demande;
use crate::lot::faisceau::Faisceau;
use crate::lot::groupe::Groupe;
use crate::objet::{ObjetRay, par_forme};
use crate::rayon::Rayon;
use crate::reel::{Reel, max};
use crate::retenus::Premier;
use crate::seize::SEIZE;

/// Rays of a block: a tile of 8 × 8 pixels.
pub(crate) const BLOC: usize = 4 * SEIZE;

/// The memory of a block, which grows no larger than a call needs: to set up all of it costs as much as some rays. It
/// stands outside of the block, which would take up to 1.15 times as long with it inside (calls of 16, measured).
pub(crate) type Groupes<R> = ArrayVec<Groupe<R>, { BLOC / SEIZE }>;

/// At most 64 rays with the first object of each so far.
pub(crate) struct Bloc<'a, R, D> {
    liste: Liste<'a, R>,
    /// How many rays are here, without what stands in for missing ones.
    nombre: usize,
    groupes: &'a mut Groupes<R>,
    demande: PhantomData<D>,
}

impl<'a, R: Reel, D: Demande<R>> Bloc<'a, R, D> {
    #[inline(always)]
    pub(crate) fn new(liste: Liste<'a, R>, groupes: &'a mut Groupes<R>) -> Self {
        Self { liste, nombre: 0, groupes, demande: PhantomData }
    }

    /// Puts these rays here, with no object so far.
    #[inline(always)]
    pub(crate) fn charger(&mut self, demandes: &[D]) {
        self.nombre = demandes.len();
        for (i, demandes) in demandes.chunks(SEIZE).enumerate() {
            if i == self.groupes.len() {
                self.groupes.push(Groupe::VIDE);
            }
            self.groupes[i].charger(demandes, D::lire);
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

    /// So many of these rays, evenly spread from the first to the last.
    #[inline(always)]
    pub(crate) fn temoins(&self, combien: usize) -> impl Iterator<Item = Rayon<R>> {
        (0..combien).map(
            #[inline(always)]
            move |i| self.rayon(i * (self.nombre - 1) / (combien - 1)),
        )
    }

    /// The beam of these rays, up to their limits if they have some; `None` if they go too far apart for
    /// one.
    #[inline(always)]
    pub(crate) fn faisceau(&self) -> Option<Faisceau<R>> {
        let reperes = [0, 7, self.nombre / 2].map(|i| self.rayon(i));
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
    pub(crate) fn proposer(&mut self, indice: usize) {
        let Some(objet) = self.liste.objet(indice) else { return };
        let (rang, groupes) = (Rang::de(indice), self.groupes().len());
        par_forme!(ObjetRay, objet, forme => {
            let forme = *forme;
            for groupe in &mut self.groupes[..groupes] {
                groupe.proposer(&forme, rang, D::UN_SUFFIT);
            }
        });
    }

    /// [`proposer`](Self::proposer) of every object of the list.
    #[inline(always)]
    pub(crate) fn proposer_tous(&mut self) {
        for indice in 0..self.liste.objets.len() {
            self.proposer(indice);
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

    /// The first object so far of one of its rays.
    #[inline(always)]
    pub(crate) fn premier(&self, i: usize) -> Premier<R> {
        self.groupes[i / SEIZE].premier(i % SEIZE)
    }

    /// Writes the answers; a function of the instruction set, which list and hierarchy share.
    #[inline(always)]
    pub(crate) fn ecrire<S: Simd>(&self, simd: S, reponses: &mut [D::Reponse]) {
        let objets = self.liste.objets;
        simd.vectorize(
            #[inline(always)]
            || {
                for (groupe, reponses) in self.groupes.iter().zip(reponses.chunks_mut(SEIZE)) {
                    D::reponses_du_groupe(groupe, objets, reponses);
                }
            },
        );
    }
}
