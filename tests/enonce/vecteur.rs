//! Vectors, also where the squares of their coordinates leave the range of the type.

use commun::{arrondi, en_f32_et_f64};
use lancer_rayon::{Nombre, Reel, Vecteur};

/// 3² + 4² + 12² = 13².
const COTES: Vecteur = Vecteur::new(3.0, -4.0, 12.0);

/// From the smallest number to the largest, at every power of two, the length is exact and the unit vector the same.
fn la_longueur_est_exacte_d_un_bout_a_l_autre<R: Reel>() {
    let (cotes, treize) = (arrondi::<R>(COTES), R::depuis_f64(13.0));
    let unitaire = cotes.unitaire();
    let (mut k, mut puissances) = (R::ETA, 0);
    while treize * k < R::INFINI {
        let v = cotes * k;
        assert_eq!(
            (v.longueur(), v.unitaire()),
            (treize * k, unitaire),
            "at {k:e}",
            k = k.vers_f64()
        );
        k = k + k;
        puissances += 1;
    }
    assert_eq!(puissances, if R::U == R::depuis_f64(f64::U) { 2095 } else { 274 });
}

fn un_operateur_sur_place_est_l_operateur<R: Reel>() {
    let (a, b, k) =
        (arrondi::<R>(COTES), arrondi(Vecteur::new(0.5, 0.25, -2.0)), R::depuis_f64(4.0));
    let mut v = a;
    v += b;
    assert_eq!(v, arrondi(Vecteur::new(3.5, -3.75, 10.0)));
    assert_eq!([a, b].into_iter().sum::<Vecteur<R>>(), v);
    assert_eq!([a, b].iter().sum::<Vecteur<R>>(), v);
    v -= b;
    assert_eq!(v, a);
    v *= k;
    assert_eq!(v, arrondi(COTES * 4.0));
    v /= k;
    assert_eq!(v, a);
    assert_eq!((4.0 * COTES, 4.0_f32 * arrondi(COTES)), (COTES * 4.0, arrondi(COTES * 4.0)));
}

/// Arrays, triples and, with the feature, the types of `mint` hold the same coordinates in the same order.
fn les_coordonnees_restent_a_leur_place<R: Reel>() {
    let v = arrondi::<R>(COTES);
    assert_eq!(v, Vecteur::X * v.x + Vecteur::Y * v.y + Vecteur::Z * v.z);
    let (triple, tableau): ((R, R, R), [R; 3]) = (v.into(), v.into());
    assert_eq!((triple, tableau), ((v.x, v.y, v.z), [v.x, v.y, v.z]));
    assert_eq!([Vecteur::from(triple), Vecteur::from(tableau)], [v; 2]);
    #[cfg(feature = "mint")]
    {
        let (vecteur, point): (mint::Vector3<R>, mint::Point3<R>) = (v.into(), v.into());
        assert_eq!((vecteur.x, vecteur.y, vecteur.z), triple);
        assert_eq!((point.x, point.y, point.z), triple);
        assert_eq!([Vecteur::from(vecteur), Vecteur::from(point)], [v; 2]);
    }
}

en_f32_et_f64!(la_longueur_est_exacte_d_un_bout_a_l_autre);
en_f32_et_f64!(un_operateur_sur_place_est_l_operateur);
en_f32_et_f64!(les_coordonnees_restent_a_leur_place);
