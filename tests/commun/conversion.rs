//! Between the type of a scene and f64.

use lancer_rayon::{Reel, Vecteur};

/// The same vector in f64, exactly.
pub(crate) fn large<R: Reel>(v: Vecteur<R>) -> Vecteur {
    Vecteur::new(v.x.vers_f64(), v.y.vers_f64(), v.z.vers_f64())
}

/// The nearest vector of a type.
pub(crate) fn arrondi<R: Reel>(v: Vecteur) -> Vecteur<R> {
    Vecteur::new(R::depuis_f64(v.x), R::depuis_f64(v.y), R::depuis_f64(v.z))
}
