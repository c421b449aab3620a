//! Light through media, and the chords of a straight ray, by the recipe `milieux`. The judge is interval arithmetic
//! along a line: for each object as it is stored, in `f64`, where the line is surely in it and where surely not. It
//! knows nothing of faces that are flush, on which closed forms stand at the end.

use commun::fabrique::{avec_arbre, boite, mur, murs, sphere, v};
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::regimes::{direction, entre};
use commun::tolerances::u;
use commun::{arrondi, cas, en_f32_et_f64};
use lancer_rayon::{Monde, ObjetRay, Rayon, Reel, Rotation, Vecteur};
use recettes::milieux::{Corde, Derriere, Marche, Matiere};
use recettes::particule;
use recettes::verre::au_fond;

const PLEIN_AIR: f64 = 1.0;

fn pleine(priorite: u32, indice: f64) -> Matiere {
    Matiere::Pleine { priorite, indice }
}

/// Where this line, S + tD with a unit D, is in the object if that is grown by `plus` on all sides.
fn part<R: Reel>(objet: &ObjetRay<R>, [s, d]: [Vecteur; 2], plus: f64) -> Option<[f64; 2]> {
    let tout = [f64::NEG_INFINITY, f64::INFINITY];
    let [de, a] = match objet {
        ObjetRay::Sphere(boule) => {
            let vers = boule.centre().vers_f64() - s;
            let milieu = vers.produit_scalaire(d);
            let r = (boule.rayon().vers_f64() + plus).max(0.0);
            let carre = r * r - (vers - d * milieu).longueur_carree();
            (carre > 0.0).then(|| [milieu - carre.sqrt(), milieu + carre.sqrt()])?
        }
        ObjetRay::Plan(plan) => {
            let n = plan.normale().vers_f64();
            let haut = n.produit_scalaire(s) + plan.distance().vers_f64() - plus;
            match n.produit_scalaire(d) {
                0.0 => (haut <= 0.0).then_some(tout)?,
                monte if monte > 0.0 => [f64::NEG_INFINITY, -haut / monte],
                descend => [-haut / descend, f64::INFINITY],
            }
        }
        ObjetRay::Boite(boite) => {
            let vers = s - boite.centre().vers_f64();
            let faces = boite.normales().into_iter().zip(boite.demi_longueurs());
            faces.fold(tout, |[de, a], (n, l)| {
                let (n, l) = (n.vers_f64(), l.vers_f64() + plus);
                let (ou, vitesse) = (n.produit_scalaire(vers), n.produit_scalaire(d));
                if vitesse == 0.0 {
                    return if ou.abs() <= l { [de, a] } else { [1.0, 0.0] };
                }
                let [x, y] = [(-l - ou) / vitesse, (l - ou) / vitesse];
                [de.max(x.min(y)), a.min(x.max(y))]
            })
        }
    };
    (de < a).then_some([de, a])
}

/// The object whose medium counts in all of these, by the description of `Matiere`.
fn compte(matieres: &[Matiere], dans: &[bool]) -> Option<usize> {
    let mut premier: Option<(u32, usize)> = None;
    for (i, matiere) in matieres.iter().enumerate() {
        let rang = match *matiere {
            Matiere::Pleine { priorite, .. } if dans[i] => priorite,
            Matiere::Commune { avec, priorite, .. } if dans[i] && dans[avec] => priorite,
            Matiere::Opaque | Matiere::Pleine { .. } | Matiere::Commune { .. } => continue,
        };
        if premier.is_none_or(|(autre, _)| rang >= autre) {
            premier = Some((rang, i));
        }
    }
    premier.map(|(_, i)| i)
}

/// A scene as light finds it, and how far anything may be beside its place.
#[derive(Debug)]
struct Scene<R> {
    objets: Vec<ObjetRay<R>>,
    matieres: Vec<Matiere>,
    tour: Rotation<R>,
    centre: Vecteur,
    ecart: f64,
}

impl<R: Reel> Scene<R> {
    fn opaque(&self, i: usize) -> bool {
        self.matieres.get(i).is_none_or(|matiere| *matiere == Matiere::Opaque)
    }

    /// Whether the line is nowhere between these distances surely in another medium than the one that `dit` names
    /// there, or in an opaque thing that does not hold the start. Returns how much of it was sure.
    #[track_caller]
    fn juger(
        &self,
        ligne: [Vecteur; 2],
        [de, a]: [f64; 2],
        dit: impl Fn(f64) -> Option<usize>,
    ) -> f64 {
        let parts = |plus: f64| {
            let part = |objet| part(objet, ligne, plus).unwrap_or([1.0, 0.0]);
            self.objets.iter().map(part).collect::<Vec<_>>()
        };
        let (larges, etroites) = (parts(self.ecart), parts(-self.ecart));
        let bords = larges.iter().chain(&etroites).flatten().copied();
        let mut bords: Vec<_> = bords.chain([de, a]).filter(|t| (de..=a).contains(t)).collect();
        bords.sort_by(f64::total_cmp);
        let mut sur = 0.0;
        for bord in bords.windows(2) {
            let t = bord[0].midpoint(bord[1]);
            let contient = |[de, a]: [f64; 2]| de <= t && t <= a;
            let dans: Vec<_> = etroites.iter().map(|&part| contient(part)).collect();
            if larges.iter().zip(&dans).any(|(&large, &dans)| contient(large) && !dans) {
                continue;
            }
            let mur = (0..dans.len()).find(|&i| dans[i] && self.opaque(i));
            let du_depart = |i: usize| larges[i][0] <= 0.0;
            assert!(mur.is_none_or(du_depart), "in the opaque {mur:?} at {t} of {ligne:?}");
            assert_eq!(dit(t), compte(&self.matieres, &dans), "at {t} of {ligne:?}: {dans:?}");
            sur += bord[1] - bord[0];
        }
        sur
    }

    /// Whether this place is on the surface of the object, and N its normal there.
    fn est_au_bord(&self, i: usize, p: Vecteur, n: Vecteur) -> bool {
        // The line along N comes to the surface here, or goes along N through its corner.
        let pas = 2.0 * self.ecart;
        let ligne = |p| part(&self.objets[i], [p, n], 0.0);
        let sort = ligne(p).is_some_and(|[_, a]| a.abs() <= pas);
        sort || part(&self.objets[i], [p, n], self.ecart).is_some_and(|[_, a]| a.abs() <= 2.0 * pas)
    }
}

/// Scenes of all kinds: things one in another, side by side, in rows, in each other, in or on a half-space; lenses; at
/// O or far from it, turned or straight.
fn scene<R: Reel>(alea: &mut Hasard) -> Scene<R> {
    let angles = direction(alea) * *alea.choix(&[0.0, 3.0]);
    let tour = Rotation::<R>::new(arrondi(angles)).unwrap();
    let axes = tour.axes().map(Vecteur::vers_f64);
    let centre = direction(alea) * *alea.choix(&[0.0, 1.0, 30.0]);
    let place = |[a, b, c]: [f64; 3]| centre + axes[0] * a + axes[1] * b + axes[2] * c;
    let (mut objets, mut matieres) = (vec![], vec![]);
    let matiere = |alea: &mut Hasard| match alea.u8(0..6) {
        0 => Matiere::Opaque,
        _ => pleine(u32::from(alea.u8(0..4)), *alea.choix(&[1.0, 1.33, 1.5, 2.4])),
    };
    let cube = |p, cotes: [f64; 3]| boite::<R>(arrondi(place(p)), arrondi(cotes.into()), tour);
    if alea.bool() {
        objets.push(mur::<R>(arrondi(place([0.0, -1.0, 0.0])), arrondi(axes[1])));
        matieres.push(matiere(alea));
    }
    match alea.u8(0..4) {
        // A phantom: boxes and balls one in another.
        0 => {
            for i in 0..alea.usize(1..6) {
                let r = 2.0 * 0.6_f64.powi(i as i32);
                let p = [(); 3].map(|()| entre(alea, -0.2, 0.2) * r);
                let cotes = [(); 3].map(|()| entre(alea, 1.0, 1.2) * r);
                let boule = sphere(arrondi(place(p)), R::depuis_f64(r));
                objets.push(if alea.bool() { boule } else { cube(p, cotes) });
                matieres.push(matiere(alea));
            }
        }
        // A row of flush panes, upon the half-space if there is one.
        1 => {
            let mut y = -1.0;
            for _ in 0..alea.usize(1..6) {
                let h = entre(alea, 0.1, 0.7);
                objets.push(cube([0.0, y + h / 2.0, 0.0], [2.0, h, 2.0]));
                matieres.push(matiere(alea));
                y += h;
            }
        }
        // Voxels.
        2 => {
            for i in 0..27 {
                let p = [i % 3, i / 3 % 3, i / 9].map(|k| f64::from(k) * 0.7 - 0.7);
                objets.push(cube(p, [0.7; 3]));
                matieres.push(matiere(alea));
            }
        }
        // Anything anywhere.
        _ => {
            for _ in 0..alea.usize(1..8) {
                let p = [(); 3].map(|()| entre(alea, -2.0, 2.0));
                let cotes = [(); 3].map(|()| entre(alea, 0.1, 3.0));
                let boule = sphere(arrondi(place(p)), R::depuis_f64(entre(alea, 0.2, 2.0)));
                objets.push(if alea.bool() { boule } else { cube(p, cotes) });
                matieres.push(matiere(alea));
            }
        }
    }
    // A lens: two balls, thin or thick, perhaps in the middle of all the rest.
    if alea.bool() {
        let (r, mince) = (entre(alea, 1.0, 9.0), entre(alea, 0.1, 0.9));
        let (priorite, indice) = (u32::from(alea.u8(0..5)), 1.5);
        for cote in [1.0, -1.0] {
            let p = place([cote * (r - mince), 0.3, 0.1]);
            objets.push(sphere(arrondi(p), R::depuis_f64(r)));
            let avec =
                matieres.len() + if cote > 0.0 { 1 } else { 0 } - if cote > 0.0 { 0 } else { 1 };
            matieres.push(Matiere::Commune { avec, priorite, indice });
        }
    }
    // Up to thirty rays lie between two starts with δ = 0, and each adds some thirty roundings of such lengths.
    let ecart = 3_000.0 * u::<R>() * (10.0 + centre.longueur());
    Scene { objets, matieres, tour, centre, ecart }
}

/// From nearby, from far away, from within or from a surface, towards the middle or anywhere, some along the axes.
fn depart<R: Reel>(alea: &mut Hasard, scene: &Scene<R>) -> Rayon<R> {
    let axes = scene.tour.axes().map(Vecteur::vers_f64);
    let loin = *alea.choix(&[0.5, 2.0, 5.0, 100.0]);
    let mut source = scene.centre + direction(alea) * loin;
    let mut vers = scene.centre + direction(alea) * 1.5 - source;
    match alea.u8(0..6) {
        0 => vers = direction(alea),
        1 => {
            // Along a plane or an edge of the voxels.
            source =
                scene.centre + (axes[0] * -5.0) + axes[1] * 0.35 + axes[2] * entre(alea, -1.0, 1.0);
            vers = axes[0];
        }
        _ => {}
    }
    let rayon = Rayon::new(arrondi(source), arrondi(vers)).unwrap();
    let objet = alea.choix(&scene.objets);
    match (alea.u8(0..3), objet.traversee(&rayon)) {
        // The surface of an object, as its coordinates round.
        (0, Ok([t, _])) if t.vers_f64() < 200.0 => {
            Rayon::new(rayon.point(t), arrondi(direction(alea))).unwrap()
        }
        _ => rayon,
    }
}

/// How light goes: a step, `None` to the next surface, and whether it then turns, and how.
type Pas = (Option<f64>, Option<Vecteur>);

/// Wherever light goes, straight, bent, mirrored or scattered, it is in the medium that the walk says; it bends where
/// the medium changes, by Snell's law and nowhere else; and stops at no other place than at an opaque thing.
fn la_lumiere_est_dans_le_milieu_que_dit_la_marche<R: Reel>() {
    let [mut passages, mut totales, mut opaques, mut pas_finis, mut pellicules] = [0_u32; 5];
    let mut sur = 0.0;
    let faire = |alea: &mut Hasard| {
        let scene = scene::<R>(alea);
        let chemins = alea.liste(20, |alea, _| {
            let depart = depart(alea, &scene);
            let pas = alea.liste(12, |alea, _| -> Pas {
                let pas = match alea.u8(0..3) {
                    0 => Some(entre(alea, 0.0, 2.0)),
                    1 => Some((-30.0 * alea.f64()).exp2()),
                    _ => None,
                };
                (pas, alea.bool().then(|| direction(alea)))
            });
            (depart, pas)
        });
        (scene, alea.bool(), chemins)
    };
    pour_chaque(cas(250), faire, |(scene, arbre, chemins)| {
        let Scene { objets, matieres, ecart, .. } = &scene;
        let monde = if arbre { avec_arbre(objets) } else { Monde::de_liste(objets) };
        let mut marche = Marche::new(monde, matieres);
        for (rayon, pas) in chemins {
            marche.partir(rayon);
            let mut renvoi = None;
            for (pas, tour) in pas {
                let rayon = marche.rayon();
                let [s, d] = [rayon.source(), rayon.direction()].map(Vecteur::vers_f64);
                let ligne = [s, d.unitaire().unwrap()];
                let surface = marche.avancer(pas.map_or(R::INFINI, R::depuis_f64)).unwrap();
                let avant = marche.milieu();
                let Some(surface) = surface else {
                    let fin = pas.unwrap_or(1e3);
                    sur += scene.juger(ligne, [0.0, fin], |_| avant);
                    if pas.is_none() {
                        break;
                    }
                    pas_finis += 1;
                    let la = marche.rayon().source().vers_f64();
                    assert!((la - s - d * fin).longueur() <= *ecart, "{la:?} {s:?} {d:?} {fin}");
                    if let Some(vers) = tour {
                        marche.tourner(arrondi(vers)).unwrap();
                    }
                    continue;
                };
                let distance = surface.distance.vers_f64();
                // So far away, where a ray grazes a half-space, nobody knows a place to less than a unit.
                if distance > 1e3 {
                    break;
                }
                sur += scene.juger(ligne, [0.0, distance], |_| avant);
                let (p, n) = (s + d * distance, surface.touche.normale().vers_f64());
                assert!(pas.is_none_or(|pas| distance <= pas + ecart), "{distance} {pas:?}");
                assert!(scene.est_au_bord(surface.objet, p, n), "{surface:?} at {p:?}");
                let Derriere::Milieu(derriere) = surface.derriere else {
                    opaques += 1;
                    // It is below 0 as rounded.
                    let de_face = d.produit_scalaire(n) < 4.0 * u::<R>();
                    assert!(scene.opaque(surface.objet) && de_face, "{surface:?}");
                    marche.rester(surface.touche.reflechi(rayon.direction()).unwrap());
                    renvoi = Some(p);
                    continue;
                };
                let passe = marche.passer(&surface).unwrap();
                let indice = |milieu: Option<usize>| match milieu.map(|i| matieres[i]) {
                    Some(Matiere::Pleine { indice, .. } | Matiere::Commune { indice, .. }) => {
                        indice
                    }
                    Some(Matiere::Opaque) | None => PLEIN_AIR,
                };
                // Snell's law across N; light that grazes knows its angle less well.
                let suite = marche.rayon().direction().vers_f64();
                let travers = |d: Vecteur| d - n * n.produit_scalaire(d);
                let rapport = indice(avant) / indice(derriere);
                // Between two faces within rounding of each other, of which one sent it back, light goes straight on where
                // the other would send it back as well.
                let total = travers(d).longueur() * rapport > 1.0 - 1e-4;
                let pellicule = renvoi.is_some_and(|la: Vecteur| (p - la).longueur() <= *ecart);
                let droit_devant = passe && total && pellicule && (suite - d).longueur() <= 1e-4;
                let rapport = if droit_devant { 1.0 } else { rapport };
                pellicules += u32::from(droit_devant);
                renvoi = if passe { renvoi } else { Some(p) };
                let attendu = travers(d) * if passe { rapport } else { 1.0 };
                let c = n.produit_scalaire(suite).abs().max(1e-3);
                let permis = 100.0 * u::<R>() / c;
                assert!((travers(suite) - attendu).longueur() <= permis, "{suite:?} {surface:?}");
                let droit = n.produit_scalaire(suite) * n.produit_scalaire(d);
                assert!(if passe { droit > -1e-5 } else { droit < 1e-5 }, "{suite:?}");
                let sinus = travers(d).longueur() * rapport;
                assert!(if passe { sinus < 1.0 + 1e-4 } else { sinus > 1.0 - 1e-4 }, "{sinus}");
                let milieu = if passe { derriere } else { avant };
                assert_eq!(marche.milieu(), milieu);
                (passages, totales) = (passages + u32::from(passe), totales + u32::from(!passe));
                if let (Some(vers), true) = (tour, passe) {
                    marche.tourner(arrondi(vers)).unwrap();
                }
            }
        }
    });
    println!("{passages} {totales} {opaques} {pas_finis} {pellicules} {sur}");
    assert!(passages > 2_000 && totales > 100 && opaques > 500 && pas_finis > 2_000 && sur > 1e4);
}

en_f32_et_f64!(la_lumiere_est_dans_le_milieu_que_dit_la_marche);

/// Every length of a straight ray counts for the medium that counts there, up to the first opaque thing.
fn les_cordes_sont_celles_des_intervalles<R: Reel>() {
    let (mut combien, mut sur) = (0, 0.0);
    let faire = |alea: &mut Hasard| {
        let scene = scene::<R>(alea);
        let rayons = alea.liste(60, |alea, _| {
            let fin = if alea.bool() { entre(alea, 0.1, 9.0) } else { f64::INFINITY };
            depart(alea, &scene).jusqu_a(R::depuis_f64(fin)).unwrap()
        });
        (scene, rayons)
    };
    pour_chaque(cas(250), faire, |(scene, rayons)| {
        let mut marche = Marche::new(avec_arbre(&scene.objets), &scene.matieres);
        for rayon in rayons {
            let [s, d] = [rayon.source(), rayon.direction()].map(Vecteur::vers_f64);
            let ligne = [s, d.unitaire().unwrap()];
            let cordes = marche.cordes(&rayon).to_vec();
            let dit = |t: f64| {
                let mut ici =
                    cordes.iter().filter(|c| (c.de.vers_f64()..=c.a.vers_f64()).contains(&t));
                ici.next().map(|corde| corde.objet)
            };
            assert!(cordes.iter().all(|corde| corde.de < corde.a && corde.a <= rayon.fin()));
            assert!(cordes.windows(2).all(|deux| deux[0].a <= deux[1].de), "{cordes:?}");
            let mur = |i: usize| {
                let dehors =
                    scene.opaque(i) && part(&scene.objets[i], ligne, scene.ecart)?[0] > 0.0;
                part(&scene.objets[i], ligne, -scene.ecart).filter(|_| dehors).map(|part| part[0])
            };
            let fin =
                (0..scene.objets.len()).filter_map(mur).fold(rayon.fin().vers_f64(), f64::min);
            // Nothing goes on behind the wall.
            let dernier = cordes.last().map_or(0.0, |corde| corde.a.vers_f64());
            assert!(dernier <= fin, "{dernier} {fin}");
            let bord = |i: usize| {
                let dehors = scene.opaque(i)
                    && part(&scene.objets[i], ligne, -scene.ecart).is_none_or(|part| part[0] > 0.0);
                part(&scene.objets[i], ligne, scene.ecart)
                    .filter(|part| dehors && part[1] > 0.0)
                    .map(|part| part[0].max(0.0))
            };
            // A wall that the ray may only graze ends what is sure.
            let fin = (0..scene.objets.len()).filter_map(bord).fold(fin.min(1e3), f64::min);
            sur += scene.juger(ligne, [0.0, fin], dit);
            combien += cordes.len();
        }
    });
    println!("{combien} {sur}");
    assert!(combien > 10_000 && sur > 1e4);
}

en_f32_et_f64!(les_cordes_sont_celles_des_intervalles);

/// A tumour in an organ in a body in the air, where every number is exact; a sea; and a ray along the faces and edges
/// of voxels, on which each length counts once.
fn une_dose_compte_le_plus_profond<R: Reel>() {
    let corde = |(objet, de, a): (usize, f64, f64)| {
        let [de, a] = [de, a].map(R::depuis_f64);
        Corde { objet, de, a }
    };
    let sans_fin = f64::INFINITY;
    let boule = |r: f64| sphere::<R>(Vecteur::NUL, R::depuis_f64(r));
    let objets = [boule(1.0), boule(10.0), boule(3.0), mur(v(0.0, -20.0, 0.0), Vecteur::Y)];
    let matieres = [pleine(2, 1.0), pleine(0, 1.0), pleine(1, 1.0), pleine(0, 1.0)];
    let mut marche = Marche::new(Monde::de_liste(&objets), &matieres);
    let de = |marche: &mut Marche<'_, R>, y: f64, vers: f64, fin: f64| {
        let rayon = Rayon::new(v(0.0, y, 0.0), v(0.0, vers, 0.0)).unwrap();
        let rayon = rayon.jusqu_a(R::depuis_f64(fin)).unwrap();
        let cordes = marche.cordes(&rayon).to_vec();
        // The δ of a ray changes nothing, since no chord begins twice.
        let flou = rayon.avec_flou(R::depuis_f64(0.01)).unwrap();
        assert_eq!(marche.cordes(&flou), cordes);
        cordes
    };
    let corps =
        [(1, 10.0, 17.0), (2, 17.0, 19.0), (0, 19.0, 21.0), (2, 21.0, 23.0), (1, 23.0, 30.0)];
    let tout: Vec<_> = corps.into_iter().chain([(3, 40.0, sans_fin)]).map(corde).collect();
    assert_eq!(de(&mut marche, 20.0, -1.0, sans_fin), tout);
    assert_eq!(de(&mut marche, 20.0, -1.0, 18.0), [(1, 10.0, 17.0), (2, 17.0, 18.0)].map(corde));
    assert_eq!(
        de(&mut marche, -2.0, 1.0, 4.0),
        [(2, 0.0, 1.0), (0, 1.0, 3.0), (2, 3.0, 4.0)].map(corde)
    );
    // From a surface outward a ray is in nothing, and inward it is in what it goes through.
    assert_eq!(de(&mut marche, 10.0, 1.0, sans_fin), []);
    assert_eq!(de(&mut marche, -20.0, -1.0, sans_fin), [(3, 0.0, sans_fin)].map(corde));
    assert_eq!(de(&mut marche, -20.0, 1.0, 9.0), []);

    let cube = |i: usize| {
        let [x, y, z] = [i % 4, i / 4 % 4, i / 16].map(|k| k as f64 + 0.5);
        boite::<R>(v(x, y, z), v(1.0, 1.0, 1.0), Rotation::IDENTITE)
    };
    let (objets, matieres): (Vec<_>, Vec<_>) = (0..64).map(|i| (cube(i), pleine(0, 1.0))).unzip();
    let mut marche = Marche::new(avec_arbre(&objets), &matieres);
    for (y, z) in [(1.5, 2.5), (2.0, 2.5), (2.0, 1.0)] {
        let rayon = Rayon::new(v::<R>(-1.0, y, z), Vecteur::X).unwrap();
        let cordes = marche.cordes(&rayon).iter().map(|c| (c.de.vers_f64(), c.a.vers_f64()));
        assert!(cordes.eq([(1.0, 2.0), (2.0, 3.0), (3.0, 4.0), (4.0, 5.0)]), "at {y} {z}");
    }
    // A wall ends it, unless it holds the source.
    let matieres = [Matiere::Opaque, pleine(0, 1.0), pleine(1, 1.0)];
    let objets = [boule(1.0), boule(10.0), boule(3.0)];
    let mut marche = Marche::new(Monde::de_liste(&objets), &matieres);
    assert_eq!(
        de(&mut marche, 20.0, -1.0, sans_fin),
        [(1, 10.0, 17.0), (2, 17.0, 19.0)].map(corde)
    );
    assert_eq!(de(&mut marche, 0.0, -1.0, sans_fin), [(2, 0.0, 3.0), (1, 3.0, 10.0)].map(corde));
}

en_f32_et_f64!(une_dose_compte_le_plus_profond);

/// Up to six flush plates of glass and water, turned. Light comes out in the direction in which it went in, displaced
/// by the sum of what Snell's law gives for the plates, and is in each plate once.
fn des_lames_a_fleur_deplacent_la_lumiere_de_leur_somme<R: Reel>() {
    let epaisseur = 0.2;
    let faire = |alea: &mut Hasard| {
        let tour = Rotation::<R>::new(arrondi(direction(alea) * 3.0)).unwrap();
        (tour, arrondi::<R>(direction(alea)).vers_f64(), 1 + alea.tour % 6, entre(alea, 0.1, 0.8))
    };
    pour_chaque(1_000, faire, |(tour, centre, combien, sinus)| {
        let [x, _, z] = tour.axes().map(Vecteur::vers_f64);
        let lame = |i: usize| {
            let c = centre - z * (epaisseur * i as f64);
            boite(arrondi::<R>(c), v(20.0, 20.0, epaisseur), tour)
        };
        let lames: Vec<_> = (0..combien).map(lame).collect();
        let indice = |i: usize| if i.is_multiple_of(2) { 1.5 } else { 1.33 };
        let milieux: Vec<_> = (0..combien).map(|i| pleine(i as u32, indice(i))).collect();
        let d = x * sinus - z * (1.0 - sinus * sinus).sqrt();
        let rayon = Rayon::new(arrondi::<R>(centre + z), arrondi(d)).unwrap();
        let mut marche = Marche::new(Monde::de_liste(&lames), &milieux);
        marche.partir(rayon);
        let mut suite = vec![];
        while let Some(surface) = marche.avancer(R::INFINI).unwrap() {
            assert!(marche.passer(&surface).unwrap());
            suite.push(marche.dans().to_vec());
            assert!(suite.len() <= combien + 1, "{suite:?}");
        }
        let attendue: Vec<_> = (0..combien).map(|i| vec![i]).chain([vec![]]).collect();
        assert_eq!(suite, attendue);
        let dehors = marche.rayon();
        let chemin = (dehors.source() - rayon.source()).vers_f64();
        let a_cote = chemin.produit_vectoriel(d).longueur();
        let par_lame = |i: usize| {
            let (dehors, dedans) = (sinus.asin(), (sinus / indice(i)).asin());
            epaisseur * (dehors - dedans).sin() / dedans.cos()
        };
        let attendu: f64 = (0..combien).map(par_lame).sum();
        // At each face there are some fifty roundings of numbers below 3, at cosines above 0.6.
        let permis = 500.0 * u::<R>() * (1 + combien) as f64;
        assert!((a_cote - attendu).abs() < permis, "{a_cote} {attendu}");
        assert!((dehors.direction().vers_f64() - d).longueur() < permis);
    });
}

en_f32_et_f64!(des_lames_a_fleur_deplacent_la_lumiere_de_leur_somme);

/// A glass of layers stands on a table, all turned alike, at any height, in mist or in the air. Light through the top
/// of the glass finds the table where Snell's law says, whatever rounding makes of the flush faces; from there it sees
/// a lamp in the glass, and a mirror sends it back out of the top.
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
        (tour, pied, lieux, alea.bool(), [1 + alea.tour % 3, alea.usize(0..5)])
    };
    pour_chaque(200, faire, |(tour, pied, lieux, brume, [couches, table_de])| {
        let y = tour.axes()[1].vers_f64();
        let haut = 1.5 / couches as f64;
        let couche = |i: usize| {
            let milieu = pied + y * (haut * (i as f64 + 0.5));
            boite::<R>(arrondi(milieu), arrondi(Vecteur::new(4.0, haut, 4.0)), tour)
        };
        let mut objets: Vec<_> = (0..couches).map(couche).collect();
        let indice = |i: usize| [1.5, 1.33, 1.8][i % 3];
        let mut milieux: Vec<_> = (0..couches).map(|i| pleine(1, indice(i))).collect();
        if brume {
            objets.push(sphere(Vecteur::NUL, R::depuis_f64(50.0)));
            milieux.push(pleine(0, 1.0));
        }
        let table = objets.len();
        // A large table knows its place less well, and may lie apart from the glass by as much.
        let large = [0.0, 4.5, 45.0, 450.0, 4_500.0][table_de];
        objets.push(if table_de == 0 {
            mur(arrondi(pied), arrondi(y))
        } else {
            boite(arrondi(pied - y * (large / 2.0)), v(large, large, large), tour)
        });
        let mut marche = Marche::new(Monde::de_liste(&objets), &milieux);
        let permis = 2_000.0 * u::<R>() * (1.0 + pied.longueur()) + 30.0 * u::<R>() * large;
        for (cible, d) in lieux {
            let d = d.unitaire().unwrap();
            marche.partir(Rayon::new(arrondi::<R>(cible - d), arrondi(d)).unwrap());
            let mut faces = 0;
            let (avant, surface) = loop {
                let avant = marche.rayon();
                let surface = marche.avancer(R::INFINI).unwrap().unwrap();
                if surface.derriere == Derriere::Opaque {
                    break (avant, surface);
                }
                assert!(marche.passer(&surface).unwrap() && faces < couches, "{surface:?}");
                faces += 1;
            };
            let touche = surface.touche;
            let depuis = touche.point().vers_f64() - avant.source().vers_f64();
            let ecart = (surface.distance.vers_f64() - depuis.longueur()).abs();
            assert!(ecart < permis, "{ecart:e}");
            assert_eq!((surface.objet, touche.indice(), faces), (table, table, couches));
            let sinus = (d + y * -d.produit_scalaire(y)).longueur();
            let travers = (d + y * -d.produit_scalaire(y)) / sinus;
            let recul = |i: usize| haut * (sinus / indice(i)).asin().tan();
            let attendu = cible - y * 1.5 + travers * (0..couches).map(recul).sum::<f64>();
            let ecart = (touche.point().vers_f64() - attendu).longueur();
            assert!(ecart < permis, "{ecart:e}");
            let lampe = touche.vers_lumiere(touche.point() + arrondi(y * (0.5 * haut))).unwrap();
            marche.rester(lampe);
            assert_eq!(marche.avancer(lampe.fin()).unwrap(), None);
            marche.rester(touche.reflechi(avant.direction()).unwrap());
            for _ in 0..couches {
                let face = marche.avancer(R::INFINI).unwrap().unwrap();
                assert!(marche.passer(&face).unwrap(), "{face:?}");
            }
            let (miroir, suite) = (d - y * (2.0 * d.produit_scalaire(y)), marche.rayon());
            assert!((suite.direction().vers_f64() - miroir).longueur() < permis);
            assert_eq!(marche.milieu(), brume.then_some(couches));
            vus += 1;
        }
    });
    assert_eq!(vus, 8_000);
}

en_f32_et_f64!(un_verre_sur_une_table_dans_la_brume_montre_la_table);

/// The program of the page, through water that reaches into glass and as far as the fish on its floor.
#[test]
fn le_programme_de_la_page_trouve_le_poisson() {
    let droite = |y: f64, h: f64| boite(v(0.0, y, 0.0), v(9.0, h, 9.0), Rotation::IDENTITE);
    let objets = [droite(0.5, 2.0), droite(-0.5, 1.0), sphere(v(0.0, -1.0, 0.0), 0.5)];
    let faire = |alea: &mut Hasard| [(); 2].map(|()| entre(alea, -0.4, 0.4));
    pour_chaque(1_000, faire, |[x, z]| {
        let rayon = Rayon::new(v(0.0, 6.5, 0.0), v(x, -1.0, z)).unwrap();
        let touche = au_fond(Monde::de_liste(&objets), rayon).unwrap();
        let sinus = (x * x + z * z).sqrt() / (1.0 + x * x + z * z).sqrt();
        let tangente = |n: f64| (sinus / n).asin().tan();
        // From the top of the glass, at the axis of the fish: the water above it, and the air.
        let a_cote = 5.0 * tangente(1.0) + 1.5 * tangente(1.33);
        // The line in the glass, beside the centre of the fish, one below.
        let biais = (sinus / 1.5).asin();
        let pres = (a_cote + biais.tan()) * biais.cos();
        assert_eq!(touche.map(|touche| touche.indice()), (pres < 0.5).then_some(2), "{pres}");
    });
}

/// Water around a body of index 1, an organ at one of its sides and another thing beside that: where all three have one
/// face, light passes between organ and water at angles at which the body would mirror it, in and out; and from a
/// bubble in the water that is flush with a pane it goes into the pane, by one surface.
fn aucune_pellicule_ne_renvoie_la_lumiere<R: Reel>() {
    let faire = |alea: &mut Hasard| {
        let tour = Rotation::<R>::new(arrondi(direction(alea) * *alea.choix(&[0.0, 3.0]))).unwrap();
        let centre = direction(alea) * *alea.choix(&[0.3, 5.0]);
        let cotes = [(); 2].map(|()| entre(alea, 1.0, 3.0));
        let (penche, angle) = (entre(alea, 0.78, 0.98), entre(alea, -3.0, 3.0));
        (tour, centre, cotes, alea.bool(), [penche, angle])
    };
    pour_chaque(2_000, faire, |(tour, centre, [corps, organe], inverse, [sinus, angle])| {
        let [x, y, z] = tour.axes().map(Vecteur::vers_f64);
        // Both have their right side at the plane x = 0 about the centre.
        let a_gauche =
            |cote: f64| boite(arrondi::<R>(centre - x * (cote / 2.0)), v(cote, 4.0, 4.0), tour);
        let vers = y * (sinus * angle.cos()) + z * (sinus * angle.sin());
        let cosinus = (1.0 - sinus * sinus).sqrt();
        let eau = sphere(Vecteur::NUL, R::depuis_f64(50.0));
        let (mut objets, mut matieres) = (
            [eau, a_gauche(corps), a_gauche(organe)],
            [pleine(0, 1.33), pleine(1, 1.0), pleine(2, 1.5)],
        );
        if inverse {
            objets.swap(1, 2);
            matieres.swap(1, 2);
        }
        let organe = if inverse { 1 } else { 2 };
        let mut marche = Marche::new(Monde::de_liste(&objets), &matieres);
        // Into the organ, at an angle of which the sine in the water is above 1 / 1.33.
        let d = vers - x * cosinus;
        marche.partir(Rayon::new(arrondi(centre - d * 0.5), arrondi(d)).unwrap());
        let surface = marche.avancer(R::INFINI).unwrap().unwrap();
        assert!(marche.passer(&surface).unwrap(), "{surface:?}");
        marche.avancer(R::ZERO).unwrap();
        assert_eq!(marche.milieu(), Some(organe), "{surface:?}");
        // And back: in the organ the sine is smaller by the indices, above 1 / 1.5.
        let dedans = vers * (1.33 / 1.5);
        let d = dedans + x * (1.0 - dedans.longueur_carree()).sqrt();
        marche.partir(Rayon::new(arrondi(centre - d * 0.3), arrondi(d)).unwrap());
        let surface = marche.avancer(R::INFINI).unwrap().unwrap();
        assert!(marche.passer(&surface).unwrap(), "{surface:?}");
        assert_eq!((surface.derriere, marche.milieu()), (Derriere::Milieu(Some(0)), Some(0)));
        // A bubble to the left of the face, a pane to the right.
        let vitre = boite(arrondi(centre + x * 1.5), v(3.0, 4.0, 4.0), tour);
        let objets = [eau, a_gauche(corps), vitre];
        let matieres = [pleine(0, 1.33), pleine(1, 1.0), pleine(1, 1.5)];
        let mut marche = Marche::new(Monde::de_liste(&objets), &matieres);
        let d = vers * 0.5 + x * (1.0 - 0.25 * sinus * sinus).sqrt();
        marche.partir(Rayon::new(arrondi(centre - d * 0.3), arrondi(d)).unwrap());
        let surface = marche.avancer(R::INFINI).unwrap().unwrap();
        assert_eq!(surface.derriere, Derriere::Milieu(Some(2)), "{surface:?}");
    });
}

en_f32_et_f64!(aucune_pellicule_ne_renvoie_la_lumiere);

/// Light that is born in a closed room, on a wall or beside one, where media lie flush with the walls and with each other.
/// Between two faces that rounding alone sets apart, one may mirror it and the other mirror it back. It is caught there
/// by no more surfaces than there are objects, and leaves no room however thin its walls.
fn aucune_pellicule_ne_prend_la_lumiere<R: Reel>() {
    let [mut surfaces, mut totales, mut plus_long] = [0; 3];
    let faire = |alea: &mut Hasard| {
        let tour = Rotation::<R>::new(arrondi(direction(alea) * *alea.choix(&[0.0, 3.0]))).unwrap();
        let centre = direction(alea) * *alea.choix(&[0.0, 10.0, 100.0]);
        let jeu = u::<R>() * (10.0 + centre.longueur());
        let minces = alea.bool().then_some([8_000.0 * jeu; 2]);
        let indice = |alea: &mut Hasard| *alea.choix(&[1.0, 1.33, 1.5, 2.4]);
        // What fills the room, a layer on its floor, a block upon or within that, and one beside it.
        let hauts = [entre(alea, 0.5, 4.0), entre(alea, 0.5, 4.0)];
        let matieres = [(); 4].map(|()| pleine(u32::from(alea.u8(0..3)), indice(alea)));
        let naissances = alea.liste(40, |alea, _| {
            let mut p = [(); 3].map(|()| entre(alea, -5.0, 5.0));
            // On a face, an edge or a corner.
            for _ in 0..alea.usize(1..5) {
                p[alea.usize(0..3)] = *alea.choix(&[-5.0, -5.0 + hauts[0], 5.0, 0.0]);
            }
            // To the next surface, or this far, and then where light is scattered to.
            let chemin = alea.liste(100, |alea, _| {
                let pas = *alea.choix(&[f64::INFINITY, 0.0, 1e-9, 0.1, 2.0]);
                (pas, direction(alea))
            });
            (p, direction(alea), chemin)
        });
        (tour, centre, jeu, minces, hauts, matieres, naissances)
    };
    pour_chaque(cas(200), faire, |(tour, centre, jeu, minces, hauts, claires, naissances)| {
        let axes = tour.axes().map(Vecteur::vers_f64);
        let place = |[a, b, c]: [f64; 3]| centre + axes[0] * a + axes[1] * b + axes[2] * c;
        let mut objets: Vec<ObjetRay<R>> =
            murs(arrondi(centre), tour, 10.0, minces).into_iter().map(ObjetRay::from).collect();
        let [couche, bloc] = hauts;
        let cube = |p, cotes: [f64; 3]| boite::<R>(arrondi(place(p)), arrondi(cotes.into()), tour);
        objets.extend([
            cube([0.0; 3], [10.0; 3]),
            cube([0.0, -5.0 + couche / 2.0, 0.0], [10.0, couche, 10.0]),
            cube([-2.5, -5.0 + bloc / 2.0, 0.0], [5.0, bloc, 10.0]),
            cube([2.5, -5.0 + bloc / 2.0, 0.0], [5.0, bloc, 10.0]),
        ]);
        let matieres: Vec<_> = [Matiere::Opaque; 6].into_iter().chain(claires).collect();
        let mut marche = Marche::new(Monde::de_liste(&objets), &matieres);
        for (p, vers, chemin) in naissances {
            let rayon = Rayon::new(arrondi::<R>(place(p)), arrondi(vers)).unwrap();
            marche.partir(rayon.avec_flou(R::depuis_f64(30.0 * jeu)).unwrap());
            let mut ici = 0;
            for (pas, tour) in chemin {
                if let Some(surface) = marche.avancer(R::depuis_f64(pas)).unwrap() {
                    surfaces += 1;
                    ici = if surface.distance.vers_f64() > 300.0 * jeu { 0 } else { ici + 1 };
                    plus_long = plus_long.max(ici);
                    assert!(ici <= objets.len(), "{ici} surfaces at {surface:?} of {rayon:?}");
                    let passe = marche.passer(&surface).unwrap();
                    totales += usize::from(!passe && surface.derriere != Derriere::Opaque);
                } else {
                    ici = 0;
                    marche.tourner(arrondi(tour)).unwrap();
                }
                let la = marche.rayon().source().vers_f64() - centre;
                let loin = axes.into_iter().map(|n| n.produit_scalaire(la).abs());
                let loin = loin.fold(0.0, f64::max);
                assert!(loin <= 5.0 + 3_500.0 * jeu, "{loin} of {rayon:?}");
            }
        }
    });
    println!("{surfaces} {totales} {plus_long}");
    assert!(surfaces > 100_000 && totales > 10_000 && plus_long > 2);
}

en_f32_et_f64!(aucune_pellicule_ne_prend_la_lumiere);

/// Two to four faces of half-spaces, balls and boxes that cross within some hundred roundings of one place, at any angles.
fn carrefour<R: Reel>(alea: &mut Hasard, opaques: bool, droit: bool) -> Scene<R> {
    let centre = direction(alea) * *alea.choix(&[0.0, 1.0, 30.0]);
    let (mut objets, mut matieres) = (vec![], vec![]);
    for _ in 0..alea.usize(2..5) {
        let tour = Rotation::<R>::new(arrondi(direction(alea) * 3.0)).unwrap();
        let [x, n, z] = tour.axes().map(Vecteur::vers_f64);
        let la = centre + n * (entre(alea, -300.0, 300.0) * u::<R>() * (1.0 + centre.longueur()));
        let r = entre(alea, 0.5, 3.0);
        // In the middle of a side, at an edge or at a corner.
        let [a, b] = [(); 2].map(|()| *alea.choix(&[0.0, 0.4, 1.0]) * r);
        objets.push(match alea.u8(0..3) {
            0 => mur(arrondi::<R>(la), arrondi(n)),
            1 => sphere(arrondi(la - n * r), R::depuis_f64(r)),
            _ => boite(arrondi(la + x * a + z * b - n * r), v(2.0 * r, 2.0 * r, 2.0 * r), tour),
        });
        let indice = if droit { 1.0 } else { *alea.choix(&[1.0, 1.33, 1.5, 2.4]) };
        let opaque = opaques && alea.u8(0..3) == 0;
        let priorite = u32::from(alea.u8(0..4));
        matieres.push(if opaque { Matiere::Opaque } else { pleine(priorite, indice) });
    }
    let ecart = 3_000.0 * u::<R>() * (10.0 + centre.longueur());
    Scene { objets, matieres, tour: Rotation::IDENTITE, centre, ecart }
}

/// Light that is aimed at where faces cross, also in a re-entrant edge, comes out again after few surfaces, and is in
/// what the walk says; where nothing bends it, a step ends where it should.
fn a_un_carrefour_la_lumiere_n_est_ni_prise_ni_perdue<R: Reel>() {
    let [mut surfaces, mut droits, mut opaques] = [0; 3];
    let mut sur = 0.0;
    let faire = |alea: &mut Hasard| {
        let droit = alea.bool();
        let opaques = !droit && alea.bool();
        let scene = carrefour::<R>(alea, opaques, droit);
        let rayons = alea.liste(40, |alea, _| {
            let d = direction(alea);
            let vise = entre(alea, 0.0, 300.0) * u::<R>() * (1.0 + scene.centre.longueur());
            let source = scene.centre + direction(alea) * vise - d * entre(alea, 0.3, 1.5);
            Rayon::new(arrondi::<R>(source), arrondi(d)).unwrap()
        });
        (scene, droit, rayons)
    };
    pour_chaque(cas(3_000), faire, |(scene, droit, rayons)| {
        let Scene { objets, matieres, ecart, .. } = &scene;
        let mut marche = Marche::new(Monde::de_liste(objets), matieres);
        for depart in rayons {
            marche.partir(depart);
            // A step through all of it, or from surface to surface for as long as light is nearby.
            let long = if droit { 3.0 } else { f64::INFINITY };
            let (mut chemin, mut ici, mut renvois) = (0.0, 0, 0);
            for _ in 0..200 {
                let rayon = marche.rayon();
                let [s, d] = [rayon.source(), rayon.direction()].map(Vecteur::vers_f64);
                let ligne = [s, d.unitaire().unwrap()];
                let surface = marche.avancer(R::depuis_f64(long - chemin)).unwrap();
                let dit = marche.milieu();
                let distance =
                    surface.as_ref().map_or(long - chemin, |surface| surface.distance.vers_f64());
                sur += scene.juger(ligne, [0.0, distance.min(1e2)], |_| dit);
                let Some(surface) = surface else { break };
                surfaces += 1;
                opaques += usize::from(surface.derriere == Derriere::Opaque);
                chemin = (chemin + distance).min(long);
                ici = if distance > *ecart { 0 } else { ici + 1 };
                assert!(ici <= 2 * objets.len(), "{ici} surfaces at {s:?} of {depart:?}");
                // Between mirrors at a sharp angle light may go to and fro many times, or for ever.
                if !marche.passer(&surface).unwrap() {
                    (ici, renvois) = (0, renvois + 1);
                }
                if chemin > 1e2 || renvois > 50 {
                    break;
                }
            }
            if droit {
                droits += 1;
                let attendu = depart.source().vers_f64() + depart.direction().vers_f64() * 3.0;
                let la = marche.rayon().source().vers_f64();
                assert!((la - attendu).longueur() <= *ecart, "at {la:?} of {depart:?}");
            }
        }
    });
    println!("{surfaces} {droits} {opaques} {sur}");
    assert!(surfaces > 50_000 && droits > 20_000 && opaques > 1_000 && sur > 1e4);
}

en_f32_et_f64!(a_un_carrefour_la_lumiere_n_est_ni_prise_ni_perdue);

/// Light that goes nearly along the edge of a plank, leaves it there and then cuts a corner of a cube by some roundings.
/// It does not go back into the plank, which lies within rounding of the cube, since it goes away from it.
fn rasante_la_lumiere_ne_rentre_pas<R: Reel>() {
    let mut coins = 0;
    let faire = |alea: &mut Hasard| {
        let pentes = [(); 2].map(|()| (-2.0 - 6.0 * alea.f64()).exp2());
        let [coin, vise] =
            [(); 2].map(|()| [(); 3].map(|()| entre(alea, -300.0, 300.0) * u::<R>()));
        (pentes, coin, vise, direction(alea) * 3.0)
    };
    pour_chaque(cas(20_000), faire, |([a, b], coin, vise, angles)| {
        let planche = boite::<R>(v(-0.5, -0.5, 0.0), v(1.0, 1.0, 4.0), Rotation::IDENTITE);
        let tour = Rotation::<R>::new(arrondi(angles)).unwrap();
        let diagonale = tour.appliquer(v(1.0, 1.0, 1.0)).vers_f64();
        let cube = boite(arrondi(Vecteur::from(coin) + diagonale), v(2.0, 2.0, 2.0), tour);
        let objets = [planche, cube];
        let matieres = [pleine(0, 1.0); 2];
        let mut marche = Marche::new(Monde::de_liste(&objets), &matieres);
        let d = Vecteur::new(a, b, 1.0);
        let depart = Rayon::new(arrondi(Vecteur::from(vise) - d * 0.3), arrondi(d)).unwrap();
        marche.partir(depart);
        let mut surfaces = 0;
        while let Some(surface) = marche.avancer(R::INFINI).unwrap() {
            marche.passer(&surface).unwrap();
            surfaces += 1;
            assert!(surfaces <= 4, "{surface:?}");
        }
        coins += usize::from(surfaces > 1);
    });
    println!("{coins}");
    assert!(coins > 1_000);
}

en_f32_et_f64!(rasante_la_lumiere_ne_rentre_pas);

/// Two balls, two slanted half-spaces and two planks that cross in a re-entrant edge: light that is aimed at it goes its
/// way, whatever steps it is asked to take.
fn dans_une_arete_rentrante_la_lumiere_passe<R: Reel>() {
    let planche = |angle: f64| {
        let tour = Rotation::<R>::new(v(0.0, 0.0, angle)).unwrap();
        boite(Vecteur::NUL, v(4.0, 1.0, 4.0), tour)
    };
    let scenes = [
        [0.8, -0.8].map(|x| sphere::<R>(v(x, 0.0, 0.0), R::UN)),
        [0.8, -0.8].map(|x| mur::<R>(v(0.0, 0.6, 0.0), v(x, 0.6, 0.0))),
        [0.9, -0.9].map(planche),
    ];
    let indices = [[1.0, 1.0], [1.5, 1.5], [1.33, 1.5]];
    let faire = |alea: &mut Hasard| (alea.f64() - 0.5, (-10.0 * alea.f64()).exp2());
    pour_chaque(500, faire, |(z, pas)| {
        for (objets, indices) in scenes.iter().flat_map(|s| indices.map(|i| (s, i))) {
            let matieres = indices.map(|indice| pleine(0, indice));
            let mut marche = Marche::new(Monde::de_liste(objets), &matieres);
            let depart = Rayon::new(Vecteur::NUL, v::<R>(0.0, 1.0, z)).unwrap();
            marche.partir(depart);
            let mut faces = 0;
            while let Some(surface) = marche.avancer(R::INFINI).unwrap() {
                marche.passer(&surface).unwrap();
                // In a plank light may be mirrored many times, but not at one place.
                faces = if surface.distance.vers_f64() < 1e-4 { faces + 1 } else { 0 };
                assert!(faces <= 4, "{surface:?}");
            }
            if indices == [1.0, 1.0] {
                marche.partir(depart);
                let mut chemin = 0.0;
                while chemin < 3.0 {
                    assert!(particule::avancer(&mut marche, R::depuis_f64(pas)).unwrap());
                    chemin += pas;
                }
                let la = (marche.rayon().source() - depart.direction() * R::depuis_f64(chemin))
                    .longueur();
                assert!(la.vers_f64() <= 1e5 * u::<R>(), "{la:?}");
                assert_eq!(marche.dans(), &[] as &[usize]);
            }
        }
    });
}

en_f32_et_f64!(dans_une_arete_rentrante_la_lumiere_passe);

/// Glass that fills a room, and light in an edge of the room, out of the glass by rounding and by less than its δ, which
/// goes nearly along the edge. Wherever it is told to come out, it is told so there, and not where it would have come in.
#[test]
fn dans_un_coin_la_lumiere_sort_ou_elle_est() {
    let verre = boite(v(0.5, 0.5, 0.5), v(1.0, 1.0, 1.0), Rotation::IDENTITE);
    let mut objets: Vec<ObjetRay> = vec![verre];
    objets.extend(
        murs(v(0.5, 0.5, 0.5), Rotation::IDENTITE, 1.0, None).into_iter().map(ObjetRay::from),
    );
    let matieres = [pleine(0, 1.5)];
    let mut marche = Marche::new(Monde::de_liste(&objets), &matieres);
    for pente in [1e-2, 1e-6, 1e-9, 1e-10, 2.5e-11] {
        let rayon = Rayon::new(v(-1e-11, 1.0 + 1e-12, 0.5), v(-pente, 0.1, 1.0)).unwrap();
        marche.reprendre(rayon.avec_flou(1e-9).unwrap(), [0]);
        let surface = marche.avancer(f64::INFINITY).unwrap().unwrap();
        let la = surface.touche.point();
        assert!(surface.distance == 0.0 && (la - rayon.source()).longueur() < 1e-7, "{surface:?}");
    }
}

/// Steps below 0 and those that are no numbers are refused, wherever light is, and it stays there.
fn un_pas_sans_longueur_est_refuse<R: Reel>() {
    let objets = [sphere::<R>(Vecteur::NUL, R::UN)];
    let matieres = [pleine(0, 1.5)];
    let mut marche = Marche::new(Monde::de_liste(&objets), &matieres);
    for x in [-3.0, 0.0, 1.0, 3.0] {
        marche.partir(Rayon::new(v(x, 0.0, 0.0), Vecteur::X).unwrap());
        // A step may have left light beyond the face of what it is in.
        marche.reprendre(marche.rayon(), [0]);
        let avant = (marche.rayon(), marche.dans().to_vec());
        for pas in [-1.0, -R::U.vers_f64(), f64::NEG_INFINITY, f64::NAN].map(R::depuis_f64) {
            assert_eq!(marche.avancer(pas).unwrap_err().champ, "pas");
            assert_eq!(particule::avancer(&mut marche, pas).unwrap_err().champ, "pas");
            assert_eq!((marche.rayon(), marche.dans().to_vec()), avant);
        }
    }
}

en_f32_et_f64!(un_pas_sans_longueur_est_refuse);

/// From within one object, also along its surface, by a step that ends within some roundings of the way out, and turned
/// there or not: light is told where it comes out, or is still in.
fn aucun_pas_ne_sort_sans_le_dire<R: Reel>() {
    let [mut avant, mut au_bord, mut ici] = [0; 3];
    let faire = |alea: &mut Hasard| {
        let tour = Rotation::<R>::new(arrondi(direction(alea) * *alea.choix(&[0.0, 3.0]))).unwrap();
        let centre = direction(alea) * *alea.choix(&[0.0, 5.0, 30.0]);
        let objet = match alea.u8(0..3) {
            0 => sphere(arrondi(centre), R::depuis_f64(entre(alea, 0.5, 2.0))),
            1 => boite(arrondi(centre), v(1.0, 2.0, 3.0), tour),
            _ => mur(arrondi(centre + tour.axes()[1].vers_f64()), tour.axes()[1]),
        };
        let rayon = Rayon::new(arrondi(centre), arrondi(direction(alea))).unwrap();
        // Along the surface, by any angle.
        let rase = (-30.0 * alea.f64()).exp2();
        let plus = f64::from(alea.i8(-6..=1)) * *alea.choix(&[1.0, 8.0]);
        (objet, rayon, alea.bool().then_some(rase), plus, alea.bool().then(|| direction(alea)))
    };
    pour_chaque(cas(20_000), faire, |(objet, rayon, rase, plus, tour)| {
        let Ok(sortie) = objet.sortie(&rayon) else { return };
        let rayon = match rase {
            Some(rase) => {
                let (n, d) = (sortie.normale(), rayon.direction());
                let travers = d - n * d.produit_scalaire(n) + n * R::depuis_f64(rase);
                let Ok(rayon) = Rayon::new(sortie.point() - n * R::depuis_f64(0.1), travers) else {
                    return;
                };
                rayon
            }
            None => rayon,
        };
        let Ok(sortie) = objet.sortie(&rayon) else { return };
        let t = sortie.distance();
        let pas = t * R::depuis_f64(1.0 + plus * u::<R>());
        let objets = [objet];
        let matieres = [pleine(0, 1.0)];
        let mut marche = Marche::new(Monde::de_liste(&objets), &matieres);
        marche.partir(rayon);
        if marche.avancer(pas).unwrap().is_some() {
            au_bord += 1;
            return;
        }
        avant += 1;
        if let Some(vers) = tour {
            marche.tourner(arrondi(vers)).unwrap();
        }
        // In a half-space light may go down for ever; and light that goes past a ball, so near that only rounding sets it
        // outside, meets nothing.
        let cosinus = sortie.normale().produit_scalaire(marche.rayon().direction()).vers_f64();
        let la = marche.rayon().source();
        let surface = marche.avancer(R::INFINI).unwrap();
        if let Some(surface) = surface.filter(|surface| surface.distance == R::ZERO) {
            ici += 1;
            let ecart = (surface.touche.point() - la).longueur().vers_f64();
            assert!(ecart <= 100.0 * u::<R>() * la.longueur().vers_f64(), "{ecart:e}");
        }
        let frole = cosinus.abs() < (1_000.0 * u::<R>()).sqrt();
        assert!(surface.is_some() || marche.milieu().is_some() || frole, "{rayon:?} until {pas}");
    });
    println!("{avant} {au_bord} {ici}");
    assert!(avant > 10_000 && au_bord > 500 && ici > 500);
}

en_f32_et_f64!(aucun_pas_ne_sort_sans_le_dire);

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
        let flou = R::depuis_f64(1e-6);
        let rayon = Rayon::new(arrondi::<R>(source), arrondi(d)).unwrap().avec_flou(flou).unwrap();
        let matieres = [pleine(0, 1.5)];
        let mut marche = Marche::new(Monde::de_liste(&objets), &matieres);
        marche.partir(rayon);
        let surface = marche.avancer(R::INFINI).unwrap().unwrap();
        assert_eq!(surface.derriere, Derriere::Opaque, "{rayon:?}");
        let (touche, distance) = (surface.touche, surface.distance);
        let depuis = (touche.point() - rayon.source()).longueur();
        assert!((distance - depuis).absolu() < R::depuis_f64(1e-5) * depuis, "{distance:?}");
        assert_eq!((touche.indice(), touche.normale()), (1, Vecteur::Y));
        assert!(touche.reflechi(rayon.direction()).unwrap().flou() > flou);
    });
    // Light that goes up from the surface of water is not in the water, and light that goes down is; a table that holds
    // a source by rounding counts for nothing.
    let objets = [
        mur::<R>(Vecteur::NUL, Vecteur::Y),
        boite(v(9.0, 5.0, 9.0), v(1.0, 1.0, 1.0), Rotation::IDENTITE),
    ];
    let matieres = [pleine(0, 1.33), Matiere::Opaque];
    let mut marche = Marche::new(Monde::de_liste(&objets), &matieres);
    for (source, vers, dans) in [(0.0, 0.8, &[][..]), (0.0, -0.8, &[0]), (-9.0, -0.8, &[0])] {
        marche.partir(Rayon::new(v(0.0, source, 0.0), v(0.6, vers, 0.0)).unwrap());
        assert_eq!(marche.avancer(R::INFINI).unwrap(), None);
        assert_eq!(marche.dans(), dans);
    }
    let neuf = R::depuis_f64(9.0);
    let source = Vecteur::new(neuf, R::depuis_f64(5.5 * (1.0 - 8.0 * u::<R>())), neuf);
    marche.partir(Rayon::new(source, Vecteur::Y).unwrap());
    assert_eq!(marche.avancer(R::INFINI).unwrap(), None);
    // Downward it stops light that knows how exactly it starts there.
    let flou = R::depuis_f64(1e-5);
    marche.partir(Rayon::new(source, -Vecteur::Y).unwrap().avec_flou(flou).unwrap());
    let surface = marche.avancer(R::INFINI).unwrap().unwrap();
    assert_eq!((surface.derriere, surface.distance), (Derriere::Opaque, R::ZERO));
}

en_f32_et_f64!(du_verre_la_lumiere_trouve_son_pied);

/// The paraxial focus of a thick lens, the rays off its axis by the trigonometric trace of Conrady, and a lamp near the
/// lens, within either ball or both, whose light a plane wave would be if it stood at the focus.
#[test]
fn une_lentille_de_deux_boules_a_son_foyer() {
    let (r, epaisseur, n) = (10.0, 1.2, 1.5);
    let balles = [1.0, -1.0].map(|cote| sphere(Vecteur::X * (cote * (r - epaisseur / 2.0)), r));
    let commune = |avec| Matiere::Commune { avec, priorite: 0, indice: n };
    let matieres = [commune(1), commune(0)];
    let mut marche = Marche::new(Monde::de_liste(&balles), &matieres);
    let mut traverser = |rayon: Rayon| {
        marche.partir(rayon);
        let mut faces = 0;
        while let Some(surface) = marche.avancer(f64::INFINITY).unwrap() {
            assert!(marche.passer(&surface).unwrap());
            faces += 1;
        }
        (faces, marche.rayon())
    };
    // Where a ray parallel to the axis, at the height h, crosses the axis, measured from the last vertex.
    let mut traverse = |h: f64| {
        let (faces, dehors) =
            traverser(Rayon::new(Vecteur::new(-30.0, h, 0.0), Vecteur::X).unwrap());
        assert_eq!(faces, 2);
        let (p, d) = (dehors.source(), dehors.direction());
        p.x - d.x * p.y / d.y - epaisseur / 2.0
    };
    let f = n * r * r / ((n - 1.0) * (2.0 * n * r - (n - 1.0) * epaisseur));
    let paraxial = f * (1.0 - (n - 1.0) * epaisseur / (n * r));
    // Aberration is of the order of h², and rounding of the order of u/h.
    assert!((traverse(1e-4) - paraxial).abs() < 1e-8, "{} {paraxial}", traverse(1e-4));
    for h in [0.1, 0.5, 1.0, 2.0, 3.0] {
        let sin_i = h / r;
        let sin_i2 = sin_i / n;
        let u1 = sin_i.asin() - sin_i2.asin();
        let l1 = r + r * sin_i2 / u1.sin() - epaisseur;
        let sin_j = (l1 + r) / -r * u1.sin();
        let sin_j2 = n * sin_j;
        let u2 = u1 + sin_j.asin() - sin_j2.asin();
        let attendu = -r - r * sin_j2 / u2.sin();
        assert!((traverse(h) - attendu).abs() < 1e-12 / h, "{h}: {} {attendu}", traverse(h));
    }
    // The lamp on the axis: at the focus, which lies within a ball, and in the glass itself.
    let mut lampe =
        |x: f64| traverser(Rayon::new(Vecteur::X * x, Vecteur::new(1.0, 1e-4, 0.0)).unwrap());
    let (faces, plane) = lampe(-(paraxial + epaisseur / 2.0));
    assert!(faces == 2 && plane.direction().y.abs() < 1e-10, "{plane:?}");
    let (faces, sortie) = lampe(0.0);
    let sinus = 1e-4 * (1.0 - epaisseur / 2.0 / r * (1.0 - 1.0 / n));
    assert!(faces == 1 && (sortie.direction().y - n * sinus).abs() < 1e-10, "{sortie:?}");
    // The edge of the lens is where the balls cross.
    let bord = (r * r - (r - epaisseur / 2.0_f64).powi(2)).sqrt();
    let mut faces = |h| traverser(Rayon::new(Vecteur::new(-30.0, h, 0.0), Vecteur::X).unwrap()).0;
    assert!(faces(bord - 1e-3) == 2 && faces(bord + 1e-3) == 0);
}

/// A walk that is kept for many rays goes as a new one, whatever it last met, and where it last stopped.
fn une_marche_gardee_va_comme_une_neuve<R: Reel>() {
    let mut surfaces = 0;
    let faire = |alea: &mut Hasard| {
        let scene = scene::<R>(alea);
        let chemins = alea.liste(20, |alea, _| {
            let pas =
                alea.liste(8, |alea, _| if alea.bool() { entre(alea, 0.0, 2.0) } else { 9.0 });
            // Half of them know their source less well, and may touch what is there at once.
            let flou = *alea.choix(&[0.0, 0.5]) * scene.ecart;
            let depart = depart(alea, &scene).avec_flou(R::depuis_f64(flou)).unwrap();
            (depart, pas, direction(alea))
        });
        (scene, chemins)
    };
    pour_chaque(cas(2_000), faire, |(scene, chemins)| {
        let neuve = || Marche::new(Monde::de_liste(&scene.objets), &scene.matieres);
        let mut gardee = neuve();
        for (rayon, pas, tour) in chemins {
            let mut aller = |marche: &mut Marche<'_, R>| {
                let mut vus = vec![];
                marche.partir(rayon);
                for &pas in &pas {
                    let surface = marche.avancer(R::depuis_f64(pas)).unwrap();
                    match &surface {
                        Some(surface) => {
                            surfaces += 1;
                            let _ = marche.passer(surface).unwrap();
                        }
                        None => marche.tourner(arrondi(tour)).unwrap(),
                    }
                    vus.push((surface, marche.rayon(), marche.milieu()));
                }
                vus
            };
            assert_eq!(aller(&mut gardee), aller(&mut neuve()));
        }
    });
    assert!(surfaces > 10_000, "{surfaces}");
}

en_f32_et_f64!(une_marche_gardee_va_comme_une_neuve);

/// The error of a face far away says nothing of the next start, at a surface.
#[test]
fn d_une_face_lointaine_rien_ne_reste() {
    let (boule, loin) = (sphere(Vecteur::NUL, 2.0_f32), mur(Vecteur::X * -2e6, Vecteur::X));
    let (objets, matieres) = ([boule, loin], [pleine(0, 1.5)]);
    let neuve = || Marche::new(Monde::de_liste(&objets), &matieres);
    let mut gardee = neuve();
    gardee.partir(Rayon::new(Vecteur::Y * 9.0, -Vecteur::X).unwrap());
    let surface = gardee.avancer(f32::INFINITY).unwrap().unwrap();
    assert_eq!(surface.objet, 1);
    for mut marche in [neuve(), gardee] {
        // Outward from the ball, and back after a step of 1.
        marche.partir(Rayon::new(Vecteur::Y * 2.0, Vecteur::Y).unwrap());
        assert!(marche.avancer(1.0).unwrap().is_none());
        marche.tourner(-Vecteur::Y).unwrap();
        let retour = marche.avancer(f32::INFINITY).unwrap().unwrap();
        assert_eq!((retour.objet, retour.distance), (0, 1.0));
    }
}
