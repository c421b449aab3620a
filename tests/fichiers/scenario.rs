//! The first picture of `docs/README.md`: its program, its `Cargo.toml` and its scenario are taken from the page, and
//! make a picture with light, shade and shadows.

use std::fs;

use exemples::scenario::image;

/// The block of the page in this language that begins so, without that beginning.
fn bloc<'a>(page: &'a str, langue: &str, debut: &str) -> &'a str {
    let marque = format!("\n```{langue}\n{debut}");
    let (_, suite) = page.split_once(&marque).expect("a block with this beginning");
    suite.split_once("```").expect("the end of a block").0
}

fn page() -> String {
    fs::read_to_string("docs/README.md").unwrap()
}

#[test]
fn le_programme_de_la_page_est_celui_des_exemples() {
    let tete = "#[allow(dead_code)] // This program does not use all of it.\nmod scene;\n\n";
    let fichier = fs::read_to_string("docs/exemples/scenario.rs").unwrap();
    let (_, programme) = fichier.split_once("\n\n").expect("a head");
    assert_eq!(bloc(&page(), "rust,ignore", tete), programme);
}

/// All that `scene.rs` and the program need, in the versions with which they are compiled here.
#[test]
fn les_dependances_de_la_page_sont_celles_des_exemples() {
    let espace = fs::read_to_string("Cargo.toml").unwrap();
    let page = page();
    let (_, dependances) =
        bloc(&page, "toml", "[package]\n").split_once("[dependencies]\n").unwrap();
    let [noyau, autres @ ..] = &*dependances.lines().collect::<Vec<_>>() else { panic!("none") };
    assert_eq!(*noyau, r#"lancer-rayon = { path = "../lancer-rayon", features = ["serde"] }"#);
    for ligne in autres {
        assert!(espace.lines().any(|autre| autre == *ligne), "{ligne}");
    }
    for source in ["scene", "scenario"] {
        let source = fs::read_to_string(format!("docs/exemples/{source}.rs")).unwrap();
        for nom in ["fastrand", "indicatif", "libm", "png", "rayon", "ron", "serde"] {
            let pris =
                source.contains(&format!("use {nom}::")) || source.contains(&format!(" {nom}::"));
            let la = autres.iter().any(|ligne| ligne.starts_with(&format!("{nom} =")));
            assert!(la || !pris, "{nom} is missing");
        }
    }
}

/// Of the floor some is lit by both lamps, some by one, some by none.
#[test]
fn le_scenario_de_la_page_a_lumiere_et_ombres() {
    let page = page();
    let scenario = bloc(&page, "ron", "");
    let image = image(scenario).unwrap();
    let mut lignes = image.lines();
    assert_eq!(lignes.next(), Some("P3 600 400 255"));
    let pixels: Vec<&str> = lignes.collect();
    assert_eq!(pixels.len(), 600 * 400);
    // 255·√(0.15·c), rounded down: the colour of the floor in the shadow of everything. Above this row the floor is
    // so far away that no lamp lights it.
    let nuit = pixels[600 * 200..].iter().filter(|pixel| **pixel == "88 88 85").count();
    let ciel = pixels.iter().filter(|pixel| **pixel == "0 0 0").count();
    assert!(nuit > 500 && ciel > 500, "{nuit} {ciel}");
    // No lamp, no light but the ambient: fewer colours than objects and sky.
    let (avant, apres) = scenario.split_once("lampes: [").unwrap();
    let (_, apres) = apres.split_once("],\n").unwrap();
    let sans_lampe = self::image(&format!("{avant}lampes: [],\n{apres}")).unwrap();
    let mut teintes: Vec<_> = sans_lampe.lines().skip(1).collect();
    teintes.sort_unstable();
    teintes.dedup();
    assert_eq!(teintes.len(), 4, "{teintes:?}");
    let plus_clairs = pixels.iter().zip(sans_lampe.lines().skip(1)).filter(|(a, b)| *a != b);
    assert!(plus_clairs.count() > 100_000);
}
