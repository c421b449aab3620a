//! Raw bytes made into objects, transformations and rays: every value is refused or valid, and every
//! answer to every ray is what it must be, alone, in a batch and in a hierarchy.
//!
//! Numbers are raw bits, or one that came before or its neighbour, without which nothing would ever
//! coincide.

#![no_main]

use std::sync::atomic::{AtomicU32, Ordering};

use lancer_rayon::{
    BoiteGeo, ErreurGeo, Hierarchie, Intersection, NoIntersection, ObjetGeo, ObjetRay,
    PlacesInsuffisantes, PlanGeo, Rayon, Rotation, SphereGeo, Texture, Vecteur, est_certaine,
    est_occulte, etendue, premiere_intersection,
};
use libfuzzer_sys::fuzz_target;

use commun::Bits;
use commun::conversion::{Mots, mots};
use commun::facons::comparer;

struct Octets<'a, R> {
    reste: &'a [u8],
    vus: Vec<R>,
}

impl<R: Bits> Octets<'_, R> {
    fn octet(&mut self) -> Option<u8> {
        let (premier, reste) = self.reste.split_first()?;
        self.reste = reste;
        Some(*premier)
    }

    fn reel(&mut self) -> Option<R> {
        let genre = self.octet()?;
        let vu = self.vus.get(usize::from(genre >> 3)).copied();
        let x = match (genre & 7, vu) {
            (0, Some(vu)) => vu,
            (1, Some(vu)) => -vu,
            (2, Some(vu)) => vu * (R::UN + R::U + R::U),
            (3, Some(vu)) => vu * (R::UN - R::U - R::U),
            (4, _) => R::depuis_f64(f64::from(genre >> 3) - 16.0),
            _ => {
                let (bits, reste) = self.reste.split_first_chunk::<8>()?;
                self.reste = reste;
                R::depuis_bits(u64::from_le_bytes(*bits))
            }
        };
        self.vus.push(x);
        Some(x)
    }

    fn vecteur(&mut self) -> Option<Vecteur<R>> {
        Some(Vecteur::new(self.reel()?, self.reel()?, self.reel()?))
    }

    fn rotation(&mut self) -> Option<Rotation<R>> {
        let angles = self.vecteur()?;
        let rotation = Rotation::new(angles);
        assert!(rotation.is_ok() || !angles.vers_f64().longueur().is_finite());
        Some(rotation.unwrap_or(Rotation::IDENTITE))
    }

    fn objet(&mut self, texture: Texture) -> Option<Result<ObjetGeo<R>, ErreurGeo>> {
        Some(match self.octet()? % 3 {
            0 => SphereGeo::new(self.vecteur()?, self.reel()?, texture).map(ObjetGeo::from),
            1 => PlanGeo::new(self.rotation()?, self.reel()?, texture).map(ObjetGeo::from),
            _ => BoiteGeo::new(self.vecteur()?, self.vecteur()?, self.rotation()?, texture)
                .map(ObjetGeo::from),
        })
    }
}

fn verifier<R: Bits>(rayon: &Rayon<R>, touche: &Intersection<R>) {
    assert!(touche.distance() > R::ZERO && touche.distance() < R::INFINI);
    assert!(touche.normale().produit_scalaire(rayon.direction()) < R::ZERO);
    let ecart = (touche.normale().vers_f64().longueur() - 1.0).abs();
    assert!(ecart <= 4.0 * R::U.vers_f64(), "|N| is off by {ecart:e}");
    assert!(touche.marge() >= R::ZERO, "margin {}", touche.marge());
}

/// The rays that leave from where `rayon` touches this object, outward and along: none touches it.
fn secondaires<R: Bits>(objet: &ObjetRay<R>, rayon: &Rayon<R>, vers: Vecteur<R>) {
    let Ok(touche) = objet.intersection(rayon) else { return };
    verifier(rayon, &touche);
    for vers in [vers, -vers, touche.normale(), -rayon.direction()] {
        let Ok(secondaire) = rayon.secondaire(&touche, vers) else { continue };
        if secondaire.direction().produit_scalaire(touche.normale()) > R::ZERO {
            assert_eq!(objet.intersection(&secondaire), Err(NoIntersection), "{objet:?} {rayon:?}");
        }
    }
    if let Ok(reflet) = rayon.reflechi(&touche) {
        assert_eq!(objet.intersection(&reflet), Err(NoIntersection), "{objet:?} {rayon:?}");
    }
    if let Some((ombre, loin)) = rayon.vers_soleil(&touche, vers) {
        assert!(!est_occulte(std::slice::from_ref(objet), &ombre, loin), "{objet:?} {rayon:?}");
    }
    if let ObjetRay::Boite(boite) = objet {
        let (face, p) = boite.lieu(rayon, &touche);
        assert_eq!(boite.face(face).1, touche.normale(), "{objet:?} {rayon:?}");
        assert!(<[R; 3]>::from(p).into_iter().all(|x| x.abs() <= R::UN), "{objet:?} {rayon:?}");
    }
}

/// Where a ray leaves this object: once, never before it enters, with a normal along the ray; and on from there outward
/// it neither enters nor leaves it again.
fn sorties<R: Bits>(objet: &ObjetRay<R>, rayon: &Rayon<R>, vers: Vecteur<R>) {
    let (entree, sortie) = (objet.intersection(rayon), objet.sortie(rayon));
    let contexte = || format!("{objet:?} {rayon:?} {entree:?} {sortie:?}");
    let borne = !matches!(objet, ObjetRay::Plan(_));
    match (entree, sortie) {
        (Ok(entree), Ok(sortie)) => {
            assert!(borne && entree.distance() <= sortie.distance(), "{}", contexte());
        }
        (Ok(_), Err(_)) => assert!(!borne, "enters and stays: {}", contexte()),
        (Err(_), Ok(_)) => assert!(objet.contient(rayon.source()), "{}", contexte()),
        (Err(_), Err(_)) => {}
    }
    let Ok(sortie) = sortie else { return };
    assert!(sortie.distance() > R::ZERO && sortie.distance() < R::INFINI, "{}", contexte());
    let n = sortie.normale();
    assert!(n.produit_scalaire(rayon.direction()) > R::ZERO, "{}", contexte());
    assert!((n.vers_f64().longueur() - 1.0).abs() <= 8.0 * R::U.vers_f64(), "{}", contexte());
    assert!(sortie.marge() >= R::ZERO, "{}", contexte());
    // That is of entries; of a way out it says anything but a NaN.
    assert!(objet.erreur(rayon, &sortie) >= R::ZERO, "{}", contexte());
    if let ObjetRay::Boite(boite) = objet {
        let (face, p) = boite.lieu(rayon, &sortie);
        assert_eq!(boite.face(face).1, n, "{}", contexte());
        assert!(<[R; 3]>::from(p).into_iter().all(|x| x.abs() <= R::UN), "{}", contexte());
    }
    for vers in [vers, -vers, n, -n, rayon.direction()] {
        let Ok(suite) = rayon.secondaire(&sortie, vers) else { continue };
        if suite.direction().produit_scalaire(n) > R::ZERO {
            let encore = [objet.intersection(&suite), objet.sortie(&suite)];
            assert_eq!(encore, [Err(NoIntersection); 2], "{} {suite:?}", contexte());
        } else if let ObjetRay::Sphere(_) = objet {
            assert_eq!(objet.intersection(&suite), Err(NoIntersection), "{} {suite:?}", contexte());
            assert!(objet.sortie(&suite).is_ok(), "{} {suite:?}", contexte());
        }
    }
}

/// What two choices take, one among the other, in order before these limits, as many as so many places hold: beside
/// each object asked alone. What they leave out is no answer of which to be certain.
fn des_choix<R: Bits>(
    hierarchie: &Hierarchie<'_, R>,
    rayon: &Rayon<R>,
    limites: &[R],
    [un, deux, places]: [u8; 3],
) {
    let [un, deux] = [un, deux].map(|masque| move |indice: usize| masque >> (indice % 8) & 1 == 0);
    let prend = |indice: usize| un(indice) && deux(indice);
    let parmi = hierarchie.parmi(&un);
    let parmi = parmi.parmi(&deux);
    let touche = |(indice, objet): (usize, &ObjetRay<R>)| {
        let touche = objet.intersection(rayon).ok().filter(|_| prend(indice))?;
        Some((touche.distance(), Mots { objet: Some(indice), ..mots(&Ok(touche)) }))
    };
    let objets = hierarchie.objets();
    let mut toutes: Vec<_> = objets.iter().enumerate().filter_map(touche).collect();
    // Stable: of equal distances the earlier in the list.
    toutes.sort_by(|(a, _), (b, _)| a.partial_cmp(b).unwrap());
    let une = toutes.get(usize::from(places) % (toutes.len() + 1)).map(|(t, _)| *t);
    for &limite in limites.iter().chain(&une).chain(&[R::INFINI]) {
        let avant = toutes.iter().filter(|(t, _)| *t < limite);
        let voulues: Vec<_> = avant.map(|(_, mots)| *mots).collect();
        let contexte = || format!("before {limite:?}: {rayon:?} {objets:?}");
        let premiere = voulues.first().copied().unwrap_or_else(|| mots::<R>(&Err(NoIntersection)));
        assert_eq!(mots(&parmi.premiere_avant(rayon, limite)), premiere, "{}", contexte());
        assert_eq!(parmi.est_occulte(rayon, limite), !voulues.is_empty(), "{}", contexte());
        let mut touches = vec![Err(NoIntersection); usize::from(places) % 9];
        let nombre = parmi.dans_l_ordre(rayon, limite, &mut touches);
        let obtenues: Vec<_> = touches[..nombre].iter().map(mots).collect();
        assert_eq!(obtenues, voulues[..voulues.len().min(touches.len())], "{}", contexte());
        assert!(touches[nombre..].iter().all(Result::is_err), "{}", contexte());
    }
    let toute = hierarchie.premiere_intersection(rayon);
    if toute.is_ok_and(|touche| !prend(touche.objet())) {
        assert!(!parmi.est_certaine(rayon, &toute), "{rayon:?} {objets:?}");
    }
    let restants: Vec<_> =
        objets.iter().enumerate().filter(|(i, _)| prend(*i)).map(|(_, objet)| *objet).collect();
    let seule = premiere_intersection(&restants, rayon);
    if est_certaine(&restants, rayon, &seule) {
        let choisie = parmi.premiere_intersection(rayon);
        assert!(parmi.est_certaine(rayon, &choisie), "{rayon:?} {objets:?}");
    }
}

/// A choice that answers otherwise each time: every answer is still a hit of some object, in order.
fn un_choix_inconstant<R: Bits>(hierarchie: &Hierarchie<'_, R>, rayons: &[Rayon<R>], graine: u8) {
    let etat = AtomicU32::new(graine.into());
    let inconstant = |_: usize| {
        let suivant = etat.load(Ordering::Relaxed).wrapping_mul(747_796_405).wrapping_add(1);
        etat.store(suivant, Ordering::Relaxed);
        suivant >> 31 == 0
    };
    let parmi = hierarchie.parmi(&inconstant);
    let mut lot = vec![Err(NoIntersection); rayons.len()];
    parmi.premieres_intersections(rayons, &mut lot).unwrap();
    for (rayon, touche) in rayons.iter().zip(lot) {
        let mut touches = [Err(NoIntersection); 4];
        let nombre = parmi.dans_l_ordre(rayon, R::INFINI, &mut touches);
        let places: Vec<_> =
            touches[..nombre].iter().flatten().map(|t| (t.distance(), t.objet())).collect();
        assert!(places.len() == nombre && places.windows(2).all(|w| w[0] < w[1]));
        let une = parmi.premiere_intersection(rayon);
        let _ = (parmi.est_certaine(rayon, &une), parmi.est_occulte(rayon, R::INFINI));
        for touche in touches.iter().chain(&[touche, une]).flatten() {
            let seule = hierarchie.objets()[touche.objet()].intersection(rayon);
            assert_eq!(mots(&seule).valeurs, mots(&Ok(*touche)).valeurs, "{rayon:?}");
        }
    }
}

/// What is asked after the fact: certain answers of two precisions agree, and so do two bounded distances; and
/// from one hit to the next nothing of the object itself is in the way.
fn apres_coup<R: Bits>(objet: &ObjetRay<R>, [rayon, autre]: [&Rayon<R>; 2]) {
    let (double, en_double) = (objet.vers_f64(), rayon.vers_f64());
    let (touche, la) = (objet.intersection(rayon), double.intersection(&en_double));
    if objet.est_certain(rayon) && double.est_certain(&en_double) {
        assert_eq!(touche.is_ok(), la.is_ok(), "{objet:?} {rayon:?}");
    }
    if objet.contient(rayon.source()) {
        assert_eq!(touche, Err(NoIntersection), "from inside: {objet:?} {rayon:?}");
    }
    let Ok(touche) = touche else { return };
    let erreur = objet.erreur(rayon, &touche).vers_f64();
    assert!(erreur > 0.0);
    if let Ok(la) = la {
        let permis = (erreur + double.erreur(&en_double, &la)) * (1.0 + 4.0 * f64::EPSILON);
        let ecart = (touche.distance().vers_f64() - la.distance()).abs();
        assert!(ecart <= permis, "{ecart:e} > {permis:e}: {objet:?} {rayon:?}");
    }
    if let Ok(cible) = objet.intersection(autre)
        && let Some((vers, avant)) = rayon.vers_touche(&touche, autre, &cible)
    {
        assert!(!est_occulte(std::slice::from_ref(objet), &vers, avant), "{objet:?} {vers:?}");
    }
}

/// Certain answers of two precisions name the same object, or none, of a list and of a tree.
fn certificats<R: Bits>(
    hierarchie: &Hierarchie<'_, R>,
    en_double: &Hierarchie<'_>,
    rayon: &Rayon<R>,
) {
    let (touche, double) = (hierarchie.premiere_intersection(rayon), rayon.vers_f64());
    let la = en_double.premiere_intersection(&double);
    let sure = est_certaine(hierarchie.objets(), rayon, &touche)
        || hierarchie.est_certaine(rayon, &touche);
    let sure_la =
        est_certaine(en_double.objets(), &double, &la) || en_double.est_certaine(&double, &la);
    if sure && sure_la {
        let [ici, la] = [touche.ok().map(|t| t.objet()), la.ok().map(|t| t.objet())];
        assert_eq!(ici, la, "{:?} {rayon:?}", hierarchie.objets());
    }
}

/// Places that are one too few are refused.
fn trop_peu_de_places<R: Bits>(objets: &[ObjetRay<R>]) {
    let necessaires = Hierarchie::places(objets.len());
    if let Some(places) = necessaires.checked_sub(1) {
        let mut pretees = vec![0.0; places];
        let refus = Hierarchie::new(objets, &mut pretees).unwrap_err();
        assert_eq!(refus, PlacesInsuffisantes { places, necessaires });
    }
}

fn attaquer<R: Bits>(octets: &[u8]) -> Option<()> {
    // Two choices, how many places for an order, and how many more for a tree.
    let (&[un, deux, rangs, plus], octets) = octets.split_first_chunk()?;
    let mut octets = Octets { reste: octets, vus: vec![R::LIMITE, R::UN / R::LIMITE] };
    let (mut objets, mut rayons) = (Vec::<ObjetGeo<R>>::new(), Vec::<Rayon<R>>::new());
    let mut lire = || {
        loop {
            match octets.octet()? % 7 {
                0 => objets.extend(octets.objet(Texture(objets.len() as u32))?),
                1 => {
                    let (v, k) = (octets.vecteur()?, octets.reel()?);
                    let r = octets.rotation()?;
                    let Some(objet) = objets.pop() else { continue };
                    let change = objet.translation(v).and_then(|o| o.rotation(r));
                    objets.push(change.and_then(|o| o.homothetie(k)).unwrap_or(objet));
                }
                2 => rayons.extend(Rayon::new(octets.vecteur()?, octets.vecteur()?)),
                3 => {
                    // Towards an object: a random ray hardly ever touches one.
                    let (de, vers) = (octets.vecteur()?, octets.vecteur()?);
                    rayons.extend(Rayon::new(de, vers - de));
                }
                6 => {
                    // A row of them: few bytes make few objects.
                    let (n, v) = (octets.octet()?, octets.vecteur()?);
                    let Some(&modele) = objets.last() else { continue };
                    let ecart = |i| v * R::depuis_f64(f64::from(i));
                    objets.extend((1..=n).filter_map(|i| modele.translation(ecart(i)).ok()));
                }
                genre => {
                    let Some(rayon) = rayons.last() else { continue };
                    let k = u32::from(octets.octet()?) % 130;
                    let vers = octets.vecteur()?;
                    let faisceau: Vec<_> = (0..k)
                        .filter_map(|i| {
                            let ecart = vers * R::depuis_f64(f64::from(i) / 1024.0);
                            let source = rayon.source();
                            let source = if genre == 4 { source } else { source + ecart };
                            Rayon::new(source, rayon.direction() + ecart).ok()
                        })
                        .collect();
                    rayons.extend(faisceau);
                }
            }
        }
    };
    let fini: Option<()> = lire();
    debug_assert!(fini.is_none());

    let objets: Vec<_> = objets.into_iter().map(ObjetGeo::vers_ray).collect();
    let limites: Vec<_> = octets.vus.iter().copied().take(4).collect();
    comparer(&objets, &rayons);
    trop_peu_de_places(&objets);
    if let Some([bas, haut]) = etendue(&objets) {
        assert!(bas.x <= haut.x && bas.y <= haut.y && bas.z <= haut.z);
    }
    let doubles: Vec<_> = objets.iter().map(|objet| objet.vers_f64()).collect();
    // In the second long boxes are cut into pieces, in the first perhaps some.
    let necessaires = Hierarchie::places(objets.len());
    let [mut places, mut autres] =
        [necessaires + 28 * usize::from(plus), 6 * necessaires].map(|places| vec![0.0; places]);
    let hierarchie = Hierarchie::new(&objets, &mut places).unwrap();
    let en_double = Hierarchie::new(&doubles, &mut autres).unwrap();
    for (rayon, suivant) in rayons.iter().zip(rayons.iter().cycle().skip(1)) {
        for &max in &limites {
            let occulte =
                objets.iter().any(|o| o.intersection(rayon).is_ok_and(|i| i.distance() < max));
            assert_eq!(est_occulte(&objets, rayon, max), occulte);
        }
        certificats(&hierarchie, &en_double, rayon);
        for hierarchie in [hierarchie, Hierarchie::de_liste(&objets)] {
            des_choix(&hierarchie, rayon, &limites, [un, deux, rangs]);
        }
        for objet in &objets {
            secondaires(objet, rayon, suivant.direction());
            sorties(objet, rayon, suivant.direction());
            apres_coup(objet, [rayon, suivant]);
        }
    }
    un_choix_inconstant(&hierarchie, &rayons, rangs);
    Some(())
}

fuzz_target!(|octets: &[u8]| {
    if let Some((genre, reste)) = octets.split_first() {
        let _ = if genre % 2 == 0 { attaquer::<f32>(reste) } else { attaquer::<f64>(reste) };
    }
});
