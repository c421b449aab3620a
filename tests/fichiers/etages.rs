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
        // The rows of a wing are adjacent.
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

/// The paths after `avant` in this source, outside of comments; each name of a list in braces counts by itself.
fn chemins(source: &str, avant: &str) -> Vec<String> {
    let code: String = source.lines().map(|ligne| ligne.split("//").next().unwrap()).collect();
    let mut chemins = Vec::new();
    for suite in code.split(avant).skip(1) {
        let fin = |c: char| !c.is_alphanumeric() && c != '_' && c != ':';
        let (debut, reste) = suite.split_at(suite.find(fin).unwrap_or(suite.len()));
        match reste.strip_prefix('{').and_then(|reste| reste.split_once('}')) {
            Some((noms, _)) => {
                let noms = noms.split(',').map(str::trim).filter(|nom| !nom.is_empty());
                chemins.extend(noms.map(|nom| format!("{debut}{nom}")));
            }
            None => chemins.push(debut.into()),
        }
    }
    chemins
}

#[test]
fn aucun_fichier_n_importe_d_un_etage_plus_haut() {
    let racine = Path::new(env!("CARGO_MANIFEST_DIR"));
    let etages = etages(racine);
    let etage = |chemin: &str| etages.iter().position(|autre| autre == chemin);
    let (mut fichiers, mut montent, mut combien) = (BTreeSet::new(), Vec::new(), 0);
    // What users of the crate find at its root is taken from there.
    let publics = chemins(&fs::read_to_string(racine.join("src/lib.rs")).unwrap(), "pub use ");
    let complet = |import: String| {
        let fin = format!("::{import}");
        publics.iter().find(|public| public.ends_with(&fin)).cloned().unwrap_or(import)
    };
    for fichier in fichiers_sous("src") {
        let source = fs::read_to_string(&fichier).unwrap();
        let chemin = fichier.strip_prefix(racine.join("src")).unwrap().with_extension("");
        let chemin = chemin.to_str().unwrap().replace('/', "::");
        if chemin == "lib" {
            continue;
        }
        assert!(!source.contains("super::{") && !source.contains("use super"), "{chemin}");
        let ici = etage(&chemin).unwrap_or_else(|| panic!("{chemin} is on no floor"));
        // A macro takes a type that it is given, as in `crate::$type`.
        let imports = chemins(&source, "crate::").into_iter().filter(|import| !import.is_empty());
        for import in imports.map(complet) {
            // The longest path that is a file; what follows it is an item.
            let mut de = import.as_str();
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
