//! Raw bytes made into objects, transformations and rays: every value is refused or valid, and every
//! answer to every ray is what it must be, alone, in a batch and in a hierarchy.
//!
//! Numbers are raw bits, or one that came before or its neighbour, without which nothing would ever
//! coincide.

#![no_main]

use lancer_rayon::{
    BoiteGeo, ErreurGeo, Hierarchie, Intersection, NoIntersection, ObjetGeo, ObjetRay,
    PlacesInsuffisantes, PlanGeo, Rayon, Reglage, Rotation, SphereGeo, Texture, Vecteur,
    est_occulte, premiere_intersection,
};
use libfuzzer_sys::fuzz_target;

use commun::conversion::{Bits, Mots, mots};

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
}

/// The answers of a list: the words of the first hit of each ray, and whether something stands before
/// each of these limits.
struct Attendu<R> {
    premiers: Vec<Mots>,
    limites: Vec<R>,
    ombres: Vec<Vec<bool>>,
}

/// The hierarchy over the list, in more places than it needs by `de_plus`, or in one too few.
fn hierarchie<R: Bits>(
    objets: &[ObjetRay<R>],
    rayons: &[Rayon<R>],
    attendu: &Attendu<R>,
    de_plus: usize,
) {
    let necessaires = Hierarchie::places(objets.len());
    // What they hold does not matter.
    let mut places = vec![attendu.limites[0].vers_f64() as f32; necessaires + de_plus];
    if let Some(pretees) = places[..necessaires].split_last_mut().map(|(_, reste)| reste) {
        let places = pretees.len();
        let refus = Hierarchie::new(objets, pretees).unwrap_err();
        assert_eq!(refus, PlacesInsuffisantes { places, necessaires });
    }
    let hierarchie = Hierarchie::new(objets, &mut places).unwrap();
    for (_, reglage) in Reglage::tous() {
        let hierarchie = reglage.hierarchie(hierarchie);
        let mut touches = vec![Err(NoIntersection); rayons.len()];
        hierarchie.premieres_intersections(rayons, &mut touches).unwrap();
        assert!(touches.iter().map(mots).eq(attendu.premiers.iter().copied()), "{objets:?}");
        for ((rayon, premier), ombres) in rayons.iter().zip(&attendu.premiers).zip(&attendu.ombres)
        {
            assert_eq!(mots(&hierarchie.premiere_intersection(rayon)), *premier, "{rayon:?}");
            for (&limite, &ombre) in attendu.limites.iter().zip(ombres) {
                assert_eq!(hierarchie.est_occulte(rayon, limite), ombre, "{rayon:?} {limite:?}");
            }
        }
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
    let mut attendu = Attendu { premiers: Vec::new(), limites, ombres: Vec::new() };
    for rayon in &rayons {
        let premiere = premiere_intersection(&objets, rayon);
        if let Ok(touche) = premiere {
            verifier(rayon, &touche);
            assert!(est_occulte(&objets, rayon, R::INFINI));
        }
        let juger = |max: R| {
            let occulte =
                objets.iter().any(|o| o.intersection(rayon).is_ok_and(|i| i.distance() < max));
            assert_eq!(est_occulte(&objets, rayon, max), occulte);
            occulte
        };
        attendu.ombres.push(attendu.limites.iter().map(|&max| juger(max)).collect());
        premiere.map(|t| juger(t.distance())).ok();
        attendu.premiers.push(mots(&premiere));
    }
    hierarchie(&objets, &rayons, &attendu, objets.len() % 3);
    for (rayon, suivant) in rayons.iter().zip(rayons.iter().cycle().skip(1)) {
        for objet in &objets {
            secondaires(objet, rayon, suivant.direction());
        }
    }
    for (_, reglage) in Reglage::tous() {
        for reglage in [reglage, reglage.sans_elagage()] {
            let mut touches = vec![Err(NoIntersection); rayons.len()];
            reglage.premieres_intersections(&objets, &rayons, &mut touches).unwrap();
            assert!(touches.iter().map(mots).eq(attendu.premiers.iter().copied()));
        }
    }
    Some(())
}

fuzz_target!(|octets: &[u8]| {
    if let Some((genre, reste)) = octets.split_first() {
        let _ = if genre % 2 == 0 { attaquer::<f32>(reste) } else { attaquer::<f64>(reste) };
    }
});
