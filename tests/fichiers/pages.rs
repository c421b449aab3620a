//! The pages lead to each other, and say the same.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::dossiers::{fichiers_sous, pages};

/// A heading as a link names it: small letters, hyphens for spaces, and no other signs.
fn ancre(titre: &str) -> String {
    let signes = titre.trim_start_matches('#').trim().chars();
    let signes = signes.filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    signes.flat_map(char::to_lowercase).map(|c| if c == ' ' { '-' } else { c }).collect()
}

#[test]
fn chaque_lien_mene_a_un_fichier_et_a_un_titre() {
    let mut ancres = 0;
    for page in pages() {
        let texte = fs::read_to_string(&page).unwrap();
        for lien in texte.split("](").skip(1).filter_map(|suite| suite.split(')').next()) {
            if lien.contains("://") {
                continue;
            }
            let (fichier, titre) = lien.split_once('#').unwrap_or((lien, ""));
            let vers = if fichier.is_empty() { page.clone() } else { page.with_file_name(fichier) };
            assert!(vers.exists(), "{}: {lien}", page.display());
            if !titre.is_empty() {
                let vers = fs::read_to_string(vers).unwrap();
                let mut titres = vers.lines().filter(|ligne| ligne.starts_with('#')).map(ancre);
                assert!(titres.any(|autre| autre == titre), "{}: {lien}", page.display());
                ancres += 1;
            }
        }
    }
    assert!(ancres > 50, "only {ancres}");
}

/// The cells of each line of a table, without what stands in brackets.
fn lignes_de_tables(page: &str) -> Vec<Vec<String>> {
    let racine = Path::new(env!("CARGO_MANIFEST_DIR"));
    let texte = fs::read_to_string(racine.join(page)).unwrap();
    let lignes = texte.lines().filter(|ligne| ligne.starts_with("| ") && ligne.contains(" of "));
    let cellule = |cellule: &str| cellule.split(" (").next().unwrap().trim().to_owned();
    lignes.map(|ligne| ligne.trim_matches('|').split('|').map(cellule).collect()).collect()
}

/// The ratios in README.md are those of the page of measurements for `f32`.
#[test]
fn les_rapports_de_l_entree_sont_ceux_des_mesures() {
    let mesures = lignes_de_tables("docs/vitesse.md");
    let entree = lignes_de_tables("README.md");
    assert_eq!(entree.len(), 3);
    for mut ligne in entree {
        ligne.insert(1, "f32".to_owned());
        assert!(mesures.contains(&ligne), "{ligne:?} is none of {mesures:#?}");
    }
}

/// The functions through which DEVELOPING.md follows a question are in the sources, and so are the files.
#[test]
fn le_chemin_d_une_question_est_celui_des_sources() {
    let racine = Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = fs::read_to_string(racine.join("DEVELOPING.md")).unwrap();
    let (_, section) = page.split_once("\n## How a question is answered\n").expect("the way");
    let sources =
        fichiers_sous("src").into_iter().map(|fichier| fs::read_to_string(fichier).unwrap());
    let sources: String = sources.collect();
    let mots: BTreeSet<_> = sources.split(|c: char| !c.is_alphanumeric() && c != '_').collect();
    let table = section.split("\n## ").next().unwrap().lines().filter(|l| l.starts_with('|'));
    let noms: Vec<_> = table.flat_map(|ligne| ligne.split('`').skip(1).step_by(2)).collect();
    for nom in &noms {
        let existe = match nom.strip_suffix(".rs") {
            Some(_) => racine.join("src").join(nom).exists(),
            None => nom.split("::").all(|mot| mots.contains(mot)),
        };
        assert!(existe, "{nom}");
    }
    assert!(noms.len() > 30, "only {}", noms.len());
}
