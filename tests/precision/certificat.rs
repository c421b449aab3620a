//! The certificate of a scene: where `certifie` is true, exact arithmetic names the same first object, or none.
//!
//! `LANCER_RAYON_CAS` is how many times 300 scenes of each kind are judged (1 unless set).

use std::cmp::Ordering;

use commun::conversion::voisin;
use commun::fabrique::{boite, boite_droite, mur, sphere, v};
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::oracle::{Exact, verite};
use commun::regimes::{Cas, direction, entre, presque, regimes};
use commun::{Bits, arrondi, en_f32_et_f64};
use lancer_rayon::{
    Monde, NoIntersection, Nombre, ObjetRay, Rayon, Reel, Rotation, Texture, Vecteur, places,
    premiere_intersection,
};

/// The first object of a list in exact arithmetic; of two at one distance the earlier. What lies at the end of the ray
/// or beyond it, or beyond the largest number, does not count.
fn premier_exact<R: Reel>(objets: &[ObjetRay<R>], rayon: &Rayon<R>) -> Option<usize> {
    let plus_grand = if size_of::<R>() == 4 { f32::MAX.into() } else { f64::MAX };
    let plus_grand = Exact::de(rayon.fin().vers_f64().min(plus_grand));
    let mut premier: Option<(usize, Exact)> = None;
    for (i, objet) in objets.iter().enumerate() {
        let Some(entree) = verite(objet, rayon).entree else { continue };
        let avant = premier.as_ref().map_or(&plus_grand, |(_, t)| t);
        // The oracle rounds to 256 bits, but a tie stays a tie.
        if (&entree.t - avant).signe() == Ordering::Less {
            premier = Some((i, entree.t));
        }
    }
    premier.map(|(i, _)| i)
}

/// Judges the answer of a list to a ray, by the list itself and by two trees of it, the second of which has long boxes
/// cut into pieces, and then two wrong answers; returns whether the answer is certain. The same is judged with an end
/// at the ray's first two hits and beside them.
fn juger<R: Bits>(objets: &[ObjetRay<R>], rayon: &Rayon<R>) -> bool {
    let certaine = juger_jusqu_a_la_fin(objets, rayon);
    let mut deux = [Err(NoIntersection); 2];
    Monde::de_liste(objets).dans_l_ordre(rayon, &mut deux);
    for t in deux.iter().flatten().map(|touche| touche.distance()) {
        for fin in [t, voisin(t, -1), voisin(t, 1)] {
            juger_jusqu_a_la_fin(objets, &rayon.jusqu_a(fin).unwrap());
        }
    }
    certaine
}

fn juger_jusqu_a_la_fin<R: Reel>(objets: &[ObjetRay<R>], rayon: &Rayon<R>) -> bool {
    let touche = premiere_intersection(objets, rayon);
    let mut memoires = [1, 6].map(|fois| vec![0.0; fois * places(objets.len())]);
    let [memoire, grande] = memoires.each_mut();
    let mondes = [Monde::new(objets, memoire), Monde::en_morceaux(objets, grande)];
    let exact = premier_exact(objets, rayon);
    let certaine = Monde::de_liste(objets).certifie(rayon, &touche);
    let contexte = || format!("{touche:?}, but {exact:?}: {objets:?} {rayon:?}");
    let dite = touche.ok().map(|touche| touche.indice());
    assert!(!certaine || dite == exact, "{}", contexte());
    for objet in objets.iter().filter(|objet| objet.est_certain(rayon)) {
        let seul = premier_exact(core::slice::from_ref(objet), rayon);
        assert_eq!(seul.is_some(), objet.intersection(rayon).is_ok(), "{objet:?} {rayon:?}");
    }
    for monde in mondes.map(Result::unwrap) {
        let par_l_arbre = monde.certifie(rayon, &touche);
        assert!(!par_l_arbre || dite == exact, "by the tree: {}", contexte());
        // The tree leaves out what the list must look at.
        assert!(par_l_arbre || !certaine, "less certain by the tree: {}", contexte());
        // Two wrong answers are the first hit without the true object, and a miss.
        let Some(exact) = exact else { continue };
        let suivante = monde.sans(exact).premiere_intersection(rayon);
        for fausse in [suivante, Err(NoIntersection)] {
            assert!(
                !Monde::de_liste(objets).certifie(rayon, &fausse),
                "{fausse:?}: {}",
                contexte()
            );
            assert!(!monde.certifie(rayon, &fausse), "tree, {fausse:?}: {}", contexte());
        }
    }
    certaine
}

/// The hard cases of each shape, with twins in front and behind that are entered at nearly the same distance.
fn parmi_des_jumeaux_rien_de_faux_n_est_certifie<R: Bits>() {
    let mut combien = [0; 2];
    for regime in regimes::<R>() {
        let faire = |alea: &mut Hasard| {
            let Cas { objet, rayon } = (regime.cas)(alea);
            // Some have enough objects for a tree.
            let n = [1, 3, 12][alea.usize(0..3)];
            let mut objets = alea.liste(n, |alea, _| presque(&objet, Texture(1), alea));
            objets.push(objet);
            alea.melanger(&mut objets);
            (objets, rayon)
        };
        pour_chaque(commun::cas(300) / 4, faire, |(objets, rayon)| {
            combien[usize::from(juger(&objets, &rayon))] += 1;
        });
    }
    let [incertaines, certaines] = combien;
    assert!(certaines > incertaines / 10 && incertaines > certaines / 10);
}

/// Cubes side by side, with rays exactly or almost along axes and in the planes of their sides.
fn parmi_des_cubes_accoles_rien_de_faux_n_est_certifie<R: Bits>() {
    let faire = |alea: &mut Hasard| {
        let cote = *alea.choix(&[1.0, 0.5, 0.1, 0.3]);
        let objets = alea.liste(27, |alea, _| {
            let [x, y, z] = [(); 3].map(|()| f64::from(alea.u8(0..3)) * cote);
            boite_droite(v(x, y, z), v(cote, cote, cote))
        });
        let grille = |alea: &mut Hasard| f64::from(alea.i8(-2..=6)) * 0.5 * cote;
        let source = v(grille(alea), grille(alea), 5.0 * cote);
        let pente = |alea: &mut Hasard| {
            let quelconque = entre(alea, -0.3, 0.3);
            *alea.choix(&[0.0, 0.0, 1e-9, -1e-17, 1e-300, 0.25, quelconque])
        };
        let vers = v(pente(alea), pente(alea), -1.0);
        (objets, Rayon::<R>::new(source, vers).unwrap())
    };
    let mut certaines = 0;
    pour_chaque(commun::cas(300), faire, |(objets, rayon)| {
        certaines += u32::from(juger(&objets, &rayon));
    });
    assert!(certaines > commun::cas(300) / 4);
}

/// A heap of things on a floor at 0, with rays that come near no decision.
fn dans_un_tas_tout_rayon_clair_est_certifie<R: Bits>() {
    let faire = |alea: &mut Hasard| {
        let objets = alea.liste(40, |alea, i| {
            let ou = arrondi(direction(alea) * 3.0 + Vecteur::new(0.0, 2.0, 0.0));
            let r = R::depuis_f64(entre(alea, 0.1, 1.0));
            match i {
                0 => mur(Vecteur::NUL, Vecteur::Y),
                _ if i % 2 == 0 => sphere(ou, r),
                _ => {
                    let tour = Rotation::new(arrondi(direction(alea) * 3.0)).unwrap();
                    boite(ou, Vecteur::new(r, r, r + r), tour)
                }
            }
        });
        let source = direction(alea) * 9.0 + Vecteur::new(0.0, 9.0, 0.0);
        let vers = direction(alea) * 3.0 + Vecteur::new(0.0, 2.0, 0.0) - source;
        (objets, Rayon::new(arrondi(source), arrondi(vers)).unwrap())
    };
    pour_chaque(commun::cas(300), faire, |(objets, rayon)| {
        assert!(juger(&objets, &rayon));
        let Ok(touche) = premiere_intersection(&objets, &rayon) else { return };
        // A miss before the first hit is certain too, and so is the hit before an end well beyond it.
        for part in [0.5, 1.01] {
            let fin = touche.distance() * R::depuis_f64(part);
            assert!(juger_jusqu_a_la_fin(&objets, &rayon.jusqu_a(fin).unwrap()), "{part}");
        }
    });
}

en_f32_et_f64!(parmi_des_jumeaux_rien_de_faux_n_est_certifie);
en_f32_et_f64!(parmi_des_cubes_accoles_rien_de_faux_n_est_certifie);
en_f32_et_f64!(dans_un_tas_tout_rayon_clair_est_certifie);

/// Two half-spaces through O, with a source a few subnormals from it: distances of `f32` do not tell which of them the ray
/// enters first.
#[test]
fn a_quelques_sous_normaux_de_deux_murs_rien_n_est_certifie() {
    let plan = |x: f32, y, z| mur(Vecteur::NUL, Vecteur::new(x, y, z));
    let mut objets = vec![
        plan(0.31017277, -0.28852975, -0.90583855),
        plan(0.47415906, -0.83682054, -0.27368703),
    ];
    for i in 0..20_u8 {
        let centre = Vecteur::new(100.0 + f32::from(i), 0.0, 0.0);
        objets.push(sphere(centre, 0.1));
    }
    let source = Vecteur::new(-4.0, -2.0, -1.0) * f32::ETA;
    let rayon = Rayon::new(source, Vecteur::new(-0.5240927, 0.34185442, 0.78003997)).unwrap();
    assert_eq!(premier_exact(&objets, &rayon), Some(1));
    assert!(!juger(&objets, &rayon));
}
