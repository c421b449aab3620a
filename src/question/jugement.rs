//! What is judged after the fact: how far a distance is off, and whether an answer is certainly
//! that of exact arithmetic on the numbers as they are stored.
//!
//! There is one judge (`juge.rs`). At a glance, in plain `f64`, nearly every ray is clear; what
//! that leaves open is judged again in doubled numbers.

pub(crate) mod certificat;
pub(crate) mod juge;
pub(crate) mod point;

use core::slice::from_ref;

use crate::algebre::arrondis::ERREUR_ARRONDIE;
use crate::algebre::double::{Double, scalaire, triple};
use crate::algebre::nombre::{est_double, fois_u};
use crate::question::jugement::certificat::Certificat;
use crate::question::jugement::juge::{Lieux, coup_d_oeil, juger};
use crate::question::liste::Liste;
use crate::question::{Abord, Question};
use crate::{Intersection, Nombre, ObjetRay, Rayon};

/// [`ObjetRay::erreur`] trusts a glance that leaves no more than this part of u·t open: doubled
/// numbers would give about the same bound.
const NET: f64 = 1.0 / 64.0;

impl<R: Nombre> ObjetRay<R> {
    /// A bound on the error of [`touche.distance()`](Intersection::distance), in scene units: the
    /// true entry, or at a [way out](Self::sortie) the true exit, is no farther than that from it,
    /// for the numbers as they are stored.
    ///
    /// The bound is proven (`docs/preuves/objets.md`, lemma 17), also at the edges of a box, and
    /// includes the rounding of its own computation. Ask the object that was hit, with the ray of
    /// the hit. The bound rests on t alone, not on how t was found: it is the error itself, as
    /// found with numbers of twice the length of an `f64`, and what D lacks to length 1 over that
    /// distance. In the median of every regime in `benches/erreurs.md` it is at most 1.01 times the
    /// error. It takes many times as long as the hit.
    ///
    /// It is never a NaN. It is +∞ where the ray does not enter or leave the object, where the
    /// doubled numbers cannot tell at t whether it does, for a hit at once, at t = 0, unless exact
    /// arithmetic has the source outside, and at a way out that is off by half of t or more.
    ///
    /// The same bound holds for t in lengths of D: it is no less than |t − t′|, where the ray
    /// crosses the surface at S + t′D. After [`Rayon::temoin_f64`] D is unit to the rounding of
    /// `f32` only, and the bound covers that; for digits in scene units make D unit again, by
    /// [`Rayon::new`] of the same source and direction.
    ///
    /// ```
    /// use lancer_rayon::{ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = SphereGeo::<f32>::new(Vecteur::new(0.0, 0.0, -5.0), 1.0, Texture(0))?;
    /// let boule = ObjetRay::from(boule);
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.1, 0.05, -1.0))?;
    /// let touche = boule.intersection(&rayon)?;
    ///
    /// let erreur = boule.erreur(&rayon, &touche);
    /// let exacte = boule.temoin_f64().intersection(&rayon.temoin_f64())?.distance();
    /// assert!((f64::from(touche.distance()) - exacte).abs() <= erreur.into());
    /// assert!(erreur < 2e-6);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("error_bound", "distance_error"))]
    #[must_use]
    pub fn erreur(&self, rayon: &Rayon<R>, touche: &Intersection<R>) -> R {
        let sort = touche.normale().produit_scalaire(rayon.direction()) > R::ZERO;
        let t = touche.distance();
        let (objet, rayon, en_f64) = (self.temoin_f64(), rayon.temoin_f64(), t.vers_f64());
        // A glance is for entries, and never leaves so little of a distance in `f64` open.
        let rapide = !est_double::<R>() && !sort;
        let vue = rapide.then(|| coup_d_oeil(&objet, &rayon));
        let nette = vue.filter(|vue| vue.haut - vue.bas <= en_f64 * (R::U.vers_f64() * NET));
        let ecart = if let Some(vue) = nette {
            (vue.haut - en_f64).max(en_f64 - vue.bas)
        } else if sort {
            // J9: the ray that comes back, from as far beyond, enters there.
            let retour = Rayon::sans_fin(rayon.source(), -rayon.direction());
            let lieux = Lieux { depart: -2.0 * en_f64, t: -en_f64 };
            let ecart = juger(&objet, &retour, lieux).entree.grandeur();
            if ecart < 0.5 * en_f64 { ecart } else { f64::INFINI }
        } else {
            juger(&objet, &rayon, Lieux { depart: 0.0, t: en_f64 }).entree.grandeur()
        };
        // J7: t counts in lengths of D.
        let d = rayon.direction();
        let exces = scalaire(triple(d), triple(d)).plus(Double::de(-1.0)).bornes().grandeur();
        let longueur = d.longueur();
        let de_d = en_f64 * (exces / (1.0 + longueur));
        let erreur = R::depuis_f64(ecart * longueur.max(1.0) + de_d);
        erreur + erreur * fois_u(ERREUR_ARRONDIE) + (R::ETA + R::ETA)
    }

    /// Whether the answer of [`intersection`](Self::intersection), a hit or a miss, is certainly
    /// that of exact arithmetic on the numbers as they are stored.
    ///
    /// It is never true of a wrong answer (lemma 17). It judges the source as it stands: a hit at
    /// once, by δ, is not certain, and what δ might let the ray touch does not count. It may be
    /// false of a right one: within some 2⁻¹⁰⁰|S − C| of a face or 2⁻¹⁰⁰|S − C|²/r of the outline
    /// of a sphere, for boxes thinner than 2⁻¹⁰⁰|S − C|, for directions within some 2⁻¹⁰⁰ of the
    /// plane of a turned face, where products leave the normal numbers of `f64`, for hits whose
    /// distance the type can hardly hold, and for entries within rounding of the end of the ray.
    /// [`Monde::certifie`](crate::Monde::certifie) judges a list.
    ///
    /// ```
    /// use lancer_rayon::{ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = ObjetRay::from(SphereGeo::new(Vecteur::new(0.0, 0.0, -5.0), 1.0, Texture(0))?);
    /// let vers_le_fond = |x| Rayon::new(Vecteur::new(x, 0.0, 0.0), Vecteur::new(0.0, 0.0, -1.0));
    /// assert!(boule.est_certain(&vers_le_fond(0.5)?)); // a hit
    /// assert!(boule.est_certain(&vers_le_fond(1.5)?)); // a miss
    /// assert!(boule.est_certain(&vers_le_fond(1.0)?)); // a tangent, exactly
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("is_certain", "is_robust"))]
    #[must_use]
    pub fn est_certain(&self, rayon: &Rayon<R>) -> bool {
        let liste = Liste::entiere(from_ref(self));
        Certificat::new(&liste, rayon, &self.intersection(rayon))
            .is_some_and(|mut certificat| certificat.voir(rayon, self, 0, Abord::Inconnu).is_none())
    }
}
