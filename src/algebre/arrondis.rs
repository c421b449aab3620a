//! What rounding may take, as the proofs in `docs/preuves` count it: every constant that a lemma
//! grants, in the order of the lemmas. `tests/precision/besoins.txt` has what each lemma needs, and
//! a test refuses less.

/// A direction is kept if |D·D − 1| is at most this, in units of u: an ordinary normalisation
/// leaves 10 (lemma 1).
pub const DEJA_UNITAIRE: f64 = 12.0;

/// How orthonormal a matrix is that `Rotation::depuis_matrice` keeps, in u (lemma 1).
pub const DEJA_ORTHONORMALE: f64 = 8.0;

/// How far a normal that does not face the source is leaned towards it, in u (lemma 7).
pub const PENCHE: f64 = 14.0;

/// The rounding of a height over a surface, in u·ℓ; the next search sees that height with as much
/// rounding again (lemmas 8 and 9).
pub const ARRONDI_HAUTEUR: f64 = 4.0;

/// How much larger a margin is made, in u of itself: 6 for an N that is not exactly unit, the
/// others for the rounding of the last operations (lemma 8).
pub const VERS_LE_HAUT: f64 = 10.0;

/// A height is at most this times the difference of squares, over r (lemmas 8 and 9).
pub const PAR_RAYON: f64 = 0.6;

/// The length ℓ of a sphere, in r (lemmas 8 and 9).
pub const LONGUEUR: f64 = 1.3;

/// The limit of |CP² − r²|, in r². A sphere is lost in rounding beyond this limit, or either of the
/// next two (lemma 8).
pub const PUISSANCE_PERDUE: f64 = 0.4;

/// The limit of the square of the part of CP across N, in r².
pub const TRAVERS_PERDU: f64 = 0.0625;

/// The limit of the rounding of P, in r.
pub const ARRONDI_PERDU: f64 = 0.0625;

/// A direction is turned outward if it lies within this of the tangent plane, in u: no N·D rounds
/// by more (lemma 9).
pub const TANGENT: f64 = 3.2;

/// How far such a direction is turned, in u: N·D is then above 0, however it is rounded (lemma 9).
pub const REDRESSE: f64 = 12.0;

/// How much a margin grows for an N that is not exactly unit, in u of itself (lemma 9).
pub const PAS_NORMAL: f64 = 20.0;

/// The rounding of the moved point, in units of u·⟨N, P⟩ (lemma 9).
pub const PAS_ARRONDI: f64 = 1.1;

/// How much longer the outward step from a hit at once is, in δ. A shorter one keeps a chain in a
/// seam of mirrors for longer; a longer one makes δ grow faster. No proof needs it.
pub const PAS_D_EMBLEE: f64 = 1.0 / 64.0;

/// How much longer than that it is, in u·‖P‖₁: about as far as flush faces lie apart as they are
/// stored. No proof needs it.
pub const PAS_D_EMBLEE_POINT: f64 = 8.0;

/// The largest ratio of two indices of refraction. With one ten times as large rounding may turn
/// light that leaves an object in `f32` back into it (lemma 9).
pub const RAPPORT_MAXIMAL: f64 = 100.0;

/// How far from an edge a place stays, in u of ‖C‖₁ and Σl_i (lemma 10).
pub const BORD: f64 = 40.0;

/// How much SC² is reduced, in u of `f32` of itself and in both types, so that rounding hides no
/// entry from the ball (lemma 14): the numbers of a scene in `f64` may be those of one in `f32`.
pub const RETRAIT: f64 = 130.0;

/// How much larger the box around an object is made, in u of the sum of its half-extents (lemma
/// 15).
pub const ETENDUE: f64 = 44.0;

/// What a product rounds by, in u² of itself (lemma 16).
pub const PRODUIT_DOUBLE: f64 = 8.1;

/// What a product loses below the normal numbers, in η (lemma 16).
pub const PERTE_DOUBLE: f64 = 3.8;

/// How much a bound grows for its own rounding, in u of itself (lemma 16).
pub const BORNE_DOUBLE: f64 = 7.5;

/// How much a bound of `juger` grows, in u of itself: what it is off by, and the growing (lemma
/// 17).
pub const ECART_ARRONDI: f64 = 10.6;

/// How much the bound of `ObjetRay::erreur` grows for its last operations, in u of itself (lemma
/// 17).
pub const ERREUR_ARRONDIE: f64 = 16.1;

/// What the height of a point is off by at a glance, in u of |f| and of t (lemma 18).
pub const VUE_POINT: f64 = 7.1;

/// What it is off by besides, in u of the distance from the centre to the face (lemma 18).
pub const VUE_LONGUEUR: f64 = 2.1;

/// What the speed towards a flat face is off by at a glance, in u (lemma 18).
pub const VUE_VITESSE: f64 = 4.1;

/// What the power of a point as stored is off by at a glance, in u of both squares (lemma 18).
pub const VUE_PUISSANCE: f64 = 21.1;

/// The slack for the point of a hit, in u of the scene's type, per unit of distance from Z to an
/// object or to the source of a ray (lemma 20).
pub const JEU_DISTANCE: f64 = 37.0;

/// The slack for the point of a hit, in u of `f32`, per unit of an object's half-extents: its
/// normals may be unit to `f32` only (lemma 20).
pub const JEU_LARGEUR: f64 = 67.0;

/// The slack for the rounding to `f32`, in u of `f32`, per unit of distance from Z to a side of a
/// box or to where a ray starts (lemmas 20 and 21).
pub const JEU_F32: f64 = 7.5;

/// How much deeper than δ a hit may lie in another object, in u of the distance (lemma 22).
pub const FLOU_DISTANCE: f64 = 15.0;

/// How much deeper than that a hit may lie, in u of ‖P‖₁ (lemma 22).
pub const FLOU_POINT: f64 = 8.1;

/// How much larger δ is made, in u of itself: for its own roundings, those where it is compared,
/// and a step along an N that is not exactly unit (lemma 22).
pub const FLOU_RELATIF: f64 = 14.0;

/// How much deeper than δ a start may lie in a sphere or in a box, in u of the radius or of the sum
/// of the half-lengths (lemma 22).
pub const FLOU_PROPRE: f64 = 44.0;

/// A ray does not touch a box at once if its start lies, under a face that it leaves by or goes
/// along, less deep than δ and this many u of Σl_i. It is less than [`FLOU_PROPRE`], since the next
/// search sees that depth with the rounding of both (lemma 22).
pub const FLOU_A_COTE: f64 = 22.0;
