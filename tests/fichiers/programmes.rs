//! The programs that the pages show are those that tests run: each block of Rust stands, line for line, in the file
//! that the page named last before it.

use std::fs;
use std::path::Path;

use crate::dossiers::pages;

/// The lines of this text, whatever their indentation.
fn lignes(texte: &str) -> String {
    texte.lines().map(|ligne| format!("\n{}", ligne.trim())).collect()
}

#[test]
fn chaque_programme_d_une_page_est_dans_son_fichier() {
    let racine = Path::new(env!("CARGO_MANIFEST_DIR"));
    for page in pages().filter(|page| page.starts_with(racine.join("docs"))) {
        let texte = fs::read_to_string(&page).unwrap();
        let (mut nom, mut reste) = ("", &*texte);
        while let Some((prose, suite)) = reste.split_once("\n```") {
            let (bloc, apres) = suite.split_once("\n```").expect("the end of a block");
            // A link counts from its page, a name in backquotes from the root.
            let mut mots = prose.rsplit(|c: char| c.is_whitespace() || "`()".contains(c));
            nom = mots.find(|mot| mot.ends_with(".rs")).unwrap_or(nom);
            if let Some(programme) = bloc.strip_prefix("rust\n") {
                let lien = page.with_file_name(nom);
                let fichier = if lien.exists() { lien } else { racine.join(nom) };
                let contenu = fs::read_to_string(fichier).unwrap_or_default();
                let est_la = lignes(&contenu).contains(&lignes(programme));
                assert!(est_la, "{}: {nom} has not\n{programme}", page.display());
            }
            reste = apres;
        }
    }
}
