//! Annex A to the letter, as an enum and once more as a list of trait objects, as an object-oriented language has it.

use banc::concurrents::{Camp, Concurrent, TROP};
use commun::litteral::{self, Forme, Objet};
use lancer_rayon::{ObjetRay, Rayon, Reel};

use crate::rival::{Rival, Vu, dire};

type Dynamique<R> = Box<dyn Fn(&Rayon<R>) -> Option<Vu<R>>>;

pub(crate) struct Annexe<R> {
    objets: Vec<Objet<R>>,
    dynamiques: Vec<Dynamique<R>>,
}

impl<R: Reel> Annexe<R> {
    pub(crate) fn new(objets: &[ObjetRay<R>]) -> Self {
        let dynamiques = objets.iter().map(|objet| dynamique(Objet::from(objet))).collect();
        Self { objets: objets.iter().map(Objet::from).collect(), dynamiques }
    }
}

fn dynamique<R: Reel>(Objet(forme, texture): Objet<R>) -> Dynamique<R> {
    match forme {
        Forme::Sphere(c, r) => {
            Box::new(move |rayon| litteral::sphere(c, r, rayon).map(|(t, n)| (t, n, texture)))
        }
        Forme::Plan(p, d) => {
            Box::new(move |rayon| litteral::plan(p, d, rayon).map(|t| (t, p, texture)))
        }
        Forme::Boite(couples) => {
            Box::new(move |rayon| litteral::boite(&couples, rayon).map(|(t, n)| (t, n, texture)))
        }
    }
}

fn premiere<R: Reel>(objets: &[Dynamique<R>], rayon: &Rayon<R>) -> Option<Vu<R>> {
    let (mut premiere, mut t_premiere) = (None, R::INFINI);
    for objet in objets {
        if let Some(touche) = objet(rayon).filter(|(t, ..)| *t < t_premiere) {
            (premiere, t_premiere) = (Some(touche), touche.0);
        }
    }
    premiere
}

impl<R: Reel> Rival<R> for Annexe<R> {
    fn concurrents<'a>(&'a self, rayons: &'a [Rayon<R>], ombres: bool) -> Vec<Concurrent<'a>> {
        if self.objets.len() > TROP || ombres {
            return Vec::new();
        }
        let enumeres = |rayon: &_| litteral::premiere_intersection(&self.objets, rayon);
        let dynamiques = |rayon: &_| premiere(&self.dynamiques, rayon);
        vec![
            Concurrent::un_par_un(("annex A, enum", Camp::Annexe), rayons, enumeres, dire),
            Concurrent::un_par_un(("annex A, dyn", Camp::Annexe), rayons, dynamiques, dire),
        ]
    }
}
