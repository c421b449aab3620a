//! The recipes of `docs/guide.md` and `docs/vitesse.md`, most against a closed form: a place of one's own, patterns, a
//! tree in a program, hidden objects, a scene far away, glass on a table, a particle in a room, a scattering medium, a
//! lens of two balls, media one within the other, a picture by threads. (Two worlds are in `choix.rs`.)

use std::f64::consts::PI;

use commun::fabrique::{boite, boite_droite, mur, murs, sphere, v};
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::oracle::hauteur;
use commun::regimes::{direction, entre};
use commun::tolerances::u;
use commun::{arrondi, en_f32_et_f64};
use exemples::recettes::animation::Animation;
use exemples::recettes::brume::chemin;
use exemples::recettes::capteur::capteur;
use exemples::recettes::lentille::traverser;
use exemples::recettes::milieux::{Lumiere, Milieu};
use exemples::recettes::particule::Particule;
use exemples::recettes::premier::premier;
use exemples::recettes::verre::{Suite, dans_le_verre};
use exemples::recettes::{atlas, au_loin, caches, damier, fils};
use exemples::scene::tuiles;
use fastrand::Rng;
use lancer_rayon::{
    BoiteGeo, Face, Monde, NoIntersection, ObjetGeo, ObjetRay, Rayon, Reel, Rotation, SphereGeo,
    Texture, Vecteur, places, premiere_intersection,
};

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

/// Heights of all kinds: with few digits, with many, halves, far up, and small.
fn hauteurs(alea: &mut Hasard) -> [f64; 2] {
    let decimale = |alea: &mut Hasard| alea.usize(1..300) as f64 / 100.0;
    let haut = if alea.bool() { decimale(alea) } else { entre(alea, 0.01, 3.0) };
    let plateau = match alea.u8(0..6) {
        0 => 0.0,
        1 => decimale(alea),
        2 => f64::from(alea.i8(-8..=8)) / 8.0,
        3 => entre(alea, -1.0, 1.0),
        4 => entre(alea, 10.0, 30.0),
        _ => -decimale(alea),
    };
    [plateau, haut]
}

/// A pane of glass lies flush on a mirror, at a hundred heights. Light comes back out of the top 2h·tan β beside where
/// it went in, and a lamp above lights what lies under the glass. Rounding alone puts the mirror before the way out or
/// after it, which changes nothing.
fn sous_un_verre_pose_la_lumiere_trouve_la_table<R: Reel>() {
    let (mut avant, mut apres) = (0, 0);
    let faire = |alea: &mut Hasard| {
        let [plateau, haut] = hauteurs(alea).map(R::depuis_f64);
        let deux = R::depuis_f64(2.0);
        let table = if alea.tour.is_multiple_of(2) {
            mur(Vecteur::Y * plateau, Vecteur::Y)
        } else {
            boite_droite(Vecteur::Y * (plateau - R::depuis_f64(0.035)), v(900.0, 0.07, 900.0))
        };
        let cotes = Vecteur::new(R::depuis_f64(80.0), haut, R::depuis_f64(80.0));
        let objets = [table, boite_droite(Vecteur::Y * (plateau + haut / deux), cotes)];
        let vers =
            alea.liste(100, |alea, _| (direction(alea) - Vecteur::Y * 1.5).unitaire().unwrap());
        let haut = haut.vers_f64();
        (objets, haut, Vecteur::Y * (plateau.vers_f64() + haut + 2.0), vers)
    };
    pour_chaque(100, faire, |(objets, haut, oeil, vers)| {
        let mut memoire = vec![0.0; places(2)];
        let monde = Monde::new(&objets, &mut memoire).unwrap();
        for d in vers {
            let rayon = Rayon::<R>::new(arrondi(oeil), arrondi(d)).unwrap();
            let entree = monde.premiere_intersection(&rayon).unwrap();
            assert_eq!(entree.indice(), 1);
            let dedans = entree.refracte(rayon.direction(), R::depuis_f64(1.0 / 1.5)).unwrap();
            let Ok(Suite::Touche(touche)) = dans_le_verre(&monde, 1, &dedans) else {
                panic!("the table is missed: {dedans:?}");
            };
            assert_eq!(touche.indice(), 0);
            let sortie = objets[1].sortie(&dedans).unwrap().distance();
            let est_avant = monde.sans(1).est_occulte(&dedans.jusqu_a(sortie).unwrap());
            (avant, apres) = (avant + u32::from(est_avant), apres + u32::from(!est_avant));
            let lampe = touche.vers_lumiere(arrondi(oeil * 3.0 + Vecteur::Y * 99.0)).unwrap();
            assert!(!monde.sans(1).est_occulte(&lampe), "{lampe:?}");
            let reflet = touche.reflechi(dedans.direction()).unwrap();
            let Ok(Suite::Sortie(sortie)) = dans_le_verre(&monde, 1, &reflet) else {
                panic!("no way out: {reflet:?}");
            };
            let dehors = sortie.refracte(reflet.direction(), R::depuis_f64(1.5)).unwrap();
            let miroir = Vecteur::new(d.x, -d.y, d.z);
            // There are some thirty roundings of lengths below a hundred, under cosines above a fifth.
            let permis = 1_000.0 * u::<R>() * (1.0 + oeil.longueur());
            assert!((dehors.direction().vers_f64() - miroir).longueur() < permis);
            let sinus = d.produit_vectoriel(Vecteur::Y) / 1.5;
            let tangente = sinus / (1.0 - sinus.longueur_carree()).sqrt();
            let attendu = tangente.produit_vectoriel(Vecteur::Y) * (-2.0 * haut);
            let parcouru = (sortie.point() - entree.point()).vers_f64();
            assert!((parcouru - attendu).longueur() < permis, "{parcouru:?} {attendu:?}");
        }
    });
    assert!(avant > 1_000 && apres > 1_000, "{avant} {apres}");
}

en_f32_et_f64!(sous_un_verre_pose_la_lumiere_trouve_la_table);

/// A particle in a cube is where a straight line would be if the cube were mirrored instead of the way. One step in
/// three ends on a wall. Thousands of bounces later none has left, and none knows its place less well than after a
/// hundred.
fn une_particule_reste_ou_le_depliage_la_met<R: Reel>() {
    let murs: Vec<ObjetRay<R>> = murs(v(0.5, 0.5, 0.5), Rotation::IDENTITE, 1.0, None)
        .into_iter()
        .map(ObjetRay::from)
        .collect();
    let monde = Monde::de_liste(&murs);
    let (mut au_mur, mut pire) = (0, 0.0_f64);
    let faire = |alea: &mut Hasard| {
        let depart = v::<R>(entre(alea, 0.1, 0.9), entre(alea, 0.1, 0.9), 0.5);
        let rayon = Rayon::new(depart, arrondi(direction(alea))).unwrap();
        // To the wall, or this far.
        let pas = alea.liste(1_200, |alea, _| (alea.u8(0..3) > 0).then(|| 2.0 * alea.f64()));
        (rayon, pas)
    };
    pour_chaque(40, faire, |(rayon, pas)| {
        let (s, d) = (rayon.source().vers_f64(), rayon.direction().vers_f64());
        let (mut particule, mut chemin, mut pas_faits) = (Particule::new(rayon), 0.0, 0.0);
        for pas in pas {
            let pas = match (pas, monde.premiere_intersection(&particule.rayon)) {
                (None, Ok(mur)) if mur.distance() > R::ZERO => {
                    au_mur += 1;
                    mur.distance()
                }
                (pas, _) => R::depuis_f64(pas.unwrap_or(1.0)),
            };
            particule.avancer(&monde, pas).unwrap();
            (chemin, pas_faits) = (chemin + pas.vers_f64(), pas_faits + 1.0);
            // A bounce turns D by 20u, which the length of the way multiplies, and some fifty roundings move it. There
            // are at most three bounces for two units of length. Steps round as well.
            let permis =
                u::<R>() * (20.0 * 1.5 * chemin * chemin + 50.0 * (1.5 * chemin + pas_faits + 1.0));
            let tout_droit = s + d * chemin;
            let depliee = |x: f64| (x - 2.0 * (x / 2.0).round()).abs();
            let attendue = Vecteur::from(<[f64; 3]>::from(tout_droit).map(depliee));
            let ecart = (particule.rayon.source().vers_f64() - attendue).longueur();
            assert!(ecart <= permis.min(2.0), "{ecart:e} > {permis:e} after {chemin}");
            pire = pire.max(ecart / permis);
            for x in <[R; 3]>::from(particule.rayon.source()).map(R::vers_f64) {
                assert!((-1e-3..1.0 + 1e-3).contains(&x), "{x} left after {chemin}");
            }
            // Each bounce and step adds less than 16u·√3, 8.1u·3 and one step off the surface.
            let connu = (100.0 + 400.0) * 60.0 * u::<R>();
            assert!(particule.rayon.flou().vers_f64() <= connu);
        }
    });
    assert!(au_mur > 1_000);
}

en_f32_et_f64!(une_particule_reste_ou_le_depliage_la_met);

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

/// The mean way through a convex body that is lit evenly from all around is 4V/S, whether the body scatters much,
/// little or not at all (Blanco and Fournier 2003).
#[test]
fn le_chemin_moyen_dans_une_brume_est_de_quatre_v_sur_s() {
    const MARCHES: u32 = 40_000;
    let mut alea = Rng::with_seed(94);
    let tour = Rotation::new(v(0.3, 0.4, 0.5)).unwrap();
    let cube = boite(v(1.0, 2.0, 3.0), v(2.0, 2.0, 2.0), tour);
    let boule = sphere(v(1.0, 2.0, 3.0), 1.0);
    for (milieu, attendu) in [(cube, 4.0 * 8.0 / 24.0), (boule, 4.0 / 3.0)] {
        for pas_moyen in [0.1, 0.7, 5.0] {
            let (mut somme, mut carres, mut nombre) = (0.0, 0.0, 0_u32);
            while nombre < MARCHES {
                // Parallel light from everywhere, as a wide beam on a ball around the body.
                let d = direction(&mut alea);
                let au_hasard = direction(&mut alea);
                let travers = au_hasard.produit_vectoriel(d).unitaire().unwrap();
                let s = v(1.0, 2.0, 3.0) - d * 9.0 + travers * (1.8 * alea.f64().sqrt());
                let Ok(entree) = milieu.intersection(&Rayon::new(s, d).unwrap()) else { continue };
                let dedans = entree.secondaire(d).unwrap();
                let chemin = chemin(&milieu, dedans, pas_moyen, || alea.f64()).unwrap();
                (somme, carres, nombre) = (somme + chemin, carres + chemin * chemin, nombre + 1);
            }
            let n = f64::from(MARCHES);
            let (moyenne, erreur) =
                (somme / n, (carres / n - (somme / n).powi(2)).sqrt() / n.sqrt());
            println!("{moyenne} ± {erreur} of {attendu} with steps of {pas_moyen}");
            assert!((moyenne - attendu).abs() < 4.0 * erreur, "{moyenne} ± {erreur}, {attendu}");
        }
        // A step ended on the surface and goes out, so that no way is left.
        for _ in 0..1_000 {
            let rayon = Rayon::new(v(1.0, 2.0, 3.0), direction(&mut alea)).unwrap();
            let a_la_face =
                rayon.bifurque(milieu.sortie(&rayon).unwrap().distance(), rayon.direction());
            let reste = chemin(&milieu, a_la_face.unwrap(), 1e9, || 0.5).unwrap();
            assert!(reste < 1e-14, "{reste}");
        }
    }
}

/// The paraxial focus of a thick lens, and the rays off its axis by the trigonometric trace of Conrady.
#[test]
fn une_lentille_de_deux_boules_a_son_foyer() {
    let (r, epaisseur, n) = (10.0, 1.2, 1.5);
    let balles = [1.0, -1.0].map(|cote| sphere(Vecteur::X * (cote * (r - epaisseur / 2.0)), r));
    // Where a ray parallel to the axis, at the height h, crosses the axis, measured from the last vertex.
    let traverse = |h: f64| {
        let rayon = Rayon::new(Vecteur::new(-30.0, h, 0.0), Vecteur::X).unwrap();
        let dehors = traverser(&balles, &rayon, n).unwrap().unwrap();
        let (p, d) = (dehors.source(), dehors.direction());
        p.x - d.x * p.y / d.y - epaisseur / 2.0
    };
    let f = n * r * r / ((n - 1.0) * (2.0 * n * r - (n - 1.0) * epaisseur));
    let paraxial = f * (1.0 - (n - 1.0) * epaisseur / (n * r));
    // Aberration is of the order of h², and rounding of the order of u/h.
    assert!((traverse(1e-4) - paraxial).abs() < 1e-8, "{} {paraxial}", traverse(1e-4));
    for h in [0.1, 0.5, 1.0, 2.0, 3.0] {
        let sin_i = h / r;
        let sin_i2 = sin_i / n;
        let u1 = sin_i.asin() - sin_i2.asin();
        let l1 = r + r * sin_i2 / u1.sin() - epaisseur;
        let sin_j = (l1 + r) / -r * u1.sin();
        let sin_j2 = n * sin_j;
        let u2 = u1 + sin_j.asin() - sin_j2.asin();
        let attendu = -r - r * sin_j2 / u2.sin();
        assert!((traverse(h) - attendu).abs() < 1e-12 / h, "{h}: {} {attendu}", traverse(h));
    }
    // The edge of the lens is where the balls cross.
    let bord = (r * r - (r - epaisseur / 2.0_f64).powi(2)).sqrt();
    let passe = |h| {
        let rayon = Rayon::new(Vecteur::new(-30.0, h, 0.0), Vecteur::X).unwrap();
        traverser(&balles, &rayon, n).unwrap().is_some()
    };
    assert!(passe(bord - 1e-3) && !passe(bord + 1e-3));
}

/// Goes on until nothing is ahead, or for 40 faces.
fn au_bout(monde: &Monde<'_>, milieux: &[Milieu], mut lumiere: Lumiere) -> Lumiere {
    for _ in 0..40 {
        if !lumiere.avancer(monde, milieux).unwrap() {
            break;
        }
    }
    lumiere
}

/// Ice in water on a plate of glass into which the water reaches. By priority each height has one medium, and light
/// goes down through all as through panes. Balls one inside another bend light as Bouguer's law says. Beyond the
/// critical angle light stays in the water.
#[test]
fn des_milieux_l_un_dans_l_autre_plient_la_lumiere_par_priorite() {
    let couche = |bas: f64, haut: f64| {
        boite_droite(v(0.0, (bas + haut) / 2.0, 0.0), v(900.0, haut - bas, 900.0))
    };
    let milieu = |priorite, indice| Milieu { priorite, indice };
    let couches = [couche(0.9, 3.0), couche(0.0, 1.0), couche(1.5, 2.5)];
    let milieux = [milieu(1, 1.33), milieu(2, 1.5), milieu(3, 1.31)];
    let monde = Monde::de_liste(&couches);
    let faire = |alea: &mut Hasard| (direction(alea) - Vecteur::Y * 1.2).unitaire().unwrap();
    pour_chaque(1_000, faire, |d| {
        let rayon = Rayon::new(Vecteur::Y * 5.0, d).unwrap();
        let dehors = au_bout(&monde, &milieux, Lumiere { rayon, dans: vec![] });
        assert_eq!(dehors.dans, []);
        let (s, d) = (dehors.rayon.source(), dehors.rayon.direction());
        assert!((d - rayon.direction()).longueur() < 1e-13);
        let sinus = (d.x * d.x + d.z * d.z).sqrt();
        let tangente = |n: f64| sinus / n / (1.0 - (sinus / n).powi(2)).sqrt();
        let attendu = 2.0 * tangente(1.0) + tangente(1.33) + tangente(1.31) + tangente(1.5);
        assert!(((s.x * s.x + s.z * s.z).sqrt() - attendu).abs() < 1e-12, "{attendu} {s:?}");
    });
    // Light goes up from the water at 60°, beyond the critical 48.8°: it comes back down, still in the water.
    let rayon = Rayon::new(Vecteur::Y * 2.8, v(0.75_f64.sqrt(), 0.5, 0.0)).unwrap();
    let mut lumiere = Lumiere { rayon, dans: vec![0] };
    assert!(lumiere.avancer(&monde, &milieux).unwrap());
    assert!(lumiere.dans == [0] && (lumiere.rayon.direction().y + 0.5).abs() < 1e-14);

    let balles = [sphere(Vecteur::NUL, 2.0), sphere(Vecteur::NUL, 1.0)];
    let milieux = [milieu(1, 1.2), milieu(2, 1.6)];
    let monde = Monde::de_liste(&balles);
    pour_chaque(
        1_000,
        |alea| entre(alea, 0.01, 1.15),
        |b| {
            let rayon = Rayon::new(Vecteur::new(-9.0, b, 0.0), Vecteur::X).unwrap();
            let dehors = au_bout(&monde, &milieux, Lumiere { rayon, dans: vec![] });
            // n·r·sin θ stays b all the way.
            let dedans = if b < 1.2 { (b / 1.2).asin() - (b / 1.6).asin() } else { 0.0 };
            let deviation = 2.0 * ((b / 2.0).asin() - (b / 2.4).asin() + dedans);
            let d = dehors.rayon.direction();
            let angle = (-d.y).atan2(d.x);
            assert!(
                (angle - deviation).abs() < 1e-12 && deviation < PI,
                "{b}: {angle} {deviation}"
            );
        },
    );
}
