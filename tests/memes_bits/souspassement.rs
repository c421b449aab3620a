//! Rays almost parallel to a face, down to the smallest number of the type, and boxes at both ends of the range: no
//! product outside of the range decides anything.

use commun::fabrique::{boite, boite_droite};
use commun::hasard::{Hasard, pour_chaque};
use commun::oracle::verite;
use commun::regimes::{direction, repere};
use commun::{Bits, arrondi, en_f32_et_f64};
use lancer_rayon::{
    Intersection, Monde, Nombre, ObjetRay, PlanGeo, Rayon, Reel, Rotation, Texture, Vecteur,
};

/// The numbers that these bits make.
fn mots<R: Bits>(bits: [u64; 3]) -> Vecteur<R> {
    // The bits of an f32 belong in the upper half.
    let decalage = if R::U.vers_f64() > f64::EPSILON { 32 } else { 0 };
    bits.map(|mot| R::depuis_bits(mot << decalage)).into()
}

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

/// Leaves the box along its face, outward by the smallest of numbers.
fn quitter<R: Reel>(objet: &ObjetRay<R>, rayon: &Rayon<R>, vers: Vecteur<R>) {
    // Within rounding of an edge this hit need not be the true one.
    let touche = objet.intersection(rayon).unwrap();
    let sortant = touche.secondaire(vers).unwrap();
    assert!(juger(objet, &sortant).is_none(), "{objet:?} left by {sortant:?}");
}

fn puissance<R: Reel>(exposant: i32) -> R {
    R::depuis_f64(f64::from(exposant).exp2())
}

/// Leaves a cube of centre `c`, at scales and slopes that are powers of two.
fn quitter_une_face<R: Bits>([c, l, s, d]: [[u64; 3]; 4], echelles: &[(i32, i32)]) {
    let [c, l, s, d] = [c, l, s, d].map(mots::<R>);
    for (echelle, petit) in echelles {
        let k = puissance(*echelle);
        let objet = demie(c * k, l * k);
        let petit = puissance(*petit);
        quitter(&objet, &Rayon::new(s * k, d).unwrap(), Vecteur::new(petit, petit, R::UN));
    }
}

#[test]
fn un_rayon_qui_quitte_une_face_ne_la_retouche_pas_f32() {
    let nombres = [
        [0x4122_e3c7, 0x412b_d450, 0x4122_9f81],
        [0x401b_4e93; 3],
        [0x4163_bfb9, 0x40cd_928e, 0x415c_e566],
        [0xbf16_310c, 0x3f2e_5499, 0xbee0_6313],
    ];
    let echelles = [(0, -140), (-50, -85), (-50, -149), (0, -149), (40, -149), (0, -100)];
    quitter_une_face::<f32>(nombres, &echelles);
}

#[test]
fn un_rayon_qui_quitte_une_face_ne_la_retouche_pas_f64() {
    let nombres = [
        [0x4025_e003_aab8_7236, 0x4025_8d10_8b7b_e822, 0x4025_8c61_b235_2ec3],
        [0x4004_2b59_fc04_a257; 3],
        [0x402d_9aa7_a4b2_30ff, 0x401c_3310_bff8_8987, 0x402c_e0ec_fffc_9344],
        [0xbfe4_1f35_39a0_b98c, 0x3fe2_0aa6_334f_0f7b, 0xbfe1_2292_09f7_8fdd],
    ];
    let echelles = [(0, -1074), (-440, -1074), (440, -1074), (-440, -640), (0, -1000)];
    quitter_une_face::<f64>(nombres, &echelles);
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

#[test]
fn un_rayon_qui_quitte_une_arete_ne_retouche_pas_la_boite() {
    let normales = [[0.0, 0.0, -1.0], [0.0, -1.0, 0.0], [-1.0, 0.0, 0.0]];
    let m = Rotation::depuis_matrice(normales).unwrap();
    let dimensions = Vecteur::new(0.499_999_9, 0.5, 1.0) * 2.0;
    let c = Vecteur::new(-0.0, -2.999_999_5, 3.0);
    let objet = boite(c, dimensions, m);
    let d = mots::<f32>([0xbf50_0fe5, 0xbead_6292, 0x3ef2_bd36]);
    let rayon = Rayon::new(mots([0x40e0_0000, 0, 0]), d).unwrap();
    quitter(&objet, &rayon, mots([0, 3, 0xbfc0_0000]));
}

/// A ray passes a face by one unit in the last place, at the smallest of speeds towards it.
fn a_cote<R: Reel>() {
    let n = |x: f64| R::depuis_f64(x);
    let dehors = n(-1.0 - 2.0 * R::U.vers_f64());
    let cube = demie(Vecteur::NUL, Vecteur::new(R::UN, R::UN, R::UN));
    for x in [0.0, 0.4, 1.4] {
        let s = Vecteur::new(n(x), dehors, n(-5.0));
        let rayon = Rayon::new(s, Vecteur::new(R::ZERO, R::ETA, R::UN)).unwrap();
        assert!(juger(&cube, &rayon).is_none());
    }
}

#[test]
fn un_rayon_a_cote_de_la_boite_manque() {
    a_cote::<f32>();
    a_cote::<f64>();
}

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
