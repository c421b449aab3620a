//! `cargo doc` finds public names by English words, and those of `docs/conventions.md` are among them.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use crate::dossiers::fichiers_sous;

/// Public names that are the same word in both languages.
const MEMES: [&str; 5] = ["Rotation", "direction", "x", "y", "z"];

/// Files of items that are public for tests alone.
const POUR_LES_TESTS: [&str; 3] = ["double.rs", "jugement.rs", "pour_les_tests.rs"];

/// How many names the page has.
const SUR_LA_PAGE: usize = 56;

fn mots(texte: &str) -> Vec<&str> {
    let mots = texte.split(|c: char| !c.is_alphanumeric() && c != '_');
    mots.filter(|mot| !mot.is_empty()).collect()
}

/// What a line declares.
fn declare(ligne: &str) -> Option<&str> {
    let sortes = ["pub", "const", "fn", "struct", "enum", "trait", "type"];
    mots(ligne).into_iter().find(|mot| !sortes.contains(mot))
}

/// Each name of `src` that has English words, and these words.
fn lexique() -> BTreeMap<String, Vec<String>> {
    let mut lexique = BTreeMap::<_, Vec<_>>::new();
    for fichier in fichiers_sous("src") {
        let mut alias = Vec::new();
        for ligne in fs::read_to_string(fichier).unwrap().lines().map(str::trim_start) {
            if let Some(suite) = ligne.strip_prefix("#[doc(alias") {
                // Words stand between quotes: every other piece.
                alias.extend(suite.split('"').skip(1).step_by(2).map(|mot| mot.replace('_', " ")));
            } else if !ligne.starts_with(['#', '/']) {
                let nom = declare(ligne).unwrap_or_default();
                lexique.entry(nom.to_owned()).or_default().append(&mut alias);
            }
        }
    }
    lexique.retain(|_, mots| !mots.is_empty());
    lexique
}

/// What `lib.rs` exports has a word, and what is `pub` within an item. What is `pub` only within the crate is written
/// `pub(crate)`, as `unreachable_pub` wants it.
#[test]
fn chaque_nom_public_a_un_mot_anglais() {
    let lib = fs::read_to_string("src/lib.rs").unwrap();
    let exportes = lib.split("\npub use ").skip(1).filter_map(|suite| suite.split(';').next());
    let exportes = exportes.filter_map(|chemin| chemin.rsplit_once("::"));
    let mut publics: BTreeSet<_> =
        exportes.flat_map(|(_, noms)| mots(noms)).map(str::to_owned).collect();
    let publies =
        |fichier: &std::path::PathBuf| !POUR_LES_TESTS.iter().any(|nom| fichier.ends_with(nom));
    for fichier in fichiers_sous("src").into_iter().filter(publies) {
        let source = fs::read_to_string(fichier).unwrap();
        let dedans = source.lines().filter(|ligne| ligne.starts_with("    pub "));
        publics.extend(dedans.filter_map(declare).map(str::to_owned));
    }
    assert!(publics.len() > 100, "{publics:?}");
    let lexique = lexique();
    let sans: Vec<_> = publics.iter().filter(|nom| !lexique.contains_key(*nom)).collect();
    assert_eq!(sans, MEMES, "names without an alias, and those that need none");
}

/// Each word that follows a name in the section is one of that name's words.
#[test]
fn les_noms_de_la_page_ont_les_mots_de_la_documentation() {
    let racine = Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = fs::read_to_string(racine.join("docs/conventions.md")).unwrap();
    let (_, section) = page.split_once("\n## Names\n").expect("the names");
    let section = section.split("\n## ").next().unwrap();
    let lexique = lexique();
    let mut combien = 0;
    for ligne in section.lines().filter(|ligne| ligne.contains("| `")) {
        // Names stand between backquotes, and words between names.
        let (noms, mots) =
            (ligne.split('`').skip(1).step_by(2), ligne.split('`').skip(2).step_by(2));
        for (nom, mot) in noms.zip(mots) {
            let mot = mot.trim_end_matches(['|', ' ']).trim_matches([',', ' ']);
            let permis = lexique.get(nom).unwrap_or_else(|| panic!("{nom} is not public"));
            // No alias has a hyphen, which the search of rustdoc refuses.
            let mot = mot.replace('-', " ");
            assert!(permis.contains(&mot), "{nom}: {mot} is none of {permis:?}");
            combien += 1;
        }
    }
    assert_eq!(combien, SUR_LA_PAGE);
}
