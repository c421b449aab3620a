//! Two hierarchies, one over what stays and one over what moves: the nearer hit of both is the hit of one list.

use commun::conversion::mots;
use commun::scenes::{melange, rayons_camera};
use commun::{Bits, en_f32_et_f64};
use lancer_rayon::{Monde, NoIntersection, places, premiere_intersection};

fn deux_hierarchies_repondent_comme_une_liste<R: Bits>() {
    let fixes = melange::<R>(200);
    // Every third again: hits at the same distance in both.
    let mobiles: Vec<_> = fixes.iter().step_by(3).copied().chain(melange(60)).collect();
    let tous: Vec<_> = fixes.iter().chain(&mobiles).copied().collect();
    let places = |n| vec![0.0; places(n)];
    let (mut a, mut b) = (places(fixes.len()), places(mobiles.len()));
    let fixe = Monde::new(&fixes, &mut a).unwrap();
    let mobile = Monde::new(&mobiles, &mut b).unwrap();
    let (mut de_fixe, mut de_mobile, mut egales) = (0, 0, 0);
    for rayon in rayons_camera::<R>(60, 40) {
        let (t, u) = (fixe.premiere_intersection(&rayon), mobile.premiere_intersection(&rayon));
        let mobile_d_abord = match (&t, &u) {
            (Ok(t), Ok(u)) => u.distance() < t.distance(),
            (Err(NoIntersection), _) => true,
            (Ok(_), Err(NoIntersection)) => false,
        };
        egales += u32::from(t.is_ok_and(|t| u.is_ok_and(|u| u.distance() == t.distance())));
        let (decalage, touche) = if mobile_d_abord { (fixes.len(), u) } else { (0, t) };
        let (deux, une) = (mots(&touche), mots(&premiere_intersection(&tous, &rayon)));
        assert_eq!(deux.valeurs, une.valeurs, "{rayon:?}");
        assert_eq!(deux.objet.map(|i| i + decalage), une.objet, "{rayon:?}");
        de_fixe += u32::from(une.objet.is_some_and(|i| i < fixes.len()));
        de_mobile += u32::from(une.objet.is_some_and(|i| i >= fixes.len()));
    }
    assert!(de_fixe > 100 && de_mobile > 100 && egales > 100, "{de_fixe} {de_mobile} {egales}");
}

en_f32_et_f64!(deux_hierarchies_repondent_comme_une_liste);
