//! What a far sun, sky, second town or camera, or a ball as the ground, costs: the time of a city of one kilometre with
//! it over that without. `cargo run --release -p banc --bin loin` prints `benches/mesures/lointains.csv`, in a minute.
//! An argument sets the seed.

use std::error::Error;

use banc::circonstances::Circonstances;
use banc::familles::{AuLoin, GRAINE_DES_PAGES, Genre, Scene};
use banc::horloge::{MORCEAU, moindres};
use banc::nous;
use exemples::scene::Lisible;
use lancer_rayon::Reel;

const CAS: [(AuLoin, &[f64]); 5] = [
    (AuLoin::Soleil, &[1.5e11]),
    (AuLoin::Ciel, &[1e8]),
    (AuLoin::Globe, &[1e7]),
    (AuLoin::DeuxVilles, &[1e5, 1e6, 1e7]),
    (AuLoin::Camera, &[1e6, 1e8]),
];

/// How many objects the city has.
const N: usize = 10_000;

/// The kinds of rays whose geometric mean the table has.
const GENRES: [Genre; 3] = [Genre::Tuiles, Genre::Diffus, Genre::Ombres];

fn main() -> Result<(), Box<dyn Error>> {
    let graine = std::env::args().nth(1).map_or(Ok(GRAINE_DES_PAGES), |graine| graine.parse())?;
    let circonstances = Circonstances::presentes().colonnes();
    let titres = Circonstances::TITRES;
    println!("with,metres,objects,f32_single,f32_batch,f64_single,f64_batch,{titres}");
    for (quoi, distances) in CAS {
        for &metres in distances {
            let mesures =
                [rapports::<f32>(quoi, metres, graine)?, rapports::<f64>(quoi, metres, graine)?];
            let cases = mesures.map(|[seul, lot]| format!("{seul:.2},{lot:.2}")).join(",");
            println!("{},{metres:.1e},{N},{cases},{circonstances}", quoi.nom());
        }
    }
    Ok(())
}

/// One by one and in a batch, over the city without it, as geometric means.
fn rapports<R: Lisible>(
    quoi: AuLoin,
    metres: f64,
    graine: u64,
) -> Result<[f64; 2], Box<dyn Error>> {
    let scenes = [AuLoin::Rien.scene::<R>(N, graine, 0.0), quoi.scene(N, graine, metres)];
    let mut sommes = [0.0; 2];
    for genre in GENRES {
        let [sans, avec] = [temps(&scenes[0], genre)?, temps(&scenes[1], genre)?];
        for (somme, (avec, sans)) in sommes.iter_mut().zip(avec.into_iter().zip(sans)) {
            *somme += (avec / sans).ln() / GENRES.len() as f64;
        }
    }
    Ok(sommes.map(f64::exp))
}

/// Nanoseconds a ray of the tree, one by one and in a batch, after a check that the list agrees.
fn temps<R: Reel>(scene: &Scene<R>, genre: Genre) -> Result<[f64; 2], Box<dyn Error>> {
    let mut places = nous::memoire(1, scene.objets.len());
    let monde = nous::monde(&scene.objets, &mut places, "");
    let rayons = genre.rayons(&monde, scene, 1);
    let quelques = &rayons[..rayons.len().min(400)];
    let [liste, ..] = nous::concurrents(monde, quelques, genre.ombres());
    let [_, _, mut seul, mut lot] = nous::concurrents(monde, &rayons, genre.ombres());
    if seul.reponses() != lot.reponses()
        || liste.reponses()[..] != seul.reponses()[..quelques.len()]
    {
        return Err("the ways differ".into());
    }
    let ns = moindres(4, 2, |qui| [&mut seul, &mut lot][qui].chronometrer(MORCEAU));
    Ok([ns[0], ns[1]])
}
