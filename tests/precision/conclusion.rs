//! Hits where the promises of `docs/precision.md` end, in the band of a decision: the normal of a sphere, a sphere lost
//! in rounding, the half-space.
//!
//! Each test names what it builds, then what must hold. It counts the hits that it judged, so that it fails if its
//! construction builds nothing.

use commun::fabrique::sphere;
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::litteral;
use commun::oracle::Exact;
use commun::regimes::{Cas, Genre, deux_puissance, direction, entre, regimes};
use commun::tolerances::{promesses, u};
use commun::{arrondi, en_f32_et_f64};
use lancer_rayon::pour_les_tests::{ARRONDI_PERDU, PENCHE, PUISSANCE_PERDUE, TRAVERS_PERDU};
use lancer_rayon::{
    Intersection, NoIntersection, Nombre, ObjetRay, PlanGeo, Rayon, Reel, Rotation, Texture,
    Vecteur,
};

/// How many cases each regime has, and each construction that hits often.
const CAS: u32 = 2_000;

/// Passes every hit of the regimes of a shape to `juger`.
fn chaque_touche<R: Reel>(genre: Genre, mut juger: impl FnMut(&Cas<R>, &Intersection<R>)) {
    for regime in regimes::<R>().into_iter().filter(|regime| regime.genre == genre) {
        pour_chaque(
            CAS,
            |alea| (regime.cas)(alea),
            |cas| {
                if let Ok(touche) = cas.objet.intersection(&cas.rayon) {
                    juger(&cas, &touche);
                }
            },
        );
    }
}

// The normal of a sphere.

/// Built: the regimes of spheres, whether or not the ray truly hits. Held: N is the direction of CP.
fn la_normale_d_une_sphere_est_celle_du_point<R: Reel>() {
    let (mut jugees, mut penchees) = (0, 0);
    chaque_touche::<R>(Genre::Sphere, |Cas { objet, rayon }, touche| {
        let ObjetRay::Sphere(sphere) = objet else { unreachable!("a regime of spheres") };
        let (centre, r) = (sphere.centre().vers_f64(), sphere.rayon().vers_f64());
        let f = (rayon.source().vers_f64() - centre).longueur();
        let p = rayon.point(touche.distance()).vers_f64();
        let cp = p - centre;
        // 2u round N, 14u lean a grazing one, and 4u take CP past a right angle. P is rounded twice in each coordinate,
        // f once and CP once.
        let etendue = touche.distance().vers_f64() + p.longueur() + f;
        let permis = u::<R>() * (6.0 + PENCHE + 4.0 * etendue / r);
        // Above 0.1 rad nothing is left of the direction to judge.
        if permis < 0.1 {
            let n = touche.normale().vers_f64();
            let ecart = (n - cp / cp.longueur()).longueur();
            assert!(ecart <= permis, "off by {ecart:e}, {permis:e} allowed");
            jugees += 1;
            let cosinus = -n.produit_scalaire(rayon.direction().vers_f64());
            penchees += u32::from(cosinus < (PENCHE + 2.0) * u::<R>());
        }
    });
    assert!(jugees > CAS && (penchees > 0 || u::<R>() < f64::EPSILON), "{jugees}, {penchees}");
}

en_f32_et_f64!(la_normale_d_une_sphere_est_celle_du_point);

/// Built: a sphere as small as the rounding of its distance, so that CB may point away from the source. Held: N is then
/// the part of CB across the ray, leaned towards the source.
fn la_normale_d_une_sphere_perdue_est_en_travers_du_rayon<R: Reel>() {
    let mut penchees = 0;
    let faire =
        |alea: &mut Hasard| (arrondi::<R>(direction(alea)), R::depuis_f64(1.0 + alea.f64()));
    pour_chaque(20 * CAS, faire, |(d, loin)| {
        let rayon = Rayon::new(Vecteur::NUL, d).unwrap();
        let d = rayon.direction();
        let centre = d * loin;
        let Ok(touche) = sphere(centre, loin * R::U).intersection(&rayon) else { return };
        // Exact in f64 for f32.
        let cb = (d * touche.distance() - centre).vers_f64();
        let d = d.vers_f64();
        let le_long = cb.produit_scalaire(d);
        let travers = cb - d * (le_long / d.longueur_carree());
        if le_long > 0.0 && travers.longueur() > le_long {
            let ecart = (touche.normale().vers_f64() - travers / travers.longueur()).longueur();
            // The lean counts, and 2u each for N and for this test.
            assert!(ecart <= (PENCHE + 4.0) * u::<R>(), "off by {ecart:e}");
            penchees += 1;
        }
    });
    assert!(penchees > 20, "{penchees} leaned");
}

en_f32_et_f64!(la_normale_d_une_sphere_perdue_est_en_travers_du_rayon);

/// Built: a sphere so small and far that nothing is left of CB, with |D|² just within the 12u up to which D is kept.
/// Held: N is −D made unit, to the 3.6u of the promise, which −D itself would exceed.
fn la_normale_d_une_sphere_perdue_est_unitaire<R: Reel>() {
    let mut perdues = 0;
    let long = R::UN + R::depuis_f64(6.0 * u::<R>());
    let axes = [[long, R::ZERO, R::ZERO], [R::ZERO, -long, R::ZERO]].map(Vecteur::from);
    let faire = |alea: &mut Hasard| (axes[alea.tour % 2], R::depuis_f64(1.0 + alea.f64()));
    pour_chaque(2 * CAS, faire, |(d, loin)| {
        let rayon = Rayon::new(Vecteur::NUL, d).unwrap();
        assert_eq!(rayon.direction(), d);
        let Ok(touche) = sphere(d * loin, R::U * R::U).intersection(&rayon) else { return };
        let n = touche.normale();
        let ecart = (n.vers_f64().longueur() - 1.0).abs();
        let permis = promesses::UNITAIRE_SPHERE * u::<R>();
        assert!(ecart <= permis, "|N| is off by {ecart:e}");
        assert!(n.produit_scalaire(d) < R::ZERO, "{n:?} {rayon:?}");
        perdues += 1;
    });
    assert!(perdues > CAS / 4, "{perdues} hits");
}

en_f32_et_f64!(la_normale_d_une_sphere_perdue_est_unitaire);

// A sphere lost in rounding.

/// Built: SC is at a right angle to D, and |SC| within 3 units in the last place of r, so that rounding sees S outside
/// and the ray enter. Held: a miss.
fn sc_a_angle_droit_de_d_manque<R: Reel>() {
    let faire = |alea: &mut Hasard| {
        let sc = arrondi::<R>(Vecteur::new(0.0, 1.0 + alea.f64(), alea.f64()));
        let mut presque_un = || R::depuis_f64(1.0 + f64::from(alea.i8(-3..=3)) * 2.0 * u::<R>());
        let objet = sphere(sc, sc.longueur() * presque_un());
        (objet, Rayon::new(Vecteur::NUL, Vecteur::new(presque_un(), R::ZERO, R::ZERO)).unwrap())
    };
    pour_chaque(CAS, faire, |(objet, rayon)| {
        assert_eq!(objet.intersection(&rayon), Err(NoIntersection));
    });
}

en_f32_et_f64!(sc_a_angle_droit_de_d_manque);

/// Built: the regimes of spheres. Held: t ≤ SA, both as computed.
fn une_sphere_est_touchee_avant_a<R: Reel>() {
    chaque_touche::<R>(Genre::Sphere, |Cas { objet, rayon }, touche| {
        let ObjetRay::Sphere(sphere) = objet else { unreachable!("a regime of spheres") };
        let (s, d) = (rayon.source(), rayon.direction());
        let sa = (sphere.centre() - s).produit_scalaire(d) / d.longueur_carree();
        assert!(touche.distance() <= sa, "{} > {sa}", touche.distance());
    });
}

en_f32_et_f64!(une_sphere_est_touchee_avant_a);

/// Built: a unit sphere from 2^-8/u to 4/u away, either about the origin, where P is hardly rounded, or as far from the
/// origin. Held: `marge()` is +∞ exactly where `docs/precision.md` says so.
fn une_sphere_perdue_a_une_marge_infinie<R: Reel>() {
    let (mut finies, mut opposes, mut infinies) = (0, 0, [0; 3]);
    let faire = |alea: &mut Hasard| {
        let (d, loin) = (direction(alea), deux_puissance(alea, -8.0, 2.0) / u::<R>());
        let centre = direction(alea) * if alea.bool() { alea.f64() } else { loin };
        let source = arrondi(centre - d * loin + direction(alea) * alea.f64());
        (arrondi::<R>(centre), Rayon::new(source, arrondi(d)).unwrap())
    };
    pour_chaque(20 * CAS, faire, |(centre, rayon)| {
        let Ok(touche) = sphere(centre, R::UN).intersection(&rayon) else { return };
        let (p, n) = (rayon.point(touche.distance()).vers_f64(), touche.normale().vers_f64());
        let cp = p - centre.vers_f64();
        let le_long = n.produit_scalaire(cp);
        let q2 = (cp - n * le_long).longueur_carree();
        let e = u::<R>() * (p.x.abs() + p.y.abs() + p.z.abs());
        let rapports = [
            (cp.longueur_carree() - 1.0).abs() / PUISSANCE_PERDUE,
            q2 / TRAVERS_PERDU,
            e / ARRONDI_PERDU,
        ];
        // Nearer to 1 the rounding of the kernel decides: some 8u of r² in |CP|² − r², and 2u of r in q.
        if rapports.iter().any(|rapport| (rapport - 1.0).abs() < 64.0 * u::<R>()) {
            return;
        }
        let perdue = rapports.map(|rapport| rapport > 1.0);
        let attendue = perdue.contains(&true) || le_long <= 0.0;
        opposes += u32::from(le_long <= 0.0);
        assert_eq!(touche.marge() == R::INFINI, attendue, "{rapports:?}");
        finies += u32::from(!attendue);
        for (raison, infinies) in infinies.iter_mut().enumerate() {
            *infinies += u32::from(perdue == [0, 1, 2].map(|autre| autre == raison));
        }
    });
    // Each of the three reasons must have been the only one at times; the point on the far side never is.
    assert!(finies > CAS && infinies.iter().all(|n| *n > 10), "{finies}, {infinies:?}");
    assert!(opposes > 10, "only {opposes} on the far side");
}

en_f32_et_f64!(une_sphere_perdue_a_une_marge_infinie);

/// From the exact centre, where |f| is 0, r = 16u‖P‖₁ is at the limit. The sum as computed decides there, not the exact
/// one.
#[test]
fn au_centre_la_somme_calculee_decide() {
    fn somme<R: Reel>(p: Vecteur<R>) -> R {
        p.x.absolu() + p.y.absolu() + p.z.absolu()
    }
    let faire = |alea: &mut Hasard| {
        let centre = arrondi::<f32>(direction(alea));
        let r = 16.0 * f32::U * (somme(centre) + f32::U * f32::from(alea.i8(-8..=8)));
        (centre, r, Rayon::new(centre, arrondi(direction(alea))).unwrap())
    };
    let [mut infinies, mut malgre_la_somme_exacte] = [0; 2];
    pour_chaque(20 * CAS, faire, |(centre, r, rayon)| {
        let sortie = sphere(centre, r).sortie(&rayon).unwrap();
        let p = sortie.point();
        let calculee = 16.0 * f32::U * somme(p);
        let exacte = 16.0 * f64::from(f32::U) * somme(p.vers_f64());
        let infinie = sortie.marge() == f32::INFINI;
        assert!(!infinie || r < calculee, "{centre:?} {r} {rayon:?}");
        infinies += u32::from(infinie);
        malgre_la_somme_exacte += u32::from(infinie && f64::from(r) >= exacte);
    });
    assert!(infinies > CAS && malgre_la_somme_exacte > 0, "{infinies} {malgre_la_somme_exacte}");
}

/// Built: a sphere on the ray whose far side is at O, smaller than the rounding of its distance, so that P is O. Held:
/// the margin is +∞, although P lies on the sphere.
fn un_point_du_cote_oppose_a_une_marge_infinie<R: Reel>() {
    for k in [2.0, 3.0, 8.0] {
        let r = R::U / R::depuis_f64(k * 4.0);
        let boule = sphere(Vecteur::new(R::ZERO, r, R::ZERO), r);
        let haut = Vecteur::new(R::ZERO, R::UN, R::ZERO);
        let rayon = Rayon::new(haut, -haut).unwrap();
        let touche = boule.intersection(&rayon).unwrap();
        assert_eq!((rayon.point(touche.distance()), touche.normale()), (Vecteur::NUL, haut));
        assert_eq!(touche.marge(), R::INFINI);
    }
}

en_f32_et_f64!(un_point_du_cote_oppose_a_une_marge_infinie);

/// Built: a sphere near the smallest, so far that CB is all rounding and CB² would be subnormal. Held:
/// the normal is unit.
#[test]
fn la_normale_d_une_sphere_dont_cb2_se_perd_est_unitaire() {
    let tres_peu = |alea: &mut Hasard| entre(alea, -1.0, 1.0) * (-530_f64).exp2();
    let faire = |alea: &mut Hasard| {
        let d = Vecteur::new(tres_peu(alea), -1.0, tres_peu(alea));
        let source = Vecteur::new(tres_peu(alea), 1.0 + alea.f64(), tres_peu(alea));
        Rayon::new(source, d).unwrap()
    };
    let mut perdues = 0;
    pour_chaque(CAS, faire, |rayon| {
        let boule = sphere(Vecteur::NUL, (-430_f64).exp2());
        let Ok(touche) = boule.intersection(&rayon) else { return };
        let ecart = (touche.normale().longueur() - 1.0).abs();
        assert!(ecart <= 8.0 * f64::U, "{ecart:e}");
        perdues += 1;
    });
    assert!(perdues > CAS / 4, "{perdues} hits");
}

// The half-space.

/// Built: N = (0, 0, 1 − 4u), and the point of the hit is O. Held: the margin is no less than d/|N|.
fn la_marge_est_selon_la_longueur_de_la_normale<R: Reel>() {
    let un_peu_court = R::depuis_f64(1.0 - 4.0 * u::<R>());
    let ligne = |i| core::array::from_fn(|j| if i == j { un_peu_court } else { R::ZERO });
    let tour = Rotation::depuis_matrice(core::array::from_fn(ligne)).unwrap();
    let s = Vecteur::new(R::ZERO, R::ZERO, R::UN);
    for k in 0..CAS {
        let d = R::depuis_f64((1.0 + f64::from(k) / f64::from(CAS)) * (-60_f64).exp2());
        let plan = ObjetRay::from(PlanGeo::new(tour, d, Texture(0)).unwrap());
        let touche = plan.intersection(&Rayon::new(s, -s).unwrap()).unwrap();
        assert_eq!((touche.distance(), touche.normale().z), (R::UN, un_peu_court), "{d}");
        let [marge, n, d] = [touche.marge(), un_peu_court, d].map(Exact::de);
        assert!(&marge * &n >= d, "{touche:?}");
    }
}

en_f32_et_f64!(la_marge_est_selon_la_longueur_de_la_normale);

/// Built: the regimes of half-spaces. Held: t is that of A.1, bit for bit.
fn un_demi_espace_suit_l_annexe<R: Reel>() {
    let mut juges = 0;
    chaque_touche::<R>(Genre::Plan, |Cas { objet, rayon }, touche| {
        let ObjetRay::Plan(plan) = objet else { unreachable!("a regime of half-spaces") };
        let (n, d) = (plan.normale(), plan.distance());
        assert_eq!(Some(touche.distance()), litteral::plan(n, d, rayon));
        juges += 1;
    });
    assert!(juges > CAS);
}

en_f32_et_f64!(un_demi_espace_suit_l_annexe);
