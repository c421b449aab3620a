//! How much rounding each property may see, in u (half a unit in the last place of 1), and why. A property derives
//! beside itself what it adds to these.

use lancer_rayon::Reel;

/// The length of a normal: within 6.1u of 1, and then 3u for measuring it in the same type.
pub const NORMALE_UNITAIRE: f64 = promesses::UNITAIRE_PLATE + 3.0;

/// Every element of R·Rᵀ − I, for a polished matrix (lemma 13).
pub const ORTHONORMALE: f64 = 5.5;

/// The same for the inverse of such a matrix, and for one that `depuis_matrice` keeps (lemmas 1 and 13).
pub const ORTHONORMALE_GARDEE: f64 = 12.0;

/// How far an element of a product of two rotations is from the product in f64 of what they hold, as observed; lemma 13
/// grants `COMPOSEE`.
pub const PRODUIT: f64 = 18.0;

/// How far M·Mᵀ may be from I for `depuis_matrice` to take M (C15).
pub const ECART_ROTATION: f64 = 1e-3;

/// u in f64.
pub fn u<R: Reel>() -> f64 {
    R::U.vers_f64()
}

/// The bands of the decisions, in u: within them rounding may answer a miss for a hit, or a hit for a
/// miss.
pub mod bandes {
    /// |SC| and |AC| of a sphere, relative to |f| + r (lemmas 3 and 5).
    pub const SPHERE: f64 = 4.0;
    /// The height of S over a half-space, relative to ⟨N, S⟩ (lemma 3).
    pub const PLAN: f64 = 3.1;
    /// What three products that underflow add to that height, in subnormals (lemma 3).
    pub const PLAN_ABSOLUE: f64 = 1.6;
    /// How far S is from a face of a box, relative to |f| + ρ (lemma 3).
    pub const BOITE_LONGUEUR: f64 = 7.1;
    /// The speed N·D towards a flat face (lemma 3).
    pub const VITESSE: f64 = 3.1;
}

/// What the table of `docs/precision.md` promises, in the unit named.
pub mod promesses {
    /// Distance to a sphere, in u·κt (lemma 5).
    pub const DISTANCE_SPHERE: f64 = 5.6;
    /// Distance to a sphere that is lost in its own distance, r < 64u|f| (lemma 5).
    pub const DISTANCE_PERDUE: f64 = 6.2;
    /// From this many u·|f| of radius on a sphere is not lost.
    pub const PERDUE: f64 = 64.0;
    /// Distance at which a ray leaves a sphere, in u·κt (lemma 10).
    pub const SORTIE_SPHERE: f64 = 5.7;
    /// Distance to a half-space, in u·κt (lemma 4).
    pub const DISTANCE_PLAN: f64 = 4.1;
    /// What underflowing products add to that distance, in subnormals over |N·D| (lemma 4).
    pub const PLAN_ABSOLU: f64 = 2.1;
    /// Distance to a box, in u·κt (lemma 4).
    pub const DISTANCE_BOITE: f64 = 5.3;
    /// ||D| − 1|, in u (lemma 1).
    pub const UNITAIRE_D: f64 = 7.6;
    /// ||N| − 1| of a half-space or a face, in u (lemma 1).
    pub const UNITAIRE_PLATE: f64 = 6.1;
    /// ||N| − 1| of a sphere, in u (lemma 1).
    pub const UNITAIRE_SPHERE: f64 = 3.6;
    /// How far above a half-space the point P of its hit may lie, in u·⟨N, S⟩, in u·t and in subnormals, with
    /// `LIEU_P`·u·|P| (lemma 6).
    pub const LIEU_PLAN_S: f64 = 3.1;
    pub const LIEU_PLAN_T: f64 = 6.1;
    pub const LIEU_PLAN_ABSOLU: f64 = 3.0;
    /// How far above the plane of any face of a box the point P of its hit may lie, in u·|f|, in u·t and in u·|P|
    /// (lemma 6).
    pub const LIEU_F: f64 = 4.1;
    pub const LIEU_T: f64 = 12.1;
    pub const LIEU_P: f64 = 1.1;
    /// The coordinates of a hit along a face of a box, in u(|f| + t)/l (lemma 6).
    pub const LIEU_FACE: f64 = 6.1;
    /// How far outside a sphere the point S + tD of its hit may lie, in u(|f| + r) (lemma 6).
    pub const LIEU_SPHERE: f64 = 13.0;
    /// The sine of the angle between the normal of a sphere and the true one, in u(1 + |f|/r), beside |Δt|·|D|/r
    /// (lemma 7).
    pub const DIRECTION: f64 = 4.1;
    /// The sine of the angle between a reflected direction and that of an exact mirror at the N of the hit, in u: for a
    /// flat face and for a sphere (lemma 9).
    pub const REFLECHI_PLAT: f64 = 20.0;
    pub const REFLECHI_SPHERE: f64 = 15.1;
    /// What is added where the reflected direction is turned outward, in u: `REDRESSE`, the sum and the quotient
    /// (lemma 9).
    pub const REFLECHI_REDRESSE: f64 = 14.0;
    /// The sine of the angle between a refracted direction and that of Snell's law at the N of the hit, in u(1 + n)
    /// over the cosine behind the surface. Where light may pass or not, how far the square of that cosine is from 0, in
    /// u(1 + n) times the cosine in front. Then the sine again for n = 1, in u (lemma 9).
    pub const REFRACTE: f64 = 10.3;
    pub const REFRACTE_TOTALE: f64 = 9.8;
    pub const TOUT_DROIT: f64 = 3.1;
    /// All in u (lemma 11): the distance of a lamp, relative to itself, its L, and its N·L; where a ray from one point
    /// to another ends, relative to the distance; and N·L towards a sun.
    pub const LAMPE_DISTANCE: f64 = 3.6;
    pub const LAMPE_DIRECTION: f64 = 4.6;
    pub const LAMPE_COSINUS: f64 = 8.0;
    pub const BOUT: f64 = 8.2;
    pub const SOLEIL: f64 = 10.7;
    /// How far under the plane of a hit a ray to it may start, in u of the distance, without being hidden (lemma 12).
    pub const SOUS_LE_PLAN: f64 = 1.9;
    /// A centre turned by M, in u·‖C‖₁, and the d of a half-space that is moved, in u·⟨N, T⟩ beside u·|d|; both with
    /// `PLAN_ABSOLUE` (lemma 11).
    pub const CENTRE_TOURNE: f64 = 3.1;
    pub const DISTANCE_DEPLACEE: f64 = 4.1;
    /// How far beyond the object its `etendue` reaches, in u of the sum of its half-extents and in u·‖C‖₁ (lemma 15).
    pub const ETENDUE_TAILLE: f64 = 87.0;
    pub const ETENDUE_CENTRE: f64 = 3.1;
    /// From how deep on, in r, a sphere that is touched at once may have a margin of +∞ (lemma 8).
    pub const D_EMBLEE_PERDUE: f64 = 0.22;
    /// An element of a rotation made of angles, of an axis or of a quaternion, in u of `f64` beside its rounding. Then
    /// one of a composition, in u, of two factors that `ORTHONORMALE` bounds, and of others (lemma 13).
    pub const TOUR: f64 = 15.0;
    pub const COMPOSEE: f64 = 24.0;
    pub const COMPOSEE_D_AUTRES: f64 = 39.0;
    /// In u, how exactly `entre` takes one direction to the other, how exactly `regard` meets its direction, and how
    /// exactly its x is at a right angle to `haut` (lemma 13).
    pub const ENTRE: f64 = 36.0;
    pub const REGARD: f64 = 6.2;
    pub const REGARD_DROIT: f64 = 14.0;
}

/// How deep S+tD, up to its hit, may lie in an object beyond how deep the source lies there: the table of lemma 22, which
/// `tests/precision/budget.rs` evaluates. Each row has what is in u·t, in u·⟨N, P⟩ and in u·r or u·Σl.
pub mod profondeurs {
    /// The source is outside.
    pub const D_UN_PLAN: [f64; 3] = [8.0, 3.0, 0.0];
    pub const D_UNE_BOITE: [f64; 3] = [9.1, 0.0, 4.0];
    /// Nearer than |f| = 2r, and from there on.
    pub const D_UNE_SPHERE: [f64; 3] = [2.0, 0.0, 23.5];
    pub const D_UNE_SPHERE_LOIN: [f64; 3] = [12.5, 0.0, 22.5];
    /// The source is inside.
    pub const DANS_UN_PLAN: [f64; 3] = [3.1, 0.0, 0.0];
    pub const DANS_UNE_SPHERE: [f64; 3] = [4.0, 0.0, 8.0];
    pub const DANS_UNE_BOITE: [f64; 3] = [3.1, 0.0, 26.0];
    pub const LIGNES: [[f64; 3]; 7] = [
        D_UN_PLAN,
        D_UNE_BOITE,
        D_UNE_SPHERE,
        D_UNE_SPHERE_LOIN,
        DANS_UN_PLAN,
        DANS_UNE_SPHERE,
        DANS_UNE_BOITE,
    ];
    /// What of the last is added but once in a chain, in u·Σl.
    pub const UNE_FOIS: f64 = 4.0;
}
