//! The rays that start from a hit: mirrors, glass, shadows, lines of sight (handout, later parts).

use crate::algebre::arrondis::{
    PAS_ARRONDI, PAS_D_EMBLEE, PAS_D_EMBLEE_POINT, PAS_NORMAL, RAPPORT_MAXIMAL, REDRESSE, TANGENT,
};
use crate::algebre::nombre::{fois_u, plancher};
use crate::algebre::refus::{en_portee, exiger, fini, positif_ou_nul, position, refus_nul};
use crate::rayon::flou::Flou;
use crate::rayon::lumiere::vue_d_une_lampe;
use crate::rayon::{DIRECTION, direction_unitaire};
use crate::{ErreurGeo, Intersection, Nombre, Rayon, Vecteur};

/// A ray that turns in mid-air.
impl<R: Nombre> Rayon<R> {
    /// A ray without an end that goes on from the [`point`](Self::point) at this distance in
    /// another direction: for a particle that is scattered in mid-air, or whose step has ended.
    ///
    /// The new ray carries [δ](Self::flou) as a ray from a hit does. If this ray touches nothing
    /// before `distance`, a particle whose step ends within rounding of a wall, or just behind it,
    /// therefore does not leave [a closed room](Self::flou). A ray that is [inside](Self::dedans)
    /// something stays so.
    ///
    /// **To walk from solid to solid** go on from a way out by
    /// [`secondaire`](crate::Intersection::secondaire), which steps beyond it. The point of a way
    /// out as computed may lie before it by less than its coordinates can tell, and a walk that
    /// turns there finds the same way out again, without end.
    ///
    /// # Errors
    /// If `distance` is below 0 or not finite, if the direction is zero or not finite, or if the
    /// point lies beyond the limits of [`new`](Self::new).
    ///
    /// ```
    /// use lancer_rayon::{NoIntersection, ObjetRay, PlanGeo, Rayon, Texture, Vecteur};
    ///
    /// let bas = Vecteur::new(0.0, -1.0, 0.0);
    /// let sol = ObjetRay::from(PlanGeo::par_un_point(Vecteur::NUL, -bas, Texture(0))?);
    /// let rayon = Rayon::new(Vecteur::new(0.0, 0.3, 0.0), Vecteur::new(1.0, -1.0, 0.0))?;
    ///
    /// // A step as long as the way to the floor ends on the floor, or in it.
    /// let pas = sol.intersection(&rayon)?.distance();
    /// assert_eq!(sol.intersection(&rayon.jusqu_a(pas)?), Err(NoIntersection));
    /// assert!(sol.intersection(&rayon.bifurque(pas, bas)?)?.distance() < 1e-15);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("scatter", "turn_at", "advance", "step"))]
    #[inline]
    pub fn bifurque(&self, distance: R, direction: Vecteur<R>) -> Result<Self, ErreurGeo> {
        let t = positif_ou_nul("distance", distance)?;
        let p = self.point(t);
        // The ray takes no step off a surface. The floor of margins covers what is lost below the
        // normal numbers.
        Ok(Self::new(p, direction)?.sachant(self.flou.suivant(plancher(), t, p)))
    }
}

impl<R: Nombre> Intersection<R> {
    /// A ray that starts at this hit and never hits the object it leaves, with two exceptions:
    /// within rounding of a box edge, and in a box no thicker than twice the step, an inward ray
    /// may start outside, and touch the box.
    ///
    /// The direction may lead outward, D·N > 0, or inward for transparency. For mirrors there is
    /// [`reflechi`](Self::reflechi), for glass [`refracte`](Self::refracte), for shadows
    /// [`vers_lumiere`](Self::vers_lumiere) and [`vers_soleil`](Self::vers_soleil). To ask the ray
    /// there is [`Monde::premiere_depuis`](crate::Monde::premiere_depuis).
    ///
    /// The source is the [`point`](Self::point) of the hit, moved along the normal to the side to
    /// which the direction leads, by [`marge`](Self::marge) and the rounding of the moved point,
    /// 1.1u·(|N_x·P_x| + |N_y·P_y| + |N_z·P_z|). There is no epsilon to choose. An outward ray does
    /// not meet the object again, and an inward ray, which starts inside, does not see it. A
    /// direction within 3.2u of the tangent plane is turned outward by 12u. The ray has no end, and
    /// its distances count from the moved start.
    ///
    /// **The length of a way in glass**, from this hit to the next, is the distance between their
    /// two points.
    ///
    /// **In the corner of a second object** the start may lie inside that object by rounding. An
    /// outward ray carries [a bound δ on the error of its start](Rayon), and touches such an object
    /// at once, at distance 0, if it goes further in. So no chain of outward rays leaves [a closed
    /// room](Rayon::flou), and light out of a glass finds the table under it. An inward ray carries
    /// δ too and is [inside](Rayon::dedans) something: it touches only what it enters from outside.
    /// From a hit at once an outward ray steps farther, by a 64th of δ and 8u·(|x| + |y| + |z|).
    ///
    /// # Errors
    /// If the direction is zero or not finite, if `marge` is +∞, or if the start lies beyond the
    /// limits of a source, as for [`Rayon::new`].
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
    ///     let suite = touche.secondaire(direction)?;
    ///     assert_eq!(boule.intersection(&suite), Err(NoIntersection));
    /// }
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("spawn_ray", "secondary_ray", "shadow_ray", "reflection", "refraction"))]
    #[doc(alias("epsilon", "bias", "tnear"))]
    #[inline(always)]
    pub fn secondaire(&self, direction: Vecteur<R>) -> Result<Rayon<R>, ErreurGeo> {
        let direction = direction_unitaire(DIRECTION, direction)?;
        let cosinus = direction.produit_scalaire(self.normale());
        self.suite(if cosinus < fois_u(-TANGENT) { Cote::Dedans } else { Cote::Dehors }, direction)
    }

    /// The ray that a mirror sends on when a ray arrives in the direction D: a
    /// [`secondaire`](Self::secondaire) in the direction D − 2(D·N)N, which never hits the object
    /// again, with the exception of `secondaire` where it goes inward.
    ///
    /// From a [way out](crate::ObjetRay::sortie), where D·N > 0, the mirrored ray goes inward, as
    /// in glass that does not let light out. Where the ray grazes, rounding may turn the mirrored
    /// direction below the surface, and the direction is then turned outward, as one in the tangent
    /// plane is. Otherwise it is within an angle of 20u of that of an exact mirror at N for the D
    /// of a ray (`docs/preuves/rayons.md`, lemma 9).
    ///
    /// Inside a ball mirrored rays drift inward: in `f32` a cosine of 0.1 grows by a half in 10,000
    /// bounces, and stays within 2 % if each ray starts anew at `sortie.point()`, by [`Rayon::new`]
    /// and [`dedans`](Rayon::dedans).
    ///
    /// # Errors
    /// As [`secondaire`](Self::secondaire): if the direction is zero or not finite, if `marge` is
    /// +∞, or if the start lies beyond the limits of a source.
    ///
    /// ```
    /// use lancer_rayon::{ObjetRay, PlanGeo, Rayon, Texture, Vecteur};
    ///
    /// let haut = Vecteur::new(0.0, 1.0, 0.0);
    /// let sol = ObjetRay::from(PlanGeo::par_un_point(Vecteur::NUL, haut, Texture(0))?);
    /// let rayon = Rayon::new(Vecteur::new(0.0, 4.0, 0.0), Vecteur::new(3.0, -4.0, 0.0))?;
    /// let reflet = sol.intersection(&rayon)?.reflechi(rayon.direction())?;
    /// assert!((reflet.direction() - Vecteur::new(0.6, 0.8, 0.0)).longueur() < 1e-15);
    /// assert!((reflet.source() - Vecteur::new(3.0, 0.0, 0.0)).longueur() < 1e-14);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("reflect", "reflection", "mirror"))]
    #[inline(always)]
    pub fn reflechi(&self, direction: Vecteur<R>) -> Result<Rayon<R>, ErreurGeo> {
        let (d, n) = (direction_unitaire(DIRECTION, direction)?, self.normale());
        let le_long = d.produit_scalaire(n);
        let direction = direction_unitaire(DIRECTION, d - (n + n) * le_long)?;
        if le_long > R::ZERO {
            return self.secondaire(direction);
        }
        // N·D ≤ 0 as computed: exactly it may be above by 3.1u, so that N·D′ is no less than −3.1u
        // before D′ is rounded, and than −5.1u after.
        self.suite(Cote::Dehors, direction)
    }

    /// The ray that light in the direction D becomes behind the surface, by Snell's law: a
    /// [`secondaire`](Self::secondaire) that goes inward from a hit, and outward from a [way
    /// out](crate::ObjetRay::sortie).
    ///
    /// `rapport` is n1 / n2, with n1 the index of refraction before the surface and n2 behind it:
    /// 1/1.5 where light enters glass from air, 1.5 where it leaves. For Fresnel's formula, the
    /// cosine behind the surface is |N·D| with the direction D of the ray that is returned; clamp
    /// it to 1, which it may exceed by some roundings. Another object may stand in the glass: ask
    /// the world before the way out (`docs/guide.md`, "Light through glass").
    ///
    /// With n for `rapport`, the direction is within an angle of sine 10.3u(1 + n)/c′ of the exact
    /// one at N for the D of a ray, with c′ the exact cosine behind the surface
    /// (`docs/preuves/rayons.md`, lemma 9). At n = 1 light goes straight on to 3.1u, at any angle.
    /// A way out within 3.2u of the tangent plane is then turned outward, as by
    /// [`secondaire`](Self::secondaire).
    ///
    /// # Errors
    /// - **Total reflection**: the error names `refraction`, and gives the square of the cosine
    ///   behind the surface, 0 or less. Above n = 1 that may be told wrongly where c′² is within
    ///   9.8u(1 + n)c of 0, with c the exact cosine in front. Up to n = 1 all light passes, unless
    ///   N·D is so small that its square is 0.
    /// - `rapport` is not above 0, or is above 100.
    /// - [`secondaire`](Self::secondaire) would fail. There [`reflechi`](Self::reflechi) fails too,
    ///   so that `touche.refracte(d, rapport).or_else(|_| touche.reflechi(d))` is where light goes,
    ///   if `rapport` is in range.
    ///
    /// ```
    /// use lancer_rayon::{ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule: ObjetRay = SphereGeo::new(Vecteur::NUL, 1.0, Texture(0))?.into();
    /// let rayon = Rayon::new(Vecteur::new(0.8, 0.0, 5.0), -Vecteur::Z)?; // sin α = 0.8
    /// let dedans = boule.intersection(&rayon)?.refracte(rayon.direction(), 1.0 / 1.5)?;
    /// let sortie = boule.sortie(&dedans)?;
    /// let dehors = sortie.refracte(dedans.direction(), 1.5)?;
    /// assert!((dehors.direction().produit_scalaire(sortie.normale()) - 0.6).abs() < 1e-14);
    ///
    /// // From within, as sin α = 0.8 is more than 1/1.5, no light leaves.
    /// let dedans = Rayon::new(Vecteur::new(0.8, 0.0, 0.0), -Vecteur::Z)?;
    /// let sortie = boule.sortie(&dedans)?;
    /// let totale = sortie.refracte(dedans.direction(), 1.5).unwrap_err();
    /// assert_eq!(totale.champ, "refraction");
    /// assert!((totale.valeur - (1.0 - 1.2 * 1.2)).abs() < 1e-14);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("refract", "refraction", "snell", "transmit", "ior", "glass"))]
    #[inline(always)]
    pub fn refracte(&self, direction: Vecteur<R>, rapport: R) -> Result<Rayon<R>, ErreurGeo> {
        let permis = rapport > R::ZERO && rapport <= R::depuis_f64(RAPPORT_MAXIMAL);
        let rapport = exiger(permis, "rapport", rapport, "a number above 0, 100 at most")?;
        let (d, n) = (direction_unitaire(DIRECTION, direction)?, self.normale());
        let le_long = d.produit_scalaire(n);
        let travers = d - n * le_long;
        // Not 1 − n² sin²α: where n is near 1 and light grazes, that cancels.
        let ecart = travers.longueur_carree() * (R::UN - rapport) * (R::UN + rapport);
        let carre = le_long * le_long + ecart;
        let attendu = "above 0, as a squared cosine: all light is mirrored (total reflection)";
        let droit = n * exiger(carre > R::ZERO, "refraction", carre, attendu)?.racine();
        let cote = if le_long <= R::ZERO { Cote::Dedans } else { Cote::Dehors };
        let travers = travers * rapport;
        // M8: n sin α across N, and c′ along it.
        let direction = match cote {
            Cote::Dedans => travers - droit,
            Cote::Dehors => travers + droit,
        };
        self.suite(cote, direction_unitaire(DIRECTION, direction)?)
    }

    /// The ray from this hit to a light, which ends there: ask
    /// [`Monde::est_occulte_depuis`](crate::Monde::est_occulte_depuis) whether anything stands
    /// before the light. [`Monde::eclairement`](crate::Monde::eclairement) does both.
    ///
    /// The ray is a [`secondaire`](Self::secondaire) and never hits the object it leaves. Its end,
    /// the distance from its start to the light, is off by at most 3.6u of itself and
    /// [`ETA`](Nombre::ETA); the direction is good to 4.6u, and N·L to 8u. If the
    /// lamp is itself an object of the list, [leave it out](crate::Monde::sans).
    ///
    /// # Errors
    /// - The surface faces away, N·L ≤ 3.2u with L the unit direction from the start of the ray to
    ///   the light: the error names `lumiere` and gives N·L.
    /// - `lumiere` is not finite or is the start itself.
    /// - [`secondaire`](Self::secondaire) would fail, as from a sphere whose [`marge`](Self::marge)
    ///   is +∞: no lamp lights such a sphere.
    ///
    /// In each case the lamp adds no light to this point, and a renderer need not tell the cases
    /// apart: `if let Ok(ombre) = touche.vers_lumiere(lampe)`.
    ///
    /// ```
    /// use lancer_rayon::{ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = SphereGeo::new(Vecteur::new(0.0, 0.0, -5.0), 1.0, Texture(0))?;
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
    /// let touche = ObjetRay::from(boule).intersection(&rayon)?;
    ///
    /// let vers = |z| touche.vers_lumiere(Vecteur::new(3.0, 0.0, z));
    /// let ombre: Rayon = vers(0.0)?;
    /// assert!((ombre.fin() - 5.0).abs() < 1e-13);
    /// assert_eq!(vers(-9.0).unwrap_err().champ, "lumiere"); // behind the surface
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("shadow_ray", "light", "lamp"))]
    #[inline(always)]
    pub fn vers_lumiere(&self, lumiere: Vecteur<R>) -> Result<Rayon<R>, ErreurGeo> {
        // L2: from the start, not from P.
        let (rayon, cosinus, eclaire) = self.vers(|source| vue_d_une_lampe(lumiere, source));
        if eclaire {
            return Ok(rayon);
        }
        Err(refus_d_ombre("lumiere", self.marge(), rayon.source, Some(lumiere), cosinus))
    }

    /// The ray without an end from this hit towards a sun, a light that has a direction and no
    /// place: ask [`Monde::est_occulte_depuis`](crate::Monde::est_occulte_depuis) whether anything
    /// stands before it. [`Monde::eclairement`](crate::Monde::eclairement) does both.
    ///
    /// `soleil` is the direction to the light, of any length. The light that the surface receives
    /// is proportional to N·L, the cosine: `touche.normale().produit_scalaire(ombre.direction())`,
    /// good to 10.7u. A half-space hides any sun behind its surface. So no sun shines into a room
    /// of half-spaces, which has no windows.
    ///
    /// # Errors
    /// - The surface faces away, N·L ≤ 3.2u with L that direction as a unit vector.
    /// - `soleil` is zero or not finite.
    /// - [`secondaire`](Self::secondaire) would fail.
    ///
    /// ```
    /// use lancer_rayon::{Monde, ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = SphereGeo::new(Vecteur::new(0.0, 0.0, -5.0), 1.0, Texture(0))?;
    /// let objets = [ObjetRay::from(boule)];
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
    /// let touche = objets[0].intersection(&rayon)?;
    ///
    /// let vers = |z| touche.vers_soleil(Vecteur::new(3.0, 0.0, z));
    /// let ombre: Rayon = vers(4.0)?;
    /// assert_eq!((ombre.direction().x, ombre.fin()), (0.6, f64::INFINITY));
    /// assert!(!Monde::de_liste(&objets).est_occulte(&ombre));
    /// assert_eq!(vers(-4.0).unwrap_err().champ, "soleil"); // behind the surface
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("sun", "directional_light", "shadow_ray"))]
    #[inline(always)]
    pub fn vers_soleil(&self, soleil: Vecteur<R>) -> Result<Rayon<R>, ErreurGeo> {
        let champs = ["soleil", "soleil.x", "soleil.y", "soleil.z"];
        let direction = direction_unitaire(champs, soleil)?;
        let (rayon, cosinus, eclaire) = self.vers(|_| (R::INFINI, direction));
        if eclaire {
            return Ok(rayon);
        }
        Err(refus_d_ombre("soleil", self.marge(), rayon.source, None, cosinus))
    }

    /// The ray from outside the surface to a light, which lies at the distance and in the direction
    /// that `vue_de` says; N·L; and whether the ray may start and the surface faces the light.
    /// Without a branch of its own.
    #[inline(always)]
    pub(crate) fn vers(
        &self,
        vue_de: impl Fn(Vecteur<R>) -> (R, Vecteur<R>),
    ) -> (Rayon<R>, R, bool) {
        let (depart, permis) = self.depart_et_permis(Cote::Dehors); // L1: past all rounding
        let (fin, direction) = vue_de(depart.source);
        let cosinus = direction.produit_scalaire(self.normale());
        (Rayon { direction, fin, ..depart }, cosinus, permis & fait_face(cosinus))
    }

    /// The ray from this hit to another, which ends there. Whether two points of surfaces see each
    /// other is `!monde.sans(cible.indice()).est_occulte(&rayon)`.
    ///
    /// **A hit of an object that was asked alone, by `intersection` or `sortie`, has index 0:**
    /// name its index in the list instead.
    ///
    /// Both ends step off their surfaces, as for [`secondaire`](Self::secondaire), so that the ray
    /// never hits the object it leaves. Leave out the object it goes to
    /// ([`sans`](crate::Monde::sans)), since no distance stops exactly before a surface; a convex
    /// solid whose surface faces the ray hides none of its own points. With both hits exchanged the
    /// ray has the same length and the opposite direction, exactly, or is an error again. What
    /// stands between is the same both ways, except within rounding of a third object that the line
    /// grazes or that one hit lies against.
    ///
    /// # Errors
    /// - Either surface faces away from the other point, to the 3.2u of
    ///   [`vers_lumiere`](Self::vers_lumiere): the error names `lumiere` or `cible`.
    /// - `vers_lumiere` fails otherwise.
    ///
    /// ```
    /// use lancer_rayon::{ErreurGeo, Intersection, Monde, PlanGeo, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let haut = Vecteur::new(0.0, 1.0, 0.0);
    /// let sol = PlanGeo::par_un_point(Vecteur::NUL, haut, Texture(0))?;
    /// let boule = |x| SphereGeo::new(Vecteur::new(x, 1.0, 0.0), 1.0, Texture(1));
    /// let objets = [sol.into(), boule(0.0)?.into(), boule(6.0)?.into()];
    /// let monde = Monde::de_liste(&objets);
    ///
    /// let vers = |x, y| Rayon::new(Vecteur::new(3.0, 8.0, 0.0), Vecteur::new(x, y, 0.0));
    /// let touche = |x, y| vers(x, y).ok().and_then(|rayon| monde.premiere_intersection(&rayon).ok());
    /// let [a, b, c] = [(-0.5, -8.0), (2.2, -7.0), (-5.0, -8.0)].map(|(x, y)| touche(x, y).unwrap());
    /// let se_voient = |a: Intersection, b: Intersection| {
    ///     let rayon = a.vers_touche(&b)?;
    ///     Ok::<_, ErreurGeo>(!monde.sans(b.indice()).est_occulte(&rayon))
    /// };
    /// assert!(se_voient(a, b)?);
    /// assert!(!se_voient(c, b)?); // the first ball stands between
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("line_of_sight", "visibility", "segment"))]
    #[inline]
    pub fn vers_touche(&self, cible: &Self) -> Result<Rayon<R>, ErreurGeo> {
        let vers = self.vers_lumiere(cible.depart(Cote::Dehors)?.source)?;
        let cosinus = -vers.direction().produit_scalaire(cible.normale());
        exiger(fait_face(cosinus), "cible", cosinus, DE_FACE)?;
        Ok(vers)
    }

    /// How far along the normal, to this side, a ray starts from the point of the hit.
    #[inline(always)]
    fn pas(&self, cote: Cote) -> R {
        let (p, n) = (self.point(), self.normale());
        // M6: the margin, and what P, N and their sum round by.
        let pas = self.marge() * (R::UN + fois_u(PAS_NORMAL));
        let pas = pas + n.somme_des_grandeurs(p) * fois_u(PAS_ARRONDI);
        // Where a box stands flush on a mirror, the nearest face may be the hidden one. The mirror
        // would send the ray back to where it was, and so on without end. Steps that grow with δ
        // leave another face nearer in the end.
        let plus = self.delta * R::depuis_f64(PAS_D_EMBLEE);
        let long = pas + plus + p.norme_1() * fois_u(PAS_D_EMBLEE_POINT);
        if (cote == Cote::Dehors) & (self.distance() == R::ZERO) { long } else { pas }
    }

    /// The ray along the normal from the point of the hit, moved along the normal to this side,
    /// past all rounding; and whether a ray may start there.
    #[inline(always)]
    fn depart_et_permis(&self, cote: Cote) -> (Rayon<R>, bool) {
        let (p, n, pas) = (self.point(), self.normale(), self.pas(cote));
        let flou = Flou::de(self.delta).suivant(pas, self.distance(), p);
        let (pas, flou) = match cote {
            Cote::Dehors => (pas, flou),
            Cote::Dedans => (-pas, flou.dedans()),
        };
        let source = p + n * pas;
        let permis = (self.marge() < R::INFINI) & en_portee(source);
        (Rayon::sans_fin(source, n).sachant(flou), permis)
    }

    /// The ray of [`depart_et_permis`](Self::depart_et_permis), or why none may start there.
    #[inline(always)]
    fn depart(&self, cote: Cote) -> Result<Rayon<R>, ErreurGeo> {
        let (depart, _) = self.depart_et_permis(cote);
        exiger_un_depart(self.marge(), depart.source)?;
        Ok(depart)
    }

    /// The ray from that side in this unit direction.
    #[inline(always)]
    fn suite(&self, cote: Cote, direction: Vecteur<R>) -> Result<Rayon<R>, ErreurGeo> {
        let direction = match cote {
            Cote::Dehors => self.redressee(direction)?,
            Cote::Dedans => direction,
        };
        Ok(Rayon { direction, ..self.depart(cote)? })
    }

    /// This direction, which leads inward by no more than rounding, turned outward if it is within
    /// [`TANGENT`] of the tangent plane or below it.
    #[inline]
    fn redressee(&self, d: Vecteur<R>) -> Result<Vecteur<R>, ErreurGeo> {
        if fait_face(d.produit_scalaire(self.normale())) {
            return Ok(d);
        }
        // M5: outward by more than it was inward.
        direction_unitaire(DIRECTION, d + self.normale() * fois_u(REDRESSE))
    }
}

/// Refuses a start at a hit with this margin.
#[inline(always)]
fn exiger_un_depart<R: Nombre>(marge: R, source: Vecteur<R>) -> Result<(), ErreurGeo> {
    let attendu = "finite: a sphere lost in rounding, or a point out of range, has no side";
    exiger(marge < R::INFINI, "marge", marge, attendu)?;
    position(["source.x", "source.y", "source.z"], source).map(|_| ())
}

/// What N·L must be.
const DE_FACE: &str = "on the side that the surface faces: N·L > 3.2u";

/// Why no shadow ray leaves a hit. Cold, and given numbers alone: what a refusal took by reference
/// would lie in memory wherever it is called, and a ray that is not refused would take three times
/// as long (measured).
#[cold]
#[inline(never)]
fn refus_d_ombre<R: Nombre>(
    champ: &'static str,
    marge: R,
    source: Vecteur<R>,
    lampe: Option<Vecteur<R>>,
    cosinus: R,
) -> ErreurGeo {
    if let Err(refus) = exiger_un_depart(marge, source) {
        return refus;
    }
    if let Some(lampe) = lampe {
        if let Err(refus) = fini(["lumiere.x", "lumiere.y", "lumiere.z"], lampe) {
            return refus;
        }
        if lampe == source {
            return refus_nul("lumiere - depart");
        }
    }
    ErreurGeo { champ, valeur: cosinus.vers_f64(), attendu: DE_FACE }
}

/// The side of a surface to which a ray starts.
#[derive(Clone, Copy, PartialEq)]
enum Cote {
    Dehors,
    Dedans,
}

/// Whether a unit direction of this cosine with the normal leads away from the surface.
#[inline(always)]
fn fait_face<R: Nombre>(cosinus: R) -> bool {
    cosinus > fois_u(TANGENT) // L3: by more than N·D rounds
}
