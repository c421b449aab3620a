//! A whole picture as a program makes it: rays made, asked, lit by a lamp and shaded, in tiles of 8 × 8 pixels and some
//! thousands of rays at a time.

use std::hint::black_box;
use std::time::{Duration, Instant};

use commun::conversion::arrondi;
use commun::scenes::en_tuiles;
use fastrand::Rng;
use lancer_rayon::{
    BoiteGeo, Lumiere, Monde, NoIntersection, ObjetGeo, ObjetRay, PlanGeo, Rayon, Reel, Reponse,
    Rotation, SphereGeo, Texture, Vecteur,
};

use crate::horloge::MORCEAU;

const LARGEUR: usize = 600;
const HAUTEUR: usize = 400;
pub const OEIL: [f64; 3] = [-1.0, 1.5, 4.0];
pub const REGARD: [f64; 3] = [0.3, -0.1, -1.0];
pub const LAMPE: [f64; 3] = [3.0, 9.0, 2.0];

/// The parts of a picture.
pub const PARTIES: [&str; 4] = ["rays", "hits", "light", "shading"];

/// Who paints: each part of some pixels, from what the part before has left.
pub trait Peintre {
    /// Makes the rays of these pixels, which lie in a picture at z = −1 before the camera.
    fn faire_les_rayons(&mut self, pixels: &[(f64, f64)]);
    fn lancer(&mut self);
    fn eclairer(&mut self);
    /// Puts N·L of each pixel, or 0, behind these.
    fn ombrer(&mut self, image: &mut Vec<f32>);
}

/// A floor, and `n` balls and turned boxes in turns over it.
pub fn objets(n: usize) -> Vec<ObjetGeo> {
    let alea = &mut Rng::with_seed(5);
    let plus_petits = (14.0 / n as f64).cbrt();
    let sol = PlanGeo::par_un_point(Vecteur::Y * -1.0, Vecteur::Y, Texture(0));
    let solide = |i| {
        let mut entre = |min, max| min + (max - min) * alea.f64();
        let centre = Vecteur::new(entre(-4.0, 4.0), entre(0.0, 3.0), entre(-9.0, -3.0));
        let demis = Vecteur::new(entre(0.3, 0.8), entre(0.3, 0.8), entre(0.3, 0.8)) * plus_petits;
        if i % 2 == 0 {
            return SphereGeo::new(centre, demis.x, Texture(1)).map(ObjetGeo::from);
        }
        let tour = Rotation::new(Vecteur::Y * entre(0.0, 6.0))?;
        BoiteGeo::new(centre, demis * 2.0, tour, Texture(2)).map(ObjetGeo::from)
    };
    let tous = std::iter::once(sol.map(ObjetGeo::from)).chain((0..n).map(solide));
    tous.collect::<Result<_, _>>().expect("objects within the limits")
}

/// The pixels of the picture, tile by tile.
pub fn pixels() -> Vec<(f64, f64)> {
    let pixel = |i: usize| {
        let (x, y) = ((i % LARGEUR) as f64 + 0.5, (i / LARGEUR) as f64 + 0.5);
        let [largeur, hauteur] = [LARGEUR, HAUTEUR].map(|cote| cote as f64 / 2.0);
        ((x - largeur) / largeur, (hauteur - y) / largeur)
    };
    en_tuiles(&(0..LARGEUR * HAUTEUR).map(pixel).collect::<Vec<_>>(), LARGEUR)
}

/// Paints the picture; the time of each of [`PARTIES`], and the picture.
pub fn peindre(peintre: &mut dyn Peintre, pixels: &[(f64, f64)]) -> ([Duration; 4], Vec<f32>) {
    let (mut durees, mut image) = ([Duration::ZERO; 4], Vec::with_capacity(pixels.len()));
    for pixels in pixels.chunks(MORCEAU) {
        let mut debut = Instant::now();
        let mut noter = |partie: usize| {
            let maintenant = Instant::now();
            durees[partie] += maintenant - std::mem::replace(&mut debut, maintenant);
        };
        peintre.faire_les_rayons(pixels);
        noter(0);
        peintre.lancer();
        noter(1);
        peintre.eclairer();
        noter(2);
        peintre.ombrer(&mut image);
        noter(3);
    }
    (durees, black_box(image))
}

/// This crate, as its guide says.
pub struct Nous<'a, R> {
    monde: Monde<'a, R>,
    camera: Rotation<R>,
    oeil: Vecteur<R>,
    lampe: Lumiere<R>,
    rayons: Vec<Rayon<R>>,
    touches: Vec<Reponse<R>>,
    cosinus: Vec<R>,
}

impl<'a, R: Reel> Nous<'a, R> {
    pub fn new(objets: &'a [ObjetRay<R>], places: &'a mut [f32]) -> Self {
        let camera = Rotation::regard(arrondi(REGARD.into()), Vecteur::Y);
        Self {
            monde: Monde::new(objets, places).expect("as many places as it takes"),
            camera: camera.expect("not straight up"),
            oeil: arrondi(OEIL.into()),
            lampe: Lumiere::lampe(arrondi(LAMPE.into())).expect("a place"),
            rayons: Vec::with_capacity(MORCEAU),
            touches: vec![Err(NoIntersection); MORCEAU],
            cosinus: vec![R::ZERO; MORCEAU],
        }
    }
}

impl<R: Reel> Peintre for Nous<'_, R> {
    fn faire_les_rayons(&mut self, pixels: &[(f64, f64)]) {
        self.rayons.clear();
        self.rayons.extend(pixels.iter().map(|&(x, y)| {
            let vers = Vecteur::new(R::depuis_f64(x), R::depuis_f64(y), -R::UN);
            Rayon::new(self.oeil, self.camera.appliquer(vers)).expect("a direction")
        }));
    }

    fn lancer(&mut self) {
        let touches = &mut self.touches[..self.rayons.len()];
        self.monde.premieres_intersections(&self.rayons, touches).expect("as many as rays");
    }

    fn eclairer(&mut self) {
        let n = self.rayons.len();
        let (touches, cosinus) = (&self.touches[..n], &mut self.cosinus[..n]);
        self.monde.eclairements(touches, &self.lampe, cosinus).expect("as many as hits");
    }

    fn ombrer(&mut self, image: &mut Vec<f32>) {
        let cosinus = &self.cosinus[..self.rayons.len()];
        image.extend(cosinus.iter().map(|cosinus| cosinus.vers_f64() as f32));
    }
}
