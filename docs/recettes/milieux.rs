//! Media one within the other, such as ice in water in a glass. Let them overlap where they meet, by more than
//! rounding: where several are, the one of the highest priority is, so that no film of air comes between.

use lancer_rayon::{ErreurGeo, Monde, ObjetRay, Rayon};

/// Of each object of the list: where several are, the higher priority counts.
#[derive(Debug, Clone, Copy)]
pub struct Milieu {
    pub priorite: u32,
    pub indice: f64,
}

/// Light, and the objects that it is in, in no order.
#[derive(Debug, Clone)]
pub struct Lumiere {
    pub rayon: Rayon,
    pub dans: Vec<usize>,
}

impl Lumiere {
    /// Goes on to the next face and through it, or is mirrored there; `false` if there is no other.
    pub fn avancer(&mut self, monde: &Monde<'_>, milieux: &[Milieu]) -> Result<bool, ErreurGeo> {
        let objets = monde.objets();
        // What has no way out was left already, unless it is a half-space, in which light may go down for ever.
        let sort = |i: usize| objets[i].sortie(&self.rayon);
        self.dans.retain(|&i| sort(i).is_ok() || matches!(objets[i], ObjetRay::Plan(_)));
        let entree = monde.parmi(|i| !self.dans.contains(&i)).premiere_intersection(&self.rayon);
        let entree = entree.map(|touche| (touche.indice(), touche)).ok();
        let sorties = self.dans.iter().filter_map(|&i| Some((i, sort(i).ok()?)));
        let plus_tot = entree
            .into_iter()
            .chain(sorties)
            .reduce(|a, b| if b.1.distance() < a.1.distance() { b } else { a });
        let Some((lequel, touche)) = plus_tot else { return Ok(false) };
        let mut apres = self.dans.clone();
        if let Some(ou) = apres.iter().position(|&i| i == lequel) {
            apres.swap_remove(ou);
        } else {
            apres.push(lequel);
        }
        let indice = |dans: &[usize]| {
            let premier = dans.iter().map(|&i| milieux[i]).max_by_key(|milieu| milieu.priorite);
            premier.map_or(1.0, |milieu| milieu.indice)
        };
        let (rapport, d) = (indice(&self.dans) / indice(&apres), self.rayon.direction());
        let droit_devant = rapport == 1.0;
        match if droit_devant { touche.secondaire(d) } else { touche.refracte(d, rapport) } {
            Ok(rayon) => (self.rayon, self.dans) = (rayon, apres),
            Err(_) => self.rayon = touche.reflechi(d)?,
        }
        Ok(true)
    }
}
