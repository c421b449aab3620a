//! The batch alone: what the order of the rays, the place of the answers, the instruction set and
//! the threads do to it.

use std::error::Error;

use lancer_rayon::{Hierarchie, Rayon, Reel, Reglage, Touche};
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::commun::scenes::melange;
use crate::concours::{Concours, Concurrent, places};
use crate::horloge::{
    MORCEAU, chronometrer_lot, exiger, moindres, nanosecondes, petit_tampon, tampon, une_par_une,
};
use crate::pairs::Parry;
use crate::rayons::{diffus, en_lignes, en_tuiles, incoherents, rugueux};

/// The table of the orders: what rays in each of them cost in a batch and one by one.
pub(crate) fn ordres() -> Result<String, Box<dyn Error>> {
    let mut table = vec![
        "| scalar | N | tiles | whole picture | rows | rough mirrors | diffuse | by object | by octant \
         | by octant, object | no order | parry, no order | parry / one by one |"
            .to_owned(),
        format!("|---|--:|{}", "--:|".repeat(11)),
    ];
    for n in [12, 48, 192, 1000, 10_000, 100_000] {
        table.push(ordres_de::<f32>(n)?);
        table.push(ordres_de::<f64>(n)?);
    }
    Ok(table.join("\n"))
}

fn ordres_de<R: Parry>(n: usize) -> Result<String, Box<dyn Error>> {
    let objets = melange(n);
    let mut places = places(&objets);
    let hierarchie = Hierarchie::new(&objets, &mut places)?;
    let ensemble = |rayons: &[Rayon<R>], touches: &mut [Touche<R>]| {
        hierarchie.premieres_intersections(rayons, touches)
    };
    let seuls = |rayons: &[Rayon<R>], touches: &mut [Touche<R>]| {
        for (rayon, touche) in rayons.iter().zip(touches) {
            *touche = hierarchie.premiere_intersection(rayon);
        }
        Ok(())
    };
    let ordres = [
        en_tuiles(),
        en_lignes(),
        rugueux(&hierarchie),
        diffus(&hierarchie, |_| (0, 0)),
        diffus(&hierarchie, |(objet, _)| (objet, 0)),
        diffus(&hierarchie, |(_, octant)| (0, octant)),
        diffus(&hierarchie, |(objet, octant)| (octant.into(), objet as u8)),
        incoherents(&hierarchie),
    ];
    let mut tampons = [petit_tampon(), tampon(ordres[0].len())];
    // Each order in a batch and one by one, and tiles with one buffer for the whole picture.
    let mut cas: Vec<_> = (0..ordres.len()).flat_map(|o| [(o, 0, true), (o, 0, false)]).collect();
    cas.push((0, 1, true));
    let ns = moindres(&cas, |&(ordre, tampon, en_lot)| {
        let (rayons, tampon) = (&ordres[ordre], &mut tampons[tampon]);
        if en_lot {
            chronometrer_lot(rayons, tampon, ensemble)
        } else {
            chronometrer_lot(rayons, tampon, seuls)
        }
    });
    let (paires, image) = ns.split_at(2 * ordres.len());
    let mut cellules: Vec<_> =
        paires.chunks(2).map(|ns| format!("{:.0} / {:.0}", ns[0], ns[1])).collect();
    cellules.insert(1, format!("{:.0}", image[0]));
    let [.., rayons] = ordres;
    let concours = Concours::new(objets.clone(), rayons);
    concours.verifier(&Concurrent::ARBRES)?;
    let temps = concours.temps(&Concurrent::ARBRES)?;
    let (scalaire, parry) = (std::any::type_name::<R>(), nanosecondes(temps.parry()));
    let rapport = temps.parry() / temps.seuls();
    Ok(format!("| {scalaire} | {n} | {} | {parry} | {rapport:.1} |", cellules.join(" | ")))
}

/// The table of the instruction sets.
pub(crate) fn jeux_d_instructions() -> Result<String, Box<dyn Error>> {
    const TAILLES: [usize; 3] = [12, 192, 1000];
    let titre = |scalaire| TAILLES.map(|n| format!("{scalaire}, N = {n}")).join(" | ");
    let mut table = vec![
        format!("| instructions | {} | {} |", titre("f32"), titre("f64")),
        format!("|---|{}", "--:|".repeat(2 * TAILLES.len())),
    ];
    let mut colonnes = Vec::new();
    for n in TAILLES {
        colonnes.push(jeux_de::<f32>(n)?);
    }
    for n in TAILLES {
        colonnes.push(jeux_de::<f64>(n)?);
    }
    for (i, (nom, _)) in Reglage::tous().enumerate() {
        let temps: Vec<_> = colonnes.iter().map(|temps| nanosecondes(temps[i])).collect();
        table.push(format!("| {nom} | {} |", temps.join(" | ")));
    }
    Ok(table.join("\n"))
}

/// Nanoseconds per ray of each set.
fn jeux_de<R: Reel>(n: usize) -> Result<Vec<f64>, Box<dyn Error>> {
    let (objets, rayons) = (melange(n), en_tuiles::<R>());
    let mut places = places(&objets);
    let hierarchie = Hierarchie::new(&objets, &mut places)?;
    let jeux: Vec<_> = Reglage::tous().map(|(_, jeu)| jeu.hierarchie(hierarchie)).collect();
    let attendues = une_par_une(&objets, &rayons);
    for jeu in &jeux {
        exiger(&attendues, &rayons, |rayons, touches| {
            jeu.premieres_intersections(rayons, touches)
        })?;
    }
    let mut tampon = petit_tampon();
    Ok(moindres(&jeux, |jeu| {
        chronometrer_lot(&rayons, &mut tampon, |rayons, touches| {
            jeu.premieres_intersections(rayons, touches)
        })
    }))
}

/// The table of the threads.
pub(crate) fn threads() -> Result<String, Box<dyn Error>> {
    let equipes = [1, 2].map(|threads| ThreadPoolBuilder::new().num_threads(threads).build());
    let [une, deux] = equipes;
    let equipes = [une?, deux?];
    let mut table = vec![
        "| scalar | N | one thread | two threads | speed-up |".to_owned(),
        "|---|--:|--:|--:|--:|".to_owned(),
    ];
    for n in [48, 1000] {
        table.push(threads_de::<f32>(n, &equipes)?);
        table.push(threads_de::<f64>(n, &equipes)?);
    }
    Ok(table.join("\n"))
}

fn threads_de<R: Reel>(n: usize, equipes: &[ThreadPool; 2]) -> Result<String, Box<dyn Error>> {
    let (objets, rayons) = (melange(n), en_tuiles::<R>());
    let mut places = places(&objets);
    let hierarchie = Hierarchie::new(&objets, &mut places)?;
    let premieres = |rayons: &[Rayon<R>], touches: &mut [Touche<R>]| {
        let morceaux = rayons.par_chunks(MORCEAU).zip(touches.par_chunks_mut(MORCEAU));
        morceaux
            .try_for_each(|(rayons, touches)| hierarchie.premieres_intersections(rayons, touches))
    };
    exiger(&une_par_une(&objets, &rayons), &rayons, premieres)?;
    let mut tampon = tampon(rayons.len());
    let temps = moindres(equipes, |equipe| {
        // The best of some pictures in a row: at the first the threads still wake up.
        equipe.install(|| {
            let images = (0..8).map(|_| chronometrer_lot(&rayons, &mut tampon, premieres));
            images.fold(f64::INFINITY, f64::min)
        })
    });
    let (un, deux, scalaire) = (temps[0], temps[1], std::any::type_name::<R>());
    Ok(format!("| {scalaire} | {n} | {un:.1} | {deux:.1} | {:.2} |", un / deux))
}
