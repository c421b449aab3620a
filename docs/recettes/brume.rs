//! A scattering medium: the walk of light, or of a neutron, through a convex object.

use lancer_rayon::{ErreurGeo, ObjetRay, Rayon, Vecteur};

/// The way that a ray from within `milieu` goes until it leaves, scattered evenly after steps of this mean length.
/// `hasard` gives numbers from 0 up to 1.
pub fn chemin(
    milieu: &ObjetRay,
    mut rayon: Rayon,
    pas_moyen: f64,
    mut hasard: impl FnMut() -> f64,
) -> Result<f64, ErreurGeo> {
    let mut chemin = 0.0;
    loop {
        let pas = -(1.0 - hasard()).ln() * pas_moyen;
        // A ray without a way out is outside already, since its step ended on the surface.
        let Ok(sortie) = milieu.sortie(&rayon) else { return Ok(chemin) };
        if pas >= sortie.distance() {
            return Ok(chemin + sortie.distance());
        }
        let (z, angle) = (2.0 * hasard() - 1.0, std::f64::consts::TAU * hasard());
        let r = (1.0 - z * z).sqrt();
        rayon = rayon.bifurque(pas, Vecteur::new(r * angle.cos(), r * angle.sin(), z))?;
        chemin += pas;
    }
}
