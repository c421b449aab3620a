//! What no answer shows: for which objects a question asks. The search ends where it may, in a list and in a tree.

use commun::en_f32_et_f64;
use commun::fabrique::{avec_arbre, boite_droite, mur, sphere, v};
use commun::facons::{Compteur, demandes, noeuds};
use commun::hasard::{Hasard, Tirage};
use lancer_rayon::{Monde, NoIntersection, ObjetRay, Rayon, Reel, Vecteur};

/// How many balls stand in a row along the ray, which enters each, and how many beside that row.
const BOULES: usize = 40;

/// A wall that the ray enters last; the row, with the farthest ball first, entered at 2, 5, 8 and so on; and the balls
/// beside it.
fn scene<R: Reel>() -> Vec<ObjetRay<R>> {
    let boule = |x, k: usize| sphere(v(x, 0.0, -3.0 * (k + 1) as f64), R::UN);
    let mut objets = vec![mur(v(0.0, 0.0, -1_000.0), v(0.0, 0.0, 1.0))];
    objets.extend((0..BOULES).rev().map(|k| boule(0.0, k)));
    objets.extend((0..BOULES).map(|k| boule(10.0, k)));
    objets
}

fn rayon<R: Reel>() -> Rayon<R> {
    Rayon::new(Vecteur::NUL, v(0.0, 0.0, -1.0)).unwrap()
}

/// How often a question asks for the wall, for all balls of the row, and for those beside it.
fn combien<R: Reel>(
    monde: &Monde<'_, R>,
    question: impl FnOnce(Monde<'_, R, Compteur<'_>>),
) -> [u32; 3] {
    let demandes = demandes(monde, question);
    let (rangee, a_cote) = demandes[1..].split_at(BOULES);
    [demandes[0], rangee.iter().sum(), a_cote.iter().sum()]
}

/// A list asks a choice only for what the ray enters, and once. A shadow ends with the first hit before its lamp.
fn une_liste_demande_ce_que_le_rayon_touche<R: Reel>() {
    let (objets, rayon) = (scene::<R>(), rayon());
    let liste = Monde::de_liste(&objets);
    let premiere = |h: Monde<'_, R, Compteur<'_>>| assert!(h.premiere_intersection(&rayon).is_ok());
    assert_eq!(combien(&liste, premiere), [1, BOULES as u32, 0]);
    let occulte = |avant: f64| {
        let ombre = rayon.jusqu_a(R::depuis_f64(avant)).unwrap();
        combien(&liste, |h| assert!(h.est_occulte(&ombre)))
    };
    assert_eq!(occulte(f64::INFINITY), [1, 0, 0]);
    // Four balls stand before 12, and the farthest of them comes first in the list.
    assert_eq!(occulte(12.0), [1, BOULES as u32 - 3, 0]);
    let touche = liste.premiere_intersection(&rayon);
    // The answer is asked for; a glance shows that the others come later.
    assert_eq!(combien(&liste, |h| assert!(h.certifie(&rayon, &touche))), [0, 1, 0]);
}

en_f32_et_f64!(une_liste_demande_ce_que_le_rayon_touche);

/// A tree asks for what lies before the last that is kept or before the limit. A shadow ends with the first hit.
fn un_arbre_s_arrete_des_qu_il_peut<R: Reel>() {
    let (objets, rayon) = (scene::<R>(), rayon());
    let arbre = avec_arbre(&objets);
    assert!(noeuds(&arbre) > 4);
    let premiere = |h: Monde<'_, R, Compteur<'_>>| assert!(h.premiere_intersection(&rayon).is_ok());
    let [_, rangee, a_cote] = combien(&arbre, premiere);
    assert!((1..4).contains(&rangee) && a_cote == 0, "{rangee}, {a_cote}");
    let occulte = |h: Monde<'_, R, Compteur<'_>>| assert!(h.est_occulte(&rayon));
    assert_eq!(combien(&arbre, occulte), [1, 0, 0]);
    let sans_le_mur = |h: Monde<'_, R, Compteur<'_>>| assert!(h.sans(0).est_occulte(&rayon));
    assert_eq!(combien(&arbre, sans_le_mur), [0, 1, 0]);
    let touche = arbre.premiere_intersection(&rayon);
    let [_, rangee, _] = combien(&arbre, |h| assert!(h.certifie(&rayon, &touche)));
    assert!(rangee < 5, "{rangee}");
    // How many places, before which limit, and how many balls at least and at most.
    for (places, limite, bornes) in [
        (3, f64::INFINITY, 3..17),
        (99, 10.0, 3..5),
        (0, f64::INFINITY, 0..1),
        (99, f64::INFINITY, BOULES as u32..BOULES as u32 + 1),
    ] {
        let ordre = |h: Monde<'_, R, Compteur<'_>>| {
            let mut touches = vec![Err(NoIntersection); places];
            h.dans_l_ordre(&rayon.jusqu_a(R::depuis_f64(limite)).unwrap(), &mut touches);
        };
        let [_, rangee, a_cote] = combien(&arbre, ordre);
        assert!(bornes.contains(&rangee) && a_cote == 0, "{places} before {limite}: {rangee}");
    }
}

en_f32_et_f64!(un_arbre_s_arrete_des_qu_il_peut);

/// One ray or two in a call go one by one, each as if alone. Sixty-four ask for an object together; in a list they ask
/// for every object, and shadows until each of them has met one.
fn peu_de_rayons_vont_un_par_un<R: Reel>() {
    let (objets, rayon) = (scene::<R>(), rayon());
    let arbre = avec_arbre(&objets);
    for monde in [arbre, Monde::de_liste(&objets)] {
        let demandes = |nombre: usize| {
            let premieres = combien(&monde, |h| {
                let mut touches = vec![Err(NoIntersection); nombre];
                h.premieres_intersections(&vec![rayon; nombre], &mut touches).unwrap();
            });
            let ombres = combien(&monde, |h| {
                let ombre = rayon.jusqu_a(R::depuis_f64(50.0)).unwrap();
                h.sont_occultes(&vec![ombre; nombre], &mut vec![false; nombre]).unwrap();
            });
            [premieres, ombres]
        };
        let ombre = rayon.jusqu_a(R::depuis_f64(50.0)).unwrap();
        let seul = [
            combien(&monde, |h| assert!(h.premiere_intersection(&rayon).is_ok())),
            combien(&monde, |h| assert!(h.est_occulte(&ombre))),
        ];
        let (un, deux, bloc) = (demandes(1), demandes(2), demandes(64));
        assert_eq!(un, seul);
        assert_eq!(deux, un.map(|combien| combien.map(|n| 2 * n)));
        let a_cote = if noeuds(&monde) > 0 { 0 } else { BOULES as u32 };
        let [[mur, rangee, autres], ombres] = bloc;
        assert!(mur == 1 && rangee <= BOULES as u32 && autres == a_cote, "{bloc:?}");
        // Every ray meets an object of the row, and a block looks for that after each sixteen objects.
        assert!(ombres[0] == 1 && ombres.iter().sum::<u32>() <= 32, "{bloc:?}");
    }
}

en_f32_et_f64!(peu_de_rayons_vont_un_par_un);

/// Rays from so far away that boxes tell nothing apart ask for every object if they come near, and for none if they pass
/// by.
fn un_rayon_lointain_passe_a_cote<R: Reel>() {
    // So many that a block does not ask all of them anyway.
    let objets = scene::<R>().repeat(3);
    let monde = avec_arbre(&objets);
    let loin = R::depuis_f64(1e17);
    let depart = Vecteur::new(loin, loin, loin);
    let combien = |vers: Vecteur<R>| {
        let rayon = Rayon::new(depart, vers).unwrap();
        let touches = demandes(&monde, |h| {
            let _ = h.premiere_intersection(&rayon);
            h.premieres_intersections(&[rayon; 64], &mut [Err(NoIntersection); 64]).unwrap();
        });
        let avec_boite = touches.iter().zip(&objets).filter(|(_, o)| o.etendue().is_some());
        avec_boite.map(|(fois, _)| u64::from(*fois)).sum::<u64>()
    };
    assert_eq!(combien(Vecteur::new(-R::UN, R::ZERO, R::ZERO)), 0);
    assert_eq!(combien(depart), 0);
    assert!(combien(-depart) > 0);
}

en_f32_et_f64!(un_rayon_lointain_passe_a_cote);

fn du_cube(alea: &mut Hasard) -> Vecteur {
    Vecteur::from([(); 3].map(|()| alea.f64() * 2.0 - 1.0))
}

/// `n` objects that lie together, except that those at the indices `loin` are far away, on all sides or on one.
fn dont_loin<R: Reel>(n: usize, un_cote: bool, loin: impl Fn(usize) -> bool) -> Vec<ObjetRay<R>> {
    let mut alea = Hasard::de_graine(n as u64);
    let boule = |k| {
        let c: Vecteur = du_cube(&mut alea);
        let c = if !loin(k) {
            c * 50.0
        } else if un_cote {
            (c + Vecteur::X * 2.0) * 3e7
        } else {
            c * 3e7
        };
        sphere(Vecteur::depuis_f64(c), R::depuis_f64(1.5))
    };
    (0..n).map(boule).collect()
}

/// How many times in all these rays ask for an object.
fn en_tout<R: Reel>(objets: &[ObjetRay<R>], rayons: &[Rayon<R>]) -> u32 {
    let monde = avec_arbre(objets);
    let tous = |h: Monde<'_, R, Compteur<'_>>| {
        for rayon in rayons {
            let _ = h.premiere_intersection(rayon);
        }
    };
    demandes(&monde, tous).iter().sum()
}

/// Which objects of a list are far away does not decide how much a ray asks for: the first of every 2 to 64, or the
/// second; a third of the list, or half; or a third when sorted along an axis. On average a ray asks for one object at
/// most.
fn l_ordre_de_la_liste_ne_coute_rien<R: Reel>() {
    let mut alea = Hasard::de_graine(1);
    let rayons: Vec<Rayon<R>> = (0..100)
        .map(|_| {
            let [s, d] = [60.0, 1.0].map(|l| Vecteur::depuis_f64(du_cube(&mut alea) * l));
            Rayon::new(s, d).unwrap()
        })
        .collect();
    let juger = |quoi: &str, objets: &[ObjetRay<R>]| {
        let demandes = en_tout(objets, &rayons);
        assert!(demandes <= rayons.len() as u32, "{quoi} of {} far: {demandes}", objets.len());
    };
    for (n, un_cote) in [60, 270, 1_000, 1_030, 2_046].into_iter().zip([true, false].repeat(3)) {
        for p in [2, 3, 4, 5, 6, 7, 9, 11, 31, 33, 62, 64] {
            for phase in [0, 1] {
                let objets = dont_loin(n, un_cote, |k| k % p == phase);
                juger(&format!("every {p}, from {phase} on,"), &objets);
            }
        }
        juger("the first third", &dont_loin(n, un_cote, |k| k < n / 3));
        juger("the last half", &dont_loin(n, un_cote, |k| k >= n / 2));
        let mut tries: Vec<ObjetRay<R>> = dont_loin(n, un_cote, |k| k % 3 == 0);
        tries.sort_by(|a, b| {
            let [a, b] = [a, b].map(|objet| objet.etendue().unwrap().bas.x.vers_f64());
            a.total_cmp(&b)
        });
        juger("a sorted third", &tries);
    }
}

en_f32_et_f64!(l_ordre_de_la_liste_ne_coute_rien);

/// A block that would be offered far more objects than its rays ask one by one stops, and the next blocks are not tried:
/// over a stack of sheets that a camera sees from beside, all blocks would be offered all sheets.
fn une_pile_de_plaques_n_est_pas_demandee_en_entier<R: Reel>() {
    const PLAQUES: usize = 2_000;
    const BLOCS: usize = 64;
    let haut = 2.0 / PLAQUES as f64;
    let plaque =
        |i: usize| boite_droite(v(0.0, i as f64 * haut - 1.0, 0.0), v(2.0, 0.7 * haut, 2.0));
    let objets: Vec<ObjetRay<R>> = (0..PLAQUES).map(plaque).collect();
    let monde = avec_arbre(&objets);
    let rayons: Vec<Rayon<R>> = (0..64 * BLOCS)
        .map(|i| {
            let (x, y) = (i % 8 + i / 64 % 8 * 8, i / 8 % 8 + i / 512 * 8);
            let [x, y] = [x, y].map(|k| k as f64 / 160.0 - 0.2);
            Rayon::new(v(1.0, 6.0, 1.5), v(x - 0.16, -1.0, y - 0.24)).unwrap()
        })
        .collect();
    let demandes: u32 = demandes(&monde, |h| {
        let mut touches = vec![Err(NoIntersection); rayons.len()];
        h.premieres_intersections(&rayons, &mut touches).unwrap();
    })
    .iter()
    .sum();
    assert!((demandes as usize) < PLAQUES * BLOCS / 8, "{demandes}");
}

en_f32_et_f64!(une_pile_de_plaques_n_est_pas_demandee_en_entier);
