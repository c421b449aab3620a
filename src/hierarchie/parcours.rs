//! One ray in the tree: the walk through the nodes that it crosses.

use fearless_simd::Simd;

use crate::hierarchie::construction::{
    Arbre, Colonne, ENFANTS, ETAGES, Noeud, Repere, TROP_LOIN, indice, jeu, premier_enfant, simple,
    simples, somme,
};
use crate::intersection::{NoIntersection, Rang, Touche, rang};
use crate::lot::colonnes::{Aligne, le_premier, max, min};
use crate::objet::ObjetRay;
use crate::rayon::Rayon;
use crate::recherche::occulte_avant;
use crate::reel::{Reel, au_plus, fois_u};
use crate::vecteur::Vecteur;

impl<R: Reel> Arbre<'_, R> {
    /// The hit of the first object that the ray enters. `(t, rang)` is the first object so far; rank 0
    /// means none.
    #[inline(always)]
    pub(crate) fn premiere_intersection<S: Simd>(
        &self,
        simd: S,
        objets: &[ObjetRay<R>],
        rayon: &Rayon<R>,
        (t, rang): (R, u32),
    ) -> Touche<R> {
        let (s, d) = (rayon.source(), rayon.direction());
        let mut premier = Premier { repere: self.repere, objets, s, d, rang, t };
        self.parcourir(simd, rayon, self.repere.distance(t), &mut premier);
        let Some(rang) = Rang::new(premier.rang) else { return Err(NoIntersection) };
        match objets.get(rang.get() as usize - 1) {
            Some(objet) => objet.conclure_sur_place(rayon, premier.t, rang),
            None => Err(NoIntersection),
        }
    }

    /// Whether the ray touches an object before `distance_max`. The walk is cut off there, with room for a
    /// hit that rounding puts before the box around its object (`docs/conception.md`, "Hierarchy").
    #[inline(always)]
    pub(crate) fn est_occulte<S: Simd>(
        &self,
        simd: S,
        objets: &[ObjetRay<R>],
        rayon: &Rayon<R>,
        distance_max: R,
    ) -> bool {
        let plafond = self.repere.distance(distance_max * (R::UN + fois_u(128.0)));
        let mut ombre = Ombre { objets, rayon, distance_max, occulte: false };
        self.parcourir(simd, rayon, plafond, &mut ombre);
        ombre.occulte
    }

    /// Asks `question` about each half-space, then about each object that the ray may enter no later
    /// than `plafond`, a [distance](Repere::distance). An answer replaces `plafond`; below 0 it ends the walk.
    #[inline(always)]
    fn parcourir<S: Simd>(
        &self,
        simd: S,
        rayon: &Rayon<R>,
        mut plafond: f32,
        question: &mut impl Question,
    ) {
        for indice in self.sans_bornes() {
            plafond = question.voir(indice).unwrap_or(plafond);
            if plafond < 0.0 {
                return;
            }
        }
        let Some(racine) = self.racine else { return };
        let sonde = Sonde::new(rayon, self.repere);
        if let [feuille] = self.noeuds {
            sonde.voir_feuille(simd, feuille, plafond, question);
            return;
        }
        // No larger pile than the tree needs: to set it up costs as much as an object.
        let (mut petite, mut grande);
        let mut pile = Pile::new(if self.noeuds.len() <= PEU_DE_NOEUDS {
            petite = [RIEN; PETITE_PILE];
            &mut petite
        } else {
            grande = [RIEN; GRANDE_PILE];
            &mut grande
        });
        let mut numero = racine;
        loop {
            let Some(noeud) = self.noeuds.get(numero) else { return };
            if numero < self.feuilles {
                plafond = sonde.voir_feuille(simd, noeud, plafond, question);
            } else {
                let (traverses, Aligne(entrees)) = &sonde.traverse(simd, noeud, plafond);
                if let Some(proche) = pile.garder(*traverses, entrees, noeud) {
                    numero = proche;
                    continue;
                }
            }
            let Some(suivant) = pile.prendre(plafond) else { return };
            numero = suivant;
        }
    }
}

/// What is asked of each object in turn.
trait Question {
    /// Asks the object of this index. If the answer changes, returns the largest entry that still matters;
    /// below 0 it ends the walk.
    fn voir(&mut self, indice: usize) -> Option<f32>;
}

/// Which object is the first, so far?
struct Premier<'a, R> {
    repere: Repere<R>,
    objets: &'a [ObjetRay<R>],
    s: Vecteur<R>,
    d: Vecteur<R>,
    /// 0 for none.
    rang: u32,
    t: R,
}

impl<R: Reel> Question for Premier<'_, R> {
    #[inline(always)]
    fn voir(&mut self, indice: usize) -> Option<f32> {
        let t = self.objets.get(indice)?.entree(self.s, self.d);
        let rang = rang(indice).get();
        // In any order: of two at the same distance, the earlier in the list.
        let avant = t < self.t || (t == self.t && rang < self.rang);
        avant.then(|| {
            (self.rang, self.t) = (rang, t);
            self.repere.distance(t)
        })
    }
}

/// Does any object block the way?
struct Ombre<'a, R> {
    objets: &'a [ObjetRay<R>],
    rayon: &'a Rayon<R>,
    distance_max: R,
    occulte: bool,
}

impl<R: Reel> Question for Ombre<'_, R> {
    #[inline(always)]
    fn voir(&mut self, indice: usize) -> Option<f32> {
        self.occulte = occulte_avant(self.objets.get(indice)?, self.rayon, self.distance_max);
        self.occulte.then_some(-1.0)
    }
}

/// A ray as the boxes see it, with its part of the slack (`docs/conception.md`, "Hierarchy").
struct Sonde([Axe; 3]);

/// One axis of it.
#[derive(Clone, Copy)]
struct Axe {
    /// 1/D, below 0 where the ray runs backwards.
    inverse: f32,
    /// S with the slack: for the nearer side of a box and for the farther.
    vers_proche: f32,
    vers_lointain: f32,
}

impl Sonde {
    #[inline(always)]
    fn new<R: Reel>(rayon: &Rayon<R>, repere: Repere<R>) -> Self {
        let (s, d) = (simples(repere.point(rayon.source())), rayon.direction());
        let loin = somme(s);
        // An infinity is too far as well.
        let (s, jeu) = if loin < TROP_LOIN {
            (s, loin * jeu::<R>() as f32 + f32::U)
        } else {
            (Vecteur::NUL, TROP_LOIN)
        };
        let axe = |s: f32, d: R| {
            // 1/−0 is −∞: the sign is that of the quotient.
            let inverse = simple(R::UN / d);
            let jeu = if inverse < 0.0 { -jeu } else { jeu };
            Axe { inverse, vers_proche: s + jeu, vers_lointain: s - jeu }
        };
        Self([axe(s.x, d.x), axe(s.y, d.y), axe(s.z, d.z)])
    }

    /// Which children the ray may enter no later than `plafond`, a bit for each, and where.
    #[inline(always)]
    fn traverse<S: Simd>(&self, simd: S, noeud: &Noeud, plafond: f32) -> (u32, Aligne<Colonne>) {
        let [bx, by, bz, hx, hy, hz, _] = noeud;
        let [x, y, z] = self.0;
        let ((px, lx), (py, ly), (pz, lz)) = (x.cotes(bx, hx), y.cotes(by, hy), z.cotes(bz, hz));
        let (mut entrees, mut sorties) = ([0.0; ENFANTS], [plafond; ENFANTS]);
        for i in 0..ENFANTS {
            // 0·∞ is a NaN, which leaves the number so far.
            let mut entree = 0.0;
            entree = max((px[i] - x.vers_proche) * x.inverse, entree);
            entree = max((py[i] - y.vers_proche) * y.inverse, entree);
            entree = max((pz[i] - z.vers_proche) * z.inverse, entree);
            entrees[i] = entree * (1.0 - fois_u::<f32>(16.0));
            let mut sortie = plafond;
            sortie = min((lx[i] - x.vers_lointain) * x.inverse, sortie);
            sortie = min((ly[i] - y.vers_lointain) * y.inverse, sortie);
            sortie = min((lz[i] - z.vers_lointain) * z.inverse, sortie);
            sorties[i] = sortie;
        }
        (au_plus(simd, &entrees, &sorties), Aligne(entrees))
    }

    /// Asks `question` about each object of a leaf that the ray may enter no later than `plafond`; the
    /// new `plafond`.
    #[inline(always)]
    fn voir_feuille<S: Simd>(
        &self,
        simd: S,
        feuille: &Noeud,
        mut plafond: f32,
        question: &mut impl Question,
    ) -> f32 {
        let (mut traverses, entrees) = self.traverse(simd, feuille, plafond);
        let Aligne(entrees) = &entrees;
        let [.., indices] = feuille;
        while traverses != 0 {
            let enfant = le_premier(traverses);
            traverses &= traverses - 1;
            if let Some(nouveau) = question.voir(indice(indices[enfant])) {
                plafond = nouveau;
                traverses &= au_plus(simd, entrees, &[plafond; ENFANTS]);
            }
        }
        plafond
    }
}

impl Axe {
    /// The nearer side of each box and the farther.
    #[inline(always)]
    fn cotes<'a>(self, bas: &'a Colonne, haut: &'a Colonne) -> (&'a Colonne, &'a Colonne) {
        if self.inverse < 0.0 { (haut, bas) } else { (bas, haut) }
    }
}

/// Room for the nodes that a walk leaves for later. Of each node above the leaves it visits one child at
/// once and leaves at most fifteen. It is done with these before it visits another node of that floor.
pub(crate) const GRANDE_PILE: usize = 15 * (ETAGES - 1);

/// Room for them where there are at most four floors. To set up a large one costs 6 ns a ray.
const PETITE_PILE: usize = 15 * 3;

/// Trees of no more nodes than this have at most four floors.
const PEU_DE_NOEUDS: usize = 16 * 16 * 16;

/// A node to look at later, and the distance at which the ray enters it.
type Attente = (f32, u32);

/// A free place of a pile.
pub(crate) const RIEN: Attente = (0.0, 0);

/// Nodes to look at later.
pub(crate) struct Pile<'a> {
    attentes: &'a mut [Attente],
    hauteur: usize,
}

impl<'a> Pile<'a> {
    #[inline(always)]
    pub(crate) fn new(attentes: &'a mut [Attente]) -> Self {
        Self { attentes, hauteur: 0 }
    }

    /// The nearest of these children, a bit for each; the others are put here.
    #[inline(always)]
    pub(crate) fn garder(
        &mut self,
        mut enfants: u32,
        entrees: &Colonne,
        noeud: &Noeud,
    ) -> Option<usize> {
        if enfants == 0 {
            return None;
        }
        let premier = premier_enfant(noeud);
        let mut proche = le_premier(enfants);
        enfants &= enfants - 1;
        while enfants != 0 {
            let enfant = le_premier(enfants);
            enfants &= enfants - 1;
            let plus_tard = if entrees[enfant] < entrees[proche] {
                core::mem::replace(&mut proche, enfant)
            } else {
                enfant
            };
            self.poser(entrees[plus_tard], premier + plus_tard);
        }
        Some(premier + proche)
    }

    #[inline(always)]
    fn poser(&mut self, entree: f32, noeud: usize) {
        self.attentes[self.hauteur] = (entree, noeud as u32);
        self.hauteur += 1;
    }

    /// The last node put here that the ray enters no later than `plafond`.
    #[inline(always)]
    pub(crate) fn prendre(&mut self, plafond: f32) -> Option<usize> {
        while let Some(hauteur) = self.hauteur.checked_sub(1) {
            self.hauteur = hauteur;
            let (entree, noeud) = self.attentes[hauteur];
            if entree <= plafond {
                return Some(noeud as usize);
            }
        }
        None
    }
}
