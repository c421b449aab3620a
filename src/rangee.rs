//! What a search keeps of what a ray enters: the first objects so far, in order.

use crate::intersection::{NoIntersection, Rang, Touche};
use crate::objet::ObjetRay;
use crate::premier::{Premier, Retenus};
use crate::rayon::Rayon;
use crate::reel::Reel;

/// The first objects along a ray so far, in order, in places that the caller lent.
pub(crate) struct Rangee<'a, R> {
    objets: &'a [ObjetRay<R>],
    pub(crate) rayon: &'a Rayon<R>,
    /// The distance before which an object is looked for.
    limite: R,
    /// Hits, then misses.
    places: &'a mut [Touche<R>],
}

impl<'a, R: Reel> Rangee<'a, R> {
    /// None so far.
    pub(crate) fn vide(
        objets: &'a [ObjetRay<R>],
        rayon: &'a Rayon<R>,
        limite: R,
        places: &'a mut [Touche<R>],
    ) -> Self {
        places.fill(Err(NoIntersection));
        Self { objets, rayon, limite, places }
    }
}

/// As many as there are places.
impl<R: Reel> Retenus<R> for Rangee<'_, R> {
    fn t(&self) -> R {
        // Where there is no place nothing is kept.
        self.places
            .last()
            .map_or(-R::INFINI, |place| place.map_or(self.limite, |derniere| derniere.distance()))
    }

    fn retenir(&mut self, t: R, indice: usize) -> bool {
        let rang = Rang::de(indice);
        let place = self.places.partition_point(|place| {
            place.is_ok_and(|autre| {
                let autre = Premier { t: autre.distance(), rang: Some(Rang::de(autre.objet())) };
                autre.precede(Premier { t, rang: Some(rang) })
            })
        });
        let (Some(suivante), Some(objet)) = (self.places.get(place), self.objets.get(indice))
        else {
            return false;
        };
        // A box of which two pieces are asked comes twice.
        let deja = suivante.is_ok_and(|suivante| suivante.objet() == rang.indice());
        if !deja && t < self.limite {
            self.places[place..].rotate_right(1);
            self.places[place] = Ok(objet.conclure(self.rayon, t, rang));
            return true;
        }
        false
    }
}
