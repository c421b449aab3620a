//! How long each takes for the 240,000 rays of a picture: in turns and by the median, since on a
//! shared machine only ratios within a run last. What they answer is compared first.

use std::fmt;
use std::hint::black_box;
use std::time::Instant;

use lancer_rayon::{Rayon, Reel, premiere_intersection};

use crate::commun::{litteral, scenes};
use crate::{Parry, Touche};

const TAILLES: [usize; 5] = [3, 12, 48, 192, 1000];
pub(crate) const TOURS: usize = 5;

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

/// Adds a row to the table; whether the three agree on the scene of `n` objects.
fn comparer<R: Parry>(n: usize, table: &mut Vec<String>) -> bool {
    let rayons = scenes::rayons_camera::<R>(600, 400);
    let rayons_parry: Vec<_> = rayons.iter().map(R::rayon).collect();
    let objets = scenes::melange::<R>(n);
    let litteraux: Vec<_> = objets.iter().map(litteral::Objet::from).collect();
    let objets_parry: Vec<_> = objets.iter().map(R::objet).collect();

    let ici = |rayon: &Rayon<R>| {
        let touche = premiere_intersection(&objets, rayon).ok()?;
        Some((touche.distance, touche.normale, touche.texture))
    };
    let litteral = |rayon: &Rayon<R>| litteral::premiere_intersection(&litteraux, rayon);
    let parry = |rayon: &R::Rayon| R::premiere_intersection(&objets_parry, rayon);

    let reponses: Vec<_> = rayons.iter().map(ici).collect();
    let scalaire = std::any::type_name::<R>();
    let accord = [
        ("annex A", rayons.iter().map(litteral).collect::<Vec<_>>()),
        ("parry", rayons_parry.iter().map(parry).collect()),
    ]
    .map(|(nom, autres)| {
        let ecart = Ecart::entre(&reponses, &autres);
        println!("{scalaire}, N = {n}, {nom}: {ecart}");
        ecart.explicable::<R>(rayons.len())
    });

    let mut temps = [(); 3].map(|()| Vec::new());
    for _ in 0..TOURS {
        temps[0].push(chronometrer(&rayons, ici));
        temps[1].push(chronometrer(&rayons, litteral));
        temps[2].push(chronometrer(&rayons_parry, parry));
    }
    let [ici, litteral, parry] = temps.map(mediane);
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
pub(crate) fn chronometrer<Q, T>(rayons: &[Q], premiere: impl Fn(&Q) -> T) -> f64 {
    let debut = Instant::now();
    for rayon in rayons {
        black_box(premiere(rayon));
    }
    debut.elapsed().as_nanos() as f64 / rayons.len() as f64
}

pub(crate) fn mediane(mut temps: Vec<f64>) -> f64 {
    temps.sort_by(f64::total_cmp);
    temps[temps.len() / 2]
}
