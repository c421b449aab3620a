//! From `f64` to `f32`, with an origin taken off first.

use commun::cas;
use commun::fabrique::murs;
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::oracle::{Exact, dehors, exacts, scalaire};
use commun::passages::flou_du_point;
use commun::regimes::{deux_puissance, direction, entre};
use lancer_rayon::pour_les_tests::FLOU_PROPRE;
use lancer_rayon::{
    BoiteGeo, ErreurGeo, Monde, ObjetGeo, ObjetRay, PlanGeo, Rayon, Rotation, SphereGeo, Texture,
    Vecteur, places,
};

/// An origin as surveyors have it: metres east of a meridian and north of the equator.
const ORIGINE: Vecteur = Vecteur::new(500_000.0, 0.0, 4_200_000.0);

/// A place in the town around the origin, to a tenth of a millimetre.
fn lieu(alea: &mut Hasard, haut: f64) -> Vecteur {
    let mut le_long = || (entre(alea, -50.0, 50.0) * 1e4).round() / 1e4;
    ORIGINE + Vecteur::new(le_long(), haut, le_long())
}

/// Balls and turned boxes of a metre or two on a floor.
fn ville(alea: &mut Hasard) -> Result<Vec<ObjetGeo>, ErreurGeo> {
    let sol = PlanGeo::par_un_point(ORIGINE, Vecteur::new(0.01, 1.0, 0.02), Texture(0))?;
    let mut objets = vec![sol.into()];
    for i in 1..200 {
        let haut = entre(alea, 0.0, 2.0);
        let (centre, texture) = (lieu(alea, haut), Texture(i));
        objets.push(if i % 2 == 0 {
            SphereGeo::new(centre, entre(alea, 0.5, 2.0), texture)?.into()
        } else {
            let tour = Rotation::new(direction(alea))?;
            let cotes = [(); 3].map(|()| entre(alea, 1.0, 4.0));
            BoiteGeo::new(centre, cotes.into(), tour, texture)?.into()
        });
    }
    Ok(objets)
}

/// How many of these rays name another object in `f32`, seen from this origin, than in `f64`; and how many of those
/// were certain.
fn autres(objets: &[ObjetGeo], rayons: &[Rayon], origine: Vecteur) -> Result<[u32; 2], ErreurGeo> {
    let simples = objets.iter().map(|objet| Ok(objet.vers_f32(origine)?.vers_ray()));
    let simples = simples.collect::<Result<Vec<ObjetRay<f32>>, ErreurGeo>>()?;
    let objets: Vec<_> = objets.iter().map(|objet| objet.vers_ray()).collect();
    let mut places = [(); 2].map(|()| vec![0.0; places(objets.len())]);
    let [a, b] = &mut places;
    let (double, simple) = (Monde::new(&objets, a).unwrap(), Monde::new(&simples, b).unwrap());
    let mut comptes = [0; 2];
    for rayon in rayons {
        let la = double.premiere_intersection(rayon);
        let rayon = rayon.vers_f32(origine)?;
        let ici = simple.premiere_intersection(&rayon);
        if ici.map(|touche| touche.indice()) != la.map(|touche| touche.indice()) {
            comptes[0] += 1;
            comptes[1] += u32::from(simple.certifie(&rayon, &ici));
        } else if let (Ok(ici), Ok(la)) = (ici, la)
            && origine == ORIGINE
            // Away from outlines the error is κ roundings of the scene.
            && la.normale().produit_scalaire(rayon.direction().vers_f64()) < -0.1
        {
            assert!((f64::from(ici.distance()) - la.distance()).abs() < 1e-3, "{ici:?} {la:?}");
        }
    }
    Ok(comptes)
}

/// With the origin taken off, hardly a ray sees another object than in `f64`. Without that many do, and call their
/// answer certain, since certificates speak of the numbers as stored.
#[test]
fn une_origine_sauve_la_scene_des_arpenteurs() {
    let faire = |alea: &mut Hasard| {
        let rayons = alea.liste(20_000, |alea, _| {
            let (oeil, vers) = (lieu(alea, 6.0), lieu(alea, 0.5));
            Rayon::new(oeil, vers - oeil).unwrap()
        });
        (ville(alea).unwrap(), rayons)
    };
    pour_chaque(1, faire, |(objets, rayons)| {
        let avec = autres(&objets, &rayons, ORIGINE).unwrap();
        let sans = autres(&objets, &rayons, Vecteur::NUL).unwrap();
        println!("other objects, and of these certain: {avec:?}, as they stand {sans:?}");
        assert!(avec[0] <= 4, "{avec:?}");
        assert!(sans[0] > 500 && sans[1] > sans[0] / 2, "{sans:?}");
    });
}

/// Each number is the nearest `f32` to the difference in `f64`, and the surface of a half-space stays where it was.
#[test]
fn chaque_nombre_est_le_plus_proche() {
    let simple = |v: Vecteur| Vecteur::<f32>::depuis_f64(v);
    let faire = |alea: &mut Hasard| {
        let cotes = <[f64; 3]>::from(direction(alea)).map(|x| x.abs() + 0.1);
        let tour = Rotation::new(direction(alea) * 3.0).unwrap();
        ([3.0, 7.0].map(|haut| lieu(alea, haut)), entre(alea, 0.1, 3.0), cotes.into(), tour)
    };
    pour_chaque(2_000, faire, |([centre, origine], r, cotes, tour)| {
        let boule = SphereGeo::new(centre, r, Texture(1)).unwrap().vers_f32(origine).unwrap();
        assert_eq!((boule.centre(), boule.rayon()), (simple(centre - origine), r as f32));
        assert_eq!(boule.texture(), Texture(1));

        let boite = BoiteGeo::new(centre, cotes, tour, Texture(2)).unwrap();
        assert_eq!((boite.centre(), boite.dimensions()), (centre, cotes));
        assert_eq!((boite.orientation(), boite.texture()), (tour, Texture(2)));
        let boite = boite.vers_f32(origine).unwrap();
        assert_eq!((boite.centre(), boite.dimensions()), (simple(centre - origine), simple(cotes)));
        assert_eq!(boite.texture(), Texture(2));
        let arrondie = tour.matrice().map(|ligne| ligne.map(|x| x as f32));
        assert_eq!(boite.orientation().matrice(), arrondie);
        // No constructor would polish this matrix.
        assert_eq!(Rotation::depuis_matrice(arrondie), Ok(boite.orientation()));

        let d = -tour.axes()[2].produit_scalaire(centre);
        let plan = PlanGeo::new(tour, d, Texture(3)).unwrap();
        assert_eq!((plan.orientation(), plan.distance(), plan.texture()), (tour, d, Texture(3)));
        let plan = plan.vers_f32(origine).unwrap();
        assert_eq!((plan.orientation(), plan.texture()), (boite.orientation(), Texture(3)));
        // N·(C − O) + d, computed exactly; it should be 0.
        let reste = scalaire(&exacts(tour.axes()[2]), &exacts(centre - origine));
        let reste = (&reste + &Exact::de(plan.distance())).vers_f64().abs();
        // The distance is rounded to `f32`, and the numbers of the place in `f64`.
        let permis = f64::from(plan.distance().abs()) * 6e-8 + 8.0 * 1.2e-16 * centre.longueur();
        assert!(reste <= permis, "{reste:e} > {permis:e}");

        let rayon = Rayon::new(centre, cotes).unwrap();
        let tourne = rayon.vers_f32(origine).unwrap();
        assert_eq!(tourne.source(), simple(centre - origine));
        assert_eq!(tourne.direction(), simple(rayon.direction()));
    });
}

/// What does not fit into an `f32` is refused, and the refusal names it.
#[test]
fn un_refus_nomme_le_champ() {
    let (loin, nul) = (Vecteur::new(0.0, 0.0, 1e20), Vecteur::NUL);
    let champ = |objet: Result<ObjetGeo<f32>, ErreurGeo>| objet.unwrap_err().champ;
    let boule = |c, r| ObjetGeo::from(SphereGeo::new(c, r, Texture(0)).unwrap());
    assert_eq!(champ(boule(loin, 1.0).vers_f32(nul)), "centre.z");
    assert!(boule(loin, 1.0).vers_f32(loin).is_ok());
    assert_eq!(champ(boule(nul, 1e20).vers_f32(nul)), "rayon");
    assert_eq!(champ(boule(nul, 1e-60).vers_f32(nul)), "rayon");
    let infinie = Vecteur::new(0.0, f64::INFINITY, 0.0);
    assert_eq!(champ(boule(nul, 1.0).vers_f32(infinie)), "origine.y");
    let cotes = Vecteur::new(1.0, 1e-30, 1.0);
    let boite = BoiteGeo::new(nul, cotes, Rotation::IDENTITE, Texture(0)).unwrap();
    assert_eq!(boite.vers_f32(nul).unwrap_err().champ, "dimensions.y");
    let plan = PlanGeo::new(Rotation::IDENTITE, 1e20, Texture(0)).unwrap();
    assert_eq!(plan.vers_f32(nul).unwrap_err().champ, "distance");
    assert_eq!(plan.vers_f32(-loin).unwrap().distance(), 0.0);
    let rayon = Rayon::new(loin, loin).unwrap();
    assert_eq!(rayon.vers_f32(nul).unwrap_err().champ, "source.z");
    assert_eq!(rayon.vers_f32(infinie).unwrap_err().champ, "origine.y");
}

/// A ray knows its source no more exactly in `f32` than before, and its δ stays finite.
#[test]
fn un_flou_ne_devient_ni_plus_petit_ni_infini() {
    let rayon = Rayon::new(Vecteur::NUL, Vecteur::X).unwrap();
    for flou in [1e-300, 0.1, 1.0 / 3.0, 7e30, 1e300] {
        let simple = rayon.avec_flou(flou).unwrap().vers_f32(Vecteur::NUL).unwrap().flou();
        assert!(simple > 0.0 && simple < f32::INFINITY, "{flou}: {simple}");
        assert!(f64::from(simple) >= flou || simple == f32::MAX, "{flou}: {simple}");
    }
    assert_eq!(rayon.vers_f32(Vecteur::NUL).unwrap().flou(), 0.0);
}

/// A ray that is inside something stays inside in `f32` and in `f64`, with a δ or without.
#[test]
fn un_rayon_dedans_le_reste_dans_l_autre_scalaire() {
    let rayon = Rayon::new(Vecteur::NUL, Vecteur::X).unwrap();
    for flou in [0.0, 0.1] {
        let rayon = rayon.avec_flou(flou).unwrap();
        // The δ of the next turn is above 0 and shows on which side the ray is.
        let simple = |rayon: Rayon| rayon.vers_f32(Vecteur::NUL).unwrap();
        let tourne = |rayon: Rayon<f32>| rayon.bifurque(1.0, Vecteur::Y).unwrap();
        assert_ne!(tourne(simple(rayon.dedans())), tourne(simple(rayon)));
        assert_eq!(tourne(simple(rayon.dedans())), tourne(simple(rayon).dedans()));
        let temoin = |rayon: Rayon<f32>| rayon.temoin_f64().bifurque(1.0, Vecteur::Y).unwrap();
        assert_ne!(temoin(simple(rayon).dedans()), temoin(simple(rayon)));
    }
}

/// Far from O a source is on its surface only to the rounding of `f64` there. This stays so when the origin is moved to
/// the source, where `f32` has no rounding to add.
#[test]
fn un_flou_loin_de_o_vaut_pres_de_l_origine() {
    let loin = Vecteur::new(4.2e6, 0.0, 5e5);
    let rayon = Rayon::new(loin, Vecteur::X).unwrap().avec_flou(1e-12).unwrap();
    let simple = rayon.vers_f32(loin).unwrap();
    assert_eq!(simple.source(), Vecteur::NUL);
    // Each coordinate may be off by half a unit in its last place.
    assert!(f64::from(simple.flou()) > 1e-12 + 4.7e6 * f64::EPSILON / 2.0, "{simple:?}");
}

/// Rays in `f64` start beside an edge of a room, into the other wall, and are converted with the room. Rounding puts
/// many behind that wall, yet none passes it. Some of those that forget their δ do.
#[test]
fn une_chambre_convertie_reste_close() {
    let u = f64::from(f32::EPSILON / 2.0);
    let (mut suites, mut derriere, mut sans_flou) = (0, 0, 0);
    let faire = |alea: &mut Hasard| {
        let tour = Rotation::new(direction(alea) * 3.0).unwrap();
        let origine = *alea.choix(&[Vecteur::NUL, ORIGINE]);
        let milieu = origine + direction(alea) * *alea.choix(&[0.0, 1.0, 100.0]);
        let murs = murs(milieu, tour, 2.0, [None, Some([0.4, 0.2])][alea.usize(0..2)]);
        let depuis = alea.liste(100, |alea, _| {
            let peu = deux_puissance(alea, -30.0, -10.0);
            let coin = tour.appliquer(Vecteur::new(1.0, 1.0 - peu, entre(alea, -1.0, 1.0)));
            let depart = milieu + direction(alea) * 0.9;
            (Rayon::new(depart, milieu + coin - depart).unwrap(), direction(alea))
        });
        (origine, murs, depuis)
    };
    pour_chaque(cas(40), faire, |(origine, murs, depuis)| {
        let simples = murs.iter().map(|mur| Ok(mur.vers_f32(origine)?.vers_ray()));
        let simples = simples.collect::<Result<Vec<ObjetRay<f32>>, ErreurGeo>>().unwrap();
        let murs: Vec<_> = murs.iter().map(|mur| mur.vers_ray()).collect();
        let (double, simple) = (Monde::de_liste(&murs), Monde::de_liste(&simples));
        // How much deeper a hit lies in some wall than twice what lemma 22 allows in one type.
        let exces = |rayon: &Rayon<f32>| {
            let Ok(touche) = simple.premiere_intersection(rayon) else { return f64::INFINITY };
            let de_plus =
                flou_du_point(touche.distance(), touche.point()) + u * (FLOU_PROPRE * 2.6);
            let profond = simples.iter().map(|mur| -dehors(mur, touche.point()));
            profond.fold(0.0, f64::max) - 2.0 * (f64::from(rayon.flou()) + de_plus)
        };
        for (rayon, vers) in depuis {
            let touche = double.premiere_intersection(&rayon).unwrap();
            let n = touche.normale();
            let le_long = vers.produit_scalaire(n).min(0.0);
            let suite = touche.secondaire(vers - n * (2.0 * le_long)).unwrap();
            let suite = suite.vers_f32(origine).unwrap();
            assert!(exces(&suite) <= 0.0, "{suite:?}");
            let oublieux = Rayon::new(suite.source(), suite.direction()).unwrap();
            sans_flou += u32::from(exces(&oublieux) > 1e-3);
            derriere += u32::from(simple.contient(suite.source()));
            suites += 1;
        }
    });
    assert!(derriere > suites / 4 && sans_flou > 20, "{suites} {derriere} {sans_flou}");
}

/// Code that is generic over the scalar gets the object itself in `f64` and that of `vers_f32` in `f32`, also with an
/// origin.
#[test]
fn un_objet_passe_a_l_un_ou_l_autre_scalaire() {
    pour_chaque(4, ville, |objets| {
        for objet in objets.unwrap() {
            assert_eq!(objet.vers::<f64>(Vecteur::NUL), Ok(objet));
            assert_eq!(objet.vers::<f64>(ORIGINE), objet.translation(-ORIGINE));
            assert_eq!(objet.vers::<f32>(ORIGINE), objet.vers_f32(ORIGINE));
            assert!(objet.vers::<f32>(ORIGINE).is_ok());
        }
    });
    let loin = SphereGeo::new(Vecteur::new(0.0, 1e30, 0.0), 1.0, Texture(0)).unwrap();
    let loin = ObjetGeo::from(loin);
    assert!(loin.vers::<f64>(Vecteur::NUL).is_ok());
    assert_eq!(loin.vers::<f32>(Vecteur::NUL).unwrap_err().champ, "centre.y");
    let nulle_part = Vecteur::new(f64::NAN, 0.0, 0.0);
    assert_eq!(loin.vers::<f64>(nulle_part).unwrap_err().champ, "origine.x");
}
