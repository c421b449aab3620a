//! The numbers in the tables of constants and in the steps of the algorithms are those of the code. A test of
//! `tests/precision` ties the same constants to what their lemmas need.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use crate::dossiers::{fichiers_sous, section};
use crate::etiquettes::algorithmes;

/// The numbers of each row of the table of constants, and of the letters, in their order: constants of the code, parts of
/// such, or what no constant holds. 0, 1 and 2 do not count.
const CONSTANTES: &[(&str, &str)] = &[
    ("u, u₃₂", "2⁻²⁴ 2⁻⁵³"),
    ("η", "2⁻¹⁴⁹ 2⁻¹⁰⁷⁴"),
    ("S, D", "UNITAIRE_D"),
    ("λ", "BOITE_LONGUEUR"),
    ("δ, o", "FLOU_PROPRE FLOU_PROPRE"),
    ("band, sphere (3, tape)", "SPHERE"),
    ("– half-space (3)", "PLAN PLAN_ABSOLUE VITESSE"),
    ("– box (3)", "VITESSE"),
    ("distance, sphere (5, tape)", "DISTANCE_SPHERE DISTANCE_PERDUE PERDUE"),
    ("– half-space (4, tape but for η)", "DISTANCE_PLAN PLAN_ABSOLU VITESSE"),
    ("– box (4, tape)", "DISTANCE_BOITE VITESSE"),
    ("– scene units (1)", "UNITAIRE_D"),
    ("way out (3, 10, tape)", "SORTIE_SPHERE SPHERE"),
    ("place, sphere (6)", "LIEU_SPHERE LIEU_P LIEU_P"),
    ("– half-space (6)", "LIEU_PLAN_S LIEU_PLAN_T LIEU_P LIEU_PLAN_ABSOLU"),
    ("– box (6)", "LIEU_F LIEU_T LIEU_P"),
    ("– `lieu` (6)", "LIEU_FACE"),
    ("– `vers_lieu` (10)", "BORD"),
    ("normal (1)", "UNITAIRE_SPHERE UNITAIRE_PLATE"),
    ("– sphere (7)", "PERDUE DIRECTION"),
    ("margin of +∞ (8)", "1/ARRONDI_PERDU PERDUE 1/ARRONDI_PERDU D_EMBLEE_PERDUE"),
    ("mirror (9)", "REFLECHI_PLAT REFLECHI_SPHERE REFLECHI_REDRESSE TANGENT"),
    ("glass (9)", "RAPPORT_MAXIMAL REFRACTE"),
    ("– n = 1 (9)", "TOUT_DROIT REFLECHI_REDRESSE TANGENT"),
    ("total reflection (9)", "REFRACTE_TOTALE"),
    ("lamp (11)", "LAMPE_DISTANCE LAMPE_DIRECTION LAMPE_COSINUS TANGENT"),
    ("– where a ray between points ends (11)", "BOUT"),
    ("sun (11)", "SOLEIL"),
    ("line of sight (12)", "SOUS_LE_PLAN"),
    ("transformation (11)", "DISTANCE_DEPLACEE PLAN_ABSOLUE CENTRE_TOURNE PLAN_ABSOLUE"),
    ("¦M·Mᵀ−I¦, an element (13)", "ORTHONORMALE ORTHONORMALE_GARDEE"),
    ("`puis`, an object turned (13)", "COMPOSEE COMPOSEE_D_AUTRES"),
    ("`new`, `autour_de`, `depuis_quaternion` (13)", "TOUR"),
    ("`entre`, `regard` (13)", "ENTRE REGARD REGARD_DROIT"),
    ("extent (15)", "ETENDUE_TAILLE ETENDUE_CENTRE"),
];

/// The same of the paragraphs that say a promise in words, by their titles or their first words. What is measured, or
/// follows from several constants, stands here as it does there.
const PHRASES: &[(&str, &str)] = &[
    ("Distance", "DISTANCE_PERDUE VITESSE"),
    ("Normal", "PERDUE"),
    ("Mirror and glass are", "DISTANCE_SPHERE DISTANCE_PLAN DISTANCE_BOITE 4.92 3.25 3.72"),
    ("In the band", "VITESSE"),
    ("Near the edge of a box", "VITESSE VITESSE"),
    ("An inward secondary ray", "LIEU_P 14"),
    ("A ray with a", "FLOU_A_COTE"),
    ("Not proved", "8 30"),
    (
        "How δ grows.",
        "FLOU_DISTANCE FLOU_POINT FLOU_RELATIF 1/PAS_D_EMBLEE PAS_D_EMBLEE_POINT 2.22",
    ),
    ("In a room of", "10 11 0.03 0.045 10 110"),
    ("A chain need not end", "1008 358 10"),
];

/// The same of lemma 22.
const PROFONDEURS: &[(&str, &str)] = &[
    ("outside, a half-space", "D_UN_PLAN"),
    ("outside, a box", "D_UNE_BOITE"),
    ("outside, a sphere, ¦f¦ < 2r", "D_UNE_SPHERE"),
    ("outside, a sphere, ¦f¦ ≥ 2r", "D_UNE_SPHERE_LOIN"),
    ("inside, a half-space", "DANS_UN_PLAN"),
    ("inside, a sphere", "DANS_UNE_SPHERE"),
    ("inside, a box", "DANS_UNE_BOITE UNE_FOIS"),
];

/// The same of the steps.
const PAS: &[(&str, &str)] = &[
    ("S7", "2⁻¹²¹ 2⁻⁹⁰¹"),
    ("S8", "PENCHE"),
    ("B2", "2⁻⁴⁷ 2¹⁰⁹ 2⁵⁶⁸"),
    ("B4", "2⁶³ 2⁴⁵³"),
    ("B5", "2⁶² 2⁵⁶⁸"),
    ("J7", "ERREUR_ARRONDIE 1/NET"),
    ("J8", "ECART_ARRONDI"),
    ("Judgement of t", "16"),
    ("A glance", "VUE_POINT 2⁻¹⁰²²"),
    ("G1", "VUE_LONGUEUR VUE_VITESSE"),
    ("G2", "VUE_PUISSANCE 16"),
    ("E1", "ETENDUE"),
    ("M3", "LONGUEUR PAR_RAYON PUISSANCE_PERDUE 1/TRAVERS_PERDU 1/ARRONDI_PERDU"),
    ("M4", "2·ARRONDI_HAUTEUR VERS_LE_HAUT 2⁻¹⁰⁰ 2⁻⁹⁰⁰"),
    ("M5", "TANGENT TANGENT REDRESSE"),
    ("M6", "PAS_NORMAL PAS_ARRONDI 1/PAS_D_EMBLEE PAS_D_EMBLEE_POINT"),
    ("M7", "FLOU_DISTANCE FLOU_POINT FLOU_RELATIF 2⁻¹⁰⁰ 2⁻⁹⁰⁰ FLOU_POINT FLOU_RELATIF 8"),
    ("D1", "FLOU_PROPRE"),
    ("D3", "FLOU_PROPRE FLOU_A_COTE"),
    ("L3", "TANGENT TANGENT"),
    ("O2", "RETRAIT"),
    ("T2", "JEU_DISTANCE JEU_LARGEUR JEU_F32"),
    ("T3", "JEU_F32 JEU_DISTANCE RACINE_DE_TROIS JEU_SOUS_NORMAL 1/JEU_MAXIMAL"),
    ("T4", "IMMOBILE IMMOBILE"),
    ("T5", "2⁻¹⁷"),
];

fn lire(page: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(page)).unwrap()
}

/// 2⁻¹⁰⁰ as its exponent, since it may be less than what a number holds; other numbers as they are.
fn nombre(texte: &str) -> f64 {
    let signe = |c: char| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|chiffre| chiffre == c);
    let Some(exposant) = texte.strip_prefix('2').filter(|reste| !reste.is_empty()) else {
        return texte.parse().expect(texte);
    };
    let grandeur = exposant.chars().filter_map(signe).fold(0.0, |x, c| 10.0 * x + c as f64);
    if grandeur == 0.0 { texte.parse().expect(texte) } else { 1e6 + grandeur }
}

/// The numbers in a text, other than 0, 1 and 2 and what belongs to a word such as `f32`.
fn nombres(texte: &str) -> Vec<f64> {
    let dans_le_mot = |c: char| c.is_alphanumeric() || "_.⁻".contains(c);
    let dans_le_nombre = |c: char| c.is_ascii_digit() || ".⁻⁰¹²³⁴⁵⁶⁷⁸⁹".contains(c);
    let mots = texte
        .split(|c| !dans_le_mot(c))
        .filter(|mot| mot.starts_with(|c: char| c.is_ascii_digit()));
    let nombres = mots.map(|mot| {
        let fin = mot.find(|c| !dans_le_nombre(c)).unwrap_or(mot.len());
        nombre(mot[..fin].trim_end_matches('.'))
    });
    nombres.filter(compte).collect()
}

fn compte(x: &f64) -> bool {
    ![0.0, 1.0, 2.0].contains(x)
}

/// The constants of the code by name, as often as the name stands there; of an array all that counts.
fn constantes() -> BTreeMap<String, Vec<Vec<f64>>> {
    let un = |texte: &str| -> Option<f64> {
        if let Some(k) = texte.strip_prefix("puissance_de_deux(-") {
            return Some(1e6 + k.trim_end_matches(')').parse::<f64>().ok()?);
        }
        let (a, b) = texte.split_once(" / ").unwrap_or((texte, "1"));
        Some(a.parse::<f64>().ok()? / b.parse::<f64>().ok()?)
    };
    let mut constantes = BTreeMap::<_, Vec<_>>::new();
    let sources = fichiers_sous("src").into_iter().map(|f| fs::read_to_string(f).unwrap());
    for texte in sources.chain([lire("tests/commun/tolerances.rs")]) {
        for ligne in texte.lines().filter_map(|ligne| ligne.trim().strip_suffix(';')) {
            let Some((_, suite)) = ligne.split_once("const ") else { continue };
            let Some((nom, valeur)) = suite.split_once(" = ") else { continue };
            let valeur = valeur.trim_end_matches(" as f32").trim_matches(['[', ']']);
            let Some(mut valeurs) = valeur.split(", ").map(un).collect::<Option<Vec<_>>>() else {
                continue;
            };
            valeurs.retain(compte);
            let nom = nom.split(':').next().unwrap().to_owned();
            constantes.entry(nom).or_default().push(valeurs);
        }
    }
    constantes
}

/// Checks each row of the page that has numbers against that of the code.
fn comparer(lues: &BTreeMap<String, String>, attendues: &[(&str, &str)]) {
    let constantes = constantes();
    let valeurs = |mot: &str| -> Vec<f64> {
        let de = |nom: &str| match constantes.get(nom).map(Vec::as_slice) {
            Some([valeurs]) => valeurs.clone(),
            autres => panic!("{nom} is {autres:?}"),
        };
        match (mot.strip_prefix("1/"), mot.strip_prefix("2·")) {
            (Some(nom), _) => de(nom).into_iter().map(f64::recip).collect(),
            (_, Some(nom)) => de(nom).into_iter().map(|x| 2.0 * x).collect(),
            (None, None) if mot.starts_with(|c: char| c.is_ascii_digit()) => vec![nombre(mot)],
            (None, None) => de(mot),
        }
    };
    for (rangee, attendue) in attendues {
        let lue = lues.get(*rangee).unwrap_or_else(|| panic!("no row {rangee} in {lues:#?}"));
        let attendus: Vec<f64> = attendue.split(' ').flat_map(valeurs).filter(compte).collect();
        assert_eq!(nombres(lue), attendus, "{rangee}: {lue} has not {attendue}");
    }
    for (rangee, lue) in lues {
        let connue = attendues.iter().any(|(attendue, _)| attendue == rangee);
        assert!(connue || nombres(lue).is_empty(), "{rangee}: {lue}");
    }
}

/// The rows of the tables in a text: so many cells that name them, and the rest.
fn rangees(texte: &str, cellules: usize) -> BTreeMap<String, String> {
    let lignes = texte.lines().filter(|ligne| ligne.starts_with("| "));
    let rangees = lignes.map(|ligne| {
        let ligne = ligne.replace("\\|", "¦");
        let cases: Vec<_> = ligne.trim_matches(['|', ' ']).split('|').map(str::trim).collect();
        (cases[..cellules].join(", "), cases[cellules..].join(" "))
    });
    rangees.collect()
}

#[test]
fn les_nombres_de_la_table_des_constantes_sont_ceux_du_code() {
    let page = lire("docs/precision.md");
    let mut lues = rangees(section(&page, "Constants"), 1);
    lues.extend(rangees(section(&page, "Model and letters"), 1));
    comparer(&lues, CONSTANTES);
    // Each constant that tests grant by the pages has a row.
    let tolerances = lire("tests/commun/tolerances.rs");
    let (_, modules) = tolerances.split_once("pub mod bandes").unwrap();
    let dites: BTreeSet<_> =
        [CONSTANTES, PROFONDEURS].concat().iter().flat_map(|(_, noms)| noms.split(' ')).collect();
    for nom in modules.split("pub const ").skip(1).filter_map(|suite| suite.split(':').next()) {
        assert!(dites.contains(nom) || nom == "LIGNES", "no row has {nom}");
    }
}

/// The paragraphs of a text, by their titles or their first four words, without its tables and its links.
fn paragraphes(texte: &str) -> BTreeMap<String, String> {
    let hors_table = |ligne| if str::starts_with(ligne, '|') { "" } else { ligne };
    let texte = texte.lines().map(hors_table).collect::<Vec<_>>().join("\n");
    let texte = texte.replace("\n- ", "\n\n");
    let bouts: Vec<_> = texte.split("](").collect();
    let sans_lien = |(i, bout): (usize, &&str)| {
        let bout = if i > 0 { bout.split_once(')').unwrap().1 } else { bout };
        let fin = if i + 1 < bouts.len() { bout.rfind('[').unwrap() } else { bout.len() };
        bout[..fin].to_owned()
    };
    let texte: String = bouts.iter().enumerate().map(sans_lien).collect();
    let paragraphes = texte.split("\n\n").map(|paragraphe| {
        let mots: Vec<_> = paragraphe.split_whitespace().collect();
        let en_gras = paragraphe.trim().strip_prefix("**").and_then(|p| p.split_once("**"));
        let premiers = || mots[..mots.len().min(4)].join(" ");
        (en_gras.map_or_else(premiers, |(titre, _)| titre.to_owned()), mots.join(" "))
    });
    paragraphes.collect()
}

/// What a promise says in words is no other number than that of the table.
#[test]
fn les_nombres_des_phrases_sont_ceux_du_code() {
    let page = lire("docs/precision.md");
    let sections = ["Promises", "Constants", "Exceptions", "Closed rooms"];
    let lus = sections.into_iter().flat_map(|titre| paragraphes(section(&page, titre)));
    comparer(&lus.collect(), PHRASES);
}

#[test]
fn les_nombres_de_la_table_du_lemme_22_sont_ceux_du_code() {
    let page = lire("docs/preuves/rayons.md");
    let lues = rangees(section(&page, "Lemma 22: closed rooms"), 2);
    comparer(&lues, PROFONDEURS);
}

#[test]
fn les_nombres_des_pas_sont_ceux_du_code() {
    let mut lus = BTreeMap::<String, String>::new();
    for algorithmes in algorithmes() {
        let mut pas = "";
        for ligne in algorithmes.lines() {
            let debut = ligne.get(..2).unwrap_or(ligne);
            if !ligne.starts_with(' ') {
                let est_un_pas = debut.len() == 2 && debut.as_bytes()[1].is_ascii_digit();
                pas = if est_un_pas { debut } else { ligne.split(',').next().unwrap() };
            }
            if !pas.is_empty() {
                lus.entry(pas.to_owned()).or_default().push_str(ligne.trim_start_matches(pas));
            }
        }
    }
    assert!(lus.len() > 50, "{lus:#?}");
    comparer(&lus, PAS);
}
