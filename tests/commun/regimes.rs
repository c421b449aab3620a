//! The extremes, each a directed generator of one object and one ray. Random rays meet a leak at an edge once in
//! millions; these rays meet it at every step.

use core::f64::consts::{FRAC_PI_2, TAU};

use lancer_rayon::{
    BoiteGeo, ObjetGeo, ObjetRay, PlanGeo, Rayon, Reel, Rotation, SphereGeo, Texture, Vecteur,
};

use crate::conversion::arrondi;
use crate::hasard::{Hasard, Tirage};

#[derive(Debug, Clone, Copy)]
pub struct Cas<R> {
    pub objet: ObjetRay<R>,
    pub rayon: Rayon<R>,
}

/// The three shapes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Genre {
    Sphere,
    Plan,
    Boite,
}

impl Genre {
    pub const TOUS: [Self; 3] = [Self::Sphere, Self::Plan, Self::Boite];

    pub fn de<R: Reel>(objet: &ObjetRay<R>) -> Self {
        match objet {
            ObjetRay::Sphere(_) => Self::Sphere,
            ObjetRay::Plan(_) => Self::Plan,
            ObjetRay::Boite(_) => Self::Boite,
        }
    }
}

/// What is hard about a regime.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extreme {
    /// Nothing.
    Aucun,
    /// The object is small beside its distance from the source or from the origin.
    Loin,
    /// The ray is nearly parallel to the surface, so that hits may lie anywhere.
    Parallele,
    /// Numbers at the ends of their range.
    Bornes,
    /// The decision hangs on the last bits.
    Decision,
}

pub struct Regime<R> {
    pub genre: Genre,
    pub extreme: Extreme,
    pub nom: &'static str,
    pub cas: fn(&mut dyn Tirage) -> Cas<R>,
}

pub fn regimes<R: Reel>() -> [Regime<R>; 19] {
    use Extreme::{Aucun, Bornes, Decision, Loin, Parallele};
    use Genre::{Boite, Plan, Sphere};
    let regime = |genre, extreme, nom, cas| Regime { genre, extreme, nom, cas };
    [
        regime(Sphere, Aucun, "sphere, ordinary", |a| ordinaire(a, boule)),
        regime(Sphere, Loin, "sphere, far and small", |a| loin(a, boule)),
        regime(Sphere, Loin, "sphere, far from the origin", |a| loin_de_l_origine(a, boule)),
        regime(Sphere, Decision, "sphere, grazing", sphere_rasante),
        regime(Sphere, Decision, "sphere, close above the surface", |a| au_ras(a, boule)),
        regime(Sphere, Decision, "sphere, source within ulps of the surface", |a| {
            a_quelques_ulp(a, boule)
        }),
        regime(Sphere, Bornes, "sphere, at the ends of the range", |a| bornes(a, boule)),
        regime(Plan, Aucun, "half-space, ordinary", |a| ordinaire(a, demi_espace)),
        regime(Plan, Parallele, "half-space, almost parallel", plan_rasant),
        regime(Plan, Decision, "half-space, close above the surface", |a| au_ras(a, demi_espace)),
        regime(Plan, Bornes, "half-space, at the ends of the range", |a| bornes(a, demi_espace)),
        regime(Boite, Aucun, "box, ordinary", |a| ordinaire(a, boite)),
        regime(Boite, Loin, "box, far and small", |a| loin(a, boite)),
        regime(Boite, Loin, "box, far from the origin", |a| loin_de_l_origine(a, boite)),
        regime(Boite, Decision, "box, edges and corners", aretes),
        regime(Boite, Decision, "box, along the plane of a face", le_long_d_une_face),
        regime(Boite, Decision, "box, almost along a face", presque_le_long_d_une_face),
        regime(Boite, Decision, "box, close above the surface", |a| au_ras(a, boite)),
        regime(Boite, Bornes, "box, at the ends of the range", |a| bornes(a, boite)),
    ]
}

/// Makes an object of about this size with its centre here; a half-space has a point of its surface here.
type Forme<R> = fn(&mut dyn Tirage, Vecteur, f64) -> ObjetGeo<R>;

pub fn entre(alea: &mut dyn Tirage, min: f64, max: f64) -> f64 {
    min + (max - min) * alea.f64()
}

/// 2^x, with x anywhere between the two.
pub fn deux_puissance(alea: &mut dyn Tirage, min: f64, max: f64) -> f64 {
    entre(alea, min, max).exp2()
}

pub fn direction(alea: &mut dyn Tirage) -> Vecteur {
    let (z, a) = (entre(alea, -1.0, 1.0), entre(alea, 0.0, TAU));
    let r = (1.0 - z * z).sqrt();
    Vecteur::new(r * a.cos(), r * a.sin(), z)
}

/// 1 or −1.
pub fn signe(alea: &mut dyn Tirage) -> f64 {
    f64::from(1 - 2 * i8::from(alea.bool()))
}

/// The vector product.
pub fn vectoriel(a: Vecteur, b: Vecteur) -> Vecteur {
    Vecteur::new(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x)
}

/// A matrix whose last row is this normal.
pub fn repere<R: Reel>(normale: Vecteur<R>) -> [[R; 3]; 3] {
    let n = normale.vers_f64();
    let cote =
        if n.x.abs() < 0.6 { Vecteur::new(1.0, 0.0, 0.0) } else { Vecteur::new(0.0, 1.0, 0.0) };
    let x = (cote - n * n.produit_scalaire(cote)).unitaire().unwrap();
    let y = vectoriel(n, x);
    [arrondi(x).into(), arrondi(y).into(), normale.into()]
}

/// A mirror whose |N|² − 1 is nearly the 8u up to which N is kept, unless rounding adds so much that its matrix is
/// polished; and a ray from the end of N, whose |D| is nearly 5u off, at the angle at which that turns its image most.
pub fn miroir<R: Reel>(alea: &mut dyn Tirage) -> Cas<R> {
    miroir_sous(0.743, alea)
}

/// The same at the angle of incidence with this sine.
pub fn miroir_sous<R: Reel>(sinus: f64, alea: &mut dyn Tirage) -> Cas<R> {
    let (n, u) = (direction(alea), R::U.vers_f64());
    let k = 1.0 + 3.9 * u;
    let m = repere::<f64>(n).map(|ligne| <[R; 3]>::from(arrondi(Vecteur::from(ligne) * k)));
    let plan = PlanGeo::new(Rotation::depuis_matrice(m).unwrap(), R::ZERO, Texture(0)).unwrap();
    let d = travers(alea, n) * sinus - n * (1.0 - sinus * sinus).sqrt();
    let rayon = Rayon::new(arrondi(n), arrondi(d * (1.0 + 5.0 * u))).unwrap();
    Cas { objet: ObjetGeo::from(plan).vers_ray(), rayon }
}

/// A unit vector across `d`.
fn travers(alea: &mut dyn Tirage, d: Vecteur) -> Vecteur {
    loop {
        let v = direction(alea);
        let v = v - d * v.produit_scalaire(d);
        if v.longueur() > 0.1 {
            return v / v.longueur();
        }
    }
}

/// Three angles; half of the time quarter turns, whose matrix is exact.
pub fn angles<R: Reel>(alea: &mut dyn Tirage) -> Vecteur<R> {
    let quarts = alea.bool();
    let angle = |()| {
        let quart = if quarts { Some(f64::from(alea.i8(-4..=4)) * FRAC_PI_2) } else { None };
        R::depuis_f64(quart.unwrap_or_else(|| entre(alea, -7.0, 7.0)))
    };
    [(); 3].map(angle).into()
}

pub fn rotation<R: Reel>(alea: &mut dyn Tirage) -> Rotation<R> {
    Rotation::new(angles(alea)).unwrap()
}

/// The nearest number that a scene can hold.
fn borne<R: Reel>(x: f64) -> R {
    let limite = R::LIMITE.vers_f64();
    R::depuis_f64(x.clamp(-limite, limite))
}

fn lieu<R: Reel>(v: Vecteur) -> Vecteur<R> {
    Vecteur::new(borne(v.x), borne(v.y), borne(v.z))
}

fn taille<R: Reel>(x: f64) -> R {
    let limite = R::LIMITE.vers_f64();
    R::depuis_f64(x.clamp(limite.recip(), limite))
}

fn boule<R: Reel>(_: &mut dyn Tirage, centre: Vecteur, r: f64) -> ObjetGeo<R> {
    SphereGeo::new(lieu(centre), taille(r), Texture(0)).unwrap().into()
}

fn demi_espace<R: Reel>(alea: &mut dyn Tirage, en: Vecteur, _: f64) -> ObjetGeo<R> {
    let r = rotation(alea);
    let n = Vecteur::from(r.matrice()[2]).vers_f64();
    PlanGeo::new(r, borne(-n.produit_scalaire(en)), Texture(0)).unwrap().into()
}

/// One box in two may be up to 10^12 times as long as thick.
fn boite<R: Reel>(alea: &mut dyn Tirage, centre: Vecteur, l: f64) -> ObjetGeo<R> {
    let allonge = if alea.bool() { -40.0 } else { -2.0 };
    let dimensions = [(); 3].map(|()| taille(l * deux_puissance(alea, allonge, 0.0)));
    BoiteGeo::new(lieu(centre), dimensions.into(), rotation(alea), Texture(0)).unwrap().into()
}

fn lancer<R: Reel>(objet: ObjetGeo<R>, de: Vecteur, vers: Vecteur) -> Cas<R> {
    let secours = Vecteur::new(R::ZERO, R::ZERO, -R::UN);
    let d = arrondi(vers);
    let rayon = Rayon::new(lieu(de), d).or_else(|_| Rayon::new(lieu(de), secours));
    Cas { objet: objet.vers_ray(), rayon: rayon.unwrap() }
}

/// At any scale, a ray from a few sizes away at the object or a little beside it.
fn ordinaire<R: Reel>(alea: &mut dyn Tirage, forme: Forme<R>) -> Cas<R> {
    let l = deux_puissance(alea, -20.0, 20.0);
    let centre = direction(alea) * (l * deux_puissance(alea, -3.0, 4.0));
    let objet = forme(alea, centre, l);
    let de = centre + direction(alea) * (l * deux_puissance(alea, -1.0, 5.0));
    let vers = centre + direction(alea) * (1.2 * l * alea.f64());
    lancer(objet, de, vers - de)
}

/// A ray from up to 4·10^6 (f32) or 2·10^15 (f64) sizes away, where S − C is not representable.
fn loin<R: Reel>(alea: &mut dyn Tirage, forme: Forme<R>) -> Cas<R> {
    let l = deux_puissance(alea, -10.0, 10.0);
    let bits = -R::U.vers_f64().log2();
    let distance = l * deux_puissance(alea, 0.0, bits - 2.0);
    let d = direction(alea);
    let centre = direction(alea) * (distance * alea.f64());
    let objet = forme(alea, centre, l);
    let ecart = travers(alea, d) * (1.3 * l * alea.f64());
    lancer(objet, centre - d * distance + ecart, d)
}

/// The object and the source close together and far from the origin, where few coordinates lie between them.
fn loin_de_l_origine<R: Reel>(alea: &mut dyn Tirage, forme: Forme<R>) -> Cas<R> {
    let l = deux_puissance(alea, -10.0, 10.0);
    let bits = -R::U.vers_f64().log2();
    let centre = direction(alea) * (l * deux_puissance(alea, 0.0, bits - 1.0));
    let objet = forme(alea, centre, l);
    let de = lieu::<R>(centre + direction(alea) * (l * deux_puissance(alea, 0.0, 5.0))).vers_f64();
    let vers = centre + direction(alea) * (l * alea.f64());
    lancer(objet, de, vers - de)
}

/// The ray passes the centre at r(1 ± 2^−k), to the last bit and beyond.
fn sphere_rasante<R: Reel>(alea: &mut dyn Tirage) -> Cas<R> {
    let r = deux_puissance(alea, -10.0, 10.0);
    let centre = direction(alea) * (r * deux_puissance(alea, -3.0, 8.0));
    let d = direction(alea);
    let presque = signe(alea) * deux_puissance(alea, -54.0, -1.0);
    let recul = r * deux_puissance(alea, -3.0, 8.0);
    let de = centre + travers(alea, d) * (r * (1.0 + presque)) - d * recul;
    lancer(boule(alea, centre, r), de, d)
}

/// A point of the surface and the normal there; for a half-space a point `etendue` away from the foot of O.
fn surface<R: Reel>(
    alea: &mut dyn Tirage,
    objet: &ObjetRay<R>,
    etendue: f64,
) -> (Vecteur, Vecteur) {
    match objet {
        ObjetRay::Sphere(sphere) => {
            let n = direction(alea);
            (sphere.centre().vers_f64() + n * sphere.rayon().vers_f64(), n)
        }
        ObjetRay::Plan(plan) => {
            let n = plan.normale().vers_f64();
            let pied = n * -plan.distance().vers_f64();
            (pied + travers(alea, n) * etendue, n)
        }
        ObjetRay::Boite(boite) => {
            let face = alea.usize(0..3);
            let signe = signe(alea);
            let point = (0..3).fold(boite.centre().vers_f64(), |point, axe| {
                let ou = if axe == face { signe } else { entre(alea, -1.0, 1.0) };
                let l = boite.demi_longueurs()[axe].vers_f64();
                point + boite.normales()[axe].vers_f64() * (ou * l)
            });
            (point, boite.normales()[face].vers_f64() * signe)
        }
    }
}

/// The ray starts at a relative height of 10^−16 … 1 above the surface, and goes in, along it or out.
fn au_ras<R: Reel>(alea: &mut dyn Tirage, forme: Forme<R>) -> Cas<R> {
    let l = deux_puissance(alea, -10.0, 10.0);
    let centre = direction(alea) * (l * deux_puissance(alea, -3.0, 8.0));
    let objet = forme(alea, centre, l);
    let (point, n) = surface(alea, &objet.vers_ray(), l);
    let haut = l * deux_puissance(alea, -53.0, 0.0);
    let incline = deux_puissance(alea, -30.0, 0.0);
    let penche = if alea.u8(0..4) == 0 { incline } else { -incline };
    lancer(objet, point + n * haut, n * penche + travers(alea, n))
}

/// The object is about the origin, and the source exactly on its surface or k ulp above or below.
fn a_quelques_ulp<R: Reel>(alea: &mut dyn Tirage, forme: Forme<R>) -> Cas<R> {
    let l = deux_puissance(alea, -10.0, 10.0);
    let objet = forme(alea, Vecteur::NUL, l);
    let (point, n) = surface(alea, &objet.vers_ray(), l);
    let ulp = 1.0 + f64::from(alea.i8(-4..=4)) * 2.0 * R::U.vers_f64();
    let axe = [Vecteur::new(1.0, 0.0, 0.0), Vecteur::new(0.0, 0.0, -1.0)];
    let point = match (&objet, alea.u8(0..4)) {
        // On an axis the source can be exactly on the sphere, or in its centre.
        (ObjetGeo::Sphere(s), 0) => axe[usize::from(alea.bool())] * s.vers_ray().rayon().vers_f64(),
        (ObjetGeo::Sphere(_), 1) => Vecteur::NUL,
        _ => point,
    };
    let vers = if alea.bool() { direction(alea) } else { -n };
    lancer(objet, point * ulp, vers)
}

/// Sizes and coordinates over the whole range that a scene can hold, often at its two ends.
fn bornes<R: Reel>(alea: &mut dyn Tirage, forme: Forme<R>) -> Cas<R> {
    let bits = R::LIMITE.vers_f64().log2();
    let echelle = |alea: &mut dyn Tirage| match alea.u8(0..4) {
        0 => bits.exp2(),
        1 => (-bits).exp2(),
        _ => deux_puissance(alea, -bits, bits),
    };
    let l = echelle(alea);
    let centre = direction(alea) * (echelle(alea) * deux_puissance(alea, -2.0, 1.0));
    let objet = forme(alea, centre, l);
    let ou = if alea.bool() { echelle(alea) } else { l * deux_puissance(alea, 0.0, 4.0) };
    let de = lieu::<R>(centre + direction(alea) * ou);
    let (cible, _) = surface(alea, &objet.vers_ray(), l);
    lancer(objet, de.vers_f64(), cible - de.vers_f64())
}

/// N·D is ±0, subnormal or ±2^−k, from nearby and from 10^15 away along the plane.
fn plan_rasant<R: Reel>(alea: &mut dyn Tirage) -> Cas<R> {
    let l = deux_puissance(alea, -10.0, 10.0);
    let centre = direction(alea) * (l * deux_puissance(alea, -3.0, 8.0));
    let objet = demi_espace::<R>(alea, centre, l);
    let etendue = l * deux_puissance(alea, 0.0, 50.0);
    let (point, n) = surface(alea, &objet.vers_ray(), etendue);
    let descente = match alea.u8(0..6) {
        0 => 0.0,
        1 => -0.0,
        2 => f64::MIN_POSITIVE / 8.0,
        _ => deux_puissance(alea, -60.0, -1.0),
    };
    let signe = f64::from(1 - 2 * i8::from(alea.u8(0..4) == 0));
    let de = point + n * (l * deux_puissance(alea, -20.0, 4.0));
    lancer(objet, de, travers(alea, n) - n * (signe * descente))
}

/// The ray goes through an edge or a corner all of whose faces look at the source, or k ulp beside it.
fn aretes<R: Reel>(alea: &mut dyn Tirage) -> Cas<R> {
    let l = deux_puissance(alea, -10.0, 10.0);
    let centre = direction(alea) * (l * deux_puissance(alea, -3.0, 8.0));
    let objet = boite(alea, centre, l);
    let ObjetRay::Boite(b) = objet.vers_ray() else { unreachable!("made as a box") };
    let (c, n) = (b.centre().vers_f64(), b.normales().map(Vecteur::vers_f64));
    let l = b.demi_longueurs().map(R::vers_f64);
    // An edge leaves the place along the third axis free; at a corner it is an end.
    let libre = if alea.bool() { alea.usize(0..3) } else { 3 };
    let signes = [(); 3].map(|()| signe(alea));
    let cible = (0..3).fold(c, |point, axe| {
        let ou = if axe == libre { entre(alea, -1.0, 1.0) } else { signes[axe] };
        point + n[axe] * (ou * l[axe])
    });
    let recul = Vecteur::from(l).longueur() * deux_puissance(alea, -2.0, 5.0);
    let de = (0..3).fold(cible, |de, axe| {
        let ou = if axe == libre { entre(alea, -1.0, 1.0) } else { signes[axe] * alea.f64() };
        de + n[axe] * (ou * recul)
    });
    let de = lieu::<R>(de).vers_f64();
    let k = 1.0 + f64::from(alea.i8(-3..=3)) * 2.0 * R::U.vers_f64();
    lancer(objet, de, cible * k - de)
}

/// D·N is ±0, and the ray runs in the plane of a face, k ulp beside it, or away from it.
fn le_long_d_une_face<R: Reel>(alea: &mut dyn Tirage) -> Cas<R> {
    let l = [(); 3].map(|()| deux_puissance(alea, -10.0, 10.0));
    let centre = direction(alea) * deux_puissance(alea, -10.0, 10.0);
    let dimensions = Vecteur::from(l.map(taille::<R>));
    let objet = BoiteGeo::new(lieu(centre), dimensions, Rotation::IDENTITE, Texture(0)).unwrap();
    let b = objet.vers_ray();
    let (axe, parallele) = (alea.usize(0..3), alea.usize(0..3));
    let c = <[f64; 3]>::from(b.centre().vers_f64());
    let l = b.demi_longueurs().map(R::vers_f64);
    let zero = if alea.bool() { 0.0 } else { -0.0 };
    let (mut de, mut vers) = ([0.0; 3], [zero; 3]);
    for i in 0..3 {
        let k = 1.0 + f64::from(alea.i8(-3..=3)) * 2.0 * R::U.vers_f64();
        let signe = signe(alea);
        de[i] = (c[i] + signe * l[i]) * if alea.bool() { 1.0 } else { k };
        if i == axe {
            de[i] = c[i] - l[i] * deux_puissance(alea, -1.0, 4.0);
            vers[i] = 1.0;
        } else if i != parallele {
            vers[i] = entre(alea, -1.0, 1.0) * deux_puissance(alea, -60.0, 0.0);
        }
    }
    lancer(objet.into(), de.into(), vers.into())
}

/// D·N is within ±2⁻⁶⁰ … 2⁻²⁰ of 0 at a turned box, and the ray goes towards the edge where it enters beside that face
/// or through it.
fn presque_le_long_d_une_face<R: Reel>(alea: &mut dyn Tirage) -> Cas<R> {
    let l = deux_puissance(alea, -10.0, 10.0);
    let centre = direction(alea) * (l * deux_puissance(alea, -3.0, 4.0));
    let objet = boite::<R>(alea, centre, l);
    let ObjetRay::Boite(b) = objet.vers_ray() else { unreachable!("made as a box") };
    let (n, l) = (b.normales().map(Vecteur::vers_f64), b.demi_longueurs().map(R::vers_f64));
    let face = alea.usize(0..3);
    let signe = signe(alea);
    let d = travers(alea, n[face]) - n[face] * (signe * deux_puissance(alea, -60.0, -20.0));
    // A point of the edges of that face, from which the source lies back along the ray.
    let au_bord = (face + 1 + alea.usize(0..2)) % 3;
    let cible = (0..3).fold(b.centre().vers_f64(), |point, axe| {
        let ou = match axe {
            _ if axe == face => signe * (1.0 + f64::from(alea.i8(-2..=2)) * R::U.vers_f64()),
            _ if axe == au_bord => -n[axe].produit_scalaire(d).signum(),
            _ => entre(alea, -1.0, 1.0),
        };
        point + n[axe] * (ou * l[axe])
    });
    lancer(objet, cible - d * (Vecteur::from(l).longueur() * deux_puissance(alea, -3.0, 3.0)), d)
}

/// Makes of this case one for the way out. The ray stays as it is; or starts within, at any depth, in the same
/// direction, back, across or anywhere; or is the one that goes on inward.
pub fn vers_la_sortie<R: Reel>(Cas { objet, rayon }: Cas<R>, alea: &mut dyn Tirage) -> Cas<R> {
    let dedans = |alea: &mut dyn Tirage| {
        let (point, n) = match alea.u8(0..4) {
            0 => return None,
            1 => {
                let touche = objet.intersection(&rayon).ok()?;
                return touche.secondaire(rayon.direction()).ok();
            }
            2 => {
                // Between the two crossings; in a half-space up to as deep as S was high.
                let t = objet.intersection(&rayon).ok()?.distance().vers_f64();
                let fin =
                    objet.sortie(&rayon).map_or(2.0 * t, |sortie| sortie.distance().vers_f64());
                let (s, d) = (rayon.source().vers_f64(), rayon.direction().vers_f64());
                (s + d * (t + alea.f64() * (fin - t)), -d)
            }
            _ => {
                // Below the surface, in a ball down to its centre.
                let l = match &objet {
                    ObjetRay::Sphere(sphere) => sphere.rayon().vers_f64(),
                    ObjetRay::Plan(plan) => plan.distance().vers_f64().abs(),
                    ObjetRay::Boite(boite) => {
                        boite.demi_longueurs().into_iter().map(R::vers_f64).fold(f64::MAX, f64::min)
                    }
                };
                let (point, n) = surface(alea, &objet, l);
                (point - n * (l * deux_puissance(alea, -53.0, 0.0)), n)
            }
        };
        let vers = match alea.u8(0..4) {
            0 => rayon.direction().vers_f64(),
            1 => n,
            2 => travers(alea, n) + n * (signe(alea) * deux_puissance(alea, -40.0, 0.0)),
            _ => direction(alea),
        };
        Rayon::new(lieu(point), arrondi(vers)).ok()
    };
    let rayon = dedans(alea).unwrap_or(rayon);
    Cas { objet, rayon }
}

/// The object with another texture, moved or grown by a few units in the last place, or not at all.
pub fn presque<R: Reel>(
    objet: &ObjetRay<R>,
    texture: Texture,
    alea: &mut dyn Tirage,
) -> ObjetRay<R> {
    let mut peu = |x: R| {
        let k = if alea.bool() { 0.0 } else { f64::from(alea.i8(-3..=3)) };
        R::depuis_f64(x.vers_f64() * (1.0 + k * 2.0 * R::U.vers_f64()))
    };
    let autre = match objet {
        ObjetRay::Sphere(s) => SphereGeo::new(s.centre(), peu(s.rayon()), texture).map(Into::into),
        ObjetRay::Plan(p) => Rotation::depuis_matrice(repere(p.normale()))
            .and_then(|tour| PlanGeo::new(tour, peu(p.distance()), texture))
            .map(Into::into),
        ObjetRay::Boite(b) => {
            let rotation = Rotation::depuis_matrice(b.normales().map(<[R; 3]>::from)).unwrap();
            let [a, c, d] = b.demi_longueurs().map(|l| l + l);
            let centre = Vecteur::new(peu(b.centre().x), b.centre().y, b.centre().z);
            BoiteGeo::new(centre, Vecteur::new(peu(a), c, d), rotation, texture).map(Into::into)
        }
    };
    autre.unwrap_or(*objet)
}

/// 64 rays around the one from `s` along `d`, spread by about `ouverture` in direction and `etendue` in place: a tile
/// or a row as in a picture, scattered, every other one turned back, or all but the middle one on one side. Some run
/// along axes, down to the sign of a zero and to the smallest numbers.
pub fn gerbe<R: Reel>(
    alea: &mut Hasard,
    (s, d): (Vecteur, Vecteur),
    [ouverture, etendue]: [f64; 2],
) -> Vec<Rayon<R>> {
    let [axe_a, axe_b] = [direction(alea), direction(alea)];
    let genre = alea.u8(0..9);
    let cote = direction(alea) * etendue;
    let axe = alea.usize(0..3);
    alea.liste(64, |alea, i| {
        let (a, b) = match genre {
            0 | 1 => ((i % 8) as f64 / 4.0 - 1.0, (i / 8) as f64 / 4.0 - 1.0),
            2 => (i as f64 / 32.0 - 1.0, 0.0),
            _ => (entre(alea, -1.0, 1.0), entre(alea, -1.0, 1.0)),
        };
        let mut vers: [f64; 3] = (d + (axe_a * a + axe_b * b) * ouverture).into();
        match genre {
            4 if i % 2 == 1 => vers = vers.map(|x| -x),
            6 => vers[axe] = [0.0, -0.0][i % 2],
            7 => {
                vers = [0.0, -0.0, 0.0];
                vers[axe] = signe(alea);
            }
            8 => vers[axe] *= deux_puissance(alea, -1_100.0, 0.0),
            _ => {}
        }
        let decalage = match genre {
            5 => cote * if i == 32 { 0.3 } else { -1.0 },
            _ => direction(alea) * (etendue * alea.f64()),
        };
        let source = arrondi(s + decalage);
        let rayon = Rayon::new(source, arrondi(vers.into()));
        rayon.or_else(|_| Rayon::new(source, Vecteur::Z)).unwrap()
    })
}
