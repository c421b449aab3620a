//! What each part of one ray takes: the call, a half-space, the probe, a node, an object, the hit. Each part is the
//! difference between two scenes, one of which has the part more often, in nanoseconds and in instructions.
//! `cargo run --release -p banc --bin parties AVX2` prints `benches/mesures/parties.csv` for the instructions of that
//! name, in some seconds. valgrind counts the instructions, and knows no AVX-512.

use std::env::{args, current_exe};
use std::error::Error;
use std::hint::black_box;
use std::process::Command;

use banc::circonstances::Circonstances;
use banc::horloge::{chronometrer, moindres};
use banc::nous;
use lancer_rayon::{
    BoiteGeo, Monde, ObjetRay, PlanGeo, Rayon, Reel, Rotation, SphereGeo, Texture, Vecteur,
};

/// A part, the scenes that have it more often and less often, and how much more often.
const PARTIES: [(&str, usize, usize, f64); 11] = [
    ("call", 0, 0, 1.0),
    ("half-space passed by", 2, 1, 4.0),
    ("ball passed by in a list", 4, 3, 4.0),
    ("box passed by in a list", 6, 5, 4.0),
    ("ball entered in a list", 7, 0, 1.0),
    ("box entered in a list", 8, 0, 1.0),
    ("probe and one node", 9, 0, 1.0),
    ("another node", 13, 11, 2.0),
    ("ball passed by in its box", 10, 9, 4.0),
    ("ball entered in a tree", 11, 9, 1.0),
    ("box entered in a tree", 12, 9, 1.0),
];

const SCENES: usize = 14;
const RAYONS: usize = 4096;
const TOURS: usize = 60;

fn v<R: Reel>(x: f64, y: f64, z: f64) -> Vecteur<R> {
    Vecteur::depuis_f64(Vecteur::new(x, y, z))
}

fn boule<R: Reel>(centre: Vecteur<R>, rayon: f64) -> ObjetRay<R> {
    SphereGeo::new(centre, R::depuis_f64(rayon), Texture(0)).expect("within the limits").into()
}

fn boite<R: Reel>(centre: Vecteur<R>, cote: f64) -> ObjetRay<R> {
    let tour = Rotation::new(v(0.3, 0.2, 0.7)).expect("angles");
    BoiteGeo::new(centre, v(cote, cote, cote), tour, Texture(0)).expect("within the limits").into()
}

/// The objects of this scene. All rays enter the ball or box in front, and nothing else.
fn scene<R: Reel>(numero: usize) -> Vec<ObjetRay<R>> {
    let devant = v(0.0, 0.0, -9.0);
    let a_cote = |k: usize| v(0.0, 30.0 + k as f64, -9.0);
    let loin = |k: usize| boule(v(30.0 + (k % 7) as f64, 20.0 + (k / 7) as f64, 0.0), 0.3);
    // The rays enter its box, but not the ball.
    let au_coin = |k: usize| boule(v(2.0, 2.0, -9.0 - 3.0 * k as f64), 1.995);
    let derriere = || PlanGeo::par_un_point(devant, v(0.1, 0.2, -1.0), Texture(0));
    let murs = |n| (0..n).map(|_| derriere().expect("within the limits").into()).collect();
    match numero {
        1 => murs(1),
        2 => murs(5),
        3 => vec![boule(a_cote(0), 1.0)],
        4 => (0..5).map(|k| boule(a_cote(k), 1.0)).collect(),
        5 => vec![boite(a_cote(0), 1.0)],
        6 => (0..5).map(|k| boite(a_cote(k), 1.0)).collect(),
        7 => vec![boule(devant, 2.5)],
        8 => vec![boite(devant, 6.0)],
        9 => (0..16).map(loin).collect(),
        10 => (0..12).map(loin).chain((0..4).map(au_coin)).collect(),
        11 => (0..15).map(loin).chain([boule(devant, 2.5)]).collect(),
        12 => (0..15).map(loin).chain([boite(devant, 6.0)]).collect(),
        13 => (0..4095).map(loin).chain([boule(devant, 2.5)]).collect(),
        _ => Vec::new(),
    }
}

fn rayons<R: Reel>() -> Vec<Rayon<R>> {
    let pente = |k: usize| (k % 64) as f64 / 6400.0 + 0.001;
    let vers = |k: usize| v(pente(k), pente(k / 64), -1.0);
    (0..RAYONS).map(|k| Rayon::new(v(0.0, 0.0, 3.0), vers(k)).expect("a direction")).collect()
}

/// One question for each ray. valgrind finds this function by its name.
#[inline(never)]
fn demander<R: Reel>(monde: &Monde<'_, R>, rayons: &[Rayon<R>], ombres: bool) {
    if ombres {
        rayons.iter().for_each(|rayon| _ = black_box(monde.est_occulte(rayon)));
    } else {
        rayons.iter().for_each(|rayon| _ = black_box(&monde.premiere_intersection(rayon)));
    }
}

/// Asks this scene once, or returns what hits and shadows take, in nanoseconds a ray.
fn mesurer<R: Reel>(jeu: &str, numero: usize, une_fois: Option<bool>) -> [f64; 2] {
    let objets = scene::<R>(numero);
    let mut memoire = nous::memoire(1, objets.len());
    let (monde, rayons) = (nous::monde(&objets, &mut memoire, jeu), rayons());
    if let Some(ombres) = une_fois {
        demander(&monde, &rayons, ombres);
        return [0.0; 2];
    }
    let temps = moindres(TOURS, 2, |ombres| {
        chronometrer(&rayons, |rayons| demander(&monde, rayons, ombres == 1))
    });
    [temps[0], temps[1]]
}

/// The instructions of hits and of shadows in this scene, a ray.
fn compter(jeu: &str, numero: usize, scalaire: &str) -> Result<[f64; 2], Box<dyn Error>> {
    let mut nombres = [0.0; 2];
    for (ombres, nombre) in ["false", "true"].into_iter().zip(&mut nombres) {
        let sortie = Command::new("valgrind")
            .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
            .arg("--toggle-collect=parties::demander*")
            .arg(current_exe()?)
            .args([jeu, &numero.to_string(), scalaire, ombres])
            .output()?;
        let texte = String::from_utf8_lossy(&sortie.stderr).into_owned();
        let (_, reste) = texte.split_once("Collected : ").ok_or("callgrind counted nothing")?;
        let compte: f64 = reste.split_whitespace().next().unwrap_or_default().parse()?;
        *nombre = compte / RAYONS as f64;
    }
    Ok(nombres)
}

fn main() -> Result<(), Box<dyn Error>> {
    let mots: Vec<_> = args().skip(1).collect();
    let jeu = mots.first().map_or("", String::as_str);
    if let [jeu, numero, scalaire, ombres] = &mots[..] {
        let (numero, ombres) = (numero.parse()?, Some(ombres.parse()?));
        match scalaire.as_str() {
            "f32" => mesurer::<f32>(jeu, numero, ombres),
            _ => mesurer::<f64>(jeu, numero, ombres),
        };
        return Ok(());
    }
    // In nanoseconds and in instructions: hits and shadows in `f32`, and in `f64`.
    let mut scenes = Vec::new();
    for numero in 0..SCENES {
        let temps = [mesurer::<f32>(jeu, numero, None), mesurer::<f64>(jeu, numero, None)];
        let comptes = [compter(jeu, numero, "f32")?, compter(jeu, numero, "f64")?];
        scenes.push([temps.concat(), comptes.concat()]);
    }
    let circonstances = Circonstances::presentes().colonnes();
    let colonnes = ["f32_hit", "f32_shadow", "f64_hit", "f64_shadow"];
    let titres =
        ["ns", "instructions"].map(|quoi| colonnes.map(|c| format!("{c}_{quoi}")).join(","));
    println!("part,{},set,{}", titres.join(","), Circonstances::TITRES);
    for (partie, plus, moins, fois) in PARTIES {
        let case = |quoi: usize, colonne: usize| {
            let sans = if plus == moins { 0.0 } else { scenes[moins][quoi][colonne] };
            (scenes[plus][quoi][colonne] - sans) / fois
        };
        let ns = [0, 1, 2, 3].map(|colonne| format!("{:.1}", case(0, colonne))).join(",");
        let comptes = [0, 1, 2, 3].map(|colonne| format!("{:.0}", case(1, colonne))).join(",");
        println!("{partie},{ns},{comptes},{jeu},{circonstances}");
    }
    Ok(())
}
