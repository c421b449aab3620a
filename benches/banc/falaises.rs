//! Searches for scenes in which a batch is slow, over its rays one by one and over the batch of the list. It draws layouts
//! and rays that no family of `familles` has, and climbs on the ratio from the worst of them.
//! `cargo run --release -p banc --bin falaises` prints `benches/mesures/falaises.csv`, in some five minutes, and the worst
//! scene of each layout beside it. Arguments: `--seed 11`, `--tries 60` scenes drawn for each layout, `--climb 20` steps
//! from the worst, which the file does not count, `--call 64` for one size of calls, `--set AVX2`, `--layout row` for one
//! layout, `--draws` to print each scene that is drawn.

use std::error::Error;

use banc::circonstances::Circonstances;
use banc::horloge::{MORCEAU, moindres};
use banc::nous;
use commun::arrondi;
use commun::fabrique::{boite, boite_droite, mur, sphere, v};
use commun::regimes::direction;
use commun::scenes::en_tuiles;
use fastrand::Rng;
use lancer_rayon::{Monde, ObjetRay, Rayon, Reel, Rotation, Vecteur};

const DISPOSITIONS: [&str; 10] = [
    "cloud of balls",
    "cloud of boxes",
    "sheets",
    "row",
    "shells",
    "needles",
    "grid of cubes",
    "two clusters",
    "street",
    "nested boxes",
];
const GENRES: [&str; 13] = [
    "tiles",
    "rows",
    "parallel",
    "no order",
    "shuffled tiles",
    "diffuse",
    "mirrors",
    "tiles, a far ray first",
    "tiles, one ray in sixteen from anywhere",
    "tiles, the first block in, the others away",
    "lamp",
    "lamp shuffled",
    "sun",
];
const AJOUTS: [&str; 6] = [
    "",
    " and a sky",
    " and mist",
    " and half-spaces",
    " and a ground",
    " before a pile of plates",
];

/// What one scene and its rays are drawn from: numbers from 0 to 1.
type Genes = [f64; 12];

/// The genes as what they stand for.
#[derive(Debug, Clone, Copy)]
struct Tirage {
    disposition: usize,
    genre: usize,
    ajout: usize,
    combien_d_ajouts: usize,
    n: usize,
    /// The size of an object over the distance of neighbours.
    taille: f64,
    /// The thickness of boxes over their sides.
    mince: f64,
    /// How wide a picture is, at a distance of 1.
    champ: f64,
    /// How far the eye is, over the radius of the scene.
    recul: f64,
    de_cote: f64,
    double: bool,
    graine: u64,
}

impl Tirage {
    fn de(g: Genes) -> Self {
        let parmi = |x: f64, n: usize| ((x * n as f64) as usize).min(n - 1);
        let log = |x: f64, a: f64, b: f64| a * (b / a).powf(x);
        Self {
            disposition: parmi(g[0], DISPOSITIONS.len()),
            genre: parmi(g[1], GENRES.len()),
            ajout: parmi(g[2], AJOUTS.len() + 4).saturating_sub(4),
            combien_d_ajouts: log(g[3], 1.0, 300.0) as usize,
            n: log(g[4], 10.0, 20_000.0) as usize,
            taille: log(g[5], 0.05, 5.0),
            mince: log(g[6], 0.01, 1.0),
            champ: log(g[7], 0.003, 2.0),
            recul: log(g[8], 0.05, if g[9] > 0.9 { 1e6 } else { 10.0 }),
            de_cote: g[10],
            double: g[11] >= 0.5,
            graine: g[9].to_bits() ^ g[10].to_bits().rotate_left(7),
        }
    }

    fn nom(&self) -> String {
        let Self { disposition, genre, ajout, combien_d_ajouts, n, .. } = *self;
        let [taille, mince, champ, recul] =
            [self.taille, self.mince, self.champ, self.recul].map(|x| format!("{x:.2e}"));
        format!(
            "{} {}{}{}, {}; size {taille}, thin {mince}, field {champ}, from {recul}, {}",
            n,
            DISPOSITIONS[disposition],
            AJOUTS[ajout],
            if matches!(ajout, 2 | 3 | 5) { format!(" {combien_d_ajouts}") } else { String::new() },
            GENRES[genre],
            if self.double { "f64" } else { "f32" },
        )
    }

    /// The objects, in a ball of radius 1 about O more or less.
    fn objets<R: Reel>(&self, alea: &mut Rng) -> Vec<ObjetRay<R>> {
        let n = self.n as f64;
        let pas = 2.0 / n.cbrt();
        let tour = |alea: &mut Rng, fois: f64| {
            Rotation::new(arrondi(direction(alea) * (3.0 * fois))).expect("angles")
        };
        let de_tous = tour(alea, self.de_cote.round() * 0.3);
        let dans = |alea: &mut Rng| direction(alea) * alea.f64().cbrt();
        let r = R::depuis_f64;
        let un = |i: usize, alea: &mut Rng| {
            let (k, cote) = (i as f64 / n, n.cbrt().ceil());
            let cotes = |a: f64, b: f64, c: f64| arrondi(Vecteur::new(a, b, c));
            match self.disposition {
                0 => sphere(arrondi(dans(alea)), r(0.5 * pas * self.taille)),
                1 => {
                    let l = pas * self.taille;
                    let (ou, tour) = (dans(alea), tour(alea, 1.0));
                    boite(arrondi(ou), cotes(l, l * self.mince, l), tour)
                }
                2 => {
                    let ou = de_tous.appliquer(arrondi(Vecteur::new(0.0, 2.0 * k - 1.0, 0.0)));
                    let haut = 2.0 / n * self.taille.min(1.0);
                    boite(ou, cotes(2.0, haut, 2.0 * (0.1 + self.mince)), de_tous)
                }
                3 => {
                    let ou = de_tous.appliquer(arrondi(Vecteur::new(2.0 * k - 1.0, 0.0, 0.0)));
                    if self.mince < 0.1 {
                        let l = 2.0 / n * self.taille;
                        boite(ou, cotes(l, l, l), de_tous)
                    } else {
                        sphere(ou, r(1.0 / n * self.taille))
                    }
                }
                4 => sphere(
                    arrondi(direction(alea) * (self.mince * 0.1)),
                    r(0.1 + 0.9 * k * self.taille),
                ),
                5 => {
                    let (ou, tour) = (dans(alea) * self.taille.min(1.0), tour(alea, 1.0));
                    let l = 0.05 * self.mince;
                    boite(arrondi(ou), cotes(2.0, l, l), tour)
                }
                6 => {
                    let place = |p: f64| (k * n / p).floor() % cote * (2.0 / cote) - 1.0;
                    let ou = Vecteur::new(place(1.0), place(cote), place(cote * cote));
                    let l = 2.0 / cote * self.taille.min(1.2);
                    boite(de_tous.appliquer(arrondi(ou)), cotes(l, l, l), de_tous)
                }
                7 => {
                    let loin = if i.is_multiple_of(2) { 1.0 } else { -1.0 };
                    let ou = Vecteur::new(loin, 0.0, 0.0) + dans(alea) * self.mince;
                    sphere(arrondi(ou), r(0.5 * pas * self.taille * self.mince))
                }
                8 => {
                    let cote = n.sqrt().ceil();
                    let l = 2.0 / cote * self.taille.min(0.95);
                    let haut = l * (0.3 + 3.0 * alea.f64() * alea.f64());
                    let x = (k * n) % cote * (2.0 / cote) - 1.0;
                    let z = (k * n / cote).floor() * (2.0 / cote) - 1.0;
                    let ou = Vecteur::new(x, haut / 2.0, z);
                    boite(de_tous.appliquer(arrondi(ou)), cotes(l, haut, l), de_tous)
                }
                _ => {
                    let l = 0.05 + 1.9 * k;
                    let ou = dans(alea) * (0.1 * self.mince);
                    boite(arrondi(ou), cotes(l, l * self.taille.min(1.0), l), de_tous)
                }
            }
        };
        let mut objets: Vec<_> = (0..self.n).map(|i| un(i, alea)).collect();
        match self.ajout {
            1 => objets.insert(0, sphere(Vecteur::NUL, r(1e3))),
            2 => objets.extend(
                (0..self.combien_d_ajouts.min(40)).map(|_| sphere(arrondi(dans(alea)), r(0.8))),
            ),
            3 => objets.extend((0..self.combien_d_ajouts).map(|_| {
                let n = direction(alea);
                mur(arrondi(n * -3.0), arrondi(n))
            })),
            4 => objets.insert(0, boite_droite(v(0.0, -1.2, 0.0), v(20.0, 0.2, 20.0))),
            5 => objets.extend((0..10 * self.combien_d_ajouts).map(|k| {
                let bas = arrondi(Vecteur::new(0.0, -1e5 - k as f64, 0.0));
                boite_droite(bas, v(1e8, 0.1, 1e8))
            })),
            _ => (),
        }
        objets
    }

    /// The rays of a square picture in this order.
    fn rayons<R: Reel>(&self, monde: &Monde<'_, R>, alea: &mut Rng) -> Vec<Rayon<R>> {
        let vers = direction(alea);
        let oeil = vers * -(1.0 + self.recul);
        let x = vers.produit_vectoriel(direction(alea)).unitaire().unwrap_or(Vecteur::X);
        let y = vers.produit_vectoriel(x);
        let cote = MORCEAU.isqrt();
        let demi = 0.5 * self.champ;
        let de_partout = |alea: &mut Rng| (direction(alea) * alea.f64().cbrt(), direction(alea));
        let pixel = |i: usize| {
            let (i, j) = (i % cote, i / cote);
            let [a, b] = [i, j].map(|k| demi * ((k as f64 + 0.5) / cote as f64 * 2.0 - 1.0));
            let travers = x * a + y * b;
            let (s, d) = match self.genre {
                2 => (oeil + travers, vers),
                3 => de_partout(alea),
                _ => (oeil, vers + travers),
            };
            let loin = self.genre == 7 && i % 8 == 0 && j % 8 == 0;
            let (s, d) = if loin { (s * 1e9, d) } else { (s, d) };
            Rayon::new(arrondi(s), arrondi(d)).expect("within the limits")
        };
        let vus: Vec<Rayon<R>> = (0..MORCEAU).map(pixel).collect();
        // Rows stay rows, and rays in no order need none.
        let mut vus = if matches!(self.genre, 1 | 3) { vus } else { en_tuiles(&vus, cote) };
        match self.genre {
            8 => {
                let premier = alea.usize(0..16);
                for rayon in vus.iter_mut().skip(premier).step_by(16) {
                    let (s, d) = de_partout(alea);
                    *rayon = Rayon::new(arrondi(s), arrondi(d)).expect("within the limits");
                }
            }
            9 => {
                for rayon in &mut vus[64..] {
                    *rayon = Rayon::new(rayon.source(), -rayon.direction()).expect("a direction");
                }
            }
            _ => (),
        }
        let lampe = arrondi(direction(alea) * 3.0);
        let mut suite: Vec<_> = if (5..=6).contains(&self.genre) || self.genre >= 10 {
            let secondaire = |rayon: &Rayon<R>| {
                let touche = monde.premiere_intersection(rayon).ok()?;
                match self.genre {
                    5 => touche.secondaire(arrondi(direction(alea))).ok(),
                    6 => touche.reflechi(rayon.direction()).ok(),
                    12 => touche.vers_soleil(lampe).ok(),
                    _ => touche.vers_lumiere(lampe).ok(),
                }
            };
            vus.iter().filter_map(secondaire).collect()
        } else {
            vus
        };
        if self.genre == 4 || self.genre == 11 {
            alea.shuffle(&mut suite);
        }
        suite
    }

    /// Nanoseconds a ray: one by one, in a batch, and in a batch of the list.
    fn mesurer(&self, appel: usize, jeu: &str, tours: usize) -> Option<[f64; 3]> {
        if self.double {
            self.en::<f64>(appel, jeu, tours)
        } else {
            self.en::<f32>(appel, jeu, tours)
        }
    }

    fn en<R: Reel>(&self, appel: usize, jeu: &str, tours: usize) -> Option<[f64; 3]> {
        let mut alea = Rng::with_seed(self.graine);
        let objets = self.objets::<R>(&mut alea);
        let mut memoire = nous::memoire(1, objets.len());
        let monde = nous::monde(&objets, &mut memoire, jeu);
        let rayons = self.rayons(&monde, &mut alea);
        if rayons.len() < 256 {
            return None;
        }
        let mut facons = nous::concurrents(monde, &rayons, self.genre >= 10);
        let attendues = facons[2].reponses();
        assert!(facons[3].reponses() == attendues, "the ways differ: {}", self.nom());
        // A long list is not asked: no batch of a tree is expected to take as long.
        let combien = if objets.len() <= 2_000 { 3 } else { 2 };
        let ns = moindres(tours, combien, |qui| facons[[2, 3, 1][qui]].chronometrer(appel));
        Some([ns[0], ns[1], ns.get(2).copied().unwrap_or(f64::INFINITY)])
    }
}

/// By how much a batch is slower than the better of the two other ways.
fn rapport([seul, lot, liste]: [f64; 3]) -> f64 {
    lot / seul.min(liste)
}

/// What is asked for on the command line.
struct Choix {
    graine: u64,
    essais: usize,
    pas: usize,
    appels: Vec<usize>,
    jeu: String,
    disposition: Option<String>,
    tirages: bool,
}

impl Choix {
    fn lire() -> Result<Self, Box<dyn Error>> {
        let (graine, essais, pas) = (11, 60, 20);
        let (appels, jeu, disposition) = (vec![MORCEAU, 64], String::new(), None);
        let mut choix = Self { graine, essais, pas, appels, jeu, disposition, tirages: false };
        let mut arguments = std::env::args().skip(1);
        while let Some(option) = arguments.next() {
            if option == "--draws" {
                choix.tirages = true;
                continue;
            }
            let valeur = arguments.next().ok_or_else(|| format!("{option} of what?"))?;
            match option.as_str() {
                "--seed" => choix.graine = valeur.parse()?,
                "--tries" => choix.essais = valeur.parse()?,
                "--climb" => choix.pas = valeur.parse()?,
                "--call" => choix.appels = vec![valeur.parse::<usize>()?.clamp(1, MORCEAU)],
                "--layout" => choix.disposition = Some(valeur),
                "--set" => choix.jeu = valeur,
                _ => return Err(format!("no option {option}").into()),
            }
        }
        Ok(choix)
    }
}

/// Draws scenes of each layout and climbs from the worst of each; returns the times of those drawn.
fn chercher(choix: &Choix, appel: usize) -> Vec<[f64; 3]> {
    let mut alea = Rng::with_seed(choix.graine);
    let mut tires = Vec::new();
    eprintln!("in calls of {appel}: ratio, one by one, batch, batch of the list (ns), scene");
    for (disposition, nom) in DISPOSITIONS.into_iter().enumerate() {
        if choix.disposition.as_ref().is_some_and(|seule| seule != nom) {
            continue;
        }
        let mut pire: Option<(f64, Genes)> = None;
        for essai in 0..choix.essais + choix.pas {
            let mut genes: Genes = [(); 12].map(|()| alea.f64());
            genes[0] = (disposition as f64 + 0.5) / DISPOSITIONS.len() as f64;
            if let Some((_, pires)) = pire.filter(|_| essai >= choix.essais) {
                for (gene, pire) in genes[1..].iter_mut().zip(&pires[1..]) {
                    let ecart = if alea.f64() < 0.3 { 0.3 * (*gene - 0.5) } else { 0.0 };
                    *gene = (pire + ecart).clamp(0.0, 1.0);
                }
            }
            let tirage = Tirage::de(genes);
            let Some(ns) = tirage.mesurer(appel, &choix.jeu, 2) else { continue };
            if essai < choix.essais {
                tires.push(ns);
            }
            if choix.tirages {
                dire(&tirage, ns);
            }
            if pire.is_none_or(|(le_pire, _)| rapport(ns) > le_pire) {
                pire = Some((rapport(ns), genes));
            }
        }
        let Some((_, genes)) = pire else { continue };
        let tirage = Tirage::de(genes);
        if let Some(ns) = tirage.mesurer(appel, &choix.jeu, 7) {
            dire(&tirage, ns);
        }
    }
    tires
}

fn dire(tirage: &Tirage, ns: [f64; 3]) {
    let [seul, lot, liste] = ns;
    eprintln!("{:5.2} {seul:8.0} {lot:8.0} {liste:8.0}  {}", rapport(ns), tirage.nom());
}

fn main() -> Result<(), Box<dyn Error>> {
    let choix = Choix::lire()?;
    let circonstances = Circonstances::presentes().colonnes();
    println!(
        "call,batch_over,scenes,geometric_mean,above_1.1,above_1.5,above_3,largest,set,{}",
        Circonstances::TITRES
    );
    let jeu = if choix.jeu.is_empty() { "best" } else { &choix.jeu };
    for &appel in &choix.appels {
        let tires = chercher(&choix, appel);
        for quoi in ["one by one", "one by one or list"] {
            let contre = |[seul, _, liste]: &[f64; 3]| {
                if quoi == "one by one" { *seul } else { seul.min(*liste) }
            };
            let rapports: Vec<_> = tires.iter().map(|ns| ns[1] / contre(ns)).collect();
            let somme: f64 = rapports.iter().map(|x| x.ln()).sum();
            let moyenne = (somme / rapports.len() as f64).exp();
            let plus = |seuil| rapports.iter().filter(|rapport| **rapport > seuil).count();
            let [a, b, c] = [1.1, 1.5, 3.0].map(plus);
            let pire = rapports.iter().copied().fold(0.0, f64::max);
            println!(
                "{appel},{quoi},{},{moyenne:.2},{a},{b},{c},{pire:.1},{jeu},{circonstances}",
                rapports.len()
            );
        }
    }
    Ok(())
}
