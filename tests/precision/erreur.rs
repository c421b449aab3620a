//! `erreur` and `est_sur` beside the oracle, regime by regime: never short of the error, seldom far above it; never
//! certain of a wrong answer, seldom uncertain of a right one.

use commun::en_f32_et_f64;
use commun::mesure::quantiles;
use commun::oracle::verite;
use commun::regimes::regimes;
use fastrand::Rng;
use lancer_rayon::Reel;

/// Of hits that are not exact the median bound is at most so many times the error, in every regime.
const AISANCE: f64 = 6.0;

fn erreur_borne_l_erreur_et_est_sur_ne_se_trompe_pas<R: Reel>() {
    let cas_par_regime = commun::cas(1_000);
    for regime in regimes::<R>() {
        let (mut incertains, mut faux) = (0, 0);
        let mut alea = Rng::with_seed(39);
        let (mut aisances, mut infinies, mut touches) = (Vec::new(), 0, 0);
        for _ in 0..cas_par_regime {
            let cas = (regime.cas)(&mut alea);
            let reponse = cas.objet.intersection(&cas.rayon);
            let verite = verite(&cas.objet, &cas.rayon);
            let plus_grand =
                if R::U.vers_f64() > f64::EPSILON { f64::from(f32::MAX) } else { f64::MAX };
            let entree = verite.entree.filter(|e| e.t.vers_f64() <= plus_grand);
            let sur = cas.objet.est_sur(&cas.rayon);
            let juste = entree.is_some() == reponse.is_ok();
            assert!(juste || !sur, "{}: certain, and wrong: {cas:?}", regime.nom);
            incertains += u32::from(!sur);
            faux += u32::from(!juste);
            let Ok(touche) = reponse else { continue };
            touches += 1;
            let erreur = cas.objet.erreur(&cas.rayon, &touche).vers_f64();
            infinies += u32::from(erreur == f64::INFINITY);
            let Some(entree) = entree else {
                assert!(erreur == f64::INFINITY, "{}: {erreur} of no entry: {cas:?}", regime.nom);
                continue;
            };
            let ecart = entree.ecart(touche.distance()).abs();
            assert!(ecart <= erreur, "{}: {ecart:e} > {erreur:e}, {cas:?}", regime.nom);
            if ecart > 0.0 {
                aisances.push(erreur / ecart);
            }
        }
        let [mediane, presque, _] = quantiles(&mut aisances);
        println!(
            "{}: {touches} hits, {infinies} infinite, median {mediane:.2}, 99.9 % {presque:.0}",
            regime.nom
        );
        assert!(mediane <= AISANCE, "{}: median looseness {mediane}", regime.nom);
        println!("   {incertains} uncertain, {faux} wrong");
    }
}

en_f32_et_f64!(erreur_borne_l_erreur_et_est_sur_ne_se_trompe_pas);
