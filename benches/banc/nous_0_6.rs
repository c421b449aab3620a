//! What `nous.rs` is, for a version up to 0.6.0: it had a `Hierarchie`, free functions for lists, and rays without an
//! end. `ab.sh` takes this page for a revision that has `src/hierarchie.rs`.

use super::concurrents::{Concurrent, FACONS, Reponse, cachee};
use super::version::pour_les_tests::Reglage;
use super::version::{
    Hierarchie, NoIntersection, ObjetRay, Rayon, Reel, Touche, est_occulte, premiere_intersection,
    premieres_intersections, sont_occultes,
};

/// The rays of this version; and each with the distance of the lamp that it goes to, as shadows were asked about.
pub struct Rayons<R> {
    rayons: Vec<Rayon<R>>,
    ombres: Vec<(Rayon<R>, R)>,
}

/// These sources, unit directions and ends.
pub fn rayons<R: Reel>(nombres: impl Iterator<Item = ([R; 3], [R; 3], R)>) -> Rayons<R> {
    let ombre = |(source, direction, fin): ([R; 3], [R; 3], R)| {
        let rayon = Rayon::new(source.into(), direction.into());
        (rayon.expect("a ray within the limits"), fin)
    };
    let ombres: Vec<_> = nombres.map(ombre).collect();
    Rayons { rayons: ombres.iter().map(|(rayon, _)| *rayon).collect(), ombres }
}

/// So many times the numbers that a tree over `n` objects needs.
pub fn memoire(fois: usize, n: usize) -> Vec<f32> {
    vec![0.0; fois * Hierarchie::places(n)]
}

/// These objects with a tree, asked with the instructions of this name, or else with the best of the machine. Long boxes
/// are cut if more is lent than need be.
pub fn monde<'a, R: Reel>(
    objets: &'a [ObjetRay<R>],
    places: &'a mut [f32],
    jeu: &str,
) -> Hierarchie<'a, R> {
    let hierarchie = Hierarchie::new(objets, places).expect("as many places as it takes");
    let reglage = Reglage::tous().find(|(nom, _)| *nom == jeu);
    reglage.map_or(hierarchie, |(_, reglage)| reglage.hierarchie(hierarchie))
}

/// All four, about the first hits of these rays, or about whether they are shadows. A first hit does not know of an end:
/// no such ray of the families has one.
pub fn concurrents<'a, R: Reel>(
    h: Hierarchie<'a, R>,
    Rayons { rayons, ombres }: &'a Rayons<R>,
    des_ombres: bool,
) -> [Concurrent<'a>; 4] {
    const COMPLET: &str = "as many answers as rays";
    let (objets, [a, b, c, d]) = (h.objets(), FACONS);
    if des_ombres {
        let liste = |ombres: &[_], caches: &mut [_]| {
            sont_occultes(objets, ombres, caches).expect(COMPLET);
        };
        let arbre = move |ombres: &[_], caches: &mut [_]| {
            h.sont_occultes(ombres, caches).expect(COMPLET);
        };
        [
            Concurrent::un_par_un(a, ombres, |(r, max)| est_occulte(objets, r, *max), cachee),
            Concurrent::en_lot(b, ombres, false, liste, cachee),
            Concurrent::un_par_un(c, ombres, move |(r, max)| h.est_occulte(r, *max), cachee),
            Concurrent::en_lot(d, ombres, false, arbre, cachee),
        ]
    } else {
        let rien = Err(NoIntersection);
        let liste = |rayons: &[_], touches: &mut [_]| {
            premieres_intersections(objets, rayons, touches).expect(COMPLET);
        };
        let arbre = move |rayons: &[_], touches: &mut [_]| {
            h.premieres_intersections(rayons, touches).expect(COMPLET);
        };
        [
            Concurrent::un_par_un(a, rayons, |rayon| premiere_intersection(objets, rayon), dire),
            Concurrent::en_lot(b, rayons, rien, liste, dire),
            Concurrent::un_par_un(c, rayons, move |rayon| h.premiere_intersection(rayon), dire),
            Concurrent::en_lot(d, rayons, rien, arbre, dire),
        ]
    }
}

/// This answer in the words of all.
pub fn dire<R: Reel>(touche: Touche<R>) -> Reponse {
    let touche = touche.ok()?;
    let n = touche.normale();
    let nombres = [touche.distance(), n.x, n.y, n.z, touche.marge()];
    Some((nombres.map(|x| x.vers_f64().to_bits()), touche.texture().0))
}
