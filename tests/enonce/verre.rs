//! Ways out of a solid, for rays from its surface, from within rounding of it, and from within several solids.

use commun::fabrique::{boite_droite, sphere, v};
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::oracle::{Passage, ecart_de_snell};
use commun::promesses::{Essai, refracte};
use commun::regimes::{deux_puissance, direction, entre, signe};
use commun::tolerances::{promesses, u};
use commun::{arrondi, en_f32_et_f64};
use lancer_rayon::{NoIntersection, ObjetRay, PlanGeo, Rayon, Reel, Rotation, Texture, Vecteur};

/// Rays from exactly on the surface, and in the plane of a face, where every number is exact. Such a ray leaves at the
/// far side or not at all.
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
    // Rays in the plane of a face, which belongs to the box; beside it; and along an edge.
    assert_eq!(sortie(&boite, v(1.0, 0.0, 0.0), haut), Some((2.0, [0.0, 1.0, 0.0])));
    assert_eq!(sortie(&boite, v(1.0, -9.0, 3.0), haut), Some((11.0, [0.0, 1.0, 0.0])));
    assert_eq!(sortie(&boite, v(1.5, 0.0, 0.0), haut), None);
    // The ray and the edge at (1, 2) share one point, where the ray enters as well.
    let croise = Rayon::new(v(0.0, 3.0, 0.0), v(1.0, -1.0, 0.0)).unwrap();
    let [entree, fin] = [boite.intersection(&croise), boite.sortie(&croise)];
    assert_eq!(entree.unwrap().distance(), fin.unwrap().distance());
    // Through a corner the first pair gives the normal, as at an entry.
    let coin = sortie(&boite, v(0.0, 1.0, 2.0), v(1.0, 1.0, 1.0));
    assert_eq!(coin.unwrap().1, [1.0, 0.0, 0.0]);

    let (monte, descend) = (v(0.0, 0.0, 1.0), v(0.0, 0.0, -1.0));
    assert_eq!(sortie(&sol, v(0.0, 0.0, -3.0), monte), Some((3.0, [0.0, 0.0, 1.0])));
    assert_eq!(sortie(&sol, v(0.0, 0.0, -3.0), descend), None);
    assert_eq!(sortie(&sol, v(0.0, 0.0, -3.0), haut), None);
    // A level ray, whatever the signs of its zeros.
    assert_eq!(sortie(&sol, v(0.0, 0.0, -3.0), v(-1.0, -0.0, -0.0)), None);
    assert_eq!(sortie(&sol, v(0.0, 0.0, 0.0), monte), None);
    assert_eq!(sortie(&sol, v(0.0, 0.0, 3.0), descend), None);
    // Too far for the type.
    let pente = Vecteur::new(R::UN, R::ZERO, R::ETA);
    assert_eq!(sortie(&sol, v(0.0, 0.0, -3.0), pente), None);
}

en_f32_et_f64!(de_la_surface_un_rayon_sort_en_face_ou_pas);

/// From within rounding of the surface, and along it too, a ray that starts inside as computed leaves, and within two
/// radii.
fn d_une_boule_tout_rayon_sort_a_moins_de_deux_rayons<R: Reel>() {
    let mut dedans = 0;
    let faire = |alea: &mut Hasard| {
        let (n, r) = (direction(alea), R::depuis_f64(entre(alea, 0.5, 2.0)));
        let au_hasard = direction(alea);
        let tangente = au_hasard - n * au_hasard.produit_scalaire(n);
        let penche = (-70.0 * alea.f64()).exp2();
        let vers = tangente + n * if alea.bool() { penche } else { -penche };
        (sphere(Vecteur::NUL, r), r, Rayon::new(arrondi(n * r.vers_f64()), arrondi(vers)).unwrap())
    };
    pour_chaque(100_000, faire, |(boule, r, rayon)| {
        if rayon.source().longueur_carree() < r * r {
            let t = boule.sortie(&rayon).unwrap().distance();
            // A root, and three roundings each of SA and AB.
            let plus = 1.0 + promesses::DISTANCE_SPHERE * u::<R>();
            assert!(t > R::ZERO && t.vers_f64() <= 2.0 * r.vers_f64() * plus, "{t}");
            dedans += 1;
        }
    });
    assert!(dedans > 20_000, "{dedans}");
}

en_f32_et_f64!(d_une_boule_tout_rayon_sort_a_moins_de_deux_rayons);

/// Between media of one index, or of two that differ by rounding, light goes on at any angle, in and out: straight on
/// at η = 1, and otherwise as Snell's law says. So does the cosine behind, which Fresnel's formula needs.
fn entre_milieux_assortis_la_lumiere_va_tout_droit<R: Reel>() {
    let u = u::<R>();
    let (mut rasants, mut pires) = (0, [0.0_f64; 2]);
    let faire = |alea: &mut Hasard| {
        let tour = Rotation::<R>::new(arrondi(direction(alea) * 3.0)).unwrap();
        let objet = ObjetRay::from(PlanGeo::new(tour, R::ZERO, Texture(0)).unwrap());
        let [x, y, n] = tour.axes().map(Vecteur::vers_f64);
        let (angle, monte) = (entre(alea, -3.0, 3.0), signe(alea));
        let cosinus = deux_puissance(alea, u.log2() + 1.0, -1.0);
        let d = x * angle.cos() + y * angle.sin() + n * (monte * cosinus);
        let rayon = Rayon::new(arrondi(n * -monte), arrondi(d)).unwrap();
        let passage = if monte < 0.0 { Passage::Entree } else { Passage::Sortie };
        let peu = [1.0, 2.0, 3.0, deux_puissance(alea, 0.0, 12.0)];
        (objet, rayon, passage, peu.map(|peu| peu * 2.0 * u))
    };
    pour_chaque(10_000, faire, |(objet, rayon, passage, peu)| {
        let Ok(touche) = passage.de(&objet, &rayon) else { return };
        let (n, d) = (touche.normale(), rayon.direction());
        let devant = n.produit_scalaire(d).absolu().vers_f64();
        if devant <= 3.2 * u {
            return;
        }
        rasants += u32::from(devant < 100.0 * u);
        let droit = touche.refracte(d, R::UN).unwrap().direction();
        let derriere = n.produit_scalaire(droit).absolu().vers_f64();
        // A direction that was turned outward is above its plane by less than 20u.
        let rase = passage == Passage::Sortie && derriere < 20.0 * u;
        let permis = promesses::TOUT_DROIT + if rase { promesses::REFLECHI_REDRESSE } else { 0.0 };
        let (_, ecart) = ecart_de_snell(d, n, R::UN, passage, Some(droit));
        let ecart = ecart.unwrap() / (permis * u);
        assert!(ecart <= 1.0, "{ecart}");
        // N·D rounds by 3.1u, twice.
        assert!((derriere - devant).abs() <= (permis + 6.2) * u, "{derriere} {devant}");
        pires[0] = pires[0].max(ecart);
        for peu in peu.into_iter().flat_map(|peu| [-peu, peu]) {
            let rapport = R::depuis_f64(1.0 + peu);
            let suite = touche.refracte(d, rapport);
            assert!(suite.is_ok() || peu > 0.0, "{rapport}");
            if let (Passage::Sortie, Ok(dehors)) = (passage, suite) {
                assert_eq!(objet.intersection(&dehors), Err(NoIntersection));
            }
            let vers = [rapport, R::ZERO, R::ZERO, R::ZERO, R::ZERO];
            let part = refracte(&Essai { objets: vec![objet], rayon, passage, vers });
            assert!(part <= 1.0, "{part} at {rapport}");
            pires[1] = pires[1].max(part);
        }
    });
    println!("{rasants} graze, {pires:?} of the bounds at 1 and beside it");
    assert!(rasants > 500 && pires[0] > 0.2, "{rasants} {pires:?}");
}

en_f32_et_f64!(entre_milieux_assortis_la_lumiere_va_tout_droit);

/// Light whose cosine with the normal is exactly 0 goes in, as light at a hit does, up to the angle of total
/// reflection.
fn la_lumiere_rasante_entre<R: Reel>() {
    let sol = ObjetRay::from(PlanGeo::par_un_point(Vecteur::NUL, Vecteur::Z, Texture(0)).unwrap());
    let touche = sol.intersection(&Rayon::new(Vecteur::Z, -Vecteur::Z).unwrap()).unwrap();
    let suite = touche.refracte(Vecteur::X, R::depuis_f64(0.6)).unwrap();
    let [x, y, z] = <[R; 3]>::from(suite.direction()).map(R::vers_f64);
    assert!((x - 0.6).abs() <= 4.0 * u::<R>() && y == 0.0, "{x} {y}");
    assert!((z + 0.8).abs() <= 4.0 * u::<R>(), "{z}");
    assert_eq!(sol.intersection(&suite), Err(NoIntersection));
    assert_eq!(touche.refracte(Vecteur::X, R::UN).unwrap_err().champ, "refraction");
}

en_f32_et_f64!(la_lumiere_rasante_entre);

/// At a ratio of 1167 rounding turned light that left a half-space back into it, where N was as long as a kept matrix
/// allows: the light hit what it had left. No glass has such a ratio.
#[test]
fn un_rapport_au_dela_de_100_est_refuse() {
    let bas = [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0 - f32::EPSILON]];
    let bas = Rotation::depuis_matrice(bas).unwrap();
    let objet = ObjetRay::from(PlanGeo::new(bas, 0.0, Texture(0)).unwrap());
    let d = Vecteur::new(-7.046_234e-4, -4.873_232e-4, -0.999_999_2_f32);
    let sortie = objet.sortie(&Rayon::new(Vecteur::Z, d).unwrap()).unwrap();
    assert_eq!(sortie.normale().z, -1.0 - f32::EPSILON);
    for rapport in [1_167.235, 100.000_01, f32::MAX, f32::INFINITY, f32::NAN, 0.0, -1.5] {
        let suite = sortie.refracte(d, rapport);
        let revient = suite.is_ok_and(|suite| objet.intersection(&suite).is_ok());
        assert!(!revient, "light that left at a ratio of {rapport} comes back");
        assert_eq!(suite.unwrap_err().champ, "rapport", "{rapport}");
    }
    let dehors = sortie.refracte(d, 100.0).unwrap();
    assert_eq!(objet.intersection(&dehors), Err(NoIntersection));
}
