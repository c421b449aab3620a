//! A closer look: whether and when a ray enters an object, in doubled numbers (`docs/preuves.md`,
//! lemma 17). No formula is that of the search.

use crate::algebre::double::{Double, Intervalle, Triple, scalaire, triple};
use crate::algebre::nombre::Nombre;
use crate::algebre::vecteur::Vecteur;
use crate::objet::ObjetRay;
use crate::objet::sphere::SphereRay;
use crate::rayon::Rayon;

/// How much the bound of a `Jugement` grows, in u of itself: what it is off by, and the growing
/// (lemma 17).
pub const ECART_ARRONDI: f64 = 10.6;

/// What exact numbers say of a ray, an object and a distance.
pub(crate) struct Jugement {
    /// Whether the ray enters the object, if that is certain.
    pub(crate) entre: Option<bool>,
    /// If it enters: no less than how far the distance is from that of the entry, to 8.6u of `f64`.
    pub(crate) ecart: f64,
}

/// The distances between which the ray enters the object, if it does. The later one is +∞ unless it
/// certainly enters, and the earlier one if it certainly never does.
pub(crate) fn loupe(objet: &ObjetRay, rayon: &Rayon) -> Intervalle {
    let t = objet.t(rayon);
    let Jugement { entre, ecart } = juger(objet, rayon, t);
    match entre {
        Some(true) if t < f64::INFINI => {
            let ecart = ecart + ecart * (ECART_ARRONDI * f64::U);
            Intervalle { bas: (t - ecart).next_down(), haut: (t + ecart).next_up() }
        }
        Some(false) => Intervalle::JAMAIS,
        // If it enters where the search saw nothing, the distance says nothing.
        Some(true) | None => Intervalle::INCONNU,
    }
}

/// What exact numbers say of a ray and a distance; for a miss the distance is +∞.
pub(crate) fn juger(objet: &ObjetRay, rayon: &Rayon, t: f64) -> Jugement {
    juger_depuis(objet, rayon, [0.0, t])
}

/// What exact numbers say of a way out at this distance: the ray that comes back, from as far
/// beyond, enters there.
pub(crate) fn juger_sortie(objet: &ObjetRay, rayon: &Rayon, t: f64) -> Jugement {
    // J9
    let retour = Rayon::sans_fin(rayon.source(), -rayon.direction());
    let Jugement { entre, ecart } = juger_depuis(objet, &retour, [-2.0 * t, -t]);
    Jugement { entre: entre.filter(|_| ecart < 0.5 * t), ecart }
}

/// Where a ray starts, and a point of it: two distances along it.
type Lieux = [f64; 2];

fn juger_depuis(objet: &ObjetRay, rayon: &Rayon, lieux: Lieux) -> Jugement {
    match objet {
        ObjetRay::Sphere(sphere) => juger_sphere(sphere, rayon, lieux),
        ObjetRay::Plan(plan) => {
            juger_faces((Vecteur::NUL, 1, &[(plan.normale(), -plan.distance())]), rayon, lieux)
        }
        ObjetRay::Boite(boite) => {
            let ([u, v, w], [a, b, c]) = (boite.normales(), boite.demi_longueurs());
            juger_faces((boite.centre(), 2, &[(u, a), (v, b), (w, c)]), rayon, lieux)
        }
    }
}

/// The centre c of a solid; how many faces stand across each axis, one or two; and for each axis a
/// unit vector and how far along it from c its face stands. The second stands as far the other way.
type Faces<'a> = (Vecteur, usize, &'a [(Vecteur, f64)]);

/// What exact numbers say of a ray, a distance and the solid inside all of these faces.
fn juger_faces(faces: Faces<'_>, rayon: &Rayon, [depart, t]: Lieux) -> Jugement {
    let a = |t| juger_faces_a(faces, rayon, [depart, t]);
    if t < f64::INFINI {
        return a(t).0;
    }
    // A miss is judged where the ray is nearest to the centre. Beside an edge, where the ray leaves
    // one face at about the place where it enters another, that may decide nothing, and the miss is
    // judged where the ray leaves.
    let pres = (faces.0 - rayon.source()).produit_scalaire(rayon.direction());
    let (jugement, sortie) = a(pres);
    if jugement.entre.is_some() {
        return jugement;
    }
    a(pres + sortie).0
}

/// [`juger_faces`] at any distance, and about how long after it the ray leaves the solid.
fn juger_faces_a((c, cotes, axes): Faces<'_>, rayon: &Rayon, lieux: Lieux) -> (Jugement, f64) {
    let [depart, point] = lieux.map(|t| depuis(c, rayon, t));
    let direction = triple(rayon.direction());
    // How long the ray has been inside the last face that it entered, and will be inside the first
    // that it leaves.
    let [mut entree, mut sortie] = [Intervalle { bas: f64::INFINI, haut: f64::INFINI }; 2];
    let (mut dehors, mut dedans) = (false, true);
    // J1
    let faces = axes.iter().flat_map(|&(n, l)| {
        let en_face = [depart, point, direction].map(|x| scalaire(triple(n), x));
        [en_face.map(Double::oppose), en_face].into_iter().take(cotes).map(move |x| (x, l))
    });
    for ([sous_depart, sous_point, vitesse], l) in faces {
        let [sous_depart, sous_point] =
            [sous_depart, sous_point].map(|x| x.plus(Double::de(l)).bornes());
        let vitesse = vitesse.bornes();
        let (lent, vite) = (vitesse.bas.max(-vitesse.haut), vitesse.grandeur());
        // J3. Above a face that the ray does not come nearer to.
        if sous_depart.haut < 0.0 && vitesse.haut <= 0.0 {
            return (Jugement { entre: Some(false), ecart: f64::INFINI }, f64::INFINI);
        }
        if vite == 0.0 {
            // Parallel: in the plane or below nothing is excluded.
            if sous_depart.bas < 0.0 {
                entree.bas = -f64::INFINI;
            }
        } else if lent <= 0.0 {
            // Nearly parallel: whether the ray comes nearer to the face or leaves it is unknown.
            let loin = sous_point.sur(vite, vite);
            if sous_depart.bas >= 0.0 && sous_point.bas > 0.0 {
                // It has been under the face for so long at least, and will be.
                entree.bas = entree.bas.min(loin.bas);
                sortie.bas = sortie.bas.min(loin.bas);
            } else {
                // If the ray is above the face at both places, it comes under the face no sooner
                // than this, if ever. Otherwise this face decides nothing, though another may still
                // exclude an entry.
                let au_dessus = sous_depart.haut < 0.0 && sous_point.haut < 0.0;
                let tard = if au_dessus { loin.haut } else { f64::INFINI };
                entree = Intervalle { bas: -f64::INFINI, haut: entree.haut.min(tard) };
                dedans = false;
            }
        } else {
            // J2
            let duree = if vitesse.bas > 0.0 { &mut entree } else { &mut sortie };
            *duree = duree.moindre(sous_point.sur(lent, vite));
            dehors |= vitesse.bas > 0.0 && sous_depart.haut < 0.0;
            dedans &= vitesse.bas < 0.0 || sous_depart.bas >= 0.0;
        }
    }
    // J4
    let touche = dehors && entree.bas + sortie.bas >= 0.0;
    let manque = dedans || entree.haut + sortie.haut < 0.0;
    let entre = (touche || manque).then_some(touche);
    (Jugement { entre, ecart: entree.grandeur() }, sortie.haut)
}

/// S + tD − C.
fn depuis(centre: Vecteur, rayon: &Rayon, t: f64) -> Triple {
    let [s, d, c] = [rayon.source(), rayon.direction(), -centre].map(triple);
    [0, 1, 2].map(|i| s[i].plus(c[i]).plus(d[i].fois(Double::de(t))))
}

/// What exact numbers say of a ray, a sphere and a distance.
fn juger_sphere(sphere: &SphereRay, rayon: &Rayon, [depart, t]: Lieux) -> Jugement {
    // p_X and XA, at the point X of the ray at this distance (J5).
    let r2 = Double::de(sphere.rayon()).fois(Double::de(-sphere.rayon()));
    let en = |t| {
        let cx = depuis(sphere.centre(), rayon, t);
        let xa = scalaire(cx, triple(-rayon.direction()));
        (scalaire(cx, cx).plus(r2).bornes(), xa.bornes())
    };
    let d2 = rayon.direction().longueur_carree();
    let a = (sphere.centre() - rayon.source()).produit_scalaire(rayon.direction()) / d2;
    let ((p_s, xa_s), (p_a, xa_a), (p, xa)) = (en(depart), en(a), en(t));
    // AB²·D² is D²(r² − PC²) + PA² at any point P of the line. At A as computed PA is all rounding:
    // its square is taken twice, so that it is a bound, and never as 0 unless PA is.
    let xa_a = xa_a.grandeur();
    let reste = 2.0 * xa_a * xa_a + if xa_a > 0.0 { f64::MIN_POSITIF } else { 0.0 };
    let ab2 = Intervalle { bas: -p_a.haut * d2, haut: reste - p_a.bas * d2 };
    let ecart = if xa.bas > 0.0 {
        p.grandeur() / (xa.bas + ab2.bas.max(0.0).sqrt())
    } else {
        (ab2.haut.max(0.0).sqrt() + xa.grandeur()) / d2
    };
    // J6
    let positifs = [p_s, xa_s, ab2];
    let exclu = positifs.iter().any(|x| x.haut <= 0.0);
    let entre = positifs.iter().all(|x| x.bas > 0.0);
    Jugement { entre: (exclu || entre).then_some(entre), ecart }
}
