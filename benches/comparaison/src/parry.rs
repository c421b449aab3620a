//! What someone with a list of objects writes in parry, at its best: a loop, parry's tree of boxes, or the eight-way
//! tree of obvhs over the same shapes.
//!
//! `main.rs` compiles this file against `parry3d` and again against `parry3d-f64`, in which all names are the same;
//! `Real` is `f32` in one and `f64` in the other.

use std::hint::black_box;

use banc::concurrents::{Camp, Concurrent, TROP, cachee};
use lancer_rayon::{ObjetRay, Rayon, Texture, Vecteur};
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb as BoiteObvhs;
use obvhs::cwbvh::CwBvh;
use obvhs::cwbvh::builder::build_cwbvh;
use obvhs::ray::{Ray as RayonObvhs, RayHit};

use super::version::bounding_volume::{Aabb, BoundingVolume};
use super::version::math::{Mat3, Pose, Real, Rotation, Vector};
use super::version::partitioning::{Bvh, BvhBuildStrategy, BvhNode};
use super::version::query::{Ray, RayCast};
use super::version::shape::{Ball, Cuboid, HalfSpace};
use crate::rival::{Parry, Rival, Vu, dire};

/// A shape and where it is, as an enum. parry's `SharedShape` would cost parry an indirect call for each object, and a
/// `Pose` for every shape would turn the ray even where nothing is turned.
struct Objet(Forme, Texture);

enum Forme {
    Sphere(Ball, Vector),
    Plan(HalfSpace, Vector),
    Boite(Cuboid, Pose),
}

/// A tree over the bounded objects. A half-space has no finite box, so half-spaces stay in a list.
struct Arbre<T> {
    plans: Vec<Objet>,
    solides: Vec<Objet>,
    boites: T,
}

impl<T> Arbre<T> {
    fn new(objets: &[ObjetRay<Real>], faire: impl Fn(&[Aabb]) -> T) -> Self {
        let objets = objets.iter().map(Objet::from);
        let (solides, plans): (Vec<_>, Vec<_>) = objets.partition(|objet| objet.boite().is_some());
        let boites: Vec<_> = solides.iter().filter_map(Objet::boite).collect();
        Self { plans, boites: faire(&boites), solides }
    }
}

impl Objet {
    /// The box, enlarged beyond rounding: a ray along a side would have no entry into it, 0 times ∞.
    fn boite(&self) -> Option<Aabb> {
        let boite = match &self.0 {
            Forme::Sphere(f, ou) => f.aabb(&Pose::from_translation(*ou)),
            Forme::Plan(..) => return None,
            Forme::Boite(f, pose) => f.aabb(pose),
        };
        Some(boite.loosened(1e-6 * boite.mins.abs().max(boite.maxs.abs()).max_element()))
    }

    /// The entry; parry answers 0 for a source inside a solid.
    fn t(&self, rayon: &Ray, t_max: Real) -> Option<Real> {
        let t = match &self.0 {
            Forme::Sphere(f, ou) => f.cast_local_ray(&rayon.translate_by(-*ou), t_max, true),
            Forme::Plan(f, ou) => f.cast_local_ray(&rayon.translate_by(-*ou), t_max, true),
            Forme::Boite(f, pose) => f.cast_ray(pose, rayon, t_max, true),
        };
        t.filter(|t| *t > 0.0)
    }

    fn normale(&self, rayon: &Ray) -> Option<Vecteur<Real>> {
        let t_max = Real::INFINITY;
        let touche = match &self.0 {
            Forme::Sphere(f, ou) => {
                f.cast_local_ray_and_get_normal(&rayon.translate_by(-*ou), t_max, true)
            }
            Forme::Plan(f, ou) => {
                f.cast_local_ray_and_get_normal(&rayon.translate_by(-*ou), t_max, true)
            }
            Forme::Boite(f, pose) => f.cast_ray_and_get_normal(pose, rayon, t_max, true),
        };
        touche.map(|touche| touche.normal.to_array().into())
    }
}

impl From<&ObjetRay<Real>> for Objet {
    fn from(objet: &ObjetRay<Real>) -> Self {
        match objet {
            ObjetRay::Sphere(s) => {
                let forme = Forme::Sphere(Ball::new(s.rayon()), vector(s.centre()));
                Self(forme, s.texture())
            }
            ObjetRay::Plan(p) => {
                let pied = p.normale() * -p.distance();
                Self(Forme::Plan(HalfSpace::new(vector(p.normale())), vector(pied)), p.texture())
            }
            ObjetRay::Boite(b) => {
                let [x, y, z] = b.normales().map(vector);
                let rotation = Rotation::from_mat3(&Mat3::from_cols(x, y, z));
                let pose = Pose::from_parts(vector(b.centre()), rotation);
                Self(Forme::Boite(Cuboid::new(b.demi_longueurs().into()), pose), b.texture())
            }
        }
    }
}

/// The loop, and both trees.
struct Tous(Vec<Objet>, Arbre<Bvh>, Arbre<CwBvh>);

impl Parry for Real {
    const ARBRES: [fn(&[ObjetRay<Self>]); 2] =
        [|objets| drop(black_box(bvh(objets))), |objets| drop(black_box(obvhs(objets)))];

    fn rival(objets: &[ObjetRay<Self>]) -> Box<dyn Rival<Self>> {
        Box::new(Tous(objets.iter().map(Objet::from).collect(), bvh(objets), obvhs(objets)))
    }

    fn touche(objet: &ObjetRay<Self>, rayon: &Rayon<Self>) -> Option<Vu<Self>> {
        dans_la_liste(&[Objet::from(objet)], &ray(rayon))
    }
}

impl Rival<Real> for Tous {
    fn concurrents<'a>(&'a self, rayons: &'a [Rayon<Real>], ombres: bool) -> Vec<Concurrent<'a>> {
        let Self(liste, bvh, obvhs) = self;
        let [boucle, arbre, huit] =
            ["parry, loop", "parry, Bvh", "parry in obvhs"].map(|nom| (nom, Camp::Parry));
        let mut concurrents = if ombres {
            let dans_l_arbre = |r: &Rayon<_>| ombre_dans_l_arbre(bvh, &ray(r), r.fin());
            let dans_la_liste = |r: &Rayon<_>| ombre_dans_la_liste(liste, &ray(r), r.fin());
            vec![
                Concurrent::un_par_un(arbre, rayons, dans_l_arbre, cachee),
                Concurrent::un_par_un(boucle, rayons, dans_la_liste, cachee),
            ]
        } else {
            vec![
                Concurrent::un_par_un(huit, rayons, |r| dans_obvhs(obvhs, &ray(r)), dire),
                Concurrent::un_par_un(arbre, rayons, |r| dans_l_arbre(bvh, &ray(r)), dire),
                Concurrent::un_par_un(boucle, rayons, |r| dans_la_liste(liste, &ray(r)), dire),
            ]
        };
        if liste.len() > TROP {
            concurrents.pop();
        }
        concurrents
    }
}

fn ray(rayon: &Rayon<Real>) -> Ray {
    Ray::new(vector(rayon.source()), vector(rayon.direction()))
}

fn bvh(objets: &[ObjetRay<Real>]) -> Arbre<Bvh> {
    Arbre::new(objets, |boites| Bvh::from_leaves(BvhBuildStrategy::Binned, boites))
}

fn obvhs(objets: &[ObjetRay<Real>]) -> Arbre<CwBvh> {
    Arbre::new(objets, |boites| {
        let en_f32 = |boite: &Aabb| {
            let [bas, haut] = [boite.mins, boite.maxs].map(|v| en_f32(v.to_array()).into());
            BoiteObvhs::new(bas, haut)
        };
        let boites: Vec<_> = boites.iter().map(en_f32).collect();
        build_cwbvh(&boites, BvhBuildParams::very_slow_build(), &mut Default::default())
    })
}

fn dans_la_liste(objets: &[Objet], rayon: &Ray) -> Option<Vu<Real>> {
    conclure(premier(objets, rayon)?, rayon)
}

/// `find_best` with the inverses of the direction, since `Bvh::cast_ray` divides again at every node in f64, and takes
/// twice as long.
fn dans_l_arbre(arbre: &Arbre<Bvh>, rayon: &Ray) -> Option<Vu<Real>> {
    let plan = premier(&arbre.plans, rayon);
    let t_max = plan.map_or(Real::INFINITY, |(_, t)| t);
    let inverses = rayon.dir.recip();
    let solide = |i| &arbre.solides[i as usize];
    let boite = |boite: &BvhNode, _| entree(boite, rayon.origin, inverses);
    let dans = arbre.boites.find_best(t_max, boite, |i, t_max| solide(i).t(rayon, t_max));
    conclure(dans.map(|(i, t)| (solide(i), t)).or(plan)?, rayon)
}

#[allow(clippy::unnecessary_cast, reason = "Real is f32 in one of the two")]
fn dans_obvhs(arbre: &Arbre<CwBvh>, rayon: &Ray) -> Option<Vu<Real>> {
    let mut premier = premier(&arbre.plans, rayon);
    let [origine, direction] = [rayon.origin, rayon.dir].map(|v| en_f32(v.to_array()).into());
    let t_max = premier.map_or(f32::INFINITY, |(_, t)| t as f32);
    let en_f32 = RayonObvhs::new(origine, direction, 0.0, t_max);
    arbre.boites.ray_traverse(en_f32, &mut RayHit::none(), |_, place| {
        let objet = &arbre.solides[arbre.boites.primitive_indices[place] as usize];
        let t_max = premier.map_or(Real::INFINITY, |(_, t)| t);
        let Some(t) = objet.t(rayon, t_max).filter(|t| *t < t_max) else {
            return f32::INFINITY;
        };
        premier = Some((objet, t));
        t as f32
    });
    conclure(premier?, rayon)
}

fn ombre_dans_la_liste(objets: &[Objet], rayon: &Ray, max: Real) -> bool {
    objets.iter().any(|objet| objet.t(rayon, max).is_some_and(|t| t < max))
}

fn ombre_dans_l_arbre(arbre: &Arbre<Bvh>, rayon: &Ray, max: Real) -> bool {
    let inverses = rayon.dir.recip();
    let solide = |i| &arbre.solides[i as usize];
    let boite = |boite: &BvhNode| entree(boite, rayon.origin, inverses) < max;
    ombre_dans_la_liste(&arbre.plans, rayon, max)
        || arbre.boites.leaves(boite).any(|i| solide(i).t(rayon, max).is_some_and(|t| t < max))
}

/// The distance at which a ray enters a box of the tree; the largest number if it does not.
fn entree(boite: &BvhNode, origine: Vector, inverses: Vector) -> Real {
    let a = (boite.mins() - origine) * inverses;
    let b = (boite.maxs() - origine) * inverses;
    let (entree, sortie) = (a.min(b).max_element(), a.max(b).min_element());
    if entree.max(0.0) <= sortie { entree } else { Real::MAX }
}

#[allow(clippy::unnecessary_cast, reason = "Real is f32 in one of the two")]
fn en_f32(v: [Real; 3]) -> [f32; 3] {
    v.map(|x| x as f32)
}

fn premier<'a>(objets: &'a [Objet], rayon: &Ray) -> Option<(&'a Objet, Real)> {
    let mut premier = None;
    let mut t_premier = Real::INFINITY;
    for objet in objets {
        if let Some(t) = objet.t(rayon, t_premier).filter(|t| *t < t_premier) {
            (premier, t_premier) = (Some((objet, t)), t);
        }
    }
    premier
}

/// Only the nearest hit needs its normal.
fn conclure((objet, t): (&Objet, Real), rayon: &Ray) -> Option<Vu<Real>> {
    Some((t, objet.normale(rayon)?, objet.1))
}

fn vector(v: Vecteur<Real>) -> Vector {
    Vector::new(v.x, v.y, v.z)
}
