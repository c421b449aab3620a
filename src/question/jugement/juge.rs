//! The judge: whether and when a ray enters an object, within bounds. Its formulae are not those of
//! the search, and are the same for plain `f64` and for doubled numbers. These are its steps, which
//! lemmas 17 and 18 of `docs/preuves/objets.md` prove. Letters are those of `docs/precision.md`.
//!
//! ```text
//! Judgement of t, in intervals: of doubled numbers (lemma 16), or at a glance by G1 and G2, with
//! X=S
//! J1  of each face: e, the height of S;  e_X, that of X=S+tD;  v, how fast the ray descends
//!     towards it
//! J2  counted from X, E is the largest e_X/v over faces with v>0, F the least over those with v<0
//! J3  v of unknown sign, |v|≤v₊: E≤e_X/v₊ and F≥−e_X/v₊ if S and X are on the face or under it;
//!     if not, J4 knows of no entry, nor that S is above no face;  if both are above, E≥e_X/v₊.
//!     v≤0: a miss if S is above
//! J4  the ray enters at t′=t+E if S is above a face with v>0 and E<F, not if S is above no such
//!     face or E>F, each for all numbers in the intervals
//! J5  sphere: p_X=CX·CX−r² and XA=−(CX·D), at S, at X and at the rounded A=S+D·(SA/D²), where
//!     −D²·p_A≤AB²≤−D²·p_A+2XA²+η, without η if XA=0
//! J6  the ray enters if p_S, SA, AB²>0, not if one is 0 or less;  t′−t=p_X/(XA+AB) if XA>0, else
//!     at most (AB+|XA|)/D² in size
//! J7  erreur=(|t−t′|·max(1, |D|)+t·||D|−1|)(1+16.1u)+2η, or +∞ unless the ray certainly enters;
//!     in f32 t′ is that of a glance if this leaves less than u·t/64 open
//! J8  t′ lies from t plus the least t′−t to t plus the greatest.  Each t′−t is moved outward by
//!     10.6u of itself and η, each sum by 2u of itself, and a sum below 0 is 0.  t is that of the
//!     search in f64, at a miss max(SC·D, 0), and then t+F
//! J9  a way out is judged as an entry of the ray S+2tD, −D at its own t, without a glance;  erreur
//!     is +∞ also unless |t−t′|<t/2
//!
//! A glance, in f64, with μ=7.1u(‖f‖₁+|t|)+2⁻¹⁰²²
//! G1  heights to μ+2.1u·l, XA to μ, speeds to 4.1u
//! G2  p_X to 21.1u(CX·CX+r²)+μ²/16u
//! G3  a hit is certain if the later end of J8 is a number of the type and before the end of the
//!     ray
//! G4  certifie is true if the first hit, where there is one, is certain at a glance or else in
//!     doubled numbers, and if all other objects that O2 lets pass are entered after its later end,
//!     at a glance or else with both in doubled numbers.  The tree is walked to that end times
//!     1+2u, rounded to the scene's type, at least η.  est_certain is certifie of a list of one
//! ```

use crate::algebre::arrondis::ECART_ARRONDI;
use crate::algebre::double::{Intervalle, Triple};
use crate::algebre::nombre::{max, min};
use crate::question::jugement::point::{Apercu, Point};
use crate::{Nombre, ObjetRay, Rayon, SphereRay, Vecteur};

/// Where a ray starts, and a point of it, from which the judgement counts.
#[derive(Clone, Copy)]
pub(crate) struct Lieux {
    pub(crate) depart: f64,
    pub(crate) t: f64,
}

/// Bounds on how much farther than the point the ray enters the object, +∞ if it does not, and the
/// most by which it leaves it farther.
pub(crate) struct Passage {
    pub(crate) entree: Intervalle,
    sortie: f64,
}

impl Passage {
    const JAMAIS: Self = Self { entree: Intervalle::de(f64::INFINI), sortie: f64::INFINI };
}

/// The distances between which the ray enters the object, if it does, at a glance. The later one is
/// +∞ unless it certainly enters, and the earlier one if it certainly never does.
#[inline(always)]
pub fn coup_d_oeil(objet: &ObjetRay, rayon: &Rayon) -> Intervalle {
    apres(0.0, juger_avec::<Apercu>(objet, rayon, Lieux { depart: 0.0, t: 0.0 }).entree)
}

/// What [`coup_d_oeil`] tells, in doubled numbers.
pub(crate) fn loupe(objet: &ObjetRay, rayon: &Rayon) -> Intervalle {
    let en = |t: f64| {
        let Passage { entree, sortie } = juger(objet, rayon, Lieux { depart: 0.0, t });
        (apres(t, entree), t + sortie)
    };
    let t = objet.t(rayon);
    if t < f64::INFINI {
        return en(t).0;
    }
    // A miss is judged where the ray is nearest to the centre. Beside an edge, where the ray leaves
    // one face at about the place where it enters another, that may decide nothing, and the miss is
    // judged where the ray leaves.
    let pres = (objet.boule().centre - rayon.source()).produit_scalaire(rayon.direction());
    let (entree, sortie) = en(max(pres, 0.0));
    let decide = entree.haut < f64::INFINI || entree.bas == f64::INFINI;
    if decide || sortie == f64::INFINI { entree } else { en(sortie).0 }
}

/// These numbers, counted from t, rounded outward.
#[inline(always)]
fn apres(t: f64, Intervalle { bas, haut }: Intervalle) -> Intervalle {
    // J8: every bound moves outward by what it may be off by.
    let [moins, plus] = [-1.0, 1.0].map(|signe| 1.0 + signe * (ECART_ARRONDI * f64::U));
    let bas = bas * if bas > 0.0 { moins } else { plus } - f64::ETA;
    let haut = haut * if haut > 0.0 { plus } else { moins } + f64::ETA;
    let (bas, haut) = ((t + bas) * (1.0 - 2.0 * f64::U), (t + haut) * (1.0 + 2.0 * f64::U));
    Intervalle { bas: max(bas, 0.0), haut }
}

/// The judgement in doubled numbers. Its bounds mean what those of a glance mean, and are off by
/// 8.6u of `f64`.
pub(crate) fn juger(objet: &ObjetRay, rayon: &Rayon, lieux: Lieux) -> Passage {
    juger_avec::<Triple>(objet, rayon, lieux)
}

#[inline(always)]
fn juger_avec<P: Point>(objet: &ObjetRay, rayon: &Rayon, lieux: Lieux) -> Passage {
    match objet {
        ObjetRay::Sphere(sphere) => juger_sphere::<P>(sphere, rayon, lieux),
        ObjetRay::Plan(plan) => {
            let face = |_| (plan.normale(), -plan.distance());
            juger_faces::<P, 1, 1>(Vecteur::NUL, face, rayon, lieux)
        }
        ObjetRay::Boite(boite) => {
            juger_faces::<P, 3, 2>(boite.centre(), |axe| boite.paire(axe), rayon, lieux)
        }
    }
}

/// Judges a solid that planes bound, with `PAR_AXE` faces across each of `AXES` axes: one across
/// one for a half-space, two across each of three for a box. `face` has for each axis a unit vector
/// and how far along it from the centre c its face stands; the second face stands as far the other
/// way.
#[inline(always)]
fn juger_faces<P: Point, const AXES: usize, const PAR_AXE: usize>(
    c: Vecteur,
    face: impl Fn(usize) -> (Vecteur, f64),
    rayon: &Rayon,
    Lieux { depart, t }: Lieux,
) -> Passage {
    let (depart, point) = (P::depuis(c, rayon, depart), P::depuis(c, rayon, t));
    let jamais = Intervalle::de(f64::INFINI);
    let toujours = Intervalle::de(-f64::INFINI);
    let mut sejour = Sejour { dessus: toujours, entree: toujours, sortie: jamais };
    // J1: the ray is inside a box while it is inside all of its faces.
    for axe in 0..AXES {
        let (n, l) = face(axe);
        let ([d, d_oppose], [p, p_oppose]) = (depart.hauteurs(n, l), point.hauteurs(n, l));
        let vitesse = P::vitesse(n, rayon.direction());
        let exclu = sejour.borner(d, p, vitesse.oppose());
        if exclu || (PAR_AXE > 1 && sejour.borner(d_oppose, p_oppose, vitesse)) {
            return Passage::JAMAIS;
        }
    }
    let Sejour { dessus, entree, sortie } = sejour;
    // J4: it enters if it starts above a face and is in the last before it leaves the first.
    let entre = if dessus.haut <= 0.0 || entree.bas > sortie.haut {
        jamais
    } else if dessus.bas > 0.0 && entree.haut < sortie.bas {
        entree
    } else {
        Intervalle { haut: f64::INFINI, ..entree }
    };
    Passage { entree: entre, sortie: sortie.haut }
}

/// How long a ray is inside all faces so far.
struct Sejour {
    /// How high it starts over the highest of those by which it enters.
    dessus: Intervalle,
    /// When it enters by the last, counted from the point.
    entree: Intervalle,
    /// When it leaves by the first.
    sortie: Intervalle,
}

impl Sejour {
    /// Takes in a face, from the heights of the start and of the point over it and the speed at
    /// which the ray descends; returns whether that excludes an entry.
    #[inline(always)]
    fn borner(&mut self, depart: Intervalle, point: Intervalle, descente: Intervalle) -> bool {
        let Self { dessus, entree, sortie } = self;
        if descente.bas > 0.0 {
            // J2. Quotients are rounded, and compared by < alone.
            *entree = entree.plus_grand(point.sur(descente));
            *dessus = dessus.plus_grand(depart);
        } else if depart.bas > 0.0 && descente.haut <= 0.0 {
            // J3. Above a face that the ray does not come nearer to.
            return true;
        } else if descente.haut < 0.0 {
            *sortie = sortie.moindre(point.oppose().sur(descente.oppose()));
        } else {
            // Parallel, or nearly so. Exactly parallel, the point is as high as the start.
            let vite = descente.grandeur();
            let point = if vite == 0.0 { depart } else { point };
            if depart.haut <= 0.0 && point.haut <= 0.0 {
                // The ray has been under the face for so long at least, and will be. In the plane
                // of the face, exactly, 0/0 excludes nothing.
                let loin = point.haut / vite;
                (entree.haut, sortie.bas) = (max(loin, entree.haut), min(-loin, sortie.bas));
            } else {
                // It comes under the face no sooner than this, if ever, or nothing is known.
                // Another face may still exclude an entry.
                if depart.bas > 0.0 && point.bas > 0.0 {
                    entree.bas = max(point.bas / vite, entree.bas);
                }
                entree.haut = f64::INFINI;
                // By a face along which it goes it does not enter.
                if vite > 0.0 {
                    dessus.haut = f64::INFINI;
                }
            }
        }
        false
    }
}

/// Judges a sphere.
#[inline(always)]
fn juger_sphere<P: Point>(
    sphere: &SphereRay,
    rayon: &Rayon,
    Lieux { depart, t }: Lieux,
) -> Passage {
    // p_X and XA, at the point X of the ray at this distance (J5).
    let d = rayon.direction();
    let en = |t| {
        let x = P::depuis(sphere.centre(), rayon, t);
        let [_, xa] = x.hauteurs(d, 0.0);
        (x.puissance(sphere.rayon()), xa)
    };
    let (d2, (p_s, sa)) = (d.longueur_carree(), en(depart));
    let (p_a, xa_a) = en(depart + (sa.bas + sa.haut) / (d2 + d2));
    // AB²·D² is D²(r² − PC²) + PA² at any point P of the line. At A as computed PA is all rounding:
    // its square is taken twice, so that it is a bound, and never as 0 unless PA is.
    let xa_a = xa_a.grandeur();
    let carre = 2.0 * xa_a * xa_a + if xa_a > 0.0 { f64::ETA } else { 0.0 };
    let ab2 = Intervalle { bas: -p_a.haut * d2, haut: carre - p_a.bas * d2 };
    // J6: without one of the three above 0 there is no entry.
    let moindre = p_s.moindre(sa).moindre(ab2);
    if moindre.haut <= 0.0 {
        return Passage::JAMAIS;
    }
    let (p, xa) = en(t);
    let [ab_bas, ab_haut] = [ab2.bas, ab2.haut].map(|x| max(x, 0.0).racine());
    let avance = if xa.bas > 0.0 {
        p.sur(Intervalle { bas: xa.bas + ab_bas, haut: xa.haut + ab_haut })
    } else {
        Intervalle::autour(0.0, (ab_haut + xa.grandeur()) / d2)
    };
    let haut = if moindre.bas > 0.0 { avance.haut } else { f64::INFINI };
    Passage { entree: Intervalle { haut, ..avance }, ..Passage::JAMAIS }
}
