//! A room in the evening, by path tracing: a lamp that is an object, soft shadows, walls that light each other, a
//! mirror and a ball of glass.
//!
//! `cargo run --release --bin chemins [--f32] [--rayons N] [scene.ron] [image.png]`
//!
//! A path starts at the eye and takes one bounce after another. The paths of one piece of the picture are a wave: all
//! of them take one bounce in a batch, then all their shadow rays go in another.

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use exemples::image;
use exemples::scene::{Lisible, Scene, tuiles};
use indicatif::ParallelProgressIterator;
use lancer_rayon::{
    Intersection, LongueursDifferentes, Monde, NoIntersection, ObjetRay, Rayon, Reel, Reponse,
    SphereRay, Texture, Vecteur, places,
};
use rayon::prelude::*;
use recettes::milieux::{Derriere, Marche, Matiere};

/// Red, green and blue, in proportion to the light.
type Couleur = Vecteur;

/// The first object of the scene is its lamp, a sphere.
const LAMPE: usize = 0;
const LUEUR: Couleur = Vecteur::new(36.0, 27.0, 17.5);

/// The sky behind the eye, where the room has no wall.
const SOIR: Couleur = Vecteur::new(0.10, 0.17, 0.34);

/// Paths for each pixel, unless `--rayons` says how many, and pixels in one piece: 4096 paths are a wave.
const RAYONS: usize = 64;
const PIECE: usize = 64;

/// The most bounces of a path; a ball of glass takes two.
const REBONDS: usize = 8;

/// A sample is limited to this before the average, since a path that finds the lamp by a rare chance would otherwise be
/// a bright dot.
const PLAFOND: f64 = 1.6;

/// The refractive index of glass.
const INDICE: f64 = 1.5;

fn main() -> ExitCode {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let avant = arguments.len();
    arguments.retain(|argument| argument != "--f32");
    let rendre = if arguments.len() < avant { rendre::<f32> } else { rendre::<f64> };
    let mut rayons = Some(RAYONS);
    if let Some(ou) = arguments.iter().position(|argument| argument == "--rayons") {
        let option: Vec<_> = arguments.drain(ou..arguments.len().min(ou + 2)).collect();
        let nombre = option.get(1).and_then(|n| n.parse::<u16>().ok());
        rayons = nombre.filter(|&n| n > 0).map(usize::from);
    }
    let usage = "chemins [--f32] [--rayons N, from 1 to 65535]";
    let defauts = ["docs/scenes/soir.ron", "target/chemins.png"];
    let peindre = rayons.map(|rayons| move |scene: &str, image: &str| rendre(scene, image, rayons));
    image::programme(&arguments, defauts, usage, peindre)
}

fn rendre<R: Lisible>(chemin: &str, image: &str, rayons: usize) -> Result<(), Box<dyn Error>> {
    let debut = Instant::now();
    let Scene { camera, objets } = Scene::<R>::lire(Path::new(chemin))?;
    let objets: Vec<_> = objets.into_iter().map(ObjetRay::from).collect();
    let Some(ObjetRay::Sphere(lampe)) = objets.get(LAMPE) else {
        return Err(format!("{chemin}: the first object is not a sphere, the lamp").into());
    };
    let mut memoire = vec![0.0; places(objets.len())];
    let hierarchie = Monde::new(&objets, &mut memoire)?;
    let grain = R::depuis_f64(1.0 / f64::from(camera.image.1));
    let matiere = |objet: &ObjetRay<R>| match materiau(objet.texture()) {
        (Genre::Verre, _) => Matiere::Pleine { priorite: 0, indice: INDICE },
        (Genre::Mat | Genre::Verni | Genre::Miroir, _) => Matiere::Opaque,
    };
    let matieres = objets.iter().map(matiere).collect();
    let chambre = Chambre { lampe, hierarchie, matieres, grain, rayons };

    let oeil = camera.rayons()?;
    let ordre = tuiles(oeil.len(), camera.image.0 as usize);
    let pieces = ordre.par_chunks(PIECE).progress().map(|pixels| {
        // Each thread has its own generator. Seeded by the piece, it gives the same picture with any number of threads.
        fastrand::seed(pixels[0] as u64);
        chambre.couleurs(&pixels.iter().map(|&i| oeil[i]).collect::<Vec<_>>())
    });
    let pieces = pieces.collect::<Result<Vec<_>, _>>()?;
    let mut octets = vec![[0; 3]; ordre.len()];
    for (couleur, i) in pieces.into_iter().flatten().zip(ordre) {
        let octet = |x: f64| (255.0 * x.min(1.0).powf(1.0 / 2.2)).round() as u8;
        octets[i] = <[f64; 3]>::from(couleur).map(octet);
    }
    println!("{chemin}: {rayons} paths a pixel, {:.1} s", debut.elapsed().as_secs_f64());
    image::ecrire(image, camera.image, png::Compression::High, octets.as_flattened())
        .map_err(|erreur| format!("{image}: {erreur}"))?;
    println!("{image}");
    Ok(())
}

#[derive(Clone, Copy)]
enum Genre {
    Mat,
    /// Matt under a clear coat that mirrors as glass does.
    Verni,
    Miroir,
    Verre,
}

/// What a surface is made of: the parts of red, green and blue that it keeps, twice for a checker.
type Materiau = (Genre, [Couleur; 2]);

const fn uni(genre: Genre, r: f64, v: f64, b: f64) -> Materiau {
    (genre, [Vecteur::new(r, v, b); 2])
}

/// A texture is the index of one of these; beyond the last they begin anew.
const PALETTE: [Materiau; 12] = [
    uni(Genre::Mat, 0.0, 0.0, 0.0), // the lamp
    (Genre::Verni, [Vecteur::new(0.25, 0.11, 0.05), Vecteur::new(0.62, 0.42, 0.22)]),
    uni(Genre::Mat, 0.82, 0.75, 0.65),
    uni(Genre::Mat, 0.09, 0.25, 0.42),
    uni(Genre::Mat, 0.56, 0.14, 0.07),
    uni(Genre::Mat, 0.70, 0.56, 0.28),
    uni(Genre::Miroir, 0.90, 0.88, 0.85),
    uni(Genre::Verre, 0.92, 0.98, 0.96),
    uni(Genre::Verni, 0.02, 0.07, 0.25),
    uni(Genre::Verni, 0.47, 0.03, 0.02),
    uni(Genre::Verni, 0.87, 0.26, 0.01),
    uni(Genre::Mat, 0.02, 0.02, 0.02),
];

/// The material of an object of this texture.
fn materiau(texture: Texture) -> Materiau {
    PALETTE[texture.0 as usize % PALETTE.len()]
}

struct Chambre<'a, R> {
    lampe: &'a SphereRay<R>,
    hierarchie: Monde<'a, R>,
    /// What light goes through, by the index of the object.
    matieres: Vec<Matiere>,
    /// The size of a pixel, one unit before the eye.
    grain: R,
    /// Paths a pixel.
    rayons: usize,
}

/// A path on its way. What it finds counts for this path of the wave, multiplied by `part`.
struct Chemin<R> {
    rayon: Rayon<R>,
    numero: usize,
    part: Couleur,
    /// Whether it counts a lamp that it meets; after a matt surface the shadow ray has done so.
    franc: bool,
    /// The object of glass that it is in.
    dans: Option<usize>,
}

impl<R: Reel> Chambre<'_, R> {
    /// The colour of each pixel through whose middle a ray of `oeil` goes.
    fn couleurs(&self, oeil: &[Rayon<R>]) -> Result<Vec<Couleur>, LongueursDifferentes> {
        let chemin = |numero: usize| {
            let milieu = oeil[numero / self.rayons];
            let vers = milieu.direction() + au_hasard() * (self.grain * R::depuis_f64(0.3));
            let rayon = Rayon::new(milieu.source(), vers).unwrap_or(milieu);
            let part = Vecteur::new(1.0, 1.0, 1.0);
            Chemin { rayon, numero, part, franc: true, dans: None }
        };
        let nombre = oeil.len() * self.rayons;
        let mut chemins: Vec<_> = (0..nombre).map(chemin).collect();
        let mut vues = vec![Vecteur::NUL; nombre];
        let mut marche = Marche::new(self.hierarchie, &self.matieres);
        for _ in 0..REBONDS {
            let dans_l_air = chemins.iter().filter(|chemin| chemin.dans.is_none());
            let mut touches = self.lancer(dans_l_air.map(|chemin| chemin.rayon))?.into_iter();
            let (mut suivants, mut ombres) = (Vec::new(), Vec::new());
            for chemin in chemins {
                let touche = match chemin.dans {
                    None => touches.next().and_then(Result::ok),
                    Some(verre) => {
                        marche.reprendre(chemin.rayon, [verre]);
                        // What a glass stands on is found through it. Where an object is lost in rounding, a path ends.
                        let Ok(Some(surface)) = marche.avancer(R::INFINI) else { continue };
                        if surface.derriere != Derriere::Opaque && surface.objet == verre {
                            suivants.extend(chemin.dehors(&surface.touche, verre));
                            continue;
                        }
                        Some(surface.touche)
                    }
                };
                let Some(touche) = touche else {
                    vues[chemin.numero] += produit(chemin.part, SOIR);
                    continue;
                };
                if touche.indice() == LAMPE {
                    if chemin.franc {
                        vues[chemin.numero] += produit(chemin.part, LUEUR);
                    }
                } else if let Some(suivant) = chemin.rebond(&touche) {
                    if !suivant.franc {
                        ombres.extend(self.vers_la_lampe(&chemin, &touche, suivant.part));
                    }
                    suivants.push(suivant);
                }
            }
            // The lamp would hide the point of it that a ray is sent to, since no distance is exact enough to stop just
            // before it. Where the lamp is left out, no epsilon is needed.
            let (vers, lumieres): (Vec<_>, Vec<_>) = ombres.into_iter().unzip();
            let mut occultes = vec![false; vers.len()];
            self.hierarchie.sans(LAMPE).sont_occultes(&vers, &mut occultes)?;
            for ((numero, lumiere), occulte) in lumieres.into_iter().zip(occultes) {
                if !occulte {
                    vues[numero] += lumiere;
                }
            }
            chemins = suivants;
        }
        let limitee = |&vue: &Couleur| Vecteur::from(<[f64; 3]>::from(vue).map(|x| x.min(PLAFOND)));
        let moyenne =
            |vues: &[Couleur]| vues.iter().map(limitee).sum::<Couleur>() / self.rayons as f64;
        Ok(vues.chunks(self.rayons).map(moyenne).collect())
    }

    /// The first object that each of these rays touches.
    fn lancer(
        &self,
        rayons: impl Iterator<Item = Rayon<R>>,
    ) -> Result<Vec<Reponse<R>>, LongueursDifferentes> {
        let rayons: Vec<_> = rayons.collect();
        let mut touches = vec![Err(NoIntersection); rayons.len()];
        self.hierarchie.premieres_intersections(&rayons, &mut touches)?;
        Ok(touches)
    }

    /// The ray from a matt surface to a point of the half of the lamp that faces it, and the light that this ray brings
    /// to the path if it arrives.
    fn vers_la_lampe(
        &self,
        chemin: &Chemin<R>,
        touche: &Intersection<R>,
        part: Couleur,
    ) -> Option<(Rayon<R>, (usize, Couleur))> {
        let (centre, rayon) = (self.lampe.centre(), self.lampe.rayon());
        let axe = (touche.point() - centre).unitaire()?;
        // The normal of the lamp there, more often near the axis, by the cosine, which is nearly how the light goes.
        let n = (axe + au_hasard()).unitaire()?;
        let ombre = touche.vers_lumiere(centre + n * rayon).ok()?;
        let (l, distance) = (ombre.direction(), ombre.fin());
        // It is below 0 near the rim, where the lamp hides this point of itself.
        let de_face = -l.produit_scalaire(n);
        // The π of the chance of this point, per area, cancels that of a matt surface.
        let poids = de_face / n.produit_scalaire(axe) * l.produit_scalaire(touche.normale());
        let poids = (poids * rayon * rayon / (distance * distance)).vers_f64();
        let lumiere = produit(part, LUEUR) * poids;
        (de_face > R::ZERO).then_some((ombre, (chemin.numero, lumiere)))
    }
}

impl<R: Reel> Chemin<R> {
    /// How a path inside the object of this index goes on where it leaves that, or is mirrored within.
    fn dehors(&self, sortie: &Intersection<R>, verre: usize) -> Option<Self> {
        let (rayon, passe) = traverser(sortie, self.rayon.direction(), INDICE);
        Some(Self { rayon: rayon?, dans: (!passe).then_some(verre), ..*self })
    }

    /// How a path goes on from a surface that is not the lamp.
    fn rebond(&self, touche: &Intersection<R>) -> Option<Self> {
        let (d, n) = (self.rayon.direction(), touche.normale());
        let (genre, couleurs) = materiau(touche.texture());
        let p = touche.point();
        let case = (p.x.vers_f64().floor() + p.z.vers_f64().floor()) as i64;
        let teinte = produit(self.part, couleurs[(case & 1) as usize]);
        let (passe, entre) = traverser(touche, d, 1.0 / INDICE);
        let (rayon, part, franc) = match genre {
            Genre::Miroir => (touche.reflechi(d).ok(), teinte, true),
            Genre::Verre => (passe, teinte, true),
            Genre::Verni if !entre => (passe, self.part, true),
            // Each direction comes as often as its cosine is large, so that no cosine is left to count.
            Genre::Verni | Genre::Mat => (touche.secondaire(n + au_hasard()).ok(), teinte, false),
        };
        let dans = (entre && matches!(genre, Genre::Verre)).then(|| touche.indice());
        // No shadow ray from within glass is straight, so the path finds the lamp by chance.
        let franc = franc || self.dans.is_some();
        Some(Self { rayon: rayon?, numero: self.numero, part, franc, dans: dans.or(self.dans) })
    }
}

/// Where light goes on from a face of glass, and whether it passes (Snell) or is mirrored, by chance. `rapport` is the
/// index in front of the face over the one behind.
fn traverser<R: Reel>(
    touche: &Intersection<R>,
    d: Vecteur<R>,
    rapport: f64,
) -> (Option<Rayon<R>>, bool) {
    let cosinus = |d: Vecteur<R>| d.produit_scalaire(touche.normale()).vers_f64().abs();
    if let Ok(passe) = touche.refracte(d, R::depuis_f64(rapport)) {
        // Schlick's approximation of Fresnel's formula takes the larger angle, that in the air.
        let rasant = 1.0 - cosinus(d).min(cosinus(passe.direction()));
        if fastrand::f64() > 0.04 + 0.96 * rasant.powi(5) {
            return (Some(passe), true);
        }
    }
    (touche.reflechi(d).ok(), false)
}

/// A random point of the unit sphere.
fn au_hasard<R: Reel>() -> Vecteur<R> {
    let z = 2.0 * fastrand::f64() - 1.0;
    let (sin, cos) = (std::f64::consts::TAU * fastrand::f64()).sin_cos();
    let r = (1.0 - z * z).sqrt();
    Vecteur::depuis_f64(Vecteur::new(r * cos, r * sin, z))
}

fn produit(a: Couleur, b: Couleur) -> Couleur {
    Vecteur::new(a.x * b.x, a.y * b.y, a.z * b.z)
}
