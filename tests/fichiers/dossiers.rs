//! The files of the repository that tests read.

use std::fs;
use std::path::{Path, PathBuf};

/// Every file in this folder of the repository and in those below.
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
