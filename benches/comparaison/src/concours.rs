//! Who competes. What all answer is compared before anyone is timed.

use std::error::Error;
use std::fmt;

use lancer_rayon::{
    Hierarchie, LongueursDifferentes, NoIntersection, ObjetRay, Rayon, Reel, Touche, est_occulte,
    premiere_intersection, premieres_intersections, sont_occultes,
};
use serde::de::DeserializeOwned;

use crate::annexe_dyn;
use crate::concurrent::{Camp, Concurrent, en_lot, un_par_un};
use crate::pairs::{Parry, Vu};
use commun::conversion::{Bits, mots};
use commun::familles::Lance;
use commun::horloge::{MORCEAU, TOURS, TUILE, chronometrer_lot, moindres};
use commun::litteral;

/// From so many objects on nobody looks at all of them for every ray.
const TROP: usize = 64;

/// A scalar, with what there is for it.
pub(crate) trait Scalaire: Parry + Bits + DeserializeOwned {
    const NOM: &'static str;

    /// Embree computes in `f32`.
    fn embree(_: &[ObjetRay<Self>]) -> Vec<Concurrent<'_, Self>> {
        Vec::new()
    }
}

impl Scalaire for f32 {
    const NOM: &'static str = "f32";

    #[cfg(feature = "embree")]
    fn embree(objets: &[ObjetRay<Self>]) -> Vec<Concurrent<'_, Self>> {
        crate::avec_embree::concurrents(objets)
    }
}

impl Scalaire for f64 {
    const NOM: &'static str = "f64";
}

/// A batch of shadows. The pairs that are asked are made within the time, some 1 ns a ray.
fn ombres_en_lot<'a, R: Reel>(
    occultes: impl Fn(&[Lance<R>], &mut [bool]) -> Result<(), LongueursDifferentes> + 'a,
) -> impl FnMut(&[Rayon<R>], &[R], &mut [bool]) + 'a {
    let mut ombres = Vec::with_capacity(MORCEAU);
    move |rayons, max, caches| {
        ombres.clear();
        ombres.extend(rayons.iter().copied().zip(max.iter().copied()));
        occultes(&ombres, caches).expect("as many answers as rays");
    }
}

/// One scene, as each wants it.
pub(crate) struct Terrain<R: Parry> {
    pub(crate) objets: Vec<ObjetRay<R>>,
    places: Vec<f32>,
    litteraux: Vec<litteral::Objet<R>>,
    dynamiques: Vec<Box<dyn annexe_dyn::Objet<R>>>,
    liste_parry: Vec<R::Objet>,
    arbre_parry: R::Arbre,
    obvhs: R::Obvhs,
}

impl<R: Scalaire> Terrain<R> {
    pub(crate) fn new(objets: Vec<ObjetRay<R>>) -> Self {
        Self {
            places: places(&objets),
            litteraux: objets.iter().map(litteral::Objet::from).collect(),
            dynamiques: objets.iter().map(annexe_dyn::objet).collect(),
            liste_parry: objets.iter().map(R::objet).collect(),
            arbre_parry: R::arbre(&objets),
            obvhs: R::obvhs(&objets),
            objets,
        }
    }

    /// The hierarchy, and everyone.
    pub(crate) fn entrer(&mut self) -> (Hierarchie<'_, R>, Vec<Concurrent<'_, R>>) {
        let Self { objets, places, litteraux, dynamiques, liste_parry, arbre_parry, obvhs } = self;
        let (objets, liste_parry) = (&objets[..], &liste_parry[..]);
        let (arbre_parry, obvhs) = (&*arbre_parry, &*obvhs);
        let tous = Some(objets.len());
        let h = Hierarchie::new(objets, places).expect("as many places as it takes");
        let liste = move |rayons: &[Rayon<R>], touches: &mut [Touche<R>]| {
            premieres_intersections(objets, rayons, touches).expect("as many answers as rays");
        };
        let arbre = move |rayons: &[Rayon<R>], touches: &mut [Touche<R>]| {
            h.premieres_intersections(rayons, touches).expect("as many answers as rays");
        };
        type Jamais<R> = fn(&Rayon<R>, R) -> bool;
        let mut concurrents = vec![
            un_par_un(
                "list",
                Camp::Seul,
                tous,
                |rayon| premiere_intersection(objets, rayon),
                Some(|rayon: &Rayon<R>, max| est_occulte(objets, rayon, max)),
            ),
            un_par_un(
                "hierarchy",
                Camp::Seul,
                None,
                move |rayon| h.premiere_intersection(rayon),
                Some(move |rayon: &Rayon<R>, max| h.est_occulte(rayon, max)),
            ),
            en_lot(
                "list, batch",
                Camp::Lot,
                tous,
                liste,
                Some(ombres_en_lot(|ombres, caches| sont_occultes(objets, ombres, caches))),
            ),
            en_lot(
                "hierarchy, batch",
                Camp::Lot,
                None,
                arbre,
                Some(ombres_en_lot(move |ombres, caches| h.sont_occultes(ombres, caches))),
            ),
            un_par_un(
                "parry, loop",
                Camp::Parry,
                tous,
                |rayon| R::dans_la_liste(liste_parry, &R::rayon(rayon)),
                Some(|rayon: &Rayon<R>, max| {
                    R::ombre_dans_la_liste(liste_parry, &R::rayon(rayon), max)
                }),
            ),
            un_par_un(
                "parry, Bvh",
                Camp::Parry,
                None,
                |rayon| R::dans_l_arbre(arbre_parry, &R::rayon(rayon)),
                Some(|rayon: &Rayon<R>, max| {
                    R::ombre_dans_l_arbre(arbre_parry, &R::rayon(rayon), max)
                }),
            ),
            un_par_un(
                "parry in obvhs",
                Camp::Parry,
                None,
                |rayon| R::dans_obvhs(obvhs, &R::rayon(rayon)),
                None::<Jamais<R>>,
            ),
            un_par_un(
                "annex A, enum",
                Camp::Annexe,
                tous,
                |rayon| litteral::premiere_intersection(litteraux, rayon),
                None::<Jamais<R>>,
            ),
            un_par_un(
                "annex A, dyn",
                Camp::Annexe,
                tous,
                |rayon| annexe_dyn::premiere_intersection(dynamiques, rayon),
                None::<Jamais<R>>,
            ),
        ];
        concurrents.extend(R::embree(objets));
        concurrents.retain(|qui| qui.chaque.is_none_or(|objets| objets <= TROP));
        (h, concurrents)
    }
}

/// An error unless list, hierarchy and both of their batches have the same bits for these rays. A long list is
/// asked about a part of them.
pub(crate) fn exiger_memes_bits<R: Scalaire>(
    hierarchie: &Hierarchie<'_, R>,
    lances: &[Lance<R>],
) -> Result<(), Box<dyn Error>> {
    let objets = hierarchie.objets();
    let pas = (objets.len() / 500).max(1);
    let lances: Vec<_> = lances.chunks(TUILE).step_by(pas).flatten().copied().collect();
    let (rayons, max): (Vec<_>, Vec<_>) = lances.iter().copied().unzip();
    let mut lots = [(); 2].map(|()| vec![Touche::<R>::Err(NoIntersection); rayons.len()]);
    premieres_intersections(objets, &rayons, &mut lots[0])?;
    hierarchie.premieres_intersections(&rayons, &mut lots[1])?;
    for (i, (rayon, max)) in rayons.iter().zip(max).enumerate() {
        let attendue = premiere_intersection(objets, rayon);
        let [a, b] = [0, 1].map(|lot: usize| lots[lot][i]);
        let autres = [hierarchie.premiere_intersection(rayon), a, b];
        let cache = attendue.is_ok_and(|touche| touche.distance() < max);
        if autres.iter().any(|autre| mots(autre) != mots(&attendue))
            || est_occulte(objets, rayon, max) != cache
            || hierarchie.est_occulte(rayon, max) != cache
        {
            return Err(format!("{rayon:?}: {attendue:?} in the list, else {autres:?}").into());
        }
    }
    Ok(())
}

/// An error unless the others see what we see, except for rounding: `tolerance` of the rays may meet another
/// object.
pub(crate) fn exiger_accord<R: Scalaire>(
    concurrents: &mut [Concurrent<'_, R>],
    lances: &[Lance<R>],
    ombres: bool,
    tolerance: f64,
) -> Result<(), Box<dyn Error>> {
    let reponses = |qui: &mut Concurrent<'_, R>| qui.reponses(lances, ombres);
    let ici = concurrents.iter_mut().find(|qui| qui.nom == "hierarchy").and_then(reponses);
    let ici = ici.ok_or("the hierarchy always competes")?;
    for qui in concurrents {
        let Some(autres) = qui.reponses(lances, ombres) else { continue };
        let ecart = Ecart::entre(&ici, &autres);
        if ecart.autre_objet as f64 > tolerance * ici.len() as f64 {
            return Err(format!("{}: {ecart}, of {} rays", qui.nom, ici.len()).into());
        }
    }
    Ok(())
}

/// Nanoseconds per ray of each, in turns; of who has no answer to a shadow, NaN.
pub(crate) fn temps<R: Scalaire>(
    concurrents: &mut [Concurrent<'_, R>],
    lances: &[Lance<R>],
    ombres: bool,
) -> Vec<(&'static str, Camp, f64)> {
    let (rayons, max): (Vec<_>, Vec<_>) = lances.iter().copied().unzip();
    let mut caches = vec![false; MORCEAU];
    let numeros: Vec<_> = (0..concurrents.len()).collect();
    let ns = moindres(TOURS, &numeros, |&i| {
        let qui = &mut concurrents[i];
        let mut max = max.chunks(MORCEAU);
        chronometrer_lot(&rayons, &mut caches, |rayons, caches| {
            match (&mut qui.ombres, max.next().filter(|_| ombres)) {
                (Some(ombres), Some(max)) => ombres(rayons, max, caches),
                (None, Some(_)) => {}
                (_, None) => (qui.premieres)(rayons, None),
            }
        })
    });
    let temps = concurrents.iter().zip(ns);
    temps
        .map(|(qui, ns)| {
            let ns = if ombres && qui.ombres.is_none() { f64::NAN } else { ns };
            (qui.nom, qui.camp, ns)
        })
        .collect()
}

impl<R: Reel> Concurrent<'_, R> {
    /// What it answers; of a shadow, a hit at the source if there is something in the way.
    pub(crate) fn reponses(
        &mut self,
        lances: &[Lance<R>],
        ombres: bool,
    ) -> Option<Vec<Option<Vu<R>>>> {
        let (rayons, max): (Vec<_>, Vec<_>) = lances.iter().copied().unzip();
        if ombres {
            let ombres = self.ombres.as_mut()?;
            let mut caches = vec![false; rayons.len()];
            let morceaux = rayons.chunks(MORCEAU).zip(max.chunks(MORCEAU));
            for ((rayons, max), caches) in morceaux.zip(caches.chunks_mut(MORCEAU)) {
                ombres(rayons, max, caches);
            }
            let vu = |cache: bool| {
                cache.then_some((R::ZERO, lancer_rayon::Vecteur::NUL, lancer_rayon::Texture(0)))
            };
            return Some(caches.into_iter().map(vu).collect());
        }
        let mut vus = Vec::new();
        for rayons in rayons.chunks(MORCEAU) {
            (self.premieres)(rayons, Some(&mut vus));
        }
        Some(vus)
    }
}

/// Places for a hierarchy over these objects.
pub(crate) fn places<R: Reel>(objets: &[ObjetRay<R>]) -> Vec<f32> {
    vec![0.0; Hierarchie::places(objets.len())]
}

/// How the answers of another differ from ours to the same rays.
struct Ecart {
    touches: [usize; 2],
    sommes_des_distances: [f64; 2],
    autre_objet: usize,
}

impl Ecart {
    fn entre<R: Reel>(ici: &[Option<Vu<R>>], autre: &[Option<Vu<R>>]) -> Self {
        let distance = |touche: &Vu<R>| touche.0.vers_f64();
        // Of two objects at one distance, as of cubes side by side, each takes either.
        let autre_objet = |a: &Option<Vu<R>>, b: &Option<Vu<R>>| match (a, b) {
            (Some(a), Some(b)) => {
                a.2 != b.2 && (distance(a) - distance(b)).abs() > 1e-5 * distance(a)
            }
            (a, b) => a.is_some() != b.is_some(),
        };
        Self {
            touches: [ici, autre].map(|liste| liste.iter().flatten().count()),
            sommes_des_distances: [ici, autre].map(|l| l.iter().flatten().map(distance).sum()),
            autre_objet: ici.iter().zip(autre).filter(|(a, b)| autre_objet(a, b)).count(),
        }
    }
}

impl fmt::Display for Ecart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ([ici, autre], [a, b]) = (self.touches, self.sommes_des_distances);
        write!(f, "{autre} hits for our {ici}, distances off by {:.0e}, ", (b - a).abs() / a)?;
        write!(f, "another object for {} rays", self.autre_objet)
    }
}
