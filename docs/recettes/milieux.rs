//! Light through media and past opaque things, one in another, overlapping or flush: ice in water, panes and voxels, a
//! glass on a table in mist. Bound the number of steps, since light may be trapped, as in a ball that it grazes from
//! within. A side that light grazes may bend it in a seam of turned tiles: let tiles of one medium overlap.

use std::ops::ControlFlow::Continue;

use lancer_rayon::{ErreurGeo, Intersection, Monde, ObjetRay, Rayon, Reel};

/// What an object is made of, by its index in the list. Where there are several, the higher priority counts. Objects
/// beyond the last medium are opaque.
#[derive(Debug, Clone, Copy)]
pub struct Milieu {
    pub priorite: u32,
    pub indice: f64,
}

/// The index of refraction of the medium that counts among these, at equal priority the last in the list; 1 if there is
/// none.
pub fn indice(milieux: &[Milieu], dans: &[usize]) -> f64 {
    let premier = dans.iter().max_by_key(|&&i| (milieux[i].priorite, i));
    premier.map_or(1.0, |&i| milieux[i].indice)
}

/// Light, and the objects that it is in, in any order. At first these are the `contenants` of its source.
#[derive(Debug, Clone)]
pub struct Lumiere<R = f64> {
    pub rayon: Rayon<R>,
    pub dans: Vec<usize>,
}

/// Where light arrives.
#[derive(Debug)]
pub enum Surface<R> {
    /// An opaque object, and how far light has come to it, since the distance of the hit itself may count from a face
    /// that is flush with the object. What the object sends back is in the same objects as before, also on its way to a
    /// lamp.
    Opaque(Intersection<R>, R),
    /// A face of a medium, and the objects that light is in behind the face. Where light leaves a medium, the
    /// `indice()` of the hit is 0, whatever the medium.
    Claire(Intersection<R>, Vec<usize>),
}

impl<R: Reel> Lumiere<R> {
    /// The next surface, if there is one. Faces that lie within rounding of each other are one surface, so that no film
    /// of air comes between flush media and an opaque thing is found through the glass that stands on it.
    pub fn surface(
        &mut self,
        monde: &Monde<'_, R>,
        milieux: &[Milieu],
    ) -> Result<Option<Surface<R>>, ErreurGeo> {
        let (objets, rayon, d) = (monde.objets(), self.rayon, self.rayon.direction());
        // An object without a way out was left beside an edge, unless it is a half-space, in which light may go down
        // for ever. Light does not leave anything where its ray ends.
        let sans_fin = rayon.jusqu_a(R::INFINI)?;
        let sort = |i: usize| objets[i].sortie(&sans_fin);
        let descend = |i: usize| match objets[i] {
            ObjetRay::Plan(plan) => plan.normale().produit_scalaire(d) <= R::ZERO,
            ObjetRay::Sphere(_) | ObjetRay::Boite(_) => false,
        };
        self.dans.retain(|&i| sort(i).is_ok() || descend(i));
        // The objects that light is in are left out here, so that no rounding makes it touch them at once; it may touch
        // others.
        let entree = monde.parmi(|i| !self.dans.contains(&i)).premiere_intersection(&rayon);
        let sorties = self.dans.iter().filter_map(|&i| sort(i).ok());
        let sorties = sorties.filter(|sortie| sortie.distance() < rayon.fin());
        let plus_tot = |a: Intersection<R>, b: Intersection<R>| {
            if b.distance() < a.distance() { b } else { a }
        };
        let Some(touche) = entree.into_iter().chain(sorties).reduce(plus_tot) else {
            return Ok(None);
        };
        let (opaque, n) = (|i: usize| i >= milieux.len(), touche.normale());
        let entre = d.produit_scalaire(n) < R::ZERO;
        if entre && opaque(touche.indice()) {
            return Ok(Some(Surface::Opaque(touche, touche.distance())));
        }
        // Light goes into what holds the place behind the face, deeper than the error of that place, and into what a
        // ray from the face comes to within that error, which may be a large thing that its own rounding sets apart
        // from the face.
        let devant = if entre { -n } else { n };
        let sonde = touche.secondaire(devant)?.dehors();
        let erreur = sonde.flou();
        let sonde = sonde.jusqu_a(erreur)?;
        let contre = monde.parmi(opaque).premiere_intersection(&sonde);
        if let Ok(contre) = contre
            && contre.normale().produit_scalaire(d) < R::ZERO
        {
            return Ok(Some(Surface::Opaque(contre, touche.distance())));
        }
        let mut apres = vec![];
        monde.contenants(touche.point() + devant * erreur, |i| apres.push(i));
        monde.visiter(&sonde, |i, _| {
            apres.push(i);
            Continue(erreur)
        });
        apres.sort_unstable();
        apres.dedup();
        apres.retain(|&i| !opaque(i));
        Ok(Some(Surface::Claire(touche, apres)))
    }

    /// Goes on to the next surface and through it, or is mirrored there; `false` where an opaque object stops the light
    /// or there is no other surface.
    pub fn avancer(&mut self, monde: &Monde<'_, R>, milieux: &[Milieu]) -> Result<bool, ErreurGeo> {
        let Some(Surface::Claire(touche, apres)) = self.surface(monde, milieux)? else {
            return Ok(false);
        };
        let rapport = indice(milieux, &self.dans) / indice(milieux, &apres);
        let d = self.rayon.direction();
        let droit_devant = rapport == 1.0;
        let passe = if droit_devant {
            touche.secondaire(d)
        } else {
            touche.refracte(d, R::depuis_f64(rapport))
        };
        let suite = match passe {
            Ok(rayon) => {
                self.dans = apres;
                rayon
            }
            Err(_) => touche.reflechi(d)?,
        };
        // `dans` tells what light is in, and questions leave that out; the light may touch anything else at once.
        self.rayon = suite.dehors();
        Ok(true)
    }
}
