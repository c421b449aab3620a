//! The objects that the rays of a slice may enter, with the balls around them side by side.

use crate::forme::Boule;
use crate::intersection::{Rang, rang};
use crate::lot::faisceau::Faisceau;
use crate::objet::ObjetRay;
use crate::rayon::Rayon;
use crate::reel::Reel;
use crate::vecteur::Vecteur;

/// From more objects than this on, a beam around all rays of a slice saves more than it costs
/// (measured).
pub(crate) const SEUIL_FAISCEAU: usize = 64;

/// Room for the selection of P objects.
pub(crate) struct Places<R, const P: usize> {
    boules: [[R; P]; 4],
    rangs: [Rang; P],
    ecartees: [bool; P],
}

impl<R: Reel, const P: usize> Places<R, P> {
    pub(crate) const VIDES: Self =
        Self { boules: [[R::ZERO; P]; 4], rangs: [Rang::MIN; P], ecartees: [false; P] };

    pub(crate) fn selection(&mut self) -> Selection<'_, R> {
        let Self { boules: [x, y, z, r2], rangs, ecartees } = self;
        Selection { nombre: 0, centres: [x, y, z], r2, rangs, ecartees }
    }
}

/// The objects that the rays of a slice may enter, in their order.
pub(crate) struct Selection<'p, R> {
    nombre: usize,
    centres: [&'p mut [R]; 3],
    r2: &'p mut [R],
    rangs: &'p mut [Rang],
    ecartees: &'p mut [bool],
}

impl<R: Reel> Selection<'_, R> {
    /// Selects for these rays; false if there was not room for all.
    #[inline(always)]
    pub(crate) fn selectionner(&mut self, objets: &[ObjetRay<R>], rayons: &[Rayon<R>]) -> bool {
        let nombreux = objets.len() > SEUIL_FAISCEAU;
        let faisceau = if nombreux { Faisceau::des_rayons(rayons) } else { None };
        self.nombre = 0;
        for (indice, objet) in objets.iter().enumerate() {
            let boule = objet.boule();
            if faisceau.is_some_and(|faisceau| faisceau.evite(boule)) {
                continue;
            }
            let place = self.nombre;
            if place == self.rangs.len() {
                return false;
            }
            let [x, y, z] = &mut self.centres;
            [x[place], y[place], z[place]] = boule.centre.into();
            self.r2[place] = boule.r2;
            self.rangs[place] = rang(indice);
            self.nombre += 1;
        }
        true
    }

    /// The rank of each of them, and whether the beam avoids it.
    #[inline(always)]
    pub(crate) fn face_a(
        &mut self,
        faisceau: &Faisceau<R>,
    ) -> impl Iterator<Item = (Rang, bool)> + use<'_, R> {
        let n = self.nombre;
        let [x, y, z] = &self.centres;
        let (x, y, z, r2) = (&x[..n], &y[..n], &z[..n], &self.r2[..n]);
        for (i, ecartee) in self.ecartees[..n].iter_mut().enumerate() {
            let boule = Boule { centre: Vecteur::new(x[i], y[i], z[i]), r2: r2[i] };
            *ecartee = faisceau.evite(boule);
        }
        self.rangs[..n].iter().copied().zip(self.ecartees[..n].iter().copied())
    }
}
