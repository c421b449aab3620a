//! The files of the repository that tests read.

use std::fs;
use std::path::{Path, PathBuf};

/// Every file in this folder of the repository and in the folders below it.
pub(crate) fn fichiers_sous(dossier: &str) -> Vec<PathBuf> {
    let mut fichiers = Vec::new();
    let mut dossiers = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join(dossier)];
    while let Some(dossier) = dossiers.pop() {
        for entree in fs::read_dir(dossier).unwrap() {
            let chemin = entree.unwrap().path();
            if chemin.is_dir() { dossiers.push(chemin) } else { fichiers.push(chemin) }
        }
    }
    fichiers
}

/// The pages of the repository: those of the root, of `docs` and `benches`, and the test set.
pub(crate) fn pages() -> impl Iterator<Item = PathBuf> {
    let racine = fs::read_dir(env!("CARGO_MANIFEST_DIR")).unwrap();
    let autour = racine.map(|entree| entree.unwrap().path());
    let sous = ["docs", "benches", "tests/enonce"].into_iter().flat_map(fichiers_sous);
    autour.chain(sous).filter(|page| page.extension() == Some("md".as_ref()))
}

/// The part of the page below this heading.
pub(crate) fn section<'a>(page: &'a str, titre: &str) -> &'a str {
    let (_, section) = page.split_once(&format!("\n## {titre}\n")).expect(titre);
    section.split("\n## ").next().unwrap()
}
