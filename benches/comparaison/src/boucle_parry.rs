//! The loop that someone with a list of objects writes in parry, at its best.
//!
//! `main.rs` compiles this page against `parry3d` and again against `parry3d-f64`, which have the
//! same names in them; `Real` is `f32` in one and `f64` in the other.

use lancer_rayon::{ObjetRay, Rayon, Texture, Vecteur};

use super::parry::math::{Mat3, Pose, Real, Rotation, Vector};
use super::parry::query::{Ray, RayCast};
use super::parry::shape::{Ball, Cuboid, HalfSpace};
use crate::{Parry, Touche};

/// A shape and where it is, as an enum: parry's `SharedShape` would cost it an indirect call per
/// object, and a `Pose` for every shape a rotation of the ray where there is nothing to turn.
pub(crate) struct Objet(Forme, Texture);

enum Forme {
    Sphere(Ball, Vector),
    Plan(HalfSpace, Vector),
    Boite(Cuboid, Pose),
}

impl Objet {
    fn t(&self, rayon: &Ray, t_max: Real) -> Option<Real> {
        match &self.0 {
            Forme::Sphere(f, ou) => f.cast_local_ray(&rayon.translate_by(-*ou), t_max, true),
            Forme::Plan(f, ou) => f.cast_local_ray(&rayon.translate_by(-*ou), t_max, true),
            Forme::Boite(f, pose) => f.cast_ray(pose, rayon, t_max, true),
        }
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

impl Parry for Real {
    type Objet = Objet;
    type Rayon = Ray;

    fn objet(objet: &ObjetRay<Self>) -> Objet {
        match objet {
            ObjetRay::Sphere(s) => {
                let forme = Forme::Sphere(Ball::new(s.rayon()), vector(s.centre()));
                Objet(forme, s.texture())
            }
            ObjetRay::Plan(p) => {
                let pied = p.normale() * -p.distance();
                Objet(Forme::Plan(HalfSpace::new(vector(p.normale())), vector(pied)), p.texture())
            }
            ObjetRay::Boite(b) => {
                let [x, y, z] = b.normales().map(vector);
                let rotation = Rotation::from_mat3(&Mat3::from_cols(x, y, z));
                let pose = Pose::from_parts(vector(b.centre()), rotation);
                Objet(Forme::Boite(Cuboid::new(b.demi_longueurs().into()), pose), b.texture())
            }
        }
    }

    fn rayon(rayon: &Rayon<Self>) -> Ray {
        Ray::new(vector(rayon.source()), vector(rayon.direction()))
    }

    /// The nearest by distance, then its normal alone; a solid answers 0 to a source inside it.
    fn premiere_intersection(objets: &[Objet], rayon: &Ray) -> Option<Touche<Self>> {
        let mut premier = None;
        let mut t_premier = Self::INFINITY;
        for objet in objets {
            match objet.t(rayon, t_premier) {
                Some(t) if t > 0.0 && t < t_premier => (premier, t_premier) = (Some(objet), t),
                _ => {}
            }
        }
        let objet = premier?;
        Some((t_premier, objet.normale(rayon)?, objet.1))
    }
}

fn vector(v: Vecteur<Real>) -> Vector {
    Vector::new(v.x, v.y, v.z)
}
