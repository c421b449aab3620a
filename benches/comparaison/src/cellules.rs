//! What is measured: a cell for every family of scenes, kind of rays and scalar.

use std::error::Error;

use banc::concurrents::{Camp, Concurrent, temps};
use banc::familles::{Famille, GRAINE_DES_PAGES, Genre};

use crate::autres::{
    Scalaire, avec_leur_touche, en_morceaux, exiger_accord, exiger_memes_bits, rivaux, tous,
};

const NOMBRES: [usize; 5] = [12, 48, 192, 1000, 10_000];

/// How much of a picture: bands of 4,800 rays.
const BANDES: usize = 8;

/// The part of the camera rays that may meet another object for others, where two objects touch.
const TOLERANCE: f64 = 0.005;

/// The part of rays that start ahead: in a corner they start in the neighbour.
const TOLERANCE_EN_AVANT: f64 = 0.02;

/// The part for Embree's quads among cubes, where another object is seen along up to 7 % of the rays.
const TOLERANCE_DES_QUADS: f64 = 0.1;

/// The times of one kind of rays in one scene.
pub(crate) struct Cellule {
    pub(crate) famille: Famille,
    pub(crate) n: usize,
    pub(crate) scalaire: &'static str,
    pub(crate) genre: Genre,
    temps: Vec<(Camp, f64)>,
}

impl Cellule {
    /// The least of these sides.
    pub(crate) fn ns(&self, camps: &[Camp]) -> f64 {
        let les_leurs = self.temps.iter().filter(|(camp, _)| camps.contains(camp));
        les_leurs.map(|(_, ns)| *ns).fold(f64::NAN, f64::min)
    }
}

/// All cells. Everyone's answers are checked first, then timed.
pub(crate) fn mesurer() -> Result<Vec<Cellule>, Box<dyn Error>> {
    let mut cellules = Vec::new();
    for chronometrer in [false, true] {
        for famille in Famille::TOUTES {
            for &n in famille.nombres(&NOMBRES) {
                courir::<f32>(famille, n, chronometrer, &mut cellules)?;
                courir::<f64>(famille, n, chronometrer, &mut cellules)?;
            }
            println!("{} {}", famille.nom(), if chronometrer { "timed" } else { "agrees" });
        }
    }
    Ok(cellules)
}

/// The cells of a scene; or the check that in each list, tree and batches agree to the bit, and the others except for
/// rounding.
fn courir<R: Scalaire>(
    famille: Famille,
    n: usize,
    chronometrer: bool,
    cellules: &mut Vec<Cellule>,
) -> Result<(), Box<dyn Error>> {
    let scene = famille.scene::<R>(n, GRAINE_DES_PAGES);
    let mut memoire = Vec::new();
    let monde = en_morceaux(&scene.objets, &mut memoire)?;
    let rivaux = rivaux(&scene.objets);
    for genre in Genre::TOUS {
        let departs = genre.departs(&monde, &scene, BANDES);
        let rayons: Vec<_> = departs.iter().map(|(rayon, _)| *rayon).collect();
        let depuis: Vec<_> =
            departs.into_iter().filter_map(|(rayon, touche)| Some((rayon, touche?))).collect();
        let en_avant = genre.en_avant(&rayons);
        let mut concurrents = tous(monde, &rivaux, &rayons, &en_avant, genre);
        concurrents.extend((!depuis.is_empty()).then(|| avec_leur_touche(monde, &depuis, genre)));
        if chronometrer {
            concurrents.retain(|qui| qui.camp != Camp::Annexe);
            let ns = temps(&mut concurrents);
            let temps = concurrents.iter().map(|qui| qui.camp).zip(ns).collect();
            cellules.push(Cellule { famille, n, scalaire: R::NOM, genre, temps });
            continue;
        }
        let tolerance = |qui: &Concurrent<'_>| {
            let quads = famille == Famille::Cubes && qui.nom.contains("quads");
            match qui.camp {
                Camp::Seul | Camp::Lot | Camp::Depuis => 0.0,
                _ if quads => TOLERANCE_DES_QUADS,
                _ if !genre.partent() => TOLERANCE,
                Camp::Parry | Camp::Embree | Camp::EmbreeSeize | Camp::Annexe => TOLERANCE_EN_AVANT,
            }
        };
        let juge =
            exiger_memes_bits(monde, &rayons).and_then(|()| exiger_accord(&concurrents, tolerance));
        let ou = format!("{} {n} {} {}", famille.nom(), R::NOM, genre.nom());
        juge.map_err(|erreur| format!("{ou}: {erreur}"))?;
    }
    Ok(())
}
