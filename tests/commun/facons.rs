//! Every way to an answer, with every instruction set of the machine: the list in a batch, the hierarchy ray by
//! ray and in a batch, shadows of both; each beside the list ray by ray.

use lancer_rayon::pour_les_tests::{Reglage, noeuds, sans_boites};
use lancer_rayon::{
    Hierarchie, ObjetRay, Rayon, Reel, SphereGeo, Texture, Touche, Vecteur, est_certaine,
    est_occulte, premiere_intersection,
};

use crate::conversion::{Bits, mots};

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

/// These rays have these answers, to the bit, of a list from which the object at the index `sauf` was taken; the first
/// that differs is named.
#[track_caller]
pub fn exiger<R: Bits>(
    facon: &str,
    objets: &[ObjetRay<R>],
    rayons: &[Rayon<R>],
    obtenues: &[Touche<R>],
    attendues: &[Touche<R>],
    sauf: Option<usize>,
) {
    for ((rayon, obtenue), attendue) in rayons.iter().zip(obtenues).zip(attendues) {
        let mut voulus = mots(attendue);
        voulus.objet = voulus.objet.map(|i| i + usize::from(sauf.is_some_and(|sauf| i >= sauf)));
        assert_eq!(
            mots(obtenue),
            voulus,
            "{facon}, {}, {} objects: {rayon:?} has {obtenue:?}, alone {attendue:?}",
            std::any::type_name::<R>(),
            objets.len()
        );
    }
}

/// Asks these rays every question in every way, of all objects and without one that some ray may meet; how many touch
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
    let attendues = comparer_les_facons(rayons, *hierarchie, None);
    // Another one each time, and now and then one that is not there.
    let sauf = rayons.len() % (hierarchie.objets().len() + 1);
    let sauf = attendues.iter().flatten().nth(sauf).map_or(sauf, |touche| touche.objet());
    comparer_les_facons(rayons, *hierarchie, Some(sauf));
    attendues.iter().flatten().count()
}

/// Asks these rays every question in every way of a hierarchy that knows no box of these objects.
#[track_caller]
pub fn comparer_sans_boites<R: Bits>(objets: &[ObjetRay<R>], rayons: &[Rayon<R>]) {
    let mut places = vec![0.0; Hierarchie::places(objets.len())];
    let mut indices = vec![0.0; objets.len()];
    let hierarchie = Hierarchie::new(objets, &mut places).unwrap();
    let hierarchie = sans_boites(hierarchie, &mut indices);
    let attendues = comparer_les_facons(rayons, hierarchie, None);
    let sauf = attendues.iter().flatten().next().unwrap().objet();
    comparer_les_facons(rayons, hierarchie, Some(sauf));
    for (rayon, touche) in rayons.iter().zip(&attendues) {
        let certaine = est_certaine(objets, rayon, touche);
        assert_eq!(hierarchie.est_certaine(rayon, touche), certaine, "{rayon:?}: {touche:?}");
    }
}

/// This hierarchy without that object, if there is one to leave out.
fn sans<R: Reel>(hierarchie: Hierarchie<'_, R>, sauf: Option<usize>) -> Hierarchie<'_, R> {
    sauf.map_or(hierarchie, |sauf| hierarchie.sans(sauf))
}

/// The answers of this hierarchy, of its list as a batch and ray by ray, and of shadows, without the object at the
/// index `sauf`, beside those of the list from which that object was taken, which it returns.
#[track_caller]
fn comparer_les_facons<R: Bits>(
    rayons: &[Rayon<R>],
    hierarchie: Hierarchie<'_, R>,
    sauf: Option<usize>,
) -> Vec<Touche<R>> {
    let objets = hierarchie.objets();
    let mut restants = objets.to_vec();
    if let Some(sauf) = sauf.filter(|sauf| *sauf < objets.len()) {
        let _ = restants.remove(sauf);
    }
    let attendues: Vec<_> = rayons.iter().map(|r| premiere_intersection(&restants, r)).collect();
    for (nom, reglage) in Reglage::tous() {
        let nom = format!("{nom}, without {sauf:?}");
        let (hierarchie, liste) =
            (sans(reglage.hierarchie(hierarchie), sauf), sans(reglage.liste(objets), sauf));
        let exiger = |facon: &str, touches: &[Touche<R>]| {
            exiger(&format!("{nom}, {facon}"), objets, rayons, touches, &attendues, sauf);
        };
        let mut touches = vec![absurde(); rayons.len()];
        liste.premieres_intersections(rayons, &mut touches).unwrap();
        exiger("batch", &touches);
        touches.fill(absurde());
        hierarchie.premieres_intersections(rayons, &mut touches).unwrap();
        exiger("hierarchy, batch", &touches);
        for (facon, hierarchie) in [("hierarchy", hierarchie), ("list", liste)] {
            touches.clear();
            touches.extend(rayons.iter().map(|rayon| hierarchie.premiere_intersection(rayon)));
            exiger(facon, &touches);
        }
    }
    comparer_les_ombres(rayons, &attendues, &restants, sans(hierarchie, sauf), sauf);
    attendues
}

/// The same of shadow rays whose lamps are at their first hits, beside them and farther, of some that no segment
/// reaches, and of a sun. A ray that hits nothing has the lamp of the ray before it.
#[track_caller]
fn comparer_les_ombres<R: Bits>(
    rayons: &[Rayon<R>],
    touches: &[Touche<R>],
    restants: &[ObjetRay<R>],
    hierarchie: Hierarchie<'_, R>,
    sauf: Option<usize>,
) {
    let objets = hierarchie.objets();
    let etranges = [R::INFINI, R::depuis_f64(f64::NAN), R::ZERO, -R::UN, R::MIN_POSITIF];
    // What is left out changes nothing of what limits are.
    for paquet in if sauf.is_some() { 1..2 } else { 0..6 } {
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
        let seules = sauf.is_some() || paquet == 3 || paquet == 4;
        let une_par_une = if seules { &ombres[..] } else { &[] };
        for ((rayon, max), voulue) in une_par_une.iter().zip(&voulues) {
            assert_eq!(est_occulte(restants, rayon, *max), *voulue, "{rayon:?} before {max:?}");
        }
        // The contrary, so that a place which is left out shows.
        let contraires: Vec<_> = voulues.iter().map(|occulte| !occulte).collect();
        for (nom, reglage) in Reglage::tous() {
            let hierarchie = reglage.hierarchie(hierarchie);
            let (mut de_la_liste, mut de_l_arbre) = (contraires.clone(), contraires.clone());
            let liste = sans(reglage.liste(objets), sauf);
            liste.sont_occultes(&ombres, &mut de_la_liste).unwrap();
            hierarchie.sont_occultes(&ombres, &mut de_l_arbre).unwrap();
            let n = objets.len();
            let exiger = |facon: &str, ombre: &(Rayon<R>, R), occulte: bool, voulue: bool| {
                let scalaire = std::any::type_name::<R>();
                assert_eq!(
                    occulte, voulue,
                    "{facon}, {nom}, {scalaire}, {n} objects without {sauf:?}: {ombre:?}"
                );
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
}
