//! What a search keeps of what a ray enters: the first object so far, or the first few in order.

use crate::epreuve::Epreuve;
use crate::intersection::{NoIntersection, Rang, Touche};
use crate::liste::Liste;
use crate::objet::ObjetRay;
use crate::rayon::Rayon;
use crate::reel::Reel;

/// What a search keeps of what a ray enters.
pub(crate) trait Retenus<R> {
    /// Nothing that is entered farther than this is kept.
    fn t(&self) -> R;

    /// Keeps the object at this index of the list, entered at distance `t`, if it comes before the last that is kept;
    /// tells whether.
    fn retenir(&mut self, t: R, indice: usize) -> bool;
}

/// Keeps what the ray enters of the objects at these indices of the list, without those that its choice leaves out; if
/// `UN_SUFFIT`, until something is kept. Tells whether something is that suffices.
#[inline(always)]
pub(crate) fn demander<R: Reel, E: Epreuve<R>>(
    epreuve: &E,
    retenus: &mut impl Retenus<R>,
    liste: Liste<'_, R>,
    indices: impl Iterator<Item = usize>,
) -> bool {
    let copie = *epreuve.rayon();
    for indice in indices {
        let Some(objet) = liste.objets.get(indice) else { continue };
        let t = epreuve.t(&copie, objet, indice, false);
        // The first comparison decides nothing: without it every miss ties with none so far, and ranks are compared. The
        // choice after it: before, a list of six without one takes up to 1.07 times as long (measured).
        if t < R::INFINI && liste.contient(indice) && retenus.retenir(t, indice) && E::UN_SUFFIT {
            return true;
        }
    }
    false
}

/// The first object of a ray so far, of a list with at most 2³² − 1 objects.
#[derive(Clone, Copy)]
pub(crate) struct Premier<R> {
    /// Its distance; of none, the distance before which an object is looked for.
    pub(crate) t: R,
    pub(crate) rang: Option<Rang>,
}

impl<R: Reel> Premier<R> {
    /// None so far, and only one nearer than `t` will do.
    #[inline(always)]
    pub(crate) fn avant(t: R) -> Self {
        Self { t, rang: None }
    }

    /// Whether this comes before another: nearer, or as near and earlier in the list. Without a branch, for
    /// sixteen side by side.
    #[inline(always)]
    pub(crate) fn precede(self, autre: Self) -> bool {
        let [rang, son_rang] = [self, autre].map(|premier| Rang::ordre(premier.rang));
        (self.t < autre.t) | ((self.t == autre.t) & (rang < son_rang))
    }

    /// The hit of this ray on it.
    #[inline(always)]
    pub(crate) fn touche(self, objets: &[ObjetRay<R>], rayon: &Rayon<R>) -> Touche<R> {
        let rang = self.rang.ok_or(NoIntersection)?;
        let objet = objets.get(rang.indice()).ok_or(NoIntersection)?;
        Ok(objet.conclure(rayon, self.t, rang))
    }
}

/// The first alone.
impl<R: Reel> Retenus<R> for Premier<R> {
    #[inline(always)]
    fn t(&self) -> R {
        self.t
    }

    #[inline(always)]
    fn retenir(&mut self, t: R, indice: usize) -> bool {
        let trouve = Self { t, rang: Some(Rang::de(indice)) };
        // Ties, which are rare, behind a branch, and two returns: without that branch a ray alone takes up to 1.16
        // times as long, where `precede` alone decides up to 1.12 in rooms, with a flag up to 1.5 (measured).
        if t < self.t || (t == self.t && trouve.precede(*self)) {
            *self = trouve;
            return true;
        }
        false
    }
}

/// The first objects along a ray so far, in order, in places that the caller lent.
pub(crate) struct Rangee<'a, R> {
    pub(crate) objets: &'a [ObjetRay<R>],
    pub(crate) rayon: &'a Rayon<R>,
    /// The distance before which an object is looked for.
    pub(crate) limite: R,
    /// Hits, then misses; before the search misses alone.
    pub(crate) places: &'a mut [Touche<R>],
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
        // A box of which two pieces are asked comes twice, and a half-space where boxes tell no objects apart.
        let deja = suivante.is_ok_and(|suivante| suivante.objet() == rang.indice());
        if !deja && t < self.limite {
            let fin = self.places.len().min(1 + self.places.partition_point(Result::is_ok));
            self.places[place..fin].rotate_right(1);
            self.places[place] = Ok(objet.conclure(self.rayon, t, rang));
            return true;
        }
        false
    }
}
