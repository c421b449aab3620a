//! What every hit is, on random objects and rays, in both types.

mod commun;

use commun::conversion::mots;
use commun::regimes::regimes;
use commun::strategies::{Plante, direction, plante, scene};
use commun::tolerances::{ARRONDI, DISTANCE, NORMALE, u};
use commun::{Bits, arrondi, est_une_entree, pour_tout};
use lancer_rayon::{
    NoIntersection, ObjetGeo, ObjetRay, Rayon, Reel, Texture, Vecteur, est_occulte,
    premiere_intersection,
};
use proptest::prelude::*;
use proptest::test_runner::TestCaseResult;

/// How far X lies above the surface of an object, in f64 and by the definition of the object;
/// below 0 inside.
fn hauteur<R: Reel>(objet: &ObjetRay<R>, x: Vecteur) -> f64 {
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

fn plantee<R: Reel>() {
    pour_tout(plante::<R>(), |p| {
        let objet = p.objet.vers_ray();
        let touche = objet.intersection(&p.rayon).unwrap();
        est_une_entree(&p.rayon, &touche)?;

        // The ray as stored passes beside the planted point by the rounding of S and D.
        let tolerance = (DISTANCE + 3.0 * ARRONDI) * p.cond();
        let ecart = (touche.distance().vers_f64() - p.distance).abs();
        prop_assert!(ecart <= tolerance, "distance off by {ecart:e}, {tolerance:e} allowed");
        let courbure = match p.objet {
            ObjetGeo::Sphere(_) => 2.0 * tolerance / p.taille,
            ObjetGeo::Plan(_) | ObjetGeo::Boite(_) => 0.0,
        };
        let ecart = (touche.normale().vers_f64() - p.normale).longueur();
        prop_assert!(ecart <= 2.0 * NORMALE * u::<R>() + courbure, "normal off by {ecart:e}");

        let t = touche.distance().vers_f64();
        let au_point = hauteur(&objet, point(&p.rayon, t));
        prop_assert!(au_point.abs() <= tolerance, "{au_point:e} above the surface");
        prop_assert!(hauteur(&objet, point(&p.rayon, t * (1.0 - 1.0 / 64.0))) > 0.0);
        Ok(())
    });
}

#[test]
fn un_point_plante_est_touche() {
    plantee::<f32>();
    plantee::<f64>();
}

/// A length beyond t whose end is inside the object by its definition, found by halving.
fn corde<R: Reel>(objet: &ObjetRay<R>, rayon: &Rayon<R>, t: f64, taille: f64) -> f64 {
    // Down to where a chord that short would be rounding, each step half of the one before.
    let mut corde = 2.0 * taille;
    while hauteur(objet, point(rayon, t + corde)) >= 0.0 && corde > 1e-4 * taille {
        corde /= 2.0;
    }
    corde
}

fn dedans<R: Reel>() {
    pour_tout(plante::<R>(), |p: Plante<R>| {
        let objet = p.objet.vers_ray();
        let t = objet.intersection(&p.rayon).unwrap().distance().vers_f64();
        let corde = corde(&objet, &p.rayon, t, p.taille);
        for fraction in [0.125, 0.5, 0.75] {
            let x = point(&p.rayon, t + fraction * corde);
            prop_assert!(hauteur(&objet, x) < 0.0, "outside at {fraction} of the chord");
        }
        // From in there the object is not touched, in whatever direction.
        let source = arrondi(point(&p.rayon, t + corde / 2.0));
        let depuis = Rayon::new(source, p.rayon.direction()).unwrap();
        prop_assert_eq!(objet.intersection(&depuis), Err(NoIntersection));
        let retour = Rayon::new(source, -p.rayon.direction()).unwrap();
        prop_assert_eq!(objet.intersection(&retour), Err(NoIntersection));
        Ok(())
    });
}

#[test]
fn au_dela_du_point_on_est_dedans_et_de_dedans_rien_n_est_touche() {
    dedans::<f32>();
    dedans::<f64>();
}

/// The first hit is an entry, no object is nearer, and it is what its object answers alone, except the
/// index.
fn premiere<R: Bits>() {
    pour_tout(scene::<R>(), |(geo, rayon)| {
        let objets: Vec<_> = geo.into_iter().map(ObjetGeo::vers_ray).collect();
        let touches = objets.iter().map(|o| o.intersection(&rayon)).enumerate();
        let attendue = touches
            .filter_map(|(i, touche)| Some((i, touche.ok()?)))
            .reduce(|a, b| if b.1.distance() < a.1.distance() { b } else { a });
        let obtenue = premiere_intersection(&objets, &rayon);
        prop_assert_eq!(obtenue.map(|touche| touche.objet()).ok(), attendue.map(|(i, _)| i));
        if let (Ok(touche), Some((_, attendue))) = (obtenue, attendue) {
            let [valeurs, attendues] = [touche, attendue].map(|t| mots(&Ok(t)).valeurs);
            prop_assert_eq!(valeurs, attendues);
            prop_assert_eq!(attendue.objet(), 0);
            est_une_entree(&rayon, &touche)?;
        }
        Ok(())
    });
}

#[test]
fn la_premiere_est_la_plus_proche_de_celles_de_chaque_objet() {
    premiere::<f32>();
    premiere::<f64>();
}

/// Among copies of one object the first in the list is touched.
fn ex_aequo<R: Reel>() {
    pour_tout((plante::<R>(), [any::<u32>(), any::<u32>()]), |(p, textures)| {
        let jumeaux = textures.map(|t| p.parametres.avec(Texture(t)).objet().vers_ray());
        let touche = premiere_intersection(&jumeaux, &p.rayon).unwrap();
        prop_assert_eq!(touche.texture(), Texture(textures[0]));
        Ok(())
    });
}

#[test]
fn a_egalite_le_premier_de_la_liste_est_touche() {
    ex_aequo::<f32>();
    ex_aequo::<f64>();
}

/// Whoever touches a convex object misses it the other way.
fn de_partout<R: Reel>() {
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

#[test]
fn un_objet_convexe_n_est_touche_que_d_un_cote() {
    de_partout::<f32>();
    de_partout::<f64>();
}

/// What it is defined as, at the limits that matter: each distance and its neighbours, the ends of
/// the type and what is no distance.
fn occultation<R: Reel>(objets: &[ObjetRay<R>], rayon: &Rayon<R>) -> TestCaseResult {
    let touches: Vec<_> = objets.iter().filter_map(|o| o.intersection(rayon).ok()).collect();
    let deux_u = R::U + R::U;
    let voisines = touches.iter().flat_map(|touche| {
        [R::UN - deux_u, R::UN, R::UN + deux_u].map(|facteur| touche.distance() * facteur)
    });
    let [zero, un, infini] = [R::ZERO, R::UN, R::INFINI];
    let autres = [zero, -zero, un, -un, R::MIN_POSITIF, infini, -infini, R::depuis_f64(f64::NAN)];
    for max in voisines.chain(autres) {
        let attendu =
            objets.iter().any(|o| o.intersection(rayon).is_ok_and(|i| i.distance() < max));
        prop_assert_eq!(est_occulte(objets, rayon, max), attendu, "before {}", max);
    }
    Ok(())
}

fn occultations<R: Reel>() {
    pour_tout(scene::<R>(), |(geo, rayon)| {
        let objets: Vec<_> = geo.into_iter().map(ObjetGeo::vers_ray).collect();
        occultation(&objets, &rayon)
    });
    let mut alea = fastrand::Rng::with_seed(5);
    for regime in regimes::<R>() {
        for _ in 0..300 {
            let cas: Vec<_> = (0..3).map(|_| (regime.cas)(&mut alea)).collect();
            let objets: Vec<_> = cas.iter().map(|cas| cas.objet).collect();
            occultation(&objets, &cas[0].rayon).unwrap();
        }
    }
}

#[test]
fn est_occulte_est_ce_que_dit_sa_definition() {
    occultations::<f32>();
    occultations::<f64>();
}
