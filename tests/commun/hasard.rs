//! Cases that are drawn number by number, as the extremes and large scenes are, and that shrink all the same. proptest
//! runs them; when a case fails, it tries the same case with fewer list elements and with rounder words.

use core::cell::RefCell;
use core::fmt::{Debug, Formatter, Result as Ecrit};
use core::ops::{Range, RangeInclusive};
use std::collections::BTreeMap;
use std::iter::successors;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::rc::Rc;
use std::time::{Duration, Instant};

use fastrand::Rng;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, TestCaseError, TestCaseResult, TestRunner};

/// How long the search for the smallest case may take.
const RECHERCHE: Duration = Duration::from_secs(30);

/// What a generator draws its numbers from.
pub trait Tirage {
    fn f64(&mut self) -> f64;
    fn bool(&mut self) -> bool;
    fn u8(&mut self, dans: Range<u8>) -> u8;
    fn i8(&mut self, dans: RangeInclusive<i8>) -> i8;
    fn usize(&mut self, dans: Range<usize>) -> usize;
}

/// What it draws is not kept: it serves climbs and benches.
impl Tirage for Rng {
    fn f64(&mut self) -> f64 {
        Self::f64(self)
    }

    fn bool(&mut self) -> bool {
        Self::bool(self)
    }

    fn u8(&mut self, dans: Range<u8>) -> u8 {
        Self::u8(self, dans)
    }

    fn i8(&mut self, dans: RangeInclusive<i8>) -> i8 {
        Self::i8(self, dans)
    }

    fn usize(&mut self, dans: Range<usize>) -> usize {
        Self::usize(self, dans)
    }
}

/// The words of a case, each newly drawn or replaced by one that shrinks the case.
pub struct Hasard {
    /// Which case it is, from 0 on; shrinking does not change it.
    pub tour: usize,
    alea: Rng,
    changes: Changes,
    tires: Tires,
    /// Whether the case has been made.
    fait: bool,
}

/// The words that replace drawn ones, by their places.
type Changes = BTreeMap<usize, u64>;

#[derive(Debug, Clone, Default)]
struct Tires {
    mots: Vec<u64>,
    /// The range of words of each list element; the first word is 0 if the element is left out.
    elements: Vec<Range<usize>>,
}

impl Hasard {
    /// New words, which no search shrinks.
    pub fn de_graine(graine: u64) -> Self {
        Self {
            tour: 0,
            alea: Rng::with_seed(graine),
            changes: Changes::new(),
            tires: Tires::default(),
            fait: false,
        }
    }

    pub fn mot(&mut self) -> u64 {
        let nouveau = self.alea.u64(..);
        self.noter(nouveau)
    }

    fn noter(&mut self, nouveau: u64) -> u64 {
        let mot = self.changes.get(&self.tires.mots.len()).copied().unwrap_or(nouveau);
        self.tires.mots.push(mot);
        // A generator may wait for a number that never comes.
        assert!(self.tires.mots.len() < 1 << 22, "too many words");
        mot
    }

    /// A whole number below `combien`, each as likely as another; a smaller word gives a smaller number.
    fn moins_que(&mut self, combien: usize) -> usize {
        assert!(combien > 0, "no number");
        ((u128::from(self.mot()) * combien as u128) >> 64) as usize
    }

    /// `combien` elements, each made with its index; a smaller case has only some of them.
    pub fn liste<T>(
        &mut self,
        combien: usize,
        mut faire: impl FnMut(&mut Self, usize) -> T,
    ) -> Vec<T> {
        let mut elements = Vec::new();
        for _ in 0..combien {
            let debut = self.tires.mots.len();
            let garde = self.noter(1) > 0;
            // One that is left out is made too, so that what is drawn after it stays as it is.
            let element = faire(self, elements.len());
            self.tires.elements.push(debut..self.tires.mots.len());
            elements.extend(garde.then_some(element));
        }
        elements
    }

    pub fn choix<'a, T>(&mut self, parmi: &'a [T]) -> &'a T {
        &parmi[self.moins_que(parmi.len())]
    }

    pub fn melanger<T>(&mut self, elements: &mut [T]) {
        for i in 1..elements.len() {
            elements.swap(i, self.usize(0..i + 1));
        }
    }
}

impl Tirage for Hasard {
    fn f64(&mut self) -> f64 {
        (self.mot() >> 11) as f64 * (-53_f64).exp2()
    }

    fn bool(&mut self) -> bool {
        self.mot() >> 63 == 1
    }

    fn u8(&mut self, dans: Range<u8>) -> u8 {
        dans.start + self.moins_que(dans.len()) as u8
    }

    fn i8(&mut self, dans: RangeInclusive<i8>) -> i8 {
        let (debut, fin) = dans.into_inner();
        (i64::from(debut) + self.moins_que(usize::from(debut.abs_diff(fin)) + 1) as i64) as i8
    }

    fn usize(&mut self, dans: Range<usize>) -> usize {
        dans.start + self.moins_que(dans.len())
    }
}

/// How a case is made and judged, or made and shown.
#[derive(Clone, Copy)]
struct Propriete<'a> {
    juger: &'a dyn Fn(&mut Hasard),
    montrer: &'a dyn Fn(&mut Hasard, &mut Formatter<'_>) -> Ecrit,
}

/// A case, made when it is judged or shown.
#[derive(Clone)]
struct Cas<'a> {
    propriete: Propriete<'a>,
    tour: usize,
    graine: u64,
    changes: Changes,
    tires: Rc<RefCell<Tires>>,
}

impl Cas<'_> {
    fn hasard(&self) -> Hasard {
        let (tour, changes) = (self.tour, self.changes.clone());
        Hasard { tour, changes, ..Hasard::de_graine(self.graine) }
    }

    fn juger(&self) -> TestCaseResult {
        let mut hasard = self.hasard();
        let juge = catch_unwind(AssertUnwindSafe(|| (self.propriete.juger)(&mut hasard)));
        // A generator may panic when elements are missing.
        let fait = hasard.fait || self.changes.is_empty();
        self.tires.replace(hasard.tires);
        juge.or_else(
            |quoi| {
                if fait { resume_unwind(quoi) } else { Err(TestCaseError::reject("no case")) }
            },
        )
    }
}

impl Debug for Cas<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Ecrit {
        (self.propriete.montrer)(&mut self.hasard(), f)
    }
}

/// The case that is tried next, and the changes of the smallest that has failed.
struct Recherche<'a> {
    essai: Cas<'a>,
    meilleurs: Changes,
    /// What is still to try, and until when.
    pas: Option<(Box<dyn Iterator<Item = Changes>>, Instant)>,
}

/// The changes that may shrink a case of these words. They leave out ever fewer elements, then set each word that is
/// left to 0, to the middle, and to ever more of its own bits.
fn pas(tires: Tires) -> impl Iterator<Item = Changes> {
    let Tires { mots, elements } = tires;
    let debuts: Vec<_> = elements.into_iter().map(|element| element.start).collect();
    let tailles = successors(Some(debuts.len()), |taille| Some(taille / 2));
    let oter = tailles.take_while(|taille| *taille > 0).flat_map(move |taille| {
        let parts =
            debuts.chunks(taille).map(|part| part.iter().map(|debut| (*debut, 0)).collect());
        parts.collect::<Vec<_>>()
    });
    let arrondir = mots.into_iter().enumerate().flat_map(|(i, mot)| {
        let ronds = [2, 4, 8, 16, 32].map(|bits| mot & !(u64::MAX >> bits));
        let ronds = [0, 1 << 63].into_iter().chain(ronds).filter(move |rond| *rond != mot);
        ronds.map(move |rond| Changes::from([(i, rond)]))
    });
    oter.chain(arrondir)
}

impl Recherche<'_> {
    fn essayer(&mut self) -> bool {
        let Cas { changes, tires, .. } = &mut self.essai;
        changes.clone_from(&self.meilleurs);
        let Some((pas, fin)) = &mut self.pas else { return false };
        let tires = tires.borrow();
        let ote = |i: &usize| {
            let mut elements = tires.elements.iter().filter(|element| element.contains(i));
            elements.any(|element| self.meilleurs.get(&element.start) == Some(&0))
        };
        let reste = |mut pas: Changes| {
            pas.retain(|i, _| !self.meilleurs.contains_key(i) && !ote(i));
            (!pas.is_empty()).then_some(pas)
        };
        let suivant = pas.take_while(|_| Instant::now() < *fin).find_map(reste);
        let encore = suivant.is_some();
        changes.extend(suivant.into_iter().flatten());
        encore
    }
}

impl<'a> ValueTree for Recherche<'a> {
    type Value = Cas<'a>;

    fn current(&self) -> Cas<'a> {
        self.essai.clone()
    }

    /// The last try failed, so it is kept.
    fn simplify(&mut self) -> bool {
        self.meilleurs.clone_from(&self.essai.changes);
        self.pas.get_or_insert_with(|| {
            (Box::new(pas(self.essai.tires.borrow().clone())), Instant::now() + RECHERCHE)
        });
        self.essayer()
    }

    fn complicate(&mut self) -> bool {
        self.essayer()
    }
}

/// Makes `combien` cases, the same on every run, and judges each. If one fails, the smallest version that also fails is
/// shown; with `PROPTEST_MAX_SHRINK_ITERS=0` the case itself is.
pub fn pour_chaque<T: Debug>(combien: u32, faire: impl Fn(&mut Hasard) -> T, juger: impl FnMut(T)) {
    let juger = RefCell::new(juger);
    let juger = |alea: &mut Hasard| {
        let cas = faire(alea);
        alea.fait = true;
        juger.borrow_mut()(cas);
    };
    // In one line, even for `{:#?}`.
    let montrer = |alea: &mut Hasard, f: &mut Formatter<'_>| write!(f, "{:?}", faire(alea));
    lancer(combien, Propriete { juger: &juger, montrer: &montrer });
}

/// Compiled once for all properties.
fn lancer(combien: u32, propriete: Propriete<'_>) {
    // proptest takes the largest number to mean four times the cases.
    let max_shrink_iters = Config::default().max_shrink_iters.min(u32::MAX - 1);
    let mut lanceur = TestRunner::new(Config { max_shrink_iters, ..Config::default() });
    let mut graines = Rng::with_seed(2);
    for tour in 0..combien as usize {
        let (graine, changes) = (graines.u64(..), Changes::new());
        let essai = Cas { propriete, tour, graine, changes, tires: Rc::default() };
        let recherche = Recherche { essai, meilleurs: Changes::new(), pas: None };
        if let Err(echec) = lanceur.run_one(recherche, |cas| cas.juger()) {
            panic!("{echec}");
        }
    }
}
