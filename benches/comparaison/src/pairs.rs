//! What is asked of parry.

use lancer_rayon::{ObjetRay, Rayon, Reel, Texture, Vecteur};

/// Distance, normal, texture. In these scenes each object has a texture of its own.
pub(crate) type Vu<R> = (R, Vecteur<R>, Texture);

/// The scalar that one of parry's two crates is made for.
pub(crate) trait Parry: Reel {
    type Objet;
    type Arbre;
    type Obvhs;
    type Rayon;
    fn objet(objet: &ObjetRay<Self>) -> Self::Objet;
    fn arbre(objets: &[ObjetRay<Self>]) -> Self::Arbre;
    fn obvhs(objets: &[ObjetRay<Self>]) -> Self::Obvhs;
    fn rayon(rayon: &Rayon<Self>) -> Self::Rayon;
    fn dans_la_liste(objets: &[Self::Objet], rayon: &Self::Rayon) -> Option<Vu<Self>>;
    fn dans_l_arbre(arbre: &Self::Arbre, rayon: &Self::Rayon) -> Option<Vu<Self>>;
    fn dans_obvhs(arbre: &Self::Obvhs, rayon: &Self::Rayon) -> Option<Vu<Self>>;
    fn ombre_dans_la_liste(objets: &[Self::Objet], rayon: &Self::Rayon, max: Self) -> bool;
    fn ombre_dans_l_arbre(arbre: &Self::Arbre, rayon: &Self::Rayon, max: Self) -> bool;
}
