//! The figures of the promises stand in several places, with one value.
//!
//! Each row is a number and the phrases that say it, `{}` in its place. A phrase may stand anywhere in
//! the pages, the changes since 0.2.0 or the documentation of the sources, and has that number
//! there. A promise that changes takes the phrases of older changes out of its row.

use std::fs;
use std::path::Path;

use commun::tolerances::{ORTHONORMALE, bandes, promesses};
use lancer_rayon::pour_les_tests::*;

use crate::dossiers::fichiers_sous;

/// Secondary rays of the long run, in millions (`docs/precision.md`).
const SECONDAIRES: f64 = 963.0;

#[test]
fn un_chiffre_d_une_promesse_a_une_valeur() {
    let rangees: &[(f64, &[&str])] = &[
        (promesses::DISTANCE_SPHERE, &["K = {} for a sphere", "K ≤ {}, and"]),
        (promesses::DISTANCE_PERDUE, &["{} where r < 64u|f|"]),
        (promesses::SORTIE_SPHERE, &["K of a sphere {}, however", "K is {} for a sphere, however"]),
        (promesses::DISTANCE_PLAN, &["{} for a half-space, 5"]),
        (promesses::PLAN_ABSOLU, &["for a half-space {}η/(v"]),
        (promesses::DISTANCE_BOITE, &["{} for a box; for"]),
        (promesses::PERDUE, &["r < {}u|f|", "r ≥ {}u|f|", "never with one of {}u·|f| + a"]),
        (1.0 / ARRONDI_PERDU, &["u|f| + {}u⟨P, 1⟩", "if r < {}u⟨P, 1⟩", "below a = {}u·(|x|"]),
        (bandes::SPHERE, &["is within {}u(|f| + r) of r", "The band is {}u,"]),
        (bandes::PLAN, &["|N·S + d| ≤ {}u⟨N, S⟩"]),
        (bandes::PLAN_ABSOLUE, &["u⟨N, S⟩ + {}η"]),
        (bandes::BOITE_LONGUEUR, &["at most {}u(|f| + ρ)", "λ = {}u(|f| + ρ)"]),
        (bandes::VITESSE, &["or v ≤ {}u", "|Δv| ≤ {}u"]),
        (promesses::UNITAIRE_SPHERE, &["1| ≤ {}u for a sphere"]),
        (promesses::UNITAIRE_PLATE, &["{}u for a flat face"]),
        (promesses::DIRECTION, &["of sine at most {}u(1 +"]),
        (promesses::LIEU_SPHERE, &["a sphere by at most {}u(|f| + r)", "is below {}u(|f| + r)"]),
        (promesses::LIEU_F, &["by more than {}u|f| +"]),
        (promesses::LIEU_FACE, &["to {}u(|f| + t)/l", "to {}u(|S − C| + t)"]),
        (DEJA_UNITAIRE, &["|D·D − 1| ≤ {}u"]),
        (DEJA_ORTHONORMALE, &["columns are orthonormal to {}u", "is orthonormal to {}u"]),
        (
            ORTHONORMALE,
            &[
                "stays within {}u after any number of compositions",
                "≤ {}u an element after any number of compositions",
            ],
        ),
        (TANGENT, &["within {}u of the tangent plane", "if N·L ≤ {}u"]),
        (REDRESSE, &["turned outward by {}u", "D′ + N·{}u"]),
        (PAS_ARRONDI, &["{}u·Σ|N_i·P_i|", "⟨N, P⟩·{}u)"]),
        (PENCHE, &["N′ − D₁·{}u"]),
        (3.6, &["relative error of the distance {}u", "to the light the distance is good to {}u"]),
        (4.6, &["|ΔL| ≤ {}u", "the direction to {}u, and N·L"]),
        (8.0, &["|ΔN·L| ≤ {}u", "and N·L to {}u"]),
        (
            SECONDAIRES,
            &["none of {} million", "of {} million such rays", "makes {} million secondary"],
        ),
    ];
    let textes = textes();
    for (valeur, phrases) in rangees {
        for phrase in *phrases {
            let trouves: Vec<_> = textes.iter().flat_map(|t| trouver(t, phrase)).collect();
            assert!(!trouves.is_empty(), "nowhere: {phrase}");
            for (ou, nombre) in trouves {
                assert!(nombre == valeur.to_string(), "{ou}: {phrase} has {nombre}, not {valeur}");
            }
        }
    }
}

/// The numbers in the place of `{}`, and where.
fn trouver<'a>((ou, texte): &'a (String, String), phrase: &str) -> Vec<(&'a str, &'a str)> {
    let (avant, apres) = phrase.split_once("{}").expect("a number");
    let de_nombre = |c: char| c.is_ascii_digit() || c == '.';
    texte
        .match_indices(apres)
        .filter_map(|(fin, _)| {
            let debut = texte[..fin].trim_end_matches(de_nombre);
            let nombre = &texte[debut.len()..fin];
            (debut.ends_with(avant) && !nombre.is_empty()).then_some((ou.as_str(), nombre))
        })
        .collect()
}

/// Each text on one line, without the marks of comments and of tables.
fn textes() -> Vec<(String, String)> {
    let racine = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut fichiers = vec![racine.join("README.md"), racine.join("CHANGELOG.md")];
    fichiers.extend(
        ["src", "docs"]
            .into_iter()
            .flat_map(fichiers_sous)
            .filter(|chemin| chemin.extension().is_some_and(|ext| ext == "rs" || ext == "md")),
    );
    let lire = |chemin: &Path| {
        let texte = fs::read_to_string(chemin).unwrap().replace("\\|", "|");
        let lignes = texte.lines().take_while(|ligne| !ligne.starts_with("## 0.2.0"));
        let mots = lignes.flat_map(|ligne| {
            let ligne = ligne.trim_start();
            let sans = ["///", "//!", "//"].iter().find_map(|marque| ligne.strip_prefix(marque));
            sans.unwrap_or(ligne).split_whitespace()
        });
        (chemin.display().to_string(), mots.collect::<Vec<_>>().join(" "))
    };
    fichiers.iter().map(|chemin| lire(chemin)).collect()
}

/// No line of a page begins with what Markdown would take for the mark of a list, a quotation or a
/// title, and no table is cut by an empty line.
#[test]
fn aucune_ligne_d_une_page_ne_commence_par_un_operateur() {
    let racine = Path::new(env!("CARGO_MANIFEST_DIR"));
    let pages = fs::read_dir(racine.join("docs")).unwrap().map(|entree| entree.unwrap().path());
    for chemin in pages.chain(["README.md", "benches/README.md"].map(|page| racine.join(page))) {
        if chemin.extension().is_none_or(|ext| ext != "md") {
            continue;
        }
        let page = fs::read_to_string(&chemin).unwrap();
        let (mut code, mut avant, mut tete) = (false, "", false);
        for (numero, ligne) in page.lines().enumerate() {
            let ou = format!("{}:{}", chemin.display(), numero + 1);
            code ^= ligne.starts_with("```");
            let debut = ligne.trim_start();
            let operateur = ["+ ", "> ", "= "].iter().any(|marque| debut.starts_with(marque));
            assert!(code || !operateur, "{ou}: {ligne}");
            // A row is in a table: below another, or the head of one, whose next line is a rule.
            assert!(!tete || ligne.starts_with("|---"), "{ou}: a row without a table above");
            tete = !code && ligne.starts_with("| ") && !avant.starts_with('|');
            avant = ligne;
        }
    }
}
