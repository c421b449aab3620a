//! Rays almost parallel to a face, down to the smallest number of the type, and boxes at both ends of the range: no
//! product outside of the range decides anything.

use commun::fabrique::boite_droite;
use commun::hasard::{Hasard, pour_chaque};
use commun::oracle::verite;
use commun::regimes::{direction, repere};
use commun::{arrondi, en_f32_et_f64};
use lancer_rayon::{
    Intersection, Monde, Nombre, ObjetRay, PlanGeo, Rayon, Reel, Rotation, Texture, Vecteur,
};

/// A box along the axes by its half-lengths.
fn demie<R: Reel>(centre: Vecteur<R>, demi_longueurs: Vecteur<R>) -> ObjetRay<R> {
    boite_droite(centre, demi_longueurs * (R::UN + R::UN))
}

/// Requires the exact answer, alone and nine side by side.
fn juger<R: Reel>(objet: &ObjetRay<R>, rayon: &Rayon<R>) -> Option<Intersection<R>> {
    let attendu = verite(objet, rayon).entree;
    let obtenu = objet.intersection(rayon);
    assert_eq!(obtenu.is_ok(), attendu.is_some(), "{objet:?} {rayon:?}: {obtenu:?}");
    let seul = [*objet];
    let liste = Monde::de_liste(&seul);
    assert_eq!(liste.est_occulte(rayon), attendu.is_some(), "{rayon:?}");
    let mut lot = [obtenu; 9];
    lot.fill(Err(lancer_rayon::NoIntersection));
    liste.premieres_intersections(&[*rayon; 9], &mut lot).unwrap();
    assert_eq!(lot, [obtenu; 9], "{objet:?} {rayon:?}");
    obtenu.ok()
}

fn puissance<R: Reel>(exposant: i32) -> R {
    R::depuis_f64(f64::from(exposant).exp2())
}

/// A slope towards a face along the axes is exact and decides as it stands, down to the smallest box: from 1024 before
/// the middle of the box the ray enters by the side or by the top, or passes over.
fn une_pente_decide_telle_qu_elle_est<R: Reel>() {
    let v = |x: f64, y: f64| arrondi::<R>(Vecteur::new(x, y, 0.0));
    // The box is 2¹¹ slopes high.
    let plus_petite = -R::LIMITE.vers_f64().log2() as i32 - 11;
    for pente in (plus_petite..=-30).map(|k| f64::from(k).exp2()) {
        let haut = 1024.0 * pente;
        let objet = demie(v(0.0, -haut), arrondi(Vecteur::new(1.0, haut, 1.0)));
        let de = |hauteur| {
            juger(&objet, &Rayon::new(v(-1024.0, hauteur), v(1.0, -pente)).unwrap())
                .map(|touche| (touche.distance().vers_f64(), touche.normale()))
        };
        assert_eq!(de(512.0 * pente), Some((1023.0, v(-1.0, 0.0))));
        assert_eq!(de(1024.0 * pente), Some((1024.0, v(0.0, 1.0))));
        assert_eq!(de(2048.0 * pente), None);
    }
}

en_f32_et_f64!(une_pente_decide_telle_qu_elle_est);

/// Rays beside the smallest box and at it, with every speed across down to the smallest number, along one axis and
/// along two. A speed below 2^−`dernier` may count as 0, which matters only in the plane of a face.
fn petite_boite<R: Reel>(dernier: i32) {
    let bits = R::LIMITE.vers_f64().log2() as i32;
    let k = puissance(-bits);
    let cube = demie(Vecteur::NUL, Vecteur::new(R::UN, R::UN, R::UN) * (k / (R::UN + R::UN)));
    let mut touches = 0;
    for (e, vitesse) in (0..).map(|e| (e, puissance::<R>(-e))).take_while(|&(_, v)| v > R::ZERO) {
        for (x, y, z) in [
            (0.6, -0.51, -0.1),
            (0.3, -0.51, -0.1),
            (0.3, -0.49, -0.8),
            (0.6, 0.2, 3.0),
            (0.5625, -0.5625, -0.8),
            (0.5, -0.51, -0.1),
            (0.3, 0.5, -0.8),
            (0.5, 0.5, -0.8),
            (0.3, -0.5, -0.50001),
        ] {
            if e > dernier && (x == 0.5 || y.absolu() == 0.5) {
                continue;
            }
            let s = Vecteur::new(R::depuis_f64(x), R::depuis_f64(y), R::depuis_f64(z)) * k;
            for cote in [R::ZERO, vitesse, -vitesse] {
                for vers_y in [vitesse, -vitesse] {
                    let d = Vecteur::new(cote, vers_y, R::UN);
                    touches += u32::from(juger(&cube, &Rayon::new(s, d).unwrap()).is_some());
                }
            }
        }
    }
    assert!(touches > 100, "{touches} hits");
}

#[test]
fn la_plus_petite_boite_est_juste_a_toute_vitesse() {
    petite_boite::<f32>(102);
    petite_boite::<f64>(1074);
}

/// In `f32` a speed of 2⁻¹⁰³ counts as 0, and the next number above does not: a ray that leaves the plane of a face so
/// slowly slides along the face.
#[test]
fn une_vitesse_de_f32_est_un_multiple_de_2_puissance_moins_102() {
    let cube = demie(Vecteur::NUL, Vecteur::new(1.0_f32, 1.0, 1.0));
    let touche = |vitesse| {
        let rayon = Rayon::new(Vecteur::new(0.5, 1.0, -5.0), Vecteur::new(0.0, vitesse, 1.0));
        cube.intersection(&rayon.unwrap()).is_ok()
    };
    let demi = puissance::<f32>(-103);
    assert!(touche(0.0) && touche(f32::ETA) && touche(demi) && !touche(demi.next_up()));
}

/// From one end of the range to a box at the other, and back, no distance is too long for the search.
fn une_boite_a_l_autre_bout_est_touchee<R: Reel>() {
    let bout = R::LIMITE * R::depuis_f64(0.75);
    let objet =
        demie(Vecteur::new(bout, bout, bout), Vecteur::new(bout, bout, bout) * R::depuis_f64(0.25));
    for k in 0..8_u8 {
        let vers = |bit: u8| if k & bit == 0 { -bout } else { bout };
        let source = Vecteur::new(vers(1), vers(2), vers(4));
        let Ok(rayon) = Rayon::new(source, Vecteur::new(bout, bout, bout) - source) else {
            continue;
        };
        assert!(juger(&objet, &rayon).is_some(), "{rayon:?}");
    }
}

en_f32_et_f64!(une_boite_a_l_autre_bout_est_touchee);

/// Sources that lie a few of the smallest numbers above a half-space through the origin.
fn aucune_distance_n_est_0<R: Reel>() {
    let mut touches = 0;
    let faire = |alea: &mut Hasard| {
        let n = arrondi::<R>(direction(alea));
        let tour = Rotation::depuis_matrice(repere(n)).unwrap();
        (ObjetRay::from(PlanGeo::new(tour, R::ZERO, Texture(0)).unwrap()), n)
    };
    pour_chaque(200, faire, |(plan, n)| {
        for k in 0..343_u16 {
            let pas = |de: u16| R::ETA * R::depuis_f64(f64::from(k / de % 7) - 3.0);
            let rayon = Rayon::new(Vecteur::new(pas(1), pas(7), pas(49)), -n).unwrap();
            if let Ok(touche) = plan.intersection(&rayon) {
                assert!(touche.distance() > R::ZERO, "{rayon:?}");
                touches += 1;
            }
        }
    });
    assert!(touches > 10_000, "only {touches} hits");
}

en_f32_et_f64!(aucune_distance_n_est_0);
