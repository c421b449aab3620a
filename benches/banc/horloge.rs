//! The clock. The competitors run in turns, and the least time of each counts, since other programs on a
//! shared machine only ever add to a time.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// Rays whose answers stay in the cache.
pub const MORCEAU: usize = 4096;

/// Turns, of which the least counts.
pub const TOURS: usize = 5;

/// Nanoseconds per question, so many at a time.
pub fn chronometrer<Q: Copy>(questions: &[Q], mut repondre: impl FnMut(&[Q])) -> f64 {
    // A copy made just before, as by someone who makes the rays of a tile when it is their turn.
    let mut fraiches = Vec::with_capacity(MORCEAU);
    let mut duree = Duration::ZERO;
    for questions in questions.chunks(MORCEAU) {
        fraiches.clear();
        fraiches.extend_from_slice(questions);
        let debut = Instant::now();
        repondre(black_box(&fraiches));
        duree += debut.elapsed();
    }
    duree.as_nanos() as f64 / questions.len() as f64
}

/// The least time of each of so many, in so many turns, each with the stack elsewhere: within a page there are places
/// of it where single rays take 1.2 times as long.
pub fn moindres(tours: usize, combien: usize, mut duree: impl FnMut(usize) -> f64) -> Vec<f64> {
    let mut durees = vec![f64::INFINITY; combien];
    for tour in 0..tours {
        for (qui, moindre) in durees.iter_mut().enumerate() {
            *moindre = moindre.min(plus_bas(tour, &mut || duree(qui)));
        }
    }
    durees
}

/// Calls this so many frames farther down the stack.
#[inline(never)]
fn plus_bas(cadres: usize, f: &mut dyn FnMut() -> f64) -> f64 {
    // More than such a place is wide, and no divisor of a page.
    let cadre = black_box([0_u8; 720]);
    let resultat = if cadres == 0 { f() } else { plus_bas(cadres - 1, f) };
    black_box(&cadre);
    resultat
}
