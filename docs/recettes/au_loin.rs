//! A scene far from the origin, in `f32`.

use std::error::Error;

use lancer_rayon::{ErreurGeo, ObjetGeo, ObjetRay, Rayon, Vecteur, premiere_intersection};

/// The objects of a scene described in `f64`, in `f32` and seen from this origin.
pub fn scene(objets: &[ObjetGeo], origine: Vecteur) -> Result<Vec<ObjetRay<f32>>, ErreurGeo> {
    objets.iter().map(|objet| Ok(objet.vers_f32(origine)?.vers_ray())).collect()
}

/// The point that a ray of the scene in `f64` hits first.
pub fn lieu(
    scene: &[ObjetRay<f32>],
    rayon: Rayon,
    origine: Vecteur,
) -> Result<Vecteur, Box<dyn Error>> {
    let touche = premiere_intersection(scene, &rayon.vers_f32(origine)?)?;
    Ok(touche.point().vers_f64() + origine)
}
