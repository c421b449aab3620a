//! The questions of one ray to a list of objects (handout §4.1).

use core::slice;

use crate::double::{Double, Jugement, scalaire, triple};
use crate::intersection::{Intersection, NoIntersection, Rang, Touche};
use crate::objet::{ObjetRay, par_forme};
use crate::rayon::Rayon;
use crate::reel::{Reel, fois_u};

/// The bound of [`ObjetRay::erreur`] grows by so many u of itself for its last operations (lemma
/// 19).
pub const ERREUR_ARRONDIE: f64 = 17.2;

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
    premiere_sauf(objets, None, rayon)
}

/// The same without the object at this index.
#[inline(always)]
pub(crate) fn premiere_sauf<R: Reel>(
    objets: &[ObjetRay<R>],
    sauf: Option<usize>,
    rayon: &Rayon<R>,
) -> Touche<R> {
    // A copy, which stays in registers.
    let copie = *rayon;
    // An index and not a rank: a list may be longer than there are ranks.
    let mut premier = objets.len();
    let mut t_premier = R::INFINI;
    for (indice, objet) in objets.iter().enumerate() {
        if sauf == Some(indice) {
            continue;
        }
        let t = objet.t_si_proche(&copie);
        if t < t_premier {
            (premier, t_premier) = (indice, t);
        }
    }
    let objet = objets.get(premier).ok_or(NoIntersection)?;
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

    /// A bound on the error of [`touche.distance()`](Intersection::distance), in scene units: the
    /// ray enters this object no farther than that from there, for the numbers as they are stored.
    ///
    /// It is proven (`docs/preuves.md`, lemma 19), at the edges of a box too and with the rounding
    /// of its own computation. It is +∞ where the ray does not enter the object, and where numbers
    /// of twice the length of an `f64` cannot tell; it is never a NaN. It rests on t alone, not on
    /// how t was found: it is the error itself, as found with such numbers, what D lacks to length 1
    /// over that distance, and u·t. In the median of ordinary hits it is 2 to 3 times the error. Ask
    /// it of the object that was hit, with the ray of the hit. It takes many times as long as the
    /// hit; whoever does not ask pays nothing.
    ///
    /// The same bound holds of t in lengths of D: no less than |t − t′|, where the ray enters at S +
    /// t′D. After [`Rayon::vers_f64`] D is unit to the rounding of `f32` only, and so is the bound:
    /// multiply the distance by `rayon.direction().longueur()` there.
    ///
    /// ```
    /// use lancer_rayon::{ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = SphereGeo::<f32>::new(Vecteur::new(0.0, 0.0, -5.0), 1.0, Texture(0))?;
    /// let boule = ObjetRay::from(boule);
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.1, 0.05, -1.0))?;
    /// let touche = boule.intersection(&rayon)?;
    ///
    /// let erreur = boule.erreur(&rayon, &touche);
    /// let exacte = boule.vers_f64().intersection(&rayon.vers_f64())?.distance();
    /// assert!((f64::from(touche.distance()) - exacte).abs() <= erreur.into());
    /// assert!(erreur < 2e-6);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("error_bound", "distance_error"))]
    #[must_use]
    pub fn erreur(&self, rayon: &Rayon<R>, touche: &Intersection<R>) -> R {
        let t = touche.distance();
        let Jugement { entre, ecart } = self.juger(rayon, t);
        // t counts in lengths of D.
        let d = rayon.vers_f64().direction();
        let [bas, haut] = scalaire(triple(d), triple(d)).plus(Double::de(-1.0)).bornes();
        let longueur = d.longueur();
        let de_d = t.vers_f64() * (haut.max(-bas) / (1.0 + longueur));
        let erreur = R::depuis_f64(ecart * Reel::max(longueur, 1.0) + de_d) + t * R::U;
        let erreur = erreur + erreur * fois_u(ERREUR_ARRONDIE) + R::MIN_POSITIF;
        if entre == Some(true) && erreur < R::INFINI { erreur } else { R::INFINI }
    }

    /// Whether the answer of [`intersection`](Self::intersection), a hit or a miss, is certain: that
    /// of exact arithmetic on the numbers as they are stored.
    ///
    /// It is never true of a wrong answer. It is false of a right one only within some 2⁻¹⁰⁰ of the
    /// decision, for spheres 2⁻⁵⁰ times as large as their distance or smaller, where products leave
    /// the normal numbers of `f64`, and of a hit whose distance the type can hardly hold. **Of a list
    /// the first object is certain** if each object is certain, and if no other that is touched comes
    /// within both bounds, [`erreur`](Self::erreur), of the first (recipe in `docs/README.md`).
    ///
    /// ```
    /// use lancer_rayon::{ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = ObjetRay::from(SphereGeo::new(Vecteur::new(0.0, 0.0, -5.0), 1.0, Texture(0))?);
    /// let vers_le_fond = |x| Rayon::new(Vecteur::new(x, 0.0, 0.0), Vecteur::new(0.0, 0.0, -1.0));
    /// assert!(boule.est_sur(&vers_le_fond(0.5)?)); // a hit
    /// assert!(boule.est_sur(&vers_le_fond(1.5)?)); // a miss
    /// assert!(boule.est_sur(&vers_le_fond(1.0)?)); // a tangent, exactly
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("is_certain", "is_robust"))]
    #[must_use]
    pub fn est_sur(&self, rayon: &Rayon<R>) -> bool {
        // No ray that enters an object passes the ball around it by (lemma 11).
        if !self.boule().approchee(rayon) {
            return true;
        }
        let t = self.t(rayon);
        let Jugement { entre, ecart } = self.juger(rayon, t);
        // Nor is an entry beyond the largest number a hit (C7): twice the bound, for its rounding.
        let au_plus = R::depuis_f64(t.vers_f64() + 2.0 * ecart);
        entre == Some(t < R::INFINI) && (t == R::INFINI || au_plus < R::INFINI)
    }

    /// What exact numbers say of this ray and this distance.
    fn juger(&self, rayon: &Rayon<R>, t: R) -> Jugement {
        par_forme!(Self, self, forme => forme.vers_f64().juger(&rayon.vers_f64(), t.vers_f64()))
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
/// exact enough to stop just before it. Ask which object is first instead: the point sees the lamp
/// if `premiere_intersection(objets, rayon)` is it, by [`objet`](crate::Intersection::objet).
///
/// [`vers_lumiere`](Rayon::vers_lumiere) gives the ray and the distance. With a
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
    occulte_sauf(objets, None, rayon, distance_max)
}

/// The same without the object at this index.
#[inline(always)]
pub(crate) fn occulte_sauf<R: Reel>(
    objets: &[ObjetRay<R>],
    sauf: Option<usize>,
    rayon: &Rayon<R>,
    distance_max: R,
) -> bool {
    let copie = *rayon;
    // Not `any`, which the compiler left out of line: 4 to 8 ns a ray (measured).
    for (indice, objet) in objets.iter().enumerate() {
        if sauf == Some(indice) {
            continue;
        }
        let t = objet.t_si_proche(&copie);
        // The first comparison decides nothing; without it this takes 5 % longer (measured).
        if t < R::INFINI && t < distance_max {
            return true;
        }
    }
    false
}
