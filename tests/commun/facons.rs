//! Every way to an answer, with every instruction set of the machine: the list in a batch, the tree ray by
//! ray and in a batch, before an end, in order and by a visit, shadows of both; each beside the list ray by ray. And who
//! holds the sources and the points of hits.

use std::ops::ControlFlow::{self, Break, Continue};
use std::sync::atomic::{AtomicU32, Ordering};

use lancer_rayon::pour_les_tests::Reglage;
use lancer_rayon::{
    Choix, Intersection, Monde, NoIntersection, ObjetRay, Parmi, Rayon, Reel, Reponse, SphereGeo,
    Texture, Tous, Vecteur, places, premiere_intersection,
};

use crate::conversion::{Bits, Mots, mots};

/// The fewest objects that get a tree; `places_dit_combien_de_places_suffisent` holds it.
pub const UN_ARBRE: usize = 10;

/// So many that a node has sixteen children, of which the beam of 64 rays may cross too many, and that no block
/// asks all of them.
const BEAUCOUP: usize = 240;

/// The number so many units in the last place away.
pub fn voisin<R: Bits>(x: R, de: i64) -> R {
    let unite = if size_of::<R>() == 4 { 32 } else { 0 };
    R::depuis_bits((x.bits() << unite).wrapping_add_signed(de << unite))
}

/// The same of an end, if that is one.
fn fin_voisine<R: Bits>(fin: R, de: i64) -> R {
    Some(voisin(fin, de)).filter(|autre| *autre >= R::ZERO).unwrap_or(fin)
}

/// A hit that no ray has, so that a place which a batch leaves out shows.
fn absurde<R: Bits>() -> Reponse<R> {
    let z = Vecteur::new(R::ZERO, R::ZERO, R::UN);
    let boule: ObjetRay<R> = SphereGeo::new(Vecteur::NUL, R::UN, Texture(u32::MAX)).unwrap().into();
    boule.intersection(&Rayon::new(z * R::LIMITE, -z).unwrap())
}

/// These rays have these answers, to the bit, of a list of the objects at the indices `pris`; the first that differs
/// is named.
#[track_caller]
pub fn exiger<R: Bits>(
    facon: &str,
    rayons: &[Rayon<R>],
    obtenues: &[Reponse<R>],
    attendues: &[Reponse<R>],
    pris: &[usize],
) {
    for ((rayon, obtenue), attendue) in rayons.iter().zip(obtenues).zip(attendues) {
        let mut voulus = mots(attendue);
        voulus.objet = voulus.objet.map(|i| pris[i]);
        assert_eq!(
            mots(obtenue),
            voulus,
            "{facon}, {}, {} objects: {rayon:?} has {obtenue:?}, alone {attendue:?}",
            std::any::type_name::<R>(),
            pris.len()
        );
    }
}

/// Asks these rays every question in every way, of all objects and of a choice of them; how many touch
/// something. A list so short that no beam of 64 rays would give up is asked again, repeated until it is longer.
#[track_caller]
pub fn comparer<R: Bits>(objets: &[ObjetRay<R>], rayons: &[Rayon<R>]) -> usize {
    let n = objets.len();
    // What the memory held before must not show through. In the larger one long boxes are cut into pieces.
    let [mut memoire, mut grande] = [1, 6].map(|fois| vec![f32::NAN; fois * places(n)]);
    let hierarchie = Monde::new(objets, &mut memoire).unwrap();
    let en_morceaux = Monde::en_morceaux(objets, &mut grande).unwrap();
    let touches = comparer_dans(&hierarchie, rayons);
    // Else it is the same tree.
    if noeuds(&en_morceaux) > noeuds(&hierarchie) {
        comparer_dans(&en_morceaux, rayons);
    }
    if (UN_ARBRE..BEAUCOUP).contains(&n) {
        comparer(&objets.repeat(BEAUCOUP.div_ceil(n)), rayons);
    }
    touches
}

/// The same of this very hierarchy.
#[track_caller]
pub fn comparer_dans<R: Bits>(hierarchie: &Monde<'_, R>, rayons: &[Rayon<R>]) -> usize {
    let facons = [*hierarchie, Monde::de_liste(hierarchie.objets())];
    let attendues = comparer_les_facons(rayons, facons, |_| true);
    // Another one each time, and now and then one that is not there.
    let sauf = rayons.len() % (hierarchie.objets().len() + 1);
    let sauf = attendues.iter().flatten().nth(sauf).map_or(sauf, |touche| touche.indice());
    // And no more than some of these, by no rule that a walk could follow.
    let plupart = |indice: usize| indice.wrapping_mul(0x9e37_79b9) >> 7 & 7 > 1;
    // By turns one alone is left out.
    let seul = sauf % 2 == 0;
    let les_deux = |indice| indice != sauf && (seul || plupart(indice));
    let sauf_lui = facons.map(|facon| facon.sans(sauf));
    if seul {
        comparer_les_facons(rayons, sauf_lui, les_deux);
    } else {
        comparer_les_facons(rayons, sauf_lui.map(|facon| facon.parmi(&plupart)), les_deux);
    }
    attendues.iter().flatten().count()
}

/// A choice that counts what it is asked.
pub type Compteur<'a> = Parmi<Tous, &'a (dyn Fn(usize) -> bool + Sync)>;

/// How often this question asks for each object. No answer shows it; a choice is told.
pub fn demandes<R: Reel>(
    hierarchie: &Monde<'_, R>,
    question: impl FnOnce(Monde<'_, R, Compteur<'_>>),
) -> Vec<u32> {
    let demandes: Vec<_> = hierarchie.objets().iter().map(|_| AtomicU32::new(0)).collect();
    let compter = |indice: usize| demandes[indice].fetch_add(1, Ordering::Relaxed) < u32::MAX;
    question(hierarchie.parmi(&compter as &(dyn Fn(usize) -> bool + Sync)));
    demandes.into_iter().map(AtomicU32::into_inner).collect()
}

/// How many nodes the tree of this hierarchy has, as it says itself; 0 if it has none and asks its list.
pub fn noeuds<R: Reel>(hierarchie: &Monde<'_, R>) -> usize {
    let texte = format!("{hierarchie:?}");
    let (_, nombre) = texte.split_once("noeuds: ").expect("the number of nodes");
    nombre.trim_end_matches(", .. }").parse().unwrap()
}

/// The answers of a hierarchy and of one without a tree, in a batch and ray by ray, and of shadows, beside those of the
/// list of the objects that both are to choose, which it returns.
#[track_caller]
fn comparer_les_facons<R: Bits, C: Choix + Copy>(
    rayons: &[Rayon<R>],
    facons: [Monde<'_, R, C>; 2],
    prend: impl Fn(usize) -> bool,
) -> Vec<Reponse<R>> {
    let objets = facons[0].objets();
    let pris: Vec<_> = (0..objets.len()).filter(|indice| prend(*indice)).collect();
    let restants: Vec<_> = pris.iter().map(|indice| objets[*indice]).collect();
    let attendues: Vec<_> = rayons.iter().map(|r| premiere_intersection(&restants, r)).collect();
    let entiere = restants.len() == objets.len();
    // That takes long: of a few rays.
    let quelques = (0..rayons.len()).step_by(1 + rayons.len() / 4);
    let ordres: Vec<_> = quelques.map(|i| (toutes(&rayons[i], &restants, &pris), i)).collect();
    for (nom, reglage) in Reglage::tous() {
        let [hierarchie, liste] = facons.map(|facon| reglage.monde(facon));
        let exiger = |facon: &str, touches: &[Reponse<R>]| {
            exiger(&format!("{nom}, {facon}"), rayons, touches, &attendues, &pris);
        };
        let demander = |facon, hierarchie: Monde<'_, R, C>| {
            let seule = |rayon| hierarchie.premiere_intersection(rayon);
            exiger(facon, &rayons.iter().map(seule).collect::<Vec<_>>());
            for (toutes, i) in &ordres {
                comparer_l_ordre(facon, &rayons[*i], hierarchie, toutes, *i);
                comparer_la_visite(facon, &rayons[*i], hierarchie, toutes);
                comparer_les_contenants(facon, &rayons[*i], hierarchie, &attendues[*i], &prend);
            }
        };
        let mut touches = vec![absurde(); rayons.len()];
        liste.premieres_intersections(rayons, &mut touches).unwrap();
        exiger("batch", &touches);
        touches.fill(absurde());
        hierarchie.premieres_intersections(rayons, &mut touches).unwrap();
        exiger("hierarchy, batch", &touches);
        demander("hierarchy", hierarchie);
        demander("list", liste);
    }
    comparer_les_ombres(rayons, &attendues, &restants, facons, entiere);
    attendues
}

/// All hits of these objects, each asked alone, in order.
fn toutes<R: Bits>(
    rayon: &Rayon<R>,
    objets: &[ObjetRay<R>],
    indices: &[usize],
) -> Vec<(Intersection<R>, Mots)> {
    let touche = |(objet, indice): (&ObjetRay<R>, &usize)| {
        let touche = objet.intersection(rayon).ok()?;
        Some((touche, Mots { objet: Some(*indice), ..mots(&Ok(touche)) }))
    };
    let mut toutes: Vec<_> = objets.iter().zip(indices).filter_map(touche).collect();
    // Stable: of equal distances the earlier in the list.
    toutes.sort_by(|(a, _), (b, _)| a.distance().partial_cmp(&b.distance()).unwrap());
    toutes
}

/// The first objects before limits that matter, as many as fit in some places, beside all of them.
#[track_caller]
fn comparer_l_ordre<R: Bits, C: Choix>(
    facon: &str,
    rayon: &Rayon<R>,
    hierarchie: Monde<'_, R, C>,
    toutes: &[(Intersection<R>, Mots)],
    i: usize,
) {
    let une = toutes.get(i % (toutes.len() + 1)).map_or(R::INFINI, |(touche, _)| touche.distance());
    let limites = [une, R::INFINI, fin_voisine(une, 1), R::ZERO, R::MIN_POSITIF];
    let places = [toutes.len() + 1, 1 + i % 4, i % 2];
    for (limite, places) in
        [(R::INFINI, places[0]), (limites[i % 5], places[i % 3]), (fin_voisine(une, 1), places[1])]
    {
        let avant = toutes.iter().filter(|(touche, _)| touche.distance() < limite);
        let voulues: Vec<_> = avant.map(|(_, mots)| *mots).collect();
        let premiere = voulues.first().copied().unwrap_or_else(|| mots::<R>(&Err(NoIntersection)));
        let rayon = rayon.jusqu_a(limite).unwrap();
        let trouvee = hierarchie.premiere_intersection(&rayon);
        assert_eq!(mots(&trouvee), premiere, "{facon}, before {limite:?}: {rayon:?}");
        let mut touches = vec![absurde(); places];
        let nombre = hierarchie.dans_l_ordre(&rayon, &mut touches);
        let obtenues: Vec<_> = touches[..nombre].iter().map(mots).collect();
        let voulues = &voulues[..voulues.len().min(places)];
        assert_eq!(obtenues, voulues, "{facon}, {places} places before {limite:?}: {rayon:?}");
        assert!(touches[nombre..].iter().all(Result::is_err), "{facon}: {touches:?}");
    }
}

/// A visit shows each of these objects once; and it ends where it is told to.
#[track_caller]
fn comparer_la_visite<R: Bits, C: Choix>(
    facon: &str,
    rayon: &Rayon<R>,
    monde: Monde<'_, R, C>,
    toutes: &[(Intersection<R>, Mots)],
) {
    let visiter = |voir: &mut dyn FnMut(usize, R) -> ControlFlow<(), R>| {
        let mut vus = vec![];
        monde.visiter(rayon, |indice, t| {
            vus.push((indice, t.bits()));
            voir(indice, t)
        });
        vus.sort_unstable();
        vus
    };
    let mut voulus: Vec<_> =
        toutes.iter().map(|(t, mots)| (mots.objet.unwrap(), t.distance().bits())).collect();
    voulus.sort_unstable();
    assert_eq!(visiter(&mut |_, _| Continue(rayon.fin())), voulus, "{facon}: {rayon:?}");
    let mut premiere = R::INFINI;
    visiter(&mut |_, t| {
        assert!(t < premiere, "{facon}: {rayon:?}, {t} after {premiere}");
        premiere = t;
        Continue(t)
    });
    let voulue = toutes.first().map_or(R::INFINI, |(touche, _)| touche.distance());
    assert_eq!(premiere.bits(), voulue.bits(), "{facon}: {rayon:?}");
    for fini in [Break(()), Continue(R::ZERO), Continue(-R::UN)] {
        assert!(visiter(&mut |_, _| fini).len() <= 1, "{facon}: {rayon:?}");
    }
    // A NaN is no end.
    assert_eq!(
        visiter(&mut |_, _| Continue(R::depuis_f64(f64::NAN))),
        voulus,
        "{facon}: {rayon:?}"
    );
}

/// Who holds the source of this ray and the point of its first hit: those that say so themselves, each once.
#[track_caller]
fn comparer_les_contenants<R: Bits, C: Choix>(
    facon: &str,
    rayon: &Rayon<R>,
    monde: Monde<'_, R, C>,
    touche: &Reponse<R>,
    prend: &impl Fn(usize) -> bool,
) {
    for point in [Some(rayon.source()), touche.ok().map(|touche| touche.point())] {
        let Some(point) = point else { continue };
        let tient =
            |(indice, objet): &(usize, &ObjetRay<R>)| prend(*indice) && objet.contient(point);
        let voulus = monde.objets().iter().enumerate().filter(tient);
        let voulus: Vec<_> = voulus.map(|(indice, _)| indice).collect();
        let mut vus = vec![];
        monde.contenants(point, |indice| vus.push(indice));
        vus.sort_unstable();
        assert_eq!(vus, voulus, "{facon}: {point:?}");
        assert_eq!(monde.contient(point), !voulus.is_empty(), "{facon}: {point:?}");
    }
}

/// The same of shadow rays whose lamps are at their first hits, beside them and farther, of some that no segment
/// reaches, and of a sun. A ray that hits nothing has the lamp of the ray before it.
#[track_caller]
fn comparer_les_ombres<R: Bits, C: Choix + Copy>(
    rayons: &[Rayon<R>],
    touches: &[Reponse<R>],
    restants: &[ObjetRay<R>],
    facons: [Monde<'_, R, C>; 2],
    entiere: bool,
) {
    let etranges = [R::INFINI, R::ZERO, -R::ZERO, R::MIN_POSITIF];
    // What is left out changes nothing of what limits are.
    for paquet in if entiere { 0..6 } else { 1..2 } {
        let mut lampe = R::UN;
        let limite = |(i, touche): (usize, &Reponse<R>)| {
            lampe = touche.map_or(lampe, |touche| touche.distance());
            match paquet {
                0 => lampe,
                1 => fin_voisine(lampe, 1),
                2 => lampe * R::depuis_f64(1.0 + (i % 9) as f64),
                3 if i % 50 == 0 => etranges[i / 50 % etranges.len()],
                3 => fin_voisine(lampe, 1),
                4 => fin_voisine(lampe, i as i64 % 5 - 2),
                _ => R::INFINI,
            }
        };
        let limites = touches.iter().enumerate().map(limite);
        let ombres: Vec<_> =
            rayons.iter().zip(limites).map(|(rayon, fin)| rayon.jusqu_a(fin).unwrap()).collect();
        let cachee = |(touche, ombre): (&Reponse<R>, &Rayon<R>)| {
            touche.is_ok_and(|touche| touche.distance() < ombre.fin())
        };
        let voulues: Vec<_> = touches.iter().zip(&ombres).map(cachee).collect();
        // Ray by ray where limits are hard: that takes longest.
        let seules = !entiere || paquet == 3 || paquet == 4;
        let une_par_une = if seules { &ombres[..] } else { &[] };
        let la_liste = Monde::de_liste(restants);
        for (ombre, voulue) in une_par_une.iter().zip(&voulues) {
            assert_eq!(la_liste.est_occulte(ombre), *voulue, "{ombre:?}");
        }
        // The contrary, so that a place which is left out shows.
        let contraires: Vec<_> = voulues.iter().map(|occulte| !occulte).collect();
        // Other instructions each time.
        let jeux: Vec<_> = Reglage::tous().collect();
        let (nom, reglage) = jeux[(lampe.bits() as usize).wrapping_add(paquet) % jeux.len()];
        let [hierarchie, liste] = facons.map(|facon| reglage.monde(facon));
        let (mut de_la_liste, mut de_l_arbre) = (contraires.clone(), contraires.clone());
        liste.sont_occultes(&ombres, &mut de_la_liste).unwrap();
        hierarchie.sont_occultes(&ombres, &mut de_l_arbre).unwrap();
        let n = restants.len();
        let exiger = |facon: &str, ombre: &Rayon<R>, occulte: bool, voulue: bool| {
            let scalaire = std::any::type_name::<R>();
            assert_eq!(occulte, voulue, "{facon}, {nom}, {scalaire}, {n} objects: {ombre:?}");
        };
        let en_lot = de_la_liste.into_iter().zip(de_l_arbre);
        for ((ombre, voulue), (liste, arbre)) in ombres.iter().zip(&voulues).zip(en_lot) {
            exiger("shadows", ombre, liste, *voulue);
            exiger("shadows of a hierarchy", ombre, arbre, *voulue);
        }
        for (ombre, voulue) in une_par_une.iter().zip(&voulues) {
            exiger("a shadow of a hierarchy", ombre, hierarchie.est_occulte(ombre), *voulue);
            exiger("a shadow", ombre, liste.est_occulte(ombre), *voulue);
        }
        // The first hits of the same rays: each has one before its end, or none.
        for monde in [hierarchie, liste] {
            let mut avant = vec![absurde(); ombres.len()];
            monde.premieres_intersections(&ombres, &mut avant).unwrap();
            for (((touche, avant), voulue), ombre) in
                touches.iter().zip(&avant).zip(&voulues).zip(&ombres)
            {
                let attendue = mots(&if *voulue { *touche } else { Err(NoIntersection) });
                assert_eq!(mots(avant).valeurs, attendue.valeurs, "{nom}: {ombre:?}");
            }
        }
    }
}
