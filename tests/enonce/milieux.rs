//! Flush media as the ordinary case: panes, voxels, and glass on a table in mist, by the recipes for media and for
//! chords.

use commun::fabrique::{avec_arbre, boite, mur, sphere, v};
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::regimes::{direction, entre};
use commun::tolerances::u;
use commun::{arrondi, en_f32_et_f64};
use exemples::recettes::cordes::{Corde, cordes, sans_recouvrement};
use exemples::recettes::milieux::{Lumiere, Milieu, Surface};
use lancer_rayon::{Monde, ObjetRay, Rayon, Reel, Rotation, Vecteur};

fn milieu(priorite: u32, indice: f64) -> Milieu {
    Milieu { priorite, indice }
}

/// Up to six flush plates of glass and water, turned. Light comes out in the direction in which it went in, displaced
/// by the sum of what Snell's law gives for the plates, and is in each plate once.
fn des_lames_a_fleur_deplacent_la_lumiere_de_leur_somme<R: Reel>() {
    let epaisseur = 0.2;
    let faire = |alea: &mut Hasard| {
        let tour = Rotation::<R>::new(arrondi(direction(alea) * 3.0)).unwrap();
        (tour, arrondi::<R>(direction(alea)).vers_f64(), 1 + alea.tour % 6, entre(alea, 0.1, 0.8))
    };
    pour_chaque(3_000, faire, |(tour, centre, combien, sinus)| {
        let [x, _, z] = tour.axes().map(Vecteur::vers_f64);
        let lame = |i: usize| {
            let c = centre - z * (epaisseur * i as f64);
            boite(arrondi::<R>(c), v(20.0, 20.0, epaisseur), tour)
        };
        let lames: Vec<_> = (0..combien).map(lame).collect();
        let indice = |i: usize| if i.is_multiple_of(2) { 1.5 } else { 1.33 };
        let milieux: Vec<_> = (0..combien).map(|i| milieu(i as u32, indice(i))).collect();
        let d = x * sinus - z * (1.0 - sinus * sinus).sqrt();
        let rayon = Rayon::new(arrondi::<R>(centre + z), arrondi(d)).unwrap();
        let mut lumiere = Lumiere { rayon, dans: vec![] };
        let mut suite = vec![];
        while lumiere.avancer(&Monde::de_liste(&lames), &milieux).unwrap() {
            suite.push(lumiere.dans.clone());
            assert!(suite.len() <= combien + 1, "{suite:?}");
        }
        let attendue: Vec<_> = (0..combien).map(|i| vec![i]).chain([vec![]]).collect();
        assert_eq!(suite, attendue);
        let chemin = (lumiere.rayon.source() - rayon.source()).vers_f64();
        let a_cote = chemin.produit_vectoriel(d).longueur();
        let par_lame = |i: usize| {
            let (dehors, dedans) = (sinus.asin(), (sinus / indice(i)).asin());
            epaisseur * (dehors - dedans).sin() / dedans.cos()
        };
        let attendu: f64 = (0..combien).map(par_lame).sum();
        // At each face there are some fifty roundings of numbers below 3, at cosines above 0.6.
        let permis = 500.0 * u::<R>() * (1 + combien) as f64;
        assert!((a_cote - attendu).abs() < permis, "{a_cote} {attendu}");
        assert!((lumiere.rayon.direction().vers_f64() - d).longueur() < permis);
    });
}

en_f32_et_f64!(des_lames_a_fleur_deplacent_la_lumiere_de_leur_somme);

/// A cube of flush cubes, straight or turned, near or far. The chords of a ray from without or within leave no gap
/// between them, and light that goes from face to face, along the planes and edges of the grid too, is in each cube
/// whose chord is longer than rounding.
fn des_cubes_a_fleur_ne_perdent_rien<R: Reel>() {
    const COTE: usize = 6;
    let (mut trous, mut cubes, mut le_long) = (0.0_f64, 0, 0);
    let faire = |alea: &mut Hasard| {
        let angles = direction(alea) * *alea.choix(&[0.0, 3.0]);
        let tour = Rotation::<R>::new(arrondi(angles)).unwrap();
        let loin = *alea.choix(&[0.0, 1.0, 30.0]);
        let centre = direction(alea) * loin;
        let axes = tour.axes().map(Vecteur::vers_f64);
        let place = |p: [f64; 3]| {
            let [a, b, c] = p.map(|x| 0.25 * x - 0.75);
            centre + axes[0] * a + axes[1] * b + axes[2] * c
        };
        let mut objets = vec![];
        for i in 0..COTE.pow(3) {
            let p = [i % COTE, i / COTE % COTE, i / COTE.pow(2)].map(|i| i as f64 + 0.5);
            objets.push(boite(arrondi(place(p)), v(0.25, 0.25, 0.25), tour));
        }
        let rayons = alea.liste(60, |alea, _| {
            let mut source = [(); 3].map(|()| entre(alea, -2.0, 8.0));
            let mut cible = [(); 3].map(|()| entre(alea, 1.0, 5.0));
            // The ray goes towards a point of the grid, along a plane or along an edge.
            for axe in 0..alea.usize(0..4) {
                cible[axe] = cible[axe].round();
                if alea.bool() {
                    source[axe] = cible[axe];
                }
            }
            let (source, cible) = (arrondi::<R>(place(source)), arrondi(place(cible)));
            (Rayon::new(source, cible - source), alea.bool())
        });
        (objets, loin, rayons)
    };
    pour_chaque(60, faire, |(objets, loin, rayons)| {
        let (monde, mut liste) = (avec_arbre(&objets), vec![]);
        let milieux = vec![milieu(0, 1.0); objets.len()];
        // Each face is where it should be to some roundings of its place, and a chord ends there to some more. A ray
        // that runs along a plane of the grid sees such a gap at a small angle, and then belongs to neither side.
        let permis = 100.0 * u::<R>() * (loin + 3.0);
        for (rayon, dedans) in rayons {
            let Ok(rayon) = rayon else { continue };
            let rayon = if dedans {
                Rayon::new(rayon.point(R::UN), rayon.direction()).unwrap()
            } else {
                rayon
            };
            cordes(&monde, &rayon, &mut liste);
            let de_face =
                |axe: Vecteur<R>| axe.produit_scalaire(rayon.direction()).absolu().vers_f64();
            let ObjetRay::Boite(cube) = objets[0] else { unreachable!("made as a box") };
            let rase = cube.normales().map(de_face).into_iter().any(|v| v < 0.01);
            let mut fin = liste.first().map_or(R::ZERO, |corde: &Corde<R>| corde.de).vers_f64();
            for corde in &liste {
                if !rase {
                    trous = trous.max((corde.de.vers_f64() - fin) / permis);
                }
                fin = fin.max(corde.a.vers_f64());
            }
            le_long += u32::from(rase);
            let mut lumiere = Lumiere { rayon, dans: vec![] };
            monde.contenants(rayon.source(), |i| lumiere.dans.push(i));
            let mut vus = lumiere.dans.clone();
            let mut pas = 0;
            while lumiere.avancer(&monde, &milieux).unwrap() {
                vus.extend(&lumiere.dans);
                pas += 1;
                assert!(pas < 200, "{rayon:?} does not come out");
            }
            for corde in liste.iter().filter(|c| !rase && (c.a - c.de).vers_f64() > 100.0 * permis)
            {
                assert!(vus.contains(&corde.indice), "{corde:?} of {rayon:?}");
                cubes += 1;
            }
        }
    });
    assert!(trous < 1.0 && cubes > 10_000 && le_long > 100, "{trous} {cubes} {le_long}");
}

en_f32_et_f64!(des_cubes_a_fleur_ne_perdent_rien);

/// Each length counts once where chords overlap: a ray in faces or along edges of voxels gets the way through.
fn des_cordes_sans_recouvrement_comptent_une_fois<R: Reel>() {
    let corde = |(indice, de, a): (usize, f64, f64)| {
        let [de, a] = [de, a].map(R::depuis_f64);
        Corde { indice, de, a }
    };
    let mut liste = [(0, 0.0, 3.0), (1, 1.0, 2.0), (2, 2.0, 5.0), (3, 7.0, 8.0), (4, 7.0, 8.0)]
        .map(corde)
        .to_vec();
    sans_recouvrement(&mut liste);
    assert_eq!(liste, [(0, 0.0, 3.0), (2, 3.0, 5.0), (3, 7.0, 8.0)].map(corde));
    let cube = |i: usize| {
        let [x, y, z] = [i % 4, i / 4 % 4, i / 16].map(|k| k as f64 + 0.5);
        boite::<R>(v(x, y, z), v(1.0, 1.0, 1.0), Rotation::IDENTITE)
    };
    let objets: Vec<_> = (0..64).map(cube).collect();
    for (y, z, cordes_d_avant) in [(1.5, 2.5, 4), (2.0, 2.5, 8), (2.0, 1.0, 16)] {
        let rayon = Rayon::new(v::<R>(-1.0, y, z), Vecteur::X).unwrap();
        cordes(&avec_arbre(&objets), &rayon, &mut liste);
        assert_eq!(liste.len(), cordes_d_avant);
        sans_recouvrement(&mut liste);
        let total: f64 = liste.iter().map(|corde| (corde.a - corde.de).vers_f64()).sum();
        assert_eq!((total, liste.len()), (4.0, 4));
    }
}

en_f32_et_f64!(des_cordes_sans_recouvrement_comptent_une_fois);

/// A half-space and solids about the source: what a ray starts in, what it enters, and where it ends.
fn une_corde_va_de_l_entree_a_la_sortie<R: Reel>() {
    let objets = [
        mur(v(0.0, 0.0, 0.0), Vecteur::Y),
        sphere(v(0.0, 5.0, 0.0), R::UN),
        boite(v(0.0, -3.0, 0.0), v(2.0, 2.0, 2.0), Rotation::IDENTITE),
    ];
    let monde = Monde::de_liste(&objets);
    let de = |y: f64, vers: f64, fin: f64| {
        let mut liste = vec![];
        let rayon = Rayon::new(v(0.0, y, 0.0), v(0.0, vers, 0.0)).unwrap();
        let rayon = rayon.jusqu_a(R::depuis_f64(fin)).unwrap();
        // The δ of a ray changes nothing, since no chord begins twice.
        let mut autre = vec![];
        cordes(&monde, &rayon.avec_flou(R::depuis_f64(0.01)).unwrap(), &mut autre);
        cordes(&monde, &rayon, &mut liste);
        assert_eq!(liste, autre);
        let lire = |corde: &Corde<R>| (corde.indice, corde.de.vers_f64(), corde.a.vers_f64());
        liste.iter().map(lire).collect::<Vec<_>>()
    };
    let sans_fin = f64::INFINITY;
    assert_eq!(de(9.0, -1.0, sans_fin), [(1, 3.0, 5.0), (0, 9.0, sans_fin), (2, 11.0, 13.0)]);
    assert_eq!(de(9.0, -1.0, 12.0), [(1, 3.0, 5.0), (0, 9.0, 12.0), (2, 11.0, 12.0)]);
    assert_eq!(de(-3.0, 1.0, sans_fin), [(0, 0.0, 3.0), (2, 0.0, 1.0), (1, 7.0, 9.0)]);
    assert_eq!(de(-3.0, 1.0, 0.5), [(0, 0.0, 0.5), (2, 0.0, 0.5)]);
    // From a surface outward a ray is in nothing, and inward it is in what it goes through.
    assert_eq!(de(0.0, 1.0, 2.0), []);
    assert_eq!(de(0.0, -1.0, 1.0), [(0, 0.0, 1.0)]);
    assert_eq!(de(6.0, 1.0, sans_fin), []);
    assert_eq!(de(6.0, -1.0, 4.0), [(1, 0.0, 2.0)]);
}

en_f32_et_f64!(une_corde_va_de_l_entree_a_la_sortie);

/// A glass of layers stands on a table, all turned alike, at any height, in mist or in the air. Light through the top
/// of the glass finds the table where Snell's law says, whatever rounding makes of the flush faces.
fn un_verre_sur_une_table_dans_la_brume_montre_la_table<R: Reel>() {
    let mut vus = 0;
    let faire = |alea: &mut Hasard| {
        let tour = Rotation::<R>::new(arrondi(direction(alea) * *alea.choix(&[0.0, 3.0]))).unwrap();
        let [x, y, z] = tour.axes().map(Vecteur::vers_f64);
        let pied = y * *alea.choix(&[0.0, 0.3, 7.0]) + x * entre(alea, -1.0, 1.0);
        let lieux = alea.liste(40, |alea, _| {
            let [a, b, c, d] = [(); 4].map(|()| entre(alea, -0.4, 0.4));
            (pied + y * 1.5 + x * a + z * b, x * c + z * d - y)
        });
        (tour, pied, lieux, alea.bool(), 1 + alea.tour % 3)
    };
    pour_chaque(200, faire, |(tour, pied, lieux, brume, couches)| {
        let y = tour.axes()[1].vers_f64();
        let haut = 1.5 / couches as f64;
        let couche = |i: usize| {
            let milieu = pied + y * (haut * (i as f64 + 0.5));
            boite::<R>(arrondi(milieu), arrondi(Vecteur::new(4.0, haut, 4.0)), tour)
        };
        let mut objets: Vec<_> = (0..couches).map(couche).collect();
        let indice = |i: usize| [1.5, 1.33, 1.8][i % 3];
        let mut milieux: Vec<_> = (0..couches).map(|i| milieu(1, indice(i))).collect();
        if brume {
            objets.push(sphere(Vecteur::NUL, R::depuis_f64(50.0)));
            milieux.push(milieu(0, 1.0));
        }
        let table = objets.len();
        objets.push(mur(arrondi(pied), arrondi(y)));
        let monde = Monde::de_liste(&objets);
        for (cible, d) in lieux {
            let d = d.unitaire().unwrap();
            let rayon = Rayon::new(arrondi::<R>(cible - d), arrondi(d)).unwrap();
            let mut lumiere = Lumiere { rayon, dans: vec![] };
            monde.contenants(rayon.source(), |i| lumiere.dans.push(i));
            let mut faces = 0;
            let touche = loop {
                match lumiere.surface(&monde, &milieux).unwrap() {
                    Some(Surface::Opaque(touche, distance)) => {
                        let depuis = touche.point().vers_f64() - lumiere.rayon.source().vers_f64();
                        let ecart = (distance.vers_f64() - depuis.longueur()).abs();
                        assert!(ecart < 2_000.0 * u::<R>() * (1.0 + pied.longueur()), "{ecart:e}");
                        break touche;
                    }
                    autre => assert!(autre.is_some() && faces < couches + 1, "{rayon:?}"),
                }
                assert!(lumiere.avancer(&monde, &milieux).unwrap());
                faces += 1;
            };
            assert_eq!((touche.indice(), faces), (table, couches), "{rayon:?}");
            let sinus = (d + y * -d.produit_scalaire(y)).longueur();
            let travers = (d + y * -d.produit_scalaire(y)) / sinus;
            let recul = |i: usize| haut * (sinus / indice(i)).asin().tan();
            let attendu = cible - y * 1.5 + travers * (0..couches).map(recul).sum::<f64>();
            let ecart = (touche.point().vers_f64() - attendu).longueur();
            assert!(ecart < 2_000.0 * u::<R>() * (1.0 + pied.longueur()), "{ecart:e}");
            vus += 1;
        }
    });
    assert_eq!(vus, 8_000);
}

en_f32_et_f64!(un_verre_sur_une_table_dans_la_brume_montre_la_table);

/// From within glass, at angles that the air would mirror, light finds the floor on which the glass stands flush, even
/// if the floor is a box a thousand times as large, which knows its place less well. The hit knows the δ of the light.
fn du_verre_la_lumiere_trouve_son_pied<R: Reel>() {
    let faire = |alea: &mut Hasard| {
        let large = *alea.choix(&[1.0, 10.0, 1000.0]);
        let (cote, cosinus) = (entre(alea, 0.05, 0.3), entre(alea, 0.05, 0.6));
        let angle = entre(alea, -3.0, 3.0);
        let sinus = (1.0 - cosinus * cosinus).sqrt();
        let d = Vecteur::new(sinus * angle.cos(), -cosinus, sinus * angle.sin());
        let cible = [(); 2].map(|()| entre(alea, -0.4, 0.4) * cote);
        (large, cote, d, cible, alea.bool())
    };
    pour_chaque(3_000, faire, |(large, cote, d, [x, z], plan)| {
        let verre = boite::<R>(v(0.0, cote / 2.0, 0.0), v(cote, cote, cote), Rotation::IDENTITE);
        let sol = if plan {
            mur(Vecteur::NUL, Vecteur::Y)
        } else {
            boite(v(0.0, -large / 2.0, 0.0), v(large, large, large), Rotation::IDENTITE)
        };
        let objets = [verre, sol];
        let source = Vecteur::new(x, 0.0, z) - d * (0.05 * cote);
        let rayon = Rayon::new(arrondi::<R>(source), arrondi(d)).unwrap();
        let flou = R::depuis_f64(1e-6);
        let mut lumiere = Lumiere { rayon: rayon.avec_flou(flou).unwrap(), dans: vec![0] };
        match lumiere.surface(&Monde::de_liste(&objets), &[milieu(0, 1.5)]).unwrap() {
            Some(Surface::Opaque(touche, distance)) => {
                let depuis = (touche.point() - rayon.source()).longueur();
                assert!(
                    (distance - depuis).absolu() < R::depuis_f64(1e-5) * depuis,
                    "{distance:?}"
                );
                assert_eq!((touche.indice(), touche.normale()), (1, Vecteur::Y));
                assert!(touche.reflechi(rayon.direction()).unwrap().flou() > flou);
            }
            autre => panic!("{autre:?}: {rayon:?}"),
        }
    });
    // Light that has an end, as on its way to a lamp, leaves no medium.
    let objets = [
        boite::<R>(Vecteur::NUL, v(20.0, 20.0, 20.0), Rotation::IDENTITE),
        sphere(v(2.0, 0.3, 0.0), R::UN),
    ];
    let rayon = Rayon::new(Vecteur::NUL, Vecteur::X).unwrap();
    for fin in [0.5, 5.0] {
        let rayon = rayon.jusqu_a(R::depuis_f64(fin)).unwrap();
        let mut lumiere = Lumiere { rayon, dans: vec![0] };
        let milieux = [milieu(0, 1.33), milieu(1, 1.5)];
        let surface = lumiere.surface(&Monde::de_liste(&objets), &milieux).unwrap();
        assert_eq!((surface.is_some(), &lumiere.dans[..]), (fin > 1.0, &[0][..]));
    }
    // Light that goes up from the surface of water is not in the water.
    let eau = [mur::<R>(Vecteur::NUL, Vecteur::Y)];
    let rayon = Rayon::new(Vecteur::NUL, v(0.6, 0.8, 0.0)).unwrap();
    let mut lumiere = Lumiere { rayon, dans: vec![0] };
    assert!(lumiere.surface(&Monde::de_liste(&eau), &[milieu(0, 1.33)]).unwrap().is_none());
    assert_eq!(lumiere.dans, []);
}

en_f32_et_f64!(du_verre_la_lumiere_trouve_son_pied);
