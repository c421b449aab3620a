//! A file of `src` imports only from floors below its own, as `DEVELOPING.md` lists them.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::dossiers::fichiers_sous;

/// The floors of the page, from the top, as paths within the crate: `objet::boite::face`.
fn etages(racine: &Path) -> Vec<String> {
    let page = fs::read_to_string(racine.join("DEVELOPING.md")).unwrap();
    let (_, section) = page.split_once("\n## The floors\n").expect("the floors");
    let section = section.split("\n## ").next().unwrap();
    let mut etages: Vec<String> = Vec::new();
    let mut ailes: Vec<&str> = Vec::new();
    for ligne in section.lines().filter(|ligne| ligne.starts_with("| ") && ligne.contains('`')) {
        let cellules: Vec<_> = ligne.split('|').map(str::trim).collect();
        let aile = cellules[1].trim_matches('`');
        let racine = !cellules[1].starts_with('`');
        // The rows of a wing stand together.
        if ailes.last() != Some(&aile) {
            assert!(racine || !ailes.contains(&aile), "{aile} stands in two places");
            ailes.push(aile);
        }
        for nom in cellules[2].split('`').skip(1).step_by(2) {
            let nom = nom.replace('/', "::");
            let seul = racine || nom == aile;
            etages.push(if seul { nom } else { format!("{aile}::{nom}") });
        }
    }
    etages
}

/// The paths that this source takes from the crate, outside of comments.
fn imports(source: &str) -> impl Iterator<Item = &str> {
    let code = source.lines().map(|ligne| ligne.split("//").next().unwrap());
    code.flat_map(|ligne| ligne.split("crate::").skip(1)).map(|suite| {
        let fin = suite.find(|c: char| !c.is_alphanumeric() && c != '_' && c != ':');
        &suite[..fin.unwrap_or(suite.len())]
    })
}

#[test]
fn aucun_fichier_n_importe_d_un_etage_plus_haut() {
    let racine = Path::new(env!("CARGO_MANIFEST_DIR"));
    let etages = etages(racine);
    let etage = |chemin: &str| etages.iter().position(|autre| autre == chemin);
    let (mut fichiers, mut montent, mut combien) = (BTreeSet::new(), Vec::new(), 0);
    for fichier in fichiers_sous("src") {
        let source = fs::read_to_string(&fichier).unwrap();
        let chemin = fichier.strip_prefix(racine.join("src")).unwrap().with_extension("");
        let chemin = chemin.to_str().unwrap().replace('/', "::");
        if chemin == "lib" {
            continue;
        }
        assert!(!source.contains("super::{") && !source.contains("use super"), "{chemin}");
        let ici = etage(&chemin).unwrap_or_else(|| panic!("{chemin} is on no floor"));
        for import in imports(&source) {
            // The longest path that is a file: what follows is an item.
            let mut de = import;
            while etage(de).is_none() {
                de = de.rsplit_once("::").unwrap_or_else(|| panic!("{chemin}: {import}")).0;
            }
            combien += 1;
            if de != chemin && etage(de).unwrap() <= ici {
                montent.push(format!("{chemin} takes {import}"));
            }
        }
        fichiers.insert(chemin);
    }
    assert!(montent.is_empty(), "{montent:#?}");
    let sur_la_page: BTreeSet<_> = etages.iter().cloned().collect();
    assert_eq!((sur_la_page.len(), sur_la_page), (etages.len(), fichiers));
    assert!(combien > 200, "{combien} imports read");
}
