//! One ray and the nodes that it crosses.

use fearless_simd::Simd;

use crate::hierarchie::construction::{Arbre, Colonne, ENFANTS, ETAGES, Noeud, somme};
use crate::intersection::{Rang, rang};
use crate::objet::ObjetRay;
use crate::rayon::Rayon;
use crate::recherche::cache_avant;
use crate::reel::{Reel, fois_u};
use crate::vecteur::Vecteur;

impl<R: Reel> Arbre<'_, R> {
    /// The rank of the first object that the ray enters, and the distance.
    #[inline(always)]
    pub(crate) fn premier<S: Simd>(
        &self,
        simd: S,
        objets: &[ObjetRay<R>],
        rayon: &Rayon<R>,
    ) -> (Option<Rang>, R) {
        let (s, d) = (rayon.source(), rayon.direction());
        let mut premier = Premier { objets, s, d, rang: 0, t: R::INFINI };
        self.parcourir(simd, rayon, R::INFINI, &mut premier);
        (Rang::new(premier.rang), premier.t)
    }

    /// Whether the ray touches an object before `distance_max`.
    #[inline(always)]
    pub(crate) fn cache<S: Simd>(
        &self,
        simd: S,
        objets: &[ObjetRay<R>],
        rayon: &Rayon<R>,
        distance_max: R,
    ) -> bool {
        let mut ombre = Ombre { objets, rayon, distance_max, cache: false };
        self.parcourir(simd, rayon, distance_max, &mut ombre);
        ombre.cache
    }

    /// Shows to the question the half-spaces, and each object that the ray may enter no later than
    /// `plafond`, which is then what the question answers; below 0 the walk ends.
    #[inline(always)]
    fn parcourir<S: Simd>(
        &self,
        simd: S,
        rayon: &Rayon<R>,
        mut plafond: R,
        question: &mut impl Question<R>,
    ) {
        for indice in self.sans_bornes() {
            plafond = question.voir(indice);
        }
        let Some(racine) = self.racine else { return };
        let sonde = Sonde::new(rayon, self.milieu);
        let mut pile = Pile::VIDE;
        let mut entrees = [R::ZERO; ENFANTS];
        let mut suivant = Some((R::ZERO, racine as u32));
        while let Some((entree, rang)) = suivant {
            let rang = rang as usize;
            if entree <= plafond
                && let Some(noeud) = self.noeuds.get(rang)
            {
                let mut traverses = sonde.traverse(simd, noeud, plafond, &mut entrees);
                let indices = &noeud[6];
                if rang < self.feuilles {
                    while traverses != 0 {
                        let mut enfant = le_premier(traverses);
                        let mut autres = traverses & (traverses - 1);
                        while autres != 0 {
                            let autre = le_premier(autres);
                            autres &= autres - 1;
                            if entrees[autre] < entrees[enfant] {
                                enfant = autre;
                            }
                        }
                        traverses &= !(1 << enfant);
                        if entrees[enfant] > plafond {
                            break;
                        }
                        plafond = question.voir(indices[enfant].indice());
                    }
                } else {
                    let base = pile.hauteur;
                    while traverses != 0 {
                        let enfant = le_premier(traverses);
                        traverses &= traverses - 1;
                        pile.poser(entrees[enfant], indices[enfant].indice() as u32, base);
                    }
                }
            }
            suivant = pile.prendre();
        }
    }
}

/// What is asked of each object in turn.
trait Question<R> {
    /// Looks at the object of this index; the largest entry that still matters, below 0 for none.
    fn voir(&mut self, indice: usize) -> R;
}

/// Which object is the first, so far?
struct Premier<'a, R> {
    objets: &'a [ObjetRay<R>],
    s: Vecteur<R>,
    d: Vecteur<R>,
    /// 0 for none.
    rang: u32,
    t: R,
}

impl<R: Reel> Question<R> for Premier<'_, R> {
    #[inline(always)]
    fn voir(&mut self, indice: usize) -> R {
        if let Some(objet) = self.objets.get(indice) {
            let t = objet.entree(self.s, self.d);
            let rang = rang(indice).get();
            // In any order: of two at the same distance, the earlier in the list.
            if t < self.t || (t == self.t && rang < self.rang) {
                (self.rang, self.t) = (rang, t);
            }
        }
        self.t
    }
}

/// Does any object block the way?
struct Ombre<'a, R> {
    objets: &'a [ObjetRay<R>],
    rayon: &'a Rayon<R>,
    distance_max: R,
    cache: bool,
}

impl<R: Reel> Question<R> for Ombre<'_, R> {
    #[inline(always)]
    fn voir(&mut self, indice: usize) -> R {
        let objet = self.objets.get(indice);
        self.cache |= objet.is_some_and(|objet| cache_avant(objet, self.rayon, self.distance_max));
        if self.cache { -R::UN } else { self.distance_max }
    }
}

/// The first of a set of children, a bit for each.
#[inline(always)]
pub(crate) fn le_premier(enfants: u32) -> usize {
    enfants.trailing_zeros() as usize % ENFANTS
}

/// A ray as the boxes see it, with its part of the slack (`docs/conception.md`, "Hierarchy").
struct Sonde<R>([Axe<R>; 3]);

/// One axis of it.
#[derive(Clone, Copy)]
struct Axe<R> {
    /// 1/D, below 0 where the ray runs backwards.
    inverse: R,
    /// S with the slack: for the nearer side of a box and for the farther.
    vers_proche: R,
    vers_lointain: R,
}

impl<R: Reel> Sonde<R> {
    #[inline(always)]
    fn new(rayon: &Rayon<R>, milieu: Vecteur<R>) -> Self {
        let (s, d) = (rayon.source(), rayon.direction());
        let jeu = somme(s - milieu) * fois_u(128.0) + somme(s) * fois_u(4.0);
        let axe = |s: R, d: R| {
            // 1/−0 is −∞: the sign is that of the quotient.
            let inverse = R::UN / d;
            let jeu = if inverse < R::ZERO { -jeu } else { jeu };
            Axe { inverse, vers_proche: s + jeu, vers_lointain: s - jeu }
        };
        Self([axe(s.x, d.x), axe(s.y, d.y), axe(s.z, d.z)])
    }

    /// Which children the ray may enter no later than `plafond`, a bit for each, and where.
    #[inline(always)]
    fn traverse<S: Simd>(
        &self,
        simd: S,
        noeud: &Noeud<R>,
        plafond: R,
        entrees: &mut Colonne<R>,
    ) -> u32 {
        let [bx, by, bz, hx, hy, hz, _] = noeud;
        let [x, y, z] = self.0;
        let ((px, lx), (py, ly), (pz, lz)) = (x.cotes(bx, hx), y.cotes(by, hy), z.cotes(bz, hz));
        let mut sorties = [plafond; ENFANTS];
        for i in 0..ENFANTS {
            let mut entree = R::ZERO;
            entree = apres(entree, (px[i] - x.vers_proche) * x.inverse);
            entree = apres(entree, (py[i] - y.vers_proche) * y.inverse);
            entree = apres(entree, (pz[i] - z.vers_proche) * z.inverse);
            entrees[i] = entree * (R::UN - fois_u(8.0));
            let mut sortie = plafond;
            sortie = avant(sortie, (lx[i] - x.vers_lointain) * x.inverse);
            sortie = avant(sortie, (ly[i] - y.vers_lointain) * y.inverse);
            sortie = avant(sortie, (lz[i] - z.vers_lointain) * z.inverse);
            sorties[i] = sortie;
        }
        R::au_plus(simd, entrees, &sorties)
    }
}

impl<R: Reel> Axe<R> {
    /// The nearer side of each box and the farther.
    #[inline(always)]
    fn cotes<'a>(self, bas: &'a Colonne<R>, haut: &'a Colonne<R>) -> (&'a Colonne<R>, &'a Colonne<R>) {
        if self.inverse < R::ZERO { (haut, bas) } else { (bas, haut) }
    }
}

/// The later of two distances; the first if the second is a NaN, of 0·∞.
#[inline(always)]
fn apres<R: Reel>(t: R, autre: R) -> R {
    if autre > t { autre } else { t }
}

/// The earlier of two distances; the first if the second is a NaN, of 0·∞.
#[inline(always)]
fn avant<R: Reel>(t: R, autre: R) -> R {
    if autre < t { autre } else { t }
}

/// Nodes to look at, the nearest on top.
///
/// A node that is taken leaves at most sixteen, one floor below: there are never more than fifteen of each
/// floor but the root's and one.
pub(crate) struct Pile<R> {
    entrees: [R; PROFONDEUR],
    noeuds: [u32; PROFONDEUR],
    pub(crate) hauteur: usize,
}

/// Room for 15 nodes of each floor below the root, and one.
const PROFONDEUR: usize = 46;

impl<R: Reel> Pile<R> {
    pub(crate) const VIDE: Self =
        Self { entrees: [R::ZERO; PROFONDEUR], noeuds: [0; PROFONDEUR], hauteur: 0 };

    /// Puts a node here, among those above `base` by its entry.
    #[inline(always)]
    pub(crate) fn poser(&mut self, entree: R, noeud: u32, base: usize) {
        let mut place = self.hauteur;
        while place > base && self.entrees[place - 1] < entree {
            self.entrees[place] = self.entrees[place - 1];
            self.noeuds[place] = self.noeuds[place - 1];
            place -= 1;
        }
        self.entrees[place] = entree;
        self.noeuds[place] = noeud;
        self.hauteur += 1;
    }

    /// The nearest node of the last put here, and where the ray enters it.
    #[inline(always)]
    pub(crate) fn prendre(&mut self) -> Option<(R, u32)> {
        self.hauteur = self.hauteur.checked_sub(1)?;
        Some((self.entrees[self.hauteur], self.noeuds[self.hauteur]))
    }
}
