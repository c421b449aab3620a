//! The boxes of an object in the tree: one, or for a long box that stands askew one for each of
//! several slices.
//!
//! The box along the axes of such an object is nearly all air; those of its slices have less. All
//! records carry the index of the object. A walk may ask it twice and finds the same t.

use crate::algebre::nombre::Nombre;
use crate::algebre::vecteur::Vecteur;
use crate::arbre::repere::Repere;
use crate::objet::ObjetRay;

/// How much surface one more record must save. The unit is the square of [the side of a
/// leaf](Repere::cote_sans_hasard) (`benches/seuils.md`, "Thresholds").
const PRIX_D_UNE_FICHE: f32 = 2e-3;

/// Shares out the records for which there is room beyond one for each object.
pub(crate) struct Partage<R> {
    repere: Repere<R>,
    prix: f32,
    /// How many records are left.
    restent: usize,
    /// The part that an object gets of the records that would save time.
    part: f32,
    /// What rounding has left over: an object gets whole records, and the fraction that it lost
    /// counts for the objects after it.
    du: f32,
}

impl<R: Nombre> Partage<R> {
    /// Shares this many records among these objects. `nombres` is room for a number of each.
    pub(crate) fn new(
        objets: &[ObjetRay<R>],
        repere: Repere<R>,
        restent: usize,
        nombres: &mut [f32],
    ) -> Self {
        let mut partage = Self { repere, prix: 0.0, restent, part: 0.0, du: 0.0 };
        if restent > 0 {
            let cote = repere.cote_sans_hasard(objets, nombres);
            partage.prix = PRIX_D_UNE_FICHE * cote * cote;
            let avec_boite = objets.iter().filter_map(|o| Some((o, o.boite_englobante()?.1)));
            let somme: f32 = avec_boite.map(|(objet, h)| partage.de_plus(objet, h)).sum();
            partage.part = if somme > 0.0 { (restent as f32 / somme).min(1.0) } else { 0.0 };
        }
        partage
    }

    /// How many pieces more than one save time: 0, or at least 1. The boxes of k pieces have the
    /// surface a/k + b + ck, and cost k times the price: the least is at k² = a/(c + price).
    fn de_plus(&self, objet: &ObjetRay<R>, h: Vecteur<R>) -> f32 {
        let axe = grandeurs(objet.demi_axe());
        let [a, c] = [axe, h - axe].map(|h| {
            let [x, y, z] = <[R; 3]>::from(h).map(|l| self.repere.distance(l));
            x * y + y * z + z * x
        });
        let k = (a / (c + self.prix)).sqrt();
        if k >= 2.0 { k - 1.0 } else { 0.0 }
    }

    /// Into how many pieces the next object of the list is cut.
    fn morceaux(&mut self, objet: &ObjetRay<R>, h: Vecteur<R>) -> usize {
        if self.part == 0.0 {
            return 1;
        }
        self.du += self.de_plus(objet, h) * self.part;
        let plus = (self.du as usize).min(self.restent);
        self.du -= plus as f32;
        self.restent -= plus;
        1 + plus
    }

    /// Passes on the boxes of the next object of the list, in the frame of the tree, and whether
    /// they are several; returns whether it has one. (With an iterator building took 1.17 times as
    /// long.)
    #[inline(always)]
    pub(crate) fn decouper(
        &mut self,
        objet: &ObjetRay<R>,
        mut recevoir: impl FnMut((Vecteur<f32>, Vecteur<f32>), bool),
    ) -> bool {
        let Some((c, h)) = objet.boite_englobante() else { return false };
        let morceaux = self.morceaux(objet, h);
        let k = R::depuis_f64(morceaux as f64);
        let pas = if morceaux > 1 { objet.demi_axe() / k } else { Vecteur::NUL };
        // Slices round more than a whole object does. Their slack is that of an object whose
        // half-extents are larger by `retrait` (lemma 20).
        let retrait = grandeurs(pas) * (k - R::UN);
        for i in 0..morceaux {
            let decalage = pas * (R::depuis_f64((2 * i + 1) as f64) - k);
            let boite = self.repere.boite_elargie((c, h + retrait), (decalage, h - retrait));
            recevoir(boite, morceaux > 1);
        }
        true
    }
}

/// The absolute values of its coordinates.
fn grandeurs<R: Nombre>(v: Vecteur<R>) -> Vecteur<R> {
    Vecteur::new(v.x.abs(), v.y.abs(), v.z.abs())
}
