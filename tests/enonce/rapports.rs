//! Faults that users of other ray casters report, each rebuilt with spheres, half-spaces and boxes.

use commun::conversion::voisin;
use commun::fabrique::{boite, boite_droite, mur, sphere, v};
use commun::facons::comparer;
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::mesure::poids;
use commun::oracle::hauteur;
use commun::regimes::{deux_puissance, direction};
use commun::tolerances::u;
use commun::{Bits, arrondi, cas, en_f32_et_f64};
use lancer_rayon::{NoIntersection, ObjetRay, Rayon, Reel, Rotation, Vecteur};

/// A ray's knowledge of its start follows it into a ball and the ball within, through bounces and turns, and out again.
/// δ grows by what each of these loses, inside and outside. Inside, the ray touches nothing at once, however large δ
/// is.
fn un_rayon_garde_son_flou_dedans_et_dehors<R: Reel>() {
    // In the larger scene the rounding of one bounce exceeds 1.
    for echelle in [1.0, 1.0 / u::<R>()] {
        let long = |x| R::depuis_f64(x * echelle);
        let [grande, petite] = [4.0, 1.0].map(|rayon| sphere(Vecteur::NUL, long(rayon)));
        let (d, travers, flou) = (v(0.0, 0.0, -1.0), v(1.0, 0.0, 0.0), long(3.0));
        let de = |z| Rayon::new(v(0.0, 0.0, z * echelle), d).unwrap().avec_flou(flou).unwrap();
        let touche = grande.intersection(&de(10.0)).unwrap();
        let verre = touche.secondaire(d).unwrap();
        let bord = petite.intersection(&verre).unwrap();
        let bulle = bord.secondaire(d).unwrap();
        let retour = petite.sortie(&bulle).unwrap().secondaire(d).unwrap();
        let miroir = bord.reflechi(d).unwrap();
        let virage = verre.bifurque(long(1.0), travers).unwrap();
        let dehors = [
            touche.reflechi(d).unwrap(),
            de(10.0).bifurque(long(1.0), travers).unwrap(),
            grande.sortie(&de(0.0)).unwrap().secondaire(d).unwrap(),
            grande.sortie(&retour).unwrap().secondaire(d).unwrap(),
        ];
        let tous = [&[verre, miroir, virage, bulle, retour][..], &dehors].concat();
        // A few bounces round by far less than δ.
        let borne = flou * R::depuis_f64(1.001);
        let fidele = |rayon: &Rayon<R>| rayon.flou() > flou && rayon.flou() < borne;
        assert!(tous.iter().all(fidele), "{tous:?}");
        assert_eq!(de(0.0).dedans().flou(), flou);
        // Without a δ, too, a ray inside is another ray.
        let net = de(0.0).avec_flou(R::ZERO).unwrap();
        assert_eq!(net, net.avec_flou(-R::ZERO).unwrap(), "−0 says inside");
        assert!(
            net != net.dedans() && net == net.dedans().dehors() && net.dedans() == net.dedans()
        );
        // Within δ of the surface a ray inside touches nothing at once, even after a turn or with another δ. A ray
        // outside does, and so does one that has come out of something.
        let touche_t =
            |rayon: Rayon<R>| grande.intersection(&rayon).map(|touche| touche.distance());
        let au_bord = de(3.9);
        assert_eq!(touche_t(au_bord), Ok(R::ZERO));
        let au_bord_dedans = au_bord.dedans();
        for dedans in [
            au_bord_dedans,
            au_bord_dedans.dedans(),
            au_bord_dedans.avec_flou(flou).unwrap(),
            au_bord_dedans.bifurque(R::ZERO, d).unwrap(),
        ] {
            assert_eq!(touche_t(dedans), Err(NoIntersection), "{dedans:?}");
        }
        let demi_tour = dehors[3].bifurque(long(1.0), -d).unwrap();
        assert_eq!(touche_t(demi_tour.bifurque(long(1.1), -d).unwrap()), Ok(R::ZERO));
    }
}

en_f32_et_f64!(un_rayon_garde_son_flou_dedans_et_dehors);

/// A hit at once adds to δ its depth, a 64th of δ and some roundings of the place, and no more. Once the deepest of the
/// faces that the ray did not come in by counted too, and δ grew from wall to wall.
fn d_emblee_le_flou_grandit_de_la_profondeur<R: Reel>() {
    let (mut touches, mut pire) = (0, 0.0_f64);
    let faire = |alea: &mut Hasard| {
        let tour = Rotation::<R>::new(arrondi(direction(alea) * 3.0)).unwrap();
        let [x, y, _] = tour.axes().map(Vecteur::vers_f64);
        let centre = direction(alea) * *alea.choix(&[0.0, 1.0, 100.0]);
        let objet = match alea.tour % 2 {
            0 => boite(arrondi(centre), v(2.0, 2.0, 2.0), tour),
            _ => mur(arrondi(centre + y), arrondi(y)),
        };
        let flou = deux_puissance(alea, u::<R>().log2() + 9.0, -4.0);
        // The source is a little below the top, beside an edge or not, with the side as deep as δ allows.
        let [bas, cote] = [flou * alea.f64().powi(4), flou * alea.f64()];
        let source =
            arrondi::<R>(centre + y * (1.0 - bas) + x * if alea.bool() { 1.0 - cote } else { 0.0 });
        let rayon = Rayon::new(source, arrondi(direction(alea) * 0.5 - y - x * 0.7)).unwrap();
        (objet, rayon.avec_flou(R::depuis_f64(flou)).unwrap())
    };
    pour_chaque(20_000, faire, |(objet, rayon)| {
        let Ok(touche) = objet.intersection(&rayon) else { return };
        if touche.distance() > R::ZERO {
            return;
        }
        touches += 1;
        let (flou, p) = (rayon.flou().vers_f64(), touche.point());
        let suite = touche.reflechi(rayon.direction()).unwrap();
        let de_plus = suite.flou().vers_f64() - flou;
        // 8u and 8.1u of the place, 1.1u of its weights, and 16u of the whole.
        let place = 17.2 * u::<R>() * poids(v(1.0, 1.0, 1.0), p.vers_f64());
        let marge = touche.marge().vers_f64();
        let permis = marge + flou / 64.0 + place + 40.0 * u::<R>() * (flou + marge);
        assert!(de_plus <= permis, "{de_plus:e} > {permis:e}: {rayon:?} {objet:?}");
        // The depth under the face of the hit, which M4 and M2 exceed by roundings of the place and of the object.
        let profond = -hauteur(&objet, touche.normale(), p);
        assert!(marge <= profond + 64.0 * u::<R>() * (3.0 + p.longueur().vers_f64()), "{marge:e}");
        pire = pire.max(de_plus / flou);
    });
    assert!(touches > 5_000 && pire > 0.5, "{touches} {pire}");
}

en_f32_et_f64!(d_emblee_le_flou_grandit_de_la_profondeur);

/// The fault: a ray with a δ reports what it passes through, or passes through what it stands in. A cube and a floor
/// must be touched at once from less deep than δ + o, but not from exactly as deep, and the cube not from just nearer
/// to another face than δ and 22u of its half-lengths. All of these numbers are exact.
fn a_la_profondeur_de_delta_et_de_o_rien_n_est_touche_d_emblee<R: Bits>() {
    let nombre = R::depuis_f64;
    let (cube, sol) =
        (boite_droite(Vecteur::NUL, v(1.0, 1.0, 1.0)), mur(v(0.0, 0.5, 0.0), Vecteur::Y));
    let faire = |alea: &mut Hasard| alea.usize(1..1 << 12) as f64;
    pour_chaque(cas(256), faire, |k| {
        let (delta, u) = (nombre(k / 16_384.0), R::U);
        let rayon = |x, y| {
            let rayon = Rayon::new(Vecteur::new(x, y, R::ZERO), -Vecteur::Y).unwrap();
            rayon.avec_flou(delta).unwrap()
        };
        let touche = |objet: &ObjetRay<R>, x, y| {
            objet.intersection(&rayon(x, y)).map(|touche| touche.distance())
        };
        let [au_sol, au_cube, a_cote] =
            [0.0, 66.0, 33.0].map(|o| nombre(0.5) - (delta + nombre(o) * u));
        for (objet, fond) in [(&sol, au_sol), (&cube, au_cube)] {
            assert_eq!(touche(objet, R::ZERO, fond), Err(NoIntersection));
            assert_eq!(touche(objet, R::ZERO, voisin(fond, 1)), Ok(R::ZERO));
        }
        // The rays lie side by side, some of them too deep and others not.
        let rayons = [au_sol, voisin(au_sol, 1), au_cube, voisin(au_cube, 1)];
        comparer(&[sol, cube], &rayons.map(|y| rayon(R::ZERO, y)).repeat(4));
        for x in [a_cote, -a_cote] {
            assert_eq!(touche(&cube, x, nombre(0.5)), Ok(R::ZERO));
            assert_eq!(touche(&cube, voisin(x, 1), nombre(0.5)), Err(NoIntersection));
        }
    });
}

en_f32_et_f64!(a_la_profondeur_de_delta_et_de_o_rien_n_est_touche_d_emblee);

/// A user's own trait, with functions named like those that the crate keeps to itself.
trait AMoi: Sized {
    fn arbre() -> u8 {
        1
    }
    fn premiere() -> u8 {
        2
    }
    fn contient() -> u8 {
        3
    }
    fn selon() -> u8 {
        4
    }
}

impl AMoi for f64 {}

/// `Reel` brings no function that hides those of another trait, which the compiler would refuse (E0034).
#[test]
fn reel_ne_cache_rien_d_un_autre_trait() {
    fn toutes<R: Reel + AMoi>() -> [u8; 4] {
        [R::arbre(), R::premiere(), R::contient(), R::selon()]
    }
    assert_eq!(toutes::<f64>(), [1, 2, 3, 4]);
}
