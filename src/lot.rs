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

use fearless_simd::{Level, Simd};

use crate::compile_ici::compile_ici;
use crate::intersection::{Intersection, NoIntersection, Rang, Touche, rang};
use crate::lot::colonnes::{VOIES, membres};
use crate::lot::faisceau::Faisceau;
use crate::lot::fenetre::Rangee;
use crate::lot::groupe::Groupe;
use crate::niveau::{meilleur_niveau, selon_le_niveau};
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
/// several times as much. Pass at least some hundred rays a call; from some hundred spheres and boxes on, use a
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
#[doc(alias("batch", "packet", "cast_rays"))]
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

compile_ici! {
    /// [`premieres_intersections`] with these instructions, with culling or without; no answer depends on
    /// either.
    pub(crate) fn repondre<'a, R>(
        niveau: Level,
        elaguer: bool,
        objets: &'a [ObjetRay<R>],
        rayons: &'a [Rayon<R>],
        touches: &'a mut [Touche<R>],
    ) -> Result<(), LongueursDifferentes> {
        memes_longueurs(rayons, touches)?;
        // In a longer list two objects share a rank.
        if rayons.len() < PEU_DE_RAYONS || objets.len() > Rang::MAX.get() as usize {
            for (rayon, touche) in rayons.iter().zip(touches) {
                *touche = premiere_intersection(objets, rayon);
            }
            return Ok(());
        }
        let (mut etroite, mut large);
        let fenetre: &mut [Rangee<R>] = if !elaguer || objets.len() < SEUIL_ELAGAGE {
            &mut []
        } else if objets.len() <= FENETRE_ETROITE * VOIES {
            etroite = [const { Rangee::VIDE }; FENETRE_ETROITE];
            &mut etroite
        } else {
            large = [const { Rangee::VIDE }; FENETRE];
            &mut large
        };
        // Where one window holds all objects it is filled once.
        if objets.len() <= fenetre.len() * VOIES {
            charger(fenetre, objets);
        }
        selon_le_niveau!(niveau, simd => {
            let recherche = RechercheDansLaListe { simd, objets, fenetre: &mut *fenetre };
            par_blocs(simd, objets, rayons, touches, recherche);
        });
        Ok(())
    }
}

/// Puts the balls around these objects into a window.
#[inline(always)]
fn charger<R: Reel>(fenetre: &mut [Rangee<R>], objets: &[ObjetRay<R>]) {
    for (rangee, objets) in fenetre.iter_mut().zip(objets.chunks(VOIES)) {
        rangee.charger(objets);
    }
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

/// Finds the first object of each ray of a block.
///
/// A trait and not a closure, since only a method can be `inline(always)` (`lot/groupe.rs`).
pub(crate) trait RechercheDeBloc<R> {
    /// Leaves the first objects in `bloc`, or writes the answers itself, and tells whether it did.
    fn chercher(
        &mut self,
        bloc: &mut [Groupe<R>],
        rayons: &[Rayon<R>],
        touches: &mut [Touche<R>],
    ) -> bool;
}

/// Searches a list. Where there is a window, culls the objects that the beam of the block avoids.
struct RechercheDansLaListe<'a, R, S> {
    simd: S,
    objets: &'a [ObjetRay<R>],
    fenetre: &'a mut [Rangee<R>],
}

impl<R: Reel, S: Simd> RechercheDeBloc<R> for RechercheDansLaListe<'_, R, S> {
    #[inline(always)]
    fn chercher(
        &mut self,
        bloc: &mut [Groupe<R>],
        rayons: &[Rayon<R>],
        _: &mut [Touche<R>],
    ) -> bool {
        let Self { simd, objets, fenetre } = self;
        let capacite = fenetre.len() * VOIES;
        let faisceau = if capacite > 0 { Faisceau::du_bloc(rayons, bloc) } else { None };
        let Some(faisceau) = faisceau else {
            for (indice, objet) in objets.iter().enumerate() {
                proposer::<R, true>(bloc, objet, rang(indice));
            }
            return false;
        };
        for (debut, proches) in (0..).step_by(capacite).zip(objets.chunks(capacite)) {
            if objets.len() > capacite {
                charger(fenetre, proches);
            }
            for (numero, (rangee, seize)) in fenetre.iter().zip(proches.chunks(VOIES)).enumerate() {
                for i in membres(rangee.rencontres(*simd, &faisceau)) {
                    if let Some(objet) = seize.get(i) {
                        let rang = rang(debut + numero * VOIES + i);
                        proposer::<R, true>(bloc, objet, rang);
                    }
                }
            }
        }
        false
    }
}

/// Block by block from the rays to the answers, so that a block stays in the nearest memory.
#[inline(always)]
pub(crate) fn par_blocs<R: Reel, S: Simd>(
    simd: S,
    objets: &[ObjetRay<R>],
    rayons: &[Rayon<R>],
    touches: &mut [Touche<R>],
    mut recherche: impl RechercheDeBloc<R>,
) {
    let mut bloc = [const { Groupe::VIDE }; BLOC / VOIES];
    for (rayons, touches) in rayons.chunks(BLOC).zip(touches.chunks_mut(BLOC)) {
        let bloc = &mut bloc[..rayons.len().div_ceil(VOIES)];
        for (groupe, rayons) in bloc.iter_mut().zip(rayons.chunks(VOIES)) {
            groupe.charger(rayons);
        }
        if !recherche.chercher(bloc, rayons, touches) {
            ecrire(simd, bloc, objets, rayons, touches);
        }
    }
}

/// Writes the answers of a block; a function of the instruction set, which list and hierarchy share.
#[inline(always)]
fn ecrire<R: Reel, S: Simd>(
    simd: S,
    bloc: &[Groupe<R>],
    objets: &[ObjetRay<R>],
    rayons: &[Rayon<R>],
    touches: &mut [Touche<R>],
) {
    simd.vectorize(
        #[inline(always)]
        || {
            let morceaux = rayons.chunks(VOIES).zip(touches.chunks_mut(VOIES));
            for (groupe, (rayons, touches)) in bloc.iter().zip(morceaux) {
                groupe.ecrire(objets, rayons, touches);
            }
        },
    );
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
