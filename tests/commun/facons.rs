//! Every way to an answer, with every instruction set of the machine, beside each object asked alone: the list in a
//! batch, the tree ray by ray and in a batch, before an end, in order, by a visit, and the shadows of list and tree;
//! and which objects hold the sources and the points of hits.

use std::sync::atomic::{AtomicU32, Ordering};

use lancer_rayon::pour_les_tests::{Reglage, sonder};
use lancer_rayon::{
    Choix, Etendue, Monde, ObjetRay, Parmi, Rayon, Reel, Tous, Vecteur, places,
    premiere_intersection,
};

use crate::choisis::{BOUTS, Choisis, Vue, bout};
use crate::conversion::Bits;

/// The fewest objects that get a tree, which the test `places_dit_combien_de_places_suffisent` checks.
pub const UN_ARBRE: usize = 10;

/// Enough objects for a node with sixteen children, of which the probe of 64 rays may enter too many, and too many for
/// a block to ask all of them.
const BEAUCOUP: usize = 240;

/// Asks these rays every question in every way, of all objects and of a choice of them; returns how many rays hit
/// something. A list too short for a common walk of 64 rays to be given up is repeated until it is long enough, and
/// asked again.
#[track_caller]
pub fn comparer<R: Bits>(objets: &[ObjetRay<R>], rayons: &[Rayon<R>]) -> usize {
    let n = objets.len();
    // What the memory held before must not show through. The larger memory lets long boxes be cut into pieces.
    let [mut memoire, mut grande] = [1, 6].map(|fois| vec![f32::NAN; fois * places(n)]);
    let touches = comparer_dans(&Monde::new(objets, &mut memoire).unwrap(), rayons);
    let _ = Monde::en_morceaux(objets, &mut grande).unwrap();
    let prises = |memoire: &[f32]| memoire.iter().filter(|place| !place.is_nan()).count();
    // Otherwise it is the same tree.
    if prises(&grande) > prises(&memoire) {
        grande.fill(f32::NAN);
        comparer_dans(&Monde::en_morceaux(objets, &mut grande).unwrap(), rayons);
    }
    if (UN_ARBRE..BEAUCOUP).contains(&n) {
        comparer(&objets.repeat(BEAUCOUP.div_ceil(n)), rayons);
    }
    touches
}

/// The same for this very world.
#[track_caller]
pub fn comparer_dans<R: Bits>(monde: &Monde<'_, R>, rayons: &[Rayon<R>]) -> usize {
    let facons = [*monde, Monde::de_liste(monde.objets())];
    let toutes = comparer_les_facons(rayons, facons, |_| true);
    // The index left out varies, and now and then is that of no object.
    let touches: Vec<_> = toutes.iter().filter_map(|toutes| toutes.first()?.1.objet).collect();
    let sauf = rayons.len() % (monde.objets().len() + 1);
    let sauf = touches.get(sauf).copied().unwrap_or(sauf);
    // Most objects, chosen by no rule that a walk could follow.
    let plupart = |indice: usize| indice.wrapping_mul(0x9e37_79b9) >> 7 & 7 > 1;
    // Half of the time only one is left out.
    let seul = sauf % 2 == 0;
    let les_deux = |indice| indice != sauf && (seul || plupart(indice));
    let sauf_lui = facons.map(|facon| facon.sans(sauf));
    if seul {
        comparer_les_facons(rayons, sauf_lui, les_deux);
    } else {
        comparer_les_facons(rayons, sauf_lui.map(|facon| facon.parmi(&plupart)), les_deux);
    }
    touches.len()
}

/// A choice that counts what it is asked.
pub type Compteur<'a> = Parmi<Tous, &'a (dyn Fn(usize) -> bool + Sync)>;

/// How often this question asks for each object, which no answer shows, but a choice sees.
pub fn demandes<R: Reel>(
    monde: &Monde<'_, R>,
    question: impl FnOnce(Monde<'_, R, Compteur<'_>>),
) -> Vec<u32> {
    let demandes: Vec<_> = monde.objets().iter().map(|_| AtomicU32::new(0)).collect();
    let compter = |indice: usize| demandes[indice].fetch_add(1, Ordering::Relaxed) < u32::MAX;
    question(monde.parmi(&compter as &(dyn Fn(usize) -> bool + Sync)));
    demandes.into_iter().map(AtomicU32::into_inner).collect()
}

/// How many nodes the tree of this world has, which the probe of a ray amid the objects is tried on one by one; 0 if it
/// has none and asks its list, or if no probe tells its boxes apart.
pub fn noeuds<R: Reel>(monde: &Monde<'_, R>) -> usize {
    let milieux = monde
        .objets()
        .iter()
        .filter_map(ObjetRay::etendue)
        .map(|Etendue { bas, haut }| (bas + haut) / (R::UN + R::UN));
    let mut rayons = milieux.filter_map(|milieu| Rayon::new(milieu, Vecteur::X).ok());
    let nombre = |rayon| {
        let mut nombre = 0;
        sonder(monde, &[rayon], R::INFINI, |_, _| nombre += 1).map(|()| nombre)
    };
    rayons.find_map(nombre).unwrap_or(0)
}

/// Compares the answers of a world with a tree and of one without, in a batch and ray by ray, shadows included, with
/// those of the objects that both are to choose; returns the hits of these objects.
#[track_caller]
fn comparer_les_facons<R: Bits, C: Choix + Copy>(
    rayons: &[Rayon<R>],
    facons: [Monde<'_, R, C>; 2],
    prend: impl Fn(usize) -> bool,
) -> Vec<Vec<Vue<R>>> {
    let objets = facons[0].objets();
    let n = objets.len();
    let pris: Vec<_> = (0..n).filter(|indice| prend(*indice)).collect();
    let choisis = |monde, facon| Choisis { monde, pris: pris.clone(), facon };
    let toutes = choisis(facons[0], String::new()).toutes(rayons);
    // Asking one ray in every way takes long, so only a few rays are asked so.
    let pas = 1 + rayons.len() / 4;
    let quelques: Vec<_> = rayons.iter().step_by(pas).copied().collect();
    let de_quelques: Vec<_> = toutes.iter().step_by(pas).cloned().collect();
    let (zero, un) = (R::ZERO, R::UN);
    let nan = R::depuis_f64(f64::NAN);
    let mut limites = [R::INFINI, zero, R::ETA, un, -zero, -un, -R::INFINI, nan];
    limites.rotate_left(rayons.len() % 8);
    let jeux: Vec<_> = Reglage::tous().collect();
    for (numero, (nom, reglage)) in jeux.iter().enumerate() {
        for (facon, monde) in ["tree", "list"].into_iter().zip(facons) {
            let choisis = choisis(reglage.monde(monde), format!("{nom}, {facon}"));
            choisis.en_lot(rayons, &toutes, |i, _| rayons[i].fin());
            for (rayon, toutes) in rayons.iter().zip(&toutes) {
                choisis.premiere(rayon, toutes, choisis.monde.premiere_intersection(rayon));
                if pris.len() == n && facon == "list" && numero == 0 {
                    choisis.premiere(rayon, toutes, premiere_intersection(objets, rayon));
                }
            }
            choisis.un_par_un(&quelques, &de_quelques, &limites, rayons.len() as u8);
            // A choice changes nothing about ends, so one kind will do. The instruction set differs each time.
            let bouts = if pris.len() == n { 0..BOUTS } else { 1..2 };
            for genre in bouts.filter(|genre| (genre + rayons.len()) % jeux.len() == numero) {
                choisis.en_lot(rayons, &toutes, bout(genre));
            }
        }
    }
    toutes
}
