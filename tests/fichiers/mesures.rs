//! The ratios of `docs/vitesse.md` that no program writes are those in the files of `benches/mesures`.

use std::fs;
use std::path::Path;

use crate::dossiers::section;

/// A file of figures: the names of its columns, and its rows.
struct Mesures {
    titres: Vec<String>,
    lignes: Vec<Vec<String>>,
}

/// The cells of this row. A cell in quotes may hold a comma.
fn cases(ligne: &str) -> Vec<String> {
    let mut cases = vec![String::new()];
    let mut cite = false;
    for signe in ligne.chars() {
        match signe {
            '"' => cite = !cite,
            ',' if !cite => cases.push(String::new()),
            _ => cases.last_mut().unwrap().push(signe),
        }
    }
    cases
}

impl Mesures {
    fn lire(nom: &str) -> Self {
        let racine = Path::new(env!("CARGO_MANIFEST_DIR"));
        let texte = fs::read_to_string(racine.join(format!("benches/mesures/{nom}.csv"))).unwrap();
        let mut lignes = texte.lines().map(cases);
        Self { titres: lignes.next().unwrap(), lignes: lignes.collect() }
    }

    /// The numbers in `colonnes`, of the rows that have one of these words in the column `de`.
    fn nombres(&self, de: &str, mots: &[&str], colonnes: &[&str]) -> Vec<f64> {
        let ou = |colonne: &&str| self.titres.iter().position(|titre| titre == colonne).unwrap();
        let (de, ou) = (ou(&de), colonnes.iter().map(ou).collect::<Vec<_>>());
        let est_dite = |ligne: &&Vec<String>| mots.iter().any(|mot| ligne[de].contains(mot));
        let dites = self.lignes.iter().filter(est_dite);
        let nombres: Vec<f64> =
            dites.flat_map(|ligne| ou.iter().map(|&i| ligne[i].parse().unwrap())).collect();
        assert!(!nombres.is_empty(), "{mots:?}");
        nombres
    }
}

/// A ratio as the page writes it.
fn rapport(x: f64) -> String {
    if x < 9.95 { format!("{x:.1}") } else { format!("{x:.0}") }
}

/// The least and the largest, or one if both look the same.
fn etendue(nombres: &[f64]) -> String {
    let moindre = rapport(nombres.iter().copied().fold(f64::INFINITY, f64::min));
    let plus_grand = rapport(nombres.iter().copied().fold(0.0, f64::max));
    if moindre == plus_grand { moindre } else { format!("{moindre} to {plus_grand}") }
}

fn lire(page: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(page)).unwrap()
}

fn page() -> String {
    lire("docs/vitesse.md")
}

/// The text in one line.
fn mots(page: &str) -> String {
    page.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The cells of the rows of this table, which a program wrote, without what stands in brackets.
fn table(page: &str, nom: &str) -> Vec<Vec<String>> {
    let (_, suite) = page.split_once(&format!("<!-- begin {nom} -->")).expect(nom);
    let (table, _) = suite.split_once("<!-- end").unwrap();
    let lignes = table.lines().filter(|ligne| ligne.starts_with("| ")).skip(1);
    let case = |case: &str| case.split(" (").next().unwrap().trim().to_owned();
    lignes.map(|ligne| ligne.trim_matches('|').split('|').map(case).collect()).collect()
}

/// What README says of speed and accuracy is what `docs/vitesse.md` says, and its picture is that of the file.
#[test]
fn les_temps_de_l_entree_sont_ceux_des_mesures() {
    let (entree, mesures) = (lire("README.md"), table(&page(), "variants"));
    let extrait = table(&entree, "variants");
    assert_eq!(extrait.len(), 4);
    let mesures = mesures.iter().map(|ligne| [0, 1, 2, 4, 5].map(|i| ligne[i].clone()));
    let mesures: Vec<_> = mesures.collect();
    for ligne in &extrait {
        assert!(mesures.iter().any(|autre| autre == &**ligne), "{ligne:?} is none of {mesures:#?}");
    }
    let image = Mesures::lire("image");
    let [nous, parry] = ["ours f32", "parry f32"]
        .map(|qui| image.nombres("who", &[qui], &["all_ns"])[0])
        .map(|ns| format!("{ns:.0} ns"));
    let phrase = format!("takes {nous} a pixel in `f32`, and {parry} with parry");
    assert!(mots(&entree).contains(&phrase), "README has not: {phrase}");
}

/// A whole number as a page writes it.
fn en_milliers(x: f64) -> String {
    let chiffres = x.to_string();
    let groupes: Vec<_> = chiffres.as_bytes().rchunks(3).rev().map(str::from_utf8).collect();
    groupes.into_iter().collect::<Result<Vec<_>, _>>().unwrap().join(",")
}

/// How many rays, objects, scenes and cells the pages count.
#[test]
fn les_comptes_des_pages_sont_ceux_des_mesures() {
    let (entree, page, pixels) = (lire("README.md"), page(), Mesures::lire("pixels"));
    let somme = |scenes: &[&str], colonne| -> f64 {
        pixels.nombres("scene", scenes, &[colonne]).into_iter().sum()
    };
    let [tous, atelier]: [&[&str]; 2] = [&[""], &["atelier"]];
    let rayons = en_milliers(somme(atelier, "rays"));
    let resume = table(&page, "summary, AVX-512");
    let cellules: u32 = resume[0].last().unwrap().rsplit(' ').next().unwrap().parse().unwrap();
    // Ten kinds of rays in each scene.
    let scenes = cellules / 10;
    for (texte, phrase) in [
        (&entree, format!("the {rayons} camera rays of the picture on one thread")),
        (&entree, format!("means over {scenes} scenes")),
        (
            &page,
            format!(
                "the {rayons} camera rays of the picture in [README](../README.md), with {} objects",
                somme(atelier, "objects")
            ),
        ),
        (
            &page,
            format!(
                "[{} of the {} camera rays](../benches/mesures/pixels.csv) of five pictures are not certain, while of {} \
                 rays aimed at outlines a third are not",
                somme(tous, "uncertain"),
                en_milliers(somme(tous, "rays")),
                en_milliers(somme(tous, "outline_rays"))
            ),
        ),
        (&page, format!("has {scenes} scenes, of fifteen families")),
        (&page, format!("which makes {cellules} cells in either scalar")),
    ] {
        assert!(mots(texte).contains(&phrase), "a page has not: {phrase}");
    }
    let tiers = somme(tous, "outline_uncertain") / somme(tous, "outline_rays");
    assert!((0.28..0.38).contains(&tiers), "{tiers}");
}

#[test]
fn les_rapports_des_ordres_sont_ceux_du_fichier() {
    let page = page();
    let section = section(&page, "The order in a batch");
    let ordres = Mesures::lire("ordres");
    // What the page compares, the rows of the file, and whether the file has the ratio the other way up.
    let lignes: [(&str, &[&str], bool); 8] = [
        ("sun by sun", &["one sun after the other"], false),
        ("window by window, as the year goes", &["suns as the year goes"], false),
        ("direction by direction", &["within 0.25°", "within 2°", "within 10°"], true),
        ("direction by direction", &["within 30°"], true),
        ("point by point", &["within 90°"], false),
        ("mixed, by first hits", &["first hits of mixed lamps"], false),
        ("as it fires: 16 beams × 4 azimuths", &["a lidar as it fires"], false),
        ("beam by beam", &["a lidar beam by beam"], false),
    ];
    for (quoi, mots, retourne) in lignes {
        let mut nombres = ordres.nombres("order", mots, &["f32", "f64"]);
        if retourne {
            nombres.iter_mut().for_each(|x| *x = x.recip());
        }
        let somme: f64 = nombres.iter().map(|x| x.ln()).sum();
        let moyenne = rapport((somme / nombres.len() as f64).exp());
        let extremes = etendue(&nombres);
        let extremes = if extremes == moyenne { String::new() } else { format!(" ({extremes})") };
        let ligne = format!("| {quoi} | {moyenne}{extremes} |");
        assert!(section.contains(&ligne), "the page has not: {ligne}");
    }
}

#[test]
fn les_rapports_des_facons_sont_ceux_des_fichiers() {
    let page = page();
    let section = section(&page, "List, tree or batch");
    let [tas, appels, morceaux, lointains, jeux] =
        ["tas", "appels", "morceaux", "lointains", "instructions"].map(Mesures::lire);
    let appel = |rayons| rapport(appels.nombres("rays_a_call", &[rayons], &["geometric_mean"])[0]);
    let loin = |quoi, colonnes: &[&str]| lointains.nombres("with", &[quoi], colonnes);
    let tous = ["f32_single", "f32_batch", "f64_single", "f64_batch"];
    let villes = |colonne| rapport(*loin("two towns", &[colonne]).last().unwrap());
    let camera = |i: &str| {
        let de_loin = loin("a camera", &[&format!("{i}_single"), &format!("{i}_batch")]);
        etendue(&de_loin[2..])
    };
    let tuiles = |jeu, scalaire: &str| {
        let colonnes = ["12", "192", "1000"].map(|n| format!("{scalaire}_{n}_ns"));
        jeux.nombres("instructions", &[jeu], &colonnes.each_ref().map(|colonne| &**colonne))
    };
    let sur = |a: Vec<f64>, b: Vec<f64>| -> Vec<f64> {
        a.into_iter().zip(b).map(|(a, b)| a / b).collect()
    };
    let doubles =
        ["AVX-512", "AVX2", "SSE2"].map(|jeu| sur(tuiles(jeu, "f64"), tuiles(jeu, "f32")));
    let doubles = etendue(&doubles.concat());
    assert!(page.contains(&format!("`f64` / `f32` is [{doubles}]")), "the page has not: {doubles}");
    let certificats = Mesures::lire("certificats");
    let moyennes = etendue(&certificats.nombres("scalar", &["f"], &["geometric_mean"]));
    let pires = certificats.nombres("scalar", &["f"], &["highest"]);
    let pire = rapport(pires.into_iter().fold(0.0, f64::max));
    let lien = "(../benches/mesures/certificats.csv)";
    let phrase = format!(
        "takes [{moyennes}]{lien} times as long as its ray, on top of the ray, in the mean over the families of \
         scenes, and {pire} times in the dearest"
    );
    assert!(mots(&page).contains(&phrase), "the page has not: {phrase}");
    let falaises = Mesures::lire("falaises");
    let pire = |appel| rapport(falaises.nombres("call", &[appel], &["largest"])[0]);
    let phrase = format!("none takes more than {} times as long", pire("4096"));
    assert!(mots(&lire("CHANGELOG.md")).contains(&phrase), "CHANGELOG has not: {phrase}");
    for ligne in [
        format!(
            "| in calls of 4,096 / one by one | scenes drawn at random | at most {} |",
            pire("4096")
        ),
        format!("| in calls of 64 / one by one | | at most {} |", pire("64")),
        format!(
            "in each 64 / without | tiles | {} |",
            etendue(&tas.nombres("case", &["1 of 64"], &["f32", "f64"]))
        ),
        format!(
            "crossing many boxes | {} |",
            etendue(&tas.nombres("case", &["single"], &["f32", "f64"]))
        ),
        format!("| one by one / in calls of 64 | rays of all kinds | {} |", appel("64")),
        format!(
            "such as poles | {} |",
            etendue(&morceaux.nombres("way", &["single", "batch"], &["1000", "10000"]))
        ),
        format!(
            "| a city | {} |",
            etendue(&["a sun", "a sky", "a globe"].map(|quoi| loin(quoi, &tous)).concat())
        ),
        format!("| {}; `f64` {} |", villes("f32_single"), villes("f64_single")),
        format!("| {}; `f64` {} |", camera("f32"), camera("f64")),
    ] {
        assert!(section.contains(&ligne), "the page has not: {ligne}");
    }
}
