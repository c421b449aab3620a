//! A tree that lives in a program, over objects that move from picture to picture.

use std::error::Error;

use lancer_rayon::{Monde, ObjetGeo, ObjetRay, Rayon, Reponse, places};

#[derive(Default)]
pub struct Animation {
    objets: Vec<ObjetRay>,
    /// Scratch memory of the tree.
    places: Vec<f32>,
}

impl Animation {
    /// Takes the objects of the next picture.
    pub fn placer(&mut self, decrits: &[ObjetGeo]) {
        self.objets.clear();
        self.objets.extend(decrits.iter().map(|objet| objet.vers_ray()));
        self.places.resize(places(self.objets.len()), 0.0);
    }

    /// What these rays touch.
    pub fn image(
        &mut self,
        rayons: &[Rayon],
        touches: &mut [Reponse],
    ) -> Result<(), Box<dyn Error>> {
        let Self { objets, places } = self;
        Ok(Monde::new(objets, places)?.premieres_intersections(rayons, touches)?)
    }
}
