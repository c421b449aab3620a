//! The picture of the renderer is the same, byte for byte, however many rays go together.

mod commun;
#[allow(dead_code, reason = "what writes the file")]
#[path = "../docs/exemples/rendu.rs"]
mod rendu;

use commun::en_f32_et_f64;
use lancer_rayon::Reel;
use rendu::{ENSEMBLE, octets};
use serde::de::DeserializeOwned;

fn un_rayon_a_la_fois_donne_la_meme_image<R: Reel + DeserializeOwned>() {
    for scene in ["docs/scenes/atelier.ron", "docs/scenes/flocon.ron"] {
        let ensemble = octets::<R>(scene, 1, ENSEMBLE).unwrap();
        assert_eq!(ensemble.1.len(), 3 * 600 * 400);
        assert_eq!(octets::<R>(scene, 1, 1).unwrap(), ensemble, "{scene}");
    }
}

en_f32_et_f64!(un_rayon_a_la_fois_donne_la_meme_image);
