//! In which order rays go into a batch: windows and suns, lamps of any width, lamps of the list, a lidar. Each row is
//! the time of one order of the same rays over that of another. `cargo run --release -p banc --bin ordres` prints
//! `benches/mesures/ordres.csv`, in a minute. An argument sets the seed.

use std::error::Error;
use std::f64::consts::TAU;

use banc::circonstances::Circonstances;
use banc::familles::{Famille, GRAINE_DES_PAGES, Genre};
use banc::horloge::{TOURS, chronometrer, moindres};
use banc::nous;
use commun::arrondi;
use commun::fabrique::sphere;
use commun::regimes::direction;
use exemples::scene::Lisible;
use fastrand::Rng;
use lancer_rayon::{Intersection, Monde, NoIntersection, ObjetRay, Rayon, Reel, Vecteur};

const FAMILLES: [Famille; 4] = [Famille::Ville, Famille::Salle, Famille::Atomes, Famille::Foret];

/// Points of the picture, and rays to a lamp from each.
const POINTS: usize = 2_048;
const RAYONS: usize = 64;

/// Days and hours of the sun.
const JOURS: usize = 64;
const HEURES: usize = 16;

const LAMPES: usize = 4;

/// How many beams a lidar has, 2° apart, and where each points in one turn.
const FAISCEAUX: usize = 16;
const AZIMUTS: usize = 2_048;

/// Each comparison with its name and its ratio of times.
type Rapports = Vec<(String, f64)>;

fn main() -> Result<(), Box<dyn Error>> {
    let graine = std::env::args().nth(1).map_or(Ok(GRAINE_DES_PAGES), |graine| graine.parse())?;
    let circonstances = Circonstances::presentes().colonnes();
    println!("order,family,objects,f32,f64,{}", Circonstances::TITRES);
    for famille in FAMILLES {
        for n in [192, 1_000] {
            let [simples, doubles] =
                [rapports::<f32>(famille, n, graine)?, rapports::<f64>(famille, n, graine)?];
            for ((ordre, simple), (_, double)) in simples.into_iter().zip(doubles) {
                println!("{ordre},{},{n},{simple:.2},{double:.2},{circonstances}", famille.nom());
            }
        }
    }
    Ok(())
}

fn rapports<R: Lisible>(
    famille: Famille,
    n: usize,
    graine: u64,
) -> Result<Rapports, Box<dyn Error>> {
    let mut alea = Rng::with_seed(graine);
    let mut scene = famille.scene::<R>(n, graine);
    // The lamps are balls of the list, high above the rest.
    for i in 0..LAMPES {
        let (sin, cos) = (TAU * i as f64 / LAMPES as f64).sin_cos();
        scene.objets.push(sphere(arrondi(Vecteur::new(9.0 * cos, 16.0, 9.0 * sin)), R::UN));
    }
    let mut places = nous::memoire(1, scene.objets.len());
    let monde = nous::monde(&scene.objets, &mut places, "");
    let touche = |rayon: Rayon<R>| monde.premiere_intersection(&rayon).ok();
    let vus = Genre::Tuiles.rayons(&monde, &scene, 8).into_iter().filter_map(touche);
    let vus: Vec<_> = vus.filter(|touche| touche.indice() < n).take(POINTS).collect();
    let mut rapports = soleils(monde, n);
    rapports.extend(cones(monde, &vus, &mut alea));
    rapports.push(lampes(monde, &vus, n, &mut alea));
    rapports.extend(lidar(monde, vus[vus.len() / 2]));
    Ok(rapports)
}

/// The middles of the sides of boxes and of balls, and the suns of a year at 45° north.
fn soleils<R: Reel>(monde: Monde<'_, R>, n: usize) -> Rapports {
    let fenetres: Vec<_> = monde.objets()[..n].iter().flat_map(fenetres).take(POINTS / 2).collect();
    let au_fil_de_l_an: Vec<_> = (0..JOURS * HEURES)
        .map(|i| {
            let saison = 0.409 * (TAU * (i / HEURES) as f64 / JOURS as f64).sin();
            let heure = TAU * ((i % HEURES) as f64 / HEURES as f64 - 0.5) / 2.0;
            let (x, dans_l_axe) = (saison.cos() * heure.sin(), saison.sin());
            let midi = saison.cos() * heure.cos();
            let demi = 0.5_f64.sqrt();
            Vecteur::new(x, demi * (midi + dans_l_axe), demi * (midi - dans_l_axe))
        })
        .filter(|soleil| soleil.y > 0.0)
        .collect();
    let mut tries = au_fil_de_l_an.clone();
    tries.sort_by_key(|soleil| en_z(soleil.x, soleil.z));
    let ombres =
        |fenetre: &Intersection<R>, soleil: &Vecteur| fenetre.vers_soleil(arrondi(*soleil)).ok();
    let soleil_par_soleil = au_fil_de_l_an
        .iter()
        .flat_map(|soleil| fenetres.iter().filter_map(move |fenetre| ombres(fenetre, soleil)));
    let fenetre_par_fenetre = |soleils: &[Vecteur]| -> Vec<_> {
        let d_une = |fenetre| soleils.iter().filter_map(move |soleil| ombres(fenetre, soleil));
        fenetres.iter().flat_map(d_une).collect()
    };
    let ordres = [
        soleil_par_soleil.collect(),
        fenetre_par_fenetre(&au_fil_de_l_an),
        fenetre_par_fenetre(&tries),
    ];
    let ns = temps(monde, &ordres);
    vec![
        (
            "one sun after the other over one window after the other with sorted suns".into(),
            ns[0] / ns[2],
        ),
        ("suns as the year goes over sorted suns".into(), ns[1] / ns[2]),
    ]
}

/// A place on each side of an object, made as the way out along the normal there.
fn fenetres<R: Reel>(objet: &ObjetRay<R>) -> Vec<Intersection<R>> {
    let (centre, normales) = match objet {
        ObjetRay::Boite(boite) => (boite.centre(), boite.normales().into()),
        ObjetRay::Sphere(sphere) => (sphere.centre(), vec![Vecteur::X, Vecteur::Y, Vecteur::Z]),
        ObjetRay::Plan(_) => return vec![],
    };
    let sortie = |n| objet.sortie(&Rayon::new(centre, n).ok()?).ok();
    normales.into_iter().flat_map(|n| [n, -n]).filter_map(sortie).collect()
}

/// The place of a point of [−1, 1]² along a curve that keeps neighbours near, made of the bits of both coordinates by
/// turns.
fn en_z(x: f64, y: f64) -> u32 {
    let [x, y] = [x, y].map(|x| ((x + 1.0) * 255.0) as u32);
    (0..9).fold(0, |z, bit| z | (x >> bit & 1) << (2 * bit) | (y >> bit & 1) << (2 * bit + 1))
}

/// Lamps, suns and skies of any width: from each point the same directions within a cone.
fn cones<R: Reel>(monde: Monde<'_, R>, vus: &[Intersection<R>], alea: &mut Rng) -> Rapports {
    let axe = Vecteur::new(0.4, 1.0, 0.3).unitaire().expect("a direction");
    let mut cone = |demi_angle: f64| {
        let bord = demi_angle.to_radians();
        let mut dans: Vec<_> = (0..RAYONS)
            .map(|_| {
                let travers =
                    direction(alea).produit_vectoriel(axe).unitaire().expect("a direction");
                let cosinus = 1.0 - alea.f64() * (1.0 - bord.cos());
                axe * cosinus + travers * (1.0 - cosinus * cosinus).sqrt()
            })
            .collect();
        dans.sort_by_key(|d| en_z(d.x, d.z));
        let dans = &dans;
        let vers = |touche: &Intersection<R>, d: &Vecteur| touche.vers_soleil(arrondi(*d)).ok();
        let par_point = vus.iter().flat_map(|vu| dans.iter().filter_map(move |d| vers(vu, d)));
        let par_direction = dans.iter().flat_map(|d| vus.iter().filter_map(move |vu| vers(vu, d)));
        let ns = temps(monde, &[par_point.collect(), par_direction.collect()]);
        let nom = format!("within {demi_angle}° point by point over direction by direction");
        (nom, ns[0] / ns[1])
    };
    [0.25, 2.0, 10.0, 30.0, 90.0].map(&mut cone).into()
}

/// A ray from each point to a random lamp: the time of the first hits, the lamp or not, in one batch, over that of a
/// batch of shadows for each lamp, which is left out.
fn lampes<R: Reel>(
    monde: Monde<'_, R>,
    vus: &[Intersection<R>],
    n: usize,
    alea: &mut Rng,
) -> (String, f64) {
    let mut de_chaque = [(); LAMPES].map(|()| Vec::new());
    let mut melees = Vec::new();
    for vu in vus {
        let lampe = alea.usize(..LAMPES);
        let ObjetRay::Sphere(boule) = monde.objets()[n + lampe] else { continue };
        let cote = arrondi::<R>(direction(alea));
        let vers = vu.point() - boule.centre();
        let cote = if cote.produit_scalaire(vers) < R::ZERO { -cote } else { cote };
        let Ok(ombre) = vu.vers_lumiere(boule.centre() + cote * boule.rayon()) else { continue };
        de_chaque[lampe].push(ombre);
        let sans_fin = ombre.jusqu_a(R::INFINI).expect("no end is one");
        melees.push(sans_fin);
    }
    let mut touches = [Err(NoIntersection); POINTS];
    let mut occultes = [false; POINTS];
    let rayons = melees.len() as f64;
    let ns = moindres(TOURS, 2, |qui| {
        if qui == 0 {
            return chronometrer(&melees, |rayons| {
                monde.premieres_intersections(rayons, &mut touches[..rayons.len()]).expect(ASSEZ);
            });
        }
        let une = |(lampe, ombres): (usize, &Vec<Rayon<R>>)| {
            let monde = monde.sans(n + lampe);
            let ns = chronometrer(ombres, |rayons| {
                monde.sont_occultes(rayons, &mut occultes[..rayons.len()]).expect(ASSEZ);
            });
            ns * ombres.len() as f64 / rayons
        };
        de_chaque.iter().enumerate().map(une).sum()
    });
    ("first hits of mixed lamps over shadows lamp by lamp".into(), ns[0] / ns[1])
}

/// A turn of a lidar one unit above this hit, as it fires, with all beams at one azimuth after the other, and beam by
/// beam; each over tiles that are about square in angle.
fn lidar<R: Reel>(monde: Monde<'_, R>, sous_lui: Intersection<R>) -> Rapports {
    let source = sous_lui.point() + sous_lui.normale();
    let rayon = |faisceau: usize, azimut: usize| {
        let site = (2.0 * faisceau as f64 - 15.0).to_radians();
        let (sin, cos) = (TAU * azimut as f64 / AZIMUTS as f64).sin_cos();
        let vers = Vecteur::new(site.cos() * cos, site.sin(), site.cos() * sin);
        Rayon::new(source, arrondi(vers)).expect("a direction")
    };
    let tour = |faisceaux: usize, azimuts: usize| -> Vec<_> {
        let tuiles = (0..AZIMUTS).step_by(azimuts).flat_map(|azimut| {
            (0..FAISCEAUX).step_by(faisceaux).map(move |faisceau| (faisceau, azimut))
        });
        let d_une = |(faisceau, azimut)| {
            let colonnes = azimut..azimut + azimuts;
            let une = move |azimut| {
                (faisceau..faisceau + faisceaux).map(move |faisceau| rayon(faisceau, azimut))
            };
            colonnes.flat_map(une)
        };
        tuiles.flat_map(d_une).collect()
    };
    let ordres = [tour(FAISCEAUX, 4), tour(1, AZIMUTS), tour(2, 32)];
    let mut touches = [Err(NoIntersection); banc::horloge::MORCEAU];
    let ns = moindres(TOURS, ordres.len(), |qui| {
        chronometrer(&ordres[qui], |rayons| {
            monde.premieres_intersections(rayons, &mut touches[..rayons.len()]).expect(ASSEZ);
        })
    });
    let nom = |ordre| format!("a lidar {ordre} over tiles of 2 beams × 32 azimuths");
    vec![(nom("as it fires"), ns[0] / ns[2]), (nom("beam by beam"), ns[1] / ns[2])]
}

const ASSEZ: &str = "as many answers as rays";

/// Nanoseconds for a shadow ray in each of these orders.
fn temps<R: Reel>(monde: Monde<'_, R>, ordres: &[Vec<Rayon<R>>]) -> Vec<f64> {
    let mut occultes = vec![false; banc::horloge::MORCEAU];
    moindres(TOURS, ordres.len(), |qui| {
        chronometrer(&ordres[qui], |rayons| {
            monde.sont_occultes(rayons, &mut occultes[..rayons.len()]).expect(ASSEZ);
        })
    })
}
