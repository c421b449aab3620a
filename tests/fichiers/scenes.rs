//! The scenes of `docs/scenes`, and the language in which they are written.

use std::path::{Path, PathBuf};

use commun::en_f32_et_f64;
use exemples::scene::{Lisible, Scene};
use lancer_rayon::{
    ObjetGeo, ObjetRay, Rayon, Reel, Reponse, SphereGeo, Texture, Vecteur, premiere_intersection,
};

fn fichiers() -> Vec<PathBuf> {
    let entrees = std::fs::read_dir("docs/scenes").unwrap().map(|entree| entree.unwrap().path());
    let scenes: Vec<_> =
        entrees.filter(|chemin| chemin.extension() == Some("ron".as_ref())).collect();
    assert!(scenes.len() >= 3, "scenes are missing: {scenes:?}");
    scenes
}

/// What every pixel of the picture sees.
fn image<R: Reel>(scene: &Scene<R>) -> Vec<Reponse<R>> {
    let objets: Vec<_> = scene.objets.iter().copied().map(ObjetRay::from).collect();
    let rayons = scene.camera.rayons().unwrap();
    rayons.iter().map(|rayon| premiere_intersection(&objets, rayon)).collect()
}

/// The picture shows each object, since nobody would miss a lost object that it does not show. In the snowflake the
/// spheres hide each other.
fn chaque_objet_se_voit<R: Reel>(chemin: &Path, scene: &Scene<R>, touches: &[Reponse<R>]) {
    let mut pixels = vec![0; scene.objets.len()];
    for touche in touches.iter().flatten() {
        pixels[touche.indice()] += 1;
    }
    let caches = pixels.iter().filter(|pixels| **pixels < 4).count();
    let permis = if chemin.ends_with("flocon.ron") { scene.objets.len() * 2 / 3 } else { 0 };
    assert!(
        caches <= permis,
        "{}: {caches} objects are seen in less than 4 pixels",
        chemin.display()
    );
}

/// How far apart the two distances may be, relative to the distance; grazing rays came to 8e-6.
const ECART_F32_F64: f64 = 1e-4;

/// A direction of the camera may be off by some units in the last place of 1, from a turn and a normalisation.
const DIRECTION_CAMERA: f64 = 1e-15;

#[test]
fn f32_et_f64_voient_tous_les_objets_aux_memes_distances() {
    for chemin in fichiers() {
        let (double, simple) = (Scene::lire(&chemin).unwrap(), Scene::lire(&chemin).unwrap());
        let (doubles, simples) = (image::<f64>(&double), image::<f32>(&simple));
        chaque_objet_se_voit(&chemin, &double, &doubles);
        chaque_objet_se_voit(&chemin, &simple, &simples);
        // `pixels.rs` counts how many rays see another object.
        for paire in doubles.iter().zip(&simples) {
            if let (Ok(a), Ok(b)) = paire
                && a.indice() == b.indice()
            {
                let ecart = (f64::from(b.distance()) / a.distance() - 1.0).abs();
                assert!(ecart < ECART_F32_F64, "{}: {a:?} and {b:?}", chemin.display());
            }
        }
    }
}

/// A scene with this object, which starts at the fifth column of the fourth line.
fn avec_objet(objet: &str) -> String {
    let camera = "source: (0, 0, 9), regard: Point((0, 0, 0)), champ: 40";
    format!("(\n  camera: ({camera}),\n  objets: [\n    {objet},\n  ],\n)")
}

/// A scene with this camera, which starts at the twelfth column of the second line.
fn avec_camera(camera: &str) -> String {
    format!("(\n  camera: ({camera}),\n  objets: [],\n)")
}

fn refuse<R: Lisible>(texte: &str, attendu: &str) {
    let erreur = Scene::<R>::depuis_texte(Path::new("x.ron"), texte).unwrap_err().to_string();
    let attendu = format!("x.ron:{attendu}");
    assert!(erreur.starts_with(&attendu), "{erreur}\ninstead of {attendu}\nfor {texte}");
}

/// The position is that of the number where one number is to blame, and that of the closing parenthesis of the vector
/// or of the object where several might be.
#[test]
fn un_objet_refuse_dit_ou_et_pourquoi() {
    for (objet, attendu) in [
        (
            "Sphere(centre: (0, 0, 0), rayon: -1, texture: 0)",
            "4:38: rayon is -1.0, but must be a number above 0",
        ),
        (
            "Sphere(centre: (0, NaN, 0), rayon: 1, texture: 0)",
            "4:30: centre.y is NaN, but must be a number between -2^",
        ),
        (
            "Boite(dimensions: (1, 0, 1), centre: (0, 0, 0), rotation: (0, 0, 0), texture: 0)",
            "4:31: dimensions.y is 0.0, but must be a number above 0",
        ),
        (
            "Plan(distance: 1, rotation: (0, inf, 0), texture: 0)",
            "4:43: vecteur_rotation.y is inf, but must be a finite number",
        ),
        (
            "Sphere(centre: (0, 0, 0), rayon: 1, texture: 0, transformations: [\n\
             Homothetie(2),\nTranslation((0, 0, inf)),\n])",
            "7:2: translation.z is inf, but must be a finite number",
        ),
        (
            "Sphere(centre: (0, 0, 0), rayon: 1, texture: 0, couleur: 3)",
            "4:53: Unexpected field named `couleur` in `Sphere`",
        ),
        (
            "Sphere(centre: (0, 0, 0), texture: 0)",
            "4:41: Unexpected missing field named `rayon` in `Sphere`",
        ),
        ("Sphere(centre: (0, 0), rayon: 1, texture: 0)", "4:25: Expected an array of length 3"),
        ("Cone(centre: (0, 0, 0), texture: 0)", "4:5: Unexpected variant named `Cone`"),
    ] {
        refuse::<f64>(&avec_objet(objet), attendu);
        refuse::<f32>(&avec_objet(objet), attendu);
    }
}

#[test]
fn une_camera_refusee_dit_ou_et_pourquoi() {
    for (camera, attendu) in [
        (
            "source: (0, 0, 0), regard: Point((0, 0, 0)), champ: 40",
            "2:66: regard - source is 0.0, but must be a vector other than 0",
        ),
        (
            "source: (0, 0, inf), regard: Rotation((0, 0, 0)), champ: 40",
            "2:30: source.z is inf, but must be a number between -2^",
        ),
        (
            "source: (0, 0, 9), regard: Rotation((0, NaN, 0)), champ: 40",
            "2:58: vecteur_rotation.y is NaN, but must be a finite number",
        ),
        (
            "source: (0, 0, 9), regard: Point((0, 0, 0)), champ: 180",
            "2:64: champ is 180, but must lie strictly between 0 and 180 degrees",
        ),
        (
            "source: (0, 0, 9), regard: Point((0, 0, 0)), champ: 40, image: (600, 0)",
            "2:82: image is 600 x 0, but must be 1 to 4096 pixels each way",
        ),
        (
            "source: (0, 0, 9), regard: Point((0, 0, 0)), champ: 40, zoom: 2",
            "2:68: Unexpected field named `zoom` in `Camera`",
        ),
        (
            "source: (0, 0, 9), regard: Point((0, 0, 0))",
            "2:55: Unexpected missing field named `champ` in `Camera`",
        ),
    ] {
        refuse::<f64>(&avec_camera(camera), attendu);
    }
}

/// One type can hold what the other cannot.
#[test]
fn un_rayon_de_1e30_est_refuse_en_f32_seulement() {
    let texte = avec_objet("Sphere(centre: (0, 0, 0), rayon: 1e30, texture: 0)");
    assert!(Scene::<f64>::depuis_texte(Path::new("x.ron"), &texte).is_ok());
    refuse::<f32>(&texte, "4:38: rayon is 1.0000000150474662e30, but must be a number between");
}

#[test]
fn un_fichier_absent_est_nomme() {
    let erreur = Scene::<f64>::lire(Path::new("docs/scenes/absente.ron")).unwrap_err().to_string();
    assert!(erreur.starts_with("docs/scenes/absente.ron: "), "{erreur}");
}

fn lue<R: Lisible>(texte: &str) -> Scene<R> {
    Scene::depuis_texte(Path::new("x.ron"), texte).unwrap()
}

/// Angles are in degrees, and 90, 180, 270 and 360 must become exactly the floats by which `Rotation::new` turns
/// exactly.
fn les_quarts_de_tour_sont_exacts<R: Lisible>() {
    for degres in [-360, -270, -180, -90, 0, 90, 180, 270, 360] {
        for r in [[degres, 0, 0], [0, degres, 0], [0, 0, degres]] {
            let [x, y, z] = r;
            let scene: Scene<R> = lue(&avec_objet(&format!(
                "Boite(centre: (0, 0, 0), dimensions: (1, 1, 1), rotation: ({x}, {y}, {z}), texture: 0)"
            )));
            let [ObjetGeo::Boite(boite)] = scene.objets[..] else { panic!("{scene:?}") };
            let exact = |x: &R| [R::ZERO, R::UN].contains(&x.absolu());
            for normale in boite.vers_ray().normales() {
                assert!(<[R; 3]>::from(normale).iter().all(exact), "{r:?} degrees: {normale:?}");
            }
        }
    }
}

en_f32_et_f64!(les_quarts_de_tour_sont_exacts);

/// The transformations below do not commute: any other order gives another sphere.
#[test]
fn les_transformations_suivent_l_ordre_du_fichier() {
    let scene: Scene<f64> = lue(&avec_objet(
        "Sphere(centre: (1, 0, 0), rayon: 2, texture: 5, transformations: [
            Translation((0, 3, 0)), Rotation((0, 0, 90)), Homothetie(0.5), Translation((7, 0, 0)),
        ])",
    ));
    // A quarter turn about z sends (x, y) to (y, -x) in the handout's sense.
    let attendue = SphereGeo::new(Vecteur::new(10.0, -1.0, 0.0), 1.0, Texture(5)).unwrap();
    assert_eq!(scene.objets, [attendue.into()]);
}

/// There is one ray for each pixel, row by row from the upper left, through its middle. The eye looks at its point with
/// the horizon level.
#[test]
fn la_camera_voit_ce_qu_elle_regarde() {
    let image = |camera: &str| -> Vec<Vecteur> {
        let rayons = lue::<f64>(&avec_camera(camera)).camera.rayons().unwrap();
        rayons.iter().map(Rayon::direction).collect()
    };
    let proche = |direction: Vecteur, vers: Vecteur| {
        let vers = vers.unitaire().unwrap();
        assert!(
            (direction - vers).longueur() < DIRECTION_CAMERA,
            "{direction:?} instead of {vers:?}"
        );
    };
    let droit = image("source: (1, 2, 3), regard: Point((1, 2, -4)), champ: 90");
    assert_eq!(droit.len(), 240_000);
    // The picture is 2 high at distance 1, so half a pixel is 1/400.
    let coin = Vecteur::new(-1.5 + 1.0 / 400.0, 1.0 - 1.0 / 400.0, -1.0);
    proche(droit[0], coin);
    proche(droit[599], Vecteur::new(-coin.x, coin.y, coin.z));
    proche(droit[239_400], Vecteur::new(coin.x, -coin.y, coin.z));

    // The middle of a picture of odd size looks at the point.
    let [gauche, milieu, droite] =
        image("source: (1, 2, 3), regard: Point((5, 7, 9)), champ: 90, image: (3, 1)")[..]
    else {
        panic!("three pixels wide, one high");
    };
    let vers = Vecteur::new(4.0, 5.0, 6.0);
    proche(milieu, vers);
    assert!(
        (gauche.y - droite.y).abs() < DIRECTION_CAMERA,
        "the horizon leans: {gauche:?}, {droite:?}"
    );
    // The camera looks towards +z, so x grows to the left.
    assert!(gauche.x > milieu.x && milieu.x > droite.x);

    // A vecteur-rotation turns in the handout's sense: (0, 0, -1)·M_y = (1, 0, 0).
    let [cote] =
        image("source: (0, 0, 0), regard: Rotation((0, 90, 0)), champ: 40, image: (1, 1)")[..]
    else {
        panic!("one pixel");
    };
    assert_eq!(cote, Vecteur::new(1.0, 0.0, 0.0));
}
