//! The same bits everywhere: a hash of the hits and misses of the 240,000 rays of each scene, ray by
//! ray and with each instruction set of the machine.
//!
//! A change of a formula changes a hash, and the failed assertion prints the new one. Read
//! `docs/precision.md` again before you take it over, and tell it in CHANGELOG.md.

mod commun;
#[allow(dead_code, reason = "shared with the examples")]
#[path = "../docs/exemples/scene.rs"]
mod scene;

use std::path::Path;

use commun::Bits;
use commun::conversion::mots;
use lancer_rayon::{NoIntersection, ObjetRay, Rayon, Reglage, Touche, premiere_intersection};
use scene::Scene;
use serde::de::DeserializeOwned;

/// FNV-1a, 64 bits.
fn empreinte<R: Bits>(touches: &[Touche<R>]) -> u64 {
    let octets = touches.iter().flat_map(|t| mots(t).valeurs).flat_map(u64::to_le_bytes);
    octets.fold(0xcbf2_9ce4_8422_2325, |empreinte, octet| {
        (empreinte ^ u64::from(octet)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

fn memes_bits<R: Bits + DeserializeOwned>(nom: &str, attendue: u64) {
    let scene: Scene<R> = Scene::lire(Path::new(&format!("docs/scenes/{nom}.ron"))).unwrap();
    let objets: Vec<_> = scene.objets.into_iter().map(ObjetRay::from).collect();
    let rayons: Vec<Rayon<R>> = scene.camera.rayons().unwrap();
    let mut touches: Vec<_> = rayons.iter().map(|r| premiere_intersection(&objets, r)).collect();
    let scalaire = std::any::type_name::<R>();
    let obtenue = empreinte(&touches);
    assert_eq!(obtenue, attendue, "{nom}, {scalaire}, ray by ray: {obtenue:#018x}");
    for (jeu, reglage) in Reglage::tous() {
        touches.fill(Err(NoIntersection));
        reglage.premieres_intersections(&objets, &rayons, &mut touches).unwrap();
        assert_eq!(empreinte(&touches), attendue, "{nom}, {scalaire}, {jeu}");
    }
}

#[test]
fn l_atelier_f32() {
    memes_bits::<f32>("atelier", 0x9380_a89f_22a2_490d);
}

#[test]
fn l_atelier_f64() {
    memes_bits::<f64>("atelier", 0x89a9_72c8_405e_c4a8);
}

#[test]
fn la_foule_f32() {
    memes_bits::<f32>("foule", 0x5f37_741c_6d9c_3964);
}

#[test]
fn la_foule_f64() {
    memes_bits::<f64>("foule", 0x9ead_9c4c_b412_4f51);
}

#[test]
fn les_extremes_f32() {
    memes_bits::<f32>("extremes", 0x2405_42d7_6977_af2b);
}

#[test]
fn les_extremes_f64() {
    memes_bits::<f64>("extremes", 0xf32b_1f7b_944f_b33c);
}
