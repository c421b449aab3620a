//! An overview of a scene: what every camera ray touches, in `f64` and in `f32`, as a table and as
//! a picture.
//!
//! `cargo run --release -p exemples [scene.ron] [image.png]`

use std::error::Error;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use exemples::scene::Scene;
use exemples::{image, surete};
use lancer_rayon::{
    Intersection, NoIntersection, ObjetGeo, Rayon, Reel, Touche, premiere_intersection,
};

const SCENE: &str = "docs/scenes/atelier.ron";
const IMAGE: &str = "target/apercu.png";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    image::programme(&arguments, [SCENE, IMAGE], "apercu", apercu)
}

fn apercu(chemin: &str, image: &str) -> Result<(), Box<dyn Error>> {
    let scene: Scene<f64> = Scene::lire(Path::new(chemin))?;
    let simple: Scene<f32> = Scene::lire(Path::new(chemin))?;
    let rayons = scene.camera.rayons()?;
    let (touches, duree) = lancer(&scene.objets, &rayons);
    let (simples, duree_simple) = lancer(&simple.objets, &simple.camera.rayons()?);

    let mut sortie = io::stdout().lock();
    let [mut spheres, mut plans, mut boites] = [0; 3];
    for objet in &scene.objets {
        match objet {
            ObjetGeo::Sphere(_) => spheres += 1,
            ObjetGeo::Plan(_) => plans += 1,
            ObjetGeo::Boite(_) => boites += 1,
        }
    }
    let n = rayons.len();
    writeln!(sortie, "{chemin}")?;
    writeln!(sortie, "objects  {spheres} spheres, {plans} half-spaces, {boites} boxes")?;
    writeln!(sortie, "hits     {} of {n} rays", touches.iter().flatten().count())?;
    for (nom, duree) in [("f64", duree), ("f32", duree_simple)] {
        let par_rayon = duree.as_secs_f64() * 1e9 / n as f64;
        writeln!(
            sortie,
            "{nom}      {:.1} ms, {par_rayon:.0} ns per ray",
            duree.as_secs_f64() * 1e3
        )?;
    }
    comparer(&mut sortie, &touches, &simples)?;
    let objets: Vec<_> = simple.objets.iter().map(|objet| objet.vers_ray()).collect();
    let pixels = surete::juger(&objets, &simple.camera.rayons()?);
    writeln!(
        sortie,
        "         on the same numbers {} rays differ; f32 called {} uncertain before, and {} of these not",
        pixels.autres, pixels.incertains, pixels.tus
    )?;
    let (largeur, hauteur) = scene.camera.image;
    peindre(image, largeur, hauteur, &rayons, &touches).map_err(|e| format!("{image}: {e}"))?;
    writeln!(sortie, "picture  {image}: normals | distance (log) | textures")?;
    Ok(())
}

/// What every ray touches, and the time of the best of three passes: the machine has other work.
fn lancer<R: Reel>(objets: &[ObjetGeo<R>], rayons: &[Rayon<R>]) -> (Vec<Touche<R>>, Duration) {
    let objets: Vec<_> = objets.iter().map(|objet| objet.vers_ray()).collect();
    let mut touches = vec![Err(NoIntersection); rayons.len()];
    let passe = |_| {
        let debut = Instant::now();
        for (touche, rayon) in touches.iter_mut().zip(rayons) {
            *touche = premiere_intersection(&objets, rayon);
        }
        debut.elapsed()
    };
    let duree = (0..3).map(passe).min().unwrap_or_default();
    (touches, duree)
}

/// How far the answers in `f32` are from those in `f64`.
fn comparer(
    sortie: &mut impl Write,
    touches: &[Touche],
    simples: &[Touche<f32>],
) -> io::Result<()> {
    let mut autres = 0;
    let (mut distances, mut angles) = (vec![], vec![]);
    for paire in touches.iter().zip(simples) {
        match paire {
            (Ok(a), Ok(b)) if a.texture() == b.texture() => {
                distances.push((f64::from(b.distance()) / a.distance() - 1.0).abs());
                // By the chord: the arc cosine of N·N' would see nothing below 1e-6 degrees.
                angles.push(
                    2.0 * ((a.normale() - b.normale().vers_f64()).longueur() / 2.0)
                        .asin()
                        .to_degrees(),
                );
            }
            (Err(_), Err(_)) => {}
            _ => autres += 1,
        }
    }
    distances.sort_by(f64::total_cmp);
    let mediane = distances.get(distances.len() / 2).copied().unwrap_or(0.0);
    let pire = |valeurs: &[f64]| valeurs.iter().copied().fold(0.0, f64::max);
    writeln!(sortie, "f32-f64  {autres} rays see another object, or none")?;
    writeln!(
        sortie,
        "         distance: {mediane:.1e} relative difference in the median, {:.1e} at most",
        pire(&distances),
    )?;
    writeln!(sortie, "         normal: {:.1e} degrees at most", pire(&angles))
}

type Couleur = [u8; 3];
type Panneau<'a> = &'a dyn Fn(&Intersection, &Rayon) -> Couleur;

/// Writes the three panels side by side as a PNG.
fn peindre(
    chemin: &str,
    largeur: u32,
    hauteur: u32,
    rayons: &[Rayon],
    touches: &[Touche],
) -> Result<(), Box<dyn Error>> {
    let mut logs: Vec<f64> = touches.iter().flatten().map(|t| t.distance().ln()).collect();
    logs.sort_by(f64::total_cmp);
    // The ramp leaves out the ends: one far horizon would flatten all the rest.
    let centile = |c: usize| logs.get(logs.len() * c / 100).copied().unwrap_or(0.0);
    let (pres, loin) = (centile(1), centile(97).max(centile(1) + 1e-9));

    let normale = |t: &Intersection, _: &Rayon| {
        <[f64; 3]>::from(t.normale()).map(|x| (127.5 * (x + 1.0)).round() as u8)
    };
    let distance = |t: &Intersection, _: &Rayon| rampe((t.distance().ln() - pres) / (loin - pres));
    let texture = |t: &Intersection, r: &Rayon| {
        let face = -t.normale().produit_scalaire(r.direction());
        teinte(t.texture().0, 0.35 + 0.65 * face)
    };
    let panneaux: [Panneau<'_>; 3] = [&normale, &distance, &texture];

    let lignes = touches.chunks(largeur as usize).zip(rayons.chunks(largeur as usize));
    let mut pixels = Vec::with_capacity(3 * 3 * touches.len());
    for (j, (touches, rayons)) in lignes.enumerate() {
        let fond = fond(j as f64 / f64::from(hauteur));
        for panneau in panneaux {
            for (touche, rayon) in touches.iter().zip(rayons) {
                pixels.extend(touche.as_ref().map_or(fond, |t| panneau(t, rayon)));
            }
        }
    }
    image::ecrire(chemin, (3 * largeur, hauteur), png::Compression::Fast, &pixels)
}

/// What is seen where nothing is touched: a dusk, from the top (0) to the bottom (1).
fn fond(y: f64) -> Couleur {
    melange([28.0, 32.0, 44.0], [66.0, 70.0, 84.0], y)
}

/// From near (0), pale yellow, through green and blue to far (1), violet: viridis, whose lightness
/// falls evenly.
fn rampe(x: f64) -> Couleur {
    const VIRIDIS: [[f64; 3]; 7] = [
        [253.0, 231.0, 37.0],
        [144.0, 215.0, 67.0],
        [53.0, 183.0, 121.0],
        [33.0, 145.0, 140.0],
        [49.0, 104.0, 142.0],
        [68.0, 57.0, 131.0],
        [68.0, 1.0, 84.0],
    ];
    let x = x.clamp(0.0, 1.0) * (VIRIDIS.len() - 1) as f64;
    let i = (x as usize).min(VIRIDIS.len() - 2);
    melange(VIRIDIS[i], VIRIDIS[i + 1], x - i as f64)
}

fn melange(a: [f64; 3], b: [f64; 3], x: f64) -> Couleur {
    std::array::from_fn(|i| (a[i] + (b[i] - a[i]) * x).round() as u8)
}

/// The colour of a texture under this light. Hues a golden angle apart, in Oklab, so that
/// neighbouring numbers differ and none shouts.
fn teinte(texture: u32, lumiere: f64) -> Couleur {
    let angle = (40.0 + 137.508 * f64::from(texture)).to_radians();
    let clarte = [0.80, 0.68, 0.74][texture as usize % 3];
    let (a, b) = (0.105 * angle.cos(), 0.105 * angle.sin());
    let [l, m, s] = [
        clarte + 0.396_337_777_4 * a + 0.215_803_757_3 * b,
        clarte - 0.105_561_345_8 * a - 0.063_854_172_8 * b,
        clarte - 0.089_484_177_5 * a - 1.291_485_548 * b,
    ]
    .map(|x| x.powi(3) * lumiere);
    [
        4.076_741_662_1 * l - 3.307_711_591_3 * m + 0.230_969_929_2 * s,
        -1.268_438_004_6 * l + 2.609_757_401_1 * m - 0.341_319_396_5 * s,
        -0.004_196_086_3 * l - 0.703_418_614_7 * m + 1.707_614_701 * s,
    ]
    .map(|x| (255.0 * x.clamp(0.0, 1.0).powf(1.0 / 2.2)).round() as u8)
}
