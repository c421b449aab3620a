//! The promises of `docs/precision.md`, in the order of its table, against the oracle at the extremes.
//!
//! `LANCER_RAYON_CAS` is how many thousand cases each regime runs (1 unless set):
//! `LANCER_RAYON_CAS=1000 cargo test --release --test precision promesses`

use commun::fabrique::{boite, boite_droite, sphere, v};
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::mesure::{absolu, au_bord, quantiles};
use commun::oracle::{Passage, hauteur, verite, verite_du};
use commun::promesses::{Essai, Part, Promesse, RIEN, marge_infinie, toutes};
use commun::regimes::{
    Cas, Extreme, Genre, Regime, deux_puissance, direction, regimes, signe, vers_la_sortie,
};
use commun::tolerances::{ORTHONORMALE, u};
use commun::{arrondi, en_f32_et_f64};
use fastrand::Rng;
use lancer_rayon::pour_les_tests::TANGENT;
use lancer_rayon::{
    NoIntersection, Nombre, ObjetGeo, ObjetRay, PlanGeo, Rayon, Reel, Rotation, Texture, Vecteur,
};

fn cas_par_regime() -> u32 {
    commun::cas(1_000)
}

/// A case of a regime and the direction in which its object is left: anywhere, straight, or along the tangent plane or
/// beside it by 2⁻⁶⁰ … 1.
fn essai<R: Reel>(regime: &Regime<R>, passage: Passage, alea: &mut Hasard) -> Essai<R> {
    let cas = (regime.cas)(alea);
    let Cas { objet, rayon } = match passage {
        Passage::Entree => cas,
        Passage::Sortie => vers_la_sortie(cas, alea),
    };
    let [x, y, z] = direction(alea).into();
    let penche = f64::from(u8::from(alea.bool()));
    let haut = signe(alea)
        * match alea.u8(0..4) {
            0 => 0.0,
            1 => 1e9,
            2 => deux_puissance(alea, -56.0, -50.0),
            _ => deux_puissance(alea, -60.0, 0.0),
        };
    let vers = [x, y, z, haut, penche].map(R::depuis_f64);
    Essai { objets: vec![objet], rayon, passage, vers }
}

/// The parts of a promise that the cases of a regime take, as they are or as `voir` changes them.
fn juger<R: Reel, S: Reel>(
    regime: &Regime<R>,
    passage: Passage,
    promesse: &Promesse<S>,
    voir: impl Fn(Essai<R>) -> Essai<S>,
) -> Vec<f64> {
    let mut parts = Vec::new();
    let faire = |alea: &mut Hasard| voir(essai(regime, passage, alea));
    pour_chaque(cas_par_regime(), faire, |essai| {
        let part = (promesse.part)(&essai);
        assert!(part <= 1.0, "{}, {}: {part} of what is promised", promesse.nom, regime.nom);
        parts.push(part);
    });
    parts
}

/// Each promise of the table holds in each regime of its shapes, and the bounds that a program may ask for are not
/// loose.
fn chaque_promesse_tient<R: Reel>() {
    for regime in regimes::<R>() {
        for passage in Passage::TOUS {
            for promesse in toutes::<R>().into_iter().filter(|p| p.parle(passage, regime.genre)) {
                let parts = juger(&regime, passage, &promesse, |essai| essai);
                let nom = format!("{}, {passage:?}: {}", promesse.nom, regime.nom);
                let mut aisances: Vec<_> =
                    parts.iter().filter(|part| **part > 0.0).map(|part| 1.0 / part).collect();
                let [mediane, ..] = quantiles(&mut aisances);
                let permise = promesse.aisance[usize::from(regime.extreme != Extreme::Aucun)];
                assert!(
                    mediane.is_nan() || mediane <= permise,
                    "{nom}: {mediane} times as much in the median"
                );
                // Some regimes have no spheres that are nearly lost in their distance.
                let rare = std::ptr::fn_addr_eq(promesse.part, marge_infinie as Part<R>);
                let jugees = parts.iter().filter(|part| **part > RIEN).count();
                assert!(rare || jugees > parts.len() / 100, "{nom}: {jugees} judged only");
            }
        }
    }
}

en_f32_et_f64!(chaque_promesse_tient);

/// Each regime is as hard as its name says: among easy cases no promise would be seen to break. How many of its cases lie
/// within a thousand bands of the decision or within one of two faces, how many objects are far away beside their size,
/// and how many are as large or as small as a scene can hold, or seen from as far.
fn chaque_regime_est_aussi_dur_qu_il_le_dit<R: Reel>() {
    const CAS: u32 = 1_000;
    let limite = R::LIMITE.vers_f64() / 16.0;
    for regime in regimes::<R>() {
        let [mut serres, mut lointains, mut extremes] = [0; 3];
        let faire = |alea: &mut Hasard| (regime.cas)(alea);
        pour_chaque(CAS, faire, |Cas { objet, rayon }| {
            let verite = verite(&objet, &rayon);
            let nommees = match (&objet, &verite.entree) {
                (ObjetRay::Boite(boite), Some(entree)) => {
                    let faces = boite.normales().into_iter().flat_map(|n| [n, -n]);
                    faces.filter(|n| entree.ecart_de_normale(*n) == 0.0).count()
                }
                _ => 0,
            };
            serres += u32::from(nommees > 1 || verite.facteur() < 1e3);
            let s = rayon.source().vers_f64();
            let etendue = objet.etendue().map(|e| [e.bas, e.haut].map(Vecteur::vers_f64));
            let [bas, haut] = etendue.unwrap_or([Vecteur::NUL; 2]);
            let (taille, loin) = ((haut - bas).longueur(), (s - bas).longueur() + bas.longueur());
            lointains += u32::from(taille > 0.0 && loin > 1e3 * taille);
            let au_bout = |x: f64| x > limite || (x > 0.0 && x < 1.0 / limite);
            extremes += u32::from(au_bout(taille) || au_bout(loin));
        });
        let parts = [serres, lointains, extremes].map(|n| f64::from(n) / f64::from(CAS));
        println!("{}: {parts:?}", regime.nom);
        let [serres, lointains, extremes] = parts;
        let assez_dur = match regime.extreme {
            // A box may be small in all three dimensions.
            Extreme::Aucun => serres < 0.05 && lointains < 0.35,
            Extreme::Loin => lointains > 0.35,
            Extreme::Parallele | Extreme::Decision => serres > 0.1,
            Extreme::Bornes => extremes > 0.3,
        };
        assert!(assez_dur, "{}: {parts:?}", regime.nom);
    }
}

en_f32_et_f64!(chaque_regime_est_aussi_dur_qu_il_le_dit);

/// What holds for the numbers of an `f32` scene in `f64`, which are unit only to the rounding of `f32`: all except what
/// rests on the length of the normal of a flat face. `docs/preuves/modele.md` promises less.
#[test]
fn les_promesses_tiennent_de_nombres_elargis() {
    let elargir = |Essai { objets, rayon, passage, vers }: Essai<f32>| {
        let objets = objets.iter().map(ObjetRay::temoin_f64).collect();
        Essai { objets, rayon: rayon.temoin_f64(), passage, vers: vers.map(f64::from) }
    };
    let refusees =
        ["length of the normal", "margin", "secondary ray", "mirror", "refraction", "sun"];
    for regime in regimes::<f32>() {
        for passage in Passage::TOUS {
            for promesse in toutes::<f64>() {
                let refusee = regime.genre != Genre::Sphere && refusees.contains(&promesse.nom);
                if promesse.parle(passage, regime.genre) && !refusee {
                    juger(&regime, passage, &promesse, elargir);
                }
            }
        }
    }
}

/// Where a way out is promised to be off by less than a quarter of its distance, `erreur` is a number, for thin plates,
/// beside edges and where the ray grazes too.
fn l_erreur_d_une_sortie_est_un_nombre<R: Reel>() {
    // At the ends of the range products leave the normal numbers of `f64`.
    for regime in regimes::<R>().into_iter().filter(|regime| regime.extreme != Extreme::Bornes) {
        let mut jugees = 0;
        let faire = |alea: &mut Hasard| essai(&regime, Passage::Sortie, alea);
        pour_chaque(cas_par_regime(), faire, |Essai { objets, rayon, .. }| {
            let objet = objets[0];
            let Ok(sortie) = objet.sortie(&rayon) else { return };
            let verite = verite_du(Passage::Sortie, &objet, &rayon);
            let Some(entree) = verite.entree.filter(|_| !verite.dans_la_marge) else { return };
            let permis = entree.k * u::<R>() * entree.kappa_t + absolu(&objet, &entree);
            if permis < 0.25 * entree.t.vers_f64() {
                assert!(objet.erreur(&rayon, &sortie) < R::INFINI, "{}: {sortie:?}", regime.nom);
                jugees += 1;
            }
        });
        assert!(jugees > cas_par_regime() / 100, "{}: {jugees} judged only", regime.nom);
    }
}

en_f32_et_f64!(l_erreur_d_une_sortie_est_un_nombre);

/// A half-space and rays exactly parallel to it, with zero written in each of its ways.
fn un_rayon_parallele_manque_et_la_moindre_pente_arrive<R: Reel>() {
    let (zero, petit, un) = (R::ZERO, R::ETA, R::UN);
    let sol = ObjetRay::from(PlanGeo::new(Rotation::IDENTITE, zero, Texture(0)).unwrap());
    let vers = |z: R| {
        let rayon = Rayon::new(Vecteur::new(zero, zero, un), Vecteur::new(un, zero, z)).unwrap();
        sol.intersection(&rayon)
    };
    for z in [zero, -zero, petit] {
        assert_eq!(vers(z), Err(NoIntersection));
    }
    // From a height of one unit the smallest descent arrives farther than any number of the type.
    assert_eq!(vers(-petit), Err(NoIntersection));
    let pente = R::depuis_f64((-100_f64).exp2());
    assert_eq!(vers(-pente).unwrap().distance(), un / pente);
}

en_f32_et_f64!(un_rayon_parallele_manque_et_la_moindre_pente_arrive);

/// Where a coordinate of the point overflows, the margin is +∞ and not a NaN.
#[test]
fn la_marge_d_un_point_hors_du_type_est_infinie() {
    let mur = ObjetGeo::from(PlanGeo::new(Rotation::<f32>::IDENTITE, 0.0, Texture(0)).unwrap());
    let haut = Vecteur::new(0.0, 0.0, f32::LIMITE);
    // It is unit to rounding, but one unit in the last place longer than 1.
    let vers = Vecteur::new(
        1.0 + f32::EPSILON,
        0.0,
        -f32::LIMITE / (f32::MAX * (1.0 - f32::EPSILON / 2.0)),
    );
    let rayon = Rayon::new(haut, vers).unwrap();
    let touche = mur.vers_ray().intersection(&rayon).unwrap();
    assert_eq!(rayon.point(touche.distance()).x, f32::INFINITY);
    assert_eq!(touche.marge(), f32::INFINITY);
    assert_eq!(touche.secondaire(touche.normale()).unwrap_err().champ, "marge");
    // The point is finite, and the weights of its height are not, along an N and a D that are longer than 1.
    let (a, peu) = (core::f32::consts::FRAC_1_SQRT_2.next_up().next_up(), 2_f32.powi(-30));
    let tour = [[a, a, 0.0], [-peu * a, peu * a, 1.0], [a, -a, peu]];
    let tour = Rotation::depuis_matrice(tour).unwrap();
    let haut = f32::MAX * (1.0 - f32::EPSILON) * peu * 2_f32.powi(-38);
    let mur = ObjetRay::from(PlanGeo::new(tour, haut, Texture(0)).unwrap());
    let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(a, a, -(2_f32.powi(-38)))).unwrap();
    let touche = mur.intersection(&rayon).unwrap();
    assert!(
        <[f32; 3]>::from(touche.point()).into_iter().all(f32::is_finite)
            && touche.marge() == f32::INFINITY,
        "{touche:?}"
    );
}

#[test]
fn un_rayon_secondaire_invalide_est_refuse() {
    let boule = sphere(Vecteur::new(0.0, 0.0, -5.0), 1.0);
    let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0)).unwrap();
    let touche = boule.intersection(&rayon).unwrap();
    let n = touche.normale();
    let refus = |d| touche.secondaire(d).unwrap_err().champ;
    assert_eq!(refus(Vecteur::NUL), "direction");
    assert_eq!(refus(n * f64::NAN), "direction.x");
    assert_eq!(touche.vers_soleil(Vecteur::NUL).unwrap_err().champ, "soleil");
}

/// A direction at the limit itself, 3.2u, is tangent: its ray starts outside and leaves, and a lamp in that direction
/// gives no light.
fn la_limite_du_plan_tangent_est_tangente<R: Reel>() {
    let v = |x, z| Vecteur::new(x, R::ZERO, z);
    let sol = ObjetRay::from(PlanGeo::new(Rotation::IDENTITE, R::ZERO, Texture(0)).unwrap());
    let rayon = Rayon::new(v(R::ZERO, R::UN), v(R::ZERO, -R::UN)).unwrap();
    let touche = sol.intersection(&rayon).unwrap();
    let part = |z| touche.secondaire(v(R::UN, z)).unwrap();
    let limite = R::depuis_f64(TANGENT) * R::U;
    let dessus = limite + limite * R::U * R::depuis_f64(2.0);
    assert!(part(-dessus).source().z < R::ZERO && part(dessus).direction().z == dessus);
    for z in [-limite, limite] {
        assert!(part(z).source().z > R::ZERO && part(z).direction().z > dessus);
    }
    let eclaire = |z| touche.vers_lumiere(part(R::UN).source() + v(R::UN, z)).is_ok();
    assert!(eclaire(dessus) && !eclaire(limite));
}

en_f32_et_f64!(la_limite_du_plan_tangent_est_tangente);

/// |R·Rᵀ − I| ≤ 5.5u after 10^6 compositions, whatever is composed.
fn un_million_de_rotations_ne_derive_pas<R: Reel>() {
    let r = |x, y, z| Rotation::<R>::new(arrondi(Vecteur::new(x, y, z))).unwrap();
    let mut alea = Rng::with_seed(6);
    let (a, b) = (r(0.1, -0.2, 0.3), r(1.0, 2.0, 3.0));
    let suites: [&mut dyn FnMut(u32) -> Rotation<R>; 3] =
        [&mut |_| a, &mut |i| if i % 2 == 0 { a } else { b }, &mut |_| {
            r(7.0 * alea.f64(), 7.0 * alea.f64(), 7.0 * alea.f64())
        }];
    for suite in suites {
        let m = (0..1_000_000).fold(Rotation::IDENTITE, |m: Rotation<R>, i| m.puis(suite(i)));
        let m = m.matrice().map(|ligne| ligne.map(R::vers_f64));
        for i in 0..3 {
            for j in 0..3 {
                let produit: f64 = (0..3).map(|k| m[i][k] * m[j][k]).sum();
                let ecart = (produit - f64::from(u8::from(i == j))).abs();
                assert!(ecart <= ORTHONORMALE * u::<R>(), "off by {ecart:e}");
            }
        }
    }
}

en_f32_et_f64!(un_million_de_rotations_ne_derive_pas);

/// A hit beside an edge, seen from afar, is off by much along the ray, of which the margin over its face knows nothing.
/// So an inward ray may start above another face, by a thousand times its margin, and enter there, but by no more than
/// lemma 6 grants.
#[test]
fn un_depart_vers_l_interieur_peut_etre_au_dessus_d_une_autre_face() {
    let centre = v(-0.0077286684, 0.018294489, 0.19977821);
    let boite = boite_droite(centre, v(1.0, 2.0 * 0.57481515, 2.0 * 0.7004555));
    let d = v(0.0039478806, -0.99913543, -0.041385863);
    let rayon = Rayon::new(v::<f32>(-58.45057, 14664.854, 606.94366), d).unwrap();
    let touche = boite.intersection(&rayon).unwrap();
    let dedans = touche.secondaire(v(0.20613794, -0.8412872, -0.4997429)).unwrap();
    let encore = boite.intersection(&dedans).unwrap();
    assert!(au_bord(&boite, &rayon, &touche, dedans.source(), &encore), "{dedans:?}");
    let haut = hauteur(&boite, encore.normale(), dedans.source());
    assert!(haut > 1_000.0 * f64::from(touche.marge()), "{haut:e} {}", touche.marge());
}

/// Far from O a plate may be no thicker than the step. Some of the rays sent inward amid its face start beyond it and
/// never leave. Every ray leaves a cube.
#[test]
fn ce_qui_est_plus_mince_que_le_pas_n_a_pas_de_sortie() {
    let tour = Rotation::new(v::<f32>(0.3, 0.4, 0.0)).unwrap();
    let centre = v(0.0, 0.0, -3_000.0);
    let faire = |alea: &mut Hasard| arrondi(centre.vers_f64() + direction(alea) * 0.25);
    let mut sortis = [0; 2];
    pour_chaque(cas_par_regime(), faire, |vers| {
        let rayon = Rayon::new(Vecteur::NUL, vers).unwrap();
        for (epaisseur, sortis) in [0.0002, 2.0].into_iter().zip(&mut sortis) {
            let objet = boite(centre, v(2.0, 2.0, epaisseur), tour);
            let dedans = objet.intersection(&rayon).unwrap().secondaire(rayon.direction()).unwrap();
            *sortis += u32::from(objet.sortie(&dedans).is_ok());
        }
    });
    assert!(sortis[0] < cas_par_regime() && sortis[1] == cas_par_regime(), "{sortis:?}");
}
