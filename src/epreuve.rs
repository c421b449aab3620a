//! What a ray asks of each object: where it enters, or whether anything stands before a lamp.

use crate::objet::ObjetRay;
use crate::rayon::Rayon;
use crate::reel::Reel;

/// A ray and what is asked of it and of each object.
pub(crate) trait Epreuve<R: Reel> {
    /// Whether any object before the limit is an answer; else the first alone is.
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

/// Its first object.
impl<R: Reel> Epreuve<R> for Rayon<R> {
    const UN_SUFFIT: bool = false;

    #[inline(always)]
    fn rayon(&self) -> &Rayon<R> {
        self
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
