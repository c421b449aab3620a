//! lancer-rayon beside annex A of the handout to the letter, beside parry, beside parry's shapes in the tree of
//! obvhs and beside Embree, with the same objects and the same rays.
//!
//! `cargo run --release -p comparaison` prints the times, in nine minutes, and with `image` those of a whole picture and
//! of single calls alone, which `image documents` also writes. With `documents` it measures errors as well, and writes
//! the tables and plots of `README.md`, `docs/vitesse.md` and `benches/erreurs.md`, and seven files of `benches/mesures`.
//! `--features embree` adds Embree 3.13 (`apt-get install libembree-dev`). `variants` measures speed against accuracy
//! alone and writes it; without Embree, whose threads slow down what is timed beside them.

mod annexe;
mod autres;
mod cellules;
mod compromis;
#[cfg(feature = "embree")]
mod embree;
mod exactitude;
mod gestes;
mod glam;
mod hierarchie;
mod image;
mod page;
mod rival;
mod tables;

use std::error::Error;

use lancer_rayon::pour_les_tests::Reglage;

#[path = "."]
mod simple {
    pub(crate) use parry3d as version;
    mod parry;
}

#[path = "."]
mod double {
    pub(crate) use parry3d_f64 as version;
    #[expect(clippy::duplicate_mod, reason = "one page, two crates with the same names in them")]
    mod parry;
}

/// The page with the tables of the cells, and others; and the first page.
const VITESSE: &str = "docs/vitesse.md";
const README: &str = "README.md";

/// The parts that are written into pages beside the tables of the cells.
const AUTRES: [(&str, &str); 5] = [
    (README, VARIANTES),
    (VITESSE, IMAGE),
    (VITESSE, VARIANTES),
    ("benches/erreurs.md", "errors"),
    ("benches/erreurs.md", "bounds"),
];

/// The table of a whole picture, and that of speed against accuracy.
const IMAGE: &str = "picture";
const VARIANTES: &str = "variants";

fn main() -> Result<(), Box<dyn Error>> {
    let ecrire = match std::env::args().nth(1).as_deref() {
        None => false,
        Some("documents") => true,
        Some("image") => {
            let (image, gestes) = (image::mesurer()?, gestes::mesurer());
            println!("{}\n\n{}", image::tableau(&image), gestes::tableau(&gestes));
            if std::env::args().nth(2).as_deref() == Some("documents") {
                documenter(&image, &gestes)?;
            }
            return Ok(());
        }
        Some("variants") => return compromis::documenter(),
        Some(_) => return Err("usage: comparaison [[image] documents | variants]".into()),
    };
    // Each machine has its own table.
    let (instructions, _) = Reglage::tous().next().ok_or("no instructions")?;
    let tableaux = [
        ("batches", tables::EN_LOT),
        ("from a hit", tables::D_UNE_TOUCHE),
        ("summary", tables::AUPRES_DES_AUTRES),
    ]
    .map(|(nom, tableau)| (format!("{nom}, {instructions}"), tableau));
    if ecrire {
        // It fails now, not after all the measuring.
        let des_cellules = tableaux.iter().map(|(nom, _)| (VITESSE, &**nom));
        for (ou, nom) in AUTRES.into_iter().chain(des_cellules) {
            page::autour(ou, nom)?;
        }
    }
    glam::verifier()?;
    // Before all else, as it stands on the pages.
    let (image, gestes) = (image::mesurer()?, gestes::mesurer());
    if ecrire {
        documenter(&image, &gestes)?;
    }
    let cellules = cellules::mesurer()?;
    let tableaux = tableaux.map(|(nom, tableau)| (nom, tables::resume(&tableau, &cellules)));
    for (nom, table) in &tableaux {
        println!("\n{nom}\n\n{table}");
    }
    let fichiers = [
        ("vitesse", tables::vitesse(&cellules)),
        ("construction", hierarchie::constructions()),
        ("instructions", hierarchie::jeux_d_instructions()?),
        ("certificats", hierarchie::certificats()?),
    ];
    for (nom, lignes) in &fichiers {
        println!("\n{nom}\n\n{}", lignes.join("\n"));
    }
    if ecrire {
        for (nom, table) in &tableaux {
            page::remplacer(VITESSE, nom, &page::datee(table))?;
        }
        for (nom, lignes) in &fichiers {
            page::csv(nom, lignes)?;
        }
        tables::graphique(&cellules)?;
        exactitude::documenter()?;
        compromis::documenter()?;
    }
    Ok(())
}

/// Writes the table of a whole picture, and the files of that and of single calls.
fn documenter(image: &[String], gestes: &[String]) -> Result<(), Box<dyn Error>> {
    page::remplacer(VITESSE, IMAGE, &page::datee(&image::tableau(image)))?;
    page::csv("image", image)?;
    page::csv("gestes", gestes)?;
    Ok(())
}
