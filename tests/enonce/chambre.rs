//! No ray leaves a closed room (lemma 22): neither paths whose every bounce is aimed at a seam, nor shadow rays to
//! lamps beyond the walls, in rooms of half-spaces and of boxes that overlap, straight and turned, with furniture that
//! stands flush.

use commun::chemins::{Pas, Suite, suivre};
use commun::fabrique::{avec_arbre, boite, boite_droite, mur, murs, sphere, v};
use commun::facons::comparer;
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::oracle::Exact;
use commun::passages::{flou_du_point, flou_propre, profondeur};
use commun::regimes::{deux_puissance, direction, entre};
use commun::tolerances::{promesses, u};
use commun::{Bits, arrondi, cas, en_f32_et_f64};
use lancer_rayon::pour_les_tests::{
    ARRONDI_HAUTEUR, FLOU_DISTANCE, FLOU_POINT, FLOU_PROPRE, PAS_ARRONDI,
};
use lancer_rayon::{
    Intersection, Monde, NoIntersection, ObjetRay, PlanGeo, Rayon, Reel, Rotation, Texture,
    Vecteur, premiere_intersection,
};
use recettes::milieux::{Derriere, Marche, Matiere};

/// Walls, then furniture, and the seams between them, towards whose points rays are sent.
#[derive(Debug)]
struct Chambre<R> {
    objets: Vec<ObjetRay<R>>,
    /// Segments in which two surfaces meet.
    coutures: Vec<[Vecteur; 2]>,
    tour: Rotation<R>,
    milieu: Vecteur,
}

/// How a path goes on: it bounces towards a seam, or it flies part of its way, ending in mid-air or within rounding of
/// the wall, and turns towards the seam or anywhere. A lamp beyond the walls throws shadows.
type Etape<R> = (Vecteur<R>, Option<(f64, Vecteur<R>)>, Vecteur<R>);
type Chemin<R> = (Rayon<R>, Vec<Etape<R>>);

impl<R: Reel> Chambre<R> {
    /// The inside is a cube of side 2 about O, turned and then moved.
    fn new(alea: &mut Hasard) -> Self {
        let angles = direction(alea) * if alea.bool() { 0.0 } else { 3.0 };
        let tour = Rotation::new(arrondi(angles)).unwrap();
        let loin = *alea.choix(&[0.0, 1.0, 100.0]);
        let milieu = direction(alea) * loin;
        // Each box reaches beyond the corners of the room, sometimes by hardly more than the error of a place after a
        // long path.
        let peu = (4096.0 * u::<R>() * loin).max(1e-3);
        let boites = [None, Some([0.4, 0.2]), Some([0.4, peu])][alea.usize(0..3)];
        let murs = murs(arrondi(milieu), tour, 2.0, boites);
        let objets = murs.into_iter().map(ObjetRay::from).collect();
        let mut chambre = Self { objets, coutures: vec![], tour, milieu };
        // The twelve edges of the cube.
        for axe in 0..3 {
            for (a, b) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
                let bout = |c: f64| {
                    let mut p = [c; 3];
                    (p[(axe + 1) % 3], p[(axe + 2) % 3]) = (a, b);
                    Vecteur::from(p)
                };
                chambre.couture(bout(-1.0), bout(1.0));
            }
        }
        for _ in 0..alea.usize(1..4) {
            chambre.coffre(alea);
        }
        // A ball that lies on the floor.
        let r = 0.05 + 0.2 * alea.f64();
        let c = v(0.5 * alea.f64(), r - 1.0, 0.6);
        chambre.objets.push(sphere(arrondi(chambre.place(c)), R::depuis_f64(r)));
        chambre.couture(c - v(0.0, r, 0.0), c - v(1e-6, r, 0.0));
        chambre
    }

    /// A chest on the floor, perhaps against a wall, and one on top of it.
    fn coffre(&mut self, alea: &mut Hasard) {
        let [l, h, p] = [(); 3].map(|()| 0.1 + 0.5 * alea.f64());
        let (x, z) = (1.6 * alea.f64() - 0.8, if alea.bool() { p / 2.0 - 1.0 } else { 0.3 });
        for (c, cotes) in
            [(v(x, h / 2.0 - 1.0, z), v(l, h, p)), (v(x, 1.5 * h - 1.0, z), v(l / 2.0, h, p / 2.0))]
        {
            self.objets.push(boite(arrondi(self.place(c)), cotes, self.tour));
        }
        for y in [-1.0, h - 1.0] {
            let [a, b, c, d] = [(-l, -p), (l, -p), (l, p), (-l, p)]
                .map(|(dx, dz)| v(x + dx / 2.0, y, z + dz / 2.0));
            for [a, b] in [[a, b], [b, c], [c, d], [d, a]] {
                self.couture(a, b);
            }
        }
    }

    fn place(&self, p: Vecteur) -> Vecteur {
        let [x, y, z] = self.tour.axes().map(Vecteur::vers_f64);
        x * p.x + y * p.y + z * p.z + self.milieu
    }

    fn couture(&mut self, a: Vecteur, b: Vecteur) {
        self.coutures.push([self.place(a), self.place(b)]);
    }

    /// A point of a seam or, more often, beside it.
    fn cible(&self, alea: &mut Hasard) -> Vecteur<R> {
        let [a, b] = *alea.choix(&self.coutures);
        let p = a + (b - a) * alea.f64();
        let peu = direction(alea) * deux_puissance(alea, -54.0, -8.0);
        arrondi(if alea.u8(0..4) == 0 { p } else { p + peu })
    }

    /// The room with up to `n` paths from the air towards seams.
    fn avec_chemins(self, alea: &mut Hasard, n: usize, pas: usize) -> (Self, Vec<Chemin<R>>) {
        let libre = Monde::de_liste(&self.objets);
        let chemins = alea.liste(n, |alea, _| {
            let depart = arrondi::<R>(self.place(direction(alea) * 0.9));
            let rayon = Rayon::new(depart, self.cible(alea) - depart).unwrap();
            let etapes = alea.liste(pas, |alea, _| {
                let (cible, ailleurs) = (self.cible(alea), arrondi(direction(alea)));
                let part = *alea.choix(&[0.5, 1.0 - 4.0 * u::<R>(), 1.0]);
                let vers = if alea.bool() { Vecteur::NUL } else { ailleurs };
                let vol = alea.bool().then_some((part, vers));
                let lampe = self.milieu + direction(alea) * (4.0 + 9.0 * alea.f64());
                (cible, vol, arrondi(lampe))
            });
            (rayon, etapes)
        });
        let dehors = |(rayon, _): &Chemin<R>| !libre.contient(rayon.source());
        let chemins = chemins.into_iter().filter(dehors).collect();
        (self, chemins)
    }

    /// How deep a point lies in the object that holds it deepest, beyond `flou` and the rounding of the object.
    fn exces(&self, point: Vecteur<R>, flou: R) -> f64 {
        let profond = |objet| profondeur(objet, point) - flou.vers_f64();
        self.objets.iter().map(profond).fold(f64::MIN, f64::max)
    }
}

/// The next ray of a path, towards this point if that is outward, otherwise mirrored.
fn rebond<R: Reel>(cible: Vecteur<R>, touche: &Intersection<R>) -> Option<Rayon<R>> {
    let (vers, n) = (cible - touche.point(), touche.normale());
    let le_long = vers.produit_scalaire(n);
    let vers = if le_long < R::ZERO { vers - (n + n) * le_long } else { vers };
    touche.secondaire(vers).ok()
}

/// Where a flight ends, some rays that forget what they knew of their place leave the room.
fn aucun_chemin_ne_quitte_une_chambre<R: Bits>() {
    let [mut pas, mut d_emblee, mut ombres, mut dehors_sans_flou] = [0; 4];
    let faire = |alea: &mut Hasard| Chambre::<R>::new(alea).avec_chemins(alea, 60, 16);
    pour_chaque(cas(20), faire, |(chambre, chemins)| {
        let (arbre, liste) = (avec_arbre(&chambre.objets), Monde::de_liste(&chambre.objets));
        let mut rayons = vec![];
        for (mut rayon, etapes) in chemins {
            for (cible, vol, lampe) in etapes {
                let Ok(touche) = arbre.premiere_intersection(&rayon) else {
                    panic!("{rayon:?} leaves the room");
                };
                let t = touche.distance();
                d_emblee += usize::from(t == R::ZERO);
                // P has a rounding of its own, which the next δ holds.
                let exces = chambre.exces(touche.point(), rayon.flou());
                assert!(exces <= flou_du_point(t, touche.point()), "{exces:e}: {rayon:?}");
                if let Ok(ombre) = touche.vers_lumiere(lampe) {
                    let occulte = [arbre, liste].map(|monde| monde.est_occulte(&ombre));
                    assert_eq!(occulte, [true; 2], "{ombre:?}");
                    ombres += 1;
                }
                (pas, _) = (pas + 1, rayons.push(rayon));
                rayon = if let Some((part, ailleurs)) = vol {
                    let fin = t * R::depuis_f64(part);
                    assert!(!arbre.est_occulte(&rayon.jusqu_a(fin).unwrap()), "{rayon:?}");
                    let la = cible - rayon.point(fin);
                    let vers = if ailleurs == Vecteur::NUL { la } else { ailleurs };
                    let Ok(suivant) = rayon.bifurque(fin, vers) else { break };
                    let oublieux = Rayon::new(suivant.source(), vers).unwrap();
                    let sort = arbre.premiere_intersection(&oublieux).is_err();
                    dehors_sans_flou += usize::from(sort);
                    suivant
                } else {
                    let Some(suivant) = rebond(cible, &touche) else { break };
                    // The ray never touches what it left.
                    let quitte = chambre.objets[touche.indice()];
                    assert_eq!(quitte.intersection(&suivant), Err(NoIntersection), "{suivant:?}");
                    suivant
                };
            }
        }
        let _ = comparer(&chambre.objets, &rayons[..rayons.len().min(128)]);
    });
    assert!(pas > 3_000 && ombres > 500 && d_emblee > 20 && dehors_sans_flou > 20);
}

en_f32_et_f64!(aucun_chemin_ne_quitte_une_chambre);

/// The furniture is of glass. Light goes through it by the recipe `milieux`, perhaps mirrored inside, and on from wall
/// to wall, aimed at seams. Beside an edge it may be out where it should be in, but it never leaves the room.
fn a_travers_du_verre_aucun_chemin_ne_quitte_une_chambre<R: Reel>() {
    let [mut pas, mut traverses, mut reflets] = [0; 3];
    let faire = |alea: &mut Hasard| Chambre::<R>::new(alea).avec_chemins(alea, 100, 40);
    pour_chaque(cas(20), faire, |(chambre, chemins)| {
        let verre = Matiere::Pleine { priorite: 0, indice: 1.5 };
        let matieres: Vec<_> = (0..chambre.objets.len())
            .map(|i| if i < 6 { Matiere::Opaque } else { verre })
            .collect();
        let mut marche = Marche::new(avec_arbre(&chambre.objets), &matieres);
        for (rayon, etapes) in chemins {
            marche.partir(rayon);
            for (cible, vol, _) in etapes {
                pas += 1;
                let rayon = marche.rayon();
                let Some(surface) = marche.avancer(R::INFINI).unwrap() else {
                    panic!("{rayon:?} leaves the room");
                };
                let touche = surface.touche;
                let (la, n) = (cible - touche.point(), touche.normale());
                let entre = rayon.direction().produit_scalaire(n) < R::ZERO;
                let de_la = la.produit_scalaire(n) < R::ZERO;
                if surface.derriere == Derriere::Opaque || (entre && !de_la) {
                    let Some(suivant) = rebond(cible, &touche) else { break };
                    marche.rester(suivant);
                } else if entre || (vol.is_none() && !de_la) {
                    traverses += 1;
                    let Ok(suivant) = touche.secondaire(la) else { break };
                    marche.entrer(suivant);
                } else {
                    reflets += 1;
                    marche.rester(touche.reflechi(rayon.direction()).unwrap());
                }
            }
        }
    });
    assert!(pas > 50_000 && traverses > 2_000 && reflets > 2_000, "{pas} {traverses} {reflets}");
    println!("{pas} {traverses} {reflets}");
}

en_f32_et_f64!(a_travers_du_verre_aucun_chemin_ne_quitte_une_chambre);

/// A chain that `temoin_f64` widens on its way, together with its room. Its start may lie as deep as `f32` lets it, and
/// some rays no longer touch what they touched at once. With a δ larger by the o of `f32` no chain leaves.
#[test]
fn une_chaine_elargie_reste_si_son_flou_est_plus_grand() {
    let (mut d_emblee, mut oublies, mut rebonds) = (0, 0, 0);
    let faire = |alea: &mut Hasard| Chambre::<f32>::new(alea).avec_chemins(alea, 200, 8);
    pour_chaque(cas(20), faire, |(Chambre { objets, .. }, chemins)| {
        let larges: Vec<_> = objets.iter().map(|objet| objet.temoin_f64()).collect();
        let (monde, large) = (Monde::de_liste(&objets), Monde::de_liste(&larges));
        let propre = objets.iter().map(flou_propre).fold(0.0, f64::max);
        for (mut rayon, etapes) in chemins {
            for (i, (cible, ..)) in etapes.iter().enumerate() {
                let touche = monde.premiere_intersection(&rayon).unwrap();
                let mut suite = rayon.temoin_f64();
                if touche.distance() == 0.0 {
                    d_emblee += 1;
                    let la = larges[touche.indice()].intersection(&suite);
                    oublies += u32::from(la.map(|t| t.distance()) != Ok(0.0));
                }
                if suite.flou() > 0.0 {
                    suite = suite.avec_flou(suite.flou() + propre).unwrap();
                }
                for (cible, ..) in etapes[i..].iter().take(4) {
                    let touche = large.premiere_intersection(&suite);
                    let Ok(touche) = touche else { panic!("{suite:?} leaves the room") };
                    let Some(suivant) = rebond(cible.vers_f64(), &touche) else { break };
                    (rebonds, suite) = (rebonds + 1, suivant);
                }
                let Some(suivant) = rebond(*cible, &touche) else { break };
                rayon = suivant;
            }
        }
    });
    assert!(oublies > 10 && rebonds > 1_000, "{oublies} of {d_emblee}, {rebonds}");
}

/// A turn at a wall through O, among numbers so small that 15u·t is lost. The ray finds the wall all the same.
fn un_virage_pres_de_l_origine_trouve_le_mur<R: Reel>() {
    let mut virages = 0;
    let faire = |alea: &mut Hasard| {
        let petit = R::ETA * R::depuis_f64(deux_puissance(alea, 1.0, 24.0));
        let [n, source, vers] = [(); 3].map(|()| arrondi::<R>(direction(alea)));
        (mur(Vecteur::NUL, n), Rayon::new(source * petit, vers).unwrap())
    };
    pour_chaque(cas(2_000), faire, |(mur, rayon)| {
        let Ok(touche) = mur.intersection(&rayon) else { return };
        let suite = rayon.bifurque(touche.distance(), -touche.normale()).unwrap();
        assert!(mur.intersection(&suite).is_ok(), "{suite:?}");
        virages += 1;
    });
    assert!(virages > 100, "{virages}");
}

en_f32_et_f64!(un_virage_pres_de_l_origine_trouve_le_mur);

/// A pillar stands on a globe up to a million times as large, whose place the type knows only to some parts of its
/// radius. Rays that leave the pillar beside the seam, downward, all find the globe.
fn un_pilier_sur_un_globe_ne_laisse_rien_passer<R: Reel>() {
    let r = R::depuis_f64;
    let (mut suites, mut d_emblee) = (0, 0);
    let faire = |alea: &mut Hasard| {
        let rayon_du_globe = deux_puissance(alea, 10.0, 20.0);
        // The pole that the pillar stands on is anywhere.
        let pole = direction(alea);
        let [x, y, z] = Rotation::<f64>::entre(Vecteur::Y, pole).unwrap().axes();
        let globe = sphere(arrondi(-pole * rayon_du_globe), r(rayon_du_globe));
        let tour = Rotation::depuis_matrice([x, y, z].map(|a| <[f64; 3]>::from(a).map(r))).unwrap();
        let objets = [globe, boite(arrondi(pole * 0.9), v(0.5, 2.0, 0.5), tour)];
        let rayons = alea.liste(8, |alea, _| {
            // Beside the seam, about as high as the place of the globe is uncertain.
            let haut = (rayon_du_globe * u::<R>() * deux_puissance(alea, -3.0, 12.0)).min(0.5);
            let cote = 0.4 * alea.f64() - 0.2;
            let creux = (0.0625 + cote * cote) / (2.0 * rayon_du_globe);
            let pied = x * 0.25 + z * cote + y * (haut - creux);
            let oeil = pied + x * 2.0 + y * 0.5;
            let vers = x * alea.f64() - y * (0.05 + alea.f64()) + z * (alea.f64() - 0.5);
            (Rayon::new(arrondi(oeil), arrondi(pied - oeil)).unwrap(), arrondi(vers))
        });
        (objets, rayons)
    };
    pour_chaque(cas(2_000), faire, |(objets, rayons)| {
        let monde = Monde::de_liste(&objets);
        for (rayon, vers) in rayons {
            let Ok(touche) = monde.premiere_intersection(&rayon) else { continue };
            if touche.indice() == 1 {
                let sol = monde.premiere_intersection(&touche.secondaire(vers).unwrap());
                assert_eq!(sol.map(|touche| touche.indice()), Ok(0), "{rayon:?}");
                d_emblee += usize::from(sol.unwrap().distance() == R::ZERO);
                suites += 1;
            }
        }
    });
    assert!(suites > 500 && d_emblee > 10, "{suites} {d_emblee}");
}

en_f32_et_f64!(un_pilier_sur_un_globe_ne_laisse_rien_passer);

/// Built: a source within δ of an edge inside a box, or in a plate thinner than δ. Held: a ray that goes in touches the
/// nearer face at once. A ray that leaves by a face as near touches nothing, nor does one from farther in.
fn un_coin_que_le_rayon_quitte_n_est_pas_touche<R: Reel>() {
    let eps = 64.0 * u::<R>();
    let cube = boite_droite(Vecteur::NUL, v(1.0, 1.0, 1.0));
    let touche = |objet: &ObjetRay<R>, de: Vecteur, vers: Vecteur| {
        let rayon = Rayon::new(arrondi(de), arrondi(vers)).unwrap();
        assert_eq!(objet.intersection(&rayon), Err(NoIntersection));
        let rayon = rayon.avec_flou(R::depuis_f64(32.0 * eps)).unwrap();
        let touche = objet.intersection(&rayon).ok()?;
        assert_eq!(touche.distance(), R::ZERO);
        Some(<[f64; 3]>::from(touche.normale().vers_f64()))
    };
    // The place beside the lower right edge, 2 eps from the right side and 1 above the bottom.
    let coin = v(0.5 - 2.0 * eps, -0.5 + eps, 0.1);
    assert_eq!(touche(&cube, coin, v(-1.0, 1.0, 0.0)), Some([0.0, -1.0, 0.0]));
    assert_eq!(touche(&cube, coin, v(-1.0, -1.0, 0.0)), None); // out through the bottom
    assert_eq!(touche(&cube, coin, v(1.0, 1.0, 0.0)), None); // out through the side
    assert_eq!(touche(&cube, coin, v(0.0, 1.0, 0.0)), None); // along the side
    assert_eq!(touche(&cube, coin, v(0.0, 0.0, 1.0)), None); // along the edge
    // The middle of the bottom, and a place deeper than δ and the rounding of the box.
    assert_eq!(touche(&cube, v(0.1, -0.5 + eps, 0.1), v(1.0, 1.0, 0.0)), Some([0.0, -1.0, 0.0]));
    assert_eq!(touche(&cube, v(0.1, -0.5 + 64.0 * eps, 0.1), v(1.0, 1.0, 0.0)), None);
    // A plate across y, with the source nearer to its bottom, then to its top.
    let plaque = boite_droite(Vecteur::NUL, v(1.0, 8.0 * eps, 1.0));
    assert_eq!(touche(&plaque, v(0.1, -eps, 0.1), v(0.1, 1.0, 0.0)), Some([0.0, -1.0, 0.0]));
    assert_eq!(touche(&plaque, v(0.1, eps, 0.1), v(0.1, 1.0, 0.0)), None);
    // A ball, and a half-space.
    let boule = sphere(Vecteur::NUL, R::UN);
    assert_eq!(touche(&boule, v(0.0, -1.0 + eps, 0.0), v(0.0, 1.0, 0.0)), Some([0.0, -1.0, 0.0]));
    assert_eq!(touche(&boule, v(0.0, -1.0 + eps, 0.0), v(0.0, -1.0, 0.0)), None);
    assert_eq!(touche(&boule, v(0.0, -1.0 + 64.0 * eps, 0.0), v(0.0, 1.0, 0.0)), None);
    let sol = ObjetRay::from(PlanGeo::new(Rotation::IDENTITE, R::ZERO, Texture(0)).unwrap());
    assert_eq!(touche(&sol, v(0.0, 0.0, -eps), v(0.0, 1.0, -1.0)), Some([0.0, 0.0, 1.0]));
    assert_eq!(touche(&sol, v(0.0, 0.0, -eps), v(0.0, 1.0, 0.0)), None);
    assert_eq!(touche(&sol, v(0.0, 0.0, -40.0 * eps), v(0.0, 1.0, -1.0)), None);
}

en_f32_et_f64!(un_coin_que_le_rayon_quitte_n_est_pas_touche);

/// A ray runs along under a face of a box, less deep than its δ and the rounding of the box, and a floor rises over
/// that face by a little less. There the two overlap by only 1.1 to 1.3 times the bound of one of them. Both rays left
/// before only nearer faces spared their box.
#[test]
fn un_rayon_le_long_d_une_face_n_en_sort_pas() {
    let suite = |objets: &[ObjetRay], source| {
        let monde = Monde::de_liste(objets);
        let rayon = Rayon::new(source, v(-1.0, 0.0, 0.0)).unwrap();
        let touche = monde.premiere_intersection(&rayon).unwrap();
        assert_eq!(touche.indice(), 0);
        let suite = rayon.bifurque(touche.distance(), rayon.direction()).unwrap();
        monde.premiere_intersection(&suite)
    };
    let haut = v(0.0, 1.0, 0.0);
    let grande = boite_droite(v(-1000.0, 1000.0, 0.0), v(2000.0, 2000.0, 2000.0));
    let sol = |y| mur(v(0.0, y, 0.0), haut);
    // 44u·Σl is 1.46e-11, and half of that 7.3e-12.
    let source = v(1.0, 1.25e-11, 0.0);
    assert_eq!(suite(&[grande, sol(1e-11)], source).map(|t| t.distance()), Ok(0.0));
    // Where the face is nearer than that half, the ray runs along as if outside the box, so a floor that overlaps by
    // less leaks.
    let source = v(1.0, 7e-12, 0.0);
    assert_eq!(suite(&[grande, sol(6e-12)], source), Err(NoIntersection));

    // In `f32`, with a turned face: the overlap is 133u, and 44u·Σl are 132u.
    let tour = Rotation::new(Vecteur::new(0.810_820_16_f32, 0.0, 0.0)).unwrap();
    let centre = Vecteur::new(-1.0_f32, 0.751_325_67, -0.665_526_6);
    let couche = |[x, y, z]: [Vecteur<f32>; 3]| [z, x, y].map(<[f32; 3]>::from);
    let couche = Rotation::depuis_matrice(couche(tour.axes())).unwrap();
    let sol = PlanGeo::new(couche, -7.901_905e-6, Texture(0)).unwrap();
    let objets = [boite(centre, v(2.0, 2.0, 2.0), tour), sol.into()];
    let source = Vecteur::new(2.384_185_8e-7_f32, 5.443_655_5e-6, -5.727_715_2e-6);
    let rayon = Rayon::new(source, v(-1.0, 0.0, 0.0)).unwrap();
    let monde = Monde::de_liste(&objets);
    let touche = monde.premiere_intersection(&rayon).unwrap();
    let suite = rayon.bifurque(touche.distance(), rayon.direction()).unwrap();
    assert!(!objets[1].contient(suite.source()), "the ray goes along over the floor");
    assert_eq!(monde.premiere_intersection(&suite).map(|t| t.distance()), Ok(0.0));
}

/// Rays from far away straight at the seam of two boxes, so that none meets a side within it: how the boxes are turned,
/// where the rays start, and where they go.
fn vers_un_joint<R: Reel>(alea: &mut Hasard) -> (Rotation<R>, [f64; 2], Vec<[f64; 2]>) {
    let tour = Rotation::new(arrondi(direction(alea) * 3.0)).unwrap();
    let deux = |alea: &mut Hasard| [(); 2].map(|()| entre(alea, -1.0, 1.0));
    (tour, deux(alea), alea.liste(8, |alea, _| deux(alea)))
}

/// The δ by which two walls must reach into each other is that of the next ray. A ray from far away has no δ, and
/// passes between walls that reach in by four times their o: on its way it loses what a ray that started there would
/// know it had lost.
fn un_rayon_venu_de_loin_perd_son_chemin<R: Reel>() {
    let mut passent = 0;
    pour_chaque(cas(500), vers_un_joint::<R>, |(tour, [haut, cote], cibles)| {
        let [x, y, z] = tour.axes().map(|axe| axe.vers_f64());
        let source = arrondi::<R>(z * 1000.0 + y * (100.0 * haut) + x * (1e5 * u::<R>() * cote));
        let coffre = |c| boite(arrondi(x * c), v(1.0, 1.0, 0.2), tour);
        let propre = flou_propre(&coffre(0.0));
        let flou = flou_du_point(R::depuis_f64(1010.0), v(0.5, 0.5, 0.5));
        for (large, assez) in [(4.0 * propre, false), (2.0 * (flou + propre), true)] {
            let murs = [0.5 - large / 2.0, large / 2.0 - 0.5].map(coffre);
            for [haut, cote] in &cibles {
                let cible = z * 0.1 + y * (0.3 * haut) + x * (large * cote);
                let rayon = Rayon::new(source, arrondi::<R>(cible) - source).unwrap();
                let passe = premiere_intersection(&murs, &rayon).is_err();
                assert!(!(passe && assez), "{rayon:?} passes {murs:?}");
                passent += u32::from(passe);
            }
        }
    });
    assert!(passent > cas(20));
}

en_f32_et_f64!(un_rayon_venu_de_loin_perd_son_chemin);

/// Boxes whose corners are points of a grid and half-spaces through its lines, all flush, with rays towards points and
/// lines of the grid or beside them.
fn a_fleur<R: Reel>(alea: &mut Hasard) -> (Vec<ObjetRay<R>>, f64, Vec<Rayon<R>>) {
    let pas = *alea.choix(&[1.0, 0.1, 1.0 / 3.0, 0.7]);
    let angles = direction(alea) * *alea.choix(&[0.0, 3.0, 3.0]);
    let tour = Rotation::<R>::new(arrondi(angles)).unwrap();
    let [x, y, z] = tour.axes().map(|axe| axe.vers_f64());
    let milieu = direction(alea) * *alea.choix(&[0.0, 0.0, 1.0, 100.0]);
    let place = |[a, b, c]: [f64; 3]| arrondi::<R>(milieu + (x * a + y * b + z * c) * pas);
    let murs = alea.usize(0..4);
    let mut objets: Vec<_> = tour.axes()[..murs].iter().map(|&n| mur(place([0.0; 3]), n)).collect();
    for _ in 0..alea.usize(1..5) {
        let [bas, cotes] = [0, 1].map(|de| [(); 3].map(|()| f64::from(alea.u8(de..3))));
        let centre = core::array::from_fn(|i| bas[i] + cotes[i] / 2.0);
        objets.push(boite(place(centre), arrondi(Vecteur::from(cotes) * pas), tour));
    }
    alea.melanger(&mut objets);
    let rayons = alea.liste(200, |alea, _| {
        let mut cible = [(); 3].map(|()| f64::from(alea.u8(0..5)));
        cible[alea.usize(0..3)] += if alea.bool() { alea.f64() } else { 0.0 };
        let peu = if alea.bool() { 0.0 } else { deux_puissance(alea, -56.0, 0.0) };
        let cible = place((Vecteur::from(cible) + direction(alea) * peu).into());
        let source = place([(); 3].map(|()| 8.0 * alea.f64() - 1.5));
        Rayon::new(source, cible - source)
    });
    (objets, pas, rayons.into_iter().flatten().collect())
}

/// All of the solids are mirrors. No ray stays in a seam, unless its δ is no longer small beside the solids: the
/// nearest of the faces within δ by which the ray goes in may be one that another solid hides.
fn aucun_solide_a_fleur_ne_garde_un_rayon<R: Reel>() {
    let (mut rayons, mut au_bout, mut d_emblee, mut en_suite) = (0, 0, 0, 0);
    pour_chaque(cas(2_000), a_fleur::<R>, |(objets, pas, depuis)| {
        let monde = Monde::de_liste(&objets);
        for mut rayon in depuis.into_iter().filter(|rayon| !monde.contient(rayon.source())) {
            rayons += 1;
            let mut ici = 0;
            for _ in 0..1_000 {
                let Ok(touche) = monde.premiere_intersection(&rayon) else {
                    au_bout += 1;
                    break;
                };
                ici = if touche.distance() == R::ZERO { ici + 1 } else { 0 };
                if rayon.flou().vers_f64() > pas / 64.0 {
                    break;
                }
                assert!(ici < 512, "{rayon:?} stays");
                (d_emblee, en_suite) = (d_emblee + u32::from(ici > 0), en_suite.max(ici));
                let Ok(suite) = touche.reflechi(rayon.direction()) else { break };
                rayon = suite;
            }
        }
    });
    println!("{rayons} chains, {d_emblee} hits at once, at most {en_suite} in a row");
    assert!(au_bout > 9 * rayons / 10 && d_emblee > rayons / 500 && en_suite > 3);
}

en_f32_et_f64!(aucun_solide_a_fleur_ne_garde_un_rayon);

/// A ray that comes to the foot of a box at a slope of some u, along the mirror on which the box stands, stays in the seam
/// until its δ is about as large as the box, and no longer.
fn rasant_un_rayon_reste_dans_un_joint<R: Reel>() {
    let (mut pris, mut en_suite) = (0, 0);
    let faire = |alea: &mut Hasard| {
        let tour = Rotation::<R>::new(arrondi(direction(alea) * 3.0)).unwrap();
        let milieu = direction(alea) * *alea.choix(&[0.0, 1.0, 10.0]);
        let pente = 8.0 * u::<R>() * alea.f64();
        (tour, milieu, pente, pente * entre(alea, 1.5, 2.5))
    };
    pour_chaque(cas(5_000), faire, |(tour, milieu, pente, haut)| {
        let place = |x, y, z| arrondi::<R>(milieu) + tour.appliquer(v(x, y, z));
        let sol = mur(place(0.0, 0.0, 0.0), tour.axes()[1]);
        let objets = [sol, boite(place(1.0, 0.5, 0.0), v(1.0, 1.0, 2.0), tour)];
        let vers = tour.appliquer(v(1.0, -pente, 0.1));
        let (mut rayon, mut ici) = (Rayon::new(place(-1.0, haut, 0.0), vers).unwrap(), 0);
        while let Ok(touche) = premiere_intersection(&objets, &rayon) {
            ici = if touche.distance() == R::ZERO { ici + 1 } else { 0 };
            assert!(ici < 1_500, "{rayon:?} stays");
            pris += u32::from(ici == 146);
            en_suite = en_suite.max(ici);
            rayon = touche.reflechi(rayon.direction()).unwrap();
        }
    });
    println!("{pris} were caught, with at most {en_suite} hits at once in a row");
    assert!(pris > 20);
}

en_f32_et_f64!(rasant_un_rayon_reste_dans_un_joint);

/// Paths of every kind among flush solids: each ray knows of its start what the pages say, and lies no deeper in any
/// solid.
fn un_chemin_sait_ou_il_est<R: Bits>() {
    let faire = |alea: &mut Hasard| {
        let (objets, pas, rayons) = a_fleur::<R>(alea);
        let chemin = alea.liste(7, |alea, _| {
            let (vers, distance) =
                (arrondi(direction(alea)), R::depuis_f64(3.0 * pas * alea.f64()));
            Pas { suite: *alea.choix(&Suite::TOUTES), vers, vise: alea.bool(), distance }
        });
        (objets, rayons, chemin)
    };
    let mut suivis = 0;
    pour_chaque(cas(500), faire, |(objets, rayons, chemin)| {
        let monde = Monde::de_liste(&objets);
        for rayon in rayons.into_iter().filter(|rayon| !monde.contient(rayon.source())) {
            suivis += suivre(monde, rayon, false, &chemin).len();
            // The same from inside.
            suivis += suivre(monde, rayon.dedans(), true, &chemin).len();
        }
    });
    assert!(suivis > 250_000, "{suivis}");
}

en_f32_et_f64!(un_chemin_sait_ou_il_est);

/// What the pages say of a ball that lies on a mirror: light that grazes the mirror runs into the wedge between the
/// two, where it is mirrored on for as long as one follows it.
#[test]
fn sous_une_boule_un_rayon_rebondit_sans_fin() {
    let objets = [sphere(Vecteur::Y, 1.0), mur(Vecteur::NUL, Vecteur::Y)];
    let d = v(-0.9109670993830367, -0.004708161605405825, 0.4124521512320597);
    let mut rayon =
        Rayon::new(v(1.978686596307599, 0.010226468407299459, -0.8958759803881442), d).unwrap();
    for _ in 0..1_000 {
        let touche = Monde::de_liste(&objets).premiere_intersection(&rayon).unwrap();
        rayon = touche.reflechi(rayon.direction()).unwrap();
    }
    assert!(rayon.source().longueur() < 0.1 && rayon.flou() < 1e-10, "{rayon:?}");
}

/// By how much δ grows at most in one bounce without a hit at once, in a cube of side 10 about O, turned anyhow, with
/// walls of boxes that are 0.2 thick and reach 0.1 beyond its corners; and o of a wall. By M4, M6, M7 and lemma 6.
fn par_rebond_dans_dix_metres(u: f64) -> [f64; 2] {
    // S and P are in the cube; C is 5.1 away, and the wall reaches 5.1 from it.
    let (t, p, p_1) = (10.0 * 3_f64.sqrt(), 5.0 * 3_f64.sqrt(), 15.0);
    let (f, cp) = (p + 5.1, (2.0 * 5.1_f64.powi(2) + 0.1_f64.powi(2)).sqrt());
    let lieu = promesses::LIEU_F * f + promesses::LIEU_T * t + promesses::LIEU_P * p;
    // M2 rounds by γ_4 of ⟨N, CP⟩, which is at most |CP|; M4 adds 8u of |CP|.
    let marge = lieu + (4.1 + 2.0 * ARRONDI_HAUTEUR) * cp;
    let de_plus = marge + PAS_ARRONDI * p + FLOU_DISTANCE * t + FLOU_POINT * p_1;
    // Terms of second order are less than 60u of each.
    [de_plus, FLOU_PROPRE * (5.1 + 5.1 + 0.1)].map(|x| x * u * (1.0 + 60.0 * u))
}

/// What the pages say of a room of 10 m about O in `f32`: δ grows by up to 0.045 mm in a bounce, and o is 0.03 mm.
fn une_chambre_de_dix_metres_perd_peu_a_chaque_rebond<R: Reel>() {
    let [par_rebond, propre] = par_rebond_dans_dix_metres(u::<R>());
    let mut pire = 0.0_f64;
    let faire = |alea: &mut Hasard| {
        let tour = Rotation::<R>::new(arrondi(direction(alea) * 3.0)).unwrap();
        let boites = [Some([0.2, 0.1]), None][alea.tour % 2];
        let murs: Vec<ObjetRay<R>> =
            murs(Vecteur::NUL, tour, 10.0, boites).into_iter().map(ObjetRay::from).collect();
        let rayon = Rayon::new(Vecteur::NUL, arrondi(direction(alea))).unwrap();
        // Rays go into the farthest corner, or anywhere.
        let cibles = alea.liste(140, |alea, _| {
            let ailleurs = arrondi::<R>(direction(alea) * 5.0);
            if alea.bool() { None } else { Some(ailleurs) }
        });
        (tour.axes(), murs, rayon, cibles)
    };
    pour_chaque(cas(400), faire, |(axes, murs, mut rayon, cibles)| {
        assert!(murs.iter().all(|mur| flou_propre(mur) <= propre * (1.0 + 4.0 * u::<R>())));
        for cible in cibles {
            let touche = Monde::de_liste(&murs).premiere_intersection(&rayon).unwrap();
            let coin = axes.into_iter().fold(Vecteur::NUL, |coin, axe| {
                let loin = axe.produit_scalaire(touche.point()) < R::ZERO;
                coin + axe * R::depuis_f64(if loin { 4.99 } else { -4.99 })
            });
            let suite = touche.secondaire(cible.unwrap_or(coin) - touche.point());
            let avant = rayon.flou().vers_f64();
            rayon = suite.or_else(|_| touche.secondaire(touche.normale())).unwrap();
            let de_plus = rayon.flou().vers_f64() - avant;
            assert!(touche.distance() == R::ZERO || de_plus <= par_rebond, "{de_plus:e}");
            pire = pire.max(de_plus / par_rebond);
        }
    });
    assert!(pire > 0.6, "{pire}");
    let [par_rebond, propre] = par_rebond_dans_dix_metres(u::<f32>());
    assert!(par_rebond < 0.045e-3 && propre < 0.03e-3, "{par_rebond:e} {propre:e}");
    let rebonds = |depasse: f64| ((depasse / 2.0 - propre) / par_rebond) as u32;
    assert_eq!([rebonds(1e-3), rebonds(1e-2)], [10, 110]);
    assert!(0.5e-3 / par_rebond_dans_dix_metres(u::<f64>())[0] > 5e9);
}

en_f32_et_f64!(une_chambre_de_dix_metres_perd_peu_a_chaque_rebond);

/// A δ covers its own roundings and those with which D1 to D3 see it, however large it is beside the way and the place.
fn un_flou_ne_perd_rien<R: Reel>() {
    let nombre = |x: R, k: f64| &Exact::de(x) * &Exact::de(1.0 + k * u::<R>());
    let faire =
        |alea: &mut Hasard| [(); 3].map(|()| R::depuis_f64(deux_puissance(alea, -80.0, 20.0)));
    pour_chaque(cas(2_000), faire, |[flou, t, x]| {
        let rayon = Rayon::new(Vecteur::new(x, -x, R::ZERO), Vecteur::Z).unwrap();
        let suite = rayon.avec_flou(flou).unwrap().bifurque(t, Vecteur::X).unwrap();
        let de_plus = flou_du_point(t, suite.source()) * (1.0 - 1e-12);
        let perdu = &nombre(flou, 2.0) + &Exact::de(de_plus);
        assert!((&nombre(suite.flou(), -3.0) - &perdu).positif(), "{suite:?}");
    });
}

en_f32_et_f64!(un_flou_ne_perd_rien);
