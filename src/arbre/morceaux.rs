//! The boxes of an object in the tree: one, or for a long box that stands askew one for each of
//! several slices.
//!
//! The box along the axes of such an object is nearly all air; those of its slices have less. All
//! records carry the index of the object. A walk may ask it twice and finds the same t, and a visit
//! shows it in the slice where the ray enters it.

use crate::algebre::nombre::{min, simple};
use crate::arbre::noeud::Fiche;
use crate::arbre::repere::Repere;
use crate::{Nombre, ObjetRay, Rayon, Vecteur};

/// How much surface one more record must save, where that of an object of the mean size is 1
/// (`DEVELOPING.md`, "Thresholds").
const PRIX_D_UNE_FICHE: f32 = 0.03;

/// Half of the least width of a slice in the frame of the tree that an object wishes for; rounded up
/// to whole slices, they are narrower by a third at most (lemma 21).
const DEMI_TRANCHE_MINIMALE: f32 = 1.0 / 65_536.0;

/// Into how many slices each object is cut. An object and its index tell it, so that no record
/// needs to.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Coupe {
    prix: f32,
    /// The part that an object gets of the records that would save time; 0 if none is cut.
    pub(crate) part: f32,
}

impl Coupe {
    /// Each object in one piece.
    pub(crate) const AUCUNE: Self = Self { prix: 0.0, part: 0.0 };

    /// Shares at most this many records among these objects, beyond one for each.
    pub(crate) fn new<R: Nombre>(
        objets: &[ObjetRay<R>],
        repere: Repere<R>,
        restent: usize,
    ) -> Self {
        let boites = objets.iter().filter_map(ObjetRay::boite_englobante);
        // A mean of roots, in which a sky or a ball for a ground counts for little.
        let tailles: f32 = boites.map(|(_, h)| repere.surface(h).racine()).sum();
        let taille = tailles / objets.len() as f32;
        let mut coupe = Self { prix: PRIX_D_UNE_FICHE * taille * taille, part: 0.0 };
        let souhaits: f32 = objets.iter().map(|objet| coupe.souhait(repere, objet)).sum();
        coupe.part = if souhaits > 0.0 { min(restent as f32 / souhaits, 1.0) } else { 0.0 };
        let de_plus = |coupe: Self, quoi| coupe.morceaux(repere, quoi) - 1;
        // Steps that grow, since the indices of a few long boxes may all round up.
        let mut moins = 0.01;
        while objets.iter().enumerate().map(|quoi| de_plus(coupe, quoi)).sum::<usize>() > restent {
            coupe.part *= 1.0 - moins;
            moins = min(2.0 * moins, 0.5);
        }
        coupe
    }

    /// How many pieces more than one save time: 0, or at least 1. The boxes of k pieces have the
    /// surface a/k + b + ck, and cost k times the price: the least is at k² = a/(c + price).
    fn souhait<R: Nombre>(self, repere: Repere<R>, objet: &ObjetRay<R>) -> f32 {
        let Some((_, h)) = objet.boite_englobante() else { return 0.0 };
        let axe = grandeurs(objet.demi_axe());
        let [a, c] = [axe, h - axe].map(|h| repere.surface(h));
        let k = (a / (c + self.prix)).racine();
        // 0/0, of a needle along an axis that has no surface in numbers of `f32`, stays a NaN.
        let k = min(repere.distance(axe.longueur()) / DEMI_TRANCHE_MINIMALE, k);
        if k >= 2.0 { k - 1.0 } else { 0.0 }
    }

    /// Into how many pieces the object at this index is cut: what it gets, rounded up for some and
    /// down for others, all over the list.
    pub(crate) fn morceaux<R: Nombre>(
        self,
        repere: Repere<R>,
        (indice, objet): (usize, &ObjetRay<R>),
    ) -> usize {
        // Multiples of the golden ratio, modulo 1.
        let arrondi = ((indice as u32).wrapping_mul(0x9e37_79b9) >> 8) as f32 / (1 << 24) as f32;
        1 + (self.souhait(repere, objet) * self.part + arrondi) as usize
    }

    /// Whether the ray enters this object, which has this index, at distance `t`, in the slice of
    /// this record: that in which the middle of its box lies (lemma 21).
    #[cold]
    #[inline(never)]
    pub(crate) fn est_ici<R: Nombre>(
        self,
        repere: Repere<R>,
        quoi @ (_, objet): (usize, &ObjetRay<R>),
        fiche: Fiche,
        rayon: &Rayon<R>,
        t: R,
    ) -> bool {
        let Some((c, _)) = objet.boite_englobante() else { return true };
        let (morceaux, axe) = (self.morceaux(repere, quoi), objet.demi_axe());
        // T5
        let tranche = |depuis_c: Vecteur<R>| {
            let place = depuis_c.produit_scalaire(axe) / axe.longueur_carree() + R::UN;
            let tranche = simple(place * R::depuis_f64(0.5 * morceaux as f64)) as usize;
            tranche.min(morceaux - 1)
        };
        let entree = (rayon.source() - c) + rayon.direction() * t;
        tranche(entree) == tranche(repere.vers_le_milieu(&fiche, c))
    }
}

/// Passes on the boxes of an object in so many pieces, in the frame of the tree; returns whether it
/// has one. (With an iterator building took 1.17 times as long.)
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
