//! What everyone who competes beside us has in common: a scene of their own, and answers in one form.

use banc::concurrents::{Concurrent, Reponse};
use lancer_rayon::{ObjetRay, Rayon, Reel, Texture, Vecteur};

/// A scene as someone wants it.
pub(crate) trait Rival<R> {
    /// Who answers about the first hits of these rays, or about whether they are shadows.
    fn concurrents<'a>(&'a self, rayons: &'a [Rayon<R>], ombres: bool) -> Vec<Concurrent<'a>>;
}

/// Distance, normal, texture: an answer of others.
pub(crate) type Vu<R> = (R, Vecteur<R>, Texture);

pub(crate) fn dire<R: Reel>(vu: Option<Vu<R>>) -> Reponse {
    vu.map(|(t, n, texture)| {
        ([t, n.x, n.y, n.z, R::ZERO].map(|x| x.vers_f64().to_bits()), texture.0)
    })
}

/// The scalar that one of parry's two crates is made for.
pub(crate) trait Parry: Reel {
    /// What builds its trees.
    const ARBRES: [fn(&[ObjetRay<Self>]); 2];

    fn rival(objets: &[ObjetRay<Self>]) -> Box<dyn Rival<Self>>;
    /// The hit of one object.
    fn touche(objet: &ObjetRay<Self>, rayon: &Rayon<Self>) -> Option<Vu<Self>>;
}
