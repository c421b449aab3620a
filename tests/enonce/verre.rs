//! Glass that stands on something: no light falls through between the two.

use commun::regimes::{direction, entre};
use commun::{arrondi, en_f32_et_f64};
use exemples::verre::{avant_la_sortie, sortir};
use fastrand::Rng;
use lancer_rayon::{
    BoiteGeo, Hierarchie, ObjetRay, PlanGeo, Rayon, Reel, Rotation, SphereGeo, Texture, Vecteur,
};

/// Rays that leave a glass through its bottom, of each glass.
const RAYONS: u32 = 10_000;

/// A half-space or a slab whose top is at this height, and a box or a ball of glass that stands on it: computed as one
/// computes them, so that what should be one height is now and then two.
fn sur_une_table<R: Reel>(ronde: bool, alea: &mut Rng) -> [ObjetRay<R>; 2] {
    let nombre = |x: f64| R::depuis_f64(x);
    let deux = nombre(2.0);
    let plateau = nombre([0.0, 0.75, 1.05, 9.9][alea.usize(..4)]);
    let (epaisseur, haut) = (nombre(entre(alea, 0.02, 0.2)), nombre(entre(alea, 0.05, 1.0)));
    let table = if alea.bool() {
        let ou = Vecteur::new(R::ZERO, plateau, R::ZERO);
        let haut = Vecteur::new(R::ZERO, R::UN, R::ZERO);
        PlanGeo::par_un_point(ou, haut, Texture(0)).unwrap().into()
    } else {
        let centre = Vecteur::new(R::ZERO, plateau - epaisseur / deux, R::ZERO);
        let cotes = Vecteur::new(nombre(8.0), epaisseur, nombre(8.0));
        BoiteGeo::new(centre, cotes, Rotation::IDENTITE, Texture(0)).unwrap().into()
    };
    let centre = Vecteur::new(nombre(0.3), plateau + haut / deux, nombre(-0.2));
    let verre = if ronde {
        SphereGeo::new(centre, haut / deux, Texture(1)).unwrap().into()
    } else {
        let tour = Rotation::new(Vecteur::new(R::ZERO, nombre(entre(alea, -1.0, 1.0)), R::ZERO));
        let cotes = Vecteur::new(nombre(0.4), haut, nombre(0.3));
        BoiteGeo::new(centre, cotes, tour.unwrap(), Texture(1)).unwrap().into()
    };
    [table, verre]
}

/// Every ray out through the bottom lands on the table, and every ray out through a side does not stop there.
fn la_lumiere_trouve_la_table_sous_le_verre<R: Reel>() {
    let mut alea = Rng::with_seed(60);
    for ronde in [false, true] {
        let (mut par_dessous, mut naifs, mut par_un_cote) = (0, 0, 0);
        while par_dessous < RAYONS {
            let scene = sur_une_table::<R>(ronde, &mut alea);
            let mut places = vec![0.0; Hierarchie::places(scene.len())];
            let hierarchie = Hierarchie::new(&scene, &mut places).unwrap();
            let [bas, haut] = scene[1].etendue().unwrap();
            let milieu = ((bas + haut) / R::depuis_f64(2.0)).vers_f64();
            let loin = (haut - bas).longueur() * R::depuis_f64(2.0);
            for _ in 0..200 {
                let oeil = milieu + Vecteur::new(0.0, 1.0, 0.0) + direction(&mut alea) * 0.9;
                let cible = milieu + direction(&mut alea) * (0.4 * alea.f64());
                let rayon = Rayon::new(arrondi(oeil), arrondi(cible - oeil)).unwrap();
                let Some(entree) = hierarchie.premiere_intersection(&rayon).ok() else { continue };
                if entree.objet() != 1 {
                    continue;
                }
                // To the bottom, of a ball next to where it touches the table; or bent, as glass does.
                let bas = Vecteur::new(milieu.x, bas.y.vers_f64(), milieu.z);
                let fin = alea.f64() * if ronde { 1e-6 } else { 0.1 };
                let p = rayon.point(entree.distance()).vers_f64();
                let vers = if alea.bool() {
                    arrondi(bas + direction(&mut alea) * fin - p)
                } else {
                    rayon.direction() - entree.normale() * R::depuis_f64(0.5)
                };
                let Ok(dedans) = rayon.secondaire(&entree, vers) else { continue };
                let touche =
                    hierarchie.parmi(&|objet| objet != 1).premiere_intersection(&dedans).ok();
                let Some((retour, sortie)) = sortir(&scene[1], &dedans, loin) else { continue };
                let n = sortie.normale().vers_f64();
                let dehors = retour.secondaire(&sortie, dedans.direction()).unwrap();
                let posee = touche.filter(|t| avant_la_sortie(&dedans, t, &(retour, sortie)));
                let contexte = || format!("{scene:?} {dedans:?} {sortie:?}");
                let dessous = n.y < if ronde { -0.999_999 } else { -0.5 };
                let arrive = hierarchie.premiere_intersection(&dehors);
                let arrive = posee.or(arrive.ok());
                if dessous {
                    // It lands there, whether the light goes straight in or crosses what air is left.
                    assert_eq!(arrive.map(|t| t.objet()), Some(0), "through: {}", contexte());
                    assert!(ronde || posee.is_some(), "air under a box: {}", contexte());
                    naifs += u32::from(scene[0].contient(dehors.source()));
                    par_dessous += 1;
                } else if n.y > -0.999 {
                    assert!(posee.is_none(), "not out through a side: {}", contexte());
                    // Downward it lands beside the glass, upward nowhere: the slab is wide enough.
                    let descend = dedans.direction().y < R::ZERO;
                    assert!(arrive.is_none_or(|t| descend && t.objet() == 0), "{}", contexte());
                    par_un_cote += 1;
                }
            }
        }
        println!(
            "round {ronde}: {par_dessous} through the bottom, {naifs} start in the table, {par_un_cote} beside"
        );
        assert!(par_un_cote > 1_000);
        // Without the test these would have fallen through.
        assert!(naifs > if ronde { 0 } else { RAYONS / 4 }, "{naifs}");
    }
}

en_f32_et_f64!(la_lumiere_trouve_la_table_sous_le_verre);
