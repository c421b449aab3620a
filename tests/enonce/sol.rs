//! Over a floor at y = 0, with which every scene begins, nothing that starts from a hit is a subnormal number,
//! which a turned floor may give.

use commun::fabrique::{avec_arbre, boite_droite, mur, v};
use commun::scenes::{melange, rayons_camera};
use commun::{arrondi, en_f32_et_f64};
use lancer_rayon::{ObjetRay, Rayon, Reel, Vecteur};

/// Whether this number is subnormal, for which processors take up to a hundred times as long.
fn sous_normal<R: Reel>(x: R) -> bool {
    let normal = if size_of::<R>() == 4 { f32::MIN_POSITIVE.into() } else { f64::MIN_POSITIVE };
    x != R::ZERO && x.absolu().vers_f64() < normal
}

/// Margins, starts, directions and distances over a floor, a wall and a slab through O and the axes.
fn au_sol_rien_n_est_sous_normal<R: Reel>() {
    let lampe = arrondi(Vecteur::new(-2.0, 3.0, 4.0));
    let mut vus = 0;
    for dalle in [false, true] {
        let mut objets = melange::<R>(40);
        if dalle {
            objets[0] = boite_droite(v(0.0, -0.25, 0.0), v(20.0, 0.5, 20.0));
        }
        objets.extend([Vecteur::X, Vecteur::Z].map(|n| mur(n * R::depuis_f64(-9.0), n)));
        let penche = mur(Vecteur::NUL, Vecteur::X + Vecteur::Z);
        for scene in [objets.clone(), vec![objets[0], penche]] {
            let monde = avec_arbre(&scene);
            for rayon in rayons_camera::<R>(60, 40) {
                let Ok(touche) = monde.premiere_intersection(&rayon) else { continue };
                let (d, n) = (rayon.direction(), touche.normale());
                let reflet = d - n * (d.produit_scalaire(n) * R::depuis_f64(2.0));
                let reflet = touche.secondaire(reflet).unwrap();
                let mut nombres = vec![touche.marge(), touche.distance()];
                nombres.extend(<[R; 3]>::from(reflet.source()));
                nombres.extend(monde.premiere_intersection(&reflet).ok().map(|t| t.distance()));
                if let Ok(ombre) = touche.vers_lumiere(lampe) {
                    nombres.extend(<[R; 3]>::from(ombre.direction()));
                    nombres.push(ombre.fin());
                }
                assert!(!nombres.iter().copied().any(sous_normal), "{nombres:?} {rayon:?}");
                vus += 1;
            }
        }
    }
    assert!(vus > 4_000, "{vus}");
}

en_f32_et_f64!(au_sol_rien_n_est_sous_normal);

/// For a floor through O that is turned by less than 2⁻²⁶ (`f64`: 2⁻¹²²), and a point that is exactly O, no margin is
/// subnormal, but a coordinate of the start is.
fn au_sol_tourne_un_depart_est_sous_normal<R: Reel>() {
    let peu = if size_of::<R>() == 4 { -27.0_f64 } else { -123.0 };
    for (pente, attendu) in [(peu.exp2(), true), ((peu + 2.0).exp2(), false), (0.0, false)] {
        let n = v(-pente, -1.0, 0.0);
        let sol: ObjetRay<R> = mur(Vecteur::NUL, n);
        let source = Vecteur::new(R::ZERO, -R::UN, R::ZERO);
        let rayon = Rayon::new(source, -source).unwrap();
        let touche = sol.intersection(&rayon).unwrap();
        assert_eq!((touche.point(), touche.normale()), (Vecteur::NUL, n));
        let depart = touche.secondaire(n).unwrap().source();
        assert!(!sous_normal(touche.marge()));
        assert_eq!(<[R; 3]>::from(depart).into_iter().any(sous_normal), attendu, "{depart:?}");
    }
}

en_f32_et_f64!(au_sol_tourne_un_depart_est_sous_normal);
