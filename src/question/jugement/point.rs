//! A point of a ray as a judge sees it, in numbers that know what they may be off by: at a glance,
//! in plain `f64` (`docs/preuves/objets.md`, lemma 18), or closely, in numbers of twice that length
//! (lemma 16).

use crate::algebre::arrondis::{VUE_LONGUEUR, VUE_POINT, VUE_PUISSANCE, VUE_VITESSE};
use crate::algebre::double::{Double, Intervalle, Triple, scalaire, triple};
use crate::{Nombre, Rayon, Vecteur};

/// A point X, seen from the centre C of an object.
pub(crate) trait Point: Copy {
    /// The point S + tD of a ray.
    fn depuis(centre: Vecteur, rayon: &Rayon, t: f64) -> Self;

    /// N·(X − C) − l and −N·(X − C) − l: how high X is over the two faces across the axis N that
    /// stand at a distance l from C.
    fn hauteurs(self, n: Vecteur, l: f64) -> [Intervalle; 2];

    /// N·D, how fast a ray rises along N.
    fn vitesse(n: Vecteur, d: Vecteur) -> Intervalle;

    /// |X − C|² − r².
    fn puissance(self, r: f64) -> Intervalle;
}

/// A point at a glance, and what it and its heights are off by.
#[derive(Clone, Copy)]
pub(crate) struct Apercu {
    cx: Vecteur,
    jeu: f64,
}

impl Point for Apercu {
    #[inline(always)]
    fn depuis(centre: Vecteur, rayon: &Rayon, t: f64) -> Self {
        let f = rayon.source() - centre;
        // The smallest normal number pays for lost products.
        let jeu = (f.norme_1() + t.abs()) * (VUE_POINT * f64::U) + f64::MIN_POSITIVE;
        Self { cx: if t == 0.0 { f } else { f + rayon.direction() * t }, jeu }
    }

    #[inline(always)]
    fn hauteurs(self, n: Vecteur, l: f64) -> [Intervalle; 2] {
        // G1: a height is off by what X is, and by u of l.
        let (x, jeu) = (n.produit_scalaire(self.cx), self.jeu + l.abs() * (VUE_LONGUEUR * f64::U));
        [x - l, -x - l].map(|hauteur| Intervalle::autour(hauteur, jeu))
    }

    #[inline(always)]
    fn vitesse(n: Vecteur, d: Vecteur) -> Intervalle {
        Intervalle::autour(n.produit_scalaire(d), VUE_VITESSE * f64::U)
    }

    #[inline(always)]
    fn puissance(self, r: f64) -> Intervalle {
        let (x2, r2) = (self.cx.longueur_carree(), r * r);
        // G2: X off by ε moves its square by 2ε|X|, at most 16u|X|² and ε²/16u.
        let jeu =
            (x2 + r2) * (VUE_PUISSANCE * f64::U) + self.jeu * self.jeu * (1.0 / 16.0 / f64::U);
        Intervalle::autour(x2 - r2, jeu)
    }
}

/// A point in doubled numbers.
impl Point for Triple {
    fn depuis(centre: Vecteur, rayon: &Rayon, t: f64) -> Self {
        let [s, d, c] = [rayon.source(), rayon.direction(), -centre].map(triple);
        [0, 1, 2].map(|i| s[i].plus(c[i]).plus(d[i].fois(Double::de(t))))
    }

    fn hauteurs(self, n: Vecteur, l: f64) -> [Intervalle; 2] {
        let x = scalaire(triple(n), self);
        [x, x.oppose()].map(|x| x.plus(Double::de(-l)).bornes())
    }

    fn vitesse(n: Vecteur, d: Vecteur) -> Intervalle {
        scalaire(triple(n), triple(d)).bornes()
    }

    fn puissance(self, r: f64) -> Intervalle {
        let r2 = Double::de(r).fois(Double::de(-r));
        scalaire(self, self).plus(r2).bornes()
    }
}
