//! The first intersection, ray by ray, beside annex A of the handout to the letter.

use std::hint::black_box;
use std::time::Duration;

use criterion::{
    BenchmarkId, Criterion, SamplingMode, Throughput, criterion_group, criterion_main,
};
use lancer_rayon::{ObjetRay, Rayon, Reel, premiere_intersection};

#[path = "../tests/commun/litteral.rs"]
mod litteral;
#[path = "../tests/commun/scenes.rs"]
mod scenes;

fn mesurer<R: Reel>(c: &mut Criterion) {
    let rayons = scenes::rayons_camera::<R>(600, 400);
    let mut groupe = c.benchmark_group(std::any::type_name::<R>());
    groupe
        .sample_size(10)
        .sampling_mode(SamplingMode::Flat)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(2))
        .throughput(Throughput::Elements(rayons.len() as u64));
    for (nom, objets) in scenes_mesurees::<R>() {
        let litteraux: Vec<_> = objets.iter().map(litteral::Objet::from).collect();
        groupe.bench_function(BenchmarkId::new("lancer-rayon", &nom), |b| {
            b.iter(|| lancer(&rayons, |rayon| premiere_intersection(&objets, rayon)));
        });
        groupe.bench_function(BenchmarkId::new("annexe A", &nom), |b| {
            b.iter(|| lancer(&rayons, |rayon| litteral::premiere_intersection(&litteraux, rayon)));
        });
    }
    groupe.finish();
}

fn scenes_mesurees<R: Reel>() -> Vec<(String, Vec<ObjetRay<R>>)> {
    [3, 12, 48, 192, 1000].map(|n| (n.to_string(), scenes::melange(n))).into()
}

fn lancer<R: Reel, T>(rayons: &[Rayon<R>], premiere: impl Fn(&Rayon<R>) -> T) {
    for rayon in rayons {
        black_box(premiere(rayon));
    }
}

criterion_group!(bancs, mesurer::<f32>, mesurer::<f64>);
criterion_main!(bancs);
