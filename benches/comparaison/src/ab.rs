//! Two versions of this crate in one process, by turns: what `benches/ab.sh` runs. `avant` is the old one and
//! `lancer_rayon` the new one; both get the same rays and the same numbers for their objects.

use std::error::Error;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

use commun::familles::{Famille, Genre};
use commun::horloge::{MORCEAU, chronometrer_lot, moindres};
use lancer_rayon::{Hierarchie, ObjetRay, Reel};

use serde::de::DeserializeOwned;

/// The most rounds, and by how much a ratio may move in the last.
const MANCHES: usize = 6;
const BOUGE: f64 = 0.015;

/// Lists are asked up to so many objects.
const LISTE: usize = 64;

/// How a version is asked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Facon {
    Liste,
    ListeEnLot,
    Seul,
    Lot,
}

impl Facon {
    const TOUTES: [Self; 4] = [Self::Liste, Self::ListeEnLot, Self::Seul, Self::Lot];

    fn nom(self) -> &'static str {
        match self {
            Self::Liste => "list",
            Self::ListeEnLot => "list-batch",
            Self::Seul => "single",
            Self::Lot => "batch",
        }
    }
}

/// Every number of an object, as its getters give them.
enum Brut<R> {
    Sphere([R; 3], R),
    Plan([R; 3], R),
    Boite([R; 3], [[R; 3]; 3], [R; 3]),
}

/// Every number of an answer, exactly; a miss is `None`. Of a shadow: whether something is in the way.
type Reponse = Option<[u64; 6]>;

/// A version with a scene and rays.
trait Version {
    /// Nanoseconds a ray.
    fn chronometrer(&mut self, facon: Facon) -> f64;
    fn reponses(&mut self, facon: Facon) -> Vec<Reponse>;
}

/// Nanoseconds per question, one by one.
fn chronometrer<Q, T>(questions: &[Q], mut reponse: impl FnMut(&Q) -> T) -> f64 {
    let debut = Instant::now();
    for question in questions {
        // By reference: moving an answer would wait for each of its fields to be written.
        black_box(&reponse(question));
    }
    debut.elapsed().as_nanos() as f64 / questions.len() as f64
}

macro_rules! version {
    ($nom:ident, $version:ident) => {
        mod $nom {
            use ::$version::{
                BoiteGeo, Hierarchie, NoIntersection, ObjetRay, PlanGeo, Rayon, Reel, Reglage,
                Rotation, SphereGeo, Texture, Touche, Vecteur, est_occulte, premiere_intersection,
                premieres_intersections, sont_occultes,
            };

            use super::*;

            struct Pret<'a, R> {
                hierarchie: Hierarchie<'a, R>,
                rayons: Vec<Rayon<R>>,
                /// The same with the distance of each lamp; none unless they are shadows.
                ombres: Vec<(Rayon<R>, R)>,
            }

            fn objet<R: Reel>(brut: &Brut<R>, i: usize) -> ObjetRay<R> {
                let texture = Texture(i as u32);
                match *brut {
                    Brut::Sphere(c, r) => SphereGeo::new(c.into(), r, texture).unwrap().into(),
                    Brut::Plan(n, d) => {
                        let plan = PlanGeo::par_un_point(Vecteur::NUL, n.into(), texture).unwrap();
                        plan.translation(-Vecteur::from(n) * d).unwrap().into()
                    }
                    Brut::Boite(c, normales, demi) => {
                        let rotation = Rotation::depuis_matrice(normales).unwrap();
                        let dimensions = demi.map(|x| x + x).into();
                        BoiteGeo::new(c.into(), dimensions, rotation, texture).unwrap().into()
                    }
                }
            }

            /// Prepares this version and hands it to `suite`.
            pub(super) fn avec<R: Reel, T>(
                bruts: &[Brut<R>],
                rayons: &[([R; 3], [R; 3], R)],
                jeu: &str,
                ombres: bool,
                suite: impl FnOnce(&mut dyn Version) -> T,
            ) -> T {
                let objets: Vec<_> =
                    bruts.iter().enumerate().map(|(i, brut)| objet(brut, i)).collect();
                let mut places = vec![0.0; Hierarchie::places(objets.len())];
                let hierarchie = Hierarchie::new(&objets, &mut places).unwrap();
                let reglage = Reglage::tous().find(|(nom, _)| jeu == *nom);
                let hierarchie = match reglage {
                    Some((_, reglage)) => reglage.hierarchie(hierarchie),
                    None => hierarchie,
                };
                let lances: Vec<_> = rayons
                    .iter()
                    .map(|(s, d, max)| (Rayon::new((*s).into(), (*d).into()).unwrap(), *max))
                    .collect();
                let rayons = lances.iter().map(|(rayon, _)| *rayon).collect();
                let ombres = if ombres { lances } else { vec![] };
                suite(&mut Pret { hierarchie, rayons, ombres })
            }

            impl<R: Reel> Version for Pret<'_, R> {
                fn chronometrer(&mut self, facon: Facon) -> f64 {
                    let Self { hierarchie, rayons, ombres } = self;
                    let objets = hierarchie.objets();
                    let mut touches = vec![Err(NoIntersection); MORCEAU];
                    let mut caches = vec![false; MORCEAU];
                    match (facon, ombres.is_empty()) {
                        (Facon::Liste, true) => {
                            chronometrer(rayons, |rayon| premiere_intersection(objets, rayon))
                        }
                        (Facon::Seul, true) => {
                            chronometrer(rayons, |rayon| hierarchie.premiere_intersection(rayon))
                        }
                        (Facon::ListeEnLot | Facon::Lot, true) => {
                            chronometrer_lot(rayons, &mut touches, |rayons, touches| {
                                toucher(hierarchie, facon, rayons, touches);
                            })
                        }
                        (Facon::Liste, false) => {
                            chronometrer(ombres, |(rayon, max)| est_occulte(objets, rayon, *max))
                        }
                        (Facon::Seul, false) => {
                            chronometrer(ombres, |(rayon, max)| hierarchie.est_occulte(rayon, *max))
                        }
                        (Facon::ListeEnLot | Facon::Lot, false) => {
                            chronometrer_lot(ombres, &mut caches, |ombres, caches| {
                                occulter(hierarchie, facon, ombres, caches);
                            })
                        }
                    }
                }

                fn reponses(&mut self, facon: Facon) -> Vec<Reponse> {
                    let Self { hierarchie, rayons, ombres } = self;
                    if ombres.is_empty() {
                        let mut touches = vec![Err(NoIntersection); rayons.len()];
                        toucher(hierarchie, facon, rayons, &mut touches);
                        touches.iter().map(reponse).collect()
                    } else {
                        let mut caches = vec![false; ombres.len()];
                        occulter(hierarchie, facon, ombres, &mut caches);
                        caches.into_iter().map(|cache| cache.then_some([0; 6])).collect()
                    }
                }
            }

            /// The first object of each ray, asked in this way.
            fn toucher<R: Reel>(
                hierarchie: &Hierarchie<'_, R>,
                facon: Facon,
                rayons: &[Rayon<R>],
                touches: &mut [Touche<R>],
            ) {
                let objets = hierarchie.objets();
                match facon {
                    Facon::Liste => {
                        for (touche, rayon) in touches.iter_mut().zip(rayons) {
                            *touche = premiere_intersection(objets, rayon);
                        }
                    }
                    Facon::Seul => {
                        for (touche, rayon) in touches.iter_mut().zip(rayons) {
                            *touche = hierarchie.premiere_intersection(rayon);
                        }
                    }
                    Facon::ListeEnLot => premieres_intersections(objets, rayons, touches).unwrap(),
                    Facon::Lot => hierarchie.premieres_intersections(rayons, touches).unwrap(),
                }
            }

            /// Whether anything stands before the lamp of each, asked in this way.
            fn occulter<R: Reel>(
                hierarchie: &Hierarchie<'_, R>,
                facon: Facon,
                ombres: &[(Rayon<R>, R)],
                caches: &mut [bool],
            ) {
                let objets = hierarchie.objets();
                match facon {
                    Facon::Liste => {
                        for (cache, (rayon, max)) in caches.iter_mut().zip(ombres) {
                            *cache = est_occulte(objets, rayon, *max);
                        }
                    }
                    Facon::Seul => {
                        for (cache, (rayon, max)) in caches.iter_mut().zip(ombres) {
                            *cache = hierarchie.est_occulte(rayon, *max);
                        }
                    }
                    Facon::ListeEnLot => sont_occultes(objets, ombres, caches).unwrap(),
                    Facon::Lot => hierarchie.sont_occultes(ombres, caches).unwrap(),
                }
            }

            fn reponse<R: Reel>(touche: &Touche<R>) -> Reponse {
                let touche = touche.ok()?;
                let n = touche.normale();
                let [t, x, y, z, marge] = [touche.distance(), n.x, n.y, n.z, touche.marge()]
                    .map(|x| x.vers_f64().to_bits());
                Some([t, x, y, z, marge, touche.objet() as u64])
            }
        }
    };
}

version! { ancienne, avant }
version! { nouvelle, lancer_rayon }

fn brut<R: Reel>(objet: &ObjetRay<R>) -> Brut<R> {
    match objet {
        ObjetRay::Sphere(s) => Brut::Sphere(s.centre().into(), s.rayon()),
        ObjetRay::Plan(p) => Brut::Plan(p.normale().into(), p.distance()),
        ObjetRay::Boite(b) => {
            Brut::Boite(b.centre().into(), b.normales().map(Into::into), b.demi_longueurs())
        }
    }
}

/// What is asked for on the command line.
struct Choix {
    familles: Vec<Famille>,
    nombres: Vec<usize>,
    scalaires: Vec<String>,
    genres: Vec<Genre>,
    facons: Vec<Facon>,
    jeu: String,
    bandes: usize,
    tours: usize,
    temps: bool,
}

impl Choix {
    fn lire() -> Result<Self, Box<dyn Error>> {
        let mut choix = Self {
            familles: Famille::TOUTES.into(),
            nombres: vec![12, 48, 192, 1000, 10_000],
            scalaires: vec!["f32".into(), "f64".into()],
            genres: Genre::TOUS.into(),
            facons: Facon::TOUTES.into(),
            jeu: String::new(),
            bandes: 8,
            tours: 4,
            temps: false,
        };
        let mut arguments = std::env::args().skip(1);
        while let Some(option) = arguments.next() {
            if option == "--ns" {
                choix.temps = true;
                continue;
            }
            let valeurs = arguments.next().ok_or_else(|| format!("{option} of what?"))?;
            match option.as_str() {
                "--family" => choix.familles = parmi(&valeurs, &Famille::TOUTES, Famille::nom)?,
                "--rays" => choix.genres = parmi(&valeurs, &Genre::TOUS, Genre::nom)?,
                "--way" => choix.facons = parmi(&valeurs, &Facon::TOUTES, Facon::nom)?,
                "--scalar" => choix.scalaires = valeurs.split(',').map(Into::into).collect(),
                "--n" => {
                    choix.nombres = valeurs.split(',').map(str::parse).collect::<Result<_, _>>()?
                }
                "--set" => choix.jeu = valeurs,
                "--bands" => choix.bandes = valeurs.parse()?,
                "--turns" => choix.tours = valeurs.parse()?,
                _ => return Err(format!("no option {option}; benches/ab.sh --help").into()),
            }
        }
        Ok(choix)
    }
}

/// Those of a list separated by commas.
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

/// What one cell of the table was measured to be.
struct Cellule {
    nom: String,
    genre: Genre,
    facon: Facon,
    rapport: f64,
    /// Rays that the two versions answer differently, in any bit.
    autres: usize,
}

fn main() -> Result<(), Box<dyn Error>> {
    let choix = Choix::lire()?;
    let titres: Vec<_> = choix.genres.iter().map(|genre| format!("{:>11}", genre.nom())).collect();
    println!("time, new over old{}", if choix.temps { ", and the old in ns a ray" } else { "" });
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

/// Every kind of ray and every way of one scene: a line a way.
fn mesurer<R: Reel + avant::Reel + DeserializeOwned>(
    choix: &Choix,
    famille: Famille,
    n: usize,
    scalaire: &str,
    cellules: &mut Vec<Cellule>,
) -> Result<(), Box<dyn Error>> {
    let docs = Path::new(env!("DOCS"));
    let scene = famille.scene::<R>(n, docs);
    let mut places = vec![0.0; Hierarchie::places(n)];
    let hierarchie = Hierarchie::new(&scene.objets, &mut places)?;
    let bruts: Vec<_> = scene.objets.iter().map(brut).collect();
    let permise = |facon: &&Facon| n <= LISTE || matches!(facon, Facon::Seul | Facon::Lot);
    let facons: Vec<_> = choix.facons.iter().filter(permise).copied().collect();
    let mut lignes = vec![String::new(); facons.len()];
    for &genre in &choix.genres {
        let rayons = genre.rayons(&hierarchie, &scene, choix.bandes).into_iter();
        let rayons: Vec<_> =
            rayons.map(|(r, max)| (r.source().into(), r.direction().into(), max)).collect();
        let ombres = genre == Genre::Ombres;
        let mesures = ancienne::avec(&bruts, &rayons, &choix.jeu, ombres, |avant| {
            nouvelle::avec(&bruts, &rayons, &choix.jeu, ombres, |apres| {
                let attendues = apres.reponses(facons[0]);
                facons
                    .iter()
                    .map(|&facon| {
                        let [anciennes, nouvelles] = [avant.reponses(facon), apres.reponses(facon)];
                        if nouvelles != attendues {
                            println!("the ways of the new version differ: {}", facon.nom());
                        }
                        let autres =
                            anciennes.iter().zip(&nouvelles).filter(|(a, b)| a != b).count();
                        let ns = posees(choix.tours, |nouveau| {
                            if nouveau {
                                apres.chronometrer(facon)
                            } else {
                                avant.chronometrer(facon)
                            }
                        });
                        (facon, ns[0], ns[1] / ns[0], autres)
                    })
                    .collect::<Vec<_>>()
            })
        });
        for (ligne, (facon, ns, rapport, autres)) in lignes.iter_mut().zip(mesures) {
            let temps = if choix.temps { format!(" {ns:4.0}") } else { String::new() };
            let marque = if autres > 0 { "!" } else { " " };
            ligne.push_str(&format!("{:>11}", format!("{rapport:.2}{marque}{temps}")));
            let nom = format!("{} {n} {scalaire} {} {}", famille.nom(), facon.nom(), genre.nom());
            cellules.push(Cellule { nom, genre, facon, rapport, autres });
        }
    }
    for (ligne, facon) in lignes.iter().zip(&facons) {
        println!("{:<32}{ligne}", format!("{} {n} {scalaire} {}", famille.nom(), facon.nom()));
    }
    Ok(())
}

/// The least times of the old and of the new, in rounds of so many turns, until a round no longer moves their
/// ratio: another program that took the processor is not taken for a difference.
fn posees(tours: usize, mut duree: impl FnMut(bool) -> f64) -> [f64; 2] {
    let mut ns = [f64::INFINITY; 2];
    let mut rapport = f64::NAN;
    for _ in 0..MANCHES {
        let manche = moindres(tours, &[false, true], |nouveau| duree(*nouveau));
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
    // Lists of many objects are not asked.
    let posees = |facon: &&Facon| cellules.iter().any(|c| c.facon == **facon);
    for facon in choix.facons.iter().filter(posees) {
        let moyenne = |genre: &Genre| {
            let choisies = cellules.iter().filter(|c| c.facon == *facon && c.genre == *genre);
            let (somme, nombre) =
                choisies.fold((0.0, 0.0), |(s, n), c| (s + c.rapport.ln(), n + 1.0));
            format!("{:>10.3} ", (somme / nombre).exp())
        };
        let moyennes: Vec<_> = choix.genres.iter().map(moyenne).collect();
        println!("{:<32}{}", format!("geometric mean, {}", facon.nom()), moyennes.join(""));
    }
    cellules.sort_by(|a, b| a.rapport.total_cmp(&b.rapport));
    let extremes = |cellules: &mut dyn Iterator<Item = &Cellule>| {
        for c in cellules.take(8) {
            println!("    {:.2}  {}", c.rapport, c.nom);
        }
    };
    println!("best");
    extremes(&mut cellules.iter());
    println!("worst");
    extremes(&mut cellules.iter().rev());
    let autres: Vec<_> = cellules.iter().filter(|c| c.autres > 0).collect();
    println!("{} of {} cells with other answers (!)", autres.len(), cellules.len());
    for c in autres.iter().take(8) {
        println!("    {} rays  {}", c.autres, c.nom);
    }
}
