//! The first intersection, ray by ray and in a batch, beside annex A of the handout to the letter.

use std::hint::black_box;
use std::path::Path;
use std::time::Duration;

use commun::{litteral, scenes};
use criterion::{
    BenchmarkId, Criterion, SamplingMode, Throughput, criterion_group, criterion_main,
};
use lancer_rayon::{
    NoIntersection, ObjetRay, Rayon, Reel, premiere_intersection, premieres_intersections,
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

fn lancer<R: Reel, T>(rayons: &[Rayon<R>], premiere: impl Fn(&Rayon<R>) -> T) {
    for rayon in rayons {
        black_box(&premiere(rayon));
    }
}

criterion_group!(bancs, mesurer::<f32>, mesurer::<f64>);
criterion_main!(bancs);
