//! The test set that the handout asks for (§4.3.3). Each row holds what is tried, the result expected and the result
//! obtained. There is one part for each rule of annex A, for each decision C1–C13 and C15 of `docs/conventions.md`, and
//! for a whole scene.
//!
//! Most rows are also on the page `tests/enonce/jeu_de_tests.md`, which
//! `LANCER_RAYON_ECRIRE=1 cargo test --test enonce` writes again.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};
use core::fmt::Write;
use std::path::Path;

use commun::litteral;
use exemples::scene::{Lisible, Scene};
use lancer_rayon::{
    BoiteGeo, BoiteRay, ErreurGeo, Face, NoIntersection, ObjetGeo, ObjetRay, PlanGeo, Rayon, Reel,
    Reponse, Rotation, SphereGeo, Texture, Vecteur, premiere_intersection,
};

/// What is tried, expected and obtained, and the marks of the row.
type Ligne = (&'static str, String, String, &'static [&'static str]);

/// A part as one scalar answers it.
struct Partie {
    titre: &'static str,
    lignes: Vec<Ligne>,
}

/// The rows of a part: what is tried => what is expected, what is obtained. Marks stand before a row: `aussi` leaves it
/// out of the page, `double` and `simple` make it a row of `f64` or of `f32` alone.
macro_rules! partie {
    ($titre:literal; $($($marque:ident)* $quoi:literal => $attendu:expr, $obtenu:expr;)*) => {
        Partie {
            titre: $titre,
            lignes: vec![$((
                $quoi, $attendu.to_string(), $obtenu.to_string(), &[$(stringify!($marque)),*],
            )),*],
        }
    };
}

/// A row of the page: what is tried, what is expected, what is obtained, and what in `f32`.
type Rangee = [String; 4];

/// The rows of the page. In every row the expected result must have been obtained, in `f32` to its rounding.
fn verifier(doubles: Partie, simples: Partie) -> Vec<Rangee> {
    let mut page = Vec::new();
    let titre = doubles.titre;
    for (double, simple) in doubles.lignes.into_iter().zip(simples.lignes) {
        let (quoi, attendu, obtenu, marques) = double;
        let en_f32 = simple.2;
        let [hors_de_la_page, d_un_double, d_un_simple] =
            ["aussi", "double", "simple"].map(|marque| marques.contains(&marque));
        assert_eq!(obtenu, attendu, "{titre}: {quoi}");
        assert!(d_un_double || presque(&en_f32, &attendu), "{titre}: {quoi}: {en_f32} in f32");
        if !hors_de_la_page {
            let rien = || "–".to_owned();
            let colonnes = match (d_un_double, d_un_simple) {
                (false, true) => [rien(), obtenu],
                (true, _) => [obtenu, rien()],
                (false, false) if en_f32 == obtenu => [obtenu, "the same".into()],
                (false, false) => [obtenu, en_f32],
            };
            let [obtenu, en_f32] = colonnes;
            page.push([quoi.into(), attendu, obtenu, en_f32]);
        }
    }
    page
}

/// Whether two results have the same words, and numbers that are the same to some roundings of `f32`.
fn presque(a: &str, b: &str) -> bool {
    let mots = |texte: &str| -> Vec<String> {
        texte.split([' ', '(', ')', ',']).map(str::to_owned).collect()
    };
    let (a, b) = (mots(a), mots(b));
    let proches = |(a, b): (&String, &String)| match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(x), Ok(y)) if a != b => (x - y).abs() <= 1e-6 * y.abs().max(0.1),
        _ => a == b,
    };
    a.len() == b.len() && a.iter().zip(&b).all(proches)
}

// How a row shows a value: with all its digits, unless the row says that it rounds. The sign of a zero is no result,
// and texture 0 is not shown.

fn nombre<R: Reel>(x: R) -> String {
    format!("{}", x + R::ZERO)
}

fn vecteur<R: Reel>(v: Vecteur<R>) -> String {
    format!("({}, {}, {})", nombre(v.x), nombre(v.y), nombre(v.z))
}

/// The faces of §3, and then the opposite ones.
const FACES: [Face; 3] = [Face::PlusX, Face::PlusY, Face::PlusZ];
const OPPOSEES: [Face; 3] = [Face::MoinsX, Face::MoinsY, Face::MoinsZ];

fn liste<T>(trois: [T; 3], montrer: impl Fn(T) -> String) -> String {
    trois.map(montrer).join(" ")
}

fn touche<R: Reel>(touche: Reponse<R>) -> String {
    match touche {
        Ok(touche) => {
            let (distance, normale) = (nombre(touche.distance()), vecteur(touche.normale()));
            let texture = match touche.texture() {
                Texture(0) => String::new(),
                Texture(texture) => format!(", texture {texture}"),
            };
            format!("distance {distance}, normal {normale}{texture}")
        }
        Err(NoIntersection) => "no intersection".into(),
    }
}

/// The quantities that §3 gives an object, or why there is none.
fn quantites<R: Reel>(objet: Result<ObjetGeo<R>, ErreurGeo>) -> String {
    match objet.map(ObjetGeo::vers_ray) {
        Ok(ObjetRay::Sphere(s)) => {
            format!("centre {}, radius {}", vecteur(s.centre()), nombre(s.rayon()))
        }
        Ok(ObjetRay::Plan(p)) => {
            format!("d {}, normal {}", nombre(p.distance()), vecteur(p.normale()))
        }
        Ok(ObjetRay::Boite(b)) => {
            let (n, l) = (liste(b.normales(), vecteur), liste(b.demi_longueurs(), nombre));
            format!("centre {}, normals {n}, half-lengths {l}", vecteur(b.centre()))
        }
        Err(erreur) => erreur.to_string(),
    }
}

fn litteralement<R: Reel>(objets: &[ObjetRay<R>], rayon: &Rayon<R>) -> String {
    let objets: Vec<_> = objets.iter().map(litteral::Objet::from).collect();
    match litteral::premiere_intersection(&objets, rayon) {
        Some((distance, ..)) => format!("distance {}", nombre(distance)),
        None => "no intersection".into(),
    }
}

fn erreur<T: core::fmt::Debug>(resultat: Result<T, ErreurGeo>) -> String {
    resultat.map_or_else(|e| e.to_string(), |_| "accepted".into())
}

// How a row makes a value, in either scalar, from numbers that both hold or round.

fn v<R: Reel>(x: f64, y: f64, z: f64) -> Vecteur<R> {
    Vecteur::from([x, y, z].map(R::depuis_f64))
}

fn o<R: Reel>() -> Vecteur<R> {
    Vecteur::NUL
}

fn tour<R: Reel>(x: f64, y: f64, z: f64) -> Rotation<R> {
    Rotation::new(v(x, y, z)).unwrap()
}

fn sphere<R: Reel>(centre: Vecteur<R>, rayon: f64, texture: u32) -> ObjetGeo<R> {
    SphereGeo::new(centre, R::depuis_f64(rayon), Texture(texture)).unwrap().into()
}

fn plan<R: Reel>(rotation: Rotation<R>, distance: f64, texture: u32) -> ObjetGeo<R> {
    PlanGeo::new(rotation, R::depuis_f64(distance), Texture(texture)).unwrap().into()
}

fn boite<R: Reel>(
    centre: Vecteur<R>,
    dimensions: Vecteur<R>,
    rotation: Rotation<R>,
) -> ObjetGeo<R> {
    BoiteGeo::new(centre, dimensions, rotation, Texture(0)).unwrap().into()
}

fn cube<R: Reel>(centre: Vecteur<R>, rotation: Rotation<R>) -> ObjetGeo<R> {
    boite(centre, v(2.0, 2.0, 2.0), rotation)
}

fn rayon<R: Reel>(source: Vecteur<R>, direction: Vecteur<R>) -> Rayon<R> {
    Rayon::new(source, direction).unwrap()
}

/// A ray along −z, as a camera looks.
fn devant<R: Reel>(x: f64, y: f64, z: f64) -> Rayon<R> {
    rayon(v(x, y, z), v(0.0, 0.0, -1.0))
}

fn lancer<R: Reel>(objet: ObjetGeo<R>, rayon: &Rayon<R>) -> String {
    touche(objet.vers_ray().intersection(rayon))
}

fn premiere<R: Reel, const N: usize>(objets: [ObjetGeo<R>; N], rayon: &Rayon<R>) -> String {
    touche(premiere_intersection(&objets.map(ObjetGeo::vers_ray), rayon))
}

fn boite_ray<R: Reel>(objet: ObjetGeo<R>) -> BoiteRay<R> {
    let ObjetRay::Boite(boite) = objet.vers_ray() else { panic!("not a box") };
    boite
}

fn annexe_a1<R: Reel>() -> Partie {
    let mur = plan::<R>(Rotation::IDENTITE, 4.0, 7);
    partie! { "Annex A.1: the half-space z ≤ −4";
        "straight at it, from the origin along −z" => "distance 4, normal (0, 0, 1), texture 7",
            lancer(mur, &devant(0.0, 0.0, 0.0));
        "at a slant: 5 along (0, 3, −4)/5 descend 4" => "distance 5, normal (0, 0, 1), texture 7",
            lancer(mur, &rayon(o(), v(0.0, 3.0, -4.0)));
        "P·D = 0: parallel" => "no intersection", lancer(mur, &rayon(o(), v(1.0, 0.0, 0.0)));
        "t < 0: the ray moves away" => "no intersection", lancer(mur, &rayon(o(), v(0.0, 0.0, 1.0)));
        "a floor y ≤ −2: a quarter turn about x lays z ≤ 0 down" =>
            "distance 5, normal (0, 1, 0), texture 1",
            lancer::<R>(
                plan(tour(FRAC_PI_2, 0.0, 0.0), 2.0, 1),
                &rayon(v(9.0, 3.0, 9.0), v(0.0, -1.0, 0.0)),
            );
    }
}

fn annexe_a2<R: Reel>() -> Partie {
    let boule = sphere::<R>(v(0.0, 0.0, -10.0), 5.0, 3);
    partie! { "Annex A.2: the sphere of radius 5 about (0, 0, −10)";
        "through the centre: SA = 10, AC = 0, AB = 5, SB = 5" =>
            "distance 5, normal (0, 0, 1), texture 3", lancer(boule, &devant(0.0, 0.0, 0.0));
        "beside it: SA = 10, AC = 3, AB = 4, SB = 6, normal CB/5" =>
            "distance 6, normal (0, 0.6, 0.8), texture 3", lancer(boule, &devant(0.0, 3.0, 0.0));
        "SC·D < 0: the ray moves away" => "no intersection",
            lancer(boule, &rayon(o(), v(0.0, 0.0, 1.0)));
        "SC·D = 0: the centre is level with the source" => "no intersection",
            lancer(boule, &rayon(o(), v(0.0, 1.0, 0.0)));
        "AC = 6 > r: beside the sphere" => "no intersection", lancer(boule, &devant(6.0, 0.0, 0.0));
    }
}

fn annexe_a3<R: Reel>() -> Partie {
    let marche = boite::<R>(v(0.0, 0.0, -10.0), v(4.0, 2.0, 6.0), Rotation::IDENTITE);
    let incline = cube::<R>(v(0.0, 0.0, -5.0), tour(0.0, FRAC_PI_4, 0.0));
    partie! { "Annex A.3: the box 4 × 2 × 6 about (0, 0, −10)";
        "D·N < 0 for the face +z: the ray hits that face" => "distance 7, normal (0, 0, 1)",
            lancer(marche, &devant(0.5, 0.5, 0.0));
        "D·N > 0 for the face +z: the ray hits the opposite face −z" =>
            "distance 7, normal (0, 0, -1)",
            lancer(marche, &rayon(v(0.5, 0.5, -20.0), v(0.0, 0.0, 1.0)));
        "|CfI·N| = 2.5 > l: the plane of the face, but beside it" => "no intersection",
            lancer(marche, &devant(2.5, 0.0, 0.0));
        "a cube turned by 45° about y: its edge is at 5 − √2, here 0.25 beside it" =>
            "distance 3.835786437626905, normal (0.7071067811865476, 0, 0.7071067811865475)",
            lancer(incline, &devant(0.25, 0.0, 0.0));
        "behind the source" => "no intersection", lancer(marche, &rayon(o(), v(0.0, 0.0, 1.0)));
    }
}

fn c1<R: Reel>() -> Partie {
    let w = v::<R>(1.0, 2.0, 3.0);
    partie! { "C1: the sense of a rotation is that of the formula V·M, for V = (1, 2, 3)";
        "§2.1's example, α = 90° about x: (x, y cos α + z sin α, −y sin α + z cos α)" =>
            "(1, 3, -2)", vecteur(tour(FRAC_PI_2, 0.0, 0.0).appliquer(w));
        "90° about y" => "(-3, 2, 1)", vecteur(tour(0.0, FRAC_PI_2, 0.0).appliquer(w));
        "90° about z" => "(2, -1, 3)", vecteur(tour(0.0, 0.0, FRAC_PI_2).appliquer(w));
        "the right-hand rule, 90° about x: y goes to z" => "(1, -3, 2)",
            vecteur(Rotation::main_droite(v(FRAC_PI_2, 0.0, 0.0)).unwrap().appliquer(w));
    }
}

/// The matrices with an element other than +0, 1 and −1, among the 9³ rotations by quarter turns and each of these
/// followed by one more about x, y or z, in all 2,916.
fn quarts_inexacts<R: Reel>() -> String {
    // −0 would show its sign bit.
    let exact = |x: R| [0.0, 1.0, -1.0].map(f64::to_bits).contains(&x.vers_f64().to_bits());
    let angle = |k: i8| f64::from(k) * FRAC_PI_2;
    let tour = |x, y, z| tour::<R>(angle(x), angle(y), angle(z));
    let quarts = [tour(1, 0, 0), tour(0, 1, 0), tour(0, 0, 1)];
    let neuf = || -4..=4_i8;
    let tours = neuf().flat_map(|x| neuf().flat_map(move |y| neuf().map(move |z| tour(x, y, z))));
    let matrices = tours.flat_map(|t| [t].into_iter().chain(quarts.map(|quart| t.puis(quart))));
    let matrices: Vec<_> = matrices.map(|tour| tour.matrice()).collect();
    let inexacts = matrices.iter().filter(|m| !m.as_flattened().iter().all(|x| exact(*x))).count();
    format!("{inexacts} of {}", matrices.len())
}

fn c2<R: Reel>() -> Partie {
    let q = FRAC_PI_2;
    let w = v::<R>(1.0, 2.0, 3.0);
    let (x, y) = (tour(q, 0.0, 0.0), tour(0.0, q, 0.0));
    partie! { "C2: about x, then y, then z, for V = (1, 2, 3); quarter turns are exact";
        "x first, then y" => "(2, 3, 1)", vecteur(tour(q, q, 0.0).appliquer(w));
        "y first, then x: another rotation" => "(-3, 1, -2)", vecteur(y.puis(x).appliquer(w));
        "all 9³ quarter turns, alone and with one more about any axis: matrices with an element other than +0, 1 and −1" =>
            "0 of 2916",
            quarts_inexacts::<R>();
    }
}

fn c3<R: Reel>() -> Partie {
    let devant_de_nous = plan::<R>(Rotation::IDENTITE, 2.0, 0);
    let autour_de_nous = plan::<R>(Rotation::IDENTITE, -2.0, 0);
    partie! { "C3: the surface is N·X = −d, the solid N·X ≤ −d";
        "N = (0, 0, 1)·M, here for a quarter turn about x" => "d 0, normal (0, 1, 0)",
            quantites::<R>(Ok(plan(tour(FRAC_PI_2, 0.0, 0.0), 0.0, 0)));
        "d = 2: the origin is outside, and sees it along −z" => "distance 2, normal (0, 0, 1)",
            lancer(devant_de_nous, &devant(0.0, 0.0, 0.0));
        "d = −2: the origin is inside, and sees nothing of it" => "no intersection",
            lancer(autour_de_nous, &devant(0.0, 0.0, 0.0));
        "d = 0: the origin is on the surface" => "no intersection",
            lancer::<R>(plan(Rotation::IDENTITE, 0.0, 0), &devant(0.0, 0.0, 0.0));
    }
}

fn c4<R: Reel>() -> Partie {
    let w = v::<R>(1.0, 2.0, 3.0);
    partie! { "C4: translation by v = (1, 2, 3)";
        "a sphere of radius 1 about (0, 0, −5)" => "centre (1, 2, -2), radius 1",
            quantites(sphere(v(0.0, 0.0, -5.0), 1.0, 0).translation(w));
        "a cube of side 2 about (0, 0, −5)" =>
            "centre (1, 2, -2), normals (1, 0, 0) (0, 1, 0) (0, 0, 1), half-lengths 1 1 1",
            quantites(cube(v(0.0, 0.0, -5.0), Rotation::IDENTITE).translation(w));
        "a half-space z ≤ −4: d − N·v = 4 − 3" => "d 1, normal (0, 0, 1)",
            quantites(plan(Rotation::IDENTITE, 4.0, 0).translation(w));
    }
}

fn c5<R: Reel>() -> Partie {
    let quart = tour::<R>(FRAC_PI_2, 0.0, 0.0);
    let c = v::<R>(1.0, 2.0, 3.0);
    partie! { "C5: an object turns about the origin, here by a quarter about x";
        "a sphere of radius 2 about (1, 2, 3): its centre turns" => "centre (1, 3, -2), radius 2",
            quantites(sphere(c, 2.0, 0).rotation(quart));
        "a box 2 × 4 × 6 about (1, 2, 3): its centre and its normals" =>
            "centre (1, 3, -2), normals (1, 0, 0) (0, 0, -1) (0, 1, 0), half-lengths 1 2 3",
            quantites(boite(c, v(2.0, 4.0, 6.0), Rotation::IDENTITE).rotation(quart));
        "a half-space z ≤ −4: its normal turns, and d stays" => "d 4, normal (0, 1, 0)",
            quantites(plan(Rotation::IDENTITE, 4.0, 0).rotation(quart));
        "the second ray of annex A.2 and its sphere, turned together: the same distance" =>
            "distance 6, normal (0, 0.8, -0.6), texture 3",
            {
                let boule = sphere::<R>(v(0.0, 0.0, -10.0), 5.0, 3).rotation(quart).unwrap();
                let r = devant(0.0, 3.0, 0.0);
                lancer(boule, &rayon(quart.appliquer(r.source()), quart.appliquer(r.direction())))
            };
    }
}

fn c6<R: Reel>() -> Partie {
    let c = v::<R>(1.0, 2.0, 3.0);
    let (boule, demi_espace) = (sphere(c, 2.0, 0), plan(Rotation::IDENTITE, 4.0, 0));
    let marche = boite(c, v(2.0, 4.0, 6.0), Rotation::IDENTITE);
    let agrandir = |objet: ObjetGeo<R>, k| quantites(objet.homothetie(R::depuis_f64(k)));
    let chacun = |k: f64| liste([boule, demi_espace, marche], |objet| agrandir(objet, k));
    let refus = "coefficient is -1.0, but must be a finite number above 0";
    partie! { "C6: homothety about the object's own centre";
        "a sphere of radius 2 about (1, 2, 3), × 3" => "centre (1, 2, 3), radius 6", agrandir(boule, 3.0);
        "a box 2 × 4 × 6 about (1, 2, 3), × 0.5" =>
            "centre (1, 2, 3), normals (1, 0, 0) (0, 1, 0) (0, 0, 1), half-lengths 0.5 1 1.5",
            agrandir(marche, 0.5);
        "a half-space z ≤ −4, which has no dimension, × 3" => "d 4, normal (0, 0, 1)",
            agrandir(demi_espace, 3.0);
        "k = −1" => refus, agrandir(boule, -1.0);
        aussi "k = −1, each of the three" => [refus; 3].join(" "), chacun(-1.0);
    }
}

fn c7<R: Reel>() -> Partie {
    let boule = sphere::<R>(o(), 2.0, 0);
    let bloc = cube::<R>(o(), Rotation::IDENTITE);
    let sol = plan::<f64>(tour(FRAC_PI_2, 0.0, 0.0), 0.0, 1);
    let derriere = sphere(v(0.0, 0.0, -10.0), 1.0, 5);
    // From a height of 2^60 a descent of 2^-149 arrives farther than any f32.
    let tres_haut: Rayon<f32> =
        rayon(Vecteur::new(0.0, 0.0, 60_f32.exp2()), Vecteur::new(1.0, 0.0, -f32::from_bits(1)));
    partie! { "C7: a hit is an entry from outside; a sphere of radius 2 and a cube of side 2 about O, rays along −z";
        "inside the sphere, from (0, 0, 1)" => "no intersection", lancer(boule, &devant(0.0, 0.0, 1.0));
        "on the sphere, going in" => "no intersection", lancer(boule, &devant(0.0, 0.0, 2.0));
        "inside the cube, from (0.5, 0.5, 0.5)" => "no intersection", lancer(bloc, &devant(0.5, 0.5, 0.5));
        "on a face of the cube, along it" => "no intersection", lancer(bloc, &devant(1.0, 0.0, 0.5));
        "inside both, a third ahead still counts: radius 1 about (0, 0, −10)" =>
            "distance 9, normal (0, 0, 1), texture 5",
            premiere([boule, bloc, derriere], &devant(0.0, 0.0, 0.0));
        aussi double "as near as can be: the smallest f64 above the floor" => "distance 5e-324", {
                let au_ras = rayon(v(0.0, f64::from_bits(1), 0.0), v(0.0, -1.0, 0.0));
                format!("distance {:e}", sol.vers_ray().intersection(&au_ras).unwrap().distance())
            };
        aussi simple "a distance beyond the largest f32 is a miss" => "no intersection",
            lancer(plan(Rotation::IDENTITE, 0.0, 0), &tres_haut);
    }
}

fn c8<R: Reel>() -> Partie {
    let boule = sphere::<R>(v(0.0, 0.0, -5.0), 1.0, 0);
    let loin = sphere::<f32>(v(0.0, 0.0, -1000.0), 1.0, 0);
    let presque = devant(0.0, 0.999, 0.0);
    partie! { "C8: the first touch of a sphere, here of radius 1 about (0, 0, −5), is SA − AB, and a tangent misses";
        "the entry" => "distance 4, normal (0, 0, 1)", lancer(boule, &devant(0.0, 0.0, 0.0));
        "A.2 as printed, SA + AB: the exit" => "6", {
                let (sc, r) = (v::<R>(0.0, 0.0, -5.0), R::UN);
                let sa = sc.produit_scalaire(v(0.0, 0.0, -1.0));
                nombre(sa + (r * r - (sc.longueur_carree() - sa * sa)).racine())
            };
        "AC = r: tangent" => "no intersection", lancer(boule, &devant(1.0, 0.0, 0.0));
        aussi double "a unit in the last place inside the tangent: AB² = 2⁻⁵², SB = 5 − 2⁻²⁶" =>
            "distance 4.999999985098839, normal (0.9999999999999999, 0, 0.000000014901161193847656)",
            lancer::<f64>(sphere(v(0.0, 0.0, -5.0), 1.0, 0), &devant(1.0_f64.next_down(), 0.0, 0.0));
        simple "1000 radii away, 0.999 beside the centre: SB = 1000 − 0.04470989" =>
            "distance 999.95526, normal (0, 0.9989987, 0.04473871)", lancer(loin, &presque);
        simple "the same ray by A.2's SC² − SA², which is 1000001 − 1000000 there" => "no intersection",
            litteralement(&[loin.vers_ray()], &presque);
    }
}

fn c9<R: Reel>() -> Partie {
    let mur = plan::<R>(Rotation::IDENTITE, 0.0, 0);
    let sortant = rayon(v(0.0, 0.0, -5.0), v(0.0, 0.0, 1.0));
    partie! { "C9: a half-space is entered against its normal, P·D < 0";
        "from inside, outwards" => "no intersection", lancer(mur, &sortant);
        "A.1 as printed has no such test: t = (−d − P·S)/(P·D)" => "5", {
                let p = v(0.0, 0.0, 1.0);
                let haut = -p.produit_scalaire(sortant.source());
                nombre(haut / p.produit_scalaire(sortant.direction()))
            };
        "a ray that descends 2⁻⁴⁰ for each unit still arrives: there is no epsilon" =>
            "distance 1099511627776, normal (0, 0, 1)",
            lancer(mur, &rayon(v(0.0, 0.0, 1.0), v(1.0, 0.0, -(-40.0_f64).exp2())));
    }
}

/// Rays at points of edges of turned boxes whose two faces look at the source: how many there are, how many the library
/// loses, and how many annex A.3 to the letter.
fn aretes_perdues<R: Reel>() -> (u32, u32, u32) {
    let (mut lances, mut perdus, mut perdus_litteral) = (0, 0, 0);
    for k in 0..500_u32 {
        let k = f64::from(k);
        let tour = tour::<R>(0.37 * k, 0.61 * k, 0.83 * k);
        let objet = boite(v(0.1, 0.2, -9.0), v(1.0, 2.0, 3.0), tour).vers_ray();
        let ObjetRay::Boite(b) = objet else { continue };
        let (n, l) = (b.normales(), b.demi_longueurs());
        let source = v(0.3, 0.4, 0.0);
        for (i, j, le_long) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
            // The edge shared by the two faces that look at the source.
            let vers_nous = |axe: usize| {
                let haut = n[axe].produit_scalaire(source - b.centre());
                let vu = haut.absolu() > l[axe] * R::depuis_f64(1.1);
                vu.then(|| n[axe] * if haut > R::ZERO { l[axe] } else { -l[axe] })
            };
            let (Some(a), Some(c)) = (vers_nous(i), vers_nous(j)) else { continue };
            for fraction in [-0.75, -0.3, 0.1, 0.6] {
                let cible =
                    b.centre() + a + c + n[le_long] * (l[le_long] * R::depuis_f64(fraction));
                let r = rayon(source, cible - source);
                lances += 1;
                perdus += u32::from(objet.intersection(&r).is_err());
                perdus_litteral += u32::from(litteralement(&[objet], &r) == "no intersection");
            }
        }
    }
    (lances, perdus, perdus_litteral)
}

fn c10<R: Reel>() -> Partie {
    let bloc = cube::<R>(v(0.0, 0.0, -5.0), Rotation::IDENTITE);
    let (lances, perdus, litteral) = aretes_perdues::<R>();
    partie! { "C10: a box is three slabs; its edges belong to it";
        "parallel, beside the box" => "no intersection", lancer(bloc, &devant(1.5, 0.0, 0.0));
        "parallel, in the plane of a face: |o| = l belongs" => "distance 4, normal (0, 0, 1)",
            lancer(bloc, &devant(1.0, 0.0, 0.0));
        aussi "in the planes of two faces: along an edge" => "distance 4, normal (0, 0, 1)",
            lancer(bloc, &devant(-1.0, 1.0, 0.0));
        aussi "D·N = −0 is no different" => "distance 4, normal (0, 0, 1)",
            lancer(bloc, &rayon(v(1.0, -1.0, 0.0), v(-0.0, -0.0, -1.0)));
        "past the box along one edge, in and out at once: it belongs" =>
            "distance 1.4142135623730951, normal (-1, 0, 0)",
            lancer(bloc, &rayon(v(-2.0, 0.0, -5.0), v(1.0, 1.0, 0.0)));
        aussi double "a unit in the last place beyond the face" => "no intersection",
            lancer::<f64>(cube(v(0.0, 0.0, -5.0), Rotation::IDENTITE), &devant(1.0_f64.next_up(), 0.0, 0.0));
        "into the edge of x and z: the normal is that of x, the lower axis" =>
            "distance 2.8284271247461903, normal (1, 0, 0)",
            lancer(bloc, &rayon(v(3.0, 0.0, -2.0), v(-2.0, 0.0, -2.0)));
        "rays at visible edges of 500 turned boxes" => "0 of 4000 lost",
            format!("{perdus} of {lances} lost");
        double "the same by A.3 to the letter" => "646 of 4000 lost",
            format!("{litteral} of {lances} lost");
    }
}

fn c11<R: Reel>() -> Partie {
    let b = boite_ray(boite::<R>(v(1.0, 2.0, -10.0), v(2.0, 4.0, 6.0), tour(FRAC_PI_2, 0.0, 0.0)));
    let m = tour::<R>(0.3, 0.5, 0.7);
    let centre = |face| b.face(face).0;
    let distance = |face| {
        let (centre, normale) = b.face(face);
        -normale.produit_scalaire(centre)
    };
    partie! { "C11: the quantities of §3 for a box 2 × 4 × 6 at (1, 2, −10), a quarter turned about x";
        "C" => "(1, 2, -10)", vecteur(b.centre());
        "N₁ N₂ N₃" => "(1, 0, 0) (0, 0, -1) (0, 1, 0)", liste(b.normales(), vecteur);
        "l₁ l₂ l₃" => "1 2 3", liste(b.demi_longueurs(), nombre);
        "Cf = C + l·N" => "(2, 2, -10) (1, 2, -12) (1, 5, -10)", liste(FACES.map(centre), vecteur);
        "Co = C − l·N" => "(0, 2, -10) (1, 2, -8) (1, -1, -10)",
            liste(OPPOSEES.map(centre), vecteur);
        "df = −N·Cf" => "-2 -12 -5", liste(FACES.map(distance), nombre);
        "do = +N·Co" => "0 8 -1", liste(OPPOSEES.map(distance), nombre);
        aussi "N_i is row i of M, here of the rotation by (0.3, 0.5, 0.7)" => liste(m.matrice().map(Vecteur::from), vecteur),
            liste(boite_ray(boite(o(), v(1.0, 1.0, 1.0), m)).normales(), vecteur);
    }
}

fn c12<R: Reel>() -> Partie {
    let boule = |texture| sphere::<R>(v(0.0, 0.0, -5.0), 1.0, texture);
    let mur = |texture| plan(Rotation::IDENTITE, 4.0, texture);
    let r = devant(0.0, 0.0, 0.0);
    let attendu = |texture| format!("distance 4, normal (0, 0, 1), texture {texture}");
    partie! { "C12: at the same distance, the earlier in the list";
        "twice the same sphere" => attendu(1), premiere([boule(1), boule(2)], &r);
        aussi "in the other order" => attendu(2), premiere([boule(2), boule(1)], &r);
        "a sphere, then the wall that it touches" => attendu(1), premiere([boule(1), mur(2)], &r);
        aussi "the wall, then the sphere" => attendu(2), premiere([mur(2), boule(1)], &r);
        "a nearer object later in the list is still first" =>
            "distance 2, normal (0, 0, 1), texture 3",
            premiere([boule(1), mur(2), sphere(v(0.0, 0.0, -2.5), 0.5, 3)], &r);
        "an empty list" => "no intersection", premiere([], &r);
    }
}

fn c13<R: Reel>() -> Partie {
    let direction = |d: Vecteur<R>| vecteur(rayon(o(), d).direction());
    let longue = |d: f64| vecteur(rayon::<f64>(o(), v(0.0, 0.0, d)).direction());
    let boule = sphere::<R>(v(0.0, 0.0, -5.0), 1.0, 0);
    partie! { "C13: any direction that has one; distances are in scene units";
        "(3, 0, −4)" => "(0.6, 0, -0.8)", direction(v(3.0, 0.0, -4.0));
        aussi double "unit to 3 units in the last place: kept" => "(0, 0, 1.0000000000000007)",
            longue(1.0 + 3.0 * f64::EPSILON);
        aussi double "unit to 10: brought to 1" => "(0, 0, 1)",
            longue(1.0 + 10.0 * f64::EPSILON);
        "the distance does not depend on the length given" => "distance 4, normal (0, 0, 1)",
            lancer(boule, &rayon(o(), v(0.0, 0.0, -1e-30)));
        "(0, 0, 0)" => "direction is 0.0, but must be a vector other than 0",
            erreur(Rayon::<R>::new(o(), o()));
        "a NaN" => "direction.z is NaN, but must be a finite number",
            erreur(Rayon::<R>::new(o(), v(0.0, 0.0, f64::NAN)));
    }
}

fn c15<R: Reel>() -> Partie {
    let (grand, petit) = (450_f64.exp2(), (-450_f64).exp2());
    let texture = Texture(0);
    let boule = |x: f64, r: f64| erreur(SphereGeo::new(v(x, 0.0, 0.0), r, texture));
    let diagonale = |x: f64| {
        let [x, un, zero] = [x, 1.0, 0.0].map(R::depuis_f64);
        erreur(Rotation::depuis_matrice([[x, zero, zero], [zero, un, zero], [zero, zero, un]]))
    };
    partie! { "C15: which numbers a scene can hold";
        double "the largest coordinate and sizes" => "accepted", boule(-grand, grand);
        double "the next coordinate" =>
            "centre.x is 2.907354897182428e135, but must be a number between -2^450 and 2^450",
            boule(grand.next_up(), 1.0);
        aussi double "the next size down" =>
            "rayon is 3.439552567074349e-136, but must be a number between 2^-450 and 2^450",
            boule(0.0, petit.next_down());
        simple "the next coordinate" =>
            "centre.y is 1.1529216420458004e18, but must be a number between -2^60 and 2^60",
            erreur(SphereGeo::new(Vecteur::new(0.0, 60_f32.exp2().next_up(), 0.0), 1.0, texture));
        "a radius of 0" => "rayon is 0.0, but must be a number above 0",
            erreur(SphereGeo::new(o::<R>(), R::ZERO, texture));
        "a negative height" => "dimensions.y is -2.0, but must be a number above 0",
            erreur(BoiteGeo::new(o::<R>(), v(1.0, -2.0, 1.0), Rotation::IDENTITE, texture));
        double "a translation that leaves" =>
            "centre.x is 5.814709794364855e135, but must be a number between -2^450 and 2^450",
            erreur(sphere::<f64>(v(grand, 0.0, 0.0), 1.0, 0).translation(v(grand, 0.0, 0.0)));
        "a matrix off by 2⁻⁹" =>
            "matrice is 0.0019540786743164063, but must be at most 1e-3 in each element of M·Mᵀ - I, as a rotation",
            diagonale(1.0 + (-10.0_f64).exp2());
        "a mirror" => "matrice is -1.0, but must be above 0 in its determinant: a mirror is no rotation",
            diagonale(-1.0);
    }
}

/// The objects of `docs/scenes/atelier.ron`, each with its own texture, and its 240,000 camera rays.
fn atelier<R: Lisible>() -> (Vec<ObjetRay<R>>, Vec<Rayon<R>>) {
    let scene: Scene<R> = Scene::lire(Path::new("docs/scenes/atelier.ron")).unwrap();
    let objets = scene.objets.into_iter().map(ObjetRay::from).collect();
    (objets, scene.camera.rayons().unwrap())
}

/// How many of these rays see another object by annex A to the letter.
fn autres_objets<R: Reel>(objets: &[ObjetRay<R>], rayons: &[Rayon<R>]) -> String {
    let litteraux: Vec<_> = objets.iter().map(litteral::Objet::from).collect();
    let autres = rayons.iter().filter(|rayon| {
        let ici = premiere_intersection(objets, rayon).ok().map(|touche| touche.texture());
        let la = litteral::premiere_intersection(&litteraux, rayon);
        ici != la.map(|(.., texture)| texture)
    });
    format!("{} of {}", autres.count(), rayons.len())
}

fn scene_entiere<R: Lisible>() -> Partie {
    let (objets, rayons) = atelier::<R>();
    let mut vus = vec![0; objets.len()];
    for touche in rayons.iter().filter_map(|rayon| premiere_intersection(&objets, rayon).ok()) {
        vus[touche.indice()] += 1;
    }
    // An object is named by its place in the file, from 0.
    let pixel = |x: usize, y: usize| {
        let touche = premiere_intersection(&objets, &rayons[600 * y + x]);
        touche.map_or("none".into(), |touche| {
            format!("object {}, distance {:.6}", touche.indice(), touche.distance().vers_f64())
        })
    };
    partie! { "A whole scene: the 600 × 400 rays of docs/scenes/atelier.ron";
        "rays that see each object, in the order of the file" =>
            "24966 82643 32144 43487 3856 2445 2623 3534 16719 20535 2534 2295 1109 1110",
            vus.iter().map(u32::to_string).collect::<Vec<_>>().join(" ");
        "pixel (450, 380): the floor" => "object 0, distance 10.498860", pixel(450, 380);
        "pixel (170, 165): the orange" => "object 7, distance 9.637377", pixel(170, 165);
        "pixel (420, 200): the cube" => "object 8, distance 8.392775", pixel(420, 200);
        "rays that see another object by annex A with C7 to C9" => "0 of 240000",
            autres_objets(&objets, &rayons);
    }
}

/// Makes a test of each part, and the page of all parts.
macro_rules! parties {
    ($($test:ident: $partie:ident,)*) => {
        /// Each part, in `f64` and in `f32`.
        const PARTIES: &[fn() -> [Partie; 2]] = &[$(|| [$partie::<f64>(), $partie::<f32>()]),*];

        $(#[test]
        fn $test() {
            verifier($partie::<f64>(), $partie::<f32>());
        })*
    };
}

parties! {
    annexe_a1_un_demi_espace_est_touche_comme_elle_le_dit: annexe_a1,
    annexe_a2_une_sphere_est_touchee_comme_elle_le_dit: annexe_a2,
    annexe_a3_une_boite_est_touchee_comme_elle_le_dit: annexe_a3,
    c1_une_rotation_a_le_sens_de_la_formule: c1,
    c2_on_tourne_dans_l_ordre_et_les_quarts_sont_exacts: c2,
    c3_d_est_negatif_si_o_est_dedans: c3,
    c4_une_translation_deplace_chaque_forme: c4,
    c5_un_objet_tourne_autour_de_l_origine: c5,
    c6_un_objet_grandit_autour_de_son_centre: c6,
    c7_une_touche_est_une_entree: c7,
    c8_une_sphere_est_touchee_a_son_entree: c8,
    c9_un_demi_espace_est_touche_contre_sa_normale: c9,
    c10_une_boite_est_touchee_a_la_derniere_entree: c10,
    c11_une_boite_a_les_quantites_de_l_enonce: c11,
    c12_a_egalite_le_premier_de_la_liste_est_touche: c12,
    c13_une_direction_est_rendue_unitaire: c13,
    c15_un_nombre_hors_des_bornes_est_refuse: c15,
    une_scene_entiere_est_vue_comme_attendu: scene_entiere,
}

#[test]
fn la_page_est_a_jour() {
    let chemin = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/enonce/jeu_de_tests.md");
    let mut page = String::from(
        "# Jeu de tests\n\n*Le jeu de tests que demande le §4.3.3 : ce qui est essayé, le résultat attendu, le résultat obtenu en `f64`, et celui en\n\
         `f32`. Le test échoue si le résultat en `f64` diffère d'un chiffre de l'attendu, ou celui en `f32` de plus que son arrondi.*\n\n\
         The handout asks for this test set (§4.3.3). Each row says what is tried, which result is expected, and which one the crate\n\
         obtained when this page was written. A test computes all results again. It fails unless that of `f64` is the expected one,\n\
         digit for digit, and that of `f32` the same to its rounding; where only one of the two is asked, a dash stands for the\n\
         other. \"No intersection\" is the handout's exception, `NoIntersection`. Textures and objects count from 0, and texture 0 is\n\
         not shown. `tests/enonce/jeu_de_tests.rs` has these rows and more, and writes the page:\n\n\
         ```sh\nLANCER_RAYON_ECRIRE=1 cargo test --test enonce la_page\n```\n",
    );
    for partie in PARTIES {
        let [doubles, simples] = partie();
        write!(page, "\n## {}\n\n", doubles.titre).unwrap();
        page.push_str("| test | expected | obtained in `f64` | in `f32` |\n|---|---|---|---|\n");
        for rangee in verifier(doubles, simples) {
            let cases = rangee.map(|case| case.replace('|', "\\|"));
            writeln!(page, "| {} |", cases.join(" | ")).unwrap();
        }
    }
    if std::env::var_os("LANCER_RAYON_ECRIRE").is_some() {
        std::fs::write(chemin, &page).unwrap();
    }
    let ecrite = std::fs::read_to_string(chemin).unwrap_or_default();
    let autre = ecrite.lines().zip(page.lines()).find(|(ecrite, ligne)| ecrite != ligne);
    assert!(ecrite == page, "tests/enonce/jeu_de_tests.md is stale, write it again: {autre:?}");
}
