//! Objects in one word, without a texture of their own. What a constructor refuses panics.

use lancer_rayon::{
    BoiteGeo, Monde, ObjetRay, PlanGeo, Reel, Rotation, SphereGeo, Texture, Vecteur, places,
};

use crate::conversion::arrondi;

/// The vector of these numbers, each rounded.
pub fn v<R: Reel>(x: f64, y: f64, z: f64) -> Vecteur<R> {
    arrondi(Vecteur::new(x, y, z))
}

pub fn sphere<R: Reel>(centre: Vecteur<R>, rayon: R) -> ObjetRay<R> {
    SphereGeo::new(centre, rayon, Texture(0)).unwrap().into()
}

/// A half-space whose surface passes through this point, by its outward normal of any length.
pub fn mur<R: Reel>(point: Vecteur<R>, normale: Vecteur<R>) -> ObjetRay<R> {
    PlanGeo::par_un_point(point, normale, Texture(0)).unwrap().into()
}

pub fn boite<R: Reel>(centre: Vecteur<R>, cotes: Vecteur<R>, tour: Rotation<R>) -> ObjetRay<R> {
    BoiteGeo::new(centre, cotes, tour, Texture(0)).unwrap().into()
}

/// A box along the axes.
pub fn boite_droite<R: Reel>(centre: Vecteur<R>, cotes: Vecteur<R>) -> ObjetRay<R> {
    boite(centre, cotes, Rotation::IDENTITE)
}

/// These objects with a tree. Its places are lent for good.
pub fn avec_arbre<R: Reel>(objets: &[ObjetRay<R>]) -> Monde<'_, R> {
    Monde::new(objets, vec![0.0; places(objets.len())].leak()).unwrap()
}
