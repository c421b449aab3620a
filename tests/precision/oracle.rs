//! The oracle itself, where a quotient of any fixed number of bits would decide wrongly.

use commun::fabrique::boite_droite;
use commun::oracle::verite;
use lancer_rayon::{Rayon, Vecteur};

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
