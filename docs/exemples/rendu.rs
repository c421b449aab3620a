//! A picture of a scene, after Whitted: lamps, shadows, and mirrors that show each other.
//!
//! `cargo run --release --example rendu [--f32] [scene.ron] [image.png]`

mod image;
mod scene;

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use lancer_rayon::{
    Intersection, NoIntersection, ObjetRay, Rayon, Reel, Touche, Vecteur, est_occulte,
    premiere_intersection, premieres_intersections,
};
use scene::Scene;
use serde::de::DeserializeOwned;

/// Red, green and blue, in proportion to the light.
type Couleur = Vecteur;

const SCENE: &str = "docs/scenes/atelier.ron";
const IMAGE: &str = "target/rendu.png";

/// Rays across a pixel, each way.
const FINESSE: u32 = 2;

/// Mirrors in a row.
const REBONDS: u32 = 4;

fn main() -> ExitCode {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let avant = arguments.len();
    arguments.retain(|argument| argument != "--f32");
    let rendre = if arguments.len() < avant { rendre::<f32> } else { rendre::<f64> };
    image::programme(&arguments, [SCENE, IMAGE], "rendu [--f32]", rendre)
}

fn rendre<R: Reel + DeserializeOwned>(chemin: &str, image: &str) -> Result<(), Box<dyn Error>> {
    let Scene { mut camera, objets } = Scene::<R>::lire(Path::new(chemin))?;
    let taille = camera.image;
    camera.image = (FINESSE * taille.0, FINESSE * taille.1);
    let rayons = camera.rayons()?;
    let objets = objets.iter().map(|objet| objet.vers_ray()).collect();
    let atelier = Atelier { objets, lampes: lampes() };

    let debut = Instant::now();
    let couleurs = atelier.prendre(&rayons, camera.image.0 as usize)?;
    println!("{chemin}: {} rays, {:.1} s", rayons.len(), debut.elapsed().as_secs_f64());
    ecrire(image, taille, &couleurs).map_err(|e| format!("{image}: {e}"))?;
    println!("{image}");
    Ok(())
}

/// What a surface is made of. A texture is the number of one of these.
struct Matiere {
    /// As sRGB; two of them for a checker.
    couleurs: [u32; 2],
    /// The side of a square of the checker, in scene units.
    carreau: f64,
    /// How much it mirrors of what is straight before it; more of what grazes it, unless it is 0.
    reflet: f64,
    /// The strength of the highlights.
    eclat: f64,
}

const fn mate(couleur: u32) -> Matiere {
    Matiere { couleurs: [couleur; 2], carreau: 1.0, reflet: 0.0, eclat: 0.0 }
}

const fn polie(couleur: u32, reflet: f64, eclat: f64) -> Matiere {
    Matiere { reflet, eclat, ..mate(couleur) }
}

/// In the order of the atelier; a scene with more textures begins anew.
const PALETTE: [Matiere; 14] = [
    Matiere { couleurs: [0x8d8178, 0xbcb0a2], carreau: 1.0, ..mate(0) },
    mate(0x7f99a6),
    mate(0xcbbba2),
    polie(0xa9764a, 0.04, 0.1),
    polie(0x2b4a70, 0.0, 0.08),
    polie(0xb04a3c, 0.0, 0.08),
    polie(0xeadbb4, 0.0, 0.08),
    polie(0xf5901e, 0.0, 0.25),
    polie(0xe2b84c, 0.0, 0.2),
    polie(0xd9b07a, 0.0, 0.05),
    polie(0xd8dce0, 0.75, 0.6),
    polie(0x2f6b4f, 0.06, 0.5),
    polie(0xc65a4a, 0.06, 0.5),
    mate(0xe4dcd0),
];

/// A point that shines alike in all directions and however far, so that one set of lamps serves
/// scenes of every size.
struct Lampe<R> {
    position: Vecteur<R>,
    couleur: Couleur,
}

const AMBIANTE: Couleur = Vecteur::new(0.22, 0.24, 0.27);

/// A warm disc of many points, for shadows with soft edges, and a cool point on the other side.
fn lampes<R: Reel>() -> Vec<Lampe<R>> {
    const POINTS: u8 = 14;
    let disque = (0..POINTS).map(|i| {
        // By the golden angle, so that no edge has two of them behind each other.
        let (sin, cos) = (2.399_963 * f64::from(i)).sin_cos();
        let rayon = 0.9 * ((f64::from(i) + 0.5) / f64::from(POINTS)).sqrt();
        let position = Vecteur::new(-2.6 + rayon * cos, 7.2, 5.2 + rayon * sin);
        (position, Vecteur::new(1.1, 1.02, 0.90) / f64::from(POINTS))
    });
    let appoint = (Vecteur::new(7.5, 4.5, 6.0), Vecteur::new(0.13, 0.16, 0.20));
    let lampes = disque.chain([appoint]);
    lampes.map(|(p, couleur)| Lampe { position: Vecteur::depuis_f64(p), couleur }).collect()
}

struct Atelier<R> {
    objets: Vec<ObjetRay<R>>,
    lampes: Vec<Lampe<R>>,
}

impl<R: Reel> Atelier<R> {
    /// The colour of each pixel, from rays that stand row by row, so many in a row.
    fn prendre(&self, rayons: &[Rayon<R>], largeur: usize) -> Result<Vec<Couleur>, Box<dyn Error>> {
        // The batch is at its best with neighbours in tiles of 8 × 8.
        let mut ordre: Vec<usize> = (0..rayons.len()).collect();
        ordre.sort_by_key(|i| (i / largeur / 8, i % largeur / 8));

        let finesse = FINESSE as usize;
        let part = 1.0 / f64::from(FINESSE * FINESSE);
        let mut couleurs = vec![Vecteur::NUL; rayons.len() / (finesse * finesse)];
        let (mut lot, mut touches) = (vec![], [Err(NoIntersection); 4096]);
        for ordre in ordre.chunks(touches.len()) {
            lot.clear();
            lot.extend(ordre.iter().map(|&i| rayons[i]));
            let touches = &mut touches[..lot.len()];
            premieres_intersections(&self.objets, &lot, touches)?;
            for ((rayon, touche), i) in lot.iter().zip(touches).zip(ordre) {
                let (ligne, colonne) = (i / largeur / finesse, i % largeur / finesse);
                let pixel = &mut couleurs[ligne * (largeur / finesse) + colonne];
                // What is brighter than the picture can show must not outweigh its neighbours.
                let vue = <[f64; 3]>::from(self.vue(rayon, *touche, REBONDS)).map(|x| x.min(1.0));
                *pixel = *pixel + Vecteur::from(vue) * part;
            }
        }
        Ok(couleurs)
    }

    /// What is seen along a ray.
    fn vue(&self, rayon: &Rayon<R>, touche: Touche<R>, rebonds: u32) -> Couleur {
        let Ok(touche) = touche else { return ciel(rayon.direction().y.vers_f64()) };
        let (d, n) = (rayon.direction(), touche.normale());
        let face = d.produit_scalaire(n);
        let reflechie = d - (n + n) * face;
        let matiere = &PALETTE[touche.texture().0 as usize % PALETTE.len()];

        let point = rayon.point(touche.distance());
        let couleur = matiere.couleur(point, n, touche.distance());
        let mut vue = produit(couleur, AMBIANTE);
        for lampe in &self.lampes {
            let Some(vers) = (lampe.position - point).unitaire() else { continue };
            let cosinus = vers.produit_scalaire(n);
            if cosinus > R::ZERO && !self.a_l_ombre(rayon, &touche, lampe) {
                let eclat = vers.produit_scalaire(reflechie).vers_f64().max(0.0).powi(60);
                vue = vue + produit(couleur, lampe.couleur) * cosinus.vers_f64();
                vue = vue + lampe.couleur * (matiere.eclat * eclat);
            }
        }

        if matiere.reflet > 0.0
            && rebonds > 0
            && let Ok(miroir) = rayon.secondaire(&touche, reflechie)
        {
            // Schlick's approximation of Fresnel's formula.
            let rasant = (1.0 + face.vers_f64()).max(0.0).powi(5);
            let part = matiere.reflet + (1.0 - matiere.reflet) * rasant;
            let touche = premiere_intersection(&self.objets, &miroir);
            vue = vue * (1.0 - part) + self.vue(&miroir, touche, rebonds - 1) * part;
        }
        vue
    }

    fn a_l_ombre(&self, rayon: &Rayon<R>, touche: &Intersection<R>, lampe: &Lampe<R>) -> bool {
        let vers = lampe.position - rayon.point(touche.distance());
        // A point that is not known well enough to leave it is in the light.
        let Ok(ombre) = rayon.secondaire(touche, vers) else { return false };
        let distance = (lampe.position - ombre.source()).longueur();
        est_occulte(&self.objets, &ombre, distance)
    }
}

impl Matiere {
    /// The colour at this point, seen from so far.
    fn couleur<R: Reel>(&self, p: Vecteur<R>, n: Vecteur<R>, distance: R) -> Couleur {
        let [a, b] = self.couleurs.map(lineaire);
        // The two coordinates along which the surface lies most.
        let (x, y) = match [n.x, n.y, n.z].map(R::abs) {
            [x, y, z] if y >= x && y >= z => (p.x, p.z),
            [x, _, z] if x >= z => (p.y, p.z),
            _ => (p.x, p.y),
        };
        let case = [x, y].map(|x| (x.vers_f64() / self.carreau).floor());
        let signe = if (case[0] + case[1]).rem_euclid(2.0) == 0.0 { 0.5 } else { -0.5 };
        // Fades before it is finer than the pixels.
        let fondu = 1.0 / (1.0 + (distance.vers_f64() / (40.0 * self.carreau)).powi(2));
        (a + b) * 0.5 + (a - b) * (signe * fondu)
    }
}

/// What is seen where nothing is touched, by the slope of the ray.
fn ciel(y: f64) -> Couleur {
    let (horizon, zenith) = (lineaire(0xe6ddd0), lineaire(0x8fa6bd));
    horizon + (zenith - horizon) * y.clamp(0.0, 1.0).sqrt()
}

fn lineaire(couleur: u32) -> Couleur {
    let [_, rvb @ ..] = couleur.to_be_bytes();
    rvb.map(|x| (f64::from(x) / 255.0).powf(2.2)).into()
}

fn produit(a: Couleur, b: Couleur) -> Couleur {
    Vecteur::new(a.x * b.x, a.y * b.y, a.z * b.z)
}

fn ecrire(chemin: &str, taille: (u32, u32), couleurs: &[Couleur]) -> Result<(), Box<dyn Error>> {
    let octet = |x: f64| (255.0 * x.powf(1.0 / 2.2)).round() as u8;
    let octets: Vec<u8> =
        couleurs.iter().flat_map(|&couleur| <[f64; 3]>::from(couleur).map(octet)).collect();
    image::ecrire(chemin, taille, png::Compression::High, &octets)
}
