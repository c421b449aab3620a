//! The balls around neighbours in a list, in columns: a beam is tested against sixteen at a time.

use fearless_simd::Simd;

use crate::forme::Boule;
use crate::lot::faisceau::Faisceau;
use crate::objet::ObjetRay;
use crate::reel::{Reel, simple};
use crate::seize::{Colonne, Membres, SEIZE, au_plus};
use crate::vecteur::Vecteur;

/// The balls around sixteen neighbours in a list, coordinate by coordinate. A window is some of
/// these.
#[repr(align(64))]
pub(crate) struct Rangee<R> {
    centres: [Colonne<R>; 3],
    r2: Colonne<R>,
}

impl<R: Reel> Rangee<R> {
    pub(crate) const VIDE: Self = Self { centres: [[R::ZERO; SEIZE]; 3], r2: [R::ZERO; SEIZE] };

    /// Puts the balls around these objects here, at most sixteen.
    #[inline(always)]
    pub(crate) fn charger(&mut self, objets: &[ObjetRay<R>]) {
        let [x, y, z] = &mut self.centres;
        for (i, objet) in objets.iter().enumerate().take(SEIZE) {
            let boule = objet.boule();
            [x[i], y[i], z[i]] = boule.centre.into();
            self.r2[i] = boule.r2;
        }
    }

    /// Which of the sixteen balls the beam may meet.
    #[inline(always)]
    pub(crate) fn rencontres<S: Simd>(&self, simd: S, faisceau: &Faisceau<R>) -> Membres {
        let ([x, y, z], r2) = (&self.centres, &self.r2);
        let mut degagements = [0.0; SEIZE];
        for i in 0..SEIZE {
            let boule = Boule { centre: Vecteur::new(x[i], y[i], z[i]), r2: r2[i] };
            // Rounding to `f32` keeps the sign, or makes a 0.
            degagements[i] = simple(faisceau.degagement(boule));
        }
        au_plus(simd, &degagements, &[0.0; SEIZE])
    }
}
