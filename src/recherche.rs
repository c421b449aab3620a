//! The questions to a list of objects (handout §4.1), of one ray and of many.

use core::slice;

use crate::forme::Forme;
use crate::hierarchie::Hierarchie;
use crate::intersection::{Intersection, NoIntersection, Rang, Touche};
use crate::liste::Liste;
use crate::lot::LongueursDifferentes;
use crate::objet::{ObjetRay, par_forme};
use crate::rayon::Rayon;
use crate::reel::{Reel, max};
use crate::retenus::{Premier, demander};

/// The first object that the ray enters: its distance, its normal there, its texture and its index
/// in the list (handout §4.1).
///
/// A hit is an entry. An object that contains the source, or whose surface does, is not touched
/// (handout §2.3); the others still count. Of two objects at the same distance the earlier in the
/// list is the first. All of this holds for distances as computed in R: within the bounds of
/// `docs/precision.md` the exact answer may be another.
///
/// # Errors
/// [`NoIntersection`] if the ray enters no object.
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
/// assert_eq!((touche.objet(), touche.texture()), (1, Texture(7)));
///
/// let ailleurs = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 1.0, 0.0))?;
/// assert_eq!(premiere_intersection(&scene, &ailleurs), Err(NoIntersection));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[doc(alias("cast_ray", "closest_hit", "first_hit", "raycast"))]
#[inline]
pub fn premiere_intersection<R: Reel>(objets: &[ObjetRay<R>], rayon: &Rayon<R>) -> Touche<R> {
    let mut premier = Premier::avant(R::INFINI);
    demander(rayon, &mut premier, Liste::entiere(objets), 0..objets.len());
    premier.touche(objets, rayon)
}

impl<R: Reel> ObjetRay<R> {
    /// Where the ray enters this object (handout, annex A): [`premiere_intersection`] with this
    /// object alone.
    ///
    /// # Errors
    /// [`NoIntersection`] if the ray passes the object by, is tangent to it, or starts inside it or
    /// on its surface.
    #[doc(alias("intersect", "hit"))]
    pub fn intersection(&self, rayon: &Rayon<R>) -> Touche<R> {
        premiere_intersection(slice::from_ref(self), rayon)
    }

    /// Where the ray leaves this object: from inside, or after it entered.
    ///
    /// `distance` is that from the source of the ray, in scene units, and `normale` points outward: now
    /// along the ray, D·N > 0. `marge` and [`Rayon::secondaire`] are those of any hit, with this very ray:
    /// glass goes on from there outward, by Snell's law, or inward, mirrored. The way out is as exact as a
    /// hit (`docs/precision.md`), and [`BoiteRay::lieu`](crate::BoiteRay::lieu) takes it as one.
    /// [`reflechi`](Rayon::reflechi) and [`erreur`](Self::erreur) are for entries alone.
    ///
    /// **Each crossing is found once.** A ray that enters a sphere or a box leaves it, and never before it
    /// enters; from inside it always leaves. A half-space that it enters it never leaves. From a source
    /// on the surface a ray leaves at the far side, or not at all: the source itself is no way out, as it is
    /// no hit. Inside and on the surface is what the search computes so: within rounding of a sphere a ray
    /// may leave at once. A ray that `secondaire` sent inward leaves, except beside an edge of a box, and
    /// one that it sent outward does not.
    ///
    /// # Errors
    /// [`NoIntersection`] if the ray passes the object by or starts beyond it; if it descends in a
    /// half-space, or keeps its depth; or if the distance is too large for the type.
    ///
    /// ```
    /// use lancer_rayon::{NoIntersection, ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = SphereGeo::new(Vecteur::new(0.0, 0.0, -5.0), 1.0, Texture(0))?;
    /// let boule: ObjetRay = boule.into();
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
    /// let [entree, sortie] = [boule.intersection(&rayon)?, boule.sortie(&rayon)?];
    /// assert_eq!([entree.distance(), sortie.distance()], [4.0, 6.0]);
    /// assert_eq!(sortie.normale(), Vecteur::new(0.0, 0.0, -1.0));
    ///
    /// // Straight through: in, and out again.
    /// let dedans = rayon.secondaire(&entree, rayon.direction())?;
    /// let sortie = boule.sortie(&dedans)?;
    /// assert!((sortie.distance() - 2.0).abs() < 1e-13);
    /// let dehors = dedans.secondaire(&sortie, dedans.direction())?;
    /// assert_eq!(boule.intersection(&dehors), Err(NoIntersection));
    /// assert_eq!(boule.sortie(&dehors), Err(NoIntersection));
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("exit", "far_side", "leave"))]
    pub fn sortie(&self, rayon: &Rayon<R>) -> Touche<R> {
        // Turned back, the ray enters the object, at −t, where this one leaves it.
        let retour = Rayon::sans_verifier(rayon.source(), -rayon.direction());
        par_forme!(Self, self, forme => {
            let (entree, sortie) = (forme.t(rayon), forme.t_sortie(rayon));
            let t = if entree < R::INFINI { max(entree, sortie) } else { sortie }; // W5
            if t == R::INFINI {
                return Err(NoIntersection);
            }
            let contact = forme.conclure(&retour, -t); // W6
            Ok(Intersection::new(t, contact, forme.texture(), Rang::de(0)))
        })
    }
}

/// Tells whether anything blocks the way of the ray before `distance_max`, the distance of a light:
/// the shadow of the handout's later parts.
///
/// It is `objets.iter().any(|o| o.intersection(rayon).is_ok_and(|i| i.distance() < distance_max))`,
/// to the bit, and ends with the first such object. +∞ asks whether the ray touches anything at
/// all; nothing is before a NaN.
///
/// **A lamp that is an object of the list** hides the points of its own surface: no distance is
/// exact enough to stop just before it. [Leave it out](Hierarchie::sans); of a plain list
/// [`Hierarchie::de_liste`] takes such a choice.
///
/// **From inside an object** that object is not seen, as by any ray: a point under a thing that
/// stands on the floor is not in its shadow. [`contient`](ObjetRay::contient) tells such points.
///
/// [`vers_lumiere`](Rayon::vers_lumiere) gives the ray and the distance; between two points in the
/// air they are `Rayon::new(p, q - p)` and `(q - p).longueur()`, with P the one nearer to a surface. With a
/// [`secondaire`](Rayon::secondaire) of one's own, measure from its source, and test N·L > 0 first:
/// towards a lamp behind the surface the ray starts inside the object, which then casts no shadow.
///
/// ```
/// use lancer_rayon::{Rayon, SphereGeo, Texture, Vecteur, est_occulte, premiere_intersection};
///
/// let boule = |y, r, texture| SphereGeo::new(Vecteur::new(0.0, y, -5.0), r, Texture(texture));
/// let scene = [boule(0.0, 1.0, 0)?.into(), boule(4.0, 0.5, 1)?.into()];
/// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.6, -5.0))?;
/// let touche = premiere_intersection(&scene, &rayon)?;
/// let eclaire = |lampe| {
///     let vers = rayon.vers_lumiere(&touche, lampe);
///     vers.is_some_and(|(ombre, distance)| !est_occulte(&scene, &ombre, distance))
/// };
/// assert!(eclaire(Vecteur::new(0.0, 3.0, -2.0)));
/// assert!(!eclaire(Vecteur::new(0.0, 9.0, -5.2))); // behind the small ball
/// assert!(!eclaire(Vecteur::new(0.0, 0.0, -9.0))); // behind the surface
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[doc(alias("any_hit", "occluded", "shadow"))]
#[inline]
#[must_use]
pub fn est_occulte<R: Reel>(objets: &[ObjetRay<R>], rayon: &Rayon<R>, distance_max: R) -> bool {
    let mut premier = Premier::avant(distance_max);
    demander(&(*rayon, distance_max), &mut premier, Liste::entiere(objets), 0..objets.len())
}

/// The first object that each ray enters:
/// [`premiere_intersection`] of every ray, to the bit, and several
/// times as fast for the rays of a picture.
///
/// Every object is asked, of sixteen rays side by side: neighbours in `rayons` should be neighbours in the
/// picture, since an object that sixteen rays in a row all pass by costs little. Pass 64 rays or more a call;
/// from ten spheres and boxes on, use a [`Hierarchie`]. Nothing is allocated and no
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
    Hierarchie::de_liste(objets).premieres_intersections(rayons, touches)
}

/// Whether anything stands before the lamp of each shadow ray: [`est_occulte`] of
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
    Hierarchie::de_liste(objets).sont_occultes(ombres, occultes)
}

/// Whether an answer of [`premiere_intersection`] of this list, a hit or a miss, is certain: whether exact
/// arithmetic on the numbers as they are stored names the same object first, or none as well. (Which
/// face of a box, at an edge, is not asked.)
///
/// It is never true of a wrong answer. It is false of a right one only where
/// [`est_certain`](ObjetRay::est_certain) of some object would be, where no distance is promised, and of two
/// entries nearer to each other than some 2⁻⁵⁰(κ + κ′)·t, twice what both distances are promised to in `f64`
/// (`docs/precision.md`; κ is large where a ray grazes). Most often that is an exact tie, as where the sides
/// of two boxes are flush. Of `reponse` only
/// [`objet`](Intersection::objet) counts, whoever found it. The time is that of a ray or two;
/// [`Hierarchie::est_certaine`] asks a tree.
///
/// In an answer that is not certain ask the same numbers in `f64`: [`ObjetRay::vers_f64`] of all
/// objects, and [`Rayon::vers_f64`]. What is uncertain there as well is most often a tie.
///
/// ```
/// use lancer_rayon::{ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
/// use lancer_rayon::{est_certaine, premiere_intersection};
///
/// let boule = |z| SphereGeo::<f32>::new(Vecteur::new(0.0, 0.0, z), 1.0, Texture(0));
/// let scene: [ObjetRay<f32>; 2] = [boule(-5.0)?.into(), boule(-5.000001)?.into()];
/// let vers_le_fond = |x| Rayon::new(Vecteur::new(x, 0.0, 0.0), Vecteur::new(0.0, 0.0, -1.0));
/// let certaine = |rayon| est_certaine(&scene, &rayon, &premiere_intersection(&scene, &rayon));
/// assert!(certaine(vers_le_fond(0.3)?)); // the nearer one
/// assert!(certaine(vers_le_fond(1.5)?)); // a miss
///
/// let deux_fois = [scene[0]; 2];
/// let rayon = vers_le_fond(0.3)?;
/// let touche = premiere_intersection(&deux_fois, &rayon);
/// assert!(!est_certaine(&deux_fois, &rayon, &touche)); // a tie
/// # Ok::<(), lancer_rayon::ErreurGeo>(())
/// ```
#[doc(alias("is_certain", "certify", "certificate"))]
#[must_use]
pub fn est_certaine<R: Reel>(
    objets: &[ObjetRay<R>],
    rayon: &Rayon<R>,
    reponse: &Touche<R>,
) -> bool {
    Hierarchie::de_liste(objets).est_certaine(rayon, reponse)
}
