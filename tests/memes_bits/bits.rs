//! The same bits everywhere: a hash of the hits and misses of the 240,000 rays of each scene, and of random rays with
//! all that a kernel makes of them, ray by ray, in a batch and in a tree, with each instruction set of the machine.
//!
//! A change of a formula changes a hash, and the failed assertion prints the new one. Before you adopt it, read
//! `docs/precision.md` again; then record it in CHANGELOG.md.

use std::path::Path;

use commun::conversion::mots;
use commun::fabrique::avec_arbre;
use commun::facons::comparer;
use commun::{Bits, arrondi, empreinte};
use exemples::scene::{Lisible, Scene};
use fastrand::Rng;
use lancer_rayon::pour_les_tests::Reglage;
use lancer_rayon::{
    BoiteGeo, Monde, NoIntersection, ObjetRay, PlanGeo, Rayon, Reponse, Rotation, SphereGeo,
    Texture, Vecteur, premiere_intersection,
};

fn empreinte_de<R: Bits>(touches: &[Reponse<R>]) -> u64 {
    // The point is left out, since the distance and the ray determine it.
    let valeurs = |touche| {
        let [d, x, y, z, marge, .., texture] = mots(touche).valeurs;
        [d, x, y, z, marge, texture]
    };
    empreinte(touches.iter().flat_map(valeurs).flat_map(u64::to_le_bytes))
}

/// Checks to the bit that these rays have these answers, and names the first that differs.
#[track_caller]
fn exiger<R: Bits>(
    facon: &str,
    rayons: &[Rayon<R>],
    obtenues: &[Reponse<R>],
    attendues: &[Reponse<R>],
) {
    for ((rayon, obtenue), attendue) in rayons.iter().zip(obtenues).zip(attendues) {
        let de = std::any::type_name::<R>();
        assert_eq!(mots(obtenue), mots(attendue), "{facon}, {de}: {rayon:?}");
    }
}

fn memes_bits<R: Bits + Lisible>(nom: &str, attendue: u64) {
    let scene: Scene<R> = Scene::lire(Path::new(&format!("docs/scenes/{nom}.ron"))).unwrap();
    let objets: Vec<_> = scene.objets.into_iter().map(ObjetRay::from).collect();
    let rayons: Vec<Rayon<R>> = scene.camera.rayons().unwrap();
    let seules: Vec<_> = rayons.iter().map(|r| premiere_intersection(&objets, r)).collect();
    let obtenue = empreinte_de(&seules);
    assert_eq!(obtenue, attendue, "{nom}, {}: {obtenue:#018x}", std::any::type_name::<R>());
    for (jeu, reglage) in Reglage::tous() {
        let mut touches = vec![Err(NoIntersection); rayons.len()];
        let liste = reglage.monde(Monde::de_liste(&objets));
        liste.premieres_intersections(&rayons, &mut touches).unwrap();
        exiger(&format!("{nom}, {jeu}"), &rayons, &touches, &seules);
    }
    let monde = avec_arbre(&objets);
    let touches: Vec<_> = rayons.iter().map(|r| monde.premiere_intersection(r)).collect();
    exiger(&format!("{nom}, tree"), &rayons, &touches, &seules);
}

/// Scenes and rays made only from sums, products and quotients of random numbers, which are the same on every machine;
/// with the secondary rays, the shadows and the errors of what the rays hit.
fn au_hasard<R: Bits>(attendue: u64) {
    let mut alea = Rng::with_seed(18);
    let mut touches = Vec::new();
    for n in [1, 5, 9, 40, 300] {
        for echelle in [1e-6, 1.0, 1e6] {
            let mut point = |l: f64| {
                let [x, y, z] = [(); 3].map(|()| (alea.f64() - 0.5) * l * echelle);
                arrondi::<R>(Vecteur::new(x, y, z))
            };
            let objets: Vec<ObjetRay<R>> = (0..n)
                .map(|i| {
                    let (centre, v) = (point(16.0), point(4.0));
                    let angles = v * R::depuis_f64(1.0 / echelle);
                    let (tour, texture) = (Rotation::new(angles).unwrap(), Texture(i));
                    match i % 9 {
                        8 => PlanGeo::new(tour, centre.x.absolu(), texture).unwrap().into(),
                        0 | 2 | 4 => SphereGeo::new(centre, v.longueur(), texture).unwrap().into(),
                        _ => {
                            let dimensions = [v.x.absolu(), v.y.absolu(), v.longueur()].into();
                            BoiteGeo::new(centre, dimensions, tour, texture).unwrap().into()
                        }
                    }
                })
                .collect();
            let rayons: Vec<Rayon<R>> = (0..1_000)
                .map(|_| (point(64.0), point(16.0)))
                .map(|(de, vers)| Rayon::new(de, vers - de).unwrap())
                .collect();
            let premiers: Vec<_> =
                rayons.iter().map(|r| premiere_intersection(&objets, r)).collect();
            comparer(&objets, &rayons);
            let suite = |(rayon, touche): (&Rayon<R>, &Reponse<R>)| {
                let touche = touche.ok()?;
                let secondaire = touche.secondaire(rayon.source()).ok()?;
                let ombre = touche.vers_lumiere(secondaire.source() * R::U).ok()?;
                let occulte = Monde::de_liste(&objets).est_occulte(&ombre);
                let ombre = ombre.jusqu_a(if occulte { R::INFINI } else { R::ZERO }).unwrap();
                Some([secondaire, ombre].map(|rayon| premiere_intersection(&objets, &rayon)))
            };
            touches.extend(rayons.iter().zip(&premiers).filter_map(suite).flatten());
            touches.extend(premiers.iter().copied());
        }
    }
    let (obtenue, hits) = (empreinte_de(&touches), touches.iter().flatten().count());
    assert!(hits > 10_000, "only {hits} hits");
    assert_eq!(obtenue, attendue, "{}: {obtenue:#018x}", std::any::type_name::<R>());
}

/// A test in each type, with the fingerprint of its answers.
macro_rules! empreintes {
    ($($nom:ident: $question:ident($($scene:literal)?), $en_f32:literal, $en_f64:literal;)*) => {$(
        mod $nom {
            #[test]
            fn f32() {
                super::$question::<f32>($($scene,)? $en_f32);
            }

            #[test]
            fn f64() {
                super::$question::<f64>($($scene,)? $en_f64);
            }
        }
    )*};
}

empreintes! {
    l_atelier_garde_ses_bits: memes_bits("atelier"), 0xd6c4_f65f_9759_d4d1, 0xd649_a018_fcb1_a80f;
    la_foule_garde_ses_bits: memes_bits("foule"), 0xd16a_0994_1539_1f3d, 0x33d3_315a_e3b3_5b3c;
    les_extremes_gardent_leurs_bits: memes_bits("extremes"), 0x92e6_b8f7_e481_9bf4, 0x3c29_77be_5589_1f89;
    le_flocon_garde_ses_bits: memes_bits("flocon"), 0x0c98_8132_db38_33da, 0x3bc4_4b6d_7d6c_f757;
    des_rayons_au_hasard_gardent_leurs_bits: au_hasard(), 0x7689_72fb_186e_249f, 0xe39b_159c_729d_7ad6;
}
