//! Glass: light enters, leaves by Snell's law, and finds what the glass stands on.

use commun::fabrique::{boite, boite_droite, mur, sphere, v};
use commun::oracle::{Passage, verite_du};
use commun::regimes::{direction, entre};
use commun::tolerances::{promesses, u};
use commun::{arrondi, en_f32_et_f64};
use fastrand::Rng;
use lancer_rayon::{
    BoiteGeo, Etendue, Monde, NoIntersection, ObjetRay, PlanGeo, Rayon, Reel, Rotation, SphereGeo,
    Texture, Vecteur, places,
};

/// Rays that leave a glass through its bottom, of each glass.
const RAYONS: u32 = 10_000;

/// A half-space or a slab whose top is at this height, and a box or a ball of glass that stands on it: computed as one
/// computes them, so that what should be one height is now and then two.
fn sur_une_table<R: Reel>(ronde: bool, alea: &mut Rng) -> [ObjetRay<R>; 2] {
    let nombre = |x: f64| R::depuis_f64(x);
    let deux = nombre(2.0);
    let plateau = nombre([0.0, 0.75, 1.05, 9.9][alea.usize(..4)]);
    let (epaisseur, haut) = (nombre(entre(alea, 0.02, 0.2)), nombre(entre(alea, 0.05, 1.0)));
    let table = if alea.bool() {
        let ou = Vecteur::new(R::ZERO, plateau, R::ZERO);
        let haut = Vecteur::new(R::ZERO, R::UN, R::ZERO);
        mur(ou, haut)
    } else {
        let centre = Vecteur::new(R::ZERO, plateau - epaisseur / deux, R::ZERO);
        let cotes = Vecteur::new(nombre(8.0), epaisseur, nombre(8.0));
        boite_droite(centre, cotes)
    };
    let centre = Vecteur::new(nombre(0.3), plateau + haut / deux, nombre(-0.2));
    let verre = if ronde {
        SphereGeo::new(centre, haut / deux, Texture(1)).unwrap().into()
    } else {
        let tour = Rotation::new(Vecteur::new(R::ZERO, nombre(entre(alea, -1.0, 1.0)), R::ZERO));
        let cotes = Vecteur::new(nombre(0.4), haut, nombre(0.3));
        BoiteGeo::new(centre, cotes, tour.unwrap(), Texture(1)).unwrap().into()
    };
    [table, verre]
}

/// Every ray out through the bottom lands on the table, and every ray out through a side does not stop there.
fn la_lumiere_trouve_la_table_sous_le_verre<R: Reel>() {
    let mut alea = Rng::with_seed(60);
    for ronde in [false, true] {
        let (mut par_dessous, mut naifs, mut par_un_cote) = (0, 0, 0);
        while par_dessous < RAYONS {
            let scene = sur_une_table::<R>(ronde, &mut alea);
            let mut places = vec![0.0; places(scene.len())];
            let monde = Monde::new(&scene, &mut places).unwrap();
            let Etendue { bas, haut } = scene[1].etendue().unwrap();
            let milieu = ((bas + haut) / R::depuis_f64(2.0)).vers_f64();
            for _ in 0..200 {
                let oeil = milieu + Vecteur::new(0.0, 1.0, 0.0) + direction(&mut alea) * 0.9;
                let cible = milieu + direction(&mut alea) * (0.4 * alea.f64());
                let rayon = Rayon::new(arrondi(oeil), arrondi(cible - oeil)).unwrap();
                let Some(entree) = monde.premiere_intersection(&rayon).ok() else { continue };
                if entree.indice() != 1 {
                    continue;
                }
                // To the bottom, of a ball next to where it touches the table; or bent, as glass does.
                let bas = Vecteur::new(milieu.x, bas.y.vers_f64(), milieu.z);
                let fin = alea.f64() * if ronde { 1e-6 } else { 0.1 };
                let p = entree.point().vers_f64();
                let vers = if alea.bool() {
                    arrondi(bas + direction(&mut alea) * fin - p)
                } else {
                    rayon.direction() - entree.normale() * R::depuis_f64(0.5)
                };
                let Ok(dedans) = entree.secondaire(vers) else { continue };
                let touche = monde.sans(1).premiere_intersection(&dedans).ok();
                let Ok(sortie) = scene[1].sortie(&dedans) else { continue };
                let n = sortie.normale().vers_f64();
                let dehors = sortie.secondaire(dedans.direction()).unwrap();
                let posee = touche.filter(|t| t.distance() < sortie.distance());
                let contexte = || format!("{scene:?} {dedans:?} {sortie:?}");
                let dessous = n.y < if ronde { -0.999_999 } else { -0.5 };
                let arrive = monde.premiere_intersection(&dehors);
                let arrive = posee.or(arrive.ok());
                if dessous {
                    // It lands there, whether the light goes straight in or crosses what air is left.
                    assert_eq!(arrive.map(|t| t.indice()), Some(0), "through: {}", contexte());
                    naifs += u32::from(scene[0].contient(dehors.source()));
                    par_dessous += 1;
                } else if n.y > -0.999 {
                    assert!(posee.is_none(), "not out through a side: {}", contexte());
                    // Downward it lands beside the glass, upward nowhere: the slab is wide enough.
                    let descend = dedans.direction().y < R::ZERO;
                    assert!(arrive.is_none_or(|t| descend && t.indice() == 0), "{}", contexte());
                    par_un_cote += 1;
                }
            }
        }
        println!(
            "round {ronde}: {par_dessous} through the bottom, {naifs} start in the table, {par_un_cote} beside"
        );
        assert!(par_un_cote > 1_000);
        // Without a word of what they know of their start these would fall through.
        assert!(naifs > if ronde { 0 } else { RAYONS / 4 }, "{naifs}");
    }
}

en_f32_et_f64!(la_lumiere_trouve_la_table_sous_le_verre);

/// A ball, and a slab that stands askew: light leaves a ball at the angle at which it entered, and a slab in the
/// direction in which it came, after the way that the angles tell.
fn la_lumiere_traverse_le_verre_comme_snell_le_dit<R: Reel>() {
    let mut alea = Rng::with_seed(61);
    // Some thirty roundings, where cosines and the way are above a third.
    let permis = 1_000.0 * u::<R>();
    for tour in 0..2_000 {
        let (n, r) = (direction(&mut alea), entre(&mut alea, 0.5, 2.0));
        let centre = arrondi(direction(&mut alea));
        let objet: ObjetRay<R> = if tour % 2 == 0 {
            sphere(centre, R::depuis_f64(r))
        } else {
            let large = R::depuis_f64(50.0);
            let cotes = Vecteur::new(large, R::depuis_f64(2.0 * r), large);
            let angles =
                Vecteur::new(entre(&mut alea, -3.0, 3.0), 0.0, entre(&mut alea, -3.0, 3.0));
            let tour = Rotation::new(arrondi(angles)).unwrap();
            boite(centre, cotes, tour)
        };
        let n = match &objet {
            ObjetRay::Boite(boite) => boite.normales()[1].vers_f64(),
            ObjetRay::Sphere(_) | ObjetRay::Plan(_) => n,
        };
        let p = centre.vers_f64() + n * r;
        let d = (direction(&mut alea) - n * 1.5).unitaire().unwrap();
        let rayon = Rayon::new(arrondi(p - d * 3.0), arrondi(d)).unwrap();
        let entree = objet.intersection(&rayon).unwrap();
        let d = rayon.direction().vers_f64();
        let dedans = entree.refracte(rayon.direction(), R::depuis_f64(1.0 / 1.5)).unwrap();
        assert_eq!(objet.intersection(&dedans), Err(NoIntersection));
        let sortie = objet.sortie(&dedans).unwrap();
        let (di, n) = (dedans.direction().vers_f64(), sortie.normale().vers_f64());
        let biais = -di.produit_scalaire(entree.normale().vers_f64());
        let chemin = if tour % 2 == 0 { 2.0 * r * biais } else { 2.0 * r / biais };
        assert!((sortie.distance().vers_f64() - chemin).abs() < permis, "{rayon:?} {objet:?}");
        let dehors = sortie.refracte(dedans.direction(), R::depuis_f64(1.5)).unwrap();
        let vers = dehors.direction().vers_f64();
        let cosinus = [-d.produit_scalaire(entree.normale().vers_f64()), vers.produit_scalaire(n)];
        assert!((cosinus[0] - cosinus[1]).abs() < permis, "{cosinus:?}");
        assert!(tour % 2 == 0 || (vers - d).longueur() < permis, "{vers:?} {d:?}");
        assert_eq!(objet.intersection(&dehors), Err(NoIntersection));
        assert_eq!(objet.sortie(&dehors), Err(NoIntersection));
    }
}

en_f32_et_f64!(la_lumiere_traverse_le_verre_comme_snell_le_dit);

/// Shells, one within the other: a ray enters each and leaves each, in order, every crossing where exact arithmetic has
/// it; and so does one that starts anew at each crossing.
fn des_coquilles_sont_traversees_dans_l_ordre<R: Reel>() {
    let mut alea = Rng::with_seed(62);
    for tour in 0..500 {
        let centre: Vecteur<R> = arrondi(direction(&mut alea) * 10.0);
        let orientation = Rotation::new(arrondi(direction(&mut alea) * 3.0)).unwrap();
        let coquilles: Vec<ObjetRay<R>> = (0..12)
            .map(|i| {
                let r = R::depuis_f64(4.0 * (-0.2 * f64::from(i)).exp2());
                if tour % 2 == 0 {
                    SphereGeo::new(centre, r, Texture(i)).unwrap().into()
                } else {
                    BoiteGeo::new(centre, Vecteur::new(r, r, r), orientation, Texture(i))
                        .unwrap()
                        .into()
                }
            })
            .collect();
        let d = direction(&mut alea);
        let cible = centre.vers_f64() + direction(&mut alea) * 0.3;
        let rayon = Rayon::new(arrondi(cible - d * 20.0), arrondi(d)).unwrap();
        let entrees = coquilles.iter().map(|coquille| (Passage::Entree, coquille));
        let sorties = coquilles.iter().rev().map(|coquille| (Passage::Sortie, coquille));
        let ordre: Vec<_> = entrees.chain(sorties).collect();
        let touche = |rayon: &Rayon<R>, (passage, objet): (Passage, &ObjetRay<R>)| match passage {
            Passage::Entree => objet.intersection(rayon),
            Passage::Sortie => objet.sortie(rayon),
        };
        let (mut avant, mut suite) = (R::ZERO, rayon);
        for &(passage, objet) in &ordre {
            let t = touche(&rayon, (passage, objet)).unwrap().distance();
            let vrai = verite_du(passage, objet, &rayon).entree.unwrap();
            assert!(vrai.ecart(t).abs() <= vrai.k * u::<R>() * vrai.kappa_t, "{objet:?} {rayon:?}");
            assert!(t > avant, "{objet:?} {rayon:?}");
            avant = t;
            // The step from one to the next.
            let ici = touche(&suite, (passage, objet)).unwrap();
            suite = ici.secondaire(suite.direction()).unwrap();
            assert_eq!(objet.intersection(&suite), Err(NoIntersection));
            assert_eq!(objet.sortie(&suite).is_ok(), passage == Passage::Entree);
        }
    }
}

en_f32_et_f64!(des_coquilles_sont_traversees_dans_l_ordre);

/// From exactly on the surface, and in the plane of a face: every number is exact. A ray leaves at the far side or not
/// at all.
fn de_la_surface_un_rayon_sort_en_face_ou_pas<R: Reel>() {
    let boule = sphere(Vecteur::NUL, R::depuis_f64(5.0));
    let boite = boite_droite(Vecteur::NUL, v(2.0, 4.0, 6.0));
    let sol = ObjetRay::from(PlanGeo::new(Rotation::IDENTITE, R::ZERO, Texture(0)).unwrap());
    let sortie = |objet: &ObjetRay<R>, de, vers| {
        let sortie = objet.sortie(&Rayon::new(de, vers).unwrap()).ok()?;
        assert_eq!(sortie.indice(), 0);
        Some((sortie.distance().vers_f64(), <[f64; 3]>::from(sortie.normale().vers_f64())))
    };
    let (haut, bas) = (v(0.0, 1.0, 0.0), v(0.0, -1.0, 0.0));
    let en_bas = Some((8.0, [0.6, -0.8, 0.0].map(|x| R::depuis_f64(x).vers_f64())));
    assert_eq!(sortie(&boule, v(3.0, 4.0, 0.0), bas), en_bas);
    assert_eq!(sortie(&boule, v(3.0, 4.0, 0.0), haut), None);
    assert_eq!(sortie(&boule, v(5.0, 0.0, 0.0), haut), None); // a tangent
    assert_eq!(sortie(&boule, v(5.0, -9.0, 0.0), haut), None); // and one from afar
    assert_eq!(sortie(&boule, v(0.0, 0.0, 0.0), haut), Some((5.0, [0.0, 1.0, 0.0])));
    assert_eq!(sortie(&boule, v(0.0, 4.0, 0.0), haut), Some((1.0, [0.0, 1.0, 0.0])));
    assert_eq!(sortie(&boule, v(0.0, 9.0, 0.0), haut), None);

    assert_eq!(sortie(&boite, v(0.5, 2.0, 0.0), bas), Some((4.0, [0.0, -1.0, 0.0])));
    assert_eq!(sortie(&boite, v(0.5, 2.0, 0.0), haut), None);
    assert_eq!(sortie(&boite, v(0.5, 1.5, 0.0), haut), Some((0.5, [0.0, 1.0, 0.0])));
    // In the plane of a face, which belongs to the box; beside it; along an edge.
    assert_eq!(sortie(&boite, v(1.0, 0.0, 0.0), haut), Some((2.0, [0.0, 1.0, 0.0])));
    assert_eq!(sortie(&boite, v(1.0, -9.0, 3.0), haut), Some((11.0, [0.0, 1.0, 0.0])));
    assert_eq!(sortie(&boite, v(1.5, 0.0, 0.0), haut), None);
    // Through a corner the first pair gives the normal, as of an entry.
    let coin = sortie(&boite, v(0.0, 1.0, 2.0), v(1.0, 1.0, 1.0));
    assert_eq!(coin.unwrap().1, [1.0, 0.0, 0.0]);

    let (monte, descend) = (v(0.0, 0.0, 1.0), v(0.0, 0.0, -1.0));
    assert_eq!(sortie(&sol, v(0.0, 0.0, -3.0), monte), Some((3.0, [0.0, 0.0, 1.0])));
    assert_eq!(sortie(&sol, v(0.0, 0.0, -3.0), descend), None);
    assert_eq!(sortie(&sol, v(0.0, 0.0, -3.0), haut), None);
    // Level, whatever the signs of its zeros.
    assert_eq!(sortie(&sol, v(0.0, 0.0, -3.0), v(-1.0, -0.0, -0.0)), None);
    assert_eq!(sortie(&sol, v(0.0, 0.0, 0.0), monte), None);
    assert_eq!(sortie(&sol, v(0.0, 0.0, 3.0), descend), None);
    // Too far for the type.
    let pente = Vecteur::new(R::UN, R::ZERO, R::MIN_POSITIF);
    assert_eq!(sortie(&sol, v(0.0, 0.0, -3.0), pente), None);
}

en_f32_et_f64!(de_la_surface_un_rayon_sort_en_face_ou_pas);

/// From within rounding of the surface and along it too: what is inside as computed leaves, and within two radii.
fn d_une_boule_tout_rayon_sort_a_moins_de_deux_rayons<R: Reel>() {
    let mut alea = Rng::with_seed(63);
    let mut dedans = 0;
    for _ in 0..200_000 {
        let (n, r) = (direction(&mut alea), R::depuis_f64(entre(&mut alea, 0.5, 2.0)));
        let boule = sphere(Vecteur::NUL, r);
        let s: Vecteur<R> = arrondi(n * r.vers_f64());
        let au_hasard = direction(&mut alea);
        let tangente = au_hasard - n * au_hasard.produit_scalaire(n);
        let penche = (-70.0 * alea.f64()).exp2();
        let rayon =
            Rayon::new(s, arrondi(tangente + n * if alea.bool() { penche } else { -penche }));
        let sortie = boule.sortie(&rayon.unwrap());
        if s.longueur_carree() < r * r {
            let t = sortie.unwrap().distance();
            // A root, and three roundings of SA and AB each.
            let plus = 1.0 + promesses::DISTANCE_SPHERE * u::<R>();
            assert!(t > R::ZERO && t.vers_f64() <= 2.0 * r.vers_f64() * plus, "{boule:?} {s:?}");
            dedans += 1;
        }
    }
    assert!(dedans > 40_000, "{dedans}");
}

en_f32_et_f64!(d_une_boule_tout_rayon_sort_a_moins_de_deux_rayons);

/// A ray in mist passes through a pane that stands in it, flush on its bottom: beyond the pane it is in the mist as before,
/// and carries no δ. A ray from within the pane is in one object fewer, outside the mist in none.
fn a_travers_une_vitre_un_rayon_reste_dans_la_brume<R: Reel>() {
    let brume = boite_droite::<R>(v(0.0, 5.0, 0.0), v(20.0, 10.0, 20.0));
    let vitre = boite_droite::<R>(v(1.0, 1.0, 0.0), v(2.0, 2.0, 4.0));
    let air = Rayon::new(v(-5.0, 1.5, 0.0), v(6.0, -1.5, 0.0)).unwrap();
    let suite = |de: &ObjetRay<R>, rayon: &Rayon<R>| {
        let sortie = de.sortie(rayon).unwrap();
        assert_eq!(sortie.normale(), v(0.0, -1.0, 0.0));
        sortie.secondaire(rayon.direction()).unwrap()
    };
    assert!(suite(&vitre, &air).flou() > R::ZERO);
    let dans_la_brume = air.dedans();
    assert_eq!(suite(&vitre, &dans_la_brume).flou(), R::ZERO);
    let dans_la_vitre = vitre.intersection(&dans_la_brume).unwrap();
    let dans_la_vitre = dans_la_vitre.secondaire(air.direction()).unwrap();
    let dehors = suite(&vitre, &dans_la_vitre);
    assert_eq!(dehors.flou(), R::ZERO);
    // Of the mist the ray is told that it left as well.
    assert!(suite(&brume, &dans_la_brume).flou() > R::ZERO);
    assert_eq!(suite(&brume, &dans_la_brume.dedans()).flou(), R::ZERO);
    assert_eq!(brume.intersection(&dehors), Err(NoIntersection));
}

en_f32_et_f64!(a_travers_une_vitre_un_rayon_reste_dans_la_brume);
