//! The beam of a block: a pyramid that all its rays stay in, by which a hierarchy leaves objects
//! out without asking every ray.
//!
//! No point of a ray lies outside, rounding included. The bounds are derived in `docs/preuves.md`,
//! lemma 19, whose letters are those of this file.

use crate::colonne::{Colonne, le_plus_grand, somme};
use crate::lot::groupe::{Groupe, VOIES};
use crate::nombre::{Nombre, fois_u, fois_u_simple, max, min};
use crate::rayon::Rayon;
use crate::vecteur::Vecteur;

/// How much shorter Ω is than a direction, in u of `f32` of itself: then Ω·D ≤ 1 (lemma 19).
pub const COURT_OMEGA: f64 = 17.0;

/// How much shorter than 1 the normals Π are, in u (lemma 19).
pub const COURT: f64 = 4.9;

/// How much too large the slope ξ/μ is taken, above and below, in u (lemma 19).
pub const PENTE: f64 = 7.5;

/// How much too large a bound w is taken, in u of the spread of the origins and of the longest
/// segment (lemma 19).
pub const ORIGINES: f64 = 10.6;

/// The steepest slope of a side of a beam of segments against Ω. Any limit is right; this one fits.
const PENTE_DES_SEGMENTS: f64 = 4.0;

/// A pyramid that the rays of a block stay in: four sides, then a back. Each of these planes has an
/// outward normal Π and a bound w on Π·(X − S₀) over the points X of all rays, or of the part of
/// each that counts.
pub(crate) struct Faisceau<R> {
    pub(crate) s0: Vecteur<R>,
    pub(crate) faces: [(Vecteur<R>, R); 5],
    /// Ω, a direction along which depths count, and a bound on Ω·(S − S₀).
    pub(crate) axe: (Vecteur<R>, R),
    /// q, the largest |coordinate| of any S − S₀.
    pub(crate) etalement: R,
    /// The longest segment; 0 for rays without an end.
    pub(crate) portee: R,
}

/// The least cosine between a ray of a beam and the one in the middle.
const COSINUS_MINIMAL: f64 = 0.25;

/// How many of at most eight of these rays, evenly spread, go too far from the way of the one in
/// the middle for a beam. Rays in no order are refused here, before a beam is made of them. Shadow
/// rays are tested as well, although their segments may lie together where their directions do not.
#[inline(always)]
pub(crate) fn vont_ailleurs<R: Nombre>(rayons: &[Rayon<R>]) -> usize {
    let milieu = rayons[rayons.len() / 2].direction();
    let quelques = rayons.iter().step_by(rayons.len() / 8 + 1);
    let minimal = R::depuis_f64(COSINUS_MINIMAL);
    quelques.filter(|rayon| rayon.direction().produit_scalaire(milieu) <= minimal).count()
}

/// A ray strays if its direction is this many times as far from that of all rays together as theirs
/// are in the mean, counted as 1 − cos: at most one of eight can (`benches/seuils.md`,
/// "Thresholds").
const FOIS_LA_MOYENNE: f64 = 8.0;

/// That mean counts as no less than this, which is more than rounding makes of parallel rays.
const MOYENNE_MINIMALE: f64 = 1.0 / 1024.0;

/// Which rays of these groups stray from the way of the others, one bit for each.
#[inline(always)]
pub(crate) fn egares<R: Nombre>(groupes: &[Groupe<R>]) -> u64 {
    let mut sommes = [[R::ZERO; VOIES]; 3];
    for groupe in groupes {
        for (sommes, directions) in sommes.iter_mut().zip(groupe.directions()) {
            for voie in 0..VOIES {
                sommes[voie] = sommes[voie] + directions[voie];
            }
        }
    }
    // The mean of the cosines to the sum is its length over the number of rays.
    let somme = Vecteur::from(sommes.map(somme));
    let longueur = somme.longueur();
    let moyenne = R::UN - longueur / R::depuis_f64((groupes.len() * VOIES) as f64);
    let moyenne = max(moyenne, R::depuis_f64(MOYENNE_MINIMALE));
    let moindre = R::UN - moyenne * R::depuis_f64(FOIS_LA_MOYENNE);
    let mut egares = 0;
    // Below −1 no ray strays.
    if moindre > -R::UN {
        for (i, groupe) in groupes.iter().enumerate() {
            for voie in 0..VOIES {
                let cosinus = groupe.rayon(voie).direction().produit_scalaire(somme);
                egares |= u64::from(cosinus < longueur * moindre) << (i * VOIES + voie);
            }
        }
    }
    egares
}

/// What a beam is built around: a reference origin S₀, a reference direction Ω, and U and V across
/// Ω.
///
/// S₀ and Ω come from the ray in the middle. U points from the first ray to the eighth, along a row
/// of pixels: any U is right, and this one fits closely.
#[inline(always)]
fn axes<R: Nombre>([depart, huitieme, milieu]: [Rayon<R>; 3]) -> [Vecteur<R>; 4] {
    let omega = milieu.direction() * (R::UN - fois_u_simple(COURT_OMEGA));
    // F1
    let cote = huitieme.direction() - depart.direction();
    let x = Vecteur::new(R::UN, R::ZERO, R::ZERO);
    let y = Vecteur::new(R::ZERO, R::UN, R::ZERO);
    let u = en_travers(cote, omega).or_else(|| en_travers(x, omega)).unwrap_or(y);
    [milieu.source(), omega, u, omega.produit_vectoriel(u)]
}

impl<R: Nombre> Faisceau<R> {
    /// The beam of the rays of these groups; three of them, the first, the eighth and the one in
    /// the middle, say where it goes. `None` if they go too far apart for one.
    #[inline(always)]
    pub(crate) fn de_rayons(groupes: &[Groupe<R>], reperes: [Rayon<R>; 3]) -> Option<Self> {
        let axes @ [s0, omega, u, v] = axes(reperes);
        let [u1, u2, v1, v2, moins_mu, etalement] = maxima(
            -R::INFINI,
            groupes,
            #[inline(always)]
            |rayon, _| {
                let (s, d) = (rayon.source() - s0, rayon.direction());
                let (du, dv) = (d.produit_scalaire(u), d.produit_scalaire(v));
                [du, -du, dv, -dv, -d.produit_scalaire(omega), plus_grande_coordonnee(s)]
            },
        );
        // The proof needs some room between the rays and the plane across Ω.
        if -moins_mu < R::depuis_f64(COSINUS_MINIMAL) {
            return None;
        }
        let mu = -moins_mu - fois_u(PENTE);
        // F2, and ξ ≥ 0.
        let pentes = [u1, u2, v1, v2].map(|xi| (max(xi, R::ZERO) + fois_u(PENTE)) / mu);
        Some(Self::de_pentes(groupes, axes, pentes, etalement, None))
    }

    /// The beam of the segments from the sources of these rays to the limits of their first
    /// objects: from surfaces to lamps. Its sides touch both ends.
    #[inline(always)]
    pub(crate) fn de_segments(groupes: &[Groupe<R>], reperes: [Rayon<R>; 3]) -> Self {
        let axes @ [s0, omega, u, v] = axes(reperes);
        let [s1, s2, s3, s4, l1, l2, l3, l4, profondeur, etalement, portee] = maxima(
            R::ZERO,
            groupes,
            #[inline(always)]
            |rayon, t| {
                let s = rayon.source() - s0;
                let l = s + rayon.direction() * t;
                let (su, sv) = (s.produit_scalaire(u), s.produit_scalaire(v));
                let (lu, lv) = (l.produit_scalaire(u), l.produit_scalaire(v));
                let profondeur = l.produit_scalaire(omega);
                [su, -su, sv, -sv, lu, -lu, lv, -lv, profondeur, plus_grande_coordonnee(s), t]
            },
        );
        let raide = R::depuis_f64(PENTE_DES_SEGMENTS);
        let pentes = [l1 - s1, l2 - s2, l3 - s3, l4 - s4]
            .map(|elargi| max(min(elargi / profondeur, raide), -raide));
        Self::de_pentes(groupes, axes, pentes, etalement, Some(portee))
    }

    /// The beam whose sides lean from U, −U, V and −V by these slopes against Ω, around segments of
    /// lengths up to `portee`, or without one around rays that no side faces.
    #[inline(always)]
    fn de_pentes(
        groupes: &[Groupe<R>],
        [s0, omega, u, v]: [Vecteur<R>; 4],
        [a1, a2, a3, a4]: [R; 4],
        etalement: R,
        portee: Option<R>,
    ) -> Self {
        let segments = portee.is_some();
        let [pi1, pi2, pi3, pi4] = [(u, a1), (-u, a2), (v, a3), (-v, a4)].map(|(axe, pente)| {
            // F3: a little shorter than 1.
            let pi = axe - omega * pente;
            pi * ((R::UN - fois_u(COURT)) / pi.longueur_carree().sqrt())
        });
        // F4. Rays of a camera have one source.
        let [w1, w2, w3, w4, arriere, avant] = if !segments && etalement == R::ZERO {
            [R::ZERO; 6]
        } else {
            maxima(
                R::ZERO,
                groupes,
                #[inline(always)]
                |rayon, t| {
                    let s = rayon.source() - s0;
                    let l = if segments { s + rayon.direction() * t } else { s };
                    let (w1, w2) = (plus_loin_le_long(pi1, s, l), plus_loin_le_long(pi2, s, l));
                    let (w3, w4) = (plus_loin_le_long(pi3, s, l), plus_loin_le_long(pi4, s, l));
                    [w1, w2, w3, w4, plus_loin_le_long(-omega, s, l), omega.produit_scalaire(s)]
                },
            )
        };
        let portee = portee.unwrap_or(R::ZERO);
        let jeu = (etalement + portee) * fois_u(ORIGINES);
        Self {
            s0,
            faces: [(pi1, w1), (pi2, w2), (pi3, w3), (pi4, w4), (-omega, arriere)]
                .map(|(pi, w)| (pi, w + jeu)),
            axe: (omega, avant + jeu),
            etalement,
            portee,
        }
    }
}

/// The largest of each of these numbers over the rays of these groups and the limits of their first
/// objects, or `depart` if that is larger. A caller whose ray in the middle gives a 0 passes 0.
///
/// Each has sixteen maxima, one per lane, since a single running maximum cannot be vectorised.
#[inline(always)]
fn maxima<R: Nombre, const N: usize>(
    depart: R,
    groupes: &[Groupe<R>],
    nombres: impl Fn(Rayon<R>, R) -> [R; N],
) -> [R; N] {
    let mut colonnes: [Colonne<R>; N] = [[depart; VOIES]; N];
    for groupe in groupes {
        for voie in 0..VOIES {
            let nombres = nombres(groupe.rayon(voie), groupe.premier(voie).t);
            for (colonne, nombre) in colonnes.iter_mut().zip(nombres) {
                colonne[voie] = max(colonne[voie], nombre);
            }
        }
    }
    colonnes.map(le_plus_grand)
}

/// How far along Π the farther end of a segment is.
#[inline(always)]
fn plus_loin_le_long<R: Nombre>(pi: Vecteur<R>, s: Vecteur<R>, l: Vecteur<R>) -> R {
    max(pi.produit_scalaire(s), pi.produit_scalaire(l))
}

#[inline(always)]
fn plus_grande_coordonnee<R: Nombre>(v: Vecteur<R>) -> R {
    max(max(v.x.abs(), v.y.abs()), v.z.abs())
}

/// The unit vector of what `v` has across Ω; `None` if `v` lies along Ω, where what rounding leaves
/// does too.
#[inline(always)]
fn en_travers<R: Nombre>(v: Vecteur<R>, omega: Vecteur<R>) -> Option<Vecteur<R>> {
    let travers = (v - omega * v.produit_scalaire(omega)).unitaire()?;
    (travers.produit_scalaire(omega).abs() < R::depuis_f64(0.5)).then_some(travers)
}
