//! Many rays at once: an image is 240,000 of them.
//!
//! Four sizes cut the work:
//!
//! - a **group** of 16 rays goes side by side through the formulae of a shape (`lot/groupe.rs`);
//! - a **block** of 64 rays, a tile of 8 × 8 pixels, shares a beam that leaves objects out
//!   (`lot/faisceau.rs`);
//! - a **slice** of 4,096 rays shares a selection of objects, from which its blocks choose
//!   (`lot/selection.rs`);
//! - the **places** of a selection are 64, 256 or 1,024 objects; a slice that needs more is halved.

mod colonnes;
mod faisceau;
mod groupe;
mod selection;

use core::fmt;

use fearless_simd::{Level, dispatch};

use crate::intersection::{Intersection, NoIntersection, Rang, Touche, rang};
use crate::lot::colonnes::VOIES;
use crate::lot::faisceau::Faisceau;
use crate::lot::groupe::Groupe;
use crate::lot::selection::{Places, SEUIL_FAISCEAU, Selection};
use crate::objet::{ObjetRay, par_forme};
use crate::rayon::Rayon;
use crate::recherche::premiere_intersection;
use crate::reel::Reel;

/// Rays of a block.
const BLOC: usize = 4 * VOIES;

/// Rays that share a selection of objects, as long as that finds room for them.
const TRANCHE: usize = 64 * BLOC;

/// From so many objects on, culling saves more than it costs (measured).
const SEUIL_ELAGAGE: usize = 10;

/// The first object that each ray enters: [`premiere_intersection`] of every ray, to the bit, several
/// times as fast.
///
/// Neighbours in `rayons` should be neighbours in the picture, in tiles of 8 × 8 better than in
/// rows: objects that sixty-four rays in a row all miss cost next to nothing. Rays in no order at
/// all are still faster than one by one. Give it some hundred rays a call, and where there are many
/// objects some thousand: which objects matter is chosen for 4,096 at a time. Nothing is allocated
/// and no thread is started; parts of a picture may be given to several.
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
#[doc(alias = "batch")]
#[doc(alias = "packet")]
#[doc(alias = "cast_rays")]
pub fn premieres_intersections<R: Reel>(
    objets: &[ObjetRay<R>],
    rayons: &[Rayon<R>],
    touches: &mut [Result<Intersection<R>, NoIntersection>],
) -> Result<(), LongueursDifferentes> {
    repondre(meilleur_niveau(), true, objets, rayons, touches)
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
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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

/// The widest instructions of this machine.
#[inline]
pub(crate) fn meilleur_niveau() -> Level {
    Level::try_detect().unwrap_or(Level::baseline())
}

/// [`premieres_intersections`] with these instructions, with culling or without; no answer depends on
/// either.
pub(crate) fn repondre<R: Reel>(
    niveau: Level,
    elaguer: bool,
    objets: &[ObjetRay<R>],
    rayons: &[Rayon<R>],
    touches: &mut [Touche<R>],
) -> Result<(), LongueursDifferentes> {
    if rayons.len() != touches.len() {
        return Err(LongueursDifferentes { rayons: rayons.len(), touches: touches.len() });
    }
    // A group of so few would be slower; and of more objects two could share a rank.
    if rayons.len() < VOIES / 2 || objets.len() > Rang::MAX.get() as usize {
        for (rayon, touche) in rayons.iter().zip(touches) {
            *touche = premiere_intersection(objets, rayon);
        }
    } else if !elaguer || objets.len() < SEUIL_ELAGAGE {
        dispatch!(niveau, _simd => lancer(objets, rayons, touches, None));
    } else if objets.len() <= SEUIL_FAISCEAU {
        avec_places::<R, SEUIL_FAISCEAU>(niveau, objets, rayons, touches);
    } else if rayons.len() < TRANCHE / 2 {
        // To set up many places costs as much as fifty rays.
        avec_places::<R, 256>(niveau, objets, rayons, touches);
    } else {
        avec_places::<R, 1024>(niveau, objets, rayons, touches);
    }
    Ok(())
}

/// With room for a selection of P objects.
fn avec_places<R: Reel, const P: usize>(
    niveau: Level,
    objets: &[ObjetRay<R>],
    rayons: &[Rayon<R>],
    touches: &mut [Touche<R>],
) {
    let mut places = Places::<R, P>::VIDES;
    let selection = Some(places.selection());
    dispatch!(niveau, _simd => lancer(objets, rayons, touches, selection));
}

/// Slice by slice, and in it block by block from the rays to the answers, so that a block stays in
/// the nearest memory.
#[inline(always)]
fn lancer<R: Reel>(
    objets: &[ObjetRay<R>],
    rayons: &[Rayon<R>],
    touches: &mut [Touche<R>],
    mut selection: Option<Selection<'_, R>>,
) {
    let mut bloc = [const { Groupe::VIDE }; BLOC / VOIES];
    let (mut debut, mut taille) = (0, TRANCHE);
    while debut < rayons.len() {
        let fin = rayons.len().min(debut + taille);
        let de_la_tranche = &rayons[debut..fin];
        let choisie = selection.as_mut().is_some_and(|s| s.selectionner(objets, de_la_tranche));
        if selection.is_some() && !choisie && de_la_tranche.len() > BLOC {
            // Fewer rays see fewer objects.
            taille = (de_la_tranche.len() / 2).next_multiple_of(BLOC);
            continue;
        }
        let choix = selection.as_mut().filter(|_| choisie);
        repondre_a_la_tranche(objets, de_la_tranche, &mut touches[debut..fin], choix, &mut bloc);
        debut = fin;
    }
}

/// The objects of the selection, or all of them without one.
#[inline(always)]
fn repondre_a_la_tranche<R: Reel>(
    objets: &[ObjetRay<R>],
    rayons: &[Rayon<R>],
    touches: &mut [Touche<R>],
    mut selection: Option<&mut Selection<'_, R>>,
    bloc: &mut [Groupe<R>; BLOC / VOIES],
) {
    for (rayons, touches) in rayons.chunks(BLOC).zip(touches.chunks_mut(BLOC)) {
        let bloc = &mut bloc[..rayons.len().div_ceil(VOIES)];
        for (groupe, rayons) in bloc.iter_mut().zip(rayons.chunks(VOIES)) {
            groupe.charger(rayons);
        }
        if let Some(selection) = &mut selection
            && let Some(faisceau) =
                Faisceau::du_bloc(rayons, bloc.iter().map(|groupe| &groupe.colonnes))
        {
            for (rang, ecartee) in selection.face_a(&faisceau) {
                if !ecartee && let Some(objet) = objets.get(rang.get() as usize - 1) {
                    proposer(bloc, objet, rang);
                }
            }
        } else {
            for (indice, objet) in objets.iter().enumerate() {
                proposer(bloc, objet, rang(indice));
            }
        }
        for (i, groupe) in bloc.iter().enumerate() {
            let (debut, fin) = (i * VOIES, rayons.len().min((i + 1) * VOIES));
            groupe.ecrire(objets, &rayons[debut..fin], &mut touches[debut..fin]);
        }
    }
}

/// Makes the object, which has this rank, the first of those rays that enter it before their first
/// so far.
///
/// The shape is copied: nothing that is written to a group can overlap it, so that the compiler
/// need not read it again for every ray.
#[inline(always)]
fn proposer<R: Reel>(bloc: &mut [Groupe<R>], objet: &ObjetRay<R>, rang: Rang) {
    par_forme!(ObjetRay, objet, forme => {
        let forme = *forme;
        for groupe in bloc {
            groupe.proposer(&forme, rang);
        }
    });
}
