//! Many rays at once: a picture of 600 × 400 pixels is 240,000 of them.
//!
//! A **group** of 16 rays goes side by side through the formulae of a shape (`lot/groupe.rs`). A **block** of 64
//! rays, a tile of 8 × 8 pixels, takes an object at a time (`lot/bloc.rs`): of a list every object, of a
//! hierarchy those whose boxes its beam crosses (`lot/faisceau.rs`).

pub(crate) mod bloc;
pub(crate) mod demande;
pub(crate) mod faisceau;
pub(crate) mod groupe;

use core::fmt;

/// There are more or fewer places for answers than rays.
///
/// ```
/// use lancer_rayon::{LongueursDifferentes, NoIntersection, Rayon, premieres_intersections};
///
/// let rayons: [Rayon; 0] = [];
/// let mut touches = [Err(NoIntersection); 3];
/// let refus = premieres_intersections(&[], &rayons, &mut touches);
/// assert_eq!(refus, Err(LongueursDifferentes { rayons: 0, reponses: 3 }));
/// ```
#[doc(alias = "length_mismatch")]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct LongueursDifferentes {
    /// How many rays.
    #[doc(alias = "rays")]
    pub rayons: usize,
    /// Places for how many answers.
    #[doc(alias = "answers")]
    pub reponses: usize,
}

impl fmt::Display for LongueursDifferentes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} rays, but places for {} answers", self.rayons, self.reponses)
    }
}

impl core::error::Error for LongueursDifferentes {}
