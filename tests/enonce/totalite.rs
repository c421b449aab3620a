//! Whatever bits go in, no invalid value can be constructed, and every query on valid ones ends.

use commun::hasard::{Hasard, pour_chaque};
use commun::passages::{exiger_apres_coup, exiger_les_passages};
use commun::strategies::{quelconque, vecteur_quelconque};
use commun::tolerances::{ECART_ROTATION, ORTHONORMALE, u};
use commun::{Bits, cas, en_f32_et_f64};
use lancer_rayon::{
    BoiteGeo, ErreurGeo, Face, ObjetGeo, ObjetRay, PlanGeo, Rayon, Reel, Rotation, SphereGeo,
    Texture, Vecteur, premiere_intersection,
};

/// Checks that a refusal names a field, and a value that this field does not accept.
fn refusee<R: Reel>(erreur: ErreurGeo) {
    let ErreurGeo { champ, valeur, .. } = erreur;
    let limite = R::LIMITE.vers_f64();
    let debut = champ.split(['.', '[', ' ', '|']).next().unwrap_or(champ);
    let admise = match debut {
        "centre" | "source" | "distance" => valeur.abs() <= limite,
        "rayon" | "dimensions" => (limite.recip()..=limite).contains(&valeur),
        "coefficient" => valeur > 0.0 && valeur < f64::INFINITY,
        "vecteur_rotation" | "translation" | "origine" => valeur.is_finite(),
        "direction" => valeur != 0.0 && valeur.is_finite(),
        "matrice" if champ.ends_with(']') => valeur.is_finite(),
        "matrice" => valeur <= ECART_ROTATION && valeur > 0.0,
        autre => panic!("unknown field {autre}"),
    };
    assert!(!admise, "{erreur}");
    assert!(!valeur.is_nan() || valeur.to_bits() == f64::NAN.to_bits(), "one NaN of many");
}

fn tient<R: Reel>(v: Vecteur<R>) -> bool {
    let limite = R::LIMITE.vers_f64();
    [v.x, v.y, v.z].into_iter().all(|x| x.vers_f64().abs() <= limite)
}

fn mesure<R: Reel>(l: R) -> bool {
    let limite = R::LIMITE.vers_f64();
    (limite.recip()..=limite).contains(&l.vers_f64())
}

fn valide<R: Reel>(objet: &ObjetRay<R>) {
    let normales = match objet {
        ObjetRay::Sphere(sphere) => {
            assert!(tient(sphere.centre()) && mesure(sphere.rayon()));
            vec![]
        }
        ObjetRay::Plan(plan) => {
            assert!(tient(Vecteur::new(plan.distance(), R::ZERO, R::ZERO)));
            vec![plan.normale()]
        }
        ObjetRay::Boite(boite) => {
            let double = boite.demi_longueurs().map(|l| l + l);
            assert!(tient(boite.centre()) && double.into_iter().all(mesure));
            let finis = |v: Vecteur<R>| v.vers_f64().longueur() < f64::INFINITY;
            for (centre, normale) in Face::TOUTES.map(|face| boite.face(face)) {
                assert!(finis(centre) && finis(normale));
                assert!(normale.produit_scalaire(centre).absolu() < R::INFINI);
            }
            boite.normales().to_vec()
        }
    };
    for n in normales {
        assert!((n.vers_f64().longueur_carree() - 1.0).abs() <= ORTHONORMALE * u::<R>());
    }
}

/// This ray asks each of these objects, also about the hit of another; then so do the rays from its hits.
fn interroger<R: Bits>(objets: &[ObjetRay<R>], rayon: &Rayon<R>) {
    for objet in objets {
        exiger_les_passages(objet, rayon, rayon.source());
        exiger_apres_coup(objet, [rayon, rayon]);
    }
    let Ok(touche) = premiere_intersection(objets, rayon) else { return };
    for objet in objets {
        assert!(objet.erreur(rayon, &touche) > R::ZERO);
        if let ObjetRay::Boite(boite) = objet {
            let (face, p) = boite.lieu(rayon, &touche);
            let p = <[R; 3]>::from(p);
            assert!(p.into_iter().all(|x| x.absolu() <= R::UN), "{:?}", p);
            assert!(p[face as usize % 3].absolu() == R::UN);
        }
    }
    for rapport in [rayon.source().x, R::UN / R::LIMITE, R::LIMITE, R::ETA, R::INFINI] {
        let verre = touche.refracte(rayon.direction(), rapport);
        let dites = ["marge", "rapport", "refraction", "source.x", "source.y", "source.z"];
        assert!(rapport < R::INFINI || verre.is_err_and(|e| e.champ == "rapport"));
        assert!(
            verre.is_ok_and(|verre| tient(verre.source()))
                || verre.is_err_and(|e| dites.contains(&e.champ))
        );
    }
}

/// The rotation that a matrix makes, if it is one, or that angles make; otherwise no turn.
fn rotation<R: Bits>(alea: &mut Hasard) -> Rotation<R> {
    let angles = Rotation::new(vecteur_quelconque(alea));
    let matrice = [(); 3].map(|()| <[R; 3]>::from(vecteur_quelconque(alea)));
    Rotation::depuis_matrice(matrice).or(angles).unwrap_or(Rotation::IDENTITE)
}

fn n_importe_quels_bits_donnent_une_valeur_valide_ou_une_erreur<R: Bits>() {
    let faire = |alea: &mut Hasard| {
        let vecteurs = [(); 5].map(|()| vecteur_quelconque(alea));
        let nombres = [(); 2].map(|()| quelconque::<R>(alea));
        (vecteurs, nombres, [(); 2].map(|()| rotation(alea)))
    };
    pour_chaque(cas(256), faire, |(vecteurs, [longueur, k], [r, r2])| {
        let [point, longueurs, v, source, direction] = vecteurs;
        let texture = Texture(0);
        let mut objets = Vec::new();
        let mut garder = |objet: Result<ObjetGeo<R>, ErreurGeo>| match objet {
            Ok(objet) => {
                valide(&objet.vers_ray());
                objets.push(objet);
            }
            Err(erreur) => refusee::<R>(erreur),
        };
        let possibles = [
            SphereGeo::new(point, longueur, texture).map(ObjetGeo::from),
            PlanGeo::new(r, longueur, texture).map(ObjetGeo::from),
            BoiteGeo::new(point, longueurs, r, texture).map(ObjetGeo::from),
            SphereGeo::new(point, R::UN, texture).map(ObjetGeo::from),
        ];
        for objet in possibles {
            garder(objet);
            if let Ok(objet) = objet {
                garder(objet.translation(v));
                garder(objet.rotation(r2));
                garder(objet.homothetie(k));
                // A half-space has no size to show a bad coefficient.
                assert!(objet.homothetie(k).is_err() || k > R::ZERO && k < R::INFINI);
                match objet.vers_f32(v) {
                    Ok(simple) => valide(&simple.vers_ray()),
                    Err(erreur) => refusee::<f32>(erreur),
                }
            }
        }
        let objets: Vec<_> = objets.into_iter().map(ObjetGeo::vers_ray).collect();
        // Few random rays hit anything, so some aim at the objects and some away from them.
        for vers in [direction, point - source, source - point, longueurs, -source] {
            match Rayon::new(source, vers) {
                Ok(rayon) => {
                    assert!(tient(rayon.source()));
                    let carre = rayon.direction().vers_f64().longueur_carree();
                    // The direction is kept (lemma 1), and this test rounds four times in f64.
                    assert!((carre - 1.0).abs() <= 15.1 * u::<R>() + 4.0 * u::<f64>());
                    interroger(&objets, &rayon);
                    let admis = k >= R::ZERO && k < R::INFINI;
                    let suites =
                        [("flou", rayon.avec_flou(k)), ("distance", rayon.bifurque(k, vers))];
                    for (champ, suite) in suites {
                        assert!(admis || suite.is_err_and(|e| e.champ == champ));
                    }
                    match rayon.vers_f32(v) {
                        Ok(simple) => assert!(tient(simple.source())),
                        Err(erreur) => refusee::<f32>(erreur),
                    }
                }
                Err(erreur) => refusee::<R>(erreur),
            }
        }
    });
}

en_f32_et_f64!(n_importe_quels_bits_donnent_une_valeur_valide_ou_une_erreur);

fn toute_direction_finie_non_nulle_est_rendue_unitaire<R: Bits>() {
    pour_chaque(cas(256), vecteur_quelconque::<R>, |v| {
        let finie = [v.x, v.y, v.z].into_iter().all(|x| x.absolu() < R::INFINI);
        let unitaire = v.unitaire();
        assert_eq!(unitaire.is_some(), finie && v != Vecteur::NUL);
        assert_eq!(Rayon::new(Vecteur::NUL, v).is_ok(), unitaire.is_some());
        if let Some(unitaire) = unitaire {
            // The largest coordinate keeps its sign, and the others keep their ratio to it.
            let (v, n) = ([v.x, v.y, v.z], [unitaire.x, unitaire.y, unitaire.z]);
            let grand = (0..3).fold(0, |i, j| if v[j].absolu() > v[i].absolu() { j } else { i });
            assert!((n[grand] > R::ZERO) == (v[grand] > R::ZERO));
            for i in 0..3 {
                let attendu = v[i].vers_f64() / v[grand].vers_f64();
                let obtenu = n[i].vers_f64() / n[grand].vers_f64();
                // There are two quotients of one rounding each, and those of this test in f64.
                assert!((obtenu - attendu).abs() <= 6.0 * u::<R>());
            }
        }
    });
}

en_f32_et_f64!(toute_direction_finie_non_nulle_est_rendue_unitaire);

fn un_rayon_refait_de_sa_source_et_de_sa_direction_est_le_meme<R: Bits>() {
    let faire = |alea: &mut Hasard| [(); 2].map(|()| vecteur_quelconque::<R>(alea));
    pour_chaque(cas(256), faire, |[s, d]| {
        if let Ok(rayon) = Rayon::new(s, d) {
            let bits = |v: Vecteur<R>| [v.x, v.y, v.z].map(R::bits);
            let encore = Rayon::new(rayon.source(), rayon.direction()).unwrap();
            assert_eq!(bits(encore.direction()), bits(rayon.direction()));
            assert_eq!(bits(encore.source()), bits(s));
        }
    });
}

en_f32_et_f64!(un_rayon_refait_de_sa_source_et_de_sa_direction_est_le_meme);

/// A δ and the distance of a turn are finite and no less than 0; what is not is refused by its
/// name.
fn un_flou_et_la_distance_d_un_virage_sont_finis<R: Reel>() {
    let rayon = Rayon::new(Vecteur::NUL, Vecteur::X).unwrap();
    for refuse in [R::INFINI, -R::INFINI, -R::ETA, R::depuis_f64(f64::NAN)] {
        assert_eq!(rayon.avec_flou(refuse).unwrap_err().champ, "flou");
        assert_eq!(rayon.bifurque(refuse, Vecteur::Y).unwrap_err().champ, "distance");
    }
    for admis in [R::ZERO, -R::ZERO, R::ETA, R::LIMITE] {
        assert_eq!(rayon.avec_flou(admis).unwrap().flou(), admis);
        assert_eq!(rayon.bifurque(admis, Vecteur::Y).unwrap().source().x, admis);
    }
}

en_f32_et_f64!(un_flou_et_la_distance_d_un_virage_sont_finis);

/// The point of a wall is in the limits, also where the distance of the wall is.
fn le_point_d_un_mur_est_dans_les_bornes<R: Reel>() {
    let trop = R::LIMITE + R::LIMITE;
    for x in [trop, -trop, R::INFINI, R::depuis_f64(f64::NAN)] {
        let point = Vecteur::new(R::ZERO, x, R::ZERO);
        let mur = PlanGeo::par_un_point(point, Vecteur::X, Texture(0));
        assert_eq!(mur.unwrap_err().champ, "point.y");
    }
}

en_f32_et_f64!(le_point_d_un_mur_est_dans_les_bornes);
