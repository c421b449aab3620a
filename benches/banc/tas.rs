//! Scenes that other people had: what a heap costs over its list, and what a ray that strays costs over its tile
//! without it. `cargo run --release -p banc --bin tas` prints `benches/mesures/tas.csv`, in a minute. An argument sets
//! the seed.

use std::error::Error;

use banc::circonstances::Circonstances;
use banc::familles::GRAINE_DES_PAGES;
use banc::horloge::{MORCEAU, moindres};
use banc::nous;
use commun::fabrique::{boite, sphere};
use commun::regimes::{direction, entre};
use commun::{arrondi, scenes};
use fastrand::Rng;
use lancer_rayon::{ObjetRay, Rayon, Reel, Rotation, Vecteur};

/// Rays in a call.
const APPEL: usize = 64;

fn main() -> Result<(), Box<dyn Error>> {
    let graine = std::env::args().nth(1).map_or(Ok(GRAINE_DES_PAGES), |graine| graine.parse())?;
    let circonstances = Circonstances::presentes().colonnes();
    println!("case,objects,f32,f64,{}", Circonstances::TITRES);
    for n in [100, 1_000] {
        let [simples, doubles] = [rapports::<f32>(n, graine)?, rapports::<f64>(n, graine)?];
        for ((cas, simple), (_, double)) in simples.into_iter().zip(doubles) {
            println!("\"{cas}\",{n},{simple:.2},{double:.2},{circonstances}");
        }
    }
    Ok(())
}

type Rapports = Vec<(String, f64)>;

fn rapports<R: Reel>(n: usize, graine: u64) -> Result<Rapports, Box<dyn Error>> {
    let mut alea = Rng::with_seed(graine);
    let mut rapports = Vec::new();
    let en_desordre: Vec<_> = (0..MORCEAU)
        .map(|_| Rayon::new(dans(&mut alea, 4.0), arrondi(direction(&mut alea))))
        .collect::<Result<_, _>>()?;
    for tas in ["equal balls", "balls about one point", "shells", "boxes", "loose balls"] {
        let objets: Vec<_> = (0..n).map(|i| objet::<R>(tas, i, n, &mut alea)).collect();
        let [seule, lot, arbre, arbre_lot] = temps(&objets, &en_desordre)?;
        rapports.push((format!("{tas}, single: tree over list"), arbre / seule));
        rapports.push((format!("{tas}, batch: tree over list"), arbre_lot / lot));
    }
    let objets: Vec<_> = (0..n).map(|i| objet::<R>("town", i, n, &mut alea)).collect();
    let tuiles = scenes::en_tuiles(&scenes::rayons_camera::<R>(64, 64), 64);
    let sans = temps(&objets, &tuiles)?[3];
    for egares in [1, 4] {
        let mut rayons = tuiles.clone();
        for bloc in rayons.chunks_mut(APPEL) {
            for _ in 0..egares {
                bloc[alea.usize(0..APPEL)] =
                    Rayon::new(bloc[0].source(), arrondi(direction(&mut alea)))?;
            }
        }
        rapports
            .push((format!("{egares} of 64 stray: over none"), temps(&objets, &rayons)?[3] / sans));
    }
    Ok(rapports)
}

/// A point in a ball about O.
fn dans<R: Reel>(alea: &mut Rng, rayon: f64) -> Vecteur<R> {
    arrondi(direction(alea) * (rayon * alea.f64().cbrt()))
}

/// Number `i` of `n` objects of a heap, or of a town 80 wide.
fn objet<R: Reel>(tas: &str, i: usize, n: usize, alea: &mut Rng) -> ObjetRay<R> {
    let r = R::depuis_f64;
    match tas {
        "equal balls" => sphere(dans(alea, 3.0), r(5.0)),
        "balls about one point" => sphere(dans(alea, 0.01), r(entre(alea, 5.0, 10.0))),
        "shells" => sphere(Vecteur::NUL, r(1.0 + 9.0 * i as f64 / n as f64)),
        "boxes" => {
            let cotes = [(); 3].map(|()| entre(alea, 5.0, 10.0));
            let tour = Rotation::new(arrondi(direction(alea) * 3.0)).expect("angles");
            boite(dans(alea, 2.0), arrondi(cotes.into()), tour)
        }
        "loose balls" => sphere(dans(alea, 10.0), r(4.0)),
        _ => sphere(dans(alea, 40.0), r(1.0)),
    }
}

/// Nanoseconds a ray of the list, one by one and in calls, and of the tree, after a check that all agree.
fn temps<R: Reel>(objets: &[ObjetRay<R>], rayons: &[Rayon<R>]) -> Result<[f64; 4], Box<dyn Error>> {
    let mut places = nous::memoire(1, objets.len());
    let monde = nous::monde(objets, &mut places, "");
    let mut facons = nous::concurrents(monde, rayons, false);
    if facons.iter().any(|facon| facon.reponses() != facons[0].reponses()) {
        return Err("the ways differ".into());
    }
    let ns = moindres(4, 4, |qui| facons[qui].chronometrer(APPEL));
    Ok([ns[0], ns[1], ns[2], ns[3]])
}
