//! Particles in closed rooms, and walks that are scattered, by the recipe `particule`. The judges are the room itself,
//! the way unfolded, and the mean way through a convex body.

use commun::fabrique::{boite, mur, murs, sphere, v};
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::regimes::{direction, entre};
use commun::tolerances::u;
use commun::{arrondi, cas, en_f32_et_f64};
use fastrand::Rng;
use lancer_rayon::{Monde, ObjetRay, Rayon, Reel, Rotation, Vecteur};
use recettes::milieux::{Marche, Matiere};
use recettes::particule::{avancer, diffuser};

/// Rooms of ten units, turned and moved, between half-spaces or between boxes that are thin and overlap by no more than
/// their thickness, with mist, a glass and a block in them. Steps are of any length, and many end on a wall. However
/// many there are, no particle leaves.
fn aucune_particule_ne_quitte_sa_chambre<R: Reel>() {
    let (mut au_mur, mut pas_faits) = (0, 0);
    let faire = |alea: &mut Hasard| {
        let tour = Rotation::<R>::new(arrondi(direction(alea) * *alea.choix(&[0.0, 3.0]))).unwrap();
        let milieu = direction(alea) * *alea.choix(&[0.0, 10.0, 100.0]);
        // 32 rays have a δ of less than 3,200u of such lengths, and walls must be thicker than twice that.
        let mince = 8_000.0 * u::<R>() * (10.0 + milieu.longueur());
        // In many short steps δ would grow to a multiple of the walls, and a particle would slip out beside an edge.
        let [genre, combien] =
            if alea.tour.is_multiple_of(5) { [0, 6_000] } else { [1 + alea.usize(0..2), 600] };
        let pas = alea.liste(combien, |alea, _| {
            let pas = match genre {
                0 => 0.1,
                1 => (-12.0 * alea.f64()).exp2(),
                _ => entre(alea, 0.0, 30.0),
            };
            (alea.bool(), pas, (genre > 0 && alea.u8(0..8) == 0).then(|| direction(alea)))
        });
        // Beside the block.
        let depart = [[-4.9, 4.9], [-2.9, 4.9], [-4.9, 4.9]].map(|[de, a]| entre(alea, de, a));
        (tour, milieu, alea.bool().then_some([mince; 2]), depart, direction(alea), pas)
    };
    pour_chaque(cas(40), faire, |(tour, milieu, minces, depart, vers, pas)| {
        let mut objets: Vec<ObjetRay<R>> =
            murs(arrondi(milieu), tour, 10.0, minces).into_iter().map(ObjetRay::from).collect();
        let place = |x: f64, y: f64, z: f64| arrondi(milieu) + tour.appliquer(v(x, y, z));
        objets.push(sphere(place(1.0, 0.0, 0.0), R::depuis_f64(3.0)));
        objets.push(boite(place(-3.0, -4.0, 1.0), v(2.0, 2.0, 2.0), tour));
        objets.push(boite(place(3.0, -4.0, 1.0), v(2.0, 2.0, 2.0), tour));
        let claire = |indice| Matiere::Pleine { priorite: 0, indice };
        let mut matieres = vec![Matiere::Opaque; 6];
        matieres.extend([claire(1.0), claire(1.5)]);
        let mut marche = Marche::new(Monde::de_liste(&objets), &matieres);
        let [x, y, z] = depart;
        marche.partir(Rayon::new(place(x, y, z), arrondi(vers)).unwrap());
        let axes = tour.axes().map(Vecteur::vers_f64);
        let jeu = 3_000.0 * u::<R>() * (10.0 + milieu.longueur());
        for (au_bout, pas, tourne) in pas {
            let suivant = marche.monde().premiere_intersection(&marche.rayon());
            // Right to a surface, if it is as near as the step.
            let pas = match suivant {
                Ok(touche) if au_bout && touche.distance().vers_f64() < pas => {
                    au_mur += 1;
                    touche.distance()
                }
                _ => R::depuis_f64(pas),
            };
            assert!(avancer(&mut marche, pas).unwrap());
            if let Some(vers) = tourne {
                marche.tourner(arrondi(vers)).unwrap();
            }
            pas_faits += 1;
            let flou = 3_200.0 * u::<R>() * (10.0 + milieu.longueur());
            assert!(marche.rayon().flou().vers_f64() <= flou, "{:?}", marche.rayon());
            let la = marche.rayon().source().vers_f64() - milieu;
            let loin = axes.into_iter().map(|n| n.produit_scalaire(la).abs()).fold(0.0, f64::max);
            assert!(loin <= 5.0 + jeu, "{loin} after {pas_faits} steps, {:?}", marche.rayon());
            let bloc = objets[8].traversee(&marche.rayon());
            let ObjetRay::Boite(boite) = objets[8] else { unreachable!("made as a box") };
            let profond = boite.centre().vers_f64() - marche.rayon().source().vers_f64();
            let profond = axes.into_iter().map(|n| 1.0 - n.produit_scalaire(profond).abs());
            assert!(profond.fold(f64::MAX, f64::min) <= jeu, "{bloc:?} holds {:?}", marche.rayon());
        }
    });
    assert!(au_mur > 1_000 && pas_faits > 20_000, "{au_mur} {pas_faits}");
}

en_f32_et_f64!(aucune_particule_ne_quitte_sa_chambre);

/// A particle in a cube is where a straight line would be if the cube were mirrored instead of the way. One step in
/// three ends on a wall. Thousands of bounces later none has left, and none knows its place less well than after some
/// tens.
fn une_particule_reste_ou_le_depliage_la_met<R: Reel>() {
    let murs: Vec<ObjetRay<R>> = murs(v(0.5, 0.5, 0.5), Rotation::IDENTITE, 1.0, None)
        .into_iter()
        .map(ObjetRay::from)
        .collect();
    let monde = Monde::de_liste(&murs);
    let mut au_mur = 0;
    let faire = |alea: &mut Hasard| {
        let depart = v::<R>(entre(alea, 0.1, 0.9), entre(alea, 0.1, 0.9), 0.5);
        let rayon = Rayon::new(depart, arrondi(direction(alea))).unwrap();
        // To the wall, or this far.
        let pas = alea.liste(1_200, |alea, _| (alea.u8(0..3) > 0).then(|| 2.0 * alea.f64()));
        (rayon, pas)
    };
    pour_chaque(40, faire, |(rayon, pas)| {
        let (s, d) = (rayon.source().vers_f64(), rayon.direction().vers_f64());
        let mut marche = Marche::new(monde, &[]);
        marche.partir(rayon);
        let (mut chemin, mut pas_faits) = (0.0, 0.0);
        for pas in pas {
            let pas = match (pas, monde.premiere_intersection(&marche.rayon())) {
                (None, Ok(mur)) if mur.distance() > R::ZERO => {
                    au_mur += 1;
                    mur.distance()
                }
                (pas, _) => R::depuis_f64(pas.unwrap_or(1.0)),
            };
            assert!(avancer(&mut marche, pas).unwrap());
            (chemin, pas_faits) = (chemin + pas.vers_f64(), pas_faits + 1.0);
            // A bounce turns D by 20u, which the length of the way multiplies, and some fifty roundings move it. There
            // are at most three bounces for two units of length. Steps round as well.
            let permis =
                u::<R>() * (20.0 * 1.5 * chemin * chemin + 50.0 * (1.5 * chemin + pas_faits + 1.0));
            let tout_droit = s + d * chemin;
            let depliee = |x: f64| (x - 2.0 * (x / 2.0).round()).abs();
            let attendue = Vecteur::from(<[f64; 3]>::from(tout_droit).map(depliee));
            let ecart = (marche.rayon().source().vers_f64() - attendue).longueur();
            assert!(ecart <= permis.min(2.0), "{ecart:e} > {permis:e} after {chemin}");
            // Each bounce and step adds less than 16u·√3, 8.1u·3 and one step off the surface.
            assert!(marche.rayon().flou().vers_f64() <= 60.0 * 60.0 * u::<R>());
        }
    });
    assert!(au_mur > 1_000);
}

en_f32_et_f64!(une_particule_reste_ou_le_depliage_la_met);

/// A particle that runs to and fro in the plane in which two media meet, or one medium ends. By rounding it is in what it
/// is not said to be in, or the reverse, wherever it starts anew. Its δ stays that of some tens of rays all the same.
fn le_long_d_une_face_le_flou_ne_croit_pas<R: Reel>() {
    let mut plus_grand = 0.0_f64;
    let faire = |alea: &mut Hasard| {
        let tour = Rotation::<R>::new(arrondi(direction(alea) * 3.0)).unwrap();
        let (milieu, face) = (direction(alea) * *alea.choix(&[0.0, 3.0]), entre(alea, -3.0, 3.0));
        (tour, milieu, face, alea.bool(), alea.liste(2_000, |alea, _| 10.0 * alea.f64()))
    };
    pour_chaque(cas(20), faire, |(tour, milieu, face, deux, pas)| {
        let place = |x: f64, y: f64, z: f64| arrondi(milieu) + tour.appliquer(v(x, y, z));
        let mut objets: Vec<ObjetRay<R>> =
            murs(arrondi(milieu), tour, 10.0, None).into_iter().map(ObjetRay::from).collect();
        let mut matieres = vec![Matiere::Opaque; 6];
        let couches = [[-5.0, face], [face, 5.0]];
        for ([bas, haut], priorite) in couches.into_iter().take(1 + usize::from(deux)).zip(0..) {
            let centre = place(0.0, (bas + haut) / 2.0, 0.0);
            objets.push(boite(centre, v(10.0, haut - bas, 10.0), tour));
            matieres.push(Matiere::Pleine { priorite, indice: 1.0 });
        }
        let mut marche = Marche::new(Monde::de_liste(&objets), &matieres);
        marche.partir(Rayon::new(place(1.0, face, 2.0), tour.axes()[0]).unwrap());
        for pas in pas {
            assert!(avancer(&mut marche, R::depuis_f64(pas)).unwrap());
            let flou = marche.rayon().flou().vers_f64() / (u::<R>() * (10.0 + milieu.longueur()));
            plus_grand = plus_grand.max(flou);
            assert!(flou <= 2_000.0, "{flou} u of the lengths in {:?}", marche.rayon());
        }
    });
    println!("{plus_grand}");
}

en_f32_et_f64!(le_long_d_une_face_le_flou_ne_croit_pas);

/// The mean way through a convex body that is lit evenly from all around is 4V/S, whether the body scatters much,
/// little or not at all (Blanco and Fournier 2003).
fn le_chemin_moyen_dans_une_brume_est_de_quatre_v_sur_s<R: Reel>() {
    const MARCHES: u32 = 20_000;
    let mut alea = Rng::with_seed(94);
    let tour = Rotation::<R>::new(v(0.3, 0.4, 0.5)).unwrap();
    let cube = boite(v(1.0, 2.0, 3.0), v(2.0, 2.0, 2.0), tour);
    let boule = sphere(v(1.0, 2.0, 3.0), R::UN);
    let matieres = [Matiere::Pleine { priorite: 0, indice: 1.0 }];
    for (milieu, attendu) in [(cube, 4.0 * 8.0 / 24.0), (boule, 4.0 / 3.0)] {
        let milieu = [milieu];
        let mut marche = Marche::new(Monde::de_liste(&milieu), &matieres);
        for pas_moyen in [0.1, 0.7, 5.0] {
            let (mut somme, mut carres, mut nombre) = (0.0, 0.0, 0_u32);
            while nombre < MARCHES {
                // Parallel light from everywhere, as a wide beam on a ball around the body.
                let d = direction(&mut alea);
                let au_hasard = direction(&mut alea);
                let travers = au_hasard.produit_vectoriel(d).unitaire().unwrap();
                let s = Vecteur::new(1.0, 2.0, 3.0) - d * 9.0 + travers * (1.8 * alea.f64().sqrt());
                marche.partir(Rayon::new(arrondi(s), arrondi(d)).unwrap());
                let Some(entree) = marche.avancer(R::INFINI).unwrap() else { continue };
                marche.passer(&entree).unwrap();
                let (chemin, sortie) =
                    diffuser(&mut marche, pas_moyen, u32::MAX, || alea.f64()).unwrap();
                assert!(sortie.is_some_and(|sortie| sortie.objet == 0));
                let chemin = chemin.vers_f64();
                (somme, carres, nombre) = (somme + chemin, carres + chemin * chemin, nombre + 1);
            }
            let n = f64::from(MARCHES);
            let (moyenne, erreur) =
                (somme / n, (carres / n - (somme / n).powi(2)).sqrt() / n.sqrt());
            println!("{moyenne} ± {erreur} of {attendu} with steps of {pas_moyen}");
            assert!((moyenne - attendu).abs() < 4.0 * erreur, "{moyenne} ± {erreur}, {attendu}");
        }
    }
}

en_f32_et_f64!(le_chemin_moyen_dans_une_brume_est_de_quatre_v_sur_s);

/// A sea is a half-space, in which most rays never come to a surface. No walk is shorter than the way up, and all end at
/// the surface or in the sea.
fn d_une_mer_on_ne_sort_que_par_le_haut<R: Reel>() {
    let mut dehors = 0;
    let faire = |alea: &mut Hasard| {
        let (fond, pas, graine) = (entre(alea, 0.01, 5.0), entre(alea, 0.2, 2.0), alea.mot());
        (direction(alea), entre(alea, -30.0, 30.0), fond, pas, graine, direction(alea))
    };
    pour_chaque(cas(2_000), faire, |(haut, niveau, fond, pas, graine, vers)| {
        let mer = [mur::<R>(arrondi(haut * niveau), arrondi(haut))];
        let ObjetRay::Plan(plan) = mer[0] else { unreachable!("made as a half-space") };
        let (n, d) = (plan.normale().vers_f64(), plan.distance().vers_f64());
        let hauteur = |p: Vecteur<R>| n.produit_scalaire(p.vers_f64()) + d;
        let matieres = [Matiere::Pleine { priorite: 0, indice: 1.33 }];
        let mut marche = Marche::new(Monde::de_liste(&mer), &matieres);
        let source = arrondi(haut * (niveau - fond));
        marche.partir(Rayon::new(source, arrondi(vers)).unwrap());
        let mut alea = Rng::with_seed(graine);
        let (chemin, sortie) = diffuser(&mut marche, pas, 200, || alea.f64()).unwrap();
        // Two hundred steps of some units round, at thirty units from O.
        let jeu = 3_000.0 * u::<R>() * (40.0 + chemin.vers_f64());
        match sortie {
            Some(sortie) => {
                assert!(chemin.vers_f64() >= -hauteur(source) - jeu, "{chemin} from {fond}");
                assert!(hauteur(sortie.touche.point()).abs() <= jeu);
                dehors += 1;
            }
            None => assert!(hauteur(marche.rayon().source()) <= jeu, "{:?}", marche.rayon()),
        }
    });
    assert!(dehors > 500, "{dehors}");
}

en_f32_et_f64!(d_une_mer_on_ne_sort_que_par_le_haut);
