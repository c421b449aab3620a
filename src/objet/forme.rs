//! The trait of the three shapes, the part of a hit that they share, and the ball that rejects most
//! rays without a division or a root.
//!
//! A ray meets a shape in three steps. [`Forme::peut_entrer`] is cheap and rejects most rays;
//! [`Forme::t`] finds where the ray enters; [`Forme::contact`] computes normal and margin, once,
//! for the first object of a ray.

use crate::algebre::arrondis::{ARRONDI_HAUTEUR, PENCHE, RETRAIT, VERS_LE_HAUT};
use crate::algebre::nombre::{fois_u, fois_u_simple, max, min, plancher};
use crate::rayon::intersection::Contact;
use crate::{Nombre, Rayon, Vecteur};

/// A shape, ready for rays.
pub(crate) trait Forme<R: Nombre>: Copy {
    /// A ball around all of the shape; [`Boule::INFINIE`] if it is unbounded.
    fn boule(&self) -> Boule<R>;

    /// The centre of the shape and its half-extents along the axes, each to 3u of itself; `None` if
    /// it is unbounded.
    fn boite_englobante(&self) -> Option<(Vecteur<R>, Vecteur<R>)>;

    /// Half of the axis across which a [tree](crate::Monde) may cut the shape into slices; 0 if it
    /// has none, as any shape has of which not every hit lies in the box of a slice (lemma 6).
    fn demi_axe(&self) -> Vecteur<R> {
        Vecteur::NUL
    }

    /// Whether the ray may enter, or touch at once: true wherever [`t_touche`](Self::t_touche) is
    /// finite, and cheap. A bounded shape keeps this definition, for which lemma 14 is proven.
    #[inline(always)]
    fn peut_entrer(&self, rayon: &Rayon<R>) -> bool {
        self.boule().approchee(rayon)
    }

    /// The distance at which the ray enters, +∞ if it does not, and whether its source is in the
    /// shape or on its surface; computed without a branch.
    ///
    /// The distance is above 0 with D·N < 0, or +∞, and never a NaN. On a bounded shape the point at
    /// that distance lies in the grown box of lemma 6, on which culling rests.
    fn t_et_contient(&self, rayon: &Rayon<R>) -> (R, bool);

    /// The distance at which the ray enters, +∞ if it does not.
    #[inline(always)]
    fn t(&self, rayon: &Rayon<R>) -> R {
        self.t_et_contient(rayon).0
    }

    /// [`t`](Self::t), or 0 if the ray touches the shape at once.
    #[inline(always)]
    fn t_touche(&self, rayon: &Rayon<R>) -> R {
        // Without a δ nobody asks what holds the source.
        if rayon.flou.d_emblee() == R::ZERO {
            return self.t(rayon);
        }
        let (t, contient) = self.t_et_contient(rayon);
        if contient { self.t_de_l_interieur(*rayon) } else { t }
    }

    /// 0 if the ray, whose source the shape contains, touches at once, else +∞.
    #[cold]
    fn t_de_l_interieur(&self, rayon: Rayon<R>) -> R {
        if self.des_le_depart(&rayon) { R::ZERO } else { R::INFINI }
    }

    /// Whether a few operations tell that the ray goes away, so that [`t_touche`](Self::t_touche) is
    /// +∞: as they do of a ray that leaves this shape outward. It is never true otherwise, since
    /// such a ray does not ask this object.
    fn s_eloigne(&self, rayon: &Rayon<R>) -> bool;

    /// Whether the ray starts in this shape by no more than its δ, which is above 0, and the
    /// rounding of the shape, and goes in: then it touches the shape at once (lemma 22). A sphere
    /// may hold it twice as deep, where `avec_flou` gave δ. Computed without a branch.
    fn des_le_depart(&self, rayon: &Rayon<R>) -> bool;

    /// The distance at which the ray leaves, from inside or after it entered, +∞ if it never does;
    /// computed without a branch. It is, with the other sign, the distance at which the ray turned
    /// back enters. In the band rounding may put it before the entry, and `ObjetRay::sortie` mends
    /// that.
    fn t_sortie(&self, rayon: &Rayon<R>) -> R;

    /// Whether a ray that is in the shape, and has no way out, stays in it for ever or farther than
    /// the type can tell. A bounded shape keeps this definition.
    fn retient(&self, _: &Rayon<R>) -> bool {
        false
    }

    /// Whether a point is in the shape or on its surface: then no ray from it enters. It decides by
    /// the sums of [`t_et_contient`](Self::t_et_contient), so that no rounding tells the two apart,
    /// and is false of a NaN.
    #[inline(always)]
    fn contient(&self, point: Vecteur<R>) -> bool {
        self.t_et_contient(&Rayon::sans_fin(point, Vecteur::Z)).1
    }

    /// The unit outward normal N of the entry at distance `t`, and how far along N the surface lies
    /// there from the centre of the ball; computed without a branch. N is unit to rounding, or 0.
    /// Where rounding has lost N or brought N·D to 0 or above, [`vers_la_source`] replaces it.
    fn plan_tangent(&self, rayon: &Rayon<R>, t: R) -> (Vecteur<R>, R);

    /// What [`plan_tangent`](Self::plan_tangent) says for a shape that the ray touches at once.
    fn plan_de_depart(&self, rayon: &Rayon<R>) -> (Vecteur<R>, R) {
        self.plan_tangent(rayon, R::ZERO)
    }

    /// How high the point P of a hit may lie over the surface there, for what
    /// [`plan_tangent`](Self::plan_tangent) said of it. This definition is that of a flat face.
    #[inline(always)]
    fn hauteur(&self, p: Vecteur<R>, n: Vecteur<R>, du_centre: R) -> Hauteur<R> {
        // M2: the ball of a half-space has the centre O, so that CP is P.
        let cp = p - self.boule().centre;
        let hauteur = n.produit_scalaire(cp) - du_centre;
        Hauteur { b: hauteur.absolu(), l: n.somme_des_grandeurs(cp) }
    }

    /// Normal and margin of the entry at distance `t`, also where [`contact`](Self::contact) is not
    /// right: where the ray touches at once, or the normal leans away from the source. A call for
    /// the normal alone, before the margin, would make a single ray take up to 1.4 times as long
    /// (measured).
    fn contact_de_toute_sorte(&self, rayon: &Rayon<R>, t: R) -> Contact<R> {
        let (n, du_centre) =
            if t == R::ZERO { self.plan_de_depart(rayon) } else { self.plan_tangent(rayon, t) };
        let d = rayon.direction();
        let n = if n.produit_scalaire(d) < R::ZERO { n } else { vers_la_source(n, d) };
        self.contact_en(rayon, t, n, du_centre)
    }

    /// The contact with the normal as it is, without a branch; and whether that is right: the ray
    /// does not touch at once, and the normal faces the source.
    #[inline(always)]
    fn contact(&self, rayon: &Rayon<R>, t: R) -> (Contact<R>, bool) {
        let (n, du_centre) = self.plan_tangent(rayon, t);
        let de_face = (n.produit_scalaire(rayon.direction()) < R::ZERO) & (t != R::ZERO);
        (self.contact_en(rayon, t, n, du_centre), de_face)
    }

    /// The contact at this distance, with this normal. Its margin, the bound of
    /// [`marge`](crate::Intersection::marge), is that of the very point that the caller will
    /// compute.
    #[inline(always)]
    fn contact_en(&self, rayon: &Rayon<R>, t: R, normale: Vecteur<R>, du_centre: R) -> Contact<R> {
        let p = rayon.point(t);
        let Hauteur { b, l } = self.hauteur(p, normale, du_centre);
        let marge = b + l * fois_u(2.0 * ARRONDI_HAUTEUR);
        // M4: rounded up; a NaN, which comes from an overflow, becomes +∞.
        let marge = marge + marge * fois_u(VERS_LE_HAUT) + plancher();
        Contact { normale, marge: min(marge, R::INFINI), point: p }
    }
}

/// A bound on the height of a point P over a surface with normal N (lemma 8).
pub(crate) struct Hauteur<R> {
    /// P lies no farther from the surface than b, in units of N.
    pub(crate) b: R,
    /// ℓ: 8u·ℓ bounds the rounding of b and that of a search for a ray that starts at P.
    pub(crate) l: R,
}

/// The unit normal nearest to N that faces the source of a ray of direction D.
///
/// Where a ray only grazes, rounding can leave N at a right angle to D or past it. The normal is
/// then the part of N across D, leaned towards the source by more than N·D can round. Where nothing
/// is left of N, −D faces the source.
#[cold]
fn vers_la_source<R: Nombre>(n: Vecteur<R>, d: Vecteur<R>) -> Vecteur<R> {
    let unitaire = d / d.longueur(); // S8: D is unit to 7.6u only
    let travers = (n - unitaire * n.produit_scalaire(unitaire)).unitaire();
    let penchee = travers.and_then(|n| (n - unitaire * fois_u(PENCHE)).unitaire());
    penchee.filter(|n| n.produit_scalaire(d) < R::ZERO).unwrap_or(-unitaire)
}

/// A ball: its centre C and the square of its radius.
#[derive(Clone, Copy)]
pub(crate) struct Boule<R> {
    pub(crate) centre: Vecteur<R>,
    pub(crate) r2: R,
}

impl<R: Nombre> Boule<R> {
    /// The ball around an unbounded shape; its centre is O.
    pub(crate) const INFINIE: Self = Self { centre: Vecteur::NUL, r2: R::INFINI };

    /// Whether the ray comes near the ball.
    ///
    /// Never false for a ray that enters the shape, whatever rounding does (derivation in
    /// `docs/preuves/recherche.md`, lemma 14). A ray whose source is in the ball passes even with C
    /// behind it.
    #[inline(always)]
    pub(crate) fn approchee(self, rayon: &Rayon<R>) -> bool {
        let sc = self.centre - rayon.source();
        let sa = sc.produit_scalaire(rayon.direction());
        // C behind the source is no nearer than the source.
        let sa = max(sa, R::ZERO); // O1: it passes A only if A is ahead
        // One comparison (O2), which the compiler cannot split into two branches.
        sc.longueur_carree() * (R::UN - fois_u_simple(RETRAIT)) - sa * sa <= self.r2
    }
}
