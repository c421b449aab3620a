//! Ways out of a solid, for rays from its surface, from within rounding of it, and from within several solids.

use commun::fabrique::sphere;
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::oracle::{Passage, ecart_de_snell};
use commun::promesses::{Essai, refracte};
use commun::regimes::{deux_puissance, direction, entre, signe};
use commun::tolerances::{promesses, u};
use commun::{arrondi, en_f32_et_f64};
use lancer_rayon::{NoIntersection, ObjetRay, PlanGeo, Rayon, Reel, Rotation, Texture, Vecteur};

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
