//! What a lemma needs beside the constant that grants it, and both beside `besoins.txt`, which has the domain of the
//! promise too: a proof over a part of it would prove less than the page says.

use crate::intervalle::{Intervalle, de_a, portee};

/// u of `f32` and of `f64`.
pub(crate) const U: [f64; 2] = [f32::EPSILON as f64 / 2.0, f64::EPSILON / 2.0];

/// A row: what is needed and granted, and the domain, one pair of ends for each variable.
struct Ligne {
    quoi: String,
    nombres: [f64; 2],
    domaine: Vec<[&'static str; 2]>,
}

fn lignes() -> impl Iterator<Item = Ligne> {
    include_str!("besoins.txt").lines().skip(1).map(|ligne| {
        let cases: Vec<_> =
            ligne.split("  ").map(str::trim).filter(|case| !case.is_empty()).collect();
        let [lemme, quoi, besoin, accorde, ref reste @ ..] = cases[..] else { panic!("{ligne}") };
        let domaine = reste.first().filter(|case| case.starts_with('[')).unwrap_or(&"");
        let bouts = |x: &'static str| x.trim_end_matches([']', ' ']).split_once(' ').unwrap();
        Ligne {
            quoi: format!("{lemme} {quoi}"),
            nombres: [besoin, accorde].map(|x| x.parse().unwrap_or_else(|_| panic!("{ligne}"))),
            domaine: domaine.split('[').skip(1).map(|x| bouts(x).into()).collect(),
        }
    })
}

#[track_caller]
fn ligne(quoi: &str) -> Ligne {
    lignes().find(|ligne| ligne.quoi == quoi).unwrap_or_else(|| panic!("besoins.txt has no {quoi}"))
}

/// An end of a domain, such as 1, 3.1u, u², 1/64u or 1+4√u.
fn bout(texte: &str, u: f64) -> f64 {
    let facteur = |texte: &str| {
        let puissances = [("√u", u.sqrt()), ("u²", u * u), ("u", u), ("", 1.0)];
        let (nombre, puissance) = puissances
            .into_iter()
            .find_map(|(fin, x)| Some((texte.strip_suffix(fin)?, x)))
            .unwrap();
        puissance * if nombre.is_empty() { 1.0 } else { nombre.parse().expect(texte) }
    };
    let quotient = |texte: &str| {
        let (a, b) = texte.split_once('/').unwrap_or((texte, "1"));
        facteur(a) / facteur(b)
    };
    texte.split('+').map(quotient).sum()
}

/// Each row can be read, has another name, and is asked for by a test; and no constant is less than its need.
#[test]
fn la_table_des_besoins_se_lit() {
    let tests =
        [include_str!("budget.rs"), include_str!("constantes.rs"), include_str!("preuves.rs")];
    for Ligne { quoi, nombres: [besoin, accorde], .. } in lignes() {
        assert!(besoin <= accorde, "{quoi}");
        assert!(tests.iter().any(|test| test.contains(&format!("\"{quoi}\""))), "{quoi}");
        assert_eq!(lignes().filter(|autre| autre.quoi == quoi).count(), 1, "{quoi}");
    }
    assert!(lignes().count() > 60);
}

/// The domain of this row, which the test has as well.
#[track_caller]
pub(crate) fn sur<const N: usize>(quoi: &str, u: f64, domaine: [[f64; 2]; N]) -> [Intervalle; N] {
    let ecrit = ligne(quoi).domaine;
    assert_eq!(ecrit.len(), N, "{quoi}");
    for (ecrit, domaine) in ecrit.into_iter().flatten().zip(domaine.into_iter().flatten()) {
        let voulu = bout(ecrit, u);
        let ecart = (voulu - domaine).abs();
        assert!(ecart <= 1e-12 * voulu.abs(), "{quoi}: {domaine:e} is not {ecrit}");
    }
    domaine.map(|[bas, haut]| de_a(bas, haut))
}

/// Checks that this constant is no less than what is needed in either type, and no more than a ninth more, and that its
/// row in `besoins.txt` says both.
#[track_caller]
pub(crate) fn tenir(quoi: &str, constante: f64, besoin: impl Fn(f64) -> Intervalle) {
    let besoin = tenir_au_large(quoi, constante, besoin);
    assert!(
        besoin.bas > 0.9 * constante,
        "{constante} is too much for {quoi}: {besoin:?} would do"
    );
}

/// The same, where a constant may be larger.
#[track_caller]
pub(crate) fn tenir_au_large(
    quoi: &str,
    constante: f64,
    besoin: impl Fn(f64) -> Intervalle,
) -> Intervalle {
    let besoins = U.map(|u| {
        let besoin = besoin(u);
        assert!(besoin.haut <= constante, "{constante} is less than {} at u = {u:e}", besoin.haut);
        besoin
    });
    let besoin = besoins[0].max(besoins[1]);
    // The file has three digits.
    let (bas, haut) = (0.995 * besoin.bas, 1.005 * besoin.haut);
    let [ecrit, accorde] = ligne(quoi).nombres;
    assert_eq!(accorde, constante, "{quoi}");
    assert!(bas <= ecrit && ecrit <= haut, "{quoi} needs {besoin:?}, not {ecrit}");
    besoin
}

/// The same as `tenir`, where what is needed depends on variables of this domain.
#[track_caller]
pub(crate) fn tenir_sur<const N: usize>(
    quoi: &str,
    constante: f64,
    domaine: impl Fn(f64) -> [[f64; 2]; N],
    besoin: impl Fn(f64, [Intervalle; N]) -> Option<Intervalle>,
) {
    tenir(quoi, constante, |u| portee(sur(quoi, u, domaine(u)), constante, |x| besoin(u, x)));
}
