//! lancer-rayon beside annex A of the handout to the letter, beside parry, beside parry's shapes in the tree of
//! obvhs and beside Embree, with the same objects and the same rays.
//!
//! `cargo run --release -p comparaison` prints the times, in five minutes; with `documents` it measures errors
//! as well, and writes the tables and plots of `docs/precision.md`, `docs/compromis.md` and
//! `docs/performance.md`. `--features embree` takes Embree 3.13 along (`apt-get install libembree-dev`).

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

fn main() -> Result<(), Box<dyn Error>> {
    let ecrire = match std::env::args().nth(1).as_deref() {
        None => false,
        Some("documents") => true,
        Some(_) => return Err("usage: comparaison [documents]".into()),
    };
    // Another machine, another table.
    let (instructions, _) = Reglage::tous().next().ok_or("no instructions")?;
    let resume = format!("summary, {instructions}");
    if ecrire {
        // Fails now, not after all the measuring.
        page::autour("docs/performance.md", &resume)?;
    }
    glam::verifier()?;
    let cellules = cellules::mesurer()?;
    println!("\nleft out\n\n{}", tables::resume(&cellules, &tables::SANS));
    let tables = [
        (&*resume, tables::resume(&cellules, &tables::QUESTIONS)),
        ("families", tables::table(&cellules)),
        ("building", hierarchie::constructions()),
        ("sets", hierarchie::jeux_d_instructions()?),
        ("certificates", hierarchie::certificats()?),
    ];
    for (nom, table) in &tables {
        println!("\n{nom}\n\n{table}");
    }
    if ecrire {
        for (nom, table) in &tables {
            page::remplacer("docs/performance.md", nom, &page::datee(table))?;
        }
        tables::graphique(&cellules)?;
        exactitude::documenter()?;
        compromis::documenter()?;
    }
    Ok(())
}
