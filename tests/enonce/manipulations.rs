//! Moving, turning and scaling objects (handout §2.3).

use commun::oracle::Exact;
use commun::strategies::{Plante, objet, plante, reel, rotation, vecteur};
use commun::tolerances::{ARRONDI, DISTANCE, NORMALE, ORTHONORMALE, PRODUIT, TOURNE, u};
use commun::{en_f32_et_f64, pour_tout};
use lancer_rayon::{
    BoiteGeo, ObjetGeo, ObjetRay, PlanGeo, Rayon, Reel, Rotation, SphereGeo, Texture, Vecteur,
};
use proptest::prelude::*;
use proptest::test_runner::TestCaseResult;

/// The same motion of an object and of a ray keeps the distance, and moves the normal along.
///
/// `bruit` is how many u of its lengths the motion itself rounds away.
fn accompagner<R: Reel>(
    p: Plante<R>,
    objet: ObjetGeo<R>,
    rayon: Rayon<R>,
    facteur: f64,
    normale: impl Fn(Vecteur) -> Vecteur,
    bruit: f64,
) -> TestCaseResult {
    let avant = p.objet.vers_ray().intersection(&p.rayon).unwrap();
    let apres = objet.vers_ray().intersection(&rayon).unwrap();
    let ecart = (apres.distance().vers_f64() / facteur - avant.distance().vers_f64()).abs();
    let tolerance = (DISTANCE + bruit) * p.kappa_t();
    prop_assert!(ecart <= tolerance, "distance off by {ecart:e}, {tolerance:e} allowed");
    let ecart = (apres.normale().vers_f64() - normale(avant.normale().vers_f64())).longueur();
    // Only a sphere's normal depends on where it is touched.
    let courbure = match objet {
        ObjetGeo::Sphere(_) => (tolerance + bruit * u::<R>() * p.etendue) / p.taille,
        ObjetGeo::Plan(_) | ObjetGeo::Boite(_) => 0.0,
    };
    // The normals before and after have one error each.
    let tolerance = 2.0 * (NORMALE + TOURNE) * u::<R>() + 2.0 * courbure;
    prop_assert!(ecart <= tolerance, "normal off by {ecart:e}, {tolerance:e} allowed");
    let texture = p.objet.vers_ray().texture();
    prop_assert_eq!((avant.texture(), apres.texture()), (texture, texture));
    Ok(())
}

fn tourner_la_scene_et_le_rayon_garde_la_distance<R: Reel>() {
    pour_tout((plante::<R>(), rotation()), |(p, r)| {
        let objet = p.objet.rotation(r).unwrap();
        let direction = r.appliquer(p.rayon.direction());
        let rayon = Rayon::new(r.appliquer(p.rayon.source()), direction).unwrap();
        let m = Rotation::depuis_matrice(r.matrice().map(|l| l.map(R::vers_f64))).unwrap();
        // TOURNE each for the source, the centre, the axes and the direction.
        accompagner(p, objet, rayon, 1.0, |n| m.appliquer(n), 4.0 * TOURNE)
    });
}

en_f32_et_f64!(tourner_la_scene_et_le_rayon_garde_la_distance);

fn deplacer_la_scene_et_le_rayon_garde_la_distance<R: Reel>() {
    let strategie = plante::<R>().prop_flat_map(|p| (Just(p), vecteur(p.etendue)));
    pour_tout(strategie, |(p, v)| {
        let objet = p.objet.translation(v).unwrap();
        let rayon = Rayon::new(p.rayon.source() + v, p.rayon.direction()).unwrap();
        // The object ends at most √3 + 1 times as far out, a half-space also rounds N·v (3u), and the
        // search reads coordinates that are larger by the same factor.
        accompagner(p, objet, rayon, 1.0, |n| n, 2.8 * (2.0 * ARRONDI + 3.0 + DISTANCE))
    });
}

en_f32_et_f64!(deplacer_la_scene_et_le_rayon_garde_la_distance);

/// The object with every length multiplied by k, its distance to O as well.
fn agrandi<R: Reel>(objet: ObjetGeo<R>, k: R) -> ObjetGeo<R> {
    match objet {
        ObjetGeo::Sphere(s) => {
            SphereGeo::new(s.centre() * k, s.rayon() * k, s.texture()).unwrap().into()
        }
        ObjetGeo::Plan(p) => {
            PlanGeo::new(p.orientation(), p.distance() * k, p.texture()).unwrap().into()
        }
        ObjetGeo::Boite(b) => {
            let (c, l) = (b.centre() * k, b.dimensions() * k);
            BoiteGeo::new(c, l, b.orientation(), b.texture()).unwrap().into()
        }
    }
}

fn agrandir_la_scene_multiplie_la_distance<R: Reel>() {
    pour_tout((plante::<R>(), reel(0.01, 100.0)), |(p, k)| {
        let rayon = Rayon::new(p.rayon.source() * k, p.rayon.direction()).unwrap();
        // The source, the centre and the size are multiplied.
        let bruit = 3.0 * ARRONDI;
        accompagner(p, agrandi(p.objet, k), rayon, k.vers_f64(), |n| n, bruit)
    });
}

en_f32_et_f64!(agrandir_la_scene_multiplie_la_distance);

/// The row "transformations" of `docs/precision.md`, against exact numbers.
fn chaque_transformation_tient_sa_borne<R: Reel>() {
    let strategie = (objet::<R>(1.0), vecteur::<R>(10.0), rotation::<R>(), reel::<R>(0.1, 10.0));
    let (u, eta) = (u::<R>(), R::ETA.vers_f64());
    pour_tout(strategie, |(objet, v, r, k)| {
        let (avant, v) = (objet.vers_ray(), <[R; 3]>::from(v));
        let deplace = objet.translation(v.into()).unwrap().vers_ray();
        let tourne = objet.rotation(r).unwrap().vers_ray();
        let agrandi = objet.homothetie(k).unwrap().vers_ray();
        let m = r.matrice().map(|ligne| ligne.map(R::vers_f64));
        for (change, tours) in [(deplace, 0.0), (tourne, 1.0), (agrandi, 0.0)] {
            prop_assert_eq!(change.texture(), avant.texture());
            for (n, n_change) in normales(avant).into_iter().zip(normales(change)) {
                let colonne = |j: usize| n.x * m[0][j] + n.y * m[1][j] + n.z * m[2][j];
                let n_tourne = Vecteur::from([0, 1, 2].map(colonne));
                let voulue = if tours > 0.0 { n_tourne } else { n };
                prop_assert!((n_change - voulue).longueur() <= tours * PRODUIT * u, "{:?}", n);
            }
        }
        if let (ObjetRay::Plan(plan), ObjetRay::Plan(tourne), ObjetRay::Plan(agrandi)) =
            (avant, tourne, agrandi)
        {
            prop_assert_eq!([tourne.distance(), agrandi.distance()], [plan.distance(); 2]);
        }
        if let (ObjetRay::Plan(plan), ObjetRay::Plan(deplace)) = (avant, deplace) {
            let n = <[R; 3]>::from(plan.normale());
            let termes: [Exact; 3] = [0, 1, 2].map(|i| &Exact::de(n[i]) * &Exact::de(v[i]));
            let exacte = &Exact::de(plan.distance()) - &somme(&termes);
            let poids: f64 = termes.iter().map(|x| x.vers_f64().abs()).sum();
            let permis = u * exacte.vers_f64().abs() + 4.1 * u * poids + 1.6 * eta;
            prop_assert!((&Exact::de(deplace.distance()) - &exacte).vers_f64().abs() <= permis);
        }
        let [
            Some((c, tailles)),
            Some((c_deplace, memes)),
            Some((c_tourne, encore)),
            Some((ici, tailles_k)),
        ] = [avant, deplace, tourne, agrandi].map(borne)
        else {
            return Ok(());
        };
        prop_assert_eq!(([memes, encore], ici), ([tailles; 2], c));
        let poids: f64 = c.iter().map(|x| x.vers_f64().abs()).sum();
        for i in 0..3 {
            let exacte = &Exact::de(c[i]) + &Exact::de(v[i]);
            let ecart = (&Exact::de(c_deplace[i]) - &exacte).vers_f64().abs();
            prop_assert!(ecart <= u * exacte.vers_f64().abs(), "moved, off by {ecart:e}");
            let termes = [0, 1, 2].map(|j| &Exact::de(c[j]) * &Exact::de(r.matrice()[j][i]));
            let ecart = (&Exact::de(c_tourne[i]) - &somme(&termes)).vers_f64().abs();
            prop_assert!(ecart <= 3.1 * u * poids + 1.6 * eta, "turned, off by {ecart:e}");
            let exacte = &Exact::de(tailles[i]) * &Exact::de(k);
            let ecart = (&Exact::de(tailles_k[i]) - &exacte).vers_f64().abs();
            prop_assert!(ecart <= u * exacte.vers_f64(), "grown, off by {ecart:e}");
        }
        Ok(())
    });
}

en_f32_et_f64!(chaque_transformation_tient_sa_borne);

/// What of an object turns with it.
fn normales<R: Reel>(objet: ObjetRay<R>) -> Vec<Vecteur> {
    match objet {
        ObjetRay::Sphere(_) => vec![],
        ObjetRay::Plan(plan) => vec![plan.normale().vers_f64()],
        ObjetRay::Boite(boite) => boite.normales().map(Vecteur::vers_f64).to_vec(),
    }
}

fn somme([a, b, c]: &[Exact; 3]) -> Exact {
    &(a + b) + c
}

/// The centre and three sizes of an object that has them.
fn borne<R: Reel>(objet: ObjetRay<R>) -> Option<([R; 3], [R; 3])> {
    match objet {
        ObjetRay::Sphere(sphere) => Some((sphere.centre().into(), [sphere.rayon(); 3])),
        ObjetRay::Plan(_) => None,
        ObjetRay::Boite(boite) => Some((boite.centre().into(), boite.demi_longueurs())),
    }
}

/// Any normal, of any length: the surface passes through the point, and the normal keeps its direction.
fn un_mur_passe_par_son_point<R: Reel>() {
    pour_tout((vecteur::<R>(30.0), vecteur::<R>(30.0)), |(point, normale)| {
        let Ok(mur) = PlanGeo::par_un_point(point, normale, Texture(0)) else {
            prop_assert_eq!(normale, Vecteur::NUL);
            return Ok(());
        };
        // Its axes are those of patterns on it.
        let axes = mur.orientation().axes().map(|axe| axe.vers_f64());
        for (i, j) in [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2)] {
            let manque = axes[i].produit_scalaire(axes[j]) - f64::from(u8::from(i == j));
            prop_assert!(manque.abs() <= ORTHONORMALE * u::<R>(), "{i}, {j}: {manque}");
        }
        let mur = mur.vers_ray();
        let (n, p) = (mur.normale().vers_f64(), point.vers_f64());
        let voulue = normale.vers_f64().unitaire().unwrap();
        // A rotation is rounded once, by u. Before, in f64: the quotient 1u, the Newton step 2u, for a first
        // axis that is across to 4u only, its rounding 2u; and 4u for the vector of this test.
        prop_assert!((n - voulue).longueur() <= u::<R>() + 10.0 * u::<f64>(), "{:?}", n);
        // Three products and two sums in R, and as many and one more here.
        let haut = n.produit_scalaire(p) + mur.distance().vers_f64();
        let permis = (3.0 * u::<R>() + 4.0 * u::<f64>()) * p.longueur() * (1.0 + 16.0 * u::<R>());
        prop_assert!(haut.abs() <= permis, "{} of {}", haut, permis);
        Ok(())
    });
    let refus = PlanGeo::par_un_point(Vecteur::NUL, Vecteur::<R>::NUL, Texture(0)).unwrap_err();
    assert_eq!(refus.to_string(), "normale is 0.0, but must be a vector other than 0");
    for axe in [[R::UN, R::ZERO, R::ZERO], [R::ZERO, -R::UN, R::ZERO], [R::ZERO, R::ZERO, R::UN]] {
        let axe = Vecteur::from(axe);
        let mur = PlanGeo::par_un_point(axe, axe, Texture(0)).unwrap().vers_ray();
        assert_eq!((mur.normale(), mur.distance()), (axe, -R::UN));
    }
}

en_f32_et_f64!(un_mur_passe_par_son_point);
