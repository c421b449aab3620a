//! Sixteen rays with the first object of each so far: the search and the conclusion, side by side.
//!
//! Plain loops call the same formulae of [`Forme`] as for a single ray, and the compiler vectorises them.
//! Every instruction set rounds a sum, a product, a quotient and a root alike, so that every ray gets the
//! bits that it gets alone. What the loops call is `inline(always)`: a function that is not inlined would be
//! compiled for the baseline instruction set.

use crate::forme::Forme;
use crate::intersection::{Contact, Intersection, NoIntersection, Rang, Touche};
use crate::lot::colonnes::{Colonnes, VOIES, Voies, le_plus_grand, le_premier};
use crate::objet::{ObjetRay, par_forme};
use crate::rayon::Rayon;
use crate::reel::Reel;
use crate::vecteur::Vecteur;

/// With fewer rays than this on one object, hits are concluded one by one: 5 % faster for rays in no order
/// among 12 objects, and as fast for tiles (measured).
const COTE_A_COTE: u32 = 3;

/// Sixteen rays, the distance of the first object of each so far, and its rank; 0 for none. Each column
/// fills cache lines.
#[repr(align(64))]
pub(crate) struct Groupe<R> {
    pub(crate) colonnes: Colonnes<R>,
    t: Voies<R>,
    rangs: Voies<u32>,
}

impl<R: Reel> Groupe<R> {
    pub(crate) const VIDE: Self =
        Self { colonnes: Colonnes::VIDES, t: [R::INFINI; VOIES], rangs: [0; VOIES] };

    /// Puts these rays here, at most sixteen, with no object so far.
    #[inline(always)]
    pub(crate) fn charger(&mut self, rayons: &[Rayon<R>]) {
        self.colonnes.charger(rayons);
        (self.t, self.rangs) = ([R::INFINI; VOIES], [0; VOIES]);
    }

    /// For each ray that enters the object of this shape and rank before its first so far: makes it its first.
    ///
    /// Of two objects at the same distance the one of lower rank is the first. `EN_ORDRE` promises that
    /// objects come in the order of their ranks, which saves that comparison. Roots and quotients are computed
    /// only if one ray at least may enter.
    #[inline(always)]
    pub(crate) fn proposer<const EN_ORDRE: bool>(&mut self, forme: &impl Forme<R>, rang: Rang) {
        let mut pres = false;
        for voie in 0..VOIES {
            let (s, d) = self.colonnes.rayon(voie);
            pres |= forme.peut_entrer(s, d);
        }
        if !pres {
            return;
        }
        // Computed for all and kept for some, in a loop of its own: a branch would not be vectorised.
        let mut t = [R::INFINI; VOIES];
        for (voie, t) in t.iter_mut().enumerate() {
            let (s, d) = self.colonnes.rayon(voie);
            let entree = forme.t(s, d);
            *t = if forme.peut_entrer(s, d) { entree } else { R::INFINI };
        }
        for (voie, &t) in t.iter().enumerate() {
            let meme = !EN_ORDRE & (t == self.t[voie]) & (rang.get() < self.rangs[voie]);
            let avant = (t < self.t[voie]) | meme;
            self.t[voie] = if avant { t } else { self.t[voie] };
            self.rangs[voie] = if avant { rang.get() } else { self.rangs[voie] };
        }
    }

    /// The first object of one ray so far: its distance and its rank, 0 for none.
    #[inline(always)]
    pub(crate) fn premier(&self, voie: usize) -> (R, u32) {
        (self.t[voie], self.rangs[voie])
    }

    /// The largest distance of a first object so far.
    #[inline(always)]
    pub(crate) fn le_plus_loin(&self) -> R {
        le_plus_grand(self.t)
    }

    /// Writes the answers of these rays: for each object that is the first of some ray, the hits of
    /// all its rays.
    #[inline(always)]
    pub(crate) fn ecrire(
        &self,
        objets: &[ObjetRay<R>],
        rayons: &[Rayon<R>],
        touches: &mut [Touche<R>],
    ) {
        let mut contacts = Contacts::VIDES;
        let mut restent = 0;
        for (voie, touche) in touches.iter_mut().enumerate() {
            if self.rangs[voie] > 0 {
                restent |= 1 << voie;
            } else {
                *touche = Err(NoIntersection);
            }
        }
        while restent != 0 {
            let Some(rang) = Rang::new(self.rangs[le_premier(restent)]) else { return };
            let Some(objet) = objets.get(rang.get() as usize - 1) else { return };
            let mut siens = self.voies_de(rang) & restent;
            restent &= !siens;
            if siens.count_ones() < COTE_A_COTE {
                contacts.surs = [false; VOIES];
            } else {
                par_forme!(ObjetRay, objet, forme => contacts.calculer(self, *forme));
            }
            let texture = objet.texture();
            while siens != 0 {
                let voie = le_premier(siens);
                siens &= siens - 1;
                // Built in its place: to copy a hit just built would stall until its fields are stored.
                if contacts.surs[voie] {
                    touches[voie] = Ok(Intersection::new(contacts.de(voie), texture, rang));
                } else {
                    touches[voie] = objet.conclure(&rayons[voie], self.t[voie], rang);
                }
            }
        }
    }

    /// The rays whose first object has this rank, a bit for each.
    #[inline(always)]
    fn voies_de(&self, rang: Rang) -> u32 {
        let mut siens = 0;
        for (voie, &autre) in self.rangs.iter().enumerate() {
            siens |= u32::from(autre == rang.get()) << voie;
        }
        siens
    }
}

/// The hits of sixteen rays on one shape, computed for all lanes; the caller keeps the valid ones.
#[repr(align(64))]
struct Contacts<R> {
    distance: Voies<R>,
    normale: [Voies<R>; 3],
    marge: Voies<R>,
    surs: Voies<bool>,
}

impl<R: Reel> Contacts<R> {
    const VIDES: Self = Self {
        distance: [R::ZERO; VOIES],
        normale: [[R::ZERO; VOIES]; 3],
        marge: [R::ZERO; VOIES],
        surs: [false; VOIES],
    };

    #[inline(always)]
    fn calculer(&mut self, groupe: &Groupe<R>, forme: impl Forme<R>) {
        let Self { distance, normale: [nx, ny, nz], marge, surs } = self;
        for voie in 0..VOIES {
            let (s, d) = groupe.colonnes.rayon(voie);
            let (contact, sur) = forme.contact(&Rayon::sans_verifier(s, d), groupe.t[voie]);
            distance[voie] = contact.distance;
            [nx[voie], ny[voie], nz[voie]] = contact.normale.into();
            (marge[voie], surs[voie]) = (contact.marge, sur);
        }
    }

    /// The hit of one ray.
    #[inline(always)]
    fn de(&self, voie: usize) -> Contact<R> {
        let Self { distance, normale: [nx, ny, nz], marge, surs: _ } = self;
        let normale = Vecteur::new(nx[voie], ny[voie], nz[voie]);
        Contact { distance: distance[voie], normale, marge: marge[voie] }
    }
}
