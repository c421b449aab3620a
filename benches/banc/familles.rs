//! The families of scenes that are measured, the same on every run, and the kinds of rays.

use std::f64::consts::{PI, TAU};
use std::path::Path;

use fastrand::Rng;
use lancer_rayon::{
    BoiteGeo, Intersection, Monde, ObjetGeo, ObjetRay, PlanGeo, Rayon, Reel, Rotation, SphereGeo,
    Texture, Vecteur,
};

use commun::conversion::arrondi;
use commun::regimes::{direction, entre};
use commun::scenes::{en_tuiles, melange};
use exemples::scene::{self, Camera, Lisible};

/// What a scene is like.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Famille {
    Ville,
    Salle,
    Atomes,
    Stade,
    Batons,
    Poutres,
    Tailles,
    Flocon,
    Cubes,
    Piece,
    Atelier,
    Melange,
    Etageres,
    Foret,
    Treillis,
}

/// One scene, what its camera looks along, and its lamp.
pub struct Scene<R> {
    pub objets: Vec<ObjetRay<R>>,
    /// The seed from which the objects and the rays that leave them are drawn.
    graine: u64,
    /// Row by row.
    image: Vec<Rayon<R>>,
    /// The step between rays of a picture without perspective.
    pas: f64,
    pub lampe: Vecteur<R>,
}

/// The seed of what the pages report. The library is tuned with other seeds.
pub const GRAINE_DES_PAGES: u64 = 7;

/// The size of every picture.
const IMAGE: (usize, usize) = (600, 400);

impl Famille {
    pub const TOUTES: [Self; 15] = [
        Self::Ville,
        Self::Salle,
        Self::Atomes,
        Self::Stade,
        Self::Batons,
        Self::Poutres,
        Self::Tailles,
        Self::Flocon,
        Self::Cubes,
        Self::Piece,
        Self::Atelier,
        Self::Melange,
        Self::Etageres,
        Self::Foret,
        Self::Treillis,
    ];

    pub fn nom(self) -> &'static str {
        match self {
            Self::Ville => "city",
            Self::Salle => "hall",
            Self::Atomes => "atoms",
            Self::Stade => "stadium",
            Self::Batons => "sticks",
            Self::Poutres => "beams",
            Self::Tailles => "sizes",
            Self::Flocon => "snowflake",
            Self::Cubes => "cubes",
            Self::Piece => "room",
            Self::Atelier => "atelier",
            Self::Melange => "mix",
            Self::Etageres => "shelves",
            Self::Foret => "forest",
            Self::Treillis => "lattice",
        }
    }

    /// How many objects its scenes have: `usuels`, except that a room has eight or twenty-four solids in its six walls,
    /// and the atelier is what it is.
    pub fn nombres(self, usuels: &[usize]) -> &[usize] {
        if self == Self::Piece {
            &[14, 30]
        } else if self == Self::Atelier {
            &[14]
        } else {
            usuels
        }
    }

    /// The scene of `n` objects, object i with texture i, drawn from this seed.
    pub fn scene<R: Lisible>(self, n: usize, graine: u64) -> Scene<R> {
        let alea = &mut Rng::with_seed(graine);
        let vue = |camera| {
            let camera: Camera = ron::from_str(camera).expect("a camera as in a scene file");
            camera.rayons().expect(PERMIS)
        };
        let (objets, image, pas, lampe) = match self {
            Self::Ville => (ville(n, alea), vue(VUE_D_EN_HAUT), 1.0 / 32.0, [-9.0, 14.5, 9.0]),
            Self::Salle => (salle(n, alea), vue(DANS_LA_SALLE), 1.0 / 32.0, [1.0, 5.5, 2.0]),
            Self::Atomes => (atomes(n, alea), vue(DE_LOIN), 1.0 / 64.0, [-8.0, 12.0, 10.0]),
            Self::Stade => (stade(n, alea), vue(DANS_LE_STADE), 1.0 / 128.0, [-8.0, 12.5, 10.0]),
            Self::Batons => (batons(n, alea), vue(DE_LOIN), 1.0 / 64.0, [-8.0, 12.0, 10.0]),
            Self::Poutres => (poutres(n, alea), vue(DE_LOIN), 1.0 / 64.0, [-8.0, 12.0, 10.0]),
            Self::Tailles => (tailles(n, alea), vue(DE_LOIN), 1.0 / 64.0, [-8.0, 12.0, 10.0]),
            Self::Flocon => (flocon(n), vue(DEVANT_LE_FLOCON), 1.0 / 64.0, [-8.0, 16.0, 10.0]),
            Self::Cubes => {
                let (objets, cote) = cubes(n, alea);
                // The picture is as wide as the terrain, or a part of it from the largest on.
                let pas = cote.next_power_of_two().min(64) as f64 / 512.0;
                let image = sans_perspective(pas, |i| VUES_SUR_LES_CUBES[3 * i / IMAGE.0]);
                (objets, image, pas, [-0.4 * cote as f64, 20.0, 0.6 * cote as f64])
            }
            Self::Piece => (piece(n, alea), vue(DANS_LA_PIECE), 1.0 / 32.0, [1.0, 6.0, 2.0]),
            Self::Atelier => {
                let chemin = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/scenes/atelier.ron");
                let atelier =
                    scene::Scene::lire(Path::new(chemin)).expect("the scene of the README");
                let objets = atelier.objets.into_iter().map(ObjetGeo::vers_ray).collect();
                let image = atelier.camera.rayons().expect(PERMIS);
                (objets, image, 1.0 / 64.0, [-2.6, 7.2, 5.2])
            }
            Self::Melange => (melange(n), vue(DEVANT), 1.0 / 32.0, [-2.6, 8.2, 5.2]),
            Self::Etageres => {
                (etageres(n, alea), vue(DEVANT_LES_ETAGERES), 1.0 / 64.0, [-4.0, 7.5, 6.0])
            }
            Self::Foret => (foret(n, alea), vue(DANS_LA_FORET), 1.0 / 32.0, [-9.0, 25.0, 12.0]),
            Self::Treillis => (treillis(n), vue(DE_COTE), 1.0 / 64.0, [-8.0, 14.0, 10.0]),
        };
        Scene { objets, graine, image, pas, lampe: arrondi(lampe.into()) }
    }
}

const VUE_D_EN_HAUT: &str = "(source: (3, 9.5, 22), regard: Point((0, 0.5, 0)), champ: 42)";
const DANS_LA_SALLE: &str = "(source: (4, 3.5, 9), regard: Point((0, 1, 0)), champ: 55)";
const DE_LOIN: &str = "(source: (0, 2, 16), regard: Point((0, 0, 0)), champ: 42)";
const DANS_LE_STADE: &str = "(source: (0, 2.5, 9), regard: Point((0, 1.2, 0)), champ: 30)";
const DEVANT_LE_FLOCON: &str = "(source: (0, 6, 16), regard: Point((0, 4, 0)), champ: 42)";
const DANS_LA_PIECE: &str = "(source: (4, 4, 9), regard: Point((0, 1.5, 0)), champ: 55)";
const DEVANT_LES_ETAGERES: &str = "(source: (3, 3.5, 9), regard: Point((0, 2.5, 0)), champ: 42)";
const DANS_LA_FORET: &str = "(source: (0, 1.7, 10), regard: Point((1, 2.5, 0)), champ: 55)";
const DE_COTE: &str = "(source: (6, 5, 13), regard: Point((0, 0, 0)), champ: 42)";
const DEVANT: &str = "(source: (0, 2, 6), regard: Rotation((0, 0, 0)), champ: 50)";

/// Where the three parts of the picture of the cubes look: along an axis, along a face, and askew.
const VUES_SUR_LES_CUBES: [Vecteur; 3] =
    [EN_BAS, Vecteur::new(0.0, -0.6, -0.8), Vecteur::new(-0.48, -0.6, -0.64)];

const EN_BAS: Vecteur = Vecteur::new(0.0, -1.0, 0.0);

/// Parallel rays to every point of a grid on the ground, row by row, with a direction for each column. The coordinates
/// of the grid are exact, and some are integers, where the sides of the cubes stand.
fn sans_perspective<R: Reel>(pas: f64, vers: impl Fn(usize) -> Vecteur) -> Vec<Rayon<R>> {
    let (largeur, hauteur) = IMAGE;
    // They start above all that is seen; from much farther away others lose small objects in rounding.
    let haut = (largeur as f64 * pas).max(12.0);
    let pixels = (0..hauteur).flat_map(|j| (0..largeur).map(move |i| (i, j)));
    let rayon = |(i, j)| {
        let [x, z] = [(i, largeur), (j, hauteur)].map(|(k, n)| (k as f64 - n as f64 / 2.0) * pas);
        let vers = vers(i);
        let source = Vecteur::new(x, 0.0, z) + vers * (haut / vers.y);
        Rayon::new(arrondi(source), arrondi(vers)).expect(PERMIS)
    };
    pixels.map(rayon).collect()
}

/// What is far from a city of one kilometre, or so large that its middle is. Most scene files have such things.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AuLoin {
    Rien,
    /// A sun at this distance, as large as ours looks.
    Soleil,
    /// A sky, a ball of this radius around all.
    Ciel,
    /// The ground is a ball of this radius.
    Globe,
    /// Half of the houses stand this far away.
    DeuxVilles,
    /// The camera stands this far away.
    Camera,
}

/// A metre, in the city.
const METRE: f64 = 0.02;

impl AuLoin {
    pub fn nom(self) -> &'static str {
        match self {
            Self::Rien => "nothing",
            Self::Soleil => "a sun",
            Self::Ciel => "a sky",
            Self::Globe => "a globe",
            Self::DeuxVilles => "two towns",
            Self::Camera => "a camera",
        }
    }

    /// The city of `n` objects with this, `metres` away or in radius.
    pub fn scene<R: Lisible>(self, n: usize, graine: u64, metres: f64) -> Scene<R> {
        let mut scene = Famille::Ville.scene::<R>(n, graine);
        let loin = metres * METRE;
        match self {
            Self::Rien => {}
            Self::Soleil => {
                scene.objets[n / 2] =
                    sphere([0.6 * loin, 0.64 * loin, 0.48 * loin], loin / 215.0, n / 2);
            }
            Self::Ciel => scene.objets[n / 2] = sphere([0.0, 0.0, 0.0], loin, n / 2),
            Self::Globe => scene.objets[0] = sphere([0.0, -loin, 0.0], loin, 0),
            Self::DeuxVilles => {
                let pas = Vecteur::new(0.8 * loin, 0.0, 0.6 * loin);
                for objet in scene.objets.iter_mut().skip(1).step_by(2) {
                    let ObjetRay::Boite(boite) = *objet else { continue };
                    let [c, l] =
                        [boite.centre().vers_f64(), boite.demi_longueurs().map(R::vers_f64).into()];
                    let rotation = Rotation::depuis_matrice(boite.normales().map(Into::into));
                    let boite = BoiteGeo::new(
                        arrondi(c + pas),
                        arrondi(l * 2.0),
                        rotation.expect(PERMIS),
                        boite.texture(),
                    );
                    *objet = boite.expect(PERMIS).into();
                }
            }
            Self::Camera => {
                // The city looks as large as from nearby.
                let k = loin / 24.0;
                let [x, y, z] = [3.0 * k, 9.5 * k, 22.0 * k];
                let champ = 2.0 * ((42.0_f64.to_radians() / 2.0).tan() / k).atan().to_degrees();
                let camera = format!(
                    "(source: ({x}, {y}, {z}), regard: Point((0, 0.5, 0)), champ: {champ})"
                );
                let camera: Camera = ron::from_str(&camera).expect("a camera as in a scene file");
                scene.image = camera.rayons().expect(PERMIS);
            }
        }
        scene
    }
}

/// The ground, and houses along streets that run a little askew, each turned a little, with some towers.
fn ville<R: Reel>(n: usize, alea: &mut Rng) -> Vec<ObjetRay<R>> {
    let cote = ((n - 1) as f64).sqrt().ceil();
    // A lot; after every four comes a street, each way.
    let lot = 20.0 / (cote * 1.25);
    let mut objets = vec![sol()];
    for i in 0..n - 1 {
        let ou = [i as f64 % cote, (i as f64 / cote).floor()];
        let [x, z] = ou.map(|k| (k + (k / 4.0).floor()) * lot - 10.0);
        let tour = if alea.u8(..16) == 0 { 3.0 } else { 1.0 };
        let haut = lot * tour * entre(alea, 0.5, 1.5);
        let dimensions = [lot * entre(alea, 0.5, 0.9), haut, lot * entre(alea, 0.5, 0.9)];
        let (sin, cos) = 0.3_f64.sin_cos();
        let centre = [x * cos - z * sin, haut / 2.0, x * sin + z * cos];
        objets.push(boite(centre, dimensions, [0.0, 0.3 + entre(alea, -0.1, 0.1), 0.0], i + 1));
    }
    objets
}

/// A floor, four walls and tables of one thickness, all of them boxes, with one to sixteen small things on each table.
fn salle<R: Reel>(n: usize, alea: &mut Rng) -> Vec<ObjetRay<R>> {
    let mut objets = Vec::new();
    for (centre, dimensions) in [
        ([0.0, -0.1, 0.0], [20.0, 0.2, 20.0]),
        ([0.0, 3.0, -10.1], [20.0, 6.0, 0.2]),
        ([-10.1, 3.0, 0.0], [0.2, 6.0, 20.0]),
        ([10.1, 3.0, 0.0], [0.2, 6.0, 20.0]),
        ([0.0, 3.0, 10.1], [20.0, 6.0, 0.2]),
    ] {
        objets.push(boite(centre, dimensions, [0.0; 3], objets.len()));
    }
    // With fewer objects than walls only walls are left.
    objets.truncate(n);
    let choses = n - objets.len();
    let rangee = (choses as f64 / 17.0).sqrt().ceil().max(1.0);
    let table = 16.0 / rangee;
    for i in 0..choses {
        let (numero, place) = ((i / 17) as f64, i % 17);
        let ou = [numero % rangee, (numero / rangee).floor()];
        let [x, z] = ou.map(|k| (k + 0.5) * table - 8.0);
        objets.push(if place == 0 {
            boite([x, 1.0, z], [0.7 * table, 0.1, 0.7 * table], [0.0; 3], objets.len())
        } else {
            let r = 0.04 * table * entre(alea, 0.5, 1.5);
            let x = x + 0.3 * table * entre(alea, -1.0, 1.0);
            let z = z + 0.3 * table * entre(alea, -1.0, 1.0);
            chose(alea, [x, 1.05 + r, z], r, objets.len())
        });
    }
    objets
}

/// A chain of overlapping balls that folds up within a ball.
fn atomes<R: Reel>(n: usize, alea: &mut Rng) -> Vec<ObjetRay<R>> {
    let r = 5.0 * (0.3 / n as f64).cbrt();
    let mut ou = Vecteur::NUL;
    let atome = |i| {
        loop {
            let suivant = ou + direction(alea) * (1.3 * r);
            if suivant.longueur() < 5.0 {
                ou = suivant;
                break;
            }
        }
        sphere(ou.into(), r * entre(alea, 0.8, 1.2), i)
    };
    (0..n).map(atome).collect()
}

/// The ground, half of all objects in a heap as large as a teapot, and the other half around a stadium.
fn stade<R: Reel>(n: usize, alea: &mut Rng) -> Vec<ObjetRay<R>> {
    let r = (1.0 / n as f64).cbrt();
    let mut objets = vec![sol()];
    for i in 1..n {
        objets.push(if i.is_multiple_of(2) {
            let ou = direction(alea) * alea.f64().cbrt();
            let taille = 0.4 * r * entre(alea, 0.5, 1.5);
            chose(alea, [ou.x, 1.0 + ou.y, ou.z], taille, i)
        } else {
            let (a, loin) = (entre(alea, 0.0, TAU), entre(alea, 30.0, 60.0));
            let taille = 8.0 * r * entre(alea, 0.5, 1.5);
            let haut = (loin - 30.0) * entre(alea, 0.0, 0.8);
            chose(alea, [loin * a.cos(), haut, loin * a.sin()], taille, i)
        });
    }
    objets
}

/// Long thin boxes at random.
fn batons<R: Reel>(n: usize, alea: &mut Rng) -> Vec<ObjetRay<R>> {
    let large = 1.5 / (n as f64).powf(0.6);
    let baton = |i| {
        let ou = direction(alea) * (5.0 * alea.f64().cbrt());
        let tour = [(); 3].map(|()| entre(alea, 0.0, TAU));
        boite(ou.into(), [large, 4.0 * entre(alea, 0.5, 1.0), large], tour, i)
    };
    (0..n).map(baton).collect()
}

/// Poles, planks and beams of all lengths, a fifth of them along the axes, among as many spheres and boxes.
fn poutres<R: Reel>(n: usize, alea: &mut Rng) -> Vec<ObjetRay<R>> {
    let large = 0.6 / (n as f64).sqrt();
    let poutre = |i: usize| {
        let ou = direction(alea) * (5.0 * alea.f64().cbrt());
        if i % 4 < 2 {
            let r = 2.0 / (n as f64).cbrt() * entre(alea, 0.3, 0.8);
            return chose(alea, ou.into(), r, i);
        }
        let long = 0.25 * 16.0_f64.powf(alea.f64());
        let [a, b]: [f64; 2] = [[1.0, 1.0], [6.0, 1.0], [2.0, 3.0]][alea.usize(..3)];
        let tour = if alea.u8(..5) == 0 {
            [(); 3].map(|()| f64::from(alea.u8(..4)) * PI / 2.0)
        } else {
            [(); 3].map(|()| entre(alea, 0.0, TAU))
        };
        boite(ou.into(), [a * large, long, b * large], tour, i)
    };
    (0..n).map(poutre).collect()
}

/// A few large objects and many small ones: the i-th largest is as large as 1/√i.
fn tailles<R: Reel>(n: usize, alea: &mut Rng) -> Vec<ObjetRay<R>> {
    let mut rangs: Vec<_> = (1..=n).collect();
    alea.shuffle(&mut rangs);
    let chose = |(i, rang): (usize, usize)| {
        let ou = direction(alea) * (5.0 * alea.f64().cbrt());
        chose(alea, ou.into(), 1.2 / (rang as f64).sqrt(), i)
    };
    rangs.into_iter().enumerate().map(chose).collect()
}

/// The ground, and balls on balls: nine of a third of its radius on each.
fn flocon<R: Reel>(n: usize) -> Vec<ObjetRay<R>> {
    // Centre, radius, and the way outward.
    let mut boules = vec![(Vecteur::new(0.0, 4.0, 0.0), 2.4, Vecteur::new(0.0, 1.0, 0.0))];
    let mut mere = 0;
    while boules.len() < n - 1 {
        let (centre, rayon, z) = boules[mere];
        mere += 1;
        let x = z.produit_vectoriel(Vecteur::new(0.6, 0.48, 0.64)).unitaire().expect("no axis");
        let y = z.produit_vectoriel(x);
        // Six around the equator, three above.
        for i in 0..9 {
            let (tour, haut): (f64, f64) =
                if i < 6 { (f64::from(i) / 6.0, 0.0) } else { (f64::from(i) / 3.0, 0.9) };
            let ((sin, cos), (haut, bas)) = ((tour * TAU).sin_cos(), haut.sin_cos());
            let vers = (x * cos + y * sin) * bas + z * haut;
            boules.push((centre + vers * (rayon * 4.0 / 3.0), rayon / 3.0, vers));
        }
    }
    let boules = boules.into_iter().enumerate();
    let boules = boules.map(|(i, (centre, rayon, _))| sphere(centre.into(), rayon, i + 1));
    [sol()].into_iter().chain(boules).take(n).collect()
}

/// The ground, and a terrain of unit cubes side by side, each on whatever stands in its place; and how many columns a
/// side has.
fn cubes<R: Reel>(n: usize, alea: &mut Rng) -> (Vec<ObjetRay<R>>, usize) {
    let cote = ((n - 1) as f64 / 4.0).sqrt().ceil() as usize;
    let mut hauteurs = vec![0.0; cote * cote];
    let mut objets = vec![sol()];
    for i in 1..n {
        let ou = alea.usize(..hauteurs.len());
        let [x, z] = [ou % cote, ou / cote].map(|k| k as f64 - (cote / 2) as f64 + 0.5);
        objets.push(boite([x, hauteurs[ou] + 0.5, z], [1.0; 3], [0.0; 3], i));
        hauteurs[ou] += 1.0;
    }
    (objets, cote)
}

/// Six half-spaces with spheres and boxes between them.
fn piece<R: Reel>(n: usize, alea: &mut Rng) -> Vec<ObjetRay<R>> {
    let murs: [([f64; 3], [f64; 3]); 6] = [
        ([0.0, 1.0, 0.0], [0.0, 0.0, 0.0]),
        ([0.0, -1.0, 0.0], [0.0, 6.5, 0.0]),
        ([1.0, 0.0, 0.0], [-10.0, 0.0, 0.0]),
        ([-1.0, 0.0, 0.0], [10.0, 0.0, 0.0]),
        ([0.0, 0.0, 1.0], [0.0, 0.0, -10.0]),
        ([0.0, 0.0, -1.0], [0.0, 0.0, 10.0]),
    ];
    let murs = murs.into_iter().enumerate().map(|(i, (vers, ou))| demi_espace(ou, vers, i));
    let mut objets: Vec<_> = murs.take(n).collect();
    while objets.len() < n {
        let r = 3.0 / (n as f64).cbrt() * entre(alea, 0.3, 0.8);
        let haut = r + entre(alea, 0.0, 2.0);
        let ou = [entre(alea, -5.0, 5.0), haut, entre(alea, -7.0, 4.0)];
        objets.push(chose(alea, ou, r, objets.len()));
    }
    objets
}

/// The ground, and shelves against a wall, with ten places on each board, eight of which hold a book that may lean or a
/// ball.
fn etageres<R: Reel>(n: usize, alea: &mut Rng) -> Vec<ObjetRay<R>> {
    const PLACES: usize = 10;
    let mut objets = vec![sol(), demi_espace([0.0, 0.0, -0.6], [0.0, 0.0, 1.0], 1)];
    // A board comes with an upright at its left end and what stands on the board.
    let planches = ((n - objets.len()) as f64 / 10.0).ceil();
    let colonnes = (planches / 3.0).sqrt().ceil();
    let (large, haut) = (8.0 / colonnes, 6.0 / (planches / colonnes).ceil());
    let mut numero = 0;
    while objets.len() < n {
        let [x, y] = [numero % colonnes as usize, numero / colonnes as usize].map(|k| k as f64);
        let (gauche, bas) = (x * large - 4.0, y * haut + 0.1 * haut);
        numero += 1;
        let planche = [gauche + large / 2.0, bas, 0.0];
        objets.push(boite(planche, [large, 0.04 * haut, 1.0], [0.0; 3], objets.len()));
        let montant = [gauche, bas + haut / 2.0, 0.0];
        objets.push(boite(montant, [0.03 * large, haut, 1.0], [0.0; 3], objets.len()));
        let pas = 0.9 * large / PLACES as f64;
        let mut places: Vec<_> = (0..PLACES).collect();
        alea.shuffle(&mut places);
        for place in &places[..8] {
            let x = gauche + 0.08 * large + (*place as f64 + 0.5) * pas;
            let dessus = bas + 0.02 * haut;
            objets.push(if alea.u8(..5) == 0 {
                let r = 0.45 * pas.min(haut);
                sphere([x, dessus + r, entre(alea, -0.2, 0.3)], r, objets.len())
            } else {
                let dimensions = [
                    pas * entre(alea, 0.3, 0.9),
                    haut * entre(alea, 0.5, 0.85),
                    entre(alea, 0.5, 0.8),
                ];
                let penche = if alea.u8(..4) == 0 { entre(alea, -0.1, 0.1) } else { 0.0 };
                let ou = [x, dessus + dimensions[1] / 2.0, entre(alea, -0.1, 0.1)];
                boite(ou, dimensions, [0.0, 0.0, penche], objets.len())
            });
        }
    }
    objets.truncate(n);
    objets
}

/// The ground, and trees here and there, with a trunk that leans a little and a crown of five balls.
fn foret<R: Reel>(n: usize, alea: &mut Rng) -> Vec<ObjetRay<R>> {
    let mut objets = vec![sol()];
    let arbres = ((n - 1) as f64 / 6.0).ceil();
    // The wood is so wide that trees stand as far apart whatever their number.
    let taille = 12.0 / arbres.sqrt().max(3.0);
    while objets.len() < n {
        let [x, z] = [(); 2].map(|()| entre(alea, -12.0, 12.0));
        let haut = taille * entre(alea, 0.7, 1.3);
        let penche = [(); 3].map(|()| entre(alea, -0.1, 0.1));
        let tronc = [0.08 * haut, haut, 0.08 * haut];
        objets.push(boite([x, haut / 2.0, z], tronc, penche, objets.len()));
        for _ in 0..5 {
            let autour = direction(alea) * (0.3 * haut);
            let r = haut * entre(alea, 0.12, 0.3);
            let ou = [x + autour.x, haut + autour.y, z + autour.z];
            objets.push(sphere(ou, r, objets.len()));
        }
    }
    objets.truncate(n);
    objets
}

/// Balls on the corners of a grid, and thin rods along its edges that stop short of them.
fn treillis<R: Reel>(n: usize) -> Vec<ObjetRay<R>> {
    let cote = (n as f64 / 4.0).cbrt().ceil() as usize;
    let pas = 9.0 / cote as f64;
    let coins = (0..).map(|i| [i % cote, i / cote % cote, i / cote / cote]);
    let coins = coins.map(|ou| ou.map(|k| (k as f64 + 0.5) * pas - 4.5));
    let mut objets = Vec::new();
    for [x, y, z] in coins {
        objets.push(sphere([x, y, z], 0.16 * pas, objets.len()));
        for axe in 0..3 {
            let (mut ou, mut dimensions) = ([x, y, z], [0.06 * pas; 3]);
            ou[axe] += pas / 2.0;
            dimensions[axe] = 0.6 * pas;
            objets.push(boite(ou, dimensions, [0.0; 3], objets.len()));
        }
        if objets.len() >= n {
            break;
        }
    }
    objets.truncate(n);
    objets
}

/// A sphere or a turned box, of this size.
fn chose<R: Reel>(alea: &mut Rng, ou: [f64; 3], r: f64, i: usize) -> ObjetRay<R> {
    if i.is_multiple_of(2) {
        return sphere(ou, r, i);
    }
    let dimensions = [(); 3].map(|()| r * entre(alea, 0.7, 1.7));
    boite(ou, dimensions, [(); 3].map(|()| entre(alea, -PI, PI)), i)
}

const PERMIS: &str = "a scene lies within every limit";

fn sphere<R: Reel>(centre: [f64; 3], rayon: f64, i: usize) -> ObjetRay<R> {
    let sphere = SphereGeo::new(arrondi(centre.into()), R::depuis_f64(rayon), Texture(i as u32));
    sphere.expect(PERMIS).into()
}

fn boite<R: Reel>(
    centre: [f64; 3],
    dimensions: [f64; 3],
    rotation: [f64; 3],
    i: usize,
) -> ObjetRay<R> {
    let rotation = Rotation::new(arrondi(rotation.into())).expect(PERMIS);
    let [centre, dimensions] = [centre, dimensions].map(|v| arrondi(v.into()));
    BoiteGeo::new(centre, dimensions, rotation, Texture(i as u32)).expect(PERMIS).into()
}

fn demi_espace<R: Reel>(ou: [f64; 3], vers: [f64; 3], i: usize) -> ObjetRay<R> {
    let [ou, vers] = [ou, vers].map(|v| arrondi(v.into()));
    PlanGeo::par_un_point(ou, vers, Texture(i as u32)).expect(PERMIS).into()
}

/// The ground at height 0, which is object 0.
fn sol<R: Reel>() -> ObjetRay<R> {
    demi_espace([0.0; 3], [0.0, 1.0, 0.0], 0)
}

/// The kinds of rays, and their order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Genre {
    /// Camera rays in tiles of 8 × 8.
    Tuiles,
    /// Camera rays row by row.
    Rangees,
    /// Straight down without perspective, in tiles.
    Paralleles,
    /// Reflected by what the camera sees, in tiles.
    Miroirs,
    /// Mirrored so, but off by up to 0.05.
    Rugueux,
    /// Scattered about the normal of what the camera sees, in tiles.
    Diffus,
    /// From what the camera sees outward in any direction, shuffled.
    SansOrdre,
    /// From what the camera sees to the lamp, in tiles.
    Ombres,
    /// Camera rays, shuffled.
    Melees,
    /// From what the camera sees to the lamp, shuffled.
    OmbresMelees,
}

/// How far ahead others start, who might hit again what a ray leaves.
pub const AVANCE: f64 = 0.001;

impl Genre {
    pub const TOUS: [Self; 10] = [
        Self::Tuiles,
        Self::Rangees,
        Self::Paralleles,
        Self::Miroirs,
        Self::Rugueux,
        Self::Diffus,
        Self::SansOrdre,
        Self::Ombres,
        Self::Melees,
        Self::OmbresMelees,
    ];

    pub fn nom(self) -> &'static str {
        match self {
            Self::Tuiles => "tiles",
            Self::Rangees => "rows",
            Self::Paralleles => "parallel",
            Self::Miroirs => "mirrors",
            Self::Rugueux => "rough",
            Self::Diffus => "diffuse",
            Self::SansOrdre => "no order",
            Self::Ombres => "shadows",
            Self::Melees => "shuffled",
            Self::OmbresMelees => "shuf. shad.",
        }
    }

    /// Whether each ray is asked whether it is a shadow. It ends at the lamp then; no other ray has an end.
    pub fn ombres(self) -> bool {
        matches!(self, Self::Ombres | Self::OmbresMelees)
    }

    /// Whether each ray leaves an object, as no ray of a camera does.
    pub fn partent(self) -> bool {
        !matches!(self, Self::Tuiles | Self::Rangees | Self::Paralleles | Self::Melees)
    }

    /// The rays of this kind from `bandes` of the picture's bands of eight rows, evenly spaced.
    pub fn rayons<R: Reel>(
        self,
        monde: &Monde<'_, R>,
        scene: &Scene<R>,
        bandes: usize,
    ) -> Vec<Rayon<R>> {
        self.departs(monde, scene, bandes).into_iter().map(|(rayon, _)| rayon).collect()
    }

    /// These rays, each with the hit that it leaves, if it leaves one.
    pub fn departs<R: Reel>(
        self,
        monde: &Monde<'_, R>,
        scene: &Scene<R>,
        bandes: usize,
    ) -> Vec<(Rayon<R>, Option<Intersection<R>>)> {
        let image = if self == Self::Paralleles {
            &sans_perspective(scene.pas, |_| EN_BAS)
        } else {
            &scene.image
        };
        let (largeur, toutes) = (IMAGE.0, IMAGE.1 / 8);
        let choisies = (0..bandes).map(|i| (2 * i + 1) * toutes / (2 * bandes));
        let choisies = choisies.flat_map(|i| &image[8 * largeur * i..8 * largeur * (i + 1)]);
        let rangees: Vec<_> = choisies.copied().collect();
        let de_la_camera = |rayon| (rayon, None);
        if self == Self::Rangees {
            return rangees.into_iter().map(de_la_camera).collect();
        }
        let mut rayons: Vec<_> =
            en_tuiles(&rangees, largeur).into_iter().map(de_la_camera).collect();
        if self.partent() {
            let mut alea = Rng::with_seed(scene.graine + 1);
            let parti = |(rayon, _): &(Rayon<R>, _)| {
                let touche = monde.premiere_intersection(rayon).ok()?;
                Some((self.depuis(rayon, &touche, scene.lampe, &mut alea)?, Some(touche)))
            };
            rayons = rayons.iter().filter_map(parti).collect();
        }
        if matches!(self, Self::SansOrdre | Self::Melees | Self::OmbresMelees) {
            Rng::with_seed(scene.graine + 2).shuffle(&mut rayons);
        }
        rayons
    }

    /// The same rays, started ahead of what they leave.
    pub fn en_avant<R: Reel>(self, rayons: &[Rayon<R>]) -> Vec<Rayon<R>> {
        let avance = R::depuis_f64(if self.partent() { AVANCE } else { 0.0 });
        let avancer = |rayon: &Rayon<R>| {
            let fin = rayon.fin() - avance;
            let fin = if fin > R::ZERO { fin } else { R::ZERO };
            Rayon::new(rayon.point(avance), rayon.direction())?.jusqu_a(fin)
        };
        rayons.iter().map(|rayon| avancer(rayon).expect(PERMIS)).collect()
    }

    /// The ray of this kind that leaves this hit, if it goes outward.
    fn depuis<R: Reel>(
        self,
        rayon: &Rayon<R>,
        touche: &Intersection<R>,
        lampe: Vecteur<R>,
        alea: &mut Rng,
    ) -> Option<Rayon<R>> {
        let (d, n) = (rayon.direction().vers_f64(), touche.normale().vers_f64());
        let reflet = d - n * (2.0 * d.produit_scalaire(n));
        let vers = match self {
            Self::Tuiles | Self::Rangees | Self::Paralleles | Self::Melees => return None,
            Self::Ombres | Self::OmbresMelees => return touche.vers_lumiere(lampe).ok(),
            Self::Miroirs => reflet,
            Self::Rugueux => reflet + direction(alea) * 0.05,
            Self::Diffus => n + direction(alea),
            Self::SansOrdre => {
                let vers = direction(alea);
                vers * vers.produit_scalaire(n).signum()
            }
        };
        let parti = touche.secondaire(arrondi(vers)).ok()?;
        (vers.produit_scalaire(n) > 0.0).then_some(parti)
    }
}
