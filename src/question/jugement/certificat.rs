//! Whether an answer is certain: every object is asked whether it comes later than the first.

use crate::algebre::nombre::{max, selon};
use crate::question::jugement::juge::{coup_d_oeil, loupe};
use crate::question::liste::Liste;
use crate::question::{Abord, Question};
use crate::{Nombre, ObjetRay, Rayon, Reponse};

/// An answer, and whether some object may come before it.
pub(crate) struct Certificat<'a, R> {
    temoin: Rayon,
    /// The first object and its index; `None` for a miss.
    premier: Option<(&'a ObjetRay<R>, usize)>,
    /// The distance by which the ray has entered the first object; for a miss, the largest number
    /// before the end of the ray.
    dernier: f64,
    pub(crate) doute: bool,
}

impl<'a, R: Nombre> Certificat<'a, R> {
    /// `None` if it is not certain that the ray enters the first object before its end, or if that
    /// object is not in the list or is left out, and so is no answer.
    #[inline(always)]
    pub(crate) fn new(
        liste: &Liste<'a, R>,
        rayon: &Rayon<R>,
        reponse: &Reponse<R>,
    ) -> Option<Self> {
        let temoin = rayon.temoin_f64();
        let Ok(touche) = reponse else {
            let dernier = temoin.fin().next_down();
            return Some(Self { temoin, premier: None, dernier, doute: false });
        };
        let premier = liste.objet(touche.indice())?;
        let objet = premier.temoin_f64();
        // G3: an entry beyond the largest number of the type is no hit (C7).
        let plus_grand = selon::<R, _>(f32::MAX.into(), f64::MAX);
        let certaine = |entree: f64| entree < temoin.fin() && entree <= plus_grand;
        let dernier = Some(coup_d_oeil(&objet, &temoin).haut).filter(|entree| certaine(*entree));
        let dernier = dernier.unwrap_or_else(|| loupe(&objet, &temoin).haut);
        let premier = Some((premier, touche.indice()));
        certaine(dernier).then_some(Self { temoin, premier, dernier, doute: false })
    }

    /// Whether the ray certainly enters this object later than the first or never, at a closer
    /// look.
    #[cold]
    fn vient_apres_a_la_loupe(&self, objet: &ObjetRay<R>) -> bool {
        let a_la_loupe = |objet: &ObjetRay<R>| loupe(&objet.temoin_f64(), &self.temoin);
        let premier = self.premier.map(|(premier, _)| a_la_loupe(premier).haut);
        a_la_loupe(objet).bas > premier.unwrap_or(f64::INFINI).min(self.dernier)
    }
}

impl<R: Nombre> Question<R> for Certificat<'_, R> {
    const UN_SUFFIT: bool = true;

    #[inline(always)]
    fn limite(&self) -> R {
        // At least `dernier`, however that rounds.
        max(R::depuis_f64(self.dernier * (1.0 + 2.0 * R::U.vers_f64())), R::ETA)
    }

    /// Sees an object that may come before the first.
    #[inline(always)]
    fn voir(&mut self, rayon: &Rayon<R>, objet: &ObjetRay<R>, i: usize, abord: Abord) -> Option<R> {
        let passe = match abord {
            // No ray that enters an object passes the ball around it by (lemma 17).
            Abord::Inconnu => !objet.boule().approchee(rayon),
            Abord::DansSaBoite { .. } => false,
        };
        // G4: a glance decides most; doubled numbers are dear, and come last.
        let vient_apres = passe
            || self.premier.is_some_and(|(_, premier)| premier == i)
            || coup_d_oeil(&objet.temoin_f64(), &self.temoin).bas > self.dernier
            || self.vient_apres_a_la_loupe(objet);
        (!vient_apres).then_some(R::ZERO)
    }

    #[inline(always)]
    fn retenir(&mut self, _: R, _: usize) -> bool {
        self.doute = true;
        true
    }
}
