//! What every hit, every way out and every ray from there must be (`commun::passages`), for every shape in every regime
//! of the extremes.

use commun::fabrique::{boite_droite, mur, sphere, v};
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::passages::{exiger_apres_coup, exiger_les_passages};
use commun::regimes::{Cas, deux_puissance, direction, regimes, vers_la_sortie};
use commun::{Bits, arrondi, en_f32_et_f64};
use lancer_rayon::{NoIntersection, ObjetRay, Rayon, Vecteur};

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

/// Where a ray enters and leaves, as one answer: the two that it gives one by one, to the bit, from inside too, with an
/// end, and in half-spaces, which it may never leave.
fn une_traversee_va_de_l_entree_a_la_sortie<R: Bits>() {
    let [mut dedans, mut sans_fond, mut coupees, mut hors] = [0; 4];
    for regime in regimes::<R>() {
        let faire = |alea: &mut Hasard| {
            let cas = (regime.cas)(alea);
            let Cas { objet, rayon } = if alea.bool() { vers_la_sortie(cas, alea) } else { cas };
            let flou = rayon.source().longueur() * R::depuis_f64(deux_puissance(alea, -54.0, -2.0));
            let avec_flou = rayon.avec_flou(flou).unwrap_or(rayon);
            (objet, rayon, avec_flou, deux_puissance(alea, -3.0, 1.0))
        };
        pour_chaque(2_000, faire, |(objet, rayon, avec_flou, part)| {
            let [entree, sortie] =
                [objet.intersection(&rayon), objet.sortie(&rayon)].map(|t| t.map(|t| t.distance()));
            let contient = objet.contient(rayon.source());
            let entree = if contient { Ok(R::ZERO) } else { entree };
            let (s, d) = (rayon.source(), rayon.direction());
            let sans_issue = match &objet {
                ObjetRay::Plan(plan) => {
                    let monte = plan.normale().produit_scalaire(d) > R::ZERO;
                    let haut = plan.normale().produit_scalaire(s) + plan.distance();
                    entree.is_ok() && (!monte || (haut < R::ZERO && sortie.is_err()))
                }
                ObjetRay::Sphere(_) | ObjetRay::Boite(_) => false,
            };
            let attendue = entree.and_then(|de| match sortie {
                Ok(a) => Ok([de, a]),
                Err(refus) => sans_issue.then_some([de, R::INFINI]).ok_or(refus),
            });
            let traversee = objet.traversee(&rayon);
            assert_eq!(traversee, attendue, "{objet:?} {rayon:?}");
            assert_eq!(objet.traversee(&avec_flou), attendue, "δ counts");
            assert!(traversee.is_ok() || sortie.is_err(), "{sortie:?}");
            if let Ok(touche) = objet.intersection(&avec_flou) {
                assert_eq!(traversee.map(|[de, _]| de), Ok(touche.distance()));
            }
            hors += u32::from(traversee.is_err());
            let Ok([de, a]) = traversee else { return };
            assert!(de <= a && R::ZERO <= de, "{de} {a}");
            (dedans, sans_fond) = (dedans + u32::from(contient), sans_fond + u32::from(sans_issue));
            for fin in [R::ZERO, de, de * R::depuis_f64(part), a, a * R::depuis_f64(part)] {
                let Ok(court) = rayon.jusqu_a(fin) else { continue };
                let coupee = if a < fin { a } else { fin };
                let attendue = if de < fin { Ok([de, coupee]) } else { Err(NoIntersection) };
                assert_eq!(objet.traversee(&court), attendue, "until {fin}");
                coupees += u32::from(attendue.is_ok() && coupee < a);
            }
        });
    }
    println!("{dedans} {sans_fond} {coupees} {hors}");
    assert!(dedans > 1_000 && sans_fond > 1_000 && coupees > 1_000 && hors > 1_000);
}

en_f32_et_f64!(une_traversee_va_de_l_entree_a_la_sortie);

/// Rays from exactly on a surface, in the plane of a face and level over a half-space, where every number is exact: inward
/// through the object, outward not at all, and along a half-space for ever. Where what is inside ends, there is the way
/// out.
fn de_la_surface_un_rayon_sort_en_face_ou_pas<R: Bits>() {
    let boule = sphere(Vecteur::NUL, R::depuis_f64(5.0));
    let boite = boite_droite(Vecteur::NUL, v(2.0, 4.0, 6.0));
    let sol = mur(Vecteur::NUL, Vecteur::Y);
    let (haut, bas, cote) = ([0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [-1.0, -0.0, -0.0]);
    // Where the ray starts and goes, from where to where it is inside, and N at the way out.
    let (sans_fin, rien) = (f64::INFINITY, [0.0; 3]);
    for (objet, source, vers, part, n) in [
        (boule, [3.0, 4.0, 0.0], bas, Some([0.0, 8.0]), [0.6, -0.8, 0.0]),
        (boule, [3.0, 4.0, 0.0], haut, None, rien),
        (boule, [3.0, 9.0, 0.0], bas, Some([5.0, 13.0]), [0.6, -0.8, 0.0]),
        (boule, [5.0, 0.0, 0.0], haut, None, rien), // a tangent
        (boule, [5.0, -9.0, 0.0], haut, None, rien), // and one from afar
        (boule, [0.0, 0.0, 0.0], haut, Some([0.0, 5.0]), haut),
        (boule, [0.0, 4.0, 0.0], haut, Some([0.0, 1.0]), haut),
        (boule, [0.0, 9.0, 0.0], haut, None, rien),
        (boite, [0.5, 2.0, 0.0], bas, Some([0.0, 4.0]), bas),
        (boite, [0.5, 2.0, 0.0], haut, None, rien),
        (boite, [0.5, 1.5, 0.0], haut, Some([0.0, 0.5]), haut),
        // In the plane of a face, which belongs to the box; along an edge; beside the box.
        (boite, [1.0, 0.0, 0.0], haut, Some([0.0, 2.0]), haut),
        (boite, [1.0, -9.0, 3.0], haut, Some([7.0, 11.0]), haut),
        (boite, [1.5, 0.0, 0.0], haut, None, rien),
        (sol, [0.0, -3.0, 0.0], haut, Some([0.0, 3.0]), haut),
        (sol, [0.0, -3.0, 0.0], bas, Some([0.0, sans_fin]), rien),
        (sol, [0.0, -3.0, 0.0], cote, Some([0.0, sans_fin]), rien),
        // Too far for the type.
        (sol, [0.0, -3.0, 0.0], [1.0, R::ETA.vers_f64(), 0.0], Some([0.0, sans_fin]), rien),
        (sol, [0.0, 0.0, 0.0], haut, None, rien),
        (sol, [0.0, 0.0, 0.0], bas, Some([0.0, sans_fin]), rien),
        (sol, [0.0, 0.0, 0.0], cote, Some([0.0, sans_fin]), rien),
        (sol, [0.0, 3.0, 0.0], bas, Some([3.0, sans_fin]), rien),
        (sol, [0.0, 3.0, 0.0], cote, None, rien),
    ] {
        let rayon = Rayon::new(arrondi(source.into()), arrondi(vers.into())).unwrap();
        let obtenue = objet.traversee(&rayon).ok().map(|part| part.map(R::vers_f64));
        assert_eq!(obtenue, part, "{objet:?} {rayon:?}");
        let sortie = objet.sortie(&rayon).ok();
        let sortie = sortie.map(|s| (s.distance().vers_f64(), s.normale(), s.indice()));
        let attendue = part.map(|[_, a]| a).filter(|a| *a < sans_fin);
        assert_eq!(sortie, attendue.map(|a| (a, arrondi(n.into()), 0)), "{objet:?} {rayon:?}");
    }
    // The ray and an edge share one point.
    let rayon = Rayon::new(v(0.0, 3.0, 0.0), v(1.0, -1.0, 0.0)).unwrap();
    let [entree, sortie] = boite.traversee(&rayon).unwrap();
    assert_eq!(entree, sortie);
    // Through a corner the first pair gives the normal, as at an entry.
    let coin = Rayon::new(v(0.0, 1.0, 2.0), v(1.0, 1.0, 1.0)).unwrap();
    assert_eq!(boite.sortie(&coin).unwrap().normale(), Vecteur::X);
}

en_f32_et_f64!(de_la_surface_un_rayon_sort_en_face_ou_pas);
