//! Lemma 19 of `docs/preuves/recherche.md`: the probe of many rays enters every box that the probe of one of them
//! enters, and enters it no later.

use commun::fabrique::{avec_arbre, sphere};
use commun::facons::comparer_dans;
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::regimes::{deux_puissance, direction, gerbe};
use commun::{Bits, arrondi, en_f32_et_f64, scenes};
use fastrand::Rng;
use lancer_rayon::pour_les_tests::{Reglage, sonder};
use lancer_rayon::{Monde, ObjetRay, Rayon};

/// Rays from about one place, which is near, amid the objects or far away. Half of the time each group of sixteen starts
/// another way back on its lines: all must be before the boxes where entries count from.
fn rayons<R: Bits>(alea: &mut Hasard) -> Vec<Rayon<R>> {
    let loin = if alea.bool() { 5.0 } else { deux_puissance(alea, 0.0, 40.0) };
    let ou = direction(alea) * loin;
    let vers = if alea.bool() { -ou } else { direction(alea) };
    let ecarts = [-30.0, -40.0].map(|bas| deux_puissance(alea, bas, 3.0));
    let mut rayons = gerbe(alea, (ou, vers.unitaire().unwrap()), ecarts);
    rayons.truncate(*alea.choix(&[1, 12, 16, 40, 64]));
    let loin = if alea.bool() { 0.0 } else { deux_puissance(alea, 0.0, 12.0) };
    let reculs = [(); 4].map(|()| loin * alea.f64());
    let recule = |(i, rayon): (usize, &Rayon<R>)| {
        Rayon::new(rayon.point(-R::depuis_f64(reculs[i / 16])), rayon.direction()).unwrap()
    };
    rayons.iter().enumerate().map(recule).collect()
}

fn la_sonde_de_plusieurs_rayons_entre_ou_l_un_d_eux_entre<R: Bits>() {
    let objets = scenes::melange::<R>(400);
    let monde = avec_arbre(&objets);
    let (mut sondes, mut entrees, mut dehors) = (0, 0, 0_u32);
    let faire = |alea: &mut Hasard| {
        let t = if alea.bool() { f64::INFINITY } else { deux_puissance(alea, -3.0, 41.0) };
        (rayons::<R>(alea), R::depuis_f64(t))
    };
    pour_chaque(commun::cas(2_000), faire, |(rayons, t)| {
        for (nom, reglage) in Reglage::tous().filter(|_| !rayons.is_empty()) {
            let mut contre = |(de_tous, ou): (u32, [f32; 16]),
                              (d_un, le_sien): (u32, [f32; 16])| {
                assert_eq!(d_un & !de_tous, 0, "{nom}: {rayons:?} leave out a child of {d_un:b}");
                for enfant in (0..16).filter(|enfant| d_un >> enfant & 1 == 1) {
                    assert!(ou[enfant] <= le_sien[enfant], "{nom}: {rayons:?}, child {enfant}");
                }
                entrees += d_un.count_ones();
                dehors += 16 - de_tous.count_ones();
            };
            sondes += u32::from(sonder(&reglage.monde(monde), &rayons, t, &mut contre).is_some());
        }
    });
    assert!(sondes > commun::cas(1_000) && entrees > sondes && dehors > entrees);
}

en_f32_et_f64!(la_sonde_de_plusieurs_rayons_entre_ou_l_un_d_eux_entre);

/// Small spheres, and rays that start near each other but far from these, with directions as long as those that are
/// kept (C13).
fn venus_de_loin(alea: &mut Hasard) -> (Vec<ObjetRay>, Vec<Rayon>) {
    let longueur = 1.0 + 5.9 * f64::from(f32::EPSILON) / 2.0;
    let boule = |alea: &mut Hasard, _| sphere::<f32>(arrondi(direction(alea) * 0.9), 0.02);
    let objets = alea.liste(100, boule);
    let (de, loin) = (direction(alea), deux_puissance(alea, 24.5, 25.2));
    let cible = direction(alea) * 0.5;
    let rayons = alea.liste(1_500, |alea, _| {
        let ou = (de + direction(alea) * 0.15).unitaire().unwrap() * loin;
        let ou = arrondi::<f32>(ou);
        let vers = cible + direction(alea) * 0.1 - ou.vers_f64();
        Rayon::new(ou, arrondi(vers.unitaire().unwrap() * longueur)).unwrap().temoin_f64()
    });
    (objets.iter().map(ObjetRay::temoin_f64).collect(), rayons)
}

/// A direction that `temoin_f64` widened is unit only to the rounding of `f32`. From twenty million units away even the
/// place before all boxes, from which the probe of a block counts, would be off by more than the scene if S·D alone
/// told it.
#[test]
fn des_rayons_elargis_venus_de_loin_touchent_ensemble_ce_qu_ils_touchent_seuls() {
    let mut touches = 0;
    pour_chaque(commun::cas(32), venus_de_loin, |(objets, mut rayons)| {
        let liste = Monde::de_liste(&objets);
        rayons.retain(|rayon| liste.est_occulte(rayon));
        touches += comparer_dans(&avec_arbre(&objets), &rayons[..rayons.len().min(64)]);
    });
    assert!(touches >= commun::cas(1_000) as usize);
}

/// No probe enters a missing child. The probe of rays that part along all three axes would, so such rays have none.
#[test]
fn aucune_sonde_n_entre_ou_il_n_y_a_rien() {
    let mut alea = Rng::with_seed(6);
    let boule = |alea: &mut Rng| sphere(arrondi(direction(alea)), 0.05_f32);
    let objets: Vec<_> = (0..40).map(|_| boule(&mut alea)).collect();
    for axes in 1..=3 {
        let rayon = |i: usize| {
            let mut vers = [0.7; 3];
            vers[i % axes] = -0.1;
            Rayon::new(arrondi(direction(&mut alea) * 0.1), arrondi(vers.into())).unwrap()
        };
        let rayons: Vec<_> = (0..63).map(rayon).collect();
        let mut noeuds = 0;
        let sonde = sonder(&avec_arbre(&objets), &rayons, f32::INFINITY, |(enfants, _), _| {
            // There are three leaves, the last of which has eight records, and the root above them.
            let la = [16, 16, 8, 3][noeuds % 4];
            assert!(enfants >> la == 0, "{enfants:b}");
            noeuds += 1;
        });
        assert_eq!(sonde.is_some(), axes < 3);
        assert_eq!(noeuds, if axes < 3 { 4 * rayons.len() } else { 0 });
    }
}
