//! Many rays at once: a picture of 600 × 400 pixels is 240,000 of them.
//!
//! Three sizes cut the work:
//!
//! - a **group** of 16 rays goes side by side through the formulae of a shape (`lot/groupe.rs`);
//! - a **block** of 64 rays, a tile of 8 × 8 pixels, shares a beam that leaves objects out
//!   (`lot/faisceau.rs`);
//! - a **window** holds the balls of 64 or 256 objects in columns, and the beam is tested against it
//!   (`lot/fenetre.rs`).

pub(crate) mod bloc;
pub(crate) mod faisceau;
mod fenetre;
pub(crate) mod groupe;

use core::fmt;

use fearless_simd::{Level, Simd};

use crate::compile::compilees;
use crate::intersection::Touche;
use crate::lot::bloc::{BLOC, Bloc};
use crate::lot::fenetre::Rangee;
use crate::niveau::{meilleur_niveau, selon_le_niveau};
use crate::objet::ObjetRay;
use crate::rayon::Rayon;
use crate::recherche::premiere_intersection;
use crate::reel::{Reel, demander};
use crate::seize::SEIZE;

/// Fewer rays than this are faster one by one: half a group.
pub(crate) const PEU_DE_RAYONS: usize = SEIZE / 2;

/// Rows of sixteen objects in a window: 256 objects, 8 kB of the stack in `f64`.
const FENETRE: usize = 16;

/// The same for lists of at most 64 objects: to set up a large window costs as much as fifteen
/// rays.
const FENETRE_ETROITE: usize = 4;

/// From so many objects on, culling saves more than it costs (`docs/performance.md`, "Thresholds").
const SEUIL_ELAGAGE: usize = 10;

/// The first object that each ray enters: [`premiere_intersection`] of every ray, to the bit,
/// several times as fast.
///
/// Neighbours in `rayons` should be neighbours in the picture, in tiles of 8 × 8 better than in
/// rows: objects that sixty-four rays in a row all miss cost next to nothing. Rays in no order at
/// all cost several times as much. Pass at least some hundred rays a call; from some hundred
/// spheres and boxes on, use a [`Hierarchie`](crate::Hierarchie). Nothing is allocated and no
/// thread is started; the caller may give parts of a picture to several threads.
///
/// # Errors
/// If `rayons` and `touches` are not of the same length; nothing is written then.
///
/// ```
/// use lancer_rayon::{
///     NoIntersection, ObjetRay, Rayon, SphereGeo, Texture, Vecteur, premieres_intersections,
/// };
///
/// let boule = ObjetRay::from(SphereGeo::new(Vecteur::new(0.0, 0.0, -5.0), 1.0, Texture(0))?);
/// let vers = |x| Rayon::new(Vecteur::NUL, Vecteur::new(x, 0.0, -1.0));
/// let rayons = [vers(0.0)?, vers(0.1)?, vers(0.5)?];
///
/// let mut touches = [Err(NoIntersection); 3];
/// premieres_intersections(&[boule], &rayons, &mut touches)?;
/// assert_eq!(touches.map(|touche| touche.is_ok()), [true, true, false]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[doc(alias("batch", "packet", "cast_rays"))]
pub fn premieres_intersections<R: Reel>(
    objets: &[ObjetRay<R>],
    rayons: &[Rayon<R>],
    touches: &mut [Touche<R>],
) -> Result<(), LongueursDifferentes> {
    let elaguer = true;
    demander::<Lot, R>(QuestionDeLot {
        niveau: meilleur_niveau(),
        elaguer,
        objets,
        rayons,
        touches,
    })
}

/// `rayons` and `touches` have different lengths.
///
/// ```
/// use lancer_rayon::{LongueursDifferentes, NoIntersection, Rayon, premieres_intersections};
///
/// let rayons: [Rayon; 0] = [];
/// let mut touches = [Err(NoIntersection); 3];
/// let refus = premieres_intersections(&[], &rayons, &mut touches);
/// assert_eq!(refus, Err(LongueursDifferentes { rayons: 0, touches: 3 }));
/// ```
#[doc(alias = "length_mismatch")]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct LongueursDifferentes {
    /// How many rays.
    #[doc(alias = "rays")]
    pub rayons: usize,
    /// Places for how many answers.
    #[doc(alias = "hits")]
    pub touches: usize,
}

impl fmt::Display for LongueursDifferentes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} rays, but places for {} answers", self.rayons, self.touches)
    }
}

impl core::error::Error for LongueursDifferentes {}

/// [`premieres_intersections`] with these instructions, with culling or without; no answer depends
/// on either.
pub(crate) struct QuestionDeLot<'a, R> {
    pub(crate) niveau: Level,
    pub(crate) elaguer: bool,
    pub(crate) objets: &'a [ObjetRay<R>],
    pub(crate) rayons: &'a [Rayon<R>],
    pub(crate) touches: &'a mut [Touche<R>],
}

compilees! {
    Lot<'a, R>: QuestionDeLot<'a, R> => Result<(), LongueursDifferentes> = repondre;
}

/// The answers of a list to many rays.
pub(crate) fn repondre<R: Reel>(
    QuestionDeLot { niveau, elaguer, objets, rayons, touches }: QuestionDeLot<'_, R>,
) -> Result<(), LongueursDifferentes> {
    memes_longueurs(rayons, touches)?;
    // In a longer list two objects share a rank.
    if rayons.len() < PEU_DE_RAYONS || u32::try_from(objets.len()).is_err() {
        for (rayon, touche) in rayons.iter().zip(touches) {
            *touche = premiere_intersection(objets, rayon);
        }
        return Ok(());
    }
    let (mut etroite, mut large);
    let fenetre: &mut [Rangee<R>] = if !elaguer || objets.len() < SEUIL_ELAGAGE {
        &mut []
    } else if objets.len() <= FENETRE_ETROITE * SEIZE {
        etroite = [const { Rangee::VIDE }; FENETRE_ETROITE];
        &mut etroite
    } else {
        large = [const { Rangee::VIDE }; FENETRE];
        &mut large
    };
    // Where one window holds all objects it is filled once.
    if objets.len() <= fenetre.len() * SEIZE {
        charger(fenetre, objets);
    }
    selon_le_niveau!(niveau, simd => {
        let mut bloc = Bloc::VIDE;
        for (rayons, touches) in rayons.chunks(BLOC).zip(touches.chunks_mut(BLOC)) {
            bloc.charger(rayons);
            chercher(simd, objets, fenetre, &mut bloc);
            bloc.ecrire(simd, objets, touches);
        }
    });
    Ok(())
}

/// Refuses places for more or fewer answers than there are rays.
pub(crate) fn memes_longueurs<R>(
    rayons: &[Rayon<R>],
    touches: &[Touche<R>],
) -> Result<(), LongueursDifferentes> {
    if rayons.len() == touches.len() {
        Ok(())
    } else {
        Err(LongueursDifferentes { rayons: rayons.len(), touches: touches.len() })
    }
}

/// Finds the first object of each ray of a block. Where there is a window, culls the objects that
/// the beam of the block avoids.
#[inline(always)]
fn chercher<R: Reel, S: Simd>(
    simd: S,
    objets: &[ObjetRay<R>],
    fenetre: &mut [Rangee<R>],
    bloc: &mut Bloc<'_, R>,
) {
    let capacite = fenetre.len() * SEIZE;
    let faisceau = if capacite > 0 { bloc.faisceau() } else { None };
    let Some(faisceau) = faisceau else {
        for (indice, objet) in objets.iter().enumerate() {
            bloc.proposer::<true>(objet, indice);
        }
        return;
    };
    for (debut, proches) in (0..).step_by(capacite).zip(objets.chunks(capacite)) {
        if objets.len() > capacite {
            charger(fenetre, proches);
        }
        for (numero, (rangee, seize)) in fenetre.iter().zip(proches.chunks(SEIZE)).enumerate() {
            for i in rangee.rencontres(simd, &faisceau) {
                if let Some(objet) = seize.get(i) {
                    bloc.proposer::<true>(objet, debut + numero * SEIZE + i);
                }
            }
        }
    }
}

/// Puts the balls around these objects into a window.
#[inline(always)]
fn charger<R: Reel>(fenetre: &mut [Rangee<R>], objets: &[ObjetRay<R>]) {
    for (rangee, objets) in fenetre.iter_mut().zip(objets.chunks(SEIZE)) {
        rangee.charger(objets);
    }
}
