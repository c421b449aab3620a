//! The constants of distances, proved from tapes of the crate's own code by the slopes of `pentes.rs`.

use std::panic::AssertUnwindSafe;

use commun::tolerances::{bandes, promesses};
use lancer_rayon::ObjetRay;

use crate::besoins::{U, sur, tenir, tenir_au_large};
use crate::constantes::{ne_suffit_pas, plus};
use crate::etapes::{S, boite, cotes, de, plan, programmes, rayon, sphere};
use crate::intervalle::{Intervalle, de_a, i, positif, prouver, sinus};
use crate::pentes::Encore::{Calcule, Erreur, Rien};
use crate::pentes::{Boite, Dit, Encore, Programme, Valeur, nombre};
use crate::ruban::{Op, Place, Taille, Trace, neuf, op};

/// The degree of a length is 1. That of D differs enough to be told apart, and is too small to turn a length into a
/// product of lengths.
const DEGRE_DE_D: f64 = 0.125;

/// A program and some of its nodes.
struct Preuve<const N: usize> {
    programme: Programme,
    noeuds: [usize; N],
}

impl<const N: usize> Preuve<N> {
    fn de(places: [Place; N]) -> Self {
        let mut programme = Programme::default();
        let noeuds = places.map(|place| programme.nombre(place));
        Self { programme, noeuds }
    }

    fn boite(&self, u: f64, lettres: &[(&str, f64, Valeur)], dits: &[Dit]) -> Option<Boite<'_>> {
        // What is lost beside r² and beside a length (lemma 2). Nothing is lost for half-spaces and boxes.
        let perdu = |degre| if degre >= 2.0 { u / 64.0 } else { u * (-60_f64).exp2() };
        let sphere = lettres.iter().any(|(nom, ..)| *nom == "r");
        let perdu = |degre| if sphere { perdu(degre) } else { 0.0 };
        Boite::new(&self.programme, u, lettres, dits, perdu)
    }
}

/// The program, once for each type.
fn de_chaque_type<const N: usize>(
    en_f32: impl Fn() -> [Place; N],
    en_f64: impl Fn() -> [Place; N],
) -> impl Fn(f64) -> &'static Preuve<N> {
    neuf();
    let un = &*Box::leak(Box::new(Preuve::de(en_f32())));
    neuf();
    let autre = &*Box::leak(Box::new(Preuve::de(en_f64())));
    move |u| if u == U[0] { un } else { autre }
}

/// Proves this constant on this domain, in both types, and shows that a tenth less is too little.
#[track_caller]
fn prouve_sur<const N: usize>(
    quoi: &str,
    constante: f64,
    domaine: impl Fn(f64) -> [[f64; 2]; N],
    besoin: impl Fn(f64, [Intervalle; N]) -> Option<Intervalle>,
) {
    tenir(quoi, constante, |u| prouver(sur(quoi, u, domaine(u)), constante, |x| besoin(u, x)));
}

macro_rules! de_chaque_type {
    ($f:ident) => {
        de_chaque_type($f::<u32>, $f::<u64>)
    };
}

fn vecteur(x: Intervalle, y: Intervalle) -> Valeur {
    [x, y, i(0.0)]
}

/// A bound, or +∞ if there is none.
fn ou_rien(borne: Option<Intervalle>) -> Intervalle {
    borne.unwrap_or(de_a(0.0, f64::INFINITY))
}

fn par(x: Intervalle, y: Intervalle) -> Option<Intervalle> {
    (y.bas > 0.0).then(|| x / y)
}

/// t and v, where |f|, ρ and t add up to 1, and tv ≤ |f|.
fn plate([f, rho, v]: [Intervalle; 3]) -> Option<[Intervalle; 2]> {
    let t = 1.0 - f - rho;
    if t.haut <= 0.0 || (f + rho).bas > 1.0 || (t * v).bas > f.haut {
        return None;
    }
    let t = positif(t);
    let haut = if t.bas > 0.0 { v.haut.min((f / i(t.bas)).haut) } else { v.haut };
    (v.bas <= haut).then(|| [t, de_a(v.bas, haut)])
}

/// The height, and t.
fn demi_espace<T: Taille>() -> [Place; 2] {
    let touche = ObjetRay::from(plan::<T>()).intersection(&rayon(S)).unwrap();
    let t = touche.distance().place();
    [cotes!(t, Quotient)[0], t]
}

#[test]
fn lemme_4_la_borne_d_un_demi_espace_suffit() {
    let preuve = de_chaque_type!(demi_espace);
    let un = i(1.0);
    let domaine = |u: f64| [[0.0, 1.0], [0.0, 1.0], [bandes::VITESSE * u, 1.0]];
    prouve_sur("4 K of a half-space", promesses::DISTANCE_PLAN, domaine, |u, x @ [f, d, _]| {
        let Preuve { noeuds: [e, sortie], .. } = *preuve(u);
        let [t, v] = plate(x)?;
        let de_d = |d: Intervalle| {
            let s = vecteur(t * v - d, positif(f.carre() - (t * v).carre()).racine());
            let lettres = [
                ("N", 0.0, nombre(un)),
                ("S", 1.0, s),
                ("D", DEGRE_DE_D, vecteur(-v, sinus(v))),
                ("d", 1.0, nombre(d)),
            ];
            let boite = preuve(u).boite(u, &lettres, &[(e, t * v, Rien), (sortie, t, Rien)])?;
            Some(boite.erreur(sortie)? * (v - bandes::VITESSE * u) / i(u) * plus(30.0, u))
        };
        Some(ou_rien(de_d(d)).max(ou_rien(de_d(-d))))
    });
}

/// The length and the t of an entry or of an exit.
fn entree<T: Taille>() -> [Place; 2] {
    de_boite(ObjetRay::from(boite::<T>()).intersection(&rayon(S)).unwrap().distance())
}

fn sortie<T: Taille>() -> [Place; 2] {
    de_boite(ObjetRay::from(boite::<T>()).sortie(&rayon(S)).unwrap().distance())
}

fn de_boite<T: Taille>(t: Trace<T>) -> [Place; 2] {
    let [longueur, _] = cotes!(t.place(), Quotient);
    [cotes!(longueur, Produit)[0], t.place()]
}

/// What a box needs, in u·κt, where it is entered or, if `sens` is −1, left.
fn distance_d_une_boite(
    u: f64,
    preuve: &Preuve<2>,
    sens: f64,
    [f, rho, v]: [Intervalle; 3],
) -> Option<Intervalle> {
    let [longueur, sortie] = preuve.noeuds;
    // At an entry tv ≤ |f|, at an exit tv ≤ |f| + ρ.
    let [t, v] = plate(if sens > 0.0 { [f, rho, v] } else { [f + rho, i(0.0), v] })?;
    let tv = t * v;
    // X is within ρ of C.
    let (l_bas, l_haut) = if sens > 0.0 { (0.0, f - tv) } else { ((tv - f).bas.max(0.0), tv + f) };
    let l_haut = l_haut.haut.min(rho.haut);
    if f.bas > (rho + t).haut || t.bas > (f + rho).haut || l_bas > l_haut {
        return None;
    }
    let l = de_a(l_bas, l_haut);
    let le_long = tv + sens * l;
    let lettres = [
        ("N", 0.0, nombre(i(1.0))),
        ("S", 1.0, vecteur(le_long, positif(f.carre() - le_long.carre()).racine())),
        ("C", 1.0, nombre(i(0.0))),
        ("D", DEGRE_DE_D, vecteur(-v, sinus(v))),
        ("l", 1.0, nombre(l * 2.0)),
    ];
    let boite = preuve.boite(u, &lettres, &[(longueur, tv, Rien), (sortie, t, Rien)]);
    let erreur = ou_rien(boite.and_then(|boite| boite.erreur(sortie)));
    // If k faces may be named, the one that B4 names comes at most 2(k − 1)u·t before the last, and v ≤ 1/√k.
    let k = [3.0, 2.0, 1.0].into_iter().find(|k| v.bas <= (plus(20.0, u) / i(*k).racine()).haut)?;
    let suite = 2.0 * (k - 1.0) * plus(8.0, u) * tv;
    Some((erreur * (v - bandes::VITESSE * u) / i(u) + suite) * plus(30.0, u))
}

#[test]
fn lemmes_4_et_10_la_borne_d_une_boite_suffit() {
    let domaine = |u: f64| [[0.0, 1.0], [0.0, 1.0], [bandes::VITESSE * u, 1.0 + 20.0 * u]];
    let preuve = de_chaque_type!(entree);
    prouve_sur("4 K of a box", promesses::DISTANCE_BOITE, domaine, |u, x| {
        distance_d_une_boite(u, preuve(u), 1.0, x)
    });
    let preuve = de_chaque_type!(sortie);
    prouve_sur("10 K of a box", promesses::DISTANCE_BOITE, domaine, |u, x| {
        distance_d_une_boite(u, preuve(u), -1.0, x)
    });
}

/// p, AB², p/s, SA/D², p·D² and SA·s.
fn entree_d_une_sphere<T: Taille>() -> [Place; 6] {
    let (objet, ray) = (sphere::<T>().into(), rayon(S));
    let quotients = programmes(9, &objet, |objet: &ObjetRay<Trace<T>>| objet.intersection(&ray));
    let [t, a]: [Place; 2] = quotients.try_into().expect("two programs");
    let ([p, s], [sa, d2]) = (cotes!(t, Quotient), cotes!(a, Quotient));
    let chercher = |voulu| crate::ruban::ops().iter().position(|op| *op == voulu).unwrap();
    let produits = [chercher(Op::Produit(p, d2)), chercher(Op::Produit(sa, s))];
    [p, de(cotes!(s, Somme)[1]), t, a, produits[0], produits[1]]
}

/// What the sphere of radius 1 needs, in u·κt, where it is entered at the distance t with the cosine c. None inside the
/// band.
fn distance_d_une_sphere(
    u: f64,
    preuve: &Preuve<6>,
    bande: f64,
    [t, c]: [Intervalle; 2],
) -> Option<Intervalle> {
    let s = sinus(c);
    let p = t * (t + 2.0 * c);
    let f = (p + 1.0).racine();
    let large = bande * u * (f + 1.0);
    if (c.carre() / (1.0 + s)).haut <= large.bas || (p / (f + 1.0)).haut <= large.bas {
        return None;
    }
    let [de_p, de_ab2, de_t, de_a_, de_p_d2, de_sa_s] = preuve.noeuds;
    let lettres = [
        ("S", 1.0, nombre(i(0.0))),
        ("C", 1.0, vecteur(t + c, s)),
        ("r", 1.0, nombre(i(1.0))),
        ("D", DEGRE_DE_D, nombre(i(1.0))),
    ];
    let dits = [(de_p, p, Rien), (de_ab2, c.carre(), Rien), (de_t, t, Rien)];
    let erreur = || {
        let boite = preuve.boite(u, &lettres, &dits)?;
        let [e_t, e_a, e_p, e_sa] =
            [de_t, de_a_, de_p_d2, de_sa_s].map(|noeud| boite.erreur(noeud));
        let (e_t, e_a) = (e_t?, e_a?);
        // SA/D² may be taken if p·D² ≥ SA·s as computed. In exact arithmetic SA·s − p·D² = AB·s.
        if (c * (t + 2.0 * c)).bas > (e_p? + e_sa?).haut {
            return Some(e_t);
        }
        // Then t̂ is no more than p/s as computed and 2u of it. Nor is it more than the mean of that and SA/D², in
        // which the two effects of a too large SA cancel.
        let moitie = u * plus(2.0, u) * (t + e_t);
        let moyen = boite.erreur_de(&[(de_t, 0.5), (de_a_, 0.5)])? + moitie + 0.5 * c;
        let plus_tard = (e_t + 2.0 * moitie).min(c + e_a).min(moyen);
        Some(e_t.max(plus_tard).max(e_a - c))
    };
    Some(ou_rien(erreur()) * c / (u * (f + 1.0 + t)) * plus(40.0, u))
}

/// Radii up to r = `perdue`·u·t.
fn rayons(u: f64, perdue: f64) -> [[f64; 2]; 2] {
    [[u / 4.0, 1.0 / (perdue * u)], [u.sqrt(), 1.0]]
}

#[test]
fn lemme_5_la_borne_d_une_sphere_suffit() {
    let preuve = de_chaque_type!(entree_d_une_sphere);
    prouve_sur(
        "5 K of a sphere",
        promesses::DISTANCE_SPHERE,
        |u| rayons(u, promesses::PERDUE),
        |u, x| distance_d_une_sphere(u, preuve(u), bandes::SPHERE, x),
    );
    prouve_sur(
        "5 small, far",
        promesses::DISTANCE_PERDUE,
        |u| rayons(u, 2.0),
        |u, x| distance_d_une_sphere(u, preuve(u), bandes::SPHERE, x),
    );
    // A narrower band does not do.
    let (u, bande) = (U[0], 0.9 * bandes::SPHERE);
    let preuve = AssertUnwindSafe(preuve(u));
    ne_suffit_pas(move || {
        let k = promesses::DISTANCE_SPHERE;
        prouver(rayons(u, promesses::PERDUE).map(|[a, b]| de_a(a, b)), k, |x| {
            distance_d_une_sphere(u, &preuve, bande, x)
        })
    });
}

/// For a way out with A ahead or behind: p, AB², −p·D², the t with the one and with the other under the root, and the
/// divisor of t.
fn sortie_d_une_sphere<T: Taille>(devant: bool) -> [Place; 6] {
    let (objet, ray) = (sphere::<T>().into(), rayon(S));
    let sorties = programmes(9, &objet, |objet: &ObjetRay<Trace<T>>| objet.sortie(&ray));
    let sorties = sorties.into_iter().filter_map(|t| match cotes!(t, Quotient).map(op) {
        [Op::Somme(_, ab), _] if devant && matches!(op(ab), Op::Racine(_)) => Some((de(ab), t)),
        [_, Op::Difference(_, ab)] if !devant => Some((de(ab), t)),
        _ => None,
    });
    let (de_w1, de_s4): (Vec<_>, Vec<_>) =
        sorties.partition(|(ab2, _)| matches!(op(*ab2), Op::Produit(..)));
    let t = de_s4[0].1;
    let p = de(cotes!(de_w1[0].0, Produit)[0]);
    [p, de_s4[0].0, de_w1[0].0, t, de_w1[0].1, cotes!(t, Quotient)[1]]
}

/// From outside −p has no root, so t takes the place of that.
fn devant<T: Taille>() -> [Place; 6] {
    let [p, ab2, p_d2, t, _, d2] = sortie_d_une_sphere::<T>(true);
    [p, ab2, p_d2, t, t, d2]
}

fn derriere<T: Taille>() -> [Place; 6] {
    sortie_d_une_sphere::<T>(false)
}

/// What a ray that leaves the sphere of radius 1 at the cosine c and the distance t needs, in u·κt, with A at `sa`.
fn distance_de_sortie(
    u: f64,
    preuve: &Preuve<6>,
    derriere: bool,
    [t, c, sa]: [Intervalle; 3],
    [p, f]: [Intervalle; 2],
) -> Intervalle {
    let [de_p, de_ab2, de_p_d2, de_t, de_t_w1, de_s] = preuve.noeuds;
    let lettres = [
        ("S", 1.0, nombre(i(0.0))),
        ("C", 1.0, vecteur(sa, sinus(c))),
        ("r", 1.0, nombre(i(1.0))),
        ("D", DEGRE_DE_D, nombre(i(1.0))),
    ];
    let erreur = || {
        let dits =
            [(de_p, p, Rien), (de_ab2, c.carre(), Rien), (de_p_d2, -p, Rien), (de_t, t, Rien)];
        let boite = preuve.boite(u, &lettres, &dits)?;
        let (e_ab2, e_p) = (boite.erreur(de_ab2)?, boite.erreur(de_p_d2)?);
        // The error with an AB² that is given apart from what else rounds. With A behind, the divisor is no nearer to 0
        // than the root of `au_moins`.
        let avec = |ab2: Encore, au_moins: f64| {
            let s = de_a(f64::MIN, -(positif(i(au_moins)).racine() * plus(-2.0, u)).bas);
            let mut dits = vec![(de_p, p, Rien), (de_ab2, c.carre(), ab2), (de_t, t, Rien)];
            dits.extend(derriere.then_some((de_s, sa - c, Calcule(s))));
            ou_rien(preuve.boite(u, &lettres, &dits).and_then(|boite| boite.erreur(de_t)))
        };
        let (exact, e_moins) = (c.carre(), e_ab2.min(e_p + sa.carre()));
        let de_trop = |ab2: Intervalle| avec(Erreur(de_a(0.0, ab2.haut.max(0.0))), exact.bas);
        // W1 takes −p·D², which is exactly SA² less than AB², if that is more. Then t is that of the other program. It
        // also lies between the t of S4 and the t of an AB² that is too large by the error of −p·D².
        let q = positif(-p).racine();
        let ecart = par(t * sa.carre(), (q - sa) * (c + q));
        let de_w1 = ou_rien(boite.erreur(de_t_w1)) + ou_rien(ecart);
        let entre = ou_rien(boite.erreur(de_t)).max(de_trop(e_p - sa.carre()));
        let possible = sa.carre().bas <= (e_ab2 + e_p).haut;
        // If not, AB² as computed is no less than −p·D². If it is too small, t lies between that of W1 and that of the
        // exact AB². Whether too small or too large, t is off by no more than the slopes there give.
        let au_moins = (exact - e_moins).bas;
        let un = avec(Calcule(de_a(au_moins, exact.haut)), au_moins)
            .min(avec(Erreur(de_a(-e_moins.haut, 0.0)), au_moins))
            .min(de_w1.max(de_trop(i(0.0))));
        let autre = avec(Calcule(de_a(exact.bas, (exact + e_ab2).haut)), exact.bas);
        let de_s4 = un.max(autre.min(de_trop(e_ab2)));
        Some(if possible { de_s4.max(de_w1.min(entre)) } else { de_s4 })
    };
    ou_rien(erreur()) * c / (u * (f + 1.0 + t)) * plus(40.0, u)
}

#[test]
fn lemme_10_la_borne_de_sortie_d_une_sphere_suffit() {
    let (devant, derriere) = (de_chaque_type!(devant), de_chaque_type!(derriere));
    let k = promesses::SORTIE_SPHERE;
    let large = |u: f64, f: Intervalle| bandes::SPHERE * u * (f + 1.0);
    let devant = |u: f64, [b, c]: [Intervalle; 2]| {
        let s = sinus(c);
        let f = (b.carre() + s.carre()).racine();
        let dehors = (c.carre() / (1.0 + s)).haut <= large(u, f).bas;
        let p = b.carre() - c.carre();
        (!dehors).then(|| distance_de_sortie(u, devant(u), false, [b + c, c, b], [p, f]))
    };
    // The sign of SA may be wrong: A is ahead as computed from 4u|f| behind on, and behind up to as far ahead.
    let derriere = |u: f64, [y, c]: [Intervalle; 2]| {
        let p = y * (y - 2.0) * c.carre();
        let f = (1.0 + p).racine();
        let sa = (y - 1.0) * c;
        let dehors = (-p / (1.0 + f)).haut <= large(u, f).bas || sa.bas > 4.1 * u;
        (!dehors).then(|| distance_de_sortie(u, derriere(u), true, [y * c, c, sa], [p, f]))
    };
    let cosinus = |u: f64| [u.sqrt(), 1.0];
    for (quoi, [bas, haut]) in [("10 A ahead", [1.0, 0.5]), ("10 A at S", [-4.2, 1.0])] {
        let haut = |u: f64| if bas > 0.0 { haut / u } else { haut * u };
        tenir_au_large(quoi, k, |u| {
            prouver(sur(quoi, u, [[bas * u, haut(u)], cosinus(u)]), k, |x| devant(u, x))
        });
    }
    let domaine = |u: f64| [[u, 1.0 + 4.0 * u.sqrt()], cosinus(u)];
    prouve_sur("10 K of a sphere", k, domaine, derriere);
}

/// p and AB², as an entry computes them.
fn signes<T: Taille>() -> [Place; 2] {
    let [p, ab2, ..] = entree_d_une_sphere::<T>();
    [p, ab2]
}

/// By how much p and AB² are off, as a part of how far they are from 0 outside of the band: the radius is 1, A is `b`
/// ahead, AC is `k`, and |loin² − 1| exceeds the width of the band there.
fn signes_surs(u: f64, preuve: &Preuve<2>, [b, k]: [Intervalle; 2]) -> Option<Intervalle> {
    let f = (b.carre() + k.carre()).racine();
    let lettres = [
        ("S", 1.0, nombre(i(0.0))),
        ("C", 1.0, vecteur(b, k)),
        ("r", 1.0, nombre(i(1.0))),
        ("D", DEGRE_DE_D, nombre(i(1.0))),
    ];
    let boite = preuve.boite(u, &lettres, &[]);
    let [p, ab2] = [0, 1].map(|quoi| {
        let loin = [f, k][quoi];
        let large = bandes::SPHERE * u * (f + 1.0) * (loin + 1.0);
        let sans_signe = 1.0 - loin.carre();
        let exact = sans_signe.max(-sans_signe).max(i(0.0));
        let erreur = ou_rien(boite.as_ref().and_then(|boite| boite.erreur(preuve.noeuds[quoi])));
        erreur / i(large.bas.max(exact.bas))
    });
    Some(p.max(ab2))
}

/// Up to |f| = r/2u; `constantes.rs` has the rest.
#[test]
fn lemme_3_la_bande_d_une_sphere_suffit() {
    let preuve = de_chaque_type!(signes);
    for (quoi, [bas, haut]) in [("3 sphere", [1e-12, 0.5]), ("3 sphere, amid", [0.0, 1e-12])] {
        let haut = |u: f64| if bas > 0.0 { haut / u } else { haut };
        tenir_au_large(quoi, 1.0, |u| {
            let domaine = sur(quoi, u, [[u, 0.5 / u], [bas, haut(u)]]);
            prouver(domaine, 1.0, |x| signes_surs(u, preuve(u), x))
        });
    }
}
