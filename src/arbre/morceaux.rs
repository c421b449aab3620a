//! The boxes of an object in the tree: one, or for a long box that stands askew one for each of
//! several slices.
//!
//! The box along the axes of such an object is nearly all air; those of its slices have less. All
//! records carry the index of the object. A walk may ask it twice and finds the same t, and a visit
//! shows it in the slice where the ray enters it.

use crate::algebre::nombre::{max, min, puissance_de_deux, simple};
use crate::arbre::noeud::Noeud;
use crate::arbre::repere::Repere;
use crate::{Nombre, ObjetRay, Rayon, Vecteur};

/// How much surface one more record must save, where that of an object of the mean size is 1
/// (`DEVELOPING.md`, "Thresholds").
const PRIX_D_UNE_FICHE: f32 = 0.03;

/// Half of the least width of a slice, in the frame of the tree. Since the number of slices is
/// rounded, a slice may be narrower by up to a quarter (lemma 21).
const DEMI_TRANCHE_MINIMALE: f32 = puissance_de_deux(-16) as f32;

/// The most slices of an object: a ray along one that is cut asks it again in each.
const PIECES: f32 = 16.0;

/// What one more record costs, as surface in the frame of the tree. It tells of every object into
/// how many slices it is cut, so that no record needs to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Coupe {
    prix: f32,
}

impl Coupe {
    /// Each object in one piece.
    pub(crate) const AUCUNE: Self = Self { prix: f32::INFINITY };

    /// The least price from [`PRIX_D_UNE_FICHE`] on, nearly, at which these objects take at most
    /// this many records beyond one for each.
    pub(crate) fn new<R: Nombre>(
        objets: &[ObjetRay<R>],
        repere: Repere<R>,
        restent: usize,
    ) -> Self {
        let boites = objets.iter().filter_map(ObjetRay::boite_englobante);
        // A mean of roots, in which a sky or a ball for a ground counts for little.
        let tailles: f32 = boites.map(|(_, h)| repere.surface(h).racine()).sum();
        let taille = tailles / objets.len() as f32;
        // What has less surface than the least price is about as narrow as a slice may be.
        let prix_minimal = DEMI_TRANCHE_MINIMALE * DEMI_TRANCHE_MINIMALE;
        let prix = max(PRIX_D_UNE_FICHE * taille * taille, prix_minimal);
        let suffit = |prix| {
            let de_plus = |objet| Self { prix }.morceaux(repere, objet) - 1;
            objets.iter().map(de_plus).sum::<usize>() <= restent
        };
        if suffit(prix) {
            return Self { prix };
        }
        // No object has so much surface that it is cut at a price of 1.
        let (mut trop_bas, mut assez) = (prix, 1.0);
        // Twelve halvings leave the price half a percent open.
        for _ in 0..12 {
            let milieu = (trop_bas * assez).racine();
            if suffit(milieu) {
                assez = milieu;
            } else {
                trop_bas = milieu;
            }
        }
        Self { prix: assez }
    }

    /// Into how many pieces this object is cut. The boxes of k pieces have the surface a/k + b +
    /// ck, and cost k times the price: the least is at k² = a/(c + price).
    pub(crate) fn morceaux<R: Nombre>(self, repere: Repere<R>, objet: &ObjetRay<R>) -> usize {
        let Some((_, h)) = objet.boite_englobante() else { return 1 };
        let axe = grandeurs(objet.demi_axe());
        let [a, c] = [axe, h - axe].map(|h| repere.surface(h));
        let k = min(
            (a / (c + self.prix)).racine(),
            repere.distance(axe.longueur()) / DEMI_TRANCHE_MINIMALE,
        );
        max(min(k, PIECES) + 0.5, 1.0) as usize
    }

    /// Whether the ray enters this object at distance `t` in the slice of this child of a leaf:
    /// that in which the middle of its box lies (lemma 21).
    #[cold]
    #[inline(never)]
    pub(crate) fn est_ici<R: Nombre>(
        self,
        repere: Repere<R>,
        (feuille, enfant): (&Noeud, usize),
        objet: &ObjetRay<R>,
        rayon: &Rayon<R>,
        t: R,
    ) -> bool {
        let (morceaux, axe) = (self.morceaux(repere, objet), objet.demi_axe());
        let Some((c, _)) = objet.boite_englobante().filter(|_| morceaux > 1) else { return true };
        let tranche = |depuis_c: Vecteur<R>| {
            // T5: from 0 to 2 along the axis.
            let place = depuis_c.produit_scalaire(axe) / axe.longueur_carree() + R::UN;
            let tranche = simple(place * R::depuis_f64(0.5 * morceaux as f64)) as usize;
            tranche.min(morceaux - 1)
        };
        let entree = (rayon.source() - c) + rayon.direction() * t;
        let fiche = feuille.map(|colonne| colonne[enfant]);
        tranche(entree) == tranche(repere.vers_le_milieu(&fiche, c))
    }
}

/// Passes on the boxes of an object cut into `morceaux` pieces, in the frame of the tree; returns
/// whether it has one. With an iterator in its place building would take 1.17 times as long
/// (measured).
#[inline(always)]
pub(crate) fn decouper<R: Nombre>(
    objet: &ObjetRay<R>,
    morceaux: usize,
    repere: Repere<R>,
    mut recevoir: impl FnMut((Vecteur<f32>, Vecteur<f32>)),
) -> bool {
    let Some((c, h)) = objet.boite_englobante() else { return false };
    let k = R::depuis_f64(morceaux as f64);
    let pas = if morceaux > 1 { objet.demi_axe() / k } else { Vecteur::NUL };
    // Slices round more than a whole object does. Their slack is that of an object whose
    // half-extents are larger by `retrait` (lemma 20).
    let retrait = grandeurs(pas) * (k - R::UN);
    for i in 0..morceaux {
        let decalage = pas * (R::depuis_f64((2 * i + 1) as f64) - k);
        recevoir(repere.boite_elargie((c, h + retrait), (decalage, h - retrait)));
    }
    true
}

/// The absolute values of its coordinates.
fn grandeurs<R: Nombre>(v: Vecteur<R>) -> Vecteur<R> {
    Vecteur::new(v.x.absolu(), v.y.absolu(), v.z.absolu())
}
