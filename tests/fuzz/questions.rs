//! Raw bytes made into objects, transformations and rays: every value is refused or valid, and every
//! answer to every ray is what it must be, alone, in a batch and in a hierarchy.
//!
//! Numbers are raw bits, or one that came before or its neighbour, without which nothing would ever
//! coincide.

#![no_main]

use lancer_rayon::{
    BoiteGeo, ErreurGeo, Hierarchie, Intersection, NoIntersection, ObjetGeo, ObjetRay,
    PlacesInsuffisantes, PlanGeo, Rayon, Rotation, SphereGeo, Texture, Vecteur, est_certaine,
    est_occulte, etendue,
};
use libfuzzer_sys::fuzz_target;

use commun::Bits;
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
    // In the second long boxes are cut into pieces.
    let [mut places, mut autres] =
        [1, 6].map(|fois| vec![0.0; fois * Hierarchie::places(objets.len())]);
    let hierarchie = Hierarchie::new(&objets, &mut places).unwrap();
    let en_double = Hierarchie::new(&doubles, &mut autres).unwrap();
    for (rayon, suivant) in rayons.iter().zip(rayons.iter().cycle().skip(1)) {
        for &max in &limites {
            let occulte =
                objets.iter().any(|o| o.intersection(rayon).is_ok_and(|i| i.distance() < max));
            assert_eq!(est_occulte(&objets, rayon, max), occulte);
        }
        certificats(&hierarchie, &en_double, rayon);
        for objet in &objets {
            secondaires(objet, rayon, suivant.direction());
            apres_coup(objet, [rayon, suivant]);
        }
    }
    Some(())
}

fuzz_target!(|octets: &[u8]| {
    if let Some((genre, reste)) = octets.split_first() {
        let _ = if genre % 2 == 0 { attaquer::<f32>(reste) } else { attaquer::<f64>(reste) };
    }
});
