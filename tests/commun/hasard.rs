//! Cases that are drawn number by number, as the extremes and large scenes are, and shrink all the same. What is kept of a
//! case is the words that were drawn; fewer and rounder words are tried, and the case is made again from them.

use core::cell::{Cell, RefCell};
use core::fmt::{Debug, Formatter, Result as Ecrit};
use core::ops::{Range, RangeInclusive};
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::rc::Rc;
use std::time::{Duration, Instant};

use fastrand::Rng;
use proptest::prelude::Rng as _;
use proptest::strategy::{NewTree, Strategy, ValueTree};
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};

/// How long the smallest case is looked for.
const RECHERCHE: Duration = Duration::from_secs(30);

/// Where a generator has its numbers from.
pub trait Tirage {
    fn f64(&mut self) -> f64;
    fn bool(&mut self) -> bool;
    fn u8(&mut self, dans: Range<u8>) -> u8;
    fn i8(&mut self, dans: RangeInclusive<i8>) -> i8;
    fn usize(&mut self, dans: Range<usize>) -> usize;
}

/// Nothing is kept of it: for searches that climb and for benches.
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

/// The words of a case: new ones, or those of a case before, and 0 from their end on.
pub struct Hasard {
    /// Which case it is, from 0 on; no smaller one has another.
    pub tour: usize,
    alea: Option<Rng>,
    mots: Mots,
    lus: usize,
}

#[derive(Debug, Clone, Default)]
struct Mots {
    mots: Vec<u64>,
    /// Where each element of a list begins, and where the last one ends.
    listes: Vec<Vec<usize>>,
}

impl Hasard {
    /// New words, of which nothing shrinks.
    pub fn de_graine(graine: u64) -> Self {
        Self { tour: 0, alea: Some(Rng::with_seed(graine)), mots: Mots::default(), lus: 0 }
    }

    /// The next word. Of new ones it is `voulu`, if that is given.
    fn mot(&mut self, voulu: Option<u64>) -> u64 {
        let mots = &mut self.mots.mots;
        if self.lus == mots.len() {
            let nouveau = self.alea.as_mut().map(|alea| voulu.unwrap_or_else(|| alea.u64(..)));
            mots.push(nouveau.unwrap_or(0));
        }
        self.lus += 1;
        // A generator may wait for a number that never comes.
        assert!(self.lus < 1 << 22, "too many words");
        mots[self.lus - 1]
    }

    /// The whole numbers below `combien`, each as likely as another; of a smaller word a smaller one.
    fn moins_que(&mut self, combien: usize) -> usize {
        assert!(combien > 0, "no number");
        ((u128::from(self.mot(None)) * combien as u128) >> 64) as usize
    }

    /// So many of these, each made with its index; a smaller case has some of them.
    pub fn liste<T>(
        &mut self,
        combien: usize,
        mut faire: impl FnMut(&mut Self, usize) -> T,
    ) -> Vec<T> {
        let (liste, mut elements) = (self.mots.listes.len(), Vec::new());
        self.mots.listes.push(Vec::new());
        loop {
            self.mots.listes[liste].push(self.lus);
            let encore = self.mot(Some(u64::from(elements.len() < combien)));
            if encore == 0 || elements.len() == combien {
                return elements;
            }
            elements.push(faire(self, elements.len()));
        }
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
        (self.mot(None) >> 11) as f64 * (-53_f64).exp2()
    }

    fn bool(&mut self) -> bool {
        self.mot(None) >> 63 == 1
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

/// A case, made when it is judged or shown.
struct Cas<'a, F> {
    faire: &'a F,
    tour: usize,
    /// Of new words.
    graine: Option<u64>,
    /// Those to make it from, and once it was made those that it took.
    mots: Rc<RefCell<Mots>>,
}

impl<T, F: Fn(&mut Hasard) -> T> Cas<'_, F> {
    fn faire(&self) -> T {
        let mots = Mots { mots: self.mots.borrow().mots.clone(), listes: Vec::new() };
        let alea = self.graine.map(Rng::with_seed);
        let mut hasard = Hasard { tour: self.tour, alea, mots, lus: 0 };
        let cas = (self.faire)(&mut hasard);
        hasard.mots.mots.truncate(hasard.lus);
        *self.mots.borrow_mut() = hasard.mots;
        cas
    }
}

impl<T: Debug, F: Fn(&mut Hasard) -> T> Debug for Cas<'_, F> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Ecrit {
        // In one line, however it is asked.
        write!(f, "{:?}", self.faire())
    }
}

struct Tirages<'a, F> {
    faire: &'a F,
    tour: Cell<usize>,
}

impl<F> Debug for Tirages<'_, F> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Ecrit {
        f.write_str("Tirages")
    }
}

impl<'a, T: Debug, F: Fn(&mut Hasard) -> T> Strategy for Tirages<'a, F> {
    type Tree = Recherche<'a, F>;
    type Value = Cas<'a, F>;

    fn new_tree(&self, lanceur: &mut TestRunner) -> NewTree<Self> {
        let (graine, tour) = (lanceur.rng().next_u64(), self.tour.replace(self.tour.get() + 1));
        Ok(Recherche {
            faire: self.faire,
            tour,
            graine: Some(graine),
            meilleurs: Mots::default(),
            essai: Rc::default(),
            ou: Ou::default(),
            change: false,
            fin: None,
        })
    }
}

/// What is tried next on the words of a failure.
#[derive(Debug, Default)]
struct Ou {
    /// To leave out so many elements of this list, from one on; 0 of them before it was begun.
    liste: usize,
    combien: usize,
    element: usize,
    /// Then to make this word rounder, in so many ways.
    mot: usize,
    facon: usize,
}

/// The words of a case, and those of the next smaller one that may fail too.
struct Recherche<'a, F> {
    faire: &'a F,
    tour: usize,
    graine: Option<u64>,
    meilleurs: Mots,
    essai: Rc<RefCell<Mots>>,
    ou: Ou,
    /// Since the search began over.
    change: bool,
    fin: Option<Instant>,
}

impl<F> Recherche<'_, F> {
    /// The next words to try.
    fn prochains(&mut self) -> Option<Vec<u64>> {
        let Mots { mots, listes } = &self.meilleurs;
        while let Some(bornes) = listes.get(self.ou.liste) {
            let (ou, elements) = (&mut self.ou, bornes.len() - 1);
            if ou.combien == 0 {
                (ou.combien, ou.element) = (elements, 0);
            }
            if ou.element >= elements {
                (ou.combien, ou.element) = (ou.combien / 2, 0);
            }
            if ou.combien == 0 || elements == 0 {
                (ou.liste, ou.combien, ou.element) = (ou.liste + 1, 0, 0);
                continue;
            }
            let fin = elements.min(ou.element + ou.combien);
            return Some([&mots[..bornes[ou.element]], &mots[bornes[fin]..]].concat());
        }
        loop {
            let mot = *mots.get(self.ou.mot)?;
            // 0, the middle, and ever more bits.
            let bits = [0, 1, 2, 4, 8, 16, 32].get(self.ou.facon);
            match bits.filter(|bits| **bits < u64::BITS - mot.trailing_zeros()) {
                Some(bits) => {
                    let rond = if *bits == 1 { 1 << 63 } else { mot & !(u64::MAX >> bits) };
                    if rond != mot {
                        let mut mots = mots.clone();
                        mots[self.ou.mot] = rond;
                        return Some(mots);
                    }
                    self.ou.facon += 1;
                }
                None => (self.ou.mot, self.ou.facon) = (self.ou.mot + 1, 0),
            }
        }
    }

    fn essayer(&mut self) -> bool {
        let fin = *self.fin.get_or_insert_with(|| Instant::now() + RECHERCHE);
        let mut prochains = self.prochains();
        if prochains.is_none() && self.change {
            (self.ou, self.change) = (Ou::default(), false);
            prochains = self.prochains();
        }
        let essai = prochains.filter(|_| Instant::now() < fin);
        let encore = essai.is_some();
        let mots = essai.unwrap_or_else(|| self.meilleurs.mots.clone());
        self.essai = Rc::new(RefCell::new(Mots { mots, listes: Vec::new() }));
        encore
    }
}

impl<'a, T: Debug, F: Fn(&mut Hasard) -> T> ValueTree for Recherche<'a, F> {
    type Value = Cas<'a, F>;

    fn current(&self) -> Cas<'a, F> {
        let Self { faire, tour, graine, .. } = *self;
        Cas { faire, tour, graine, mots: Rc::clone(&self.essai) }
    }

    /// What was tried last fails: it is kept, and the search goes on where it is.
    fn simplify(&mut self) -> bool {
        self.meilleurs = self.essai.borrow().clone();
        if self.graine.take().is_none() {
            self.change = true;
            if self.ou.mot > 0 || self.ou.facon > 0 || self.ou.liste >= self.meilleurs.listes.len()
            {
                (self.ou.mot, self.ou.facon) = (self.ou.mot + 1, 0);
            }
        }
        self.essayer()
    }

    fn complicate(&mut self) -> bool {
        if self.ou.liste < self.meilleurs.listes.len() {
            self.ou.element += self.ou.combien;
        } else {
            self.ou.facon += 1;
        }
        self.essayer()
    }
}

/// Makes so many cases, the same on every run, and judges each. Of one that fails the smallest that fails too is shown;
/// with `PROPTEST_MAX_SHRINK_ITERS=0` itself.
pub fn pour_chaque<T: Debug>(combien: u32, faire: impl Fn(&mut Hasard) -> T, juger: impl FnMut(T)) {
    let config = Config { cases: combien, failure_persistence: None, ..Config::default() };
    // The largest number stands for four times the cases.
    let max_shrink_iters = config.max_shrink_iters.min(u32::MAX - 1);
    let config = Config { max_shrink_iters, ..config };
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let tirages = Tirages { faire: &faire, tour: Cell::new(0) };
    let juger = RefCell::new(juger);
    let echec = TestRunner::new_with_rng(config, rng).run(&tirages, |cas| {
        let fait = catch_unwind(AssertUnwindSafe(|| cas.faire()));
        let fait = fait.or_else(|quoi| {
            // A generator may not know what to make of fewer words.
            let neuf = cas.graine.is_some();
            if neuf { resume_unwind(quoi) } else { Err(TestCaseError::reject("no case")) }
        })?;
        juger.borrow_mut()(fait);
        Ok(())
    });
    if let Err(echec) = echec {
        panic!("{echec}");
    }
}
