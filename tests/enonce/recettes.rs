//! The recipes of `docs/guide.md` and `docs/vitesse.md`, most against a closed form: a place of one's own, patterns, a
//! tree in a program, hidden objects, a scene far away, a picture by threads; and what the pages say of δ. (Media are in
//! `milieux.rs`, particles in `particule.rs`, two worlds in `choix.rs`.)

use commun::fabrique::{boite, murs, sphere, v};
use commun::hasard::{Hasard, pour_chaque};
use commun::oracle::hauteur;
use commun::regimes::{direction, entre};
use commun::tolerances::u;
use commun::{arrondi, en_f32_et_f64};
use exemples::scene::tuiles;
use lancer_rayon::{
    BoiteGeo, Face, Monde, NoIntersection, ObjetGeo, ObjetRay, Rayon, Reel, Rotation, SphereGeo,
    Texture, Vecteur, premiere_intersection,
};
use recettes::animation::Animation;
use recettes::capteur::capteur;
use recettes::premier::premier;
use recettes::{atlas, au_loin, caches, damier, fils};

/// Places on the wall of a house against which a taller one stands flush get no sun. Places on the other wall get every
/// sun that the wall faces. The houses are turned and stand anywhere, so that their stored walls overlap or leave a
/// crack, by rounding.
fn un_mur_mitoyen_est_a_l_ombre<R: Reel>() {
    let (mut caches, mut clairs, mut naifs) = (0, 0, 0);
    let faire = |alea: &mut Hasard| {
        let tour = Rotation::new(v(0.0, entre(alea, -3.0, 3.0), 0.0)).unwrap();
        let [l, h, p] = [(); 3].map(|()| entre(alea, 4.0, 20.0));
        let centre = v::<R>(entre(alea, -90.0, 90.0), h / 2.0, entre(alea, -90.0, 90.0));
        let maison = boite(centre, v(l, h, p), tour);
        let voisin = centre + tour.appliquer(v(l, h / 2.0, 0.0));
        let objets = [maison, boite(voisin, v(l, 2.0 * h, 1.5 * p), tour)];
        let [_, y, z] = tour.axes();
        let lieux = alea.liste(50, |alea, _| {
            let [b, c] = [(); 2].map(|()| entre(alea, -0.98, 0.98));
            let [y, z] = [(y, b * h), (z, c * p)].map(|(n, l)| n * R::depuis_f64(0.5 * l));
            let soleil = direction(alea);
            (v(0.0, b, c), y + z, arrondi::<R>(Vecteur::new(soleil.x, soleil.y.abs(), soleil.z)))
        });
        (objets, lieux)
    };
    pour_chaque(200, faire, |(objets, lieux)| {
        let [maison @ ObjetRay::Boite(boite), _] = objets else { unreachable!("made as a box") };
        let monde = Monde::de_liste(&objets);
        for (lieu, vers, soleil) in lieux {
            for (face, cache) in [(Face::PlusX, true), (Face::MoinsX, false)] {
                let (milieu, n) = boite.face(face);
                let capteur = capteur(boite, face, face.le_long(lieu)).unwrap();
                // The error is some roundings of numbers below 200, and nowhere near the size of the wall.
                let ecart = (capteur.point() - milieu - vers).longueur().vers_f64();
                assert!(ecart < 4_000.0 * u::<R>(), "{ecart:e}");
                let Ok(ombre) = capteur.vers_soleil(soleil) else { continue };
                assert_eq!(monde.est_occulte(&ombre), cache, "{ombre:?}");
                let naif = Rayon::new(capteur.point(), soleil).unwrap();
                // C + l·N rounds by u of the product and by u of the sum, and N is unit to 6.1u.
                let [l, ..] = boite.demi_longueurs();
                let flou = 10.0 * u::<R>() * (boite.centre().longueur() + l).vers_f64();
                assert!(hauteur(&maison, n, milieu).abs() <= flou);
                let du_milieu = Rayon::new(milieu, soleil).unwrap();
                let du_milieu = du_milieu.avec_flou(R::depuis_f64(flou)).unwrap();
                assert!(!cache || monde.est_occulte(&du_milieu), "{du_milieu:?}");
                naifs += u32::from(cache && !monde.est_occulte(&naif));
                if cache { caches += 1 } else { clairs += 1 }
            }
        }
    });
    assert!(caches > 4_000 && clairs > 4_000 && naifs > caches / 5);
}

en_f32_et_f64!(un_mur_mitoyen_est_a_l_ombre);

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

/// What the page says of `f32` in a large hall.
#[test]
fn dans_une_salle_de_cent_kilometres_le_flou_atteint_huit_decimetres() {
    let murs: Vec<ObjetRay<f32>> = murs(v(5e4, 5e4, 5e4), Rotation::IDENTITE, 1e5, None)
        .into_iter()
        .map(ObjetRay::from)
        .collect();
    let (mut somme, rayons) = (0.0, 1_000);
    let faire = |alea: &mut Hasard| Rayon::new(v(5e4, 5e4, 5e4), arrondi(direction(alea))).unwrap();
    pour_chaque(rayons, faire, |mut rayon| {
        for _ in 0..5 {
            let touche = Monde::de_liste(&murs).premiere_intersection(&rayon).unwrap();
            rayon = touche.reflechi(rayon.direction()).unwrap();
        }
        somme += rayon.flou() / rayons as f32;
    });
    assert!((0.7..0.9).contains(&somme), "{somme}");
}

/// What the page says of light mirrored within a ball: its cosine would stay that of the first time, but for the steps
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
