//! A floor at y = 0, with which every scene begins. Its points under things are dark, and nothing that starts there is
//! a subnormal number, which a turned floor may give.

use commun::fabrique::{avec_arbre, boite, boite_droite, mur, sphere, v};
use commun::hasard::{Hasard, pour_chaque};
use commun::regimes::entre;
use commun::scenes::rayons_camera;
use commun::{arrondi, en_f32_et_f64};
use lancer_rayon::{Monde, ObjetRay, Rayon, Reel, Rotation, Vecteur};

/// Points along each side of the floor.
const GRILLE: u32 = 200;

/// A floor, as a half-space or the top of a slab, with things that stand on it.
fn scene<R: Reel>(dalle: bool) -> Vec<ObjetRay<R>> {
    let alea = &mut Hasard::de_graine(61);
    let sol = if dalle {
        boite_droite(v(0.0, -0.25, 0.0), v(20.0, 0.5, 20.0))
    } else {
        mur(Vecteur::NUL, v(0.0, 1.0, 0.0))
    };
    let mut objets = vec![sol];
    for i in 1..40 {
        let (x, z) = (entre(alea, -9.0, 9.0), entre(alea, -9.0, 9.0));
        let haut = entre(alea, 0.1, 1.5);
        objets.push(if i % 2 == 0 {
            sphere(v(x, 0.3 * haut, z), R::depuis_f64(haut))
        } else {
            let tour = Rotation::new(v(0.0, entre(alea, 0.0, 1.5), 0.0)).unwrap();
            let cotes = v(entre(alea, 0.3, 2.0), haut, entre(alea, 0.3, 2.0));
            boite(v(x, haut / 2.0, z), cotes, tour)
        });
    }
    objets
}

/// The recipe of the documents: whether the lamp shines on a point, and whether it would if nobody asked what holds the
/// start.
fn eclaire<R: Reel>(monde: &Monde<'_, R>, point: Vecteur<R>, lampe: Vecteur<R>) -> [bool; 2] {
    let haut = Vecteur::new(R::ZERO, R::UN, R::ZERO);
    let rayon = Rayon::new(point + haut, -haut).unwrap();
    let touche = monde.objets()[0].intersection(&rayon).unwrap();
    let ombre = touche.vers_lumiere(lampe).unwrap();
    let dessous = monde.contient(ombre.source());
    assert_eq!(dessous, monde.objets().iter().any(|objet| objet.contient(ombre.source())));
    let libre = !monde.est_occulte(&ombre);
    [!dessous && libre, libre]
}

/// How deep a point is under things, in scene units; below 0 where it is beside them all.
fn sous<R: Reel>(objets: &[ObjetRay<R>], [x, z]: [f64; 2]) -> f64 {
    let profondeur = |objet: &ObjetRay<R>| match objet {
        ObjetRay::Sphere(s) => {
            let c = s.centre().vers_f64();
            s.rayon().vers_f64() - (c - Vecteur::new(x, 0.0, z)).longueur()
        }
        ObjetRay::Boite(b) => {
            let depuis = Vecteur::new(x, 0.0, z) - b.centre().vers_f64();
            let (n, l) = (b.normales().map(Vecteur::vers_f64), b.demi_longueurs().map(R::vers_f64));
            [0, 2]
                .map(|i| l[i] - n[i].produit_scalaire(depuis).abs())
                .into_iter()
                .fold(9.0, f64::min)
        }
        ObjetRay::Plan(_) => f64::NEG_INFINITY,
    };
    objets[1..].iter().map(profondeur).fold(f64::NEG_INFINITY, f64::max)
}

fn sous_un_objet_il_fait_sombre<R: Reel>() {
    for dalle in [false, true] {
        let objets = scene::<R>(dalle);
        let monde = avec_arbre(&objets);
        let lampe = arrondi(Vecteur::new(-6.0, 9.0, 4.0));
        let (mut sombres, mut naifs, mut clairs) = (0, 0, 0);
        for i in 0..GRILLE * GRILLE {
            let ou =
                [i % GRILLE, i / GRILLE].map(|k| f64::from(k) * 18.0 / f64::from(GRILLE) - 9.0);
            let point = arrondi(Vecteur::new(ou[0], 0.0, ou[1]));
            let [clair, naif] = eclaire(&monde, point, lampe);
            // Near the side of a thing rounding decides.
            let dessous = sous(&objets, ou);
            if dessous > 1e-5 {
                assert!(!clair, "lit under something: {ou:?}");
                sombres += 1;
                naifs += u32::from(naif);
            } else if dessous < -1e-5 {
                assert_eq!(clair, naif, "{ou:?}");
                clairs += u32::from(clair);
            }
        }
        println!("{sombres} under things, {naifs} of them lit at first, {clairs} lit");
        assert!(naifs > sombres / 2 && clairs > 10 * GRILLE);
    }
}

en_f32_et_f64!(sous_un_objet_il_fait_sombre);

/// A sensor in the air, a hundredth of a rounding above the floor, and a lamp. From the sensor, as the documents
/// advise, nothing stands between them; from the lamp, rounding puts some sensors behind the floor.
fn un_capteur_au_ras_du_sol_voit_la_lampe<R: Reel>() {
    let sol = &scene::<R>(false)[..1];
    let voit = |de: Vecteur<R>, vers: Vecteur<R>| {
        let rayon = Rayon::entre(de, vers).unwrap();
        !Monde::de_liste(sol).est_occulte(&rayon)
    };
    let mut depuis_la_lampe = 0;
    let faire = |alea: &mut Hasard| {
        let mut lieu = |haut| Vecteur::new(entre(alea, -5.0, 5.0), haut, entre(alea, -5.0, 5.0));
        [arrondi::<R>(lieu(0.01 * R::U.vers_f64())), arrondi(lieu(2.5))]
    };
    let tous = GRILLE * GRILLE;
    pour_chaque(tous, faire, |[capteur, lampe]| {
        assert!(voit(capteur, lampe));
        depuis_la_lampe += u32::from(voit(lampe, capteur));
    });
    assert!((tous / 2..tous - tous / 100).contains(&depuis_la_lampe));
}

en_f32_et_f64!(un_capteur_au_ras_du_sol_voit_la_lampe);

/// Whether this number is subnormal, for which processors take up to a hundred times as long.
fn sous_normal<R: Reel>(x: R) -> bool {
    let normal = if size_of::<R>() == 4 { f32::MIN_POSITIVE.into() } else { f64::MIN_POSITIVE };
    x != R::ZERO && x.absolu().vers_f64() < normal
}

/// Margins, starts, directions and distances over a floor, a wall and a slab through O and the axes.
fn au_sol_rien_n_est_sous_normal<R: Reel>() {
    let lampe = arrondi(Vecteur::new(-2.0, 3.0, 4.0));
    let mut vus = 0;
    for dalle in [false, true] {
        let mut objets = scene::<R>(dalle);
        let [x, y] = [Vecteur::<R>::X, Vecteur::Z];
        for n in [x, y] {
            objets.push(mur(n * R::depuis_f64(-9.0), n));
        }
        let penche = mur(Vecteur::NUL, x + y);
        for scene in [objets.clone(), vec![objets[0], penche]] {
            let monde = avec_arbre(&scene);
            for rayon in rayons_camera::<R>(60, 40) {
                let Ok(touche) = monde.premiere_intersection(&rayon) else { continue };
                let (d, n) = (rayon.direction(), touche.normale());
                let reflet = d - n * (d.produit_scalaire(n) * R::depuis_f64(2.0));
                let reflet = touche.secondaire(reflet).unwrap();
                let mut nombres = vec![touche.marge(), touche.distance()];
                nombres.extend(<[R; 3]>::from(reflet.source()));
                nombres.extend(monde.premiere_intersection(&reflet).ok().map(|t| t.distance()));
                if let Ok(ombre) = touche.vers_lumiere(lampe) {
                    nombres.extend(<[R; 3]>::from(ombre.direction()));
                    nombres.push(ombre.fin());
                }
                assert!(!nombres.iter().copied().any(sous_normal), "{nombres:?} {rayon:?}");
                vus += 1;
            }
        }
    }
    assert!(vus > 4_000, "{vus}");
}

en_f32_et_f64!(au_sol_rien_n_est_sous_normal);

/// For a floor through O that is turned by less than 2⁻²⁶ (`f64`: 2⁻¹²²), and a point that is exactly O, no margin is
/// subnormal, but a coordinate of the start is.
fn au_sol_tourne_un_depart_est_sous_normal<R: Reel>() {
    let peu = if size_of::<R>() == 4 { -27.0_f64 } else { -123.0 };
    for (pente, attendu) in [(peu.exp2(), true), ((peu + 2.0).exp2(), false), (0.0, false)] {
        let n = v(-pente, -1.0, 0.0);
        let sol: ObjetRay<R> = mur(Vecteur::NUL, n);
        let source = Vecteur::new(R::ZERO, -R::UN, R::ZERO);
        let rayon = Rayon::new(source, -source).unwrap();
        let touche = sol.intersection(&rayon).unwrap();
        assert_eq!((touche.point(), touche.normale()), (Vecteur::NUL, n));
        let depart = touche.secondaire(n).unwrap().source();
        assert!(!sous_normal(touche.marge()));
        assert_eq!(<[R; 3]>::from(depart).into_iter().any(sous_normal), attendu, "{depart:?}");
    }
}

en_f32_et_f64!(au_sol_tourne_un_depart_est_sous_normal);
