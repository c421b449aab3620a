//! The tree over a list, built in the numbers that the caller lends.
//!
//! All boxes are numbers of `f32`, relative to the scene ([`Repere`]), whatever the scalar.
//!
//! Each object is first a record of seven numbers: its box and its index. Median cuts at multiples
//! of 16^k, each along the axis on which the centres lie farthest apart, sort the records until
//! those of a leaf are sixteen neighbours. Each leaf is then transposed into columns in place, and
//! the nodes above follow, floor by floor.

use crate::hierarchie::noeud::{
    COIN_ABSENT, FICHE, Fiche, LIMITE_INDICES, Noeud, VIDE, en_mot, indice_lu,
};
use crate::hierarchie::repere::{Repere, extremes};
use crate::objet::ObjetRay;
use crate::reel::{Reel, max, min};
use crate::seize::SEIZE;

/// Over fewer bounded objects than this no tree is made: one leaf would hold them, and the list is
/// as fast (`docs/performance.md`, "Thresholds").
const SEUIL_ARBRE: usize = SEIZE + 1;

/// A tree over a list of objects.
#[derive(Clone, Copy)]
pub(crate) struct Arbre<'a, R> {
    pub(crate) objets: &'a [ObjetRay<R>],
    /// The leaves, then the floors above. The columns of indices of the leaves hold the bounded
    /// objects first, then the half-spaces.
    pub(crate) noeuds: &'a [Noeud],
    /// How many nodes are leaves.
    pub(crate) feuilles: usize,
    pub(crate) racine: usize,
    /// How many of the objects are bounded.
    pub(crate) bornes: usize,
    pub(crate) repere: Repere<R>,
}

impl<R: Reel> Arbre<'_, R> {
    /// The indices of the half-spaces.
    #[inline(always)]
    pub(crate) fn sans_bornes(&self) -> impl Iterator<Item = usize> + use<'_, R> {
        (self.bornes..self.objets.len()).filter_map(|place| {
            let [.., indices] = self.noeuds.get(place / SEIZE)?;
            Some(indice_lu(indices[place % SEIZE]))
        })
    }
}

/// How many nodes the tree of so many objects may have, whichever of them are half-spaces.
pub(crate) const fn noeuds(objets: usize) -> usize {
    if objets < SEUIL_ARBRE || objets as u64 >= LIMITE_INDICES {
        return 0;
    }
    let mut etage = objets.div_ceil(SEIZE);
    let mut total = etage;
    while etage > 1 {
        etage = etage.div_ceil(SEIZE);
        total += etage;
    }
    total
}

/// The tree over these objects, in the numbers of [so many nodes](noeuds); none over few that are
/// bounded.
pub(crate) fn construire<'a, R: Reel>(
    objets: &'a [ObjetRay<R>],
    places: &'a mut [f32],
) -> Option<Arbre<'a, R>> {
    let repere = Repere::autour(objets);
    let (fiches, _) = places.as_chunks_mut();
    let (mut bornes, mut fin) = (0, objets.len());
    for (indice, objet) in objets.iter().enumerate() {
        let indice = en_mot(indice);
        if let Some((bas, haut)) = repere.boite_elargie(objet) {
            fiches[bornes] = [bas.x, bas.y, bas.z, haut.x, haut.y, haut.z, indice];
            bornes += 1;
        } else {
            fin -= 1;
            fiches[fin][FICHE - 1] = indice;
        }
    }
    if bornes < SEUIL_ARBRE {
        return None;
    }
    trier(&mut fiches[..bornes]);

    let (noeuds, _) = places.as_chunks_mut().0.as_chunks_mut();
    let feuilles = objets.len().div_ceil(SEIZE);
    for (numero, feuille) in noeuds[..feuilles].iter_mut().enumerate() {
        en_colonnes(feuille, bornes.saturating_sub(numero * SEIZE));
    }
    // The floor whose nodes have none above them yet.
    let mut etage = 0..bornes.div_ceil(SEIZE);
    let mut suivant = feuilles;
    while etage.len() > 1 {
        let premier = suivant;
        for debut in etage.clone().step_by(SEIZE) {
            let (dessous, dessus) = noeuds.split_at_mut(suivant);
            dessus[0] = parent(&dessous[debut..etage.end.min(debut + SEIZE)], debut);
            suivant += 1;
        }
        etage = premier..suivant;
    }
    let racine = etage.end - 1;
    Some(Arbre { objets, noeuds, feuilles, racine, bornes, repere })
}

/// Puts the records of each node, of every floor, side by side.
///
/// The recursion is at most 32 deep, four calls for each of eight floors: four halvings separate at
/// most sixteen blocks of 16^k records.
fn trier(fiches: &mut [Fiche]) {
    if fiches.len() <= SEIZE {
        return;
    }
    let mut pas = SEIZE;
    while fiches.len() > pas * SEIZE {
        pas *= SEIZE;
    }
    let coupe = fiches.len().div_ceil(pas) / 2 * pas;
    let (bas, haut) = extremes(fiches.iter().map(double_centre));
    let etendue: [f32; 3] = core::array::from_fn(|axe| haut[axe] - bas[axe]);
    let axe = (1..3).fold(0, |long, axe| if etendue[axe] > etendue[long] { axe } else { long });
    let centre = |fiche: &Fiche| double_centre(fiche)[axe];
    let _ = fiches.select_nth_unstable_by(coupe, |a, b| centre(a).total_cmp(&centre(b)));
    let (avant, apres) = fiches.split_at_mut(coupe);
    trier(avant);
    trier(apres);
}

/// Twice the centre of a box.
#[inline(always)]
fn double_centre(&[x0, y0, z0, x1, y1, z1, _]: &Fiche) -> [f32; 3] {
    [x0 + x1, y0 + y1, z0 + z1]
}

/// Transposes sixteen records into columns, in place; only the first `bornes` have a box.
fn en_colonnes(feuille: &mut Noeud, bornes: usize) {
    let mut noeud = VIDE;
    let (fiches, _) = feuille.as_flattened().as_chunks::<FICHE>();
    for (enfant, fiche) in fiches.iter().enumerate() {
        let mots = if enfant < bornes { 0..FICHE } else { FICHE - 1..FICHE };
        for mot in mots {
            noeud[mot][enfant] = fiche[mot];
        }
    }
    *feuille = noeud;
}

/// The node over at most sixteen others, the first of which has this index.
fn parent(enfants: &[Noeud], premier: usize) -> Noeud {
    let mut noeud = VIDE;
    for (enfant, dessous) in enfants.iter().enumerate() {
        for axe in 0..3 {
            noeud[axe][enfant] = dessous[axe].into_iter().fold(COIN_ABSENT, min);
            noeud[axe + 3][enfant] = dessous[axe + 3].into_iter().fold(-COIN_ABSENT, max);
        }
    }
    noeud[FICHE - 1][0] = en_mot(premier);
    noeud
}
