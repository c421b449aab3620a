//! `cargo doc` finds every public name by English words, and those of `docs/conventions.md` are among them.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::dossiers::fichiers_sous;

/// Public names that are the same word in both languages.
const MEMES: [&str; 8] = ["Rotation", "ZERO", "abs", "direction", "sqrt", "x", "y", "z"];

/// The names of the page.
const SUR_LA_PAGE: usize = 32;

/// Each public name, with its English words.
type Lexique = BTreeMap<String, Vec<String>>;

/// The types and functions that `src/lib.rs` makes public.
fn exportes(racine: &Path) -> Vec<String> {
    let lib = fs::read_to_string(racine.join("src/lib.rs")).unwrap();
    let lignes = lib.lines().filter_map(|ligne| ligne.strip_prefix("pub use "));
    let noms = lignes.filter_map(|ligne| ligne.rsplit_once("::"));
    noms.flat_map(|(_, noms)| mots(noms).map(str::to_owned).collect::<Vec<_>>()).collect()
}

fn mots(texte: &str) -> impl Iterator<Item = &str> {
    texte.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|mot| !mot.is_empty())
}

/// Adds what this source has of public names: the exported items, and what stands in them with `pub`, in a
/// trait without, in an enum if it has an alias: the faces of a box are found by their enum.
fn noter(source: &str, exportes: &[String], lexique: &mut Lexique) {
    let mut alias: Vec<String> = Vec::new();
    // The item around a line, if it is exported: its first word.
    let mut autour = None;
    let mut cachee = false;
    for ligne in source.lines() {
        let nue = ligne.trim_start();
        if nue.starts_with("#[doc(alias") {
            // Every other piece stands between quotes.
            alias.extend(nue.split('"').skip(1).step_by(2).map(|mot| mot.replace('_', " ")));
            continue;
        } else if nue.starts_with("#[doc(hidden)]") {
            cachee = true;
            continue;
        } else if nue.starts_with("#[") || nue.starts_with("//") || nue.is_empty() {
            continue;
        }
        let dehors = nue.len() == ligne.len();
        let publique = nue.strip_prefix("pub ");
        let suite = publique.unwrap_or(nue);
        let suite = suite.strip_prefix("const ").filter(|s| s.starts_with("fn ")).unwrap_or(suite);
        let sorte = mots(suite).next().unwrap_or_default();
        let declare = ["fn", "struct", "enum", "trait", "type", "const"].contains(&sorte);
        let nom = if declare { mots(suite).nth(1) } else { mots(suite).next() };
        let nom = nom.unwrap_or_default();
        let exporte = |nom: &str| exportes.iter().any(|autre| autre == nom);
        let est_publique = if dehors {
            if sorte == "impl" {
                // After the parameters, as in `impl<R: Reel> Rayon<R> {`.
                let parametres = nue.strip_prefix("impl<").and_then(|suite| suite.split_once("> "));
                let type_seul = parametres.map_or(&nue[sorte.len()..], |(_, suite)| suite);
                let de = mots(type_seul).next().unwrap_or_default();
                autour = (exporte(de) && !nue.contains(" for ")).then_some("impl");
            } else if nue != "}" && !nue.starts_with(['{', ')', 'w']) {
                autour = (publique.is_some() && exporte(nom)).then_some(sorte);
            }
            publique.is_some() && declare && exporte(nom)
        } else {
            ligne.starts_with("    ")
                && !ligne.starts_with("     ")
                && match autour {
                    Some("trait") => declare,
                    Some("enum") => !alias.is_empty(),
                    _ => autour.is_some() && publique.is_some(),
                }
        };
        if est_publique && !cachee {
            lexique.entry(nom.to_owned()).or_default().append(&mut alias);
        }
        alias.clear();
        cachee = false;
    }
}

fn lexique(racine: &Path) -> Lexique {
    let exportes = exportes(racine);
    let mut lexique = Lexique::new();
    for chemin in fichiers_sous("src") {
        noter(&fs::read_to_string(&chemin).unwrap(), &exportes, &mut lexique);
    }
    for nom in &exportes {
        assert!(lexique.contains_key(nom), "nowhere: {nom}");
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
            assert!(permis.iter().any(|autre| autre == mot), "{nom}: {mot} is none of {permis:?}");
            combien += 1;
        }
    }
    assert_eq!(combien, SUR_LA_PAGE);
}
