//! The pictures that know which of their pixels may be wrong: of all rays of all scenes, `f32` beside `f64` on the
//! same numbers.

use std::fs;
use std::path::Path;

use crate::scene::Scene;
use crate::surete::juger;

const SCENES: [&str; 5] = ["atelier", "soir", "foule", "flocon", "extremes"];

/// No ray on which the two differ was certain; how many were not is a table of `docs/compromis.md`.
#[test]
fn un_pixel_faux_etait_incertain() {
    let racine = Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = fs::read_to_string(racine.join("docs/compromis.md")).unwrap();
    for nom in SCENES {
        let scene: Scene<f32> =
            Scene::lire(&racine.join(format!("docs/scenes/{nom}.ron"))).unwrap();
        let objets: Vec<_> = scene.objets.iter().map(|objet| objet.vers_ray()).collect();
        let rayons = scene.camera.rayons().unwrap();
        let pixels = juger(&objets, &rayons);
        assert_eq!(pixels.tus, 0, "{nom}: {pixels:?}");
        let ligne = format!(
            "| {nom} | {} | {} | {} | {} |",
            objets.len(),
            rayons.len(),
            pixels.incertains,
            pixels.autres
        );
        assert!(page.contains(&ligne), "docs/compromis.md has not the row {ligne}");
    }
}
