//! The oracle itself: where a quotient of any fixed number of bits would decide wrongly, and how much it grants.

use commun::fabrique::{boite_droite, mur, sphere};
use commun::mesure::{au_bord, lieu_permis};
use commun::oracle::verite;
use commun::passages::est_a_fleur;
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

/// How wide the bands are by which an oracle excuses a wrong decision, and what it grants of a distance and of a normal,
/// here and there computed by hand. A wider band, or a larger grant, would excuse every test that asks the oracle.
#[test]
fn la_bande_d_un_oracle_est_celle_des_pages() {
    let (o, un, u) = (Vecteur::<f32>::NUL, Vecteur::new(1.0, 1.0, 1.0), f64::from(f32::U));
    let (sol, cube, boule) = (mur(o, Vecteur::Z), boite_droite(o, un + un), sphere(o, 1.0));
    let proche = |x: f64, y: f64| (x / y - 1.0).abs() < 0.01;
    let peu = 100.0 * f32::U;
    // Past the cube and past the ball by 100u, and 100u steep to the floor: how many bands that is.
    let (racine, diagonale) = (17_f64.sqrt(), 3_f64.sqrt());
    for (objet, source, vers, bandes) in [
        (cube, [1.0 + peu, 0.0, 4.0], [0.0, 0.0, -1.0], 7.1 * (racine + diagonale) + 3.1 * 5.0),
        (boule, [1.0 + peu, 0.0, 4.0], [0.0, 0.0, -1.0], 4.0 * (racine + 1.0)),
        (sol, [0.0, 0.0, 4.0], [1.0, 0.0, -peu], 3.1),
    ] {
        let verite = verite(&objet, &Rayon::new(source.into(), vers.into()).unwrap());
        let facteur = verite.facteur();
        assert!(proche(facteur, 100.0 / bandes), "{facteur}: {objet:?}");
        assert_eq!(verite.dans_la_marge, facteur <= 1.0);
    }
    // Straight down, from 4 away: K, κt and the sine of the angle by which a normal may be off.
    for (objet, a, k, kappa_t) in [
        (sol, 0.0, 4.1, 4.0 + 4.0),
        (cube, 1.0, 5.3, 4.0 + diagonale + 3.0),
        (boule, 1.0, 5.6, 4.0 + 1.0 + 3.0),
    ] {
        let rayon = Rayon::new(Vecteur::Z * 4.0, -Vecteur::Z).unwrap();
        let entree = verite(&objet, &rayon).entree.unwrap();
        assert!(entree.k == k && proche(entree.kappa_t, kappa_t), "{objet:?}");
        assert!(entree.ecart(4.0_f32 - a) == 0.0 && proche(entree.ecart(4.5_f32 - a), 0.5));
        let penche = |x: f32| entree.ecart_de_normale(Vecteur::new(x, 0.0, 1.0));
        assert!(penche(0.0) == 0.0 && proche(penche(0.75), 0.6), "{objet:?}");
        assert_eq!(entree.ecart_de_normale(-Vecteur::<f32>::Z), 1.0);
    }
    // Aslant a flat face takes 3.1u of the cosine, and a sphere is lost if its radius is less than 64u|f|.
    let rase = Rayon::new(Vecteur::Z * 4.0, Vecteur::new(1.0, 0.0, -peu)).unwrap();
    let cosinus = verite(&sol, &rase).entree.unwrap().cosinus / u;
    assert!(proche(cosinus, 100.0 - 3.1), "{cosinus}");
    for (r, k, permis) in [(66.0, 5.6, 4.1 * (u + 1.0 / 66.0)), (62.0, 6.2, f64::INFINITY)] {
        let rayon = Rayon::new(Vecteur::Z, -Vecteur::Z).unwrap();
        let entree = verite(&sphere(o, r * f32::U), &rayon).entree.unwrap();
        let direction = entree.direction_permise::<f32>(0.0);
        assert!(entree.k == k && (direction == permis || proche(direction, permis)), "{direction}");
        let de_plus = entree.direction_permise::<f32>(u) - direction;
        assert!(direction == f64::INFINITY || proche(de_plus, 1.0 / f64::from(r)), "{de_plus}");
    }
}

/// How far above the plane of a second face a ray may start that was sent in beside an edge, computed by hand; and how
/// deep a ray may start in an object that its δ still lets it touch.
#[test]
fn un_oracle_excuse_ce_que_disent_les_pages() {
    let (o, un, u) = (Vecteur::<f32>::NUL, Vecteur::new(1.0, 1.0, 1.0), f32::U);
    let (sol, cube) = (mur(o, Vecteur::Z), boite_droite(o, un + un));
    let dessus = Rayon::new(Vecteur::new(1.0 - 64.0 * u, 0.0, 4.0), -Vecteur::Z).unwrap();
    let touche = cube.intersection(&dessus).unwrap();
    // 4.1u|f|, 12.1ut and twice 1.1u|P|; the margin is nearly 0 here.
    let permis = 4.1 * 17_f32.sqrt() + 12.1 * 3.0 + 2.0 * 1.1 * 2_f32.sqrt();
    for (haut, excuse) in [(0.9 * permis, true), (1.1 * permis, false), (-4.0 * permis, false)] {
        let depart = Vecteur::new(1.0 + haut * u, 0.0, 1.0 - 64.0 * u);
        let de_cote = Rayon::new(Vecteur::new(2.0, 0.0, 0.5), -Vecteur::X).unwrap();
        let encore = cube.intersection(&de_cote).unwrap();
        assert_eq!(au_bord(&cube, &dessus, &touche, depart, &encore), excuse, "{haut}u");
        assert!(!au_bord(&cube, &dessus, &touche, depart, &touche), "the same face");
    }
    for (profond, a_fleur) in [(0.99, true), (1.01, false)] {
        let rayon = Rayon::new(-Vecteur::Z * profond, -Vecteur::Z).unwrap();
        assert!(!est_a_fleur(&sol, &rayon));
        let rayon = rayon.avec_flou(1.0).unwrap();
        assert_eq!(est_a_fleur(&sol, &rayon), a_fleur, "{profond}");
        assert!(!est_a_fleur(&sol, &rayon.dedans()));
    }
}
