//! The oracle itself: where a quotient of any fixed number of bits would decide wrongly, and how much it grants.

use commun::fabrique::{boite_droite, mur, sphere};
use commun::mesure::lieu_permis;
use commun::oracle::verite;
use commun::promesses::profondeur_a;
use lancer_rayon::{Nombre, Rayon, Vecteur};

/// A ray passes an edge of a box of size 2⁴⁴⁰ at 2⁻⁴⁰⁰: entry and exit agree in 839 bits.
#[test]
fn une_arete_est_decidee_a_2_puissance_moins_839_pres() {
    let deux = |e: f64| e.exp2();
    let s = Vecteur::new(-deux(440.0), 0.0, 0.0);
    let rayon = Rayon::new(s, Vecteur::new(1.0, 1.0, 0.0)).unwrap();
    assert_eq!(rayon.direction().x, rayon.direction().y);
    let dimensions = Vecteur::new(1.0, 1.0, 1.0) * deux(440.0);
    for (x, touchee) in [(deux(-400.0), false), (0.0, true), (-deux(-400.0), true)] {
        let c = Vecteur::new(x, 0.0, 0.0);
        let verite = verite(&boite_droite(c, dimensions), &rayon);
        assert_eq!(verite.entree.is_some(), touchee, "{x:e}");
        assert!(verite.dans_la_marge);
    }
}

/// Straight down on objects of size 1 about O, or half-spaces through it: what oracles grant, here and there computed
/// by hand, to a twentieth.
#[test]
fn un_oracle_accorde_ce_que_disent_les_pages() {
    let (o, un, u) = (Vecteur::<f32>::NUL, Vecteur::new(1.0, 1.0, 1.0), f64::from(f32::U));
    let (sol, cube) = (mur(o, Vecteur::Z), boite_droite(o, un + un));
    let boule = sphere(o, 1.0);
    // The height of S, that of the surface, how deep X may be, and how far outside P.
    for (objet, de, a, profond, dehors) in [
        (sol, 4.0, 0.0, 8.0 * 4.0, 3.1 * 4.0 + 6.1 * 4.0),
        (cube, 4.0, 1.0, 9.1 * 3.0 + 4.0 * 3_f64.sqrt(), 4.1 * 4.0 + 12.1 * 3.0 + 1.1),
        (boule, 1.5, 1.0, 2.0 * 0.5 + 23.5, 13.0 * 2.5 + 1.1 * 0.5 + 1.1),
        (boule, 4.0, 1.0, 12.5 * 3.0 + 22.5, 13.0 * 5.0 + 1.1 * 3.0 + 1.1),
    ] {
        let rayon = Rayon::new(Vecteur::Z * de, -Vecteur::Z).unwrap();
        let t = de - a;
        for part in [0.95, 1.05] {
            let mesure = profondeur_a(&objet, &rayon, f64::from(t) + part * profond * u);
            assert_eq!(mesure > 1.0, part > 1.0, "{mesure}: {objet:?}");
        }
        let permis = lieu_permis(&objet, &rayon, t) / u;
        assert!((permis / dehors - 1.0).abs() < 0.05, "{permis}, not {dehors}: {objet:?}");
    }
}
