//! Moving, turning and scaling objects (handout §2.3).

use commun::fabrique::v;
use commun::hasard::{Hasard, pour_chaque};
use commun::mesure::poids;
use commun::oracle::{Exact, exacts, scalaire};
use commun::regimes::{entre, rotation};
use commun::strategies::{objet, vecteur};
use commun::tolerances::{ORTHONORMALE, PRODUIT, u};
use commun::{cas, en_f32_et_f64};
use lancer_rayon::{BoiteGeo, ObjetRay, PlanGeo, Reel, Rotation, Texture, Vecteur};

/// The row "transformation" of `docs/precision.md`, against exact numbers.
fn chaque_transformation_tient_sa_borne<R: Reel>() {
    let (u, eta) = (u::<R>(), R::ETA.vers_f64());
    let faire = |alea: &mut Hasard| {
        let (v, k) = (vecteur::<R>(alea, 10.0), R::depuis_f64(entre(alea, 0.1, 10.0)));
        (objet::<R>(alea), v, rotation::<R>(alea), k)
    };
    pour_chaque(cas(256), faire, |(objet, v, r, k)| {
        let avant = objet.vers_ray();
        let deplace = objet.translation(v).unwrap().vers_ray();
        let tourne = objet.rotation(r).unwrap().vers_ray();
        let agrandi = objet.homothetie(k).unwrap().vers_ray();
        let m = r.matrice().map(|ligne| ligne.map(R::vers_f64));
        for (change, tours) in [(deplace, 0.0), (tourne, 1.0), (agrandi, 0.0)] {
            assert_eq!(change.texture(), avant.texture());
            for (n, n_change) in normales(avant).into_iter().zip(normales(change)) {
                let colonne = |j: usize| n.x * m[0][j] + n.y * m[1][j] + n.z * m[2][j];
                let n_tourne = Vecteur::from([0, 1, 2].map(colonne));
                let voulue = if tours > 0.0 { n_tourne } else { n };
                assert!((n_change - voulue).longueur() <= tours * PRODUIT * u, "{:?}", n);
            }
        }
        if let (ObjetRay::Plan(plan), ObjetRay::Plan(tourne), ObjetRay::Plan(agrandi)) =
            (avant, tourne, agrandi)
        {
            assert_eq!([tourne.distance(), agrandi.distance()], [plan.distance(); 2]);
        }
        if let (ObjetRay::Plan(plan), ObjetRay::Plan(deplace)) = (avant, deplace) {
            let n = plan.normale();
            let exacte = &Exact::de(plan.distance()) - &scalaire(&exacts(n), &exacts(v));
            let poids = poids(n.vers_f64(), v.vers_f64());
            let permis = u * exacte.vers_f64().abs() + 4.1 * u * poids + 1.6 * eta;
            assert!((&Exact::de(deplace.distance()) - &exacte).vers_f64().abs() <= permis);
        }
        let [
            Some((c, tailles)),
            Some((c_deplace, memes)),
            Some((c_tourne, encore)),
            Some((ici, tailles_k)),
        ] = [avant, deplace, tourne, agrandi].map(borne)
        else {
            return;
        };
        assert_eq!(([memes, encore], ici), ([tailles; 2], c));
        let poids: f64 = c.iter().map(|x| x.vers_f64().abs()).sum();
        let colonnes = r.inverse().axes().map(exacts);
        for i in 0..3 {
            let exacte = &Exact::de(c[i]) + &exacts(v)[i];
            let ecart = (&Exact::de(c_deplace[i]) - &exacte).vers_f64().abs();
            assert!(ecart <= u * exacte.vers_f64().abs(), "moved, off by {ecart:e}");
            let exacte = scalaire(&c.map(Exact::de), &colonnes[i]);
            let ecart = (&Exact::de(c_tourne[i]) - &exacte).vers_f64().abs();
            assert!(ecart <= 3.1 * u * poids + 1.6 * eta, "turned, off by {ecart:e}");
            let exacte = &Exact::de(tailles[i]) * &Exact::de(k);
            let ecart = (&Exact::de(tailles_k[i]) - &exacte).vers_f64().abs();
            assert!(ecart <= u * exacte.vers_f64(), "grown, off by {ecart:e}");
        }
    });
}

en_f32_et_f64!(chaque_transformation_tient_sa_borne);

/// The normals of an object turn with it.
fn normales<R: Reel>(objet: ObjetRay<R>) -> Vec<Vecteur> {
    match objet {
        ObjetRay::Sphere(_) => vec![],
        ObjetRay::Plan(plan) => vec![plan.normale().vers_f64()],
        ObjetRay::Boite(boite) => boite.normales().map(Vecteur::vers_f64).to_vec(),
    }
}

/// The centre and three sizes of an object that has them.
fn borne<R: Reel>(objet: ObjetRay<R>) -> Option<([R; 3], [R; 3])> {
    match objet {
        ObjetRay::Sphere(sphere) => Some((sphere.centre().into(), [sphere.rayon(); 3])),
        ObjetRay::Plan(_) => None,
        ObjetRay::Boite(boite) => Some((boite.centre().into(), boite.demi_longueurs())),
    }
}

/// With any normal of any length the surface passes through the point, and the normal keeps its direction.
fn un_mur_passe_par_son_point<R: Reel>() {
    let faire = |alea: &mut Hasard| [(); 2].map(|()| vecteur::<R>(alea, 30.0));
    pour_chaque(cas(256), faire, |[point, normale]| {
        let Ok(mur) = PlanGeo::par_un_point(point, normale, Texture(0)) else {
            assert_eq!(normale, Vecteur::NUL);
            return;
        };
        // Patterns on the wall are measured along its axes.
        let axes = mur.orientation().axes().map(|axe| axe.vers_f64());
        for (i, j) in [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2)] {
            let manque = axes[i].produit_scalaire(axes[j]) - f64::from(u8::from(i == j));
            assert!(manque.abs() <= ORTHONORMALE * u::<R>(), "{i}, {j}: {manque}");
        }
        let mur = mur.vers_ray();
        let (n, p) = (mur.normale().vers_f64(), point.vers_f64());
        let voulue = normale.vers_f64().unitaire().unwrap();
        // A rotation is rounded once, by u. Before that, in f64, the quotient takes 1u, the Newton step 2u, since the
        // first axis is across only to 4u, and its rounding 2u. The vector of this test takes 4u.
        assert!((n - voulue).longueur() <= u::<R>() + 10.0 * u::<f64>(), "{:?}", n);
        // There are three products and two sums in R, and as many and one more here.
        let haut = n.produit_scalaire(p) + mur.distance().vers_f64();
        let permis = (3.0 * u::<R>() + 4.0 * u::<f64>()) * p.longueur() * (1.0 + 16.0 * u::<R>());
        assert!(haut.abs() <= permis, "{} of {}", haut, permis);
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

/// What `ObjetGeo` says of a centre that is turned 100,000 times by 0.1° in `f32`. The rotation that was composed keeps
/// it as far from O as C·M rounds, by 3.1u, and as M·Mᵀ is I, to 5.5u an element.
#[test]
fn un_tour_repris_derive_et_un_tour_compose_non() {
    let cotes = v(2.0, 2.0, 2.0);
    let decrite =
        BoiteGeo::<f32>::new(v(10.0, 0.0, 0.0), cotes, Rotation::IDENTITE, Texture(0)).unwrap();
    let pas = Rotation::new(v(0.0, 0.1_f64.to_radians(), 0.0)).unwrap();
    let (mut reprise, mut composee) = (decrite, Rotation::IDENTITE);
    for _ in 0..100_000 {
        (reprise, composee) = (reprise.rotation(pas).unwrap(), composee.puis(pas));
    }
    let derive = [reprise, decrite.rotation(composee).unwrap()]
        .map(|boite| boite.centre().vers_f64().longueur() / 10.0 - 1.0);
    assert!((derive[0] + 0.0025).abs() < 0.0001, "{derive:?}");
    assert!(derive[1].abs() <= 15.0 * u::<f32>(), "{derive:?}");
}
