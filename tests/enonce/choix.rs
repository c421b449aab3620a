//! A choice of objects, all objects along a ray, and a first hit before a distance, as programs use them.

use commun::scenes::{melange, rayons_camera};
use commun::{arrondi, en_f32_et_f64};
use lancer_rayon::{
    BoiteGeo, Hierarchie, Intersection, NoIntersection, ObjetRay, PlanGeo, Rayon, Reel, Rotation,
    SphereGeo, Texture, Touche, Vecteur, premiere_intersection,
};

fn v<R: Reel>(x: f64, y: f64, z: f64) -> Vecteur<R> {
    arrondi(Vecteur::new(x, y, z))
}

fn cube<R: Reel>(centre: Vecteur<R>) -> ObjetRay<R> {
    let cotes = Vecteur::new(R::UN, R::UN, R::UN);
    BoiteGeo::new(centre, cotes, Rotation::IDENTITE, Texture(0)).unwrap().into()
}

/// A half-space at this height along z.
fn sol_a(z: f64) -> ObjetRay {
    PlanGeo::new(Rotation::IDENTITE, -z, Texture(0)).unwrap().into()
}

/// The indices of the objects of these hits.
fn indices<R: Reel>(touches: &[Touche<R>]) -> Vec<usize> {
    touches.iter().flatten().map(Intersection::objet).collect()
}

/// A robot of three parts scans the room around it, and sees no part of its own; beside scans of a list without them.
fn un_robot_ne_se_voit_pas<R: Reel>() {
    let robot: [ObjetRay<R>; 3] = [
        cube(v(0.0, 0.5, 0.0)),
        SphereGeo::new(v(0.0, 1.3, 0.0), R::depuis_f64(0.4), Texture(1)).unwrap().into(),
        cube(v(0.9, 0.5, 0.0)),
    ];
    let piece = melange::<R>(60);
    let scene = [&robot[..], &piece].concat();
    let mut places = vec![0.0; Hierarchie::places(scene.len())];
    let hierarchie = Hierarchie::new(&scene, &mut places).unwrap();
    let dehors = |objet| objet >= robot.len();
    let vue = hierarchie.parmi(&dehors);
    let mut caches = 0;
    for i in 0..4_000 {
        let a = f64::from(i) * 0.37;
        let d = v(a.cos(), (f64::from(i) * 0.011).sin(), a.sin());
        // From within its own head, and from beside it.
        let rayon = Rayon::new(v(0.0, if i % 2 == 0 { 1.2 } else { 2.5 }, 0.0), d).unwrap();
        let voulue = premiere_intersection(&piece, &rayon).map(|t| (t.distance(), t.objet() + 3));
        let vu = vue.premiere_intersection(&rayon);
        assert_eq!(vu.map(|t| (t.distance(), t.objet())), voulue);
        assert_eq!(vue.est_occulte(&rayon, R::INFINI), voulue.is_ok());
        // What is left out is no answer, of which to be certain.
        let nue = hierarchie.premiere_intersection(&rayon);
        if nue.is_ok_and(|t| t.objet() < 3) {
            assert!(!vue.est_certaine(&rayon, &nue));
            caches += 1;
        }
    }
    assert!(caches > 500, "the robot stood in its own way of {caches} rays alone");
}

en_f32_et_f64!(un_robot_ne_se_voit_pas);

/// A choice among a choice takes what both take, in whatever order, and undoes neither.
#[test]
fn un_choix_parmi_un_choix() {
    let scene: Vec<ObjetRay> = (0..40).map(|i| cube(v(0.0, 0.0, -2.0 * f64::from(i)))).collect();
    let rayon = Rayon::new(v(0.0, 0.0, 5.0), v(0.1, 0.07, -9.0)).unwrap();
    let mut places = vec![0.0; Hierarchie::places(scene.len())];
    for hierarchie in [Hierarchie::new(&scene, &mut places).unwrap(), Hierarchie::de_liste(&scene)]
    {
        let sans = |k: usize| move |objet| objet != k;
        let [un, zero] = [sans(1), sans(0)];
        let premier = |h: Hierarchie| h.premiere_intersection(&rayon).map(|t| t.objet());
        assert_eq!(premier(hierarchie.parmi(&zero)), Ok(1));
        assert_eq!(premier(hierarchie.parmi(&un)), Ok(0));
        assert_eq!(premier(hierarchie.parmi(&zero).parmi(&un)), Ok(2));
        assert_eq!(premier(hierarchie.parmi(&un).parmi(&zero)), Ok(2));
        assert_eq!(premier(hierarchie.parmi(&un).parmi(&un)), Ok(0));
        assert_eq!(premier(hierarchie.sans(0)), Ok(1));
        assert_eq!(premier(hierarchie.sans(0).sans(1)), Ok(2));
        assert_eq!(premier(hierarchie.sans(1).sans(0)), Ok(2));
        assert_eq!(premier(hierarchie.parmi(&zero).sans(1)), Ok(2));
        assert_eq!(premier(hierarchie.sans(0).parmi(&un)), Ok(2));
        assert_eq!(premier(hierarchie.sans(0).sans(usize::MAX)), Ok(1));
        // Beyond the list, and with the lowest 32 bits of an index of it.
        let au_dela = usize::MAX - usize::MAX % (usize::MAX >> (usize::BITS / 2)).wrapping_add(1);
        assert_eq!([au_dela, usize::MAX].map(|k| premier(hierarchie.sans(k))), [Ok(0); 2]);
        assert_eq!(premier(hierarchie.parmi(&|_| false)), Err(NoIntersection));
        assert_eq!(premier(hierarchie), Ok(0));
    }
}

/// Choices five deep, each of which leaves one object out: every question knows all of them, of a tree and of a list.
#[test]
fn chaque_question_connait_tous_les_choix() {
    let mut scene = vec![sol_a(-60.0)];
    scene.extend((0..20).map(|i| cube(v(0.0, 0.0, -2.0 * f64::from(i)))));
    let rayon = Rayon::new(v(0.0, 0.0, 5.0), v(0.01, 0.007, -9.0)).unwrap();
    let mut places = vec![0.0; Hierarchie::places(scene.len())];
    for hierarchie in [Hierarchie::new(&scene, &mut places).unwrap(), Hierarchie::de_liste(&scene)]
    {
        let en_ordre = |parmi: Hierarchie| {
            let mut touches = [Err(NoIntersection); 30];
            parmi.dans_l_ordre(&rayon, f64::INFINITY, &mut touches);
            indices(&touches)
        };
        let tous: Vec<_> = (1..=20).chain([0]).collect();
        assert_eq!(en_ordre(hierarchie), tous);
        let nues = tous
            .iter()
            .map(|&k| hierarchie.parmi(&move |objet| objet == k).premiere_intersection(&rayon));
        let nues: Vec<_> = nues.collect();
        // Five of them, in whatever order: the half-space among them, and the first two.
        for exclus in [[1, 2, 0, 9, 20], [20, 0, 2, 1, 5], [0, 20, 19, 2, 1], [2, 9, 1, 20, 0]] {
            let [a, b, c, d, e] = exclus.map(|k| move |objet| objet != k);
            let (h1, reste) = (hierarchie.parmi(&a), |objet: &usize| !exclus.contains(objet));
            let (h2, voulus) = (h1.parmi(&b), tous.iter().copied().filter(reste));
            let h3 = h2.parmi(&c);
            let h4 = h3.parmi(&d);
            let (parmi, voulus) = (h4.parmi(&e), voulus.collect::<Vec<_>>());
            assert_eq!(en_ordre(parmi), voulus);
            let premiere = parmi.premiere_intersection(&rayon);
            assert_eq!(premiere.map(|t| t.objet()), Ok(3));
            let t = premiere.unwrap().distance();
            assert!(parmi.est_occulte(&rayon, t.next_up()) && !parmi.est_occulte(&rayon, t));
            let mut lot = [Err(NoIntersection); 70];
            parmi.premieres_intersections(&[rayon; 70], &mut lot).unwrap();
            assert_eq!(lot, [premiere; 70]);
            let mut occultes = [true; 70];
            parmi.sont_occultes(&[(rayon, t); 70], &mut occultes).unwrap();
            assert_eq!(occultes, [false; 70]);
            // The first of the choice is certain; what any of the five leaves out is no answer.
            assert!(parmi.est_certaine(&rayon, &premiere));
            for nue in &nues {
                let lui = nue.unwrap().objet();
                assert_eq!(parmi.est_certaine(&rayon, nue), lui == 3, "{lui}");
            }
        }
    }
}

/// Flush cubes, of which a ray along the seams touches two at a time. In order all of them are there; whoever goes on
/// from hit to hit with `secondaire` loses some.
fn un_rayon_dans_les_joints_ne_perd_aucun_cube<R: Reel>() {
    let mut scene = Vec::new();
    for (x, y, z) in (0..216).map(|i| (i % 6, i / 6 % 6, i / 36)) {
        let place = |i: i32| f64::from(i) + 0.5;
        scene.push(cube(v(place(x), place(y), place(z))));
    }
    let mut places = vec![0.0; Hierarchie::places(scene.len())];
    let hierarchie = Hierarchie::new(&scene, &mut places).unwrap();
    let mut perdus = 0;
    for i in 0..6 {
        // Into the seams between two layers, exactly: y + z stays whole.
        let s = v(-1.0, f64::from(i) + 1.0, 0.25);
        let rayon = Rayon::new(s, v(1.0, 0.0, if i % 2 == 0 { 0.0 } else { 0.125 })).unwrap();
        let mut attendus: Vec<_> = scene
            .iter()
            .enumerate()
            .filter_map(|(i, objet)| Some((objet.intersection(&rayon).ok()?.distance(), i)))
            .collect();
        attendus.sort_by(|a, b| a.partial_cmp(b).unwrap());
        let attendus: Vec<_> = attendus.into_iter().map(|(_, indice)| indice).collect();
        let mut touches = vec![Err(NoIntersection); scene.len()];
        let nombre = hierarchie.dans_l_ordre(&rayon, R::INFINI, &mut touches);
        assert_eq!(indices(&touches[..nombre]), attendus, "{rayon:?}");
        assert!(touches[..nombre].iter().flatten().all(|touche| touche.marge() < R::INFINI));
        let mut pas_a_pas = Vec::new();
        let mut suite = rayon;
        while let Ok(touche) = hierarchie.premiere_intersection(&suite) {
            pas_a_pas.push(touche.objet());
            suite = suite.secondaire(&touche, suite.direction()).unwrap();
        }
        perdus += attendus.len() - pas_a_pas.len();
    }
    assert!(perdus > 5, "stepping lost {perdus} cubes alone");
}

en_f32_et_f64!(un_rayon_dans_les_joints_ne_perd_aucun_cube);

/// The recipe of two hierarchies, one of what stays and one of what moves, beside one list of both. Some of what moves
/// stands where something of what stays does: then what stays is the first.
fn deux_hierarchies_repondent_comme_une_liste<R: Reel>() {
    let tout = melange::<R>(300);
    let fixes = &tout[..200];
    let mobiles = [&tout[200..], &tout[..40]].concat();
    let (mut a, mut b) =
        (vec![0.0; Hierarchie::places(200)], vec![0.0; Hierarchie::places(mobiles.len())]);
    let fixe = Hierarchie::new(fixes, &mut a).unwrap();
    let mobile = Hierarchie::new(&mobiles, &mut b).unwrap();
    let ensemble = [fixes, &mobiles].concat();
    let (mut de_mobile, mut ex_aequo) = (0, 0);
    for rayon in rayons_camera::<R>(60, 40) {
        let de_fixe = fixe.premiere_intersection(&rayon);
        let avant = de_fixe.map_or(R::INFINI, |touche| touche.distance());
        let plus_pres = mobile.premiere_avant(&rayon, avant);
        let apres = |touche: Intersection<R>| (fixes.len() + touche.objet(), touche.distance());
        let trouvee = plus_pres.map(apres).or(de_fixe.map(|t| (t.objet(), t.distance())));
        let voulue = premiere_intersection(&ensemble, &rayon).map(|t| (t.objet(), t.distance()));
        assert_eq!(trouvee, voulue, "{rayon:?}");
        de_mobile += u32::from(plus_pres.is_ok());
        let egale = mobile.premiere_intersection(&rayon).is_ok_and(|t| t.distance() == avant);
        ex_aequo += u32::from(egale);
    }
    assert!(de_mobile > 20 && ex_aequo > 20, "{de_mobile} of what moves, {ex_aequo} at one place");
}

en_f32_et_f64!(deux_hierarchies_repondent_comme_une_liste);

/// A half-space and a sky of shells: every one that the ray enters, in order; those around its source it does not enter.
fn des_coques_dans_l_ordre<R: Reel>() {
    let coque = |x: f64, r: f64| {
        SphereGeo::new(v(x, 0.0, 0.0), R::depuis_f64(r), Texture(0)).unwrap().into()
    };
    let mur = PlanGeo::par_un_point(v(20.0, 0.0, 0.0), v(-1.0, 0.0, 0.0), Texture(1)).unwrap();
    let scene: [ObjetRay<R>; 5] =
        [mur.into(), coque(10.0, 1.0), coque(0.0, 50.0), coque(10.0, 3.0), coque(10.0, 2.0)];
    let rayon = Rayon::new(Vecteur::NUL, v(1.0, 0.0, 0.0)).unwrap();
    let mut touches = [Err(NoIntersection); 5];
    let hierarchie = Hierarchie::de_liste(&scene);
    assert_eq!(hierarchie.dans_l_ordre(&rayon, R::INFINI, &mut touches), 4);
    assert_eq!(indices(&touches), [3, 4, 1, 0]);
    let distances: Vec<_> = touches.iter().flatten().map(|t| t.distance().vers_f64()).collect();
    assert_eq!(distances, [7.0, 8.0, 9.0, 20.0]);
    assert_eq!(touches[4], Err(NoIntersection));
}

en_f32_et_f64!(des_coques_dans_l_ordre);
