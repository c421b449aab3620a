//! What every hit, every way out and every ray from there must be (`commun::passages`), for every shape in every regime
//! of the extremes.

use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::passages::{exiger_apres_coup, exiger_les_passages};
use commun::regimes::{Cas, deux_puissance, direction, regimes, vers_la_sortie};
use commun::{Bits, arrondi, en_f32_et_f64};
use lancer_rayon::Vecteur;

fn chaque_passage_est_ce_qu_il_doit_etre<R: Bits>() {
    let [mut entrees, mut sorties, mut d_emblee] = [0; 3];
    for regime in regimes::<R>() {
        let faire = |alea: &mut Hasard| {
            let cas = (regime.cas)(alea);
            let Cas { objet, rayon } = if alea.bool() { vers_la_sortie(cas, alea) } else { cas };
            // Every third ray knows its source only to a part of its distance from O.
            let flou = rayon.source().longueur() * R::depuis_f64(deux_puissance(alea, -54.0, -2.0));
            let rayon =
                if alea.u8(0..3) == 0 { rayon.avec_flou(flou).unwrap_or(rayon) } else { rayon };
            let vers = arrondi(direction(alea) * deux_puissance(alea, -8.0, 8.0));
            (objet, [rayon, (regime.cas)(alea).rayon], vers)
        };
        pour_chaque(2_000, faire, |(objet, [rayon, autre], vers)| {
            let entree = objet.intersection(&rayon);
            entrees += u32::from(entree.is_ok());
            d_emblee += u32::from(entree.is_ok_and(|t| t.distance() == R::ZERO));
            sorties += u32::from(objet.sortie(&rayon).is_ok());
            exiger_les_passages(&objet, &rayon, vers);
            exiger_apres_coup(&objet, [&rayon, &autre]);
            // In the tangent plane rounding decides.
            if let Ok(touche) = entree {
                let n = touche.normale();
                let tangente = vers - n * n.produit_scalaire(vers);
                exiger_les_passages(&objet, &rayon, tangente);
                exiger_les_passages(&objet, &rayon, touche.point() + tangente);
            }
            exiger_les_passages(&objet, &rayon, Vecteur::NUL);
        });
    }
    assert!(entrees > 10_000 && sorties > 10_000 && d_emblee > 500);
}

en_f32_et_f64!(chaque_passage_est_ce_qu_il_doit_etre);
