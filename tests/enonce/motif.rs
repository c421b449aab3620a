//! Patterns: on which face of a box a hit lies and where. (How exactly is a promise, `commun/promesses.rs`.)

use commun::fabrique::mur;
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::regimes::{deux_puissance, direction, entre, signe};
use commun::tolerances::u;
use commun::{arrondi, en_f32_et_f64};
use lancer_rayon::{
    BoiteGeo, BoiteRay, Face, Nombre, ObjetRay, Rayon, Reel, Rotation, Texture, Vecteur,
};

/// Right and up along each face, so that their vector product points outward.
#[test]
fn le_long_d_une_face_on_va_a_droite_et_en_haut() {
    let axes: [Vecteur; 3] = [Vecteur::X, Vecteur::Y, Vecteur::Z];
    for (i, face) in Face::TOUTES.into_iter().enumerate() {
        let [droite, haut] = [0, 1].map(|k| Vecteur::from(axes.map(|axe| face.le_long(axe)[k])));
        let dehors = if i < 3 { axes[i] } else { -axes[i - 3] };
        assert_eq!((face as usize, droite.produit_vectoriel(haut)), (i, dehors));
    }
}

/// The place of a hit on something else, whose point is beyond every number, is a point of the box all the same.
#[test]
fn le_lieu_d_une_touche_d_ailleurs_est_un_point_de_la_boite() {
    let cotes = Vecteur::new(1.0, 1.0, 1.0);
    let boite = BoiteGeo::new(Vecteur::NUL, cotes, Rotation::IDENTITE, Texture(0)).unwrap();
    let boite = boite.vers_ray();
    // The direction is kept although it is a little longer than 1.
    let (haut, long) = (f32::LIMITE, 1.0 + 2.0 * f32::EPSILON);
    let rayon = Rayon::new(Vecteur::new(0.0, haut, 0.0), Vecteur::new(long, 0.0, 0.0)).unwrap();
    let mut perdus = 0;
    for k in 0..16 {
        let pente = f32::from_bits((haut / f32::MAX).to_bits() - k);
        let n = Vecteur::new(-pente, 1.0, 0.0);
        let Ok(touche) = mur(Vecteur::NUL, n).intersection(&rayon) else { continue };
        let (_, p) = boite.lieu(&rayon, &touche);
        assert!(<[f32; 3]>::from(p).into_iter().all(|x| x.abs() <= 1.0), "{p:?}");
        perdus += u32::from(touche.point().x == f32::INFINITY);
    }
    assert!(perdus > 0);
}

/// A place on a face makes a hit whose place is the one that was asked for.
fn un_lieu_fait_une_touche_de_ce_lieu<R: Reel>() {
    let mut au_bord = 0;
    let faire = |alea: &mut Hasard| {
        let tour = Rotation::new(arrondi::<R>(direction(alea) * 3.0)).unwrap();
        let centre = arrondi(direction(alea) * [0.0, 3.0, 3e3][alea.usize(0..3)]);
        let cotes = [(); 3].map(|()| deux_puissance(alea, -9.0, 9.0));
        let boite = BoiteGeo::new(centre, arrondi(cotes.into()), tour, Texture(3)).unwrap();
        // Some places are on an edge, in a corner or beyond.
        let au_bord = alea.bool();
        let uv = [(); 2].map(|()| {
            let x = entre(alea, -1.2, 1.2);
            R::depuis_f64(if au_bord && alea.bool() { x.signum() } else { x })
        });
        (boite.vers_ray(), Face::TOUTES[alea.usize(0..6)], uv)
    };
    pour_chaque(2_000, faire, |(boite, face, uv)| {
        let rayon = boite.vers_lieu(face, uv).unwrap();
        let touche = ObjetRay::from(boite).sortie(&rayon).unwrap();
        assert_eq!((touche.normale(), touche.texture()), (boite.face(face).1, Texture(3)));
        let (obtenue, p) = boite.lieu(&rayon, &touche);
        assert_eq!(obtenue, face, "{p:?}");
        // A coordinate of the source takes two roundings of each l·N and three of their sum with C, of which √3 count
        // along the face. N is unit and at right angles to 12u. `lieu` adds 6.1u of |f| + t, which is at most twice the
        // extent. A place near an edge is moved away from it, by 40u of the centre and of the extent.
        let c = <[R; 3]>::from(boite.centre()).map(|x| x.vers_f64().abs());
        let c = c.into_iter().fold(0.0, f64::max);
        let extension: f64 = boite.demi_longueurs().into_iter().map(R::vers_f64).sum();
        let permis =
            u::<R>() * (3.0_f64.sqrt() * (c + 5.0 * extension) + (12.0 + 12.2) * extension);
        let bord = 40.0 * u::<R>() * (3.0 * c + extension);
        for (k, (obtenu, voulu)) in face.le_long(p).into_iter().zip(uv).enumerate() {
            let l = demi_longueur_le_long(&boite, face, k);
            let (obtenu, voulu) = (obtenu.vers_f64(), voulu.vers_f64().clamp(-1.0, 1.0));
            let deplace = if voulu.abs() >= 1.0 - bord / l { bord } else { 0.0 };
            assert!((obtenu - voulu).abs() <= (permis + deplace) / l, "{obtenu}, not {voulu}");
            au_bord += u32::from(deplace > 0.0);
        }
        let rien = R::depuis_f64(f64::NAN);
        for uv in [[R::INFINI, -R::INFINI], [rien, R::ZERO], [R::ZERO, rien]] {
            let rayon = boite.vers_lieu(face, uv).unwrap();
            assert!(ObjetRay::from(boite).sortie(&rayon).is_ok(), "{uv:?}");
        }
    });
    assert!(au_bord > 1_000, "{au_bord}");
}

/// The half-length of the box along the first or the second coordinate of a face.
fn demi_longueur_le_long<R: Reel>(boite: &BoiteRay<R>, face: Face, k: usize) -> f64 {
    let axes: [Vecteur; 3] = [Vecteur::X, Vecteur::Y, Vecteur::Z];
    let axe = axes.iter().position(|axe| face.le_long(*axe)[k] != 0.0).unwrap();
    boite.demi_longueurs()[axe].vers_f64()
}

en_f32_et_f64!(un_lieu_fait_une_touche_de_ce_lieu);

/// Boxes as skew as a rotation may be, long along one axis and thin along another: a place in a corner is moved in so
/// far that the way out from it is by its face.
fn un_coin_d_une_boite_de_biais_a_une_sortie<R: Reel>() {
    // Rows that are kept as given, since they are orthonormal to 8u.
    let biais = R::depuis_f64(7.5 * u::<R>());
    let matrice = |signe: R| {
        let (o, un) = (R::ZERO, R::UN);
        [[un, signe * biais, signe * biais], [o, un, signe * biais], [o, o, un]]
    };
    let faire = |alea: &mut Hasard| {
        let matrice = matrice(R::depuis_f64(signe(alea)));
        let tour = Rotation::depuis_matrice(matrice).unwrap();
        assert_eq!(tour.matrice(), matrice);
        let centre = arrondi(direction(alea) * [0.0, 1.0][alea.usize(0..2)]);
        let mut cotes = [1.0, deux_puissance(alea, -7.0, 0.0), deux_puissance(alea, -7.0, 0.0)];
        cotes.rotate_left(alea.usize(0..3));
        BoiteGeo::new(centre, arrondi(cotes.into()), tour, Texture(0)).unwrap().vers_ray()
    };
    let mut trop_pres = 0;
    pour_chaque(500, faire, |boite| {
        for face in Face::TOUTES {
            for (u, v) in COINS {
                let rayon = boite.vers_lieu(face, [u, v].map(R::depuis_f64)).unwrap();
                let sortie = ObjetRay::from(boite).sortie(&rayon).unwrap();
                assert_eq!(sortie.normale(), boite.face(face).1, "{face} {u} {v}");
                trop_pres += u32::from(!sort_par(&boite, face, [u, v], 7.0 * R::U.vers_f64()));
            }
        }
    });
    assert!(trop_pres > 0);
}

const COINS: [(f64, f64); 4] = [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)];

/// Whether the ray along the normal to the place that lies this part of ‖C‖₁ and Σl_i amid an edge or a corner leaves by
/// the face.
fn sort_par<R: Reel>(boite: &BoiteRay<R>, face: Face, [u, v]: [f64; 2], part: f64) -> bool {
    let (n, l) = (boite.normales(), boite.demi_longueurs());
    let c = <[R; 3]>::from(boite.centre()).map(|x| x.vers_f64().abs());
    let bord = part * (c.iter().sum::<f64>() + l.iter().map(|l| l.vers_f64()).sum::<f64>());
    let axes: [Vecteur; 3] = [Vecteur::X, Vecteur::Y, Vecteur::Z];
    let p = [0, 1, 2].map(|i| {
        let [a, b] = face.le_long(axes[i]);
        let p = (a * u + b * v) * (1.0 - bord / l[i].vers_f64()).max(0.0);
        n[i] * (l[i] * R::depuis_f64(p))
    });
    let rayon = Rayon::new(boite.centre() + (p[0] + p[1] + p[2]), boite.face(face).1).unwrap();
    let sortie = ObjetRay::from(*boite).sortie(&rayon);
    sortie.is_ok_and(|sortie| sortie.normale() == boite.face(face).1)
}

en_f32_et_f64!(un_coin_d_une_boite_de_biais_a_une_sortie);

/// In a box that was widened rays to places at an edge may not leave by the face, as the documentation of `vers_lieu` says.
/// Those to places 40u of `f32` from it do.
#[test]
fn pres_d_une_arete_d_une_boite_elargie_un_lieu_peut_manquer_la_face() {
    let tour = Rotation::new(Vecteur::new(0.3_f32, 0.4, 0.5)).unwrap();
    let cotes = Vecteur::new(2.0, 2.0, 2.0);
    let cube = ObjetRay::from(BoiteGeo::new(Vecteur::NUL, cotes, tour, Texture(0)).unwrap());
    let ObjetRay::Boite(large) = cube.temoin_f64() else { unreachable!("a box") };
    let aretes = [(-1.0, 0.0), (1.0, 0.0), (0.0, -1.0), (0.0, 1.0)];
    let mut justes = 0;
    for face in Face::TOUTES {
        for (u, v) in COINS.into_iter().chain(aretes) {
            let sortie = ObjetRay::from(large).sortie(&large.vers_lieu(face, [u, v]).unwrap());
            justes += u32::from(sortie.is_ok_and(|s| s.normale() == large.face(face).1));
            assert!(sort_par(&large, face, [u, v], 40.0 * f64::from(f32::U)), "{face} {u} {v}");
        }
    }
    assert_eq!(justes, 32);
}
