//! Who competes. What they answer is compared before anyone is timed.

use std::error::Error;
use std::fmt;

use lancer_rayon::{
    Hierarchie, ObjetRay, Rayon, Reel, Touche, premiere_intersection, premieres_intersections,
};

use crate::annexe_dyn;
use crate::commun::litteral;
use crate::horloge::{
    TUILE, chronometrer, chronometrer_lot, exiger, moindres, petit_tampon, une_par_une,
};
use crate::pairs::{Parry, Vu};

/// A competitor that tests every object ray by ray gets one tile in so many, from a thousand objects on:
/// enough to time it, where the whole picture would take minutes.
const TUILES: usize = 8;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Concurrent {
    LotListe,
    LotHierarchie,
    Liste,
    Hierarchie,
    ParryListe,
    ParryArbre,
    Obvhs,
    AnnexeEnum,
    AnnexeDyn,
}

impl Concurrent {
    pub(crate) const TOUS: [Self; 9] = [
        Self::LotListe,
        Self::LotHierarchie,
        Self::Liste,
        Self::Hierarchie,
        Self::ParryListe,
        Self::ParryArbre,
        Self::Obvhs,
        Self::AnnexeEnum,
        Self::AnnexeDyn,
    ];

    /// Those whose time hardly grows with the number of objects.
    pub(crate) const ARBRES: [Self; 4] =
        [Self::LotHierarchie, Self::Hierarchie, Self::ParryArbre, Self::Obvhs];

    pub(crate) fn nom(self) -> &'static str {
        match self {
            Self::LotListe => "list, batch",
            Self::LotHierarchie => "hierarchy, batch",
            Self::Liste => "list",
            Self::Hierarchie => "hierarchy",
            Self::ParryListe => "parry, loop",
            Self::ParryArbre => "parry, Bvh",
            Self::Obvhs => "parry in obvhs",
            Self::AnnexeEnum => "annex A, enum",
            Self::AnnexeDyn => "annex A, dyn",
        }
    }
}

/// Nanoseconds per ray; NaN for who did not run.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Temps([f64; 9]);

impl Temps {
    pub(crate) fn de(&self, qui: Concurrent) -> f64 {
        self.0[qui as usize]
    }

    /// The best of these.
    pub(crate) fn le_meilleur<const N: usize>(&self, de: [Concurrent; N]) -> f64 {
        de.into_iter().map(|qui| self.de(qui)).fold(f64::NAN, f64::min)
    }

    /// Our rays one by one.
    pub(crate) fn seuls(&self) -> f64 {
        self.le_meilleur([Concurrent::Liste, Concurrent::Hierarchie])
    }

    /// Our batch.
    pub(crate) fn lot(&self) -> f64 {
        self.le_meilleur([Concurrent::LotListe, Concurrent::LotHierarchie])
    }

    /// parry, in a loop or in one of the two trees.
    pub(crate) fn parry(&self) -> f64 {
        self.le_meilleur([Concurrent::ParryListe, Concurrent::ParryArbre, Concurrent::Obvhs])
    }

    pub(crate) fn annexe(&self) -> f64 {
        self.le_meilleur([Concurrent::AnnexeEnum, Concurrent::AnnexeDyn])
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
    obvhs: R::Obvhs,
    rayons_parry: Vec<R::Rayon>,
}

impl<R: Parry> Concours<R> {
    pub(crate) fn new(objets: Vec<ObjetRay<R>>, rayons: Vec<Rayon<R>>) -> Self {
        Self {
            litteraux: objets.iter().map(litteral::Objet::from).collect(),
            dynamiques: objets.iter().map(annexe_dyn::objet).collect(),
            liste_parry: objets.iter().map(R::objet).collect(),
            arbre_parry: R::arbre(&objets),
            obvhs: R::obvhs(&objets),
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

    fn obvhs(&self, rayon: &R::Rayon) -> Option<Vu<R>> {
        R::dans_obvhs(&self.obvhs, rayon)
    }

    /// What one answers to every ray of so many. The batch and the hierarchy answer as the list does ray
    /// by ray, which `verifier` makes sure of.
    pub(crate) fn reponses(&self, qui: Concurrent, pas: usize) -> Vec<Option<Vu<R>>> {
        let rayons = self.rayons.iter().step_by(pas);
        let rayons_parry = self.rayons_parry.iter().step_by(pas);
        match qui {
            Concurrent::LotListe
            | Concurrent::LotHierarchie
            | Concurrent::Liste
            | Concurrent::Hierarchie => rayons.map(|r| touche(self.ici(r))).collect(),
            Concurrent::AnnexeEnum => rayons.map(|r| self.litteral(r)).collect(),
            Concurrent::AnnexeDyn => rayons.map(|r| self.dynamique(r)).collect(),
            Concurrent::ParryListe => rayons_parry.map(|r| self.liste(r)).collect(),
            Concurrent::ParryArbre => rayons_parry.map(|r| self.arbre(r)).collect(),
            Concurrent::Obvhs => rayons_parry.map(|r| self.obvhs(r)).collect(),
        }
    }

    /// An error unless the batch and the hierarchy have the bits of the list ray by ray, and the others
    /// agree but for rounding. Of a long list a part of the rays must do.
    pub(crate) fn verifier(&self, concurrents: &[Concurrent]) -> Result<(), Box<dyn Error>> {
        let pas = (self.objets.len() / 5000).max(1);
        let rayons: Vec<_> = self.rayons.chunks(TUILE).step_by(pas).flatten().copied().collect();
        let attendues = une_par_une(&self.objets, &rayons);
        let ici = self.reponses(Concurrent::Liste, pas);
        let mut places = places(&self.objets);
        let hierarchie = Hierarchie::new(&self.objets, &mut places)?;
        for qui in concurrents {
            match qui {
                Concurrent::Liste => {}
                Concurrent::Hierarchie => {
                    let obtenues =
                        rayons.iter().map(|rayon| hierarchie.premiere_intersection(rayon));
                    if !obtenues.eq(attendues.iter().copied()) {
                        return Err("the hierarchy differs from its list".into());
                    }
                }
                Concurrent::LotListe => exiger(&attendues, &rayons, |rayons, touches| {
                    premieres_intersections(&self.objets, rayons, touches)
                })?,
                Concurrent::LotHierarchie => exiger(&attendues, &rayons, |rayons, touches| {
                    hierarchie.premieres_intersections(rayons, touches)
                })?,
                Concurrent::AnnexeEnum
                | Concurrent::AnnexeDyn
                | Concurrent::ParryListe
                | Concurrent::ParryArbre
                | Concurrent::Obvhs => {
                    let ecart = Ecart::entre(&ici, &self.reponses(*qui, pas));
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

    pub(crate) fn temps(&self, concurrents: &[Concurrent]) -> Result<Temps, Box<dyn Error>> {
        let (rayons, rayons_parry) = (&self.rayons, &self.rayons_parry);
        let pas = if self.objets.len() < 1000 { 1 } else { TUILES };
        let mut tampon = petit_tampon();
        let mut places = places(&self.objets);
        let hierarchie = Hierarchie::new(&self.objets, &mut places)?;
        let moindres = moindres(concurrents, |qui| match qui {
            Concurrent::LotListe => chronometrer_lot(rayons, &mut tampon, |rayons, touches| {
                premieres_intersections(&self.objets, rayons, touches)
            }),
            Concurrent::LotHierarchie => {
                chronometrer_lot(rayons, &mut tampon, |rayons, touches| {
                    hierarchie.premieres_intersections(rayons, touches)
                })
            }
            Concurrent::Liste => chronometrer(rayons, pas, |rayon| self.ici(rayon)),
            Concurrent::Hierarchie => {
                chronometrer(rayons, 1, |rayon| hierarchie.premiere_intersection(rayon))
            }
            Concurrent::AnnexeEnum => chronometrer(rayons, pas, |rayon| self.litteral(rayon)),
            Concurrent::AnnexeDyn => chronometrer(rayons, pas, |rayon| self.dynamique(rayon)),
            Concurrent::ParryListe => chronometrer(rayons_parry, pas, |rayon| self.liste(rayon)),
            Concurrent::ParryArbre => chronometrer(rayons_parry, 1, |rayon| self.arbre(rayon)),
            Concurrent::Obvhs => chronometrer(rayons_parry, 1, |rayon| self.obvhs(rayon)),
        });
        let mut temps = Temps([f64::NAN; 9]);
        for (qui, moindre) in concurrents.iter().zip(moindres) {
            temps.0[*qui as usize] = moindre;
        }
        Ok(temps)
    }
}

/// Places for a hierarchy over these objects.
pub(crate) fn places<R: Reel>(objets: &[ObjetRay<R>]) -> Vec<f32> {
    vec![0.0; Hierarchie::places(objets.len())]
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
        let tolerance = 3e4 * R::U.vers_f64();
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
