//! A scalar that records: when the crate's own formulae run on it, they leave a tape of what they compute.
//!
//! What is computed twice from the same numbers has one place on the tape, so that two ways through the code compute
//! the same if they end at the same place.

use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::fmt::{Debug, Display, Formatter, Result};
use std::ops::{Add, Div, Mul, Neg, Sub};

use lancer_rayon::pour_les_tests::Scelle;
use lancer_rayon::{Nombre, Vecteur};

/// A place of the tape.
pub(crate) type Place = usize;

/// What is computed at a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Op {
    /// An input of this name, and which of its coordinates.
    Entree(&'static str, u8),
    /// A number of these bits, and whether it was rounded from `f64`.
    Constante(u64, bool),
    Oppose(Place),
    Absolu(Place),
    Racine(Place),
    Somme(Place, Place),
    Difference(Place, Place),
    Produit(Place, Place),
    Quotient(Place, Place),
}

use Op::{Absolu, Constante, Difference, Entree, Oppose, Produit, Quotient, Racine, Somme};

#[derive(Debug, Default)]
struct Ruban {
    ops: Vec<Op>,
    /// The number at each place for the given inputs.
    valeurs: Vec<f64>,
    places: HashMap<Op, Place>,
    /// Which places are known to be less than which, or not to be.
    moindre: HashMap<(Place, Place), bool>,
    /// The results of the comparisons on a way through the code, in order.
    chemin: Vec<bool>,
    /// How the comparisons are to come out, all later ones as true; without it, as the numbers tell.
    impose: Option<Vec<bool>>,
}

thread_local! {
    static RUBAN: RefCell<Ruban> = RefCell::default();
}

/// Starts a tape.
pub(crate) fn neuf() {
    RUBAN.take();
}

pub(crate) fn op(place: Place) -> Op {
    RUBAN.with_borrow(|ruban| ruban.ops[place])
}

/// All that is recorded.
pub(crate) fn ops() -> Vec<Op> {
    RUBAN.with_borrow(|ruban| ruban.ops.clone())
}

/// The pairs of places that were compared.
pub(crate) fn comparaisons() -> Vec<(Place, Place)> {
    RUBAN.with_borrow(|ruban| ruban.moindre.keys().copied().collect())
}

/// The type that the scalar stands for. `Self` is as large as that type, so that `selon` takes it for that.
pub(crate) trait Taille: Copy + Send + Sync + 'static {
    type Nombre: Nombre;
    /// The codes of 0, 1, +∞, η, u and the limit.
    const CODES: [Self; 6];
    fn de(code: u32) -> Self;
    fn code(self) -> u32;
}

macro_rules! taille {
    ($($type:ident $nombre:ident;)*) => {$(
        impl Taille for $type {
            type Nombre = $nombre;
            const CODES: [Self; 6] = [0, 1, 2, 3, 4, 5];
            fn de(code: u32) -> Self {
                code.into()
            }
            fn code(self) -> u32 {
                self as u32
            }
        }
    )*};
}

taille! { u32 f32; u64 f64; }

/// A number that records: the code of one of six constants, or its place plus six.
#[derive(Clone, Copy)]
pub(crate) struct Trace<T>(T);

fn inscrire(op: Op, valeur: f64) -> Place {
    RUBAN.with_borrow_mut(|ruban| {
        let Ruban { ops, valeurs, places, .. } = ruban;
        *places.entry(op).or_insert_with(|| {
            ops.push(op);
            valeurs.push(valeur);
            ops.len() - 1
        })
    })
}

impl<T: Taille> Trace<T> {
    pub(crate) fn en(place: Place) -> Self {
        Self(T::de(u32::try_from(place).unwrap() + 6))
    }

    pub(crate) fn place(self) -> Place {
        let constantes = [0.0, 1.0, f64::INFINITY].map(Some).into_iter();
        let du_type = [T::Nombre::ETA, T::Nombre::U, T::Nombre::LIMITE].map(|x| Some(x.vers_f64()));
        match constantes.chain(du_type).nth(self.0.code() as usize) {
            Some(Some(x)) => inscrire(Constante(x.to_bits(), false), x),
            _ => self.0.code() as usize - 6,
        }
    }

    fn valeur(self) -> f64 {
        let place = self.place();
        RUBAN.with_borrow(|ruban| ruban.valeurs[place])
    }

    fn constante(x: f64, arrondie: bool) -> Self {
        let rendue = T::Nombre::depuis_f64(x).vers_f64();
        Self::en(inscrire(Constante(rendue.to_bits(), arrondie || rendue != x), rendue))
    }

    fn est_arrondie(self) -> bool {
        matches!(op(self.place()), Constante(_, true))
    }

    fn fixe(self) -> Option<f64> {
        match op(self.place()) {
            Constante(bits, _) => Some(f64::from_bits(bits)),
            Entree(..) | Oppose(_) | Absolu(_) | Racine(_) | Somme(..) | Difference(..)
            | Produit(..) | Quotient(..) => None,
        }
    }

    fn un(self, op: impl FnOnce(Place) -> Op, valeur: f64) -> Self {
        match self.fixe() {
            Some(_) => Self::constante(valeur, self.est_arrondie()),
            None => Self::en(inscrire(op(self.place()), valeur)),
        }
    }

    fn deux(self, autre: Self, op: impl FnOnce(Place, Place) -> Op, valeur: f64) -> Self {
        Self::en(inscrire(op(self.place(), autre.place()), valeur))
    }

    /// Whether this is less, for numbers that are finite and not NaN.
    fn est_moindre(self, autre: Self) -> bool {
        match (self.fixe(), autre.fixe()) {
            (Some(a), Some(b)) => return a < b,
            (Some(a), None) if a.is_infinite() => return a < 0.0,
            (None, Some(b)) if b.is_infinite() => return b > 0.0,
            _ => {}
        }
        let (cle, nombres) = ((self.place(), autre.place()), self.valeur() < autre.valeur());
        RUBAN.with_borrow_mut(|ruban| {
            if let Some(&connu) = ruban.moindre.get(&cle) {
                return connu;
            }
            let suivant =
                |impose: &Vec<bool>| impose.get(ruban.chemin.len()).copied().unwrap_or(true);
            let moindre = ruban.impose.as_ref().map_or(nombres, suivant);
            ruban.chemin.push(moindre);
            ruban.moindre.insert(cle, moindre);
            moindre
        })
    }
}

/// A number under a name.
pub(crate) fn entree<T: Taille>(nom: &'static str, x: f64) -> Trace<T> {
    Trace::en(inscrire(Entree(nom, 0), x))
}

/// Three coordinates under a name.
pub(crate) fn entrees<T: Taille>(nom: &'static str, v: impl Into<[f64; 3]>) -> Vecteur<Trace<T>> {
    let mut rang = 0;
    let v = v.into().map(|x| {
        rang += 1;
        Trace::en(inscrire(Entree(nom, rang - 1), x))
    });
    v.into()
}

/// The results of all ways through the code, whatever the numbers: each of the first `combien` comparisons comes out
/// both ways, unless it repeats an earlier one.
pub(crate) fn tous_les_chemins<R: Ord>(combien: usize, f: impl Fn() -> R) -> BTreeSet<R> {
    let (mut fins, mut impose) = (BTreeSet::new(), Vec::new());
    loop {
        RUBAN.with_borrow_mut(|ruban| {
            ruban.moindre.clear();
            ruban.chemin.clear();
            ruban.impose = Some(impose);
        });
        fins.insert(f());
        impose = RUBAN.with_borrow(|ruban| ruban.chemin.clone());
        impose.truncate(combien);
        while impose.last() == Some(&false) {
            impose.pop();
        }
        match impose.last_mut() {
            Some(dernier) => *dernier = false,
            None => return fins,
        }
    }
}

fn est_puissance_de_deux(place: Place) -> bool {
    matches!(op(place), Constante(bits, false) if bits != 0 && bits << 12 == 0)
}

/// How often each product of inputs that this expression sums up is rounded. Products of the same names share their
/// counts. A root or a divisor is a factor of its own, and so is each of these letters; a power of two rounds nothing.
pub(crate) fn arrondis(
    place: Place,
    lettres: &[(&'static str, Place)],
) -> BTreeMap<String, BTreeSet<u32>> {
    let mut noms: BTreeMap<String, BTreeSet<u32>> = BTreeMap::new();
    let lettre = |k, &(nom, place)| (place, Termes::from([(vec![(nom, k)], 0)]));
    let mut connus = (0..).zip(lettres).map(|(k, l)| lettre(k, l)).collect();
    for (facteurs, combien) in termes(place, &mut connus) {
        let mut facteurs = facteurs.into_iter().map(|(nom, _)| nom).collect::<Vec<_>>();
        facteurs.sort_unstable();
        noms.entry(facteurs.join(" ")).or_default().insert(combien);
    }
    noms
}

type Termes = BTreeMap<Vec<(&'static str, u8)>, u32>;

fn termes(place: Place, connus: &mut HashMap<Place, Termes>) -> Termes {
    if let Some(connu) = connus.get(&place) {
        return connu.clone();
    }
    let mut resultat = Termes::new();
    let mut noter = |facteurs, combien: u32| {
        let ici = resultat.entry(facteurs).or_insert(0);
        *ici = combien.max(*ici);
    };
    match op(place) {
        Entree(nom, k) => noter(vec![(nom, k)], 0),
        Constante(_, arrondie) => noter(vec![], arrondie.into()),
        Oppose(a) | Absolu(a) => termes(a, connus).into_iter().for_each(|(f, n)| noter(f, n)),
        Racine(_) => noter(vec![("√", 0)], 1),
        // x + x rounds nothing.
        Somme(a, b) if a == b => termes(a, connus).into_iter().for_each(|(f, n)| noter(f, n)),
        Somme(a, b) | Difference(a, b) => {
            for (f, n) in termes(a, connus).into_iter().chain(termes(b, connus)) {
                noter(f, n + 1);
            }
        }
        Produit(a, b) => {
            let exact = est_puissance_de_deux(a) || est_puissance_de_deux(b);
            for (f, n) in termes(a, connus) {
                for (g, m) in termes(b, connus) {
                    let mut facteurs = [f.as_slice(), &g].concat();
                    facteurs.sort_unstable();
                    noter(facteurs, n + m + u32::from(!exact));
                }
            }
        }
        Quotient(a, b) => {
            let exact = est_puissance_de_deux(b);
            for (mut f, n) in termes(a, connus) {
                if !exact {
                    f.push(("/", 0));
                    f.sort_unstable();
                }
                noter(f, n + u32::from(!exact));
            }
        }
    }
    connus.insert(place, resultat.clone());
    resultat
}

macro_rules! operateurs {
    ($($trait:ident::$f:ident |$a:ident, $b:ident, $v:ident| $regle:expr;)*) => {$(
        impl<T: Taille> $trait for Trace<T> {
            type Output = Self;
            fn $f(self, autre: Self) -> Self {
                let $v = self.valeur().$f(autre.valeur());
                let ($a, $b) = (self, autre);
                if $a.fixe().is_some() && $b.fixe().is_some() {
                    return Self::constante($v, $a.est_arrondie() || $b.est_arrondie());
                }
                $regle
            }
        }
    )*};
}

operateurs! {
    Add::add |a, b, v| match (a.fixe(), b.fixe()) {
        (Some(0.0), _) => b,
        (_, Some(0.0)) => a,
        _ => a.deux(b, Somme, v),
    };
    Sub::sub |a, b, v| match (a.fixe(), b.fixe()) {
        (Some(0.0), _) => -b,
        (_, Some(0.0)) => a,
        _ => a.deux(b, Difference, v),
    };
    Mul::mul |a, b, v| match (a.fixe(), b.fixe()) {
        (Some(0.0), _) | (_, Some(0.0)) => Self::ZERO,
        (Some(1.0), _) => b,
        (_, Some(1.0)) => a,
        (Some(-1.0), _) => -b,
        (_, Some(-1.0)) => -a,
        _ => a.deux(b, Produit, v),
    };
    Div::div |a, b, v| match (a.fixe(), b.fixe()) {
        (_, Some(1.0)) => a,
        _ => a.deux(b, Quotient, v),
    };
}

impl<T: Taille> Neg for Trace<T> {
    type Output = Self;
    fn neg(self) -> Self {
        self.un(Oppose, -self.valeur())
    }
}

impl<T: Taille> PartialEq for Trace<T> {
    /// A computed number equals nothing but itself.
    fn eq(&self, autre: &Self) -> bool {
        match (self.fixe(), autre.fixe()) {
            (Some(a), Some(b)) => a == b,
            _ => self.place() == autre.place(),
        }
    }
}

impl<T: Taille> PartialOrd for Trace<T> {
    fn partial_cmp(&self, _: &Self) -> Option<Ordering> {
        unreachable!("the crate compares by operators")
    }
    fn lt(&self, autre: &Self) -> bool {
        self.est_moindre(*autre)
    }
    fn gt(&self, autre: &Self) -> bool {
        autre.est_moindre(*self)
    }
    fn le(&self, autre: &Self) -> bool {
        !autre.est_moindre(*self)
    }
    fn ge(&self, autre: &Self) -> bool {
        !self.est_moindre(*autre)
    }
}

impl<T: Taille> Debug for Trace<T> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "{:?} = {}", op(self.place()), self.valeur())
    }
}

impl<T: Taille> Display for Trace<T> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        Debug::fmt(self, f)
    }
}

impl<T> Scelle for Trace<T> {}

impl<T: Taille> Nombre for Trace<T> {
    const ZERO: Self = Self(T::CODES[0]);
    const UN: Self = Self(T::CODES[1]);
    const INFINI: Self = Self(T::CODES[2]);
    const ETA: Self = Self(T::CODES[3]);
    const U: Self = Self(T::CODES[4]);
    const LIMITE: Self = Self(T::CODES[5]);

    fn racine(self) -> Self {
        self.un(Racine, self.valeur().sqrt())
    }
    fn absolu(self) -> Self {
        self.un(Absolu, self.valeur().abs())
    }
    fn vers_f64(self) -> f64 {
        self.valeur()
    }
    fn depuis_f64(x: f64) -> Self {
        Self::constante(x, false)
    }
}
