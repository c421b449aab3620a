//! All objects that a ray enters, or all that hold a point, each shown once; and the first of them
//! in order, in places that the caller lends.

use core::ops::ControlFlow::{self, Break, Continue};

use arrayvec::ArrayVec;

use crate::algebre::nombre::{Nombre, fois_u, max, min};
use crate::objet::ObjetRay;
use crate::question::{Abord, Premier, Question, entree};
use crate::rayon::Rayon;
use crate::rayon::intersection::{Intersection, NoIntersection, Rang, Reponse};

/// How many objects in several pieces wait until a walk is done. If the walk meets more, another
/// follows. Any number would do, since a ray seldom enters even one such object.
const EN_MORCEAUX: usize = 16;

/// Takes the index of an object and where the ray enters it, and says whether to go on, up to which
/// end of the ray.
pub(crate) type Montrer<'a, R> = &'a mut dyn FnMut(usize, R) -> ControlFlow<(), R>;

/// Shows the objects that a ray enters before its end, in no order, each once; or if `D_UN_POINT`
/// those that hold its source.
pub(crate) struct Visite<'a, R, const D_UN_POINT: bool> {
    montrer: Montrer<'a, R>,
    fin: R,
    /// Objects in several pieces, which a walk may meet several times: those of the lowest ranks,
    /// in order.
    en_morceaux: ArrayVec<Premier<R>, EN_MORCEAUX>,
    /// Whether there were more of them.
    encore: bool,
    /// All objects up to this rank have been shown, and all that are in one piece.
    deja: Option<Rang>,
}

impl<'a, R: Nombre, const D_UN_POINT: bool> Visite<'a, R, D_UN_POINT> {
    pub(crate) fn new(fin: R, montrer: Montrer<'a, R>) -> Self {
        Self { montrer, fin, en_morceaux: ArrayVec::new_const(), encore: false, deja: None }
    }

    /// Shows what waited; to be called after each walk. Returns whether another walk is to follow.
    pub(crate) fn montrer_ce_qui_attend(&mut self) -> bool {
        for i in 0..self.en_morceaux.len() {
            let Premier { t, rang } = self.en_morceaux[i];
            self.deja = rang;
            if let Some(rang) = rang.filter(|_| t < self.fin) {
                self.montrer(t, rang.indice());
            }
        }
        self.en_morceaux.clear();
        core::mem::take(&mut self.encore)
    }

    fn montrer(&mut self, t: R, indice: usize) {
        self.fin = match (self.montrer)(indice, t) {
            Continue(fin) => min(fin, self.fin),
            Break(()) => R::ZERO,
        };
    }
}

impl<R: Nombre, const D_UN_POINT: bool> Question<R> for &mut Visite<'_, R, D_UN_POINT> {
    const UN_SUFFIT: bool = false;
    type Vu = R;
    type Reponse = ();

    fn limite(&self) -> R {
        // A ray up to distance 0 crosses the boxes that hold its source.
        if D_UN_POINT { R::ZERO } else { self.fin }
    }

    #[inline(always)]
    fn voir(&self, rayon: &Rayon<R>, objet: &ObjetRay<R>, _: usize, abord: Abord) -> Option<R> {
        if D_UN_POINT {
            return objet.contient(rayon.source()).then_some(R::ZERO);
        }
        entree(rayon, objet, abord).filter(|t| *t < self.fin)
    }

    fn retenir(&mut self, t: R, indice: usize, en_morceaux: bool) -> bool {
        if !en_morceaux {
            if self.deja.is_none() {
                self.montrer(t, indice);
            }
            return true;
        }
        let rang = Some(Rang::de(indice));
        let place =
            self.en_morceaux.partition_point(|autre| Rang::ordre(autre.rang) < Rang::ordre(rang));
        let y_est = self.en_morceaux.get(place).is_some_and(|autre| autre.rang == rang);
        if y_est || Rang::ordre(rang) <= Rang::ordre(self.deja) {
            return false;
        }
        if self.en_morceaux.is_full() {
            self.encore = true;
            if place == EN_MORCEAUX {
                return false;
            }
            self.en_morceaux.pop();
        }
        self.en_morceaux.insert(place, Premier { t, rang });
        false
    }

    fn repondre(self, _: &Rayon<R>, _: &[ObjetRay<R>]) {}
}

/// Whether some object holds the source of the ray.
pub(crate) struct Contenance(pub(crate) bool);

impl<R: Nombre> Question<R> for Contenance {
    const UN_SUFFIT: bool = true;
    type Vu = ();
    type Reponse = bool;

    fn limite(&self) -> R {
        R::ZERO
    }

    #[inline(always)]
    fn voir(&self, rayon: &Rayon<R>, objet: &ObjetRay<R>, _: usize, _: Abord) -> Option<()> {
        objet.contient(rayon.source()).then_some(())
    }

    fn retenir(&mut self, (): (), _: usize, _: bool) -> bool {
        self.0 = true;
        true
    }

    fn repondre(self, _: &Rayon<R>, _: &[ObjetRay<R>]) -> bool {
        self.0
    }
}

/// The first of the objects that are shown, at most one for each place. While there is room they
/// stand as they come; then the places are a heap with the last of them in front.
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
        let trouve = Premier { t, rang: Some(Rang::de(indice)) };
        if let Some(place) = self.places.get_mut(self.nombre) {
            *place = Ok(Intersection::a_conclure(trouve.t, Rang::de(indice)));
            self.nombre += 1;
            if self.nombre < self.places.len() {
                return Continue(R::INFINI);
            }
            trier(self.places);
            self.places.reverse();
        } else if let Some(derniere) = self.places.first_mut()
            && trouve.precede(cle(derniere))
        {
            *derniere = Ok(Intersection::a_conclure(trouve.t, Rang::de(indice)));
            self.descendre();
        }
        let Some(derniere) = self.places.first().map(|derniere| cle(derniere).t) else {
            return Break(());
        };
        // The end is a little beyond the last, since an object at the same distance that is earlier
        // in the list comes before it.
        Continue(derniere + max(derniere * fois_u(2.0), R::MIN_POSITIF))
    }

    /// Brings the first place of the heap to where it belongs.
    fn descendre(&mut self) {
        let mut pere = 0;
        loop {
            let mut tard = pere;
            for fils in [2 * pere + 1, 2 * pere + 2] {
                if fils < self.places.len()
                    && cle(&self.places[tard]).precede(cle(&self.places[fils]))
                {
                    tard = fils;
                }
            }
            if tard == pere {
                return;
            }
            self.places.swap(pere, tard);
            pere = tard;
        }
    }

    /// Puts the places in order and computes what was left open of each hit; returns how many there
    /// are.
    pub(crate) fn conclure(self, rayon: &Rayon<R>, objets: &[ObjetRay<R>]) -> usize {
        trier(self.places);
        for touche in &mut self.places[..self.nombre] {
            let premier = cle(touche);
            *touche = premier.repondre(rayon, objets);
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

fn trier<R: Nombre>(places: &mut [Reponse<R>]) {
    places.sort_unstable_by(|a, b| {
        let (a, b) = (cle(a), cle(b));
        b.precede(a).cmp(&a.precede(b))
    });
}
