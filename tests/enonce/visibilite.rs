//! Two points of surfaces: whether they see each other, beside an exact answer.

use std::path::Path;

use commun::fabrique::{avec_arbre, boite, mur, sphere};
use commun::oracle::{dehors, verite};
use commun::regimes::{direction, entre};
use commun::{arrondi, en_f32_et_f64};
use exemples::scene::Scene;
use fastrand::Rng;
use lancer_rayon::{
    BoiteGeo, Intersection, Monde, ObjetRay, Rayon, Reel, Rotation, Texture, Vecteur,
    premiere_intersection,
};
use serde::de::DeserializeOwned;

/// Pairs of points in each scene.
const PAIRES: u32 = 20_000;

/// Pairs of a sensor on a wall, at each of these heights above the ground, and a point of the ground.
const CAPTEURS: u32 = 2_000;
const HAUTEURS: [f64; 3] = [0.01, 0.002, 0.001];

/// Houses in streets, some of them turned, on level ground.
fn ville<R: Reel>() -> Vec<ObjetRay<R>> {
    let mut alea = Rng::with_seed(40);
    let haut = arrondi(Vecteur::new(0.0, 1.0, 0.0));
    let mut objets: Vec<ObjetRay<R>> = vec![mur(Vecteur::NUL, haut)];
    for (i, j) in (-6..6).flat_map(|i| (-6..6).map(move |j| (i, j))) {
        let [x, z] = [i, j].map(|k| 20.0 * f64::from(k) + entre(&mut alea, -2.0, 2.0));
        let h = entre(&mut alea, 4.0, 30.0);
        let dimensions = Vecteur::new(entre(&mut alea, 8.0, 14.0), h, entre(&mut alea, 8.0, 14.0));
        let lacet = if alea.bool() { 0.0 } else { entre(&mut alea, -0.5, 0.5) };
        let tour = Rotation::new(arrondi(Vecteur::new(0.0, lacet, 0.0))).unwrap();
        let centre = arrondi(Vecteur::new(x, h / 2.0, z));
        objets.push(boite(centre, arrondi(dimensions), tour));
    }
    objets
}

fn atelier<R: Reel + DeserializeOwned>() -> Vec<ObjetRay<R>> {
    let chemin = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/scenes/atelier.ron");
    Scene::lire(&chemin).unwrap().objets.into_iter().map(Into::into).collect()
}

/// A point that is seen from somewhere above a scene of this extent.
fn point<R: Reel>(objets: &[ObjetRay<R>], etendue: f64, alea: &mut Rng) -> Intersection<R> {
    loop {
        let mut lieu = |haut: f64| {
            let v = direction(alea) * etendue;
            Vecteur::new(v.x, haut * alea.f64() * etendue, v.z)
        };
        let (de, vers) = (lieu(0.6), lieu(0.1));
        // From inside an object one sees points that it hides from all others.
        if objets.iter().any(|objet| objet.contient(arrondi(de))) {
            continue;
        }
        let rayon = Rayon::new(arrondi(de), arrondi(vers - de)).unwrap();
        let touche = premiere_intersection(objets, &rayon).ok();
        if let Some(touche) = touche.filter(|t| t.distance().vers_f64() < 4.0 * etendue) {
            return touche;
        }
    }
}

/// A sensor this high on the wall of a house.
fn capteur<R: Reel>(objets: &[ObjetRay<R>], haut: f64, alea: &mut Rng) -> Intersection<R> {
    loop {
        let de = Vecteur::new(entre(alea, -110.0, 110.0), haut, entre(alea, -110.0, 110.0));
        let vers = direction(alea);
        let rayon = Rayon::new(arrondi(de), arrondi(Vecteur::new(vers.x, 0.0, vers.z))).unwrap();
        if let Ok(touche) = premiere_intersection(objets, &rayon) {
            return touche;
        }
    }
}

/// A point of the ground under the open sky, no farther than some streets from here.
fn du_sol<R: Reel>(objets: &[ObjetRay<R>], ici: Vecteur, alea: &mut Rng) -> Intersection<R> {
    loop {
        let de = ici + Vecteur::new(entre(alea, -60.0, 60.0), 90.0, entre(alea, -60.0, 60.0));
        let bas = Vecteur::new(0.0, -1.0, 0.0);
        let rayon = Rayon::new(arrondi(de), arrondi(bas)).unwrap();
        match premiere_intersection(objets, &rayon) {
            Ok(touche) if touche.indice() == 0 => return touche,
            Ok(_) | Err(_) => {}
        }
    }
}

/// Whether the ray enters one of these objects before its end, exactly; `None` if that is nearer than the
/// end is known.
fn cache<'a, R: Reel>(
    objets: impl Iterator<Item = &'a ObjetRay<R>>,
    rayon: &Rayon<R>,
) -> Option<bool> {
    let longueur = rayon.temoin_f64().direction().longueur();
    let fin = rayon.fin().vers_f64() / longueur;
    let rayon = &rayon.jusqu_a(R::INFINI).unwrap();
    // Those that are certainly passed by need no exact numbers.
    let proches = objets.filter(|o| !o.est_certain(rayon) || o.intersection(rayon).is_ok());
    let entrees = proches.filter_map(|objet| verite(objet, rayon).entree);
    let premiere = entrees.map(|entree| entree.t.vers_f64()).fold(f64::INFINITY, f64::min);
    // The distance is good to 3.6u (lemma 11), and rounds here.
    let jeu = 5.0 * R::U.vers_f64() * fin;
    ((premiere - fin).abs() > jeu).then_some(premiere < fin)
}

/// What the recipe of the documents says of two points, and whether that is right: the same both ways, and of a list
/// cut in two.
fn se_voient<R: Reel>(
    monde: &Monde<'_, R>,
    depart: &Intersection<R>,
    cible: &Intersection<R>,
) -> Option<bool> {
    let rayon = match depart.vers_touche(cible) {
        Ok(rayon) => rayon,
        Err(erreur) => {
            assert!(["lumiere", "cible"].contains(&erreur.champ), "{erreur}");
            return None;
        }
    };
    let libre = !monde.sans(cible.indice()).est_occulte(&rayon);
    let objets = monde.objets();
    let (avant, apres) = (&objets[..cible.indice()], &objets[cible.indice() + 1..]);
    let coupee = [avant, apres].iter().any(|part| Monde::de_liste(part).est_occulte(&rayon));
    assert_eq!(libre, !coupee);
    // The object that the ray leaves never stands in its way; nor would that to which it goes, exactly.
    let depart = objets[depart.indice()];
    assert!(
        depart.intersection(&rayon.jusqu_a(R::INFINI).unwrap()).is_err(),
        "hidden by its own start: {depart:?} {rayon:?}"
    );
    let autres = avant.iter().chain(apres).filter(|objet| **objet != depart);
    let exacte = cache(autres, &rayon);
    assert!(exacte.is_none_or(|cache| cache != libre), "{libre}, but {exacte:?}: {rayon:?}");
    Some(libre)
}

fn deux_points_se_voient_si_rien_n_est_entre_eux<R: Reel + DeserializeOwned>() {
    for (nom, objets, etendue) in [("city", ville::<R>(), 120.0), ("atelier", atelier(), 6.0)] {
        let monde = avec_arbre(&objets);
        let mut alea = Rng::with_seed(39);
        let (mut vus, mut caches, mut dos) = (0, 0, 0);
        let mut naifs = [0; 2];
        let mut juger = |a: Intersection<R>, b: Intersection<R>| {
            let [p, q] = [a, b].map(|touche| touche.point());
            // What one writes at first.
            let obvie = !Monde::de_liste(&objets).est_occulte(&Rayon::entre(p, q).unwrap());
            let libre = se_voient(&monde, &a, &b);
            assert_eq!(se_voient(&monde, &b, &a), libre, "{nom}: one way: {a:?} {b:?}");
            match libre {
                None => {
                    let v = q - p;
                    let penche =
                        |n: Vecteur<R>| n.produit_scalaire(v).vers_f64() / v.longueur().vers_f64();
                    let face = penche(a.normale()).min(-penche(b.normale()));
                    assert!(face < 1e-4, "{nom}: both face, and no ray: {a:?} {b:?}");
                    dos += 1;
                }
                Some(true) => vus += 1,
                Some(false) => caches += 1,
            }
            naifs[usize::from(obvie)] += u32::from(obvie != (libre == Some(true)));
            libre
        };
        for _ in 0..PAIRES {
            let a = point(&objets, etendue, &mut alea);
            juger(a, point(&objets, etendue, &mut alea));
        }
        let hauteurs = if nom == "city" { &HAUTEURS[..] } else { &[] };
        for &haut in hauteurs {
            let paire = |_| {
                let mur = capteur(&objets, haut, &mut alea);
                let ici = mur.point().vers_f64();
                juger(du_sol(&objets, ici, &mut alea), mur)
            };
            let reponses: Vec<_> = (0..CAPTEURS).filter_map(paire).collect();
            let vus = reponses.iter().filter(|libre| **libre).count();
            println!("{nom}, {haut} high: {vus} of {} seen", reponses.len());
            assert!(vus > 100 && reponses.len() - vus > 100);
        }
        println!(
            "{nom}: {vus} seen, {caches} hidden, {dos} turned away, at first {naifs:?} wrongly hidden and seen"
        );
        assert!(vus > PAIRES / 40 && caches > PAIRES / 40, "{nom}");
        assert!(naifs[0] > vus / 10, "{nom}: the obvious hides {} of {vus} only", naifs[0]);
    }
}

en_f32_et_f64!(deux_points_se_voient_si_rien_n_est_entre_eux);

/// What the recipe says of two points, of a list.
fn voit<R: Reel>(
    objets: &[ObjetRay<R>],
    depart: &Intersection<R>,
    cible: &Intersection<R>,
) -> Option<(Rayon<R>, bool)> {
    let rayon = depart.vers_touche(cible).ok()?;
    let (avant, apres) = (&objets[..cible.indice()], &objets[cible.indice() + 1..]);
    let cache = [avant, apres].iter().any(|part| Monde::de_liste(part).est_occulte(&rayon));
    Some((rayon, !cache))
}

/// At the foot of a turned wall rounding sets starts inside the wall or under the ground, of which a ray that comes there
/// knows and one that leaves does not; and a ball that the line grazes may be hit one way and missed the other.
/// Nowhere else does it matter which of two points is named first.
fn a_un_joint_ou_au_ras_d_un_tiers_l_ordre_compte<R: Reel>() {
    let mut alea = Rng::with_seed(41);
    let haut = Vecteur::new(0.0, 1.0, 0.0);
    let sol: ObjetRay<R> = mur(Vecteur::NUL, arrondi(haut));
    let boule = |c: Vecteur, r: f64| sphere(arrondi(c), R::depuis_f64(r));
    let [mut au_joint, mut au_ras, mut memes] = [0; 3];
    for i in 0..PAIRES {
        let tour = Rotation::new(arrondi(haut * entre(&mut alea, -3.0, 3.0))).unwrap();
        let cotes = arrondi(Vecteur::new(2.0, 2.0, 2.0));
        let mur = BoiteGeo::new(arrondi(haut), cotes, tour, Texture(2)).unwrap().vers_ray();
        let [n, _, le_long] = mur.normales().map(Vecteur::vers_f64);
        let au_pied = n + le_long * entre(&mut alea, -0.9, 0.9);
        let lustre = n * entre(&mut alea, 3.0, 5.0) + haut * 2.0;
        let mut objets = vec![sol, boule(lustre, 0.5)];
        let joint = i % 2 == 0;
        if joint {
            objets.push(mur.into());
        }
        let vers = |ou: Vecteur, de: Vecteur| {
            let rayon = Rayon::new(arrondi(de), arrondi(ou - de)).unwrap();
            premiere_intersection(&objets, &rayon).unwrap()
        };
        let a = vers(au_pied, au_pied + n * entre(&mut alea, 0.1, 1.0) + haut);
        let b = vers(lustre + le_long * entre(&mut alea, -0.2, 0.2), n * 2.0 + haut * 0.5);
        if !joint {
            let [p, q] = [a, b].map(|touche| touche.point().vers_f64());
            let travers = (q - p).produit_vectoriel(direction(&mut alea)).unitaire().unwrap();
            let r = entre(&mut alea, 0.01, 0.1);
            objets.push(boule((p + q) * 0.5 + travers * r, r));
        }
        let [aller, retour] = [voit(&objets, &a, &b), voit(&objets, &b, &a)];
        let (Some((aller, libre)), Some((retour, egalement))) = (aller, retour) else {
            assert!(aller.is_none() && retour.is_none());
            continue;
        };
        if libre == egalement {
            memes += 1;
        } else if joint {
            // The wall at a point of the ground, the ground at one of the wall.
            let tiers = objets[2 - a.indice()];
            let hauteur = dehors(&tiers, aller.source());
            assert!(hauteur < 16.0 * R::U.vers_f64(), "clear of its neighbour: {a:?} {b:?}");
            au_joint += 1;
        } else {
            let de_bande = |rayon| verite(&objets[2], rayon).dans_la_marge;
            assert!([aller, retour].iter().any(de_bande), "clear of the ball: {a:?} {b:?}");
            au_ras += 1;
        }
    }
    println!("{au_joint} at seams, {au_ras} beside a ball, {memes} alike");
    assert!(au_joint > 10 && au_ras > 10 && memes > PAIRES / 4);
}

en_f32_et_f64!(a_un_joint_ou_au_ras_d_un_tiers_l_ordre_compte);
