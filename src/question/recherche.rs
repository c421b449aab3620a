//! The question of the handout (§4.1). An object is asked alone in `objet.rs`.

use crate::algebre::nombre::Nombre;
use crate::objet::ObjetRay;
use crate::question::Premier;
use crate::question::liste::Liste;
use crate::rayon::Rayon;
use crate::rayon::intersection::{Reponse, exiger_des_rangs};

/// The first object that the ray enters: its distance, its normal there, its texture and its index
/// in the list (handout §4.1).
///
/// For every other question, for many rays at once and for many objects there is
/// [`Monde`](crate::Monde).
///
/// A hit is an entry. An object that holds the source, inside or on its surface, is not touched
/// (handout §2.3), unless the source lies in it by little more than [the δ of the
/// ray](Rayon::flou); other objects still count. At the same distance the earlier in the list is the first. All of
/// this holds for distances as computed in R: within the bounds of `docs/precision.md` the exact
/// answer may differ.
///
/// # Errors
/// [`NoIntersection`](crate::NoIntersection) if the ray enters no object before its end.
///
/// # Panics
/// If the list has more than 2³² − 1 objects, some 300 GB.
///
/// ```
/// use lancer_rayon::{NoIntersection, Rayon, SphereGeo, Texture, Vecteur, premiere_intersection};
///
/// let boule = |z, texture| SphereGeo::new(Vecteur::new(0.0, 0.0, z), 1.0, Texture(texture));
/// let scene = [boule(-9.0, 0)?.into(), boule(-4.0, 7)?.into()];
///
/// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
/// let touche = premiere_intersection(&scene, &rayon)?;
/// assert_eq!((touche.distance(), touche.normale()), (3.0, Vecteur::new(0.0, 0.0, 1.0)));
/// assert_eq!((touche.indice(), touche.texture()), (1, Texture(7)));
///
/// let ailleurs = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 1.0, 0.0))?;
/// assert_eq!(premiere_intersection(&scene, &ailleurs), Err(NoIntersection));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[doc(alias("cast_ray", "closest_hit", "first_hit", "raycast"))]
#[inline]
pub fn premiere_intersection<R: Nombre>(objets: &[ObjetRay<R>], rayon: &Rayon<R>) -> Reponse<R> {
    exiger_des_rangs(objets.len());
    let mut premier = Premier::<_>::avant(rayon.fin());
    Liste { objets, choix: None }.interroger(rayon, &mut premier);
    premier.conclure(rayon, objets)
}
