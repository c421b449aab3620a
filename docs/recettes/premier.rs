//! A first program: three objects, a ray, and what an error says.

use std::error::Error;

use lancer_rayon::*;

/// What the ray hits, and the error.
pub fn premier() -> Result<(Intersection, String), Box<dyn Error>> {
    let sol = PlanGeo::par_un_point(Vecteur::NUL, Vecteur::Y, Texture(0))?;
    let boule = SphereGeo::new(Vecteur::new(0.0, 1.0, 0.0), 1.0, Texture(1))?;
    let tour = Rotation::new(Vecteur::new(0.0, 0.5, 0.0))?;
    let boite = BoiteGeo::new(Vecteur::Y, Vecteur::new(2.0, 2.0, 1.0), tour, Texture(2))?;
    let boite = boite.translation(Vecteur::X * 3.0)?;
    let objets: [ObjetRay; 3] = [sol.into(), boule.into(), boite.into()];

    let rayon = Rayon::new(Vecteur::new(0.0, 1.0, 5.0), -Vecteur::Z)?;
    let touche = premiere_intersection(&objets, &rayon)?;
    println!("object {} at {}", touche.indice(), touche.distance()); // object 1 at 4

    let erreur = SphereGeo::new(Vecteur::NUL, -1.0, Texture(0)).unwrap_err();
    println!("{erreur}"); // rayon is -1.0, but must be a number above 0
    Ok((touche, erreur.to_string()))
}
