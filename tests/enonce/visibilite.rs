//! Two points of surfaces: whether they see each other, beside an exact answer.

use std::path::Path;

use commun::oracle::verite;
use commun::regimes::{direction, entre};
use commun::tolerances::u;
use commun::{arrondi, en_f32_et_f64};
use exemples::scene::Scene;
use fastrand::Rng;
use lancer_rayon::{
    BoiteGeo, Intersection, ObjetRay, PlanGeo, Rayon, Reel, Rotation, Texture, Vecteur,
    est_occulte, premiere_intersection,
};
use serde::de::DeserializeOwned;

/// Pairs of points in each scene.
const PAIRES: u32 = 20_000;

/// A crossing this near to an end of the way, as a part of it, is left open here: the ends of a true way lie on the
/// surfaces, those of the ray a step off them.
const OUVERT: f64 = 1e-5;

/// Houses in streets, some of them turned, on level ground.
fn ville<R: Reel>() -> Vec<ObjetRay<R>> {
    let mut alea = Rng::with_seed(40);
    let haut = arrondi(Vecteur::new(0.0, 1.0, 0.0));
    let mut objets: Vec<ObjetRay<R>> =
        vec![PlanGeo::par_un_point(Vecteur::NUL, haut, Texture(0)).unwrap().into()];
    for (i, j) in (-6..6).flat_map(|i| (-6..6).map(move |j| (i, j))) {
        let [x, z] = [i, j].map(|k| 20.0 * f64::from(k) + entre(&mut alea, -2.0, 2.0));
        let h = entre(&mut alea, 4.0, 30.0);
        let dimensions = Vecteur::new(entre(&mut alea, 8.0, 14.0), h, entre(&mut alea, 8.0, 14.0));
        let lacet = if alea.bool() { 0.0 } else { entre(&mut alea, -0.5, 0.5) };
        let tour = Rotation::new(arrondi(Vecteur::new(0.0, lacet, 0.0))).unwrap();
        let centre = arrondi(Vecteur::new(x, h / 2.0, z));
        objets.push(BoiteGeo::new(centre, arrondi(dimensions), tour, Texture(1)).unwrap().into());
    }
    objets
}

fn atelier<R: Reel + DeserializeOwned>() -> Vec<ObjetRay<R>> {
    let chemin = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/scenes/atelier.ron");
    Scene::lire(&chemin).unwrap().objets.into_iter().map(Into::into).collect()
}

/// A point that is seen from somewhere above a scene of this extent.
fn point<R: Reel>(
    objets: &[ObjetRay<R>],
    etendue: f64,
    alea: &mut Rng,
) -> (Rayon<R>, Intersection<R>) {
    loop {
        let mut lieu = |haut: f64| {
            let v = direction(alea) * etendue;
            Vecteur::new(v.x, haut * alea.f64() * etendue, v.z)
        };
        let (de, vers) = (lieu(0.6), lieu(0.1));
        let rayon = Rayon::new(arrondi(de), arrondi(vers - de)).unwrap();
        let touche = premiere_intersection(objets, &rayon).ok();
        if let Some(touche) = touche.filter(|t| t.distance().vers_f64() < 4.0 * etendue) {
            return (rayon, touche);
        }
    }
}

/// Whether something stands within this distance of the ray, of the objects that are not certainly passed by.
fn cache<R: Reel>(objets: &[ObjetRay<R>], rayon: &Rayon<R>, distance: f64) -> bool {
    let entree = |objet: &ObjetRay<R>| verite(objet, rayon).entree.map(|e| e.t.vers_f64());
    let proches = objets.iter().filter(|o| !o.est_sur(rayon) || o.intersection(rayon).is_ok());
    proches.filter_map(entree).any(|t| t < distance)
}

fn deux_points_se_voient_si_rien_n_est_entre_eux<R: Reel + DeserializeOwned>() {
    for (nom, objets, etendue) in [("city", ville::<R>(), 120.0), ("atelier", atelier(), 6.0)] {
        let mut alea = Rng::with_seed(39);
        let (mut vus, mut caches, mut dos, mut ouverts) = (0, 0, 0, 0);
        let mut naifs = [0; 2];
        for _ in 0..PAIRES {
            let (a, touche) = point(&objets, etendue, &mut alea);
            let (b, cible) = point(&objets, etendue, &mut alea);
            let [p, q] = [a.point(touche.distance()), b.point(cible.distance())];
            // What one writes at first.
            let obvie = Rayon::new(p, q - p).unwrap();
            let obvie = !est_occulte(&objets, &obvie, (q - p).longueur());
            let Some((rayon, distance)) = a.vers_touche(&touche, &b, &cible) else {
                dos += 1;
                naifs[1] += u32::from(obvie);
                let v = q - p;
                let penche =
                    |n: Vecteur<R>| n.produit_scalaire(v).vers_f64() / v.longueur().vers_f64();
                let face = penche(touche.normale()).min(-penche(cible.normale()));
                assert!(face < 1e-4, "{nom}: both face, and no ray: {touche:?} {cible:?}");
                continue;
            };
            // The object that the ray leaves, and that to which it goes, never stand in its way.
            for bout in [touche.objet(), cible.objet()] {
                let objet = &objets[bout];
                let avant = objet.intersection(&rayon).is_ok_and(|t| t.distance() < distance);
                assert!(!avant, "{nom}: hidden by its own end: {objet:?} {rayon:?} {distance:?}");
            }
            let d = (q - p).longueur().vers_f64();
            // The end of the way that nobody looks at: 73u and 12 margins (lemma 20), the step off each surface and
            // the rounding of both points, over the cosine at the far surface.
            let cosinus = -rayon.direction().produit_scalaire(cible.normale()).vers_f64();
            let pas = touche.marge().vers_f64() + cible.marge().vers_f64();
            let bout = (80.0 * u::<R>() * (d + etendue) + 20.0 * pas) / cosinus;
            let distance_ = distance.vers_f64();
            assert!((distance_ - d).abs() <= bout, "{nom}: {distance_} of {d}: {rayon:?}");
            let libre = !est_occulte(&objets, &rayon, distance);
            let entrees = cache(&objets, &rayon, (1.0 - OUVERT) * d - bout);
            if entrees {
                assert!(!libre, "{nom}: through an object: {rayon:?} {distance:?}");
            } else if libre {
                vus += 1;
            } else {
                // Hidden by something else just before the end.
                ouverts += 1;
                assert!(cache(&objets, &rayon, (1.0 + OUVERT) * d), "{nom}: hidden: {rayon:?}");
            }
            caches += u32::from(!libre);
            naifs[usize::from(obvie)] += u32::from(obvie != libre);
        }
        println!(
            "{nom}: {vus} seen, {caches} hidden, {dos} turned away, {ouverts} open, at first {naifs:?} wrongly hidden and seen"
        );
        assert!(vus > PAIRES / 40 && caches > PAIRES / 40 && ouverts < PAIRES / 1000, "{nom}");
        assert!(naifs[0] > vus / 10, "{nom}: the obvious hides {} of {vus} only", naifs[0]);
    }
}

en_f32_et_f64!(deux_points_se_voient_si_rien_n_est_entre_eux);
