//! Annex A of the handout to the letter, on the quantities of its §3: what the library is compared
//! with. Of two corrections it cannot do without: the near root (C8) and the side of a plane (C9).
//!
//! Its weaknesses are the handout's: SC² − SA² cancels for a small or far sphere; a box stops at
//! the first face found, and a point of an edge may be rounded off both of its faces; a ray
//! parallel to a face never touches it.

use lancer_rayon::{ObjetRay, Rayon, Reel, Texture, Vecteur};

/// Distance, normal and texture.
type Touche<R> = (R, Vecteur<R>, Texture);

pub(crate) enum Objet<R> {
    Sphere { c: Vecteur<R>, r: R, texture: Texture },
    Plan { p: Vecteur<R>, d: R, texture: Texture },
    Boite { n: [Vecteur<R>; 3], faces: [[(Vecteur<R>, R); 2]; 3], l: [R; 3], texture: Texture },
}

impl<R: Reel> From<&ObjetRay<R>> for Objet<R> {
    fn from(objet: &ObjetRay<R>) -> Self {
        match objet {
            ObjetRay::Sphere(s) => {
                Self::Sphere { c: s.centre(), r: s.rayon(), texture: s.texture() }
            }
            ObjetRay::Plan(p) => {
                Self::Plan { p: p.normale(), d: p.distance(), texture: p.texture() }
            }
            ObjetRay::Boite(b) => {
                let (cf, df) = (b.centres_faces(), b.distances_faces());
                let (co, d_o) = (b.centres_opposes(), b.distances_opposees());
                let faces = core::array::from_fn(|i| [(cf[i], df[i]), (co[i], d_o[i])]);
                Self::Boite { n: b.normales(), faces, l: b.demi_longueurs(), texture: b.texture() }
            }
        }
    }
}

/// A.1.
fn plan<R: Reel>(p: Vecteur<R>, d: R, rayon: &Rayon<R>) -> Option<R> {
    let pd = p.produit_scalaire(rayon.direction());
    let t = (-d - p.produit_scalaire(rayon.source())) / pd;
    (pd < R::ZERO && t > R::ZERO).then_some(t)
}

impl<R: Reel> Objet<R> {
    pub(crate) fn intersection(&self, rayon: &Rayon<R>) -> Option<Touche<R>> {
        match *self {
            Self::Sphere { c, r, texture } => {
                let sc = c - rayon.source();
                let sa = sc.produit_scalaire(rayon.direction());
                let ac2 = sc.longueur_carree() - sa * sa;
                if sa <= R::ZERO || ac2 >= r * r {
                    return None;
                }
                let t = sa - (r * r - ac2).sqrt();
                let cb = rayon.point(t) - c;
                (t > R::ZERO).then(|| (t, cb / cb.longueur(), texture))
            }
            Self::Plan { p, d, texture } => plan(p, d, rayon).map(|t| (t, p, texture)),
            Self::Boite { n, faces, l, texture } => (0..3).find_map(|i| {
                let dn = rayon.direction().produit_scalaire(n[i]);
                let [face, opposee] = faces[i];
                let (normale, (c, d)) = if dn > R::ZERO { (-n[i], opposee) } else { (n[i], face) };
                let t = plan(normale, d, rayon)?;
                let ci = rayon.point(t) - c;
                let dessus = |j: usize| ci.produit_scalaire(n[j]).abs() <= l[j];
                (dessus((i + 1) % 3) && dessus((i + 2) % 3)).then_some((t, normale, texture))
            }),
        }
    }
}

pub(crate) fn premiere_intersection<R: Reel>(
    objets: &[Objet<R>],
    rayon: &Rayon<R>,
) -> Option<Touche<R>> {
    let touches = objets.iter().filter_map(|objet| objet.intersection(rayon));
    touches.reduce(|a, b| if b.0 < a.0 { b } else { a })
}
