//! A glance: when a ray enters an object, in plain `f64` (`docs/preuves.md`, lemma 18).
//!
//! The formulae are those of the shapes; lemmas 3 and 4 say how far their terms may be off. The
//! numbers of an `f32` scene are the same in `f64`, and `f64` tells them apart with ease.

use crate::algebre::double::Intervalle;
use crate::algebre::nombre::{Nombre, puissance_de_deux};
use crate::algebre::vecteur::Vecteur;
use crate::objet::ObjetRay;
use crate::objet::boite::BoiteRay;
use crate::objet::boite::dalle::{Quotient, echelle_vitesse};
use crate::objet::forme::Forme;
use crate::objet::plan::PlanRay;
use crate::objet::sphere::{SphereRay, Termes};
use crate::rayon::Rayon;

/// From what size on |CP|² − r² and AB² decide, in u of |f|² + r² (lemma 18).
pub const VUE_SPHERE: f64 = 19.0;

/// What the distance to a sphere is off by, in u·(t + r)·r/AB (lemma 18).
pub const VUE_DISTANCE: f64 = 20.0;

/// What the height over a half-space is off by, in u·⟨N, S⟩ (lemma 18).
pub const VUE_HAUTEUR: f64 = 3.1;

/// What a length of a box is off by, in u of the sums of |f_i| and of the half-lengths (lemma 18).
pub const VUE_LONGUEUR: f64 = 5.5;

/// What a speed towards a flat face is off by, in u (lemma 18).
pub const VUE_VITESSE: f64 = 3.2;

/// What a quotient and its factors round by, in u of itself (lemma 18).
pub const VUE_QUOTIENT: f64 = 5.5;

/// What an interval says of the entry of a ray.
impl Intervalle {
    /// The ray never enters.
    pub(crate) const JAMAIS: Self = Self { bas: f64::INFINI, haut: f64::INFINI };

    /// Whether and when the ray enters is unknown.
    pub(crate) const INCONNU: Self = Self { bas: 0.0, haut: f64::INFINI };

    /// Whether the ray enters before its end, if that is certain, and if so at a distance that is
    /// at most the largest number of a type: an entry beyond it is no hit there, and one in a wider
    /// type (C7).
    #[inline(always)]
    pub(crate) fn touche(self, fin: f64, plus_grand: f64) -> Option<bool> {
        // G4
        let touche = self.haut < fin && self.haut <= plus_grand;
        (touche || self.bas >= fin).then_some(touche)
    }
}

/// The distances between which the ray enters the object, if it does. The later one is +∞ unless it
/// certainly enters, and the earlier one if it certainly never does.
#[inline(always)]
pub fn coup_d_oeil(objet: &ObjetRay, rayon: &Rayon) -> Intervalle {
    match objet {
        ObjetRay::Sphere(sphere) => de_sphere(sphere, rayon),
        ObjetRay::Plan(plan) => de_plan(plan, rayon),
        ObjetRay::Boite(boite) => de_boite(boite, rayon),
    }
}

#[inline(always)]
fn de_sphere(sphere: &SphereRay, rayon: &Rayon) -> Intervalle {
    // G1
    let Termes { sa, puissance, ab2, sc2, r2, .. } = sphere.termes(rayon);
    let jeu = (sc2 + r2) * (VUE_SPHERE * f64::U);
    // Where S is certainly outside, SA has its sign or AC is beyond r.
    if puissance < -jeu || ab2 < -jeu || (puissance > jeu && sa < 0.0) {
        return Intervalle::JAMAIS;
    }
    if puissance > jeu && ab2 > jeu {
        let (t, r) = (sphere.t(rayon), sphere.rayon());
        let ecart = (t + r) * (r / ab2.sqrt()) * (VUE_DISTANCE * f64::U);
        return Intervalle { bas: t - ecart, haut: t + ecart };
    }
    Intervalle::INCONNU
}

#[inline(always)]
fn de_plan(plan: &PlanRay, rayon: &Rayon) -> Intervalle {
    // G2
    let (hauteur, descente) = plan.hauteur_et_descente(rayon);
    let poids = plan.normale().somme_des_grandeurs(rayon.source());
    let jeu = poids * (VUE_HAUTEUR * f64::U) + 4.0 * f64::MIN_POSITIF;
    // An exactly parallel ray is seen to be so.
    let jeu_v = plan.normale().somme_des_grandeurs(rayon.direction()) * (VUE_VITESSE * f64::U);
    let jeu_v = jeu_v + 4.0 * f64::MIN_POSITIF;
    let (lente, vite) = (descente - jeu_v, descente + jeu_v);
    if hauteur < -jeu || vite < 0.0 {
        return Intervalle::JAMAIS;
    }
    let au_moins = hauteur - jeu;
    if au_moins <= 0.0 {
        return Intervalle::INCONNU;
    }
    let tard = if lente > 0.0 { (hauteur + jeu) / lente * APRES } else { f64::INFINI };
    // Near the largest number a quotient may be rounded to +∞ that is none.
    let jamais = au_moins * puissance_de_deux(-10) / vite == f64::INFINI;
    let tot = au_moins / vite * AVANT;
    Intervalle { bas: if jamais { f64::INFINI } else { tot.min(f64::MAX) }, haut: tard }
}

/// The latest of the three entries, unless the first of the three exits comes before.
#[inline(always)]
fn de_boite(boite: &BoiteRay, rayon: &Rayon) -> Intervalle {
    // G3
    let longueurs = Vecteur::from(boite.demi_longueurs());
    let jeu = (rayon.source() - boite.centre()).norme_1() + longueurs.norme_1();
    let jeu = jeu * (VUE_LONGUEUR * f64::U);
    let mut entree = Intervalle { bas: -f64::INFINI, haut: -f64::INFINI };
    let mut sortie = Intervalle { bas: f64::INFINI, haut: f64::INFINI };
    for axe in 0..3 {
        let (Quotient { longueur: e, vitesse }, Quotient { longueur: s, .. }) =
            boite.dalle(axe, rayon);
        let vitesse = vitesse / echelle_vitesse::<f64>();
        let vite = 1.0 / (vitesse + VUE_VITESSE * f64::U);
        let (e, s) = if vitesse > VUE_VITESSE * f64::U {
            let lent = 1.0 / (vitesse - VUE_VITESSE * f64::U);
            (autour(e, jeu, lent, vite), autour(s, jeu, lent, vite))
        } else {
            // Which way the ray goes is unknown; it comes to neither face sooner than this.
            let sous = s.min(-e);
            let loin = (sous.abs() - jeu) * vite * AVANT;
            let partout = Intervalle { bas: -f64::INFINI, haut: f64::INFINI };
            if loin <= 0.0 {
                (partout, partout)
            } else if sous > 0.0 {
                (Intervalle { haut: -loin, ..partout }, Intervalle { bas: loin, ..partout })
            } else {
                (Intervalle { bas: loin, ..partout }, partout)
            }
        };
        entree = Intervalle { bas: entree.bas.max(e.bas), haut: entree.haut.max(e.haut) };
        sortie = sortie.moindre(s);
    }
    if entree.haut <= 0.0 || entree.bas > sortie.haut || sortie.haut < 0.0 {
        return Intervalle::JAMAIS;
    }
    let certaine = entree.bas > 0.0 && entree.haut <= sortie.bas;
    Intervalle { bas: entree.bas.max(0.0), haut: if certaine { entree.haut } else { f64::INFINI } }
}

/// A length that may be off by `jeu` over a speed between two, of which these are the inverses.
#[inline(always)]
fn autour(longueur: f64, jeu: f64, lent: f64, vite: f64) -> Intervalle {
    let (bas, haut) = (longueur - jeu, longueur + jeu);
    Intervalle {
        bas: bas * if bas > 0.0 { vite * AVANT } else { lent * APRES },
        haut: haut * if haut > 0.0 { lent * APRES } else { vite * AVANT },
    }
}

const AVANT: f64 = 1.0 - VUE_QUOTIENT * f64::U;
const APRES: f64 = 1.0 + VUE_QUOTIENT * f64::U;
