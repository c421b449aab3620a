//! A version of this crate, asked in its four ways. Whoever compiles this file says which, as `super::version`; it may
//! be any from 0.7.0 on.

use super::concurrents::{self, Concurrent, FACONS, cachee};
use super::version::pour_les_tests::Reglage;
use super::version::{
    self, Monde, NoIntersection, ObjetRay, Rayon, Reel, Reponse, premiere_intersection,
};

/// The rays of this version.
pub type Rayons<R> = Vec<Rayon<R>>;

/// Rays with these sources, unit directions, ends and δ.
pub fn rayons<R: Reel>(nombres: impl Iterator<Item = ([[R; 3]; 2], [R; 2])>) -> Rayons<R> {
    let rayon = |([source, direction], [fin, flou]): ([[R; 3]; 2], [R; 2])| {
        Rayon::new(source.into(), direction.into())?.jusqu_a(fin)?.avec_flou(flou)
    };
    nombres.map(|nombres| rayon(nombres).expect("a ray within the limits")).collect()
}

/// `fois` times the numbers that a tree over `n` objects needs.
pub fn memoire(fois: usize, n: usize) -> Vec<f32> {
    vec![0.0; fois * version::places(n)]
}

/// A world of these objects with a tree, asked with the instructions of this name, or otherwise with the best of the
/// machine. Long boxes are cut if more places are lent than needed.
pub fn monde<'a, R: Reel>(
    objets: &'a [ObjetRay<R>],
    places: &'a mut [f32],
    jeu: &str,
) -> Monde<'a, R> {
    let monde = if places.len() > version::places(objets.len()) {
        Monde::en_morceaux(objets, places)
    } else {
        Monde::new(objets, places)
    };
    let monde = monde.expect("as many places as it takes");
    let reglage = Reglage::tous().find(|(nom, _)| *nom == jeu);
    reglage.map_or(monde, |(_, reglage)| reglage.monde(monde))
}

/// All four ways to ask for the first hits of these rays, or whether they are shadows.
pub fn concurrents<'a, R: Reel>(
    monde: Monde<'a, R>,
    rayons: &'a [Rayon<R>],
    ombres: bool,
) -> [Concurrent<'a>; 4] {
    const COMPLET: &str = "as many answers as rays";
    let [a, b, c, d] = FACONS;
    let objets = monde.objets();
    let liste = Monde::de_liste(objets);
    if ombres {
        let en_lot = |monde: Monde<'a, R>| {
            move |rayons: &[_], caches: &mut [_]| {
                monde.sont_occultes(rayons, caches).expect(COMPLET);
            }
        };
        [
            Concurrent::un_par_un(a, rayons, move |rayon| liste.est_occulte(rayon), cachee),
            Concurrent::en_lot(b, rayons, false, en_lot(liste), cachee),
            Concurrent::un_par_un(c, rayons, move |rayon| monde.est_occulte(rayon), cachee),
            Concurrent::en_lot(d, rayons, false, en_lot(monde), cachee),
        ]
    } else {
        let rien = Err(NoIntersection);
        let en_lot = |monde: Monde<'a, R>| {
            move |rayons: &[_], touches: &mut [_]| {
                monde.premieres_intersections(rayons, touches).expect(COMPLET);
            }
        };
        [
            Concurrent::un_par_un(a, rayons, |rayon| premiere_intersection(objets, rayon), dire),
            Concurrent::en_lot(b, rayons, rien, en_lot(liste), dire),
            Concurrent::un_par_un(c, rayons, move |rayon| monde.premiere_intersection(rayon), dire),
            Concurrent::en_lot(d, rayons, rien, en_lot(monde), dire),
        ]
    }
}

/// This answer in the common form.
pub fn dire<R: Reel>(touche: Reponse<R>) -> concurrents::Reponse {
    let touche = touche.ok()?;
    let n = touche.normale();
    let nombres = [touche.distance(), n.x, n.y, n.z, touche.marge()];
    Some((nombres.map(|x| x.vers_f64().to_bits()), touche.texture().0))
}
