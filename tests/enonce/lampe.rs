//! A lamp that is an object of the list is left out: no distance is exact enough to stop just before it.

use commun::fabrique::{avec_arbre, boite, mur, sphere};
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::oracle::Exact;
use commun::regimes::{direction, entre, signe};
use commun::tolerances::u;
use commun::{arrondi, en_f32_et_f64};
use lancer_rayon::{Monde, ObjetRay, Rayon, Reel, Rotation, Vecteur};

/// A point of a lamp, and its outward normal there.
type Lumineux = (Vecteur, Vecteur);

/// A number near 1, or nearer and nearer.
fn vers_un(alea: &mut Hasard) -> f64 {
    1.0 - (-f64::from(alea.u8(0..50)) * alea.f64()).exp2()
}

/// A point of the surface of this lamp: anywhere, or near to its silhouette as seen from `s`.
fn lumineux<R: Reel>(lampe: &ObjetRay<R>, s: Vecteur, alea: &mut Hasard) -> Lumineux {
    match lampe {
        ObjetRay::Sphere(sphere) => {
            let vers = (s - sphere.centre().vers_f64()).unitaire().unwrap();
            let n = direction(alea);
            let travers = (n - vers * n.produit_scalaire(vers)).unitaire().unwrap();
            let sin = vers_un(alea);
            let n = if alea.bool() { n } else { travers * sin + vers * (1.0 - sin * sin).sqrt() };
            (sphere.centre().vers_f64() + n * sphere.rayon().vers_f64(), n)
        }
        ObjetRay::Plan(plan) => {
            let n = plan.normale().vers_f64();
            let x = direction(alea) * 20.0;
            let haut = n.produit_scalaire(x) + plan.distance().vers_f64();
            (x - n * haut, n)
        }
        ObjetRay::Boite(boite) => {
            let (axe, l) = (alea.usize(0..3), boite.demi_longueurs().map(R::vers_f64));
            let normales = boite.normales().map(Vecteur::vers_f64);
            let mut parts = [(); 3].map(|()| signe(alea) * vers_un(alea));
            parts[axe] = parts[axe].signum();
            let depuis: Vecteur = (0..3).map(|i| normales[i] * (l[i] * parts[i])).sum();
            (boite.centre().vers_f64() + depuis, normales[axe] * parts[axe])
        }
    }
}

/// A lamp of each shape beside a ball and a box, which it shines on from anywhere.
fn lampes<R: Reel>(alea: &mut Hasard) -> [ObjetRay<R>; 3] {
    let mut place = || arrondi::<R>(direction(alea) * entre(alea, 4.0, 12.0));
    let (centre, dimensions) = (place(), arrondi(Vecteur::new(1.5, 0.1, 0.7)));
    let boule = sphere(place(), R::depuis_f64(0.8));
    let point = place();
    let plan = mur(point, -point);
    [boule, plan, boite(centre, dimensions, Rotation::new(place()).unwrap())]
}

/// The ball or the box at the origin stands before the lamp where the lamp's own face turns away or N·L ≤ 0,
/// and nowhere else: both are convex. So with the lamp left out the recipe sees every point of it that faces the
/// start, however near to the silhouette; and a screen hides what it hides of a list without the lamp.
fn un_point_voit_la_lampe_qui_lui_fait_face<R: Reel>() {
    let mut vus = [0; 3];
    let (mut caches, mut derriere) = (0, 0);
    // A lamp, what it shines on, a screen, and shadow rays to the lamp.
    let faire = |alea: &mut Hasard| {
        let tour = Rotation::new(arrondi::<R>(direction(alea))).unwrap();
        let cotes = arrondi(Vecteur::new(2.0, 1.0, 1.5));
        let recepteurs: [ObjetRay<R>; 2] =
            [sphere(Vecteur::NUL, R::UN), boite(Vecteur::NUL, cotes, tour)];
        let recepteur = *alea.choix(&recepteurs);
        let forme = alea.tour % 3;
        let lampe = lampes::<R>(alea)[forme];
        let centre = arrondi(direction(alea) * entre(alea, 2.0, 3.5));
        let ecran = sphere(centre, R::depuis_f64(0.9));
        let ombres = alea.liste(200, |alea, _| {
            let oeil = arrondi(direction(alea) * 3.0);
            let vers = arrondi::<R>(direction(alea) * 0.8) - oeil;
            let rayon = Rayon::new(oeil, vers).ok()?;
            let touche = recepteur.intersection(&rayon).ok()?;
            let (q, n) = lumineux(&lampe, touche.point().vers_f64(), alea);
            let ombre = touche.vers_lumiere(arrondi(q)).ok()?;
            (ombre.direction().produit_scalaire(arrondi(n)) < R::ZERO).then_some(ombre)
        });
        let ombres: Vec<_> = ombres.into_iter().flatten().collect();
        (forme, lampe, recepteur, ecran, ombres)
    };
    pour_chaque(240, faire, |(forme, lampe, recepteur, ecran, ombres)| {
        vus[forme] += ombres.len() as u32;
        let par_elle = |ombre: &&Rayon<R>| Monde::de_liste(&[lampe]).est_occulte(ombre);
        caches += ombres.iter().filter(par_elle).count() as u32;
        // As a list, and among copies of what hides nothing that make it a tree.
        for copies in [1, 126] {
            let mut objets = vec![lampe, ecran];
            objets.extend([recepteur].repeat(copies));
            let monde = avec_arbre(&objets);
            let mut occultes = vec![false; ombres.len()];
            monde.sans(0).sont_occultes(&ombres, &mut occultes).unwrap();
            for (ombre, occulte) in ombres.iter().zip(occultes) {
                let attendu = Monde::de_liste(&[ecran]).est_occulte(ombre);
                assert_eq!(occulte, attendu, "{objets:?} {ombre:?}");
                derriere += u32::from(occulte);
            }
        }
    });
    assert!(vus.iter().all(|n| *n > 1_000), "{vus:?} seen");
    // Distances would have hidden these.
    assert!(caches > vus.iter().sum::<u32>() / 10, "only {caches} hidden by their own lamp");
    assert!(derriere > 1_000, "only {derriere} behind the screen");
}

en_f32_et_f64!(un_point_voit_la_lampe_qui_lui_fait_face);

/// What `vers_lumiere` says of its ray, beside the exact vector from the start to the lamp: the row of
/// `docs/precision.md`.
fn la_distance_et_la_direction_d_une_lampe_sont_bornees<R: Reel>() {
    let boule: ObjetRay<R> = sphere(Vecteur::NUL, R::UN);
    let mut juges = 0;
    let faire = |alea: &mut Hasard| {
        let n = direction(alea);
        let loin = entre(alea, -12.0, 12.0).exp2();
        (n, arrondi::<R>(n + (n + direction(alea)) * loin))
    };
    pour_chaque(5_000, faire, |(n, lampe)| {
        let Ok(rayon) = Rayon::new(arrondi(n * 3.0), arrondi(-n)) else { return };
        let Ok(touche) = boule.intersection(&rayon) else { return };
        let Ok(ombre) = touche.vers_lumiere(lampe) else { return };
        let (s, l) = (<[R; 3]>::from(ombre.source()), <[R; 3]>::from(lampe));
        let v: [Exact; 3] = core::array::from_fn(|i| &Exact::de(l[i]) - &Exact::de(s[i]));
        let carre = &(&(&v[0] * &v[0]) + &(&v[1] * &v[1])) + &(&v[2] * &v[2]);
        let longueur = carre.vers_f64().sqrt();
        // d² − |V|², exactly, over 2|V|.
        let d = Exact::de(ombre.fin());
        let ecart = (&(&d * &d) - &carre).vers_f64() / (2.0 * longueur);
        let permis = 3.6 * u::<R>() * longueur + R::MIN_POSITIF.vers_f64();
        assert!(ecart.abs() <= permis, "{ecart:e} of {longueur}: {ombre:?}");
        // |V| is good to 1.5u of `f64`, each coordinate of V to u, and so are the products and the differences.
        let essai = 5.0 * u::<f64>();
        let exacte = Vecteur::from(v.each_ref().map(Exact::vers_f64));
        let ecart = (ombre.direction().vers_f64() * longueur - exacte).longueur() / longueur;
        assert!(ecart <= 4.6 * u::<R>() + essai, "{ecart:e}: {ombre:?}");
        let n = <[R; 3]>::from(touche.normale()).map(Exact::de);
        let nv = &(&(&n[0] * &v[0]) + &(&n[1] * &v[1])) + &(&n[2] * &v[2]);
        let cosinus = ombre.direction().produit_scalaire(touche.normale()).vers_f64();
        let ecart = (cosinus - nv.vers_f64() / longueur).abs();
        assert!(ecart <= 8.0 * u::<R>() + essai, "{ecart:e}: {ombre:?}");
        juges += 1;
    });
    assert!(juges > 3_000, "{juges} judged");
}

en_f32_et_f64!(la_distance_et_la_direction_d_une_lampe_sont_bornees);
