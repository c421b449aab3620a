//! A block of rays, to which a list offers all of its objects and a tree those of the leaves that
//! its probe enters.

use core::ops::Range;

use arrayvec::ArrayVec;
use fearless_simd::prelude::*;

use crate::algebre::nombre::{max, selon};
use crate::cote_a_cote::groupe::{Groupe, VOIES};
use crate::objet::par_forme;
use crate::question::liste::Liste;
use crate::rayon::intersection::Rang;
use crate::{Nombre, ObjetRay, Rayon};

/// Groups of a block.
pub(crate) const GROUPES: usize = 4;

/// Rays of a block: a tile of 8 × 8 pixels.
pub(crate) const BLOC: usize = GROUPES * VOIES;

/// The memory of a block. It grows only as far as a call needs, since setting up all of it takes as
/// long as some rays. It is lent to the block: as a field it would make calls of 16 rays take up to
/// 1.15 times as long (measured).
pub(crate) type Groupes<R> = ArrayVec<Groupe<R>, GROUPES>;

/// How far the rays of a group came together.
#[derive(Clone, Copy)]
pub(crate) enum Ensemble {
    /// Nothing is loaded, and they have asked nothing.
    Rien,
    /// They have asked some objects, those without a box among them, and are to go on one by one.
    EnPartie,
    JusquAuBout,
}

/// At most 64 rays with the first object of each so far. Which question they ask is a flag and no
/// type, so that what asks them is compiled once for both.
pub(crate) struct Bloc<'a, R> {
    pub(crate) groupes: &'a mut Groupes<R>,
    /// The groups that objects are offered to: all that hold rays, or one of them.
    pub(crate) demandes: Range<usize>,
    /// Whether any object settles the answer of a ray.
    pub(crate) un_suffit: bool,
    /// Whether some ray has a δ above 0.
    d_emblee: bool,
}

impl<'a, R: Nombre> Bloc<'a, R> {
    #[inline(always)]
    pub(crate) fn new(groupes: &'a mut Groupes<R>, un_suffit: bool) -> Self {
        Self { groupes, demandes: 0..0, un_suffit, d_emblee: false }
    }

    /// Loads these rays, with no object so far.
    #[inline(always)]
    pub(crate) fn charger(&mut self, rayons: &[Rayon<R>]) {
        self.demandes = 0..rayons.len().div_ceil(VOIES);
        self.d_emblee = false;
        for (i, rayons) in rayons.chunks(VOIES).enumerate() {
            if i == self.groupes.len() {
                self.groupes.push(Groupe::VIDE);
            }
            self.d_emblee |= self.groupes[i].charger(rayons);
        }
    }

    /// The groups that objects are offered to.
    #[inline(always)]
    pub(crate) fn groupes_demandes(&self) -> &[Groupe<R>] {
        &self.groupes[self.demandes.clone()]
    }

    /// Makes each of these objects, by its index, the first of every ray that is offered objects
    /// and enters it before its first so far; the flag says whether the object may hold the source
    /// of one.
    ///
    /// `vectorize` is called once around the loop over objects, which takes up to 8 % less time
    /// than one call for each object (measured). Each shape is copied: the compiler then knows that
    /// no write to a group changes it, and does not read it again for every ray.
    #[inline(always)]
    pub(crate) fn proposer<S: Simd>(
        &mut self,
        simd: S,
        liste: &Liste<'_, R>,
        offerts: &mut dyn Iterator<Item = (usize, bool)>,
    ) {
        simd.vectorize(
            #[inline(always)]
            || {
                let d_emblee = self.d_emblee;
                let groupes = &mut self.groupes[self.demandes.clone()];
                for (indice, source) in offerts {
                    let Some(objet) = liste.objet(indice) else { continue };
                    let rang = Rang::de(indice);
                    par_forme!(ObjetRay, objet, forme => {
                        let forme = *forme;
                        for groupe in groupes.iter_mut() {
                            groupe.proposer(&forme, rang, d_emblee && source);
                        }
                    });
                }
            },
        );
    }

    /// Offers the objects at these indices; where any object suffices, some at a time until all
    /// rays are done, or so few are left that they take less time one by one.
    #[inline(always)]
    pub(crate) fn proposer_tous<S: Simd>(
        &mut self,
        simd: S,
        liste: &Liste<'_, R>,
        indices: impl Iterator<Item = usize> + Clone,
    ) {
        // The fewer numbers a register holds the dearer is an object, and the sooner a look at what
        // is left to do pays.
        let par_registre = selon::<R, _>(S::f32s::LEN, S::f64s::LEN);
        let mut offerts = indices.map(|indice| (indice, true)).peekable();
        while offerts.peek().is_some() {
            if !self.un_suffit {
                return self.proposer(simd, liste, &mut offerts);
            }
            self.proposer(simd, liste, &mut offerts.by_ref().take(par_registre));
            if offerts.peek().is_none() {
                return;
            }
            // All lanes of a group take part, whether or not their rays are done, and a ray alone
            // takes about as long as one register.
            let groupes = self.groupes_demandes();
            let restent: u32 = groupes.iter().map(Groupe::sans_objet).sum();
            if restent as usize * par_registre < groupes.len() * VOIES {
                return self.finir_un_par_un(liste, offerts.map(|(indice, _)| indice));
            }
        }
    }

    /// Asks the objects at these indices for one ray after the other, where any object suffices, of
    /// the rays that have none.
    #[cold]
    #[inline(never)]
    fn finir_un_par_un(
        &mut self,
        liste: &Liste<'_, R>,
        indices: impl Iterator<Item = usize> + Clone,
    ) {
        for groupe in &mut self.groupes[self.demandes.clone()] {
            for voie in 0..VOIES {
                let premier = groupe.premier(voie);
                if premier.rang.is_none() {
                    let mut premier = premier.en_question::<true>();
                    liste.interroger_parmi(&groupe.rayon(voie), &mut premier, indices.clone());
                    groupe.noter(voie, premier.en_question());
                }
            }
        }
    }

    /// The largest distance before which a ray looks for an object; 0 if all are done.
    #[inline(always)]
    pub(crate) fn le_plus_loin(&self) -> R {
        let mut loin = R::ZERO;
        for groupe in self.groupes_demandes() {
            loin = max(groupe.le_plus_loin(self.un_suffit), loin);
        }
        loin
    }
}
