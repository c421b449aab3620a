//! The tree gives every bit of what the list answers, ray by ray, in a batch and for shadows, with every instruction
//! set of the machine.
//!
//! `LANCER_RAYON_CAS` is how many times as long each random test takes.

use std::f64::consts::FRAC_PI_2;

use commun::conversion::{mots, voisin};
use commun::fabrique::{avec_arbre, boite_droite, mur, sphere, v};
use commun::facons::{UN_ARBRE, comparer, comparer_dans, noeuds};
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::regimes::{deux_puissance, direction, entre, gerbe, signe};
use commun::{Bits, arrondi, en_f32_et_f64, scenes};
use lancer_rayon::pour_les_tests::{JEU_F32, JEU_LARGEUR, Reglage, groupes_au_bout};
use lancer_rayon::{
    BoiteGeo, Face, LongueursDifferentes, Monde, NoIntersection, Nombre, ObjetRay,
    PlacesInsuffisantes, PlanGeo, Rayon, Reel, Rotation, SphereGeo, Texture, Vecteur, places,
    premiere_intersection,
};

// Threads share a world.
const _: () = {
    const fn partage<T: Copy + Send + Sync>() {}
    partage::<Monde<'_, f32>>();
    partage::<Monde<'_, f64>>();
};

fn cas() -> usize {
    commun::cas(15) as usize
}

/// A sphere or box of this size here.
fn objet<R: Reel>(alea: &mut Hasard, centre: Vecteur, taille: f64, i: usize) -> ObjetRay<R> {
    let texture = Texture(i as u32);
    // A smaller word draws the simpler object.
    if !alea.bool() {
        return SphereGeo::new(arrondi(centre), R::depuis_f64(taille), texture).unwrap().into();
    }
    let angles = if alea.bool() {
        [(); 3].map(|()| entre(alea, -4.0, 4.0))
    } else {
        [(); 3].map(|()| f64::from(alea.i8(-2..=2)) * FRAC_PI_2)
    };
    let dimensions = [(); 3].map(|()| taille * deux_puissance(alea, -3.0, 1.0));
    let rotation = Rotation::new(arrondi(angles.into())).unwrap();
    BoiteGeo::new(arrondi(centre), arrondi(dimensions.into()), rotation, texture).unwrap().into()
}

/// Objects and rays.
type Scene<R> = (Vec<ObjetRay<R>>, Vec<Rayon<R>>);

/// In `combien` scenes a tree answers as the list does; returns how many rays hit something.
#[track_caller]
fn comme_la_liste<R: Bits>(combien: usize, faire: impl Fn(&mut Hasard) -> Scene<R>) -> usize {
    let mut touches = 0;
    pour_chaque(combien as u32, faire, |(objets, rayons)| touches += comparer(&objets, &rayons));
    touches
}

/// A half-space whose d is `distance`.
fn sol<R: Reel>(alea: &mut Hasard, distance: f64) -> ObjetRay<R> {
    let rotation = Rotation::new(arrondi(direction(alea) * 7.0)).unwrap();
    PlanGeo::new(rotation, R::depuis_f64(distance), Texture(9)).unwrap().into()
}

/// Three blocks of rays at these objects, from needles to everywhere.
fn gerbes<R: Reel>(alea: &mut Hasard, objets: &[ObjetRay<R>], l: f64) -> Vec<Rayon<R>> {
    let gerbes = [(); 3].map(|()| {
        let cible = match alea.choix(objets) {
            ObjetRay::Sphere(sphere) => sphere.centre().vers_f64(),
            ObjetRay::Boite(boite) => boite.centre().vers_f64(),
            ObjetRay::Plan(_) => Vecteur::NUL,
        };
        let vers = direction(alea);
        let de = cible - vers * (l * deux_puissance(alea, -6.0, 6.0));
        let ecarts = [1.0, l].map(|l| l * deux_puissance(alea, -30.0, 2.0));
        gerbe(alea, (de, vers), ecarts)
    });
    gerbes.concat()
}

/// Objects of one size or of many, near or far, in a cloud, on a plane, in a line or all about one point; some of them
/// twice, and some half-spaces.
fn un_arbre_d_objets_au_hasard_repond_comme_la_liste<R: Bits>() {
    let touches = comme_la_liste::<R>(cas(), |alea| {
        let n = [UN_ARBRE, 20, 40, 70, 100, 200, 400, 900][alea.tour % 8] + alea.usize(0..9);
        let (l, loin) = (deux_puissance(alea, -8.0, 8.0), deux_puissance(alea, -6.0, 12.0));
        let lieu = if alea.bool() { Vecteur::NUL } else { direction(alea) * (l * loin) };
        let etendue = l * deux_puissance(alea, -2.0, 6.0);
        let aplati = [(); 3].map(|()| if alea.u8(0..3) == 0 { 0.0 } else { 1.0 });
        let minces = alea.bool();
        let mut objets = alea.liste(n, |alea, i| {
            let [x, y, z]: [f64; 3] = (direction(alea) * (etendue * alea.f64())).into();
            let ou = lieu + Vecteur::new(x * aplati[0], y * aplati[1], z * aplati[2]);
            let taille = if minces { l } else { l * deux_puissance(alea, -12.0, 2.0) };
            match alea.u8(0..40) {
                0 => sol(alea, lieu.longueur() + etendue),
                _ => objet(alea, ou, taille, i),
            }
        });
        for _ in 0..objets.len() / 8 {
            let i = alea.usize(0..objets.len());
            objets[i] = *alea.choix(&objets);
        }
        let rayons = gerbes(alea, &objets, l);
        (objets, rayons)
    });
    assert!(touches > 20 * cas(), "only {touches} hits");
}

/// Boxes and spheres side by side over partly filled nodes, and rays along axes and diagonals: in faces, through edges
/// and beside them, with components that are ±0 or subnormal.
fn le_long_des_axes_un_arbre_repond_comme_la_liste<R: Bits>() {
    for (n, decalage) in [(2, 0.0), (3, 0.3), (4, 100.3), (5, -7.7), (7, 0.1)] {
        let touches = comme_la_liste::<R>(1, |alea| {
            let objets = alea.liste(n * n * n, |alea, i| {
                let [x, y, z] = [i % n, i / n % n, i / n / n].map(|k| k as f64 + decalage);
                let ou = v(x, y, z);
                if alea.bool() {
                    sphere(ou, R::depuis_f64(0.5))
                } else {
                    boite_droite(ou, v(1.0, 1.0, 1.0))
                }
            });
            let rayons = alea.liste(cas(), |alea, _| {
                let axe = alea.usize(0..3);
                let sens = signe(alea);
                let pres = *alea.choix(&[-0.0, 0.0, 1e-320, -1e-40, 1e-20, -1e-7]);
                let demi = f64::from(alea.u8(0..2)) / 2.0;
                let deux = alea.liste(64, |alea, k| {
                    let [a, b] = [k % 8, k / 8].map(|i| i as f64 * 0.5 + demi - 1.0 + decalage);
                    let depart = decalage - sens * 3.0 * n as f64;
                    let (mut s, mut d) = ([a, b, a], [pres, -pres, pres]);
                    (s[axe], d[axe]) = (depart, sens);
                    (s[(axe + 1) % 3], s[(axe + 2) % 3]) = (a, b);
                    let s = arrondi(s.into());
                    [d, [(); 3].map(|()| signe(alea))]
                        .map(|d| Rayon::new(s, arrondi(d.into())).unwrap())
                });
                deux.concat()
            });
            (objets, rayons.concat())
        });
        assert!(touches > 128 * cas() / 20, "{n}: only {touches} hits");
    }
}

/// At a tie the first of the list is hit, wherever it stands in the tree.
fn parmi_des_objets_egaux_le_premier_de_la_liste_est_touche<R: Bits>() {
    let rayons = scenes::en_tuiles(&scenes::rayons_camera::<R>(16, 16), 16);
    for n in [UN_ARBRE, 100, 300, 5_000] {
        let mut objets = scenes::melange::<R>(40)[1..6].repeat(n / 5 + 1);
        objets.truncate(n);
        Hasard::de_graine(4).melanger(&mut objets);
        assert!(comparer(&objets, &rayons) > 20);
    }
    // A ray enters every box of the tree, so that as many nodes wait as ever can, in the small pile and in the large
    // one.
    let objet = sphere(v(0.0, 1.0, -4.0), R::UN);
    for n in [61_440, 100_000] {
        let objets = vec![objet; n];
        let monde = avec_arbre(&objets);
        let mut touches = vec![Err(NoIntersection); 256];
        monde.premieres_intersections(&rayons, &mut touches).unwrap();
        for (rayon, touche) in rayons.iter().zip(&touches) {
            assert_eq!(mots(touche), mots(&objet.intersection(rayon)));
            assert_eq!(mots(&monde.premiere_intersection(rayon)), mots(touche));
        }
        assert!(touches.iter().flatten().count() > 5);
    }
}

/// How many groups of sixteen of these rays come to the end of a tree together.
fn combien_vont_au_bout<R: Bits>(monde: &Monde<'_, R>, rayons: &[Rayon<R>]) -> usize {
    rayons.chunks(64).map(|bloc| groupes_au_bout(monde, bloc)).sum()
}

/// A tree with enough nodes for a walk to need the large pile: a tile that is a whole picture, whose common walk is
/// given up, and a tile of a larger picture, which walks to the end.
fn un_tres_grand_arbre_repond_comme_la_liste<R: Bits>() {
    let objets = scenes::melange::<R>(70_000);
    let mut places = vec![0.0; places(70_000)];
    let monde = Monde::new(&objets, &mut places).unwrap();
    assert!(noeuds(&monde) >= 4_096);
    for cote in [8, 256] {
        let rayons = scenes::en_tuiles(&scenes::rayons_camera::<R>(cote, cote), cote);
        let bloc = &rayons[rayons.len() / 128 * 64..][..64];
        assert_eq!(groupes_au_bout(&monde, bloc), if cote > 8 { 4 } else { 0 });
        assert!(comparer(&objets, bloc) > 2);
    }
}

/// What makes a batch fast, which no answer shows. The tiles of a picture walk together. Rays in no order go apart, and
/// so do rays in opposite directions, whose common probe tells nothing apart; but not among few objects, nor in a heap,
/// where each ray crosses every box.
fn les_tuiles_vont_ensemble<R: Bits>() {
    let tuiles = scenes::en_tuiles(&scenes::rayons_camera::<R>(512, 512), 512);
    let mut melees = tuiles.clone();
    Hasard::de_graine(12).melanger(&mut melees);
    let opposes = scenes::rayons_opposes::<R>(8);
    let combien = |objets: &[ObjetRay<R>]| {
        let monde = avec_arbre(objets);
        [&tuiles, &melees, &opposes].map(|rayons| combien_vont_au_bout(&monde, rayons))
    };
    let [ensemble, apart, opposes_ensemble] = combien(&scenes::melange(10_000));
    assert!(ensemble > 16_000, "{ensemble}");
    assert_eq!([apart, opposes_ensemble], [0; 2]);
    let peu = scenes::melange(UN_ARBRE + 1);
    assert_eq!(combien(&peu), [16_384, 16_384, 4]);
    // Half-spaces do not count, since they are asked in any case.
    let mut alea = Hasard::de_graine(13);
    let avec = [peu, (0..100).map(|_| sol(&mut alea, 20.0)).collect()].concat();
    let mut places = vec![0.0; places(avec.len())];
    assert_eq!(groupes_au_bout(&Monde::new(&avec, &mut places).unwrap(), &opposes), 4);
    let boule = sphere(v(0.0, 2.0, 0.0), R::depuis_f64(4.0));
    assert_eq!(combien(&[boule; 1_000]), [16_384, 16_384, 4]);
    // The balls need not be equal; but far apart they are no heap.
    let tas = |ecart: f64| {
        let mut alea = Hasard::de_graine(14);
        let boules = (0..1_000).map(|_| {
            let ou = direction(&mut alea) * (ecart * alea.f64().cbrt());
            sphere(arrondi(ou), R::depuis_f64(entre(&mut alea, 4.0, 8.0)))
        });
        boules.collect::<Vec<_>>()
    };
    let vers_partout = (0..6_400).map(|_| {
        let [ou, vers] = [(); 2].map(|()| arrondi(direction(&mut alea)));
        Rayon::new(ou, vers).unwrap()
    });
    let vers_partout: Vec<_> = vers_partout.collect();
    for (ecart, attendus) in [(0.01, 400), (200.0, 0)] {
        let (objets, mut memoire) = (tas(ecart), vec![0.0; 9_000]);
        let monde = Monde::new(&objets, &mut memoire).unwrap();
        assert_eq!(combien_vont_au_bout(&monde, &vers_partout), attendus, "{ecart}");
    }
}

/// A few rays that stray cost only the common walk of the groups of sixteen in which they stand, wherever they go, and
/// all rays have the answers of the list. Where half of the rays stray, none walks with others.
fn un_rayon_egare_n_arrete_que_son_groupe<R: Bits>() {
    let objets = scenes::melange::<R>(10_000);
    let monde = avec_arbre(&objets);
    let tuiles = scenes::en_tuiles(&scenes::rayons_camera::<R>(512, 512), 512);
    for (egares, au_moins) in [(1, 700), (4, 0), (32, 0)] {
        let (mut au_bout, mut juges) = (0, 0);
        let faire = |alea: &mut Hasard| {
            let mut bloc = tuiles[alea.tour * 16 * 64..][..64].to_vec();
            for i in 0..egares {
                let voie = (64 / egares * i + alea.usize(0..64 / egares)) % 64;
                let ou = arrondi(direction(alea) * 30.0);
                bloc[voie] = Rayon::new(ou, arrondi(direction(alea))).unwrap();
            }
            bloc
        };
        pour_chaque(256, faire, |bloc| {
            au_bout += groupes_au_bout(&monde, &bloc);
            juges += 1;
            if juges % 32 == 1 {
                comparer_dans(&monde, &bloc[..64 - au_bout % 40]);
            }
        });
        println!("{egares} of 64 rays stray: {au_bout} of 1,024 groups come to the end");
        assert!(au_bout >= au_moins && (egares < 32 || au_bout == 0), "{egares}: {au_bout}");
    }
}

/// Where one ray crosses many boxes the probe of many rays may too. Rows among crossed sticks walk together, and more
/// of them do the more numbers a register holds.
fn parmi_des_batons_croises_un_large_bloc_va_au_bout<R: Bits>() {
    let mut alea = Hasard::de_graine(3);
    let baton = |i| {
        let ou = direction(&mut alea) * (5.0 * alea.f64().cbrt());
        let angles = [(); 3].map(|()| entre(&mut alea, -4.0, 4.0));
        let rotation = Rotation::new(arrondi(angles.into())).unwrap();
        BoiteGeo::new(arrondi(ou), v(0.03, 3.0, 0.03), rotation, Texture(i)).unwrap().into()
    };
    let objets: Vec<ObjetRay<R>> = (0..1_000).map(baton).collect();
    let monde = avec_arbre(&objets);
    let rangs = scenes::rayons_camera::<R>(64, 64);
    // No row would, if no ray were asked what it crosses.
    for (nom, reglage) in Reglage::tous() {
        let au_bout = combien_vont_au_bout(&reglage.monde(monde), &rangs);
        println!("{nom}: of 64 rows {au_bout} come to the end");
        let huit_nombres = nom == "AVX-512" || (nom == "AVX2" && size_of::<R>() == 4);
        assert!(au_bout > if huit_nombres { 32 } else { 16 }, "{nom}: {au_bout}");
    }
    assert!(comparer(&objets, &rangs[..512]) > 100);
}

/// The nodes of the tree of these objects in this memory, as bits.
fn arbre<R: Reel>(objets: &[ObjetRay<R>], places: &mut [f32]) -> Vec<[[u32; 16]; 7]> {
    // Nodes start at a cache line.
    let debut = places.as_ptr().align_offset(64);
    let combien = noeuds(&Monde::en_morceaux(objets, places).unwrap());
    let (colonnes, _) = places[debut..].as_chunks::<16>();
    let (noeuds, _) = colonnes.as_chunks::<7>();
    noeuds[..combien].iter().map(|noeud| noeud.map(|colonne| colonne.map(f32::to_bits))).collect()
}

/// Eight balls of radius 1 about O and one at 5 on either side, whose tree has its middle in O and a scale of 1/16. The
/// boxes about O have the slack that T2 grants half-extents of 3 in all. No hit that is known lies so far beyond its box that
/// an answer would show the slack.
fn une_boite_a_le_jeu_de_la_preuve<R: Bits>() {
    let boule = |x| sphere::<R>(v(x, 0.0, 0.0), R::UN);
    let objets = [[boule(0.0); 8].as_slice(), &[-5.0, 5.0].map(boule)].concat();
    let feuilles = arbre(&objets, &mut [0.0; 1_000]);
    let attendu = 3.0 / 16.0 * (JEU_LARGEUR + JEU_F32);
    let fiche = |enfant: usize| {
        [0, 1, 2, 3, 4, 5].map(|i| f64::from(f32::from_bits(feuilles[0][i][enfant])))
    };
    let du_milieu = (0..10).map(fiche).filter(|bords| (bords[0] + bords[3]).abs() < 0.1);
    let bords = du_milieu.collect::<Vec<_>>().concat();
    assert_eq!(bords.len(), 8 * 6);
    for bord in bords {
        let jeu = (bord.abs() - 1.0 / 16.0) / f64::from(f32::U);
        assert!((jeu - attendu).abs() < 1.0, "{jeu} is not {attendu}");
    }
}

/// The index of each record in the first leaves of a tree.
fn indices(feuilles: &[[[u32; 16]; 7]]) -> impl Iterator<Item = usize> {
    let fiches = feuilles.iter().flat_map(|[bas, .., indices]| bas.iter().zip(indices));
    // The lower corner of a missing child is far away.
    let fiches = fiches.filter(|(bas, _)| f32::from_bits(**bas) < 2.0);
    fiches.map(|(_, indice)| *indice as usize)
}

/// Long askew boxes about the origin, no two of them alike.
fn poutres<R: Reel>(alea: &mut Hasard, n: usize) -> Vec<ObjetRay<R>> {
    alea.liste(n, |alea, i| {
        let long = deux_puissance(alea, 2.0, 4.0);
        let mut dimensions = [(); 3].map(|()| long * deux_puissance(alea, -8.0, -4.0));
        dimensions[alea.usize(0..3)] = long;
        let ou = direction(alea) * (4.0 * alea.f64());
        let tour = Rotation::new(arrondi(direction(alea) * 7.0)).unwrap();
        let texture = Texture(i as u32);
        BoiteGeo::new(arrondi(ou), arrondi(dimensions.into()), tour, texture).unwrap().into()
    })
}

/// Whether sticks amid a wide town are worth a cut depends on the sticks and the town, not on the order of the list.
fn l_ordre_de_la_liste_ne_decide_pas_de_la_coupe<R: Bits>() {
    let mut alea = Hasard::de_graine(17);
    let batons = poutres::<R>(&mut alea, 400);
    let mut coupes = 0;
    for (maisons, r) in [(40, 1.0), (80, 3.0), (120, 10.0), (160, 30.0), (200, 90.0)] {
        let mut objets = batons.clone();
        for _ in 0..maisons {
            let ou = direction(&mut alea) * (2_000.0 * alea.f64());
            objets.push(sphere(arrondi(ou), R::depuis_f64(r)));
        }
        let mut memoire = vec![0.0; 2 * places(objets.len())];
        let juste = noeuds(&Monde::new(&objets, &mut memoire).unwrap());
        let nombres = [(); 12].map(|()| {
            alea.melanger(&mut objets);
            noeuds(&Monde::en_morceaux(&objets, &mut memoire).unwrap())
        });
        // The mean size is summed in another order, and one more piece may fill a leaf.
        let coupees = nombres.iter().filter(|nombre| **nombre > juste).count();
        assert!(coupees == 0 || coupees == nombres.len(), "{maisons}: {juste}, {nombres:?}");
        assert!(nombres.iter().all(|nombre| nombre.abs_diff(nombres[0]) <= 1), "{nombres:?}");
        coupes += usize::from(coupees > 0);
    }
    assert!((1..5).contains(&coupes), "{coupes} of 5 are cut");
}

/// Places lent beyond what is needed are spent on long askew boxes, on all alike, and on nothing else. Any number of
/// places will do.
fn les_places_de_plus_vont_aux_boites_longues<R: Bits>() {
    let mut alea = Hasard::de_graine(31);
    // Nothing is long, or only along the axes.
    let mut trapus = scenes::melange::<R>(500);
    for (i, axe) in (0..40).zip([0, 1, 2].into_iter().cycle()) {
        let mut dimensions = [0.1; 3];
        dimensions[axe] = 5.0;
        let quart = Rotation::new(v(FRAC_PI_2, 0.0, 2.0 * FRAC_PI_2)).unwrap();
        let ou = arrondi(direction(&mut alea) * 4.0);
        let poutre = BoiteGeo::new(ou, arrondi(dimensions.into()), quart, Texture(i));
        trapus.push(poutre.unwrap().into());
    }
    for n in [UN_ARBRE, 100, trapus.len()] {
        let (objets, necessaires) = (&trapus[trapus.len() - n..], places(n));
        let [juste, ample] = [1, 9].map(|k| arbre(objets, &mut vec![f32::NAN; k * necessaires]));
        assert!(juste == ample, "{n}");
    }
    // Needles along the axes are not cut either; they are so thin that in the frame of a tree they have no surface.
    let aiguilles: Vec<_> = (0..40)
        .map(|i| {
            let mut dimensions = [R::UN / R::LIMITE; 3];
            dimensions[i % 3] = R::UN;
            boite_droite::<R>(v(i as f64, 0.0, 0.0), dimensions.into())
        })
        .collect();
    let [juste, ample] = [1, 9].map(|k| arbre(&aiguilles, &mut vec![f32::NAN; k * places(40)]));
    assert_eq!(juste.len(), ample.len());
    // Too few objects for a tree stay too few, alone or among half-spaces.
    let demi_espaces = [(); 20].map(|()| sol(&mut alea, 20.0));
    let mut peu = poutres::<R>(&mut alea, UN_ARBRE - 1);
    assert!(arbre(&peu, &mut [0.0; 9_000]).is_empty());
    peu.extend(demi_espaces);
    assert!(arbre(&peu, &mut [0.0; 9_000]).is_empty());
    for n in [UN_ARBRE, 16, 17, 100, 240, 256, 700] {
        let mut objets = poutres::<R>(&mut alea, n);
        let rayons = gerbes(&mut alea, &objets, 4.0);
        if n == 100 {
            objets.extend(demi_espaces);
        }
        let necessaires = places(objets.len());
        let seul = arbre(&objets, &mut vec![f32::NAN; necessaires]);
        let mut plus_grand = seul.len();
        for plus in (0..4 * necessaires + 500).step_by(necessaires / 12 + 1) {
            let mut places = vec![f32::NAN; necessaires + plus + 16];
            let places = &mut places[plus % 16..][..necessaires + plus];
            let noeuds = arbre(&objets, places);
            // Less than a record changes nothing.
            assert!(plus >= 7 || noeuds == seul, "{n}, {plus} more");
            plus_grand = plus_grand.max(noeuds.len());
            let monde = Monde::en_morceaux(&objets, places).unwrap();
            for rayon in &rayons[..16] {
                let attendue = mots(&premiere_intersection(&objets, rayon));
                assert_eq!(mots(&monde.premiere_intersection(rayon)), attendue);
            }
        }
        assert!(plus_grand > seul.len(), "{n}: {}, {plus_grand}", seul.len());
    }
    // If there is too little room, all objects share it, not only the first of the list.
    let objets = poutres::<R>(&mut alea, 1_000);
    let noeuds = arbre(&objets, &mut vec![f32::NAN; 2 * places(1_000)]);
    let feuilles = noeuds.len() * 15 / 16;
    let premiers = indices(&noeuds[..feuilles]).filter(|indice| *indice < 500).count();
    assert!((900..1_100).contains(&premiers) && feuilles >= 120, "{premiers} of {feuilles} leaves");
}

/// Built: a long askew box, alone or twice, among small spheres, in a tree with room for all its slices, some four to
/// ten. Rays go to the planes between slices, to the last bits, and most of them to edges of the box: from all sides,
/// from nearby, from so far that rounding moves the hit, and along the box. Held: the answers of the list, also for
/// shadows up to the very hit. A gap between two slices would show.
fn aux_coutures_des_morceaux_aucune_touche_n_est_perdue<R: Bits>() {
    let bits = -R::U.vers_f64().log2();
    // How many slices the tree has of the first of these objects, since all nodes but the root are leaves.
    let tranches = |objets: &[ObjetRay<R>]| {
        let noeuds = arbre(objets, &mut vec![f32::NAN; places(200)]);
        indices(&noeuds[..noeuds.len().saturating_sub(1)]).filter(|indice| *indice == 0).count()
    };
    let faire = |alea: &mut Hasard| {
        let lieu = direction(alea) * [0.0, 0.0, 100.0][alea.tour % 3];
        let mince = deux_puissance(alea, -9.0, -4.0);
        let dimensions = v(mince, 4.0, mince * deux_puissance(alea, -2.0, 2.0));
        let rotation = Rotation::new(arrondi(direction(alea) * 7.0)).unwrap();
        let poutre = BoiteGeo::new(arrondi(lieu), dimensions, rotation, Texture(0)).unwrap();
        let mut objets: Vec<ObjetRay<R>> = vec![poutre.into(); 1 + alea.tour % 2];
        objets.extend(alea.liste(60 - objets.len(), |alea, _| {
            sphere(arrondi(lieu + direction(alea) * 0.5), R::depuis_f64(0.01))
        }));
        let (tranches, poutre) = (tranches(&objets).max(1), poutre.vers_ray());
        let [n, long, m] = poutre.normales().map(Vecteur::vers_f64);
        let [a, b, c] = poutre.demi_longueurs().map(R::vers_f64);
        let rayons = alea.liste(8 * 64, |alea, _| {
            let couture = 2.0 * alea.usize(0..tranches + 1) as f64 / tranches as f64 - 1.0;
            let peu = 1.0 + entre(alea, -4.0, 4.0) * R::U.vers_f64();
            let mut bord = || if alea.u8(0..4) > 0 { signe(alea) } else { entre(alea, -1.0, 1.0) };
            let bords = n * (a * bord()) + m * (c * bord());
            let cible = poutre.centre().vers_f64() + bords * peu + long * (b * couture * peu);
            let (d, loin) = match alea.u8(0..4) {
                // Along the box.
                0 => {
                    let travers = direction(alea) * deux_puissance(alea, -bits, -4.0);
                    (long * signe(alea) + travers, 5.0)
                }
                1 => (direction(alea), deux_puissance(alea, 3.0, bits - 4.0)),
                _ => (direction(alea), deux_puissance(alea, -6.0, 2.0)),
            };
            let d = d.unitaire().unwrap();
            Rayon::new(arrondi(cible - d * loin), arrondi(d)).unwrap()
        });
        (objets, rayons)
    };
    let (mut touches, mut certaines, mut coutures) = (0, 0, 0);
    pour_chaque(cas() as u32, faire, |(objets, rayons)| {
        coutures += tranches(&objets).saturating_sub(1);
        let mut places = vec![f32::NAN; places(200)];
        let monde = Monde::en_morceaux(&objets, &mut places).unwrap();
        touches += comparer_dans(&monde, &rayons);
        for rayon in rayons.iter().take(64) {
            let touche = premiere_intersection(&objets, rayon);
            let certaine = Monde::de_liste(&objets).certifie(rayon, &touche);
            assert!(monde.certifie(rayon, &touche) || !certaine, "{rayon:?}");
            certaines += usize::from(certaine);
        }
    });
    let combien = format!("{touches} hits, {certaines} certain, {coutures} seams");
    assert!(touches > 200 * cas() && certaines > 10 * cas() && coutures > 3 * cas(), "{combien}");
}

/// Long boxes at random, once or three times, and rays of all kinds: at a tie the first is hit, whichever piece finds
/// it. One box is left out at times.
fn des_poutres_en_morceaux_repondent_comme_la_liste<R: Bits>() {
    let touches =
        comme_la_liste::<R>(6, |alea| {
            let (n, copies) = ([UN_ARBRE, 40, 300][alea.tour % 3], [1, 3][alea.tour / 3]);
            let mut objets = poutres::<R>(alea, n.div_ceil(copies)).repeat(copies);
            // Balls are in one piece, and only the first of several walks shows them.
            objets.extend(alea.liste(n / 10, |alea, _| {
                sphere(arrondi(direction(alea) * (4.0 * alea.f64())), R::UN)
            }));
            alea.melanger(&mut objets);
            let rayons = gerbes(alea, &objets, 4.0);
            (objets, rayons)
        });
    assert!(touches > 100, "only {touches} hits");
}

/// Rays of one block start under a face of a long box by less than their δ, and go in. They touch the box at once,
/// though the block first meets a piece that does not hold the start.
fn une_poutre_en_morceaux_est_touchee_d_emblee<R: Bits>() {
    let flou = R::depuis_f64(2_f64.powi(-12));
    let faire = |alea: &mut Hasard| {
        let objets = poutres::<R>(alea, 60);
        let rayons = alea.liste(4, |alea, _| {
            let ObjetRay::Boite(poutre) = *alea.choix(&objets) else { unreachable!("a box") };
            let face = Face::TOUTES[alea.usize(0..6)];
            let (n, uv) = (poutre.face(face).1, [(); 2].map(|()| entre(alea, -0.8, 0.8)));
            let lieu = poutre.vers_lieu(face, uv.map(R::depuis_f64)).unwrap();
            let lieu = ObjetRay::from(poutre).sortie(&lieu).unwrap().point();
            let penche = arrondi::<R>(direction(alea) * 0.9);
            let rayon = |alea: &mut Hasard| {
                let ecart = arrondi::<R>(direction(alea) * 2_f64.powi(-8));
                let source = lieu - n * (flou * R::depuis_f64(alea.f64()));
                Rayon::new(source, penche + ecart - n).and_then(|rayon| rayon.avec_flou(flou))
            };
            (0..64).map(|_| rayon(alea).unwrap()).collect::<Vec<_>>()
        });
        (objets, rayons.concat())
    };
    let mut d_emblee = 0;
    pour_chaque(40, faire, |(objets, rayons)| {
        let mut places = vec![f32::NAN; 4 * places(objets.len())];
        comparer_dans(&Monde::en_morceaux(&objets, &mut places).unwrap(), &rayons);
        let touches = rayons.iter().map(|rayon| premiere_intersection(&objets, rayon));
        d_emblee += touches.flatten().filter(|touche| touche.distance() == R::ZERO).count();
    });
    assert!(d_emblee > 5_000, "{d_emblee}");
}

/// Rays of one block start under a floor by less than their δ, and go in. The floor has no box, and the block, which
/// offers it before it enters the tree, touches it at once.
fn un_sol_est_touche_d_emblee_en_bloc<R: Bits>() {
    let flou = R::depuis_f64(2_f64.powi(-12));
    let faire = |alea: &mut Hasard| {
        let mut objets = poutres::<R>(alea, 60);
        objets.push(sol(alea, 4.0));
        let Some(ObjetRay::Plan(sol)) = objets.last() else { unreachable!("a half-space") };
        let (n, penche) = (sol.normale(), arrondi::<R>(direction(alea) * 0.9));
        let lieu = -n * sol.distance();
        let rayons = alea.liste(64, |alea, _| {
            let ecart = arrondi::<R>(direction(alea) * 2_f64.powi(-8));
            let source = lieu - n * (flou * R::depuis_f64(alea.f64()));
            let rayon = Rayon::new(source, penche + ecart - n).unwrap();
            rayon.avec_flou(flou).unwrap()
        });
        (objets, rayons)
    };
    let mut d_emblee = 0;
    pour_chaque(20, faire, |(objets, rayons)| {
        let monde = avec_arbre(&objets);
        comparer_dans(&monde, &rayons);
        let touches = rayons.iter().flat_map(|rayon| monde.premiere_intersection(rayon));
        let du_sol = touches.filter(|touche| touche.indice() == 60);
        d_emblee += du_sol.filter(|touche| touche.distance() == R::ZERO).count();
    });
    assert!(d_emblee > 500, "{d_emblee}");
}

/// A block remembers by their indices which objects of a tree in pieces it has asked, and still asks the first of the
/// list.
fn un_bloc_demande_le_premier_de_la_liste<R: Bits>() {
    let mut du_premier = 0;
    let faire = |alea: &mut Hasard| {
        let objets = poutres::<R>(alea, 30);
        let rayons = alea.liste(30, |alea, i| {
            let ObjetRay::Boite(poutre) = objets[i] else { unreachable!("a box") };
            let vers = direction(alea);
            gerbe(alea, (poutre.centre().vers_f64() - vers * 20.0, vers), [2_f64.powi(-6); 2])
        });
        (objets, rayons)
    };
    pour_chaque(2, faire, |(mut objets, rayons)| {
        for rayons in rayons {
            let mut places = vec![f32::NAN; 4 * places(objets.len())];
            let monde = Monde::en_morceaux(&objets, &mut places).unwrap();
            comparer_dans(&monde, &rayons);
            let touches = rayons.iter().flat_map(|rayon| monde.premiere_intersection(rayon));
            du_premier += touches.filter(|touche| touche.indice() == 0).count();
            objets.rotate_left(1);
        }
    });
    assert!(du_premier > 200, "{du_premier}");
}

/// Forty boxes whose tops lie in one plane, twenty half-spaces under it, before them in the list or behind, and rays that
/// start under that plane by less than their δ, and go down. They touch all objects at once, at distance 0. A block that
/// has met a half-space there still asks the others and the boxes, and even when all places are full, an object earlier in
/// the list takes one.
fn de_ce_qui_est_touche_d_emblee_le_premier_de_la_liste_est_le_premier<R: Bits>() {
    let flou = R::depuis_f64(2_f64.powi(-12));
    let faire = |alea: &mut Hasard| {
        let boites = alea.liste(40, |alea, _| {
            let [x, y] = [(); 2].map(|()| entre(alea, -1.0, 1.0));
            let [large, haut] = [entre(alea, 3.0, 6.0), deux_puissance(alea, -2.0, 2.0)];
            boite_droite::<R>(v(x, y, -0.5 * haut), v(large, large, haut))
        });
        let (sols, devant) = ([mur(Vecteur::NUL, Vecteur::Z); 20], alea.tour.is_multiple_of(2));
        let objets = if devant { [&sols, &boites[..]] } else { [&boites[..], &sols] }.concat();
        let rayons = alea.liste(16, |alea, _| {
            let source = v(entre(alea, -0.4, 0.4), entre(alea, -0.4, 0.4), 0.0);
            let source = source - Vecteur::Z * (flou * R::depuis_f64(alea.f64()));
            let vers = arrondi::<R>(direction(alea) * 0.5) - Vecteur::Z;
            Rayon::new(source, vers).unwrap().avec_flou(flou).unwrap()
        });
        (objets, rayons)
    };
    pour_chaque(10, faire, |(objets, rayons)| {
        let monde = avec_arbre(&objets);
        comparer_dans(&monde, &rayons);
        for rayon in &rayons {
            let mut touches = [Err(NoIntersection); 3];
            assert_eq!(monde.dans_l_ordre(rayon, &mut touches), 3);
            let lues = touches.map(|touche| touche.map(|t| (t.distance(), t.indice())));
            assert_eq!(lues, [0, 1, 2].map(|indice| Ok((R::ZERO, indice))));
        }
    });
}

/// Built: an object that a ray passes across an axis, at the object's farthest point along that axis, within rounding
/// of the distance; the object, the source or both are far from the many. Held: a hit beyond the box of the object is
/// not lost. In `f32` some hits lie so; in `f64` the box itself is rounded.
fn une_touche_au_bord_de_sa_boite_n_est_pas_perdue<R: Bits>() {
    // In `f64` so far away that the error of a hit exceeds the rounding of a box.
    let bits = -R::U.vers_f64().log2() - 4.0;
    let faire = |alea: &mut Hasard| {
        let [f, loin] = [(); 2].map(|()| deux_puissance(alea, 0.0, bits));
        let milieu = direction(alea) * if alea.tour.is_multiple_of(3) { 0.0 } else { loin };
        let e = d_axe(alea);
        let d = direction(alea);
        let d = (d - e * d.produit_scalaire(e)).unitaire().unwrap();
        let seul = objet::<R>(alea, milieu, 1.0, 0);
        let (c, bord) = match seul {
            ObjetRay::Sphere(sphere) => (sphere.centre(), e * sphere.rayon().vers_f64()),
            ObjetRay::Boite(boite) => {
                let coin =
                    boite.normales().into_iter().zip(boite.demi_longueurs()).map(|(n, l)| {
                        let n = n.vers_f64();
                        n * (l.vers_f64() * n.produit_scalaire(e).signum())
                    });
                (boite.centre(), coin.fold(Vecteur::NUL, |a, b| a + b))
            }
            ObjetRay::Plan(_) => unreachable!("no half-space was made"),
        };
        let au_bord = c.vers_f64() + bord;
        // The many lie about the origin, all on one side, so that their boxes do not cover that of the one.
        let mut objets = vec![seul];
        objets.extend(alea.liste(40, |alea, i| {
            let ou = direction(alea) * 0.4 - e * 3.0;
            objet(alea, ou, 0.01, i)
        }));
        let u = R::U.vers_f64() * (f + milieu.longueur());
        let rayons = alea.liste(64, |alea, _| {
            let large = f64::from(f32::U) * (1.0 + milieu.longueur());
            let ecart = entre(alea, -8.0, 8.0) * if alea.bool() { u } else { large };
            Rayon::new(arrondi(au_bord + e * ecart - d * f), arrondi(d))
        });
        let rayons: Vec<_> = rayons.into_iter().flatten().collect();
        // Every other time long boxes are cut into pieces.
        (objets, rayons, [1, 6][alea.tour % 2], (au_bord, e / u))
    };
    let (mut touches, mut dehors) = (0, 0.0_f64);
    pour_chaque(160 * cas() as u32, faire, |(objets, rayons, fois, (au_bord, e))| {
        let mut places = vec![0.0; fois * places(objets.len())];
        let monde = Monde::en_morceaux(&objets, &mut places).unwrap();
        let mut lot = vec![Err(NoIntersection); rayons.len()];
        monde.premieres_intersections(&rayons, &mut lot).unwrap();
        for (rayon, en_lot) in rayons.iter().zip(lot) {
            let attendue = premiere_intersection(&objets, rayon);
            let obtenue = monde.premiere_intersection(rayon);
            assert_eq!(mots(&obtenue), mots(&attendue), "{:?}, {rayon:?}", objets[0]);
            assert_eq!(mots(&en_lot), mots(&attendue), "in a batch: {:?}, {rayon:?}", objets[0]);
            let Some(touche) = attendue.ok().filter(|touche| touche.indice() == 0) else {
                continue;
            };
            touches += 1;
            let x = rayon.source().vers_f64()
                + rayon.direction().vers_f64() * touche.distance().vers_f64();
            dehors = dehors.max((x - au_bord).produit_scalaire(e));
        }
    });
    assert!(touches > 400 * cas(), "only {touches} hits");
    assert!(R::U < R::depuis_f64(1e-10) || dehors > 1.0, "{dehors}");
}

fn d_axe(alea: &mut Hasard) -> Vecteur {
    let mut d = [0.0; 3];
    d[alea.usize(0..3)] = signe(alea);
    d.into()
}

/// A ray runs along an edge of boxes, within rounding of two faces. Its shadow is cut off no earlier than in the list.
fn le_long_d_une_arete_une_ombre_est_celle_de_la_liste<R: Bits>() {
    let touches = comme_la_liste::<R>(100 * cas(), |alea| {
        let [x, y] = [(); 2].map(|()| entre(alea, 0.05, 0.15));
        let objets = [boite_droite::<R>(v(x, y, 0.0), v(1.0, 1.0, 4.0)); UN_ARBRE];
        let ObjetRay::Boite(boite) = objets[0] else { unreachable!("made as a box") };
        let c = boite.centre();
        let demi = R::depuis_f64(0.5);
        let [sx, sy] = [c.x - demi, c.y - demi].map(|x| voisin(x, alea.i8(-2..=2).into()));
        let s = Vecteur::new(sx, sy, -R::depuis_f64(7.0));
        let d = v(alea.f64() * 0.3 * R::U.vers_f64(), 0.0, 1.0);
        (objets.to_vec(), vec![Rayon::new(s, d).unwrap()])
    });
    assert!(touches > 20 * cas(), "only {touches} hits");
}

/// Sources up to the limit away from objects of any size, ever farther, until the boxes of the tree can no longer be
/// told apart.
fn de_toute_distance_un_arbre_repond_comme_la_liste<R: Bits>() {
    let limite = R::LIMITE.vers_f64().log2();
    let touches = comme_la_liste::<R>(9 * cas(), |alea| {
        let n = [UN_ARBRE, 40, 300][alea.tour % 3];
        let unite = [8.0 - limite, -20.0, 0.0][alea.tour / 3 % 3].exp2();
        let autour = |alea: &mut Hasard| direction(alea) * (4.0 * unite * alea.f64());
        let objets = alea.liste(n, |alea, i| {
            let ou = autour(alea);
            objet(alea, ou, 0.5 * unite, i)
        });
        let loin = deux_puissance(alea, unite.log2() + 3.0, limite - 1.0);
        let axe = d_axe(alea);
        let rayons = alea.liste(64, |alea, _| {
            Rayon::new(arrondi(autour(alea) - axe * loin), arrondi(axe)).unwrap()
        });
        (objets, rayons)
    });
    assert!(touches > 100 * cas(), "only {touches} hits");
}

/// The source is far from the many, and entries count from the point next to them. An object close ahead of the source
/// comes before a limit, whether the ray approaches the many or goes away from them.
fn loin_de_tous_l_objet_tout_proche_est_touche<R: Bits>() {
    let touches = comme_la_liste::<R>(2 * cas(), |alea| {
        let ou = direction(alea) * deux_puissance(alea, 6.0, 24.0);
        let taille = ou.longueur() * deux_puissance(alea, -12.0, -4.0);
        let mut objets = alea.liste(40, |alea, _| {
            let ou = direction(alea);
            objet(alea, ou, 0.1, 0)
        });
        objets.push(objet(alea, ou, taille, 1));
        let sens = if alea.tour.is_multiple_of(2) { ou } else { -ou } / ou.longueur();
        let rayons = alea.liste(64, |alea, _| {
            let d = sens + direction(alea) * 0.1;
            Rayon::new(arrondi(ou - d * (3.0 * taille)), arrondi(d)).unwrap()
        });
        (objets, rayons)
    });
    assert!(touches > 20 * cas(), "only {touches} hits");
}

/// Clusters so small beside the largest object that all their boxes have the same corners.
fn des_objets_minuscules_repondent_comme_dans_la_liste<R: Bits>() {
    let limite = R::LIMITE.vers_f64().log2();
    let touches = comme_la_liste::<R>(3 * cas(), |alea| {
        let petit = deux_puissance(alea, 8.0 - limite, -10.0);
        let ou = if alea.bool() { Vecteur::NUL } else { direction(alea) * (petit * 1e4) };
        let n = UN_ARBRE + alea.usize(0..60);
        let mut objets = alea.liste(n, |alea, i| {
            let ou = ou + direction(alea) * (4.0 * petit * alea.f64());
            objet(alea, ou, petit * 0.5, i)
        });
        let grand = deux_puissance(alea, 0.0, limite - 3.0);
        objets.push(objet(alea, Vecteur::new(3.0 * grand, 0.0, 0.0), grand, 0));
        let rayons = gerbes(alea, &objets, petit);
        (objets, rayons)
    });
    assert!(touches > 10 * cas(), "only {touches} hits");
}

/// Objects of a few subnormals of the tree's boxes, for there is another so large and far: what the
/// boxes and the start of a ray round to there must hide no hit.
#[test]
fn des_objets_de_quelques_sous_normaux_repondent_comme_dans_la_liste() {
    let touches = comme_la_liste::<f64>(6 * cas(), |alea| {
        let petit = deux_puissance(alea, -48.0, -44.0);
        let mut objets = alea.liste(UN_ARBRE + 30, |alea, i| {
            let ou = direction(alea) * (64.0 * petit * alea.f64());
            objet(alea, ou, petit, i)
        });
        let grand = 100_f64.exp2();
        objets.push(sphere(Vecteur::new(3.0 * grand, 0.0, 0.0), grand));
        let rayons = gerbes(alea, &objets[..UN_ARBRE], petit);
        (objets, rayons)
    });
    assert!(touches > 10 * cas(), "only {touches} hits");
}

/// Built: slabs that cover the scene, more or fewer than a leaf holds, among small objects. Held: the answers of the
/// list; and sixteen slabs have a leaf under the root or, where the root is full, under another above it.
fn les_geants_ont_leur_feuille_sous_la_racine<R: Bits>() {
    // How many giants and how many others; then the number of leaves, that of giants included, and of nodes above.
    let nombres = [
        (16, 256, Some(17 + 1 + 1)),
        (16, 240, Some(16 + 1)),
        (16, 1, None),
        (16, 8, None),
        (5, 256, None),
        (0, 272, Some(17 + 2 + 1)),
        (40, 232, Some(17 + 1 + 1)),
        (17, 600, None),
        (16, 4_000, Some(251 + 16 + 1 + 1)),
        (16, 4_065, Some(256 + 16 + 1 + 1)),
    ];
    let faire = |alea: &mut Hasard| {
        let (grands, petits, voulus) = nombres[alea.tour];
        let mut objets = alea.liste(petits, |alea, _| {
            let ou = direction(alea) * 10.0;
            objet::<R>(alea, ou, 0.1, 0)
        });
        for i in 0..grands {
            let y = -12.0 + f64::from(i) * 24.0 / f64::from(grands);
            let dalle = boite_droite(v(0.0, y, 0.0), v(30.0, 0.05, 30.0));
            objets.insert(alea.usize(0..objets.len() + 1), dalle);
        }
        if petits == 4_065 {
            // There are then as many half-spaces as the places beside the nodes can hold.
            objets.extend([(); 15].map(|()| sol::<R>(alea, 20.0)));
        }
        let rayons = gerbes(alea, &objets, 10.0);
        (objets, rayons, voulus)
    };
    let mut touches = 0;
    pour_chaque(nombres.len() as u32, faire, |(objets, rayons, voulus)| {
        touches += comparer(&objets, &rayons);
        let monde = avec_arbre(&objets);
        assert!(voulus.is_none_or(|voulus| noeuds(&monde) == voulus), "{monde:?}");
    });
    assert!(touches > 100, "only {touches} hits");
}

fn places_dit_combien_de_places_suffisent<R: Bits>() {
    // The last number of objects that gets a tree, and the first that does not, also on 32-bit machines.
    assert!(places(0x7f7f_ffff) > 0 && places(0x7f80_0000) == 0);
    for n in [0, 1, UN_ARBRE - 1, UN_ARBRE, 256, 257, 1_000] {
        let scene = scenes::melange::<R>(n);
        let rayons = scenes::rayons_camera::<R>(9, 9);
        let necessaires = places(n);
        // An object takes 7.5 places; the rest is nodes that are not full, one a floor, and one above the giants.
        assert!(necessaires <= 8 * n + 400, "{n}: {necessaires}");
        assert_eq!(necessaires > 0, n >= UN_ARBRE);
        for pretees in [0, necessaires / 2, necessaires.saturating_sub(1)] {
            let mut places = vec![0.0; pretees];
            let erreur = Monde::new(&scene, &mut places).err();
            let refus = PlacesInsuffisantes { places: pretees, necessaires };
            assert_eq!(erreur, (pretees < necessaires).then_some(refus));
            let phrase = format!("{pretees} places lent, but {necessaires} needed");
            assert_eq!(refus.to_string(), phrase);
        }
        for pretees in [necessaires, necessaires + 1, 2 * necessaires + 100] {
            let mut places = vec![f32::INFINITY; pretees];
            let monde = Monde::new(&scene, &mut places).unwrap();
            // One line, whatever the number of objects.
            assert!(format!("{monde:?}").len() < 60, "{monde:?}");
            let copie = monde;
            for rayon in &rayons {
                let attendue = mots(&premiere_intersection(&scene, rayon));
                assert_eq!(mots(&copie.premiere_intersection(rayon)), attendue);
            }
        }
    }
}

/// Built: `bornes` objects with a box, at the end or spread among half-spaces, in exactly the places that are asked
/// for, which start anywhere in a cache line. Held: the answers of the list, and a tree from ten objects with a box on.
/// One place less would show.
fn les_demi_espaces_ont_leur_place<R: Bits>() {
    let faire = |alea: &mut Hasard| {
        // No bounded object, one, and just too few and just enough for a tree; and as many half-spaces as take no
        // further node.
        let (bornes, demi_espaces) = [
            (0, 100),
            (1, 15),
            (UN_ARBRE - 1, 91),
            (UN_ARBRE - 1, 1),
            (UN_ARBRE, 300),
            (UN_ARBRE, 16 - UN_ARBRE),
            (17, 15),
            (241, 15),
            (257, 15),
            (20, 60),
        ][alea.tour];
        let mut objets = scenes::melange::<R>(bornes + 1).split_off(1);
        objets.extend((0..demi_espaces).map(|_| sol::<R>(alea, 20.0)));
        if alea.tour.is_multiple_of(2) {
            alea.melanger(&mut objets);
        }
        (objets, bornes)
    };
    let rayons = scenes::rayons_camera::<R>(6, 6);
    pour_chaque(10, faire, |(objets, bornes)| {
        let _ = comparer(&objets, &rayons);
        let necessaires = places(objets.len());
        let mut places = vec![0.0; necessaires + 16];
        for debut in 0..16 {
            let monde = Monde::new(&objets, &mut places[debut..debut + necessaires]).unwrap();
            // Without a tree the list would be compared with itself.
            assert_eq!(noeuds(&monde) > 0, bornes >= UN_ARBRE);
            for rayon in &rayons {
                let attendue = mots(&premiere_intersection(&objets, rayon));
                assert_eq!(mots(&monde.premiere_intersection(rayon)), attendue);
            }
        }
    });
}

fn des_longueurs_differentes_sont_une_erreur_et_rien_n_est_ecrit<R: Bits>() {
    let (scene, rayons) = (scenes::melange::<R>(300), scenes::rayons_camera(20, 10));
    for monde in [avec_arbre(&scene), Monde::de_liste(&scene)] {
        let avant = monde.premiere_intersection(&rayons[105]);
        assert!(avant.is_ok());
        for longueur in [0, 1, 199, 201] {
            let erreur = LongueursDifferentes { rayons: 200, reponses: longueur };
            assert_eq!(erreur.to_string(), format!("200 rays, but places for {longueur} answers"));
            let mut touches = vec![avant; longueur];
            assert_eq!(monde.premieres_intersections(&rayons, &mut touches), Err(erreur));
            assert_eq!(touches, vec![avant; longueur]);
            for vraie in [true, false] {
                let mut occultes = vec![vraie; longueur];
                assert_eq!(monde.sont_occultes(&rayons, &mut occultes), Err(erreur));
                assert_eq!(occultes, vec![vraie; longueur]);
            }
        }
    }
}

en_f32_et_f64!(les_tuiles_vont_ensemble);
en_f32_et_f64!(parmi_des_batons_croises_un_large_bloc_va_au_bout);
en_f32_et_f64!(un_arbre_d_objets_au_hasard_repond_comme_la_liste);
en_f32_et_f64!(le_long_des_axes_un_arbre_repond_comme_la_liste);
en_f32_et_f64!(parmi_des_objets_egaux_le_premier_de_la_liste_est_touche);
en_f32_et_f64!(un_tres_grand_arbre_repond_comme_la_liste);
en_f32_et_f64!(les_places_de_plus_vont_aux_boites_longues);
en_f32_et_f64!(aux_coutures_des_morceaux_aucune_touche_n_est_perdue);
en_f32_et_f64!(un_rayon_egare_n_arrete_que_son_groupe);
en_f32_et_f64!(l_ordre_de_la_liste_ne_decide_pas_de_la_coupe);
en_f32_et_f64!(des_poutres_en_morceaux_repondent_comme_la_liste);
en_f32_et_f64!(une_poutre_en_morceaux_est_touchee_d_emblee);
en_f32_et_f64!(un_sol_est_touche_d_emblee_en_bloc);
en_f32_et_f64!(de_ce_qui_est_touche_d_emblee_le_premier_de_la_liste_est_le_premier);
en_f32_et_f64!(un_bloc_demande_le_premier_de_la_liste);
en_f32_et_f64!(une_boite_a_le_jeu_de_la_preuve);
en_f32_et_f64!(une_touche_au_bord_de_sa_boite_n_est_pas_perdue);
en_f32_et_f64!(le_long_d_une_arete_une_ombre_est_celle_de_la_liste);
en_f32_et_f64!(de_toute_distance_un_arbre_repond_comme_la_liste);
en_f32_et_f64!(loin_de_tous_l_objet_tout_proche_est_touche);
en_f32_et_f64!(des_objets_minuscules_repondent_comme_dans_la_liste);
en_f32_et_f64!(places_dit_combien_de_places_suffisent);
en_f32_et_f64!(les_demi_espaces_ont_leur_place);
en_f32_et_f64!(les_geants_ont_leur_feuille_sous_la_racine);
en_f32_et_f64!(des_longueurs_differentes_sont_une_erreur_et_rien_n_est_ecrit);
