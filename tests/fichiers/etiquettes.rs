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

/// The algorithms of the pages and, without the signs of a comment, of the judge: what stands between the first fences
/// after their titles.
pub(crate) fn algorithmes() -> Vec<String> {
    let racine = Path::new(env!("CARGO_MANIFEST_DIR"));
    let des_pages =
        fichiers_sous("docs/preuves").into_iter().map(|page| (page, "\n## The algorithms\n"));
    let algorithmes =
        des_pages.chain([(racine.join(JUGE), "//! The judge")]).filter_map(|(page, titre)| {
            let texte = fs::read_to_string(page).unwrap();
            let (_, suite) = texte.split_once(titre)?.1.split_once("```text\n")?;
            Some(suite.split_once("```")?.0.replace("//! ", ""))
        });
    let algorithmes: Vec<_> = algorithmes.collect();
    assert_eq!(algorithmes.len(), 4);
    algorithmes
}

#[test]
fn chaque_pas_des_preuves_est_une_fois_dans_le_code() {
    let definis = algorithmes();
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
        // What defines a step does not take it.
        let definit = |ligne: &str| chemin.ends_with(JUGE) && ligne.starts_with("//!");
        let texte = fs::read_to_string(&chemin).unwrap();
        for (numero, ligne) in texte.lines().enumerate().filter(|(_, ligne)| !definit(ligne)) {
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
