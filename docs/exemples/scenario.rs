//! From a file to a lit picture, in as few lines as may be: a student copies this program, `scene.rs` and
//! `scenario.ron` into a package of their own (`docs/guide.md`). `tests/fichiers/scenario.rs` runs it.

#[allow(dead_code, unreachable_pub)] // This program does not use all of it.
mod scene;

use std::error::Error;

use lancer_rayon::*;
use scene::Scene;

/// What the handout calls a scenario: a scene as `scene.rs` reads it, its colours and its light.
#[derive(serde::Deserialize)]
struct Scenario {
    ambiante: f64,
    lampes: Vec<Lampe>,
    /// Red, green and blue from 0 to 1, for each texture.
    couleurs: Vec<Vecteur>,
    scene: Scene<f64>,
}

#[derive(serde::Deserialize)]
struct Lampe {
    position: Vecteur,
    eclat: f64,
}

/// The picture of this scenario, as the text of a PPM file.
pub(crate) fn image(scenario: &str) -> Result<String, Box<dyn Error>> {
    let Scenario { ambiante, lampes, couleurs, scene } = ron::from_str(scenario)?;
    let objets: Vec<ObjetRay> = scene.objets.iter().map(|objet| objet.vers_ray()).collect();
    let mut memoire = vec![0.0; places(objets.len())];
    let monde = Monde::new(&objets, &mut memoire)?;
    let places_des_lampes: Vec<Lumiere> =
        lampes.iter().map(|lampe| Lumiere::lampe(lampe.position)).collect::<Result<_, _>>()?;

    let (largeur, hauteur) = scene.camera.image;
    let mut image = format!("P3 {largeur} {hauteur} 255\n");
    for rayon in scene.camera.rayons()? {
        let mut couleur = Vecteur::NUL;
        if let Ok(touche) = monde.premiere_intersection(&rayon) {
            let mut lumiere = ambiante;
            for (lampe, place) in lampes.iter().zip(&places_des_lampes) {
                lumiere += lampe.eclat * monde.eclairement(&touche, place);
            }
            let texture = touche.texture().0 as usize;
            couleur = *couleurs.get(texture).ok_or("a texture without a colour")? * lumiere;
        }
        // A screen wants the root of the light; `as u8` keeps 255 for anything above.
        let [r, v, b] = <[f64; 3]>::from(couleur).map(|c| (255.0 * c.sqrt()) as u8);
        image += &format!("{r} {v} {b}\n");
    }
    Ok(image)
}

fn main() -> Result<(), Box<dyn Error>> {
    let scenario = std::fs::read_to_string("scenario.ron")?;
    Ok(std::fs::write("image.ppm", image(&scenario)?)?)
}
