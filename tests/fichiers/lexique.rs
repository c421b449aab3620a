//! `cargo doc` finds every public name by English words, and those of `docs/conventions.md` are among them.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::dossiers::fichiers_sous;

/// Public names that are the same word in both languages.
const MEMES: [&str; 6] = ["Rotation", "ZERO", "direction", "x", "y", "z"];

/// The names of the page.
const SUR_LA_PAGE: usize = 38;

/// Each public name, with its English words.
type Lexique = BTreeMap<String, Vec<String>>;

fn mots(texte: &str) -> Vec<&str> {
    let mots = texte.split(|c: char| !c.is_alphanumeric() && c != '_');
    mots.filter(|mot| !mot.is_empty()).collect()
}

/// Adds what this source of exported items has of public names: these, what has `pub` in it, and what stands in a public
/// trait, or in a public enum with an alias. (`pub` within the crate is `pub(crate)`, as `unreachable_pub` wants it.)
fn noter(source: &str, exportes: &[&str], lexique: &mut Lexique) {
    // An item begins a line, after its attributes and comments.
    let (mut attributs, mut autour) = (String::new(), "");
    for ligne in source.lines() {
        let nue = ligne.trim_start();
        if nue.starts_with("#[") || nue.starts_with("//") {
            attributs += nue;
            continue;
        }
        // An empty line, or the end of an item or of its head.
        if nue.is_empty() || ligne.starts_with(['}', '{', ')', 'w']) {
            continue;
        }
        let (retrait, attributs) = (ligne.len() - nue.len(), std::mem::take(&mut attributs));
        // Every other piece stands between quotes.
        let alias =
            attributs.split("#[doc(alias").skip(1).filter_map(|suite| suite.split(']').next());
        let alias = alias.flat_map(|alias| alias.split('"').skip(1).step_by(2));
        let alias: Vec<_> = alias.map(|mot| mot.replace('_', " ")).collect();
        let publique = nue.strip_prefix("pub ");
        let mots = mots(publique.unwrap_or(nue).trim_start_matches("const fn "));
        let sortes = ["fn", "struct", "enum", "trait", "type", "const"];
        let sorte = sortes.into_iter().find(|sorte| mots.first() == Some(sorte));
        let nom = mots.get(usize::from(sorte.is_some())).copied().unwrap_or_default();
        let est_publique = if retrait == 0 {
            // The type of an `impl<R: Reel> Rayon<R> {`, but of no trait.
            let de = nue.strip_prefix("impl").filter(|_| !nue.contains(" for "));
            let de = de.map(|suite| self::mots(suite.split_once("> ").map_or(suite, |(_, de)| de)));
            let exporte = publique.is_some() && exportes.contains(&nom);
            autour = sorte.filter(|_| exporte).unwrap_or_default();
            if de.is_some_and(|de| de.first().is_some_and(|de| exportes.contains(de))) {
                autour = "impl";
            }
            exporte
        } else {
            let dedans = match autour {
                "trait" => sorte.is_some(),
                "enum" => !alias.is_empty(),
                _ => publique.is_some() && !autour.is_empty(),
            };
            retrait == 4 && dedans
        };
        if est_publique && !attributs.contains("#[doc(hidden)]") {
            lexique.entry(nom.to_owned()).or_default().extend(alias);
        }
    }
}

fn lexique(racine: &Path) -> Lexique {
    let lib = fs::read_to_string(racine.join("src/lib.rs")).unwrap();
    let exportes = lib.split("\npub use ").skip(1).filter_map(|suite| suite.split(';').next());
    let exportes = exportes.filter_map(|chemin| chemin.rsplit_once("::"));
    let exportes: Vec<_> = exportes.flat_map(|(_, noms)| mots(noms)).collect();
    let mut lexique = Lexique::new();
    for chemin in fichiers_sous("src") {
        noter(&fs::read_to_string(&chemin).unwrap(), &exportes, &mut lexique);
    }
    for nom in &exportes {
        assert!(lexique.contains_key(*nom), "nowhere: {nom}");
    }
    lexique
}

#[test]
fn chaque_nom_public_a_un_mot_anglais() {
    let lexique = lexique(Path::new(env!("CARGO_MANIFEST_DIR")));
    let sans: Vec<_> =
        lexique.iter().filter(|(_, mots)| mots.is_empty()).map(|(nom, _)| nom).collect();
    assert_eq!(sans, MEMES, "names without an alias, and those that need none");
}

/// Each name of the section is followed by one of its words.
#[test]
fn les_noms_de_la_page_ont_les_mots_de_la_documentation() {
    let racine = Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = fs::read_to_string(racine.join("docs/conventions.md")).unwrap();
    let (_, section) = page.split_once("\n## Names\n").expect("the names");
    let section = section.split("\n## ").next().unwrap();
    let lexique = lexique(racine);
    let mut combien = 0;
    for ligne in section.lines().filter(|ligne| ligne.contains("| `")) {
        // Names stand between backquotes, words between them.
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
