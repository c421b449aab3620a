//! An object asked alone: where a ray enters it, and where it leaves it. How exact the answers are is
//! asked in `question/jugement.rs`.

use crate::algebre::nombre::{Nombre, max, min};
use crate::objet::forme::Forme;
use crate::objet::{ObjetRay, par_forme};
use crate::rayon::Rayon;
use crate::rayon::intersection::{Intersection, NoIntersection, Rang, Reponse};

impl<R: Nombre> ObjetRay<R> {
    /// Where the ray enters this object (handout, annex A): what
    /// [`premiere_intersection`](fn@crate::premiere_intersection) says of a list of this object alone.
    ///
    /// # Errors
    /// [`NoIntersection`] if the ray ends before the object, passes it by, is tangent to it, or
    /// starts inside it or on its surface.
    #[doc(alias("intersect", "hit"))]
    pub fn intersection(&self, rayon: &Rayon<R>) -> Reponse<R> {
        let t = self.t_si_proche(rayon);
        if t < rayon.fin() { self.conclure(rayon, t, Rang::de(0)) } else { Err(NoIntersection) }
    }

    /// Where the ray leaves this object: from inside, or after it entered.
    ///
    /// `distance` is that from the source of the ray, in scene units, and `normale` points outward:
    /// now along the ray, D·N > 0. `marge` and [`secondaire`](Intersection::secondaire) are those
    /// of any hit: light in glass goes on from there outward, by Snell's law, or inward,
    /// [mirrored](Intersection::reflechi). The way out is as exact as a hit (`docs/precision.md`),
    /// and [`BoiteRay::lieu`](crate::BoiteRay::lieu) and [`erreur`](Self::erreur) take it as one.
    ///
    /// **Each crossing is found once.** A ray that enters a sphere or a box leaves it, never before
    /// it enters, and a ray from inside always leaves. A ray that enters a half-space never leaves
    /// it. From a source on the surface a ray leaves at the far side, or not at all: the source
    /// itself is no way out, as it is no hit. What is inside and what is on the surface is decided
    /// as computed: within rounding of a sphere a ray may leave at once. A ray that `secondaire`
    /// sent into a sphere or a box leaves, except beside an edge and in a box no thicker than twice
    /// the step; a ray that it sent outward does not.
    ///
    /// **A place of one's own**, such as a sensor on a wall, a window or a point of a lamp, is where
    /// a ray from within leaves the object along the normal. That is a hit of this object alone,
    /// whatever stands flush with it: `vers_soleil`, `vers_lumiere` and `vers_touche` start there as
    /// from any other. Keep the place off the edges of its face: rounding may put a source there
    /// outside, from which there is no way out.
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
        // Turned back, the ray enters the object, at −t, where this one leaves it.
        let retour = Rayon::sans_fin(rayon.source(), -rayon.direction());
        par_forme!(Self, self, forme => {
            let (entree, sortie) = (forme.t(rayon), forme.t_sortie(rayon));
            let t = if entree < R::INFINI { max(entree, sortie) } else { sortie }; // W5
            if t >= rayon.fin() {
                return Err(NoIntersection);
            }
            // Beyond, a ray from inside is inside one object fewer, or outside; one that passes
            // through is inside as many as before.
            let su = rayon.su();
            let su = if entree < R::INFINI { su } else { min(su + R::UN, max(su, R::ZERO)) };
            let contact = forme.conclure(&retour, -t); // W6
            Ok(Intersection::new(t, contact, su, forme.texture(), Rang::de(0)))
        })
    }
}
