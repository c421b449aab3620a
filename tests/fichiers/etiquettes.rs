//! Each step of the algorithms of `docs/preuves.md` and `docs/preuves-arbre.md` stands, by its label, in a comment of the code that takes it.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::dossiers::fichiers_sous;

/// A capital letter and a digit.
fn etiquettes(texte: &str) -> impl Iterator<Item = &str> {
    texte.split(|c: char| !c.is_alphanumeric()).filter(|mot| {
        let mut signes = mot.chars();
        let [lettre, chiffre, fin] = [(); 3].map(|()| signes.next());
        let de_lettre = lettre.is_some_and(|c| c.is_ascii_uppercase());
        de_lettre && chiffre.is_some_and(|c| c.is_ascii_digit()) && fin.is_none()
    })
}

#[test]
fn chaque_pas_des_preuves_est_une_fois_dans_le_code() {
    let racine = Path::new(env!("CARGO_MANIFEST_DIR"));
    let pages = ["docs/preuves.md", "docs/preuves-arbre.md"].map(|page| {
        let page = fs::read_to_string(racine.join(page)).unwrap();
        let (_, algorithmes) = page.split_once("\n## The algorithms\n").unwrap();
        let (_, algorithmes) = algorithmes.split_once("```text\n").unwrap();
        algorithmes.split_once("```").unwrap().0.to_owned()
    });
    // A step begins a line.
    let mut pas: BTreeMap<_, _> = pages
        .iter()
        .flat_map(|algorithmes| algorithmes.lines())
        .filter_map(|ligne| etiquettes(ligne).next().filter(|pas| ligne.starts_with(pas)))
        .map(|pas| (pas.to_owned(), Vec::new()))
        .collect();
    assert!(pas.len() > 40, "only {} steps", pas.len());
    for chemin in fichiers_sous("src") {
        for (numero, ligne) in fs::read_to_string(&chemin).unwrap().lines().enumerate() {
            let Some((_, commentaire)) = ligne.split_once("//") else { continue };
            for etiquette in etiquettes(commentaire) {
                if let Some(lieux) = pas.get_mut(etiquette) {
                    lieux.push(format!("{}:{}", chemin.display(), numero + 1));
                }
            }
        }
    }
    for (pas, lieux) in pas {
        assert!(lieux.len() == 1, "{pas} stands in {} places: {lieux:?}", lieux.len());
    }
}
