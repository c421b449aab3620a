//! The clock. The competitors run in turns, and the least time of each counts, since other programs on a
//! shared machine only ever add to a time. What is timed is first checked to be right.

use std::error::Error;
use std::hint::black_box;
use std::time::{Duration, Instant};

use lancer_rayon::{
    LongueursDifferentes, NoIntersection, ObjetRay, Rayon, Reel, Touche, premiere_intersection,
};

/// Rays whose answers stay in the cache.
pub const MORCEAU: usize = 4096;

/// Rays of a tile.
pub const TUILE: usize = 64;

/// Turns, of which the least counts.
pub const TOURS: usize = 5;

/// Room for the answers to so many rays at a time.
pub fn tampon<R: Reel>(rayons: usize) -> Vec<Touche<R>> {
    vec![Err(NoIntersection); rayons]
}

/// Room for those of a part of the picture, used again for the next.
pub fn petit_tampon<R: Reel>() -> Vec<Touche<R>> {
    tampon(MORCEAU)
}

/// What the rays get one by one.
pub fn une_par_une<R: Reel>(objets: &[ObjetRay<R>], rayons: &[Rayon<R>]) -> Vec<Touche<R>> {
    rayons.iter().map(|rayon| premiere_intersection(objets, rayon)).collect()
}

/// An error unless `premieres` gives these rays `attendues`, however many it is given at a time.
pub fn exiger<R: Reel>(
    attendues: &[Touche<R>],
    rayons: &[Rayon<R>],
    premieres: impl Fn(&[Rayon<R>], &mut [Touche<R>]) -> Result<(), LongueursDifferentes>,
) -> Result<(), Box<dyn Error>> {
    for taille in [MORCEAU, rayons.len()] {
        let mut obtenues = tampon(rayons.len());
        for (rayons, touches) in rayons.chunks(taille).zip(obtenues.chunks_mut(taille)) {
            premieres(rayons, touches)?;
        }
        if obtenues != attendues {
            return Err("the batch differs from its rays one by one".into());
        }
    }
    Ok(())
}

/// Nanoseconds per ray, as many at a time as `tampon` has room for.
pub fn chronometrer_lot<Q: Copy, T>(
    rayons: &[Q],
    tampon: &mut [T],
    mut premieres: impl FnMut(&[Q], &mut [T]),
) -> f64 {
    // A copy made just before, as by someone who makes the rays of a tile when it is their turn.
    let mut frais = Vec::with_capacity(tampon.len());
    let mut duree = Duration::ZERO;
    for rayons in rayons.chunks(tampon.len()) {
        frais.clear();
        frais.extend_from_slice(rayons);
        let touches = &mut tampon[..rayons.len()];
        let debut = Instant::now();
        premieres(black_box(&frais), touches);
        duree += debut.elapsed();
        black_box(touches);
    }
    duree.as_nanos() as f64 / rayons.len() as f64
}

/// The least time of each, in so many turns.
pub fn moindres<Q>(tours: usize, concurrents: &[Q], mut duree: impl FnMut(&Q) -> f64) -> Vec<f64> {
    let mut durees = vec![f64::INFINITY; concurrents.len()];
    for _ in 0..tours {
        for (qui, moindre) in concurrents.iter().zip(&mut durees) {
            *moindre = moindre.min(duree(qui));
        }
    }
    durees
}

/// Nanoseconds in three digits or more; a dash for who did not run.
pub fn nanosecondes(ns: f64) -> String {
    match ns {
        _ if ns.is_nan() => "–".into(),
        _ if ns < 100.0 => format!("{ns:.1}"),
        _ => format!("{ns:.0}"),
    }
}
