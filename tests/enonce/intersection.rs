//! What holds of every hit, on random objects and rays.

use commun::choisis::Choisis;
use commun::conversion::voisin;
use commun::hasard::{Hasard, pour_chaque};
use commun::passages::exiger_un_passage;
use commun::regimes::regimes;
use commun::strategies::{plante, scene};
use commun::tolerances::{ARRONDI, DISTANCE, NORMALE, u};
use commun::{Bits, en_f32_et_f64, pour_tout};
use lancer_rayon::{Monde, ObjetGeo, ObjetRay, Rayon, Reel, Vecteur};
use proptest::prelude::*;

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

fn un_point_plante_est_touche<R: Bits>() {
    pour_tout(plante::<R>(), |p| {
        let objet = p.objet.vers_ray();
        let touche = objet.intersection(&p.rayon).unwrap();
        exiger_un_passage(&objet, &p.rayon, &touche);

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

/// Every question at the ends that matter: each distance and its neighbours, and the ends of the type; numbers that are
/// no distance are no end of a ray.
fn une_liste_repond_ce_que_dit_sa_definition<R: Bits>() {
    let juger = |objets: Vec<ObjetRay<R>>, rayon: Rayon<R>| {
        let touches = objets.iter().filter_map(|o| o.intersection(&rayon).ok());
        let voisines =
            touches.flat_map(|touche| [-1, 0, 1].map(|de| voisin(touche.distance(), de)));
        let [zero, un, infini] = [R::ZERO, R::UN, R::INFINI];
        let autres = [zero, -zero, un, -un, R::ETA, infini, -infini, R::depuis_f64(f64::NAN)];
        let limites: Vec<_> = voisines.chain(autres).collect();
        let tous = Choisis { monde: Monde::de_liste(&objets), pris: (0..objets.len()).collect() };
        let rayons = vec![rayon; limites.len()];
        tous.un_par_un(&rayons, &tous.toutes(&rayons), &limites, objets.len() as u8);
    };
    pour_tout(scene::<R>(), |(geo, rayon)| {
        // Each stands twice in the list, and of equals the earlier is hit.
        juger(geo.iter().chain(&geo).map(|geo| geo.vers_ray()).collect(), rayon);
        Ok(())
    });
    for regime in regimes::<R>() {
        let faire = |alea: &mut Hasard| [(); 3].map(|()| (regime.cas)(alea));
        pour_chaque(300, faire, |cas| juger(cas.map(|cas| cas.objet).to_vec(), cas[0].rayon));
    }
}

en_f32_et_f64!(une_liste_repond_ce_que_dit_sa_definition);
