//! What one may ask for many rays at once: the first object of each, or whether anything stands before
//! the lamp of each.

use crate::intersection::Touche;
use crate::lot::groupe::Groupe;
use crate::objet::ObjetRay;
use crate::premier::Premier;
use crate::rayon::Rayon;
use crate::recherche::{occulte_sauf, premiere_sauf};
use crate::reel::{Reel, max};

/// A ray and what is asked of it.
pub(crate) trait Demande<R: Reel>: Copy {
    type Reponse;

    /// Whether any object before the limit answers, or the first alone.
    const UN_SUFFIT: bool;

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
impl<R: Reel> Demande<R> for Rayon<R> {
    type Reponse = Touche<R>;
    const UN_SUFFIT: bool = false;

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
impl<R: Reel> Demande<R> for (Rayon<R>, R) {
    type Reponse = bool;
    const UN_SUFFIT: bool = true;

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
        premier.rang > 0
    }

    #[inline(always)]
    fn conclure_groupe(groupe: &Groupe<R>, _: &[ObjetRay<R>], occultes: &mut [bool]) {
        for (voie, occulte) in occultes.iter_mut().enumerate() {
            *occulte = groupe.premier(voie).rang > 0;
        }
    }
}
