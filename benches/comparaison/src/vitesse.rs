//! How long each takes for the 240,000 rays of a picture: in turns and by the median, since on a
//! shared machine only ratios within a run last. What they answer is compared first.

use std::fmt;
use std::hint::black_box;
use std::time::Instant;

use lancer_rayon::{ObjetRay, Rayon, Reel, premiere_intersection};

use crate::commun::{litteral, scenes};
use crate::{Parry, Touche};

const TAILLES: [usize; 5] = [3, 12, 48, 192, 1000];
const TOURS: usize = 5;

/// The table; `None` if the three do not agree but for rounding.
pub(crate) fn table() -> Option<String> {
    let mut table = vec![
        "| scalar | N | lancer-rayon | annex A | parry | annex A / ours | parry / ours |".into(),
        "|---|--:|--:|--:|--:|--:|--:|".into(),
    ];
    let mut accord = true;
    for n in TAILLES {
        accord &= comparer::<f32>(n, &mut table);
        accord &= comparer::<f64>(n, &mut table);
    }
    accord.then(|| table.join("\n"))
}

/// One scene and its rays, as each of the three wants them. Always in the order ours, annex A,
/// parry.
pub(crate) struct Concours<R: Parry> {
    pub(crate) objets: Vec<ObjetRay<R>>,
    pub(crate) rayons: Vec<Rayon<R>>,
    litteraux: Vec<litteral::Objet<R>>,
    objets_parry: Vec<R::Objet>,
    rayons_parry: Vec<R::Rayon>,
}

impl<R: Parry> Concours<R> {
    pub(crate) fn new(objets: Vec<ObjetRay<R>>, rayons: Vec<Rayon<R>>) -> Self {
        Self {
            litteraux: objets.iter().map(litteral::Objet::from).collect(),
            objets_parry: objets.iter().map(R::objet).collect(),
            rayons_parry: rayons.iter().map(R::rayon).collect(),
            objets,
            rayons,
        }
    }

    fn ici(&self, rayon: &Rayon<R>) -> Option<Touche<R>> {
        let touche = premiere_intersection(&self.objets, rayon).ok()?;
        Some((touche.distance, touche.normale, touche.texture))
    }

    fn litteral(&self, rayon: &Rayon<R>) -> Option<Touche<R>> {
        litteral::premiere_intersection(&self.litteraux, rayon)
    }

    fn parry(&self, rayon: &R::Rayon) -> Option<Touche<R>> {
        R::premiere_intersection(&self.objets_parry, rayon)
    }

    /// What each answers to every ray of so many.
    pub(crate) fn reponses(&self, pas: usize) -> [Vec<Option<Touche<R>>>; 3] {
        let rayons = || self.rayons.iter().step_by(pas);
        [
            rayons().map(|rayon| self.ici(rayon)).collect(),
            rayons().map(|rayon| self.litteral(rayon)).collect(),
            self.rayons_parry.iter().step_by(pas).map(|rayon| self.parry(rayon)).collect(),
        ]
    }

    /// Nanoseconds per ray, in turns and by the median.
    pub(crate) fn temps(&self) -> [f64; 3] {
        let mut temps = [(); 3].map(|()| Vec::new());
        for _ in 0..TOURS {
            temps[0].push(chronometrer(&self.rayons, |rayon| self.ici(rayon)));
            temps[1].push(chronometrer(&self.rayons, |rayon| self.litteral(rayon)));
            temps[2].push(chronometrer(&self.rayons_parry, |rayon| self.parry(rayon)));
        }
        temps.map(mediane)
    }
}

/// Adds a row to the table; whether the three agree on the scene of `n` objects.
fn comparer<R: Parry>(n: usize, table: &mut Vec<String>) -> bool {
    let concours = Concours::<R>::new(scenes::melange(n), scenes::rayons_camera(600, 400));
    let scalaire = std::any::type_name::<R>();
    let [ici, litteral, parry] = concours.reponses(1);
    let accord = [("annex A", litteral), ("parry", parry)].map(|(nom, autres)| {
        let ecart = Ecart::entre(&ici, &autres);
        println!("{scalaire}, N = {n}, {nom}: {ecart}");
        ecart.explicable::<R>(concours.rayons.len())
    });
    let [ici, litteral, parry] = concours.temps();
    table.push(format!(
        "| {scalaire} | {n} | {ici:.0} | {litteral:.0} | {parry:.0} | {:.1} | {:.1} |",
        litteral / ici,
        parry / ici,
    ));
    accord == [true, true]
}

/// How the answers of another differ from ours to the same rays.
struct Ecart {
    touches: [usize; 2],
    sommes_des_distances: [f64; 2],
    autre_objet: usize,
}

impl Ecart {
    fn entre<R: Reel>(ici: &[Option<Touche<R>>], autre: &[Option<Touche<R>>]) -> Self {
        let distance = |touche: &Touche<R>| touche.0.vers_f64();
        let objet = |touche: &Option<Touche<R>>| touche.map(|(_, _, texture)| texture);
        Self {
            touches: [ici, autre].map(|liste| liste.iter().flatten().count()),
            sommes_des_distances: [ici, autre].map(|l| l.iter().flatten().map(distance).sum()),
            autre_objet: ici.iter().zip(autre).filter(|(a, b)| objet(a) != objet(b)).count(),
        }
    }

    fn relatif(&self) -> f64 {
        let [ici, autre] = self.sommes_des_distances;
        (autre - ici).abs() / ici
    }

    /// Rounding moves an outline by thousands of u at most, which are what SC² − SA² costs annex A
    /// and parry: the rays in between, and nothing else, may touch another object.
    fn explicable<R: Reel>(&self, rayons: usize) -> bool {
        let tolerance = 1e4 * R::U.vers_f64();
        self.autre_objet as f64 <= tolerance * rayons as f64 && self.relatif() <= tolerance
    }
}

impl fmt::Display for Ecart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ([ici, autre], relatif) = (self.touches, self.relatif());
        write!(f, "{autre} hits for our {ici}, distances off by {relatif:.0e}, ")?;
        write!(f, "another object for {} rays", self.autre_objet)
    }
}

/// Nanoseconds per ray.
fn chronometrer<Q, T>(rayons: &[Q], premiere: impl Fn(&Q) -> T) -> f64 {
    let debut = Instant::now();
    for rayon in rayons {
        black_box(premiere(rayon));
    }
    debut.elapsed().as_nanos() as f64 / rayons.len() as f64
}

fn mediane(mut temps: Vec<f64>) -> f64 {
    temps.sort_by(f64::total_cmp);
    temps[temps.len() / 2]
}
