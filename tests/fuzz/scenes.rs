//! Text goes through the scene loader. Some rays and paths ask what comes out, which is also written and read again.
//!
//! It finds little unless it starts from scenes: give it `docs/scenes` as a second folder, after that of its own corpus.

#![no_main]

mod relire;

use std::path::Path;

use commun::Bits;
use commun::chemins::{Pas, Suite, suivre};
use commun::choisis::{Choisis, choisir};
use commun::passages::exiger_les_passages;
use exemples::scene::{Lisible, Scene};
use lancer_rayon::{Monde, ObjetGeo, Rayon, Vecteur, places};
use libfuzzer_sys::fuzz_target;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::relire::relire;

/// How many objects are asked.
const OBJETS: usize = 40;

/// Along a mirror, into glass and out of it, a turn in mid-air, and towards a lamp.
fn pas<R: Bits>(v: Vecteur<R>) -> [Pas<R>; 5] {
    let suites =
        [Suite::Reflechi, Suite::ToutDroit, Suite::ToutDroit, Suite::Bifurque, Suite::Lumiere];
    suites.map(|suite| Pas { suite, vers: v, vise: false, distance: R::UN })
}

fn lire<R: Bits + Serialize + DeserializeOwned + Lisible>(texte: &str) {
    let scene = match Scene::<R>::depuis_texte(Path::new("scene.ron"), texte) {
        Ok(scene) => scene,
        Err(erreur) => return assert!(!erreur.to_string().is_empty()),
    };
    let decrits: Vec<ObjetGeo<R>> = scene.objets.into_iter().take(OBJETS).collect();
    relire(&decrits);
    let objets: Vec<_> = decrits.iter().map(|objet| objet.vers_ray()).collect();
    let mut memoire = vec![0.0; places(objets.len())];
    let arbre = Monde::new(&objets, &mut memoire).unwrap();
    let mut rayons = vec![];
    for (x, y, z) in [(0, 0, -1), (1, 1, 1), (-3, 0, 2), (0, -7, 1)] {
        let vers = Vecteur::from([x, y, z].map(|x| R::depuis_f64(f64::from(x))));
        let rayon = Rayon::new(Vecteur::NUL, vers).unwrap();
        rayons.extend(suivre(arbre, rayon, false, &pas(vers)));
        objets.iter().for_each(|objet| exiger_les_passages(objet, &rayon, vers));
    }
    relire(&rayons);
    for monde in [arbre, Monde::de_liste(&objets)] {
        let touches: Vec<_> = rayons.iter().map(|r| monde.premiere_intersection(r)).collect();
        relire(&touches);
        let pris = (0..objets.len()).collect();
        let tous = Choisis { monde, pris, facon: String::new() };
        tous.interroger(&rayons, &[R::UN], &[Vecteur::NUL], 3);
        choisir(monde, [0b0101_0000, 1, 0]).interroger(&rayons, &[R::UN], &[], 1);
    }
}

fuzz_target!(|texte: &str| {
    lire::<f32>(texte);
    lire::<f64>(texte);
});
