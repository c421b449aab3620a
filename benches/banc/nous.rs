//! A version of this crate, asked in its four ways. Whoever compiles this page says which: `super::version`.

use super::concurrents::{Concurrent, FACONS, Reponse, cachee};
use super::version::{
    Hierarchie, NoIntersection, Rayon, Reel, Touche, est_occulte, premiere_intersection,
    premieres_intersections, sont_occultes,
};

/// All four, about the first hits of these rays, or about these shadows if there are any.
pub fn concurrents<'a, R: Reel>(
    h: Hierarchie<'a, R>,
    rayons: &'a [Rayon<R>],
    ombres: &'a [(Rayon<R>, R)],
) -> [Concurrent<'a>; 4] {
    const COMPLET: &str = "as many answers as rays";
    let (objets, [a, b, c, d]) = (h.objets(), FACONS);
    if ombres.is_empty() {
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
    } else {
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
    }
}

/// This answer in the words of all.
pub fn dire<R: Reel>(touche: Touche<R>) -> Reponse {
    let touche = touche.ok()?;
    let n = touche.normale();
    let nombres = [touche.distance(), n.x, n.y, n.z, touche.marge()];
    Some((nombres.map(|x| x.vers_f64().to_bits()), touche.texture().0))
}
