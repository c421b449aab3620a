//! The picture of the renderer is the same, byte for byte, however many rays go together and in however many bands it
//! is made.

#[path = "../../docs/exemples/rendu.rs"]
#[expect(dead_code, reason = "of the program all but what its `main` calls")]
mod programme;

use commun::en_f32_et_f64;
use exemples::scene::Lisible;

use self::programme::{Bande, ENSEMBLE, octets};

/// 400 rows are no multiple of 7. Every other band is made ray by ray.
fn des_bandes_bout_a_bout_sont_l_image<R: Lisible>() {
    for scene in ["docs/scenes/atelier.ron", "docs/scenes/flocon.ron"] {
        let image = octets::<R>(scene, 1, ENSEMBLE, Bande { numero: 1, nombre: 1 }).unwrap().octets;
        assert_eq!(image.len(), 3 * 600 * 400);
        let octets = (1..=7).flat_map(|numero| {
            let ensemble = if numero % 2 == 0 { 1 } else { ENSEMBLE };
            octets::<R>(scene, 1, ensemble, Bande { numero, nombre: 7 }).unwrap().octets
        });
        assert!(octets.eq(image), "{scene}");
    }
}

en_f32_et_f64!(des_bandes_bout_a_bout_sont_l_image);
