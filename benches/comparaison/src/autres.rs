//! Who competes beside us, and that all see the same before anyone is timed.

use std::error::Error;

use banc::concurrents::{Concurrent, Reponse, permises};
use banc::familles::{AVANCE, Lance, Lances};
use banc::nous;
use commun::conversion::Bits;
use lancer_rayon::{Hierarchie, ObjetRay, Rayon, Reel};
use serde::de::DeserializeOwned;

use crate::annexe::Annexe;
use crate::monde::{Monde, Parry};

/// A scalar, with what there is for it alone.
pub(crate) trait Scalaire: Parry + Bits + DeserializeOwned {
    const NOM: &'static str;

    /// Embree computes in `f32`.
    fn embree(_: &[ObjetRay<Self>]) -> Vec<Box<dyn Monde<Self>>> {
        Vec::new()
    }
}

impl Scalaire for f32 {
    const NOM: &'static str = "f32";

    #[cfg(feature = "embree")]
    fn embree(objets: &[ObjetRay<Self>]) -> Vec<Box<dyn Monde<Self>>> {
        crate::embree::mondes(objets)
    }
}

impl Scalaire for f64 {
    const NOM: &'static str = "f64";
}

/// The scene as each of the others wants it.
pub(crate) fn mondes<R: Scalaire>(objets: &[ObjetRay<R>]) -> Vec<Box<dyn Monde<R>>> {
    let mut mondes = R::embree(objets);
    mondes.push(R::monde(objets));
    mondes.push(Box::new(Annexe::new(objets)));
    mondes
}

/// We and all others, who start ahead of what a ray leaves; who looks at all objects for every ray, only where they are few.
pub(crate) fn tous<'a, R: Reel>(
    hierarchie: Hierarchie<'a, R>,
    mondes: &'a [Box<dyn Monde<R>>],
    lances: &'a Lances<R>,
    en_avant: &'a Lances<R>,
) -> Vec<Concurrent<'a>> {
    let permises = permises(hierarchie.objets().len());
    let nous = nous::concurrents(hierarchie, &lances.rayons, &lances.ombres).into_iter();
    let nous = nous.filter(|qui| permises.contains(&(qui.nom, qui.camp)));
    let Lances { rayons, ombres, .. } = en_avant;
    let eux = mondes.iter().flat_map(|monde| monde.concurrents(rayons, ombres));
    nous.chain(eux).collect()
}

/// Places for a hierarchy over these objects, and as many for the pieces of long boxes.
pub(crate) fn places<R: Reel>(objets: &[ObjetRay<R>]) -> Vec<f32> {
    vec![0.0; 2 * Hierarchie::places(objets.len())]
}

/// An error unless list, hierarchy and both of their batches have the same bits for these rays and for shadows
/// along them. A long list is asked about a part of them.
pub(crate) fn exiger_memes_bits<R: Scalaire>(
    hierarchie: Hierarchie<'_, R>,
    rayons: &[Rayon<R>],
    ombres: &[Lance<R>],
) -> Result<(), Box<dyn Error>> {
    const TUILE: usize = 64;
    let pas = (hierarchie.objets().len() / 500).max(1);
    let rayons: Vec<_> = rayons.chunks(TUILE).step_by(pas).flatten().copied().collect();
    let ombres: Vec<_> = if ombres.is_empty() {
        rayons.iter().map(|rayon| (*rayon, R::INFINI)).collect()
    } else {
        ombres.chunks(TUILE).step_by(pas).flatten().copied().collect()
    };
    let touches = nous::concurrents(hierarchie, &rayons, &[]).map(|qui| qui.reponses());
    let caches = nous::concurrents(hierarchie, &rayons, &ombres).map(|qui| qui.reponses());
    let cachee = |(touche, (_, max)): (&Reponse, &Lance<R>)| {
        touche.is_some_and(|touche| distance(touche) < max.vers_f64())
    };
    let attendues = touches[0].iter().zip(&ombres).map(cachee);
    if touches.iter().any(|autres| *autres != touches[0])
        || caches.iter().any(|autres| *autres != caches[0])
        || !attendues.eq(caches[0].iter().map(Option::is_some))
    {
        return Err("list, hierarchy and batches differ".into());
    }
    Ok(())
}

/// An error unless the others see what we see, except for rounding and where they start: `tolerance` of the rays
/// may meet another object. Of two objects at one distance, as of cubes side by side, each takes either.
pub(crate) fn exiger_accord(
    concurrents: &[Concurrent<'_>],
    tolerance: impl Fn(&Concurrent<'_>) -> f64,
) -> Result<(), Box<dyn Error>> {
    let seule = concurrents.iter().find(|qui| qui.nom == "single");
    let ici = seule.ok_or("the hierarchy always competes")?.reponses();
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
