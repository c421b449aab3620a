//! A competitor, and how each is timed and asked.

use std::hint::black_box;

use crate::horloge::{MORCEAU, TOURS, chronometrer, moindres};

/// Beyond this many objects nobody looks at all of them for every ray.
pub const TROP: usize = 64;

/// Whose competitor it is, and how it asks, as tables tell them apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Camp {
    Seul,
    Lot,
    /// Us one by one, each ray with the hit that it leaves.
    Depuis,
    Parry,
    Embree,
    EmbreeSeize,
    Annexe,
}

/// Our four ways: the list one by one and in a batch, the tree one by one and in a batch.
pub const FACONS: [(&str, Camp); 4] =
    [("list", Camp::Seul), ("list-batch", Camp::Lot), ("single", Camp::Seul), ("batch", Camp::Lot)];

/// Those permitted among `objets` objects.
pub fn permises(objets: usize) -> &'static [(&'static str, Camp)] {
    if objets <= TROP { &FACONS } else { &FACONS[2..] }
}

/// An answer in a form common to all: distance, normal and margin of a hit as bits of an `f64`, and its texture, which
/// in these scenes tells each object. For a shadow, that something is in the way.
pub type Reponse = Option<([u64; 5], u32)>;

/// The answer to a shadow ray.
pub fn cachee(cache: bool) -> Reponse {
    cache.then_some(([0; 5], 0))
}

/// A competitor with a scene and the rays of one kind.
pub struct Concurrent<'a> {
    pub nom: &'static str,
    pub camp: Camp,
    /// The size of a call counts if many are taken at once.
    chronometrer: Box<dyn FnMut(usize) -> f64 + 'a>,
    repondre: Box<dyn Fn() -> Vec<Reponse> + 'a>,
}

impl<'a> Concurrent<'a> {
    /// One that takes one question after the other.
    pub fn un_par_un<Q: Copy, T>(
        (nom, camp): (&'static str, Camp),
        questions: &'a [Q],
        une: impl Fn(&Q) -> T + Clone + 'a,
        dire: impl Fn(T) -> Reponse + 'a,
    ) -> Self {
        let chronometree = une.clone();
        let toutes = move |questions: &[Q]| {
            for question in questions {
                // It goes by reference, since moving an answer would wait for each of its fields to be written.
                black_box(&chronometree(question));
            }
        };
        Self {
            nom,
            camp,
            chronometrer: Box::new(move |_| chronometrer(questions, &toutes)),
            repondre: Box::new(move || questions.iter().map(|q| dire(une(q))).collect()),
        }
    }

    /// One that takes many at once, into a buffer that is filled with `rien`.
    pub fn en_lot<Q: Copy, T: Clone + 'a>(
        (nom, camp): (&'static str, Camp),
        questions: &'a [Q],
        rien: T,
        lot: impl Fn(&[Q], &mut [T]) + Clone + 'a,
        dire: impl Fn(T) -> Reponse + 'a,
    ) -> Self {
        let (chronometre, vides) = (lot.clone(), vec![rien; MORCEAU]);
        let mut tampon = vides.clone();
        let repondre = move || {
            let lot = |questions: &[Q]| {
                let mut reponses = vides[..questions.len()].to_vec();
                lot(questions, &mut reponses);
                reponses
            };
            questions.chunks(MORCEAU).flat_map(lot).map(&dire).collect()
        };
        let chronometrer = move |appel| {
            chronometrer(questions, |questions| {
                for (questions, reponses) in questions.chunks(appel).zip(tampon.chunks_mut(appel)) {
                    let reponses = &mut reponses[..questions.len()];
                    chronometre(questions, reponses);
                    black_box(reponses);
                }
            })
        };
        Self { nom, camp, chronometrer: Box::new(chronometrer), repondre: Box::new(repondre) }
    }

    /// Nanoseconds per question, in calls of `appel`.
    pub fn chronometrer(&mut self, appel: usize) -> f64 {
        (self.chronometrer)(appel)
    }

    pub fn reponses(&self) -> Vec<Reponse> {
        (self.repondre)()
    }
}

/// Nanoseconds per question for each, taken in turns.
pub fn temps(concurrents: &mut [Concurrent<'_>]) -> Vec<f64> {
    moindres(TOURS, concurrents.len(), |i| concurrents[i].chronometrer(MORCEAU))
}
