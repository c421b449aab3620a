//! One ray in the tree: the walk through the nodes that it crosses.

use fearless_simd::Simd;

use crate::hierarchie::construction::{
    Arbre, Colonne, ENFANTS, ETAGES, Noeud, Repere, TROP_LOIN, indice, jeu, premier_enfant, simple,
    simples,
};
use crate::intersection::{NoIntersection, Rang, Touche, rang};
use crate::lot::colonnes::{Aligne, le_premier, max, membres, min};
use crate::objet::ObjetRay;
use crate::rayon::Rayon;
use crate::recherche::avant;
use crate::reel::{Reel, au_plus, fois_u};
use crate::vecteur::Vecteur;

impl<R: Reel> Arbre<'_, R> {
    /// The hit of the first object that the ray enters. `premier` is the first so far, a distance and a rank;
    /// rank 0 means none.
    #[inline(always)]
    pub(crate) fn premiere_intersection<S: Simd>(
        &self,
        simd: S,
        objets: &[ObjetRay<R>],
        rayon: &Rayon<R>,
        premier: (R, u32),
    ) -> Touche<R> {
        let (t, rang) = self.parcourir::<S, false>(simd, objets, rayon, premier);
        let Some(rang) = Rang::new(rang) else { return Err(NoIntersection) };
        match objets.get(rang.get() as usize - 1) {
            Some(objet) => Ok(objet.conclure(rayon, t, rang)),
            None => Err(NoIntersection),
        }
    }

    /// Whether the ray touches an object before `distance_max`.
    #[inline(always)]
    pub(crate) fn est_occulte<S: Simd>(
        &self,
        simd: S,
        objets: &[ObjetRay<R>],
        rayon: &Rayon<R>,
        distance_max: R,
    ) -> bool {
        let (_, rang) = self.parcourir::<S, true>(simd, objets, rayon, (distance_max, 0));
        rang > 0
    }

    /// The first object that the ray enters before `premier`, or `premier`; if `UN_SUFFIT`, any such object.
    ///
    /// It asks the half-spaces, then the objects of each leaf that the ray may enter before what it has found.
    #[inline(always)]
    fn parcourir<S: Simd, const UN_SUFFIT: bool>(
        &self,
        simd: S,
        objets: &[ObjetRay<R>],
        rayon: &Rayon<R>,
        premier: (R, u32),
    ) -> (R, u32) {
        let (s, d) = (rayon.source(), rayon.direction());
        let mut recherche = Recherche { repere: self.repere, objets, s, d, premier };
        for indice in self.sans_bornes() {
            if recherche.voir_demi_espace(indice) && UN_SUFFIT {
                return recherche.premier;
            }
        }
        let sonde = Sonde::new(rayon, self.repere);
        // No larger pile than the tree needs: to set it up costs as much as an object.
        let (mut petite, mut grande);
        let mut pile = Pile::new(if self.noeuds.len() <= PEU_DE_NOEUDS {
            petite = [RIEN; PETITE_PILE];
            &mut petite
        } else {
            grande = [RIEN; GRANDE_PILE];
            &mut grande
        });
        let mut numero = self.racine;
        while let Some(noeud) = self.noeuds.get(numero) {
            if numero < self.feuilles {
                let trouve = sonde.voir_feuille::<R, S, UN_SUFFIT>(simd, noeud, &mut recherche);
                if trouve && UN_SUFFIT {
                    break;
                }
            } else {
                let (traverses, Aligne(entrees)) =
                    &sonde.traverse(simd, noeud, recherche.plafond());
                if let Some(proche) = pile.garder(*traverses, entrees, noeud) {
                    numero = proche;
                    continue;
                }
            }
            let Some(suivant) = pile.prendre(recherche.plafond()) else { break };
            numero = suivant;
        }
        recherche.premier
    }
}

/// A ray with its first object so far.
struct Recherche<'a, R> {
    repere: Repere<R>,
    objets: &'a [ObjetRay<R>],
    s: Vecteur<R>,
    d: Vecteur<R>,
    /// Its distance and its rank; 0 for none.
    premier: (R, u32),
}

impl<R: Reel> Recherche<'_, R> {
    /// Asks the half-space of this index, and tells whether it is now the first.
    #[inline(always)]
    fn voir_demi_espace(&mut self, indice: usize) -> bool {
        let objet = self.objets.get(indice);
        objet.is_some_and(|objet| self.retenir(objet.entree(self.s, self.d), indice))
    }

    /// The same of a bounded object, whose ball a ray that crosses its box seldom passes by.
    #[inline(always)]
    fn voir_borne(&mut self, indice: usize) -> bool {
        let objet = self.objets.get(indice);
        objet.is_some_and(|objet| self.retenir(objet.t(self.s, self.d), indice))
    }

    #[inline(always)]
    fn retenir(&mut self, t: R, indice: usize) -> bool {
        let trouve = (t, rang(indice).get());
        let avant = avant(trouve, self.premier);
        if avant {
            self.premier = trouve;
        }
        avant
    }

    /// The largest entry that still matters, in the frame of the tree.
    #[inline(always)]
    fn plafond(&self) -> f32 {
        self.repere.distance(self.premier.0)
    }
}

/// By so many u of `f32` an entry comes before its rounding (lemma 16).
pub const ENTREE_AVANT: f64 = 10.0;

/// A ray as the boxes see it, with its part of the slack (`docs/conception.md`, lemmas 14 to 17).
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
        let loin = s.norme_1();
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
            entrees[i] = entree * (1.0 - fois_u::<f32>(ENTREE_AVANT));
            let mut sortie = plafond;
            sortie = min((lx[i] - x.vers_lointain) * x.inverse, sortie);
            sortie = min((ly[i] - y.vers_lointain) * y.inverse, sortie);
            sortie = min((lz[i] - z.vers_lointain) * z.inverse, sortie);
            sorties[i] = sortie;
        }
        (au_plus(simd, &entrees, &sorties), Aligne(entrees))
    }

    /// Asks the objects of a leaf that the ray may enter before its first so far, and tells whether one of
    /// them came before it; if `UN_SUFFIT`, that one is the last asked.
    #[inline(always)]
    fn voir_feuille<R: Reel, S: Simd, const UN_SUFFIT: bool>(
        &self,
        simd: S,
        feuille: &Noeud,
        recherche: &mut Recherche<'_, R>,
    ) -> bool {
        let (mut traverses, entrees) = self.traverse(simd, feuille, recherche.plafond());
        let Aligne(entrees) = &entrees;
        let [.., indices] = feuille;
        let mut trouve = false;
        while traverses != 0 {
            let enfant = le_premier(traverses);
            traverses &= traverses - 1;
            if recherche.voir_borne(indice(indices[enfant])) {
                trouve = true;
                if UN_SUFFIT {
                    break;
                }
                traverses &= au_plus(simd, entrees, &[recherche.plafond(); ENFANTS]);
            }
        }
        trouve
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
        enfants: u32,
        entrees: &Colonne,
        noeud: &Noeud,
    ) -> Option<usize> {
        let premier = premier_enfant(noeud);
        let mut enfants = membres(enfants);
        let mut proche = enfants.next()?;
        for enfant in enfants {
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
