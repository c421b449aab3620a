//! What a renderer rests on: a lamp lights a convex object on its own exactly where the object faces the
//! lamp.

use commun::fabrique::{boite, sphere};
use commun::scenes::rayons_camera;
use commun::tolerances::u;
use commun::{arrondi, en_f32_et_f64};
use lancer_rayon::{Intersection, Monde, ObjetRay, Rayon, Reel, Rotation, Vecteur};

const LAMPES: [Vecteur; 4] = [
    Vecteur::new(2.0, 3.0, 4.0),
    Vecteur::new(-1.9, 0.4, 0.3),
    Vecteur::new(0.3, -50.0, 20.0),
    Vecteur::new(-500.0, 800.0, -300.0),
];

/// cos² of a ray from a lamp, below which the ray grazes, in u of the coordinates: the point of a hit is
/// off by a few u, and 64 is far above a few.
const RASANT: f64 = 64.0;

/// How far the camera stands from the objects, in their size: the distance is rounded as well, and that of the
/// lamp.
const RECUL: f64 = 8.0;

/// A ball and a turned box, about as large as `echelle`.
fn objets<R: Reel>(centre: Vecteur, echelle: f64) -> [ObjetRay<R>; 2] {
    let tour = Rotation::new(arrondi(Vecteur::new(0.4, 0.7, 0.2))).unwrap();
    let cotes = arrondi(Vecteur::new(1.5, 1.1, 1.3) * echelle);
    let boule = sphere(arrondi(centre), R::depuis_f64(echelle));
    [boule, boite(arrondi(centre), cotes, tour)]
}

/// Whether nothing is between this hit and the lamp, as a renderer asks.
fn voit<R: Reel>(objet: &ObjetRay<R>, touche: &Intersection<R>, lampe: Vecteur<R>) -> bool {
    let ombre = touche.secondaire(lampe - touche.point()).unwrap();
    let ombre = ombre.jusqu_a((lampe - ombre.source()).longueur()).unwrap();
    !Monde::de_liste(&[*objet]).est_occulte(&ombre)
}

/// The first assertion needs no threshold: `secondaire` promises that an outward ray never hits its own
/// object, and that an inward ray misses it. One lamp lies in the tangent plane of each hit, on either
/// side of it by rounding. The sign of N·L alone tells what is dark.
///
/// The second assertion traces the ray of the lamp towards the point P. It must hit the object beside P
/// if N·L > 0, and elsewhere if N·L < 0. P is off the surface by h, a few u of its coordinates, so that
/// an oblique ray hits h/(r·cos) beside P, in radii. The normals differ by as much, and by about the
/// cosine on the other side: the two are told apart where cos² is far above h/r.
fn une_lampe_eclaire_ce_qui_lui_fait_face<R: Reel>() {
    let (mut clairs, mut sombres, mut rasants) = (0, 0, 0);
    for (echelle, loin) in [1e-3, 1.0, 1e4].into_iter().flat_map(|e| [(e, 0.0), (e, 1e3)]) {
        let decalage = Vecteur::new(0.6, -0.7, 0.4) * (loin * echelle);
        let centre = Vecteur::new(0.0, 2.0, 2.0) * echelle + decalage;
        let objets = objets::<R>(centre, echelle);
        let rayons = rayons_camera::<R>(90, 60).into_iter().map(|rayon| {
            let source = rayon.source().vers_f64() * echelle + decalage;
            Rayon::new(arrondi(source), rayon.direction()).unwrap()
        });
        for (rayon, objet) in rayons.flat_map(|rayon| objets.map(|objet| (rayon, objet))) {
            let Ok(touche) = objet.intersection(&rayon) else { continue };
            let (d, n) = (rayon.direction().vers_f64(), touche.normale().vers_f64());
            let point = touche.point();
            let rasante = point.vers_f64() + (d - n * d.produit_scalaire(n)) * echelle;
            for lampe in LAMPES.map(|lampe| lampe * echelle + centre).into_iter().chain([rasante]) {
                let loin = (lampe - centre).longueur() + centre.longueur();
                let seuil = (RASANT * u::<R>() * (loin / echelle + RECUL)).sqrt();
                let lampe = arrondi(lampe);
                let Ok(depuis) = Rayon::new(lampe, point - lampe) else { continue };
                let cosinus = -depuis.direction().produit_scalaire(touche.normale()).vers_f64();
                let contexte = || format!("{objet:?} {rayon:?} {lampe:?}: {cosinus}");
                assert!(voit(&objet, &touche, lampe), "its own shadow: {}", contexte());
                let vers = touche.vers_lumiere(lampe);
                if let Ok(ombre) = vers {
                    let distance = ombre.fin();
                    assert!(!Monde::de_liste(&[objet]).est_occulte(&ombre), "{}", contexte());
                    let ecart = (ombre.point(distance) - lampe).longueur().vers_f64();
                    // A rounding of the distance, six of the direction, two of the point.
                    let permis = 9.0 * u::<R>() * (distance + ombre.source().longueur()).vers_f64();
                    assert!(ecart <= permis, "{ecart:e} beside the lamp, {}", contexte());
                }
                if cosinus.abs() < seuil {
                    rasants += u32::from(cosinus > 0.0);
                    continue;
                }
                let vue = objet.intersection(&depuis).map_err(|_| contexte()).unwrap();
                let ecart = (vue.normale().vers_f64() - n).longueur();
                assert_eq!(ecart < seuil, cosinus > 0.0, "{ecart}, {}", contexte());
                assert_eq!(vers.is_ok(), cosinus > 0.0, "{}", contexte());
                *(if cosinus > 0.0 { &mut clairs } else { &mut sombres }) += 1;
            }
        }
    }
    println!("{clairs} lit, {sombres} dark, {rasants} grazed");
    assert!(clairs.min(sombres) > 10_000 && rasants > 2_000);
}

en_f32_et_f64!(une_lampe_eclaire_ce_qui_lui_fait_face);
