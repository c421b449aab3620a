//! The batch and the hierarchy with other instructions, for tests and measurements.

use fearless_simd::Level;

use crate::hierarchie::{Hierarchie, SEUIL_LOT};
use crate::lot::bloc::Bloc;
use crate::niveau::meilleur_niveau;
use crate::objet::ObjetRay;
use crate::rayon::Rayon;
use crate::reel::Reel;

/// Which instructions are taken: no answer depends on it.
#[doc(hidden)]
#[derive(Debug, Clone, Copy)]
pub struct Reglage {
    niveau: Level,
}

impl Reglage {
    /// Up to so many spheres and boxes the batch of a hierarchy is that of the list, in `f64` up to half as
    /// many.
    pub const SEUIL_LOT: usize = 2 * SEUIL_LOT;

    /// Each instruction set of this machine, the best first, by name.
    pub fn tous() -> impl Iterator<Item = (&'static str, Self)> {
        let niveau = meilleur_niveau();
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        let niveaux = [
            ("AVX-512", niveau.as_avx512().map(Level::Avx512)),
            ("AVX2", niveau.as_avx2().map(Level::Avx2)),
            ("SSE2", niveau.as_sse2().map(Level::Sse2)),
        ];
        #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
        let niveaux = [("the only one", Some(niveau))];
        niveaux.into_iter().filter_map(|(nom, niveau)| Some((nom, Self { niveau: niveau? })))
    }

    /// Whether the beam of these shadow rays, one to sixty-four, up to their lamps leaves out a ball
    /// around this object, or that of the rays if a lamp is infinitely far. No answer tells.
    pub fn evite<R: Reel>(ombres: &[(Rayon<R>, R)], objet: &ObjetRay<R>) -> bool {
        let mut bloc = Bloc::sans(None);
        bloc.charger(ombres);
        bloc.faisceau().is_some_and(|faisceau| faisceau.ecart_a(objet.boule()) > R::ZERO)
    }

    /// These objects as a hierarchy that asks its list, however long, with these instructions.
    pub fn liste<R: Reel>(self, objets: &[ObjetRay<R>]) -> Hierarchie<'_, R> {
        Hierarchie { objets, arbre: None, sauf: None, niveau: self.niveau }
    }

    /// How many nodes the tree of this hierarchy has; 0 if it has none and asks its list.
    pub fn noeuds<R: Reel>(hierarchie: &Hierarchie<'_, R>) -> usize {
        hierarchie.noeuds()
    }

    /// The same hierarchy with these instructions.
    pub fn hierarchie<R: Reel>(self, mut hierarchie: Hierarchie<'_, R>) -> Hierarchie<'_, R> {
        hierarchie.niveau = self.niveau;
        hierarchie
    }
}
