//! Boxes from two opposite corners.

use commun::fabrique::v;
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::oracle::Exact;
use commun::regimes::entre;
use commun::{Bits, arrondi, en_f32_et_f64};
use lancer_rayon::{BoiteGeo, ObjetRay, Rayon, Reel, Texture, Vecteur};

/// The lower and the upper face across an axis, exactly, of this centre and dimension.
fn faces<R: Reel>(centre: R, dimension: R) -> [Exact; 2] {
    let (c, l) = (Exact::de(centre), Exact::de(dimension.vers_f64() / 2.0));
    [&c - &l, &c + &l]
}

/// How far the worse of two faces is from where it should be.
fn ecart<R: Reel>(faces: &[Exact; 2], coins: [R; 2]) -> f64 {
    let de = |i: usize| (&faces[i] - &Exact::de(coins[i])).vers_f64().abs();
    de(0).max(de(1))
}

/// No centre and no dimension near by bring both faces nearer to the corners, whichever corner comes first; and a ray
/// through the middle enters and leaves there.
fn les_faces_sont_aux_coins<R: Bits>() {
    let faire = |alea: &mut Hasard| {
        let echelle = (20.0 * alea.f64() - 10.0).exp2();
        let mut coin = || [(); 3].map(|()| R::depuis_f64(entre(alea, -9.0, 9.0) * echelle));
        [coin(), coin()]
    };
    pour_chaque(20_000, faire, |[a, b]: [[R; 3]; 2]| {
        let Ok(boite) = BoiteGeo::entre_coins(a.into(), b.into(), Texture(7)) else { return };
        assert_eq!(BoiteGeo::entre_coins(b.into(), a.into(), Texture(7)), Ok(boite));
        let [c, d] = [boite.centre(), boite.dimensions()].map(<[R; 3]>::from);
        for i in 0..3 {
            let coins = if a[i] < b[i] { [a[i], b[i]] } else { [b[i], a[i]] };
            let trouve = ecart(&faces(c[i], d[i]), coins);
            let peu = |x: R, k: f64| x * R::depuis_f64(1.0 + k * 2.0 * R::U.vers_f64());
            for (k, l) in
                [(-1.0, 0.0), (1.0, 0.0), (0.0, -1.0), (0.0, 1.0), (1.0, 1.0), (-1.0, -1.0)]
            {
                let autre = ecart(&faces(peu(c[i], k), peu(d[i], l)), coins);
                assert!(trouve <= autre, "{trouve:e} > {autre:e} of {coins:?} at {k} {l}");
            }
            assert!(trouve <= R::U.vers_f64() * (coins[0].absolu() + coins[1].absolu()).vers_f64());
        }
        let objet = ObjetRay::from(boite);
        let devant = boite.centre() - Vecteur::X * (boite.dimensions().x * R::depuis_f64(3.0));
        let rayon = Rayon::new(devant, Vecteur::X).unwrap();
        let [entree, sortie] = objet.traversee(&rayon).unwrap();
        let long = (sortie - entree - boite.dimensions().x).absolu();
        assert!(long <= R::depuis_f64(8.0) * R::U * (sortie + boite.centre().x.absolu()), "{long}");
        assert_eq!((boite.texture(), boite.vers_ray().normales()[1]), (Texture(7), Vecteur::Y));
    });
}

en_f32_et_f64!(les_faces_sont_aux_coins);

/// What the documentation says of neighbours: with corners in centimetres a third meet, a third leave a crack and a
/// third overlap; with whole numbers all meet.
fn un_tiers_des_voisins_laisse_une_fente<R: Bits>() {
    let mut combien = [0_u32; 3];
    let mut pire = 0.0_f64;
    let faire = |alea: &mut Hasard| {
        let de = alea.usize(0..800) as f64;
        let [a, b] = [(); 2].map(|()| alea.usize(1..101) as f64);
        [de, de + a, de + a + b]
    };
    let boite = |de: f64, a: f64| {
        let boite =
            BoiteGeo::<R>::entre_coins(v(de, 0.0, 0.0), v(a, 1.0, 1.0), Texture(0)).unwrap();
        faces(boite.centre().x, boite.dimensions().x)
    };
    pour_chaque(20_000, faire, |centimetres| {
        let [a, b, c] = centimetres.map(|x| x / 100.0);
        let recouvre = &boite(a, b)[1] - &boite(b, c)[0];
        let signe = recouvre.signe();
        combien[(signe as i8 + 1) as usize] += 1;
        pire = pire.max(recouvre.vers_f64().abs());
        let [a, b, c] = centimetres;
        assert!((&boite(a, b)[1] - &boite(b, c)[0]).signe().is_eq());
    });
    println!("{combien:?} {pire:e}");
    let permis = 6_300..7_000;
    assert!(combien.iter().all(|n| permis.contains(n)), "{combien:?} leave a crack, meet, overlap");
    assert!((4.0..64.0).contains(&(pire / R::U.vers_f64())), "{pire:e}");
}

en_f32_et_f64!(un_tiers_des_voisins_laisse_une_fente);

#[test]
fn une_erreur_nomme_le_coin_ou_le_cote() {
    let refus = |a: [f64; 3], b: [f64; 3]| {
        let refus = BoiteGeo::entre_coins(a.into(), b.into(), Texture(0)).unwrap_err();
        (refus.champ, refus.valeur)
    };
    let loin = 2.0_f64.powi(451);
    assert_eq!(refus([0.0, loin, 0.0], [1.0, 1.0, 1.0]), ("coin.y", loin));
    assert_eq!(refus([0.0, 0.0, 0.0], [1.0, 1.0, -loin]), ("oppose.z", -loin));
    assert!(refus([0.0, 0.0, 0.0], [f64::NAN, 1.0, 1.0]).1.is_nan());
    assert_eq!(refus([0.0, 3.0, 0.0], [1.0, 3.0, 1.0]), ("dimensions.y", 0.0));
    assert_eq!(refus([0.0, 0.0, 1e-150], [1.0, 1.0, 0.0]), ("dimensions.z", 1e-150));
    let petit: Vecteur<f32> = arrondi(Vecteur::new(1e-20, 1.0, 1.0));
    let refus = BoiteGeo::entre_coins(Vecteur::NUL, petit, Texture(0)).unwrap_err();
    assert_eq!(refus.champ, "dimensions.x");
}
