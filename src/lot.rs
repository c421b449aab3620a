//! Many rays at once: a picture of 600 × 400 pixels is 240,000 of them.
//!
//! Three sizes cut the work:
//!
//! - a **group** of 16 rays goes side by side through the formulae of a shape (`lot/groupe.rs`);
//! - a **block** of 64 rays, a tile of 8 × 8 pixels, shares a beam that leaves objects out
//!   (`lot/faisceau.rs`);
//! - a **window** holds the balls of 64 or 256 objects in columns, and the beam is tested against it
//!   (`lot/fenetre.rs`).

pub(crate) mod colonnes;
pub(crate) mod faisceau;
mod fenetre;
pub(crate) mod groupe;

use core::fmt;

use fearless_simd::{Level, Simd, dispatch};

use crate::intersection::{Intersection, NoIntersection, Rang, Touche, rang};
use crate::lot::colonnes::{VOIES, le_premier};
use crate::lot::faisceau::Faisceau;
use crate::lot::fenetre::Fenetre;
use crate::lot::groupe::Groupe;
use crate::objet::{ObjetRay, par_forme};
use crate::rayon::Rayon;
use crate::recherche::premiere_intersection;
use crate::reel::Reel;

/// Rays of a block.
const BLOC: usize = 4 * VOIES;

/// Fewer rays than this are faster one by one: half a group.
pub(crate) const PEU_DE_RAYONS: usize = VOIES / 2;

/// Rows of sixteen objects in a window: 256 objects, 8 kB of the stack in `f64`.
const FENETRE: usize = 16;

/// The same for lists of at most 64 objects: to set up a large window costs as much as fifteen rays.
const FENETRE_ETROITE: usize = 4;

/// From so many objects on, culling saves more than it costs (`docs/performance.md`, "Thresholds").
const SEUIL_ELAGAGE: usize = 10;

/// The first object that each ray enters: [`premiere_intersection`] of every ray, to the bit, several
/// times as fast.
///
/// Neighbours in `rayons` should be neighbours in the picture, in tiles of 8 × 8 better than in rows:
/// objects that sixty-four rays in a row all miss cost next to nothing. Rays in no order at all cost
/// several times as much. Pass at least some hundred rays a call; from some hundred objects on, use a
/// [`Hierarchie`](crate::Hierarchie). Nothing is allocated and no thread is started; the caller may
/// give parts of a picture to several threads.
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
    memes_longueurs(rayons, touches)?;
    // In a longer list two objects share a rank.
    if rayons.len() < PEU_DE_RAYONS || objets.len() > Rang::MAX.get() as usize {
        for (rayon, touche) in rayons.iter().zip(touches) {
            *touche = premiere_intersection(objets, rayon);
        }
    } else if !elaguer || objets.len() < SEUIL_ELAGAGE {
        dispatch!(niveau, _simd => {
            par_blocs(objets, rayons, touches, &mut Tous { objets });
        });
    } else if objets.len() <= FENETRE_ETROITE * VOIES {
        avec_fenetre::<R, FENETRE_ETROITE>(niveau, objets, rayons, touches);
    } else {
        avec_fenetre::<R, FENETRE>(niveau, objets, rayons, touches);
    }
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

/// With culling, in a window of Q times sixteen objects.
fn avec_fenetre<R: Reel, const Q: usize>(
    niveau: Level,
    objets: &[ObjetRay<R>],
    rayons: &[Rayon<R>],
    touches: &mut [Touche<R>],
) {
    let mut fenetre = Fenetre::<R, Q>::VIDE;
    // Where one window holds all objects it is filled once.
    if objets.len() <= Fenetre::<R, Q>::CAPACITE {
        fenetre.charger(objets);
    }
    dispatch!(niveau, simd => {
        let mut elagage = Elagage { simd, objets, fenetre: &mut fenetre };
        par_blocs(objets, rayons, touches, &mut elagage);
    });
}

/// Finds the first object of each ray of a block.
///
/// A trait and not a closure, since only a method can be `inline(always)` (`lot/groupe.rs`).
pub(crate) trait RechercheDeBloc<R> {
    /// Leaves the first objects in `bloc`, from which [`par_blocs`] writes the answers, or writes the
    /// answers itself; the result says which.
    fn chercher(
        &mut self,
        bloc: &mut [Groupe<R>],
        rayons: &[Rayon<R>],
        touches: &mut [Touche<R>],
    ) -> Trouve;
}

/// Where a [`RechercheDeBloc`] left what it found.
#[derive(PartialEq)]
pub(crate) enum Trouve {
    DansLeBloc,
    DansLesTouches,
}

/// Searches a list and tests every object.
struct Tous<'a, R> {
    objets: &'a [ObjetRay<R>],
}

impl<R: Reel> RechercheDeBloc<R> for Tous<'_, R> {
    #[inline(always)]
    fn chercher(&mut self, bloc: &mut [Groupe<R>], _: &[Rayon<R>], _: &mut [Touche<R>]) -> Trouve {
        for (indice, objet) in self.objets.iter().enumerate() {
            proposer::<R, true>(bloc, objet, rang(indice));
        }
        Trouve::DansLeBloc
    }
}

/// Searches a list and culls the objects that the beam of the block avoids.
struct Elagage<'a, R, S, const Q: usize> {
    simd: S,
    objets: &'a [ObjetRay<R>],
    fenetre: &'a mut Fenetre<R, Q>,
}

impl<R: Reel, S: Simd, const Q: usize> RechercheDeBloc<R> for Elagage<'_, R, S, Q> {
    #[inline(always)]
    fn chercher(
        &mut self,
        bloc: &mut [Groupe<R>],
        rayons: &[Rayon<R>],
        touches: &mut [Touche<R>],
    ) -> Trouve {
        let Self { simd, objets, fenetre } = self;
        let Some(faisceau) = Faisceau::du_bloc(rayons, bloc) else {
            return Tous { objets }.chercher(bloc, rayons, touches);
        };
        for (numero, rangee) in objets.chunks(VOIES).enumerate() {
            if numero % Q == 0 && objets.len() > Fenetre::<R, Q>::CAPACITE {
                fenetre.charger(&objets[numero * VOIES..]);
            }
            let mut vus = fenetre.rencontres(*simd, &faisceau, numero % Q);
            while vus != 0 {
                let i = le_premier(vus);
                vus &= vus - 1;
                if let Some(objet) = rangee.get(i) {
                    proposer::<R, true>(bloc, objet, rang(numero * VOIES + i));
                }
            }
        }
        Trouve::DansLeBloc
    }
}

/// Block by block from the rays to the answers, so that a block stays in the nearest memory.
#[inline(always)]
pub(crate) fn par_blocs<R: Reel>(
    objets: &[ObjetRay<R>],
    rayons: &[Rayon<R>],
    touches: &mut [Touche<R>],
    recherche: &mut impl RechercheDeBloc<R>,
) {
    let mut bloc = [const { Groupe::VIDE }; BLOC / VOIES];
    for (rayons, touches) in rayons.chunks(BLOC).zip(touches.chunks_mut(BLOC)) {
        let bloc = &mut bloc[..rayons.len().div_ceil(VOIES)];
        for (groupe, rayons) in bloc.iter_mut().zip(rayons.chunks(VOIES)) {
            groupe.charger(rayons);
        }
        if recherche.chercher(bloc, rayons, touches) == Trouve::DansLesTouches {
            continue;
        }
        for (i, groupe) in bloc.iter().enumerate() {
            let (debut, fin) = (i * VOIES, rayons.len().min((i + 1) * VOIES));
            groupe.ecrire(objets, &rayons[debut..fin], &mut touches[debut..fin]);
        }
    }
}

/// For each ray that enters the object, which has this rank, before its first so far: makes it its first.
///
/// The shape is copied: nothing that is written to a group can overlap it, so that the compiler
/// need not read it again for every ray.
#[inline(always)]
pub(crate) fn proposer<R: Reel, const EN_ORDRE: bool>(
    bloc: &mut [Groupe<R>],
    objet: &ObjetRay<R>,
    rang: Rang,
) {
    par_forme!(ObjetRay, objet, forme => {
        let forme = *forme;
        for groupe in bloc {
            groupe.proposer::<EN_ORDRE>(&forme, rang);
        }
    });
}
