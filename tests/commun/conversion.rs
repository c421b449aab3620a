//! Conversions between a scene's type, f64 and bits.

use lancer_rayon::{Reel, Reponse, Vecteur};

/// [`Vecteur::depuis_f64`] under a shorter name.
pub fn arrondi<R: Reel>(v: Vecteur) -> Vecteur<R> {
    Vecteur::depuis_f64(v)
}

/// A scalar as bits, and back.
pub trait Bits: Reel {
    fn depuis_bits(bits: u64) -> Self;
    fn bits(self) -> u64;
}

impl Bits for f32 {
    fn depuis_bits(bits: u64) -> Self {
        // The upper half carries the exponent that the strategies choose.
        Self::from_bits((bits >> 32) as u32)
    }
    fn bits(self) -> u64 {
        u64::from(self.to_bits())
    }
}

impl Bits for f64 {
    fn depuis_bits(bits: u64) -> Self {
        Self::from_bits(bits)
    }
    fn bits(self) -> u64 {
        self.to_bits()
    }
}

/// Every bit of a hit or a miss.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mots {
    /// Distance, normal, margin, point and texture. A miss has bits that would be NaNs, and no hit has those.
    pub valeurs: [u64; 9],
    /// The δ of a ray from the hit, which alone tells the δ that the hit keeps; `None` if no ray may start there.
    pub flou: Option<u64>,
    /// The index of the object.
    pub objet: Option<usize>,
}

pub fn mots<R: Bits>(touche: &Reponse<R>) -> Mots {
    let Ok(t) = touche else { return Mots { valeurs: [u64::MAX; 9], flou: None, objet: None } };
    let (n, p, texture) = (t.normale(), t.point(), t.texture().0.into());
    let [d, x, y, z, marge] = [t.distance(), n.x, n.y, n.z, t.marge()].map(R::bits);
    let [px, py, pz] = [p.x, p.y, p.z].map(R::bits);
    let valeurs = [d, x, y, z, marge, px, py, pz, texture];
    let flou = t.secondaire(n).ok().map(|suite| suite.flou().bits());
    Mots { valeurs, flou, objet: Some(t.indice()) }
}

/// The number `de` units in the last place away.
pub fn voisin<R: Bits>(x: R, de: i64) -> R {
    let unite = if size_of::<R>() == 4 { 32 } else { 0 };
    R::depuis_bits((x.bits() << unite).wrapping_add_signed(de << unite))
}
