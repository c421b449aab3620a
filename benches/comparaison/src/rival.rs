//! What all competitors beside us have in common: a scene of their own, and answers in one form.

use banc::concurrents::{Concurrent, Reponse};
use lancer_rayon::{ObjetRay, Rayon, Reel, Texture, Vecteur};

/// A scene as someone wants it.
pub(crate) trait Rival<R> {
    /// The competitors that answer for the first hits of these rays, or whether they are shadows.
    fn concurrents<'a>(&'a self, rayons: &'a [Rayon<R>], ombres: bool) -> Vec<Concurrent<'a>>;
}

/// An answer of others: distance, normal and texture.
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
