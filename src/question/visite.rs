//! All objects that a ray enters, or all that hold a point, each shown once; and the first of them
//! in order, in places that the caller lends.

use core::ops::ControlFlow::{self, Break, Continue};

use crate::algebre::nombre::{fois_u, max, min};
use crate::question::{Abord, Premier, Question, t_d_entree};
use crate::rayon::intersection::Rang;
use crate::{Intersection, NoIntersection, Nombre, ObjetRay, Rayon, Reponse};

/// Takes the index of an object and where the ray enters it, and says whether to go on, up to which
/// end of the ray.
pub(crate) type Montrer<'a, R> = &'a mut dyn FnMut(usize, R) -> ControlFlow<(), R>;

/// Shows the objects that a ray enters before its end, in no order, each once; or if `D_UN_POINT`
/// those that hold its source, at distance 0, until told to stop.
pub(crate) struct Visite<'a, R, const D_UN_POINT: bool> {
    /// 0 once told to stop.
    pub(crate) fin: R,
    pub(crate) montrer: Montrer<'a, R>,
}

impl<R: Nombre, const D_UN_POINT: bool> Question<R> for Visite<'_, R, D_UN_POINT> {
    const UN_SUFFIT: bool = D_UN_POINT;
    const CHACUN_UNE_FOIS: bool = true;

    fn limite(&self) -> R {
        // A ray up to distance 0 crosses the boxes that hold its source.
        if D_UN_POINT { R::ZERO } else { self.fin }
    }

    #[inline(always)]
    fn voir(&mut self, rayon: &Rayon<R>, objet: &ObjetRay<R>, _: usize, abord: Abord) -> Option<R> {
        if D_UN_POINT {
            return objet.contient(rayon.source()).then_some(R::ZERO);
        }
        t_d_entree(rayon, objet, abord).filter(|t| *t < self.fin)
    }

    #[inline(always)]
    fn retenir(&mut self, t: R, indice: usize) -> bool {
        let suite = (self.montrer)(indice, t);
        self.fin = suite.continue_value().map_or(R::ZERO, |fin| min(fin, self.fin));
        true
    }

    #[inline(always)]
    fn est_reglee(&self) -> bool {
        self.fin <= R::ZERO
    }
}

/// The first of the objects that are shown, at most one for each place: as they come while there is
/// room, then as a heap, whose first place holds the last of them.
pub(crate) struct Rangee<'a, R> {
    places: &'a mut [Reponse<R>],
    nombre: usize,
}

impl<'a, R: Nombre> Rangee<'a, R> {
    pub(crate) fn new(places: &'a mut [Reponse<R>]) -> Self {
        places.fill(Err(NoIntersection));
        Self { places, nombre: 0 }
    }

    /// Takes in the object at this index, entered at `t`; returns the end of the ray from then on.
    pub(crate) fn placer(&mut self, indice: usize, t: R) -> ControlFlow<(), R> {
        let trouve = Ok(Intersection::a_conclure(t, Rang::de(indice)));
        if let Some(place) = self.places.get_mut(self.nombre) {
            *place = trouve;
            self.nombre += 1;
            if self.nombre < self.places.len() {
                return Continue(R::INFINI);
            }
            (0..self.nombre / 2).rev().for_each(|place| descendre(self.places, place));
        } else if let Some(derniere) = self.places.first_mut()
            && cle(&trouve).precede(cle(derniere))
        {
            *derniere = trouve;
            descendre(self.places, 0);
        }
        let Some(derniere) = self.places.first().map(|derniere| cle(derniere).t) else {
            return Break(());
        };
        // The end is a little beyond the last, since an object at the same distance that is earlier
        // in the list comes before it.
        Continue(derniere + max(derniere * fois_u(2.0), R::ETA))
    }

    /// Puts the places in order and computes what was left open of each hit; returns how many there
    /// are.
    pub(crate) fn en_ordre(self, rayon: &Rayon<R>, objets: &[ObjetRay<R>]) -> usize {
        trier(self.places);
        for touche in &mut self.places[..self.nombre] {
            *touche = cle(touche).reponse(rayon, objets);
        }
        self.nombre
    }
}

/// The key by which places are ordered: a hit by distance and rank, a miss after all hits.
fn cle<R: Nombre>(reponse: &Reponse<R>) -> Premier<R> {
    match reponse {
        Ok(touche) => Premier { t: touche.distance(), rang: Some(Rang::de(touche.indice())) },
        Err(NoIntersection) => Premier::avant(R::INFINI),
    }
}

/// Moves what stands at this place of a heap down until nothing below comes after it.
fn descendre<R: Nombre>(places: &mut [Reponse<R>], mut place: usize) {
    loop {
        let mut dernier = place;
        for dessous in [2 * place + 1, 2 * place + 2] {
            if places.get(dessous).is_some_and(|autre| cle(&places[dernier]).precede(cle(autre))) {
                dernier = dessous;
            }
        }
        if dernier == place {
            return;
        }
        places.swap(place, dernier);
        place = dernier;
    }
}

fn trier<R: Nombre>(places: &mut [Reponse<R>]) {
    places.sort_unstable_by(|a, b| {
        let (a, b) = (cle(a), cle(b));
        b.precede(a).cmp(&a.precede(b))
    });
}
