//! Values without a regime: any bits, and objects and scenes of ordinary size.

use lancer_rayon::{
    BoiteGeo, ObjetGeo, ObjetRay, PlanGeo, Rayon, Reel, SphereGeo, Texture, Vecteur,
};

use crate::hasard::{Hasard, Tirage};
use crate::regimes::{entre, rotation};
use crate::{Bits, arrondi};

/// Any float at all, with the remarkable ones often.
pub fn quelconque<R: Bits>(alea: &mut Hasard) -> R {
    let limite = R::LIMITE.vers_f64();
    let remarquables = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::MAX,
        f64::from(f32::MAX),
        f64::MIN_POSITIVE,
        f64::from(f32::MIN_POSITIVE),
        f64::from_bits(1),
        limite,
        -limite,
        limite.next_up(),
        limite.recip(),
        limite.recip().next_down(),
    ];
    match alea.u8(0..9) {
        0..4 => R::depuis_bits(alea.mot()),
        4..8 => R::depuis_f64(entre(alea, -10.0, 10.0)),
        _ => R::depuis_f64(*alea.choix(&remarquables)),
    }
}

pub fn vecteur_quelconque<R: Bits>(alea: &mut Hasard) -> Vecteur<R> {
    [(); 3].map(|()| quelconque(alea)).into()
}

/// A vector whose coordinates lie within ±`max`.
pub fn vecteur<R: Reel>(alea: &mut Hasard, max: f64) -> Vecteur<R> {
    arrondi([(); 3].map(|()| entre(alea, -max, max)).into())
}

/// A sphere, a half-space or a box of size about 1, whose coordinates are at most ten times that.
pub fn objet<R: Reel>(alea: &mut Hasard) -> ObjetGeo<R> {
    let (centre, texture) = (vecteur(alea, 10.0), Texture(alea.mot() as u32));
    let cotes = [(); 3].map(|()| R::depuis_f64(entre(alea, 0.1, 2.0)));
    match alea.u8(0..3) {
        0 => SphereGeo::new(centre, cotes[0], texture).unwrap().into(),
        1 => PlanGeo::new(rotation(alea), centre.x, texture).unwrap().into(),
        _ => BoiteGeo::new(centre, cotes.into(), rotation(alea), texture).unwrap().into(),
    }
}

/// A list of up to 11 objects, and a ray between two points among them.
pub fn scene<R: Reel>(alea: &mut Hasard) -> (Vec<ObjetRay<R>>, Rayon<R>) {
    let combien = alea.usize(0..12);
    let objets = alea.liste(combien, |alea, _| objet(alea).vers_ray());
    let (source, cible) = (vecteur::<R>(alea, 15.0), vecteur::<R>(alea, 10.0));
    (objets, Rayon::new(source, cible - source).unwrap())
}
