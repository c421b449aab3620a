//! Scenes and rays that are the same on every run: what benches measure and what tests compare.

use std::f64::consts::{FRAC_PI_2, TAU};

use lancer_rayon::{
    BoiteGeo, ErreurGeo, ObjetGeo, ObjetRay, PlanGeo, Rayon, Reel, Rotation, SphereGeo, Texture,
    Vecteur,
};

use crate::conversion::arrondi;

/// Where the rays start; they look towards −z.
const CAMERA: Vecteur = Vecteur::new(0.0, 2.0, 6.0);

/// tan 25°: half of what the camera sees from top to bottom, one unit ahead of it.
const DEMI_CHAMP: f64 = 0.466_307_658_154_998_6;

/// `n` objects in view of the camera, object i with texture i: a floor at height 0, then spheres
/// and turned boxes by turns.
///
/// They shrink so that their volumes add up to the same for every n: the picture stays full,
/// and the more there are the more of them are hidden.
pub fn melange<R: Reel>(n: usize) -> Vec<ObjetRay<R>> {
    let taille = 2.5 / (n as f64).cbrt();
    let textures = (0..).map(Texture);
    let objets = textures.zip(suite_dense()).map(|(texture, alea)| match texture.0 {
        0 => sol(texture),
        i if i % 2 == 1 => sphere(taille, alea, texture),
        _ => boite(taille, alea, texture),
    });
    let objets = objets.map(|objet| objet.expect("a scene lies within every limit").vers_ray());
    objets.take(n).collect()
}

/// One ray through the middle of each pixel of a picture, row by row from the top left.
pub fn rayons_camera<R: Reel>(largeur: usize, hauteur: usize) -> Vec<Rayon<R>> {
    let pixel = 2.0 * DEMI_CHAMP / hauteur as f64;
    let cote = |i: usize, nombre: usize| (i as f64 + 0.5 - nombre as f64 / 2.0) * pixel;
    let rayon = |(ligne, colonne)| {
        let direction = Vecteur::new(cote(colonne, largeur), -cote(ligne, hauteur), -1.0);
        let direction = direction.unitaire().expect("a direction towards −z");
        Rayon::new(arrondi(CAMERA), arrondi(direction)).expect("a camera within the limits")
    };
    let pixels = (0..hauteur).flat_map(|ligne| (0..largeur).map(move |colonne| (ligne, colonne)));
    pixels.map(rayon).collect()
}

/// The rays of a square picture, every other one turned round, so that no probe of all of them tells boxes apart.
pub fn rayons_opposes<R: Reel>(cote: usize) -> Vec<Rayon<R>> {
    let mut rayons = rayons_camera::<R>(cote, cote);
    for rayon in rayons.iter_mut().step_by(2) {
        *rayon = Rayon::new(rayon.source(), -rayon.direction()).expect("within the limits");
    }
    rayons
}

/// The rows of a picture of this width, in tiles of 8 × 8.
pub fn en_tuiles<T: Copy>(rangees: &[T], largeur: usize) -> Vec<T> {
    let bandes = rangees.chunks(8 * largeur);
    let tuiles = bandes.flat_map(|bande| {
        (0..largeur).step_by(8).flat_map(move |debut| {
            let fin = largeur.min(debut + 8);
            bande.chunks(largeur).flat_map(move |rangee| &rangee[debut..fin])
        })
    });
    tuiles.copied().collect()
}

fn sol<R: Reel>(texture: Texture) -> Result<ObjetGeo<R>, ErreurGeo> {
    let couche = Rotation::new(arrondi(Vecteur::new(FRAC_PI_2, 0.0, 0.0)))?;
    Ok(PlanGeo::new(couche, R::ZERO, texture)?.into())
}

fn sphere<R: Reel>(taille: f64, alea: Alea, texture: Texture) -> Result<ObjetGeo<R>, ErreurGeo> {
    let rayon = taille * (0.5 + alea[3]);
    Ok(SphereGeo::new(arrondi(place(alea)), R::depuis_f64(rayon), texture)?.into())
}

fn boite<R: Reel>(taille: f64, alea: Alea, texture: Texture) -> Result<ObjetGeo<R>, ErreurGeo> {
    let [_, _, _, a, b, c] = alea;
    let dimensions = Vecteur::new(0.5 + a, 0.5 + b, 0.5 + c) * (1.6 * taille);
    let rotation = Rotation::new(arrondi(Vecteur::new(b, c, a) * TAU))?;
    Ok(BoiteGeo::new(arrondi(place(alea)), arrondi(dimensions), rotation, texture)?.into())
}

/// A point that the camera sees, 6 to 18 units ahead of it and not below the floor.
fn place([x, y, z, ..]: Alea) -> Vecteur {
    let profondeur = 6.0 + 12.0 * z;
    let haut = profondeur * DEMI_CHAMP;
    let bas = haut.min(CAMERA.y);
    CAMERA + Vecteur::new((2.0 * x - 1.0) * 1.5 * haut, (haut + bas) * y - bas, -profondeur)
}

/// Six numbers from 0 to 1.
type Alea = [f64; 6];

/// The points i·(1/g, 1/g², …, 1/g⁶) modulo 1, with g⁷ = g + 1: the golden section in six
/// dimensions, which spreads the first n points evenly whatever n.
fn suite_dense() -> impl Iterator<Item = Alea> {
    const G: f64 = 1.112_775_684_278_705_5;
    let mut puissance = 1.0;
    let pas = [(); 6].map(|()| {
        puissance /= G;
        puissance
    });
    (0_u32..).map(move |i| pas.map(|pas| (f64::from(i) * pas).fract()))
}
