//! No ray leaves a closed room (lemma 23): paths whose every bounce is aimed at a seam, and shadows of lamps beyond the
//! walls, in rooms of half-spaces and of boxes that overlap, straight and turned, with furniture that stands flush.

use commun::fabrique::{boite, boite_droite, mur, sphere, v};
use commun::facons::comparer;
use commun::oracle::Exact;
use commun::passages::{flou_du_point, flou_propre, profondeur};
use commun::regimes::{deux_puissance, direction};
use commun::tolerances::u;
use commun::{Bits, arrondi, cas, en_f32_et_f64};
use fastrand::Rng;
use lancer_rayon::{
    Intersection, Monde, NoIntersection, ObjetRay, PlanGeo, Rayon, Reel, Rotation, Texture,
    Vecteur, places, premiere_intersection,
};

/// Walls, then furniture; and points of the seams between them, towards which rays are sent.
struct Chambre<R> {
    objets: Vec<ObjetRay<R>>,
    /// Segments in which two surfaces meet.
    coutures: Vec<[Vecteur; 2]>,
    tour: Rotation,
    milieu: Vecteur,
}

impl<R: Reel> Chambre<R> {
    /// The inside is a cube of side 2 about O, turned and then moved.
    fn new(alea: &mut Rng) -> Self {
        let angles = direction(alea) * if alea.bool() { 0.0 } else { 3.0 };
        let tour = Rotation::new(angles).unwrap();
        let loin = [0.0, 1.0, 100.0][alea.usize(0..3)];
        let milieu = direction(alea) * loin;
        let mut chambre = Self { objets: vec![], coutures: vec![], tour, milieu };
        let de_boites = alea.bool();
        for axe in 0..3 {
            for cote in [-1.0, 1.0] {
                let mut n = [0.0; 3];
                n[axe] = cote;
                if de_boites {
                    // Each reaches beyond its corners, some by hardly more than a long path knows its place.
                    let peu = (4096.0 * u::<R>() * loin).max(1e-3);
                    let depasse = [0.2, peu][alea.usize(0..2)];
                    let mut cotes = [2.0 + 2.0 * depasse; 3];
                    cotes[axe] = 0.4;
                    chambre.boite(Vecteur::from(n) * 1.2, cotes.into());
                } else {
                    let (p, n) = (chambre.place(Vecteur::from(n)), tour.appliquer(n.into()));
                    chambre.objets.push(mur(arrondi(p), arrondi(-n)));
                }
            }
        }
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
        chambre.meubler(alea);
        chambre
    }

    /// Chests on the floor, against a wall and on each other, and balls that lie on the floor.
    fn meubler(&mut self, alea: &mut Rng) {
        for _ in 0..alea.usize(1..4) {
            let [l, h, p] = [(); 3].map(|()| 0.1 + 0.5 * alea.f64());
            let (x, z) = (1.6 * alea.f64() - 0.8, if alea.bool() { p / 2.0 - 1.0 } else { 0.3 });
            self.boite(v(x, h / 2.0 - 1.0, z), v(l, h, p));
            self.boite(v(x, 1.5 * h - 1.0, z), v(l / 2.0, h, p / 2.0));
            for y in [-1.0, h - 1.0] {
                let [a, b, c, d] = [(-l, -p), (l, -p), (l, p), (-l, p)]
                    .map(|(dx, dz)| v(x + dx / 2.0, y, z + dz / 2.0));
                for [a, b] in [[a, b], [b, c], [c, d], [d, a]] {
                    self.couture(a, b);
                }
            }
        }
        let r = 0.05 + 0.2 * alea.f64();
        let c = v(0.5 * alea.f64(), r - 1.0, 0.6);
        self.objets.push(sphere(arrondi(self.place(c)), R::depuis_f64(r)));
        self.couture(c - v(0.0, r, 0.0), c - v(1e-6, r, 0.0));
    }

    fn boite(&mut self, c: Vecteur, cotes: Vecteur) {
        let tour = Rotation::depuis_matrice(self.tour.matrice().map(|l| l.map(R::depuis_f64)));
        self.objets.push(boite(arrondi(self.place(c)), arrondi(cotes), tour.unwrap()));
    }

    fn place(&self, p: Vecteur) -> Vecteur {
        self.tour.appliquer(p) + self.milieu
    }

    fn couture(&mut self, a: Vecteur, b: Vecteur) {
        self.coutures.push([self.place(a), self.place(b)]);
    }

    /// A ray from somewhere in the air towards a seam; `None` if an object holds that place.
    fn depart(&self, alea: &mut Rng, monde: &Monde<'_, R>) -> Option<Rayon<R>> {
        let point = arrondi::<R>(self.place(direction(alea) * 0.9));
        let libre = !monde.contient(point);
        libre.then(|| Rayon::new(point, arrondi::<R>(self.cible(alea)) - point).unwrap())
    }

    /// A point of a seam, most often beside it.
    fn cible(&self, alea: &mut Rng) -> Vecteur {
        let [a, b] = self.coutures[alea.usize(..self.coutures.len())];
        let p = a + (b - a) * alea.f64();
        if alea.u8(0..4) == 0 { p } else { p + direction(alea) * deux_puissance(alea, -54.0, -8.0) }
    }

    /// How deep a point lies in the object that holds it deepest, beyond δ and the rounding of the object.
    fn exces(&self, point: Vecteur<R>, flou: R) -> f64 {
        let profond = |objet| profondeur(objet, point) - flou.vers_f64();
        self.objets.iter().map(profond).fold(f64::MIN, f64::max)
    }
}

/// The next ray of a path, towards a seam if that is outward, else mirrored.
fn rebond<R: Reel>(
    chambre: &Chambre<R>,
    alea: &mut Rng,
    touche: &Intersection<R>,
) -> Option<Rayon<R>> {
    let vers = arrondi::<R>(chambre.cible(alea) - touche.point().vers_f64());
    let n = touche.normale();
    let le_long = vers.produit_scalaire(n);
    let vers = if le_long < R::ZERO { vers - (n + n) * le_long } else { vers };
    touche.secondaire(vers).ok()
}

fn aucun_chemin_ne_quitte_une_chambre<R: Bits>() {
    let mut alea = Rng::with_seed(23);
    let (mut rebonds, mut d_emblee, mut ombres) = (0, 0, 0);
    for _ in 0..cas(20) {
        let chambre = Chambre::<R>::new(&mut alea);
        let mut memoire = vec![0.0; places(chambre.objets.len())];
        let arbre = Monde::new(&chambre.objets, &mut memoire).unwrap();
        let liste = Monde::de_liste(&chambre.objets);
        let mut rayons = vec![];
        for _ in 0..40 {
            let Some(mut rayon) = chambre.depart(&mut alea, &liste) else { continue };
            for _ in 0..16 {
                let premiere = arbre.premiere_intersection(&rayon);
                let Ok(touche) = premiere else {
                    panic!("{:?} left {:?}", rayon, chambre.objets);
                };
                d_emblee += usize::from(touche.distance() == R::ZERO);
                let exces = chambre.exces(touche.point(), rayon.flou());
                // P has its own rounding, which the next δ has.
                let permis = flou_du_point(touche.distance(), touche.point());
                assert!(exces <= permis, "{exces:e}: {rayon:?} {:?}", chambre.objets);
                rebonds += 1;
                rayons.push(rayon);
                let lampe = chambre.milieu + direction(&mut alea) * (4.0 + 9.0 * alea.f64());
                if let Ok(ombre) = touche.vers_lumiere(arrondi(lampe)) {
                    assert!(arbre.est_occulte(&ombre), "{ombre:?} {:?}", chambre.objets);
                    assert!(liste.est_occulte(&ombre), "{ombre:?} {:?}", chambre.objets);
                    ombres += 1;
                }
                let Some(suivant) = rebond(&chambre, &mut alea, &touche) else { break };
                // It never touches what it left.
                let quitte = chambre.objets[touche.indice()];
                assert_eq!(quitte.intersection(&suivant), Err(NoIntersection), "{suivant:?}");
                rayon = suivant;
            }
        }
        let _ = comparer(&chambre.objets, &rayons[..rayons.len().min(128)]);
    }
    assert!(rebonds > 1_000 && ombres > 500 && d_emblee > 20, "{rebonds} {ombres} {d_emblee}");
}

en_f32_et_f64!(aucun_chemin_ne_quitte_une_chambre);

/// A flight that ends in mid-air, or within rounding of a wall, goes on from there and stays in the
/// room. From the same points without what the ray knows of them some leave it.
fn aucun_pas_ne_quitte_une_chambre<R: Bits>() {
    let mut alea = Rng::with_seed(29);
    let (mut pas, mut dehors_sans_flou) = (0, 0);
    for _ in 0..cas(20) {
        let chambre = Chambre::<R>::new(&mut alea);
        let mut memoire = vec![0.0; places(chambre.objets.len())];
        let monde = Monde::new(&chambre.objets, &mut memoire).unwrap();
        for _ in 0..40 {
            let Some(mut rayon) = chambre.depart(&mut alea, &monde) else { continue };
            for _ in 0..16 {
                let touche = monde.premiere_intersection(&rayon);
                let Ok(touche) = touche else { panic!("{rayon:?} left {:?}", chambre.objets) };
                let t = touche.distance();
                let part = [0.5, 1.0 - 4.0 * u::<R>(), 1.0][alea.usize(0..3)];
                let fin = t * R::depuis_f64(part);
                assert!(!monde.est_occulte(&rayon.jusqu_a(fin).unwrap()), "{rayon:?}");
                let vers = if alea.bool() {
                    arrondi::<R>(chambre.cible(&mut alea)) - rayon.point(fin)
                } else {
                    arrondi(direction(&mut alea))
                };
                let Ok(suivant) = rayon.bifurque(fin, vers) else { break };
                let oublieux = Rayon::new(suivant.source(), vers).unwrap();
                dehors_sans_flou += usize::from(monde.premiere_intersection(&oublieux).is_err());
                pas += 1;
                rayon = suivant;
            }
        }
    }
    assert!(pas > 1_000 && dehors_sans_flou > 20, "{pas} {dehors_sans_flou}");
}

en_f32_et_f64!(aucun_pas_ne_quitte_une_chambre);

/// A chain that `vers_f64` widens on its way, with its room: its start may lie as deep as `f32` lets it, and some do not
/// touch what they touched at once. With a δ that is larger by the o of `f32` no chain leaves.
#[test]
fn une_chaine_elargie_reste_si_son_flou_est_plus_grand() {
    let mut alea = Rng::with_seed(64);
    let (mut d_emblee, mut oublies, mut rebonds) = (0, 0, 0);
    for _ in 0..cas(20) {
        let etroite = Chambre::<f32>::new(&mut alea);
        let objets = etroite.objets.iter().map(|objet| objet.temoin_f64()).collect();
        let (coutures, tour, milieu) = (etroite.coutures.clone(), etroite.tour, etroite.milieu);
        let large = Chambre { objets, coutures, tour, milieu };
        let monde = Monde::de_liste(&etroite.objets);
        let propre = etroite.objets.iter().map(flou_propre).fold(0.0, f64::max);
        for _ in 0..200 {
            let Some(mut rayon) = etroite.depart(&mut alea, &monde) else { continue };
            for _ in 0..8 {
                let touche = monde.premiere_intersection(&rayon).unwrap();
                let mut suite = rayon.temoin_f64();
                if touche.distance() == 0.0 {
                    d_emblee += 1;
                    let la = large.objets[touche.indice()].intersection(&suite);
                    oublies += u32::from(la.map(|t| t.distance()) != Ok(0.0));
                }
                if suite.flou() > 0.0 {
                    suite = suite.avec_flou(suite.flou() + propre).unwrap();
                }
                for _ in 0..4 {
                    let touche = Monde::de_liste(&large.objets).premiere_intersection(&suite);
                    let Ok(touche) = touche else { panic!("{suite:?} left {:?}", large.objets) };
                    let Some(suivant) = rebond(&large, &mut alea, &touche) else { break };
                    (rebonds, suite) = (rebonds + 1, suivant);
                }
                let Some(suivant) = rebond(&etroite, &mut alea, &touche) else { break };
                rayon = suivant;
            }
        }
    }
    println!("{oublies} of {d_emblee} at once are not, {rebonds} bounces");
    assert!(oublies > 10 && rebonds > 1_000, "{oublies} of {d_emblee}, {rebonds}");
}

/// A turn at a wall through O, among numbers so small that 15u·t is lost: the ray finds the wall all the same.
fn un_virage_pres_de_l_origine_trouve_le_mur<R: Reel>() {
    let mut alea = Rng::with_seed(31);
    let mut virages = 0;
    for _ in 0..cas(2_000) {
        let mur = mur(Vecteur::NUL, arrondi::<R>(direction(&mut alea)));
        let petit = R::MIN_POSITIF * R::depuis_f64(deux_puissance(&mut alea, 1.0, 24.0));
        let source = arrondi::<R>(direction(&mut alea)) * petit;
        let rayon = Rayon::new(source, arrondi(direction(&mut alea))).unwrap();
        let Ok(touche) = mur.intersection(&rayon) else { continue };
        let suite = rayon.bifurque(touche.distance(), -touche.normale()).unwrap();
        assert!(mur.intersection(&suite).is_ok(), "{mur:?} {rayon:?} {suite:?}");
        virages += 1;
    }
    assert!(virages > 100, "{virages}");
}

en_f32_et_f64!(un_virage_pres_de_l_origine_trouve_le_mur);

/// A pillar that stands on a globe a million times as large: rays that leave the pillar beside the seam, downward, all
/// find the globe, of which the type knows its place to some parts of its radius.
fn un_pilier_sur_un_globe_ne_laisse_rien_passer<R: Reel>() {
    let mut alea = Rng::with_seed(24);
    let r = R::depuis_f64;
    let (mut suites, mut d_emblee) = (0, 0);
    for _ in 0..cas(2_000) {
        let rayon_du_globe = deux_puissance(&mut alea, 10.0, 20.0);
        // The pole that the pillar stands on is anywhere.
        let pole = direction(&mut alea);
        let [x, y, z] = Rotation::<f64>::entre(Vecteur::Y, pole).unwrap().axes();
        let globe = sphere(arrondi(-pole * rayon_du_globe), r(rayon_du_globe));
        let tour = Rotation::depuis_matrice([x, y, z].map(|a| <[f64; 3]>::from(a).map(r))).unwrap();
        let objets = [globe, boite(arrondi(pole * 0.9), v(0.5, 2.0, 0.5), tour)];
        let monde = Monde::de_liste(&objets);
        for _ in 0..8 {
            // Beside the seam, by what the type knows of the place of the globe.
            let haut = (rayon_du_globe * u::<R>() * deux_puissance(&mut alea, -3.0, 12.0)).min(0.5);
            let cote = 0.4 * alea.f64() - 0.2;
            let creux = (0.0625 + cote * cote) / (2.0 * rayon_du_globe);
            let pied = x * 0.25 + z * cote + y * (haut - creux);
            let oeil = pied + x * 2.0 + y * 0.5;
            let rayon = Rayon::new(arrondi(oeil), arrondi(pied - oeil)).unwrap();
            let Ok(touche) = monde.premiere_intersection(&rayon) else { continue };
            if touche.indice() != 1 {
                continue;
            }
            let vers = x * alea.f64() - y * (0.05 + alea.f64()) + z * (alea.f64() - 0.5);
            let suite = touche.secondaire(arrondi(vers)).unwrap();
            let sol = monde.premiere_intersection(&suite);
            assert_eq!(sol.map(|touche| touche.indice()), Ok(0), "{objets:?} {rayon:?}");
            d_emblee += usize::from(sol.unwrap().distance() == R::ZERO);
            suites += 1;
        }
    }
    println!("{suites} rays, {d_emblee} at once");
    assert!(suites > 500 && d_emblee > 10, "{suites} {d_emblee}");
}

en_f32_et_f64!(un_pilier_sur_un_globe_ne_laisse_rien_passer);

/// Built: a source within δ of an edge of a box, inside, and in a plate thinner than δ. Held: a ray that goes in touches
/// at once, by the nearer face; one that leaves by a face as near does not, and from farther in none does.
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
    // Beside the lower edge on the right: 2 eps from the right side, 1 above the bottom.
    let coin = v(0.5 - 2.0 * eps, -0.5 + eps, 0.1);
    assert_eq!(touche(&cube, coin, v(-1.0, 1.0, 0.0)), Some([0.0, -1.0, 0.0]));
    assert_eq!(touche(&cube, coin, v(-1.0, -1.0, 0.0)), None); // out through the bottom
    assert_eq!(touche(&cube, coin, v(1.0, 1.0, 0.0)), None); // out through the side
    assert_eq!(touche(&cube, coin, v(0.0, 1.0, 0.0)), None); // along the side
    assert_eq!(touche(&cube, coin, v(0.0, 0.0, 1.0)), None); // along the edge
    // In the middle of the bottom, and deeper than δ and the rounding of the box.
    assert_eq!(touche(&cube, v(0.1, -0.5 + eps, 0.1), v(1.0, 1.0, 0.0)), Some([0.0, -1.0, 0.0]));
    assert_eq!(touche(&cube, v(0.1, -0.5 + 64.0 * eps, 0.1), v(1.0, 1.0, 0.0)), None);
    // A plate across y, nearer to its bottom than to its top, and the other way round.
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

/// A box under whose face a ray goes along, less deep than the δ of the ray and the rounding of the box, and a floor that
/// rises over that face by a little less: there the walls overlap by 1.1 to 1.3 times the bound of one of them, and before
/// a face had to be nearer to spare its box, both rays left.
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
    // 44u·Σl is 1.46e-11, half of it 7.3e-12.
    let source = v(1.0, 1.25e-11, 0.0);
    assert_eq!(suite(&[grande, sol(1e-11)], source).map(|t| t.distance()), Ok(0.0));
    // Where the face is as near as that, the ray goes along outside of the box: a floor that overlaps by less leaks.
    let source = v(1.0, 7e-12, 0.0);
    assert_eq!(suite(&[grande, sol(6e-12)], source), Err(NoIntersection));

    // In `f32`, a face that looks askew: the overlap is 133u, and 44u·Σl are 132u.
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

/// The δ that two walls are to reach into each other by is that of the next ray. One from far away has none, and passes
/// between walls that reach by four times their o; it loses on its way what a ray that started there would know it lost.
fn un_rayon_venu_de_loin_perd_son_chemin<R: Reel>() {
    let mut alea = Rng::with_seed(47);
    let (u, mut passent) = (u::<R>(), [0; 2]);
    for _ in 0..cas(500) {
        let tour = Rotation::<R>::new(arrondi(direction(&mut alea) * 3.0)).unwrap();
        let [x, y, z] = tour.axes().map(|axe| axe.vers_f64());
        let mut entre = |large: f64| large * (2.0 * alea.f64() - 1.0);
        // Straight at the seam, so that no ray meets a side within it.
        let source = arrondi::<R>(z * 1000.0 + y * entre(100.0) + x * entre(1e5 * u));
        let coffre = |c| boite(arrondi(x * c), v(1.0, 1.0, 0.2), tour);
        let propre = flou_propre(&coffre(0.0));
        let flou = flou_du_point(R::depuis_f64(1010.0), v(0.5, 0.5, 0.5));
        for (large, passent) in [4.0 * propre, 2.0 * (flou + propre)].into_iter().zip(&mut passent)
        {
            let murs = [0.5 - large / 2.0, large / 2.0 - 0.5].map(coffre);
            for _ in 0..8 {
                let cible = z * 0.1 + y * entre(0.3) + x * entre(large);
                let rayon = Rayon::new(source, arrondi::<R>(cible) - source).unwrap();
                *passent += u32::from(premiere_intersection(&murs, &rayon).is_err());
            }
        }
    }
    assert!(passent[0] > 20 && passent[1] == 0, "{passent:?}");
}

en_f32_et_f64!(un_rayon_venu_de_loin_perd_son_chemin);

/// Mirrors that stand flush on mirrors, and rays at the foot: a ray that starts beside the seam, in the box by rounding,
/// may be told the face that the floor hides, and the floor would send it back. Each comes out of the seam after a few hits.
fn aucun_pied_de_miroir_ne_garde_un_rayon<R: Reel>() {
    let mut alea = Rng::with_seed(90);
    let (mut caches, mut en_suite) = (0, 0);
    for scene in 0..cas(48) {
        let angles = direction(&mut alea) * if scene % 2 == 0 { 0.0 } else { 3.0 };
        let tour = Rotation::<R>::new(arrondi(angles)).unwrap();
        let [x, y, z] = tour.axes().map(|axe| axe.vers_f64());
        let milieu = if scene % 4 < 2 { y * 0.1 } else { direction(&mut alea) * 10.0 };
        let place = |a, b, c| milieu + x * a + y * b + z * c;
        let l = if scene % 3 == 0 { 1.0 } else { 0.3 };
        let cube = |a| boite(arrondi(place(a, l / 2.0, 0.0)), v(l, l, l), tour);
        let sol = if alea.bool() {
            mur(arrondi(milieu), tour.axes()[1])
        } else {
            boite(arrondi(place(0.0, -l / 2.0, 0.0)), v(8.0, l, 8.0), tour)
        };
        // Alone, or with a neighbour that hides another face.
        let objets = [sol, cube(0.0), cube(if alea.bool() { l } else { 4.0 * l })];
        let monde = Monde::de_liste(&objets);
        for _ in 0..200 {
            let pied = place(-l / 2.0, 0.0, l * (0.9 * alea.f64() - 0.45));
            let oeil = place(-l / 2.0 - 0.1 - alea.f64(), 0.1 + alea.f64(), alea.f64() - 0.5);
            let mut rayon = Rayon::new(arrondi(oeil), arrondi(pied - oeil)).unwrap();
            let mut d_emblee = 0;
            while let Ok(touche) = monde.premiere_intersection(&rayon) {
                d_emblee = if touche.distance() == R::ZERO { d_emblee + 1 } else { 0 };
                assert!(d_emblee < 64, "{rayon:?} {objets:?}");
                en_suite = en_suite.max(d_emblee);
                let dessous = touche.normale().vers_f64().produit_scalaire(y) < -0.9;
                caches += usize::from(d_emblee > 0 && dessous && touche.indice() > 0);
                rayon = touche.reflechi(rayon.direction()).unwrap();
            }
        }
    }
    println!("{caches} hidden faces, at most {en_suite} hits at once in a row");
    assert!(caches > 50 && (3..10).contains(&en_suite), "{caches} {en_suite}");
}

en_f32_et_f64!(aucun_pied_de_miroir_ne_garde_un_rayon);

/// Boxes whose corners are points of a grid and half-spaces through it, all flush and all mirrors, and rays towards points
/// and lines of the grid or beside them: no ray stays in a seam, unless δ is no longer small beside the solids. With
/// `LANCER_RAYON_CAS=100` there are 29 million rays in either type.
fn aucun_solide_a_fleur_ne_garde_un_rayon<R: Reel>() {
    let (mut rayons, mut au_bout, mut d_emblee, mut en_suite) = (0, 0, 0, 0);
    for graine in 0..cas(2_000) {
        let mut alea = Rng::with_seed(graine.into());
        let pas = [1.0, 0.1, 1.0 / 3.0, 0.7][alea.usize(0..4)];
        let angles = direction(&mut alea) * [0.0, 3.0, 3.0][alea.usize(0..3)];
        let tour = Rotation::<R>::new(arrondi(angles)).unwrap();
        let [x, y, z] = tour.axes().map(|axe| axe.vers_f64());
        let milieu = direction(&mut alea) * [0.0, 0.0, 1.0, 100.0][alea.usize(0..4)];
        let place = |[a, b, c]: [f64; 3]| arrondi::<R>(milieu + (x * a + y * b + z * c) * pas);
        let murs = alea.usize(0..4);
        let mut objets: Vec<_> =
            tour.axes()[..murs].iter().map(|&n| mur(place([0.0; 3]), n)).collect();
        for _ in 0..alea.usize(1..5) {
            let [bas, cotes] = [0, 1].map(|de| [(); 3].map(|()| f64::from(alea.i32(de..3))));
            let centre = core::array::from_fn(|i| bas[i] + cotes[i] / 2.0);
            objets.push(boite(place(centre), arrondi(Vecteur::from(cotes) * pas), tour));
        }
        alea.shuffle(&mut objets);
        let monde = Monde::de_liste(&objets);
        for _ in 0..200 {
            let mut cible = [(); 3].map(|()| f64::from(alea.i32(0..5)));
            cible[alea.usize(0..3)] += if alea.bool() { alea.f64() } else { 0.0 };
            let peu = if alea.bool() { 0.0 } else { deux_puissance(&mut alea, -56.0, 0.0) };
            let cible = place((Vecteur::from(cible) + direction(&mut alea) * peu).into());
            let source = place([(); 3].map(|()| 8.0 * alea.f64() - 1.5));
            let Ok(mut rayon) = Rayon::new(source, cible - source) else { continue };
            if monde.contient(source) {
                continue;
            }
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
                assert!(ici < 64, "{rayon:?} {objets:?}");
                (d_emblee, en_suite) = (d_emblee + u32::from(ici > 0), en_suite.max(ici));
                let Ok(suite) = touche.reflechi(rayon.direction()) else { break };
                rayon = suite;
            }
        }
    }
    println!("{rayons} rays, {au_bout} end, {d_emblee} at once, {en_suite} in a row at most");
    assert!(au_bout > 9 * rayons / 10 && d_emblee > rayons / 500 && en_suite > 3);
}

en_f32_et_f64!(aucun_solide_a_fleur_ne_garde_un_rayon);

/// What the pages say of a ball: at the point where it touches a mirror a ray may stay, since its hits there do not move it.
#[test]
fn au_contact_d_une_boule_un_rayon_peut_rester() {
    let boule = v(0.6190252699772706, 0.3467097000736147, 0.4040628239161553);
    let tour = Rotation::depuis_matrice([
        [0.24874570450755454, 0.5478593218332496, 0.7987338342460849],
        [0.7631309755904152, -0.6186860750985684, 0.1867047256326144],
        [0.5964534253262878, 0.5630965316529134, -0.5719839223763182],
    ]);
    let tiers = 1.0 / 3.0;
    let coffre = |centre, l| boite(centre, v(2.0 * tiers, 2.0 * tiers, l), tour.unwrap());
    let objets = [
        sphere(boule, tiers),
        coffre(v(1.0283703494831662, -0.15959710526758308, 0.6238632947339513), tiers),
        coffre(v(1.0448640188683627, -0.24836745726984735, 0.2622880295892033), 2.0 * tiers),
    ];
    let source = v(0.8734022618407384, 0.14048100837410202, 0.4662977324603403);
    let d = v(0.30202890598447596, 0.09757520018823561, -0.9482919488522759);
    let mut rayon = Rayon::new(source, d).unwrap().avec_flou(1.1476832079184187e-12).unwrap();
    for _ in 0..1_000 {
        let touche = Monde::de_liste(&objets).premiere_intersection(&rayon).unwrap();
        assert_eq!(touche.distance(), 0.0);
        rayon = touche.reflechi(rayon.direction()).unwrap();
    }
    assert!(rayon.flou() < 1e-10);
}

/// What the pages say of a room of 10 m about O, in millimetres of `f32`: δ grows by up to 0.035 a bounce, and o is 0.03.
fn une_chambre_de_dix_metres_perd_peu_a_chaque_rebond<R: Reel>() {
    const FLOU_PAR_REBOND: f64 = 0.035e-3;
    const PROPRE: f64 = 0.03e-3;
    let mut alea = Rng::with_seed(10);
    let en_f32 = u::<f32>() / u::<R>();
    let mut pire = 0.0_f64;
    for scene in 0..cas(20) {
        let tour = Rotation::<R>::new(arrondi(direction(&mut alea) * 3.0)).unwrap();
        let axes = tour.axes();
        let mut objets = vec![];
        for axe in 0..3 {
            for n in [axes[axe], -axes[axe]] {
                let loin = |d| n * R::depuis_f64(d);
                let mut cotes = [10.2; 3];
                cotes[axe] = 0.2;
                objets.push(if scene % 2 == 0 {
                    boite(loin(5.1), arrondi(cotes.into()), tour)
                } else {
                    mur(loin(5.0), -n)
                });
            }
        }
        for objet in &objets {
            assert!(flou_propre(objet) * en_f32 <= PROPRE);
        }
        let monde = Monde::de_liste(&objets);
        for _ in 0..20 {
            let mut rayon = Rayon::new(Vecteur::NUL, arrondi(direction(&mut alea))).unwrap();
            for rebond in 1..=140 {
                let touche = monde.premiere_intersection(&rayon).unwrap();
                let ailleurs = direction(&mut alea) * 5.0;
                // Into the farthest corner, or anywhere.
                let coin = axes.into_iter().fold(Vecteur::NUL, |coin, axe| {
                    let loin = axe.produit_scalaire(touche.point()) < R::ZERO;
                    coin + axe.vers_f64() * if loin { 4.99 } else { -4.99 }
                });
                let cible = if alea.bool() { coin } else { ailleurs };
                let suite = touche.secondaire(arrondi::<R>(cible) - touche.point());
                rayon = suite.or_else(|_| touche.secondaire(touche.normale())).unwrap();
                let par_rebond = rayon.flou().vers_f64() * en_f32 / f64::from(rebond);
                assert!(par_rebond <= FLOU_PAR_REBOND, "{par_rebond:e}");
                pire = pire.max(par_rebond);
            }
        }
    }
    assert!(pire > FLOU_PAR_REBOND / 2.0, "{pire:e}");
    let rebonds = |depasse: f64| ((depasse / 2.0 - PROPRE) / FLOU_PAR_REBOND) as u32;
    assert_eq!([rebonds(1e-3), rebonds(1e-2)], [13, 142]);
    assert!((0.5e-3 / FLOU_PAR_REBOND) * (u::<f32>() / u::<f64>()) > 7e9);
}

en_f32_et_f64!(une_chambre_de_dix_metres_perd_peu_a_chaque_rebond);

/// A δ pays for its own roundings and those with which D1 to D3 see it, however large it is beside the way and the place.
fn un_flou_ne_perd_rien<R: Reel>() {
    let mut alea = Rng::with_seed(15);
    let nombre = |x: R, k: f64| &Exact::de(x) * &Exact::de(1.0 + k * u::<R>());
    for _ in 0..cas(2_000) {
        let mut petit = || R::depuis_f64(deux_puissance(&mut alea, -80.0, 20.0));
        let (flou, t, x) = (petit(), petit(), petit());
        let rayon = Rayon::new(v(0.0, 0.0, 0.0), v(0.0, 0.0, 1.0)).unwrap();
        let rayon = Rayon::new(Vecteur::new(x, -x, R::ZERO), rayon.direction()).unwrap();
        let suite = rayon.avec_flou(flou).unwrap().bifurque(t, v(1.0, 0.0, 0.0)).unwrap();
        let p = suite.source();
        let de_plus = flou_du_point(t, p) * (1.0 - 1e-12);
        let perdu = &nombre(flou, 2.0) + &Exact::de(de_plus);
        let reste = &nombre(suite.flou(), -3.0) - &perdu;
        assert!(reste.positif(), "{flou:?} {t:?} {x:?} {suite:?}");
    }
}

en_f32_et_f64!(un_flou_ne_perd_rien);
