//! A whole picture beside parry: a `Compound` of the balls and boxes, and the floor beside it, as its users write it.

use std::error::Error;

use banc::horloge::TOURS;
use banc::image::{LAMPE, Nous, OEIL, PARTIES, Peintre, REGARD, objets, peindre, pixels};
use lancer_rayon::{ObjetGeo, ObjetRay, Vecteur, places};
use parry3d::math::{Mat3, Pose, Rotation, Vector};
use parry3d::query::{Ray, RayCast, RayIntersection};
use parry3d::shape::{Compound, HalfSpace, SharedShape};

use crate::autres::Scalaire;
use crate::tables::nanosecondes;

const NOMBRES: [usize; 2] = [13, 200];

/// How far ahead of a surface parry's shadow rays start.
const AVANCE: f32 = 1e-3;

/// Nanoseconds a pixel of each part and in all, ours in either scalar and parry's.
pub(crate) fn mesurer() -> Result<Vec<String>, Box<dyn Error>> {
    let mut table = vec![format!("objects,who,{}_ns,all_ns", PARTIES.join("_ns,"))];
    for n in NOMBRES {
        let objets = objets(n);
        let simples = prets::<f32>(&objets)?;
        let doubles = prets::<f64>(&objets)?;
        let [mut memoire, mut autre] = [(); 2].map(|()| vec![0.0; places(objets.len())]);
        let peintres: [(&str, Box<dyn Peintre>); 3] = [
            ("ours f32", Box::new(Nous::new(&simples, &mut memoire))),
            ("ours f64", Box::new(Nous::new(&doubles, &mut autre))),
            ("parry f32", Box::new(Parry::new(&objets))),
        ];
        let pixels = pixels();
        let mut peintres = peintres.map(|(nom, peintre)| (nom, peintre, [f64::INFINITY; 4]));
        let mut images = Vec::new();
        for tour in 0..3 * TOURS {
            for (_, peintre, ns) in &mut peintres {
                let (durees, image) = peindre(&mut **peintre, &pixels);
                for (ns, duree) in ns.iter_mut().zip(durees) {
                    *ns = ns.min(duree.as_nanos() as f64 / pixels.len() as f64);
                }
                images.extend((tour == 0).then_some(image));
            }
        }
        exiger_la_meme_image(&images)?;
        for (nom, _, ns) in &peintres {
            let colonnes = ns.iter().copied().chain([ns.iter().sum()]).map(nanosecondes);
            table.push(format!("{},{nom},{}", n + 1, colonnes.collect::<Vec<_>>().join(",")));
        }
    }
    Ok(table)
}

/// The file as a table of a page.
pub(crate) fn tableau(lignes: &[String]) -> String {
    let lignes = lignes[1..].iter().map(|ligne| format!("| {} |", ligne.replace(',', " | ")));
    let titres =
        format!("| objects | | {} | in all |\n|--:|---|--:|--:|--:|--:|--:|", PARTIES.join(" | "));
    std::iter::once(titres).chain(lignes).collect::<Vec<_>>().join("\n")
}

fn prets<R: Scalaire>(objets: &[ObjetGeo]) -> Result<Vec<ObjetRay<R>>, Box<dyn Error>> {
    let pret = |objet: &ObjetGeo| Ok(objet.vers(Vecteur::NUL)?.vers_ray());
    objets.iter().map(pret).collect()
}

/// An error unless all see the same, but for one pixel of a hundred at outlines and beside shadows.
fn exiger_la_meme_image(images: &[Vec<f32>]) -> Result<(), Box<dyn Error>> {
    for image in images {
        let autres = image.iter().zip(&images[0]).filter(|(a, b)| (*a - *b).abs() > 1e-2).count();
        if 100 * autres > image.len() || image.len() != images[0].len() {
            return Err(format!("another picture: {autres} pixels").into());
        }
    }
    Ok(())
}

struct Parry {
    solides: Compound,
    sol: (Pose, HalfSpace),
    axes: [Vector; 3],
    oeil: Vector,
    lampe: Vector,
    rayons: Vec<Ray>,
    touches: Vec<Option<RayIntersection>>,
    cosinus: Vec<f32>,
}

impl Parry {
    fn new(objets: &[ObjetGeo]) -> Self {
        let mut solides = Vec::new();
        let mut sol = None;
        for objet in objets {
            match objet {
                ObjetGeo::Sphere(s) => {
                    let ou = Pose::from_translation(vector(s.centre().into()));
                    solides.push((ou, SharedShape::ball(s.rayon() as f32)));
                }
                ObjetGeo::Plan(p) => {
                    let n = p.orientation().axes()[2];
                    let ou = Pose::from_translation(vector((n * -p.distance()).into()));
                    sol = Some((ou, HalfSpace::new(vector(n.into()))));
                }
                ObjetGeo::Boite(b) => {
                    let [x, y, z] = b.orientation().axes().map(|axe| vector(axe.into()));
                    let tour = Rotation::from_mat3(&Mat3::from_cols(x, y, z));
                    let d = b.dimensions() / 2.0;
                    let boite = SharedShape::cuboid(d.x as f32, d.y as f32, d.z as f32);
                    solides.push((Pose::from_parts(vector(b.centre().into()), tour), boite));
                }
            }
        }
        let z = -vector(REGARD).normalize();
        let x = Vector::Y.cross(z).normalize();
        Self {
            solides: Compound::new(solides),
            sol: sol.expect("a floor"),
            axes: [x, z.cross(x), z],
            oeil: vector(OEIL),
            lampe: vector(LAMPE),
            rayons: Vec::new(),
            touches: Vec::new(),
            cosinus: Vec::new(),
        }
    }

    /// N·L, unless something is in the way.
    fn cosinus(&self, rayon: &Ray, touche: &RayIntersection) -> f32 {
        let point = rayon.point_at(touche.time_of_impact) + touche.normal * AVANCE;
        let vers = self.lampe - point;
        let distance = vers.length();
        let direction = vers / distance;
        let cosinus = direction.dot(touche.normal);
        let ombre = Ray::new(point, direction);
        let (pose, sol) = &self.sol;
        let cache = cosinus <= 0.0
            || sol.intersects_ray(pose, &ombre, distance)
            || self.solides.intersects_ray(&Pose::IDENTITY, &ombre, distance);
        if cache { 0.0 } else { cosinus }
    }
}

impl Peintre for Parry {
    fn faire_les_rayons(&mut self, pixels: &[(f64, f64)]) {
        let [x, y, z] = self.axes;
        let vers = |&(a, b): &(f64, f64)| (x * a as f32 + y * b as f32 - z).normalize();
        self.rayons.clear();
        self.rayons.extend(pixels.iter().map(|pixel| Ray::new(self.oeil, vers(pixel))));
    }

    fn lancer(&mut self) {
        let (pose, sol) = &self.sol;
        let premiere = |rayon: &Ray| {
            let plan = sol.cast_ray_and_get_normal(pose, rayon, f32::MAX, true);
            let loin = plan.map_or(f32::MAX, |touche| touche.time_of_impact);
            let solide = self.solides.cast_ray_and_get_normal(&Pose::IDENTITY, rayon, loin, true);
            solide.or(plan)
        };
        self.touches.clear();
        self.touches.extend(self.rayons.iter().map(premiere));
    }

    fn eclairer(&mut self) {
        let touches = self.rayons.iter().zip(&self.touches);
        let cosinus = touches.map(|(rayon, touche)| {
            touche.as_ref().map_or(0.0, |touche| self.cosinus(rayon, touche))
        });
        self.cosinus = cosinus.collect();
    }

    fn ombrer(&mut self, image: &mut Vec<f32>) {
        image.extend(&self.cosinus);
    }
}

fn vector(v: [f64; 3]) -> Vector {
    let [x, y, z] = v.map(|x| x as f32);
    Vector::new(x, y, z)
}
