//! What one may ask for many rays at once: the first object of each, or whether anything stands before
//! the lamp of each.

use crate::intersection::Touche;
use crate::lot::groupe::Groupe;
use crate::objet::ObjetRay;
use crate::premier::Premier;
use crate::rayon::Rayon;
use crate::recherche::{occulte_sauf, premiere_sauf};
use crate::reel::{Reel, max};

/// A ray and what is asked of it and of each object.
pub(crate) trait Epreuve<R: Reel> {
    /// Whether any object before the limit answers, or the first alone.
    const UN_SUFFIT: bool;

    fn rayon(&self) -> &Rayon<R>;

    /// Where this object counts, which has this index in the list: where the ray enters it, +∞ if
    /// nowhere. The ray is a copy, which stays in registers; if it crosses the box of the object
    /// (`dans_sa_boite`), the ball is not asked, which such a ray seldom passes by.
    #[inline(always)]
    fn t(&self, rayon: &Rayon<R>, objet: &ObjetRay<R>, _indice: usize, dans_sa_boite: bool) -> R {
        if dans_sa_boite { objet.t(rayon) } else { objet.t_si_proche(rayon) }
    }
}

/// A question that may be asked for many rays at once.
pub(crate) trait Demande<R: Reel>: Epreuve<R> + Copy {
    type Reponse;

    /// The ray, and the distance before which an object counts, 0 or more.
    fn lire(&self) -> (Rayon<R>, R);

    /// The answer of the list without the object at this index, ray by ray.
    fn parmi(&self, objets: &[ObjetRay<R>], sauf: Option<usize>) -> Self::Reponse;

    /// The answer, once a search has found this.
    fn conclure(premier: Premier<R>, objets: &[ObjetRay<R>], rayon: &Rayon<R>) -> Self::Reponse;

    /// The same for a group.
    fn conclure_groupe(groupe: &Groupe<R>, objets: &[ObjetRay<R>], reponses: &mut [Self::Reponse]);
}

/// Its first object.
impl<R: Reel> Epreuve<R> for Rayon<R> {
    const UN_SUFFIT: bool = false;

    #[inline(always)]
    fn rayon(&self) -> &Rayon<R> {
        self
    }
}

impl<R: Reel> Demande<R> for Rayon<R> {
    type Reponse = Touche<R>;

    #[inline(always)]
    fn lire(&self) -> (Rayon<R>, R) {
        (*self, R::INFINI)
    }

    fn parmi(&self, objets: &[ObjetRay<R>], sauf: Option<usize>) -> Touche<R> {
        premiere_sauf(objets, sauf, self)
    }

    #[inline(always)]
    fn conclure(premier: Premier<R>, objets: &[ObjetRay<R>], rayon: &Rayon<R>) -> Touche<R> {
        premier.conclure(objets, rayon)
    }

    #[inline(always)]
    fn conclure_groupe(groupe: &Groupe<R>, objets: &[ObjetRay<R>], touches: &mut [Touche<R>]) {
        groupe.ecrire(objets, touches);
    }
}

/// A shadow ray and the distance of its lamp: whether anything stands before the lamp.
impl<R: Reel> Epreuve<R> for (Rayon<R>, R) {
    const UN_SUFFIT: bool = true;

    #[inline(always)]
    fn rayon(&self) -> &Rayon<R> {
        &self.0
    }
}

impl<R: Reel> Demande<R> for (Rayon<R>, R) {
    type Reponse = bool;

    #[inline(always)]
    fn lire(&self) -> (Rayon<R>, R) {
        // Nothing is before a NaN.
        (self.0, max(self.1, R::ZERO))
    }

    fn parmi(&self, objets: &[ObjetRay<R>], sauf: Option<usize>) -> bool {
        occulte_sauf(objets, sauf, &self.0, self.1)
    }

    #[inline(always)]
    fn conclure(premier: Premier<R>, _: &[ObjetRay<R>], _: &Rayon<R>) -> bool {
        premier.rang.is_some()
    }

    #[inline(always)]
    fn conclure_groupe(groupe: &Groupe<R>, _: &[ObjetRay<R>], occultes: &mut [bool]) {
        for (voie, occulte) in occultes.iter_mut().enumerate() {
            *occulte = groupe.premier(voie).rang.is_some();
        }
    }
}
