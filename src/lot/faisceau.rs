//! Culling: leaves out the objects that no ray of a block can enter, without asking every ray.
//!
//! An object that some ray could enter is never left out, rounding included. The bounds are derived
//! in `docs/conception.md`, lemmas 12 and 13, whose letters are those of this file.

use crate::forme::Boule;
use crate::lot::groupe::Groupe;
use crate::rayon::Rayon;
use crate::reel::{Reel, fois_u, max};
use crate::seize::{Colonne, SEIZE, le_plus_grand};
use crate::vecteur::Vecteur;

/// M is shorter than a direction by so many u of itself: then M·D ≤ 1 (lemma 12).
pub const COURT_M: f64 = 17.0;

/// The normals P are shorter than 1 by so many u (lemma 12).
pub const COURT: f64 = 4.9;

/// By so many u the slope e/μ is taken too large, above and below (lemma 12).
pub const PENTE: f64 = 7.5;

/// By so many u of itself the bound w on the origins is too large (lemma 12).
pub const ORIGINES: f64 = 5.5;

/// The rounding of h² and of the ball test, in u·|C − S₀|² (lemma 13).
pub const JEU_BOULE: f64 = 1300.0;

/// Running bounds over the rays of a block: distance from a reference origin S₀, spread around a
/// reference direction M.
///
/// Each quantity has sixteen maxima, one a lane: a single running maximum cannot be vectorised.
struct Etendue<R> {
    s0: Vecteur<R>,
    m: Vecteur<R>,
    /// U and V, across M and unit to rounding.
    axes: [Vecteur<R>; 2],
    /// The largest coordinate of S − S₀.
    ecarts: Colonne<R>,
    /// e: the largest D·U, −D·U, D·V and −D·V.
    e: [Colonne<R>; 4],
    /// −μ: the largest −D·M.
    moins_mu: Colonne<R>,
}

impl<R: Reel> Etendue<R> {
    /// The bounds of no rays yet. S₀ and M come from the ray in the middle. U points from the first
    /// ray to the eighth, along a row of pixels: any U is right, this one fits closely.
    #[inline(always)]
    fn vide(rayons: &[Rayon<R>]) -> Self {
        let milieu = rayons[rayons.len() / 2];
        let m = milieu.direction() * (R::UN - fois_u(COURT_M));
        let cote = rayons[7.min(rayons.len() - 1)].direction() - rayons[0].direction();
        let x = Vecteur::new(R::UN, R::ZERO, R::ZERO);
        let y = Vecteur::new(R::ZERO, R::UN, R::ZERO);
        let a = en_travers(cote, m).or_else(|| en_travers(x, m)).unwrap_or(y);
        Self {
            s0: milieu.source(),
            m,
            axes: [a, m.produit_vectoriel(a)],
            ecarts: [R::ZERO; SEIZE],
            // Not −∞: the proof needs e ≥ 0.
            e: [[R::ZERO; SEIZE]; 4],
            moins_mu: [-R::INFINI; SEIZE],
        }
    }

    #[inline(always)]
    fn ajouter(&mut self, groupe: &Groupe<R>) {
        let Self { s0, m, axes: [a, b], ecarts, e: [a1, a2, b1, b2], moins_mu } = self;
        for voie in 0..SEIZE {
            let rayon = groupe.rayon(voie);
            let (ecart, d) = (rayon.source() - *s0, rayon.direction());
            let ecart = max(max(ecart.x.abs(), ecart.y.abs()), ecart.z.abs());
            ecarts[voie] = max(ecarts[voie], ecart);
            let (da, db) = (d.produit_scalaire(*a), d.produit_scalaire(*b));
            a1[voie] = max(a1[voie], da);
            a2[voie] = max(a2[voie], -da);
            b1[voie] = max(b1[voie], db);
            b2[voie] = max(b2[voie], -db);
            moins_mu[voie] = max(moins_mu[voie], -d.produit_scalaire(*m));
        }
    }

    /// The beam of these rays; `None` if they go too far apart for one.
    #[inline(always)]
    fn faisceau(self) -> Option<Faisceau<R>> {
        let mu = -le_plus_grand(self.moins_mu);
        // The proof needs some room between the rays and the plane across M.
        if mu < R::depuis_f64(0.25) {
            return None;
        }
        let [a, b] = self.axes;
        let [a1, a2, b1, b2] = self.e.map(le_plus_grand);
        let [p1, p2, p3, p4] = [(a, a1), (-a, a2), (b, b1), (-b, b2)].map(|(axe, e)| {
            let p = axe - self.m * ((e + fois_u(PENTE)) / (mu - fois_u(PENTE)));
            p * ((R::UN - fois_u(COURT)) / p.longueur_carree().sqrt())
        });
        let largeur = ((a1 + a2) * (b1 + b2)).sqrt() / mu;
        let ecart = le_plus_grand(self.ecarts);
        let ecarts = Vecteur::new(ecart, ecart, ecart);
        Some(Faisceau {
            s0: self.s0,
            plans: [p1, p2, p3, p4, -self.m]
                .map(|p| (p, p.somme_des_grandeurs(ecarts) * (R::UN + fois_u(ORIGINES)))),
            ecart,
            largeur,
        })
    }
}

/// A pyramid that the rays of a block stay in: four sides, then a back. Each of these planes has an
/// outward normal P and a bound w, with P·D ≤ 0 and P·(S − S₀) ≤ w for every ray.
#[derive(Clone, Copy)]
pub(crate) struct Faisceau<R> {
    pub(crate) s0: Vecteur<R>,
    pub(crate) plans: [(Vecteur<R>, R); 5],
    /// The largest coordinate of any S − S₀.
    pub(crate) ecart: R,
    /// The side of its section one unit ahead.
    pub(crate) largeur: R,
}

impl<R: Reel> Faisceau<R> {
    /// The beam of these rays, which stand in these groups as well; `None` if they go too far apart
    /// for one.
    #[inline(always)]
    pub(crate) fn autour(rayons: &[Rayon<R>], groupes: &[Groupe<R>]) -> Option<Self> {
        let mut etendue = Etendue::vide(rayons);
        for groupe in groupes {
            etendue.ajouter(groupe);
        }
        etendue.faisceau()
    }

    /// −M and its w: the plane behind which no ray goes.
    #[inline(always)]
    pub(crate) fn dos(&self) -> (Vecteur<R>, R) {
        let [.., dos] = self.plans;
        dos
    }

    /// Two numbers: h², and the limit ρ² + 1300u·|C − S₀|². h is how far C lies beyond the farthest
    /// of the five planes, or 0. If h² is above the limit, the computed
    /// [`approchee`](Boule::approchee) is false for every ray of the beam.
    #[inline(always)]
    pub(crate) fn depassement_et_limite(&self, boule: Boule<R>) -> (R, R) {
        let sc = boule.centre - self.s0;
        let [h1, h2, h3, h4, h5] = self.plans.map(|(p, w)| p.produit_scalaire(sc) - w);
        let h = max(max(max(h1, h2), max(h3, h4)), max(h5, R::ZERO));
        (h * h, boule.r2 + sc.longueur_carree() * fois_u(JEU_BOULE))
    }
}

/// The unit vector of what `v` has across M; `None` if `v` lies along M, where what rounding leaves
/// does too.
#[inline(always)]
fn en_travers<R: Reel>(v: Vecteur<R>, m: Vecteur<R>) -> Option<Vecteur<R>> {
    let travers = (v - m * v.produit_scalaire(m)).unitaire()?;
    (travers.produit_scalaire(m).abs() < R::depuis_f64(0.5)).then_some(travers)
}
