//! The constants of the proofs beside the numbers that their lemmas need: `docs/preuves`. Letters are those of these
//! pages, unless another source is named.
//!
//! What a lemma needs is computed in intervals over its whole domain, for both types (`besoins.rs`). A constant must be at
//! least that, and at most a ninth more: a constant made a tenth smaller fails. Exceptions are
//! - `PAS_NORMAL`, which fails at 0.87, and `FLOU_PROPRE`, `FLOU_A_COTE`, `FLOU_DISTANCE` and `BORD`, which have room;
//! - the limits of a sphere that is lost, which are limits of a domain; what direction, what matrix and what parallel
//!   directions are kept or refused, which are decisions (C13, C15);
//! - powers of two, which lemmas 2, 8, 18, 20 and 21 compare with what is lost below the normal numbers;
//! - the third comparison that lemma 6 grants between an entry and an exit, of which lemma 3 needs two;
//! - the 8u that M4 adds at a hit at once, which no proof needs, the 64 of J7, a choice, the 2u of E1 and J8, which count
//!   roundings, and the 2 of T3, of which lemma 19 needs 1.1.
//!
//! How often a step of an algorithm rounds is read from tapes (`etapes.rs`), and what distances need is proved from them
//! (`preuves.rs`). Taken from the text, and not found here:
//! - what a rounding is relative to, and how often doubled numbers, judgements and probes round;
//! - what is of second order in u, where the text says "to O(u²)": one factor such as `plus(20.0,
//!   u)` stands for all of it, larger than what was counted by hand;
//! - lemma 3: that two comparisons at most lie between an entry and an exit; lemma 4: that k speeds
//!   of which all are v or more have v ≤ 1/√k;
//! - lemma 8: that nearer than |f| = 2r no sphere is lost;
//! - lemma 9: that M5 turns no refracted ray by more than the bound has to spare;
//! - lemma 13: that a matrix made of sines and cosines, or of one direction, is orthonormal to 90u
//!   before its Newton step, and of a quaternion or several directions to 200u;
//! - lemma 21: that what is subnormal is less than the slack.

use crate::besoins::{U, sur, tenir, tenir_au_large, tenir_sur};
use crate::etapes::compte;
use crate::intervalle::{Intervalle, de_a, i, portee, positif, sinus};
use commun::tolerances::{ECART_ROTATION, ORTHONORMALE, ORTHONORMALE_GARDEE, bandes, promesses};
use lancer_rayon::Nombre;
use lancer_rayon::pour_les_tests::*;

/// |D|² − 1, in u.
const D2: f64 = 15.1;

/// |D| − 1, in u.
const D1: f64 = promesses::UNITAIRE_D;

/// |N|² − 1 of a flat face, in u.
const N2: f64 = ORTHONORMALE_GARDEE;

/// |N| − 1 of a sphere, in u.
const N1: f64 = promesses::UNITAIRE_SPHERE;

/// What lost products weigh beside r² where r is smallest, in u·r²: three, each at most 1/64 (lemma 2).
const PERDU: f64 = 3.0 / 64.0;

/// What lost products weigh beside a length or its error where r is smallest, in u·r: 2η/(2⁻⁶⁰·u)
/// (lemma 2).
const PERDU_LONGUEUR: f64 = 1.0 / (1_u64 << 60) as f64;

/// What lemma 6 grants the point of a hit, in u·|f| and then in u·ρ.
const TOUCHE_F: f64 = 27.0;
const TOUCHE_RHO: f64 = 60.0;

/// γ_n = nu/(1 − nu), in u.
pub(crate) fn gamma(n: f64, u: f64) -> Intervalle {
    i(n) / (1.0 - i(n) * u)
}

/// How often a step rounds a product of these letters at most, read from its tape, as in "S3 r²: r r".
#[track_caller]
pub(crate) fn fois(ligne: &str) -> f64 {
    let (etape, produit) = ligne.split_once(": ").expect("a step and a product");
    compte(etape, produit)
}

/// A sum of three squares.
pub(crate) fn carre() -> f64 {
    fois("S1 D²: D D")
}

/// A scalar product.
pub(crate) fn scalaire() -> f64 {
    fois("H1 v: D N")
}

/// The roundings after a product in a scalar product.
fn sommes() -> f64 {
    scalaire() - fois("S3 r²: r r")
}

/// A difference of two terms.
pub(crate) fn difference() -> f64 {
    fois("S4 AB²: AC²")
}

/// SC², with an S − C that rounds.
fn sc2_arrondi() -> f64 {
    fois("S3 SC²: SC SC") + 2.0 * fois("S1 SC: S")
}

/// r²·D².
fn r2_d2() -> f64 {
    fois("S4 r²D²: D D r r")
}

/// The last sum of the height over a flat face, and the quotient.
pub(crate) fn conclue() -> f64 {
    assert_eq!(fois("H1 e: d") + fois("H3 t: / e"), fois("B1 l±f_i: l") + fois("B5 t: / l±f_i"));
    fois("H1 e: d") + fois("H3 t: / e")
}

/// A length over D².
fn sur_d2() -> f64 {
    fois("S1 D²: D D") + fois("W2 s/D²: / s")
}

/// SA/D², with an S − C that does not round.
fn sa_sur_d2() -> f64 {
    fois("S2 SA: D SC") + sur_d2()
}

/// (1 + a·u)(1 + b·u) − 1, in u.
fn et(a: Intervalle, b: Intervalle, u: f64) -> Intervalle {
    a + b + a * b * u
}

/// In u, a bound of 1 − 1/(1 + a·u), and exactly 1/(1 − a·u) − 1.
fn inverse(a: Intervalle, u: f64) -> Intervalle {
    a / (1.0 - a * u)
}

/// 1 + a·u.
pub(crate) fn plus(a: impl Into<Intervalle>, u: f64) -> Intervalle {
    1.0 + a.into() * u
}

/// 1 − a·u.
fn moins(a: impl Into<Intervalle>, u: f64) -> Intervalle {
    1.0 - a.into() * u
}

/// (1 + u)/(1 − u) − 1, in u.
fn rapport(u: f64) -> Intervalle {
    2.0 / moins(1.0, u)
}

/// √(1 + a·u) − 1, in u, in a form that does not cancel.
fn racine(a: impl Into<Intervalle>, u: f64) -> Intervalle {
    let a = a.into();
    a / (1.0 + plus(a, u).racine())
}

/// The domain of a part or of a cosine.
fn zero_a_un(_: f64) -> [[f64; 2]; 1] {
    [[0.0, 1.0]]
}

/// 1/√(1 − γ₃) · (1 + u)/(1 − u) − 1, in u: a vector over its length.
fn normalise(u: f64) -> Intervalle {
    et(racine(inverse(gamma(carre(), u), u), u), rapport(u), u)
}

#[test]
fn lemme_1_les_bornes_des_vecteurs_unitaires_suffisent() {
    // The CB of a sphere is not scaled: three products of CB², which is r²/2 at least, may be lost.
    tenir("1 |N| of a sphere", N1, |u| et(normalise(u), PERDU * plus(8.0, u), u));
    for u in U {
        // The decision C13 keeps whatever was normalised.
        let n2 = et(normalise(u), normalise(u), u);
        assert!((et(n2, gamma(carre(), u), u) * plus(1.0, u)).haut <= DEJA_UNITAIRE);
    }
    let d2 = |u| {
        (DEJA_UNITAIRE * plus(1.0, u) + gamma(carre(), u)) * plus(inverse(gamma(carre(), u), u), u)
    };
    tenir("1 |D|²", D2, d2);
    tenir("1 |D|", D1, |u| racine(D2, u));
    // In f64 the elements of M·Mᵀ − I are themselves only computed to γ₃.
    tenir("1 M·Mᵀ", N2, |u| {
        DEJA_ORTHONORMALE * plus(1.0, u) + gamma(fois("M·Mᵀ: M M"), u) * plus(N2, u)
    });
    tenir("1 |N| of a face", promesses::UNITAIRE_PLATE, |u| racine(N2, u) * plus(N2, u));
}

/// The largest |N| of a flat face.
fn n(u: f64) -> Intervalle {
    plus(promesses::UNITAIRE_PLATE, u)
}

/// The largest |D|.
fn d(u: f64) -> Intervalle {
    plus(D1, u)
}

/// How far a speed N·D towards a flat face is off, in u.
fn vitesse(u: f64) -> Intervalle {
    gamma(scalaire(), u) * n(u) * d(u)
}

/// How far SC² as computed, rounded once more, is off, in u·f².
fn sc2(u: f64) -> Intervalle {
    et(gamma(sc2_arrondi(), u), i(1.0), u)
}

/// How far AC is off, in u·f, by S − C and by the coordinates of SC ∧ D.
fn autour_de_ac() -> Intervalle {
    1.0 + i(4.0 / 3.0).racine()
}

#[test]
fn lemme_3_les_bandes_suffisent() {
    tenir("3 height", bandes::PLAN, |u| gamma(fois("H1 N·S: N S"), u));
    tenir("3 height, η", bandes::PLAN_ABSOLUE, |u| 0.5 * scalaire() * plus(gamma(sommes(), u), u));
    // Rounded speeds add 2⁻⁷⁸.
    tenir("3 speed", bandes::VITESSE, |u| vitesse(u) + (-78_f64).exp2());
    tenir_sur("3 box", bandes::BOITE_LONGUEUR, zero_a_un, |u, [f]| {
        let rho = 1.0 - f;
        let o = f * n(u);
        // Two comparisons in a row; each of the two lengths takes half of their rounding errors.
        let compare = et(rapport(u), rapport(u), u) * 0.5;
        let longueur = rho + o * plus(gamma(fois("B1 f_i: N S"), u), u);
        Some(gamma(fois("B1 f_i: N S"), u) * o + et(i(1.0), compare, u) * longueur)
    });
    // Where AB² has the wrong sign, AC, seen from 1 away, is off the radius y by no more than C′ and S4 are off. This is
    // of a vector, so that no sphere is too small for it.
    tenir_au_large("3 small sphere", bandes::SPHERE, |u| {
        portee(sur("3 small sphere", u, [[0.0, 1.0]]), bandes::SPHERE, |[y]| {
            let ac = y * plus(10.0, u) + 4.0 * u;
            let carres = 0.5 * (fois("S4 AC²: AC AC") + 2.0) * ac + 0.5 * r2_d2() * y;
            Some((autour_de_ac() + carres) / (1.0 + y) * plus(60.0, u))
        })
    });
}

/// What is lost below the normal numbers; `preuves.rs` has the rest.
#[test]
fn lemme_4_ce_qui_est_perdu_suffit() {
    tenir("4 half-space, η", promesses::PLAN_ABSOLU, |u| {
        let g = plus(gamma(conclue(), u), u);
        0.5 * scalaire() * plus(gamma(sommes(), u), u) * g + 0.5 * n(u) * d(u)
    });
}

/// A bound fails.
#[track_caller]
pub(crate) fn ne_suffit_pas(borne: impl FnOnce() -> Intervalle + std::panic::UnwindSafe) {
    let echec = std::panic::catch_unwind(borne).unwrap_err().downcast::<String>().unwrap();
    assert!(echec.contains(" is more than "), "{echec}");
}

/// Smaller parts and lengths do not do, nor a lower limit of what is lost.
#[test]
fn lemmes_8_et_9_moins_ne_suffit_pas() {
    let u = U[0];
    ne_suffit_pas(|| marges_d_une_sphere(u, [0.9 * PAR_RAYON, LONGUEUR]));
    ne_suffit_pas(|| marges_d_une_sphere(u, [PAR_RAYON, 0.9 * LONGUEUR]));
    let perdue = 0.9 * promesses::PERDUE;
    let domaine = [de_a(2.0, 1.0 / (perdue * u)), de_a(0.0, 1.05)];
    ne_suffit_pas(|| portee(domaine, 1.0, |x| sphere_non_perdue(u, perdue, false, x)));
}

#[test]
fn lemme_7_les_bornes_d_une_normale_suffisent() {
    // y = f/r; the error of the distance is at most K·u·κt, with κt ≤ (1 + 2y)/c.
    let domaine = |u| [[1.0, 1.0 / (promesses::PERDUE * u)]];
    let k_kappa_t = |u: f64, y: Intervalle| promesses::DISTANCE_SPHERE * u * (1.0 + 2.0 * y);
    // The part along D of a normal that does not face the source. t is at most A to 9u·f, CB is off by 2u·f more, and c
    // is at most the errors of both and the rounding error of N·D.
    let part = |u: f64, y: Intervalle| {
        let c2 = k_kappa_t(u, y) + u * (2.0 * y + 9.0);
        (11.0 * y * u + 4.0 * u) / ((1.0 - c2).racine() - 4.0 * y * u)
    };
    tenir_sur("7 direction", promesses::DIRECTION, domaine, |u, [y]| {
        // Outside the band c² > 4u(1 + y).
        let c = (bandes::SPHERE * u * (1.0 + y)).racine();
        let z = k_kappa_t(u, y) / c;
        assert!(z.bas < 1.0, "the distance is off by more than r");
        let cb = fois("S7 CB: S") * y * plus(4.0, u) + z + fois("S7 N: / CB");
        let penchee = 4.0 + 2.0 * part(u, y);
        Some((cb + 1.0 + penchee) / (1.0 + y) * plus(8.0, u))
    });
    let le_long = 0.25;
    for u in U {
        assert!(
            portee(sur("7 direction", u, domaine(u)), le_long, |[y]| Some(part(u, y))).haut
                <= le_long
        );
    }
    // How far N·D is off. The part along D takes γ₃ and u of N·D, 8u of that part and the product, over the length of
    // what is left. Then come the difference, two quotients and a difference, and γ₃ to compute N·D.
    let de_n_d = |u: f64| {
        let reste =
            (gamma(scalaire(), u) + 1.0 + 9.0 * le_long) / i(1.0 - le_long * le_long).racine();
        et(et(reste, i(4.0), u), gamma(scalaire(), u), u) * plus(8.0, u)
    };
    tenir("7 lean", PENCHE, de_n_d);
    for u in U {
        // It leans less than the true normal, whose c² > 8u outside the band.
        assert!((PENCHE + de_n_d(u).haut) * u < (2.0 * bandes::SPHERE * u).sqrt());
    }
}

/// How much of a margin a flat face leaves for each unit of its height.
fn marge_plate(u: f64) -> Intervalle {
    // A sum, a product and a sum.
    moins(1.0, u) * (1.0 + VERS_LE_HAUT * u * moins(1.0, u)) * moins(1.0, u)
}

#[test]
fn lemme_8_la_marge_d_une_face_suffit() {
    tenir("8 10u of M4", VERS_LE_HAUT, |u| {
        // (1 + u)/(√(1 − 12u)·(1 − u)²) − 1.
        let n = racine(inverse(i(N2), u), u);
        let un = inverse(i(1.0), u);
        et(et(et(i(1.0), n, u), un, u), un, u) * plus(un, u)
    });
}

/// The height of P, the way outward and the way inward, as parts of what the margin of a sphere of radius 1 grants.
/// `puissance` is |CP² − r²| as computed, of sign `signe`, `q` is the part of CP across N, and `e` is the rounding of
/// P.
fn marge_d_une_sphere(
    u: f64,
    [par_rayon, longueur]: [f64; 2],
    signe: f64,
    [puissance, q, e]: [Intervalle; 3],
) -> [Intervalle; 3] {
    let g = |k| gamma(k, u) * u;
    let b = par_rayon * (puissance + q.carre()) + e.carre();
    // Three products of the margin may be lost.
    let marge = (b * (1.0 - g(fois("M3 b: / x²") + fois("M3 x²: x x"))) - PERDU * u
        + 2.0 * ARRONDI_HAUTEUR * longueur * u * (1.0 - g(fois("M3 ℓ: r"))))
        * marge_plate(u);
    let pas = marge
        * plus(PAS_NORMAL, u)
        * (1.0 - g(fois("M6 pas: marge") + fois("M6 S′: N pas")))
        * moins(N1 + 1.0, u);
    // The errors of what was computed.
    let puissance =
        (puissance + g(fois("M3 g: P P") - difference()) * (1.0 + puissance) + u + PERDU * u)
            * plus(rapport(u), u);
    let e = e * plus(4.0, u) + 2.1 * u;
    let q2 = (q * plus(1.5, u) + 2.7 * u).carre() + PERDU * u;
    let (q, ecart) = (q2.racine(), signe * puissance);
    let le_long = (1.0 + ecart - q2).racine();
    let hauteur = puissance / (le_long + (1.0 - q2).racine());
    let f = (1.0 + (q + e).carre()).racine();
    let r2 = et(gamma(r2_d2(), u), inverse(gamma(r2_d2(), u), u), u) + PERDU;
    let ac = (racine(r2, u) + autour_de_ac() * f) * u;
    let dehors = (ac * (2.0 + ac) - ecart + q2) / (1.0 + ac + le_long);
    let six = (sc2(u) + PERDU) * u;
    let dedans =
        (ecart + six + e * (2.0 * q + e)) / (le_long + (1.0 - six - (q + e).carre()).racine());
    [hauteur / marge, dehors / pas, dedans / pas]
}

fn marges_d_une_sphere(u: f64, constantes: [f64; 2]) -> Intervalle {
    let domaine =
        [[0.0, PUISSANCE_PERDUE], [0.0, TRAVERS_PERDU.sqrt().next_up()], [0.0, ARRONDI_PERDU]];
    let [puissance, q, e] = sur("8 sphere, margin", u, domaine);
    // Height and way outward, without e, of which the margin grants more than it costs.
    let [a, b] = [1.0, -1.0].map(|signe| {
        portee([puissance, q], 1.0, |[puissance, q]| {
            let [h, dehors, _] = marge_d_une_sphere(u, constantes, signe, [puissance, q, i(0.0)]);
            Some(h.max(dehors))
        })
    });
    // The way inward, from a P on the sphere: a P beyond the sphere adds less of the power than the margin grants, and
    // one within takes from it.
    let racines = (1.0 - q.carre()).racine() + (1.0 - (q + e).carre() - 7.0 * u).racine();
    assert!((1.0 / racines).haut < 0.97 * constantes[0]);
    let dedans = portee([q, e], 1.0, |[q, e]| {
        Some(marge_d_une_sphere(u, constantes, 1.0, [i(0.0), q, e])[2])
    });
    a.max(b).max(dedans)
}

#[test]
fn lemmes_8_et_9_la_marge_d_une_sphere_suffit() {
    tenir("8 sphere, margin", 1.0, |u| marges_d_une_sphere(u, [PAR_RAYON, LONGUEUR]));
}

/// What |CP² − r²|, x² and y reach for a sphere of radius 1 with r ≥ 64u|f| + 16u‖P‖₁, as parts of the limits beyond
/// which the sphere is lost. `sort` means where the ray leaves, and `k` is AC. None where the ray misses.
fn sphere_non_perdue(
    u: f64,
    perdue: f64,
    sort: bool,
    [f, k]: [Intervalle; 2],
) -> Option<Intervalle> {
    let a = u * f;
    let g = |k| gamma(k, u) * u;
    let g_ac = i(4.0 / 3.0).racine() * a + PERDU_LONGUEUR * u;
    let ac2 =
        et(gamma(fois("S4 AC²: AC AC"), u), et(i(1.0), i(1.0), u), u) * u * (k + g_ac).carre()
            + g_ac * (2.0 * k + g_ac);
    let w = 1.0 - k.carre();
    let dw = g(r2_d2()) + PERDU * u + ac2 + u * w.grandeur();
    if (w + dw).haut <= 0.0 {
        return None;
    }
    let beta = positif(w + dw).racine();
    let (b, p) = ((f.carre() - k.carre()).racine(), f.carre() - 1.0);
    // ψ (lemma 6).
    let dp = (g(fois("S3 SC²: SC SC")) * f.carre() + u + PERDU * u) * plus(1.0, u) + u * p;
    let dq = (g(fois("S2 SA: D SC")) * f + PERDU_LONGUEUR * u + u * beta) * plus(2.0, u)
        + u * (b + beta);
    let e = if sort {
        // SA, the root, the sum, D² and the quotient.
        dq + gamma(sur_d2(), u) * u * (b + beta) * plus(8.0, u)
    } else {
        (dw + dp * plus(1.0, u) + u * p + b * dq) / (b - dq)
    };
    // Where t̂ is SA/D², β is no more than e and 8u·f.
    let loin = (dw + 2.0 * beta * e + e.carre()).max(dw + (g(sa_sur_d2()) * f).carre());
    let pres = dw + (2.0 * beta * e).max((e + g(sa_sur_d2() + fois("S1 SC: S")) * f).carre());
    // y, and the rounding of P and of S − C.
    let y = (1.0 - perdue * a) * ARRONDI_PERDU;
    let arrondi = 2.0 * a * plus(16.0, u) + y * plus(2.0, u);
    let dessus = ((1.0 + loin).racine() + arrondi).carre() - 1.0;
    let dessous = 1.0 - ((1.0 - pres).racine() - arrondi).carre();
    let puissance = (dessus.max(dessous) + 20.0 * u) / PUISSANCE_PERDUE;
    // A leaned N is across the ray, and P is beyond A by at most 10u·f.
    let x = 13.0 * a * plus(16.0, u) + y + 32.0 * u;
    let y = y * plus(8.0, u) / ARRONDI_PERDU;
    Some(puissance.max(x.carre() / TRAVERS_PERDU).max(y))
}

#[test]
fn lemme_8_la_marge_d_une_sphere_non_perdue_est_finie() {
    let perdue = promesses::PERDUE;
    let domaine = |u| [[2.0, 1.0 / (perdue * u)], [0.0, 1.05]];
    tenir_sur("8 sphere, not lost", 1.0, domaine, |u, x| sphere_non_perdue(u, perdue, false, x));
    // At once P is S, and the power of a depth h is (2 − h)h.
    let profonde = 1.0 - (1.0 - i(PUISSANCE_PERDUE)).racine();
    assert!(profonde.bas > promesses::D_EMBLEE_PERDUE);
    assert!(profonde.haut < 1.05 * promesses::D_EMBLEE_PERDUE);
}

#[test]
fn lemmes_8_et_9_le_pas_depuis_une_face_suffit() {
    // What 2·`arrondi`·u·ℓ must pay in excess of what it is, in u: twice (1 + u)⁴ − 1, by which N·(P − C) as computed
    // is off, for the height of P and for the next search.
    let exces = |u: f64, arrondi: f64, pas: f64| {
        assert_eq!(fois("M2 b box: N P") - difference(), 4.0);
        let quatre = et(i((4.0 / arrondi - 1.0) / u), 0.25 * (6.0 + 4.0 * i(u) + i(u) * u), u);
        // ℓ; two sums of the margin; a product and a sum, N·pas, the sum with P; an N² up to 12u less than 1; what the
        // next search sees of the step.
        let pertes = [1.0, 1.0, 1.0, 1.0, fois("M6 S′: N pas"), N2, fois("B1 f_i: N S")]
            .map(|perte| inverse(gamma(perte, u), u));
        let pertes = pertes
            .into_iter()
            .fold(inverse(gamma(fois("M2 ℓ box: N P"), u), u), |a, b| et(a, b, u));
        et(quatre, pertes, u) - et(VERS_LE_HAUT * moins(1.0, u), i(pas), u)
    };
    for u in U {
        assert!(exces(u, ARRONDI_HAUTEUR, PAS_NORMAL).haut <= 0.0);
        assert!(exces(u, 0.9 * ARRONDI_HAUTEUR, PAS_NORMAL).bas > 0.0, "less would do");
        assert!(exces(u, ARRONDI_HAUTEUR, 0.87 * PAS_NORMAL).bas > 0.0, "less would do");
        // The height itself is rounded once.
        assert!(
            (exces(u, 4.0, PAS_NORMAL) - gamma(fois("M2 b box: N P") - difference(), u) + 1.0).haut
                < 0.0
        );
    }
    // What is lost below the normal numbers, in η: three products of the height and three of the height that the next
    // search sees, the products by 8u, 10u, 1 + 20u and 1.1u, and N·pas along N.
    let perdu = 1.5 + 1.5 + 4.0 * 0.5 + 0.5 * i(3.0).racine();
    assert!(perdu.haut * f64::from(f32::ETA) < PLANCHER.0);
    assert!(perdu.haut * f64::ETA < PLANCHER.1);
    // The margin over a floor through O is `PLANCHER`, and u of it is a normal number. Beside the margin of the
    // smallest sphere it is less than a hundred thousandth.
    let moindre = |u: f64, limite: f64| 2.0 * ARRONDI_HAUTEUR * LONGUEUR * u / limite;
    assert!(
        PLANCHER.0 * U[0] >= f64::from(f32::MIN_POSITIVE) && PLANCHER.1 * U[1] >= f64::MIN_POSITIVE
    );
    assert!(PLANCHER.0 < 1e-5 * moindre(U[0], f32::LIMITE.into()));
    assert!(PLANCHER.1 < 1e-5 * moindre(U[1], f64::LIMITE));
    tenir("9 weights of M6", PAS_ARRONDI, |u| {
        plus(1.0, u) / ((1.0 - gamma(fois("M6 pas: N P"), u) * u) * moins(N2, u))
    });
}

#[test]
fn lemme_9_un_rayon_redresse_sort() {
    tenir("9 tangent", TANGENT, vitesse);
    tenir("9 M5", REDRESSE, |u| {
        (TANGENT + 2.0 * vitesse(u) + 2.0 * n(u) * d(u)) * plus(3.0 * N2, u)
    });
}

#[test]
fn lemme_9_la_borne_d_un_reflet_suffit() {
    // c is the cosine of the angle of incidence; N·D rounds by γ₃, and N² is off from 1 by `n2`.
    let besoin = |n2: f64| {
        move |u: f64, [c]: [Intervalle; 1]| {
            let s = sinus(c);
            let le_long = 2.0 * gamma(scalaire(), u) + 2.0 * n2 * c;
            Some((s * le_long + 2.0 * c + 2.0) * plus(60.0, u))
        }
    };
    tenir_sur("9 mirror, flat", promesses::REFLECHI_PLAT, zero_a_un, besoin(N2));
    tenir_sur("9 mirror, sphere", promesses::REFLECHI_SPHERE, zero_a_un, besoin(2.0 * N1));
    // M5: the lean, its sum and its quotient.
    tenir("9 mirror, turned", promesses::REFLECHI_REDRESSE, |_| i(REDRESSE + 2.0));
}

/// How far T of M8 is off along the surface and across it, and k, in u. `eta` is the ratio n of indices; the others are
/// sine and cosine in front of the surface and behind it.
fn refraction(
    u: f64,
    eta: Intervalle,
    [s, c]: [Intervalle; 2],
    [s_, c_]: [Intervalle; 2],
) -> [Intervalle; 3] {
    // In W the product with N and the difference round, and so does N·D, and N² is not 1.
    let le_long = c + s;
    let travers = le_long + gamma(scalaire(), u) + N2 * c;
    // The square and the N² of N·D; three roundings of W², and those of 1 − n, 1 + n and two products; the sum.
    let droit =
        2.0 * gamma(scalaire(), u) * c + (N2 + 1.0) * c.carre() + gamma(scalaire(), u).carre() * u;
    let perdu = (le_long.carre() + travers.carre()) * u;
    let ecart = gamma(fois("M8 W²: W W") + fois("M8 c′²: W²") - difference(), u) * s.carre()
        + 2.0 * s * le_long
        + perdu;
    let k = droit + ((1.0 - eta) * (1.0 + eta)).grandeur() * ecart + c_.carre();
    // The product with n.
    [eta * le_long + s_, eta * travers + s_, k].map(|erreur| erreur * plus(60.0, u))
}

#[test]
fn lemme_9_la_borne_d_une_refraction_suffit() {
    let domaine = |u: f64| [[0.0, RAPPORT_MAXIMAL], [u, 1.0]];
    tenir_sur("9 refraction", promesses::REFRACTE, domaine, |u, [eta, c_]| {
        let s_ = sinus(c_);
        if s_.bas > eta.haut {
            return None; // no light comes to c′
        }
        let s = if eta.bas > 0.0 { (s_ / eta).min(i(1.0)) } else { de_a(0.0, 1.0) };
        let c = sinus(s);
        let [le_long, travers, k] = refraction(u, eta, [s, c], [s_, c_]);
        // The error of √k = c′, times c′.
        let racine = k * c_ / (c_ + (c_.carre() - k * u).max(i(0.0)).racine());
        // Root, length of N, product; the product, the difference and the quotient in any direction.
        let droit = travers + c_ * (1.0 + promesses::UNITAIRE_PLATE);
        let angle = c_ * (c_ * le_long + s_ * droit + c_ + 2.0) + s_ * racine;
        Some(angle * plus(60.0, u) / (1.0 + eta))
    });
    // n starts at the first number above 1, since up to 1 all terms of k are above 0.
    let domaine = |u: f64| [[1.0 + 2.0 * u, RAPPORT_MAXIMAL]];
    tenir_sur("9 total reflection", promesses::REFRACTE_TOTALE, domaine, |u, [eta]| {
        let c = ((eta - 1.0) * (eta + 1.0)).racine() / eta;
        let [.., k] = refraction(u, eta, [1.0 / eta, c], [i(1.0), i(0.0)]);
        Some(k / ((1.0 + eta) * c))
    });
    // W and the sum round, and so does making the sum unit. N·√k is N·(N·D) again.
    tenir("9 straight on", promesses::TOUT_DROIT, |u| 3.0 * plus(60.0, u));
}

#[test]
fn lemme_11_les_bornes_d_une_lampe_et_des_transformations_suffisent() {
    // A sun that is kept as it stands is off by more than one that is made unit.
    tenir("11 N·L of a sun", promesses::SOLEIL, |u| et(i(D1), gamma(scalaire(), u), u) * n(u));
    let longueur = |u: f64| et(et(racine(gamma(carre(), u), u), i(1.0), u), i(1.0), u);
    tenir("11 lamp, distance", promesses::LAMPE_DISTANCE, longueur);
    let direction = |u: f64| et(normalise(u), i(1.0), u);
    tenir("11 lamp, L", promesses::LAMPE_DIRECTION, direction);
    tenir("11 where it ends", promesses::BOUT, |u| et(longueur(u), direction(u), u));
    tenir("11 N·L", promesses::LAMPE_COSINUS, |u| {
        et(direction(u), gamma(fois("L3 N·L: L N"), u), u) * n(u)
    });
    tenir("11 turn", promesses::CENTRE_TOURNE, |u| gamma(fois("turn C·M: T U"), u) * n(u));
    tenir("11 move", promesses::DISTANCE_DEPLACEE, |u| gamma(fois("move d: N T"), u));
}

#[test]
fn lemme_13_une_rotation_reste_orthonormale() {
    let v = U[1];
    // What one Newton step leaves of an e = |M·Mᵀ − I|.
    let pas = |e: Intervalle| 0.75 * e.carre() + 0.25 * e * e.carre();
    // Elements are off by 12u, and products by γ₃ of f64. Both count as norms, which are at most three times the
    // largest element.
    let compose = |u: f64| {
        // A matrix made of a quaternion or of directions, in f64 for either type.
        let fait = 200.0 * i(v);
        let facteur = 3.0 * N2 * i(u);
        let produit = facteur
            + facteur * (1.0 + facteur)
            + 2.0 * 3.0 * gamma(fois("M·M′: U U"), v) * v * plus(8.0, v);
        produit.max(fait)
    };
    // I − M·Mᵀ is off by γ₃ of f64, and so is what the step leaves; then the sum of the step rounds. In f64 that is the
    // last rounding, in f32 the elements round once more.
    let reste = |u: f64| (pas(compose(u)) + gamma(fois("M·Mᵀ: M M"), v) * v * plus(40.0, v)) / i(u);
    let elements = |u: f64| et(i(1.0), i(1.0), u) + if u > v { 2.0 * v / u } else { 0.0 };
    tenir("13 M·Mᵀ", ORTHONORMALE, |u| et(reste(u), elements(u), u));
    // For columns the eigenvalues are the same.
    tenir("13 M·Mᵀ of an inverse", N2, |u| et(3.0 * reste(u), elements(u), u));
    // Three steps, from an element at the limit.
    let mut e = 3.0 * i(1.01 * ECART_ROTATION);
    for _ in 0..3 {
        e = pas(e) + 3.0 * gamma(fois("I−M·Mᵀ: M M"), v) * v;
    }
    assert!(e.haut < compose(v).bas);
}

#[test]
fn lemme_13_les_tours_et_les_compositions_sont_assez_justes() {
    let v = U[1];
    // In u of f64. A turn is 1/√2 of the norm of the error of a matrix, of which a factor of all elements is no part.
    let [deux, trois] = [2.0, 3.0].map(|x| i(x).racine());
    let tenir_en_f64 = |quoi, constante, besoin: Intervalle| tenir(quoi, constante, |_| besoin);
    // What the step leaves of a defect whose elements are off by 3u: in a row, in a row across itself, and in all rows.
    // Each element rounds.
    let (rangee, travers) = (1.5 * trois + 1.0, 1.5 * deux + 1.0);
    let toutes = trois * rangee;
    // A vector product, and one with a k that may be off its right angle by 2.2u of 16u.
    let croise = 1.0 + 2.0 / trois;
    let oblique = croise / (1.0 - (croise / 16.0).carre()).racine();
    // An axis, its length and the elements, made of cosine and sine or of a quaternion.
    let elements = (2.0 + 2.0 + trois) / deux + 1.0;
    let axe = 2.0 + 0.5 * 3.5 + deux;
    // s(2 − c + 2|c|) for c < 0, and half a rounding of e.
    let quaternion =
        portee(sur("13 turns", v, [[0.0, 1.0]]), 3.1, |[c]| Some((2.0 + 3.0 * c) * sinus(c)));
    // Three cosines and sines; products of norms 1 and 2 and their sum.
    let new = 3.0 * deux + (1.0 + 2.0 + deux) / deux + rangee;
    let de_l_axe = axe + elements + rangee;
    tenir_en_f64(
        "13 turns",
        promesses::TOUR,
        new.max(de_l_axe).max(2.0 + quaternion + 0.5 + elements + rangee),
    );
    // Directions; cosine and k; elements, in which e is k; the half turn and its product with the first turn; V·M.
    let demi_tour = 2.0 * croise + (2.0 + trois) / deux + 9.0 / deux;
    let arc = deux * croise + 3.0 + (1.0 + 1.0 + trois) / deux;
    tenir_en_f64("13 `entre`", promesses::ENTRE, 2.0 + arc + demi_tour + toutes + 3.0 * trois);
    // Half of the right angles with both other rows; y is divided by its length.
    let droits = 0.5 * (croise.carre() + (oblique + 1.0).carre()).racine();
    tenir_en_f64("13 `regard`", promesses::REGARD, 1.0 + travers + droits);
    let droits = 0.5 * deux * croise;
    tenir_en_f64(
        "13 x of `regard`",
        promesses::REGARD_DROIT,
        1.0 + croise + (oblique + 1.0 + croise) + travers + droits,
    );
    // In f32 only elements and V·M round.
    assert!((trois + 3.0 * trois + 40.0 * U[1] / U[0]).haut < promesses::ENTRE);
    // What both factors lack of being orthonormal, as a row and as a norm; then the product, as a turn.
    let composee = |element: f64, norme: f64| 0.5 * (trois * element + norme) + 9.0 / deux + rangee;
    tenir_en_f64("13 `puis`", promesses::COMPOSEE, composee(ORTHONORMALE, 3.0 * ORTHONORMALE));
    tenir_en_f64("13 `puis`, others", promesses::COMPOSEE_D_AUTRES, composee(N2, 3.0 * N2));
}

/// What the ball test may lose of SC² − SA², in u·f².
fn boule(u: f64) -> Intervalle {
    let sa = 2.0 * gamma(fois("S2 SA: D SC") + fois("S1 SC: S"), u) * d(u);
    sc2(u) + et(i(D2), i(1.0), u) + sa * d(u)
}

#[test]
fn lemme_14_la_boule_ne_cache_aucune_entree() {
    // y = ρ/f; lemma 6 says where the point of a hit lies.
    tenir_sur("14 ball", RETRAIT, zero_a_un, |u, [y]| {
        let epsilon = 15.0 * plus(40.0, u) * u;
        let rho2 = y.carre();
        let loin = 11.0 * i(3.0).racine() * y;
        let hors = plus(37.0, u)
            * (2.0 * i(3.0).racine() * y * 15.0 * plus(40.0, u) + 3.0 * epsilon * 15.1);
        let besoin = boule(u)
            + hors
            + (37.0 + gamma(carre(), u) + difference()) * rho2
            + loin.carre() * u * plus(100.0, u);
        // If SA ≤ 0 as computed, C is no farther ahead than 4u·f: CX² ≥ f²(1 − 17u²) + t².
        let derriere = sc2(u) + 17.0 * u;
        assert!(derriere.haut < boule(u).bas, "the second condition needs more than the first");
        Some(besoin * plus(RETRAIT, u))
    });
    for u in U {
        let g = inverse(gamma(r2_d2(), u), u);
        let ac = et(gamma(r2_d2(), u), g, u) + 2.0 * 2.16 * plus(20.0, u);
        assert!((boule(u) + ac + 1.0).haut < RETRAIT);
        // SC² less its part, over f².
        assert!((plus(sc2(u) - RETRAIT, u) * plus(inverse(gamma(carre(), u), u), u)).haut < 1.0);
    }
}

/// How far the point of a hit is off along the axis of a box, in u·t: three comparisons, of which two would do, the
/// quotient and the length of an exit, and the speed.
fn lieu_le_long(u: f64) -> Intervalle {
    let comparaisons = et(et(rapport(u), rapport(u), u), rapport(u), u);
    et(et(comparaisons, i(1.0), u), i(1.0), u) * n(u) * d(u) * plus(20.0, u) + vitesse(u)
}

#[test]
fn lemme_6_la_borne_du_lieu_d_une_touche_suffit() {
    // For a box: along an axis √3·(4f + 11t) with t ≤ f + ρ, and 36ρ.
    let le_long = |u: f64| i(3.0).racine() * lieu_le_long(u) * plus(20.0, u);
    tenir("6 box, |f|", TOUCHE_F, |u| {
        (i(3.0).racine() * gamma(fois("B1 f_i: N S"), u) * n(u) + le_long(u)) * plus(60.0, u)
    });
    tenir("6 box, ρ", TOUCHE_RHO, |u| {
        // Across the slice that T5 names there are the place, U, the product, what follows, and `f32`.
        let tranche = i(2.0 + 3.0 + 3.0 + 8.0 + 2.0);
        let tranchee = (2.0 * lieu_le_long(u).carre() + tranche.carre()).racine();
        (le_long(u).max(tranchee) + 36.0) * plus(60.0, u)
    });
}

/// How far AB² is off, in u, where AC is at most `k`.
fn de_ab2(u: f64, [f, r, k]: [Intervalle; 3]) -> Intervalle {
    let g_ac = i(4.0 / 3.0).racine() * f + PERDU_LONGUEUR * r;
    gamma(r2_d2(), u) * plus(8.0, u) * (r.carre() + (k + g_ac * u).carre())
        + g_ac * (2.0 * k + g_ac * u)
        + PERDU * r.carre()
}

/// How far from the surface the point of a hit lies outside a sphere of radius `y`, seen from 1
/// away, in u(1 + y).
fn hors_d_une_sphere(u: f64, y: Intervalle) -> Intervalle {
    // AC is at most this, since r² − AC² > 0 as computed.
    let k = y * plus(10.0, u) + 3.0 * u;
    // The last difference adds u(r² − AC²) to 5u of each.
    let dw = de_ab2(u, [i(1.0), y, k]);
    let (y_bas, k_bas) = (i(y.bas), i(k.bas));
    assert!((dw.haut * u - (k_bas - y_bas) * (k_bas + y_bas)).haut <= 0.0 || y.haut > y.bas);
    let p = (1.0 - y.carre()).max(i(0.0));
    let racine_p = p.racine();
    // (b − β)β is no more than p/2, nor than √p·y.
    let t_beta = (0.5 * p).min(racine_p * y);
    let somme = dw
        + (gamma(fois("S3 SC²: SC SC"), u) + (1.0 + PERDU) * y.carre() + p) * plus(2.0, u)
        + p
        + (gamma(fois("S2 SA: D SC"), u) * racine_p + t_beta + p) * plus(4.0, u);
    let dehors = |carre: Intervalle| carre / ((y.carre() + carre * u).racine() + y);
    // Measured from the point where AB as computed ends.
    let loin = if racine_p.bas > 0.5 {
        dehors(dw) + somme / (racine_p * moins(40.0, u))
    } else {
        i(f64::INFINITY)
    };
    // X is no farther from C than S; and p ≤ ΔAB², or 2β ≤ s and s² ≥ p.
    let w = dw + 2.0 * somme * (y / (1.0 + y)).min(i(0.5));
    let mut carre = 0.5 * (w + (w.carre() + 4.0 * somme.carre()).racine());
    if p.bas > 0.25 {
        carre = carre.min(w + somme.carre() * u / p);
    }
    // Where AB² < 0, β² + |AB²| = ΔAB² and SA² = p + AB². SA − t is (β·SA + AB²)/s, off by what remains over s. Where p
    // is small, ω is at most `petit`.
    let petit = 40.0 * y.carre();
    let sa = (petit.max(p / u) - dw).racine();
    let pres = if y.bas > 0.25 && sa.bas > 0.0 {
        let sans = (dw.racine().max(dw / sa) + (somme - dw) / sa).carre() + dw;
        dehors(carre.max(petit).max(sans))
    } else {
        i(f64::INFINITY)
    };
    // SA/D², and S − C.
    let de_a_ = dehors(dw) + gamma(sa_sur_d2(), u);
    (loin.min(pres).max(de_a_) + 1.0) / (1.0 + y) * plus(100.0, u)
}

#[test]
fn lemme_6_la_borne_du_lieu_sur_une_sphere_suffit() {
    let domaine = |u: f64| [[0.0, 1.0 + 4.0 * u]];
    tenir_sur("6 P over sphere", promesses::LIEU_SPHERE, domaine, |u, [y]| {
        Some(hors_d_une_sphere(u, y))
    });
    for u in U {
        assert!(promesses::LIEU_SPHERE * plus(20.0, u).haut < TOUCHE_F);
    }
    // For a half-space t·v as computed is the height to two roundings; P adds that of tD.
    tenir("6 P over a plane, S", promesses::LIEU_PLAN_S, |u| {
        gamma(fois("H1 N·S: N S"), u) * plus(4.0, u)
    });
    tenir("6 P over a plane", promesses::LIEU_PLAN_T, |u| {
        let de_x = gamma(conclue(), u) * n(u) * d(u) + vitesse(u);
        (de_x + n(u) * d(u) * plus(1.0, u)) * plus(8.0, u)
    });
    // Three products and the quotient, then the three products of tD, for which ⟨N, 1⟩ ≤ √3.
    tenir("6 P over a plane, η", promesses::LIEU_PLAN_ABSOLU, |u| {
        (2.0 + 0.5 * i(3.0).racine()) * plus(40.0, u)
    });
    // For P, S + tD is rounded twice, and for a box it is off by more than the 11u of X.
    tenir("6 P over a face, |f|", promesses::LIEU_F, |u| gamma(fois("B1 f_i: N S"), u) * n(u));
    tenir("6 P over a face, t", promesses::LIEU_T, |u| {
        lieu_le_long(u) + n(u) * d(u) * plus(1.0, u)
    });
    tenir("6 P", promesses::LIEU_P, n);
    // For `lieu`: difference, product and sum; the scalar product; the quotient. Its loss below the normal numbers is
    // least beside |f|, which is at least a half-length, where the half-length that divides is largest.
    tenir("6 `lieu`", promesses::LIEU_FACE, |u| {
        let limite = if u == U[0] { f32::LIMITE.into() } else { f64::LIMITE };
        let eta = if u == U[0] { f32::ETA.into() } else { f64::ETA };
        let perdu = 0.5 * (eta * limite * limite) / u * plus(20.0, u);
        gamma(fois("lieu: / S U"), u) * n(u) * d(u) * plus(1.0, u) + perdu
    });
}

#[test]
fn lemme_20_le_jeu_d_un_objet_suffit() {
    let v = U[0];
    // What a ray loses of the place of its source: (S − Z)σ; if it is moved, a product, a sum of up to twice that, and
    // the distances that count from there.
    tenir("20 |f|", JEU_DISTANCE, |u| {
        let place = et(i(1.0), i(1.0), u);
        let deplacee = i(1.0) + 2.0 * i(1.0) + 2.0 * i(2.0);
        let deplacee = if u == v { i(0.0) } else { deplacee };
        // For an object: three rounding errors of its centre, and two for the distances.
        let objet = et(et(i(1.0), i(1.0), u), i(1.0), u) + 2.0;
        (TOUCHE_F + (place + deplacee).max(objet)) * plus(200.0, u)
    });
    // For the half-extents: γ₃, σ, the sum and the difference.
    tenir("20 extents", JEU_LARGEUR, |u| {
        let lieu = if u == v { i(TOUCHE_RHO) } else { 36.0 * plus(60.0, v) };
        lieu + et(et(gamma(3.0, u), i(1.0), u), i(2.0), u) * (u / v)
    });
}

#[test]
fn lemme_21_le_jeu_d_un_rayon_suffit() {
    let v = U[0];
    tenir("21 of a ray", JEU_F32, |u| {
        // A length G − Y_S takes the difference, D, the inverse and the product; then the ceiling.
        let inverse_d = et(i(if u == v { 0.0 } else { 1.0 }), i(1.0), v);
        let entree = et(et(inverse_d, i(1.0), v), i(1.0), v) + 1.0;
        // The corner is rounded, and so are Y_S and its sum with the slack. The slack itself is rounded five times.
        (entree + 2.0) * plus(3.0 * JEU_F32, v)
    });
}

#[test]
fn lemme_16_les_bornes_des_nombres_doubles_suffisent() {
    tenir("16 product", PRODUIT_DOUBLE, |u| {
        // In u² of the product as computed: two low parts, their products with the high ones, the sum of these
        // products, and its sum with what the product of the high parts left.
        let un = plus(inverse(i(1.0), u), u);
        let croises = 2.0 * plus(1.0, u);
        (1.0 + 2.0 + croises + (1.0 + croises * plus(1.0, u))) * un
    });
    // The fma loses ½, two cross products 1, four products of bounds 2.
    tenir("16 lost", PERTE_DOUBLE, |u| 3.5 * plus(1.0, u));
    // |x| ≤ |haut|(1 + u); then a product, four sums, and the product that makes the bound grow.
    tenir("16 bound", BORNE_DOUBLE, |u| et(i(1.0), inverse(gamma(6.0, u), u), u));
}

#[test]
fn lemme_17_les_bornes_de_l_erreur_suffisent() {
    let ecart = |u: f64| {
        // AB, of −D²·p_A with D² to γ₃, and of 2XA²; then the sum with XA and the quotient by D².
        let ab = et(racine(et(gamma(3.0, u), gamma(2.0, u), u), u), i(1.0), u);
        et(ab, et(i(1.0), inverse(gamma(4.0, u), u), u), u)
    };
    // The product that moves an end, and the η that moves it on.
    tenir("17 J8", ECART_ARRONDI, |u| et(ecart(u), inverse(gamma(2.0, u), u), u));
    tenir("17 J7", ERREUR_ARRONDIE, |u| {
        // Times |D|, the root of a sum; and the sum with what D lacks, which rounds less often.
        let mesure = et(
            ecart(u),
            et(et(racine(gamma(3.0, u), u), i(1.0), u), inverse(gamma(2.0, u), u), u),
            u,
        );
        // The conversion, the product that makes it grow, two sums.
        et(mesure, inverse(gamma(3.0, u), u), u)
    });
    for u in U {
        // No ray that enters an object passes by its ball: AC² is at most ρ²(1 + 37u), and ρ² as computed is off by 3u.
        assert!(
            (boule(u) + 37.0 + gamma(carre(), u) + difference()).haut * (1.0 + 100.0 * u) < RETRAIT
        );
    }
}

#[test]
fn lemme_18_les_bornes_du_coup_d_oeil_suffisent() {
    // In f64, with numbers that are unit only to the rounding of f32.
    let (u, large) = (U[1], 1.0 + D1 * U[0]);
    let tenir = |quoi, constante, besoin: Intervalle| tenir(quoi, constante, |_| besoin);
    // The point rounds twice, the product three times, the height and its bound twice.
    tenir("18 point", VUE_POINT, gamma(7.0, u) * large * large * plus(8.0, u));
    tenir("18 length", VUE_LONGUEUR, gamma(2.0, u) * plus(8.0, u));
    tenir("18 speed", VUE_VITESSE, gamma(4.0, u) * large * large);
    // The square of X as computed, the difference and its bound, and 16 for the point. r² is off by less.
    tenir("18 power", VUE_PUISSANCE, (16.0 + gamma(5.0, u)) * plus(16.0, u));
    // The point itself is off by less than heights over it.
    assert!((gamma(2.0, u) * large * plus(8.0, u)).haut < VUE_POINT);
}

#[test]
fn lemme_12_la_borne_vers_une_touche_suffit() {
    // The difference, the quotient and the scalar product. As computed, that product exceeds what is tangent.
    tenir("12 under the plane", promesses::SOUS_LE_PLAN, |u| {
        (2.0 * plus(1.0, u) * n(u) + vitesse(u) * plus(8.0, u)) - TANGENT * moins(1.0, u)
    });
}

#[test]
fn lemme_15_l_etendue_tient_tout_l_objet() {
    // The half-extents as computed, what the matrix is off by, and two sums.
    let besoin = |u: f64| {
        let h = et(gamma(fois("E1 H: U l"), u), i(fois("E1 corner: H")), u);
        (h + 36.0) * plus(100.0, u)
    };
    tenir("15 `etendue`, E1", ETENDUE, besoin);
    // The gap between, in half-extents and in C.
    tenir("15 `etendue`", promesses::ETENDUE_TAILLE, |u| besoin(u) + ETENDUE * plus(100.0, u));
    tenir("15 ‖C‖₁", promesses::ETENDUE_CENTRE, |u| (2.0 + 1.0) * plus(8.0, u));
}

/// How far outside a sphere the point lies where a ray leaves it, in u(f + r). The larger of |f| and r is 1, the
/// smaller `y`.
fn sortie_hors_d_une_sphere(u: f64, dehors: bool, y: Intervalle) -> Intervalle {
    let (f, r) = if dehors { (i(1.0), y) } else { (y, i(1.0)) };
    // The error of AB². AC is at most |f|, or r as computed.
    let k = if dehors { r * plus(10.0, u) + 3.0 * u } else { f };
    let dw = de_ab2(u, [f, r, k]) + r.carre() * plus(8.0, u);
    let hors = |carre: Intervalle| carre / ((r.carre() + carre * u).racine() + r);
    // With A ahead: SA, the root, the sum, D² and the quotient, and also what W5 may move.
    let ab = (r.carre() + dw * u).racine();
    let s =
        (gamma(fois("S2 SA: D SC"), u) * f + ab + gamma(sur_d2() + fois("W2 s: SA"), u) * (f + ab))
            * plus(8.0, u);
    let devant = hors(dw) + s.max(gamma(9.0, u) * f);
    // With A behind, S is within, and t is at most r.
    let derriere = if dehors {
        i(0.0)
    } else {
        let dp =
            gamma(fois("S3 SC²: SC SC"), u) * f.carre() + (1.0 + PERDU) * r.carre() + r.carre();
        let arrondi = 2.0 * r * (3.0 * f + r + 2.0 * r * plus(8.0, u));
        hors((2.0 * dp + dw + arrondi) * plus(32.0 * u.sqrt() / u, u))
    };
    (devant.max(derriere) + f) / (f + r) * plus(100.0, u)
}

#[test]
fn lemme_10_la_borne_du_lieu_sur_une_sphere_suffit() {
    let domaine = |u: f64| [[0.0, 1.0 + 4.0 * u]];
    tenir_sur("10 P over sphere", promesses::LIEU_SPHERE, domaine, |u, [y]| {
        let [dehors, dedans] = [true, false].map(|dehors| sortie_hors_d_une_sphere(u, dehors, y));
        Some(dehors.max(dedans))
    });
}

#[test]
fn lemme_10_la_marge_est_finie() {
    let perdue = promesses::PERDUE;
    let domaine = |u| [[2.0, 1.0 / (perdue * u)], [0.0, 1.05]];
    tenir_sur("10 not lost", 1.0, domaine, |u, x| sphere_non_perdue(u, perdue, true, x));
}

#[test]
fn lemme_10_les_bornes_d_une_normale_suffisent() {
    // y = f/r. S7 rounds f, t̂D and their sum. t is at most f + r, and at most y + c where the normal is leaned, with
    // y ≥ 1 − c²/2 then. The quotient and four rounding errors across D follow.
    let loin = |u: f64| 1.0 / (promesses::PERDUE * u);
    tenir_au_large("10 direction", promesses::DIRECTION, |u| {
        portee(sur("10 direction", u, [[u, loin(u)]]), promesses::DIRECTION, |[y]| {
            Some((2.0 * y + 3.0) / (1.0 + y) * plus(8.0, u))
        })
    });
    // There c² is at most the errors of the distance, which is off by at most K·u·κt, and of N·D.
    let domaine = |u| [[0.5, loin(u)]];
    tenir_sur("10 direction, leaned", promesses::DIRECTION, domaine, |u, [y]| {
        let c2 = promesses::SORTIE_SPHERE * u * (2.0 + 2.0 * y) + 20.0 * u * (1.0 + y);
        if (y.carre() + c2).haut < 1.0 {
            return None;
        }
        let c = if y.haut < 4.0 { c2.racine() } else { i(1.0) };
        Some((2.0 * y + c + 6.0) / (1.0 + y) * plus(8.0, u))
    });
}

#[test]
fn lemme_10_le_bord_d_un_lieu_suffit() {
    // All are worst where one half-length is all of Σl. Along the edge the source is off by its roundings, by S − C and a
    // product with an axis, by `limite` and as the axes are at right angles. On the way to the face it comes nearer by the
    // N_i·D of another axis, as computed.
    let [de_l, de_c] = ["U l p", "C"].map(|produit| fois(&format!("vers_lieu: {produit}")));
    tenir_au_large("10 edge, Σl", BORD, |u| {
        let le_long = de_l + fois("B1 f_i: N S") + 1.0 + N2;
        i(le_long).max(N2 + vitesse(u)) * plus(60.0, u)
    });
    tenir_au_large("10 edge, ‖C‖₁", BORD, |u| de_c * n(u));
}
