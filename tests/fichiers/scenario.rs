//! The first picture of `docs/guide.md`: its program, scenario and commands.

use std::fs;

#[path = "../../docs/exemples/scenario.rs"]
#[expect(dead_code, reason = "of the program all but its `main`")]
mod programme;

use self::programme::image;

/// The commands of the page add what `scene.rs` and the program need, in the versions that compile them here.
#[test]
fn les_dependances_de_la_page_sont_celles_des_exemples() {
    let espace = fs::read_to_string("Cargo.toml").unwrap();
    let page = fs::read_to_string("docs/guide.md").unwrap();
    let commandes = page.lines().filter(|ligne| ligne.starts_with("cargo add "));
    let ajouts = commandes.flat_map(|ligne| ligne.split(' ')).filter_map(|mot| mot.split_once('@'));
    let dependances: Vec<_> = ajouts.collect();
    for (nom, version) in &dependances {
        let mut lignes = espace.lines().filter(|ligne| ligne.starts_with(&format!("{nom} =")));
        let exacte = format!("\"{version}\"");
        assert!(lignes.any(|ligne| ligne.contains(&exacte)), "{nom}@{version}");
    }
    for source in ["scene", "scenario"] {
        let source = fs::read_to_string(format!("docs/exemples/{source}.rs")).unwrap();
        for nom in ["fastrand", "indicatif", "libm", "png", "rayon", "ron", "serde"] {
            let pris =
                source.contains(&format!("use {nom}::")) || source.contains(&format!(" {nom}::"));
            assert!(
                !pris || dependances.iter().any(|(autre, _)| *autre == nom),
                "{nom} is missing"
            );
        }
    }
}

/// Both lamps light some of the floor, one lamp some, and none some.
#[test]
fn le_scenario_a_lumiere_et_ombres() {
    let scenario = fs::read_to_string("docs/exemples/scenario.ron").unwrap();
    let image = image(&scenario).unwrap();
    let mut lignes = image.lines();
    assert_eq!(lignes.next(), Some("P3 600 400 255"));
    let pixels: Vec<&str> = lignes.collect();
    assert_eq!(pixels.len(), 600 * 400);
    // The colour of the floor in the shadow of everything: 255·√(0.15·c), rounded down. Above this row the floor is so
    // far away that no lamp lights it.
    let nuit = pixels[600 * 200..].iter().filter(|pixel| **pixel == "88 88 85").count();
    let ciel = pixels.iter().filter(|pixel| **pixel == "0 0 0").count();
    assert!(nuit > 500 && ciel > 500, "{nuit} {ciel}");
    // Without a lamp there is only ambient light, and one colour for each object and the sky.
    let (avant, apres) = scenario.split_once("lampes: [").unwrap();
    let (_, apres) = apres.split_once("],\n").unwrap();
    let sans_lampe = programme::image(&format!("{avant}lampes: [],\n{apres}")).unwrap();
    let mut teintes: Vec<_> = sans_lampe.lines().skip(1).collect();
    teintes.sort_unstable();
    teintes.dedup();
    assert_eq!(teintes.len(), 4, "{teintes:?}");
    let plus_clairs = pixels.iter().zip(sans_lampe.lines().skip(1)).filter(|(a, b)| *a != b);
    assert!(plus_clairs.count() > 100_000);
}
