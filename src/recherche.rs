//! The questions of one ray to a list of objects (handout §4.1).

use core::slice;

use crate::forme::Forme;
use crate::intersection::{Intersection, NoIntersection, Rang, Touche};
use crate::liste::Liste;
use crate::objet::{ObjetRay, par_forme};
use crate::rayon::Rayon;
use crate::reel::{Reel, max};

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
    premiere_de(Liste::entiere(objets), rayon, R::INFINI)
}

/// The same of a choice of objects, before this distance.
#[inline(always)]
pub(crate) fn premiere_de<R: Reel>(
    liste: Liste<'_, R>,
    rayon: &Rayon<R>,
    distance_max: R,
) -> Touche<R> {
    // A copy, which stays in registers.
    let copie = *rayon;
    // An index and not a rank: a list may be longer than there are ranks. In the order of the list none of an
    // equal distance takes the place of an earlier one.
    let mut premier = liste.objets.len();
    let mut t_premier = distance_max;
    for (indice, objet) in liste.objets.iter().enumerate() {
        if liste.sauf() == Some(indice) {
            continue;
        }
        let t = objet.t_si_proche(&copie);
        // A predicate last: before it, a list of six without a choice takes up to 1.07 times as long (measured).
        if t < t_premier && liste.contient(indice) {
            (premier, t_premier) = (indice, t);
        }
    }
    let objet = liste.objets.get(premier).ok_or(NoIntersection)?;
    Ok(objet.conclure(rayon, t_premier, Rang::de(premier)))
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
/// exact enough to stop just before it. [Leave it out](crate::Hierarchie::sans); of a plain list
/// [`Hierarchie::de_liste`](crate::Hierarchie::de_liste) takes such a choice.
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
    occulte_de(Liste::entiere(objets), rayon, distance_max)
}

/// The same of a choice of objects.
#[inline(always)]
pub(crate) fn occulte_de<R: Reel>(liste: Liste<'_, R>, rayon: &Rayon<R>, distance_max: R) -> bool {
    let copie = *rayon;
    // Not `any`, which the compiler left out of line: 4 to 8 ns a ray (measured).
    for (indice, objet) in liste.objets.iter().enumerate() {
        if liste.sauf() == Some(indice) {
            continue;
        }
        let t = objet.t_si_proche(&copie);
        // The first comparison decides nothing; without it this takes 5 % longer (measured).
        if t < R::INFINI && t < distance_max && liste.contient(indice) {
            return true;
        }
    }
    false
}
