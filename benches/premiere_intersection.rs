//! The first intersection, ray by ray and in a batch, beside annex A of the handout to the letter; and
//! shadows, with the question made for them and without.

use std::hint::black_box;
use std::path::Path;
use std::time::Duration;

use commun::{litteral, scenes};
use criterion::{
    BenchmarkId, Criterion, SamplingMode, Throughput, criterion_group, criterion_main,
};
use lancer_rayon::{
    NoIntersection, ObjetRay, Rayon, Reel, Vecteur, est_occulte, premiere_intersection,
    premieres_intersections,
};
use scene::Scene;
use serde::de::DeserializeOwned;

#[allow(dead_code, reason = "shared with the tests")]
#[path = "../tests/commun"]
mod commun {
    pub(crate) mod conversion;
    pub(crate) mod litteral;
    pub(crate) mod scenes;
}
#[allow(dead_code, reason = "shared with the examples")]
#[path = "../docs/exemples/scene.rs"]
mod scene;

fn mesurer<R: Reel + DeserializeOwned>(c: &mut Criterion) {
    let mut groupe = c.benchmark_group(std::any::type_name::<R>());
    groupe
        .sample_size(10)
        .sampling_mode(SamplingMode::Flat)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(2));
    let mut mesurer = |nom: &str, objets: &[ObjetRay<R>], rayons: &[Rayon<R>]| {
        let litteraux: Vec<_> = objets.iter().map(litteral::Objet::from).collect();
        groupe.throughput(Throughput::Elements(rayons.len() as u64));
        groupe.bench_function(BenchmarkId::new("lancer-rayon", nom), |b| {
            b.iter(|| lancer(rayons, |rayon| premiere_intersection(objets, rayon)));
        });
        let mut touches = vec![Err(NoIntersection); rayons.len()];
        groupe.bench_function(BenchmarkId::new("lot", nom), |b| {
            b.iter(|| premieres_intersections(objets, rayons, black_box(&mut touches)));
        });
        let ombres = ombres(objets, rayons);
        groupe.throughput(Throughput::Elements(ombres.len() as u64));
        groupe.bench_function(BenchmarkId::new("ombres, est_occulte", nom), |b| {
            b.iter(|| lancer(&ombres, |(ombre, max)| est_occulte(objets, ombre, *max)));
        });
        groupe.bench_function(BenchmarkId::new("ombres, premiere_intersection", nom), |b| {
            let avant = |(ombre, max): &(Rayon<R>, R)| {
                premiere_intersection(objets, ombre).is_ok_and(|touche| touche.distance() < *max)
            };
            b.iter(|| lancer(&ombres, avant));
        });
        groupe.bench_function(BenchmarkId::new("annexe A", nom), |b| {
            b.iter(|| lancer(rayons, |rayon| litteral::premiere_intersection(&litteraux, rayon)));
        });
    };

    let atelier: Scene<R> = Scene::lire(Path::new("docs/scenes/atelier.ron")).unwrap();
    let objets: Vec<_> = atelier.objets.iter().map(|objet| objet.vers_ray()).collect();
    mesurer("atelier", &objets, &atelier.camera.rayons().unwrap());
    let rayons = scenes::rayons_camera(600, 400);
    for n in [3, 12, 48, 192, 1000] {
        mesurer(&n.to_string(), &scenes::melange(n), &rayons);
    }
}

/// From what the rays touch to a lamp that it faces, and how far that is.
fn ombres<R: Reel>(objets: &[ObjetRay<R>], rayons: &[Rayon<R>]) -> Vec<(Rayon<R>, R)> {
    let lampe = Vecteur::depuis_f64(Vecteur::new(-2.6, 7.2, 5.2));
    let ombre = |rayon: &Rayon<R>| {
        let touche = premiere_intersection(objets, rayon).ok()?;
        rayon.vers_lumiere(&touche, lampe)
    };
    rayons.iter().filter_map(ombre).collect()
}

fn lancer<Q, T>(rayons: &[Q], premiere: impl Fn(&Q) -> T) {
    for rayon in rayons {
        black_box(&premiere(rayon));
    }
}

criterion_group!(bancs, mesurer::<f32>, mesurer::<f64>);
criterion_main!(bancs);
