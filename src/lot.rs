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
pub(crate) mod demande;
pub(crate) mod faisceau;
mod fenetre;
pub(crate) mod groupe;

use core::fmt;

use fearless_simd::{Level, Simd};

use crate::compile::compilees;
use crate::intersection::Touche;
use crate::lot::bloc::{BLOC, Bloc, groupes_vides};
use crate::lot::demande::Demande;
use crate::lot::fenetre::Rangee;
use crate::niveau::{meilleur_niveau, selon_le_niveau};
use crate::objet::ObjetRay;
use crate::rayon::Rayon;
use crate::reel::Reel;
use crate::seize::{SEIZE, prendre};

/// Fewer rays than this are faster one by one: half a group.
pub(crate) const PEU_DE_RAYONS: usize = SEIZE / 2;

/// Rows of sixteen objects in a window: 256 objects, 8 kB of the stack in `f64`.
const FENETRE: usize = 16;

/// The same for lists of at most 64 objects: to set up a large window costs as much as fifteen
/// rays.
const FENETRE_ETROITE: usize = 4;

/// From so many objects on, culling saves more than it costs (`docs/performance.md`, "Thresholds").
const SEUIL_ELAGAGE: usize = 10;

/// The first object that each ray enters:
/// [`premiere_intersection`](fn@crate::premiere_intersection) of every ray, to the bit, and several
/// times as fast for the rays of a picture.
///
/// Neighbours in `rayons` should be neighbours in the picture, in tiles of 8 × 8 better than in
/// rows: objects that sixty-four rays in a row all miss cost next to nothing. Rays in no order gain
/// less, or nothing. Pass 64 rays or more a call; from a dozen spheres and boxes on, use a
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
    touches: &mut [Touche<R>],
) -> Result<(), LongueursDifferentes> {
    R::demander::<Lot>(((meilleur_niveau(), objets, None), rayons, touches))
}

/// There are more or fewer places for answers than rays.
///
/// ```
/// use lancer_rayon::{LongueursDifferentes, NoIntersection, Rayon, premieres_intersections};
///
/// let rayons: [Rayon; 0] = [];
/// let mut touches = [Err(NoIntersection); 3];
/// let refus = premieres_intersections(&[], &rayons, &mut touches);
/// assert_eq!(refus, Err(LongueursDifferentes { rayons: 0, reponses: 3 }));
/// ```
#[doc(alias = "length_mismatch")]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct LongueursDifferentes {
    /// How many rays.
    #[doc(alias = "rays")]
    pub rayons: usize,
    /// Places for how many answers.
    #[doc(alias = "answers")]
    pub reponses: usize,
}

impl fmt::Display for LongueursDifferentes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} rays, but places for {} answers", self.rayons, self.reponses)
    }
}

impl core::error::Error for LongueursDifferentes {}

/// Whether anything stands before the lamp of each shadow ray: [`est_occulte`](fn@crate::est_occulte) of
/// every ray and the distance of its lamp, to the bit, and sooner.
///
/// [`vers_lumiere`](Rayon::vers_lumiere) gives both. What [`premieres_intersections`] says of order and
/// length of a call holds here; rays to one lamp, in the order of the picture, are neighbours. A ray
/// from inside an object does not see that object.
///
/// # Errors
/// If `ombres` and `occultes` are not of the same length; nothing is written then.
///
/// ```
/// use lancer_rayon::{ObjetRay, Rayon, SphereGeo, Texture, Vecteur, sont_occultes};
///
/// let boule = ObjetRay::from(SphereGeo::new(Vecteur::new(0.0, 3.0, 0.0), 1.0, Texture(0))?);
/// let vers_le_haut = |x| Rayon::new(Vecteur::new(x, 0.0, 0.0), Vecteur::new(0.0, 1.0, 0.0));
/// let ombres = [(vers_le_haut(0.0)?, 9.0), (vers_le_haut(0.0)?, 2.0), (vers_le_haut(4.0)?, 9.0)];
///
/// let mut occultes = [false; 3];
/// sont_occultes(&[boule], &ombres, &mut occultes)?;
/// assert_eq!(occultes, [true, false, false]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[doc(alias("any_hit", "occluded", "shadow", "batch"))]
pub fn sont_occultes<R: Reel>(
    objets: &[ObjetRay<R>],
    ombres: &[(Rayon<R>, R)],
    occultes: &mut [bool],
) -> Result<(), LongueursDifferentes> {
    R::demander::<LotDOmbres>(((meilleur_niveau(), objets, None), ombres, occultes))
}

/// The instructions to take, on which no answer depends; a list; the index of an object to leave
/// out.
pub(crate) type Liste<'a, R> = (Level, &'a [ObjetRay<R>], Option<usize>);

compilees! {
    Lot<'a, R>: (Liste<'a, R>, &'a [Rayon<R>], &'a mut [Touche<R>])
        => Result<(), LongueursDifferentes> = repondre;
    LotDOmbres<'a, R>: (Liste<'a, R>, &'a [(Rayon<R>, R)], &'a mut [bool])
        => Result<(), LongueursDifferentes> = repondre;
}

/// The answers of a list to many rays.
pub(crate) fn repondre<R: Reel, D: Demande<R>>(
    ((niveau, objets, sauf), demandes, reponses): (Liste<'_, R>, &[D], &mut [D::Reponse]),
) -> Result<(), LongueursDifferentes> {
    memes_longueurs(demandes.len(), reponses.len())?;
    // In a longer list two objects share a rank.
    if demandes.len() < PEU_DE_RAYONS || u32::try_from(objets.len()).is_err() {
        for (demande, reponse) in demandes.iter().zip(reponses) {
            *reponse = demande.parmi(objets, sauf);
        }
        return Ok(());
    }
    let (mut etroite, mut large);
    let fenetre: &mut [Rangee<R>] = if objets.len() < SEUIL_ELAGAGE {
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
        let mut groupes = groupes_vides();
        let mut bloc = Bloc::new(sauf, &mut groupes);
        for (demandes, reponses) in demandes.chunks(BLOC).zip(reponses.chunks_mut(BLOC)) {
            bloc.charger(demandes);
            chercher(simd, objets, fenetre, &mut bloc);
            bloc.ecrire(simd, objets, reponses);
        }
    });
    Ok(())
}

/// Refuses places for more or fewer answers than there are rays.
pub(crate) fn memes_longueurs(rayons: usize, reponses: usize) -> Result<(), LongueursDifferentes> {
    if rayons == reponses { Ok(()) } else { Err(LongueursDifferentes { rayons, reponses }) }
}

/// Finds the first object of each ray of a block. Where there is a window, culls the objects that
/// the beam of the block avoids.
#[inline(always)]
fn chercher<R: Reel, D: Demande<R>, S: Simd>(
    simd: S,
    objets: &[ObjetRay<R>],
    fenetre: &mut [Rangee<R>],
    bloc: &mut Bloc<'_, R, D>,
) {
    let capacite = fenetre.len() * SEIZE;
    let faisceau = if capacite > 0 { bloc.faisceau() } else { None };
    let Some(faisceau) = faisceau else {
        return bloc.proposer_tous(objets);
    };
    for (debut, proches) in (0..).step_by(capacite).zip(objets.chunks(capacite)) {
        if objets.len() > capacite {
            charger(fenetre, proches);
        }
        for (debut, rangee) in (debut..debut + proches.len()).step_by(SEIZE).zip(&*fenetre) {
            let mut rencontres = rangee.rencontres(simd, &faisceau);
            while let Some(i) = prendre(&mut rencontres) {
                bloc.proposer(objets, debut + i);
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
