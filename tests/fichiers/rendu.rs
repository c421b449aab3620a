//! The picture of the renderer is the same, byte for byte, however many rays go together and in however
//! many bands it is made.

#[path = "../../docs/exemples/rendu.rs"]
#[expect(dead_code, reason = "of the program all but what its `main` calls")]
mod programme;

use commun::en_f32_et_f64;
use lancer_rayon::Reel;
use serde::de::DeserializeOwned;

use self::programme::{Bande, ENSEMBLE, octets};

fn un_rayon_a_la_fois_donne_la_meme_image<R: Reel + DeserializeOwned>() {
    for scene in ["docs/scenes/atelier.ron", "docs/scenes/flocon.ron"] {
        let ensemble = octets::<R>(scene, 1, ENSEMBLE, TOUT).unwrap();
        assert_eq!(ensemble.1.len(), 3 * 600 * 400);
        // The bands with the most to see first.
        for numero in [4, 5, 3, 6, 2, 7, 8, 1].into_iter().take(commun::cas(2) as usize) {
            let (_, seuls) = octets::<R>(scene, 1, 1, Bande { numero, nombre: 8 }).unwrap();
            let bande = ensemble.1.chunks(seuls.len()).nth(numero as usize - 1);
            assert!(bande == Some(&seuls), "{scene}, band {numero}");
        }
    }
}

const TOUT: Bande = Bande { numero: 1, nombre: 1 };
const SCENE: &str = "docs/scenes/atelier.ron";

fn les_bandes_bout_a_bout_sont_l_image<R: Reel + DeserializeOwned>() {
    let (_, image) = octets::<R>(SCENE, 1, ENSEMBLE, TOUT).unwrap();
    // 400 rows are no multiple of 7.
    for nombre in [2, 7] {
        let bandes = (1..=nombre).map(|numero| Bande { numero, nombre });
        let octets = bandes.flat_map(|bande| octets::<R>(SCENE, 1, ENSEMBLE, bande).unwrap().1);
        assert!(octets.eq(image.iter().copied()), "{nombre} bands");
    }
}

en_f32_et_f64!(un_rayon_a_la_fois_donne_la_meme_image);
en_f32_et_f64!(les_bandes_bout_a_bout_sont_l_image);
