//! The distance and the direction of a lamp.

use commun::fabrique::sphere;
use commun::hasard::{Hasard, pour_chaque};
use commun::oracle::{Exact, exacts, moins, scalaire};
use commun::regimes::{direction, entre};
use commun::tolerances::u;
use commun::{arrondi, en_f32_et_f64};
use lancer_rayon::{ObjetRay, Rayon, Reel, Vecteur};

/// What `vers_lumiere` says of its ray, compared with the exact vector from the start to the lamp: the row of
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
        let v = moins(&exacts(lampe), &exacts(ombre.source()));
        let carre = scalaire(&v, &v);
        let longueur = carre.vers_f64().sqrt();
        // d² − |V|², which is exact, over 2|V|.
        let d = Exact::de(ombre.fin());
        let ecart = (&(&d * &d) - &carre).vers_f64() / (2.0 * longueur);
        let permis = 3.6 * u::<R>() * longueur + R::ETA.vers_f64();
        assert!(ecart.abs() <= permis, "{ecart:e} of {longueur}");
        // |V| is good to 1.5u of `f64`, each coordinate of V to u, and so are the products and the differences.
        let essai = 5.0 * u::<f64>();
        let exacte = Vecteur::from(v.each_ref().map(Exact::vers_f64));
        let ecart = (ombre.direction().vers_f64() * longueur - exacte).longueur() / longueur;
        assert!(ecart <= 4.6 * u::<R>() + essai, "{ecart:e}");
        let nv = scalaire(&exacts(touche.normale()), &v);
        let cosinus = ombre.direction().produit_scalaire(touche.normale()).vers_f64();
        let ecart = (cosinus - nv.vers_f64() / longueur).abs();
        assert!(ecart <= 8.0 * u::<R>() + essai, "{ecart:e}");
        juges += 1;
    });
    assert!(juges > 3_000, "{juges} judged");
}

en_f32_et_f64!(la_distance_et_la_direction_d_une_lampe_sont_bornees);
