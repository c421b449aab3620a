//! What the pages of `docs/preuves` name is in the code: each step of the algorithms stands, with its label, in a
//! comment of the code that takes it, and each test and each constant of the map exists. The steps of the judge are
//! defined at the head of its file, all others on the pages.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::dossiers::fichiers_sous;

/// A capital letter and a digit.
fn etiquettes(texte: &str) -> impl Iterator<Item = &str> {
    texte.split(|c: char| !c.is_alphanumeric()).filter(|mot| {
        let mut signes = mot.chars();
        let [lettre, chiffre, fin] = [(); 3].map(|()| signes.next());
        let de_lettre = lettre.is_some_and(|c| c.is_ascii_uppercase());
        de_lettre && chiffre.is_some_and(|c| c.is_ascii_digit()) && fin.is_none()
    })
}

/// The file of which the head defines steps.
const JUGE: &str = "src/question/jugement/juge.rs";

/// What stands between the first fences after this title.
fn algorithmes<'a>(texte: &'a str, titre: &str) -> Option<&'a str> {
    let (_, suite) = texte.split_once(titre)?;
    let (_, algorithmes) = suite.split_once("```text\n")?;
    Some(algorithmes.split_once("```")?.0)
}

#[test]
fn chaque_pas_des_preuves_est_une_fois_dans_le_code() {
    let algorithmes_de_la_page = |page: PathBuf| {
        let page = fs::read_to_string(page).unwrap();
        algorithmes(&page, "\n## The algorithms\n").map(str::to_owned)
    };
    let mut definis: Vec<_> =
        fichiers_sous("docs/preuves").into_iter().filter_map(algorithmes_de_la_page).collect();
    assert_eq!(definis.len(), 3);
    let juge = Path::new(env!("CARGO_MANIFEST_DIR")).join(JUGE);
    let texte_du_juge = fs::read_to_string(&juge).unwrap();
    let tete = algorithmes(&texte_du_juge, "//! The judge").expect("steps at the head");
    assert!(tete.lines().all(|ligne| ligne.starts_with("//!")), "{tete}");
    definis.push(tete.replace("//! ", ""));
    // A step begins a line, and is defined once.
    let mut pas = BTreeMap::new();
    for ligne in definis.iter().flat_map(|algorithmes| algorithmes.lines()) {
        let etiquette = etiquettes(ligne).next().filter(|pas| ligne.starts_with(pas));
        let Some(etiquette) = etiquette else { continue };
        let ancien = pas.insert(etiquette.to_owned(), Vec::new());
        assert!(ancien.is_none(), "{etiquette} is defined twice");
    }
    assert!(pas.len() > 50, "only {} steps", pas.len());
    for chemin in fichiers_sous("src") {
        let texte = fs::read_to_string(&chemin).unwrap();
        // What defines a step does not take it.
        let vides = "\n".repeat(tete.matches('\n').count());
        let code = if chemin == juge { texte.replacen(tete, &vides, 1) } else { texte };
        for (numero, ligne) in code.lines().enumerate() {
            let Some((_, commentaire)) = ligne.split_once("//") else { continue };
            for etiquette in etiquettes(commentaire) {
                if let Some(lieux) = pas.get_mut(etiquette) {
                    lieux.push(format!("{}:{}", chemin.display(), numero + 1));
                }
            }
        }
    }
    for (pas, lieux) in pas {
        assert!(lieux.len() == 1, "{pas} stands in {} places: {lieux:?}", lieux.len());
    }
}

#[test]
fn la_carte_des_lemmes_nomme_ce_qui_existe() {
    let racine = Path::new(env!("CARGO_MANIFEST_DIR"));
    let lire = |chemin: PathBuf| fs::read_to_string(chemin).unwrap();
    let sources: String = fichiers_sous("src")
        .into_iter()
        .chain([racine.join("tests/commun/tolerances.rs")])
        .map(lire)
        .collect();
    let page = lire(racine.join("docs/preuves/modele.md"));
    let lignes = page.lines().filter(|ligne| ligne.starts_with("| ") && ligne.contains("#lemma-"));
    let mut lemmes = 0;
    for ligne in lignes {
        let cellules: Vec<_> = ligne.trim_matches('|').split('|').collect();
        let [lemme, tests, constantes] = cellules[..] else { panic!("{ligne}") };
        let noms = |cellule| str::split(cellule, '`').skip(1).step_by(2);
        for test in noms(tests) {
            let (fichier, fonction) = test.split_once("::").unwrap_or(("constantes.rs", test));
            let dossier = if fichier.contains('/') { "tests" } else { "tests/precision" };
            let texte = lire(racine.join(dossier).join(fichier));
            let declaree = ['(', '<'].iter().any(|c| texte.contains(&format!("fn {fonction}{c}")));
            assert!(declaree, "{lemme}: no {fonction} in {fichier}");
        }
        for constante in noms(constantes) {
            assert!(sources.contains(&format!("const {constante}:")), "{lemme}: no {constante}");
        }
        lemmes += 1;
    }
    assert_eq!(lemmes, 22);
}
