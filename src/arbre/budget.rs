//! What a block of rays may spend together, compared with what its rays spend one by one.
//!
//! Prices are about nanoseconds, and wrong by up to twice, so that nothing is decided by a single
//! sum: a block stops once it has spent more than its rays would, as found out on some of them, and
//! blocks that are as wide are then left apart for a while (`DEVELOPING.md`, "What a block may
//! spend").

use crate::algebre::nombre::{max, min};
use crate::cote_a_cote::groupe::VOIES;
use crate::question::pesee::{MOINDRE, Prix};

/// A node that a block looks at, and what its objects take before they are offered.
pub(crate) const NOEUD_D_UN_BLOC: Prix = 80.0;

/// An object that is offered to sixteen rays which all pass it by, times the numbers that a register
/// holds; and what a ball or a box takes beyond that where a ray comes near.
const PASSEE: Prix = 40.0;
const BOULE_PROCHE: Prix = 110.0;
const BOITE_PROCHE: Prix = 180.0;

/// Wider registers than this, in bytes, make an object no cheaper.
const REGISTRE_UTILE: usize = 32;

/// A block stops once it has spent this many times what its rays would.
const CONFIANCE: f32 = 1.5;

/// A block that stops narrows the width that is tried by this part, from at most this many times its
/// own.
const RECUL: f32 = 0.3;
const MARGE: f32 = 1.5;

/// A block that spends nothing widens it by this part, and each block that is left apart by that.
const AVANCE: f32 = 0.5;
const REPRISE: f32 = 0.015;

/// After this many blocks some rays are weighed again.
const BLOCS_D_UNE_PESEE: u32 = 8;

/// What was found out about some rays of a block.
#[derive(Clone, Copy)]
pub(crate) struct Releve {
    /// What one of them spent alone, in the mean.
    pub(crate) seul: Prix,
    /// What part of some objects with a box one of them comes near.
    pub(crate) proches: f32,
    /// What part of those are boxes.
    pub(crate) boites: f32,
}

/// What the blocks of a call may spend, and how wide they may be.
#[derive(Clone, Copy)]
pub struct Budget {
    /// How many objects have a box.
    objets: f32,
    nombres_par_registre: f32,
    /// What the rays weighed last spent and came near; `None` before any were.
    releve: Option<Releve>,
    /// For how many blocks to come that will do.
    encore: u32,
    /// An object that is offered to sixteen rays, one of which comes near.
    pub(crate) fiche: Prix,
    /// What a ray spends in a block that is offered all objects with a box.
    la_liste: Prix,
    /// Rays that are wider than this are left apart.
    largeur: f32,
}

impl Budget {
    /// Nothing is known yet, but how many objects have a box, and how many bytes a number has and a
    /// register.
    pub(crate) fn new(objets: usize, nombre: usize, registre: usize) -> Self {
        let nombres_par_registre = (registre.min(REGISTRE_UTILE) / nombre) as f32;
        let fiche = (PASSEE + BOULE_PROCHE) / nombres_par_registre;
        let objets = objets as f32;
        let la_liste = objets * fiche / VOIES as Prix;
        let (releve, encore, largeur) = (None, 0, f32::INFINITY);
        Self { objets, nombres_par_registre, releve, encore, fiche, la_liste, largeur }
    }

    /// Whether rays were weighed lately.
    pub(crate) fn est_a_jour(&self) -> bool {
        self.encore > 0
    }

    /// Takes note of what some rays spent alone.
    pub(crate) fn noter(&mut self, ici: Releve) {
        let moyenne = self.releve.map_or(ici, |avant| Releve {
            seul: 0.5 * (avant.seul + ici.seul),
            proches: 0.5 * (avant.proches + ici.proches),
            boites: ici.boites,
        });
        self.releve = Some(moyenne);
        self.encore = BLOCS_D_UNE_PESEE;
        // That none of sixteen rays comes near.
        let mut aucun = 1.0 - moyenne.proches;
        for _ in 0..VOIES.ilog2() {
            aucun *= aucun;
        }
        let proche = BOULE_PROCHE + moyenne.boites * (BOITE_PROCHE - BOULE_PROCHE);
        self.fiche = (PASSEE + proche) / self.nombres_par_registre;
        let en_moyenne = (PASSEE + (1.0 - aucun) * proche) / self.nombres_par_registre;
        self.la_liste = self.objets * en_moyenne / VOIES as Prix;
    }

    /// Whether a block spends no more than its rays even if it is offered all objects.
    pub(crate) fn suffit_a_la_liste(&self) -> bool {
        self.suffirait_a_la_liste(self.releve.map_or(MOINDRE, |releve| releve.seul))
    }

    /// The same if a ray spent this alone.
    pub(crate) fn suffirait_a_la_liste(&self, seul: Prix) -> bool {
        self.la_liste <= seul
    }

    /// What so many rays may spend together: as long as nothing is known, what they spend at least.
    pub(crate) fn permis(&self, rayons: usize) -> Prix {
        if self.suffit_a_la_liste() {
            return Prix::INFINITY;
        }
        let seul = self.releve.filter(|_| self.est_a_jour()).map(|releve| CONFIANCE * releve.seul);
        rayons as Prix * seul.unwrap_or(MOINDRE)
    }

    /// Whether a block has stopped.
    pub(crate) fn est_entame(&self) -> bool {
        self.largeur < f32::INFINITY
    }

    /// Whether rays of this width are left apart.
    pub(crate) fn est_trop_large(&self, largeur: f32) -> bool {
        largeur > self.largeur && !self.suffit_a_la_liste()
    }

    /// The rays of a block are left apart.
    pub(crate) fn laisser(&mut self) {
        self.largeur *= 1.0 + REPRISE;
        self.encore = self.encore.saturating_sub(1);
    }

    /// A part of a block, of this width, stopped.
    pub(crate) fn reculer(&mut self, largeur: f32, part: f32) {
        self.largeur = min(self.largeur, MARGE * largeur) * (1.0 - RECUL * part);
    }

    /// A part of a block, of this width, came to the end, and has spent so much a ray.
    pub(crate) fn avancer(&mut self, largeur: f32, part: f32, depense: Prix) {
        self.encore = self.encore.saturating_sub(1);
        if let Some(releve) = self.releve.filter(|_| self.est_entame()) {
            let gain = max(1.0 - depense / releve.seul, 0.0);
            let plus = min(self.largeur * (1.0 + AVANCE * gain * part), MARGE * largeur);
            self.largeur = max(self.largeur, plus);
        }
    }
}
