//! An overview of a scene, as a table and as a picture: what every camera ray hits, how long that takes in `f64` and in
//! `f32`, and how far the two differ.
//!
//! `cargo run --release --bin apercu [scene.ron] [image.png]`

use std::error::Error;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use exemples::scene::{Scene, tuiles};
use exemples::surete::Jugement;
use exemples::{image, surete};
use lancer_rayon::{
    LongueursDifferentes, Monde, NoIntersection, ObjetGeo, ObjetRay, Rayon, Reel, Reponse, places,
    premiere_intersection,
};

const SCENE: &str = "docs/scenes/atelier.ron";
const IMAGE: &str = "target/apercu.png";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    image::programme(&arguments, [SCENE, IMAGE], "apercu", Some(apercu))
}

fn apercu(chemin: &str, image: &str) -> Result<(), Box<dyn Error>> {
    let Scene { camera, objets } = Scene::<f64>::lire(Path::new(chemin))?;
    let [mut spheres, mut plans, mut boites] = [0; 3];
    for objet in &objets {
        match objet {
            ObjetGeo::Sphere(_) => spheres += 1,
            ObjetGeo::Plan(_) => plans += 1,
            ObjetGeo::Boite(_) => boites += 1,
        }
    }
    let Scene { objets: simples, .. } = Scene::<f32>::lire(Path::new(chemin))?;
    let objets: Vec<_> = objets.into_iter().map(ObjetRay::from).collect();
    let simples: Vec<_> = simples.into_iter().map(ObjetRay::from).collect();
    let (rayons, rayons_simples) = (camera.rayons()?, camera.rayons()?);
    let (touches, temps) = lancer(&objets, &rayons, camera.image.0)?;
    let (touches_simples, temps_simples) = lancer(&simples, &rayons_simples, camera.image.0)?;

    let mut sortie = io::stdout().lock();
    writeln!(sortie, "{chemin}")?;
    writeln!(sortie, "objects  {spheres} spheres, {plans} half-spaces, {boites} boxes")?;
    writeln!(sortie, "hits     {} of {} rays", touches.iter().flatten().count(), rayons.len())?;
    writeln!(sortie, "time     ns per ray                  f64     f32")?;
    for ((facon, double), simple) in FACONS.iter().zip(temps).zip(temps_simples) {
        writeln!(sortie, "         {facon:<23} {double:>7.1} {simple:>7.1}")?;
    }
    writeln!(sortie, "         all with the hits of the list; the batch in tiles of 8 x 8 pixels")?;
    comparer(&mut sortie, &touches, &touches_simples)?;
    let jugements = surete::juger(&simples, &rayons_simples)?;
    let comptes = surete::compter(&jugements);
    writeln!(
        sortie,
        "         on the same numbers {} rays differ; f32 called {} uncertain before, and {} of these not",
        comptes.autres, comptes.incertaines, comptes.tues
    )?;
    peindre(image, camera.image, &rayons, &touches, &jugements)
        .map_err(|e| format!("{image}: {e}"))?;
    writeln!(sortie, "picture  {image}: normals | distance (log) | textures | f32 - f64")?;
    writeln!(
        sortie,
        "         f32 - f64 on the same numbers, of the distance: violet {PEU:e}, blue, green, \
         yellow {BEAUCOUP:e} (log); red: not certain"
    )?;
    Ok(())
}

/// The ways to ask for the rays of a picture.
const FACONS: [&str; 3] = ["list", "hierarchy", "batch of the hierarchy"];

type Facon<'a, R> = &'a dyn Fn(&mut [Reponse<R>]) -> Result<(), LongueursDifferentes>;

/// What every ray hits, and how many nanoseconds a ray takes in each of `FACONS`.
type Mesure<R> = (Vec<Reponse<R>>, [f64; 3]);

/// Asks for a picture of this width in three passes, the best of which counts, since the machine has other work.
fn lancer<R: Reel>(
    objets: &[ObjetRay<R>],
    rayons: &[Rayon<R>],
    largeur: u32,
) -> Result<Mesure<R>, Box<dyn Error>> {
    let ordre = tuiles(rayons.len(), largeur as usize);
    let tuiles: Vec<_> = ordre.iter().map(|&i| rayons[i]).collect();
    // Twice the places that are needed, in case a scene has long askew boxes.
    let mut memoire = vec![0.0; 2 * places(objets.len())];
    let hierarchie = Monde::new(objets, &mut memoire)?;
    let facons: [Facon<'_, R>; 3] = [
        &|touches| {
            for (touche, rayon) in touches.iter_mut().zip(&tuiles) {
                *touche = premiere_intersection(objets, rayon);
            }
            Ok(())
        },
        &|touches| {
            for (touche, rayon) in touches.iter_mut().zip(&tuiles) {
                *touche = hierarchie.premiere_intersection(rayon);
            }
            Ok(())
        },
        &|touches| hierarchie.premieres_intersections(&tuiles, touches),
    ];
    let mut touches = [(); 3].map(|()| vec![Err(NoIntersection); rayons.len()]);
    let mut temps = [f64::INFINITY; 3];
    for _ in 0..3 {
        for ((facon, touches), temps) in facons.iter().zip(&mut touches).zip(&mut temps) {
            let debut = Instant::now();
            facon(touches)?;
            *temps = temps.min(debut.elapsed().as_secs_f64() * 1e9 / rayons.len() as f64);
        }
    }
    let [liste, autres @ ..] = touches;
    for (touches, facon) in autres.iter().zip(&FACONS[1..]) {
        if *touches != liste {
            return Err(format!("the {facon} has other hits than the list").into());
        }
    }
    let mut touches = liste.clone();
    for (i, touche) in ordre.into_iter().zip(liste) {
        touches[i] = touche;
    }
    Ok((touches, temps))
}

/// How far the answers in `f32` are from those in `f64`.
fn comparer(
    sortie: &mut impl Write,
    touches: &[Reponse],
    simples: &[Reponse<f32>],
) -> io::Result<()> {
    let mut autres = 0;
    let (mut distances, mut angles) = (vec![], vec![]);
    for paire in touches.iter().zip(simples) {
        match paire {
            (Ok(a), Ok(b)) if a.texture() == b.texture() => {
                distances.push((f64::from(b.distance()) / a.distance() - 1.0).abs());
                // By the chord, since the arc cosine of N·N' would see nothing below 1e-6 degrees.
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

/// The colour of the pixel of this index, unless nothing is seen there.
type Panneau<'a> = &'a dyn Fn(usize) -> Option<Couleur>;

/// The ends of the ramp of differences between `f32` and `f64`.
const PEU: f64 = 1e-9;
const BEAUCOUP: f64 = 1e-5;

/// The colour of an uncertain answer, unlike any ramp or texture.
const ALARME: Couleur = [255, 30, 30];

/// How far the mark of such a pixel reaches, so that a single one shows.
const MARQUE: usize = 4;

/// Writes the four panels side by side as a PNG.
fn peindre(
    chemin: &str,
    (largeur, hauteur): (u32, u32),
    rayons: &[Rayon],
    touches: &[Reponse],
    jugements: &[Jugement],
) -> Result<(), Box<dyn Error>> {
    let mut logs: Vec<f64> = touches.iter().flatten().map(|t| t.distance().ln()).collect();
    logs.sort_by(f64::total_cmp);
    // The ramp leaves out the ends, since one far horizon would flatten all the rest.
    let centile = |c: usize| logs.get(logs.len() * c / 100).copied().unwrap_or(0.0);
    let (pres, loin) = (centile(1), centile(97).max(centile(1) + 1e-9));
    let cote = largeur as usize;
    let mut marques = vec![false; jugements.len()];
    for i in (0..jugements.len()).filter(|&i| !jugements[i].certaine) {
        let autour = |x: usize, fin: usize| x.saturating_sub(MARQUE)..(x + MARQUE + 1).min(fin);
        for ligne in autour(i / cote, hauteur as usize) {
            let colonnes = autour(i % cote, cote);
            marques[ligne * cote + colonnes.start..ligne * cote + colonnes.end].fill(true);
        }
    }

    let normale = |i: usize| {
        let n = touches[i].ok()?.normale();
        Some(<[f64; 3]>::from(n).map(|x| (127.5 * (x + 1.0)).round() as u8))
    };
    let distance = |i: usize| {
        let t = touches[i].ok()?.distance();
        Some(rampe((t.ln() - pres) / (loin - pres)))
    };
    let texture = |i: usize| {
        let t = touches[i].ok()?;
        let face = -t.normale().produit_scalaire(rayons[i].direction());
        Some(teinte(t.texture().0, 0.35 + 0.65 * face))
    };
    let ecart = |i: usize| {
        let difference = |x: f64| rampe((BEAUCOUP / x).ln() / (BEAUCOUP / PEU).ln());
        if marques[i] { Some(ALARME) } else { jugements[i].ecart.map(difference) }
    };
    let panneaux: [Panneau<'_>; 4] = [&normale, &distance, &texture, &ecart];

    let mut pixels = Vec::with_capacity(4 * 3 * touches.len());
    for j in 0..hauteur as usize {
        let fond = fond(j as f64 / f64::from(hauteur));
        for panneau in panneaux {
            let ligne = j * cote..(j + 1) * cote;
            pixels.extend(ligne.flat_map(|i| panneau(i).unwrap_or(fond)));
        }
    }
    image::ecrire(chemin, (4 * largeur, hauteur), png::Compression::Fast, &pixels)
}

/// What is seen where nothing is hit: a dusk, from the top (0) to the bottom (1).
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

/// The colour of a texture under this light. Hues are a golden angle apart, in Oklab, so that neighbouring numbers
/// differ and none stands out.
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
