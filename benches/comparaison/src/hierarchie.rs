//! The tree alone: what the instruction set does to a batch over the even mix, what building takes, and what a
//! certificate takes over all families.

use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

use banc::concurrents::temps;
use banc::familles::{Famille, GRAINE_DES_PAGES, Genre};
use banc::horloge::{TOURS, moindres};
use banc::nous;
use commun::scenes::{en_tuiles, melange, rayons_camera};
use lancer_rayon::pour_les_tests::Reglage;
use lancer_rayon::{Monde, Rayon, Reel, Reponse, places};

use crate::autres::{Scalaire, en_morceaux};
use crate::rival::Parry;
use crate::tables::nanosecondes;

/// The rays of a picture, in tiles.
fn image<R: Reel>() -> Vec<Rayon<R>> {
    en_tuiles(&rayons_camera(600, 400), 600)
}

/// A batch in tiles with each instruction set, in nanoseconds a ray.
pub(crate) fn jeux_d_instructions() -> Result<Vec<String>, Box<dyn Error>> {
    const TAILLES: [usize; 3] = [12, 192, 1000];
    let titre = |scalaire| TAILLES.map(|n| format!("{scalaire}_{n}_ns")).join(",");
    let mut table = vec![format!("instructions,{},{}", titre("f32"), titre("f64"))];
    let colonnes = TAILLES.map(jeux_de::<f32>).into_iter().chain(TAILLES.map(jeux_de::<f64>));
    let colonnes: Vec<_> = colonnes.collect::<Result<_, _>>()?;
    for (i, (nom, _)) in Reglage::tous().enumerate() {
        let temps: Vec<_> = colonnes.iter().map(|temps| nanosecondes(temps[i])).collect();
        table.push(format!("{nom},{}", temps.join(",")));
    }
    Ok(table)
}

/// Nanoseconds a ray with each set.
fn jeux_de<R: Reel>(n: usize) -> Result<Vec<f64>, Box<dyn Error>> {
    let (objets, rayons) = (melange(n), image::<R>());
    let mut memoire = Vec::new();
    let monde = en_morceaux(&objets, &mut memoire)?;
    let [liste, ..] = nous::concurrents(monde, &rayons, false);
    let attendues = liste.reponses();
    let en_lot = |(_, jeu): (_, Reglage)| {
        let [.., lot] = nous::concurrents(jeu.monde(monde), &rayons, false);
        lot
    };
    let mut lots: Vec<_> = Reglage::tous().map(en_lot).collect();
    if lots.iter().any(|lot| lot.reponses() != attendues) {
        return Err("a batch differs from its rays one by one".into());
    }
    Ok(temps(&mut lots))
}

/// What a tree costs to build, in time and in memory beside the objects.
pub(crate) fn constructions() -> Vec<String> {
    let titres = "tree_ns_per_object,tree_bytes_per_object,parry_ns_per_object,obvhs_ns_per_object";
    let mut table = vec![format!("scalar,objects,{titres}")];
    for n in [1000, 100_000] {
        table.push(constructions_de::<f32>(n));
        table.push(constructions_de::<f64>(n));
    }
    table
}

fn constructions_de<R: Parry>(n: usize) -> String {
    let objets = melange::<R>(n);
    // Nothing is long, so what must be lent is enough.
    let mut places = vec![0.0; places(n)];
    let octets = size_of_val(&places[..]) as f64 / n as f64;
    let ns = moindres(TOURS, 3, |qui| {
        let debut = Instant::now();
        match qui {
            0 => assert!(black_box(Monde::new(&objets, &mut places)).is_ok()),
            _ => R::ARBRES[qui - 1](&objets),
        }
        debut.elapsed().as_nanos() as f64 / n as f64
    });
    let [ici, parry, obvhs] = [0, 1, 2].map(|qui| nanosecondes(ns[qui]));
    let scalaire = std::any::type_name::<R>();
    format!("{scalaire},{n},{ici},{octets:.0},{parry},{obvhs}")
}

/// The time of a certificate over that of its ray, one by one, in tiles.
pub(crate) fn certificats() -> Result<Vec<String>, Box<dyn Error>> {
    let titres = "scalar,objects,geometric_mean,least,least_family,highest,highest_family";
    let mut table = vec![titres.to_owned()];
    for (noms, n) in [("12 to 30", 12), ("10000", 10_000)] {
        table.push(certificats_parmi::<f32>(noms, n)?);
        table.push(certificats_parmi::<f64>(noms, n)?);
    }
    Ok(table)
}

fn certificats_parmi<R: Scalaire>(noms: &str, n: usize) -> Result<String, Box<dyn Error>> {
    let mut rapports = Vec::new();
    for famille in Famille::TOUTES {
        for &n in famille.nombres(&[n]).iter().filter(|&&m| (m < 100) == (n < 100)) {
            rapports.push((certificat_de::<R>(famille, n)?, famille.nom()));
        }
    }
    rapports.sort_by(|a, b| a.0.total_cmp(&b.0));
    let moyenne = rapports.iter().map(|(x, _)| x.ln()).sum::<f64>() / rapports.len() as f64;
    let [Some(moindre), Some(plus_haut)] = [rapports.first(), rapports.last()] else {
        return Err("no family".into());
    };
    let [(moindre, ou), (plus_haut, la)] = [moindre, plus_haut];
    let moyenne = moyenne.exp();
    Ok(format!("{},{noms},{moyenne:.2},{moindre:.2},{ou},{plus_haut:.2},{la}", R::NOM))
}

fn certificat_de<R: Scalaire>(famille: Famille, n: usize) -> Result<f64, Box<dyn Error>> {
    let scene = famille.scene::<R>(n, GRAINE_DES_PAGES);
    let mut memoire = Vec::new();
    let monde = en_morceaux(&scene.objets, &mut memoire)?;
    let rayons = Genre::Tuiles.rayons(&monde, &scene, 4);
    let vues: Vec<(Rayon<R>, Reponse<R>)> =
        rayons.iter().map(|rayon| (*rayon, monde.premiere_intersection(rayon))).collect();
    let ns = moindres(TOURS, 2, |quoi| {
        let debut = Instant::now();
        for (rayon, touche) in black_box(&vues) {
            black_box(if quoi == 0 {
                monde.premiere_intersection(rayon).is_ok()
            } else {
                monde.certifie(rayon, touche)
            });
        }
        debut.elapsed().as_nanos() as f64
    });
    Ok(ns[1] / ns[0])
}
