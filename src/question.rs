//! The questions that a ray asks. They have one trait, so that every walk can ask any of them: a
//! list (`liste.rs`) and a tree (`arbre/parcours.rs`).
//!
//! [`Premier`] asks which object is first, or whether there is any; many rays ask it side by side
//! (`cote_a_cote/bloc.rs`). The others are
//! [`Certificat`](crate::question::jugement::certificat::Certificat) and
//! [`Visite`](crate::question::visite::Visite). A tree weighs any of them by `arbre/pesee.rs`.

pub(crate) mod choix;
pub(crate) mod jugement;
pub(crate) mod liste;
pub(crate) mod visite;

use crate::rayon::intersection::Rang;
use crate::{NoIntersection, Nombre, ObjetRay, Rayon, Reponse};

/// A question: which objects count, and what is kept of them. The caller of the walk makes
/// the answer of what is kept.
pub(crate) trait Question<R: Nombre> {
    /// Whether any object that counts may settle the answer, so that none need be asked first.
    const UN_SUFFIT: bool;

    /// Whether an object that a tree holds in several pieces is kept only once.
    const CHACUN_UNE_FOIS: bool = false;

    /// No object that the ray enters farther than this counts.
    fn limite(&self) -> R;

    /// Told of each node of a tree that is looked at.
    #[inline(always)]
    fn au_noeud(&mut self) {}

    /// Asks the object at this index of the list: the distance at which it counts, 0 if the
    /// question is not for distances, or `None` if it does not count.
    fn voir(
        &mut self,
        rayon: &Rayon<R>,
        objet: &ObjetRay<R>,
        indice: usize,
        abord: Abord,
    ) -> Option<R>;

    /// Keeps the object at this index, seen at distance `t`, if it comes before the last that is
    /// kept; returns whether it did.
    fn retenir(&mut self, t: R, indice: usize) -> bool;

    /// Whether the answer is settled by what has been kept.
    #[inline(always)]
    fn est_reglee(&self) -> bool {
        Self::UN_SUFFIT
    }
}

/// What is known of an object before it is asked.
#[derive(Clone, Copy)]
pub(crate) enum Abord {
    /// Nothing is known: a list asks it.
    Inconnu,
    /// The ray crosses the box of the object. Its ball is not worth asking, since such a ray seldom
    /// passes it by. The box may hold the source of a ray that has a δ above 0, or not.
    DansSaBoite { tient_la_source: bool },
}

/// Where the ray touches the object; `None` if it does not.
#[inline(always)]
pub(crate) fn t_d_entree<R: Nombre>(
    rayon: &Rayon<R>,
    objet: &ObjetRay<R>,
    abord: Abord,
) -> Option<R> {
    let t = match abord {
        Abord::Inconnu => objet.t_si_proche(rayon),
        Abord::DansSaBoite { tient_la_source: true } => objet.t_touche(rayon),
        Abord::DansSaBoite { tient_la_source: false } => objet.t(rayon),
    };
    // No answer depends on this comparison. Without it every miss, at +∞, would tie with having
    // found nothing, and ranks would be compared.
    Some(t).filter(|t| *t < R::INFINI)
}

/// Which object the ray enters first; if it is an `OMBRE`, a shadow, any object before its end.
#[derive(Clone, Copy)]
pub(crate) struct Premier<R, const OMBRE: bool = false> {
    /// The distance of the first object so far; while there is none, the end of the ray.
    pub(crate) t: R,
    pub(crate) rang: Option<Rang>,
}

impl<R: Nombre, const OMBRE: bool> Premier<R, OMBRE> {
    /// No object so far; the first must be nearer than `t`.
    #[inline(always)]
    pub(crate) fn avant(t: R) -> Self {
        Self { t, rang: None }
    }

    /// The same first object, as the question of a shadow or of a first hit.
    #[inline(always)]
    pub(crate) fn en_question<const AUTRE: bool>(self) -> Premier<R, AUTRE> {
        Premier { t: self.t, rang: self.rang }
    }

    /// Whether this comes before another: nearer, or as near and earlier in the list. Without a
    /// branch, for sixteen side by side.
    #[inline(always)]
    pub(crate) fn precede(self, autre: Self) -> bool {
        let [rang, son_rang] = [self, autre].map(|premier| Rang::ordre(premier.rang));
        (self.t < autre.t) | ((self.t == autre.t) & (rang < son_rang))
    }
}

impl<R: Nombre> Premier<R> {
    /// The hit on this object of the list.
    #[inline(always)]
    pub(crate) fn reponse(self, rayon: &Rayon<R>, objets: &[ObjetRay<R>]) -> Reponse<R> {
        let rang = self.rang.ok_or(NoIntersection)?;
        let objet = objets.get(rang.indice()).ok_or(NoIntersection)?;
        objet.touche(rayon, self.t, rang)
    }
}

impl<R: Nombre, const OMBRE: bool> Question<R> for Premier<R, OMBRE> {
    const UN_SUFFIT: bool = OMBRE;

    #[inline(always)]
    fn limite(&self) -> R {
        self.t
    }

    #[inline(always)]
    fn voir(&mut self, rayon: &Rayon<R>, objet: &ObjetRay<R>, _: usize, abord: Abord) -> Option<R> {
        t_d_entree(rayon, objet, abord)
    }

    #[inline(always)]
    fn retenir(&mut self, t: R, indice: usize) -> bool {
        let trouve = Self { t, rang: Some(Rang::de(indice)) };
        // Ties are rare and have a branch of their own, and each outcome its own return. A single
        // ray takes up to 1.16 times as long without that branch, up to 1.12 times in rooms if
        // `precede` alone decides, and up to 1.5 times if a flag holds the outcome (measured).
        if t < self.t || (t == self.t && trouve.precede(*self)) {
            *self = trouve;
            return true;
        }
        false
    }
}
