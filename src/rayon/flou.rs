//! What a ray knows of its source.

use crate::algebre::arrondis::{FLOU_DISTANCE, FLOU_POINT, FLOU_RELATIF};
use crate::algebre::nombre::{fois_u, max, simple};
use crate::algebre::refus::positif_ou_nul;
use crate::{ErreurGeo, Nombre, Vecteur};

/// δ, which bounds how deep the source may lie in any object by rounding, and whether the ray
/// starts inside something on purpose. One number holds both: δ is its magnitude, and the sign bit
/// says inside, also of a zero.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Flou<R>(R);

/// Inside and outside differ where δ is 0 as well, although 0 and −0 are equal.
impl<R: Nombre> PartialEq for Flou<R> {
    #[inline]
    fn eq(&self, autre: &Self) -> bool {
        self.0 == autre.0 && self.est_dedans() == autre.est_dedans()
    }
}

impl<R: Nombre> Flou<R> {
    /// A source that is taken as it stands.
    pub(crate) const NUL: Self = Self(R::ZERO);

    /// This δ, 0 or more, of a ray outside.
    #[inline(always)]
    pub(crate) fn de(delta: R) -> Self {
        Self(delta)
    }

    /// The same δ of a ray inside something.
    #[inline(always)]
    pub(crate) fn dedans(self) -> Self {
        Self(-self.delta())
    }

    /// The same δ of a ray outside.
    #[inline(always)]
    pub(crate) fn dehors(self) -> Self {
        Self(self.delta())
    }

    #[inline(always)]
    pub(crate) fn est_dedans(self) -> bool {
        self.0.vers_f64().is_sign_negative()
    }

    /// δ.
    #[inline(always)]
    pub(crate) fn delta(self) -> R {
        self.0.absolu()
    }

    /// The δ to which objects are touched at once: 0 inside, where none is.
    #[inline(always)]
    pub(crate) fn d_emblee(self) -> R {
        max(self.0, R::ZERO)
    }

    /// A δ that somebody gives, on the same side.
    #[inline]
    pub(crate) fn avec(self, delta: R) -> Result<Self, ErreurGeo> {
        // A −0 would say inside.
        let delta = positif_ou_nul("flou", delta)?.absolu();
        Ok(self.du_meme_cote(delta))
    }

    #[inline(always)]
    fn du_meme_cote(self, delta: R) -> Self {
        Self(if self.est_dedans() { -delta } else { delta })
    }

    /// What a ray knows, on the same side, that starts a step `pas` away from the point P, at
    /// distance t of the ray that knows this: the δ of lemma 22, which is finite if the numbers
    /// that are given are.
    #[inline(always)]
    pub(crate) fn suivant(self, pas: R, t: R, p: Vecteur<R>) -> Self {
        // M7: the step, what the hit may be off by, and what the point may.
        let de_plus = t * fois_u(FLOU_DISTANCE) + p.norme_1() * fois_u(FLOU_POINT);
        let suivant = (self.delta() + pas + de_plus) * (R::UN + fois_u(FLOU_RELATIF));
        if suivant < R::INFINI { self.du_meme_cote(suivant) } else { self }
    }

    /// The same in `f32`, for a source that was this in its own type and is that in `f32`.
    #[inline]
    pub(crate) fn vers_f32(self, avant: Vecteur<R>, apres: Vecteur<f32>) -> Flou<f32> {
        if self.delta() == R::ZERO {
            return Flou(simple(self.0));
        }
        let ici = simple(self.suivant(R::ZERO, R::ZERO, avant).0).clamp(f32::MIN, f32::MAX);
        // The step is more than is lost below the normal numbers.
        Flou(ici).suivant(8.0 * f32::ETA, 0.0, apres)
    }

    /// The same in `f64`, exactly.
    pub(crate) fn vers_f64(self) -> Flou<f64> {
        Flou(self.0.vers_f64())
    }
}
