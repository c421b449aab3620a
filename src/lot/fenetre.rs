//! The balls around some objects of a list, side by side.

use crate::forme::Boule;
use crate::lot::faisceau::Faisceau;
use crate::objet::ObjetRay;
use crate::reel::Reel;
use crate::vecteur::Vecteur;

/// The balls around at most P neighbours in a list, coordinate by coordinate.
pub(crate) struct Fenetre<R, const P: usize> {
    centres: [[R; P]; 3],
    r2: [R; P],
    ecartees: [bool; P],
}

impl<R: Reel, const P: usize> Fenetre<R, P> {
    pub(crate) const VIDE: Self =
        Self { centres: [[R::ZERO; P]; 3], r2: [R::ZERO; P], ecartees: [false; P] };

    /// Puts the balls around these objects here.
    #[inline(always)]
    pub(crate) fn charger(&mut self, objets: &[ObjetRay<R>]) {
        let Self { centres: [x, y, z], r2, ecartees: _ } = self;
        for (i, objet) in objets.iter().enumerate().take(P) {
            let boule = objet.boule();
            [x[i], y[i], z[i]] = boule.centre.into();
            r2[i] = boule.r2;
        }
    }

    /// Whether the beam avoids each of the first `n`; without a beam none is avoided.
    #[inline(always)]
    pub(crate) fn face_a(&mut self, faisceau: Option<&Faisceau<R>>, n: usize) -> &[bool] {
        let n = n.min(P);
        let Self { centres: [x, y, z], r2, ecartees } = self;
        let ecartees = &mut ecartees[..n];
        let Some(faisceau) = faisceau else {
            ecartees.fill(false);
            return ecartees;
        };
        let (x, y, z, r2) = (&x[..n], &y[..n], &z[..n], &r2[..n]);
        for (i, ecartee) in ecartees.iter_mut().enumerate() {
            let boule = Boule { centre: Vecteur::new(x[i], y[i], z[i]), r2: r2[i] };
            *ecartee = faisceau.evite(boule);
        }
        ecartees
    }
}
