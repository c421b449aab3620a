//! Raw bytes made into objects, transformations, rays and paths: every value is refused or valid, and every answer to
//! every ray and every point is what it must be, alone, in a batch and with a tree, among all objects and among a
//! choice of them.

#![no_main]

mod octets;
mod relire;

use lancer_rayon::{
    Monde, ObjetGeo, ObjetRay, PlacesInsuffisantes, Rayon, Reponse, Vecteur, places,
};
use libfuzzer_sys::fuzz_target;
use serde::Serialize;
use serde::de::DeserializeOwned;

use commun::Bits;
use commun::chemins::suivre;
use commun::choisis::{Choisis, choisir, exiger_les_certificats, un_choix_inconstant};
use commun::facons::comparer;
use commun::passages::{exiger_apres_coup, exiger_les_passages};
use commun::promesses;

use crate::octets::{Lecture, Octets};
use crate::relire::relire;

/// How many pairs of a ray and an object are judged by exact integers, how many are asked alone, and how many in every
/// way.
const EXACTS: usize = 3;
const SEULS: usize = 128;
const ENSEMBLE: usize = 4096;

/// Places that are one too few are refused.
fn trop_peu_de_places<R: Bits>(objets: &[ObjetRay<R>]) {
    let necessaires = places(objets.len());
    if let Some(places) = necessaires.checked_sub(1) {
        let mut pretees = vec![0.0; places];
        let refus = [
            Monde::new(objets, &mut pretees).err(),
            Monde::en_morceaux(objets, &mut pretees).err(),
        ];
        assert_eq!(refus, [Some(PlacesInsuffisantes { places, necessaires }); 2]);
    }
}

/// An object and a ray in the other precision: in `f64` they are as they were, and they come back from there; in `f32`
/// a ray has a δ that is no smaller.
fn changer_de_precision<R: Bits>(objet: ObjetGeo<R>, rayon: &Rayon<R>, origine: Vecteur<R>) {
    let double = rayon.temoin_f64();
    assert_eq!(double.source(), rayon.source().vers_f64());
    assert_eq!([double.fin(), double.flou()], [rayon.fin(), rayon.flou()].map(R::vers_f64));
    for simple in [double.vers_f32(Vecteur::NUL), rayon.vers_f32(origine)].into_iter().flatten() {
        assert_eq!(simple.fin(), rayon.fin().vers_f64() as f32, "{rayon:?}");
        let (flou, la) = (rayon.flou().vers_f64(), f64::from(simple.flou()));
        assert_eq!(flou > 0.0, la > 0.0, "{rayon:?}");
        assert!(la >= flou || simple.flou() == f32::MAX, "{rayon:?}");
    }
    if size_of::<R>() == 4 {
        let [ici, la] = [rayon.temoin_f64(), rayon.vers_f32(Vecteur::NUL).unwrap().temoin_f64()];
        assert_eq!((ici.source(), ici.direction()), (la.source(), la.direction()));
        let la = objet.vers_f32(Vecteur::NUL).unwrap().vers_ray().temoin_f64();
        assert_eq!(la, objet.vers_ray().temoin_f64());
    }
    let _ = objet.vers_f32(origine);
}

fn attaquer<R: Bits + Serialize + DeserializeOwned>(octets: &[u8]) -> Option<()> {
    // Two choices and what is left out between them, how many places an order has, and how many more the tree has.
    let (&[un, sauf, deux, rangs, plus], octets) = octets.split_first_chunk()?;
    let Lecture { objets: decrits, rayons: droits, chemins, limites, points } =
        Octets::<R>::new(octets).lire();
    let objets: Vec<_> = decrits.iter().map(|objet| objet.vers_ray()).collect();
    let doubles: Vec<_> = objets.iter().map(|objet| objet.temoin_f64()).collect();
    // The second tree has long boxes cut into pieces, and the first perhaps some.
    let necessaires = places(objets.len());
    let [mut memoire, mut autre] =
        [necessaires + 28 * usize::from(plus), 6 * necessaires].map(|places| vec![0.0; places]);
    let monde = Monde::en_morceaux(&objets, &mut memoire).unwrap();
    let en_double = Monde::en_morceaux(&doubles, &mut autre).unwrap();
    let chemins = chemins.iter().flat_map(|(de, dedans, pas)| suivre(monde, *de, *dedans, pas));
    let mut rayons: Vec<_> = chemins.chain(droits).collect();
    rayons.truncate(ENSEMBLE / objets.len().max(16));
    let sans_fin: Vec<_> = rayons.iter().map(|r| r.jusqu_a(R::INFINI).unwrap()).collect();
    comparer(&objets, &sans_fin);
    trop_peu_de_places(&objets);
    for rayon in &rayons {
        exiger_les_certificats(monde, en_double, rayon);
    }
    let paires = rayons.iter().zip(rayons.iter().cycle().skip(1));
    let paires = paires.flat_map(|deux| objets.iter().map(move |objet| (objet, deux)));
    // Where pairs are many, only some of them are asked.
    let de_suite = rayons.len() * objets.len() / SEULS | 1;
    for (i, (objet, (rayon, suivant))) in paires.step_by(de_suite).enumerate() {
        exiger_les_passages(objet, rayon, suivant.direction());
        exiger_apres_coup(objet, [rayon, suivant]);
        if i < EXACTS {
            promesses::exiger(objet, rayon, suivant.direction());
        }
    }
    for (objet, rayon) in decrits.iter().zip(&rayons).take(8) {
        let touche: Reponse<R> = monde.premiere_intersection(rayon);
        relire(objet);
        relire(rayon);
        relire(&touche);
        changer_de_precision(*objet, rayon, points.first().copied().unwrap_or(Vecteur::NUL));
    }
    for monde in [monde, Monde::de_liste(&objets)] {
        choisir(monde, [un, sauf, deux]).interroger(&rayons, &limites, &points, rangs);
        let pris = (0..objets.len()).collect();
        let tous = Choisis { monde, pris, facon: String::new() };
        tous.interroger(&rayons, &limites, &points, rangs);
    }
    un_choix_inconstant(monde, &rayons, rangs);
    Some(())
}

fuzz_target!(|octets: &[u8]| {
    if let Some((genre, reste)) = octets.split_first() {
        let _ = if genre % 2 == 0 { attaquer::<f32>(reste) } else { attaquer::<f64>(reste) };
    }
});
