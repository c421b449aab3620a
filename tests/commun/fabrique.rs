//! Short names for making objects, all with texture 0. They panic on what a constructor refuses.

use lancer_rayon::{
    BoiteGeo, Monde, ObjetGeo, ObjetRay, PlanGeo, Reel, Rotation, SphereGeo, Texture, Vecteur,
    places,
};

use crate::conversion::arrondi;

/// The vector of these numbers, each rounded.
pub fn v<R: Reel>(x: f64, y: f64, z: f64) -> Vecteur<R> {
    arrondi(Vecteur::new(x, y, z))
}

pub fn sphere<R: Reel>(centre: Vecteur<R>, rayon: R) -> ObjetRay<R> {
    SphereGeo::new(centre, rayon, Texture(0)).unwrap().into()
}

/// A half-space whose surface passes through this point; its outward normal may have any length.
pub fn mur<R: Reel>(point: Vecteur<R>, normale: Vecteur<R>) -> ObjetRay<R> {
    PlanGeo::par_un_point(point, normale, Texture(0)).unwrap().into()
}

pub fn boite<R: Reel>(centre: Vecteur<R>, cotes: Vecteur<R>, tour: Rotation<R>) -> ObjetRay<R> {
    BoiteGeo::new(centre, cotes, tour, Texture(0)).unwrap().into()
}

/// A box along the axes.
pub fn boite_droite<R: Reel>(centre: Vecteur<R>, cotes: Vecteur<R>) -> ObjetRay<R> {
    boite(centre, cotes, Rotation::IDENTITE)
}

/// A world of these objects with a tree, whose memory is leaked.
pub fn avec_arbre<R: Reel>(objets: &[ObjetRay<R>]) -> Monde<'_, R> {
    Monde::new(objets, vec![0.0; places(objets.len())].leak()).unwrap()
}

/// The walls of a cube of side `cote`: half-spaces, or boxes of a given thickness that reach a given length beyond its
/// corners.
pub fn murs<R: Reel>(
    milieu: Vecteur<R>,
    tour: Rotation<R>,
    cote: f64,
    boites: Option<[f64; 2]>,
) -> Vec<ObjetGeo<R>> {
    let nombre = R::depuis_f64;
    let mur = |axe: usize, signe: f64| {
        let n = tour.axes()[axe] * nombre(signe);
        let Some([epaisseur, depasse]) = boites else {
            let p = milieu + n * nombre(cote / 2.0);
            return PlanGeo::par_un_point(p, -n, Texture(0)).unwrap().into();
        };
        let mut cotes = [nombre(cote + 2.0 * depasse); 3];
        cotes[axe] = nombre(epaisseur);
        let centre = milieu + n * nombre((cote + epaisseur) / 2.0);
        BoiteGeo::new(centre, cotes.into(), tour, Texture(0)).unwrap().into()
    };
    (0..6).map(|i| mur(i / 2, f64::from(1 - 2 * (i as i8 % 2)))).collect()
}
