//! Someone who competes, and how anyone is asked: some thousands of rays into a buffer of their own, and each answer
//! with its normal.

use std::hint::black_box;

use lancer_rayon::{NoIntersection, Rayon, Reel, Touche};

use crate::pairs::Vu;
use commun::horloge::MORCEAU;

/// On whose side, and how: all that a table tells apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Camp {
    Seul,
    Lot,
    Parry,
    Embree,
    EmbreeSeize,
    Annexe,
}

pub(crate) type Premieres<'a, R> = dyn FnMut(&[Rayon<R>], Option<&mut Vec<Option<Vu<R>>>>) + 'a;
pub(crate) type Ombres<'a, R> = dyn FnMut(&[Rayon<R>], &[R], &mut [bool]) + 'a;

/// Someone with a scene.
pub(crate) struct Concurrent<'a, R> {
    pub(crate) nom: &'static str,
    pub(crate) camp: Camp,
    /// How many objects it looks at for every ray, if it looks at all of them.
    pub(crate) chaque: Option<usize>,
    /// Asks for the first hits, and adds them to a list if there is one.
    pub(crate) premieres: Box<Premieres<'a, R>>,
    pub(crate) ombres: Option<Box<Ombres<'a, R>>>,
}

/// An answer, in the words of all.
pub(crate) trait Reponse<R>: Copy {
    const RIEN: Self;
    fn vu(&self) -> Option<Vu<R>>;
}

impl<R: Reel> Reponse<R> for Touche<R> {
    const RIEN: Self = Err(NoIntersection);
    fn vu(&self) -> Option<Vu<R>> {
        self.ok().map(|touche| (touche.distance(), touche.normale(), touche.texture()))
    }
}

impl<R: Reel> Reponse<R> for Option<Vu<R>> {
    const RIEN: Self = None;
    fn vu(&self) -> Self {
        *self
    }
}

/// Who takes many rays at once.
pub(crate) fn en_lot<'a, R: Reel, T: Reponse<R> + 'a>(
    nom: &'static str,
    camp: Camp,
    chaque: Option<usize>,
    premieres: impl Fn(&[Rayon<R>], &mut [T]) + 'a,
    ombres: Option<impl FnMut(&[Rayon<R>], &[R], &mut [bool]) + 'a>,
) -> Concurrent<'a, R> {
    let mut tampon = vec![T::RIEN; MORCEAU].into_boxed_slice();
    let premieres = move |rayons: &[Rayon<R>], vus: Option<&mut Vec<Option<Vu<R>>>>| {
        let reponses = &mut tampon[..rayons.len()];
        premieres(rayons, reponses);
        if let Some(vus) = vus {
            vus.extend(black_box(reponses).iter().map(Reponse::vu));
        }
    };
    let ombres = ombres.map(|ombres| Box::new(ombres) as _);
    Concurrent { nom, camp, chaque, premieres: Box::new(premieres), ombres }
}

/// Who takes one ray after the other.
pub(crate) fn un_par_un<'a, R: Reel, T: Reponse<R> + 'a>(
    nom: &'static str,
    camp: Camp,
    chaque: Option<usize>,
    premiere: impl Fn(&Rayon<R>) -> T + 'a,
    ombre: Option<impl Fn(&Rayon<R>, R) -> bool + 'a>,
) -> Concurrent<'a, R> {
    let premieres = move |rayons: &[Rayon<R>], reponses: &mut [T]| {
        for (reponse, rayon) in reponses.iter_mut().zip(rayons) {
            *reponse = premiere(rayon);
        }
    };
    let ombres = ombre.map(|ombre| {
        move |rayons: &[Rayon<R>], max: &[R], caches: &mut [bool]| {
            for ((cache, rayon), max) in caches.iter_mut().zip(rayons).zip(max) {
                *cache = ombre(rayon, *max);
            }
        }
    });
    en_lot(nom, camp, chaque, premieres, ombres)
}
