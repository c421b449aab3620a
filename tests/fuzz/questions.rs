//! Raw bytes made into objects, transformations and rays: every value is refused or valid, and every
//! answer to every ray and every point is what it must be, alone, in a batch and with a tree, of all objects and of a
//! choice of them.
//!
//! Numbers are raw bits, or one that came before or its neighbour, without which nothing would ever
//! coincide.

#![no_main]

use std::sync::atomic::{AtomicU32, Ordering};

use lancer_rayon::{
    BoiteGeo, Choix, ErreurGeo, Etendue, Intersection, Monde, NoIntersection, ObjetGeo, ObjetRay,
    PlacesInsuffisantes, PlanGeo, Rayon, Reponse, Rotation, SphereGeo, Texture, Vecteur, places,
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
        let Ok(secondaire) = touche.secondaire(vers) else { continue };
        if secondaire.direction().produit_scalaire(touche.normale()) > R::ZERO {
            assert_eq!(objet.intersection(&secondaire), Err(NoIntersection), "{objet:?} {rayon:?}");
        }
    }
    if let Ok(reflet) = touche.reflechi(rayon.direction()) {
        assert_eq!(objet.intersection(&reflet), Err(NoIntersection), "{objet:?} {rayon:?}");
    }
    let ombres = [touche.vers_soleil(vers), touche.vers_lumiere(vers)];
    for ombre in ombres.into_iter().flatten() {
        assert_eq!(objet.intersection(&ombre), Err(NoIntersection), "{objet:?} {ombre:?}");
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
        let Ok(suite) = sortie.secondaire(vers) else { continue };
        if suite.direction().produit_scalaire(n) > R::ZERO {
            let encore = [objet.intersection(&suite), objet.sortie(&suite)];
            assert_eq!(encore, [Err(NoIntersection); 2], "{} {suite:?}", contexte());
        } else if let ObjetRay::Sphere(_) = objet {
            assert_eq!(objet.intersection(&suite), Err(NoIntersection), "{} {suite:?}", contexte());
            assert!(objet.sortie(&suite).is_ok(), "{} {suite:?}", contexte());
        }
    }
}

/// A choice that is kept for all questions, and the indices of what it is to take.
struct Choisis<'a, R, C> {
    monde: Monde<'a, R, C>,
    pris: Vec<usize>,
}

/// Of these objects what two choices take, and not the one between them.
fn choisir<R: Bits>(
    monde: Monde<'_, R>,
    [un, sauf, deux]: [u8; 3],
) -> Choisis<'_, R, impl Choix + Copy> {
    let [un, deux] = [un, deux].map(|masque| move |indice: usize| masque >> (indice % 8) & 1 == 0);
    let sauf = usize::from(sauf);
    let pris = (0..monde.objets().len()).filter(|i| un(*i) && *i != sauf && deux(*i)).collect();
    Choisis { monde: monde.parmi(un).sans(sauf).parmi(deux), pris }
}

/// A hit of an object that was asked alone, with its index: its distance, and its bits.
type Vue<R> = (R, Mots);

impl<R: Bits, C: Choix + Copy> Choisis<'_, R, C> {
    /// Beside each object asked alone; as many places for what comes in order as `places` says.
    fn interroger(&self, rayons: &[Rayon<R>], limites: &[R], points: &[Vecteur<R>], places: u8) {
        let toutes: Vec<_> = rayons.iter().map(|rayon| self.toutes(rayon)).collect();
        for (rayon, toutes) in rayons.iter().zip(&toutes) {
            let une = toutes.get(usize::from(places) % (toutes.len() + 1)).map(|(t, _)| *t);
            for &limite in limites.iter().chain(&une).chain(&[R::INFINI]) {
                let fini = rayon.jusqu_a(limite);
                assert_eq!(fini.is_ok(), limite >= R::ZERO, "{limite:?}");
                let Ok(fini) = fini else { continue };
                let avant = toutes.iter().copied().filter(|(t, _)| *t < limite);
                self.un_rayon(&fini, &avant.collect::<Vec<_>>(), places);
                self.visites(&fini, toutes, limites);
            }
            self.certificat(rayon);
            self.points(rayon.source());
            for (t, _) in toutes {
                self.points(rayon.point(*t));
            }
        }
        for (i, limite) in limites.iter().enumerate() {
            self.en_lot(rayons, &toutes, &limites[i..], *limite);
        }
        points.iter().for_each(|point| self.points(*point));
    }

    /// All hits of what was chosen, each object asked alone, in order.
    fn toutes(&self, rayon: &Rayon<R>) -> Vec<Vue<R>> {
        let touche = |indice: &usize| {
            let touche = self.monde.objets()[*indice].intersection(rayon).ok()?;
            Some((touche.distance(), Mots { objet: Some(*indice), ..mots(&Ok(touche)) }))
        };
        let mut toutes: Vec<_> = self.pris.iter().filter_map(touche).collect();
        // Stable: of equal distances the earlier in the list.
        toutes.sort_by(|(a, _), (b, _)| a.partial_cmp(b).unwrap());
        toutes
    }

    /// The first hit, the shadow, and what comes in order, of a ray that enters these objects before its end.
    fn un_rayon(&self, rayon: &Rayon<R>, avant: &[Vue<R>], places: u8) {
        let contexte = || format!("{rayon:?} {:?} of {:?}", self.pris, self.monde.objets());
        let voulues: Vec<_> = avant.iter().map(|(_, mots)| *mots).collect();
        let premiere = self.monde.premiere_intersection(rayon);
        assert_eq!(mots(&premiere), premiers_mots::<R>(avant), "{}", contexte());
        assert_eq!(self.monde.est_occulte(rayon), !avant.is_empty(), "{}", contexte());
        let mut touches = vec![Err(NoIntersection); usize::from(places) % 9];
        let nombre = self.monde.dans_l_ordre(rayon, &mut touches);
        let obtenues: Vec<_> = touches[..nombre].iter().map(mots).collect();
        assert_eq!(obtenues, voulues[..voulues.len().min(touches.len())], "{}", contexte());
        assert!(touches[nombre..].iter().all(Result::is_err), "{}", contexte());
    }

    /// Visits that go on, that come nearer with every object, and that end where raw numbers say: each shows what lies
    /// before its end then, and nothing twice.
    fn visites(&self, rayon: &Rayon<R>, toutes: &[Vue<R>], fins: &[R]) {
        let contexte = || format!("{rayon:?} {:?} of {:?}", self.pris, self.monde.objets());
        let visiter = |prochaine: &mut dyn FnMut(R) -> R| {
            let (mut fin, mut vus) = (rayon.fin(), Vec::new());
            self.monde.visiter(rayon, |indice, t| {
                assert!(t < fin, "{t} is not before {fin}: {}", contexte());
                vus.push((indice, t.bits()));
                let suivante = prochaine(t);
                // A NaN leaves the end where it is.
                fin = if suivante < fin { suivante } else { fin };
                suivante
            });
            vus.sort_unstable();
            assert!(vus.windows(2).all(|w| w[0].0 != w[1].0), "twice: {}", contexte());
            (vus, fin)
        };
        let avant = |fin: R| {
            let avant = toutes.iter().filter(move |(t, _)| *t < fin);
            let mut avant: Vec<_> =
                avant.filter_map(|(t, mots)| Some((mots.objet?, t.bits()))).collect();
            avant.sort_unstable();
            avant
        };
        let toutes_avant = avant(rayon.fin());
        assert_eq!(visiter(&mut |_| R::INFINI).0, toutes_avant, "{}", contexte());
        let premiere = toutes.first().map_or(R::INFINI, |(t, _)| *t);
        let fin = if premiere < rayon.fin() { premiere } else { rayon.fin() };
        assert_eq!(visiter(&mut |t| t).1.bits(), fin.bits(), "{}", contexte());
        assert!(visiter(&mut |_| R::ZERO).0.len() <= 1, "{}", contexte());
        let mut suivantes = fins.iter().copied().cycle();
        let (vus, fin) = visiter(&mut |_| suivantes.next().unwrap_or(R::INFINI));
        // All that lies before the last end was shown, and none that no object alone knows.
        assert!(avant(fin).iter().all(|vu| vus.contains(vu)), "{}", contexte());
        assert!(vus.iter().all(|vu| toutes_avant.contains(vu)), "{}", contexte());
    }

    /// First hits and shadows of all rays at once, each with an end of its own: by turns one of these, its nth hit, the
    /// number beside it, and none.
    fn en_lot(&self, rayons: &[Rayon<R>], toutes: &[Vec<Vue<R>>], limites: &[R], sinon: R) {
        let finir = |(i, (rayon, toutes)): (usize, (&Rayon<R>, &Vec<Vue<R>>))| {
            let t = toutes.get(i % (toutes.len() + 1)).map_or(sinon, |(t, _)| *t);
            let fin = match i % 4 {
                0 => limites[i / 4 % limites.len()],
                1 => t,
                2 => t * (R::UN + R::U + R::U),
                _ => R::INFINI,
            };
            rayon.jusqu_a(fin).unwrap_or(*rayon)
        };
        let finis: Vec<_> = rayons.iter().zip(toutes).enumerate().map(finir).collect();
        let mut touches: Vec<Reponse<R>> = vec![Err(NoIntersection); finis.len()];
        let mut occultes = vec![true; finis.len()];
        self.monde.premieres_intersections(&finis, &mut touches).unwrap();
        self.monde.sont_occultes(&finis, &mut occultes).unwrap();
        let obtenues = touches.iter().zip(occultes);
        for ((rayon, toutes), (touche, occulte)) in finis.iter().zip(toutes).zip(obtenues) {
            let contexte = || format!("{rayon:?} {:?} of {:?}", self.pris, self.monde.objets());
            let avant = &toutes[..toutes.partition_point(|(t, _)| *t < rayon.fin())];
            assert_eq!(mots(touche), premiers_mots::<R>(avant), "{}", contexte());
            assert_eq!(occulte, !avant.is_empty(), "{}", contexte());
        }
    }

    /// What the choice leaves out is no answer of which to be certain; and what a list of what it takes is certain of is
    /// certain.
    fn certificat(&self, rayon: &Rayon<R>) {
        let objets = self.monde.objets();
        let toute = Monde::de_liste(objets).premiere_intersection(rayon);
        if toute.is_ok_and(|touche| !self.pris.contains(&touche.indice())) {
            assert!(!self.monde.certifie(rayon, &toute), "{rayon:?} {objets:?}");
        }
        let restants: Vec<_> = self.pris.iter().map(|indice| objets[*indice]).collect();
        let restants = Monde::de_liste(&restants);
        if restants.certifie(rayon, &restants.premiere_intersection(rayon)) {
            let choisie = self.monde.premiere_intersection(rayon);
            assert!(self.monde.certifie(rayon, &choisie), "{rayon:?} {objets:?}");
        }
    }

    /// Who holds this point: those that say so themselves, each once.
    fn points(&self, point: Vecteur<R>) {
        let objets = self.monde.objets();
        let voulus = self.pris.iter().copied().filter(|indice| objets[*indice].contient(point));
        let voulus: Vec<_> = voulus.collect();
        let mut vus = Vec::new();
        self.monde.contenants(point, |indice| vus.push(indice));
        vus.sort_unstable();
        assert_eq!(vus, voulus, "{point:?} {:?} of {objets:?}", self.pris);
        assert_eq!(self.monde.contient(point), !voulus.is_empty(), "{point:?} {objets:?}");
    }
}

/// The first of these hits, or a miss.
fn premiers_mots<R: Bits>(toutes: &[Vue<R>]) -> Mots {
    toutes.first().map_or_else(|| mots::<R>(&Err(NoIntersection)), |(_, mots)| *mots)
}

/// A choice that answers otherwise each time: every answer is still a hit of some object, in order.
fn un_choix_inconstant<R: Bits>(monde: Monde<'_, R>, rayons: &[Rayon<R>], graine: u8) {
    let etat = AtomicU32::new(graine.into());
    let parmi = monde.parmi(|_| {
        let suivant = etat.load(Ordering::Relaxed).wrapping_mul(747_796_405).wrapping_add(1);
        etat.store(suivant, Ordering::Relaxed);
        suivant >> 31 == 0
    });
    let mut lot = vec![Err(NoIntersection); rayons.len()];
    parmi.premieres_intersections(rayons, &mut lot).unwrap();
    for (rayon, touche) in rayons.iter().zip(lot) {
        let mut touches = [Err(NoIntersection); 4];
        let nombre = parmi.dans_l_ordre(rayon, &mut touches);
        let places: Vec<_> =
            touches[..nombre].iter().flatten().map(|t| (t.distance(), t.indice())).collect();
        assert!(places.len() == nombre && places.windows(2).all(|w| w[0] < w[1]));
        let mut vus = Vec::new();
        parmi.visiter(rayon, |indice, _| {
            vus.push(indice);
            R::INFINI
        });
        parmi.contenants(rayon.source(), |indice| {
            assert!(monde.objets()[indice].contient(rayon.source()), "{rayon:?}");
        });
        assert!(vus.iter().all(|indice| monde.objets()[*indice].intersection(rayon).is_ok()));
        let une = parmi.premiere_intersection(rayon);
        let _ = (parmi.certifie(rayon, &une), parmi.est_occulte(rayon));
        for touche in touches.iter().chain(&[touche, une]).flatten() {
            let seule = monde.objets()[touche.indice()].intersection(rayon);
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
        && let Ok(vers) = touche.vers_touche(&cible)
    {
        assert_eq!(objet.intersection(&vers), Err(NoIntersection), "{objet:?} {vers:?}");
        // The other way the same line, exactly.
        let retour = cible.vers_touche(&touche).unwrap();
        assert_eq!((retour.fin(), retour.direction()), (vers.fin(), -vers.direction()));
    }
}

/// Certain answers of two precisions name the same object, or none, of a list and of a tree.
fn certificats<R: Bits>(monde: Monde<'_, R>, en_double: Monde<'_>, rayon: &Rayon<R>) {
    let (touche, double) = (monde.premiere_intersection(rayon), rayon.vers_f64());
    let la = en_double.premiere_intersection(&double);
    let [sure, sure_par_la_liste] =
        [monde, Monde::de_liste(monde.objets())].map(|monde| monde.certifie(rayon, &touche));
    let [sure_la, sure_la_par_la_liste] =
        [en_double, Monde::de_liste(en_double.objets())].map(|monde| monde.certifie(&double, &la));
    if (sure || sure_par_la_liste) && (sure_la || sure_la_par_la_liste) {
        let [ici, la] = [touche.ok().map(|t| t.indice()), la.ok().map(|t| t.indice())];
        assert_eq!(ici, la, "{:?} {rayon:?}", monde.objets());
    }
}

/// Places that are one too few are refused.
fn trop_peu_de_places<R: Bits>(objets: &[ObjetRay<R>]) {
    let necessaires = places(objets.len());
    if let Some(places) = necessaires.checked_sub(1) {
        let mut pretees = vec![0.0; places];
        let refus = [
            Monde::new(objets, &mut pretees).err(),
            Monde::en_morceaux(objets, &mut pretees).err(),
        ];
        assert_eq!(refus, [Some(PlacesInsuffisantes { places, necessaires }); 2]);
    }
}

/// The box around a list is that around its boxes, and there is none where no object has one.
fn etendues<R: Bits>(objets: &[ObjetRay<R>]) {
    let etendue = Monde::de_liste(objets).etendue();
    let celles = objets.iter().filter_map(ObjetRay::etendue);
    assert_eq!(etendue.is_some(), celles.clone().next().is_some(), "{objets:?}");
    let Some(Etendue { bas, haut }) = etendue else { return };
    let dedans = |a: Vecteur<R>, b: Vecteur<R>| a.x <= b.x && a.y <= b.y && a.z <= b.z;
    for celle in celles {
        let dans = dedans(bas, celle.bas) && dedans(celle.haut, haut);
        assert!(dans && dedans(celle.bas, celle.haut), "{objets:?}");
    }
}

fn attaquer<R: Bits>(octets: &[u8]) -> Option<()> {
    // Two choices and what is left out between them, how many places for an order, and how many more for a tree.
    let (&[un, sauf, deux, rangs, plus], octets) = octets.split_first_chunk()?;
    let mut octets = Octets { reste: octets, vus: vec![R::LIMITE, R::UN / R::LIMITE] };
    let (mut objets, mut rayons) = (Vec::<ObjetGeo<R>>::new(), Vec::<Rayon<R>>::new());
    let (mut limites, mut points) = (Vec::<R>::new(), Vec::<Vecteur<R>>::new());
    let mut lire = || {
        loop {
            match octets.octet()? % 9 {
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
                    let Ok(rayon) = Rayon::entre(de, vers) else { continue };
                    // +∞ between points that are farther apart than any number.
                    assert!(rayon.fin() > R::ZERO, "{rayon:?}");
                    limites.push(rayon.fin());
                    rayons.extend(rayon.jusqu_a(R::INFINI));
                }
                6 => {
                    // A row of them: few bytes make few objects.
                    let (n, v) = (octets.octet()?, octets.vecteur()?);
                    let Some(&modele) = objets.last() else { continue };
                    let ecart = |i| v * R::depuis_f64(f64::from(i));
                    objets.extend((1..=n).filter_map(|i| modele.translation(ecart(i)).ok()));
                }
                7 => points.push(octets.vecteur()?),
                8 => limites.push(octets.reel()?),
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
    // Each costs as much as all rays.
    limites.extend(octets.vus.iter().copied().take(2));
    limites.truncate(4);
    comparer(&objets, &rayons);
    trop_peu_de_places(&objets);
    etendues(&objets);
    let doubles: Vec<_> = objets.iter().map(|objet| objet.vers_f64()).collect();
    // In the second long boxes are cut into pieces, in the first perhaps some.
    let necessaires = places(objets.len());
    let [mut memoire, mut autre] =
        [necessaires + 28 * usize::from(plus), 6 * necessaires].map(|places| vec![0.0; places]);
    let monde = Monde::en_morceaux(&objets, &mut memoire).unwrap();
    let en_double = Monde::en_morceaux(&doubles, &mut autre).unwrap();
    for (rayon, suivant) in rayons.iter().zip(rayons.iter().cycle().skip(1)) {
        certificats(monde, en_double, rayon);
        for objet in &objets {
            secondaires(objet, rayon, suivant.direction());
            sorties(objet, rayon, suivant.direction());
            apres_coup(objet, [rayon, suivant]);
        }
    }
    for monde in [monde, Monde::de_liste(&objets)] {
        let choisis = choisir(monde, [un, sauf, deux]);
        choisis.interroger(&rayons, &limites, &points, rangs);
        let tous = Choisis { monde, pris: (0..objets.len()).collect() };
        tous.interroger(&rayons, &limites, &points, rangs);
    }
    un_choix_inconstant(monde, &rayons, rangs);
    Some(())
}

fuzz_target!(|octets: &[u8]| {
    if let Some((genre, reste)) = octets.split_first() {
        let _ = if genre % 2 == 0 { attaquer::<f32>(reste) } else { attaquer::<f64>(reste) };
    }
});
