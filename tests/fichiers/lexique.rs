//! `docs/lexique.md` has every public name and every English word by which `cargo doc` finds it.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// What each page of the sources is about, in the order of the lexicon.
const PARTIES: [(&str, &[&str]); 8] = [
    ("Scalars and vectors", &["reel", "vecteur"]),
    ("Rotations", &["rotation"]),
    ("Objects", &["objet", "sphere", "plan", "boite", "face", "texture"]),
    ("Rays", &["rayon"]),
    ("Hits, and the rays that start there", &["intersection", "secondaire"]),
    ("One ray and a list", &["recherche", "jugement"]),
    ("Many rays, many objects", &["lot", "hierarchie"]),
    ("Errors", &["refus"]),
];

fn racine() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The public names of a source, each with its aliases, in their order.
fn noms(source: &str) -> Vec<(String, Vec<String>)> {
    let mut noms: Vec<(String, Vec<String>)> = Vec::new();
    let mut alias = Vec::new();
    let mut cache = false;
    for ligne in source.lines().map(str::trim) {
        if ligne.starts_with("#[doc(alias") {
            // Every other piece stands between quotes.
            alias.extend(ligne.split('"').skip(1).step_by(2).map(str::to_owned));
        } else if ligne == "#[doc(hidden)]" {
            cache = true;
        } else if ligne.starts_with("#[") || ligne.starts_with("//") || ligne.is_empty() {
        } else {
            let nom = nom_public(ligne).or_else(|| nom_de_trait_ou_de_variante(ligne, &alias));
            if let Some(nom) = nom.filter(|_| !cache) {
                match noms.iter_mut().find(|(autre, _)| *autre == nom) {
                    Some((_, mots)) => mots.append(&mut alias),
                    None => noms.push((nom, std::mem::take(&mut alias))),
                }
            }
            alias.clear();
            cache = false;
        }
    }
    noms
}

fn nom_public(ligne: &str) -> Option<String> {
    let suite = ligne.strip_prefix("pub ")?;
    let mots = ["const fn ", "fn ", "struct ", "enum ", "trait ", "type ", "const ", ""];
    let suite = mots.iter().find_map(|mot| suite.strip_prefix(mot))?;
    let nom = premier_mot(suite);
    (nom != "mod" && nom != "use" && !nom.is_empty()).then(|| nom.to_owned())
}

/// What stands in a public trait or enum has no `pub`; with an alias it is public.
fn nom_de_trait_ou_de_variante(ligne: &str, alias: &[String]) -> Option<String> {
    let suite = ["fn ", "const "].iter().find_map(|mot| ligne.strip_prefix(mot)).unwrap_or(ligne);
    let nom = premier_mot(suite);
    (!alias.is_empty() && !nom.is_empty()).then(|| nom.to_owned())
}

fn premier_mot(texte: &str) -> &str {
    texte.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or_default()
}

#[test]
fn le_lexique_est_a_jour() {
    let mut page = String::from(
        "# Names\n\nThe names are the handout's, in French and in ASCII. `cargo doc` finds each by these English words as \
         well.\nWritten by `tests/fichiers/lexique.rs`, which also checks that it holds each name that has one:\n\n\
         ```sh\nLANCER_RAYON_ECRIRE=1 cargo test --all-features --test fichiers lexique\n```\n",
    );
    for (titre, fichiers) in PARTIES {
        page += &format!("\n## {titre}\n\n| here | in English |\n|---|---|\n");
        let mut vus = BTreeMap::new();
        let mut ordre = Vec::new();
        for fichier in fichiers {
            let source = fs::read_to_string(racine().join(format!("src/{fichier}.rs"))).unwrap();
            for (nom, mots) in noms(&source) {
                let tous: &mut Vec<String> = vus.entry(nom.clone()).or_default();
                if !ordre.contains(&nom) {
                    ordre.push(nom);
                }
                for mot in mots {
                    if !tous.contains(&mot) {
                        tous.push(mot);
                    }
                }
            }
        }
        // A name without a word of its own, as `direction`, is English already.
        for nom in ordre.into_iter().filter(|nom| !vus[nom].is_empty()) {
            page += &format!("| `{nom}` | {} |\n", vus[&nom].join(", ").replace('_', " "));
        }
    }
    let chemin: PathBuf = racine().join("docs/lexique.md");
    if std::env::var_os("LANCER_RAYON_ECRIRE").is_some() {
        fs::write(&chemin, &page).unwrap();
    }
    let ecrite = fs::read_to_string(&chemin).unwrap_or_default();
    let autre = ecrite.lines().zip(page.lines()).find(|(ecrite, ligne)| ecrite != ligne);
    assert!(ecrite == page, "docs/lexique.md is stale, write it again: {autre:?}");
}
