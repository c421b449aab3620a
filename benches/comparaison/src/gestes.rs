//! What each call takes that a program makes once a ray, a hit or an object, compiled in a crate other than that of the
//! call, at Cargo's default profile.

use std::hint::black_box;
use std::ops::ControlFlow::Continue;
use std::time::Instant;

use banc::horloge::{MORCEAU, moindres};
use banc::image::{LAMPE, objets};
use commun::conversion::arrondi;
use commun::scenes::rayons_camera;
use lancer_rayon::{
    BoiteRay, Intersection, Lumiere, Monde, ObjetGeo, ObjetRay, Rayon, Rotation, Vecteur, places,
};

use recettes::milieux::{Derriere, Marche, Matiere};

use crate::autres::Scalaire;
use crate::tables::nanosecondes;

const TOURS: usize = 40;

/// A call, by the name of the crate, and its nanoseconds.
type Appel = (&'static str, f64);

/// A row for each call.
pub(crate) fn mesurer() -> Vec<String> {
    let (simples, doubles) = (appels::<f32>(), appels::<f64>());
    let lignes = simples.into_iter().zip(doubles).map(|((nom, simple), (_, double))| {
        format!("{nom},{},{}", nanosecondes(simple), nanosecondes(double))
    });
    std::iter::once("call,f32_ns,f64_ns".to_owned()).chain(lignes).collect()
}

/// The file as a table of a page.
pub(crate) fn tableau(lignes: &[String]) -> String {
    let lignes = lignes[1..].iter().map(|ligne| {
        let (nom, temps) = ligne.rsplit_once(',').and_then(|(a, double)| {
            let (nom, simple) = a.rsplit_once(',')?;
            Some((nom, [simple, double]))
        })?;
        Some(format!("| `{}` | {} |", nom.trim_matches('"'), temps.join(" | ")))
    });
    let titres = "| call | `f32`: ns | `f64`: ns |\n|---|--:|--:|".to_owned();
    std::iter::once(titres).chain(lignes.flatten()).collect::<Vec<_>>().join("\n")
}

fn appels<R: Scalaire>() -> Vec<Appel> {
    let objets = objets(40);
    let prets: Vec<ObjetRay<R>> =
        objets.iter().map(|o| o.vers(Vecteur::NUL).expect("within limits").vers_ray()).collect();
    let mut memoire = vec![0.0; places(prets.len())];
    let monde = Monde::new(&prets, &mut memoire).expect("as many places as it takes");
    let rayons: Vec<Rayon<R>> = rayons_camera(600, 400).into_iter().step_by(16).collect();
    let touchee = |rayon: &Rayon<R>| Some((*rayon, monde.premiere_intersection(rayon).ok()?));
    let touches: Vec<_> = rayons.iter().filter_map(touchee).take(MORCEAU).collect();
    let vers = |(rayon, touche): &(Rayon<R>, Intersection<R>)| {
        (rayon.source(), touche.point() - rayon.source())
    };
    let segments: Vec<_> = touches.iter().map(vers).collect();
    let boites: Vec<_> = prets.iter().filter_map(boite).collect();
    let sur = |boite: &BoiteRay<R>| {
        let objet = ObjetRay::from(*boite);
        let rayon =
            Rayon::new(boite.centre() + Vecteur::Z * R::depuis_f64(9.0), -Vecteur::Z).ok()?;
        Some((*boite, objet, rayon, objet.intersection(&rayon).ok()?))
    };
    let sur: Vec<_> = boites.iter().filter_map(sur).collect();
    let dedans: Vec<_> = sur
        .iter()
        .filter_map(|(_, objet, rayon, touche)| {
            Some((*objet, touche.secondaire(rayon.direction()).ok()?))
        })
        .collect();
    let tour: Rotation<R> = Rotation::new(arrondi(Vecteur::new(0.1, 0.2, 0.3))).expect("finite");
    let (lampe, un) = (arrondi::<R>(LAMPE.into()), R::UN);
    let lumiere = Lumiere::lampe(lampe).expect("finite");
    let [refraction, loin] = [0.7, 4.0].map(R::depuis_f64);
    vec![
        ("Rayon::new", chacun(&segments, |(s, d)| Rayon::new(*s, *d).ok())),
        ("Rayon::entre", chacun(&segments, |(s, d)| Rayon::entre(*s, *s + *d).ok())),
        ("Rayon::jusqu_a", chacun(&rayons, |rayon| rayon.jusqu_a(loin).ok())),
        ("Rayon::bifurque", chacun(&rayons, |rayon| rayon.bifurque(un, Vecteur::X).ok())),
        ("Rotation::appliquer", chacun(&segments, |(_, d)| tour.appliquer(*d))),
        (
            "Intersection::secondaire",
            chacun(&touches, |(rayon, touche)| touche.secondaire(-rayon.direction()).ok()),
        ),
        (
            "Intersection::reflechi",
            chacun(&touches, |(rayon, touche)| touche.reflechi(rayon.direction()).ok()),
        ),
        (
            "Intersection::refracte",
            chacun(&touches, |(rayon, touche)| touche.refracte(rayon.direction(), refraction).ok()),
        ),
        (
            "Intersection::vers_lumiere",
            chacun(&touches, |(_, touche)| touche.vers_lumiere(lampe).ok()),
        ),
        (
            "Intersection::vers_soleil",
            chacun(&touches, |(_, touche)| touche.vers_soleil(lampe).ok()),
        ),
        ("Monde::eclairement", chacun(&touches, |(_, touche)| monde.eclairement(touche, &lumiere))),
        ("BoiteRay::lieu", chacun(&sur, |(boite, _, rayon, touche)| boite.lieu(rayon, touche))),
        ("ObjetRay::sortie", chacun(&dedans, |(objet, rayon)| objet.sortie(rayon).ok())),
        ("ObjetRay::traversee", chacun(&sur, |(_, objet, rayon, _)| objet.traversee(rayon).ok())),
        ("milieux::Marche, a surface", une_surface(&monde, &rayons)),
        ("ObjetRay::contient", chacun(&sur, |(_, objet, rayon, _)| objet.contient(rayon.source()))),
        ("Monde::visiter", chacun(&rayons, |rayon| visites(&monde, rayon))),
        ("Monde::contient", chacun(&segments, |(s, d)| monde.contient(*s + *d))),
        ("ObjetGeo::translation", chacun(&objets, |objet| objet.translation(Vecteur::X).ok())),
        ("ObjetGeo::rotation", chacun(&objets, |objet| objet.rotation(Rotation::IDENTITE).ok())),
        ("ObjetGeo::vers_ray", chacun(&objets, |objet| pret::<R>(objet))),
    ]
}

fn boite<R: Scalaire>(objet: &ObjetRay<R>) -> Option<BoiteRay<R>> {
    match objet {
        ObjetRay::Boite(boite) => Some(*boite),
        ObjetRay::Sphere(_) | ObjetRay::Plan(_) => None,
    }
}

fn pret<R: Scalaire>(objet: &ObjetGeo) -> Option<ObjetRay<R>> {
    Some(objet.vers(Vecteur::NUL).ok()?.vers_ray())
}

/// A walk through media that fill all balls and boxes, over a floor: what it takes from surface to surface.
fn une_surface<R: Scalaire>(monde: &Monde<'_, R>, rayons: &[Rayon<R>]) -> f64 {
    let pleine = Matiere::Pleine { priorite: 0, indice: 1.5 };
    let matieres: Vec<_> = std::iter::once(Matiere::Opaque).chain(vec![pleine; 40]).collect();
    let mut marche = Marche::new(*monde, &matieres);
    let mut surfaces = 0;
    let ns = moindres(TOURS, 1, |_| {
        surfaces = 0;
        let debut = Instant::now();
        for rayon in rayons.iter().step_by(16) {
            marche.partir(*rayon);
            for _ in 0..20 {
                let Ok(Some(surface)) = marche.avancer(R::INFINI) else { break };
                surfaces += 1;
                if surface.derriere == Derriere::Opaque || marche.passer(&surface).is_err() {
                    break;
                }
            }
        }
        debut.elapsed().as_nanos() as f64 / f64::from(surfaces)
    });
    ns[0]
}

fn visites<R: Scalaire>(monde: &Monde<'_, R>, rayon: &Rayon<R>) -> usize {
    let mut nombre = 0;
    monde.visiter(rayon, |_, _| {
        nombre += 1;
        Continue(rayon.fin())
    });
    nombre
}

/// Nanoseconds of each call, whose answers are kept.
fn chacun<Q, T>(questions: &[Q], appel: impl Fn(&Q) -> T) -> f64 {
    let mut reponses: Vec<T> = questions.iter().map(&appel).collect();
    let ns = moindres(TOURS, 1, |_| {
        let debut = Instant::now();
        for (reponse, question) in reponses.iter_mut().zip(questions) {
            *reponse = appel(question);
        }
        black_box(&mut reponses);
        debut.elapsed().as_nanos() as f64 / questions.len() as f64
    });
    ns[0]
}
