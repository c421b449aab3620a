//! Many rays at once: a picture of 600 × 400 pixels is 240,000 of them.
//!
//! A **group** of 16 rays goes side by side through the formulae of a shape (`lot/groupe.rs`). A **block** of 64
//! rays, a tile of 8 × 8 pixels, takes an object at a time (`lot/bloc.rs`): of a list every object, of a
//! hierarchy those whose boxes its beam crosses (`lot/faisceau.rs`).

pub(crate) mod bloc;
pub(crate) mod demande;
pub(crate) mod faisceau;
pub(crate) mod groupe;

use core::fmt;

use fearless_simd::Level;

use crate::compile::compilees;
use crate::intersection::Touche;
use crate::liste::Liste;
use crate::lot::bloc::{BLOC, Bloc, Groupes};
use crate::lot::demande::Demande;
use crate::niveau::{meilleur_niveau, selon_le_niveau};
use crate::objet::ObjetRay;
use crate::rayon::Rayon;
use crate::reel::Reel;
use crate::seize::SEIZE;

/// Fewer rays than this ask a list faster one by one: half a group.
const PEU_DE_RAYONS: usize = SEIZE / 2;

/// The first object that each ray enters:
/// [`premiere_intersection`](fn@crate::premiere_intersection) of every ray, to the bit, and several
/// times as fast for the rays of a picture.
///
/// Every object is asked, of sixteen rays side by side: neighbours in `rayons` should be neighbours in the
/// picture, since an object that sixteen rays in a row all pass by costs little. Pass 64 rays or more a call;
/// from ten spheres and boxes on, use a [`Hierarchie`](crate::Hierarchie). Nothing is allocated and no
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
    R::demander::<Lot>(((meilleur_niveau(), Liste::entiere(objets)), rayons, touches))
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
    R::demander::<LotDOmbres>(((meilleur_niveau(), Liste::entiere(objets)), ombres, occultes))
}

/// A list, and the instructions to take, on which no answer depends.
pub(crate) type ListeAuNiveau<'a, R> = (Level, Liste<'a, R>);

compilees! {
    Lot<'a, R>: (ListeAuNiveau<'a, R>, &'a [Rayon<R>], &'a mut [Touche<R>])
        => Result<(), LongueursDifferentes> = repondre;
    LotDOmbres<'a, R>: (ListeAuNiveau<'a, R>, &'a [(Rayon<R>, R)], &'a mut [bool])
        => Result<(), LongueursDifferentes> = repondre;
}

/// The answers of a list to many rays.
pub(crate) fn repondre<R: Reel, D: Demande<R>>(
    ((niveau, liste), demandes, reponses): (ListeAuNiveau<'_, R>, &[D], &mut [D::Reponse]),
) -> Result<(), LongueursDifferentes> {
    memes_longueurs(demandes.len(), reponses.len())?;
    // In a longer list two objects share a rank.
    if demandes.len() < PEU_DE_RAYONS || u32::try_from(liste.objets.len()).is_err() {
        for (demande, reponse) in demandes.iter().zip(reponses) {
            *reponse = demande.parmi(liste);
        }
        return Ok(());
    }
    selon_le_niveau!(niveau, simd => {
        let mut groupes = Groupes::new_const();
        let mut bloc = Bloc::new(liste, &mut groupes);
        for (demandes, reponses) in demandes.chunks(BLOC).zip(reponses.chunks_mut(BLOC)) {
            bloc.charger(demandes);
            bloc.proposer_tous();
            bloc.ecrire(simd, reponses);
        }
    });
    Ok(())
}

/// Refuses places for more or fewer answers than there are rays.
pub(crate) fn memes_longueurs(rayons: usize, reponses: usize) -> Result<(), LongueursDifferentes> {
    if rayons == reponses { Ok(()) } else { Err(LongueursDifferentes { rayons, reponses }) }
}
