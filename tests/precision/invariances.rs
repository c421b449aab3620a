//! A hit changes as it should when its scene is scaled, mirrored or turned onto other axes.

use commun::fabrique::{boite_droite, sphere};
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::oracle::verite;
use commun::regimes::direction;
use commun::tolerances::{promesses, u};
use commun::{arrondi, en_f32_et_f64};
use lancer_rayon::{
    BoiteGeo, ObjetGeo, PlanGeo, Rayon, Reel, Rotation, SphereGeo, Texture, Vecteur,
};

const CAS: u32 = 1_000;

/// Where no product is subnormal, scaling everything by a power of two changes no bit except the exponent of the
/// distance, over the whole range that a scene can hold.
fn une_puissance_de_deux_ne_change_aucun_bit<R: Reel>() {
    let bits = R::LIMITE.vers_f64().log2();
    let faire = |alea: &mut Hasard| {
        let (centre, d) = (direction(alea) * 4.0, direction(alea));
        let (rayon, dimensions) = (0.5 + alea.f64(), direction(alea));
        let m = Rotation::new(arrondi::<R>(direction(alea) * 3.0)).unwrap();
        let source = centre - d * (3.0 * alea.f64() + 2.0) + direction(alea) * 0.7;
        (centre, d, rayon, dimensions, m, source)
    };
    pour_chaque(CAS, faire, |(centre, d, rayon, dimensions, m, source)| {
        let texture = Texture(0);
        let touche = |k: R| {
            let c = arrondi(centre) * k;
            let [x, y, z] = [dimensions.x, dimensions.y, dimensions.z];
            let dimensions = arrondi(Vecteur::new(x.abs() + 0.5, y.abs() + 0.5, z.abs() + 0.5)) * k;
            let d_plan = R::depuis_f64(-centre.longueur()) * k;
            let r = Rayon::new(arrondi(source) * k, arrondi(d)).unwrap();
            [
                ObjetGeo::from(SphereGeo::new(c, R::depuis_f64(rayon) * k, texture).unwrap()),
                ObjetGeo::from(PlanGeo::new(m, d_plan, texture).unwrap()),
                ObjetGeo::from(BoiteGeo::new(c, dimensions, m, texture).unwrap()),
            ]
            .map(|objet| objet.vers_ray().intersection(&r).map(|t| (t.distance() / k, t.normale())))
        };
        let attendu = touche(R::UN);
        for exposant in [-bits + 4.0, -bits / 2.0, -1.0, 7.0, bits - 4.0] {
            assert_eq!(touche(R::depuis_f64(exposant.exp2())), attendu, "2^{exposant}");
        }
    });
}

en_f32_et_f64!(une_puissance_de_deux_ne_change_aucun_bit);

/// A scene along the axes that is mirrored, or whose axes are exchanged, gives the same distance to the bound, and for
/// the mirror to the bit, since no sign is privileged.
fn ni_signe_ni_axe_n_est_privilegie<R: Reel>() {
    let mut touches = 0;
    let faire = |alea: &mut Hasard| {
        let (c, d) = (direction(alea) * 4.0, direction(alea));
        let s = c - d * 5.0 + direction(alea) * 0.5;
        (c, d, s, [(); 3].map(|()| 0.5 + alea.f64()), 0.5 + alea.f64())
    };
    pour_chaque(CAS, faire, |(c, d, s, l, r)| {
        let lancer = |transforme: &dyn Fn([f64; 3]) -> [f64; 3]| {
            let v = |v: Vecteur| arrondi::<R>(transforme(v.into()).into());
            let dimensions = transforme(l).map(f64::abs);
            let boite = boite_droite(v(c), arrondi(dimensions.into()));
            let boule = sphere(v(c), R::depuis_f64(r));
            let rayon = Rayon::new(v(s), v(d)).unwrap();
            [boite, boule].map(|objet| {
                let touche = objet.intersection(&rayon).ok();
                let kappa_t = verite(&objet, &rayon).entree.map_or(f64::INFINITY, |e| e.kappa_t);
                touche.map(|t| {
                    (t.distance().vers_f64(), <[f64; 3]>::from(t.normale().vers_f64()), kappa_t)
                })
            })
        };
        let direct = lancer(&|v| v);
        let miroir = lancer(&|[x, y, z]| [-x, y, -z]);
        let permute = lancer(&|[x, y, z]| [z, x, y]);
        for ((a, b), c) in direct.into_iter().zip(miroir).zip(permute) {
            assert_eq!(a.is_some(), b.is_some());
            let (Some((t, [x, y, z], kappa_t)), Some((t_m, n_m, _))) = (a, b) else { continue };
            touches += 1;
            assert_eq!((t_m, n_m), (t, [-x, y, -z]));
            if let Some((t_p, ..)) = c {
                // The sums have another order, which makes two errors of K·u·κt. The K of a sphere is the larger.
                assert!((t_p - t).abs() <= 2.0 * promesses::DISTANCE_SPHERE * u::<R>() * kappa_t);
            }
        }
    });
    assert!(touches > CAS / 2);
}

en_f32_et_f64!(ni_signe_ni_axe_n_est_privilegie);
