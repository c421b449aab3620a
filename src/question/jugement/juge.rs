//! The judge: whether and when a ray enters an object, within bounds. Its formulae are not those of
//! the search, and are the same for plain `f64` and for doubled numbers (`docs/preuves/objets.md`,
//! lemmas 17 and 18).

use crate::algebre::double::{Intervalle, Triple};
use crate::algebre::nombre::{max, min};
use crate::question::jugement::point::{Apercu, Point};
use crate::{Nombre, ObjetRay, Rayon, SphereRay, Vecteur};

/// How much a bound of `juger` grows, in u of itself: what it is off by, and the growing (lemma
/// 17).
pub const ECART_ARRONDI: f64 = 10.6;

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

/// The same at a closer look.
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

/// The judgement in doubled numbers. The bounds of the entry are those of [`coup_d_oeil`], to 8.6u
/// of `f64`.
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
