//! Lemma 19 of `docs/preuves.md`: the probe of many rays enters every box that the probe of one of them enters, and no
//! later.

use commun::fabrique::avec_arbre;
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::regimes::{deux_puissance, direction, gerbe};
use commun::{Bits, en_f32_et_f64, scenes};
use lancer_rayon::Rayon;
use lancer_rayon::pour_les_tests::{Reglage, sonder};

/// Rays from about one place: near, amid the objects or far away.
fn rayons<R: Bits>(alea: &mut Hasard) -> Vec<Rayon<R>> {
    let loin = if alea.bool() { 5.0 } else { deux_puissance(alea, 0.0, 40.0) };
    let ou = direction(alea) * loin;
    let vers = if alea.bool() { -ou } else { direction(alea) };
    let ecarts = [-30.0, -40.0].map(|bas| deux_puissance(alea, bas, 3.0));
    let mut rayons = gerbe(alea, (ou, vers.unitaire().unwrap()), ecarts);
    rayons.truncate(*alea.choix(&[1, 12, 16, 40, 64]));
    rayons
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
