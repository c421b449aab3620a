//! The library beside annex A to the letter (`commun/litteral.rs`), away from the weaknesses of the
//! latter: no ray grazes, none is far from its object, none passes beside an edge.

use commun::litteral;
use commun::strategies::{plante, scene};
use commun::tolerances::{DISTANCE, u};
use commun::{en_f32_et_f64, pour_tout};
use lancer_rayon::{ObjetGeo, ObjetRay, Reel, premiere_intersection};
use proptest::prelude::*;

/// What A.2's SC² − SA² loses, in u of SC²: three roundings of each square and the difference.
const LITTERAL: f64 = 8.0;

fn un_objet_touche_de_face_est_touche_au_meme_endroit<R: Reel>() {
    pour_tout(plante::<R>(), |p| {
        let objet = p.objet.vers_ray();
        let ici = objet.intersection(&p.rayon).unwrap();
        let (distance, normale, texture) =
            litteral::premiere_intersection(&[litteral::Objet::from(&objet)], &p.rayon).unwrap();
        let ecart = (ici.distance().vers_f64() - distance.vers_f64()).abs();
        // AB² = r² − AC² is off by LITTERAL·u·SC², and AB = r|N·D| by half of that over AB.
        let annulation = match objet {
            ObjetRay::Sphere(_) => LITTERAL * p.etendue / p.taille,
            ObjetRay::Plan(_) | ObjetRay::Boite(_) => 0.0,
        };
        let tolerance = (2.0 * DISTANCE + annulation) * p.kappa_t();
        prop_assert!(ecart <= tolerance, "distance off by {ecart:e}, {tolerance:e} allowed");
        // CB: the distances, and three roundings of A.2's CB before its length is taken out.
        let normales = match objet {
            ObjetRay::Sphere(_) => 2.0 * (tolerance + 3.0 * u::<R>() * p.etendue) / p.taille,
            ObjetRay::Plan(_) | ObjetRay::Boite(_) => 0.0,
        };
        let ecart = (ici.normale().vers_f64() - normale.vers_f64()).longueur();
        prop_assert!(ecart <= normales, "normal off by {ecart:e}, {normales:e} allowed");
        prop_assert_eq!(ici.texture(), texture);
        Ok(())
    });
}

en_f32_et_f64!(un_objet_touche_de_face_est_touche_au_meme_endroit);

/// In f64 only rays within about 1e-9 of an edge or a tangent may see another object: no random ray
/// comes that close.
#[test]
fn une_scene_entiere_donne_le_meme_premier_objet() {
    pour_tout(scene::<f64>(), |(geo, rayon)| {
        let objets: Vec<_> = geo.into_iter().map(ObjetGeo::vers_ray).collect();
        let litteraux: Vec<_> = objets.iter().map(litteral::Objet::from).collect();
        let ici = premiere_intersection(&objets, &rayon).ok();
        let la = litteral::premiere_intersection(&litteraux, &rayon);
        prop_assert_eq!(ici.map(|t| t.texture()), la.map(|(_, _, texture)| texture));
        Ok(())
    });
}
