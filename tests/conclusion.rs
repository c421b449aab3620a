//! What a hit says where the promises of `docs/precision.md` end: within the margin of a decision, and
//! where the search, made in the type of the scene, and the conclusion, made in f64, do not agree.

mod commun;
#[allow(dead_code, reason = "only its half-space is asked")]
#[path = "commun/litteral.rs"]
mod litteral;

use std::f64::consts::FRAC_PI_2;

use commun::oracle::verite;
use commun::regimes::{Cas, Regime, direction, entre, puissance, regimes, vectoriel};
use commun::tolerances::u;
use commun::{arrondi, est_une_entree};
use fastrand::Rng;
use lancer_rayon::{
    BoiteGeo, BoiteRay, Intersection, NoIntersection, ObjetRay, PlanGeo, Rayon, Reel, Rotation,
    SphereGeo, SphereRay, Texture, Vecteur,
};

const CAS: u32 = 2_000;

/// The hits of those regimes whose name begins so.
fn touches<R: Reel>(debut: &str, mut suite: impl FnMut(&Cas<R>, &Intersection<R>)) {
    let mut alea = Rng::with_seed(9);
    for Regime { cas, .. } in regimes::<R>().into_iter().filter(|r| r.nom.starts_with(debut)) {
        for cas in (0..CAS).map(|_| cas(&mut alea)) {
            if let Ok(touche) = cas.objet.intersection(&cas.rayon) {
                suite(&cas, &touche);
            }
        }
    }
}

fn boule<R: Reel>(centre: Vecteur<R>, rayon: R) -> SphereRay<R> {
    SphereGeo::new(centre, rayon, Texture(0)).unwrap().vers_ray()
}

/// Whether or not the ray truly touches the sphere.
fn normale_au_point<R: Reel>() {
    let (mut jugees, mut penchees) = (0, 0);
    touches::<R>("sphere", |Cas { objet, rayon }, touche| {
        let ObjetRay::Sphere(sphere) = objet else { unreachable!("a regime of spheres") };
        let (centre, r) = (sphere.centre().vers_f64(), sphere.rayon().vers_f64());
        let f = (rayon.source().vers_f64() - centre).longueur();
        let p = rayon.point(touche.distance()).vers_f64();
        let cp = p - centre;
        // 2u to round N, 6u for the lean of a grazing one and 4u as far past a right angle; beside
        // it P is rounded twice in each coordinate, f once, and CP once.
        let etendue = touche.distance().vers_f64() + p.longueur() + f;
        let permis = u::<R>() * (12.0 + 4.0 * etendue / r);
        if permis < 0.1 {
            let n = touche.normale().vers_f64();
            let ecart = (n - cp / cp.longueur()).longueur();
            assert!(ecart <= permis, "off by {ecart:e}, {permis:e} allowed: {objet:?} {rayon:?}");
            jugees += 1;
            penchees +=
                u32::from(n.produit_scalaire(rayon.direction().vers_f64()) > -8.0 * u::<R>());
        }
    });
    assert!(jugees > CAS && (penchees > 10 || u::<R>() < f64::EPSILON), "{jugees}, {penchees}");
}

#[test]
fn la_normale_d_une_sphere_est_celle_du_point() {
    normale_au_point::<f32>();
    normale_au_point::<f64>();
}

/// Where rounding, as large as the sphere, turns CB away from the source, the normal is what CB has
/// across the ray, leaned by 6u.
#[test]
fn la_normale_d_une_sphere_perdue_est_en_travers_du_rayon() {
    let (mut alea, mut penchees) = (Rng::with_seed(17), 0);
    for _ in 0..20 * CAS {
        let rayon = Rayon::new(Vecteur::NUL, direction(&mut alea)).unwrap();
        let (d, loin) = (rayon.direction(), 1.0 + alea.f64());
        let sphere = boule(d * loin, loin * u::<f64>());
        let Ok(touche) = ObjetRay::from(sphere).intersection(&rayon) else { continue };
        let cb = d * touche.distance() - sphere.centre();
        let le_long = cb.produit_scalaire(d);
        let travers = cb - d * (le_long / d.longueur_carree());
        if le_long > 0.0 && travers.longueur() > le_long {
            let ecart = (touche.normale() - travers / travers.longueur()).longueur();
            // 6u, and the roundings of both.
            assert!(ecart <= 16.0 * u::<f64>(), "off by {ecart:e}: {sphere:?} {rayon:?}");
            penchees += 1;
        }
    }
    assert!(penchees > 20, "{penchees} leaned");
}

/// As computed in f64, where the distance is that of the search.
#[test]
fn une_sphere_est_touchee_avant_a() {
    touches::<f64>("sphere", |Cas { objet, rayon }, touche| {
        let ObjetRay::Sphere(sphere) = objet else { unreachable!("a regime of spheres") };
        let (s, d) = (rayon.source(), rayon.direction());
        let sa = (sphere.centre() - s).produit_scalaire(d) / d.longueur_carree();
        assert!(touche.distance() <= sa, "{} > {sa}: {objet:?} {rayon:?}", touche.distance());
    });
}

/// C level with the source, S and r so close that rounding sees S outside and the ray enter.
fn centre_a_la_hauteur_de_la_source<R: Reel>() {
    let mut alea = Rng::with_seed(10);
    for _ in 0..CAS {
        let sc = arrondi::<R>(Vecteur::new(0.0, 1.0 + alea.f64(), alea.f64()));
        let mut peu = || R::UN + R::depuis_f64(f64::from(alea.i8(-3..=3)) * 2.0 * u::<R>());
        let sphere = boule(sc, sc.longueur() * peu());
        let vers = Vecteur::new(peu(), R::ZERO, R::ZERO);
        let rayon = Rayon::new(Vecteur::NUL, vers).unwrap();
        assert_eq!(ObjetRay::from(sphere).intersection(&rayon), Err(NoIntersection));
    }
}

#[test]
fn sc_a_angle_droit_de_d_manque() {
    centre_a_la_hauteur_de_la_source::<f32>();
    centre_a_la_hauteur_de_la_source::<f64>();
}

/// So small and far that nothing is left of CB.
fn normale_perdue<R: Reel>() {
    let (mut alea, mut perdues) = (Rng::with_seed(11), 0);
    // |D|² − 1 just below 12u: kept as it is.
    let long = R::UN + R::depuis_f64(6.0 * u::<R>());
    let axes = [[long, R::ZERO, R::ZERO], [R::ZERO, -long, R::ZERO]].map(Vecteur::from);
    for d in (0..CAS).flat_map(|_| axes) {
        let rayon = Rayon::new(Vecteur::NUL, d).unwrap();
        assert_eq!(rayon.direction(), d);
        let sphere = boule(d * R::depuis_f64(1.0 + alea.f64()), R::U * R::U);
        let Ok(touche) = ObjetRay::from(sphere).intersection(&rayon) else { continue };
        est_une_entree(&rayon, &touche).unwrap();
        perdues += 1;
    }
    assert!(perdues > CAS / 4, "{perdues} hits");
}

#[test]
fn la_normale_d_une_sphere_perdue_est_unitaire() {
    normale_perdue::<f32>();
    normale_perdue::<f64>();
}

/// The sphere is no larger than the rounding of its distance or place: as `docs/precision.md` has it.
fn marge_infinie<R: Reel>() {
    let (mut alea, mut finies, mut infinies) = (Rng::with_seed(12), 0, [0; 3]);
    for _ in 0..20 * CAS {
        let (d, loin) = (direction(&mut alea), puissance(&mut alea, -8.0, 0.0) / u::<R>());
        // About the origin, where P has no rounding of its own, or as far from it as the source is
        // from the sphere.
        let centre = direction(&mut alea) * if alea.bool() { alea.f64() } else { loin };
        let source = arrondi(centre - d * loin + direction(&mut alea) * alea.f64());
        let sphere = boule::<R>(arrondi(centre), R::UN);
        let Ok(rayon) = Rayon::new(source, arrondi(d)) else { continue };
        let Ok(touche) = ObjetRay::from(sphere).intersection(&rayon) else { continue };
        let (p, n) = (rayon.point(touche.distance()).vers_f64(), touche.normale().vers_f64());
        let cp = p - sphere.centre().vers_f64();
        let q = (cp - n * n.produit_scalaire(cp)).longueur();
        let e = 4.0 * u::<R>() * (p.x.abs() + p.y.abs() + p.z.abs());
        let rapports = [(cp.longueur_carree() - 1.0).abs() / 0.5, q / 0.25, 4.0 * e];
        // What the rounding of this test may decide is left out.
        if rapports.iter().any(|rapport| (rapport - 1.0).abs() < 1e-6) {
            continue;
        }
        let perdue = rapports.map(|rapport| rapport > 1.0);
        let attendue = perdue.contains(&true);
        assert_eq!(touche.marge() == R::INFINI, attendue, "{rapports:?}, {sphere:?} {rayon:?}");
        finies += u32::from(!attendue);
        for (raison, infinies) in infinies.iter_mut().enumerate() {
            *infinies += u32::from(perdue == [0, 1, 2].map(|autre| autre == raison));
        }
    }
    assert!(finies > CAS && infinies.iter().all(|n| *n > 10), "{finies}, {infinies:?}");
}

#[test]
fn une_sphere_perdue_a_une_marge_infinie() {
    marge_infinie::<f32>();
    marge_infinie::<f64>();
}

/// (m, 2m, 2m) is 3m from O exactly. Where the squares in f32 say more, the search finds a hit, of
/// which f64 knows that it starts on the surface or, from m − ½, inside.
#[test]
fn la_distance_trouvee_reste_ou_f64_n_en_a_pas_sphere() {
    let mut trouvees = [0; 2];
    for m in (1 << 22)..(1 << 22) + CAS {
        for (trouvees, x) in trouvees.iter_mut().zip([m as f32, m as f32 - 0.5]) {
            let (deux_m, r) = ((2 * m) as f32, (3 * m) as f32);
            let source = Vecteur::new(x, deux_m, deux_m);
            let rayon = Rayon::new(source, -source).unwrap();
            let Ok(touche) = ObjetRay::from(boule(Vecteur::NUL, r)).intersection(&rayon) else {
                continue;
            };
            // The least that a difference of two squares near r² can be, u·r², over 2r.
            assert!(touche.distance() >= 0.4 * f32::U * r, "{}", touche.distance());
            *trouvees += 1;
        }
    }
    assert!(trouvees.iter().all(|n| *n > 50), "{trouvees:?}");
}

/// N = (a, b, ½), unit, as the third row of a rotation; and two vectors V, the first of them unit, with
/// N·V = 0 exactly, of which f32 sees more or less: V.z = −2(aV.x + bV.y), all rounding.
fn tangentes(alea: &mut Rng) -> Option<(Rotation<f32>, [Vecteur<f32>; 2])> {
    let (sin, cos) = (0.3 + 0.9 * alea.f64()).sin_cos();
    let trois_quarts = 0.75_f64.sqrt();
    let n = arrondi::<f32>(Vecteur::new(cos * trois_quarts, sin * trois_quarts, 0.5)).vers_f64();
    let x = Vecteur::new(sin, -cos, 0.0);
    let r = Rotation::depuis_matrice([x, vectoriel(n, x), n].map(|ligne| arrondi(ligne).into()))
        .ok()?;
    if Vecteur::from(r.matrice()[2]).vers_f64() != n {
        return None;
    }
    let v = |longueur| {
        let v = arrondi::<f32>(x * longueur).vers_f64();
        let v = Vecteur::new(v.x, v.y, -2.0 * (n.x * v.x + n.y * v.y));
        let exact = arrondi::<f32>(v).vers_f64() == v;
        exact.then(|| arrondi(v))
    };
    Some((r, [v(1.0)?, v(entre(alea, 0.5, 1.0))?]))
}

/// Almost parallel to a half-space in whose surface f64 sees the source: A.1 in f32 stands.
#[test]
fn la_distance_trouvee_reste_ou_f64_n_en_a_pas_demi_espace() {
    let (mut alea, mut trouvees) = (Rng::with_seed(13), 0);
    for _ in 0..CAS {
        let Some((tour, [d, source])) = tangentes(&mut alea) else { continue };
        let plan = PlanGeo::new(tour, 0.0, Texture(0)).unwrap().vers_ray();
        let rayon = Rayon::new(source, d - Vecteur::new(0.0, 0.0, (-28_f32).exp2())).unwrap();
        let Ok(touche) = ObjetRay::from(plan).intersection(&rayon) else { continue };
        let descente = -plan.normale().vers_f64().produit_scalaire(rayon.direction().vers_f64());
        if descente.abs() < (-26_f64).exp2() {
            assert_eq!(Some(touche.distance()), litteral::plan(plan.normale(), 0.0, &rayon));
            trouvees += 1;
        }
    }
    assert!(trouvees > 20, "{trouvees} hits");
}

/// In f32 the distance is that of the plane of the face that is named, to half a unit in the last
/// place, even where the ray lies so nearly along another face that f64 would have named that.
#[test]
fn la_distance_d_une_boite_est_celle_de_la_face_nommee() {
    let mut jugees = 0;
    touches::<f32>("box", |Cas { objet, rayon }, touche| {
        let ObjetRay::Boite(boite) = objet else { unreachable!("a regime of boxes") };
        let (n, axe) = (touche.normale().vers_f64(), axe_de(boite, touche.normale()));
        let f = rayon.source().vers_f64() - boite.centre().vers_f64();
        let (l, t) = (boite.demi_longueurs()[axe].vers_f64(), touche.distance().vers_f64());
        let (haut, vitesse) =
            (n.produit_scalaire(f) - l, -n.produit_scalaire(rayon.direction().vers_f64()));
        // Where f64 has no such distance, that of the search stands.
        if haut > 0.0 && vitesse > 0.0 && haut / vitesse <= f64::from(f32::MAX) {
            let ecart = (haut - t * vitesse).abs();
            // Half a unit in the last place; and the sums of the kernel and of this test in f64.
            let sommes = 8.0 * (f64::EPSILON / 2.0) * (f.longueur() + l + t);
            let permis =
                (f64::from(f32::U) * t).max(f64::from(f32::MIN_POSITIF)) * vitesse + sommes;
            assert!(ecart <= permis, "off by {ecart:e}, {permis:e} allowed: {objet:?} {rayon:?}");
            jugees += 1;
        }
    });
    assert!(jugees > CAS);
}

fn axe_de<R: Reel>(boite: &BoiteRay<R>, normale: Vecteur<R>) -> usize {
    (0..3).find(|i| [normale, -normale].contains(&boite.normales()[*i])).expect("a face of the box")
}

/// From the plane of the face +z exactly and so near to that of another face that f32 sees an entry by
/// it and f64 none: the other face is named, as it was found.
#[test]
fn la_face_trouvee_reste_ou_f64_part_d_une_autre() {
    let (mut alea, mut trouvees) = (Rng::with_seed(14), 0);
    for _ in 0..20 * CAS {
        let tour = Rotation::<f32>::new(Vecteur::new(0.0, 0.0, alea.f32())).unwrap();
        let boite = BoiteGeo::new(Vecteur::NUL, Vecteur::new(2.0, 40.0, 2.0), tour, Texture(0));
        let boite = boite.unwrap().vers_ray();
        let [n, cote, _] = boite.normales();
        let source = n + cote * (16.0 * alea.f32()) + Vecteur::new(0.0, 0.0, 1.0);
        let entree = n.vers_f64().produit_scalaire(source.vers_f64()) - 1.0;
        let rayon = Rayon::new(source, -n - Vecteur::new(0.0, 0.0, 0.5)).unwrap();
        let Ok(touche) = ObjetRay::from(boite).intersection(&rayon) else { continue };
        if entree < 0.0 {
            assert_eq!(touche.normale(), n);
            trouvees += 1;
        }
    }
    assert!(trouvees > 20, "{trouvees} hits");
}

/// Along a face exactly and beside it, as f64 sees it, but level with the box for f32: that face is
/// not the one that is touched.
#[test]
fn la_face_trouvee_reste_ou_f64_longe_une_autre() {
    let (mut alea, mut trouvees) = (Rng::with_seed(15), 0);
    for _ in 0..CAS {
        let Some((tour, [d, _])) = tangentes(&mut alea) else { continue };
        let boite = BoiteGeo::new(Vecteur::NUL, Vecteur::new(2.0, 2.0, 2.0), tour, Texture(0));
        let boite = boite.unwrap().vers_ray();
        let [_, _, n] = boite.normales();
        let rayon = Rayon::new(-n - d * (2.0 + 8.0 * alea.f32()), d).unwrap();
        let Ok(touche) = ObjetRay::from(boite).intersection(&rayon) else { continue };
        let [o, vitesse] = [rayon.source(), rayon.direction()]
            .map(|v| n.vers_f64().produit_scalaire(v.vers_f64()));
        let entree_en_f32 = n.produit_scalaire(rayon.source()) < -1.0;
        if o < -1.0 && vitesse == 0.0 && !entree_en_f32 {
            assert!(![n, -n].contains(&touche.normale()), "{boite:?} {rayon:?}");
            trouvees += 1;
        }
    }
    assert!(trouvees > 20, "{trouvees} hits");
}

/// In f64 a half-space is A.1 as it stands, bit by bit, until half of the digits of N·D are gone.
#[test]
fn un_demi_espace_est_l_annexe_en_f64() {
    let mut juges = 0;
    touches::<f64>("half-space", |Cas { objet, rayon }, touche| {
        let ObjetRay::Plan(plan) = objet else { unreachable!("a regime of half-spaces") };
        let (n, d) = (plan.normale(), plan.distance());
        if -n.produit_scalaire(rayon.direction()) > (-26_f64).exp2() {
            assert_eq!(Some(touche.distance()), litteral::plan(n, d, rayon));
            juges += 1;
        }
    });
    assert!(juges > CAS);
}

/// Below that N·D is rounded once, of three products as small as itself: with the quotient, an error
/// of 2u.
#[test]
fn le_produit_compense_n_est_arrondi_qu_une_fois() {
    let (mut alea, mut juges) = (Rng::with_seed(16), 0);
    for _ in 0..CAS {
        let mut peu = || entre(&mut alea, -1.0, 1.0) * (-28_f64).exp2();
        let [x, y, penche] = [peu(), peu(), peu()];
        let angles = Vecteur::new(FRAC_PI_2 + penche, 0.0, 7.0 * alea.f64());
        let plan =
            PlanGeo::new(Rotation::new(angles).unwrap(), 0.0, Texture(0)).unwrap().vers_ray();
        let source = Vecteur::new(0.0, 0.0, plan.normale().z.signum());
        let rayon = Rayon::new(source, Vecteur::new(x, y, -source.z)).unwrap();
        let plan = ObjetRay::from(plan);
        let (Some(entree), Ok(touche)) = (verite(&plan, &rayon).entree, plan.intersection(&rayon))
        else {
            continue;
        };
        let ecart = entree.ecart(touche.distance()).abs();
        let permis = 2.0 * u::<f64>() * touche.distance() * (1.0 + 1e-3);
        assert!(ecart <= permis, "off by {ecart:e}, {permis:e} allowed: {plan:?} {rayon:?}");
        juges += 1;
    }
    assert!(juges > CAS / 2);
}
