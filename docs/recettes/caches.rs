//! Objects that are shown or hidden while a program runs.

use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

use lancer_rayon::{Monde, Rayon};

/// The objects that a ray touches first, as each is hidden after it was touched.
pub fn un_par_un(monde: Monde<'_>, rayon: &Rayon) -> Vec<usize> {
    let caches: Vec<_> = monde.objets().iter().map(|_| AtomicBool::new(false)).collect();
    let vue = monde.parmi(|indice| !caches[indice].load(Relaxed));
    let mut vus = vec![];
    while let Ok(touche) = vue.premiere_intersection(rayon) {
        caches[touche.indice()].store(true, Relaxed);
        vus.push(touche.indice());
    }
    vus
}
