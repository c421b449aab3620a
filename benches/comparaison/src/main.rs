//! lancer-rayon beside annex A of the handout to the letter, beside parry, beside parry's shapes in the tree of
//! obvhs and beside Embree, with the same objects and the same rays.
//!
//! `cargo run --release -p comparaison` prints the times, in five minutes; with `documents` it measures errors
//! as well, and writes the tables and plots of `README.md`, `docs/choisir.md`, `docs/precision.md` and
//! `benches/README.md`. `--features embree` takes Embree 3.13 along (`apt-get install libembree-dev`).

mod annexe;
mod autres;
mod cellules;
mod compromis;
#[cfg(feature = "embree")]
mod embree;
mod exactitude;
mod glam;
mod hierarchie;
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

/// What else is written than the tables of the cells, by page.
const AUTRES: [(&str, &str); 5] = [
    ("README.md", "picture"),
    ("docs/choisir.md", "variants"),
    ("docs/precision.md", "errors"),
    ("docs/precision.md", "bounds"),
    (BANCS, "ways"),
];

const BANCS: &str = "benches/README.md";

fn main() -> Result<(), Box<dyn Error>> {
    let ecrire = match std::env::args().nth(1).as_deref() {
        None => false,
        Some("documents") => true,
        Some(_) => return Err("usage: comparaison [documents]".into()),
    };
    // Another machine, another table.
    let (instructions, _) = Reglage::tous().next().ok_or("no instructions")?;
    let resume = format!("summary, {instructions}");
    let a_ecrire = [
        ("README.md", "speed"),
        (BANCS, &resume),
        (BANCS, "building"),
        (BANCS, "sets"),
        (BANCS, "certificates"),
    ];
    if ecrire {
        // Fails now, not after all the measuring.
        for (ou, nom) in a_ecrire.into_iter().chain(AUTRES) {
            page::autour(ou, nom)?;
        }
    }
    glam::verifier()?;
    let cellules = cellules::mesurer()?;
    let tables = [
        tables::vitesse(&cellules),
        tables::resume(&cellules),
        hierarchie::constructions(),
        hierarchie::jeux_d_instructions()?,
        hierarchie::certificats()?,
    ];
    for ((_, nom), table) in a_ecrire.iter().zip(&tables) {
        println!("\n{nom}\n\n{table}");
    }
    if ecrire {
        for ((ou, nom), table) in a_ecrire.iter().zip(&tables) {
            // The page of the measurements has one date, below its first table.
            let texte = if *ou == BANCS { table.clone() } else { page::datee(table) };
            page::remplacer(ou, nom, &texte)?;
        }
        tables::graphique(&cellules)?;
        exactitude::documenter()?;
        compromis::documenter()?;
    }
    Ok(())
}
