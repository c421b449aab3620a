//! Whether two points of surfaces see each other, asked from either.

use commun::fabrique::{boite, mur, sphere};
use commun::hasard::{Hasard, pour_chaque};
use commun::oracle::{dehors, verite};
use commun::regimes::{direction, entre};
use commun::{arrondi, en_f32_et_f64};
use lancer_rayon::{Intersection, Monde, Rayon, Reel, Rotation, Vecteur, premiere_intersection};

/// Pairs of points.
const PAIRES: u32 = 20_000;

/// What the recipe of the documents says of two points, and the ray that it uses.
fn voit<R: Reel>(
    monde: &Monde<'_, R>,
    depart: &Intersection<R>,
    cible: &Intersection<R>,
) -> Option<(Rayon<R>, bool)> {
    match depart.vers_touche(cible) {
        Ok(rayon) => Some((rayon, !monde.sans(cible.indice()).est_occulte(&rayon))),
        Err(erreur) => {
            assert!(["lumiere", "cible"].contains(&erreur.champ), "{erreur}");
            None
        }
    }
}

/// At the foot of a turned wall rounding puts starts inside the wall or under the ground, which a ray that comes there
/// knows and one that leaves does not. And a ball that the line grazes may be hit one way and missed the other. Nowhere
/// else does it matter which of two points is named first.
fn a_un_joint_ou_au_ras_d_un_tiers_l_ordre_compte<R: Reel>() {
    let haut = Vecteur::Y;
    let boule = |c: Vecteur, r: f64| sphere(arrondi(c), R::depuis_f64(r));
    let [mut au_joint, mut au_ras, mut memes] = [0; 3];
    let faire = |alea: &mut Hasard| {
        let tour = Rotation::new(arrondi(haut * entre(alea, -3.0, 3.0))).unwrap();
        let mur_tourne = boite(arrondi(haut), arrondi(Vecteur::new(2.0, 2.0, 2.0)), tour);
        let [n, _, le_long] = tour.axes().map(Vecteur::vers_f64);
        let au_pied = n + le_long * entre(alea, -0.9, 0.9);
        let lustre = n * entre(alea, 3.0, 5.0) + haut * 2.0;
        let mut objets = vec![mur(Vecteur::NUL, arrondi(haut)), boule(lustre, 0.5)];
        let joint = alea.tour.is_multiple_of(2);
        if joint {
            objets.push(mur_tourne);
        }
        let vers = |ou: Vecteur, de: Vecteur| {
            let rayon = Rayon::new(arrondi(de), arrondi(ou - de)).unwrap();
            premiere_intersection(&objets, &rayon).unwrap()
        };
        let a = vers(au_pied, au_pied + n * entre(alea, 0.1, 1.0) + haut);
        let b = vers(lustre + le_long * entre(alea, -0.2, 0.2), n * 2.0 + haut * 0.5);
        if !joint {
            let [p, q] = [a, b].map(|touche| touche.point().vers_f64());
            let travers = (q - p).produit_vectoriel(direction(alea)).unitaire().unwrap();
            let r = entre(alea, 0.01, 0.1);
            objets.push(boule((p + q) * 0.5 + travers * r, r));
        }
        (objets, joint, [a, b])
    };
    pour_chaque(PAIRES, faire, |(objets, joint, [a, b])| {
        let monde = Monde::de_liste(&objets);
        let [aller, retour] = [voit(&monde, &a, &b), voit(&monde, &b, &a)];
        let (Some((aller, libre)), Some((retour, egalement))) = (aller, retour) else {
            assert!(aller.is_none() && retour.is_none());
            return;
        };
        if libre == egalement {
            memes += 1;
        } else if joint {
            // The neighbour is the wall for the ground, and the ground for the wall.
            let hauteur = dehors(&objets[2 - a.indice()], aller.source());
            assert!(hauteur < 16.0 * R::U.vers_f64(), "clear of its neighbour");
            au_joint += 1;
        } else {
            let de_bande = |rayon| verite(&objets[2], rayon).dans_la_marge;
            assert!([aller, retour].iter().any(de_bande), "clear of the ball");
            au_ras += 1;
        }
    });
    assert!(au_joint > 10 && au_ras > 10 && memes > PAIRES / 4);
}

en_f32_et_f64!(a_un_joint_ou_au_ras_d_un_tiers_l_ordre_compte);
