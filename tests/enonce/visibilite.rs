//! Whether two points of surfaces see each other, beside an exact answer.

use commun::fabrique::{avec_arbre, boite, mur, sphere};
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::oracle::{dehors, verite};
use commun::regimes::{direction, entre};
use commun::{arrondi, en_f32_et_f64};
use lancer_rayon::{
    Intersection, Monde, ObjetRay, Rayon, Reel, Rotation, Vecteur, premiere_intersection,
};

/// Pairs of points.
const PAIRES: u32 = 20_000;

/// In every other pair one point is a sensor on a wall, at one of these heights above the ground.
const HAUTEURS: [f64; 3] = [0.01, 0.002, 0.001];

/// Houses in streets, some of them turned, on level ground.
fn ville<R: Reel>() -> Vec<ObjetRay<R>> {
    let alea = &mut Hasard::de_graine(40);
    let mut objets: Vec<ObjetRay<R>> = vec![mur(Vecteur::NUL, Vecteur::Y)];
    for (i, j) in (-6..6).flat_map(|i| (-6..6).map(move |j| (i, j))) {
        let [x, z] = [i, j].map(|k| 20.0 * f64::from(k) + entre(alea, -2.0, 2.0));
        let h = entre(alea, 4.0, 30.0);
        let cotes = Vecteur::new(entre(alea, 8.0, 14.0), h, entre(alea, 8.0, 14.0));
        let lacet = if alea.bool() { 0.0 } else { entre(alea, -0.5, 0.5) };
        let tour = Rotation::new(arrondi(Vecteur::Y * lacet)).unwrap();
        objets.push(boite(arrondi(Vecteur::new(x, h / 2.0, z)), arrondi(cotes), tour));
    }
    objets
}

/// A point of the town that is seen from somewhere above it, or a sensor this high on the wall of a house.
fn point<R: Reel>(
    monde: &Monde<'_, R>,
    capteur: Option<f64>,
    alea: &mut Hasard,
) -> Option<Intersection<R>> {
    let mut lieu =
        |haut| Vecteur::new(entre(alea, -110.0, 110.0), haut, entre(alea, -110.0, 110.0));
    let (de, vers) = match capteur {
        Some(haut) => (lieu(haut), lieu(haut)),
        None => (lieu(40.0), lieu(0.0)),
    };
    // From inside an object one would see points that it hides from everywhere else.
    if monde.contient(arrondi(de)) {
        return None;
    }
    monde.premiere_intersection(&Rayon::new(arrondi(de), arrondi(vers - de)).ok()?).ok()
}

/// A point of the ground under the open sky, at most some streets from `ici`.
fn du_sol<R: Reel>(
    monde: &Monde<'_, R>,
    ici: Vecteur,
    alea: &mut Hasard,
) -> Option<Intersection<R>> {
    let de = ici + Vecteur::new(entre(alea, -60.0, 60.0), 90.0, entre(alea, -60.0, 60.0));
    let touche = monde.premiere_intersection(&Rayon::new(arrondi(de), -Vecteur::Y).ok()?).ok();
    touche.filter(|touche| touche.indice() == 0)
}

/// Whether the ray enters one of these objects before its end, exactly; `None` if the two are nearer to each other than
/// the end is known.
fn cache<'a, R: Reel>(
    objets: impl Iterator<Item = &'a ObjetRay<R>>,
    rayon: &Rayon<R>,
) -> Option<bool> {
    let longueur = rayon.temoin_f64().direction().longueur();
    let fin = rayon.fin().vers_f64() / longueur;
    let rayon = &rayon.jusqu_a(R::INFINI).unwrap();
    // Objects that the ray certainly passes by need no exact numbers.
    let proches = objets.filter(|o| !o.est_certain(rayon) || o.intersection(rayon).is_ok());
    let entrees = proches.filter_map(|objet| verite(objet, rayon).entree);
    let premiere = entrees.map(|entree| entree.t.vers_f64()).fold(f64::INFINITY, f64::min);
    // The distance is good to 3.6u (lemma 11), and rounds here.
    let jeu = 5.0 * R::U.vers_f64() * fin;
    ((premiere - fin).abs() > jeu).then_some(premiere < fin)
}

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

/// The recipe is right, and its answer is the same both ways.
fn deux_points_se_voient_si_rien_n_est_entre_eux<R: Reel>() {
    let objets = ville::<R>();
    let monde = avec_arbre(&objets);
    let [mut vus, mut caches, mut dos, mut naifs] = [0; 4];
    let faire = |alea: &mut Hasard| {
        let capteur = (alea.tour % 2 == 1).then(|| *alea.choix(&HAUTEURS));
        let a = point(&monde, capteur, alea)?;
        let b = match capteur {
            Some(_) => du_sol(&monde, a.point().vers_f64(), alea),
            None => point(&monde, None, alea),
        };
        Some((a, b?))
    };
    pour_chaque(2 * PAIRES, faire, |paire| {
        let Some((a, b)) = paire else { return };
        let [aller, retour] = [voit(&monde, &a, &b), voit(&monde, &b, &a)];
        assert_eq!(aller.map(|(_, libre)| libre), retour.map(|(_, libre)| libre), "one way");
        let Some((rayon, libre)) = aller else {
            let v = b.point() - a.point();
            let penche = |n: Vecteur<R>| n.produit_scalaire(v).vers_f64() / v.longueur().vers_f64();
            let face = penche(a.normale()).min(-penche(b.normale()));
            assert!(face < 1e-4, "both face, and no ray");
            dos += 1;
            return;
        };
        // The object that the ray leaves never hides the other point, nor, in exact arithmetic, would the object to
        // which it goes.
        let [depart, cible] = [a, b].map(|touche| touche.indice());
        let sans_fin = rayon.jusqu_a(R::INFINI).unwrap();
        assert!(objets[depart].intersection(&sans_fin).is_err(), "hidden by its own start");
        let autres = objets.iter().enumerate().filter(|(i, _)| ![depart, cible].contains(i));
        let exacte = cache(autres.map(|(_, objet)| objet), &rayon);
        assert!(exacte.is_none_or(|cache| cache != libre), "{libre}, but {exacte:?}: {rayon:?}");
        *(if libre { &mut vus } else { &mut caches }) += 1;
        // What one writes at first.
        let obvie = Rayon::entre(a.point(), b.point()).unwrap();
        naifs += u32::from(libre && Monde::de_liste(&objets).est_occulte(&obvie));
    });
    assert!(vus > PAIRES / 20 && caches > PAIRES / 20 && dos > 100);
    assert!(naifs > vus / 10, "the obvious hides {naifs} of {vus} only");
}

en_f32_et_f64!(deux_points_se_voient_si_rien_n_est_entre_eux);

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
