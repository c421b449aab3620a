//! The pictures that show which of their pixels may be wrong: all rays of all scenes, with `f32` beside `f64` on the
//! same numbers, and rays at the outlines themselves.

use std::fs;
use std::path::Path;

use exemples::scene::Scene;
use exemples::surete::{compter, juger};
use lancer_rayon::{ObjetRay, Rayon, premiere_intersection};

const SCENES: [&str; 5] = ["atelier", "soir", "foule", "flocon", "extremes"];

/// The two adjacent rays at which the answer changes, between two neighbours that see different objects.
fn au_bord(objets: &[ObjetRay<f32>], [mut a, mut b]: [Rayon<f32>; 2]) -> Option<[Rayon<f32>; 2]> {
    let vu = |rayon: &Rayon<f32>| premiere_intersection(objets, rayon).ok().map(|t| t.indice());
    let ici = vu(&a);
    if ici == vu(&b) {
        return None;
    }
    loop {
        let entre = Rayon::new(a.source(), a.direction() + b.direction()).unwrap();
        if entre == a || entre == b {
            return Some([a, b]);
        }
        if vu(&entre) == ici { a = entre } else { b = entre }
    }
}

/// No ray on which the two differ was certain. `benches/mesures/pixels.csv` tells how many rays were not.
#[test]
fn un_pixel_faux_etait_incertain() {
    let racine = Path::new(env!("CARGO_MANIFEST_DIR"));
    let fichier = fs::read_to_string(racine.join("benches/mesures/pixels.csv")).unwrap();
    let mut lignes = String::new();
    for nom in SCENES {
        let scene: Scene<f32> =
            Scene::lire(&racine.join(format!("docs/scenes/{nom}.ron"))).unwrap();
        let objets: Vec<_> = scene.objets.iter().map(|objet| objet.vers_ray()).collect();
        let rayons = scene.camera.rayons().unwrap();
        let voisins = rayons.windows(2).map(|paire| [paire[0], paire[1]]);
        let bords: Vec<_> = voisins.filter_map(|v| au_bord(&objets, v)).flatten().collect();
        let [image, bord] =
            [&rayons, &bords].map(|rayons| compter(&juger(&objets, rayons).unwrap()));
        assert_eq!((image.tues, bord.tues), (0, 0), "{nom}: {image:?} {bord:?}");
        lignes += &format!(
            "{nom},{},{},{},{},{},{},{}\n",
            objets.len(),
            rayons.len(),
            image.incertaines,
            image.autres,
            bords.len(),
            bord.incertaines,
            bord.autres
        );
    }
    assert!(fichier.ends_with(&lignes), "benches/mesures/pixels.csv has not these rows:\n{lignes}");
}
