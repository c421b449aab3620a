//! Annex A of the handout to the letter, on the 36 numbers of its §3, except that a hit is an entry (C7 to C9). Its
//! weaknesses are kept: SC² − SA² cancels for a small or far sphere, a ray along a face misses it, and at an edge `≤ l`
//! compares rounded numbers, so that both faces may refuse the point.

use lancer_rayon::{Face, ObjetRay, Rayon, Reel, Texture, Vecteur};

pub struct Objet<R>(pub Forme<R>, pub Texture);
pub enum Forme<R> {
    Sphere(Vecteur<R>, R),
    Plan(Vecteur<R>, R),
    Boite([Couple<R>; 3]),
}
/// N, (Cf, df), (Co, do), l.
pub type Couple<R> = (Vecteur<R>, (Vecteur<R>, R), (Vecteur<R>, R), R);

impl<R: Reel> From<&ObjetRay<R>> for Objet<R> {
    fn from(objet: &ObjetRay<R>) -> Self {
        match objet {
            ObjetRay::Sphere(s) => Self(Forme::Sphere(s.centre(), s.rayon()), s.texture()),
            ObjetRay::Plan(p) => Self(Forme::Plan(p.normale(), p.distance()), p.texture()),
            ObjetRay::Boite(b) => {
                let couple = |i: usize| {
                    let [face, opposee] = [i, i + 3].map(|i| {
                        let (centre, normale) = b.face(Face::TOUTES[i]);
                        (centre, -normale.produit_scalaire(centre))
                    });
                    (b.normales()[i], face, opposee, b.demi_longueurs()[i])
                };
                Self(Forme::Boite([0, 1, 2].map(couple)), b.texture())
            }
        }
    }
}

pub fn premiere_intersection<R: Reel>(
    objets: &[Objet<R>],
    rayon: &Rayon<R>,
) -> Option<(R, Vecteur<R>, Texture)> {
    let (mut premiere, mut t_premiere) = (None, R::INFINI);
    for Objet(forme, texture) in objets {
        let touche = match forme {
            Forme::Sphere(c, r) => sphere(*c, *r, rayon),
            Forme::Plan(p, d) => plan(*p, *d, rayon).map(|t| (t, *p)),
            Forme::Boite(couples) => boite(couples, rayon),
        };
        if let Some((t, n)) = touche.filter(|(t, _)| *t < t_premiere) {
            (premiere, t_premiere) = (Some((t, n, *texture)), t);
        }
    }
    premiere
}

/// A.1.
pub fn plan<R: Reel>(p: Vecteur<R>, d: R, rayon: &Rayon<R>) -> Option<R> {
    let pd = p.produit_scalaire(rayon.direction());
    let t = || (-d - p.produit_scalaire(rayon.source())) / pd;
    (pd < R::ZERO).then(t).filter(|t| *t > R::ZERO)
}

/// A.2.
pub fn sphere<R: Reel>(c: Vecteur<R>, r: R, rayon: &Rayon<R>) -> Option<(R, Vecteur<R>)> {
    let sc = c - rayon.source();
    let sa = sc.produit_scalaire(rayon.direction());
    let ac2 = sc.longueur_carree() - sa * sa;
    let sb = || sa - (r * r - ac2).racine();
    let sb = (sa > R::ZERO && ac2 < r * r).then(sb).filter(|sb| *sb > R::ZERO)?;
    let cb = rayon.point(sb) - c;
    Some((sb, cb / cb.longueur_carree().racine()))
}

/// A.3.
pub fn boite<R: Reel>(couples: &[Couple<R>; 3], rayon: &Rayon<R>) -> Option<(R, Vecteur<R>)> {
    [[0, 1, 2], [1, 2, 0], [2, 0, 1]].into_iter().find_map(|[i, j, k]| {
        let (n, face, opposee, _) = &couples[i];
        let opposee_en_vue = n.produit_scalaire(rayon.direction()) > R::ZERO;
        let (n, &(centre, d)) = if opposee_en_vue { (-*n, opposee) } else { (*n, face) };
        let t = plan(n, d, rayon)?;
        let ci = rayon.point(t) - centre;
        let dedans = |(n, _, _, l): &Couple<R>| ci.produit_scalaire(*n).absolu() <= *l;
        (dedans(&couples[j]) && dedans(&couples[k])).then_some((t, n))
    })
}
