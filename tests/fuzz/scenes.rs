//! Text through the scene loader, and what comes out of it asked with some rays.

#![no_main]

use std::path::Path;

use exemples::scene::Scene;
use lancer_rayon::{Monde, NoIntersection, ObjetGeo, Rayon, Reel, Vecteur, premiere_intersection};
use libfuzzer_sys::fuzz_target;
use serde::de::DeserializeOwned;

fn lire<R: Reel + DeserializeOwned>(texte: &str) {
    match Scene::<R>::depuis_texte(Path::new("scene.ron"), texte) {
        Ok(scene) => {
            let objets: Vec<_> = scene.objets.into_iter().map(ObjetGeo::vers_ray).collect();
            for (x, y, z) in [(0, 0, -1), (1, 1, 1), (-3, 0, 2), (0, -7, 1)] {
                let vers = [x, y, z].map(|x| R::depuis_f64(f64::from(x)));
                let rayon = Rayon::new(Vecteur::NUL, vers.into()).unwrap();
                let premiere = premiere_intersection(&objets, &rayon);
                if let Ok(touche) = premiere {
                    assert!(touche.distance() > R::ZERO && touche.distance() < R::INFINI);
                }
                // All along the ray; and of what it leaves, where.
                let mut touches = vec![Err(NoIntersection); objets.len() + 1];
                let liste = Monde::de_liste(&objets);
                let nombre = liste.dans_l_ordre(&rayon, &mut touches);
                assert_eq!(touches[0], premiere);
                let entres = objets.iter().filter(|objet| objet.intersection(&rayon).is_ok());
                assert_eq!(nombre, entres.count());
                for sortie in objets.iter().flat_map(|objet| objet.sortie(&rayon)) {
                    assert!(sortie.distance() > R::ZERO && sortie.distance() < R::INFINI);
                    assert!(sortie.normale().produit_scalaire(rayon.direction()) > R::ZERO);
                }
            }
        }
        Err(erreur) => assert!(!erreur.to_string().is_empty()),
    }
}

fuzz_target!(|texte: &str| {
    lire::<f32>(texte);
    lire::<f64>(texte);
});
