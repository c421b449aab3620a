//! First hits and shadows, of a list and of a tree, ray by ray and in a batch, beside annex A of the handout to the
//! letter; and each part of a whole picture.

use std::hint::black_box;
use std::path::Path;
use std::time::Duration;

use banc::image::{self, Nous, PARTIES, peindre};
use commun::{litteral, scenes};
use criterion::{
    BenchmarkId, Criterion, SamplingMode, Throughput, criterion_group, criterion_main,
};
use exemples::scene::{Lisible, Scene};
use lancer_rayon::{
    Monde, NoIntersection, ObjetGeo, ObjetRay, Rayon, Reel, Vecteur, places, premiere_intersection,
};

/// Object by object, a list longer than this would take minutes.
const LONGUE_LISTE: usize = 1000;

fn mesurer<R: Lisible>(c: &mut Criterion) {
    let mut groupe = c.benchmark_group(std::any::type_name::<R>());
    groupe
        .sample_size(10)
        .sampling_mode(SamplingMode::Flat)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(2));
    let mut mesurer = |nom: &str, objets: &[ObjetRay<R>], rayons: &[Rayon<R>]| {
        let mut touches = vec![Err(NoIntersection); rayons.len()];
        let mut places = vec![0.0; places(objets.len())];
        let monde = Monde::new(objets, &mut places).expect("as many places as it takes");
        let liste = Monde::de_liste(objets);
        let ombres = ombres(&monde, rayons);
        groupe.throughput(Throughput::Elements(rayons.len() as u64));
        groupe.bench_function(BenchmarkId::new("arbre", nom), |b| {
            b.iter(|| lancer(rayons, |rayon| monde.premiere_intersection(rayon)));
        });
        groupe.bench_function(BenchmarkId::new("arbre, lot", nom), |b| {
            b.iter(|| monde.premieres_intersections(rayons, black_box(&mut touches)));
        });
        if objets.len() <= LONGUE_LISTE {
            let litteraux: Vec<_> = objets.iter().map(litteral::Objet::from).collect();
            groupe.bench_function(BenchmarkId::new("liste", nom), |b| {
                b.iter(|| lancer(rayons, |rayon| premiere_intersection(objets, rayon)));
            });
            groupe.bench_function(BenchmarkId::new("liste, lot", nom), |b| {
                b.iter(|| liste.premieres_intersections(rayons, black_box(&mut touches)));
            });
            groupe.bench_function(BenchmarkId::new("annexe A", nom), |b| {
                let premiere = |rayon: &_| litteral::premiere_intersection(&litteraux, rayon);
                b.iter(|| lancer(rayons, premiere));
            });
        }
        groupe.throughput(Throughput::Elements(ombres.len() as u64));
        groupe.bench_function(BenchmarkId::new("arbre, ombres", nom), |b| {
            b.iter(|| lancer(&ombres, |ombre| monde.est_occulte(ombre)));
        });
        if objets.len() <= LONGUE_LISTE {
            groupe.bench_function(BenchmarkId::new("liste, ombres", nom), |b| {
                b.iter(|| lancer(&ombres, |ombre| liste.est_occulte(ombre)));
            });
        }
    };

    let chemin = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/scenes/atelier.ron");
    let atelier: Scene<R> = Scene::lire(&chemin).unwrap();
    let objets: Vec<_> = atelier.objets.iter().map(|objet| objet.vers_ray()).collect();
    mesurer("atelier", &objets, &scenes::en_tuiles(&atelier.camera.rayons().unwrap(), 600));
    let rayons = scenes::en_tuiles(&scenes::rayons_camera(600, 400), 600);
    for n in [3, 12, 48, 100, 1000, 10_000] {
        mesurer(&n.to_string(), &scenes::melange(n), &rayons);
    }
}

/// Rays from hits to a lamp that the surface faces.
fn ombres<R: Reel>(monde: &Monde<'_, R>, rayons: &[Rayon<R>]) -> Vec<Rayon<R>> {
    let lampe = Vecteur::depuis_f64(Vecteur::new(-2.6, 7.2, 5.2));
    let ombre = |rayon: &Rayon<R>| {
        let touche = monde.premiere_intersection(rayon).ok()?;
        touche.vers_lumiere(lampe).ok()
    };
    rayons.iter().filter_map(ombre).collect()
}

/// A picture of 240,000 pixels: its rays made, asked, lit and shaded.
fn peindre_en_parties<R: Reel>(c: &mut Criterion) {
    let mut groupe = c.benchmark_group(format!("image, {}", std::any::type_name::<R>()));
    groupe.sample_size(10).measurement_time(Duration::from_secs(1));
    let pixels = image::pixels();
    groupe.throughput(Throughput::Elements(pixels.len() as u64));
    for n in [13, 200] {
        let objets = image::objets(n);
        let pret = |objet: &ObjetGeo| objet.vers(Vecteur::NUL).map(ObjetGeo::vers_ray);
        let objets: Vec<ObjetRay<R>> = objets.iter().map(pret).collect::<Result<_, _>>().unwrap();
        let mut places = vec![0.0; places(objets.len())];
        let mut nous = Nous::new(&objets, &mut places);
        for (partie, nom) in PARTIES.into_iter().enumerate() {
            groupe.bench_function(BenchmarkId::new(nom, n), |b| {
                b.iter_custom(|fois| {
                    (0..fois).map(|_| peindre(&mut nous, &pixels).0[partie]).sum()
                });
            });
        }
    }
}

fn lancer<Q, T>(rayons: &[Q], premiere: impl Fn(&Q) -> T) {
    for rayon in rayons {
        black_box(&premiere(rayon));
    }
}

criterion_group!(
    bancs,
    mesurer::<f32>,
    mesurer::<f64>,
    peindre_en_parties::<f32>,
    peindre_en_parties::<f64>
);
criterion_main!(bancs);
