//! Annex A to the letter once more, as a list of trait objects: how an object-oriented language
//! has it.

use lancer_rayon::{ObjetRay, Rayon, Reel, Texture, Vecteur};

use crate::pairs::Vu;
use commun::litteral::{self, Couple, Forme};

pub(crate) trait Objet<R> {
    fn intersection(&self, rayon: &Rayon<R>) -> Option<Vu<R>>;
}

struct Sphere<R>(Vecteur<R>, R, Texture);
struct Plan<R>(Vecteur<R>, R, Texture);
struct Boite<R>([Couple<R>; 3], Texture);

impl<R: Reel> Objet<R> for Sphere<R> {
    fn intersection(&self, rayon: &Rayon<R>) -> Option<Vu<R>> {
        litteral::sphere(self.0, self.1, rayon).map(|(t, n)| (t, n, self.2))
    }
}

impl<R: Reel> Objet<R> for Plan<R> {
    fn intersection(&self, rayon: &Rayon<R>) -> Option<Vu<R>> {
        litteral::plan(self.0, self.1, rayon).map(|t| (t, self.0, self.2))
    }
}

impl<R: Reel> Objet<R> for Boite<R> {
    fn intersection(&self, rayon: &Rayon<R>) -> Option<Vu<R>> {
        litteral::boite(&self.0, rayon).map(|(t, n)| (t, n, self.1))
    }
}

pub(crate) fn objet<R: Reel>(objet: &ObjetRay<R>) -> Box<dyn Objet<R>> {
    let litteral::Objet(forme, texture) = litteral::Objet::from(objet);
    match forme {
        Forme::Sphere(c, r) => Box::new(Sphere(c, r, texture)),
        Forme::Plan(p, d) => Box::new(Plan(p, d, texture)),
        Forme::Boite(couples) => Box::new(Boite(couples, texture)),
    }
}

pub(crate) fn premiere_intersection<R: Reel>(
    objets: &[Box<dyn Objet<R>>],
    rayon: &Rayon<R>,
) -> Option<Vu<R>> {
    let (mut premiere, mut t_premiere) = (None, R::INFINI);
    for objet in objets {
        if let Some(touche) = objet.intersection(rayon).filter(|(t, ..)| *t < t_premiere) {
            (premiere, t_premiere) = (Some(touche), touche.0);
        }
    }
    premiere
}
