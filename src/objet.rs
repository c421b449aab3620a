//! The two enums of the handout's §4.1, and the choice between shapes.
//!
//! What an [`ObjetRay`] can do stands here, and how exact its answers are in
//! `question/jugement.rs`.

pub(crate) mod boite;
pub(crate) mod forme;
pub(crate) mod plan;
pub(crate) mod sphere;

use crate::algebre::arrondis::ETENDUE;
use crate::algebre::nombre::{fois_u, max, min};
use crate::objet::forme::{Boule, Forme};
use crate::rayon::intersection::Rang;
use crate::{
    BoiteGeo, BoiteRay, ErreurGeo, Intersection, NoIntersection, Nombre, PlanGeo, PlanRay, Rayon,
    Reponse, Rotation, SphereGeo, SphereRay, Texture, Vecteur,
};

/// `par_forme!(ObjetRay, objet, forme => expression)` is the expression for the shape in `objet`.
/// All of the crate chooses between shapes in this way, except where it judges
/// (`question/jugement/`) and where a block is priced (`arbre/parcours_de_bloc.rs`).
///
/// Each arm has a type of its own for `forme`, which no closure could have. One match can serve
/// many rays.
macro_rules! par_forme {
    ($enum:ident, $objet:expr, $forme:ident => $expression:expr) => {
        match $objet {
            $enum::Sphere($forme) => $expression,
            $enum::Plan($forme) => $expression,
            $enum::Boite($forme) => $expression,
        }
    };
}
pub(crate) use par_forme;

/// An object as it is described and moved (`Objet_geo` in the handout). Make one of a
/// [`SphereGeo`], a [`PlanGeo`] or a [`BoiteGeo`], move it, and convert it once by
/// [`vers_ray`](Self::vers_ray).
///
/// ```
/// use core::f64::consts::PI;
/// use lancer_rayon::{ObjetGeo, ObjetRay, Rotation, SphereGeo, Texture, Vecteur};
///
/// let boule = ObjetGeo::from(SphereGeo::new(Vecteur::NUL, 1.0, Texture(0))?);
/// let objet = boule.translation(Vecteur::new(0.0, 0.0, -4.0))?.homothetie(2.0)?;
/// let objet = objet.rotation(Rotation::new(Vecteur::new(0.0, PI, 0.0))?)?.vers_ray();
///
/// let ObjetRay::Sphere(boule) = objet else { panic!("a sphere stays one") };
/// assert_eq!((boule.centre(), boule.rayon()), (Vecteur::new(0.0, 0.0, 4.0), 2.0));
/// # Ok::<(), lancer_rayon::ErreurGeo>(())
/// ```
///
/// **The errors of many moves add up**, and those of one turn that is taken again and again all go
/// the same way: in `f32` a centre that is turned 100,000 times by 0.1° comes 0.25 % nearer to O.
/// For each picture of an animation turn the object that was described first, by one rotation that
/// was composed ([`Rotation::puis`]) and so stays orthonormal.
///
/// **The errors of one move**, with u half a unit in the last place of 1 (`docs/preuves/rayons.md`,
/// lemma 11):
///
/// - A translation by v rounds each coordinate of a centre once.
/// - The distance d − N·v of a moved half-space is off by at most u·|d| + 4.1u·Σ|N_i·v_i|.
/// - A turned centre C·M is off by at most 3.1u·Σ|C_i|.
///
/// The last two may be off by 1.6 times the smallest number more, for products below the normal
/// numbers.
#[doc(alias("shape", "Objet_geo"))]
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "R: Nombre + serde::Serialize")))]
#[cfg_attr(feature = "serde", serde(bound(deserialize = "R: Nombre + serde::Deserialize<'de>")))]
#[must_use]
pub enum ObjetGeo<R = f64> {
    /// A ball, by its centre and its radius.
    Sphere(SphereGeo<R>),
    /// A half-space, such as a floor or a wall, by its rotation and its distance.
    #[doc(alias = "plane")]
    Plan(PlanGeo<R>),
    /// A box, by its centre, its dimensions and its rotation.
    #[doc(alias = "box")]
    Boite(BoiteGeo<R>),
}

impl<R: Nombre> ObjetGeo<R> {
    /// The object moved by `v` (handout §2.3).
    ///
    /// # Errors
    /// If the moved object lies outside the limits of its constructor.
    #[doc(alias("translate", "move", "transform"))]
    pub fn translation(self, v: Vecteur<R>) -> Result<Self, ErreurGeo> {
        par_forme!(Self, self, forme => Ok(forme.translation(v)?.into()))
    }

    /// The object turned about the origin O (handout §2.3).
    ///
    /// # Errors
    /// If the turned object lies outside the limits of its constructor.
    #[doc(alias("rotate", "turn", "transform"))]
    pub fn rotation(self, r: Rotation<R>) -> Result<Self, ErreurGeo> {
        par_forme!(Self, self, forme => Ok(forme.rotation(r)?.into()))
    }

    /// The object with its dimensions multiplied by `k`, about its own centre; a half-space has no
    /// dimensions and stays as it is (handout §2.3).
    ///
    /// # Errors
    /// If `k` is not finite and above 0, or a dimension leaves the limits of the constructor.
    #[doc(alias("scale", "transform"))]
    pub fn homothetie(self, k: R) -> Result<Self, ErreurGeo> {
        par_forme!(Self, self, forme => Ok(forme.homothetie(k)?.into()))
    }

    /// The same object in `f32`, moved by −`origine` before anything is rounded to `f32`.
    ///
    /// Far from O an `f32` holds few digits, which no margin and no certificate sees
    /// (`docs/vitesse.md`, "What is lost in storing"). So describe a scene in `f64`, and subtract
    /// an origin in its middle from the objects and from the rays ([`Rayon::vers_f32`]). To return
    /// to the scene, convert the point of a hit by `vers_f64` and add that origin. `Vecteur::NUL`
    /// leaves the scene where it is.
    ///
    /// # Errors
    /// If `origine` is not finite, or if [`translation`](Self::translation) by −`origine` or the
    /// constructor with the numbers in `f32` fails; the error names the field.
    ///
    /// ```
    /// use lancer_rayon::{ObjetGeo, ObjetRay, SphereGeo, Texture, Vecteur};
    ///
    /// let borne = SphereGeo::new(Vecteur::new(500001.005, 150.0, 4200000.0115), 0.01, Texture(0))?;
    /// let borne = ObjetGeo::from(borne);
    /// let centre = |objet: ObjetGeo<f32>| match objet.vers_ray() {
    ///     ObjetRay::Sphere(sphere) => sphere.centre(),
    ///     ObjetRay::Plan(_) | ObjetRay::Boite(_) => panic!("a sphere stays one"),
    /// };
    /// let origine = Vecteur::new(500000.0, 0.0, 4200000.0);
    /// assert_eq!(centre(borne.vers_f32(origine)?), Vecteur::new(1.005, 150.0, 0.0115));
    /// // As it stands, z would be off by more than the radius.
    /// assert_eq!(centre(borne.vers_f32(Vecteur::NUL)?).z, 4200000.0);
    ///
    /// let loin = SphereGeo::new(Vecteur::new(0.0, 1e30, 0.0), 1.0, Texture(0))?;
    /// assert_eq!(ObjetGeo::from(loin).vers_f32(Vecteur::NUL).unwrap_err().champ, "centre.y");
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("to_f32", "narrow", "floating_origin"))]
    pub fn vers_f32(self, origine: Vecteur<R>) -> Result<ObjetGeo<f32>, ErreurGeo> {
        par_forme!(Self, self, forme => Ok(forme.vers(origine)?.into()))
    }

    /// The same object, ready for rays (handout §3).
    #[doc(alias = "into_ray")]
    pub fn vers_ray(self) -> ObjetRay<R> {
        par_forme!(Self, self, forme => forme.vers_ray().into())
    }
}

impl ObjetGeo {
    /// The same object in the scalar R, for code that is generic over it: as it is in `f64`, and as
    /// [`vers_f32`](Self::vers_f32) in `f32`.
    ///
    /// # Errors
    /// As [`vers_f32`](Self::vers_f32).
    ///
    /// ```
    /// use lancer_rayon::{ErreurGeo, ObjetGeo, ObjetRay, Reel, SphereGeo, Texture, Vecteur};
    ///
    /// fn scene<R: Reel>(objets: &[ObjetGeo]) -> Result<Vec<ObjetRay<R>>, ErreurGeo> {
    ///     objets.iter().map(|objet| Ok(objet.vers(Vecteur::NUL)?.vers_ray())).collect()
    /// }
    ///
    /// let boule = ObjetGeo::from(SphereGeo::new(Vecteur::Z, 0.1, Texture(0))?);
    /// assert_eq!(scene::<f64>(&[boule])?, [boule.vers_ray()]);
    /// assert_eq!(scene::<f32>(&[boule])?, [boule.vers_f32(Vecteur::NUL)?.vers_ray()]);
    /// # Ok::<(), ErreurGeo>(())
    /// ```
    #[doc(alias("cast", "convert", "either_scalar"))]
    pub fn vers<R: Nombre>(self, origine: Vecteur) -> Result<ObjetGeo<R>, ErreurGeo> {
        par_forme!(Self, self, forme => Ok(forme.vers(origine)?.into()))
    }
}

/// An object ready for rays (`Objet_ray` in the handout).
///
/// ```
/// use lancer_rayon::{ObjetGeo, Rayon, SphereGeo, Texture, Vecteur};
///
/// let boule = SphereGeo::new(Vecteur::new(0.0, 0.0, -5.0), 1.0, Texture(3))?;
/// let objet = ObjetGeo::from(boule).vers_ray();
/// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
/// let touche = objet.intersection(&rayon)?;
/// assert_eq!((touche.distance(), touche.texture()), (4.0, Texture(3)));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[doc(alias("primitive", "Objet_ray"))]
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub enum ObjetRay<R = f64> {
    /// A [`SphereGeo`], ready for rays.
    Sphere(SphereRay<R>),
    /// A [`PlanGeo`], ready for rays.
    #[doc(alias = "plane")]
    Plan(PlanRay<R>),
    /// A [`BoiteGeo`], ready for rays.
    #[doc(alias = "box")]
    Boite(BoiteRay<R>),
}

// Fifteen numbers, a texture and a tag: all of them pass through the cache for every ray.
const _: () = assert!(size_of::<ObjetRay<f64>>() <= 136);

impl<R: Nombre> ObjetRay<R> {
    /// The distance at which the ray enters this object, +∞ if it does not.
    #[inline(always)]
    pub(crate) fn t(&self, rayon: &Rayon<R>) -> R {
        par_forme!(Self, self, forme => forme.t(rayon))
    }

    /// Whether the ray may enter the object.
    #[inline(always)]
    pub(crate) fn peut_entrer(&self, rayon: &Rayon<R>) -> bool {
        par_forme!(Self, self, forme => forme.peut_entrer(rayon))
    }

    /// [`t_touche`](Self::t_touche), faster for a ray that passes this object by.
    #[inline(always)]
    pub(crate) fn t_si_proche(&self, rayon: &Rayon<R>) -> R {
        par_forme!(Self, self, forme => {
            if forme.peut_entrer(rayon) { forme.t_touche(rayon) } else { R::INFINI }
        })
    }

    /// The distance at which the ray touches this object, 0 if at once.
    #[inline(always)]
    pub(crate) fn t_touche(&self, rayon: &Rayon<R>) -> R {
        par_forme!(Self, self, forme => forme.t_touche(rayon))
    }

    /// The hit that the search found at distance `t`, on this object, which has this rank.
    ///
    /// The rare case is a call that returns a whole answer. Were it to return a contact, the common
    /// case would pass its contact through memory as well, and a single ray would take up to 1.2
    /// times as long (measured).
    #[inline(always)]
    pub(crate) fn touche(&self, rayon: &Rayon<R>, t: R, rang: Rang) -> Reponse<R> {
        par_forme!(Self, self, forme => {
            let (contact, de_face) = forme.contact(rayon, t);
            if de_face {
                let (delta, texture) = (rayon.flou(), forme.texture());
                Ok(Intersection { distance: t, contact, delta, texture, rang })
            } else {
                self.touche_rare(rayon, t, rang)
            }
        })
    }

    #[cold]
    #[inline(never)]
    fn touche_rare(&self, rayon: &Rayon<R>, t: R, rang: Rang) -> Reponse<R> {
        par_forme!(Self, self, forme => {
            let (contact, delta) = (forme.contact_de_toute_sorte(rayon, t), rayon.flou());
            Ok(Intersection { distance: t, contact, delta, texture: forme.texture(), rang })
        })
    }

    /// Where the ray enters this object (handout, annex A): what
    /// [`premiere_intersection`](fn@crate::premiere_intersection) says of a list of this object
    /// alone.
    ///
    /// # Errors
    /// [`NoIntersection`] if the ray ends before the object, passes it by, is tangent to it, or
    /// starts inside it or on its surface.
    #[doc(alias("intersect", "hit"))]
    pub fn intersection(&self, rayon: &Rayon<R>) -> Reponse<R> {
        let t = self.t_si_proche(rayon);
        if t < rayon.fin() { self.touche(rayon, t, Rang::de(0)) } else { Err(NoIntersection) }
    }

    /// Where the ray leaves this object: from inside, or after it entered.
    ///
    /// `distance` is that from the source of the ray, in scene units, and `normale` points outward:
    /// now along the ray, D·N > 0. `marge` and [`secondaire`](Intersection::secondaire) are those
    /// of any hit: light in glass goes on from there outward, by Snell's law, or inward,
    /// [mirrored](Intersection::reflechi). The way out is as exact as a hit (`docs/precision.md`),
    /// and [`BoiteRay::lieu`](crate::BoiteRay::lieu) and [`erreur`](Self::erreur) take it as one.
    ///
    /// **What is a way out:**
    ///
    /// - A ray without an end that enters a sphere or a box leaves it, and never before it enters.
    ///   So does one from strictly inside. A ray that enters a half-space never leaves it.
    /// - From a source on the surface a ray leaves at the far side, or not at all: the source
    ///   itself is no way out, as it is no hit.
    /// - What is inside and what is on the surface is decided as computed. Within rounding of a
    ///   sphere a ray may leave at once.
    /// - A ray that `secondaire` sent into a sphere or a box leaves, except beside an edge and in a
    ///   box no thicker than twice the step. A ray that it sent outward does not.
    ///
    /// **A place of one's own**, such as a sensor, is a way out along the normal (`docs/guide.md`,
    /// "Sensors, and other places of one's own"). Keep it off the edges of its face, as
    /// [`vers_lieu`](crate::BoiteRay::vers_lieu) does: rounding may put a source there outside,
    /// from which there is no way out.
    ///
    /// # Errors
    /// [`NoIntersection`] if the ray ends before it leaves, passes the object by or starts beyond
    /// it; if it descends in a half-space, or keeps its depth; or if the distance is too large for
    /// the type.
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
    /// let dedans = entree.secondaire(rayon.direction())?;
    /// let sortie = boule.sortie(&dedans)?;
    /// assert!((sortie.distance() - 2.0).abs() < 1e-13);
    /// let dehors = sortie.secondaire(dedans.direction())?;
    /// assert_eq!(boule.intersection(&dehors), Err(NoIntersection));
    /// assert_eq!(boule.sortie(&dehors), Err(NoIntersection));
    ///
    /// // A sensor on the side that the sun shines on.
    /// let capteur = boule.sortie(&Rayon::new(Vecteur::new(0.0, 0.0, -5.0), Vecteur::Y)?)?;
    /// assert_eq!(capteur.normale(), Vecteur::Y);
    /// assert!(capteur.vers_soleil(Vecteur::new(1.0, 2.0, 0.0)).is_ok());
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("exit", "far_side", "leave", "sensor", "sample", "anchor"))]
    pub fn sortie(&self, rayon: &Rayon<R>) -> Reponse<R> {
        let (entree, sortie) =
            par_forme!(Self, self, forme => (forme.t(rayon), forme.t_sortie(rayon)));
        // W5: never before the entry.
        let t = if entree < R::INFINI { max(entree, sortie) } else { sortie };
        if t >= rayon.fin() {
            return Err(NoIntersection);
        }
        // W6: turned back, the ray enters the object, at −t, where this one leaves it.
        let retour = Rayon::sans_fin(rayon.source(), -rayon.direction());
        let touche = self.touche(&retour, -t, Rang::de(0))?;
        Ok(Intersection { distance: t, delta: rayon.flou(), ..touche })
    }

    /// The part of the ray that lies in this object (handout, annex A): where it begins and where it
    /// ends, in scene units from the source of the ray.
    ///
    /// It serves chords, such as a dose, an attenuation or mist that a ray goes through, for which
    /// neither normals nor margins are needed.
    ///
    /// - **It begins** where [`intersection`](Self::intersection) says, to the bit, or at 0 if the
    ///   object [contains](Self::contient) the source.
    /// - **It ends** where [`sortie`](Self::sortie) says, to the bit, or at the [end](Rayon::fin) of
    ///   the ray if that comes first. A ray that does not leave a half-space ends there at the end
    ///   of the ray, +∞ for one without an end.
    /// - **On a surface** the source is in the object. From there a ray that goes inward, or along
    ///   the surface of a half-space, is in the object from 0 on; one that goes outward is not in it
    ///   at all, nor, within rounding, is one that grazes a sphere.
    /// - Both distances are the same where the ray only passes through an edge of a box.
    /// - **δ changes nothing**, since what a ray touches at once contains its source.
    ///
    /// # Errors
    /// [`NoIntersection`] if no part of the ray before its end is in the object.
    ///
    /// ```
    /// use lancer_rayon::{NoIntersection, ObjetRay, PlanGeo, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let brume = ObjetRay::from(SphereGeo::new(Vecteur::Z * -5.0, 1.0, Texture(0))?);
    /// let rayon = Rayon::new(Vecteur::NUL, -Vecteur::Z)?;
    /// assert_eq!(brume.traversee(&rayon)?, [4.0, 6.0]);
    /// assert_eq!(brume.traversee(&rayon.jusqu_a(4.5)?)?, [4.0, 4.5]);
    /// assert_eq!(brume.traversee(&rayon.jusqu_a(3.5)?), Err(NoIntersection));
    /// let de_l_interieur = Rayon::new(brume.sortie(&rayon)?.point() + Vecteur::Z, Vecteur::Z)?;
    /// assert_eq!(brume.traversee(&de_l_interieur)?, [0.0, 1.0]);
    ///
    /// let mer = ObjetRay::from(PlanGeo::par_un_point(Vecteur::Y * -2.0, Vecteur::Y, Texture(0))?);
    /// assert_eq!(mer.traversee(&Rayon::new(Vecteur::NUL, -Vecteur::Y)?)?, [2.0, f64::INFINITY]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("chord", "interval", "entry_exit", "thickness", "attenuation", "fog"))]
    pub fn traversee(&self, rayon: &Rayon<R>) -> Result<[R; 2], NoIntersection> {
        let (entree, sortie, retient) = par_forme!(Self, self, forme => {
            let (t, contient) = forme.t_et_contient(rayon);
            let entree = if contient { R::ZERO } else { t };
            (entree, forme.t_sortie(rayon), forme.retient(rayon))
        });
        // A ray that enters has a way out, unless that is too far for the type.
        if entree >= rayon.fin() || (entree == R::ZERO && sortie == R::INFINI && !retient) {
            return Err(NoIntersection);
        }
        // Never out before in, as for a way out.
        Ok([entree, min(max(entree, sortie), rayon.fin())])
    }

    /// The texture of this object.
    #[doc(alias = "material")]
    #[inline(always)]
    pub fn texture(&self) -> Texture {
        par_forme!(Self, self, forme => forme.texture())
    }

    /// What an answer in `f32` would be in `f64`, asked of this object and of
    /// [`Rayon::temoin_f64`]: the same object in `f64`, exactly, with every number that is stored
    /// and no other.
    ///
    /// It serves for nothing else. Directions and normals are unit only to the rounding of `f32`, so
    /// that `marge`, `etendue` and all rays from a hit, as `secondaire` gives them, promise nothing,
    /// and `vers_lieu` nothing beside an edge. For an object in `f64` describe it in `f64`.
    ///
    /// ```
    /// use lancer_rayon::{ObjetRay, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = SphereGeo::<f32>::new(Vecteur::new(0.1, 0.2, 0.3), 0.7, Texture(0))?;
    /// let ObjetRay::Sphere(boule) = ObjetRay::from(boule).temoin_f64() else { panic!("a sphere") };
    /// assert_eq!((boule.centre().x, boule.rayon()), (0.1_f32.into(), 0.7_f32.into()));
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("to_f64", "widen", "witness"))]
    pub fn temoin_f64(&self) -> ObjetRay {
        par_forme!(Self, self, forme => forme.temoin_f64().into())
    }

    /// Whether a point is in this object or on its surface. The test computes what a search
    /// computes, so that no ray from such a point touches the object (unless the ray has a
    /// [δ](Rayon::flou)).
    ///
    /// ```
    /// use lancer_rayon::{ObjetRay, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = ObjetRay::from(SphereGeo::new(Vecteur::NUL, 2.0, Texture(0))?);
    /// let le_long = |x| boule.contient(Vecteur::new(x, 0.0, 0.0));
    /// assert_eq!([1.0, 2.0, 3.0, f64::NAN].map(le_long), [true, true, false, false]);
    ///
    /// // For a list:
    /// assert!([boule].iter().any(|objet| objet.contient(Vecteur::NUL)));
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("contains", "inside"))]
    #[must_use]
    pub fn contient(&self, point: Vecteur<R>) -> bool {
        par_forme!(Self, self, forme => forme.contient(point))
    }

    /// A box along the axes that holds all of this object; `None` for a half-space, which is
    /// unbounded.
    ///
    /// Rounding is allowed for, except for an object that [`temoin_f64`](Self::temoin_f64) gave.
    /// The corners lie beyond the object by up to 87u of the sum of its half-extents and 3.1u of
    /// |x| + |y| + |z| of its centre. [`Monde::etendue`](crate::Monde::etendue) is the box of a list.
    #[doc(alias("bounding_box", "aabb", "bounds"))]
    #[must_use]
    pub fn etendue(&self) -> Option<Etendue<R>> {
        let (c, h) = self.boite_englobante()?;
        // E1: rounding may leave the solid this far beyond its half-extents.
        let jeu = h.norme_1() * fois_u(ETENDUE) + c.norme_1() * fois_u(2.0);
        let h = h + Vecteur::new(jeu, jeu, jeu);
        Some(Etendue { bas: c - h, haut: c + h })
    }

    /// Whether a few operations tell that the ray goes away from this object.
    #[inline]
    pub(crate) fn s_eloigne(&self, rayon: &Rayon<R>) -> bool {
        par_forme!(Self, self, forme => forme.s_eloigne(rayon))
    }

    /// A ball around this object.
    #[inline(always)]
    pub(crate) fn boule(&self) -> Boule<R> {
        par_forme!(Self, self, forme => forme.boule())
    }

    /// The centre of this object and its half-extents along the axes; `None` if it is unbounded.
    pub(crate) fn boite_englobante(&self) -> Option<(Vecteur<R>, Vecteur<R>)> {
        par_forme!(Self, self, forme => forme.boite_englobante())
    }

    /// Half of the axis across which this object may be cut into slices; 0 if it has none.
    pub(crate) fn demi_axe(&self) -> Vecteur<R> {
        par_forme!(Self, self, forme => forme.demi_axe())
    }
}

/// A box along the axes around an object or a list: its lowest and its highest corner.
#[doc(alias("bounding_box", "aabb", "bounds"))]
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct Etendue<R = f64> {
    /// The corner with the least coordinates.
    #[doc(alias("min", "corner"))]
    pub bas: Vecteur<R>,
    /// The corner with the greatest coordinates.
    #[doc(alias("max", "corner"))]
    pub haut: Vecteur<R>,
}

impl<R: Nombre> Etendue<R> {
    /// The smallest box that holds both.
    pub(crate) fn avec(self, autre: Self) -> Self {
        let (Self { bas: a, haut: b }, Self { bas: c, haut: d }) = (self, autre);
        let bas = Vecteur::new(min(a.x, c.x), min(a.y, c.y), min(a.z, c.z));
        Self { bas, haut: Vecteur::new(max(b.x, d.x), max(b.y, d.y), max(b.z, d.z)) }
    }
}

/// The conversions of each shape: `XGeo` and `XRay` into the enums `ObjetGeo` and `ObjetRay`, and
/// `XGeo` into `XRay` and `ObjetRay`.
macro_rules! conversions {
    ($($forme:ident, $geo:ident, $ray:ident;)*) => {$(
        impl<R> From<$geo<R>> for ObjetGeo<R> {
            fn from(forme: $geo<R>) -> Self {
                Self::$forme(forme)
            }
        }

        impl<R> From<$ray<R>> for ObjetRay<R> {
            fn from(forme: $ray<R>) -> Self {
                Self::$forme(forme)
            }
        }

        impl<R: Nombre> From<$geo<R>> for $ray<R> {
            fn from(forme: $geo<R>) -> Self {
                forme.vers_ray()
            }
        }

        impl<R: Nombre> From<$geo<R>> for ObjetRay<R> {
            fn from(forme: $geo<R>) -> Self {
                Self::$forme(forme.vers_ray())
            }
        }
    )*};
}

conversions! {
    Sphere, SphereGeo, SphereRay;
    Plan, PlanGeo, PlanRay;
    Boite, BoiteGeo, BoiteRay;
}

impl<R: Nombre> From<ObjetGeo<R>> for ObjetRay<R> {
    fn from(objet: ObjetGeo<R>) -> Self {
        objet.vers_ray()
    }
}
