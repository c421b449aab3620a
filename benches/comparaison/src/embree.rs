//! What someone with a list of objects writes with Embree: spheres as its sphere points, boxes as quads or as a user
//! geometry, half-spaces beside the scene; single rays or packets of sixteen.

use std::array;
use std::hint::black_box;
use std::sync::Arc;
use std::thread;

use banc::concurrents::{Camp, Concurrent, cachee};
use embree3::{
    Bounds, BufferUsage, Device, Format, GeometryKind, Hit, Hit16, INVALID_ID, IntersectContext,
    IntersectFunctionNArgs, OccludedFunctionNArgs, QuadMeshBuilder, Ray, Ray16, RayHit, RayHit16,
    Scene, UserGeometryBuilder, ValidMask, ValidMaskN,
};
use lancer_rayon::{BoiteRay, ObjetRay, PlanRay, Rayon, Texture};

use crate::rival::{Rival, Vu, dire};

const SEIZE: usize = 16;

/// Embree with quads, and with user boxes.
pub(crate) fn rivaux(objets: &[ObjetRay<f32>]) -> Vec<Box<dyn Rival<f32>>> {
    let noms = [
        ["Embree, quads", "Embree ×16, quads, coherent", "Embree ×16, quads"],
        ["Embree, own boxes", "Embree ×16, own boxes, coherent", "Embree ×16, own boxes"],
    ];
    let faire = |(noms, en_quads)| {
        // A thread of its own, since whoever makes a device of Embree rounds subnormal numbers to 0 from then on.
        let foule = thread::scope(|fils| fils.spawn(|| Foule::new(objets, noms, en_quads)).join());
        assert!(
            black_box(f32::MIN_POSITIVE) / 2.0 > 0.0,
            "this thread has lost its subnormal numbers"
        );
        Box::new(foule.expect("Embree takes every scene")) as _
    };
    noms.into_iter().zip([true, false]).map(faire).collect()
}

/// Single rays, or packets that expect coherent rays or not.
impl Rival<f32> for Foule {
    fn concurrents<'a>(&'a self, rayons: &'a [Rayon<f32>], ombres: bool) -> Vec<Concurrent<'a>> {
        let [seul, coherents, quelconques] = self.noms;
        let seul = (seul, Camp::Embree);
        let mut concurrents = vec![if ombres {
            Concurrent::un_par_un(seul, rayons, |rayon| self.occulte(rayon), cachee)
        } else {
            Concurrent::un_par_un(seul, rayons, |rayon| self.premiere(rayon), dire)
        }];
        for (nom, contexte) in [
            (coherents, IntersectContext::coherent as fn() -> IntersectContext),
            (quelconques, IntersectContext::incoherent),
        ] {
            let seize = (nom, Camp::EmbreeSeize);
            let premieres = move |rayons: &[Rayon<f32>], vus: &mut [Option<Vu<f32>>]| {
                for (rayons, vus) in rayons.chunks(SEIZE).zip(vus.chunks_mut(SEIZE)) {
                    self.premieres(&mut contexte(), rayons, vus);
                }
            };
            let occultes = move |rayons: &[Rayon<f32>], caches: &mut [bool]| {
                for (rayons, caches) in rayons.chunks(SEIZE).zip(caches.chunks_mut(SEIZE)) {
                    self.occultes(&mut contexte(), rayons, caches);
                }
            };
            concurrents.push(if ombres {
                Concurrent::en_lot(seize, rayons, false, occultes, cachee)
            } else {
                Concurrent::en_lot(seize, rayons, None, premieres, dire)
            });
        }
        concurrents
    }
}

struct Foule {
    noms: [&'static str; 3],
    scene: Scene<'static>,
    plans: Vec<PlanRay<f32>>,
    spheres: Vec<Texture>,
    boites: Vec<Texture>,
    /// The number of Embree's geometry of the spheres, and of primitives in a box.
    geometrie_des_spheres: u32,
    par_boite: u32,
}

impl Foule {
    fn new(objets: &[ObjetRay<f32>], noms: [&'static str; 3], en_quads: bool) -> Self {
        let (mut plans, mut spheres, mut boites) = (vec![], vec![], vec![]);
        for objet in objets {
            match objet {
                ObjetRay::Sphere(sphere) => spheres.push(*sphere),
                ObjetRay::Plan(plan) => plans.push(*plan),
                ObjetRay::Boite(boite) => boites.push(*boite),
            }
        }
        let device = Device::new().expect("Embree");
        let mut scene = device.create_scene().expect("a scene of Embree");
        let mut geometrie_des_spheres = INVALID_ID;
        if !spheres.is_empty() {
            let mut geometrie =
                device.create_geometry(GeometryKind::SPHERE_POINT).expect("spheres of Embree");
            let mut points = geometrie
                .set_new_buffer::<[f32; 4]>(
                    BufferUsage::VERTEX,
                    0,
                    Format::FLOAT4,
                    16,
                    spheres.len(),
                )
                .expect("room for them");
            for (point, sphere) in points.iter_mut().zip(&spheres) {
                let [x, y, z] = sphere.centre().into();
                *point = [x, y, z, sphere.rayon()];
            }
            geometrie_des_spheres = scene.attach_geometry(&geometrie.commit());
        }
        if !boites.is_empty() {
            let geometrie =
                if en_quads { quads(&device, &boites) } else { les_notres(&device, &boites) };
            scene.attach_geometry(&geometrie);
        }
        scene.commit();
        Self {
            noms,
            scene,
            plans,
            spheres: spheres.iter().map(|sphere| sphere.texture()).collect(),
            boites: boites.iter().map(|boite| boite.texture()).collect(),
            geometrie_des_spheres,
            par_boite: if en_quads { 6 } else { 1 },
        }
    }

    /// The first half-space.
    fn plan(&self, rayon: &Rayon<f32>) -> Option<(&PlanRay<f32>, f32)> {
        let mut premier = None;
        let mut t_premier = f32::INFINITY;
        for plan in &self.plans {
            let t = entree_du_plan(plan, rayon);
            if t < t_premier {
                (premier, t_premier) = (Some((plan, t)), t);
            }
        }
        premier
    }

    fn premiere(&self, rayon: &Rayon<f32>) -> Option<Vu<f32>> {
        let plan = self.plan(rayon);
        let mut ici = RayHit::from_ray(vers_embree(rayon, plan.map_or(f32::INFINITY, |(_, t)| t)));
        self.scene.intersect(&mut IntersectContext::incoherent(), &mut ici);
        let RayHit { ray, hit } = ici;
        self.vu(ray.tfar, hit.normal(), hit.geomID, hit.primID, plan.map(|(plan, _)| plan))
    }

    fn occulte(&self, rayon: &Rayon<f32>) -> bool {
        let fin = rayon.fin();
        self.plans.iter().any(|plan| entree_du_plan(plan, rayon) < fin)
            || self
                .scene
                .occluded(&mut IntersectContext::incoherent(), &mut vers_embree(rayon, fin))
    }

    fn premieres(
        &self,
        contexte: &mut IntersectContext,
        rayons: &[Rayon<f32>],
        vus: &mut [Option<Vu<f32>>],
    ) {
        let mut plans = [None; SEIZE];
        let mut loin = [f32::INFINITY; SEIZE];
        for plan in &self.plans {
            for ((rayon, premier), loin) in rayons.iter().zip(&mut plans).zip(&mut loin) {
                let t = entree_du_plan(plan, rayon);
                if t < *loin {
                    (*premier, *loin) = (Some(plan), t);
                }
            }
        }
        let mut seize = RayHit16 { ray: paquet(rayons, loin), hit: Hit16::new() };
        self.scene.intersect16(contexte, &mut seize, &actifs(rayons.len()));
        let RayHit16 { ray, hit } = seize;
        for (i, vu) in vus.iter_mut().enumerate() {
            let normale = [hit.Ng_x[i], hit.Ng_y[i], hit.Ng_z[i]];
            *vu = self.vu(ray.tfar[i], normale, hit.geomID[i], hit.primID[i], plans[i]);
        }
    }

    fn occultes(
        &self,
        contexte: &mut IntersectContext,
        rayons: &[Rayon<f32>],
        caches: &mut [bool],
    ) {
        let loin = array::from_fn(|i| rayons.get(i).map_or(0.0, Rayon::fin));
        let mut seize = paquet(rayons, loin);
        self.scene.occluded16(contexte, &mut seize, &actifs(rayons.len()));
        for (cache, t) in caches.iter_mut().zip(seize.tfar) {
            *cache = t == f32::NEG_INFINITY;
        }
        for plan in &self.plans {
            for (rayon, cache) in rayons.iter().zip(&mut *caches) {
                *cache |= entree_du_plan(plan, rayon) < rayon.fin();
            }
        }
    }

    fn vu(
        &self,
        t: f32,
        normale: [f32; 3],
        geometrie: u32,
        primitive: u32,
        plan: Option<&PlanRay<f32>>,
    ) -> Option<Vu<f32>> {
        if geometrie == INVALID_ID {
            return plan.map(|plan| (t, plan.normale(), plan.texture()));
        }
        let [x, y, z] = normale;
        let longueur = (x * x + y * y + z * z).sqrt();
        let texture = if geometrie == self.geometrie_des_spheres {
            self.spheres[primitive as usize]
        } else {
            self.boites[(primitive / self.par_boite) as usize]
        };
        Some((t, [x / longueur, y / longueur, z / longueur].into(), texture))
    }
}

fn vers_embree(rayon: &Rayon<f32>, loin: f32) -> Ray {
    Ray::segment(rayon.source().into(), rayon.direction().into(), 0.0, loin)
}

fn paquet(rayons: &[Rayon<f32>], loin: [f32; SEIZE]) -> Ray16 {
    let mut seize = Ray16 { tfar: loin, ..Ray16::empty() };
    for (i, rayon) in rayons.iter().enumerate() {
        [seize.org_x[i], seize.org_y[i], seize.org_z[i]] = rayon.source().into();
        [seize.dir_x[i], seize.dir_y[i], seize.dir_z[i]] = rayon.direction().into();
    }
    seize
}

fn actifs(combien: usize) -> ValidMaskN<SEIZE> {
    let actif = |i| if i < combien { ValidMask::Valid } else { ValidMask::Invalid };
    ValidMaskN::new(array::from_fn(actif))
}

/// The distance at which a ray enters a half-space, +∞ if it does not.
fn entree_du_plan(plan: &PlanRay<f32>, rayon: &Rayon<f32>) -> f32 {
    let n = plan.normale();
    let vers = n.produit_scalaire(rayon.direction());
    let t = -(plan.distance() + n.produit_scalaire(rayon.source())) / vers;
    if vers < 0.0 && t > 0.0 { t } else { f32::INFINITY }
}

/// Six outward quads a box.
fn quads(device: &Device, boites: &[BoiteRay<f32>]) -> embree3::Geometry<'static> {
    // Corner i has the sign of its k-th coordinate in bit k.
    const FACES: [[u32; 4]; 6] =
        [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    let mut geometrie = QuadMeshBuilder::new(device).expect("quads of Embree");
    let mut coins = geometrie
        .set_new_buffer::<[f32; 3]>(BufferUsage::VERTEX, 0, Format::FLOAT3, 12, 8 * boites.len())
        .expect("room for them");
    for (coins, boite) in coins.chunks_mut(8).zip(boites) {
        let ([x, y, z], [a, b, c]) = (boite.normales(), boite.demi_longueurs());
        for (i, coin) in coins.iter_mut().enumerate() {
            let signe = |k: usize| if i >> k & 1 == 1 { 1.0_f32 } else { -1.0 };
            let ecart = x * (a * signe(0)) + y * (b * signe(1)) + z * (c * signe(2));
            *coin = (boite.centre() + ecart).into();
        }
    }
    let mut faces = geometrie
        .set_new_buffer::<[u32; 4]>(BufferUsage::INDEX, 0, Format::UINT4, 16, 6 * boites.len())
        .expect("room for them");
    for (i, faces) in (0..).zip(faces.chunks_mut(6)) {
        for (face, coins) in faces.iter_mut().zip(FACES) {
            *face = coins.map(|coin| 8 * i + coin);
        }
    }
    geometrie.commit()
}

/// Boxes that Embree asks us about.
fn les_notres(device: &Device, boites: &[BoiteRay<f32>]) -> embree3::Geometry<'static> {
    type Boites = Arc<[BoiteRay<f32>]>;
    let boites: Boites = boites.into();
    let mut geometrie = UserGeometryBuilder::new(device).expect("a geometry of our own");
    geometrie.set_primitive_count(boites.len() as u32);
    geometrie.set_bounds_function_owned(
        |bornes: &mut Bounds, i, _, boites: Option<&Boites>| {
            let boite = &boites.expect("the boxes")[i as usize];
            let demi = boite.demi_longueurs();
            let normales = boite.normales().map(<[f32; 3]>::from);
            let etendue: [f32; 3] =
                array::from_fn(|k| (0..3).map(|i| (normales[i][k] * demi[i]).abs()).sum());
            let centre = <[f32; 3]>::from(boite.centre());
            // Larger by the rounding.
            let etendue: [f32; 3] =
                array::from_fn(|k| etendue[k] + 1e-6 * (etendue[k] + centre[k].abs()));
            let cote = |k: usize, signe: f32| centre[k] + signe * etendue[k];
            [bornes.lower_x, bornes.lower_y, bornes.lower_z] = [0, 1, 2].map(|k| cote(k, -1.0));
            [bornes.upper_x, bornes.upper_y, bornes.upper_z] = [0, 1, 2].map(|k| cote(k, 1.0));
        },
        Arc::clone(&boites),
    );
    geometrie.set_intersect_function_owned(
        |demande: &mut IntersectFunctionNArgs<'_, Boites>| {
            let (geometrie, i) = (demande.geom_id(), demande.prim_id());
            let boite = demande.user_data().expect("the boxes")[i as usize];
            demande.for_each_active_lane(|mut voie| {
                let mut rayon = voie.ray();
                if let Some((t, axe)) = entree_de_la_boite(&boite, &rayon) {
                    rayon.tfar = t;
                    let [x, y, z] = boite.normales()[axe].into();
                    let devant = x * rayon.dir_x + y * rayon.dir_y + z * rayon.dir_z < 0.0;
                    let signe = if devant { 1.0 } else { -1.0 };
                    let [x, y, z] = [x, y, z].map(|x| signe * x);
                    let (geom, prim) = (geometrie, i);
                    voie.commit_hit(
                        &rayon,
                        &Hit {
                            Ng_x: x,
                            Ng_y: y,
                            Ng_z: z,
                            u: 0.0,
                            v: 0.0,
                            primID: prim,
                            geomID: geom,
                            instID: [INVALID_ID],
                        },
                    );
                }
            });
        },
        Arc::clone(&boites),
    );
    geometrie.set_occluded_function_owned(
        |demande: &mut OccludedFunctionNArgs<'_, Boites>| {
            let boite = demande.user_data().expect("the boxes")[demande.prim_id() as usize];
            demande.for_each_active_lane(|mut voie| {
                if entree_de_la_boite(&boite, &voie.ray()).is_some() {
                    voie.set_occluded();
                }
            });
        },
        boites,
    );
    geometrie.commit()
}

/// The distance at which a ray enters a box within its segment, and the axis of the face.
#[inline(always)]
fn entree_de_la_boite(boite: &BoiteRay<f32>, rayon: &Ray) -> Option<(f32, usize)> {
    let (normales, demi) = (boite.normales(), boite.demi_longueurs());
    let [x, y, z] = boite.centre().into();
    let vers = [x - rayon.org_x, y - rayon.org_y, z - rayon.org_z];
    let (mut entree, mut sortie, mut axe) = (0.0_f32, rayon.tfar, 3);
    for k in 0..3 {
        let [x, y, z] = normales[k].into();
        let au_centre = x * vers[0] + y * vers[1] + z * vers[2];
        let inverse = 1.0 / (x * rayon.dir_x + y * rayon.dir_y + z * rayon.dir_z);
        let (a, b) = ((au_centre - demi[k]) * inverse, (au_centre + demi[k]) * inverse);
        let (pres, loin) = if inverse < 0.0 { (b, a) } else { (a, b) };
        if pres > entree {
            (entree, axe) = (pres, k);
        }
        sortie = sortie.min(loin);
    }
    (axe < 3 && entree <= sortie).then_some((entree, axe))
}
