//! What one may ask for many rays at once: the first object of each, or whether anything stands before
//! the lamp of each.

use crate::epreuve::Epreuve;
use crate::intersection::Touche;
use crate::lot::groupe::Groupe;
use crate::objet::ObjetRay;
use crate::rayon::Rayon;
use crate::reel::{Reel, max};
use crate::retenus::Premier;

/// A question that may be asked for many rays at once.
pub(crate) trait Demande<R: Reel>: Epreuve<R> + Copy {
    type Reponse;

    /// The ray, and the distance before which an object counts, 0 or more.
    fn lire(&self) -> (Rayon<R>, R);

    /// The answer, once a search has found this.
    fn reponse(premier: Premier<R>, objets: &[ObjetRay<R>], rayon: &Rayon<R>) -> Self::Reponse;

    /// The same for a group.
    fn reponses_du_groupe(
        groupe: &Groupe<R>,
        objets: &[ObjetRay<R>],
        reponses: &mut [Self::Reponse],
    );
}

impl<R: Reel> Demande<R> for Rayon<R> {
    type Reponse = Touche<R>;

    #[inline(always)]
    fn lire(&self) -> (Rayon<R>, R) {
        (*self, R::INFINI)
    }

    #[inline(always)]
    fn reponse(premier: Premier<R>, objets: &[ObjetRay<R>], rayon: &Rayon<R>) -> Touche<R> {
        premier.touche(objets, rayon)
    }

    #[inline(always)]
    fn reponses_du_groupe(groupe: &Groupe<R>, objets: &[ObjetRay<R>], touches: &mut [Touche<R>]) {
        groupe.ecrire(objets, touches);
    }
}

impl<R: Reel> Demande<R> for (Rayon<R>, R) {
    type Reponse = bool;

    #[inline(always)]
    fn lire(&self) -> (Rayon<R>, R) {
        // Nothing is before a NaN.
        (self.0, max(self.1, R::ZERO))
    }

    #[inline(always)]
    fn reponse(premier: Premier<R>, _: &[ObjetRay<R>], _: &Rayon<R>) -> bool {
        premier.rang.is_some()
    }

    #[inline(always)]
    fn reponses_du_groupe(groupe: &Groupe<R>, _: &[ObjetRay<R>], occultes: &mut [bool]) {
        for (voie, occulte) in occultes.iter_mut().enumerate() {
            *occulte = groupe.premier(voie).rang.is_some();
        }
    }
}
