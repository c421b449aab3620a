//! What an object holds, and what holds the object.

use commun::arrondi;
use commun::en_f32_et_f64;
use commun::fabrique::{boite, boite_droite, mur, sphere, v};
use commun::hasard::pour_chaque;
use commun::regimes::regimes;
use lancer_rayon::{Etendue, Monde, Nombre, ObjetRay, Reel, Rotation, Vecteur};

/// The surface belongs to an object; the next number beyond it does not.
fn la_surface_est_dans_l_objet<R: Reel>() {
    let (cotes, un) = (arrondi(Vecteur::new(2.0, 2.0, 2.0)), Vecteur::new(R::UN, R::ZERO, R::ZERO));
    let objets: [ObjetRay<R>; 3] =
        [sphere(Vecteur::NUL, R::UN), mur(un, un), boite_droite(Vecteur::NUL, cotes)];
    for objet in objets {
        assert!(objet.contient(un), "{objet:?}");
        assert!(!objet.contient(un * (R::UN + (R::U + R::U))), "{objet:?}");
        assert!(!objet.contient(un * R::depuis_f64(f64::NAN)), "{objet:?}");
    }
}

en_f32_et_f64!(la_surface_est_dans_l_objet);

/// A box whose normals are as short as a matrix may keep them reaches farther than its half-lengths
/// along them, and its extent holds all that it contains.
fn l_etendue_tient_une_boite_aux_normales_courtes<R: Reel>() {
    let un = |u: f64| R::UN + R::U * R::depuis_f64(u);
    let court = un(-4.0);
    let m = Rotation::IDENTITE.matrice().map(|ligne| ligne.map(|x: R| x * court));
    let tour = Rotation::depuis_matrice(m).unwrap();
    assert_eq!(tour.matrice(), m);
    let objet = boite(Vecteur::NUL, v(2.0, 1e-3, 1e-3), tour);
    let bout = Vecteur::new(un(4.0), R::ZERO, R::ZERO);
    assert!(objet.contient(bout) && objet.contient(-bout));
    let Etendue { bas, haut } = objet.etendue().unwrap();
    assert!(bas.x <= -bout.x && bout.x <= haut.x, "{bas:?} {haut:?}");
}

en_f32_et_f64!(l_etendue_tient_une_boite_aux_normales_courtes);

/// The centre of an object that has one, and how far its farthest corner is from there along each axis.
fn demi_etendue(objet: &ObjetRay<f32>) -> [[f64; 3]; 2] {
    let (centre, coins) = match objet {
        ObjetRay::Sphere(sphere) => (sphere.centre(), vec![[sphere.rayon().vers_f64(); 3]]),
        ObjetRay::Plan(_) => (Vecteur::NUL, vec![[f64::INFINITY; 3]]),
        ObjetRay::Boite(boite) => {
            let [u, v, w] = [0, 1, 2]
                .map(|i| boite.normales()[i].vers_f64() * boite.demi_longueurs()[i].vers_f64());
            let coin = |x: f64, y: f64| <[f64; 3]>::from(u + v * x + w * y);
            let coins = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)];
            (boite.centre(), coins.map(|(x, y)| coin(x, y)).to_vec())
        }
    };
    let h = [0, 1, 2].map(|i| coins.iter().map(|coin| coin[i].abs()).fold(0.0, f64::max));
    [centre.vers_f64().into(), h]
}

/// Each hit lies in the box around its object, and in that around the list; no box is larger than promised.
#[test]
fn chaque_touche_est_dans_l_etendue() {
    let (mut juges, mut objets) = (0, Vec::new());
    for regime in regimes::<f32>() {
        pour_chaque(
            300,
            |alea| (regime.cas)(alea),
            |cas| {
                let Some(Etendue { bas, haut }) = cas.objet.etendue() else {
                    assert!(matches!(cas.objet, ObjetRay::Plan(_)));
                    return;
                };
                objets.push(cas.objet);
                let [bas, haut] = [bas, haut].map(|v| <[f64; 3]>::from(v.vers_f64()));
                let [c, h] = demi_etendue(&cas.objet);
                // What lemma 15 adds to the corners, less the 36u by which they may be off from those of the solid.
                let (des_demis, du_centre) =
                    (h.iter().sum::<f64>(), c.map(f64::abs).iter().sum::<f64>());
                let jeu = f64::from(f32::U) * (51.0 * des_demis + 3.1 * du_centre);
                for i in 0..3 {
                    assert!(bas[i] >= c[i] - h[i] - jeu && haut[i] <= c[i] + h[i] + jeu, "{cas:?}");
                }
                // This hit is as exact as f64.
                let rayon = cas.rayon.temoin_f64();
                let Ok(touche) = cas.objet.temoin_f64().intersection(&rayon) else { return };
                let s = <[f64; 3]>::from(rayon.source());
                let ici = <[f64; 3]>::from(touche.point());
                for i in 0..3 {
                    let arrondi = 1e-14 * (s[i].abs() + touche.distance());
                    assert!(bas[i] <= ici[i] + arrondi && ici[i] <= haut[i] + arrondi, "{cas:?}");
                }
                juges += 1;
            },
        );
    }
    assert!(juges > 1_000, "{juges}");
    let Etendue { bas, haut } = Monde::de_liste(&objets).etendue().unwrap();
    for Etendue { bas: b, haut: h } in objets.iter().filter_map(ObjetRay::etendue) {
        assert!(bas.x <= b.x && bas.y <= b.y && bas.z <= b.z);
        assert!(haut.x >= h.x && haut.y >= h.y && haut.z >= h.z);
    }
    assert_eq!(Monde::<f64>::de_liste(&[]).etendue(), None);
}
