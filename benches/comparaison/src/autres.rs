//! The competitors, and a check before anyone is timed that all see the same.

use std::error::Error;

use banc::concurrents::{Camp, Concurrent, Reponse, cachee, permises};
use banc::familles::{AVANCE, Genre};
use banc::nous;
use commun::conversion::Bits;
use exemples::scene::Lisible;
use lancer_rayon::{Intersection, Monde, ObjetRay, PlacesInsuffisantes, Rayon, Reel, places};

use crate::annexe::Annexe;
use crate::rival::{Parry, Rival};

/// A scalar, with what exists for it alone.
pub(crate) trait Scalaire: Parry + Bits + Lisible {
    const NOM: &'static str;

    /// Embree computes in `f32`.
    fn embree(_: &[ObjetRay<Self>]) -> Vec<Box<dyn Rival<Self>>> {
        Vec::new()
    }
}

impl Scalaire for f32 {
    const NOM: &'static str = "f32";

    #[cfg(feature = "embree")]
    fn embree(objets: &[ObjetRay<Self>]) -> Vec<Box<dyn Rival<Self>>> {
        crate::embree::rivaux(objets)
    }
}

impl Scalaire for f64 {
    const NOM: &'static str = "f64";
}

/// The scene in the form that each of the others wants.
pub(crate) fn rivaux<R: Scalaire>(objets: &[ObjetRay<R>]) -> Vec<Box<dyn Rival<R>>> {
    let mut rivaux = R::embree(objets);
    rivaux.push(R::rival(objets));
    rivaux.push(Box::new(Annexe::new(objets)));
    rivaux
}

/// Our ways and all others, who start ahead of what a ray leaves. Those that look at all objects for every ray take
/// part only where these are few.
pub(crate) fn tous<'a, R: Reel>(
    monde: Monde<'a, R>,
    rivaux: &'a [Box<dyn Rival<R>>],
    rayons: &'a [Rayon<R>],
    en_avant: &'a [Rayon<R>],
    genre: Genre,
) -> Vec<Concurrent<'a>> {
    let permises = permises(monde.objets().len());
    let nous = nous::concurrents(monde, rayons, genre.ombres()).into_iter();
    let nous = nous.filter(|qui| permises.contains(&(qui.nom, qui.camp)));
    let eux = rivaux.iter().flat_map(|rival| rival.concurrents(en_avant, genre.ombres()));
    nous.chain(eux).collect()
}

/// Us one by one, each ray asked with the hit that it leaves.
pub(crate) fn avec_leur_touche<'a, R: Reel>(
    monde: Monde<'a, R>,
    depuis: &'a [(Rayon<R>, Intersection<R>)],
    genre: Genre,
) -> Concurrent<'a> {
    let facon = ("from its hit", Camp::Depuis);
    if genre.ombres() {
        let occulte = move |(rayon, touche): &_| monde.est_occulte_depuis(touche, rayon);
        return Concurrent::un_par_un(facon, depuis, occulte, cachee);
    }
    let premiere = move |(rayon, touche): &_| monde.premiere_depuis(touche, rayon);
    Concurrent::un_par_un(facon, depuis, premiere, nous::dire)
}

/// These objects with a tree in `memoire`, which becomes twice what the tree needs; the rest is for the pieces of long
/// boxes.
pub(crate) fn en_morceaux<'a, R: Reel>(
    objets: &'a [ObjetRay<R>],
    memoire: &'a mut Vec<f32>,
) -> Result<Monde<'a, R>, PlacesInsuffisantes> {
    memoire.resize(2 * places(objets.len()), 0.0);
    Monde::en_morceaux(objets, memoire)
}

/// An error unless list, tree and both of their batches have the same bits for these rays, and unless shadows agree
/// with first hits. A long list is asked about a part of the rays.
pub(crate) fn exiger_memes_bits<R: Scalaire>(
    monde: Monde<'_, R>,
    rayons: &[Rayon<R>],
) -> Result<(), Box<dyn Error>> {
    const TUILE: usize = 64;
    let pas = (monde.objets().len() / 500).max(1);
    let rayons: Vec<_> = rayons.chunks(TUILE).step_by(pas).flatten().copied().collect();
    let touches = nous::concurrents(monde, &rayons, false).map(|qui| qui.reponses());
    let caches = nous::concurrents(monde, &rayons, true).map(|qui| qui.reponses());
    // The first hits before an end must be those of the rays without it.
    let sans_fin = |rayon: &Rayon<R>| rayon.jusqu_a(R::INFINI);
    let sans_fin: Vec<_> = rayons.iter().map(sans_fin).collect::<Result<_, _>>()?;
    let [toutes, ..] = nous::concurrents(monde, &sans_fin, false).map(|qui| qui.reponses());
    let avant = |(touche, rayon): (&Reponse, &Rayon<R>)| {
        touche.filter(|touche| distance(*touche) < rayon.fin().vers_f64())
    };
    if touches.iter().any(|autres| *autres != touches[0])
        || caches.iter().any(|autres| *autres != caches[0])
        || !toutes.iter().zip(&rayons).map(avant).eq(touches[0].iter().copied())
        || !touches[0].iter().map(Option::is_some).eq(caches[0].iter().map(Option::is_some))
    {
        return Err("list, tree and batches differ".into());
    }
    Ok(())
}

/// An error unless the others see what we see, except for rounding and where they start: `tolerance` of the rays may
/// meet another object. Where two objects are at one distance, as cubes side by side, each may take either.
pub(crate) fn exiger_accord(
    concurrents: &[Concurrent<'_>],
    tolerance: impl Fn(&Concurrent<'_>) -> f64,
) -> Result<(), Box<dyn Error>> {
    let seule = concurrents.iter().find(|qui| qui.nom == "single");
    let ici = seule.ok_or("the tree always competes")?.reponses();
    for qui in concurrents {
        let reponses = qui.reponses();
        let autre = |(a, b): &(&Reponse, &Reponse)| match (a, b) {
            (Some(a), Some(b)) => {
                let ecart = (distance(*a) - distance(*b)).abs();
                a.1 != b.1 && ecart > 1e-5 * distance(*a) + 1.5 * AVANCE
            }
            (a, b) => a.is_some() != b.is_some(),
        };
        let autres = ici.iter().zip(&reponses).filter(autre).count();
        if autres as f64 > tolerance(qui) * ici.len() as f64 {
            let n = ici.len();
            return Err(format!("{}: another object for {autres} of {n} rays", qui.nom).into());
        }
    }
    Ok(())
}

pub(crate) fn distance((nombres, _): ([u64; 5], u32)) -> f64 {
    f64::from_bits(nombres[0])
}
