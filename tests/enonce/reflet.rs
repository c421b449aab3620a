//! The two rays of a hit that every renderer sends: the mirrored one, outside and inside, and the one to a sun.

use commun::hasard::{Hasard, pour_chaque};
use commun::oracle::Exact;
use commun::regimes::{Cas, direction, regimes};
use commun::tolerances::u;
use commun::{Bits, arrondi, en_f32_et_f64};
use lancer_rayon::pour_les_tests::{REDRESSE, TANGENT};
use lancer_rayon::{Monde, NoIntersection, ObjetRay, Rayon, Reel, Vecteur};

fn scalaire<R: Reel>(a: Vecteur<R>, b: Vecteur<R>) -> f64 {
    let terme = |a, b| &Exact::de(a) * &Exact::de(b);
    (&(&terme(a.x, b.x) + &terme(a.y, b.y)) + &terme(a.z, b.z)).vers_f64()
}

fn bits<R: Bits>(rayon: &Rayon<R>) -> [u64; 7] {
    let (s, d) = (rayon.source(), rayon.direction());
    [s.x, s.y, s.z, d.x, d.y, d.z, rayon.fin()].map(R::bits)
}

/// Of every shape in every regime: the mirrored ray never goes inward and never meets its object again, starts where
/// `secondaire` starts, is refused where that is, and is the ray of D − 2(D·N)N. (That such a ray could go inward is
/// not excluded by a bound; no case is known.)
fn un_reflet_ne_revient_pas<R: Bits>() {
    let [mut reflets, mut rasants, mut refus] = [0; 3];
    for regime in regimes::<R>() {
        pour_chaque(
            4_000,
            |alea| (regime.cas)(alea),
            |Cas { objet, rayon }| {
                let Ok(touche) = objet.intersection(&rayon) else { return };
                let (d, n) = (rayon.direction(), touche.normale());
                let droit = touche.secondaire(n);
                let reflet = match touche.reflechi(rayon.direction()) {
                    Ok(reflet) => reflet,
                    Err(erreur) => {
                        assert_eq!(droit.unwrap_err().champ, erreur.champ, "{objet:?} {rayon:?}");
                        refus += 1;
                        return;
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
                let naif = touche.secondaire(d - (n + n) * d.produit_scalaire(n)).unwrap();
                assert_eq!(bits(&naif), bits(&reflet));
                rasants += u32::from(-d.produit_scalaire(n).vers_f64() <= TANGENT * u::<R>());
                reflets += 1;
            },
        );
    }
    println!("{reflets} mirrored, {refus} refused, {rasants} within 3.2u of the tangent plane");
    assert!(reflets > 15_000 && refus > 100 && rasants > 100);
}

en_f32_et_f64!(un_reflet_ne_revient_pas);

/// From a way out a mirror sends the ray back in: where it does not graze, the mirrored ray goes inward, starts inside the
/// object, which it does not see, and leaves it again, a half-space alone excepted. Beside an edge of a box, and in a box
/// no thicker than the step, the start may lie beyond another face.
fn de_la_sortie_un_reflet_rentre<R: Bits>() {
    let [mut rentres, mut aux_aretes, mut minces, mut refus, mut rasants] = [0; 5];
    for regime in regimes::<R>() {
        pour_chaque(
            2_000,
            |alea| (regime.cas)(alea),
            |Cas { objet, rayon }| {
                let Ok(sortie) = objet.sortie(&rayon) else { return };
                let (d, n) = (rayon.direction(), sortie.normale());
                let le_long = d.produit_scalaire(n);
                assert!(le_long > R::ZERO, "{objet:?} {rayon:?}");
                let reflet = match sortie.reflechi(d) {
                    Ok(reflet) => reflet,
                    Err(erreur) => {
                        assert_eq!(sortie.secondaire(-n).unwrap_err().champ, erreur.champ);
                        refus += 1;
                        return;
                    }
                };
                assert_eq!(reflet.fin(), R::INFINI);
                let attendue = d.vers_f64() - n.vers_f64() * (2.0 * scalaire(d, n));
                let ecart = (reflet.direction().vers_f64() - attendue).longueur();
                assert!(ecart <= (16.0 + 8.0 + 2.0 * REDRESSE) * u::<R>(), "{ecart:e}");
                // Within rounding of the tangent plane a direction counts as outward.
                if le_long.vers_f64() <= (TANGENT + 8.0) * u::<R>() {
                    rasants += 1;
                    return;
                }
                assert!(scalaire(n, reflet.direction()) < 0.0, "{objet:?} {rayon:?}");
                assert_eq!(reflet.source(), sortie.secondaire(-n).unwrap().source());
                let dedans = objet.contient(reflet.source());
                let ressort = match objet {
                    // Downward it never leaves.
                    ObjetRay::Plan(_) => objet.sortie(&reflet) == Err(NoIntersection),
                    ObjetRay::Sphere(_) | ObjetRay::Boite(_) => objet.sortie(&reflet).is_ok(),
                };
                let revu = objet.intersection(&reflet).is_ok();
                if dedans && ressort && !revu {
                    rentres += 1;
                    return;
                }
                let ObjetRay::Boite(boite) = objet else {
                    panic!("{dedans} {ressort} {revu}: {objet:?} {rayon:?}");
                };
                let pas = (reflet.source() - sortie.point()).longueur().vers_f64();
                let f = (rayon.source() - boite.centre()).longueur() + boite.centre().longueur();
                let pres = pas + 16.0 * u::<R>() * (f + sortie.distance()).vers_f64();
                let (face, p) = boite.lieu(&rayon, &sortie);
                let (p, l) = (<[R; 3]>::from(p), boite.demi_longueurs().map(R::vers_f64));
                let axe = face as usize % 3;
                if l[axe] <= pres {
                    minces += 1;
                    return;
                }
                let mut autres = (0..3).filter(|i| *i != axe);
                let a_l_arete = autres.any(|i| l[i] * (1.0 - p[i].abs().vers_f64()) <= pres);
                assert!(a_l_arete, "{dedans} {ressort} {revu}: {boite:?} {rayon:?}");
                aux_aretes += 1;
            },
        );
    }
    println!(
        "{rentres} inward, {aux_aretes} beside an edge, {minces} in thin boxes, {rasants} grazing, {refus} refused"
    );
    assert!(rentres > 10_000 && aux_aretes < rentres / 10 && rasants > 10);
}

en_f32_et_f64!(de_la_sortie_un_reflet_rentre);

/// A sun shines on the side of a convex object that faces it, to 3.2u, and nowhere else: then nothing of the object is
/// in the way at any distance, and the ray is that of `secondaire`.
fn le_soleil_eclaire_ce_qui_lui_fait_face<R: Bits>() {
    let [mut clairs, mut sombres, mut refus] = [0; 3];
    for regime in regimes::<R>() {
        let faire = |alea: &mut Hasard| ((regime.cas)(alea), direction(alea));
        pour_chaque(2_000, faire, |(Cas { objet, rayon }, au_hasard)| {
            let Ok(touche) = objet.intersection(&rayon) else { return };
            let n = touche.normale();
            // In the tangent plane rounding decides.
            let tangente = au_hasard - n.vers_f64() * n.vers_f64().produit_scalaire(au_hasard);
            for soleil in [au_hasard * 1e3, tangente] {
                let soleil = arrondi::<R>(soleil);
                let Ok(vers) = Rayon::new(Vecteur::NUL, soleil) else { continue };
                let de_face = vers.direction().produit_scalaire(n).vers_f64() > TANGENT * u::<R>();
                let secondaire = touche.secondaire(soleil);
                refus += u32::from(secondaire.is_err());
                let ombre = touche.vers_soleil(soleil);
                assert_eq!(ombre.is_ok(), de_face && secondaire.is_ok());
                if let (Err(erreur), Ok(_)) = (&ombre, &secondaire) {
                    assert_eq!(erreur.champ, "soleil");
                }
                let Ok(ombre) = ombre else {
                    sombres += 1;
                    continue;
                };
                assert!(ombre.fin() == R::INFINI && bits(&ombre) == bits(&secondaire.unwrap()));
                assert!(!Monde::de_liste(&[objet]).est_occulte(&ombre), "{objet:?} {rayon:?}");
                clairs += 1;
            }
            for nulle in [Vecteur::NUL, arrondi(Vecteur::new(f64::NAN, 0.0, 1.0))] {
                assert!(touche.vers_soleil(nulle).is_err());
            }
        });
    }
    println!("{clairs} lit, {sombres} dark, {refus} refused");
    assert!(clairs > 5_000 && sombres > 8_000 && refus > 100);
}

en_f32_et_f64!(le_soleil_eclaire_ce_qui_lui_fait_face);
