//! Every way to an answer, with every instruction set of the machine: the list in a batch, the hierarchy ray by
//! ray and in a batch, before a limit and in order, shadows of both; each beside the list ray by ray.

use std::sync::atomic::{AtomicU32, Ordering};

use lancer_rayon::pour_les_tests::Reglage;
use lancer_rayon::{
    Hierarchie, Intersection, NoIntersection, ObjetRay, Rayon, Reel, SphereGeo, Texture, Touche,
    Vecteur, est_occulte, premiere_intersection,
};

use crate::conversion::{Bits, Mots, mots};

/// The fewest objects that get a tree; `les_places_pretees` holds it.
pub const UN_ARBRE: usize = 10;

/// So many that a node has sixteen children, of which the beam of 64 rays may cross too many, and that no block
/// asks all of them.
const BEAUCOUP: usize = 240;

/// The number so many units in the last place away.
pub fn voisin<R: Bits>(x: R, de: i64) -> R {
    let unite = if size_of::<R>() == 4 { 32 } else { 0 };
    R::depuis_bits((x.bits() << unite).wrapping_add_signed(de << unite))
}

/// A hit that no ray has, so that a place which a batch leaves out shows.
fn absurde<R: Bits>() -> Touche<R> {
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
    obtenues: &[Touche<R>],
    attendues: &[Touche<R>],
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
    let mut memoires = [1, 6].map(|fois| vec![f32::NAN; fois * Hierarchie::places(n)]);
    let [hierarchie, en_morceaux] =
        memoires.each_mut().map(|places| Hierarchie::new(objets, places).unwrap());
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
pub fn comparer_dans<R: Bits>(hierarchie: &Hierarchie<'_, R>, rayons: &[Rayon<R>]) -> usize {
    let facons = [*hierarchie, Hierarchie::de_liste(hierarchie.objets())];
    let attendues = comparer_les_facons(rayons, facons, |_| true);
    // Another one each time, and now and then one that is not there.
    let sauf = rayons.len() % (hierarchie.objets().len() + 1);
    let sauf = attendues.iter().flatten().nth(sauf).map_or(sauf, |touche| touche.objet());
    // And no more than some of these, by no rule that a walk could follow.
    let plupart = |indice: usize| indice.wrapping_mul(0x9e37_79b9) >> 7 & 7 > 1;
    // By turns one alone is left out.
    let seul = sauf % 2 == 0;
    let les_deux = |indice| indice != sauf && (seul || plupart(indice));
    let sauf_lui = facons.each_ref().map(|facon| facon.sans(sauf));
    let plupart = sauf_lui.each_ref().map(|facon| facon.parmi(&plupart));
    comparer_les_facons(rayons, if seul { sauf_lui } else { plupart }, les_deux);
    attendues.iter().flatten().count()
}

/// How often this question asks for each object of this hierarchy. No answer shows it; a choice is told.
pub fn demandes<R: Reel>(
    hierarchie: &Hierarchie<'_, R>,
    question: impl FnOnce(Hierarchie<'_, R>),
) -> Vec<u32> {
    let demandes: Vec<_> = hierarchie.objets().iter().map(|_| AtomicU32::new(0)).collect();
    let compter = |indice: usize| demandes[indice].fetch_add(1, Ordering::Relaxed) < u32::MAX;
    question(hierarchie.parmi(&compter));
    demandes.into_iter().map(AtomicU32::into_inner).collect()
}

/// How many nodes the tree of this hierarchy has, as it says itself; 0 if it has none and asks its list.
pub fn noeuds<R: Reel>(hierarchie: &Hierarchie<'_, R>) -> usize {
    let texte = format!("{hierarchie:?}");
    let (_, nombre) = texte.split_once("noeuds: ").expect("the number of nodes");
    nombre.trim_end_matches(" }").parse().unwrap()
}

/// The answers of a hierarchy and of one without a tree, in a batch and ray by ray, and of shadows, beside those of the
/// list of the objects that both are to choose, which it returns.
#[track_caller]
fn comparer_les_facons<R: Bits>(
    rayons: &[Rayon<R>],
    facons: [Hierarchie<'_, R>; 2],
    prend: impl Fn(usize) -> bool,
) -> Vec<Touche<R>> {
    let objets = facons[0].objets();
    let pris: Vec<_> = (0..objets.len()).filter(|indice| prend(*indice)).collect();
    let restants: Vec<_> = pris.iter().map(|indice| objets[*indice]).collect();
    let attendues: Vec<_> = rayons.iter().map(|r| premiere_intersection(&restants, r)).collect();
    let entiere = restants.len() == objets.len();
    // That takes long: of a few rays.
    let quelques = (0..rayons.len()).step_by(1 + rayons.len() / 4);
    let ordres: Vec<_> = quelques.map(|i| (toutes(&rayons[i], &restants, &pris), i)).collect();
    for (nom, reglage) in Reglage::tous() {
        let [hierarchie, liste] = facons.map(|facon| reglage.hierarchie(facon));
        let exiger = |facon: &str, touches: &[Touche<R>]| {
            exiger(&format!("{nom}, {facon}"), rayons, touches, &attendues, &pris);
        };
        let demander = |facon, hierarchie: Hierarchie<'_, R>| {
            let seule = |rayon| hierarchie.premiere_intersection(rayon);
            exiger(facon, &rayons.iter().map(seule).collect::<Vec<_>>());
            for (toutes, i) in &ordres {
                comparer_l_ordre(facon, &rayons[*i], hierarchie, toutes, *i);
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
fn comparer_l_ordre<R: Bits>(
    facon: &str,
    rayon: &Rayon<R>,
    hierarchie: Hierarchie<'_, R>,
    toutes: &[(Intersection<R>, Mots)],
    i: usize,
) {
    let une = toutes.get(i % (toutes.len() + 1)).map_or(R::INFINI, |(touche, _)| touche.distance());
    let limites = [une, R::INFINI, voisin(une, 1), -R::UN, R::depuis_f64(f64::NAN)];
    let places = [toutes.len() + 1, 1 + i % 4, i % 2];
    for (limite, places) in
        [(R::INFINI, places[0]), (limites[i % 5], places[i % 3]), (voisin(une, 1), places[1])]
    {
        let avant = toutes.iter().filter(|(touche, _)| touche.distance() < limite);
        let voulues: Vec<_> = avant.map(|(_, mots)| *mots).collect();
        let premiere = voulues.first().copied().unwrap_or_else(|| mots::<R>(&Err(NoIntersection)));
        let trouvee = hierarchie.premiere_avant(rayon, limite);
        assert_eq!(mots(&trouvee), premiere, "{facon}, before {limite:?}: {rayon:?}");
        let mut touches = vec![absurde(); places];
        let nombre = hierarchie.dans_l_ordre(rayon, limite, &mut touches);
        let obtenues: Vec<_> = touches[..nombre].iter().map(mots).collect();
        let voulues = &voulues[..voulues.len().min(places)];
        assert_eq!(obtenues, voulues, "{facon}, {places} places before {limite:?}: {rayon:?}");
        assert!(touches[nombre..].iter().all(Result::is_err), "{facon}: {touches:?}");
    }
}

/// The same of shadow rays whose lamps are at their first hits, beside them and farther, of some that no segment
/// reaches, and of a sun. A ray that hits nothing has the lamp of the ray before it.
#[track_caller]
fn comparer_les_ombres<R: Bits>(
    rayons: &[Rayon<R>],
    touches: &[Touche<R>],
    restants: &[ObjetRay<R>],
    facons: [Hierarchie<'_, R>; 2],
    entiere: bool,
) {
    let etranges = [R::INFINI, R::depuis_f64(f64::NAN), R::ZERO, -R::UN, R::MIN_POSITIF];
    // What is left out changes nothing of what limits are.
    for paquet in if entiere { 0..6 } else { 1..2 } {
        let mut lampe = R::UN;
        let limite = |(i, touche): (usize, &Touche<R>)| {
            lampe = touche.map_or(lampe, |touche| touche.distance());
            match paquet {
                0 => lampe,
                1 => voisin(lampe, 1),
                2 => lampe * R::depuis_f64(1.0 + (i % 9) as f64),
                3 if i % 50 == 0 => etranges[i / 50 % etranges.len()],
                3 => voisin(lampe, 1),
                4 => voisin(lampe, i as i64 % 5 - 2),
                _ => R::INFINI,
            }
        };
        let limites = touches.iter().enumerate().map(limite);
        let ombres: Vec<_> = rayons.iter().copied().zip(limites).collect();
        let cachee = |(touche, (_, max)): (&Touche<R>, &(Rayon<R>, R))| {
            touche.is_ok_and(|touche| touche.distance() < *max)
        };
        let voulues: Vec<_> = touches.iter().zip(&ombres).map(cachee).collect();
        // Ray by ray where limits are hard: that takes longest.
        let seules = !entiere || paquet == 3 || paquet == 4;
        let une_par_une = if seules { &ombres[..] } else { &[] };
        for ((rayon, max), voulue) in une_par_une.iter().zip(&voulues) {
            assert_eq!(est_occulte(restants, rayon, *max), *voulue, "{rayon:?} before {max:?}");
        }
        // The contrary, so that a place which is left out shows.
        let contraires: Vec<_> = voulues.iter().map(|occulte| !occulte).collect();
        // Other instructions each time.
        let jeux: Vec<_> = Reglage::tous().collect();
        let (nom, reglage) = jeux[(lampe.bits() as usize).wrapping_add(paquet) % jeux.len()];
        let [hierarchie, liste] = facons.map(|facon| reglage.hierarchie(facon));
        let (mut de_la_liste, mut de_l_arbre) = (contraires.clone(), contraires.clone());
        liste.sont_occultes(&ombres, &mut de_la_liste).unwrap();
        hierarchie.sont_occultes(&ombres, &mut de_l_arbre).unwrap();
        let n = restants.len();
        let exiger = |facon: &str, ombre: &(Rayon<R>, R), occulte: bool, voulue: bool| {
            let scalaire = std::any::type_name::<R>();
            assert_eq!(occulte, voulue, "{facon}, {nom}, {scalaire}, {n} objects: {ombre:?}");
        };
        let en_lot = de_la_liste.into_iter().zip(de_l_arbre);
        for ((ombre, voulue), (liste, arbre)) in ombres.iter().zip(&voulues).zip(en_lot) {
            exiger("shadows", ombre, liste, *voulue);
            exiger("shadows of a hierarchy", ombre, arbre, *voulue);
        }
        for (ombre, voulue) in une_par_une.iter().zip(&voulues) {
            let occulte = hierarchie.est_occulte(&ombre.0, ombre.1);
            exiger("a shadow of a hierarchy", ombre, occulte, *voulue);
            exiger("a shadow", ombre, liste.est_occulte(&ombre.0, ombre.1), *voulue);
        }
    }
}
