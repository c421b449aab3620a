//! Scenes written in RON: a camera and a list of objects, which are checked where they stand in the file.
//!
//! ```ron
//! (
//!     camera: (source: (0, 2, 8), regard: Point((0, 1, 0)), champ: 40),
//!     objets: [
//!         Plan(rotation: (90, 0, 0), distance: 0, texture: 0),
//!         Sphere(centre: (0, 1, 0), rayon: 1, texture: 1),
//!         Boite(
//!             centre: (2, 1, 0), dimensions: (1, 2, 1), rotation: (0, 30, 0), texture: 2,
//!             transformations: [Translation((0, 0, -3)), Rotation((0, 15, 0)), Homothetie(0.5)],
//!         ),
//!     ],
//! )
//! ```
//!
//! A rotation is the handout's vecteur-rotation, in degrees. Transformations apply in the order
//! in which they are written.

use std::f64::consts::FRAC_PI_2;
use std::path::{Path, PathBuf};
use std::{fmt, fs};

use lancer_rayon::{
    BoiteGeo, ErreurGeo, ObjetGeo, PlanGeo, Rayon, Reel, Rotation, SphereGeo, Texture, Vecteur,
};
use ron::error::{Position, SpannedResult};
use ron::extensions::Extensions;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer};

/// A camera and what stands before it.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[serde(bound(deserialize = "R: Reel + Deserialize<'de>"))]
pub struct Scene<R> {
    pub camera: Camera,
    #[serde(deserialize_with = "objets")]
    pub objets: Vec<ObjetGeo<R>>,
}

/// A scalar in which a scene is read. The readers are compiled here for both, and not once more by every program.
pub trait Lisible: Reel {
    fn depuis_ron(texte: &str) -> SpannedResult<Scene<Self>>;
}

macro_rules! lisible {
    ($($reel:ident)*) => {$(
        impl Lisible for $reel {
            fn depuis_ron(texte: &str) -> SpannedResult<Scene<Self>> {
                ron::Options::default().with_default_extension(Extensions::UNWRAP_NEWTYPES).from_str(texte)
            }
        }
    )*};
}

lisible! { f32 f64 }

impl<R: Lisible> Scene<R> {
    /// The scene of this file.
    pub fn lire(chemin: &Path) -> Result<Self, ErreurScene> {
        let texte = fs::read_to_string(chemin).map_err(|erreur| ErreurScene {
            fichier: chemin.to_owned(),
            position: None,
            raison: erreur.to_string(),
        })?;
        Self::depuis_texte(chemin, &texte)
    }

    /// The scene of this text; errors say that it stands in `fichier`.
    pub fn depuis_texte(fichier: &Path, texte: &str) -> Result<Self, ErreurScene> {
        R::depuis_ron(texte).map_err(|erreur| ErreurScene {
            fichier: fichier.to_owned(),
            position: Some(erreur.span.start),
            raison: erreur.code.to_string(),
        })
    }
}

/// Why there is no scene.
#[derive(Debug)]
pub struct ErreurScene {
    fichier: PathBuf,
    /// Line and column, unless the file as a whole could not be read.
    position: Option<Position>,
    raison: String,
}

impl fmt::Display for ErreurScene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:", self.fichier.display())?;
        if let Some(position) = &self.position {
            write!(f, "{position}:")?;
        }
        write!(f, " {}", self.raison)
    }
}

impl std::error::Error for ErreurScene {}

/// Where the picture is taken from. It is always in `f64`, so that the rays of both types are the same up to their
/// rounding.
#[derive(Debug, Deserialize)]
#[serde(try_from = "CameraBrute")]
pub struct Camera {
    source: Vecteur,
    rotation: Rotation,
    /// The height of the picture, one unit before the camera.
    hauteur: f64,
    /// Width and height, in pixels.
    pub image: (u32, u32),
}

impl Camera {
    /// One ray through the middle of each pixel, row by row from the upper left corner.
    pub fn rayons<R: Reel>(&self) -> Result<Vec<Rayon<R>>, ErreurGeo> {
        let (largeur, hauteur) = self.image;
        let pas = self.hauteur / f64::from(hauteur);
        let milieu = |pixel: u32, pixels: u32| f64::from(pixel) + 0.5 - f64::from(pixels) / 2.0;
        let pixels = (0..hauteur).flat_map(|j| (0..largeur).map(move |i| (i, j)));
        let rayon = |(i, j)| {
            let (x, y) = (milieu(i, largeur) * pas, -milieu(j, hauteur) * pas);
            let direction = self.rotation.appliquer(Vecteur::new(x, y, -1.0));
            Rayon::new(Vecteur::depuis_f64(self.source), Vecteur::depuis_f64(direction))
        };
        pixels.map(rayon).collect()
    }
}

/// The pixels of a picture of width `largeur`, counted row by row, in tiles of 8 × 8: a batch is at its best with such
/// neighbours.
pub fn tuiles(pixels: usize, largeur: usize) -> Vec<usize> {
    let mut ordre: Vec<usize> = (0..pixels).collect();
    ordre.sort_by_key(|i| (i / largeur / 8, i % largeur / 8));
    ordre
}

#[derive(Deserialize)]
#[serde(rename = "Camera", deny_unknown_fields)]
struct CameraBrute {
    #[serde(deserialize_with = "source")]
    source: Vecteur,
    regard: Regard,
    #[serde(deserialize_with = "champ")]
    champ: f64,
    #[serde(default = "image_usuelle", deserialize_with = "image")]
    image: (u32, u32),
}

/// How the camera, which looks along −z at first, is turned.
#[derive(Deserialize)]
enum Regard {
    /// Towards this point, with the horizon level.
    Point(Vecteur),
    /// By this vecteur-rotation.
    Rotation(#[serde(deserialize_with = "rotation")] Rotation),
}

impl TryFrom<CameraBrute> for Camera {
    type Error = ErreurGeo;
    fn try_from(brute: CameraBrute) -> Result<Self, ErreurGeo> {
        let CameraBrute { source, regard, champ, image } = brute;
        let rotation = match regard {
            Regard::Rotation(rotation) => rotation,
            Regard::Point(point) => {
                let rayon = Rayon::new(source, point - source).map_err(|mut erreur| {
                    erreur.champ = "regard - source";
                    erreur
                });
                let d = rayon?.direction();
                // From libm, as in the library, so that a scene has the same bits on every machine.
                let montee = libm::atan2(d.y, libm::hypot(d.x, d.z));
                let lacet = libm::atan2(-d.x, -d.z);
                Rotation::main_droite(Vecteur::new(montee, lacet, 0.0))?
            }
        };
        Ok(Self { source, rotation, hauteur: 2.0 * libm::tan(champ.to_radians() / 2.0), image })
    }
}

/// An object as the file describes it.
#[derive(Deserialize)]
#[serde(rename = "Objet", deny_unknown_fields)]
#[serde(bound(deserialize = "R: Reel + Deserialize<'de>"))]
enum ObjetBrut<R> {
    Sphere {
        #[serde(deserialize_with = "centre")]
        centre: Vecteur<R>,
        #[serde(deserialize_with = "rayon")]
        rayon: R,
        texture: Texture,
        #[serde(default)]
        transformations: Vec<Transformation<R>>,
    },
    Plan {
        #[serde(deserialize_with = "rotation")]
        rotation: Rotation<R>,
        #[serde(deserialize_with = "distance")]
        distance: R,
        texture: Texture,
        #[serde(default)]
        transformations: Vec<Transformation<R>>,
    },
    Boite {
        #[serde(deserialize_with = "centre")]
        centre: Vecteur<R>,
        #[serde(deserialize_with = "dimensions")]
        dimensions: Vecteur<R>,
        #[serde(deserialize_with = "rotation")]
        rotation: Rotation<R>,
        texture: Texture,
        #[serde(default)]
        transformations: Vec<Transformation<R>>,
    },
}

#[derive(Deserialize)]
#[serde(bound(deserialize = "R: Reel + Deserialize<'de>"))]
enum Transformation<R> {
    Translation(Vecteur<R>),
    Rotation(#[serde(deserialize_with = "rotation")] Rotation<R>),
    Homothetie(#[serde(deserialize_with = "coefficient")] R),
}

/// An object once its transformations are applied.
#[derive(Deserialize)]
#[serde(try_from = "ObjetBrut<R>")]
#[serde(bound(deserialize = "R: Reel + Deserialize<'de>"))]
struct Objet<R: Reel>(ObjetGeo<R>);

impl<R: Reel> TryFrom<ObjetBrut<R>> for Objet<R> {
    type Error = ErreurGeo;
    fn try_from(brut: ObjetBrut<R>) -> Result<Self, ErreurGeo> {
        let (objet, transformations): (ObjetGeo<R>, _) = match brut {
            ObjetBrut::Sphere { centre, rayon, texture, transformations } => {
                (SphereGeo::new(centre, rayon, texture)?.into(), transformations)
            }
            ObjetBrut::Plan { rotation, distance, texture, transformations } => {
                (PlanGeo::new(rotation, distance, texture)?.into(), transformations)
            }
            ObjetBrut::Boite { centre, dimensions, rotation, texture, transformations } => {
                (BoiteGeo::new(centre, dimensions, rotation, texture)?.into(), transformations)
            }
        };
        let transforme = transformations.into_iter().try_fold(objet, |objet, t| match t {
            Transformation::Translation(v) => objet.translation(v),
            Transformation::Rotation(r) => objet.rotation(r),
            Transformation::Homothetie(k) => objet.homothetie(k),
        });
        transforme.map(Self)
    }
}

fn objets<'de, D, R>(d: D) -> Result<Vec<ObjetGeo<R>>, D::Error>
where
    D: Deserializer<'de>,
    R: Reel + Deserialize<'de>,
{
    let objets: Vec<Objet<R>> = Vec::deserialize(d)?;
    Ok(objets.into_iter().map(|Objet(objet)| objet).collect())
}

/// Reads a field and has the library try it on an otherwise valid object, so that a refusal points at the field and not
/// at the end of the object.
fn essaye<'de, D, T, V>(d: D, essai: impl FnOnce(T) -> Result<V, ErreurGeo>) -> Result<T, D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de> + Copy,
{
    let valeur = T::deserialize(d)?;
    essai(valeur).map(|_| valeur).map_err(D::Error::custom)
}

fn centre<'de, D: Deserializer<'de>, R: Reel + Deserialize<'de>>(
    d: D,
) -> Result<Vecteur<R>, D::Error> {
    essaye(d, |centre| SphereGeo::new(centre, R::UN, Texture(0)))
}

fn rayon<'de, D: Deserializer<'de>, R: Reel + Deserialize<'de>>(d: D) -> Result<R, D::Error> {
    essaye(d, |rayon| SphereGeo::new(Vecteur::NUL, rayon, Texture(0)))
}

fn distance<'de, D: Deserializer<'de>, R: Reel + Deserialize<'de>>(d: D) -> Result<R, D::Error> {
    essaye(d, |distance| PlanGeo::new(Rotation::IDENTITE, distance, Texture(0)))
}

fn dimensions<'de, D: Deserializer<'de>, R: Reel + Deserialize<'de>>(
    d: D,
) -> Result<Vecteur<R>, D::Error> {
    essaye(d, |cotes| BoiteGeo::new(Vecteur::NUL, cotes, Rotation::IDENTITE, Texture(0)))
}

fn coefficient<'de, D: Deserializer<'de>, R: Reel + Deserialize<'de>>(d: D) -> Result<R, D::Error> {
    essaye(d, |k| PlanGeo::new(Rotation::IDENTITE, R::ZERO, Texture(0))?.homothetie(k))
}

/// A vecteur-rotation in degrees. It is counted in quarter turns, so that 90 becomes the float nearest to π/2, which
/// turns exactly; a factor π/180 would be rounded first.
fn rotation<'de, D: Deserializer<'de>, R: Reel>(d: D) -> Result<Rotation<R>, D::Error> {
    let degres = Vecteur::deserialize(d)?;
    Rotation::new(Vecteur::depuis_f64(degres / 90.0 * FRAC_PI_2)).map_err(D::Error::custom)
}

fn source<'de, D: Deserializer<'de>>(d: D) -> Result<Vecteur, D::Error> {
    essaye(d, |source| Rayon::new(source, Vecteur::new(0.0, 0.0, -1.0)))
}

fn champ<'de, D: Deserializer<'de>>(d: D) -> Result<f64, D::Error> {
    let champ = f64::deserialize(d)?;
    if 0.0 < champ && champ < 180.0 {
        return Ok(champ);
    }
    Err(D::Error::custom(format_args!(
        "champ is {champ}, but must lie strictly between 0 and 180 degrees"
    )))
}

fn image<'de, D: Deserializer<'de>>(d: D) -> Result<(u32, u32), D::Error> {
    let (largeur, hauteur) = <(u32, u32)>::deserialize(d)?;
    if [largeur, hauteur].iter().all(|cote| (1..=4096).contains(cote)) {
        return Ok((largeur, hauteur));
    }
    let pixels = format_args!("{largeur} x {hauteur}");
    Err(D::Error::custom(format_args!("image is {pixels}, but must be 1 to 4096 pixels each way")))
}

/// The size that the handout takes as its example.
fn image_usuelle() -> (u32, u32) {
    (600, 400)
}
