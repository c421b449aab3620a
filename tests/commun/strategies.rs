//! Where the values of the properties come from.

use lancer_rayon::{
    BoiteGeo, ObjetGeo, ObjetRay, PlanGeo, Rayon, Reel, Rotation, SphereGeo, Texture, Vecteur,
};
use proptest::prelude::*;

use crate::{Bits, arrondi};

/// Any float at all, the remarkable ones often.
pub fn quelconque<R: Bits>() -> impl Strategy<Value = R> {
    let limite = R::LIMITE.vers_f64();
    let remarquables = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::MAX,
        f64::from(f32::MAX),
        f64::MIN_POSITIVE,
        f64::from(f32::MIN_POSITIVE),
        f64::from_bits(1),
        limite,
        -limite,
        limite.next_up(),
        limite.recip(),
        limite.recip().next_down(),
    ];
    prop_oneof![
        4 => any::<u64>().prop_map(R::depuis_bits),
        4 => (-10.0..10.0_f64).prop_map(R::depuis_f64),
        1 => prop::sample::select(remarquables.to_vec()).prop_map(R::depuis_f64),
    ]
}

pub fn vecteur_quelconque<R: Bits>() -> impl Strategy<Value = Vecteur<R>> {
    [quelconque(), quelconque(), quelconque()].prop_map(Vecteur::from)
}

/// A real number of this range, rounded.
pub fn reel<R: Reel>(min: f64, max: f64) -> impl Strategy<Value = R> {
    (min..max).prop_map(R::depuis_f64)
}

/// A vector whose coordinates are at most `max`.
pub fn vecteur<R: Reel>(max: f64) -> impl Strategy<Value = Vecteur<R>> {
    [-max..max, -max..max, -max..max].prop_map(|v| arrondi(Vecteur::from(v)))
}

/// A unit vector, every direction as likely as another.
pub fn direction() -> impl Strategy<Value = Vecteur> {
    (-1.0..1.0_f64, 0.0..std::f64::consts::TAU).prop_map(|(z, a)| {
        let r = (1.0 - z * z).sqrt();
        Vecteur::new(r * a.cos(), r * a.sin(), z)
    })
}

/// A vecteur-rotation; one in four turns by quarters, whose matrix is exact.
pub fn vecteur_rotation<R: Reel>() -> impl Strategy<Value = Vecteur<R>> {
    let quart = || (-4..=4_i8).prop_map(|k| f64::from(k) * std::f64::consts::FRAC_PI_2);
    prop_oneof![
        3 => vecteur(7.0),
        1 => [quart(), quart(), quart()].prop_map(|v| arrondi(Vecteur::from(v))),
    ]
}

pub fn rotation<R: Reel>() -> impl Strategy<Value = Rotation<R>> {
    vecteur_rotation().prop_map(|r| Rotation::new(r).unwrap())
}

/// A sphere, a half-space or a box about `taille` large, whose coordinates are at most ten times that.
pub fn objet<R: Reel>(taille: f64) -> impl Strategy<Value = ObjetGeo<R>> {
    let centre = move || vecteur::<R>(10.0 * taille);
    let longueur = move || reel(0.1 * taille, 2.0 * taille);
    let texture = || any::<u32>().prop_map(Texture);
    let cotes = [longueur(), longueur(), longueur()].prop_map(Vecteur::from);
    prop_oneof![
        (centre(), longueur(), texture())
            .prop_map(|(c, r, texture)| SphereGeo::new(c, r, texture).unwrap().into()),
        (rotation(), reel(-10.0 * taille, 10.0 * taille), texture())
            .prop_map(|(r, d, texture)| PlanGeo::new(r, d, texture).unwrap().into()),
        (centre(), cotes, rotation(), texture()).prop_map(|(c, l, r, texture)| BoiteGeo::new(
            c, l, r, texture
        )
        .unwrap()
        .into()),
    ]
}

/// A hit that was planted: the point of the surface first, then a ray that arrives there.
#[derive(Debug, Clone, Copy)]
pub struct Plante<R> {
    pub objet: ObjetGeo<R>,
    pub rayon: Rayon<R>,
    /// The outward normal at the point, in f64.
    pub normale: Vecteur,
    /// From the source as stored to the point, in f64.
    pub distance: f64,
    /// |N·D|, never below 0.1: a first-order bound must hold here, and other tests have flatter rays.
    pub cosinus: f64,
    /// The radius, the half-diagonal or |d|.
    pub taille: f64,
    /// |S| + |P| + size + t: every length that is rounded on the way to the hit.
    pub etendue: f64,
}

impl<R: Reel> Plante<R> {
    /// `echelle` is about the size of the object; `sur` chooses the point of its surface, `vers`
    /// and `ecart` the direction from which the ray arrives, and it comes from `recul` away.
    fn new(
        objet: ObjetGeo<R>,
        echelle: f64,
        sur: Vecteur,
        vers: Vecteur,
        ecart: f64,
        recul: f64,
    ) -> Self {
        let (point, normale, taille) = match objet.vers_ray() {
            ObjetRay::Sphere(sphere) => {
                let r = sphere.rayon().vers_f64();
                (sphere.centre().vers_f64() + sur * r, sur, r)
            }
            ObjetRay::Plan(plan) => {
                let n = plan.normale().vers_f64();
                let le_long = sur - n * sur.produit_scalaire(n);
                let d = plan.distance().vers_f64();
                (le_long * (10.0 * echelle) - n * d, n, d.abs())
            }
            ObjetRay::Boite(boite) => {
                let sur = [sur.x, sur.y, sur.z];
                let face = (0..3).fold(0, |i, j| if sur[j].abs() > sur[i].abs() { j } else { i });
                // The two smaller coordinates of a unit vector stay below 0.71, so that this
                // stays 1 % of the face away from its edges.
                let ou = |axe: usize| if axe == face { sur[axe].signum() } else { 1.4 * sur[axe] };
                let (n, l) = (boite.normales(), boite.demi_longueurs());
                let point = (0..3).fold(boite.centre().vers_f64(), |point, axe| {
                    point + n[axe].vers_f64() * (l[axe].vers_f64() * ou(axe))
                });
                let demi_diagonale = Vecteur::from(boite.demi_longueurs()).longueur().vers_f64();
                (point, boite.normales()[face].vers_f64() * sur[face].signum(), demi_diagonale)
            }
        };
        let cote = vers - normale * vers.produit_scalaire(normale);
        let cote = cote.unitaire().unwrap_or(Vecteur::NUL);
        let vient_de = (normale * (1.0 - ecart) + cote * ecart).unitaire().unwrap_or(normale);
        let rayon = Rayon::new(arrondi(point + vient_de * recul), arrondi(-vient_de)).unwrap();
        let source = rayon.source().vers_f64();
        Self {
            objet,
            rayon,
            normale,
            distance: (point - source).longueur(),
            cosinus: -normale.produit_scalaire(rayon.direction().vers_f64()),
            taille,
            etendue: source.longueur() + point.longueur() + taille + recul,
        }
    }

    /// u·(etendue)/|N·D|: what one rounding of the inputs may move the distance by.
    pub fn kappa_t(&self) -> f64 {
        R::U.vers_f64() * self.etendue / self.cosinus
    }
}

pub fn plante<R: Reel>() -> impl Strategy<Value = Plante<R>> {
    // The scale of the scene, from a grain of sand to a planet.
    let echelle = (-20..20_i32).prop_map(|k| f64::from(k).exp2());
    echelle
        .prop_flat_map(|e| {
            (objet(e), Just(e), direction(), direction(), 0.0..0.9, 0.1 * e..10.0 * e)
        })
        .prop_map(|(o, echelle, sur, vers, ecart, recul)| {
            Plante::new(o, echelle, sur, vers, ecart, recul)
        })
}

/// A list of up to 11 objects, and a ray between two points among them.
pub fn scene<R: Reel>() -> impl Strategy<Value = (Vec<ObjetGeo<R>>, Rayon<R>)> {
    (prop::collection::vec(objet(1.0), 0..12), vecteur::<R>(15.0), vecteur::<R>(10.0)).prop_map(
        |(objets, source, cible)| {
            let vers = cible.vers_f64() - source.vers_f64();
            let vers = vers.unitaire().unwrap_or(Vecteur::new(0.0, 0.0, -1.0));
            (objets, Rayon::new(source, arrondi(vers)).unwrap())
        },
    )
}
