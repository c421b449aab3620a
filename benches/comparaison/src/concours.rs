//! Who competes. What they answer is compared before anyone is timed.

use std::error::Error;
use std::fmt;

use lancer_rayon::{ObjetRay, Rayon, Reel, Touche, premiere_intersection, premieres_intersections};

use crate::annexe_dyn;
use crate::commun::litteral;
use crate::horloge::{chronometrer, chronometrer_lot, exiger, medianes, petit_tampon, une_par_une};
use crate::pairs::{Parry, Vu};

/// Who looks at every object, ray by ray, gets one tile in so many of a picture of a thousand
/// objects or more: enough for its time, which would be minutes for them all.
const TUILES: usize = 8;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Concurrent {
    Lot,
    Rayons,
    AnnexeEnum,
    AnnexeDyn,
    ParryListe,
    ParryArbre,
}

impl Concurrent {
    pub(crate) const TOUS: [Self; 6] = [
        Self::Lot,
        Self::Rayons,
        Self::AnnexeEnum,
        Self::AnnexeDyn,
        Self::ParryListe,
        Self::ParryArbre,
    ];

    fn nom(self) -> &'static str {
        match self {
            Self::Lot => "batch",
            Self::Rayons => "ray by ray",
            Self::AnnexeEnum => "annex A, enum",
            Self::AnnexeDyn => "annex A, dyn",
            Self::ParryListe => "parry, loop",
            Self::ParryArbre => "parry, Bvh",
        }
    }
}

/// Nanoseconds per ray; NaN for who did not run.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Temps([f64; 6]);

impl Temps {
    pub(crate) fn de(&self, qui: Concurrent) -> f64 {
        self.0[qui as usize]
    }

    /// The better of the two.
    pub(crate) fn parry(&self) -> f64 {
        self.de(Concurrent::ParryListe).min(self.de(Concurrent::ParryArbre))
    }

    /// The better of the two.
    pub(crate) fn annexe(&self) -> f64 {
        self.de(Concurrent::AnnexeEnum).min(self.de(Concurrent::AnnexeDyn))
    }
}

/// One scene and its rays, as each wants them.
pub(crate) struct Concours<R: Parry> {
    pub(crate) objets: Vec<ObjetRay<R>>,
    pub(crate) rayons: Vec<Rayon<R>>,
    litteraux: Vec<litteral::Objet<R>>,
    dynamiques: Vec<Box<dyn annexe_dyn::Objet<R>>>,
    liste_parry: Vec<R::Objet>,
    arbre_parry: R::Arbre,
    rayons_parry: Vec<R::Rayon>,
}

impl<R: Parry> Concours<R> {
    pub(crate) fn new(objets: Vec<ObjetRay<R>>, rayons: Vec<Rayon<R>>) -> Self {
        Self {
            litteraux: objets.iter().map(litteral::Objet::from).collect(),
            dynamiques: objets.iter().map(annexe_dyn::objet).collect(),
            liste_parry: objets.iter().map(R::objet).collect(),
            arbre_parry: R::arbre(&objets),
            rayons_parry: rayons.iter().map(R::rayon).collect(),
            objets,
            rayons,
        }
    }

    fn ici(&self, rayon: &Rayon<R>) -> Touche<R> {
        premiere_intersection(&self.objets, rayon)
    }

    fn litteral(&self, rayon: &Rayon<R>) -> Option<Vu<R>> {
        litteral::premiere_intersection(&self.litteraux, rayon)
    }

    fn dynamique(&self, rayon: &Rayon<R>) -> Option<Vu<R>> {
        annexe_dyn::premiere_intersection(&self.dynamiques, rayon)
    }

    fn liste(&self, rayon: &R::Rayon) -> Option<Vu<R>> {
        R::dans_la_liste(&self.liste_parry, rayon)
    }

    fn arbre(&self, rayon: &R::Rayon) -> Option<Vu<R>> {
        R::dans_l_arbre(&self.arbre_parry, rayon)
    }

    /// What one answers to every ray of so many. The batch answers as the rays do one by one,
    /// which `verifier` makes sure of.
    pub(crate) fn reponses(&self, qui: Concurrent, pas: usize) -> Vec<Option<Vu<R>>> {
        let rayons = self.rayons.iter().step_by(pas);
        let rayons_parry = self.rayons_parry.iter().step_by(pas);
        match qui {
            Concurrent::Lot | Concurrent::Rayons => rayons.map(|r| touche(self.ici(r))).collect(),
            Concurrent::AnnexeEnum => rayons.map(|r| self.litteral(r)).collect(),
            Concurrent::AnnexeDyn => rayons.map(|r| self.dynamique(r)).collect(),
            Concurrent::ParryListe => rayons_parry.map(|r| self.liste(r)).collect(),
            Concurrent::ParryArbre => rayons_parry.map(|r| self.arbre(r)).collect(),
        }
    }

    /// An error unless the batch is exact and the others agree but for rounding.
    pub(crate) fn verifier(&self, concurrents: &[Concurrent]) -> Result<(), Box<dyn Error>> {
        let attendues = une_par_une(&self.objets, &self.rayons);
        let ici: Vec<_> = attendues.iter().copied().map(touche).collect();
        for qui in concurrents {
            match qui {
                Concurrent::Rayons => {}
                Concurrent::Lot => exiger(&attendues, &self.rayons, |rayons, touches| {
                    premieres_intersections(&self.objets, rayons, touches)
                })?,
                Concurrent::AnnexeEnum
                | Concurrent::AnnexeDyn
                | Concurrent::ParryListe
                | Concurrent::ParryArbre => {
                    let ecart = Ecart::entre(&ici, &self.reponses(*qui, 1));
                    let (scalaire, n) = (std::any::type_name::<R>(), self.objets.len());
                    println!("{scalaire}, N = {n}, {}: {ecart}", qui.nom());
                    if !ecart.explicable::<R>(ici.len()) {
                        return Err("the answers differ by more than rounding explains".into());
                    }
                }
            }
        }
        Ok(())
    }

    pub(crate) fn temps(&self, concurrents: &[Concurrent]) -> Temps {
        let (rayons, rayons_parry) = (&self.rayons, &self.rayons_parry);
        let pas = if self.objets.len() < 1000 { 1 } else { TUILES };
        let mut tampon = petit_tampon();
        let medianes = medianes(concurrents, |qui| match qui {
            Concurrent::Lot => chronometrer_lot(rayons, &mut tampon, |rayons, touches| {
                premieres_intersections(&self.objets, rayons, touches)
            }),
            Concurrent::Rayons => chronometrer(rayons, pas, |rayon| self.ici(rayon)),
            Concurrent::AnnexeEnum => chronometrer(rayons, pas, |rayon| self.litteral(rayon)),
            Concurrent::AnnexeDyn => chronometrer(rayons, pas, |rayon| self.dynamique(rayon)),
            Concurrent::ParryListe => chronometrer(rayons_parry, pas, |rayon| self.liste(rayon)),
            Concurrent::ParryArbre => chronometrer(rayons_parry, 1, |rayon| self.arbre(rayon)),
        });
        let mut temps = Temps([f64::NAN; 6]);
        for (qui, mediane) in concurrents.iter().zip(medianes) {
            temps.0[*qui as usize] = mediane;
        }
        temps
    }
}

fn touche<R: Reel>(reponse: Touche<R>) -> Option<Vu<R>> {
    let touche = reponse.ok()?;
    Some((touche.distance(), touche.normale(), touche.texture()))
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
        let objet = |touche: &Option<Vu<R>>| touche.map(|(_, _, texture)| texture);
        Self {
            touches: [ici, autre].map(|liste| liste.iter().flatten().count()),
            sommes_des_distances: [ici, autre].map(|l| l.iter().flatten().map(distance).sum()),
            autre_objet: ici.iter().zip(autre).filter(|(a, b)| objet(a) != objet(b)).count(),
        }
    }

    fn relatif(&self) -> f64 {
        let [ici, autre] = self.sommes_des_distances;
        (autre - ici).abs() / ici
    }

    /// Rounding moves an outline by thousands of u at most, which are what SC² − SA² costs annex A
    /// and parry: the rays in between, and nothing else, may touch another object.
    fn explicable<R: Reel>(&self, rayons: usize) -> bool {
        let tolerance = 1e4 * R::U.vers_f64();
        self.autre_objet as f64 <= tolerance * rayons as f64 && self.relatif() <= tolerance
    }
}

impl fmt::Display for Ecart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ([ici, autre], relatif) = (self.touches, self.relatif());
        write!(f, "{autre} hits for our {ici}, distances off by {relatif:.0e}, ")?;
        write!(f, "another object for {} rays", self.autre_objet)
    }
}
