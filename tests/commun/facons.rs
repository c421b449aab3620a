//! Every way to an answer, with every instruction set of the machine: the list in a batch, the tree ray by
//! ray and in a batch, before an end, in order and by a visit, shadows of both; each beside each object asked alone. And who
//! holds the sources and the points of hits.

use std::sync::atomic::{AtomicU32, Ordering};

use lancer_rayon::pour_les_tests::Reglage;
use lancer_rayon::{
    Choix, Monde, ObjetRay, Parmi, Rayon, Reel, Tous, places, premiere_intersection,
};

use crate::choisis::{BOUTS, Choisis, Vue, bout};
use crate::conversion::Bits;

/// The fewest objects that get a tree; `places_dit_combien_de_places_suffisent` holds it.
pub const UN_ARBRE: usize = 10;

/// So many that a node has sixteen children, of which the probe of 64 rays may enter too many, and that no block
/// asks all of them.
const BEAUCOUP: usize = 240;

/// Asks these rays every question in every way, of all objects and of a choice of them; how many touch
/// something. A list so short that no common walk of 64 rays would be given up is asked again, repeated until it is longer.
#[track_caller]
pub fn comparer<R: Bits>(objets: &[ObjetRay<R>], rayons: &[Rayon<R>]) -> usize {
    let n = objets.len();
    // What the memory held before must not show through. In the larger one long boxes are cut into pieces.
    let [mut memoire, mut grande] = [1, 6].map(|fois| vec![f32::NAN; fois * places(n)]);
    let monde = Monde::new(objets, &mut memoire).unwrap();
    let en_morceaux = Monde::en_morceaux(objets, &mut grande).unwrap();
    let touches = comparer_dans(&monde, rayons);
    // Else it is the same tree.
    if noeuds(&en_morceaux) > noeuds(&monde) {
        comparer_dans(&en_morceaux, rayons);
    }
    if (UN_ARBRE..BEAUCOUP).contains(&n) {
        comparer(&objets.repeat(BEAUCOUP.div_ceil(n)), rayons);
    }
    touches
}

/// The same of this very world.
#[track_caller]
pub fn comparer_dans<R: Bits>(monde: &Monde<'_, R>, rayons: &[Rayon<R>]) -> usize {
    let facons = [*monde, Monde::de_liste(monde.objets())];
    let toutes = comparer_les_facons(rayons, facons, |_| true);
    // Another one each time, and now and then one that is not there.
    let touches: Vec<_> = toutes.iter().filter_map(|toutes| toutes.first()?.1.objet).collect();
    let sauf = rayons.len() % (monde.objets().len() + 1);
    let sauf = touches.get(sauf).copied().unwrap_or(sauf);
    // And no more than some of these, by no rule that a walk could follow.
    let plupart = |indice: usize| indice.wrapping_mul(0x9e37_79b9) >> 7 & 7 > 1;
    // By turns one alone is left out.
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

/// How often this question asks for each object. No answer shows it; a choice is told.
pub fn demandes<R: Reel>(
    monde: &Monde<'_, R>,
    question: impl FnOnce(Monde<'_, R, Compteur<'_>>),
) -> Vec<u32> {
    let demandes: Vec<_> = monde.objets().iter().map(|_| AtomicU32::new(0)).collect();
    let compter = |indice: usize| demandes[indice].fetch_add(1, Ordering::Relaxed) < u32::MAX;
    question(monde.parmi(&compter as &(dyn Fn(usize) -> bool + Sync)));
    demandes.into_iter().map(AtomicU32::into_inner).collect()
}

/// How many nodes the tree of this world has, as it says itself; 0 if it has none and asks its list.
pub fn noeuds<R: Reel>(monde: &Monde<'_, R>) -> usize {
    let texte = format!("{monde:?}");
    let (_, nombre) = texte.split_once("noeuds: ").expect("the number of nodes");
    nombre.trim_end_matches(", .. }").parse().unwrap()
}

/// The answers of a world with a tree and of one without, in a batch and ray by ray, and of shadows, beside those of the
/// objects that both are to choose, whose hits it returns.
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
    // What one ray asks in every way takes long: of a few rays.
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
            // What is left out changes nothing of what ends are. Other instructions each time.
            let bouts = if pris.len() == n { 0..BOUTS } else { 1..2 };
            for genre in bouts.filter(|genre| (genre + rayons.len()) % jeux.len() == numero) {
                choisis.en_lot(rayons, &toutes, bout(genre));
            }
        }
    }
    toutes
}
