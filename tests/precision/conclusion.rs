//! A hit where the promises of `docs/precision.md` end: in the band of a decision, and where the
//! search in the type of the scene and the conclusion in f64 disagree.
//!
//! Five parts: the normal of a sphere, a sphere lost in rounding, where the distance of the search
//! stands, which face of a box is named, the half-space. Each test names what it builds, then what must
//! hold; it counts the hits that it judged, so that a construction that builds nothing is red.

#[allow(dead_code, reason = "only its half-space is asked")]
use std::f64::consts::FRAC_PI_2;

use crate::commun::litteral;
use crate::commun::oracle::{Exact, verite};
use crate::commun::regimes::{Cas, deux_puissance, direction, entre, regimes, vectoriel};
use crate::commun::tolerances::u;
use crate::commun::{arrondi, en_f32_et_f64};
use fastrand::Rng;
use lancer_rayon::{
    BoiteGeo, BoiteRay, Intersection, NoIntersection, ObjetRay, PlanGeo, Rayon, Reel, Rotation,
    SphereGeo, Texture, Vecteur, est_occulte,
};

/// Cases of each regime, and of each construction that hits often.
const CAS: u32 = 2_000;

/// The descent −N·D at which an f64 has lost half of its digits, and the kernel compensates N·D.
const RASANT: f64 = 1.0 / 67_108_864.0; // 2^-26

/// Passes on every hit of the regimes whose name begins with `debut`.
fn chaque_touche<R: Reel>(debut: &str, mut juger: impl FnMut(&Cas<R>, &Intersection<R>)) {
    let mut alea = Rng::with_seed(9);
    for regime in regimes::<R>().into_iter().filter(|regime| regime.nom.starts_with(debut)) {
        for cas in (0..CAS).map(|_| (regime.cas)(&mut alea)) {
            if let Ok(touche) = cas.objet.intersection(&cas.rayon) {
                juger(&cas, &touche);
            }
        }
    }
}

fn sphere<R: Reel>(centre: Vecteur<R>, rayon: R) -> ObjetRay<R> {
    SphereGeo::new(centre, rayon, Texture(0)).unwrap().into()
}

fn boite(tour: Rotation<f32>, dimensions: [f32; 3]) -> BoiteRay<f32> {
    BoiteGeo::new(Vecteur::NUL, dimensions.into(), tour, Texture(0)).unwrap().vers_ray()
}

// The normal of a sphere.

/// Built: the regimes of spheres, whether or not the ray truly hits. Held: N is the direction of CP.
fn la_normale_d_une_sphere_est_celle_du_point<R: Reel>() {
    let (mut jugees, mut penchees) = (0, 0);
    chaque_touche::<R>("sphere", |Cas { objet, rayon }, touche| {
        let ObjetRay::Sphere(sphere) = objet else { unreachable!("a regime of spheres") };
        let (centre, r) = (sphere.centre().vers_f64(), sphere.rayon().vers_f64());
        let f = (rayon.source().vers_f64() - centre).longueur();
        let p = rayon.point(touche.distance()).vers_f64();
        let cp = p - centre;
        // 2u round N, 6u lean a grazing one, 4u take CP past a right angle; P is rounded twice in
        // each coordinate, f once, CP once.
        let etendue = touche.distance().vers_f64() + p.longueur() + f;
        let permis = u::<R>() * (12.0 + 4.0 * etendue / r);
        // Above 0.1 rad there is nothing left of the direction to judge.
        if permis < 0.1 {
            let n = touche.normale().vers_f64();
            let ecart = (n - cp / cp.longueur()).longueur();
            assert!(ecart <= permis, "off by {ecart:e}, {permis:e} allowed: {objet:?} {rayon:?}");
            jugees += 1;
            // A leaned normal has N·D = −6u.
            let cosinus = -n.produit_scalaire(rayon.direction().vers_f64());
            penchees += u32::from(cosinus < 8.0 * u::<R>());
        }
    });
    assert!(jugees > CAS && (penchees > 10 || u::<R>() < f64::EPSILON), "{jugees}, {penchees}");
}

en_f32_et_f64!(la_normale_d_une_sphere_est_celle_du_point);

/// Built: a sphere as small as the rounding of its distance, so that CB may point away from the
/// source. Held: N is then what CB has across the ray, leaned by 6u towards the source.
#[test]
fn la_normale_d_une_sphere_perdue_est_en_travers_du_rayon() {
    let (mut alea, mut penchees) = (Rng::with_seed(17), 0);
    for _ in 0..20 * CAS {
        let rayon = Rayon::new(Vecteur::NUL, direction(&mut alea)).unwrap();
        let (d, loin) = (rayon.direction(), 1.0 + alea.f64());
        let centre = d * loin;
        let Ok(touche) = sphere(centre, loin * u::<f64>()).intersection(&rayon) else { continue };
        let cb = d * touche.distance() - centre;
        let le_long = cb.produit_scalaire(d);
        let travers = cb - d * (le_long / d.longueur_carree());
        if le_long > 0.0 && travers.longueur() > le_long {
            let ecart = (touche.normale() - travers / travers.longueur()).longueur();
            // The lean of 6u, and 2u each for N and for this test.
            assert!(ecart <= 10.0 * u::<f64>(), "off by {ecart:e}: {centre:?} {rayon:?}");
            penchees += 1;
        }
    }
    assert!(penchees > 20, "{penchees} leaned");
}

/// Built: a sphere so small and far that nothing is left of CB, and |D|² just within the 12u up to
/// which D is kept. Held: N is −D made unit, to the 4u of the promise, which −D itself exceeds.
fn la_normale_d_une_sphere_perdue_est_unitaire<R: Reel>() {
    let (mut alea, mut perdues) = (Rng::with_seed(11), 0);
    let long = R::UN + R::depuis_f64(6.0 * u::<R>());
    let axes = [[long, R::ZERO, R::ZERO], [R::ZERO, -long, R::ZERO]].map(Vecteur::from);
    for d in (0..CAS).flat_map(|_| axes) {
        let rayon = Rayon::new(Vecteur::NUL, d).unwrap();
        assert_eq!(rayon.direction(), d);
        let objet = sphere(d * R::depuis_f64(1.0 + alea.f64()), R::U * R::U);
        let Ok(touche) = objet.intersection(&rayon) else { continue };
        let n = touche.normale();
        let ecart = (n.vers_f64().longueur() - 1.0).abs();
        assert!(ecart <= 4.0 * u::<R>(), "|N| is off by {ecart:e}: {rayon:?}");
        assert!(n.produit_scalaire(d) < R::ZERO, "{n:?} {rayon:?}");
        perdues += 1;
    }
    assert!(perdues > CAS / 4, "{perdues} hits");
}

en_f32_et_f64!(la_normale_d_une_sphere_perdue_est_unitaire);

/// Built: a unit sphere 2^40 away in f32, C on the ray exactly, so that even in f64 CB is a thousandth
/// longer or shorter than r. Held: N is unit, to the 4u of the promise.
#[test]
fn la_normale_d_une_sphere_de_f32_est_unitaire_de_tres_loin() {
    let mut alea = Rng::with_seed(23);
    for _ in 0..CAS {
        let d: Vecteur<f32> = arrondi(direction(&mut alea));
        let rayon = Rayon::new(-d * 40_f32.exp2(), d).unwrap();
        let touche = sphere(Vecteur::NUL, 1.0).intersection(&rayon).unwrap();
        let ecart = (touche.normale().vers_f64().longueur() - 1.0).abs();
        assert!(ecart <= 4.0 * u::<f32>(), "|N| is off by {ecart:e}: {rayon:?}");
    }
}

// A sphere lost in rounding.

/// Built: C level with the source, and |SC| within 3 units in the last place of r, so that rounding
/// sees S outside and the ray enter. Held: a miss.
fn sc_a_angle_droit_de_d_manque<R: Reel>() {
    let mut alea = Rng::with_seed(10);
    for _ in 0..CAS {
        let sc = arrondi::<R>(Vecteur::new(0.0, 1.0 + alea.f64(), alea.f64()));
        let mut presque_un = || R::depuis_f64(1.0 + f64::from(alea.i8(-3..=3)) * 2.0 * u::<R>());
        let objet = sphere(sc, sc.longueur() * presque_un());
        let vers = Vecteur::new(presque_un(), R::ZERO, R::ZERO);
        let rayon = Rayon::new(Vecteur::NUL, vers).unwrap();
        assert_eq!(objet.intersection(&rayon), Err(NoIntersection));
    }
}

en_f32_et_f64!(sc_a_angle_droit_de_d_manque);

/// Built: the regimes of spheres in f64, where the distance is that of the search. Held: t ≤ SA, both
/// as computed.
#[test]
fn une_sphere_est_touchee_avant_a() {
    chaque_touche::<f64>("sphere", |Cas { objet, rayon }, touche| {
        let ObjetRay::Sphere(sphere) = objet else { unreachable!("a regime of spheres") };
        let (s, d) = (rayon.source(), rayon.direction());
        let sa = (sphere.centre() - s).produit_scalaire(d) / d.longueur_carree();
        assert!(touche.distance() <= sa, "{} > {sa}: {objet:?} {rayon:?}", touche.distance());
    });
}

/// Built: a unit sphere from 2^-8/u to 4/u away, about the origin, where P is hardly rounded, or as far
/// from the origin. Held: `marge()` is +∞ exactly where `docs/precision.md` puts it.
fn une_sphere_perdue_a_une_marge_infinie<R: Reel>() {
    let (mut alea, mut finies, mut opposes, mut infinies) = (Rng::with_seed(12), 0, 0, [0; 3]);
    for _ in 0..20 * CAS {
        let (d, loin) = (direction(&mut alea), deux_puissance(&mut alea, -8.0, 2.0) / u::<R>());
        let centre = direction(&mut alea) * if alea.bool() { alea.f64() } else { loin };
        let source = arrondi(centre - d * loin + direction(&mut alea) * alea.f64());
        let centre = arrondi::<R>(centre);
        let Ok(rayon) = Rayon::new(source, arrondi(d)) else { continue };
        let Ok(touche) = sphere(centre, R::UN).intersection(&rayon) else { continue };
        let (p, n) = (rayon.point(touche.distance()).vers_f64(), touche.normale().vers_f64());
        let cp = p - centre.vers_f64();
        let le_long = n.produit_scalaire(cp);
        let q = (cp - n * le_long).longueur();
        let e = 4.0 * u::<R>() * (p.x.abs() + p.y.abs() + p.z.abs());
        let rapports = [(cp.longueur_carree() - 1.0).abs() / 0.5, q / 0.25, 4.0 * e];
        // The rounding of this test, far below 1e-6, decides nearer to 1.
        if rapports.iter().any(|rapport| (rapport - 1.0).abs() < 1e-6) {
            continue;
        }
        let perdue = rapports.map(|rapport| rapport > 1.0);
        let attendue = perdue.contains(&true) || le_long <= 0.0;
        opposes += u32::from(le_long <= 0.0);
        assert_eq!(touche.marge() == R::INFINI, attendue, "{rapports:?}, {centre:?} {rayon:?}");
        finies += u32::from(!attendue);
        for (raison, infinies) in infinies.iter_mut().enumerate() {
            *infinies += u32::from(perdue == [0, 1, 2].map(|autre| autre == raison));
        }
    }
    // Each of the three reasons must also have been the only one; the point on the far side never is.
    assert!(finies > CAS && infinies.iter().all(|n| *n > 10), "{finies}, {infinies:?}");
    assert!(opposes > 10, "only {opposes} on the far side");
}

en_f32_et_f64!(une_sphere_perdue_a_une_marge_infinie);

/// Built: a sphere on the ray whose far side is O, smaller than the rounding of its distance, so that P
/// is O. Held: the margin is +∞, although P lies on the sphere.
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
    let mut alea = Rng::with_seed(18);
    let mut perdues = 0;
    for _ in 0..CAS {
        let tres_peu = |alea: &mut Rng| entre(alea, -1.0, 1.0) * (-530_f64).exp2();
        let d = Vecteur::new(tres_peu(&mut alea), -1.0, tres_peu(&mut alea));
        let source = Vecteur::new(tres_peu(&mut alea), 1.0 + alea.f64(), tres_peu(&mut alea));
        let rayon = Rayon::new(source, d).unwrap();
        let Ok(touche) = sphere(Vecteur::NUL, (-430_f64).exp2()).intersection(&rayon) else {
            continue;
        };
        let ecart = (touche.normale().longueur() - 1.0).abs();
        assert!(ecart <= 8.0 * f64::U, "{ecart:e}: {rayon:?}");
        perdues += 1;
    }
    assert!(perdues > CAS / 4, "{perdues} hits");
}

// Where the distance of the search stands, because f64 has none.

/// Built: S = (m, 2m, 2m), which is 3m = r from O exactly, or S with m − ½, which is inside, while the
/// squares in f32 put S outside. Held: t is no less than the smallest difference of such squares gives.
#[test]
fn la_distance_trouvee_reste_ou_f64_n_en_a_pas_sphere() {
    let mut trouvees = [0; 2];
    for m in (1 << 22)..(1 << 22) + CAS {
        for (trouvees, x) in trouvees.iter_mut().zip([m as f32, m as f32 - 0.5]) {
            let (deux_m, r) = ((2 * m) as f32, (3 * m) as f32);
            let source = Vecteur::new(x, deux_m, deux_m);
            let rayon = Rayon::new(source, -source).unwrap();
            let Ok(touche) = sphere(Vecteur::NUL, r).intersection(&rayon) else { continue };
            // u·r² over 2r is 0.5·u·r, and t is rounded.
            assert!(touche.distance() >= 0.4 * f32::U * r, "{}", touche.distance());
            *trouvees += 1;
        }
    }
    assert!(trouvees.iter().all(|n| *n > 50), "{trouvees:?}");
}

/// Built, in bits: a sphere that f32 sees ahead and from outside, f64 behind and from inside, where the
/// power and SA + AB are both below 0. Held: t is that of the search, 2.1e-22 and 0.25, for a shadow too.
#[test]
fn la_distance_trouvee_reste_ou_f64_voit_la_sphere_derriere() {
    let nombre = f32::from_bits;
    let cas = [(0x27f6_9a41, 0x8d53_99aa, 0x0c58_c8df), (0xcac3_f92a, 0x300c_11df, 0xae69_639c)];
    for (c, dy, dz) in cas.map(|(c, dy, dz)| (nombre(c), nombre(dy), nombre(dz))) {
        let centre = Vecteur::new(c, nombre(0x5a47_9518), nombre(0x5a44_d060));
        let boule = sphere(centre, nombre(0x5a8c_2694));
        let source = Vecteur::new(0.0, nombre(0x3fc7_9518), 0.0);
        let rayon = Rayon::new(source, Vecteur::new(nombre(0x3f7f_fffe), dy, dz)).unwrap();
        let touche = boule.intersection(&rayon).unwrap();
        assert!(touche.distance() < 0.5 && est_occulte(&[boule], &rayon, 0.5), "{touche:?}");
    }
}

/// Built: a ray that rises so slowly towards a pair of faces that f32 sees it between their planes, and f64
/// below them, which it reaches 10⁹ and 10²¹ farther on. Held: t is that of the search, on a face that it meets.
#[test]
fn la_distance_trouvee_reste_ou_f64_manque_la_boite() {
    for lenteur in [-60_f32, -100.0] {
        let centre = Vecteur::new((-30_f32).exp2(), 0.0, 0.0);
        let boite = BoiteGeo::new(centre, [2.0; 3].into(), Rotation::IDENTITE, Texture(0)).unwrap();
        let direction = Vecteur::new(lenteur.exp2(), 0.0, 1.0);
        let rayon = Rayon::new(Vecteur::new(-1.0, 0.25, -6.0), direction).unwrap();
        let touche = ObjetRay::from(boite).intersection(&rayon).unwrap();
        assert_eq!(touche.distance(), 5.0);
        assert_eq!(touche.normale(), Vecteur::new(0.0, 0.0, -1.0));
    }
}

/// A rotation whose third row is N = (a, b, ½), and two vectors V with N·V = 0 exactly, of which f32
/// sees more or less, since V.z = −2(aV.x + bV.y) is all rounding. The first V is unit.
fn tangentes(alea: &mut Rng) -> Option<(Rotation<f32>, [Vecteur<f32>; 2])> {
    let (sin, cos) = (0.3 + 0.9 * alea.f64()).sin_cos();
    let trois_quarts = 0.75_f64.sqrt();
    let n = arrondi::<f32>(Vecteur::new(cos * trois_quarts, sin * trois_quarts, 0.5)).vers_f64();
    let x = Vecteur::new(sin, -cos, 0.0);
    let lignes = [x, vectoriel(n, x), n].map(|ligne| arrondi(ligne).into());
    let tour = Rotation::depuis_matrice(lignes).ok()?;
    let gardee = Vecteur::from(tour.matrice()[2]).vers_f64() == n;
    let v = |longueur| {
        let v = arrondi::<f32>(x * longueur).vers_f64();
        let v = Vecteur::new(v.x, v.y, -2.0 * (n.x * v.x + n.y * v.y));
        (arrondi::<f32>(v).vers_f64() == v).then(|| arrondi(v))
    };
    gardee.then_some((tour, [v(1.0)?, v(entre(alea, 0.5, 1.0))?]))
}

/// Built: a ray almost parallel to a half-space, in whose surface f64 sees the source; and one that f64
/// sees inside, going out. Held: t is A.1's in f32.
#[test]
fn la_distance_trouvee_reste_ou_f64_n_en_a_pas_demi_espace() {
    let (mut alea, mut trouvees) = (Rng::with_seed(13), [0; 2]);
    let pas = Vecteur::new(0.0, 0.0, (-28_f32).exp2());
    for _ in 0..CAS {
        let Some((tour, [d, source])) = tangentes(&mut alea) else { continue };
        let plan = PlanGeo::new(tour, 0.0, Texture(0)).unwrap().vers_ray();
        let rayons = [(source, d - pas), (source - pas, d + pas)];
        for (trouvees, (source, direction)) in trouvees.iter_mut().zip(rayons) {
            let rayon = Rayon::new(source, direction).unwrap();
            let Ok(touche) = ObjetRay::from(plan).intersection(&rayon) else { continue };
            let n = plan.normale().vers_f64();
            if n.produit_scalaire(rayon.direction().vers_f64()).abs() < RASANT {
                assert_eq!(Some(touche.distance()), litteral::plan(plan.normale(), 0.0, &rayon));
                *trouvees += 1;
            }
        }
    }
    assert!(trouvees.iter().all(|n| *n > 20), "{trouvees:?} hits");
}

// Which face of a box is named.

/// Built: the regimes of boxes in f32. Held: t is the distance to the plane of the named face, to half
/// a unit in the last place, even where f64 would have named another face.
#[test]
fn la_distance_d_une_boite_est_celle_de_la_face_nommee() {
    let mut jugees = 0;
    chaque_touche::<f32>("box", |Cas { objet, rayon }, touche| {
        let ObjetRay::Boite(boite) = objet else { unreachable!("a regime of boxes") };
        let normale = touche.normale();
        let axe = boite.normales().iter().position(|n| [*n, -*n].contains(&normale)).unwrap();
        let n = normale.vers_f64();
        let f = rayon.source().vers_f64() - boite.centre().vers_f64();
        let (l, t) = (boite.demi_longueurs()[axe].vers_f64(), touche.distance().vers_f64());
        let haut = n.produit_scalaire(f) - l;
        let vitesse = -n.produit_scalaire(rayon.direction().vers_f64());
        // Elsewhere f64 has no such distance.
        if haut > 0.0 && vitesse > 0.0 && haut / vitesse <= f64::from(f32::MAX) {
            let ecart = (haut - t * vitesse).abs();
            let demi_unite = (f64::from(f32::U) * t).max(f64::from(f32::MIN_POSITIF));
            // Four roundings of the kernel in f64, and as many of this test.
            let sommes = 8.0 * u::<f64>() * (f.longueur() + l + t);
            let permis = demi_unite * vitesse + sommes;
            assert!(ecart <= permis, "off by {ecart:e}, {permis:e} allowed: {objet:?} {rayon:?}");
            jugees += 1;
        }
    });
    assert!(jugees > CAS);
}

/// Built: a source in the plane of +z exactly, and so near to that of +x that f32 sees an entry by +x
/// and f64 none. Held: +x is named, as the search found it.
#[test]
fn la_face_trouvee_reste_ou_f64_part_d_une_autre() {
    let (mut alea, mut trouvees) = (Rng::with_seed(14), 0);
    for _ in 0..20 * CAS {
        let tour = Rotation::new(Vecteur::new(0.0, 0.0, alea.f32())).unwrap();
        let boite = boite(tour, [2.0, 40.0, 2.0]);
        let [n, cote, _] = boite.normales();
        let source = n + cote * (16.0 * alea.f32()) + Vecteur::new(0.0, 0.0, 1.0);
        let haut = n.vers_f64().produit_scalaire(source.vers_f64()) - 1.0;
        let rayon = Rayon::new(source, -n - Vecteur::new(0.0, 0.0, 0.5)).unwrap();
        let Ok(touche) = ObjetRay::from(boite).intersection(&rayon) else { continue };
        if haut < 0.0 {
            assert_eq!(touche.normale(), n);
            trouvees += 1;
        }
    }
    assert!(trouvees > 20, "{trouvees} hits");
}

/// Built: a ray parallel to ±z and beside the box, as f64 sees it, but between the two faces for f32.
/// Held: neither of them is named.
#[test]
fn la_face_trouvee_reste_ou_f64_longe_une_autre() {
    let (mut alea, mut trouvees) = (Rng::with_seed(15), 0);
    for _ in 0..CAS {
        let Some((tour, [d, _])) = tangentes(&mut alea) else { continue };
        let boite = boite(tour, [2.0; 3]);
        let [_, _, n] = boite.normales();
        let rayon = Rayon::new(-n - d * (2.0 + 8.0 * alea.f32()), d).unwrap();
        let Ok(touche) = ObjetRay::from(boite).intersection(&rayon) else { continue };
        let [haut, vitesse] = [rayon.source(), rayon.direction()]
            .map(|v| n.vers_f64().produit_scalaire(v.vers_f64()));
        let entre_en_f32 = n.produit_scalaire(rayon.source()) >= -1.0;
        if haut < -1.0 && vitesse == 0.0 && entre_en_f32 {
            assert!(![n, -n].contains(&touche.normale()), "{boite:?} {rayon:?}");
            trouvees += 1;
        }
    }
    assert!(trouvees > 20, "{trouvees} hits");
}

/// Built: a ray along an edge of a box, within rounding outside of both its faces; parallel to one, so
/// that f64 sees no entry, and almost to the other, whose plane the ray meets before the box. Held: the
/// hit is not before the box, to 64u and rounding.
#[test]
fn une_boite_n_est_pas_touchee_avant_elle() {
    let (mut alea, mut avant) = (Rng::with_seed(17), 0);
    for _ in 0..20 * CAS {
        let centre = Vecteur::new(alea.f32(), alea.f32(), 0.0);
        let dimensions = Vecteur::new(1.0, 1.0, 4.0);
        let boite = BoiteGeo::new(centre, dimensions, Rotation::IDENTITE, Texture(0)).unwrap();
        let dehors = Vecteur::new(alea.f32(), alea.f32(), 0.0) * 1e-7;
        let arete = centre - Vecteur::new(0.5, 0.5, 7.0) - dehors;
        let rayon = Rayon::new(arete, Vecteur::new(3e-8 * alea.f32(), 0.0, 1.0)).unwrap();
        let Ok(touche) = ObjetRay::from(boite).intersection(&rayon) else { continue };
        let haut = f64::from(centre.x) - 0.5 - f64::from(arete.x);
        let vitesse = f64::from(rayon.direction().x);
        avant += u32::from(haut > 0.0 && haut < 4.9 * vitesse && touche.normale().x != 0.0);
        assert!(touche.distance() >= 5.0 * (1.0 - 66.0 * f32::U), "{boite:?} {rayon:?} {touche:?}");
    }
    assert!(avant > 20, "{avant} hits");
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

/// Built: the regimes of half-spaces in f64, except grazing rays. Held: t is A.1's, bit for bit.
#[test]
fn un_demi_espace_est_l_annexe_en_f64() {
    let mut juges = 0;
    chaque_touche::<f64>("half-space", |Cas { objet, rayon }, touche| {
        let ObjetRay::Plan(plan) = objet else { unreachable!("a regime of half-spaces") };
        let (n, d) = (plan.normale(), plan.distance());
        if -n.produit_scalaire(rayon.direction()) > RASANT {
            assert_eq!(Some(touche.distance()), litteral::plan(n, d, rayon));
            juges += 1;
        }
    });
    assert!(juges > CAS);
}

/// Built: a grazing ray whose N·D is the sum of three products as small as itself. Held: N·D is rounded
/// once, so that t is off by 2u, one for N·D and one for the quotient.
#[test]
fn le_produit_compense_n_est_arrondi_qu_une_fois() {
    let (mut alea, mut juges) = (Rng::with_seed(16), 0);
    for _ in 0..CAS {
        let mut peu = || entre(&mut alea, -1.0, 1.0) * (RASANT / 4.0);
        let [x, y, penche] = [peu(), peu(), peu()];
        let tour = Rotation::new(Vecteur::new(FRAC_PI_2 + penche, 0.0, 7.0 * alea.f64())).unwrap();
        let plan = PlanGeo::new(tour, 0.0, Texture(0)).unwrap().vers_ray();
        let source = Vecteur::new(0.0, 0.0, plan.normale().z.signum());
        let rayon = Rayon::new(source, Vecteur::new(x, y, -source.z)).unwrap();
        let plan = ObjetRay::from(plan);
        let Some(entree) = verite(&plan, &rayon).entree else { continue };
        let Ok(touche) = plan.intersection(&rayon) else { continue };
        let ecart = entree.ecart(touche.distance()).abs();
        // A thousandth more, for the terms in u².
        let permis = 2.0 * u::<f64>() * touche.distance() * (1.0 + 1e-3);
        assert!(ecart <= permis, "off by {ecart:e}, {permis:e} allowed: {plan:?} {rayon:?}");
        juges += 1;
    }
    assert!(juges > CAS / 2);
}

/// Built: a thin box far away, almost parallel to the ray. f32 sees the source 2^-37 before a face, since
/// two products of opposite sign cancel, and f64 2^32 before it, from where the way takes more than 2^128.
/// Held: the distance of the search stands.
#[test]
fn la_distance_trouvee_reste_ou_f64_n_en_a_pas_boite() {
    let (a, b, c) = (0.6_f32, 0.8_f32, (-30_f32).exp2());
    let tour = Rotation::depuis_matrice([[b, -a, 0.0], [a * c, b * c, -1.0], [a, b, c]]).unwrap();
    let mince = boite(tour, [59_f32.exp2(), 2.0, (-36_f32).exp2()]);
    let n = mince.normales()[2];
    assert_eq!(n, Vecteur::new(a, b, c));
    let mut trouvees = 0;
    for k in 0..CAS {
        let x = -b * 59_f32.exp2() * (1.0 + f32::EPSILON * k as f32);
        let source = Vecteur::new(x, -(a * x) / b, -(-6_f32).exp2());
        let avant = n.vers_f64().produit_scalaire(source.vers_f64());
        if n.produit_scalaire(source) == -(-36_f32).exp2() && avant < -32_f64.exp2() {
            let rayon = Rayon::new(source, Vecteur::new(b, -a, (-66_f32).exp2())).unwrap();
            let touche = ObjetRay::from(mince).intersection(&rayon).unwrap();
            assert_eq!((touche.distance(), touche.normale()), (59_f32.exp2(), -n));
            trouvees += 1;
        }
    }
    assert!(trouvees > 50, "{trouvees}");
}

/// What the f32 search sees at the end of the range, the conclusion in f64 sees beyond it.
#[test]
fn une_distance_au_bord_du_type_reste_finie() {
    let (a, b, c) = (0.746_069_25_f32, 0.665_868_34_f32, 4.297_683_7e-12_f32);
    let m = Rotation::depuis_matrice([[b, -a, 0.0], [a * c, b * c, -1.0], [a, b, c]]).unwrap();
    let sol = ObjetRay::from(PlanGeo::new(m, 0.0, Texture(0)).unwrap());
    let source = Vecteur::new(a, b, c) * 59_f32.exp2();
    let rayon = Rayon::new(source, Vecteur::new(4.974_663e-12, -1.202_809_4e-11, 1.0)).unwrap();
    assert!(sol.intersection(&rayon).unwrap().distance() < f32::INFINITY);
}
