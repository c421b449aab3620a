//! Doubled numbers themselves (`docs/preuves/objets.md`, lemma 16): a climb on the bits of a few numbers, towards the
//! largest error of their sums and products as a part of its bound. `est_certain` would show such an error only in a
//! decision within 2⁻¹⁰⁰, which no search among scenes finds.

use commun::cas;
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::oracle::Exact;
use commun::regimes::signe;
use fastrand::Rng;
use lancer_rayon::pour_les_tests::{Double, Intervalle};

/// An operation on two of the numbers so far, which their places name.
#[derive(Debug, Clone, Copy)]
enum Pas {
    Plus(usize, usize),
    Fois(usize, usize),
    /// The number minus what an `f64` holds of it, so that all that is left is rounding.
    Reste(usize),
}

/// The largest error of any number on the way, as a part of its bound; `None` if a number overflows.
fn part(feuilles: &[f64], pas: &[Pas]) -> Option<f64> {
    let mut nombres: Vec<(Double, Exact)> =
        feuilles.iter().map(|&x| (Double::de(x), Exact::de(x))).collect();
    let mut pire: f64 = 0.0;
    for &pas in pas {
        let (double, exact) = match pas {
            Pas::Plus(i, j) => (nombres[i].0.plus(nombres[j].0), &nombres[i].1 + &nombres[j].1),
            Pas::Fois(i, j) => (nombres[i].0.fois(nombres[j].0), &nombres[i].1 * &nombres[j].1),
            Pas::Reste(i) => {
                let x = -nombres[i].0.haut;
                (nombres[i].0.plus(Double::de(x)), &nombres[i].1 + &Exact::de(x))
            }
        };
        let Double { haut, bas, erreur } = double;
        if !(haut.is_finite() && erreur.is_finite()) {
            return None;
        }
        assert!(bas.abs() <= haut.abs() * (f64::EPSILON / 2.0), "{double:?} {feuilles:?}");
        let ecart = (&(&exact - &Exact::de(haut)) - &Exact::de(bas)).vers_f64().abs();
        pire = pire.max(if ecart <= erreur { ecart / erreur } else { f64::INFINITY });
        let Intervalle { bas, haut } = double.bornes();
        let (au_moins, au_plus) = (Exact::de(bas), Exact::de(haut));
        assert!(au_moins <= exact && exact <= au_plus, "{double:?} {feuilles:?}");
        nombres.push((double, exact));
    }
    Some(pire)
}

/// A number of a scene, of full length or of a few bits, from 2^−`etendue` to 2^`etendue`.
fn feuille(alea: &mut Rng, etendue: i32) -> f64 {
    let exposant = alea.i32(-etendue..=etendue);
    let bits = if alea.bool() { alea.u64(..) } else { alea.u64(..8) << 49 };
    let un_a_deux = f64::from_bits((1023 << 52) | (bits >> 12) | (bits & (0xf << 49)));
    un_a_deux * f64::from(exposant).exp2() * if alea.bool() { 1.0 } else { -1.0 }
}

/// Some steps, each with any two of the numbers so far, preferably the last.
fn programme(alea: &mut Rng, feuilles: usize) -> Vec<Pas> {
    (feuilles..feuilles + 6)
        .map(|nombre| {
            let mut un = || nombre - 1 - alea.usize(..nombre).min(alea.usize(..nombre));
            let (i, j) = (un(), un());
            *alea
                .choice(&[Pas::Plus(i, j), Pas::Fois(i, j), Pas::Fois(i, i), Pas::Reste(i)])
                .unwrap()
        })
        .collect()
}

#[test]
fn aucune_somme_et_aucun_produit_ne_sort_de_sa_borne() {
    let mut alea = Rng::with_seed(18);
    let mut pires = [0.0; 3];
    for essai in 0..cas(4_000) {
        let etendue = [3, 60, 537][essai as usize % 3];
        let mut feuilles: Vec<f64> = (0..4).map(|_| feuille(&mut alea, etendue)).collect();
        let pas = programme(&mut alea, feuilles.len());
        let Some(mut mieux) = part(&feuilles, &pas) else { continue };
        for _ in 0..100 {
            let (i, bit) = (alea.usize(..feuilles.len()), alea.u32(..53));
            let avant = feuilles[i];
            feuilles[i] = f64::from_bits(avant.to_bits() ^ (1 << bit));
            match part(&feuilles, &pas) {
                Some(part) if part >= mieux => mieux = part,
                _ => feuilles[i] = avant,
            }
            assert!(mieux <= 1.0, "{mieux} {feuilles:?} {pas:?}");
        }
        let pire = &mut pires[essai as usize % 3];
        *pire = f64::max(*pire, mieux);
    }
    // The bounds are not loose either: for numbers of one size, of many and of all, some error exceeds half of its
    // bound.
    assert!(pires.iter().all(|pire| *pire > 0.5), "{pires:?}");
}

/// What the sum of the low parts rounds by counts, also where the rest of the high parts cancels
/// that sum: 1 − 2⁻⁵⁴ and 2⁻⁵⁴ + 2⁻¹⁰⁹ are 1 + 2⁻¹⁰⁹, of which 1 is left.
#[test]
fn ce_que_perdent_les_parties_basses_est_compte() {
    let peu = (-54_f64).exp2();
    let [x, y] = [(1.0, -peu), (peu, 0.5 * peu * peu)];
    let [x, y] = [x, y].map(|(haut, bas)| Double { haut, bas, erreur: 0.0 });
    let Double { haut, bas, erreur } = x.plus(y);
    assert_eq!((haut, bas), (1.0, 0.0));
    assert!(erreur >= 0.5 * peu * peu, "{erreur:e}");
}

/// The bounds hold also where a number is about as large as its bound, which is where a sign is decided.
#[test]
fn les_bornes_tiennent_le_nombre_et_son_erreur() {
    let faire = |alea: &mut Hasard| {
        let haut = (1.0 + alea.f64()) * signe(alea) * f64::from(alea.i8(-3..=3)).exp2();
        let bas = haut * alea.f64() * (f64::EPSILON / 2.0);
        let erreur = haut.abs() * (1.0 + f64::from(alea.i8(-2..=2)) * f64::EPSILON);
        Double { haut, bas, erreur }
    };
    pour_chaque(cas(4_000), faire, |double| {
        let Double { haut, bas, erreur } = double;
        let milieu = &Exact::de(haut) + &Exact::de(bas);
        let Intervalle { bas: au_moins, haut: au_plus } = double.bornes();
        assert!(Exact::de(au_moins) <= &milieu - &Exact::de(erreur));
        assert!(Exact::de(au_plus) >= &milieu + &Exact::de(erreur));
    });
}

/// A ray along a face is judged by products that are 0, or exact.
#[test]
fn ce_qui_est_exact_le_reste() {
    let [trois, tiers, nul] = [3.0, 1.0 / 3.0, 0.0].map(Double::de);
    for (double, exact) in
        [(trois.fois(trois), 9.0), (tiers.fois(nul), 0.0), (trois.plus(nul), 3.0)]
    {
        let Intervalle { bas, haut } = double.bornes();
        assert_eq!((double.erreur, bas, haut), (0.0, exact, exact));
    }
    assert!(trois.fois(tiers).erreur > 0.0);
}
