//! The clock. Competitors run in turns, and the least time of each counts, since other programs on a shared machine can
//! only add to a time.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// How many rays' answers stay in the cache.
pub const MORCEAU: usize = 4096;

/// How many turns; the least counts.
pub const TOURS: usize = 5;

/// Nanoseconds per question, `MORCEAU` at a time.
pub fn chronometrer<Q: Copy>(questions: &[Q], mut repondre: impl FnMut(&[Q])) -> f64 {
    // The copy is made just before, as by someone who makes the rays of a tile when it is their turn.
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

/// The least time of each of `combien`, in `tours` turns, each with the stack elsewhere, since at some places within a
/// page single rays take 1.2 times as long.
pub fn moindres(tours: usize, combien: usize, mut duree: impl FnMut(usize) -> f64) -> Vec<f64> {
    let mut durees = vec![f64::INFINITY; combien];
    for tour in 0..tours {
        for (qui, moindre) in durees.iter_mut().enumerate() {
            *moindre = moindre.min(plus_bas(tour, &mut || duree(qui)));
        }
    }
    durees
}

/// Calls `f` with `cadres` more frames on the stack.
#[inline(never)]
fn plus_bas(cadres: usize, f: &mut dyn FnMut() -> f64) -> f64 {
    // A frame is wider than such a place, and no divisor of a page.
    let cadre = black_box([0_u8; 720]);
    let resultat = if cadres == 0 { f() } else { plus_bas(cadres - 1, f) };
    black_box(&cadre);
    resultat
}
