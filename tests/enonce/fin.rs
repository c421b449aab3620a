//! Rays with an end: which numbers are ends, and where a ray between two points ends. (`commun/choisis.rs` tries with
//! every way to an answer that each question stops there.)

use commun::fabrique::{mur, v};
use commun::hasard::{Hasard, pour_chaque};
use commun::oracle::{Exact, exact_a, exacts, moins};
use commun::regimes::{direction, entre};
use commun::{Bits, arrondi, en_f32_et_f64};
use lancer_rayon::{Monde, Rayon, Reel, Vecteur};

fn jusqu_a<R: Reel>(rayon: &Rayon<R>, fin: R) -> Rayon<R> {
    rayon.jusqu_a(fin).unwrap()
}

/// NaN and numbers below 0 are no ends, and the refusal names `fin`. Every number from 0 on is an end, and replaces the
/// one before. A ray that ends at 0 asks nothing.
fn une_fin_est_une_distance<R: Bits>() {
    let rayon = Rayon::<R>::new(v(0.0, 0.0, 5.0), v(0.1, 0.2, -3.0)).unwrap();
    assert_eq!(rayon.fin(), R::INFINI);
    let nan = R::depuis_f64(f64::NAN);
    for refusee in [nan, -nan, -R::UN, -R::ETA, -R::LIMITE, -R::INFINI] {
        let erreur = rayon.jusqu_a(refusee).unwrap_err();
        assert_eq!(erreur.champ, "fin");
        let valeur = refusee.vers_f64();
        assert!(erreur.valeur == valeur || (erreur.valeur.is_nan() && valeur.is_nan()));
    }
    let admises = [R::ZERO, -R::ZERO, R::ETA, R::UN, R::LIMITE, R::INFINI];
    for fin in admises {
        let court = jusqu_a(&rayon, fin);
        assert_eq!((court.source(), court.direction()), (rayon.source(), rayon.direction()));
        assert_eq!(court.fin(), fin);
        // The end moves nearer, farther, and away again.
        for autre in admises {
            assert_eq!(jusqu_a(&court, autre), jusqu_a(&rayon, autre));
            assert_eq!(court == jusqu_a(&rayon, autre), fin == autre);
        }
        assert_eq!(court == rayon, fin == R::INFINI);
        assert_eq!(court.point(R::UN), rayon.point(R::UN));
        // To the other type and back, where an `f32` loses nothing.
        assert_eq!(court.temoin_f64().fin(), fin.vers_f64());
        let simple = court.vers_f32(Vecteur::NUL).unwrap();
        assert_eq!(simple.fin(), fin.vers_f64() as f32);
    }
}

en_f32_et_f64!(une_fin_est_une_distance);

/// The ray between two points has the direction of their difference, and is as long. It meets what stands between them
/// and not what stands beyond. No ray joins a point with itself.
fn un_rayon_entre_deux_points_finit_au_second<R: Bits>() {
    let (mut libres, mut caches) = (0, 0);
    let faire = |alea: &mut Hasard| {
        let [p, q] = [(); 2].map(|()| direction(alea) * entre(alea, 0.5, 20.0));
        // The points are close by, or one is some thousand times as far from O as the other.
        let p = p * [1.0, 1e4][alea.tour % 2];
        (arrondi::<R>(p), arrondi::<R>(q), entre(alea, 0.1, 1.9))
    };
    pour_chaque(2_000, faire, |(p, q, part)| {
        let rayon = Rayon::entre(p, q).unwrap();
        let voulu = Rayon::new(p, q - p).unwrap();
        assert_eq!(rayon, jusqu_a(&voulu, (q - p).longueur()));
        assert_eq!(rayon.source(), p);
        let ecart = moins(&exact_a(&rayon, &Exact::de(rayon.fin())), &exacts(q));
        let ecart = ecart.map(|x| x.vers_f64());
        // The end is off by 3.6u of the way along the ray and by 4.6u in direction (lemma 11).
        let permis = 8.2 * R::U.vers_f64() * (q.vers_f64() - p.vers_f64()).longueur();
        assert!(Vecteur::from(ecart).longueur() <= permis, "{ecart:?} {rayon:?}");
        // A wall across the line, at some part of its length.
        let la = arrondi(p.vers_f64() + (q - p).vers_f64() * part);
        let occulte = Monde::de_liste(&[mur(la, p - q)]).est_occulte(&rayon);
        if (part - 1.0).abs() > 1e-3 {
            assert_eq!(occulte, part < 1.0, "{part}: {rayon:?}");
            *(if occulte { &mut caches } else { &mut libres }) += 1;
        }
    });
    assert!(libres > 500 && caches > 500);

    let p = v::<R>(1.0, 2.0, 3.0);
    assert_eq!(Rayon::entre(p, p).unwrap_err().champ, "arrivee - depart");
    let loin = v::<R>(0.0, 1.0, 0.0) * (R::LIMITE + R::LIMITE);
    assert_eq!(Rayon::entre(loin, p).unwrap_err().champ, "depart.y");
    assert!(Rayon::entre(p, loin).is_ok());
    let [nulle_part, a_l_infini] = [f64::NAN, f64::INFINITY].map(|z| v::<R>(0.0, 0.0, z));
    for ailleurs in [nulle_part, a_l_infini] {
        assert_eq!(Rayon::entre(ailleurs, p).unwrap_err().champ, "depart.z");
        assert_eq!(Rayon::entre(p, ailleurs).unwrap_err().champ, "arrivee.z");
    }
}

en_f32_et_f64!(un_rayon_entre_deux_points_finit_au_second);
