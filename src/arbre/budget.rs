//! What a block of rays may spend together, compared with what its rays spend one by one.
//!
//! Prices are in about nanoseconds, and off by up to two times, so that nothing is decided by a
//! single sum: a block stops once it has spent more than its rays would, as found out on some of
//! them, and blocks that are as wide are then left apart for a while (`DEVELOPING.md`, "What a block
//! may spend").

use crate::Nombre;
use crate::algebre::nombre::{max, min};
use crate::arbre::pesee::{MOINDRE, Prix};
use crate::cote_a_cote::groupe::VOIES;

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

/// By what part a block that stops lowers the limit of width, which is then at most this many times
/// its own width.
const RECUL: f32 = 0.3;
const AU_DELA: f32 = 1.5;

/// By what part a block that has spent nothing raises that limit, and each block that is left apart.
const AVANCE: f32 = 0.5;
const REPRISE: f32 = 0.015;

/// After this many blocks some rays are weighed again.
const BLOCS_D_UNE_PESEE: u32 = 8;

/// What was found out about some rays of a block.
#[derive(Clone, Copy)]
pub(crate) struct Releve {
    /// What one of them spent alone, in the mean of all but the dearest.
    pub(crate) seul: Prix,
    /// What part of some objects with a box one of them comes near.
    pub(crate) proches: f32,
    /// What part of those are boxes.
    pub(crate) boites: f32,
}

impl Releve {
    /// As if a ray spent as little as it can, and came near every object, which are balls.
    const INCONNU: Self = Self { seul: MOINDRE, proches: 1.0, boites: 0.0 };
}

/// What the blocks of a call may spend, and how wide they may be.
#[derive(Clone, Copy)]
pub struct Budget {
    /// How many objects have a box.
    objets: f32,
    nombres_par_registre: f32,
    /// What the rays weighed so far spent and came near; `None` before any were.
    releve: Option<Releve>,
    /// How many more blocks may rely on that.
    encore: u32,
    /// How many times rays were weighed.
    pub(crate) pesees: usize,
    /// What an object takes that is offered to sixteen rays, one of which comes near. Stored, like
    /// the next price: computed anew for each block they would make tiles take 1.05 times as long
    /// (measured).
    pub(crate) objet_proche: Prix,
    /// What a ray spends in a block that is offered all objects with a box.
    la_liste: Prix,
    /// Whether that is no more than it spends alone.
    suffit: bool,
    /// The limit of width: rays that are wider are left apart.
    largeur: f32,
}

impl Budget {
    /// Nothing is known yet, but how many objects have a box, and how many bytes a number has and a
    /// register.
    pub(crate) fn new(objets: usize, nombre: usize, registre: usize) -> Self {
        let nombres_par_registre = (registre.min(REGISTRE_UTILE) / nombre) as f32;
        let budget = Self {
            objets: objets as f32,
            nombres_par_registre,
            releve: None,
            encore: 0,
            pesees: 0,
            objet_proche: 0.0,
            la_liste: 0.0,
            suffit: false,
            largeur: f32::INFINITY,
        };
        budget.avec_prix(Releve::INCONNU)
    }

    /// The same with the prices for such rays.
    fn avec_prix(self, Releve { seul, proches, boites }: Releve) -> Self {
        // That none of sixteen rays comes near.
        let mut aucun = 1.0 - proches;
        for _ in 0..VOIES.ilog2() {
            aucun *= aucun;
        }
        let proche = BOULE_PROCHE + boites * (BOITE_PROCHE - BOULE_PROCHE);
        let en_moyenne = (PASSEE + (1.0 - aucun) * proche) / self.nombres_par_registre;
        let objet_proche = (PASSEE + proche) / self.nombres_par_registre;
        let la_liste = self.objets * en_moyenne / VOIES as Prix;
        // Where it was no more before, it must be clearly more: prices are off, and rays differ.
        let suffit = la_liste <= if self.suffit { CONFIANCE * seul } else { seul };
        Self { objet_proche, la_liste, suffit, ..self }
    }

    /// Whether rays were weighed lately.
    pub(crate) fn est_a_jour(&self) -> bool {
        self.encore > 0
    }

    /// Takes note of what some rays spent alone.
    pub(crate) fn noter(&mut self, ici: Releve) {
        let moyenne = self.releve.map_or(ici, |avant| Releve {
            // A mean of logarithms: of a heap that is behind it forgets nearly all at once.
            seul: (avant.seul * ici.seul).racine(),
            proches: 0.5 * (avant.proches + ici.proches),
            boites: ici.boites,
        });
        let (releve, encore, pesees) = (Some(moyenne), BLOCS_D_UNE_PESEE, self.pesees + 1);
        *self = Self { releve, encore, pesees, ..*self }.avec_prix(moyenne);
    }

    /// Whether a block spends no more than its rays even if it is offered all objects.
    pub(crate) fn suffit_a_la_liste(&self) -> bool {
        self.suffit
    }

    /// Whether that is so of the rays that were weighed, and not of any rays.
    pub(crate) fn suffit_par_une_pesee(&self) -> bool {
        self.suffit_a_la_liste() && !self.suffirait_a_la_liste(Releve::INCONNU.seul)
    }

    /// Whether it would if a ray spent this alone.
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
        self.largeur = min(self.largeur, AU_DELA * largeur) * (1.0 - RECUL * part);
    }

    /// A part of a block, of this width, came to the end, and has spent so much a ray.
    pub(crate) fn avancer(&mut self, largeur: f32, part: f32, depense: Prix) {
        self.encore = self.encore.saturating_sub(1);
        if let Some(releve) = self.releve.filter(|_| self.est_entame()) {
            let gain = max(1.0 - depense / releve.seul, 0.0);
            let plus = min(self.largeur * (1.0 + AVANCE * gain * part), AU_DELA * largeur);
            self.largeur = max(self.largeur, plus);
        }
    }
}
