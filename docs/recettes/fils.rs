//! A picture by several threads, with several rays for each pixel.

use std::thread;

use lancer_rayon::{Monde, NoIntersection, Rayon, Reel, Reponse, Vecteur};

/// The first hit of each ray, found by as many threads as the machine runs at once. The bits are those of one thread.
pub fn reponses<R: Reel>(monde: Monde<'_, R>, rayons: &[Rayon<R>]) -> Vec<Reponse<R>> {
    let mut touches = vec![Err(NoIntersection); rayons.len()];
    let fils = thread::available_parallelism().map_or(1, usize::from);
    // A batch takes 64 rays together.
    let part = rayons.len().div_ceil(fils).next_multiple_of(64).max(64);
    thread::scope(|portee| {
        for (rayons, touches) in rayons.chunks(part).zip(touches.chunks_mut(part)) {
            portee.spawn(move || {
                monde.premieres_intersections(rayons, touches).expect("a place for each ray")
            });
        }
    });
    touches
}

/// The first hit of each ray. `ordre`, which has each ray's index once, tells in which order they are found; the hits
/// stand as the rays do.
pub fn dans_cet_ordre<R: Reel>(
    monde: Monde<'_, R>,
    rayons: &[Rayon<R>],
    ordre: &[usize],
) -> Vec<Reponse<R>> {
    let mut touches = vec![Err(NoIntersection); rayons.len()];
    let ranges: Vec<_> = ordre.iter().map(|&i| rayons[i]).collect();
    for (&i, touche) in ordre.iter().zip(reponses(monde, &ranges)) {
        touches[i] = touche;
    }
    touches
}

/// The mean of each k × k pixels of a picture of width `largeur`, row by row: several rays for each pixel that remains.
pub fn moyennes(couleurs: &[Vecteur], largeur: usize, k: usize) -> Vec<Vecteur> {
    let mut image = vec![Vecteur::NUL; couleurs.len() / (k * k)];
    for (i, couleur) in couleurs.iter().enumerate() {
        image[i / largeur / k * (largeur / k) + i % largeur / k] += *couleur / (k * k) as f64;
    }
    image
}
