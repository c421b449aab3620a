//! What holds of every hit, on random objects and rays.

use commun::choisis::Choisis;
use commun::conversion::{mots, voisin};
use commun::hasard::{Hasard, pour_chaque};
use commun::regimes::regimes;
use commun::strategies::{Plante, direction, plante, scene};
use commun::tolerances::{ARRONDI, DISTANCE, NORMALE, u};
use commun::{Bits, arrondi, en_f32_et_f64, est_une_entree, pour_tout};
use lancer_rayon::{
    Monde, NoIntersection, ObjetGeo, ObjetRay, Rayon, Reel, Vecteur, premiere_intersection,
};
use proptest::prelude::*;

/// The shortest chord looked for, in sizes of the object: some fifty roundings of an f32 there.
const CORDE_MIN: f64 = 1e-4;

/// A point this part of t before the hit is outside: the planted rays are too steep to graze there.
const AVANT: f64 = 1.0 / 64.0;

/// How far X lies above the surface of an object, in f64 and by the definition of the object;
/// below 0 inside.
fn au_dessus<R: Reel>(objet: &ObjetRay<R>, x: Vecteur) -> f64 {
    match objet {
        ObjetRay::Sphere(sphere) => {
            (x - sphere.centre().vers_f64()).longueur() - sphere.rayon().vers_f64()
        }
        ObjetRay::Plan(plan) => {
            plan.normale().vers_f64().produit_scalaire(x) + plan.distance().vers_f64()
        }
        ObjetRay::Boite(boite) => (0..3)
            .map(|i| {
                let cx = x - boite.centre().vers_f64();
                let ecart = boite.normales()[i].vers_f64().produit_scalaire(cx).abs();
                ecart - boite.demi_longueurs()[i].vers_f64()
            })
            .fold(f64::NEG_INFINITY, f64::max),
    }
}

/// R(t) without the rounding of R.
fn point<R: Reel>(rayon: &Rayon<R>, t: f64) -> Vecteur {
    rayon.source().vers_f64() + rayon.direction().vers_f64() * t
}

fn un_point_plante_est_touche<R: Reel>() {
    pour_tout(plante::<R>(), |p| {
        let objet = p.objet.vers_ray();
        let touche = objet.intersection(&p.rayon).unwrap();
        est_une_entree(&p.rayon, &touche)?;

        // The rounding of S and D takes the stored ray past the planted point.
        let tolerance = (DISTANCE + 3.0 * ARRONDI) * p.kappa_t();
        let ecart = (touche.distance().vers_f64() - p.distance).abs();
        prop_assert!(ecart <= tolerance, "distance off by {ecart:e}, {tolerance:e} allowed");
        let courbure = match p.objet {
            ObjetGeo::Sphere(_) => 2.0 * tolerance / p.taille,
            ObjetGeo::Plan(_) | ObjetGeo::Boite(_) => 0.0,
        };
        let ecart = (touche.normale().vers_f64() - p.normale).longueur();
        prop_assert!(ecart <= 2.0 * NORMALE * u::<R>() + courbure, "normal off by {ecart:e}");

        let t = touche.distance().vers_f64();
        let au_point = au_dessus(&objet, point(&p.rayon, t));
        prop_assert!(au_point.abs() <= tolerance, "{au_point:e} above the surface");
        prop_assert!(au_dessus(&objet, point(&p.rayon, t * (1.0 - AVANT))) > 0.0);
        Ok(())
    });
}

en_f32_et_f64!(un_point_plante_est_touche);

/// A length beyond t whose end is inside the object by its definition, found by halving.
fn corde<R: Reel>(objet: &ObjetRay<R>, rayon: &Rayon<R>, t: f64, taille: f64) -> f64 {
    let mut corde = 2.0 * taille;
    while au_dessus(objet, point(rayon, t + corde)) >= 0.0 && corde > CORDE_MIN * taille {
        corde /= 2.0;
    }
    corde
}

fn au_dela_du_point_on_est_dedans_et_de_dedans_rien_n_est_touche<R: Reel>() {
    pour_tout(plante::<R>(), |p: Plante<R>| {
        let objet = p.objet.vers_ray();
        let t = objet.intersection(&p.rayon).unwrap().distance().vers_f64();
        let corde = corde(&objet, &p.rayon, t, p.taille);
        for fraction in [0.125, 0.5, 0.75] {
            let x = point(&p.rayon, t + fraction * corde);
            prop_assert!(au_dessus(&objet, x) < 0.0, "outside at {fraction} of the chord");
        }
        // A source in there misses the object, forwards and backwards.
        let source = arrondi(point(&p.rayon, t + corde / 2.0));
        let depuis = Rayon::new(source, p.rayon.direction()).unwrap();
        prop_assert_eq!(objet.intersection(&depuis), Err(NoIntersection));
        let retour = Rayon::new(source, -p.rayon.direction()).unwrap();
        prop_assert_eq!(objet.intersection(&retour), Err(NoIntersection));
        Ok(())
    });
}

en_f32_et_f64!(au_dela_du_point_on_est_dedans_et_de_dedans_rien_n_est_touche);

/// The first hit is an entry and, except for the index, the hit of its object alone. No object is
/// nearer; each stands twice in the list, and of equals the earlier is hit.
fn la_premiere_est_la_plus_proche_et_a_egalite_la_premiere_de_la_liste<R: Bits>() {
    pour_tout(scene::<R>(), |(geo, rayon)| {
        let objets: Vec<_> = geo.iter().chain(&geo).map(|geo| geo.vers_ray()).collect();
        let touches = objets.iter().map(|o| o.intersection(&rayon)).enumerate();
        let attendue = touches
            .filter_map(|(i, touche)| Some((i, touche.ok()?)))
            .reduce(|a, b| if b.1.distance() < a.1.distance() { b } else { a });
        let obtenue = premiere_intersection(&objets, &rayon);
        prop_assert_eq!(obtenue.map(|touche| touche.indice()).ok(), attendue.map(|(i, _)| i));
        if let (Ok(touche), Some((_, attendue))) = (obtenue, attendue) {
            let [valeurs, attendues] = [touche, attendue].map(|t| mots(&Ok(t)).valeurs);
            prop_assert_eq!(valeurs, attendues);
            prop_assert_eq!(attendue.indice(), 0);
            est_une_entree(&rayon, &touche)?;
        }
        Ok(())
    });
}

en_f32_et_f64!(la_premiere_est_la_plus_proche_et_a_egalite_la_premiere_de_la_liste);

/// A ray that hits a convex object misses it the other way.
fn un_objet_convexe_n_est_touche_que_d_un_cote<R: Reel>() {
    pour_tout((plante::<R>(), direction()), |(p, vers)| {
        let objet = p.objet.vers_ray();
        let rayon = Rayon::new(p.rayon.source(), arrondi(vers)).unwrap();
        if let Ok(touche) = objet.intersection(&rayon) {
            est_une_entree(&rayon, &touche)?;
            let ailleurs = Rayon::new(rayon.source(), -rayon.direction()).unwrap();
            prop_assert_eq!(objet.intersection(&ailleurs), Err(NoIntersection));
        }
        Ok(())
    });
}

en_f32_et_f64!(un_objet_convexe_n_est_touche_que_d_un_cote);

/// Every question at the ends that matter: each distance and its neighbours, and the ends of the type; numbers that are
/// no distance are no end of a ray.
fn une_liste_repond_ce_que_dit_sa_definition<R: Bits>() {
    let juger = |objets: Vec<ObjetRay<R>>, rayon: Rayon<R>| {
        let touches = objets.iter().filter_map(|o| o.intersection(&rayon).ok());
        let voisines =
            touches.flat_map(|touche| [-1, 0, 1].map(|de| voisin(touche.distance(), de)));
        let [zero, un, infini] = [R::ZERO, R::UN, R::INFINI];
        let autres =
            [zero, -zero, un, -un, R::MIN_POSITIF, infini, -infini, R::depuis_f64(f64::NAN)];
        let limites: Vec<_> = voisines.chain(autres).collect();
        let tous = Choisis { monde: Monde::de_liste(&objets), pris: (0..objets.len()).collect() };
        let rayons = vec![rayon; limites.len()];
        tous.un_par_un(&rayons, &tous.toutes(&rayons), &limites, objets.len() as u8);
    };
    pour_tout(scene::<R>(), |(geo, rayon)| {
        juger(geo.into_iter().map(ObjetGeo::vers_ray).collect(), rayon);
        Ok(())
    });
    for regime in regimes::<R>() {
        let faire = |alea: &mut Hasard| [(); 3].map(|()| (regime.cas)(alea));
        pour_chaque(300, faire, |cas| juger(cas.map(|cas| cas.objet).to_vec(), cas[0].rayon));
    }
}

en_f32_et_f64!(une_liste_repond_ce_que_dit_sa_definition);
