//! Every way to an answer, with every instruction set of the machine: the list in a batch, the tree ray by
//! ray and in a batch, before an end, in order and by a visit, shadows of both; each beside the list ray by ray. And who
//! holds the sources and the points of hits.

use std::sync::atomic::{AtomicU32, Ordering};

use lancer_rayon::pour_les_tests::Reglage;
use lancer_rayon::{
    Choix, Monde, NoIntersection, ObjetRay, Parmi, Rayon, Reel, Reponse, SphereGeo, Texture, Tous,
    Vecteur, places, premiere_intersection,
};

use crate::choisis::Choisis;
use crate::conversion::{Bits, mots, voisin};

/// The fewest objects that get a tree; `places_dit_combien_de_places_suffisent` holds it.
pub const UN_ARBRE: usize = 10;

/// So many that a node has sixteen children, of which the probe of 64 rays may enter too many, and that no block
/// asks all of them.
const BEAUCOUP: usize = 240;

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
/// something. A list so short that no common walk of 64 rays would be given up is asked again, repeated until it is longer.
#[track_caller]
pub fn comparer<R: Bits>(objets: &[ObjetRay<R>], rayons: &[Rayon<R>]) -> usize {
    let n = objets.len();
    // What the memory held before must not show through. In the larger one long boxes are cut into pieces.
    let [mut memoire, mut grande] = [1, 6].map(|fois| vec![f32::NAN; fois * places(n)]);
    let monde = Monde::new(objets, &mut memoire).unwrap();
    let en_morceaux = Monde::en_morceaux(objets, &mut grande).unwrap();
    let touches = comparer_dans(&monde, rayons);
    // Else it is the same tree.
    if noeuds(&en_morceaux) > noeuds(&monde) {
        comparer_dans(&en_morceaux, rayons);
    }
    if (UN_ARBRE..BEAUCOUP).contains(&n) {
        comparer(&objets.repeat(BEAUCOUP.div_ceil(n)), rayons);
    }
    touches
}

/// The same of this very world.
#[track_caller]
pub fn comparer_dans<R: Bits>(monde: &Monde<'_, R>, rayons: &[Rayon<R>]) -> usize {
    let facons = [*monde, Monde::de_liste(monde.objets())];
    let attendues = comparer_les_facons(rayons, facons, |_| true);
    // Another one each time, and now and then one that is not there.
    let sauf = rayons.len() % (monde.objets().len() + 1);
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
    monde: &Monde<'_, R>,
    question: impl FnOnce(Monde<'_, R, Compteur<'_>>),
) -> Vec<u32> {
    let demandes: Vec<_> = monde.objets().iter().map(|_| AtomicU32::new(0)).collect();
    let compter = |indice: usize| demandes[indice].fetch_add(1, Ordering::Relaxed) < u32::MAX;
    question(monde.parmi(&compter as &(dyn Fn(usize) -> bool + Sync)));
    demandes.into_iter().map(AtomicU32::into_inner).collect()
}

/// How many nodes the tree of this world has, as it says itself; 0 if it has none and asks its list.
pub fn noeuds<R: Reel>(monde: &Monde<'_, R>) -> usize {
    let texte = format!("{monde:?}");
    let (_, nombre) = texte.split_once("noeuds: ").expect("the number of nodes");
    nombre.trim_end_matches(", .. }").parse().unwrap()
}

/// The answers of a world with a tree and of one without, in a batch and ray by ray, and of shadows, beside those of the
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
    let quelques: Vec<_> = rayons.iter().step_by(1 + rayons.len() / 4).copied().collect();
    let limites = [R::INFINI, R::ZERO, R::ETA, R::UN];
    let toutes = Choisis { monde: facons[0], pris: pris.clone() }.toutes(&quelques);
    for (nom, reglage) in Reglage::tous() {
        let [monde, liste] = facons.map(|facon| reglage.monde(facon));
        let exiger = |facon: &str, touches: &[Reponse<R>]| {
            exiger(&format!("{nom}, {facon}"), rayons, touches, &attendues, &pris);
        };
        let demander = |facon, monde: Monde<'_, R, C>| {
            let seule = |rayon| monde.premiere_intersection(rayon);
            exiger(facon, &rayons.iter().map(seule).collect::<Vec<_>>());
            let choisis = Choisis { monde, pris: pris.clone() };
            choisis.un_par_un(&quelques, &toutes, &limites, rayons.len() as u8);
        };
        let mut touches = vec![absurde(); rayons.len()];
        liste.premieres_intersections(rayons, &mut touches).unwrap();
        exiger("batch", &touches);
        touches.fill(absurde());
        monde.premieres_intersections(rayons, &mut touches).unwrap();
        exiger("tree, batch", &touches);
        demander("tree", monde);
        demander("list", liste);
    }
    comparer_les_ombres(rayons, &attendues, &restants, facons, entiere);
    attendues
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
    let etranges = [R::INFINI, R::ZERO, -R::ZERO, R::ETA];
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
        let [monde, liste] = facons.map(|facon| reglage.monde(facon));
        let (mut de_la_liste, mut de_l_arbre) = (contraires.clone(), contraires.clone());
        liste.sont_occultes(&ombres, &mut de_la_liste).unwrap();
        monde.sont_occultes(&ombres, &mut de_l_arbre).unwrap();
        let n = restants.len();
        let exiger = |facon: &str, ombre: &Rayon<R>, occulte: bool, voulue: bool| {
            let scalaire = std::any::type_name::<R>();
            assert_eq!(occulte, voulue, "{facon}, {nom}, {scalaire}, {n} objects: {ombre:?}");
        };
        let en_lot = de_la_liste.into_iter().zip(de_l_arbre);
        for ((ombre, voulue), (liste, arbre)) in ombres.iter().zip(&voulues).zip(en_lot) {
            exiger("shadows", ombre, liste, *voulue);
            exiger("shadows of a tree", ombre, arbre, *voulue);
        }
        for (ombre, voulue) in une_par_une.iter().zip(&voulues) {
            exiger("a shadow of a tree", ombre, monde.est_occulte(ombre), *voulue);
            exiger("a shadow", ombre, liste.est_occulte(ombre), *voulue);
        }
        // The first hits of the same rays: each has one before its end, or none.
        for monde in [monde, liste] {
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
