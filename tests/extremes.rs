//! The promises of `docs/precision.md` at the extremes, against the oracle, in both types.
//!
//! `LANCER_RAYON_CAS` sets how many cases each regime runs (1 000 unless set):
//! `LANCER_RAYON_CAS=1000000 cargo test --release --all-features --test extremes`

mod commun;

use commun::arrondi;
use commun::mesure::{au_bord, mesurer, quantiles};
use commun::oracle::{Entree, hauteur, verite};
use commun::regimes::{Cas, direction, regimes, vectoriel};
use commun::tolerances::{ORTHONORMALE, promesses, u};
use fastrand::Rng;
use lancer_rayon::{
    BoiteGeo, Intersection, NoIntersection, ObjetGeo, ObjetRay, PlanGeo, Rayon, Reel, Rotation,
    SphereGeo, Texture, Vecteur, premiere_intersection,
};

/// K of the promise for the distance to an object.
fn k<R: Reel>(objet: &ObjetRay<R>) -> f64 {
    match objet {
        ObjetRay::Sphere(_) => promesses::DISTANCE_SPHERE,
        ObjetRay::Plan(_) => promesses::DISTANCE_PLAN,
        ObjetRay::Boite(_) => promesses::DISTANCE_BOITE,
    }
}

fn cas_par_regime() -> u32 {
    commun::cas(1_000)
}

/// Hit or miss never wrong outside the margin, distance to its K·2⁻⁵³·cond, normal to its bound.
fn distances_et_normales<R: Reel>() {
    for regime in regimes::<R>() {
        let mesure = mesurer(&regime, cas_par_regime(), 1, |objet, rayon| {
            objet.intersection(rayon).ok().map(|touche| (touche.distance, touche.normale))
        });
        let nom = regime.nom;
        assert!(mesure.touches > cas_par_regime() / 10, "{nom}: {} hits only", mesure.touches);
        assert_eq!(mesure.fausses, 0, "{nom}: wrong hits or misses");
        let k = match nom.split_once(',') {
            Some(("sphere", _)) => promesses::DISTANCE_SPHERE,
            Some(("half-space", _)) => promesses::DISTANCE_PLAN,
            Some(("box", _)) => promesses::DISTANCE_BOITE,
            autre => panic!("{autre:?} is no shape"),
        };
        assert!(mesure.k_promis <= k, "{nom}: K = {}", mesure.k_promis);
        // Beside the error itself, the normal of the oracle has been rounded to f64.
        assert!(mesure.normale <= 1.01, "{nom}: normal off by {} of its bound", mesure.normale);
    }
}

#[test]
fn distances_et_normales_f32() {
    distances_et_normales::<f32>();
}

#[test]
fn distances_et_normales_f64() {
    distances_et_normales::<f64>();
}

/// The hits of a regime, and the randomness for what follows them.
fn touches<R: Reel>(
    cas: fn(&mut Rng) -> Cas<R>,
    mut suite: impl FnMut(&Cas<R>, &Intersection<R>, &mut Rng),
) {
    let mut alea = Rng::with_seed(2);
    for _ in 0..cas_par_regime() {
        let cas = cas(&mut alea);
        if let Ok(touche) = cas.objet.intersection(&cas.rayon) {
            let cosinus = touche.normale.produit_scalaire(cas.rayon.direction());
            assert!(touche.distance > R::ZERO && cosinus < R::ZERO, "{cas:?} {touche:?}");
            suite(&cas, &touche, &mut alea);
        }
    }
}

/// `marge()` is never exceeded, and of random scenes most often no more than 16 times the error.
fn marges<R: Reel>() {
    for regime in regimes::<R>() {
        let mut aisances = Vec::new();
        touches(regime.cas, |cas, touche, _| {
            let point = cas.rayon.point(touche.distance);
            if touche.marge() < R::INFINI {
                let ecart = hauteur(&cas.objet, touche.normale, point).abs();
                let marge = touche.marge().vers_f64();
                assert!(ecart <= marge, "{}: {ecart:e} > {marge:e}, {cas:?}", regime.nom);
                if ecart > 0.0 {
                    aisances.push(marge / ecart);
                }
            } else {
                assert!(touche.marge() == R::INFINI, "{}: {touche:?}", regime.nom);
            }
        });
        let [mediane, ..] = quantiles(&mut aisances);
        if regime.nom.ends_with("ordinary") {
            assert!(mediane <= 16.0, "{}: median looseness {mediane}", regime.nom);
        }
    }
}

#[test]
fn la_marge_borne_l_ecart() {
    marges::<f32>();
    marges::<f64>();
}

/// Where a coordinate of the point overflows, the margin is +∞ and no NaN.
#[test]
fn la_marge_d_un_point_hors_du_type_est_infinie() {
    let mur = ObjetGeo::from(PlanGeo::new(Rotation::<f32>::IDENTITE, 0.0, Texture(0)).unwrap());
    let haut = Vecteur::new(0.0, 0.0, f32::LIMITE);
    // Unit to rounding, but longer than 1 by a unit in the last place.
    let vers = Vecteur::new(
        1.0 + f32::EPSILON,
        0.0,
        -f32::LIMITE / (f32::MAX * (1.0 - f32::EPSILON / 2.0)),
    );
    let rayon = Rayon::new(haut, vers).unwrap();
    let touche = mur.vers_ray().intersection(&rayon).unwrap();
    assert_eq!(rayon.point(touche.distance).x, f32::INFINITY);
    assert_eq!(touche.marge(), f32::INFINITY);
    assert!(rayon.secondaire(&touche, touche.normale).is_err());
}

/// What the f32 search sees at the end of the range, the conclusion in f64 sees beyond it.
#[test]
fn une_distance_au_bord_du_type_reste_finie() {
    let (a, b, c) = (0.746_069_25_f32, 0.665_868_34_f32, 4.297_683_7e-12_f32);
    let m = Rotation::depuis_matrice([[b, -a, 0.0], [a * c, b * c, -1.0], [a, b, c]]).unwrap();
    let sol = ObjetGeo::from(PlanGeo::new(m, 0.0, Texture(0)).unwrap()).vers_ray();
    let source = Vecteur::new(a, b, c) * 59_f32.exp2();
    let rayon = Rayon::new(source, Vecteur::new(4.974_663e-12, -1.202_809_4e-11, 1.0)).unwrap();
    assert!(sol.intersection(&rayon).unwrap().distance < f32::INFINITY);
}

/// Directions from a surface of normal `n`: any, straight in and out, along the tangent plane to
/// the last bit, and tilted from it by 2⁻⁶⁰ … 1 to either side.
fn directions_secondaires(n: Vecteur, alea: &mut Rng) -> [Vecteur; 8] {
    let au_hasard = direction(alea);
    let tangente = au_hasard - n * au_hasard.produit_scalaire(n);
    let peu = n * (-60.0 * alea.f64()).exp2();
    let tres_peu = n * (-50.0 - 6.0 * alea.f64()).exp2();
    [
        au_hasard,
        n,
        -n,
        tangente,
        tangente + peu,
        tangente - peu,
        tangente + tres_peu,
        tangente - tres_peu,
    ]
}

/// No secondary ray touches the object that it leaves, and none starts farther than promised.
fn secondaires<R: Reel>() {
    let mut lances = 0_u64;
    // With what misses, enough for 10^6 rays from the 1 000 cases that are the default.
    let fois = 24;
    for regime in regimes::<R>() {
        let mut refus = 0_u64;
        touches(regime.cas, |cas, touche, alea| {
            let n = touche.normale.vers_f64();
            let point = cas.rayon.point(touche.distance);
            for _ in 0..fois {
                for vers in directions_secondaires(n, alea) {
                    let Ok(rayon) = cas.rayon.secondaire(touche, arrondi(vers)) else {
                        refus += 1;
                        continue;
                    };
                    lances += 1;
                    let encore = cas.objet.intersection(&rayon);
                    let dedans = rayon.direction().produit_scalaire(touche.normale) < R::ZERO;
                    assert!(
                        encore == Err(NoIntersection)
                            || dedans && au_bord(&cas.objet, touche, rayon.source()),
                        "{}: {cas:?} {touche:?} left by {rayon:?} is touched again: {encore:?}",
                        regime.nom
                    );
                    // Turned outward by 8u, kept up to 6u too long, and rounded in each coordinate.
                    let voulue = arrondi::<R>(vers).vers_f64().unitaire().unwrap();
                    let tournee = (rayon.direction().vers_f64() - voulue).longueur();
                    assert!(tournee <= 20.0 * u::<R>(), "{}: turned by {tournee:e}", regime.nom);
                    let pas = (rayon.source().vers_f64() - point.vers_f64()).longueur();
                    let np = [
                        n.x * point.x.vers_f64(),
                        n.y * point.y.vers_f64(),
                        n.z * point.z.vers_f64(),
                    ];
                    let poids: f64 = np.into_iter().map(f64::abs).sum();
                    // The last term is the rounding of the start itself, in three coordinates.
                    let permis = touche.marge().vers_f64() * (1.0 + 32.0 * u::<R>())
                        + 2.0 * u::<R>() * poids
                        + 2.0 * u::<R>() * point.vers_f64().longueur();
                    assert!(pas <= permis, "{}: moved by {pas:e}, {permis:e} allowed", regime.nom);
                }
            }
        });
        // Refused only where the point, or the bound, is beyond the range of a source.
        let aux_bornes = regime.nom.ends_with("range") || regime.nom.ends_with("parallel");
        assert!(
            refus == 0 || aux_bornes || regime.nom.starts_with("sphere, far"),
            "{}: {refus} refused",
            regime.nom
        );
    }
    println!("{lances} secondary rays");
    assert!(lances >= 1_000 * u64::from(cas_par_regime()), "{lances} rays only");
}

#[test]
fn un_rayon_secondaire_ne_retouche_pas_l_objet_qu_il_quitte_f32() {
    secondaires::<f32>();
}

#[test]
fn un_rayon_secondaire_ne_retouche_pas_l_objet_qu_il_quitte_f64() {
    secondaires::<f64>();
}

#[test]
fn un_rayon_secondaire_invalide_est_refuse() {
    let boule = SphereGeo::new(Vecteur::new(0.0, 0.0, -5.0), 1.0, Texture(0)).unwrap();
    let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0)).unwrap();
    let touche = ObjetGeo::from(boule).vers_ray().intersection(&rayon).unwrap();
    let n = touche.normale;
    let refus = |touche: Intersection, d| rayon.secondaire(&touche, d).unwrap_err().champ;
    let a = |distance: f64| {
        let mut touche = touche;
        touche.distance = distance;
        touche
    };
    for distance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(refus(a(distance), n), "touche.distance");
    }
    assert_eq!(refus(a(1e200), n), "source.z");
    for normale in [Vecteur::NUL, n * 2.0, n * f64::NAN] {
        let mut touche = touche;
        touche.normale = normale;
        assert_eq!(refus(touche, n), "|touche.normale|");
    }
    assert_eq!(refus(touche, Vecteur::NUL), "direction");
    assert_eq!(refus(touche, n * f64::NAN), "direction.x");
}

/// Three objects whose entries are 0, 1, 2 … ulp apart, nested or the same: the one that
/// is answered is the first, or within the two bounds of it.
fn presque_ex_aequo<R: Reel>() {
    for regime in regimes::<R>() {
        let mut juges = 0;
        touches(regime.cas, |cas, _, alea| {
            let objets: Vec<_> = (0..3).map(|i| presque_le_meme(&cas.objet, alea, i)).collect();
            let Ok(premiere) = premiere_intersection(&objets, &cas.rayon) else { return };
            let verites: Vec<_> = objets.iter().map(|o| verite(o, &cas.rayon)).collect();
            let Texture(gagnant) = premiere.texture;
            let Some(gagnant) = &verites[gagnant as usize].entree else { return };
            juges += 1;
            let promis = |e: &Entree| e.cosinus >= promesses::ORDRE_COSINUS * u::<R>();
            if !promis(gagnant) {
                return;
            }
            for autre in verites.iter().filter(|v| !v.dans_la_marge) {
                let Some(autre) = autre.entree.as_ref().filter(|e| promis(e)) else { continue };
                let avance = (&gagnant.t - &autre.t).vers_f64();
                let borne = |e: &Entree| k(&cas.objet) * u::<R>() * e.cond;
                let permis = borne(gagnant) + borne(autre);
                assert!(
                    avance <= permis,
                    "{}: nearer by {avance:e}, {permis:e}: {objets:?} {:?}",
                    regime.nom,
                    cas.rayon
                );
            }
        });
        assert!(juges > cas_par_regime() / 20, "{}: {juges} judged only", regime.nom);
    }
}

/// The object with its number as texture, moved or grown by a few ulp.
fn presque_le_meme<R: Reel>(objet: &ObjetRay<R>, alea: &mut Rng, numero: u32) -> ObjetRay<R> {
    let texture = Texture(numero);
    let mut peu = |x: R| {
        let k = 1.0 + f64::from(alea.i8(-2..=2)) * 2.0 * u::<R>();
        let limite = R::LIMITE.vers_f64();
        R::depuis_f64((x.vers_f64() * k).clamp(-limite, limite))
    };
    let geo: ObjetGeo<R> = match objet {
        ObjetRay::Sphere(s) => {
            let r = peu(s.rayon()).vers_f64().max(R::LIMITE.vers_f64().recip());
            SphereGeo::new(s.centre(), R::depuis_f64(r), texture).unwrap().into()
        }
        ObjetRay::Plan(p) => {
            let [x, y] = deux_axes(p.normale());
            let n = p.normale();
            let m = [x, y, n].map(<[R; 3]>::from);
            let r = Rotation::depuis_matrice(m).unwrap();
            PlanGeo::new(r, peu(p.distance()), texture).unwrap().into()
        }
        ObjetRay::Boite(b) => {
            let r = Rotation::depuis_matrice(b.normales().map(<[R; 3]>::from)).unwrap();
            let c = b.centre();
            let dimensions = b.demi_longueurs().map(|l| {
                let (double, limite) = ((l + l).vers_f64(), R::LIMITE.vers_f64());
                R::depuis_f64(double.clamp(limite.recip(), limite))
            });
            let c = Vecteur::new(peu(c.x), peu(c.y), peu(c.z));
            BoiteGeo::new(c, dimensions.into(), r, texture).unwrap().into()
        }
    };
    geo.vers_ray()
}

/// Two unit vectors that make a right-handed frame with `n`.
fn deux_axes<R: Reel>(n: Vecteur<R>) -> [Vecteur<R>; 2] {
    let n = n.vers_f64();
    let cote =
        if n.x.abs() < 0.6 { Vecteur::new(1.0, 0.0, 0.0) } else { Vecteur::new(0.0, 1.0, 0.0) };
    let x = (cote - n * n.produit_scalaire(cote)).unitaire().unwrap();
    [arrondi(x), arrondi(vectoriel(n, x))]
}

#[test]
fn le_premier_est_le_premier_a_l_arrondi_pres() {
    presque_ex_aequo::<f32>();
    presque_ex_aequo::<f64>();
}

/// Tangents every number of which is exact: (3, 4, 5)·2^k, with r = 5·2^k. They miss; one
/// unit in the last place more of radius is touched, at A.
fn tangentes_exactes<R: Reel>() {
    for k in -20..20 {
        let echelle = f64::from(k).exp2();
        let r = |x: f64| R::depuis_f64(x * echelle);
        let rayon = Rayon::new(
            Vecteur::new(r(3.0), r(4.0), r(64.0)),
            Vecteur::new(R::ZERO, R::ZERO, -R::UN),
        );
        let rayon = rayon.unwrap();
        let boule = |rayon: f64| {
            let centre = Vecteur::new(R::ZERO, R::ZERO, -r(64.0));
            ObjetGeo::from(SphereGeo::new(centre, r(rayon), Texture(0)).unwrap()).vers_ray()
        };
        assert_eq!(boule(5.0).intersection(&rayon), Err(NoIntersection));
        let plus_grande = boule(5.0 * (1.0 + 2.0 * u::<R>()));
        let touche = plus_grande.intersection(&rayon).unwrap();
        let cos = touche.normale.produit_scalaire(rayon.direction()).vers_f64();
        // One unit in the last place of 5 is 1.6u of it, and AB/r = √(2·1.6u).
        assert!(cos < 0.0 && cos >= -2.0 * u::<R>().sqrt());
    }
}

#[test]
fn une_tangente_exacte_manque() {
    tangentes_exactes::<f32>();
    tangentes_exactes::<f64>();
}

/// Half-spaces and rays exactly parallel to them, in each of the ways that zero can be written.
fn paralleles<R: Reel>() {
    let (zero, petit, un) = (R::ZERO, R::PLUS_PETIT, R::UN);
    let sol =
        ObjetGeo::from(PlanGeo::new(Rotation::IDENTITE, zero, Texture(0)).unwrap()).vers_ray();
    let vers = |z: R| {
        let rayon = Rayon::new(Vecteur::new(zero, zero, un), Vecteur::new(un, zero, z)).unwrap();
        sol.intersection(&rayon)
    };
    for z in [zero, -zero, petit] {
        assert_eq!(vers(z), Err(NoIntersection));
    }
    // One unit high, the smallest descent arrives farther than any number of the type.
    assert_eq!(vers(-petit), Err(NoIntersection));
    let pente = R::depuis_f64((-100_f64).exp2());
    assert_eq!(vers(-pente).unwrap().distance, un / pente);
}

#[test]
fn un_rayon_parallele_manque_et_la_moindre_pente_arrive() {
    paralleles::<f32>();
    paralleles::<f64>();
}

/// What remains of N·D for a ray almost parallel to a half-space has all its digits: the distance is
/// as good as the height of the source, three roundings, and the division. In f64 from a descent of
/// 2⁻²⁶ on, where half of the digits are gone.
fn rasants<R: Reel>() {
    let mut alea = Rng::with_seed(8);
    let mut juges = 0;
    for _ in 0..cas_par_regime() {
        let m = Rotation::<R>::new(arrondi(direction(&mut alea) * 3.0)).unwrap();
        let sol = ObjetGeo::from(PlanGeo::new(m, R::ZERO, Texture(0)).unwrap()).vers_ray();
        let [le_long, _, n] = m.matrice().map(|ligne| Vecteur::from(ligne).vers_f64());
        let descente = if alea.bool() {
            (-26_f64).exp2()
        } else {
            (alea.f64() - 1.0).exp2() * u::<R>().sqrt() * 1e-3
        };
        let rayon = Rayon::new(arrondi(n), arrondi(le_long - n * descente)).unwrap();
        // Rounding makes it more than that as often as less.
        let en_f64 = u::<R>() < f64::EPSILON;
        if en_f64 && -n.produit_scalaire(rayon.direction().vers_f64()) > (-26_f64).exp2() {
            continue;
        }
        let (Some(entree), Ok(touche)) = (verite(&sol, &rayon).entree, sol.intersection(&rayon))
        else {
            continue;
        };
        juges += 1;
        let ecart = entree.ecart(touche.distance).abs();
        let permis = 6.0 * u::<R>() * touche.distance.vers_f64();
        assert!(ecart <= permis, "off by {ecart:e}, {permis:e} allowed: {rayon:?}");
    }
    assert!(juges > cas_par_regime() / 4);
}

#[test]
fn un_rayon_rasant_garde_ses_chiffres() {
    rasants::<f32>();
    rasants::<f64>();
}

/// Where no product is subnormal, scaling everything by a power of two changes no bit but the
/// exponent of the distance: over the whole range that a scene can hold.
fn puissances_de_deux<R: Reel>() {
    let bits = R::LIMITE.vers_f64().log2();
    let mut alea = Rng::with_seed(3);
    for _ in 0..cas_par_regime() {
        let (centre, d) = (direction(&mut alea) * 4.0, direction(&mut alea));
        let (rayon, dimensions) = (0.5 + alea.f64(), direction(&mut alea));
        let m = Rotation::new(arrondi(direction(&mut alea) * 3.0)).unwrap();
        let source = centre - d * (3.0 * alea.f64() + 2.0) + direction(&mut alea) * 0.7;
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
            .map(|objet| objet.vers_ray().intersection(&r).map(|t| (t.distance / k, t.normale)))
        };
        let attendu = touche(R::UN);
        for exposant in [-bits + 4.0, -bits / 2.0, -1.0, 7.0, bits - 4.0] {
            assert_eq!(touche(R::depuis_f64(exposant.exp2())), attendu, "2^{exposant}");
        }
    }
}

#[test]
fn une_puissance_de_deux_ne_change_aucun_bit() {
    puissances_de_deux::<f32>();
    puissances_de_deux::<f64>();
}

/// An axis-aligned scene seen in a mirror, or with its axes exchanged, gives the same distance
/// to the bound, and for the mirror to the bit: no sign is privileged.
fn miroirs<R: Reel>() {
    let mut alea = Rng::with_seed(4);
    let mut touches = 0;
    for _ in 0..cas_par_regime() {
        let (c, d) = (direction(&mut alea) * 4.0, direction(&mut alea));
        let s = c - d * 5.0 + direction(&mut alea) * 0.5;
        let (l, r) = ([(); 3].map(|()| 0.5 + alea.f64()), 0.5 + alea.f64());
        let lancer = |transforme: &dyn Fn([f64; 3]) -> [f64; 3]| {
            let v = |v: Vecteur| arrondi::<R>(transforme(v.into()).into());
            let dimensions = transforme(l).map(f64::abs);
            let boite =
                BoiteGeo::new(v(c), arrondi(dimensions.into()), Rotation::IDENTITE, Texture(0));
            let boule = SphereGeo::new(v(c), R::depuis_f64(r), Texture(0)).unwrap();
            let rayon = Rayon::new(v(s), v(d)).unwrap();
            [ObjetGeo::from(boite.unwrap()), boule.into()].map(|objet| {
                let objet = objet.vers_ray();
                let touche = objet.intersection(&rayon).ok();
                let cond = verite(&objet, &rayon).entree.map_or(f64::INFINITY, |e| e.cond);
                touche
                    .map(|t| (t.distance.vers_f64(), <[f64; 3]>::from(t.normale.vers_f64()), cond))
            })
        };
        let direct = lancer(&|v| v);
        let miroir = lancer(&|[x, y, z]| [-x, y, -z]);
        let permute = lancer(&|[x, y, z]| [z, x, y]);
        for ((a, b), c) in direct.into_iter().zip(miroir).zip(permute) {
            assert_eq!(a.is_some(), b.is_some());
            let (Some((t, [x, y, z], cond)), Some((t_m, n_m, _))) = (a, b) else { continue };
            touches += 1;
            assert_eq!((t_m, n_m), (t, [-x, y, -z]));
            if let Some((t_p, ..)) = c {
                // Sums in another order: two errors of K·u·cond, that of a sphere being the larger.
                assert!((t_p - t).abs() <= 2.0 * promesses::DISTANCE_SPHERE * u::<R>() * cond);
            }
        }
    }
    assert!(touches > cas_par_regime() / 2);
}

#[test]
fn ni_signe_ni_axe_n_est_privilegie() {
    miroirs::<f32>();
    miroirs::<f64>();
}

/// Translation by a power of two that rounds nothing away changes no bit.
fn translations_exactes<R: Reel>() {
    let mut alea = Rng::with_seed(5);
    let grille = |alea: &mut Rng, n: i32| R::depuis_f64(f64::from(alea.i32(-n..=n)) / 16.0);
    let mut touches = 0;
    for _ in 0..cas_par_regime() {
        let mut point =
            || Vecteur::new(grille(&mut alea, 64), grille(&mut alea, 64), grille(&mut alea, 64));
        let (c, s, cible) = (point(), point(), point());
        let Ok(rayon) = Rayon::new(s, cible - s) else { continue };
        let v = Vecteur::new(R::depuis_f64(1024.0), R::depuis_f64(-2048.0), R::depuis_f64(512.0));
        let ailleurs = Rayon::new(s + v, rayon.direction()).unwrap();
        let deux = R::UN + R::UN;
        let m = Rotation::new(Vecteur::new(R::UN, deux, -R::UN)).unwrap();
        let objets: [ObjetGeo<R>; 2] = [
            SphereGeo::new(c, deux, Texture(0)).unwrap().into(),
            BoiteGeo::new(c, Vecteur::new(deux, deux, R::UN), m, Texture(0)).unwrap().into(),
        ];
        for objet in objets {
            let valeurs = |t: Intersection<R>| (t.distance, t.normale);
            let ici = objet.vers_ray().intersection(&rayon).map(valeurs);
            let la = objet.translation(v).unwrap().vers_ray().intersection(&ailleurs).map(valeurs);
            assert_eq!(ici, la);
            touches += u32::from(ici.is_ok());
        }
    }
    assert!(touches > cas_par_regime() / 20);
}

#[test]
fn une_translation_exacte_ne_change_aucun_bit() {
    translations_exactes::<f32>();
    translations_exactes::<f64>();
}

/// |R·Rᵀ − I| ≤ 4 units in the last place of 1 after 10^6 compositions, whatever is composed.
fn million_de_rotations<R: Reel>() {
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

#[test]
fn un_million_de_rotations_ne_derive_pas() {
    million_de_rotations::<f32>();
    million_de_rotations::<f64>();
}
