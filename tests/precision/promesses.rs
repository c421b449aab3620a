//! The promises of `docs/precision.md`, in the order of its table, against the oracle at the extremes.
//!
//! `LANCER_RAYON_CAS` is how many thousand cases each regime runs (1 unless set):
//! `LANCER_RAYON_CAS=1000 cargo test --release --all-features --test precision promesses`

use commun::fabrique::{boite_droite, sphere, v};
use commun::hasard::Tirage;
use commun::mesure::{absolu, au_bord, quantiles};
use commun::oracle::{Entree, Passage, hauteur, verite, verite_du};
use commun::promesses::{
    Essai, Part, Promesse, RIEN, de_la_sortie, marge_infinie, reflechi, refracte, secondaire,
    soleil, toutes,
};
use commun::regimes::{
    Cas, Extreme, Genre, deux_puissance, direction, entre, miroir, miroir_sous, regimes, repere,
    signe, vers_la_sortie,
};
use commun::tolerances::{ORTHONORMALE, u};
use commun::{arrondi, en_f32_et_f64};
use fastrand::Rng;
use lancer_rayon::pour_les_tests::TANGENT;
use lancer_rayon::{
    BoiteGeo, Intersection, NoIntersection, Nombre, ObjetGeo, ObjetRay, PlanGeo, Rayon, Reel,
    Rotation, SphereGeo, Texture, Vecteur, premiere_intersection,
};

fn cas_par_regime() -> u32 {
    commun::cas(1_000)
}

/// The hits of a regime, and the randomness for what follows them.
fn chaque_touche<R: Reel>(
    cas: fn(&mut dyn Tirage) -> Cas<R>,
    mut suite: impl FnMut(&Cas<R>, &Intersection<R>, &mut Rng),
) {
    let mut alea = Rng::with_seed(2);
    for _ in 0..cas_par_regime() {
        let cas = cas(&mut alea);
        if let Ok(touche) = cas.objet.intersection(&cas.rayon) {
            let cosinus = touche.normale().produit_scalaire(cas.rayon.direction());
            assert!(touche.distance() > R::ZERO && cosinus < R::ZERO, "{cas:?} {touche:?}");
            suite(&cas, &touche, &mut alea);
        }
    }
}

/// Each promise of the table in each regime of its shapes; and how loose those are that a program may ask.
fn chaque_promesse_tient<R: Reel>() {
    for regime in regimes::<R>() {
        let de_l_entree = toutes::<R>().into_iter().map(|promesse| (promesse, false));
        let de_la_sortie = de_la_sortie::<R>().into_iter().map(|promesse| (promesse, true));
        let siennes = de_l_entree.chain(de_la_sortie);
        for (Promesse { nom, part, aisance, genres }, sort) in siennes {
            if !genres.contains(&regime.genre) {
                continue;
            }
            let nom = format!("{nom}: {}", regime.nom);
            let (mut alea, mut jugees, mut aisances) = (Rng::with_seed(1), 0, Vec::new());
            for _ in 0..cas_par_regime() {
                let cas = (regime.cas)(&mut alea);
                let Cas { objet, rayon } = if sort { vers_la_sortie(cas, &mut alea) } else { cas };
                let [x, y, z] = arrondi(direction(&mut alea)).into();
                let essai = Essai { objets: vec![objet], rayon, vers: [x, y, z, R::ZERO, R::ZERO] };
                let part = part(&essai);
                assert!(part <= 1.0, "{nom}: {part} of what is promised, {essai:?}");
                jugees += u32::from(part > RIEN);
                aisances.extend((part > 0.0).then(|| 1.0 / part));
            }
            let [mediane, ..] = quantiles(&mut aisances);
            let permise = aisance[usize::from(regime.extreme != Extreme::Aucun)];
            assert!(
                mediane.is_nan() || mediane <= permise,
                "{nom}: {mediane} times as much in the median"
            );
            // Some regimes have no spheres nearly lost in their distance.
            let rare = std::ptr::fn_addr_eq(part, marge_infinie as Part<R>);
            assert!(rare || jugees > cas_par_regime() / 100, "{nom}: {jugees} judged only");
        }
    }
}

en_f32_et_f64!(chaque_promesse_tient);

/// Where a way out is promised to be off by less than a quarter of its distance, `erreur` is a number: of thin plates,
/// beside edges and where the ray grazes.
fn l_erreur_d_une_sortie_est_un_nombre<R: Reel>() {
    for regime in regimes::<R>() {
        // There products leave the normal numbers of `f64`.
        if regime.extreme == Extreme::Bornes {
            continue;
        }
        let (mut alea, mut jugees) = (Rng::with_seed(3), 0);
        for _ in 0..cas_par_regime() {
            let cas = vers_la_sortie((regime.cas)(&mut alea), &mut alea);
            let Ok(sortie) = cas.objet.sortie(&cas.rayon) else { continue };
            let verite = verite_du(Passage::Sortie, &cas.objet, &cas.rayon);
            let Some(entree) = verite.entree.filter(|_| !verite.dans_la_marge) else { continue };
            let permis = entree.k * u::<R>() * entree.kappa_t + absolu(&cas.objet, &entree);
            if permis < 0.25 * entree.t.vers_f64() {
                let erreur = cas.objet.erreur(&cas.rayon, &sortie);
                assert!(erreur < R::INFINI, "{}: {cas:?} {sortie:?}", regime.nom);
                jugees += 1;
            }
        }
        assert!(jugees > cas_par_regime() / 100, "{}: {jugees} judged only", regime.nom);
    }
}

en_f32_et_f64!(l_erreur_d_une_sortie_est_un_nombre);

/// Mirrors and suns where the bounds are nearly reached: a normal and directions that are kept though their lengths
/// are off by almost all that is allowed, at the angle that is worst.
fn un_reflet_et_un_cosinus_atteignent_presque_leur_borne<R: Reel>() {
    let u = u::<R>();
    let mut alea = Rng::with_seed(8);
    let (mut reflet, mut cosinus) = (0.0_f64, 0.0_f64);
    for _ in 0..20 * cas_par_regime() {
        let Cas { objet, rayon } = miroir(&mut alea);
        let n = rayon.source().vers_f64();
        let [x, y, z] = arrondi(n * (1.0 + 5.0 * u)).into();
        let essai = Essai { objets: vec![objet], rayon, vers: [x, y, z, R::ZERO, R::ZERO] };
        let parts = [reflechi(&essai), soleil(&essai)];
        assert!(parts.iter().all(|part| *part <= 1.0), "{parts:?} {essai:?}");
        (reflet, cosinus) = (reflet.max(parts[0]), cosinus.max(parts[1]));
    }
    assert!(reflet > 0.5 && cosinus > 0.6, "{reflet} {cosinus}");
}

en_f32_et_f64!(un_reflet_et_un_cosinus_atteignent_presque_leur_borne);

/// Light that enters and leaves glass of every index, in every regime and where the numbers are worst: as Snell's law
/// says, and mirrored where that is exact, outside the band of the decision. Of light that grazes behind the surface the
/// bound is nearly reached.
fn une_refraction_est_celle_de_snell<R: Reel>() {
    let mut alea = Rng::with_seed(9);
    let (mut pire, mut jugees) = (0.0_f64, 0);
    let mut juger = |Cas { objet, rayon }: Cas<R>, alea: &mut Rng| {
        let Ok(touche) = objet.intersection(&rayon).or_else(|_| objet.sortie(&rayon)) else {
            return;
        };
        let (n, d) = (touche.normale().vers_f64(), rayon.direction().vers_f64());
        let limite = 1.0 / n.produit_vectoriel(d).longueur();
        let peu = 1.0 + deux_puissance(alea, -54.0, -4.0) * signe(alea);
        for rapport in [limite * peu, limite * alea.f64(), entre(alea, 0.3, 3.0)] {
            let vers = [R::depuis_f64(rapport), R::ZERO, R::ZERO, R::ZERO, R::ZERO];
            let essai = Essai { objets: vec![objet], rayon, vers };
            let part = refracte(&essai);
            assert!(part <= 1.0, "{part} {essai:?}");
            (pire, jugees) = (pire.max(part), jugees + u32::from(part > RIEN));
        }
    };
    for regime in regimes::<R>() {
        for _ in 0..cas_par_regime() {
            let cas = (regime.cas)(&mut alea);
            juger(cas, &mut alea);
            juger(vers_la_sortie(cas, &mut alea), &mut alea);
        }
    }
    for _ in 0..20 * cas_par_regime() {
        let sinus = deux_puissance(&mut alea, -9.0, -0.1);
        juger(miroir_sous(sinus, &mut alea), &mut alea);
    }
    println!("{jugees} judged, {pire} of the bound");
    assert!(jugees > 60 * cas_par_regime() && pire > 0.4, "{jugees} {pire}");
}

en_f32_et_f64!(une_refraction_est_celle_de_snell);

/// What `docs/preuves.md` grants the numbers of an `f32` scene in `f64`, which are unit to the rounding of `f32` only:
/// all except what rests on the length of the normal of a flat face.
#[test]
fn les_promesses_tiennent_de_nombres_elargis() {
    let refusees = ["length of the normal", "margin", "secondary ray"];
    for regime in regimes::<f32>() {
        let de_l_entree = toutes::<f64>().map(|promesse| (promesse, false));
        let de_la_sortie = de_la_sortie::<f64>().map(|promesse| (promesse, true));
        let plate = regime.genre != Genre::Sphere;
        let siennes: Vec<_> = de_l_entree
            .into_iter()
            .chain(de_la_sortie)
            .filter(|(Promesse { nom, genres, .. }, _)| {
                let refusee = refusees.contains(&nom.trim_start_matches("way out: "));
                genres.contains(&regime.genre) && !(plate && refusee)
            })
            .collect();
        let mut alea = Rng::with_seed(5);
        for _ in 0..cas_par_regime() {
            let cas = (regime.cas)(&mut alea);
            let sort = vers_la_sortie(cas, &mut alea);
            let [x, y, z] = direction(&mut alea).into();
            let essais = [cas, sort].map(|Cas { objet, rayon }| {
                let (objets, rayon) = (vec![objet.temoin_f64()], rayon.temoin_f64());
                Essai { objets, rayon, vers: [x, y, z, 0.0, 0.0] }
            });
            for (Promesse { nom, part, .. }, sort) in &siennes {
                let essai = &essais[usize::from(*sort)];
                let part = part(essai);
                assert!(part <= 1.0, "{nom}: {}: {part} of it, {essai:?}", regime.nom);
            }
        }
    }
}

/// Tangents every number of which is exact: (3, 4, 5)·2^k, with r = 5·2^k. They miss; one
/// unit in the last place more of radius is touched, at A.
fn une_tangente_exacte_manque<R: Reel>() {
    for k in -20..20 {
        let echelle = f64::from(k).exp2();
        let r = |x: f64| R::depuis_f64(x * echelle);
        let rayon = Rayon::new(
            Vecteur::new(r(3.0), r(4.0), r(64.0)),
            Vecteur::new(R::ZERO, R::ZERO, -R::UN),
        );
        let rayon = rayon.unwrap();
        let boule = |rayon: f64| sphere(Vecteur::Z * -r(64.0), r(rayon));
        assert_eq!(boule(5.0).intersection(&rayon), Err(NoIntersection));
        let plus_grande = boule(5.0 * (1.0 + 2.0 * u::<R>()));
        let touche = plus_grande.intersection(&rayon).unwrap();
        let cos = touche.normale().produit_scalaire(rayon.direction()).vers_f64();
        // One unit in the last place of 5 is 1.6u of it, and AB/r = √(2·1.6u).
        assert!(cos < 0.0 && cos >= -2.0 * u::<R>().sqrt());
    }
}

en_f32_et_f64!(une_tangente_exacte_manque);

/// Half-spaces and rays exactly parallel to them, in each of the ways that zero can be written.
fn un_rayon_parallele_manque_et_la_moindre_pente_arrive<R: Reel>() {
    let (zero, petit, un) = (R::ZERO, R::MIN_POSITIF, R::UN);
    let sol = ObjetRay::from(PlanGeo::new(Rotation::IDENTITE, zero, Texture(0)).unwrap());
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
    assert_eq!(vers(-pente).unwrap().distance(), un / pente);
}

en_f32_et_f64!(un_rayon_parallele_manque_et_la_moindre_pente_arrive);

/// Three objects whose entries are 0, 1, 2 … ulp apart, nested or the same: the one that
/// is answered is the first, or within the two bounds of it.
fn le_premier_est_le_premier_a_l_arrondi_pres<R: Reel>() {
    for regime in regimes::<R>() {
        let mut juges = 0;
        chaque_touche(regime.cas, |cas, _, alea| {
            let objets: Vec<_> = (0..3).map(|i| presque_le_meme(&cas.objet, alea, i)).collect();
            let Ok(premiere) = premiere_intersection(&objets, &cas.rayon) else { return };
            let verites: Vec<_> = objets.iter().map(|o| verite(o, &cas.rayon)).collect();
            let Texture(gagnant) = premiere.texture();
            let Some(gagnant) = &verites[gagnant as usize].entree else { return };
            juges += 1;
            for autre in verites.iter().filter(|v| !v.dans_la_marge) {
                let Some(autre) = &autre.entree else { continue };
                let avance = (&gagnant.t - &autre.t).vers_f64();
                let objet = &cas.objet;
                let borne = |e: &Entree| e.k * u::<R>() * e.kappa_t + absolu(objet, e);
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

en_f32_et_f64!(le_premier_est_le_premier_a_l_arrondi_pres);

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
            let m = repere(p.normale());
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
    assert_eq!(rayon.point(touche.distance()).x, f32::INFINITY);
    assert_eq!(touche.marge(), f32::INFINITY);
    assert_eq!(touche.secondaire(touche.normale()).unwrap_err().champ, "marge");
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

/// The promise of secondary rays once more, in the directions that it is hardest in.
fn un_rayon_secondaire_ne_retouche_pas_l_objet_qu_il_quitte<R: Reel>() {
    let mut lances = 0_u64;
    // With what misses, enough for 10^6 rays from the 1 000 cases that are the default.
    let fois = 24;
    for regime in regimes::<R>() {
        let mut refus = 0_u64;
        chaque_touche(regime.cas, |cas, touche, alea| {
            let vers = [R::ZERO; 5];
            let mut essai = Essai { objets: vec![cas.objet], rayon: cas.rayon, vers };
            for _ in 0..fois {
                for vers in directions_secondaires(touche.normale().vers_f64(), alea) {
                    let [x, y, z] = arrondi(vers).into();
                    essai.vers = [x, y, z, R::ZERO, R::ZERO];
                    let part = secondaire(&essai);
                    assert!(part <= 1.0, "{}: {essai:?} {touche:?}", regime.nom);
                    lances += u64::from(part > RIEN);
                    refus += u64::from(part == RIEN);
                }
            }
        });
        // Refused only where the point, or the bound, is beyond the range of a source, or the sphere is lost.
        let refuse = match regime.extreme {
            Extreme::Bornes | Extreme::Parallele => true,
            Extreme::Loin => regime.genre == Genre::Sphere,
            Extreme::Aucun | Extreme::Decision => false,
        };
        assert!(refus == 0 || refuse, "{}: {refus} refused", regime.nom);
    }
    println!("{lances} secondary rays");
    assert!(lances >= 1_000 * u64::from(cas_par_regime()), "{lances} rays only");
}

en_f32_et_f64!(un_rayon_secondaire_ne_retouche_pas_l_objet_qu_il_quitte);

/// From afar a hit beside an edge is off by much along the ray, of which the margin over its face
/// knows nothing: an inward ray may start above another face by a thousand times 2(`marge()` + 4u|P|), which
/// one might expect, though by no more than lemma 6 grants.
fn un_depart_vers_l_interieur_peut_etre_loin_au_dessus_d_une_autre_face<R: Reel>() {
    let centre = v(-0.0077286684, 0.018294489, 0.19977821);
    let dimensions = v(1.0, 2.0 * 0.57481515, 2.0 * 0.7004555);
    let boite: ObjetRay<R> = boite_droite(centre, dimensions);
    let encore = |rayon: &Rayon<R>, vers| {
        let touche = boite.intersection(rayon).ok()?;
        let dedans = touche.secondaire(vers).ok()?;
        let encore = boite.intersection(&dedans).ok()?;
        assert!(au_bord(&boite, rayon, &touche, dedans.source(), &encore), "{rayon:?} {dedans:?}");
        let p = rayon.point(touche.distance()).vers_f64().longueur();
        let attendu = 2.0 * (touche.marge().vers_f64() + 4.0 * u::<R>() * p);
        Some(hauteur(&boite, encore.normale(), dedans.source()) / attendu)
    };
    if u::<R>() > f64::EPSILON {
        let d = v(0.0039478806, -0.99913543, -0.041385863);
        let rayon = Rayon::new(v(-58.45057, 14664.854, 606.94366), d).unwrap();
        assert!(encore(&rayon, v(0.20613794, -0.8412872, -0.4997429)).is_some_and(|h| h > 1_480.0));
    }
    // At the edge that the faces −x and +y share.
    let mut alea = Rng::with_seed(21);
    let mut pire = 0.0_f64;
    for _ in 0..20 * cas_par_regime() {
        let bord = centre.vers_f64() + Vecteur::new(-0.5, 0.57481515, alea.f64() - 0.5);
        let d = Vecteur::new(0.01 * alea.f64(), -1.0, 0.1 * alea.f64());
        let Ok(rayon) = Rayon::new(arrondi(bord - d * 1.5e4), arrondi(d)) else { continue };
        if let Some(h) = encore(&rayon, v(0.2, -0.8, -0.5)) {
            pire = pire.max(h);
        }
    }
    assert!(pire > 1_000.0, "{pire}");
}

en_f32_et_f64!(un_depart_vers_l_interieur_peut_etre_loin_au_dessus_d_une_autre_face);

/// Far from O a plate may be no thicker than the step: of rays sent inward, amid its face, some start beyond it and never
/// leave. Of a cube each leaves; of a half-space none does.
#[test]
fn ce_qui_est_plus_mince_que_le_pas_n_a_pas_de_sortie() {
    let r = Rotation::new(Vecteur::new(0.3_f32, 0.4, 0.0)).unwrap();
    let centre = Vecteur::new(0.0, 0.0, -3_000.0);
    let boite = |epaisseur| {
        ObjetRay::from(
            BoiteGeo::new(centre, Vecteur::new(2.0, 2.0, epaisseur), r, Texture(0)).unwrap(),
        )
    };
    let mur = PlanGeo::new(r, 3_000.0, Texture(0)).unwrap();
    let n = Vecteur::from(r.matrice()[2]);
    let mut alea = Rng::with_seed(22);
    let [mut dans_la_plaque, mut dans_le_cube, mut dans_le_mur, mut lances] = [0; 4];
    for _ in 0..cas_par_regime() {
        let vers = arrondi(centre.vers_f64() + direction(&mut alea) * 0.25);
        let rayon = Rayon::new(Vecteur::NUL, vers).unwrap();
        let mut sort = |objet: ObjetRay<f32>| {
            let Ok(touche) = objet.intersection(&rayon) else { return 0 };
            assert!(touche.normale() == n);
            let dedans = touche.secondaire(rayon.direction()).unwrap();
            lances += 1;
            u32::from(objet.sortie(&dedans).is_ok())
        };
        dans_la_plaque += sort(boite(0.0002));
        dans_le_cube += sort(boite(2.0));
        dans_le_mur += sort(mur.into());
    }
    assert!(lances == 3 * cas_par_regime() && dans_le_cube == cas_par_regime());
    assert!(dans_le_mur == 0 && dans_la_plaque < cas_par_regime(), "{dans_la_plaque}");
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
}

/// A direction at the limit itself, 3.2u, is tangent: its ray starts outside and leaves, and a light there has none.
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
