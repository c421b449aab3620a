//! A block of rays, to which a list offers all of its objects and a tree those of the leaves that
//! its beam crosses.

use core::marker::PhantomData;

use arrayvec::ArrayVec;
use fearless_simd::Simd;

use crate::intersection::{Rang, Reponse};
use crate::liste::Liste;
use crate::lot::faisceau::{Faisceau, egares};
use crate::lot::groupe::{Groupe, VOIES};
use crate::nombre::{Nombre, max};
use crate::objet::{ObjetRay, par_forme};
use crate::question::{Ombre, Premier, Question};
use crate::rayon::Rayon;

/// Rays of a block: a tile of 8 × 8 pixels.
pub(crate) const BLOC: usize = 4 * VOIES;

/// Fewer rays than this are asked of a list one by one (`benches/seuils.md`, "Thresholds").
const RAYONS_D_UNE_LISTE: usize = 6;

/// The memory of a block, which grows no larger than a call needs: since setting up all of it costs
/// as much as some rays. It stands outside of the block, which would take up to 1.15 times as long
/// with it inside (calls of 16, measured).
pub(crate) type Groupes<R> = ArrayVec<Groupe<R>, { BLOC / VOIES }>;

/// A question that the rays of a block ask side by side: each keeps a first object so far.
pub(crate) trait EnLot<R: Nombre>: Question<R> + From<Premier<R>> {
    /// Writes the answers of a group.
    fn repondre_ensemble(
        groupe: &Groupe<R>,
        objets: &[ObjetRay<R>],
        reponses: &mut [Self::Reponse],
    );
}

impl<R: Nombre> EnLot<R> for Premier<R> {
    #[inline(always)]
    fn repondre_ensemble(groupe: &Groupe<R>, objets: &[ObjetRay<R>], touches: &mut [Reponse<R>]) {
        groupe.ecrire(objets, touches);
    }
}

impl<R: Nombre> EnLot<R> for Ombre<R> {
    #[inline(always)]
    fn repondre_ensemble(groupe: &Groupe<R>, _: &[ObjetRay<R>], occultes: &mut [bool]) {
        for (voie, occulte) in occultes.iter_mut().enumerate() {
            *occulte = groupe.premier(voie).rang.is_some();
        }
    }
}

/// At most 64 rays with the first object of each so far.
pub(crate) struct Bloc<'a, R, Q> {
    /// How many rays are here, not counting what stands in for missing ones.
    nombre: usize,
    /// Whether some ray has a δ above 0.
    flou: bool,
    /// The rays in whose place others stand, one bit for each.
    egares: u64,
    groupes: &'a mut Groupes<R>,
    question: PhantomData<Q>,
}

impl<'a, R: Nombre, Q: EnLot<R>> Bloc<'a, R, Q> {
    #[inline(always)]
    pub(crate) fn new(groupes: &'a mut Groupes<R>) -> Self {
        Self { nombre: 0, flou: false, egares: 0, groupes, question: PhantomData }
    }

    /// Loads these rays, with no object so far.
    #[inline(always)]
    pub(crate) fn charger(&mut self, rayons: &[Rayon<R>]) {
        (self.nombre, self.flou, self.egares) = (rayons.len(), false, 0);
        for (i, rayons) in rayons.chunks(VOIES).enumerate() {
            if i == self.groupes.len() {
                self.groupes.push(Groupe::VIDE);
            }
            self.groupes[i].charger(rayons);
            self.flou |= self.groupes[i].est_flou();
        }
    }

    /// The groups that hold rays.
    #[inline(always)]
    pub(crate) fn groupes(&self) -> &[Groupe<R>] {
        &self.groupes[..self.nombre.div_ceil(VOIES)]
    }

    #[inline(always)]
    fn rayon(&self, i: usize) -> Rayon<R> {
        self.groupes[i / VOIES].rayon(i % VOIES)
    }

    /// This many of these rays, two or more, evenly spread from the first to the last.
    #[inline(always)]
    pub(crate) fn rayons_epars(&self, combien: usize) -> impl Iterator<Item = Rayon<R>> {
        (0..combien).map(
            #[inline(always)]
            move |i| self.rayon(i * (self.nombre - 1) / (combien - 1)),
        )
    }

    /// The beam of these rays, up to their limits if all have one; `None` if they go too far apart
    /// for one.
    #[inline(always)]
    pub(crate) fn faisceau(&self) -> Option<Faisceau<R>> {
        let reperes = [0, 7, self.nombre / 2].map(|i| self.rayon(i));
        if self.le_plus_loin() <= R::LIMITE {
            return Some(Faisceau::de_segments(self.groupes(), reperes));
        }
        Faisceau::de_rayons(self.groupes(), reperes)
    }

    /// Lays aside the rays that [stray](egares) until none does: one that does not stands in for
    /// them. Tells whether there are some.
    #[cold]
    #[inline(never)]
    pub(crate) fn ecarter_les_egares<S: Simd>(&mut self, simd: S) -> bool {
        simd.vectorize(
            #[inline(always)]
            || {
                let (deja, places) = (self.egares, self.groupes().len() * VOIES);
                loop {
                    let egares = egares(self.groupes());
                    let autre = egares.trailing_ones() as usize;
                    if egares == 0 || autre >= places {
                        return self.egares > deja;
                    }
                    self.egares |= egares;
                    let (rayon, premier) = (self.rayon(autre), self.premier(autre));
                    for i in (0..places).filter(|i| egares >> i & 1 == 1) {
                        self.groupes[i / VOIES].remplacer(i % VOIES, &rayon, premier);
                    }
                }
            },
        )
    }

    /// Whether this ray was laid aside, so that its first object is not here.
    #[inline(always)]
    pub(crate) fn est_egare(&self, i: usize) -> bool {
        self.egares >> i & 1 == 1
    }

    /// Whether some ray was.
    #[inline(always)]
    pub(crate) fn a_des_egares(&self) -> bool {
        self.egares > 0
    }

    /// Makes the object at this index of the list the first of each ray that enters it before its
    /// first so far. `source` says that it may hold the source of a ray.
    ///
    /// The shape is copied: nothing that is written to a group can overlap it, so that the compiler
    /// need not read it again for every ray.
    #[inline(always)]
    pub(crate) fn proposer(&mut self, liste: &Liste<'_, R>, indice: usize, source: bool) {
        let Some(objet) = liste.objet(indice) else { return };
        let (rang, groupes, flou) = (Rang::de(indice), self.groupes().len(), self.flou && source);
        par_forme!(ObjetRay, objet, forme => {
            let forme = *forme;
            for groupe in &mut self.groupes[..groupes] {
                groupe.proposer(&forme, rang, Q::UN_SUFFIT, flou);
            }
        });
    }

    /// Calls [`proposer`](Self::proposer) with every object of the list.
    #[inline(always)]
    pub(crate) fn interroger(&mut self, liste: &Liste<'_, R>) {
        for indice in 0..liste.objets.len() {
            self.proposer(liste, indice, true);
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
        self.groupes[i / VOIES].premier(i % VOIES)
    }

    /// Writes the answers. It is compiled for each instruction set, and list and tree share it.
    #[inline(always)]
    pub(crate) fn repondre<S: Simd>(
        &self,
        simd: S,
        liste: &Liste<'_, R>,
        reponses: &mut [Q::Reponse],
    ) {
        simd.vectorize(
            #[inline(always)]
            || {
                for (groupe, reponses) in self.groupes.iter().zip(reponses.chunks_mut(VOIES)) {
                    Q::repondre_ensemble(groupe, liste.objets, reponses);
                }
            },
        );
    }

    /// Writes the answers of a list to the rays of a block: together if they are enough, else one
    /// by one.
    #[inline(always)]
    pub(crate) fn repondre_de_la_liste<S: Simd>(
        &mut self,
        simd: S,
        liste: &Liste<'_, R>,
        (rayons, reponses): (&[Rayon<R>], &mut [Q::Reponse]),
    ) {
        if rayons.len() >= RAYONS_D_UNE_LISTE {
            self.charger(rayons);
            self.interroger(liste);
            return self.repondre(simd, liste, reponses);
        }
        simd.vectorize(
            #[inline(always)]
            || {
                for (rayon, reponse) in rayons.iter().zip(reponses) {
                    let mut question = Q::from(Premier::avant(rayon.fin()));
                    liste.interroger(rayon, &mut question);
                    *reponse = question.repondre(rayon, liste.objets);
                }
            },
        );
    }
}
