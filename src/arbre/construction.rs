//! The tree over a list, built in the numbers that the caller lends.
//!
//! All boxes are numbers of `f32`, relative to the scene ([`Repere`]), whatever the scalar.
//!
//! Each object is first a record of seven numbers: its box and its index; a long box that stands
//! askew has several records, one for each of its pieces (`morceaux.rs`). Median cuts at multiples
//! of 16^k, each along the axis on which the centres lie farthest apart, sort the records until
//! those of a leaf are sixteen neighbours. Each leaf is then transposed into columns in place, and
//! the nodes above follow, floor by floor.

use core::{fmt, mem};

use crate::algebre::nombre::{max, min, simple};
use crate::arbre::Arbre;
use crate::arbre::morceaux::{Coupe, decouper};
use crate::arbre::noeud::{
    COIN_ABSENT, ENFANTS, FICHE, Fiche, LIMITE_INDICES, Noeud, VIDE, en_mot,
};
use crate::arbre::repere::{JEU_MAXIMAL, Repere, double_centre, extremes};
use crate::{Nombre, ObjetRay, Vecteur};

/// No tree is made over fewer objects with a box than this, since the list is about as fast
/// (`DEVELOPING.md`, "Thresholds").
const OBJETS_D_UN_ARBRE: usize = 10;

/// Bytes of a cache line: nodes start on one (`DEVELOPING.md`, "Thresholds").
const LIGNE: usize = 64;

/// The most `f32` that are skipped at the start of what the caller lends, so that nodes start on a
/// line.
const BOURRAGE: usize = LIGNE / size_of::<f32>() - 1;

/// How many `f32` [`Monde::new`](crate::Monde::new) needs to be lent for this many objects, in
/// either scalar: where there are many objects, 7.5 for each, which is 30 bytes.
///
/// The numbers are scratch memory, free again after the last question. The count is 0 for fewer
/// than 10 objects, and for 2³¹ − 2²³ or more: lists of that length get no tree, and neither does a
/// list with fewer than 10 spheres and boxes.
#[doc(alias("capacity", "memory"))]
#[must_use]
pub const fn places(objets: usize) -> usize {
    // They suffice whichever objects have no box. An object without one needs one number, less than
    // its share of a leaf, except for the first fifteen.
    if objets < OBJETS_D_UN_ARBRE || objets as u64 >= LIMITE_INDICES {
        return 0;
    }
    let mut etage = objets.div_ceil(ENFANTS);
    let mut total = etage;
    while etage > 1 {
        etage = etage.div_ceil(ENFANTS);
        total += etage;
    }
    // If the root is full, another stands above it and the giants.
    if total > 1 {
        total += 1;
    }
    // Where this saturates, on a 32-bit machine, it is more than there is memory.
    total.saturating_mul(FICHE * ENFANTS).saturating_add(ENFANTS - 1 + BOURRAGE)
}

/// How many records there is room for in this many numbers, beyond one for each of these objects.
fn fiches_de_plus(objets: usize, nombres: usize) -> usize {
    let le_plus = LIMITE_INDICES as usize - 1 - objets;
    let mut plus = (nombres.saturating_sub(places(objets)) / FICHE).min(le_plus);
    // The nodes above the leaves take the place of about one in sixteen.
    while places(objets + plus) > nombres {
        plus = plus * 15 / 16;
    }
    plus
}

/// The tree over these objects, in as many numbers as [`places`] says or more; one without nodes over
/// few that have a box. The numbers beyond pay for pieces of long boxes.
pub(crate) fn construire<'a, R: Nombre>(
    objets: &[ObjetRay<R>],
    memoire: &'a mut [f32],
) -> Result<Arbre<'a, R>, PlacesInsuffisantes> {
    let necessaires = places(objets.len());
    if memoire.len() < necessaires {
        return Err(PlacesInsuffisantes { places: memoire.len(), necessaires });
    }
    if necessaires == 0 {
        return Ok(Arbre::SANS_NOEUDS);
    }
    let plus = fiches_de_plus(objets.len(), memoire.len());
    let debut = memoire.as_ptr().align_offset(LIGNE).min(BOURRAGE);
    let memoire = &mut memoire[debut..];
    let mut repere = Repere::autour(objets);
    let coupe = if plus > 0 { Coupe::new(objets, repere, plus) } else { Coupe::AUCUNE };
    let (nombre, fin) = remplir(objets, memoire, repere, coupe);
    let (memoire, sans_boite) = memoire.split_at_mut(fin);
    // Where nothing was cut, a visit need not ask in which slice.
    let coupe = if nombre + sans_boite.len() == objets.len() { Coupe::AUCUNE } else { coupe };
    if objets.len() - sans_boite.len() < OBJETS_D_UN_ARBRE {
        return Ok(Arbre::SANS_NOEUDS);
    }
    let (fiches, _) = memoire.as_chunks_mut();
    let geants = trier_les_geants(&mut fiches[..nombre], repere);
    let autres = &mut fiches[geants * ENFANTS..nombre];
    let [bas, haut] = extremes(autres.iter().map(double_centre));
    repere.jeu_maximal = JEU_MAXIMAL * 0.5 * (haut - bas).norme_1();
    trier(autres);
    let (noeuds, _) = memoire.as_chunks_mut().0.as_chunks_mut();
    let feuilles = nombre.div_ceil(ENFANTS);
    for (numero, feuille) in noeuds[..feuilles].iter_mut().enumerate() {
        let (fiches, _) = feuille.as_flattened().as_chunks();
        *feuille = en_colonnes(fiches.iter().take(nombre - numero * ENFANTS));
    }
    let racine = etager(noeuds, geants, feuilles);
    let noeuds = &noeuds[..=racine];
    Ok(Arbre { noeuds, feuilles, sans_boite, repere, coupe })
}

/// Writes the records of these objects from the front, and from the back the indices of those
/// without a box; tells how many records there are, and where those indices begin.
fn remplir<R: Nombre>(
    objets: &[ObjetRay<R>],
    memoire: &mut [f32],
    repere: Repere<R>,
    coupe: Coupe,
) -> (usize, usize) {
    let (mut nombre, mut fin) = (0, memoire.len());
    for (indice, objet) in objets.iter().enumerate() {
        let (fiches, _) = memoire.as_chunks_mut();
        let morceaux = if coupe == Coupe::AUCUNE { 1 } else { coupe.morceaux(repere, objet) };
        let a_une_boite = decouper(objet, morceaux, repere, |(bas, haut)| {
            fiches[nombre] = [bas.x, bas.y, bas.z, haut.x, haut.y, haut.z, en_mot(indice)];
            nombre += 1;
        });
        if !a_une_boite {
            fin -= 1;
            memoire[fin] = en_mot(indice);
        }
    }
    (nombre, fin)
}

/// Makes the nodes above these leaves, of which the first `geants` hold giants; returns the last,
/// the root.
fn etager(noeuds: &mut [Noeud], geants: usize, feuilles: usize) -> usize {
    // The floor whose nodes have none above them yet, and the leaves of giants, which the root
    // takes along.
    let (mut etage, mut a_part) = (geants..feuilles, geants);
    while etage.len() + a_part > 1 {
        let mut suivant = etage.end;
        for debut in etage.clone().step_by(ENFANTS) {
            let (dessous, dessus) = noeuds.split_at_mut(suivant);
            let enfants = debut..etage.end.min(debut + ENFANTS);
            let la_racine = enfants.len() == etage.len() && enfants.len() + a_part <= ENFANTS;
            let geants = if la_racine { 0..mem::take(&mut a_part) } else { 0..0 };
            dessus[0] = parent(dessous, geants.chain(enfants));
            suivant += 1;
        }
        etage = etage.end..suivant;
    }
    etage.start
}

/// The sixteen largest objects are giants if their mean [reach](portee) is more than this part of a
/// sum: the mean reach of the others and [the side of a leaf](Repere::cote_d_une_feuille)
/// (`DEVELOPING.md`, "Thresholds").
const TAILLE_DES_GEANTS: f32 = 0.4;

/// Puts the sixteen largest records first, and tells how many leaves they are: 1 if they are
/// giants, else 0. Giants are floors and walls, whose centres say little of where they are, a sky,
/// or a ball for a ground; a sun is one because it is far away.
fn trier_les_geants<R: Nombre>(fiches: &mut [Fiche], repere: Repere<R>) -> usize {
    if fiches.len() <= ENFANTS {
        return 0;
    }
    let (cote, loin) = (repere.cote_d_une_feuille(fiches.len()), simple(repere.loin));
    let portee = |fiche: &Fiche| portee(fiche, loin);
    let moyenne = |fiches: &[Fiche]| fiches.iter().map(portee).sum::<f32>() / fiches.len() as f32;
    let _ = fiches.select_nth_unstable_by(ENFANTS, |a, b| portee(b).total_cmp(&portee(a)));
    let (grands, petits) = fiches.split_at(ENFANTS);
    usize::from(moyenne(grands) > TAILLE_DES_GEANTS * (moyenne(petits) + cote))
}

/// The sum of the sides of a box, and by how much its centre is farther from Z than `loin`.
fn portee(fiche @ &[x0, y0, z0, x1, y1, z1, _]: &Fiche, loin: f32) -> f32 {
    let au_dela = 0.5 * Vecteur::from(double_centre(fiche)).norme_1() - loin;
    (x1 - x0) + (y1 - y0) + (z1 - z0) + max(au_dela, 0.0)
}

/// Puts the records of each node, of every floor, side by side.
///
/// The recursion is at most 32 deep, four calls for each of eight floors: four halvings separate at
/// most sixteen blocks of 16^k records.
fn trier(fiches: &mut [Fiche]) {
    if fiches.len() <= ENFANTS {
        return;
    }
    let pas = ENFANTS.pow((fiches.len() - 1).ilog(ENFANTS));
    let mediane = fiches.len().div_ceil(pas) / 2 * pas;
    let [bas, haut] = extremes(fiches.iter().map(double_centre));
    let etendue: [f32; 3] = (haut - bas).into();
    let axe = (1..3).fold(0, |long, axe| if etendue[axe] > etendue[long] { axe } else { long });
    let centre = |fiche: &Fiche| double_centre(fiche)[axe];
    let _ = fiches.select_nth_unstable_by(mediane, |a, b| centre(a).total_cmp(&centre(b)));
    let (avant, apres) = fiches.split_at_mut(mediane);
    trier(avant);
    trier(apres);
}

/// These records, sixteen at most, as columns.
fn en_colonnes<'a>(fiches: impl Iterator<Item = &'a Fiche>) -> Noeud {
    let mut noeud = VIDE;
    for (enfant, fiche) in fiches.enumerate() {
        for mot in 0..FICHE {
            noeud[mot][enfant] = fiche[mot];
        }
    }
    noeud
}

/// The node over the nodes with these numbers, at most sixteen.
fn parent(noeuds: &[Noeud], enfants: impl Iterator<Item = usize>) -> Noeud {
    let mut noeud = VIDE;
    for (enfant, numero) in enfants.enumerate() {
        let dessous = &noeuds[numero];
        for axe in 0..3 {
            noeud[axe][enfant] = dessous[axe].into_iter().fold(COIN_ABSENT, min);
            noeud[axe + 3][enfant] = dessous[axe + 3].into_iter().fold(-COIN_ABSENT, max);
        }
        noeud[FICHE - 1][enfant] = en_mot(numero);
    }
    noeud
}

/// Fewer places were lent than the [`Monde`](crate::Monde) over this many objects needs.
#[doc(alias = "buffer_too_small")]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct PlacesInsuffisantes {
    /// How many places were lent.
    pub places: usize,
    /// How many places are needed: [`places`](crate::places).
    #[doc(alias = "required")]
    pub necessaires: usize,
}

impl fmt::Display for PlacesInsuffisantes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} places lent, but {} needed", self.places, self.necessaires)
    }
}

impl core::error::Error for PlacesInsuffisantes {}
