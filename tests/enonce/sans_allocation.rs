//! No question allocates, and neither does making objects, transformations and rays.
//!
//! The crate is `#![no_std]` without `alloc`, so that its own code cannot allocate. This test covers the
//! crates that it calls as well.

use std::hint::black_box;
use std::ops::ControlFlow::Continue;

use allocation_counter::measure;
use commun::scenes::{melange, rayons_camera};
use commun::{arrondi, en_f32_et_f64};
use lancer_rayon::pour_les_tests::Reglage;
use lancer_rayon::{
    BoiteGeo, ErreurGeo, Monde, NoIntersection, ObjetGeo, ObjetRay, PlanGeo, Rayon, Reel, Rotation,
    SphereGeo, Texture, Vecteur, places, premiere_intersection,
};
use recettes::milieux::{Marche, Matiere};

#[track_caller]
fn sans_allocation<T>(nom: &str, faire: impl FnOnce() -> T) -> T {
    let mut reponse = None;
    let allouees = measure(|| reponse = Some(black_box(faire())));
    assert_eq!(allouees.count_total, 0, "{nom} allocates");
    reponse.unwrap()
}

#[test]
fn le_compteur_compte() {
    assert_eq!(measure(|| drop(black_box(vec![0_u8; 100]))).count_total, 1);
}

fn un_de_chaque<R: Reel>() -> Result<[ObjetRay<R>; 3], ErreurGeo> {
    let v = |x, y, z| arrondi(Vecteur::new(x, y, z));
    let tour = Rotation::new(v(0.3, -0.2, 0.1))?.puis(Rotation::main_droite(v(1.0, 2.0, 3.0))?);
    let tour = Rotation::depuis_matrice(tour.inverse().matrice())?;
    let sphere = ObjetGeo::from(SphereGeo::new(v(0.0, 0.0, -5.0), R::UN, Texture(1))?);
    let plan = ObjetGeo::from(PlanGeo::new(tour, R::UN, Texture(2))?);
    let boite = BoiteGeo::new(v(1.0, 0.0, -7.0), v(1.0, 2.0, 3.0), tour, Texture(3))?;
    let [sphere, plan, boite] = [sphere, plan, boite.into()].map(|objet| {
        let objet = objet.translation(v(0.0, 0.1, 0.0))?.rotation(tour)?;
        Ok(objet.homothetie(R::depuis_f64(2.0))?.vers_ray())
    });
    Ok([sphere?, plan?, boite?])
}

/// A walk through media allocates for its first rays, and then no more.
#[test]
fn une_marche_n_alloue_qu_au_debut() {
    let scene = melange::<f64>(300);
    let matieres = vec![Matiere::Pleine { priorite: 0, indice: 1.5 }; scene.len()];
    let mut marche = Marche::new(Monde::de_liste(&scene), &matieres);
    let rayons = rayons_camera::<f64>(20, 20);
    let mut tous = || {
        let mut passages = 0;
        for rayon in &rayons {
            passages += marche.cordes(rayon).len();
            marche.partir(*rayon);
            for _ in 0..20 {
                let Some(surface) = marche.avancer(f64::INFINITY).unwrap() else { break };
                marche.passer(&surface).unwrap();
                passages += 1;
            }
        }
        passages
    };
    let passages = tous();
    assert!(passages > 400, "{passages}");
    assert_eq!(sans_allocation("a walk", tous), passages);
}

fn aucune_question_n_alloue<R: Reel>() {
    let objets = sans_allocation("making objects", un_de_chaque::<R>);
    assert!(objets.is_ok());
    let refus = || SphereGeo::new(Vecteur::NUL, -R::UN, Texture(0));
    assert!(sans_allocation("an error", refus).is_err());

    let [objet, autre, _] = objets.unwrap();
    let seul = [objet];
    let etendue = sans_allocation("etendue", || Monde::de_liste(&seul).etendue()).unwrap();
    let rayon = Rayon::new(Vecteur::NUL, etendue.bas + etendue.haut).unwrap();
    let touche = objet.intersection(&rayon).unwrap();
    sans_allocation("erreur", || objet.erreur(&rayon, &touche));
    sans_allocation("est_certain", || autre.est_certain(&rayon));
    let refus = sans_allocation("vers_touche", || touche.vers_touche(&touche));
    assert!(refus.is_err());

    let scene = melange::<R>(300);
    let rayons = rayons_camera::<R>(40, 40);
    let mut touches = vec![Err(NoIntersection); rayons.len()];
    for (nom, reglage) in Reglage::tous() {
        sans_allocation(nom, || {
            let liste = reglage.monde(Monde::de_liste(&scene));
            liste.premieres_intersections(&rayons, &mut touches)
        })
        .unwrap();
    }
    // With room for the pieces of long boxes.
    let tour = Rotation::new(arrondi(Vecteur::new(0.3, -0.2, 0.1))).unwrap();
    let dimensions = arrondi(Vecteur::new(0.1, 9.0, 0.1));
    let poutre = BoiteGeo::new(Vecteur::NUL, dimensions, tour, Texture(4)).unwrap();
    let scene = [scene, vec![poutre.into(); 20]].concat();
    let mut places = vec![0.0; 2 * places(scene.len())];
    let monde = sans_allocation("a tree", || Monde::en_morceaux(&scene, &mut places)).unwrap();
    for (nom, reglage) in Reglage::tous() {
        let monde = reglage.monde(monde);
        sans_allocation(nom, || monde.premieres_intersections(&rayons, &mut touches)).unwrap();
        for rayon in &rayons {
            let questions = || {
                let touche = monde.premiere_intersection(black_box(rayon));
                let mut premieres = [Err(NoIntersection); 3];
                let autres = monde.parmi(|indice| indice % 3 > 0);
                let nombre = autres.dans_l_ordre(rayon, &mut premieres);
                let court = rayon.jusqu_a(R::UN).unwrap();
                let mut entrees = 0;
                monde.visiter(rayon, |_, _| {
                    entrees += 1;
                    Continue(rayon.fin())
                });
                monde.contenants(rayon.source(), |_| entrees += 1);
                (
                    touche.is_ok(),
                    autres.premiere_intersection(&court).is_ok(),
                    monde.certifie(rayon, &touche),
                    nombre,
                    entrees,
                    monde.est_occulte(&court),
                )
            };
            sans_allocation(nom, questions);
        }
    }
    let ombres: Vec<_> = rayons.iter().map(|rayon| rayon.jusqu_a(R::UN).unwrap()).collect();
    let mut occultes = vec![false; ombres.len()];
    sans_allocation("sont_occultes", || {
        Monde::de_liste(&scene).sont_occultes(&ombres, &mut occultes)?;
        monde.sont_occultes(&ombres, &mut occultes)
    })
    .unwrap();
    for (rayon, touche) in rayons.iter().zip(&touches) {
        let seule = sans_allocation("premiere_intersection", || {
            premiere_intersection(&scene, black_box(rayon))
        });
        assert_eq!(seule, *touche);
        let Ok(touche) = touche else { continue };
        let secondaire = sans_allocation("secondaire", || {
            let vers = Rayon::new(rayon.source(), touche.normale())?;
            touche.secondaire(vers.direction())
        });
        assert!(secondaire.is_ok());
    }
}

en_f32_et_f64!(aucune_question_n_alloue);
