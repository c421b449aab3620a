//! Rays of light (handout §4.1 and annex A): a source, a unit direction and an end.

pub(crate) mod flou;
pub(crate) mod intersection;
pub(crate) mod lumiere;
pub(crate) mod secondaire;

use crate::algebre::arrondis::DEJA_UNITAIRE;
use crate::algebre::nombre::{fois_u, simple};
use crate::algebre::refus::{self, exiger, fini, position, refus_nul, unitaire};
use crate::rayon::flou::Flou;
use crate::{ErreurGeo, Nombre, Vecteur};

/// A ray: the points R(t) = S + t·D, 0 ≤ t < [`fin`](Self::fin), from the source S along D, a
/// vector that is unit to 7.6u (handout, annex A).
///
/// [`new`](Self::new) makes a ray without an end. A ray with an end touches only what it enters
/// before that distance, whatever the question. [`jusqu_a`](Self::jusqu_a) sets the end,
/// [`entre`](Self::entre) goes from one point to another, and
/// [`vers_lumiere`](crate::Intersection::vers_lumiere) ends at a lamp.
///
/// **δ** bounds the error of the source: it is 0 for a ray from `new`, and above 0 for one from a
/// hit. A ray with a δ touches *at once*, at distance 0, an object in which it starts less than
/// about δ deep, if it goes further in; so it does not slip through a seam between two solids. A
/// ray that is [inside](Self::dedans) something touches nothing at once. [`flou`](Self::flou) has
/// the details.
///
/// **A ray has no least distance.** For a near plane start at its [`point`](Self::point), or skip
/// nearer entries in [`visiter`](crate::Monde::visiter): either way the ray sees what stands behind
/// a thing that is too near. For a sensor with a least range ask the whole ray, and discard a hit
/// that is nearer.
///
/// ```
/// use lancer_rayon::{Rayon, Vecteur};
///
/// let rayon = Rayon::new(Vecteur::new(0.0, 1.0, 0.0), Vecteur::new(0.0, 0.0, -8.0))?;
/// assert_eq!(rayon.direction(), Vecteur::new(0.0, 0.0, -1.0));
/// assert_eq!(rayon.point(3.0), Vecteur::new(0.0, 1.0, -3.0));
/// assert_eq!((rayon.fin(), rayon.jusqu_a(9.0)?.fin()), (f64::INFINITY, 9.0));
/// # Ok::<(), lancer_rayon::ErreurGeo>(())
/// ```
#[doc(alias = "ray")]
#[derive(Debug, Clone, Copy)]
#[must_use]
pub struct Rayon<R = f64> {
    source: Vecteur<R>,
    direction: Vecteur<R>,
    fin: R,
    pub(crate) flou: Flou<R>,
}

impl<R: Nombre> PartialEq for Rayon<R> {
    /// Whether both have the same numbers, and start both inside something or both outside.
    #[inline]
    fn eq(&self, autre: &Self) -> bool {
        (self.source, self.direction, self.fin, self.flou)
            == (autre.source, autre.direction, autre.fin, autre.flou)
    }
}

impl<R: Nombre> Rayon<R> {
    /// The ray from `source` in this direction, which may have any length: it is made unit. A
    /// direction that is already unit to rounding is kept bit for bit.
    ///
    /// # Errors
    /// If a coordinate of the source is beyond ±2⁴⁵⁰ (`f64`) or ±2⁶⁰ (`f32`), or if the direction
    /// is zero or not finite.
    #[inline]
    pub fn new(source: Vecteur<R>, direction: Vecteur<R>) -> Result<Self, ErreurGeo> {
        let source = position(["source.x", "source.y", "source.z"], source)?;
        Ok(Self::sans_fin(source, direction_unitaire(DIRECTION, direction)?))
    }

    /// The ray from one point to another, which ends there: a line of sight between two points in
    /// the air, or a step of a particle. From a point of a surface use
    /// [`vers_lumiere`](crate::Intersection::vers_lumiere) or
    /// [`vers_touche`](crate::Intersection::vers_touche), which start beside the surface.
    ///
    /// The direction and the end are those of `arrivee − depart` as computed, so that the ray may
    /// end before `arrivee`, after it or beside it, by at most 8.2u of the distance and
    /// [`ETA`](Nombre::ETA) (lemma 11). It has no end if the distance is too large
    /// for the type. A line that grazes an object may be answered differently from its other end.
    ///
    /// # Errors
    /// If a coordinate of `depart` is beyond the limits of [`new`](Self::new), if one of `arrivee`
    /// is not finite, or if both are the same point.
    ///
    /// ```
    /// use lancer_rayon::{Rayon, Vecteur};
    ///
    /// let [p, q] = [Vecteur::new(1.0, 0.0, 0.0), Vecteur::new(1.0, 3.0, 4.0)];
    /// let rayon = Rayon::entre(p, q)?;
    /// assert_eq!((rayon.source(), rayon.fin()), (p, 5.0));
    /// assert_eq!(Rayon::entre(p, p).unwrap_err().champ, "arrivee - depart");
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("between", "segment", "line_of_sight"))]
    #[inline]
    pub fn entre(depart: Vecteur<R>, arrivee: Vecteur<R>) -> Result<Self, ErreurGeo> {
        let depart = position(["depart.x", "depart.y", "depart.z"], depart)?;
        let arrivee = fini(["arrivee.x", "arrivee.y", "arrivee.z"], arrivee)?;
        let trajet = (arrivee - depart).longueur_et_unitaire();
        let (fin, direction) = trajet.ok_or_else(|| refus_nul("arrivee - depart"))?;
        Ok(Self { fin, ..Self::sans_fin(depart, direction) })
    }

    /// The same ray with this end: it touches what it enters at a distance t < `fin`, but nothing
    /// at `fin` itself. A ray that ends at 0 touches nothing.
    ///
    /// # Errors
    /// If `fin` is below 0 or a NaN. +∞ is a ray without an end.
    ///
    /// ```
    /// use lancer_rayon::{NoIntersection, Rayon, SphereGeo, Texture, Vecteur, premiere_intersection};
    ///
    /// let boule = SphereGeo::new(Vecteur::new(0.0, 0.0, -4.0), 1.0, Texture(0))?;
    /// let scene = [boule.into()];
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
    /// assert_eq!(premiere_intersection(&scene, &rayon.jusqu_a(3.0)?), Err(NoIntersection));
    /// assert_eq!(premiere_intersection(&scene, &rayon.jusqu_a(3.5)?)?.distance(), 3.0);
    /// assert_eq!(rayon.jusqu_a(f64::NAN).unwrap_err().champ, "fin");
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("max_distance", "t_max", "tmax", "tfar", "range", "until"))]
    #[inline]
    pub fn jusqu_a(mut self, fin: R) -> Result<Self, ErreurGeo> {
        self.fin = exiger(fin >= R::ZERO, "fin", fin, "0 or more, +∞ for a ray without an end")?;
        Ok(self)
    }

    /// The same ray with this [δ](Self): for a source that is known to lie on a surface, or in a
    /// seam of several, only to rounding, as of a particle that is born on a wall.
    ///
    /// Without δ a ray that starts just inside an object does not see it. A ray that [starts from a
    /// hit](crate::Intersection::secondaire) has a δ already, as does one from [a place of your
    /// own](crate::ObjetRay::sortie). A point C + l·N as computed, the middle of a face, lies
    /// within 14u(|C| + l) of the face (lemma 1). A δ much larger than the error does harm: a ray
    /// that starts in a box no thicker than 2δ may not touch it.
    ///
    /// # Errors
    /// If `flou` is not finite or below 0.
    ///
    /// ```
    /// use lancer_rayon::{NoIntersection, ObjetRay, PlanGeo, Rayon, Texture, Vecteur};
    ///
    /// let sol = ObjetRay::from(PlanGeo::par_un_point(Vecteur::NUL, Vecteur::Y, Texture(0))?);
    /// // On the floor as somebody else computed it.
    /// let rayon = Rayon::new(Vecteur::new(4.0, -1e-12, 0.0), Vecteur::new(0.0, -1.0, 0.0))?;
    /// assert_eq!(sol.intersection(&rayon), Err(NoIntersection));
    /// assert_eq!(sol.intersection(&rayon.avec_flou(1e-9)?)?.distance(), 0.0);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("tolerance", "on_surface", "blur"))]
    #[inline]
    pub fn avec_flou(self, flou: R) -> Result<Self, ErreurGeo> {
        Ok(self.sachant(self.flou.avec(flou)?))
    }

    /// The same ray, known to start inside something such as glass, water or mist: it keeps its
    /// [δ](Self), but touches nothing at once. It is idempotent.
    ///
    /// Where mist stands flush on a floor, a ray that bounces off the floor would otherwise touch
    /// the mist where it starts. Rays that `secondaire`, `reflechi` and `refracte` send inward are
    /// inside, those that they send outward are not, and a turn in mid-air changes nothing.
    ///
    /// **A ray inside may pass through a seam**, since it touches nothing at once. What a ray is in
    /// for long, leave out of its questions by [`sans`](crate::Monde::sans) or
    /// [`parmi`](crate::Monde::parmi), and let the ray be outside: then it touches all the rest as
    /// a ray in the air does, and leaves no closed room.
    ///
    /// ```
    /// use lancer_rayon::{Monde, PlanGeo, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let haut = Vecteur::new(0.0, 1.0, 0.0);
    /// let sol = PlanGeo::par_un_point(Vecteur::NUL, haut, Texture(0))?;
    /// let brume = SphereGeo::new(Vecteur::NUL, 9.0, Texture(1))?;
    /// let objets = [sol.into(), brume.into()];
    /// let monde = Monde::de_liste(&objets);
    ///
    /// // From the edge of the mist, as somebody else computed it.
    /// let bord = Rayon::new(Vecteur::new(0.0, 9.0 - 1e-12, 0.0), -haut)?.avec_flou(1e-9)?;
    /// assert_eq!(monde.premiere_intersection(&bord)?.indice(), 1);
    /// assert_eq!(monde.premiere_intersection(&bord.dedans())?.indice(), 0);
    /// assert_eq!(monde.sans(1).premiere_intersection(&bord)?.indice(), 0);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("inside", "medium", "fog"))]
    #[inline]
    pub fn dedans(self) -> Self {
        self.sachant(self.flou.dedans())
    }

    /// The same ray, known to start in the air: it undoes [`dedans`](Self::dedans). It is
    /// idempotent.
    ///
    /// Beside an edge a ray that was sent into glass may have stepped out again: if
    /// [`sortie`](crate::ObjetRay::sortie) finds no way out of a sphere or a box, go on with this
    /// ray. Of a half-space that says nothing, since a ray that goes down in a sea never leaves it.
    #[doc(alias("outside", "air"))]
    #[inline]
    pub fn dehors(self) -> Self {
        self.sachant(self.flou.dehors())
    }

    /// The ray without an end from a source and in a direction that were checked before, with δ =
    /// 0.
    #[inline(always)]
    pub(crate) fn sans_fin(source: Vecteur<R>, direction: Vecteur<R>) -> Self {
        Self { source, direction, fin: R::INFINI, flou: Flou::NUL }
    }

    /// The ray of these numbers, which were those of a ray before, with this δ.
    #[inline(always)]
    pub(crate) fn en_nombres(source: Vecteur<R>, direction: Vecteur<R>, fin: R, delta: R) -> Self {
        Self { source, direction, fin, flou: Flou::de(delta) }
    }

    /// The same ray that knows this of its source.
    #[inline(always)]
    pub(crate) fn sachant(mut self, flou: Flou<R>) -> Self {
        self.flou = flou;
        self
    }

    /// S, where the ray starts.
    #[doc(alias = "origin")]
    #[inline(always)]
    pub fn source(&self) -> Vecteur<R> {
        self.source
    }

    /// D, which is unit to 7.6u.
    #[inline(always)]
    pub fn direction(&self) -> Vecteur<R> {
        self.direction
    }

    /// The distance before which the ray touches objects, 0 or more; +∞ if it has no end.
    #[doc(alias("max_distance", "t_max", "tmax", "tfar", "end"))]
    #[inline(always)]
    #[must_use]
    pub fn fin(&self) -> R {
        self.fin
    }

    /// [δ](Self), how exactly the ray knows its source, in scene units. If the source lies in an
    /// object less deep than δ + o and the ray goes further in, it touches the object at once. The
    /// rounding o of the object is 44u of the radius of a sphere or of the sum of the half-lengths
    /// of a box, and 0 for a half-space. Nothing is touched at once where δ is 0, or by a ray that
    /// is [inside](Self::dedans) something.
    ///
    /// - A source exactly δ + o deep, as computed, is too deep.
    /// - A sphere may be touched at once from up to twice as deep.
    /// - A thin box may not be touched, nor a box beside an edge (`docs/precision.md`, "Closed
    ///   rooms").
    ///
    /// **Closed rooms.** No chain of outward rays from hits, and of turns in mid-air, that starts
    /// where no object [contains](crate::Monde::contient) the source leaves a closed room whose
    /// walls are thicker than 2(δ + o) and reach as far into each other, with the δ of the ray that
    /// would start at the next hit. In `f32` a wall of 10 m has an o of 0.03 mm. Not proved is one
    /// case: a crack between a half-space and an object that only meets it and is, in `f32`, half a
    /// million times as large as the ray is long (`docs/precision.md`).
    ///
    /// δ is 0 for a ray from [`new`](Self::new), which takes its source as it stands. It is finite,
    /// and grows with each bounce and each turn in mid-air (`docs/precision.md`, "Closed rooms").
    #[doc(alias("tolerance", "blur"))]
    #[inline(always)]
    #[must_use]
    pub fn flou(&self) -> R {
        self.flou.delta()
    }

    /// R(t) = S + t·D, the point at this distance from the source, in scene units. At +∞ a
    /// coordinate may be NaN.
    #[doc(alias = "at")]
    #[inline(always)]
    pub fn point(&self, distance: R) -> Vecteur<R> {
        self.source + self.direction * distance // M1: P = S + tD
    }

    /// The same ray in `f32`, seen from an origin that is subtracted before anything is rounded:
    /// the ray for objects that [`ObjetGeo::vers_f32`](crate::ObjetGeo::vers_f32) gave with this
    /// origin. Its end is rounded as well.
    ///
    /// A δ above 0 grows by 8.1u·(|x| + |y| + |z|) of the source in the first type and in `f32`, for
    /// what the source and the surfaces beside it are rounded by. That a ray from a hit thus stays
    /// in a closed room that is converted with it is tested, and not promised. A ray from
    /// [`new`](Self::new) may start inside a wall that it stood against:
    /// [`contient`](crate::ObjetRay::contient) tells.
    ///
    /// # Errors
    /// If `origine` is not finite, or the source in `f32` is outside the limits of
    /// [`new`](Self::new).
    ///
    /// ```
    /// use lancer_rayon::{Rayon, Vecteur};
    ///
    /// let arpenteur = Vecteur::new(500001.005, 150.0, 4200000.0115);
    /// let rayon = Rayon::new(arpenteur, Vecteur::new(0.0, -1.0, 0.0))?;
    /// let rayon = rayon.vers_f32(Vecteur::new(500000.0, 0.0, 4200000.0))?;
    /// assert_eq!(rayon.source(), Vecteur::new(1.005_f32, 150.0, 0.0115));
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("to_f32", "narrow", "floating_origin"))]
    #[inline]
    pub fn vers_f32(self, origine: Vecteur<R>) -> Result<Rayon<f32>, ErreurGeo> {
        let origine = refus::origine(origine)?;
        let rayon = Rayon::new((self.source - origine).vers_f32(), self.direction.vers_f32())?;
        let flou = self.flou.vers_f32(self.source, rayon.source);
        Ok(Rayon { fin: simple(self.fin), flou, ..rayon })
    }

    /// The same ray in `f64`, exactly, by which
    /// [`ObjetRay::temoin_f64`](crate::ObjetRay::temoin_f64) tells what an answer in `f32` would be
    /// in `f64`. It serves for nothing else.
    ///
    /// The direction is not made unit again: that of an `f32` ray is unit only to the rounding of
    /// `f32`, and distances are in units of its length, in both types alike. Batches and trees
    /// answer this ray as a list does. Margins, rays from its hits and closed rooms are not promised.
    ///
    /// ```
    /// use lancer_rayon::{Rayon, Vecteur};
    ///
    /// let rayon = Rayon::<f32>::new(Vecteur::NUL, Vecteur::new(1.0, 2.0, 3.0))?;
    /// assert_eq!(rayon.temoin_f64().direction(), rayon.direction().vers_f64());
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("to_f64", "widen", "witness"))]
    pub fn temoin_f64(&self) -> Rayon {
        let (source, direction) = (self.source.vers_f64(), self.direction.vers_f64());
        Rayon { source, direction, fin: self.fin.vers_f64(), flou: self.flou.vers_f64() }
    }
}

/// The names of a direction and of its coordinates.
pub(crate) const DIRECTION: [&str; 4] = ["direction", "direction.x", "direction.y", "direction.z"];

/// This direction brought to length 1; refused by one of these names if it is zero or not finite.
#[inline]
pub(crate) fn direction_unitaire<R: Nombre>(
    champs: [&'static str; 4],
    direction: Vecteur<R>,
) -> Result<Vecteur<R>, ErreurGeo> {
    if (direction.longueur_carree() - R::UN).absolu() <= fois_u(DEJA_UNITAIRE) {
        return Ok(direction);
    }
    unitaire(champs, direction)
}
