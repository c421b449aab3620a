//! Lemma 22 as a program: each row of its table from the counts of the tapes, those of a sphere over their whole domain;
//! then what M7 and D1 to D3 grant beside the sums. All is to first order in u. Only the page can say what a row is
//! about, why 22u and 8u bound a way inside, and what SA/D² adds.

use commun::tolerances::{bandes, profondeurs, promesses};
use lancer_rayon::pour_les_tests::*;

use crate::besoins::{sur, tenir, tenir_au_large, tenir_sur};
use crate::constantes::{carre, conclue, difference, fois, gamma, ne_suffit_pas, plus, scalaire};
use crate::intervalle::{Intervalle, de_a, i, portee, positif, prouver};

/// ΔAB² and χ of lemma 6, in u, for this |f|, r and β, where SA is `sa`. Beside ζ = 2/√3 AC rounds by the squares of its
/// coordinates, each of which rounds once more.
fn chi([f, r, b, sa]: [Intervalle; 4]) -> [Intervalle; 2] {
    let zeta = i(4.0 / 3.0).racine() * f;
    let ac2 = positif(r.carre() - b.carre());
    let ab2 = (fois("S4 AC²: AC AC") + 2.0) * ac2
        + 2.0 * zeta * ac2.racine()
        + fois("S4 r²D²: D D r r") * r.carre()
        + b.carre();
    let p = positif(f.carre() - r.carre());
    let dp = carre() * f.carre() + fois("S3 r²: r r") * r.carre() + p;
    // SA, the root and the sum.
    let ds = fois("S2 SA: D SC") * f + b + (sa + b);
    [ab2, ab2 + dp + fois("S6 t: / p") * p + positif(sa - b) * ds]
}

/// S − C, by which C′ lies off C, in u·|f|.
fn du_centre() -> f64 {
    fois("S1 SC: S")
}

/// The depth in a sphere of radius 1 with |f| < 2. While β ≤ SA, 2β is at most s.
fn pres([f, b]: [Intervalle; 2]) -> Intervalle {
    let sa = (positif(f.carre() - 1.0) + b.carre()).racine();
    let [ab2, chi] = chi([f, i(1.0), b, sa]);
    let s = sa + b;
    let part = if s.bas > 0.0 { (2.0 * b / s).min(i(1.0)) } else { de_a(0.0, 1.0) };
    0.5 * (ab2 + part * chi) + du_centre() * f
}

/// The same where p is all rounding and β > SA: then |f| is r, and 2β at most 2s.
fn tout_pres([b]: [Intervalle; 1]) -> Intervalle {
    let [ab2, chi] = chi([i(1.0), i(1.0), b, b]);
    0.5 * (ab2 + 2.0 * chi) + du_centre()
}

/// The depth in a sphere of radius y, seen from 1 ≥ 2y away, where β = ky, less these constants times u·t and u·y. X is
/// χ/s from a point of power ΔAB², no deeper than that over r. What AC may exceed r by and the square of ζ add 3ζ² to
/// ΔAB², at most ζ²/15 over r ≥ 45u|f|.
fn loin([y, k]: [Intervalle; 2], [par_t, par_r]: [f64; 2]) -> Intervalle {
    let b = y * k;
    let p = 1.0 - y.carre();
    let sa = (p + b.carre()).racine();
    let [_, chi] = chi([i(1.0), y, b, sa]);
    let ac2 = positif(1.0 - k.carre());
    let par_rayon = (fois("S4 AC²: AC AC") + 2.0) * ac2 + fois("S4 r²D²: D D r r") + k.carre();
    let zeta = i(4.0 / 3.0).racine();
    let ab2_sur_r = y * par_rayon + 2.0 * zeta * ac2.racine() + zeta.carre() / 15.0;
    ab2_sur_r + chi / (sa + b) + du_centre() - par_t * positif(sa - b) - par_r * y
}

/// The rows that counts make, in the order of `profondeurs::LIGNES`, and those of a sphere seen from outside as granted.
fn lignes() -> [[f64; 3]; 7] {
    let (boite, plan) = (fois("B1 f_i: N S"), fois("H1 N·S: N S"));
    // A length, and the quotient or a comparison in its place.
    let d_une_face = fois("B1 l±f_i: l") + fois("B5 t: / l±f_i").max(fois("B3: l±f_i v"));
    // The page says why: SA/D² in place of p/s, and a ray that passes by the centre where AB² ≤ 0 as computed.
    let (sa_sur_d2, sans_ab) = (2.0, 2.0 * bandes::SPHERE);
    [
        [plan + scalaire() + conclue(), plan, 0.0],
        [boite + bandes::VITESSE + d_une_face, 0.0, boite],
        [sa_sur_d2, 0.0, profondeurs::D_UNE_SPHERE[2]],
        profondeurs::D_UNE_SPHERE_LOIN,
        [bandes::VITESSE, 0.0, 0.0],
        [fois("S2 SA: D SC") + du_centre(), 0.0, sans_ab],
        // Under the face beside that D3 finds near.
        [bandes::VITESSE, 0.0, FLOU_A_COTE + boite],
    ]
}

#[test]
fn lemme_22_les_lignes_de_la_table_suffisent() {
    assert_eq!(lignes(), profondeurs::LIGNES);
    // A start that rounding alone put under a face is as near as that, as the next search sees it.
    assert_eq!(profondeurs::UNE_FOIS, fois("B1 f_i: N S"));
    const { assert!(FLOU_A_COTE > 2.0 * profondeurs::UNE_FOIS) };
    let [.., de_r] = profondeurs::D_UNE_SPHERE;
    tenir_au_large("22 sphere, near", de_r, |u| {
        let domaine = sur("22 sphere, near", u, [[1.0, 2.0], [0.0, 1.0]]);
        prouver(domaine, de_r, |x| Some(pres(x)))
    });
    tenir_sur("22 sphere, p < ΔAB²", de_r, |_| [[0.0, 1.0]], |_, x| Some(tout_pres(x)));
    let [de_t, _, de_r] = profondeurs::D_UNE_SPHERE_LOIN;
    let loin = |par| portee([de_a(0.0, 0.5), de_a(0.0, 1.0)], 1e-9, |x| Some(loin(x, par)));
    loin([de_t, de_r]);
    ne_suffit_pas(|| loin([0.98 * de_t, de_r]));
    ne_suffit_pas(|| loin([de_t, 0.98 * de_r]));
    // Of a smaller sphere no point of power ΔAB² is deeper than this, in u·|f|, down to r = 8u|f|.
    let zeta = i(4.0 / 3.0).racine();
    let petite = |[r]: [Intervalle; 1]| {
        let ab2 = 2.0 * zeta * r + 3.0 * zeta.carre();
        Some(r - positif(r.carre() - ab2).racine())
    };
    prouver([de_a(8.0, 45.0)], (2.0 * zeta).bas, petite);
}

#[test]
fn lemme_22_le_flou_permis_suffit() {
    // P rounds by the product and the sum, the start by its sum. The next search takes the height, or the power over 2r.
    let hors = |quoi, produits: [&str; 2]| {
        produits
            .map(|produit| fois(&format!("{quoi}: {produit}")) - difference())
            .iter()
            .sum::<f64>()
    };
    let par_t = fois("M1 P: D t") - fois("M1 P: S");
    let par_p = fois("M1 P: S") + fois("M6 S′: P");
    let [d_un_plan, d_une_boite] = [fois("H1 N·S: N S"), fois("B1 f_i: N S")];
    let d_une_sphere = 0.5 * hors("S3 p", ["S S", "r r"]);
    let vus = |ligne: usize| match ligne {
        0 | 4 => [par_t, par_p + d_un_plan, 0.0],
        1 | 6 => [par_t, par_p, d_une_boite],
        _ => [par_t, par_p, d_une_sphere],
    };
    let lignes = profondeurs::LIGNES;
    let pire = |k: usize, choisies: &[usize]| {
        choisies.iter().map(|&ligne| lignes[ligne][k] + vus(ligne)[k]).fold(0.0, f64::max)
    };
    let toutes = [0, 1, 2, 3, 4, 5, 6];
    tenir_au_large("22 t", FLOU_DISTANCE, |u| pire(0, &toutes) * plus(60.0, u));
    tenir("22 ‖P‖₁", FLOU_POINT, |u| pire(1, &toutes) * plus(60.0, u));
    tenir_au_large("22 r", FLOU_PROPRE, |u| (pire(2, &[2, 3, 5]) + 0.5) * plus(60.0, u));
    // In u of δ, with a step of `pas` δ whose N, with Ω's own, a product and a sum make it count with `compte` more. Ω was
    // seen as deep as `sous` less than δ, and M7 rounds three times.
    let relatif = |u: f64, pas: f64, compte: Intervalle, sous: f64| {
        (pas * compte - sous) / i(1.0 + pas) + gamma(3.0, u) + sous
    };
    let de_la_face = i(2.0 * promesses::UNITAIRE_PLATE) + fois("M6 S′: N pas");
    let dans_une_boite = 3.0;
    // From a hit at once: by M3 1.2 times as long as the depth out of a sphere, and a 64th of δ.
    let long = 2.0 * PAR_RAYON + PAS_D_EMBLEE;
    tenir("22 δ and step", FLOU_RELATIF, |u| {
        let plan = relatif(u, long, de_la_face + d_un_plan, 1.0);
        relatif(u, long, de_la_face, dans_une_boite).max(plan) * plus(60.0, u)
    });
    // Under a face that D3 finds near X may be as deep as (1 + 2u)δ, where a step is no part of δ.
    assert!(2.0 + 3.0 + dans_une_boite <= FLOU_RELATIF);
    // A longer step lacks this much of itself. Where it lies deep in a box, it is no longer than a third of Σl; and as each
    // such step exceeds all before it, which are in δ, all together lack no more than this much of the last.
    let par_fois = FLOU_RELATIF - 3.0;
    let manque = |compte: Intervalle, sous: f64| compte - (par_fois - sous);
    tenir_au_large("22 Σl", FLOU_PROPRE, |u| {
        let du_pas = manque(de_la_face, dans_une_boite);
        let des_pas = du_pas * (1.0 + du_pas / i(par_fois)) / 3.0;
        (pire(2, &[1, 6]) + profondeurs::UNE_FOIS + des_pas) * plus(60.0, u)
    });
    // Next to a half-space what the table leaves of M7's 15ut pays a step of 0.8t, and 14u of δ one of 1.5δ.
    let reste = FLOU_DISTANCE - lignes[0][0] - par_t;
    let du_pas = manque(de_la_face + d_un_plan, 1.0);
    assert!((0.8 * du_pas).haut <= reste && (1.5 * du_pas).haut <= par_fois);
}
