//! Batches: any number of rays, in any order, and what the probe of a block leaves out of a tree.
//!
//! `LANCER_RAYON_CAS` is how many times as long each random test takes:
//! `LANCER_RAYON_CAS=2000 cargo test --release --test memes_bits lot`

use std::collections::HashSet;

use commun::fabrique::{avec_arbre, boite, sphere, v};
use commun::facons::{UN_ARBRE, comparer, comparer_dans, demandes, noeuds};
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::regimes::{Cas, deux_puissance, direction, gerbe, regimes, signe};
use commun::tolerances::u;
use commun::{Bits, arrondi, en_f32_et_f64, scenes};
use lancer_rayon::pour_les_tests::Reglage;
use lancer_rayon::{
    BoiteGeo, Monde, ObjetRay, Rayon, Reel, Rotation, SphereGeo, Texture, Vecteur,
    premiere_intersection,
};

/// Half the angle of a needle, which is far beyond rounding in both types, and small enough for its rays to walk
/// together.
const AIGUILLE: f64 = 1e-5;

fn cas() -> usize {
    commun::cas(50) as usize
}

#[test]
fn chaque_jeu_d_instructions_de_la_machine_est_essaye() {
    let noms: Vec<_> = Reglage::tous().map(|(nom, _)| nom).collect();
    println!("instruction sets tried: {}", noms.join(", "));
    assert!(!noms.is_empty());
    #[cfg(all(feature = "std", any(target_arch = "x86", target_arch = "x86_64")))]
    {
        let avx2 = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
        assert_eq!(avx2, noms.contains(&"AVX2"));
        // The level is that of the Ice Lake generation, of which this feature is the last part.
        let avx512 = is_x86_feature_detected!("avx512vpopcntdq");
        assert_eq!(avx512, noms.contains(&"AVX-512"));
    }
    let uns = Reglage::tous().map(|(_, reglage)| format!("{reglage:?}"));
    assert_eq!(uns.collect::<HashSet<_>>().len(), noms.len(), "two settings are the same");
}

/// From no ray to one more than two blocks of 64, with few objects and with enough for a tree.
fn toute_longueur_convient<R: Bits>() {
    let rayons = scenes::rayons_camera::<R>(20, 10);
    for n in [3, 12, 100, 300] {
        let scene = scenes::melange(n);
        let touches = (0..=129).map(|longueur| comparer(&scene, &rayons[200 - longueur..]));
        assert!(touches.sum::<usize>() > 100, "{n} objects");
    }
}

en_f32_et_f64!(toute_longueur_convient);

/// Pictures in rows, in tiles of 8 × 8 and in no order, with no objects, some or many.
fn l_ordre_des_rayons_ne_change_aucune_reponse<R: Bits>() {
    let (largeur, hauteur) = (96, 16 * commun::cas(1).min(4) as usize);
    let rangees = scenes::rayons_camera::<R>(largeur, hauteur);
    let tuiles = scenes::en_tuiles(&rangees, largeur);
    let mut melanges = rangees.clone();
    Hasard::de_graine(1).melanger(&mut melanges);
    for n in [0, 1, 2, 5, 8, 9, 10, 17, 33, 63, 64, 65, 130, 131, 256, 257, 1_000, 3_000] {
        let scene = scenes::melange(n);
        let touches = [&rangees, &tuiles, &melanges].map(|rayons| comparer(&scene, rayons));
        assert_eq!(touches, [touches[0]; 3]);
        assert!(n == 0 || touches[0] > 100, "{n} objects, {} hits", touches[0]);
    }
}

en_f32_et_f64!(l_ordre_des_rayons_ne_change_aucune_reponse);

/// One ray of a block has its lamp nowhere, wherever that ray stands. The others see what stands before their lamps,
/// near and at infinity.
fn une_lampe_nulle_part_ne_cache_rien_aux_autres<R: Bits>() {
    let rayons = scenes::en_tuiles(&scenes::rayons_camera::<R>(32, 32), 32);
    let scene = scenes::melange::<R>(300);
    let monde = avec_arbre(&scene);
    let mut caches = 0;
    for (i, bloc) in rayons.chunks(64).cycle().enumerate().take(256) {
        for loin in [R::depuis_f64(30.0), R::INFINI] {
            let jusqu_a = |rayon: &Rayon<R>, fin| rayon.jusqu_a(fin).unwrap();
            let mut ombres: Vec<_> = bloc.iter().map(|rayon| jusqu_a(rayon, loin)).collect();
            ombres[i % 64] = jusqu_a(&bloc[i % 64], R::ZERO);
            let liste = Monde::de_liste(&scene);
            let voulues: Vec<_> = ombres.iter().map(|ombre| liste.est_occulte(ombre)).collect();
            caches += voulues.iter().filter(|occulte| **occulte).count();
            for (nom, reglage) in Reglage::tous() {
                for facon in [monde, Monde::de_liste(&scene)] {
                    let mut occultes: Vec<_> = voulues.iter().map(|occulte| !occulte).collect();
                    reglage.monde(facon).sont_occultes(&ombres, &mut occultes).unwrap();
                    assert_eq!(occultes, voulues, "{nom}, ray {}, up to {loin:?}", i % 64);
                }
            }
        }
    }
    assert!(caches > 5_000, "{caches}");
}

en_f32_et_f64!(une_lampe_nulle_part_ne_cache_rien_aux_autres);

/// All rays of a regime of the extremes against all its objects. Then each ray against its own object, alone and with
/// copies that make a tree, twelve times over, since fewer rays do not walk together in a tree. Then needles of rays
/// that walk together around some of them, at objects so large, small or far that squares reach the ends of the type.
fn aux_extremes_un_lot_repond_comme_un_par_un<R: Bits>() {
    let mut d_aiguilles = 0;
    for regime in regimes::<R>() {
        let combien = cas().min(3_000);
        let mut touches = 0;
        let faire = |alea: &mut Hasard| {
            alea.liste(combien, |alea, i| {
                let cas = (regime.cas)(alea);
                let d = cas.rayon.direction().vers_f64();
                let aiguille = alea.liste(if i % 5 == 0 { 64 } else { 0 }, |alea, _| {
                    let vers = d + direction(alea) * AIGUILLE;
                    Rayon::new(cas.rayon.source(), arrondi(vers)).unwrap()
                });
                (cas, aiguille)
            })
        };
        pour_chaque(1, faire, |cas| {
            let objets: Vec<_> = cas.iter().map(|(cas, _)| cas.objet).collect();
            let rayons: Vec<_> = cas.iter().map(|(cas, _)| cas.rayon).collect();
            comparer(&objets, &rayons);
            for (Cas { objet, rayon }, aiguille) in cas {
                let copies = [objet; UN_ARBRE];
                touches += comparer(&[objet], &[rayon; 12]);
                // Many more copies take long: one ray in five has them.
                if aiguille.is_empty() {
                    comparer_dans(&avec_arbre(&copies), &[rayon; 12]);
                } else {
                    comparer(&copies, &[rayon; 12]);
                    d_aiguilles += comparer(&objets[..objets.len().min(20)], &aiguille);
                }
            }
        });
        assert!(touches > 12 * combien / 20, "{}", regime.nom);
    }
    assert!(d_aiguilles > 20 * cas(), "{d_aiguilles}");
}

en_f32_et_f64!(aux_extremes_un_lot_repond_comme_un_par_un);

/// An object whose ball, of radius `l`, is grazed by one of the rays.
///
/// Half of the objects are spheres. The others are cubes with a corner where the ray grazes the ball, since corners are
/// all that a cube shares with its ball.
fn frole<R: Reel>(alea: &mut Hasard, rayons: &[Rayon<R>], texture: Texture) -> ObjetRay<R> {
    let l = deux_puissance(alea, -12.0, 4.0);
    let (centre, vers_le_rayon) = boule_frolee(alea, rayons, l);
    if alea.bool() {
        return SphereGeo::new(centre, R::depuis_f64(l), texture).unwrap().into();
    }
    let cote = R::depuis_f64(2.0 * l / 3.0_f64.sqrt());
    let rotation = coin_vers(alea, vers_le_rayon);
    BoiteGeo::new(centre, Vecteur::new(cote, cote, cote), rotation, texture).unwrap().into()
}

/// The centre of a ball of radius `l` that one of the rays grazes, and the direction from there to the ray.
///
/// The ball lies ahead of the source, or behind it in one case of six, and so far away that as few as two bits of `l`
/// are left in the distance. The ray is any of the block or, as often, the eighth, at the end of the row of a tile.
/// Half of the balls lie in the plane of that row, where the sides are closest to the rays.
fn boule_frolee<R: Reel>(alea: &mut Hasard, rayons: &[Rayon<R>], l: f64) -> (Vecteur<R>, Vecteur) {
    let rayon = &rayons[if alea.bool() { alea.usize(0..rayons.len()) } else { 7 }];
    let (s, d) = (rayon.source().vers_f64(), rayon.direction().vers_f64());
    let bits = -R::U.vers_f64().log2();
    let devant = if alea.u8(0..6) == 0 { -1.0 } else { 1.0 };
    let loin = devant * l * deux_puissance(alea, -4.0, bits - 2.0);
    let en_travers = |v: Vecteur| (v - d * v.produit_scalaire(d)).unitaire();
    let rangee = en_travers((rayon.direction() - rayons[0].direction()).vers_f64());
    let travers = rangee.filter(|_| alea.bool()).or_else(|| en_travers(direction(alea))).unwrap();
    // From the ray to the centre it is l, off by any power of two down to nothing, or by some units in the last place
    // of the distance.
    let ecart = if alea.bool() {
        l * (1.0 + signe(alea) * deux_puissance(alea, -60.0, 0.0))
    } else {
        l + signe(alea) * 8.0 * alea.f64() * R::U.vers_f64() * loin
    };
    (arrondi(s + d * loin + travers * ecart), -travers)
}

/// A random rotation of a cube, followed by a half-turn that takes its corner (1, 1, 1) to `cible`.
fn coin_vers<R: Reel>(alea: &mut Hasard, cible: Vecteur) -> Rotation<R> {
    let rotation = Rotation::<R>::new(arrondi(direction(alea) * 7.0)).unwrap();
    let axes = rotation.matrice().map(|ligne| Vecteur::from(ligne).vers_f64());
    let coin = (axes[0] + axes[1] + axes[2]) / 3.0_f64.sqrt();
    // The half-turn is about the middle of the two corners.
    let Some(milieu) = (coin + cible).unitaire() else { return rotation };
    let demi_tour = |v: Vecteur| milieu * (2.0 * v.produit_scalaire(milieu)) - v;
    let lignes = axes.map(|axe| <[R; 3]>::from(arrondi(demi_tour(axe))));
    Rotation::depuis_matrice(lignes).unwrap_or(rotation)
}

/// Bundles from needles to fans too wide to walk together, from one source or many, with objects that rays at the rim
/// of the bundle graze.
///
/// The ever farther sources in `arbre.rs` would find a probe without its slack. This test has lost no hit by one.
fn la_sonde_ne_perd_aucune_touche<R: Bits>() {
    let faire = |alea: &mut Hasard| {
        let loin = if alea.bool() { 0.0 } else { deux_puissance(alea, -10.0, 16.0) };
        let axe = (direction(alea) * loin, direction(alea));
        let ouverture = deux_puissance(alea, -40.0, 3.0);
        let etendue = if alea.bool() { 0.0 } else { deux_puissance(alea, -40.0, 6.0) };
        let rayons = gerbe::<R>(alea, axe, [ouverture, etendue]);
        (alea.liste(70, |alea, i| frole(alea, &rayons, Texture(i as u32))), rayons)
    };
    let mut touches = 0;
    pour_chaque(cas() as u32, faire, |(objets, rayons)| {
        touches += comparer(&objets, &rayons);
        // The numbers of f32 as f64, in which D and N are unit only to the rounding of f32.
        if u::<R>() > f64::EPSILON {
            let en_f64: Vec<_> = objets.iter().map(|objet| objet.temoin_f64()).collect();
            comparer(&en_f64, &rayons.iter().map(|rayon| rayon.temoin_f64()).collect::<Vec<_>>());
        }
    });
    assert!(touches > 10 * cas(), "only {touches} hits");
}

en_f32_et_f64!(la_sonde_ne_perd_aucune_touche);

/// A cube flush on a slab, and rays into it and past it from one hit of the slab at the foot of the cube, where
/// rounding decides whether the hit is in the cube. Some of them are inside and touch nothing at once.
fn du_pied<R: Reel>(alea: &mut Hasard) -> (Vec<ObjetRay<R>>, Vec<Rayon<R>>) {
    let tour = Rotation::new(arrondi(direction(alea) * 3.0)).unwrap();
    let [x, y, z] = tour.axes().map(|axe| axe.vers_f64());
    let pied = direction(alea) * *alea.choix(&[0.1, 1.0, 10.0]);
    let dalle = boite(arrondi(pied - y), v(8.0, 2.0, 8.0), tour);
    let cube = boite(arrondi(pied + x + y), v(2.0, 2.0, 2.0), tour);
    let vers = arrondi::<R>(x - y * alea.f64() + z * alea.f64());
    let rayon = Rayon::new(arrondi(pied - vers.vers_f64()), vers).unwrap();
    let touche = premiere_intersection(&[dalle], &rayon).unwrap();
    // Half of the time the rays of one group alone touch at once, and the block must see that, whichever group it is.
    let seul = alea.usize(0..8);
    let suites = alea.liste(64, |alea, i| {
        let vers = arrondi(y + x * (0.3 * signe(alea)) + direction(alea) * 0.1);
        let suite = touche.secondaire(vers).unwrap();
        let dedans = alea.u8(0..8) == 0 || (seul < 4 && i / 16 != seul);
        if dedans { suite.dedans() } else { suite }
    });
    // Where nearly all centres coincide, boxes tell nothing apart, and every walk asks the whole list.
    let sous = (1..UN_ARBRE).map(|i| sphere(arrondi(pied - y * (4.0 * i as f64)), R::UN));
    ([dalle, cube].into_iter().chain(sous).collect(), suites)
}

/// To find what is touched at once, one ray in a tree and many at once ask the box that holds the source, as a list
/// does.
fn d_un_pied_un_bloc_touche_d_emblee<R: Bits>() {
    let mut d_emblee = 0;
    pour_chaque(2 * cas() as u32, du_pied::<R>, |(objets, rayons)| {
        comparer_dans(&avec_arbre(&objets), &rayons);
        let touche = |rayon| premiere_intersection(&objets, rayon);
        d_emblee += rayons.iter().flat_map(touche).filter(|t| t.distance() == R::ZERO).count();
    });
    assert!(d_emblee > 20 * cas(), "only {d_emblee}");
}

en_f32_et_f64!(d_un_pied_un_bloc_touche_d_emblee);

/// Whether a block of these shadow rays never asks for this ball. Enough others for a tree lie behind the rays.
fn evite<R: Reel>(ombres: &[Rayon<R>], boule: ObjetRay<R>) -> bool {
    let derriere = |i: usize| {
        let centre = ombres[0].point(R::depuis_f64(-90.0 - 3.0 * i as f64));
        sphere(centre, R::UN)
    };
    let objets: Vec<_> = (1..UN_ARBRE).map(derriere).chain([boule]).collect();
    let monde = avec_arbre(&objets);
    assert!(noeuds(&monde) > 0);
    let mut occultes = vec![false; ombres.len()];
    let en_lot = demandes(&monde, |parmi| parmi.sont_occultes(ombres, &mut occultes).unwrap());
    en_lot[UN_ARBRE - 1] == 0
}

/// No answer shows what a probe leaves out, but counting what is asked does.
fn des_rayons_paralleles_evitent_une_boule_a_cote<R: Reel>() {
    let axes = [Vecteur::<R>::Z, Vecteur::X];
    for k in 0..27_u8 {
        let axe = |i: u8| R::depuis_f64(f64::from(k / i % 3) - 1.0);
        let Some(d) = Vecteur::new(axe(1), axe(3), axe(9)).unitaire() else { continue };
        let autre =
            axes.into_iter().find(|axe| axe.produit_scalaire(d).absolu() < R::depuis_f64(0.9));
        let u = d.produit_vectoriel(autre.unwrap()).unitaire().expect("across D");
        let v = d.produit_vectoriel(u);
        // The corners of a tile.
        let sources = [Vecteur::NUL, u, v, u + v];
        let rayons = sources.map(|source| Rayon::new(source, d).unwrap()).repeat(4);
        for cote in [Vecteur::NUL, u, -u, v, -v, -d] {
            let centre = d * R::depuis_f64(7.0) + cote * R::depuis_f64(10.0);
            let boule = sphere(centre, R::UN);
            let a_cote = cote != Vecteur::NUL;
            assert_eq!(evite(&rayons, boule), a_cote, "along {d:?}, {centre:?}");
        }
    }
}

en_f32_et_f64!(des_rayons_paralleles_evitent_une_boule_a_cote);

/// The same for rays to a lamp. The probe sees that they end, but not that they come together.
fn des_segments_vers_une_lampe_evitent_une_boule_a_cote<R: Reel>() {
    let lampe = v(0.0, 10.0, 0.0);
    let sources = (0..64).map(|i| v(f64::from(i % 8) - 3.5, 0.0, f64::from(i / 8) - 3.5));
    let ombres: Vec<_> = sources.map(|source| Rayon::entre(source, lampe).unwrap()).collect();
    // Beside a corner of the sources, among them, half-way beside and within, beside the lamp by more and by less than
    // the extent of the sources, and beyond the lamp.
    for (centre, a_cote) in [
        ([6.0, 0.5, 6.0], true),
        ([3.0, 0.5, 3.0], false),
        ([9.0, 5.0, 0.0], true),
        ([1.5, 5.0, 0.0], false),
        ([0.0, 9.5, 8.0], true),
        ([0.0, 9.5, 3.0], false),
        ([0.0, 9.5, 0.5], false),
        ([0.0, 14.0, 0.0], true),
        ([0.0, -5.0, 0.0], true),
    ] {
        let boule = sphere(Vecteur::from(centre.map(R::depuis_f64)), R::depuis_f64(0.75));
        assert_eq!(evite(&ombres, boule), a_cote, "{centre:?}");
    }
}

en_f32_et_f64!(des_segments_vers_une_lampe_evitent_une_boule_a_cote);
