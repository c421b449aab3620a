//! What every hit, every way out and every ray that starts from one must be, whatever the numbers: the promises of
//! `docs/precision.md` and of the documentation that need no exact answer beside them.

use lancer_rayon::pour_les_tests::{FLOU_DISTANCE, FLOU_POINT, FLOU_PROPRE, TANGENT};
use lancer_rayon::{Intersection, NoIntersection, ObjetRay, Rayon, Reel, Vecteur};

use crate::conversion::{Bits, mots, voisin};
use crate::mesure::{au_bord, poids};
use crate::oracle::{Passage, dehors};
use crate::tolerances::{NORMALE_UNITAIRE, bandes, u};

/// How deep a point lies in an object, beyond the object's own rounding o_B (lemma 22).
pub fn profondeur<R: Reel>(objet: &ObjetRay<R>, point: Vecteur<R>) -> f64 {
    -dehors(objet, point) - flou_propre(objet)
}

/// How much less exactly a path knows its point P at distance t than it knows the source of the ray: 15ut and 8.1u‖P‖₁
/// (lemma 22).
pub fn flou_du_point<R: Reel>(t: R, p: Vecteur<R>) -> f64 {
    let [x, y, z] = <[f64; 3]>::from(p.vers_f64()).map(f64::abs);
    u::<R>() * (FLOU_DISTANCE * t.vers_f64() + FLOU_POINT * (x + y + z))
}

/// o_B of lemma 22.
pub fn flou_propre<R: Reel>(objet: &ObjetRay<R>) -> f64 {
    let taille = match objet {
        ObjetRay::Sphere(sphere) => sphere.rayon().vers_f64(),
        ObjetRay::Plan(_) => 0.0,
        ObjetRay::Boite(boite) => boite.demi_longueurs().map(R::vers_f64).iter().sum(),
    };
    FLOU_PROPRE * u::<R>() * taille
}

/// How far off a computed height over a half-space may be (lemma 3). For the other shapes o_B holds it.
fn arrondi_d_une_hauteur<R: Reel>(objet: &ObjetRay<R>, point: Vecteur<R>) -> f64 {
    let ObjetRay::Plan(plan) = objet else { return 0.0 };
    let poids = poids(plan.normale().vers_f64(), point.vers_f64());
    bandes::PLAN * u::<R>() * poids + bandes::PLAN_ABSOLUE * R::ETA.vers_f64()
}

/// Checks where the ray enters and leaves this object, and whether the rays that start there meet it again. One of
/// these rays goes towards `vers`.
pub fn exiger_les_passages<R: Bits>(objet: &ObjetRay<R>, rayon: &Rayon<R>, vers: Vecteur<R>) {
    let (entree, sortie) = (objet.intersection(rayon), objet.sortie(rayon));
    let contexte = || format!("{objet:?} {rayon:?} {entree:?} {sortie:?}");
    let borne = !matches!(objet, ObjetRay::Plan(_));
    match (entree, sortie) {
        (Ok(entree), Ok(sortie)) => {
            assert!(borne && entree.distance() <= sortie.distance(), "{}", contexte());
        }
        // "A ray that enters a sphere or a box leaves it", unless it ends before. It never leaves a half-space.
        (Ok(_), Err(_)) => assert!(!borne || rayon.fin() < R::INFINI, "{}", contexte()),
        (Err(_), Ok(_)) => assert!(objet.contient(rayon.source()), "{}", contexte()),
        (Err(_), Err(_)) => {}
    }
    exiger_la_fin(objet, rayon);
    exiger_qu_il_ne_s_enfonce_pas(objet, rayon);
    for passage in [entree, sortie].into_iter().flatten() {
        exiger_un_passage(objet, rayon, &passage);
        let (n, d) = (passage.normale(), rayon.direction());
        let libres = [vers, -vers, n, -n, d, -d].map(|vers| passage.secondaire(vers));
        let reflet = passage.reflechi(d);
        let (le_long, monte) =
            (n.produit_scalaire(d), |r: &Rayon<R>| r.direction().produit_scalaire(n));
        // A mirror sends a ray that enters outward, and one that leaves inward, unless the latter grazes: 20u of
        // lemma 9 and 3.2u. The mirrored ray starts where a secondary ray in that direction does, and is refused where
        // that is.
        let rase = le_long > R::ZERO && le_long.vers_f64() < 32.0 * u::<R>();
        let droit = libres[if le_long < R::ZERO { 2 } else { 3 }];
        let sources = [reflet, droit].map(|suite| suite.map(|r| r.source()).map_err(|e| e.champ));
        assert!(rase || sources[0] == sources[1], "{sources:?} {}", contexte());
        let du_bon_cote = |r: Rayon<R>| (monte(&r) > R::ZERO) == (le_long < R::ZERO);
        assert!(rase || reflet.is_ok_and(du_bon_cote) || reflet.is_err(), "{}", contexte());
        exiger_les_lampes(passage, vers);
        let lampes = [passage.vers_soleil(vers), passage.vers_lumiere(vers)];
        // Light passes to the other side, or the error says that all of it is mirrored.
        let derriere = libres[if le_long < R::ZERO { 3 } else { 2 }];
        let verres = [0.6, 1.5].map(|rapport| passage.refracte(d, R::depuis_f64(rapport)));
        for verre in &verres {
            match verre {
                Ok(verre) => assert!(monte(verre) * le_long > R::ZERO, "{verre:?} {}", contexte()),
                Err(erreur) if erreur.champ == "refraction" => {
                    assert!(erreur.valeur <= 0.0, "{}", contexte());
                }
                // It is refused as any ray to that side is.
                Err(_) => assert!(derriere.is_err(), "{verre:?} {}", contexte()),
            }
        }
        let sans_fin = libres.into_iter().chain(verres).chain([reflet]).flatten();
        for suite in sans_fin.inspect(|suite| assert_eq!(suite.fin(), R::INFINI, "{}", contexte()))
        {
            exiger_une_suite(objet, rayon, &passage, &suite);
        }
        for ombre in lampes.into_iter().flatten() {
            exiger_une_suite(objet, rayon, &passage, &ombre);
        }
    }
}

/// A ray that ends at its own passage finds neither a hit nor a way out there, but with an end one number farther it
/// does.
fn exiger_la_fin<R: Bits>(objet: &ObjetRay<R>, rayon: &Rayon<R>) {
    for passage in Passage::TOUS {
        let Ok(touche) = passage.de(objet, rayon) else { continue };
        let (t, contexte) = (touche.distance(), || format!("{passage:?}: {objet:?} {rayon:?}"));
        let avant = |fin| passage.de(objet, &rayon.jusqu_a(fin).unwrap());
        assert_eq!(avant(t), Err(NoIntersection), "{}", contexte());
        assert_eq!(mots(&avant(voisin(t, 1))), mots(&Ok(touche)), "{}", contexte());
    }
}

/// A sun lights only a surface that faces it by more than 3.2u, and a lamp only one that faces it so from the start of
/// the ray. The ray to a sun is that of `secondaire`, and the ray to a lamp that between two points.
fn exiger_les_lampes<R: Bits>(passage: Intersection<R>, vers: Vecteur<R>) {
    let (n, droit) = (passage.normale(), passage.secondaire(passage.normale()));
    let de_face = |l: Vecteur<R>| l.produit_scalaire(n).vers_f64() > TANGENT * u::<R>();
    let direction = Rayon::new(Vecteur::NUL, vers).map(|rayon| rayon.direction());
    let ombre = passage.vers_soleil(vers);
    assert_eq!(
        ombre.is_ok(),
        droit.is_ok() && direction.is_ok_and(de_face),
        "{passage:?} {vers:?}"
    );
    assert!(ombre.is_err() || ombre == passage.secondaire(vers), "{passage:?} {vers:?}");
    let Ok(depart) = droit else { return };
    let voulue = Rayon::entre(depart.source(), vers).ok().filter(|r| de_face(r.direction()));
    let ce_qu_il_est = |r: Rayon<R>| (r.source(), r.direction(), r.fin());
    let ombre = passage.vers_lumiere(vers).ok();
    assert_eq!(ombre.map(ce_qu_il_est), voulue.map(ce_qu_il_est), "{passage:?} {vers:?}");
    assert!(ombre.is_none_or(|r| r.flou() == depart.flou()), "{passage:?} {vers:?}");
}

/// Whether this object, which holds the source of the ray, holds it by no more than δ, which is above 0, and o_B however
/// that is rounded, and the ray is not inside something on purpose. A height over a half-space rounds by u of itself,
/// which may be δ, and `profondeur` by 3u of `f64` (lemma 22, D1 to D3).
pub fn est_a_fleur<R: Reel>(objet: &ObjetRay<R>, rayon: &Rayon<R>) -> bool {
    let (source, flou) = (rayon.source(), rayon.flou().vers_f64());
    // `dedans` changes no ray that is inside already.
    flou > 0.0
        && *rayon != rayon.dedans()
        && profondeur(objet, source) + arrondi_d_une_hauteur(objet, source)
            <= (1.0 - 4.0 * u::<R>()) * flou
}

/// Lemma 22: an object that holds the start of a ray by no more than δ and o_B, and that the ray does not touch at
/// once, is on the ray's way nowhere deeper than the next start may be. The middle of that way is tried.
fn exiger_qu_il_ne_s_enfonce_pas<R: Bits>(objet: &ObjetRay<R>, rayon: &Rayon<R>) {
    let rayon = rayon.jusqu_a(R::INFINI).unwrap();
    let flou = rayon.flou().vers_f64();
    if objet.contient(rayon.source())
        && est_a_fleur(objet, &rayon)
        && objet.intersection(&rayon).is_err()
    {
        let au_milieu = |t: Intersection<R>| t.distance() / (R::UN + R::UN);
        let t = objet.sortie(&rayon).map_or(rayon.flou(), au_milieu);
        let p = rayon.point(t);
        let (profond, permis) = (profondeur(objet, p), flou + flou_du_point(t, p));
        assert!(profond <= permis, "{profond:e} > {permis:e}: {objet:?} {rayon:?}");
    }
}

/// Checks a hit of this ray on this object, or its way out. N tells which of the two it is.
pub fn exiger_un_passage<R: Bits>(
    objet: &ObjetRay<R>,
    rayon: &Rayon<R>,
    passage: &Intersection<R>,
) {
    let contexte = || format!("{objet:?} {rayon:?} {passage:?}");
    let (t, n) = (passage.distance(), passage.normale());
    let entre = n.produit_scalaire(rayon.direction()) < R::ZERO;
    assert!(entre || n.produit_scalaire(rayon.direction()) > R::ZERO, "{}", contexte());
    assert!(t >= R::ZERO && t < rayon.fin(), "{}", contexte());
    let ecart = (n.vers_f64().longueur() - 1.0).abs();
    assert!(ecart <= NORMALE_UNITAIRE * u::<R>(), "|N| is off by {ecart:e}: {}", contexte());
    assert_eq!(coordonnees(passage.point()), coordonnees(rayon.point(t)), "{}", contexte());
    assert!(passage.marge() >= R::ZERO, "{}", contexte());
    assert!(objet.erreur(rayon, passage) > R::ZERO, "{}", contexte());
    if entre {
        // By `contient`, a ray from such a point touches the object at once or not at all, and at once only if it has a
        // δ.
        assert_eq!(t == R::ZERO, objet.contient(rayon.source()), "{}", contexte());
    } else {
        assert!(t > R::ZERO, "the source is no way out: {}", contexte());
    }
    if t == R::ZERO {
        let (flou, source) = (rayon.flou(), rayon.source());
        // Lemma 22: the object holds the start by no more than 2(δ+o_B), as computed.
        let permis =
            2.0 * flou.vers_f64() + flou_propre(objet) + arrondi_d_une_hauteur(objet, source);
        assert!(flou > R::ZERO && profondeur(objet, source) <= permis, "{}", contexte());
    }
    if let ObjetRay::Boite(boite) = objet {
        let (face, p) = boite.lieu(rayon, passage);
        assert_eq!(boite.face(face).1, n, "{}", contexte());
        let p = <[R; 3]>::from(p);
        assert!(p.into_iter().all(|x| x.absolu() <= R::UN), "{}", contexte());
        let un = if (face as usize) < 3 { R::UN } else { -R::UN };
        assert_eq!(p[face as usize % 3], un, "{}", contexte());
    }
}

/// Checks a ray that starts where another enters this object or leaves it. Outward it never meets the object again, and
/// inward only beside an edge of a box (lemma 9); from within a sphere it leaves.
pub fn exiger_une_suite<R: Bits>(
    objet: &ObjetRay<R>,
    rayon: &Rayon<R>,
    passage: &Intersection<R>,
    suite: &Rayon<R>,
) {
    let contexte = || format!("{objet:?} {rayon:?} {passage:?} {suite:?}");
    let (entree, sortie) = (objet.intersection(suite), objet.sortie(suite));
    if suite.direction().produit_scalaire(passage.normale()) > R::ZERO {
        assert_eq!([entree, sortie], [Err(NoIntersection); 2], "{}", contexte());
        return;
    }
    // The ray is inside, and has no end.
    assert_eq!(suite.fin(), R::INFINI, "{}", contexte());
    match objet {
        ObjetRay::Sphere(_) => assert!(entree.is_err() && sortie.is_ok(), "{}", contexte()),
        ObjetRay::Plan(_) => assert!(entree.is_err(), "{}", contexte()),
        ObjetRay::Boite(_) => {
            let a_cote = |encore| au_bord(objet, rayon, passage, suite.source(), &encore);
            assert!(entree.is_err() || entree.is_ok_and(a_cote), "{}", contexte());
        }
    }
}

/// Checks what is asked after the fact: certain answers in two precisions agree, and so do two distances within their
/// bounds; and the object itself does not hide one of its hits from another.
pub fn exiger_apres_coup<R: Bits>(objet: &ObjetRay<R>, [rayon, autre]: [&Rayon<R>; 2]) {
    let (double, en_double) = (objet.temoin_f64(), rayon.temoin_f64());
    let (touche, la) = (objet.intersection(rayon), double.intersection(&en_double));
    if objet.est_certain(rayon) && double.est_certain(&en_double) {
        assert_eq!(touche.is_ok(), la.is_ok(), "{objet:?} {rayon:?}");
    }
    let Ok(touche) = touche else { return };
    if let Ok(la) = la {
        let erreurs = objet.erreur(rayon, &touche).vers_f64() + double.erreur(&en_double, &la);
        let permis = erreurs * (1.0 + 4.0 * f64::EPSILON);
        let ecart = (touche.distance().vers_f64() - la.distance()).abs();
        assert!(ecart <= permis, "{ecart:e} > {permis:e}: {objet:?} {rayon:?}");
    }
    let Ok(cible) = objet.intersection(autre) else { return };
    if let Some(vers) = exiger_le_retour(&touche, &cible) {
        assert_eq!(objet.intersection(&vers), Err(NoIntersection), "{objet:?} {vers:?}");
    }
}

/// The ray from one hit to another. The ray back is exactly the same line, or an error as well (lemma 12).
pub fn exiger_le_retour<R: Bits>(de: &Intersection<R>, a: &Intersection<R>) -> Option<Rayon<R>> {
    let (aller, retour) = (de.vers_touche(a), a.vers_touche(de));
    assert_eq!(aller.is_ok(), retour.is_ok(), "{de:?} {a:?}");
    let (aller, retour) = (aller.ok()?, retour.ok()?);
    assert_eq!((retour.fin(), retour.direction()), (aller.fin(), -aller.direction()));
    Some(aller)
}

/// The bits of three coordinates.
pub fn coordonnees<R: Bits>(p: Vecteur<R>) -> [u64; 3] {
    <[R; 3]>::from(p).map(R::bits)
}
