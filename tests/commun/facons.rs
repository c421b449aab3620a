//! Every way to an answer, with every instruction set of the machine: the list in a batch, the hierarchy ray by
//! ray and in a batch, shadows of both; each beside the list ray by ray.

use lancer_rayon::{
    Hierarchie, ObjetRay, Rayon, Reglage, SphereGeo, Texture, Touche, Vecteur, est_occulte,
    premiere_intersection,
};

use crate::conversion::{Bits, mots};

/// The fewest objects that get a tree; `les_places_pretees` holds it.
pub const UN_ARBRE: usize = 8;

/// The fewest objects of which a block walks the tree.
const UN_BLOC: usize = Reglage::SEUIL_LOT + 1;

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

/// These rays have these answers, to the bit; the first that differs is named.
#[track_caller]
pub fn exiger<R: Bits>(
    facon: &str,
    objets: &[ObjetRay<R>],
    rayons: &[Rayon<R>],
    obtenues: &[Touche<R>],
    attendues: &[Touche<R>],
) {
    for ((rayon, obtenue), attendue) in rayons.iter().zip(obtenues).zip(attendues) {
        assert_eq!(
            mots(obtenue),
            mots(attendue),
            "{facon}, {}, {} objects: {rayon:?} has {obtenue:?}, alone {attendue:?}",
            std::any::type_name::<R>(),
            objets.len()
        );
    }
}

/// Asks these rays every question in every way; how many touch something. A list that is too short for a walk of
/// its blocks is repeated until it is long enough.
#[track_caller]
pub fn comparer<R: Bits>(objets: &[ObjetRay<R>], rayons: &[Rayon<R>]) -> usize {
    let n = objets.len();
    let attendues: Vec<_> = rayons.iter().map(|r| premiere_intersection(objets, r)).collect();
    // What the memory held before must not show through.
    let mut places = vec![f32::NAN; Hierarchie::places(n)];
    let hierarchie = Hierarchie::new(objets, &mut places).unwrap();
    for (nom, reglage) in Reglage::tous() {
        let hierarchie = reglage.hierarchie(hierarchie);
        let mut touches = vec![absurde(); rayons.len()];
        reglage.liste(objets).premieres_intersections(rayons, &mut touches).unwrap();
        exiger(&format!("{nom}, batch"), objets, rayons, &touches, &attendues);
        touches.fill(absurde());
        hierarchie.premieres_intersections(rayons, &mut touches).unwrap();
        exiger(&format!("{nom}, hierarchy, batch"), objets, rayons, &touches, &attendues);
        touches.clear();
        touches.extend(rayons.iter().map(|rayon| hierarchie.premiere_intersection(rayon)));
        exiger(&format!("{nom}, hierarchy"), objets, rayons, &touches, &attendues);
    }
    comparer_les_ombres(objets, rayons, &attendues, hierarchie);
    if (UN_ARBRE..UN_BLOC).contains(&n) {
        comparer(&objets.repeat(UN_BLOC.div_ceil(n)), rayons);
    }
    attendues.iter().flatten().count()
}

/// The same of shadow rays whose lamps are at their first hits, beside them and farther, of some that no segment
/// reaches, and of a sun. A ray that hits nothing has the lamp of the ray before it.
#[track_caller]
fn comparer_les_ombres<R: Bits>(
    objets: &[ObjetRay<R>],
    rayons: &[Rayon<R>],
    touches: &[Touche<R>],
    hierarchie: Hierarchie<'_, R>,
) {
    let etranges = [R::INFINI, R::depuis_f64(f64::NAN), R::ZERO, -R::UN, R::MIN_POSITIF];
    for paquet in 0..6 {
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
        let une_par_une = if paquet == 3 || paquet == 4 { &ombres[..] } else { &[] };
        for ((rayon, max), voulue) in une_par_une.iter().zip(&voulues) {
            assert_eq!(est_occulte(objets, rayon, *max), *voulue, "{rayon:?} before {max:?}");
        }
        // The contrary, so that a place which is left out shows.
        let contraires: Vec<_> = voulues.iter().map(|occulte| !occulte).collect();
        for (nom, reglage) in Reglage::tous() {
            let hierarchie = reglage.hierarchie(hierarchie);
            let (mut de_la_liste, mut de_l_arbre) = (contraires.clone(), contraires.clone());
            reglage.liste(objets).sont_occultes(&ombres, &mut de_la_liste).unwrap();
            hierarchie.sont_occultes(&ombres, &mut de_l_arbre).unwrap();
            let n = objets.len();
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
            }
        }
    }
}
