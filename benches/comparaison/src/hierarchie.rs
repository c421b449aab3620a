//! The hierarchy alone: over the even mix what the instruction set and the threads do to a batch, and what it
//! takes to build; over all families what a certificate takes, and what a ray gains that leaves out what it leaves.

use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

use banc::concurrents::temps;
use banc::familles::{Famille, Genre};
use banc::horloge::{MORCEAU, TOURS, moindres};
use banc::nous;
use commun::scenes::{en_tuiles, melange, rayons_camera};
use lancer_rayon::pour_les_tests::Reglage;
use lancer_rayon::{
    Hierarchie, NoIntersection, Rayon, Reel, Touche, Vecteur, premiere_intersection,
};
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use serde::de::DeserializeOwned;

use crate::autres::{Parry, places};
use crate::tables::nanosecondes;

/// The rays of a picture, in tiles.
fn image<R: Reel>() -> Vec<Rayon<R>> {
    en_tuiles(&rayons_camera(600, 400), 600)
}

/// The table of the instruction sets.
pub(crate) fn jeux_d_instructions() -> Result<String, Box<dyn Error>> {
    const TAILLES: [usize; 3] = [12, 192, 1000];
    let titre = |scalaire| TAILLES.map(|n| format!("{scalaire}, N = {n}")).join(" | ");
    let mut table = vec![
        format!("| instructions | {} | {} |", titre("f32"), titre("f64")),
        format!("|---|{}", "--:|".repeat(2 * TAILLES.len())),
    ];
    let colonnes = TAILLES.map(jeux_de::<f32>).into_iter().chain(TAILLES.map(jeux_de::<f64>));
    let colonnes: Vec<_> = colonnes.collect::<Result<_, _>>()?;
    for (i, (nom, _)) in Reglage::tous().enumerate() {
        let temps: Vec<_> = colonnes.iter().map(|temps| nanosecondes(temps[i])).collect();
        table.push(format!("| {nom} | {} |", temps.join(" | ")));
    }
    Ok(table.join("\n"))
}

/// Nanoseconds per ray of each set.
fn jeux_de<R: Reel>(n: usize) -> Result<Vec<f64>, Box<dyn Error>> {
    let (objets, rayons) = (melange(n), image::<R>());
    let mut places = places(&objets);
    let hierarchie = Hierarchie::new(&objets, &mut places)?;
    let [liste, ..] = nous::concurrents(hierarchie, &rayons, &[]);
    let attendues = liste.reponses();
    let en_lot = |(_, jeu): (_, Reglage)| {
        let [.., lot] = nous::concurrents(jeu.hierarchie(hierarchie), &rayons, &[]);
        lot
    };
    let mut lots: Vec<_> = Reglage::tous().map(en_lot).collect();
    if lots.iter().any(|lot| lot.reponses() != attendues) {
        return Err("a batch differs from its rays one by one".into());
    }
    Ok(temps(&mut lots))
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
    let (objets, rayons) = (melange(n), image::<R>());
    let mut places = places(&objets);
    let hierarchie = Hierarchie::new(&objets, &mut places)?;
    let mut touches = vec![Err(NoIntersection); rayons.len()];
    let mut premieres = || {
        let debut = Instant::now();
        let morceaux = rayons.par_chunks(MORCEAU).zip(touches.par_chunks_mut(MORCEAU));
        morceaux
            .try_for_each(|(rayons, touches)| hierarchie.premieres_intersections(rayons, touches))
            .expect("as many answers as rays");
        debut.elapsed().as_nanos() as f64 / rayons.len() as f64
    };
    // The best of some pictures in a row: at the first the threads still wake up.
    let temps = moindres(TOURS, 2, |i| {
        equipes[i].install(|| (0..8).map(|_| premieres()).fold(f64::INFINITY, f64::min))
    });
    if rayons.iter().zip(&touches).any(|(r, touche)| premiere_intersection(&objets, r) != *touche) {
        return Err("the batch differs from its rays one by one".into());
    }
    let (un, deux, scalaire) = (temps[0], temps[1], std::any::type_name::<R>());
    Ok(format!("| {scalaire} | {n} | {un:.1} | {deux:.1} | {:.2} |", un / deux))
}

/// What a tree costs to build, in time and in memory beside the objects.
pub(crate) fn constructions() -> String {
    let mut table = vec![
        "| scalar | N | hierarchy, ns per object | bytes per object | parry's Bvh, ns | obvhs, ns |"
            .to_owned(),
        format!("|---|--:|{}", "--:|".repeat(4)),
    ];
    for n in [1000, 10_000, 100_000] {
        table.push(constructions_de::<f32>(n));
        table.push(constructions_de::<f64>(n));
    }
    table.join("\n")
}

fn constructions_de<R: Parry>(n: usize) -> String {
    let objets = melange::<R>(n);
    let mut places = places(&objets);
    let octets = size_of_val(&places[..]) as f64 / n as f64;
    let ns = moindres(TOURS, 3, |qui| {
        let debut = Instant::now();
        match qui {
            0 => assert!(black_box(Hierarchie::new(&objets, &mut places)).is_ok()),
            _ => R::ARBRES[qui - 1](&objets),
        }
        debut.elapsed().as_nanos() as f64 / n as f64
    });
    let [ici, parry, obvhs] = [0, 1, 2].map(|qui| nanosecondes(ns[qui]));
    let scalaire = std::any::type_name::<R>();
    format!("| {scalaire} | {n} | {ici} | {octets:.0} | {parry} | {obvhs} |")
}

/// One by one, in tiles: a certificate over its ray; and mirrors and shadows without the object that they leave over
/// the same with it.
pub(crate) fn certificats() -> Result<String, Box<dyn Error>> {
    let titre = |scalaire| format!("{scalaire}: certificate | mirrors | shadows");
    let mut table = vec![
        format!("| family | N | {} | {} |", titre("f32"), titre("f64")),
        format!("|---|{}", "--:|".repeat(7)),
    ];
    for famille in Famille::TOUTES {
        for &n in famille.nombres(&[12, 10_000]) {
            let rapports = [certificats_de::<f32>(famille, n)?, certificats_de::<f64>(famille, n)?];
            let rapports = rapports.as_flattened().iter().map(|x| format!("{x:.2}"));
            let rapports = rapports.collect::<Vec<_>>().join(" | ");
            table.push(format!("| {} | {n} | {rapports} |", famille.nom()));
        }
    }
    Ok(table.join("\n"))
}

fn certificats_de<R: Reel + DeserializeOwned>(
    famille: Famille,
    n: usize,
) -> Result<[f64; 3], Box<dyn Error>> {
    let scene = famille.scene::<R>(n);
    let mut places = places(&scene.objets);
    let hierarchie = Hierarchie::new(&scene.objets, &mut places)?;
    let (rayons, _) = Genre::Tuiles.rayons(&hierarchie, &scene, 4);
    let vues: Vec<(Rayon<R>, Touche<R>)> =
        rayons.iter().map(|rayon| (*rayon, hierarchie.premiere_intersection(rayon))).collect();
    let lampe = Vecteur::depuis_f64(Vecteur::new(-8.0, 12.0, 10.0));
    let touchees = vues.iter().filter_map(|(rayon, touche)| Some((rayon, touche.ok()?)));
    let reflets = touchees.clone().filter_map(|(rayon, touche)| {
        let (d, n) = (rayon.direction(), touche.normale());
        let reflet = d - n * (d.produit_scalaire(n) * R::depuis_f64(2.0));
        Some((rayon.secondaire(&touche, reflet).ok()?, touche.objet()))
    });
    let reflets: Vec<_> = reflets.collect();
    let ombres = touchees
        .filter_map(|(rayon, touche)| Some((rayon.vers_lumiere(&touche, lampe)?, touche.objet())));
    let ombres: Vec<_> = ombres.collect();
    fn chaque<Q>(questions: &[Q], mut demander: impl FnMut(&Q) -> bool) -> f64 {
        let debut = Instant::now();
        for question in questions {
            black_box(demander(black_box(question)));
        }
        debut.elapsed().as_nanos() as f64
    }
    let h = &hierarchie;
    let ns = moindres(TOURS, 6, |quoi| match quoi {
        0 => chaque(&vues, |(r, _)| h.premiere_intersection(r).is_ok()),
        1 => chaque(&vues, |(r, touche)| h.est_certaine(r, touche)),
        2 => chaque(&reflets, |(r, _)| h.premiere_intersection(r).is_ok()),
        3 => chaque(&reflets, |(r, objet)| h.sans(*objet).premiere_intersection(r).is_ok()),
        4 => chaque(&ombres, |((r, t), _)| h.est_occulte(r, *t)),
        _ => chaque(&ombres, |((r, t), objet)| h.sans(*objet).est_occulte(r, *t)),
    });
    Ok([ns[1] / ns[0], ns[3] / ns[2], ns[5] / ns[4]])
}
