//! The nodes of a hierarchy, in the numbers that the caller lends.
//!
//! All boxes are numbers of `f32`, relative to the scene ([`Repere`]), whatever the scalar.
//!
//! Each object is first a record of seven numbers: its box and its index. Median cuts at multiples of 16^k,
//! each along the axis on which the centres lie farthest apart, sort the records until those of a leaf are
//! sixteen neighbours. Each leaf is then transposed into columns in place, and the nodes above follow, floor
//! by floor.

use crate::lot::colonnes::{max, min};
use crate::objet::ObjetRay;
use crate::reel::Reel;
use crate::vecteur::Vecteur;

/// Children of a node: as many as one loop tests side by side.
pub(crate) const ENFANTS: usize = 16;

/// Numbers of a record: the lower corner, the upper corner, the index.
const FICHE: usize = 7;

/// Numbers of a node.
pub(crate) const MOTS: usize = FICHE * ENFANTS;

/// Over fewer bounded objects than this no tree is made: one leaf would hold them, and the list is as fast
/// (`docs/performance.md`, "Thresholds").
const SEUIL_ARBRE: usize = ENFANTS + 1;

/// Of so many objects or more no tree is made: this index would have the bits of +∞ in `f32`.
const LIMITE_INDICES: u64 = 0x7f80_0000;

/// The farthest corner of a missing child.
const COIN_ABSENT: f32 = (1_u128 << 120) as f32;

/// From so far away the boxes of a scene cannot be told apart: the whole tree is asked.
pub(crate) const TROP_LOIN: f32 = (1_u128 << 100) as f32;

/// Floors of the largest tree: 16⁸ is more than [`LIMITE_INDICES`].
pub(crate) const ETAGES: usize = 8;

/// The box and the index of an object.
type Fiche = [f32; FICHE];

/// A number of each of sixteen children.
pub(crate) type Colonne = [f32; ENFANTS];

/// Sixteen children: the lower corners of their boxes, the upper corners, and in a leaf the indices of the
/// objects. Above the leaves the children are consecutive nodes, and the index of the
/// [first](premier_enfant) stands there.
///
/// A child that is missing has a box turned inside out ([`vide`]), which nothing enters.
pub(crate) type Noeud = [Colonne; FICHE];

/// A tree over a list of objects.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Arbre<'a, R> {
    /// The leaves, then the floors above. The columns of indices of the leaves hold the bounded objects
    /// first, then the half-spaces.
    pub(crate) noeuds: &'a [Noeud],
    /// How many nodes are leaves.
    pub(crate) feuilles: usize,
    pub(crate) racine: usize,
    /// How many objects there are, and how many of them are bounded.
    pub(crate) objets: usize,
    pub(crate) bornes: usize,
    pub(crate) repere: Repere<R>,
}

/// The frame of the tree, in which `f32` holds any scene: a point X of the scene stands at (X − K)·σ. No
/// coordinate of a box is beyond ±1, except for rounding and slack.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Repere<R> {
    /// K, the middle of the centres.
    milieu: Vecteur<R>,
    /// σ, what lengths are multiplied by.
    echelle: R,
}

impl<R: Reel> Arbre<'_, R> {
    /// The indices of the half-spaces.
    #[inline(always)]
    pub(crate) fn sans_bornes(&self) -> impl Iterator<Item = usize> + use<'_, R> {
        (self.bornes..self.objets).filter_map(|place| {
            let [.., indices] = self.noeuds.get(place / ENFANTS)?;
            Some(indice(indices[place % ENFANTS]))
        })
    }
}

/// How many nodes the tree of so many objects may have, whichever of them are half-spaces.
pub(crate) const fn noeuds(objets: usize) -> usize {
    if objets < SEUIL_ARBRE || objets as u64 >= LIMITE_INDICES {
        return 0;
    }
    let mut etage = objets.div_ceil(ENFANTS);
    let mut total = etage;
    while etage > 1 {
        etage = etage.div_ceil(ENFANTS);
        total += etage;
    }
    total
}

/// The tree over these objects, in the numbers of [so many nodes](noeuds); none over few that are bounded.
pub(crate) fn construire<'a, R: Reel>(
    objets: &[ObjetRay<R>],
    places: &'a mut [f32],
) -> Option<Arbre<'a, R>> {
    let repere = Repere::autour(objets);
    let (fiches, _) = places.as_chunks_mut();
    let (mut bornes, mut fin) = (0, objets.len());
    for (indice, objet) in objets.iter().enumerate() {
        let indice = nombre(indice);
        if let Some((bas, haut)) = boite_elargie(objet, repere) {
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
    let feuilles = objets.len().div_ceil(ENFANTS);
    for (numero, feuille) in noeuds[..feuilles].iter_mut().enumerate() {
        en_colonnes(feuille, bornes.saturating_sub(numero * ENFANTS));
    }
    // The floor whose nodes have none above them yet.
    let mut etage = 0..bornes.div_ceil(ENFANTS);
    let mut suivant = feuilles;
    while etage.len() > 1 {
        let premier = suivant;
        for debut in etage.clone().step_by(ENFANTS) {
            let (dessous, dessus) = noeuds.split_at_mut(suivant);
            dessus[0] = parent(&dessous[debut..etage.end.min(debut + ENFANTS)], debut);
            suivant += 1;
        }
        etage = premier..suivant;
    }
    let racine = etage.end - 1;
    Some(Arbre { noeuds, feuilles, racine, objets: objets.len(), bornes, repere })
}

impl<R: Reel> Repere<R> {
    /// The frame of these objects.
    fn autour(objets: &[ObjetRay<R>]) -> Self {
        let mut portee = R::ZERO;
        let centres = objets.iter().filter_map(|objet| {
            let (c, h) = objet.boite_englobante()?;
            portee = max(portee, h.norme_1());
            Some(c.into())
        });
        let (bas, haut) = extremes(centres);
        let (bas, haut) = (Vecteur::from(bas), Vecteur::from(haut));
        // K in the middle would need half of this. In the worst case rounding moves K to the last centre.
        let echelle = R::UN / ((haut - bas).norme_1() + portee * R::depuis_f64(2.0));
        Self { milieu: (bas + haut) * R::depuis_f64(0.5), echelle }
    }

    /// (X − K)·σ.
    #[inline(always)]
    pub(crate) fn point(self, x: Vecteur<R>) -> Vecteur<R> {
        (x - self.milieu) * self.echelle
    }

    /// A length times σ.
    #[inline(always)]
    pub(crate) fn longueur(self, l: R) -> R {
        l * self.echelle
    }

    /// A distance along a ray times σ, to 2u of `f32` down to its least normal number; +∞ beyond all numbers
    /// of that type.
    #[inline(always)]
    pub(crate) fn distance(self, t: R) -> f32 {
        simple(self.longueur(t))
    }
}

/// The nearest number of `f32`; ±∞ beyond them all.
#[inline(always)]
pub(crate) fn simple<R: Reel>(x: R) -> f32 {
    x.vers_f64() as f32
}

/// The nearest vector of such numbers.
#[inline(always)]
pub(crate) fn simples<R: Reel>(v: Vecteur<R>) -> Vecteur<f32> {
    Vecteur::depuis_f64(v.vers_f64())
}

/// An index below 2³¹ − 2²³, stored in a column of `f32` as the number with the same bits, which is finite.
fn nombre(indice: usize) -> f32 {
    f32::from_bits(indice as u32)
}

/// The index of which this is the [number](nombre).
#[inline(always)]
pub(crate) fn indice(nombre: f32) -> usize {
    nombre.to_bits() as usize
}

/// The least and the greatest coordinates of these points.
fn extremes<R: Reel>(points: impl Iterator<Item = [R; 3]>) -> ([R; 3], [R; 3]) {
    let (mut bas, mut haut) = ([au_dela::<R>(); 3], [-au_dela::<R>(); 3]);
    for point in points {
        for axe in 0..3 {
            bas[axe] = min(bas[axe], point[axe]);
            haut[axe] = max(haut[axe], point[axe]);
        }
    }
    (bas, haut)
}

/// Farther than any corner of a box.
fn au_dela<R: Reel>() -> R {
    R::LIMITE * R::LIMITE
}

/// The box around a bounded object, with the object's part of the [slack](jeu).
fn boite_elargie<R: Reel>(
    objet: &ObjetRay<R>,
    repere: Repere<R>,
) -> Option<(Vecteur<f32>, Vecteur<f32>)> {
    let (c, h) = objet.boite_englobante()?;
    let (c, h) = (repere.point(c), h * repere.echelle);
    // The proof needs ρ, the radius of the ball around the object; the sum of the half-extents is no less.
    let jeu = (c.norme_1() + h.norme_1()) * R::depuis_f64(jeu::<R>());
    let demi = h + Vecteur::new(jeu, jeu, jeu);
    Some((simples(c - demi), simples(c + demi)))
}

/// The slack for the point of a hit, in u of the scalar (lemma 15).
pub const JEU_TOUCHE: f64 = 70.0;

/// The slack for the rounding to `f32`, in u of `f32` (lemma 15).
pub const JEU_F32: f64 = 2.2;

/// The slack, by which boxes grow so that rounding loses no hit, per unit of distance from K to an object
/// or to the source of a ray. Derived in `docs/conception.md`, lemmas 14 to 17.
#[inline(always)]
pub(crate) fn jeu<R: Reel>() -> f64 {
    JEU_TOUCHE * R::U.vers_f64() + JEU_F32 * f64::from(f32::U)
}

/// Puts the records of each node, of every floor, side by side.
///
/// The recursion is at most 32 deep, four calls for each of eight floors: four halvings separate at most
/// sixteen blocks of 16^k records.
fn trier(fiches: &mut [Fiche]) {
    if fiches.len() <= ENFANTS {
        return;
    }
    let mut pas = ENFANTS;
    while fiches.len() > pas * ENFANTS {
        pas *= ENFANTS;
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
    let mut noeud = vide();
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
    let mut noeud = vide();
    for (enfant, dessous) in enfants.iter().enumerate() {
        for axe in 0..3 {
            noeud[axe][enfant] = dessous[axe].into_iter().fold(COIN_ABSENT, min);
            noeud[axe + 3][enfant] = dessous[axe + 3].into_iter().fold(-COIN_ABSENT, max);
        }
    }
    noeud[FICHE - 1][0] = nombre(premier);
    noeud
}

/// The index of the first child of a node above the leaves; the others follow.
#[inline(always)]
pub(crate) fn premier_enfant([.., indices]: &Noeud) -> usize {
    indice(indices[0])
}

/// A node without children: each box is turned inside out, its lower corner beyond everything and its upper
/// corner below. A ray would leave it before it enters it.
fn vide() -> Noeud {
    let (bas, haut) = ([COIN_ABSENT; ENFANTS], [-COIN_ABSENT; ENFANTS]);
    [bas, bas, bas, haut, haut, haut, [0.0; ENFANTS]]
}
