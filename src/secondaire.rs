//! The rays that start from a hit: mirrors, glass, shadows, lines of sight (handout, later parts).

use crate::intersection::Intersection;
use crate::rayon::{Rayon, direction_unitaire, source_valide};
use crate::reel::{Reel, fois_u};
use crate::refus::{ErreurGeo, exiger};
use crate::vecteur::Vecteur;

/// A direction within so many u of the tangent plane is turned outward: no N·D rounds by more
/// (lemma 9).
pub const TANGENT: f64 = 3.2;

/// Such a direction is turned by so many u: N·D is then above 0, however it is rounded (lemma 9).
pub const REDRESSE: f64 = 12.0;

/// By so many u of itself a margin grows for an N that is not exactly unit (lemma 9).
pub const PAS_NORMAL: f64 = 20.0;

/// The rounding of the moved point, in u·Σ|N_i·P_i| (lemma 9).
pub const PAS_ARRONDI: f64 = 1.1;

impl<R: Reel> Rayon<R> {
    /// A ray that starts where this one touched an object and never hits that object again, with
    /// one exception (below): for a direction outward, D·N > 0, and for transparency, inward. Mirrors
    /// have [`reflechi`](Self::reflechi), shadows [`vers_lumiere`](Self::vers_lumiere) and
    /// [`vers_soleil`](Self::vers_soleil).
    ///
    /// The source is the point of the hit, moved along the normal to the side to which the
    /// direction leads, by [`marge`](Intersection::marge) and the rounding of the moved point,
    /// 1.1u·Σ|N_i·P_i|. From outside, a ray that leaves the object does not meet it again; from
    /// inside, the object is not seen at all. A direction within 3.2u of the tangent plane is
    /// turned outward by 12u. There is no epsilon to choose, and nothing farther than that step is
    /// jumped over.
    ///
    /// Within rounding of a box edge an inward ray may touch the other face of that edge, of which
    /// the hit knows nothing. **Of a second object** that the hit lies within rounding of, the hit
    /// knows nothing either: the ray may start inside that object, which it then does not see. Of
    /// rays aimed at the corner between two walls up to half go through; a ray out of a glass into
    /// the table that the glass stands on always starts inside the table. Where a ray leaves an
    /// object [`ObjetRay::sortie`](crate::ObjetRay::sortie) says; the recipe "Glass" in
    /// `docs/README.md` asks for both.
    ///
    /// `touche` is to be a hit of this very ray. With the hit of another ray the result is a valid
    /// ray or a refusal, and nothing is promised about where it starts.
    ///
    /// # Errors
    /// If the direction is zero or not finite, if `marge` is +∞, or if the start lies beyond the
    /// limits of a source, as for [`new`](Self::new).
    ///
    /// ```
    /// use lancer_rayon::{NoIntersection, ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = SphereGeo::new(Vecteur::new(0.1, 0.2, -5.0), 1.7, Texture(0))?;
    /// let boule = ObjetRay::from(boule);
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.1, 0.05, -1.0))?;
    /// let touche = boule.intersection(&rayon)?;
    ///
    /// // Back along the normal, and straight on, as through glass.
    /// for direction in [touche.normale(), rayon.direction()] {
    ///     let suite = rayon.secondaire(&touche, direction)?;
    ///     assert_eq!(boule.intersection(&suite), Err(NoIntersection));
    /// }
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("spawn_ray", "secondary_ray", "shadow_ray", "reflection", "refraction"))]
    #[inline]
    pub fn secondaire(
        &self,
        touche: &Intersection<R>,
        direction: Vecteur<R>,
    ) -> Result<Self, ErreurGeo> {
        let direction = direction_unitaire(direction)?;
        let dedans = direction.produit_scalaire(touche.normale()) < fois_u(-TANGENT);
        let direction = if dedans { direction } else { redressee(touche, direction)? };
        Ok(Self::sans_verifier(self.depart(touche, dedans)?, direction))
    }

    /// The ray that a mirror sends on from where this one touched an object: a
    /// [`secondaire`](Self::secondaire) in the direction D − 2(D·N)N, which never hits that object
    /// again.
    ///
    /// Where this ray grazes, rounding may turn that direction below the surface; it is then turned
    /// outward, as one of the tangent plane is.
    ///
    /// # Errors
    /// As [`secondaire`](Self::secondaire): if `marge` is +∞, or the start beyond the limits of a
    /// source.
    ///
    /// ```
    /// use lancer_rayon::{ObjetRay, PlanGeo, Rayon, Texture, Vecteur};
    ///
    /// let haut = Vecteur::new(0.0, 1.0, 0.0);
    /// let sol = ObjetRay::from(PlanGeo::par_un_point(Vecteur::NUL, haut, Texture(0))?);
    /// let rayon = Rayon::new(Vecteur::new(0.0, 4.0, 0.0), Vecteur::new(3.0, -4.0, 0.0))?;
    /// let reflet = rayon.reflechi(&sol.intersection(&rayon)?)?;
    /// assert!((reflet.direction() - Vecteur::new(0.6, 0.8, 0.0)).longueur() < 1e-15);
    /// assert!((reflet.source() - Vecteur::new(3.0, 0.0, 0.0)).longueur() < 1e-14);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("reflect", "reflection", "mirror"))]
    #[inline]
    pub fn reflechi(&self, touche: &Intersection<R>) -> Result<Self, ErreurGeo> {
        let (d, n) = (self.direction(), touche.normale());
        // N·D < 0 as computed: exactly it may be above by 3.1u, so that N·D′ is no less than −3.1u before
        // D′ is rounded, and than −5.1u after.
        let direction = direction_unitaire(d - (n + n) * d.produit_scalaire(n))?;
        Ok(Self::sans_verifier(self.depart(touche, false)?, redressee(touche, direction)?))
    }

    /// The ray from the point of a hit to a light, and the distance of the light in scene units:
    /// the arguments of [`est_occulte`](crate::est_occulte) for a shadow.
    ///
    /// The ray is a [`secondaire`](Self::secondaire) and never hits the object it leaves. `None` if
    /// N·L ≤ 3.2u, with L the unit direction from the start of the ray to the light: the surface
    /// faces away, or the light lies in the tangent plane of the start. `None` also if `lumiere` is
    /// not finite or is the start itself, or where [`secondaire`](Self::secondaire) would fail. A
    /// distance that overflows is +∞. Either way no light of this point is to be added, and a
    /// renderer need not tell the cases apart; whoever must asks `secondaire(touche, lumiere −
    /// point)`, whose error names what cannot be computed.
    ///
    /// From the start to the light the distance is good to 3.6u of itself and
    /// [`MIN_POSITIF`](Reel::MIN_POSITIF), the direction to 4.6u, and N·L to 8u (lemma 11). Towards a
    /// point of a lamp that is itself an object of the list, [leave the lamp
    /// out](crate::Hierarchie::sans).
    ///
    /// ```
    /// use lancer_rayon::{ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = SphereGeo::new(Vecteur::new(0.0, 0.0, -5.0), 1.0, Texture(0))?;
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
    /// let touche = ObjetRay::from(boule).intersection(&rayon)?;
    ///
    /// let vers = |z| rayon.vers_lumiere(&touche, Vecteur::new(3.0, 0.0, z));
    /// let (_, distance): (Rayon, f64) = vers(0.0).expect("the surface faces it");
    /// assert!((distance - 5.0).abs() < 1e-13);
    /// assert!(vers(-9.0).is_none()); // behind the surface
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("shadow_ray", "light", "lamp"))]
    #[inline]
    #[must_use]
    pub fn vers_lumiere(&self, touche: &Intersection<R>, lumiere: Vecteur<R>) -> Option<(Self, R)> {
        let depart = self.depart(touche, false).ok()?; // L1
        let (distance, direction) = (lumiere - depart).longueur_et_unitaire()?; // L2
        fait_face(touche, direction).then(|| (Self::sans_verifier(depart, direction), distance))
    }

    /// The ray from the point of a hit to a light that is a direction and has no place, a sun, and
    /// its distance, +∞: the arguments of [`est_occulte`](crate::est_occulte) for a shadow, as those
    /// of [`vers_lumiere`](Self::vers_lumiere).
    ///
    /// `soleil` is the direction to the light, of any length. `None` if N·L ≤ 3.2u, with L that
    /// direction as a unit vector: the surface faces away. `None` also if `soleil` is zero or not
    /// finite, or where [`secondaire`](Self::secondaire) would fail. What the surface receives goes
    /// with N·L, the cosine: `touche.normale().produit_scalaire(ombre.direction())`.
    ///
    /// ```
    /// use lancer_rayon::{ObjetRay, Rayon, SphereGeo, Texture, Vecteur, est_occulte};
    ///
    /// let boule = SphereGeo::new(Vecteur::new(0.0, 0.0, -5.0), 1.0, Texture(0))?;
    /// let scene = [ObjetRay::from(boule)];
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
    /// let touche = scene[0].intersection(&rayon)?;
    ///
    /// let vers = |z| rayon.vers_soleil(&touche, Vecteur::new(3.0, 0.0, z));
    /// let (ombre, distance): (Rayon, f64) = vers(4.0).expect("the surface faces it");
    /// assert_eq!((ombre.direction().x, distance), (0.6, f64::INFINITY));
    /// assert!(!est_occulte(&scene, &ombre, distance));
    /// assert!(vers(-4.0).is_none()); // behind the surface
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("sun", "directional_light", "shadow_ray"))]
    #[inline]
    #[must_use]
    pub fn vers_soleil(&self, touche: &Intersection<R>, soleil: Vecteur<R>) -> Option<(Self, R)> {
        let depart = self.depart(touche, false).ok()?;
        let direction = direction_unitaire(soleil).ok()?;
        fait_face(touche, direction).then(|| (Self::sans_verifier(depart, direction), R::INFINI))
    }

    /// The ray from this hit to another, `cible`, which the ray `autre` found, and the distance
    /// between both: whether two points of surfaces see each other is
    /// `!hierarchie.sans(cible.objet()).est_occulte(&rayon, distance)`. (A hit of an object that was
    /// asked alone has index 0: name its index in the list.)
    ///
    /// Both ends step off their surfaces, as for [`secondaire`](Self::secondaire), so that the ray
    /// never hits the object it leaves. The object it goes to is
    /// [left out](crate::Hierarchie::sans), since no distance stops exactly before a surface: solids
    /// are convex, and one that faces the ray hides no point of its own. `None` if either surface
    /// faces away from the other point, to the 3.2u of [`vers_lumiere`](Self::vers_lumiere), or
    /// where that cannot compute. With both hits exchanged the answer is the same distance and the
    /// opposite direction, exactly, or `None` again; what stands between is the same both ways, but
    /// within rounding of a third object, that the line grazes or one hit lies against.
    ///
    /// ```
    /// use lancer_rayon::{Hierarchie, PlanGeo, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let haut = Vecteur::new(0.0, 1.0, 0.0);
    /// let sol = PlanGeo::par_un_point(Vecteur::NUL, haut, Texture(0))?;
    /// let boule = |x| SphereGeo::new(Vecteur::new(x, 1.0, 0.0), 1.0, Texture(1));
    /// let scene = [sol.into(), boule(0.0)?.into(), boule(6.0)?.into()];
    ///
    /// let vers = |x, y| Rayon::new(Vecteur::new(3.0, 8.0, 0.0), Vecteur::new(x, y, 0.0));
    /// let (a, b, c) = (vers(-0.5, -8.0)?, vers(2.2, -7.0)?, vers(-5.0, -8.0)?);
    /// let mut places = vec![0.0; Hierarchie::places(scene.len())];
    /// let hierarchie = Hierarchie::new(&scene, &mut places)?;
    /// let se_voient = |a: &Rayon, b: &Rayon| {
    ///     let touche = |rayon| hierarchie.premiere_intersection(rayon).ok();
    ///     let (depart, cible) = (touche(a)?, touche(b)?);
    ///     let (rayon, distance) = a.vers_touche(&depart, b, &cible)?;
    ///     Some(!hierarchie.sans(cible.objet()).est_occulte(&rayon, distance))
    /// };
    /// assert_eq!(se_voient(&a, &b), Some(true));
    /// assert_eq!(se_voient(&c, &b), Some(false)); // the first ball stands between
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("line_of_sight", "visibility", "segment"))]
    #[must_use]
    pub fn vers_touche(
        &self,
        touche: &Intersection<R>,
        autre: &Self,
        cible: &Intersection<R>,
    ) -> Option<(Self, R)> {
        let vers = self.vers_lumiere(touche, autre.depart(cible, false).ok()?)?;
        fait_face(cible, -vers.0.direction()).then_some(vers)
    }

    /// The point of the hit, moved along the normal, outward or inward, past all rounding.
    #[inline(always)]
    fn depart(&self, touche: &Intersection<R>, dedans: bool) -> Result<Vecteur<R>, ErreurGeo> {
        let attendu = "finite: a sphere lost in rounding, or a point out of range, has no side";
        exiger(touche.marge() < R::INFINI, "marge", touche.marge(), attendu)?;
        let (p, n) = (self.point(touche.distance()), touche.normale());
        let pas = touche.marge() * (R::UN + fois_u(PAS_NORMAL));
        let pas = pas + n.somme_des_grandeurs(p) * fois_u(PAS_ARRONDI);
        // M6
        source_valide(p + n * if dedans { -pas } else { pas })
    }
}

/// Whether this unit direction leads away from the surface that was hit, by more than N·D can round.
#[inline(always)]
fn fait_face<R: Reel>(touche: &Intersection<R>, direction: Vecteur<R>) -> bool {
    direction.produit_scalaire(touche.normale()) > fois_u(TANGENT) // L3
}

/// This direction, which no more than rounding leads inward, turned outward if it is within
/// [`TANGENT`] of the tangent plane or below it.
#[inline]
fn redressee<R: Reel>(touche: &Intersection<R>, d: Vecteur<R>) -> Result<Vecteur<R>, ErreurGeo> {
    if fait_face(touche, d) {
        return Ok(d);
    }
    direction_unitaire(d + touche.normale() * fois_u(REDRESSE)) // M5
}
