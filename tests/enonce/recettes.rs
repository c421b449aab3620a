//! The recipes of `docs/guide.md` and `docs/vitesse.md`, most against a closed form: a place of one's own, patterns, a
//! tree in a program, hidden objects, a scene far away, a picture by threads. (Media are in
//! `milieux.rs`, particles in `particule.rs`, two worlds in `choix.rs`.)

use commun::en_f32_et_f64;
use commun::fabrique::{boite, sphere, v};
use commun::tolerances::u;
use exemples::scene::tuiles;
use lancer_rayon::{
    BoiteGeo, Face, Monde, NoIntersection, ObjetGeo, ObjetRay, Rayon, Reel, Rotation, SphereGeo,
    Texture, Vecteur, premiere_intersection,
};
use recettes::animation::Animation;
use recettes::capteur::capteur;
use recettes::premier::premier;
use recettes::{atlas, au_loin, caches, damier, fils};

/// A sensor faces outward, where its coordinates say; and on the wall against which another house stands flush it gets
/// no sun.
fn un_capteur_est_sur_sa_face<R: Reel>() {
    let (centre, cotes) = (v::<R>(30.0, 3.0, -50.0), v::<R>(4.0, 6.0, 9.0));
    let tour = Rotation::new(v(0.3, 0.4, 0.5)).unwrap();
    let voisine = boite(centre + tour.appliquer(v(4.0, 3.0, 0.0)), v(4.0, 12.0, 14.0), tour);
    let objets = [boite(centre, cotes, tour), voisine];
    let ObjetRay::Boite(maison) = objets[0] else { unreachable!("made as a box") };
    let lieu = v::<R>(0.9, -0.4, 0.1);
    for face in Face::TOUTES {
        let capteur = capteur(maison, face, face.le_long(lieu)).unwrap();
        let n = maison.face(face).1;
        let depuis = tour.inverse().appliquer(capteur.point() - centre);
        let [x, y] = face.le_long(Vecteur::new(
            depuis.x / cotes.x - lieu.x / R::depuis_f64(2.0),
            depuis.y / cotes.y - lieu.y / R::depuis_f64(2.0),
            depuis.z / cotes.z - lieu.z / R::depuis_f64(2.0),
        ));
        let ecart = x.absolu() + y.absolu();
        assert!(ecart.vers_f64() < 100.0 * u::<R>() && capteur.normale() == n, "{face}: {ecart}");
        let ombre = capteur.vers_soleil(n + Vecteur::Y * R::depuis_f64(0.1)).unwrap();
        let cache = Monde::de_liste(&objets).est_occulte(&ombre);
        assert_eq!(cache, face == Face::PlusX, "{face}");
    }
}

en_f32_et_f64!(un_capteur_est_sur_sa_face);

/// The pattern of a turned box is that of the box before it was turned, and so is the map of a ball.
#[test]
fn un_motif_tourne_avec_son_objet() {
    let tour = Rotation::new(v(0.4, -1.1, 2.5)).unwrap();
    let boite = BoiteGeo::new(v(3.0, 1.0, -2.0), v(2.0, 2.0, 4.0), tour, Texture(0)).unwrap();
    let boite = boite.vers_ray();
    for (lieu, sombre) in [([0.2, 0.3], false), ([0.7, 0.3], true), ([-0.2, 0.3], true)] {
        let d = tour.appliquer(-Vecteur::Z);
        let source = boite.centre() + tour.appliquer(v(lieu[0], lieu[1], 9.0));
        let rayon = Rayon::new(source, d).unwrap();
        // The face lies at z = 2, in cell 4.
        let touche = ObjetRay::from(boite).intersection(&rayon).unwrap();
        assert_eq!(damier::sombre(&boite, &rayon, &touche, 0.5), sombre, "{lieu:?}");
    }
    let boule = sphere(v(1.0, 2.0, 3.0), 1.0);
    for (d, attendue) in
        [(v(0.3, 0.2, 1.0), [4, 1]), (v(0.1, 5.0, 0.3), [4, 0]), (v(-0.2, -0.3, -1.0), [0, 2])]
    {
        let d = tour.appliquer(d);
        let touche = boule.intersection(&Rayon::new(v(1.0, 2.0, 3.0) + d * 3.0, -d).unwrap());
        assert_eq!(atlas::case(&touche.unwrap(), tour, [8, 4]), attendue);
    }
}

/// Pictures of more and of fewer objects, one after another: each is the picture of its list.
#[test]
fn chaque_image_est_celle_de_ses_objets() {
    let boule = |x: f64| ObjetGeo::from(SphereGeo::new(v(x, 0.0, 0.0), 0.4, Texture(0)).unwrap());
    let mut animation = Animation::default();
    for image in [3, 40, 0, 12] {
        let decrits: Vec<_> = (0..image).map(|i| boule(f64::from(i))).collect();
        let objets: Vec<_> = decrits.iter().map(|objet| objet.vers_ray()).collect();
        let rayons =
            [0.0, 2.1, 11.0, 30.0].map(|x| Rayon::new(v(x, 0.0, 9.0), -Vecteur::Z).unwrap());
        let mut touches = [Err(NoIntersection); 4];
        animation.placer(&decrits);
        animation.image(&rayons, &mut touches).unwrap();
        assert_eq!(touches, rayons.map(|rayon| premiere_intersection(&objets, &rayon)), "{image}");
    }
}

/// Where objects are hidden one by one, the next one shows; what a caller left out never shows.
#[test]
fn ce_qu_on_cache_montre_le_suivant() {
    let objets = [-9.0, -4.0, 2.0, -6.0].map(|z| sphere(v(0.0, 0.0, z), 1.0));
    let rayon = Rayon::new(Vecteur::NUL, -Vecteur::Z).unwrap();
    assert_eq!(caches::un_par_un(Monde::de_liste(&objets), &rayon), [1, 3, 0]);
}

/// The number of rays may be anything, also no multiple of a block, or less than one.
#[test]
fn une_image_par_fils_a_les_bits_d_un_seul() {
    let objets = [sphere(v(0.0, 0.0, -5.0), 1.0), sphere(v(2.0, 1.0, -9.0), 2.0)];
    let monde = Monde::de_liste(&objets);
    for nombre in [0, 1, 63, 64, 65, 1_000, 4_096] {
        let rayon = |i: i32| Rayon::new(v(0.0, 0.0, 0.0), v(f64::from(i % 64) / 64.0, 0.1, -1.0));
        let rayons: Vec<Rayon> = (0..nombre).map(|i| rayon(i).unwrap()).collect();
        let seul = rayons.iter().map(|rayon| monde.premiere_intersection(rayon));
        assert!(seul.clone().eq(fils::reponses(monde, &rayons)), "{nombre} rays");
        let ordre = tuiles(rayons.len(), 24);
        assert!(seul.eq(fils::dans_cet_ordre(monde, &rayons, &ordre)), "{nombre} rays in tiles");
    }
}

/// The guide says what the first program prints.
#[test]
fn le_premier_programme_dit_ce_que_dit_la_page() {
    let (touche, erreur) = premier().unwrap();
    assert_eq!((touche.indice(), touche.distance()), (1, 4.0));
    assert_eq!(erreur, "rayon is -1.0, but must be a number above 0");
}

#[test]
fn un_pixel_est_la_moyenne_de_ses_rayons() {
    // There are 4 × 6 pixels, each with its index; a pixel that remains has the mean of its four.
    let couleurs: Vec<_> = (0..24).map(|i| Vecteur::Y * f64::from(i)).collect();
    let moyennes = [2.5, 4.5, 10.5, 12.5, 18.5, 20.5].map(|y| Vecteur::Y * y);
    assert_eq!(fils::moyennes(&couleurs, 4, 2), moyennes);
    assert_eq!(fils::moyennes(&couleurs, 4, 1), couleurs);
}

/// A kilometre from the origin of a map, a place is known to some micrometres. Without that origin the scene in `f32`
/// knows it to a tenth of a metre.
#[test]
fn au_loin_un_lieu_se_trouve_pres_d_une_origine() {
    let origine = v(500_000.0, 0.0, 4_200_000.0);
    let boule = SphereGeo::new(origine + v(1.3, 2.1, -4.7), 0.7, Texture(0)).unwrap();
    let objets = [ObjetGeo::from(boule)];
    let rayon = Rayon::new(origine + v(0.3, 0.1, 5.0), v(1.1, 1.9, -10.0)).unwrap();
    let attendu = premiere_intersection(&[objets[0].vers_ray()], &rayon).unwrap().point();
    let trouve = |origine| {
        let scene = au_loin::scene(&objets, origine).unwrap();
        au_loin::lieu(&scene, rayon, origine).unwrap_or(Vecteur::NUL)
    };
    assert!((trouve(origine) - attendu).longueur() < 1e-5, "{:?} {attendu:?}", trouve(origine));
    assert!((trouve(Vecteur::NUL) - attendu).longueur() > 1e-2);
}

/// What `reflechi` says of light mirrored within a ball: its cosine would stay that of the first time, but for the steps
/// inward.
#[test]
fn les_reflets_dans_une_boule_derivent_du_pas() {
    let boule = sphere::<f32>(Vecteur::NUL, 1.0);
    let cosinus = |de_nouveau: bool| {
        let d = v(-0.1, 0.99_f64.sqrt(), 0.0);
        let mut rayon = Rayon::new(v(0.999_999, 0.0, 0.0), d).unwrap().dedans();
        for _ in 0..10_000 {
            let sortie = boule.sortie(&rayon).unwrap();
            rayon = sortie.reflechi(rayon.direction()).unwrap();
            if de_nouveau {
                rayon = Rayon::new(sortie.point(), rayon.direction()).unwrap().dedans();
            }
        }
        let sortie = boule.sortie(&rayon).unwrap();
        sortie.normale().produit_scalaire(rayon.direction())
    };
    assert!((0.14..0.17).contains(&cosinus(false)), "{}", cosinus(false));
    assert!((cosinus(true) - 0.1).abs() < 0.002, "{}", cosinus(true));
}
