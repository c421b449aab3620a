//! `erreur` and `est_certain` where doubled numbers themselves reach their limits (`docs/preuves/objets.md`, lemmas 16
//! and 17): numbers of few bits over the whole range, exactly on a surface, in the plane of a face, or a little beside
//! it.

use commun::fabrique::{boite, boite_droite, mur, sphere, v};
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::oracle::{Passage, norme_au_carre_moins_un, verite};
use commun::promesses::{Essai, coup_d_oeil, erreur, est_certain};
use commun::regimes::{Cas, Extreme, direction, entre, regimes};
use commun::tolerances::u;
use commun::{arrondi, en_f32_et_f64};
use lancer_rayon::{
    BoiteGeo, ErreurGeo, Monde, Nombre, ObjetRay, PlanGeo, Rayon, Reel, Rotation, SphereGeo,
    Texture, Vecteur, premiere_intersection,
};

/// An answer is right or not called certain, and no distance is bounded where there is no entry.
#[track_caller]
fn juger<R: Reel>(objet: ObjetRay<R>, rayon: Rayon<R>) {
    let (passage, vers) = (Passage::Entree, [R::ZERO; 5]);
    let essai = Essai { objets: vec![objet], rayon, passage, vers };
    let parts = [est_certain(&essai), erreur(&essai)];
    assert!(parts.iter().all(|part| *part <= 1.0), "{parts:?} {essai:?}");
}

/// Exact cases at the end of doubled numbers. |CP| is half a subnormal short of r, a hit. A ray is parallel to a face
/// and half a subnormal outside, a miss. A is exactly on the sphere, with w = 2⁻⁵⁴⁰ there, whose square is below all
/// numbers, a hit.
#[test]
fn un_demi_sous_normal_et_un_carre_perdu_decident() {
    let peu = f64::ETA;
    let rayon = |s, d| Rayon::new(s, d).unwrap();
    let boule = sphere(Vecteur::new(0.0, peu, 0.0), 0.5);
    juger(boule, rayon(Vecteur::new(-5.0, 0.5, 0.0), Vecteur::X));
    let m = [[0.28, 0.96, 0.0], [-0.96, 0.28, 0.0], [0.0, 0.0, 1.0]];
    let (c, cotes) = (Vecteur::new(-peu, 0.0, 0.0), Vecteur::new(0.56, 4.0, 2.0));
    let boite = boite(c, cotes, Rotation::depuis_matrice(m).unwrap());
    juger(boite, rayon(Vecteur::new(1.0, 0.0, 5.0), -Vecteur::Z));
    let [r, loin, peu, pente] = [-440.0, -300.0, -400.0, -100.0].map(f64::exp2);
    let d = Vecteur::new(1.0, 0.0, pente);
    juger(sphere(Vecteur::NUL, r), rayon(Vecteur::new(-loin, 0.0, r - peu), d));
}

/// A distance that rounds to +∞ is a miss (C7), but here the search answers the largest number. It does so too where
/// the entry lies less than half a unit in the last place beyond that number. Neither answer is certain.
#[test]
fn une_distance_que_le_type_ne_contient_pas_n_est_pas_sure() {
    let deux = |k: f32| k.exp2();
    let n = deux(-93.0) * 0.99;
    let penche = [[0.0, 0.0, 1.0], [1.0, -n, 0.0], [n, 1.0, 0.0]];
    let haut = Rotation::IDENTITE.matrice();
    for (m, d, s, vers) in [
        (penche, deux(35.0) * 0.99, [0.0, deux(60.0) - deux(36.0), 0.0], [1.0, -deux(-68.0), 0.0]),
        (haut, deux(33.0), [0.0, 0.0, (1.0 - f32::U) * deux(60.0)], [1.0, 0.0, -deux(-68.0)]),
    ] {
        let rotation = Rotation::depuis_matrice(m).unwrap();
        let mur = ObjetRay::from(PlanGeo::new(rotation, d, Texture(0)).unwrap());
        let rayon = Rayon::new(s.into(), vers.into()).unwrap();
        assert_eq!(mur.intersection(&rayon).unwrap().distance(), f32::MAX);
        assert!(verite(&mur, &rayon).entree.unwrap().ecart(f32::MAX) < 0.0);
        assert!(!mur.est_certain(&rayon));
        juger(mur, rayon);
    }
}

/// From a few subnormals over a half-space through O, where heights are all rounding, a glance
/// leaves no entry out.
#[test]
fn a_quelques_sous_normaux_un_coup_d_oeil_ne_perd_aucune_entree() {
    let faire = |alea: &mut Hasard| {
        let source = [(); 3].map(|()| f64::from(alea.i8(-9..=9)) * f64::ETA);
        (mur(Vecteur::NUL, direction(alea)), Rayon::new(source.into(), direction(alea)).unwrap())
    };
    let mut entrees = 0;
    pour_chaque(4_000, faire, |(objet, rayon)| {
        entrees += u32::from(verite(&objet, &rayon).entree.is_some());
        let essai = Essai { objets: vec![objet], rayon, passage: Passage::Entree, vers: [0.0; 5] };
        assert!(coup_d_oeil(&essai) <= 1.0, "{essai:?}");
    });
    assert!(entrees > 500, "{entrees}");
}

/// Where a ray meets a plane at nearly the largest distance, the point overflows, even in doubled numbers. The bound is
/// then a number or +∞, and at least the error.
#[test]
fn au_bord_de_l_infini_une_erreur_n_est_pas_un_nan() {
    let plan = ObjetRay::from(PlanGeo::new(Rotation::IDENTITE, 2.0, Texture(0)).unwrap());
    let (mut touches, mut infinies) = (0, 0);
    for i in 0..200_u64 {
        let z = f64::MIN_POSITIVE * (1.125 + i as f64 * f64::EPSILON);
        for x in [1.0_f64.next_up().next_up().next_up(), 1.0, 1.0_f64.next_down()] {
            for haut in [2.5, 2.4, 2.49] {
                let source = Vecteur::new(-5.5, -5.5, haut);
                let rayon = Rayon::new(source, Vecteur::new(x, 0.0, -z)).unwrap();
                let Ok(touche) = plan.intersection(&rayon) else { continue };
                let erreur = plan.erreur(&rayon, &touche);
                assert!(erreur >= 0.0, "{erreur}: {touche:?} {rayon:?}");
                touches += 1;
                infinies += u32::from(erreur == f64::INFINITY);
            }
        }
    }
    assert!(touches > 500 && infinies > 0, "{touches} {infinies}");
}

/// A ray that passes an edge of a turned box at some 2⁻⁵⁰ to 2⁻⁹⁰ of its distance misses exactly, and the miss is
/// certain.
#[test]
fn un_manque_a_cote_d_une_arete_est_sur() {
    let mut manques = 0;
    let faire = |alea: &mut Hasard| {
        let tour = Rotation::new(direction(alea) * 3.0).unwrap();
        let cotes = Vecteur::new(2.0, 1.0, 3.0);
        let boite = BoiteGeo::new(direction(alea), cotes, tour, Texture(0)).unwrap().vers_ray();
        let ([u, v, w], [a, b, c]) = (boite.normales(), boite.demi_longueurs());
        let arete = boite.centre() + u * a + v * b + w * (c * entre(alea, -0.9, 0.9));
        let source = arete + u * entre(alea, -3.0, -0.1) + v * entre(alea, 0.1, 3.0);
        let a_cote = arete + (u + v) * entre(alea, -90.0, -48.0).exp2();
        (ObjetRay::from(boite), Rayon::new(source, a_cote - source).unwrap())
    };
    pour_chaque(20_000, faire, |(boite, rayon)| {
        if verite(&boite, &rayon).entree.is_none() && boite.intersection(&rayon).is_err() {
            assert!(boite.est_certain(&rayon));
            manques += 1;
        }
    });
    assert!(manques > 1_000, "{manques}");
}

/// A ray along an axis of a turned box, through its middle or past it: as far as doubled numbers tell, the ray neither
/// nears nor leaves the faces across the other axes.
#[test]
fn le_long_d_une_face_tournee_une_reponse_est_sure() {
    let faire = |alea: &mut Hasard| (entre(alea, -3.0, 3.0), entre(alea, -0.9, 0.9));
    pour_chaque(1_000, faire, |(angle, a_cote)| {
        let rotation = Rotation::new(Vecteur::new(0.0, angle, 0.0)).unwrap();
        let cotes = Vecteur::new(2.0, 2.0, 2.0);
        let boite = BoiteGeo::new(Vecteur::NUL, cotes, rotation, Texture(0)).unwrap().vers_ray();
        let [u, v, w] = boite.normales();
        let boite = ObjetRay::from(boite);
        let vers_le_fond = |source| Rayon::new(source, -w).unwrap();
        let rayon = vers_le_fond(w * 5.0 + u * a_cote);
        let touche = boite.intersection(&rayon).unwrap();
        assert!(boite.est_certain(&rayon) && boite.erreur(&rayon, &touche) < 1e-14);
        for cote in [u, v] {
            assert!(boite.est_certain(&vers_le_fond(w * 5.0 + cote * 1.2)));
        }
    });
}

/// For ordinary rays every right answer is certain, and `erreur` is the error itself, what D lacks to length 1 and a
/// rounding of t.
fn une_reponse_juste_est_sure<R: Reel>() {
    let (mut touches, mut pire) = (0, 0.0_f64);
    for regime in regimes::<R>().into_iter().filter(|regime| regime.extreme == Extreme::Aucun) {
        pour_chaque(
            300,
            |alea| (regime.cas)(alea),
            |Cas { objet, rayon }| {
                let (touche, entree) = (objet.intersection(&rayon), verite(&objet, &rayon).entree);
                assert_eq!(objet.est_certain(&rayon), touche.is_ok() == entree.is_some());
                if let (Ok(touche), Some(entree)) = (touche, entree) {
                    let t = touche.distance();
                    let d = norme_au_carre_moins_un(rayon.direction()) / 2.0;
                    let de_d = t.vers_f64() * d.abs();
                    let attendue = entree.ecart(t).abs() + de_d + (t * R::U).vers_f64();
                    pire = pire.max(objet.erreur(&rayon, &touche).vers_f64() / attendue);
                    touches += 1;
                }
            },
        );
    }
    // In `f32` a glance may leave a sixty-fourth of u·t open; the rest rounds by some 27u.
    assert!(touches > 300 && pire < 1.0 + 1.0 / 60.0, "{touches} {pire}");
}

en_f32_et_f64!(une_reponse_juste_est_sure);

/// Whether exact arithmetic has a hit, whether the search answers one, and whether that answer is certain.
#[track_caller]
fn exiger<R: Reel>(objet: ObjetRay<R>, rayon: Rayon<R>, attendu: [bool; 3]) {
    let exacte = verite(&objet, &rayon).entree.is_some();
    let dit = [exacte, objet.intersection(&rayon).is_ok(), objet.est_certain(&rayon)];
    assert_eq!(dit, attendu, "{objet:?} {rayon:?}");
    juger(objet, rayon);
}

#[test]
fn la_ou_des_nombres_exacts_decident_seul_ce_qui_est_exact_est_sur() {
    let rayon = |s, d| Rayon::new(s, d).unwrap();
    // A face whose plane holds the ray excludes no hit, and one that the ray runs beside excludes all, since the
    // products are exact.
    let cube = boite_droite(Vecteur::NUL, v(2.0, 2.0, 2.0));
    for (y, touche) in [(1.0, true), (1.0_f64.next_up(), false), (-1.0, true)] {
        exiger(cube, rayon(v(-5.0, y, 0.0), Vecteur::X), [touche, touche, true]);
    }
    // In the plane of a face that is slightly turned, exactly and along it, whatever the distance rounds to: N·S is 1.
    let y = 3.0 * (-28_f64).exp2();
    let tour = Rotation::depuis_matrice([[1.0, y, 0.0], [-y, 1.0, 0.0], [0.0, 0.0, 1.0]]).unwrap();
    let tourne = boite(Vecteur::NUL, v(2.0, 2.0, 2.0), tour);
    for x in [-4.0, -4.75, -5.5] {
        exiger(tourne, rayon(v(x, 1.0 + y * x, 0.0), v(1.0, y, 0.0)), [true; 3]);
    }
    // The source lies exactly on a turned face and on the top, but no product shows that of the face, and rounding
    // lifts it. The first length is 2(5a − 3b), exactly.
    let (a, b) = (0.6 - 8.0 * f64::U, 0.8 + 4.0 * f64::U);
    let m = [[a, b, 0.0], [-b, a, 0.0], [0.0, 0.0, 1.0]];
    let cotes = Vecteur::new(f64::from_bits(0x3fe3_3333_3333_32fd) * 2.0, 14.0, 2.0);
    let souleve = boite(Vecteur::NUL, cotes, Rotation::depuis_matrice(m).unwrap());
    let depart = rayon(v(5.0, -3.0, 1.0), v(-3.0, -4.0, -5.0));
    exiger(souleve, depart, [false, true, false]);
    // A ray touches an edge exactly, for it comes under one face when it leaves another, each at 3/4. The search, which
    // loses a bit of S − C, sees a miss.
    let [x, y] = [2_516_582.0_f32, 3_355_444.0].map(|k| k / 4_194_304.0);
    let source = Vecteur::new(x * -0.75, y * 0.75 + 1.0, 0.0);
    let longue = boite_droite(v(-8.0, 0.0, 0.0), v(16.0, 2.0, 2.0));
    let par_l_arete = Rayon::new(source, Vecteur::new(x, -y, 0.0)).unwrap();
    exiger(longue, par_l_arete, [true, false, false]);
    // A ray is tangent at (3, 4)·m exactly, but no product shows that it goes at a right angle to the radius there, and
    // rounding lets it in.
    let [s, m] = [0x3fc9_9999_9999_9998, 0x3fc9_9986_8000_0000].map(f64::from_bits);
    let (d, contact) = (v(4.0 * s, -3.0 * s, 0.0), v(3.0 * m, 4.0 * m, 0.0));
    exiger(sphere(Vecteur::NUL, 5.0 * m), rayon(contact - d, d), [false, true, false]);
    // The source is above one face, from which the ray goes away, and in the plane of another as far as can be told.
    for k in [-30.0, -45.0, -60.0, -100.0] {
        let [loin, haut, pente] = [-110.0, -64.0, k].map(f32::exp2);
        let cube = boite_droite(Vecteur::new(loin, 0.0, haut), v(2.0, 2.0, 2.0));
        let monte = Rayon::new(v(1.0, 0.0, -1.0), Vecteur::new(-pente, 0.0, -1.0)).unwrap();
        exiger(cube, monte, [false, false, true]);
    }
    // Doubled numbers cannot tell whether a direction within 2⁻¹⁰⁰ of the plane of a turned floor comes down, however
    // high S is. They can where the ray is a little steeper, and along an axis.
    let [a, b, x, y, z] = [
        0x3fec_2dd5_38e2_9bb5,
        0x3fde_53e2_a5c9_57b2,
        0xbfc8_137b_efdd_2b28,
        0x3fd6_5ed0_f46b_c116,
        0x3fed_5f01_ee55_05ff,
    ]
    .map(f64::from_bits);
    let n = Vecteur::new(a, b, 0.0);
    let penche = mur(Vecteur::NUL, n);
    exiger(penche, rayon(n, Vecteur::new(x, y, z)), [false; 3]);
    exiger(penche, rayon(n, Vecteur::new(x, y - 1e-14, z)), [true; 3]);
    let (plat, peu) = (mur(Vecteur::NUL, Vecteur::Y), (-106_f64).exp2());
    for (pente, touche) in [(0.0, false), (peu, false), (-peu, true)] {
        exiger(plat, rayon(Vecteur::Y, v(1.0, pente, 0.0)), [touche, touche, true]);
    }
}

/// From a source exactly on the surface of an object no ray enters it, whichever way it goes. This miss is certain.
fn depuis_la_surface_un_manque_est_sur<R: Reel>() {
    let boule = sphere(Vecteur::NUL, R::depuis_f64(5.0));
    let (boite, sol) =
        (boite_droite(Vecteur::NUL, v(2.0, 4.0, 6.0)), mur(Vecteur::NUL, Vecteur::Z));
    let cas = [(sol, v(7.0, 5.0, 0.0)), (boule, v(0.0, 4.0, 3.0)), (boite, v(0.5, 1.0, 3.0))];
    for (objet, source) in cas {
        for (x, y) in [(0.0, 0.0), (0.5, 0.25), (-0.25, 0.125)] {
            for z in [-1.0, 1.0] {
                exiger(objet, Rayon::new(source, v(x, y, z)).unwrap(), [false, false, true]);
            }
        }
    }
}

en_f32_et_f64!(depuis_la_surface_un_manque_est_sur);

/// A long box, and a source some roundings under a face along which the ray goes to rounding: it may leave the box by that
/// face before it enters by another, far along. (Whether it rises towards the face is not known at a glance, so that the
/// face bounds the way out, J3.)
fn sous_une_face_qu_il_longe_rien_de_faux_n_est_sur<R: Reel>() {
    let u = u::<R>();
    let [mut fausses, mut sures] = [0; 2];
    let faire = |alea: &mut Hasard| {
        let tour = Rotation::<R>::new(arrondi(direction(alea) * 3.0)).unwrap();
        let boite = boite(Vecteur::NUL, v(2.0, 200.0, 2.0), tour);
        let [x, y, z] = tour.axes().map(Vecteur::vers_f64);
        let sous = 1.0 - u * entre(alea, 5.0, 65.0);
        let source = x * entre(alea, 1.0, 2.0) + y * entre(alea, -2.0, 2.0) + z * sous;
        let d = y - x * entre(alea, 0.01, 0.11) + z * (u * entre(alea, -4.0, 4.0));
        (boite, Rayon::new(arrondi(source), arrondi(d)).unwrap())
    };
    pour_chaque(20_000, faire, |(objet, rayon)| {
        let exacte = verite(&objet, &rayon).entree.is_some();
        let sure = objet.est_certain(&rayon);
        let juste = objet.intersection(&rayon).is_ok() == exacte;
        assert!(juste || !sure, "{objet:?} {rayon:?}");
        fausses += u32::from(!juste);
        sures += u32::from(sure);
    });
    assert!(fausses > 50 && sures > 15_000, "{fausses} {sures}");
}

en_f32_et_f64!(sous_une_face_qu_il_longe_rien_de_faux_n_est_sur);

/// The places where the documents say that a right answer may be uncertain, and places just beside them.
#[test]
fn une_reponse_juste_n_est_incertaine_qu_ou_on_le_dit() {
    // A plate 2⁻⁶⁰ thick.
    let deux = |k: f32| k.exp2();
    let cotes = Vecteur::new(deux(60.0), deux(60.0), deux(-60.0));
    let plaque = boite_droite(Vecteur::NUL, cotes);
    for (k, sure) in [(38.0, true), (45.0, false)] {
        let (s, d) = (Vecteur::new(0.0, 0.0, deux(k)), Vecteur::new(0.1, 0.05, -1.0));
        let rayon = Rayon::new(s, d).unwrap();
        assert!(plaque.intersection(&rayon).is_ok());
        assert_eq!(plaque.est_certain(&rayon), sure, "{k}");
    }
    // A sphere of radius 2⁻³⁸ of its distance: one ray passes its outline by 2⁻⁶⁹, one farther out.
    let b = f32::from_bits;
    let c = Vecteur::new(b(0x3f39_7e2d), b(0x37fc_5035), b(0x3f30_6eb2));
    let boule = sphere(c, deux(-38.0));
    for (y, sure) in [(0x37fc_5033, false), (0x37fc_5034, true)] {
        let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(c.x, b(y), c.z)).unwrap();
        assert_eq!(boule.est_certain(&rayon), sure, "{y:x}");
    }
    // Two cubes, one a little in front of the other.
    for (k, certaine) in [(-50.0, true), (-54.0, false)] {
        let cube = |z| {
            let (c, cotes) = (Vecteur::new(0.0, 0.0, z), Vecteur::new(1.0, 1.0, 1.0));
            boite_droite(c, cotes)
        };
        let cubes = [cube(0.0), cube(-deux(k))];
        let (s, d) = (Vecteur::new(0.0, 0.0, 1.0), Vecteur::new(0.0, 0.0, -1.0));
        let rayon = Rayon::new(s, d).unwrap();
        let touche = premiere_intersection(&cubes, &rayon);
        assert_eq!(touche.map(|touche| touche.indice()), Ok(0));
        assert_eq!(Monde::de_liste(&cubes).certifie(&rayon, &touche), certaine, "{k}");
    }
}

/// Along a face, where nothing but N·D is exact, a right hit is certain and its distance bounded.
fn dans_le_plan_d_une_face_un_contact_est_sur<R: Reel>() {
    let mut touches = 0;
    let faire = |alea: &mut Hasard| {
        let centre = v(entre(alea, -1.0, 1.0), 0.5, entre(alea, -1.0, 1.0));
        (centre, [-0.5, 1.5].map(|y| (y, entre(alea, -0.3, 0.3))))
    };
    pour_chaque(1_000, faire, |(centre, rayons)| {
        let boite: ObjetRay<R> = boite_droite(centre, v(2.0, 2.0, 3.0));
        for (y, pente) in rayons {
            let rayon = Rayon::new(v(-5.0, y, 0.0), v(1.0, 0.0, pente)).unwrap();
            let Ok(touche) = boite.intersection(&rayon) else { continue };
            assert!(boite.est_certain(&rayon));
            assert!(boite.erreur(&rayon, &touche) < R::U * R::depuis_f64(64.0));
            touches += 1;
        }
    });
    assert!(touches > 1_000, "{touches}");
}

en_f32_et_f64!(dans_le_plan_d_une_face_un_contact_est_sur);

/// A number of few bits: 0, a power of two, or a power of two and a far smaller one.
fn creux<R: Reel>(alea: &mut Hasard) -> R {
    let fond = R::ETA.vers_f64().log2() as i32;
    let mut dans =
        |debut: i32, fin: i32| debut + alea.usize(0..debut.abs_diff(fin) as usize) as i32;
    let k = if dans(0, 2) == 1 { dans(-8, 9) } else { dans(fond, -fond / 3) };
    let ecart = if dans(0, 2) == 1 { 60 } else { -fond };
    let plus_bas = (k - dans(1, ecart + 1)).max(fond);
    let [a, b] = [k, plus_bas].map(|k| f64::from(k).exp2());
    let x = *alea.choix(&[0.0, a, a, a + b, a - b]);
    R::depuis_f64(if alea.bool() { x } else { -x })
}

fn triple<R: Reel>(alea: &mut Hasard) -> Vecteur<R> {
    Vecteur::new(creux(alea), creux(alea), creux(alea))
}

/// An object and a ray of such numbers. More often than not the ray runs along an axis of the object, from a place on
/// its surface or at some distance back along the ray.
fn essai<R: Reel>(alea: &mut Hasard) -> Result<(ObjetRay<R>, Rayon<R>), ErreurGeo> {
    let (peu, e) = (creux::<R>(alea), entre(alea, 0.0, 6.0));
    let m = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|l| l.map(R::depuis_f64)),
        [[0.28, 0.96, 0.0], [-0.96, 0.28, 0.0], [0.0, 0.0, 1.0]].map(|l| l.map(R::depuis_f64)),
        [[e.cos(), 0.0, -e.sin()], [0.0, 1.0, 0.0], [e.sin(), 0.0, e.cos()]]
            .map(|l| l.map(R::depuis_f64)),
        [[R::UN, -peu, R::ZERO], [peu, R::UN, R::ZERO], [R::ZERO, R::ZERO, R::UN]],
    ][alea.usize(0..4)];
    let rotation = Rotation::depuis_matrice(m)?;
    let axes = m.map(Vecteur::from);
    let d = match alea.u8(0..4) {
        0 => triple(alea),
        1 => Vecteur::new(R::UN, creux(alea), creux(alea)),
        _ => axes[alea.usize(0..3)],
    };
    let d = if alea.bool() { d } else { -d };
    // Or the centre is the smallest number beside O, while the surface is taken around O.
    let mut moindre = [R::ZERO; 3];
    moindre[alea.usize(0..3)] = if alea.bool() { R::ETA } else { -R::ETA };
    let quelconque = triple(alea);
    let (centre, autour) =
        [(Vecteur::NUL, Vecteur::NUL), (moindre.into(), Vecteur::NUL), (quelconque, quelconque)]
            [alea.usize(0..3)];
    let [a, b, c] = <[R; 3]>::from(triple::<R>(alea)).map(R::absolu);
    let cote = |alea: &mut Hasard, l: R| [l, -l, creux(alea)][alea.usize(0..3)];
    let bord = axes[0] * cote(alea, a) + axes[1] * cote(alea, b) + axes[2] * cote(alea, c);
    let (objet, bord) = match alea.u8(0..3) {
        0 => {
            let bord = axes[alea.usize(0..3)] * a;
            (SphereGeo::new(centre, a, Texture(0))?.into(), autour + bord)
        }
        1 => (PlanGeo::new(rotation, a, Texture(0))?.into(), axes[2] * -a + axes[0] * b),
        _ => {
            let cotes = Vecteur::new(a, b, c) * R::depuis_f64(2.0);
            (BoiteGeo::new(centre, cotes, rotation, Texture(0))?.into(), autour + bord)
        }
    };
    let source =
        if alea.u8(0..4) > 0 { bord - d * creux::<R>(alea).absolu() } else { triple(alea) };
    Ok((objet, Rayon::new(source, d)?))
}

fn rien_de_faux_n_est_sur<R: Reel>() {
    let [mut surs, mut incertains] = [0; 2];
    pour_chaque(commun::cas(40_000), essai::<R>, |essai| {
        let Ok((objet, rayon)) = essai else { return };
        juger(objet, rayon);
        let sur = objet.est_certain(&rayon);
        surs += u32::from(sur);
        incertains += u32::from(!sur);
    });
    assert!(surs > commun::cas(15_000) && incertains > surs / 100, "{incertains} of {surs}");
}

en_f32_et_f64!(rien_de_faux_n_est_sur);
