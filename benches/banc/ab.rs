//! Two versions of this crate in one process, by turns, as `benches/ab.sh` runs them. `avant` is the old one and
//! `lancer_rayon` the new one. Both get the same rays and the same numbers for their objects.

use std::error::Error;

use banc::concurrents::{Concurrent, FACONS, permises};
use banc::familles::{Famille, Genre};
use banc::horloge::{MORCEAU, moindres};
use banc::nous;
use exemples::scene::Lisible;
use lancer_rayon::{ObjetRay, Rayon, Reel};

#[path = "."]
#[allow(unreachable_pub, reason = "`nous` is a module of the library too, public there")]
mod ancienne {
    #[cfg(not(feature = "seule"))]
    pub use avant as version;
    pub use banc::concurrents;
    #[cfg(feature = "seule")]
    pub use lancer_rayon as version;
    pub mod nous;
}
use ancienne::version as avant;

/// How many rounds there are at most, and how far a ratio may move in the last.
const MANCHES: usize = 6;
const BOUGE: f64 = 0.015;

/// What is asked for on the command line.
struct Choix {
    familles: Vec<Famille>,
    nombres: Vec<usize>,
    scalaires: Vec<String>,
    genres: Vec<Genre>,
    facons: Vec<&'static str>,
    jeu: String,
    graine: u64,
    bandes: usize,
    tours: usize,
    appel: usize,
    /// How many times the places that a tree needs are lent to the old version, and to the new.
    places: [usize; 2],
    temps: bool,
    sur: bool,
}

impl Choix {
    fn lire() -> Result<Self, Box<dyn Error>> {
        let mut choix = Self {
            familles: Famille::TOUTES.into(),
            nombres: vec![3, 12, 48, 192, 1000, 10_000],
            scalaires: vec!["f32".into(), "f64".into()],
            genres: Genre::TOUS.into(),
            facons: FACONS.map(|(nom, _)| nom).into(),
            jeu: String::new(),
            graine: 1,
            bandes: 8,
            tours: 4,
            appel: MORCEAU,
            places: [2; 2],
            temps: false,
            sur: false,
        };
        let mut arguments = std::env::args().skip(1);
        while let Some(option) = arguments.next() {
            if option == "--ns" {
                choix.temps = true;
                continue;
            }
            if option == "--over" {
                choix.sur = true;
                continue;
            }
            let valeurs = arguments.next().ok_or_else(|| format!("{option} of what?"))?;
            match option.as_str() {
                "--family" => choix.familles = parmi(&valeurs, &Famille::TOUTES, Famille::nom)?,
                "--rays" => choix.genres = parmi(&valeurs, &Genre::TOUS, Genre::nom)?,
                "--way" => choix.facons = parmi(&valeurs, &choix.facons, |nom| nom)?,
                "--scalar" => choix.scalaires = valeurs.split(',').map(Into::into).collect(),
                "--n" => {
                    choix.nombres = valeurs.split(',').map(str::parse).collect::<Result<_, _>>()?
                }
                "--set" => choix.jeu = valeurs,
                "--seed" => choix.graine = valeurs.parse()?,
                "--bands" => choix.bandes = valeurs.parse()?,
                "--turns" => choix.tours = valeurs.parse()?,
                "--places" => {
                    let (ancien, nouveau) = valeurs.split_once(':').unwrap_or((&valeurs, &valeurs));
                    choix.places = [ancien.parse()?, nouveau.parse()?];
                    if choix.places.contains(&0) {
                        return Err("--places 1 is the least that a tree needs".into());
                    }
                }
                "--call" => choix.appel = valeurs.parse::<usize>()?.clamp(1, MORCEAU),
                _ => return Err(format!("no option {option}; benches/ab.sh --help").into()),
            }
        }
        if choix.sur {
            choix.facons.retain(|facon| facon.ends_with("batch"));
        }
        Ok(choix)
    }
}

/// The values named in a list with commas.
fn parmi<T: Copy>(
    valeurs: &str,
    tous: &[T],
    nom: impl Fn(T) -> &'static str,
) -> Result<Vec<T>, String> {
    let un = |valeur: &str| {
        let noms = || tous.iter().map(|t| nom(*t)).collect::<Vec<_>>().join(", ");
        tous.iter()
            .copied()
            .find(|t| nom(*t) == valeur)
            .ok_or_else(|| format!("{valeur} is none of {}", noms()))
    };
    valeurs.split(',').map(un).collect()
}

/// The measurement of one cell of the table.
struct Cellule {
    nom: String,
    genre: Genre,
    facon: &'static str,
    rapport: f64,
    /// How many rays the two versions answer differently, in any bit.
    autres: usize,
}

fn main() -> Result<(), Box<dyn Error>> {
    let choix = Choix::lire()?;
    let titres: Vec<_> = choix.genres.iter().map(|genre| format!("{:>12}", genre.nom())).collect();
    let de = if choix.sur { "one by one over batch" } else { "new over old" };
    println!(
        "time, {de}{}",
        if choix.temps { ", and the ns a ray of old or one by one" } else { "" }
    );
    println!("{:<32}{}", "family, N, scalar, way", titres.join(""));
    let mut cellules = Vec::new();
    for famille in &choix.familles {
        for n in famille.nombres(&choix.nombres) {
            for scalaire in &choix.scalaires {
                match scalaire.as_str() {
                    "f32" => mesurer::<f32>(&choix, *famille, *n, "f32", &mut cellules)?,
                    "f64" => mesurer::<f64>(&choix, *famille, *n, "f64", &mut cellules)?,
                    _ => return Err("--scalar f32,f64".into()),
                }
            }
        }
    }
    resumer(&choix, cellules);
    Ok(())
}

/// The same object in the old version.
fn ancien<R: Reel + avant::Reel>(objet: &ObjetRay<R>) -> avant::ObjetRay<R> {
    use avant::{BoiteGeo, PlanGeo, Rotation, SphereGeo, Texture, Vecteur};
    let vecteur = |v: lancer_rayon::Vecteur<R>| Vecteur::from(<[R; 3]>::from(v));
    let texture = Texture(objet.texture().0);
    let objet: Result<avant::ObjetRay<R>, avant::ErreurGeo> = match objet {
        ObjetRay::Sphere(s) => {
            SphereGeo::new(vecteur(s.centre()), s.rayon(), texture).map(Into::into)
        }
        ObjetRay::Plan(p) => {
            let pied = vecteur(p.normale() * -p.distance());
            let plan = PlanGeo::par_un_point(Vecteur::NUL, vecteur(p.normale()), texture);
            plan.and_then(|plan| plan.translation(pied)).map(Into::into)
        }
        ObjetRay::Boite(b) => Rotation::depuis_matrice(b.normales().map(Into::into))
            .and_then(|rotation| {
                let dimensions = b.demi_longueurs().map(|x| x + x).into();
                BoiteGeo::new(vecteur(b.centre()), dimensions, rotation, texture)
            })
            .map(Into::into),
    };
    objet.expect("an object within the limits")
}

/// Every kind of ray and every way for one scene, with a line for each way.
fn mesurer<R: Lisible + avant::Reel>(
    choix: &Choix,
    famille: Famille,
    n: usize,
    scalaire: &str,
    cellules: &mut Vec<Cellule>,
) -> Result<(), Box<dyn Error>> {
    let scene = famille.scene::<R>(n, choix.graine);
    let anciens: Vec<_> = scene.objets.iter().map(ancien).collect();
    let mut ancienne_memoire = ancienne::nous::memoire(choix.places[0], n);
    let mut memoire = nous::memoire(choix.places[1], n);
    let ancien_monde = ancienne::nous::monde(&anciens, &mut ancienne_memoire, &choix.jeu);
    let monde = nous::monde(&scene.objets, &mut memoire, &choix.jeu);
    let permises = permises(n).iter().map(|(nom, _)| *nom).filter(|nom| choix.facons.contains(nom));
    let mut lignes: Vec<_> = permises.map(|nom| (nom, String::new())).collect();
    for &genre in &choix.genres {
        // Made once, so that both versions get the same numbers.
        let lances = genre.rayons(&monde, &scene, choix.bandes);
        if lances.is_empty() {
            // Where nothing is hit no ray starts.
            for (_, ligne) in &mut lignes {
                ligne.push_str(&format!("{:>12}", "– "));
            }
            continue;
        }
        let nombres = |rayon: &Rayon<R>| {
            ([rayon.source().into(), rayon.direction().into()], [rayon.fin(), rayon.flou()])
        };
        let anciens_rayons = ancienne::nous::rayons(lances.iter().map(nombres));
        let rayons = nous::rayons(lances.iter().map(nombres));
        let nouveaux = nous::concurrents(monde, &rayons, genre.ombres());
        let temoins = if choix.sur {
            // Each batch is beside its rays one by one, in the same memory: over a second copy of a million objects
            // they take up to 1.12 of the time.
            let [liste, en_lot, un_par_un, lot] = nous::concurrents(monde, &rayons, genre.ombres());
            [en_lot, liste, lot, un_par_un]
        } else {
            ancienne::nous::concurrents(ancien_monde, &anciens_rayons, genre.ombres())
        };
        let attendues = nouveaux[2].reponses();
        for (avant, apres) in temoins.into_iter().zip(nouveaux) {
            let facon = apres.nom;
            let Some((_, ligne)) = lignes.iter_mut().find(|(nom, _)| *nom == facon) else {
                continue;
            };
            let nouvelles = apres.reponses();
            if nouvelles != attendues {
                println!("the ways of the new version differ: {facon}");
            }
            let autres = avant.reponses().iter().zip(&nouvelles).filter(|(a, b)| a != b).count();
            let [ns, nouveau] = posees(choix, [avant, apres]);
            let rapport = if choix.sur { ns / nouveau } else { nouveau / ns };
            let temps = if choix.temps { format!(" {ns:4.0}") } else { String::new() };
            let marque = if autres > 0 { "!" } else { " " };
            ligne.push_str(&format!("{:>12}", format!("{rapport:.2}{marque}{temps}")));
            let nom = format!("{} {n} {scalaire} {facon} {}", famille.nom(), genre.nom());
            cellules.push(Cellule { nom, genre, facon, rapport, autres });
        }
    }
    for (facon, ligne) in lignes {
        println!("{:<32}{ligne}", format!("{} {n} {scalaire} {facon}", famille.nom()));
    }
    Ok(())
}

/// The least times of the old and of the new, in rounds of `choix.tours` turns, until a round no longer moves their
/// ratio, so that another program that took the processor is not taken for a difference.
fn posees(choix: &Choix, mut versions: [Concurrent<'_>; 2]) -> [f64; 2] {
    let mut ns = [f64::INFINITY; 2];
    let mut rapport = f64::NAN;
    for _ in 0..MANCHES {
        let manche = moindres(choix.tours, 2, |i| versions[i].chronometrer(choix.appel));
        ns = [ns[0].min(manche[0]), ns[1].min(manche[1])];
        let dernier = std::mem::replace(&mut rapport, ns[1] / ns[0]);
        if (rapport / dernier - 1.0).abs() < BOUGE {
            break;
        }
    }
    ns
}

/// The geometric means of each way and kind, the extremes, and which answers differ.
fn resumer(choix: &Choix, mut cellules: Vec<Cellule>) {
    println!();
    // Lists of many objects are not measured.
    let posees = |facon: &&&str| cellules.iter().any(|c| c.facon == **facon);
    for facon in choix.facons.iter().filter(posees) {
        let moyenne = |genre: &Genre| {
            let choisies = cellules.iter().filter(|c| c.facon == *facon && c.genre == *genre);
            let (somme, nombre) =
                choisies.fold((0.0, 0.0), |(s, n), c| (s + c.rapport.ln(), n + 1.0));
            format!("{:>11.3} ", (somme / nombre).exp())
        };
        let moyennes: Vec<_> = choix.genres.iter().map(moyenne).collect();
        println!("{:<32}{}", format!("geometric mean, {facon}"), moyennes.join(""));
    }
    cellules.sort_by(|a, b| a.rapport.total_cmp(&b.rapport));
    let extremes = |cellules: &mut dyn Iterator<Item = &Cellule>| {
        for c in cellules.take(8) {
            println!("    {:.2}  {}", c.rapport, c.nom);
        }
    };
    // The cells that lose a tenth and two fifths.
    let ([a, b], ou) =
        if choix.sur { ([1.0 / 1.1, 1.0 / 1.4], "under") } else { ([1.1, 1.4], "over") };
    let perdue = |x: f64, seuil| if choix.sur { x < seuil } else { x > seuil };
    let perdues = |seuil| cellules.iter().filter(|c| perdue(c.rapport, seuil)).count();
    let [un_dixieme, deux_cinquiemes] = [a, b].map(perdues);
    let moyenne = cellules.iter().map(|c| c.rapport.ln()).sum::<f64>() / cellules.len() as f64;
    println!(
        "of {} cells the mean is {:.2}, {un_dixieme} {ou} {a:.2}, {deux_cinquiemes} {ou} {b:.2}",
        cellules.len(),
        moyenne.exp()
    );
    println!("least");
    extremes(&mut cellules.iter());
    println!("highest");
    extremes(&mut cellules.iter().rev());
    let autres: Vec<_> = cellules.iter().filter(|c| c.autres > 0).collect();
    println!("{} of {} cells with other answers (!)", autres.len(), cellules.len());
    for c in autres.iter().take(8) {
        println!("    {} rays  {}", c.autres, c.nom);
    }
}
