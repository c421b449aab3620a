//! How far a program on a tape is off, for all inputs in a box: each rounding error counts with the slope of the answer
//! at that place. Slopes go backwards and hold between what is exact and what is computed, without second-order terms:
//!
//! - (ab)^ − ab = Δa·(b + b^)/2 + Δb·(a + a^)/2, and so for scalar and vector products;
//! - (a/b)^ − a/b = (Δa − Δb·a/b)/b^, and √a^ − √a = Δa/(√a + √a^).
//!
//! Vectors are found again among the numbers, so that the frame is free. A vector rounds by u of its length, a vector
//! product by lemma 3.

use std::collections::HashMap;

use crate::intervalle::{Intervalle, de_a, i};
use crate::ruban::{Op, Place, op};

/// A vector in a frame that suits the lemma, or a number followed by two zeros.
pub(crate) type Valeur = [Intervalle; 3];

/// How a node is computed from others.
#[derive(Debug, Clone, Copy)]
enum Pas {
    Lettre(&'static str),
    Constante(f64),
    Oppose(usize),
    Absolu(usize),
    Racine(usize),
    Somme(usize, usize),
    Difference(usize, usize),
    /// A number or a vector times a number.
    Produit(usize, usize),
    Quotient(usize, usize),
    Scalaire(usize, usize),
    Vectoriel(usize, usize),
}

/// A program whose nodes are numbers and vectors.
#[derive(Debug, Default)]
pub(crate) struct Programme {
    pas: Vec<Pas>,
    connus: HashMap<Vec<Place>, usize>,
}

impl Programme {
    fn noter(&mut self, places: &[Place], pas: Pas) -> usize {
        self.pas.push(pas);
        self.connus.insert(places.to_vec(), self.pas.len() - 1);
        self.pas.len() - 1
    }

    /// The node of this place.
    pub(crate) fn nombre(&mut self, place: Place) -> usize {
        if let Some(&connu) = self.connus.get(&vec![place]) {
            return connu;
        }
        let pas = match op(place) {
            Op::Entree(nom, _) => Pas::Lettre(nom),
            Op::Constante(bits, _) => Pas::Constante(f64::from_bits(bits)),
            Op::Oppose(a) => Pas::Oppose(self.nombre(a)),
            Op::Absolu(a) => Pas::Absolu(self.nombre(a)),
            Op::Racine(a) => Pas::Racine(self.nombre(a)),
            Op::Somme(a, b) => match self.scalaire(a, b) {
                Some(pas) => pas,
                None => Pas::Somme(self.nombre(a), self.nombre(b)),
            },
            Op::Difference(a, b) => Pas::Difference(self.nombre(a), self.nombre(b)),
            Op::Produit(a, b) => Pas::Produit(self.nombre(a), self.nombre(b)),
            Op::Quotient(a, b) => Pas::Quotient(self.nombre(a), self.nombre(b)),
        };
        self.noter(&[place], pas)
    }

    /// The scalar product that this sum is.
    fn scalaire(&mut self, xy: Place, z: Place) -> Option<Pas> {
        let Op::Somme(x, y) = op(xy) else { return None };
        let [x, y, z] = [x, y, z]
            .map(|produit| if let Op::Produit(a, b) = op(produit) { Some([a, b]) } else { None });
        let [x, y, z] = [x?, y?, z?];
        let [v, w] = [0, 1].map(|k| self.vecteur([x[k], y[k], z[k]]));
        Some(Pas::Scalaire(v?, w?))
    }

    /// The vector of these coordinates, if the code computes one.
    fn vecteur(&mut self, places: [Place; 3]) -> Option<usize> {
        if let Some(&connu) = self.connus.get(places.as_slice()) {
            return Some(connu);
        }
        let pas = match places.map(op) {
            [Op::Entree(nom, 0), Op::Entree(y, 1), Op::Entree(z, 2)] if nom == y && nom == z => {
                Pas::Lettre(nom)
            }
            [Op::Oppose(x), Op::Oppose(y), Op::Oppose(z)] => Pas::Oppose(self.vecteur([x, y, z])?),
            [Op::Somme(x, a), Op::Somme(y, b), Op::Somme(z, c)] => {
                Pas::Somme(self.vecteur([x, y, z])?, self.vecteur([a, b, c])?)
            }
            [Op::Difference(x, a), Op::Difference(y, b), Op::Difference(z, c)] => {
                match [x, y, z, a, b, c].map(op) {
                    [
                        Op::Produit(y1, z2),
                        Op::Produit(z1, x2),
                        Op::Produit(x1, y2),
                        Op::Produit(z1_, y2_),
                        Op::Produit(x1_, z2_),
                        Op::Produit(y1_, x2_),
                    ] if [x1, y1, z1, x2, y2, z2] == [x1_, y1_, z1_, x2_, y2_, z2_] => {
                        Pas::Vectoriel(self.vecteur([x1, y1, z1])?, self.vecteur([x2, y2, z2])?)
                    }
                    _ => Pas::Difference(self.vecteur([x, y, z])?, self.vecteur([a, b, c])?),
                }
            }
            [Op::Produit(x, k), Op::Produit(y, l), Op::Produit(z, m)] if k == l && k == m => {
                Pas::Produit(self.vecteur([x, y, z])?, self.nombre(k))
            }
            [Op::Quotient(x, k), Op::Quotient(y, l), Op::Quotient(z, m)] if k == l && k == m => {
                Pas::Quotient(self.vecteur([x, y, z])?, self.nombre(k))
            }
            _ => return None,
        };
        Some(self.noter(&places, pas))
    }
}

/// What is known of the nodes of a program for all inputs in a box.
pub(crate) struct Boite<'a> {
    programme: &'a Programme,
    /// Exact.
    x: Vec<Valeur>,
    /// Exact and computed.
    calcule: Vec<Valeur>,
    /// How far off the computed value is, and what the last operation alone adds to that.
    erreur: Vec<f64>,
    arrondi: Vec<f64>,
    /// Whether the error of the node was given.
    coupe: Vec<bool>,
    norme: Vec<f64>,
}

/// What is given of a node: its exact value, where that is known better than its operands tell; and its error, if it is
/// not to be found from theirs, or where the computed value lies.
pub(crate) type Dit = (usize, Intervalle, Encore);

#[derive(Debug, Clone, Copy)]
pub(crate) enum Encore {
    Rien,
    Erreur(Intervalle),
    Calcule(Intervalle),
}

pub(crate) fn nombre(x: Intervalle) -> Valeur {
    [x, i(0.0), i(0.0)]
}

fn deux(v: Valeur, w: Valeur, f: impl Fn(Intervalle, Intervalle) -> Intervalle) -> Valeur {
    [f(v[0], w[0]), f(v[1], w[1]), f(v[2], w[2])]
}

fn scalaire(v: Valeur, w: Valeur) -> Intervalle {
    v[0] * w[0] + v[1] * w[1] + v[2] * w[2]
}

fn vectoriel(v: Valeur, w: Valeur) -> Valeur {
    [[1, 2], [2, 0], [0, 1]].map(|[y, z]| v[y] * w[z] - v[z] * w[y])
}

/// The longest.
fn norme(v: Valeur) -> f64 {
    if v[1] == i(0.0) && v[2] == i(0.0) {
        return v[0].grandeur().haut;
    }
    let grand = v.iter().map(|x| x.grandeur().haut).fold(f64::MIN_POSITIVE, f64::max);
    let [x, y, z] = v.map(|x| (x / i(grand)).carre());
    (i(grand) * (x + y + z).racine()).haut
}

/// a over b, which must not be 0.
fn sur(a: Intervalle, b: Intervalle) -> Option<Intervalle> {
    if b.haut < 0.0 { Some(-a / -b) } else { (b.bas > 0.0).then(|| a / b) }
}

/// a over b, which must be above 0.
fn par(a: Intervalle, b: f64) -> Option<Intervalle> {
    (b > 0.0).then(|| a / i(b))
}

fn signe(x: Intervalle) -> Intervalle {
    de_a(if x.bas < 0.0 { -1.0 } else { 1.0 }, if x.haut > 0.0 { 1.0 } else { -1.0 })
}

impl<'a> Boite<'a> {
    /// None where a divisor may be 0. `perdu` is what a product of a given degree in lengths may lose.
    pub(crate) fn new(
        programme: &'a Programme,
        u: f64,
        lettres: &[(&str, f64, Valeur)],
        dits: &[Dit],
        perdu: impl Fn(f64) -> f64,
    ) -> Option<Self> {
        let mut degres: Vec<f64> = Vec::new();
        let mut b = Boite {
            programme,
            x: vec![],
            calcule: vec![],
            erreur: vec![],
            arrondi: vec![],
            coupe: vec![],
            norme: vec![],
        };
        for (k, &pas) in programme.pas.iter().enumerate() {
            let (x, e) = (&b.x, |k: usize| i(b.erreur[k]));
            let n = |k: usize| i(b.norme[k]);
            let produit = |a: usize, c: usize| n(a) * e(c) + n(c) * e(a) + e(a) * e(c);
            let (exact, herite, degre) = match pas {
                Pas::Lettre(nom) => {
                    let lettre = lettres.iter().find(|(lettre, ..)| *lettre == nom);
                    let (_, degre, x) = lettre.unwrap_or_else(|| panic!("{nom} of {lettres:?}"));
                    (*x, i(0.0), *degre)
                }
                Pas::Constante(c) => (nombre(i(c)), i(0.0), 0.0),
                Pas::Oppose(a) => (x[a].map(|x| -x), e(a), degres[a]),
                Pas::Absolu(a) => (nombre(x[a][0].grandeur()), e(a), degres[a]),
                Pas::Somme(a, c) => (deux(x[a], x[c], |x, y| x + y), e(a) + e(c), degres[a]),
                Pas::Difference(a, c) => (deux(x[a], x[c], |x, y| x - y), e(a) + e(c), degres[a]),
                Pas::Produit(a, c) => {
                    (x[a].map(|y| y * x[c][0]), produit(a, c), degres[a] + degres[c])
                }
                Pas::Scalaire(a, c) => {
                    (nombre(scalaire(x[a], x[c])), produit(a, c), degres[a] + degres[c])
                }
                Pas::Vectoriel(a, c) => {
                    (vectoriel(x[a], x[c]), produit(a, c), degres[a] + degres[c])
                }
                Pas::Quotient(a, c) => {
                    let [p, q, r] = x[a].map(|y| sur(y, x[c][0]));
                    let exact = [p?, q?, r?];
                    let reste = x[c][0].grandeur() - e(c);
                    (exact, par(e(a) + i(norme(exact)) * e(c), reste.bas)?, degres[a] - degres[c])
                }
                Pas::Racine(a) => {
                    let exact = x[a][0].max(i(0.0)).racine();
                    let reste = exact + (x[a][0] - e(a)).max(i(0.0)).racine();
                    (
                        nombre(exact),
                        if e(a).haut > 0.0 { par(e(a), reste.bas)? } else { i(0.0) },
                        0.5 * degres[a],
                    )
                }
            };
            // All terms of a sum must scale alike with all lengths, and with D.
            if let Pas::Somme(a, c) | Pas::Difference(a, c) = pas {
                assert_eq!(degres[a], degres[c], "{pas:?} of unlike degrees");
            }
            let dit = dits.iter().find(|(dit, ..)| *dit == k);
            // At a point a given value must be what the program computes.
            if let Some((_, dit, _)) = dit {
                let mince = exact[0].haut - exact[0].bas < 1e-9 * exact[0].haut.abs();
                assert!(
                    !mince || (dit.bas <= exact[0].haut && exact[0].bas <= dit.haut),
                    "{pas:?}: {exact:?} is not {dit:?}"
                );
            }
            let exact = dit.map_or(exact, |(_, dit, _)| nombre(*dit));
            let longueur = norme(exact);
            let large = i(longueur) + herite;
            let puissance_de_deux =
                |a: usize| matches!(programme.pas[a], Pas::Constante(c) if c.to_bits() << 12 == 0);
            let arrondi = match pas {
                Pas::Lettre(_) | Pas::Constante(_) | Pas::Oppose(_) | Pas::Absolu(_) => i(0.0),
                Pas::Produit(a, c) if puissance_de_deux(a) || puissance_de_deux(c) => i(0.0),
                Pas::Quotient(_, c) if puissance_de_deux(c) => i(0.0),
                Pas::Somme(..) | Pas::Difference(..) | Pas::Racine(_) => large * u,
                Pas::Produit(..) | Pas::Quotient(..) => large * u + perdu(degre),
                // The products and their first sum; then the last sum.
                Pas::Scalaire(a, c) => {
                    (2.0 * (n(a) + e(a)) * (n(c) + e(c)) + large) * u * (1.0 + 4.0 * u)
                        + 3.0 * perdu(degre)
                }
                Pas::Vectoriel(a, c) => {
                    let deux_produits = i(4.0 / 3.0).racine() * (n(a) + e(a)) * (n(c) + e(c));
                    (deux_produits * (1.0 + 2.0 * u) + large) * u + 3.5 * perdu(degre)
                }
            };
            let encore = dit.map_or(Encore::Rien, |(.., encore)| *encore);
            let (erreur, calcule) = match encore {
                Encore::Erreur(erreur) => (erreur.grandeur(), exact.map(|x| x + erreur)),
                Encore::Rien | Encore::Calcule(_) => {
                    let erreur = (herite + arrondi).haut;
                    (i(erreur), exact.map(|x| x + de_a(-erreur, erreur)))
                }
            };
            let calcule = match (encore, pas) {
                (Encore::Calcule(x), _) => nombre(calcule[0].max(i(x.bas)).min(i(x.haut))),
                (_, Pas::Racine(_)) => calcule.map(|x| x.max(i(0.0))),
                _ => calcule,
            };
            let coupe = matches!(encore, Encore::Erreur(_));
            degres.push(degre);
            b.norme.push(longueur);
            b.x.push(exact);
            b.calcule.push(calcule);
            b.erreur.push(erreur.haut);
            b.arrondi.push(if coupe { erreur.haut } else { arrondi.haut });
            b.coupe.push(coupe);
        }
        Some(b)
    }

    /// How far this node is off at most.
    pub(crate) fn erreur(&self, sortie: usize) -> Option<Intervalle> {
        self.erreur_de(&[(sortie, 1.0)])
    }

    /// How far the sum of these nodes, each times a number, is off at most.
    pub(crate) fn erreur_de(&self, sorties: &[(usize, f64)]) -> Option<Intervalle> {
        let mut pentes: Vec<Option<Valeur>> = vec![None; self.x.len()];
        for &(sortie, poids) in sorties {
            pentes[sortie] = Some(nombre(i(poids)));
        }
        let mut somme = i(0.0);
        for k in (0..self.x.len()).rev() {
            let Some(pente) = pentes[k] else { continue };
            let p = pente[0];
            somme = somme + i(norme(pente)) * self.arrondi[k];
            let milieu = |k: usize| deux(self.x[k], self.calcule[k], |x, y| (x + y) * 0.5);
            let mut vers = |k: usize, valeur: Valeur| {
                pentes[k] =
                    Some(pentes[k].map_or(valeur, |pente| deux(pente, valeur, |x, y| x + y)));
            };
            if self.coupe[k] {
                continue;
            }
            match self.programme.pas[k] {
                Pas::Lettre(_) | Pas::Constante(_) => {}
                Pas::Oppose(a) => vers(a, pente.map(|x| -x)),
                Pas::Absolu(a) => vers(a, nombre(p * signe(self.calcule[a][0]))),
                Pas::Somme(a, c) => [a, c].into_iter().for_each(|k| vers(k, pente)),
                Pas::Difference(a, c) => {
                    vers(a, pente);
                    vers(c, pente.map(|x| -x));
                }
                Pas::Produit(a, c) => {
                    vers(a, pente.map(|x| x * milieu(c)[0]));
                    vers(c, nombre(scalaire(pente, milieu(a))));
                }
                Pas::Scalaire(a, c) => {
                    vers(a, milieu(c).map(|x| p * x));
                    vers(c, milieu(a).map(|x| p * x));
                }
                Pas::Vectoriel(a, c) => {
                    vers(a, vectoriel(milieu(c), pente));
                    vers(c, vectoriel(pente, milieu(a)));
                }
                Pas::Quotient(a, c) => {
                    let [x, y, z] = pente.map(|x| sur(x, self.calcule[c][0]));
                    let pente = [x?, y?, z?];
                    vers(a, pente);
                    vers(c, nombre(-scalaire(pente, self.x[k])));
                }
                Pas::Racine(a) => {
                    let racines = self.x[k][0] + self.calcule[a][0].max(i(0.0)).racine();
                    vers(a, nombre(sur(p, racines)?));
                }
            }
        }
        Some(somme)
    }
}
