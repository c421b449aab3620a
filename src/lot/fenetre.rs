//! The balls around neighbours in a list, in columns: a beam is tested against sixteen at a time.

use fearless_simd::Simd;

use crate::forme::Boule;
use crate::lot::colonnes::{VOIES, Voies};
use crate::lot::faisceau::Faisceau;
use crate::objet::ObjetRay;
use crate::reel::{Reel, au_plus};
use crate::vecteur::Vecteur;

/// The balls around neighbours in a list, coordinate by coordinate: at most Q times sixteen.
#[repr(align(64))]
pub(crate) struct Fenetre<R, const Q: usize> {
    centres: [[Voies<R>; Q]; 3],
    r2: [Voies<R>; Q],
}

impl<R: Reel, const Q: usize> Fenetre<R, Q> {
    /// How many balls there is room for.
    pub(crate) const CAPACITE: usize = Q * VOIES;

    pub(crate) const VIDE: Self =
        Self { centres: [[[R::ZERO; VOIES]; Q]; 3], r2: [[R::ZERO; VOIES]; Q] };

    /// Puts the balls around these objects here.
    #[inline(always)]
    pub(crate) fn charger(&mut self, objets: &[ObjetRay<R>]) {
        let [x, y, z] = self.centres.each_mut().map(|c| c.as_flattened_mut());
        let r2 = self.r2.as_flattened_mut();
        for (i, objet) in objets.iter().enumerate().take(Self::CAPACITE) {
            let boule = objet.boule();
            [x[i], y[i], z[i]] = boule.centre.into();
            r2[i] = boule.r2;
        }
    }

    /// Which of the sixteen balls in this row of the window the beam may meet, a bit for each.
    #[inline(always)]
    pub(crate) fn rencontres<S: Simd>(
        &self,
        simd: S,
        faisceau: &Faisceau<R>,
        rangee: usize,
    ) -> u32 {
        let [x, y, z] = &self.centres;
        let (x, y, z, r2) = (&x[rangee], &y[rangee], &z[rangee], &self.r2[rangee]);
        let (mut h2, mut limites) = ([R::ZERO; VOIES], [R::ZERO; VOIES]);
        for i in 0..VOIES {
            let boule = Boule { centre: Vecteur::new(x[i], y[i], z[i]), r2: r2[i] };
            (h2[i], limites[i]) = faisceau.hauteur_et_limite(boule);
        }
        au_plus(simd, &h2, &limites)
    }
}
