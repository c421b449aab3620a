//! Sixteen rays with the first object of each so far: the search and the conclusion, side by side.
//!
//! Plain loops call the same formulae of [`Forme`] as for a single ray, and the compiler vectorises them.
//! Every instruction set rounds a sum, a product, a quotient and a root alike, so that every ray gets the
//! bits that it gets alone. What the loops call is `inline(always)`: a function that is not inlined would be
//! compiled for the baseline instruction set.

use crate::forme::Forme;
use crate::intersection::{Contact, Intersection, NoIntersection, Rang, Touche};
use crate::lot::colonnes::{Colonnes, VOIES, Voies, le_plus_grand, le_premier, membres};
use crate::objet::{ObjetRay, par_forme};
use crate::rayon::Rayon;
use crate::recherche::avant;
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
            *t = forme.t(s, d);
        }
        for (voie, &t) in t.iter().enumerate() {
            let (trouve, premier) = ((t, rang.get()), (self.t[voie], self.rangs[voie]));
            let avant = if EN_ORDRE { t < premier.0 } else { avant(trouve, premier) };
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
            let siens = self.voies_de(rang) & restent;
            restent &= !siens;
            let cote_a_cote = siens.count_ones() >= COTE_A_COTE;
            if cote_a_cote {
                par_forme!(ObjetRay, objet, forme => contacts.calculer(self, *forme));
            }
            let texture = objet.texture();
            for voie in membres(siens) {
                let t = self.t[voie];
                // Built in its place: to copy a hit just built would stall until its fields are stored.
                touches[voie] = Ok(if cote_a_cote && contacts.de_face[voie] {
                    Intersection::new(t, contacts.de(voie), texture, rang)
                } else {
                    objet.conclure(&rayons[voie], t, rang)
                });
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
    normale: [Voies<R>; 3],
    marge: Voies<R>,
    de_face: Voies<bool>,
}

impl<R: Reel> Contacts<R> {
    const VIDES: Self =
        Self { normale: [[R::ZERO; VOIES]; 3], marge: [R::ZERO; VOIES], de_face: [false; VOIES] };

    #[inline(always)]
    fn calculer(&mut self, groupe: &Groupe<R>, forme: impl Forme<R>) {
        let Self { normale: [nx, ny, nz], marge, de_face } = self;
        for voie in 0..VOIES {
            let (s, d) = groupe.colonnes.rayon(voie);
            let (contact, face) = forme.contact(&Rayon::sans_verifier(s, d), groupe.t[voie]);
            [nx[voie], ny[voie], nz[voie]] = contact.normale.into();
            (marge[voie], de_face[voie]) = (contact.marge, face);
        }
    }

    /// The hit of one ray.
    #[inline(always)]
    fn de(&self, voie: usize) -> Contact<R> {
        let Self { normale: [nx, ny, nz], marge, de_face: _ } = self;
        Contact { normale: Vecteur::new(nx[voie], ny[voie], nz[voie]), marge: marge[voie] }
    }
}
