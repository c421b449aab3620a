//! A picture of a scene, after Whitted: lamps, shadows, mirrors that show each other, and glass.
//!
//! `cargo run --release [-- --f32] [--bande i/n] [scene.ron] [image.png]`
//!
//! With `--bande 2/4` it writes only the second of four bands of the picture, as bare rows of red, green and blue.
//! Bands put one after another are the whole picture, whichever machines made them.
//!
//! Every kind of ray goes in batches, level by level: what the eye sees, the shadows there, what mirrors and glass
//! show, the shadows there, and so on. Rays of a level that leave the same object are neighbours, so that a batch finds
//! them as a beam.

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use exemples::image;
use exemples::scene::{Lisible, Scene, tuiles};
use indicatif::ParallelProgressIterator;
use lancer_rayon::{
    ErreurGeo, Intersection, LongueursDifferentes, Lumiere, Monde, NoIntersection, ObjetRay, Rayon,
    Reel, Reponse, Vecteur, places,
};
use rayon::prelude::*;

/// Red, green and blue, in proportion to the light.
type Couleur = Vecteur;

const SCENE: &str = "docs/scenes/atelier.ron";
const IMAGE: &str = "target/rendu.png";

/// Rays across a pixel, each way.
const FINESSE: u32 = 2;

/// How many mirrors in a row are followed, or half as many glasses.
const NIVEAUX: u32 = 6;

/// How many rays of the eye go together, as the work of one thread at a time.
pub(crate) const ENSEMBLE: usize = 4096;

fn main() -> ExitCode {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let avant = arguments.len();
    arguments.retain(|argument| argument != "--f32");
    let rendre = if arguments.len() < avant { rendre::<f32> } else { rendre::<f64> };
    let bande = match arguments.iter().position(|argument| argument == "--bande") {
        None => Some(None),
        Some(ou) => {
            let suite: Vec<_> = arguments.drain(ou..).skip(1).collect();
            arguments.extend(suite.iter().skip(1).cloned());
            suite.first().and_then(|bande| Bande::lire(bande)).map(Some)
        }
    };
    let usage = "rendu [--f32] [--bande i/n, i from 1 to n]";
    let peindre = bande.map(|bande| move |scene: &str, image: &str| rendre(scene, image, bande));
    image::programme(&arguments, [SCENE, IMAGE], usage, peindre)
}

/// Band `numero` of `nombre` of a picture, from the top; counted from 1.
#[derive(Clone, Copy)]
pub(crate) struct Bande {
    pub(crate) numero: u32,
    pub(crate) nombre: u32,
}

impl Bande {
    const TOUT: Self = Self { numero: 1, nombre: 1 };

    fn lire(texte: &str) -> Option<Self> {
        let (numero, nombre) = texte.split_once('/')?;
        let bande = Self { numero: numero.parse().ok()?, nombre: nombre.parse().ok()? };
        (1..=bande.nombre).contains(&bande.numero).then_some(bande)
    }

    /// Its rows in a picture of this height.
    fn lignes(self, hauteur: u32) -> core::ops::Range<u32> {
        let debut =
            |numero: u32| (u64::from(hauteur) * u64::from(numero) / u64::from(self.nombre)) as u32;
        debut(self.numero - 1)..debut(self.numero)
    }
}

fn rendre<R: Lisible>(
    chemin: &str,
    image: &str,
    bande: Option<Bande>,
) -> Result<(), Box<dyn Error>> {
    let debut = Instant::now();
    let Image { taille, octets, objets, rayons, touches } =
        octets::<R>(chemin, FINESSE, ENSEMBLE, bande.unwrap_or(Bande::TOUT))?;
    println!("{chemin}: {objets} objects, which {touches} of {rayons} rays of the camera hit");
    println!("with shadows, mirrors and glass: {:.1} s", debut.elapsed().as_secs_f64());
    let ecrite = match bande {
        None => image::ecrire(image, taille, png::Compression::High, &octets),
        Some(_) => std::fs::write(image, octets).map_err(Into::into),
    };
    ecrite.map_err(|e| format!("{image}: {e}"))?;
    println!("{image}");
    Ok(())
}

/// A picture, and what was asked for it.
pub(crate) struct Image {
    /// Width and height.
    taille: (u32, u32),
    /// Red, green and blue of each pixel, row by row from the top left.
    pub(crate) octets: Vec<u8>,
    objets: usize,
    /// The rays of the camera, and how many of them hit something.
    rayons: usize,
    touches: usize,
}

/// The picture of a scene file, with `finesse` rays across a pixel, `ensemble` of them together.
pub(crate) fn octets<R: Lisible>(
    chemin: &str,
    finesse: u32,
    ensemble: usize,
    bande: Bande,
) -> Result<Image, Box<dyn Error>> {
    let Scene { mut camera, objets } = Scene::<R>::lire(Path::new(chemin))?;
    let (largeur, hauteur) = camera.image;
    camera.image = (finesse * largeur, finesse * hauteur);
    let rayons = camera.rayons()?;
    let lignes = bande.lignes(hauteur);
    let par_ligne = (finesse * finesse * largeur) as usize;
    let rayons = &rayons[lignes.start as usize * par_ligne..lignes.end as usize * par_ligne];
    let objets: Vec<_> = objets.into_iter().map(ObjetRay::from).collect();
    let mut memoire = vec![0.0; places(objets.len())];
    let hierarchie = Monde::new(&objets, &mut memoire)?;
    let atelier = Atelier { objets: &objets, hierarchie, lampes: lampes()? };
    let (couleurs, touches) = atelier.prendre(rayons, camera.image.0, finesse, ensemble)?;
    let octet = |x: f64| (255.0 * x.powf(1.0 / 2.2)).round() as u8;
    let octets = couleurs.into_iter().flat_map(|couleur| <[f64; 3]>::from(couleur).map(octet));
    Ok(Image {
        taille: (largeur, lignes.end - lignes.start),
        octets: octets.collect(),
        objets: objets.len(),
        rayons: rayons.len(),
        touches,
    })
}

/// What a surface is made of. A texture is the index of one of these.
struct Matiere {
    /// Two sRGB colours, of a checker.
    couleurs: [u32; 2],
    /// The side of a square of the checker, in scene units.
    carreau: f64,
    /// How much it mirrors of what is straight ahead. It mirrors more of what grazes it, unless this is 0.
    reflet: f64,
    /// The strength of the highlights.
    eclat: f64,
    /// The refractive index of glass, which is seen in its colour; 0 for what light does not pass.
    indice: f64,
}

const fn mate(couleur: u32) -> Matiere {
    Matiere { couleurs: [couleur; 2], carreau: 1.0, reflet: 0.0, eclat: 0.0, indice: 0.0 }
}

const fn polie(couleur: u32, reflet: f64, eclat: f64) -> Matiere {
    Matiere { reflet, eclat, ..mate(couleur) }
}

/// In the order of the atelier; beyond the last they begin anew.
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
    Matiere { indice: 1.5, ..polie(0xb9e3cd, 0.0, 0.8) },
    polie(0xc65a4a, 0.06, 0.5),
    mate(0xe4dcd0),
];

/// A point that shines alike in all directions and at any distance, so that one set of lamps serves scenes of every
/// size.
struct Lampe<R> {
    position: Vecteur<R>,
    /// The same place, as a world asks for it.
    lumiere: Lumiere<R>,
    couleur: Couleur,
}

const AMBIANTE: Couleur = Vecteur::new(0.22, 0.24, 0.27);

/// A warm disc of many points, for shadows with soft edges, and a cool point on the other side.
fn lampes<R: Reel>() -> Result<Vec<Lampe<R>>, ErreurGeo> {
    const POINTS: u8 = 14;
    let disque = (0..POINTS).map(|i| {
        // Points are a golden angle apart, so that no edge has two of them behind each other.
        let (sin, cos) = (2.399_963 * f64::from(i)).sin_cos();
        let rayon = 0.9 * ((f64::from(i) + 0.5) / f64::from(POINTS)).sqrt();
        let position = Vecteur::new(-2.6 + rayon * cos, 7.2, 5.2 + rayon * sin);
        (position, Vecteur::new(1.1, 1.02, 0.90) / f64::from(POINTS))
    });
    let appoint = (Vecteur::new(7.5, 4.5, 6.0), Vecteur::new(0.13, 0.16, 0.20));
    let lampes = disque.chain([appoint]);
    let lampe = |(p, couleur)| {
        let position = Vecteur::depuis_f64(p);
        Ok(Lampe { position, lumiere: Lumiere::lampe(position)?, couleur })
    };
    lampes.map(lampe).collect()
}

struct Atelier<'a, R> {
    objets: &'a [ObjetRay<R>],
    hierarchie: Monde<'a, R>,
    lampes: Vec<Lampe<R>>,
}

/// A ray on its way. What it sees counts for this ray of the eye, multiplied by `part`.
struct Trajet<R> {
    rayon: Rayon<R>,
    oeil: usize,
    part: Couleur,
    /// The object that it leaves.
    quitte: usize,
    /// Whether it is inside that object, which is of glass.
    dedans: bool,
}

impl<R: Reel> Atelier<'_, R> {
    /// The colour of each pixel, from rays that stand row by row, `largeur` in a row; and how many of them hit.
    fn prendre(
        &self,
        rayons: &[Rayon<R>],
        largeur: u32,
        finesse: u32,
        ensemble: usize,
    ) -> Result<(Vec<Couleur>, usize), LongueursDifferentes> {
        let (largeur, finesse) = (largeur as usize, finesse as usize);
        let ordre = tuiles(rayons.len(), largeur);
        let ensembles = ordre.par_chunks(ensemble).progress();
        let vues: Vec<_> = ensembles
            .map(|ordre| self.vues(ordre.iter().map(|&i| rayons[i])))
            .collect::<Result<_, _>>()?;

        let mut couleurs = vec![Vecteur::NUL; rayons.len() / (finesse * finesse)];
        let touches = vues.iter().map(|(_, touches)| touches).sum();
        for (vue, i) in vues.into_iter().flat_map(|(vues, _)| vues).zip(ordre) {
            let (ligne, colonne) = (i / largeur / finesse, i % largeur / finesse);
            // What is brighter than the picture can show must not outweigh its neighbours.
            let vue = Vecteur::from(<[f64; 3]>::from(vue).map(|x| x.min(1.0)));
            couleurs[ligne * (largeur / finesse) + colonne] += vue / (finesse * finesse) as f64;
        }
        Ok((couleurs, touches))
    }

    /// What is seen along each of these rays, and how many of them hit.
    fn vues(
        &self,
        rayons: impl Iterator<Item = Rayon<R>>,
    ) -> Result<(Vec<Couleur>, usize), LongueursDifferentes> {
        let blanc = Vecteur::new(1.0, 1.0, 1.0);
        let trajet = |(oeil, rayon)| Trajet { rayon, oeil, part: blanc, quitte: 0, dedans: false };
        let mut trajets: Vec<_> = rayons.enumerate().map(trajet).collect();
        let mut vues = vec![Vecteur::NUL; trajets.len()];
        let mut de_l_oeil = 0;
        for niveau in 0..=NIVEAUX {
            let touches = self.lancer(trajets.iter().map(|trajet| trajet.rayon).collect())?;
            if niveau == 0 {
                de_l_oeil = touches.iter().flatten().count();
            }
            let mut surfaces = Vec::new();
            let mut suivants = Vec::new();
            for (trajet, touche) in trajets.iter().zip(touches) {
                match (self.sortie(trajet, &touche), touche) {
                    (Some(suivant), _) => suivants.push(suivant),
                    (None, Ok(touche)) => {
                        let (surface, suivant) = self.surface(trajet, touche);
                        vues[trajet.oeil] += produit(surface.couleur, AMBIANTE);
                        surfaces.push(surface);
                        suivants.extend(suivant);
                    }
                    (None, Err(NoIntersection)) => {
                        let ciel = ciel(trajet.rayon.direction().y.vers_f64());
                        vues[trajet.oeil] += produit(trajet.part, ciel);
                    }
                }
            }
            self.eclairer(&surfaces, &mut vues)?;
            suivants.sort_by_key(|trajet| trajet.quitte);
            trajets = suivants;
        }
        Ok((vues, de_l_oeil))
    }

    /// The first object that each of these rays touches.
    fn lancer(&self, rayons: Vec<Rayon<R>>) -> Result<Vec<Reponse<R>>, LongueursDifferentes> {
        let mut touches = vec![Err(NoIntersection); rayons.len()];
        self.hierarchie.premieres_intersections(&rayons, &mut touches)?;
        Ok(touches)
    }

    /// What a ray sees of the surface that it touched, and the ray that goes on from there.
    fn surface<'t>(
        &self,
        trajet: &'t Trajet<R>,
        touche: Intersection<R>,
    ) -> (Surface<'t, R>, Option<Trajet<R>>) {
        let Trajet { rayon, oeil, part, .. } = trajet;
        let (d, n) = (rayon.direction(), touche.normale());
        let face = d.produit_scalaire(n);
        let reflechi = touche.reflechi(rayon.direction()).ok();
        let matiere = &PALETTE[touche.texture().0 as usize % PALETTE.len()];
        let couleur = matiere.couleur(touche.point(), n, touche.distance());
        let dedans = matiere.indice > 0.0;
        // Schlick's approximation of Fresnel's formula.
        let rasant = (1.0 + face.vers_f64()).max(0.0).powi(5);
        let reflet = if matiere.reflet > 0.0 {
            matiere.reflet + (1.0 - matiere.reflet) * rasant
        } else {
            0.0
        };
        let (secondaire, suit, reste) = if dedans {
            (touche.refracte(d, R::depuis_f64(1.0 / matiere.indice)).ok(), couleur, 0.0)
        } else {
            let suit = Vecteur::new(reflet, reflet, reflet);
            (reflechi.filter(|_| reflet > 0.0), suit, 1.0 - reflet)
        };
        let quitte = touche.indice();
        let suivant = secondaire.map(|rayon| Trajet {
            rayon,
            oeil: *oeil,
            part: produit(*part, suit),
            quitte,
            dedans,
        });
        let couleur = produit(*part, couleur) * reste;
        (Surface { trajet, touche, reflechi, couleur, eclat: matiere.eclat }, suivant)
    }

    /// Where a ray inside glass leaves it, unless it touches something else before.
    fn sortie(&self, trajet: &Trajet<R>, touche: &Reponse<R>) -> Option<Trajet<R>> {
        let Trajet { rayon, oeil, part, quitte, dedans: true } = *trajet else { return None };
        let objet = &self.objets[quitte];
        let sortie = objet.sortie(&rayon).ok()?;
        if touche.is_ok_and(|touche| touche.distance() < sortie.distance()) {
            return None;
        }
        let matiere = &PALETTE[sortie.texture().0 as usize % PALETTE.len()];
        let d = rayon.direction();
        let dehors = sortie.refracte(d, R::depuis_f64(matiere.indice));
        // Beyond the critical angle the ray stays inside.
        let dedans = dehors.is_err();
        let rayon = dehors.or_else(|_| sortie.reflechi(d)).ok()?;
        Some(Trajet { rayon, oeil, part, quitte, dedans })
    }

    /// Adds the light of the lamps to what is seen of these surfaces, except where something blocks it.
    fn eclairer(
        &self,
        surfaces: &[Surface<'_, R>],
        vues: &mut [Couleur],
    ) -> Result<(), LongueursDifferentes> {
        let touches: Vec<_> = surfaces.iter().map(|surface| Ok(surface.touche)).collect();
        let mut cosinus = vec![R::ZERO; touches.len()];
        for lampe in &self.lampes {
            self.hierarchie.eclairements(&touches, &lampe.lumiere, &mut cosinus)?;
            for (surface, cosinus) in surfaces.iter().zip(&cosinus) {
                if *cosinus > R::ZERO {
                    let Surface { trajet, couleur, eclat, .. } = surface;
                    let brillant = surface.brillant(lampe).powi(60);
                    vues[trajet.oeil] += produit(*couleur, lampe.couleur) * cosinus.vers_f64()
                        + produit(trajet.part, lampe.couleur) * (eclat * brillant);
                }
            }
        }
        Ok(())
    }
}

/// A point of a surface that is seen.
struct Surface<'t, R> {
    trajet: &'t Trajet<R>,
    touche: Intersection<R>,
    /// What a mirror would make of the ray.
    reflechi: Option<Rayon<R>>,
    /// Times the part in which it is seen.
    couleur: Couleur,
    eclat: f64,
}

impl<R: Reel> Surface<'_, R> {
    /// The cosine between the mirrored ray and the light of this lamp, or 0; of a surface without highlights 0.
    fn brillant(&self, lampe: &Lampe<R>) -> f64 {
        let Some(reflechi) = self.reflechi.filter(|_| self.eclat > 0.0) else { return 0.0 };
        let Ok(ombre) = self.touche.vers_lumiere(lampe.position) else { return 0.0 };
        ombre.direction().produit_scalaire(reflechi.direction()).vers_f64().max(0.0)
    }
}

impl Matiere {
    /// The colour at this point, seen from this distance.
    fn couleur<R: Reel>(&self, p: Vecteur<R>, n: Vecteur<R>, distance: R) -> Couleur {
        let [a, b] = self.couleurs.map(lineaire);
        // The two coordinates along which the surface lies most.
        let (x, y) = match [n.x, n.y, n.z].map(R::absolu) {
            [x, y, z] if y >= x && y >= z => (p.x, p.z),
            [x, _, z] if x >= z => (p.y, p.z),
            _ => (p.x, p.y),
        };
        let case = [x, y].map(|x| (x.vers_f64() / self.carreau).floor());
        let signe = if (case[0] + case[1]).rem_euclid(2.0) == 0.0 { 0.5 } else { -0.5 };
        // The checker fades before it is finer than the pixels.
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
