//! A block of rays, to which a list offers all of its objects and a tree those of the leaves that
//! its probe enters.

use core::ops::Range;

use arrayvec::ArrayVec;
use fearless_simd::Simd;

use crate::algebre::nombre::max;
use crate::cote_a_cote::colonne::{LARGEUR, Membres, TOUS, indice_lu, prendre};
use crate::cote_a_cote::groupe::{Groupe, VOIES};
use crate::objet::par_forme;
use crate::question::liste::Liste;
use crate::rayon::intersection::Rang;
use crate::{Nombre, ObjetRay, Rayon};

/// Rays of a block: a tile of 8 × 8 pixels.
pub(crate) const BLOC: usize = 4 * VOIES;

/// The memory of a block. It grows only as far as a call needs, since setting up all of it takes as
/// long as some rays. It is lent to the block: as a field it would make calls of 16 rays take up to
/// 1.15 times as long (measured).
pub(crate) type Groupes<R> = ArrayVec<Groupe<R>, { BLOC / VOIES }>;

/// Some of sixteen objects of a list.
pub(crate) struct Offre<'a> {
    /// Their indices, [stored](indice_lu); if there are none, the objects from `debut` on.
    pub(crate) mots: &'a [f32],
    pub(crate) debut: usize,
    /// Which of the sixteen are offered, and which may hold the source of a ray.
    pub(crate) membres: Membres,
    pub(crate) sources: Membres,
}

/// At most 64 rays with the first object of each so far. It does not know which question they ask,
/// so that what asks them is compiled once for all.
pub(crate) struct Bloc<'a, R> {
    groupes: &'a mut Groupes<R>,
    /// The groups that objects are offered to: all that hold rays, or one of them.
    demandes: Range<usize>,
    /// Whether any object settles the answer of a ray.
    un_suffit: bool,
    /// Whether some ray has a δ above 0.
    flou: bool,
}

impl<'a, R: Nombre> Bloc<'a, R> {
    #[inline(always)]
    pub(crate) fn new(groupes: &'a mut Groupes<R>, un_suffit: bool) -> Self {
        Self { groupes, demandes: 0..0, un_suffit, flou: false }
    }

    /// Loads these rays, with no object so far.
    #[inline(always)]
    pub(crate) fn charger(&mut self, rayons: &[Rayon<R>]) {
        self.demander_a(0..rayons.len().div_ceil(VOIES));
        self.flou = false;
        for (i, rayons) in rayons.chunks(VOIES).enumerate() {
            if i == self.groupes.len() {
                self.groupes.push(Groupe::VIDE);
            }
            self.flou |= self.groupes[i].charger(rayons);
        }
    }

    /// From now on objects are offered to these groups alone.
    #[inline(always)]
    pub(crate) fn demander_a(&mut self, groupes: Range<usize>) {
        self.demandes = groupes;
    }

    /// The groups that objects are offered to.
    #[inline(always)]
    pub(crate) fn groupes(&self) -> &[Groupe<R>] {
        &self.groupes[self.demandes.clone()]
    }

    /// Whether any object settles the answer of a ray.
    #[inline(always)]
    pub(crate) fn un_suffit(&self) -> bool {
        self.un_suffit
    }

    /// Makes each of these objects the first of each ray that enters it before its first so far.
    ///
    /// `vectorize` is called once around the loop over objects, which takes up to 8 % less time
    /// than one call for each object (measured). Each shape is copied: the compiler then knows that
    /// no write to a group changes it, and does not read it again for every ray.
    #[inline(always)]
    pub(crate) fn proposer<S: Simd>(&mut self, simd: S, liste: &Liste<'_, R>, offre: Offre<'_>) {
        simd.vectorize(
            #[inline(always)]
            || {
                let Offre { mots, debut, mut membres, sources } = offre;
                let flou = self.flou;
                let groupes = &mut self.groupes[self.demandes.clone()];
                while let Some(membre) = prendre(&mut membres) {
                    let indice = mots.get(membre).map_or(debut + membre, |mot| indice_lu(*mot));
                    let Some(objet) = liste.objet(indice) else { continue };
                    let (rang, source) = (Rang::de(indice), sources >> membre & 1 == 1);
                    par_forme!(ObjetRay, objet, forme => {
                        let forme = *forme;
                        for groupe in groupes.iter_mut() {
                            groupe.proposer(&forme, rang, flou && source);
                        }
                    });
                }
            },
        );
    }

    /// Offers all objects of the list.
    #[inline(always)]
    pub(crate) fn interroger<S: Simd>(&mut self, simd: S, liste: &Liste<'_, R>) {
        for debut in (0..liste.objets.len()).step_by(LARGEUR) {
            self.proposer(simd, liste, Offre { mots: &[], debut, membres: TOUS, sources: TOUS });
        }
    }

    /// Offers the objects of these [stored](indice_lu) indices, of which any may hold a source.
    #[inline(always)]
    pub(crate) fn interroger_ceux<S: Simd>(&mut self, simd: S, liste: &Liste<'_, R>, mots: &[f32]) {
        for mots in mots.chunks(LARGEUR) {
            let membres = TOUS >> (LARGEUR - mots.len());
            self.proposer(simd, liste, Offre { mots, debut: 0, membres, sources: TOUS });
        }
    }

    /// The largest distance before which a ray looks for an object; 0 if all are done.
    #[inline(always)]
    pub(crate) fn le_plus_loin(&self) -> R {
        let mut loin = R::ZERO;
        for groupe in self.groupes() {
            loin = max(groupe.le_plus_loin(self.un_suffit), loin);
        }
        loin
    }

    /// One of the groups, which was loaded.
    #[inline(always)]
    pub(crate) fn groupe(&self, i: usize) -> &Groupe<R> {
        &self.groupes[i]
    }
}
