//! The two rays of a hit that every renderer sends: the mirrored one, and the one to a sun.

use commun::oracle::Exact;
use commun::regimes::{direction, regimes};
use commun::tolerances::u;
use commun::{Bits, arrondi, en_f32_et_f64};
use fastrand::Rng;
use lancer_rayon::pour_les_tests::{REDRESSE, TANGENT};
use lancer_rayon::{NoIntersection, Rayon, Reel, Vecteur, est_occulte};

fn scalaire<R: Reel>(a: Vecteur<R>, b: Vecteur<R>) -> f64 {
    let terme = |a, b| &Exact::de(a) * &Exact::de(b);
    (&(&terme(a.x, b.x) + &terme(a.y, b.y)) + &terme(a.z, b.z)).vers_f64()
}

fn bits<R: Bits>(rayon: &Rayon<R>) -> [u64; 6] {
    let (s, d) = (rayon.source(), rayon.direction());
    [s.x, s.y, s.z, d.x, d.y, d.z].map(R::bits)
}

/// Of every shape in every regime: the mirrored ray never goes inward and never meets its object again, starts where
/// `secondaire` starts, is refused where that is, and is the ray of D − 2(D·N)N. (That such a ray could go inward is
/// not excluded by a bound; no case is known.)
fn un_reflet_ne_revient_pas<R: Bits>() {
    let mut alea = Rng::with_seed(75);
    let [mut reflets, mut rasants, mut refus] = [0; 3];
    for regime in regimes::<R>() {
        for _ in 0..4_000 {
            let cas = (regime.cas)(&mut alea);
            let (objet, rayon) = (cas.objet, cas.rayon);
            let Ok(touche) = objet.intersection(&rayon) else { continue };
            let (d, n) = (rayon.direction(), touche.normale());
            let droit = rayon.secondaire(&touche, n);
            let reflet = match rayon.reflechi(&touche) {
                Ok(reflet) => reflet,
                Err(erreur) => {
                    assert_eq!(droit.unwrap_err().champ, erreur.champ, "{objet:?} {rayon:?}");
                    refus += 1;
                    continue;
                }
            };
            assert_eq!(reflet.source(), droit.unwrap().source());
            let dehors = scalaire(n, reflet.direction());
            assert!(dehors > 0.0, "{dehors:e}: {objet:?} {rayon:?}");
            assert_eq!(objet.intersection(&reflet), Err(NoIntersection), "{objet:?} {rayon:?}");
            // |D| and |N| are off by 8u, two roundings and a unit vector, and the turn outward.
            let attendue = d.vers_f64() - n.vers_f64() * (2.0 * scalaire(d, n));
            let ecart = (reflet.direction().vers_f64() - attendue).longueur();
            assert!(ecart <= (16.0 + 8.0 + 2.0 * REDRESSE) * u::<R>(), "{ecart:e}");
            let naif = rayon.secondaire(&touche, d - (n + n) * d.produit_scalaire(n)).unwrap();
            assert_eq!(bits(&naif), bits(&reflet));
            rasants += u32::from(-d.produit_scalaire(n).vers_f64() <= TANGENT * u::<R>());
            reflets += 1;
        }
    }
    println!("{reflets} mirrored, {refus} refused, {rasants} within 3.2u of the tangent plane");
    assert!(reflets > 15_000 && refus > 100 && rasants > 100);
}

en_f32_et_f64!(un_reflet_ne_revient_pas);

/// A sun shines on the side of a convex object that faces it, to 3.2u, and nowhere else: then nothing of the object is
/// in the way at any distance, and the ray is that of `secondaire`.
fn le_soleil_eclaire_ce_qui_lui_fait_face<R: Bits>() {
    let mut alea = Rng::with_seed(76);
    let [mut clairs, mut sombres, mut refus] = [0; 3];
    for regime in regimes::<R>() {
        for _ in 0..2_000 {
            let cas = (regime.cas)(&mut alea);
            let (objet, rayon) = (cas.objet, cas.rayon);
            let Ok(touche) = objet.intersection(&rayon) else { continue };
            let (n, au_hasard) = (touche.normale(), direction(&mut alea));
            // In the tangent plane rounding decides.
            let tangente = au_hasard - n.vers_f64() * n.vers_f64().produit_scalaire(au_hasard);
            for soleil in [au_hasard * 1e3, tangente] {
                let soleil = arrondi::<R>(soleil);
                let Ok(vers) = Rayon::new(Vecteur::NUL, soleil) else { continue };
                let de_face = vers.direction().produit_scalaire(n).vers_f64() > TANGENT * u::<R>();
                let secondaire = rayon.secondaire(&touche, soleil);
                refus += u32::from(secondaire.is_err());
                let ombre = rayon.vers_soleil(&touche, soleil);
                assert_eq!(ombre.is_some(), de_face && secondaire.is_ok());
                let Some((ombre, distance)) = ombre else {
                    sombres += 1;
                    continue;
                };
                assert!(distance == R::INFINI && bits(&ombre) == bits(&secondaire.unwrap()));
                assert!(!est_occulte(&[objet], &ombre, distance), "{objet:?} {rayon:?}");
                clairs += 1;
            }
            for nulle in [Vecteur::NUL, arrondi(Vecteur::new(f64::NAN, 0.0, 1.0))] {
                assert_eq!(rayon.vers_soleil(&touche, nulle), None);
            }
        }
    }
    println!("{clairs} lit, {sombres} dark, {refus} refused");
    assert!(clairs > 5_000 && sombres > 8_000 && refus > 100);
}

en_f32_et_f64!(le_soleil_eclaire_ce_qui_lui_fait_face);
