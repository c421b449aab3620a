//! Numbers of twice the length of an `f64`, each with a bound on its own error: with them a hit or
//! a miss is judged after the fact, in either scalar (`docs/preuves.md`, lemmas 18 and 19).

use crate::rayon::Rayon;
use crate::reel::Reel;
use crate::vecteur::Vecteur;

/// A product rounds by so many u² of itself (lemma 18).
pub const PRODUIT_DOUBLE: f64 = 8.1;

/// What a product loses below the normal numbers, in η (lemma 18).
pub const PERTE_DOUBLE: f64 = 3.8;

/// A bound grows by so many u of itself for its own rounding (lemma 18).
pub const BORNE_DOUBLE: f64 = 7.5;

/// `haut` + `bas`, no farther than `erreur` from the number that it stands for; |bas| ≤ u·|haut|.
#[derive(Debug, Clone, Copy)]
pub struct Double {
    /// The number to `f64`.
    pub haut: f64,
    /// What is left of it.
    pub bas: f64,
    /// The bound.
    pub erreur: f64,
}

/// s + r = x + y exactly, with s their sum as computed.
fn somme(x: f64, y: f64) -> (f64, f64) {
    let s = x + y;
    let de_y = s - x;
    (s, (x - (s - de_y)) + (y - de_y))
}

impl Double {
    /// This very number.
    pub fn de(x: f64) -> Self {
        Self { haut: x, bas: 0.0, erreur: 0.0 }
    }

    /// A result and its bound, both as computed.
    fn arrondi(haut: f64, bas: f64, erreur: f64) -> Self {
        let (haut, bas) = somme(haut, bas);
        Self { haut, bas, erreur: erreur * (1.0 + BORNE_DOUBLE * f64::U) }
    }

    /// The sum.
    pub fn plus(self, autre: Self) -> Self {
        let (s, r) = somme(self.haut, autre.haut);
        let m = self.bas + autre.bas;
        let n = r + m;
        Self::arrondi(s, n, self.erreur + autre.erreur + (m.abs() + n.abs()) * f64::U)
    }

    /// The product.
    pub fn fois(self, autre: Self) -> Self {
        let p = self.haut * autre.haut;
        // No machine instruction where there is none: the same bits everywhere.
        let r = libm::fma(self.haut, autre.haut, -p);
        let n = r + (self.haut * autre.bas + self.bas * autre.haut);
        let (x, y) = (self.haut.abs(), autre.haut.abs());
        let erreur = x * autre.erreur + y * self.erreur + self.erreur * autre.erreur;
        // What is exact stays so: a ray may be parallel to a face, or start in its plane.
        let sans_perte = x.min(y) == 0.0 || p.abs() > 1e-270;
        if sans_perte && r == 0.0 && self.est_un_f64() && autre.est_un_f64() {
            return Self::de(p);
        }
        let arrondi = PRODUIT_DOUBLE * f64::U * f64::U * p.abs();
        Self::arrondi(p, n, erreur + arrondi + PERTE_DOUBLE * f64::MIN_POSITIF)
    }

    /// Whether the number is exactly `haut`.
    fn est_un_f64(self) -> bool {
        self.erreur == 0.0 && self.bas == 0.0
    }

    /// The number lies between these two, which are the same if it is an `f64` exactly.
    pub fn bornes(self) -> [f64; 2] {
        if self.est_un_f64() {
            return [self.haut; 2];
        }
        let [bas, haut] = [self.bas - self.erreur, self.bas + self.erreur];
        [(self.haut + bas.next_down()).next_down(), (self.haut + haut.next_up()).next_up()]
    }
}

/// A vector of such numbers.
pub(crate) type Triple = [Double; 3];

pub(crate) fn triple(v: Vecteur) -> Triple {
    <[f64; 3]>::from(v).map(Double::de)
}

/// S + tD − C.
pub(crate) fn depuis(centre: Vecteur, rayon: &Rayon, t: f64) -> Triple {
    let [s, d, c] = [rayon.source(), rayon.direction(), -centre].map(triple);
    [0, 1, 2].map(|i| s[i].plus(c[i]).plus(d[i].fois(Double::de(t))))
}

pub(crate) fn scalaire([a, b, c]: Triple, [x, y, z]: Triple) -> Double {
    a.fois(x).plus(b.fois(y)).plus(c.fois(z))
}

/// What exact numbers say of a ray, an object and a distance.
pub(crate) struct Jugement {
    /// Whether the ray enters the object, if that is certain.
    pub(crate) entre: Option<bool>,
    /// If it enters: no less than how far the distance is from that of the entry, to 8.6u of `f64`.
    pub(crate) ecart: f64,
}

/// What exact numbers say of a ray, a distance and the solid inside all of these faces, each with
/// its outward normal and how far along it the face is from the centre c (lemma 19).
pub(crate) fn juger_faces(c: Vecteur, faces: &[(Vecteur, f64)], rayon: &Rayon, t: f64) -> Jugement {
    // How long the ray has been inside the last face that it entered, and will be inside the first
    // that it leaves, at this distance or where it is nearest to the centre: bounds of both.
    let pres = (c - rayon.source()).produit_scalaire(rayon.direction());
    let t = if t < f64::INFINI { t } else { pres };
    let [depart, point] = [0.0, t].map(|t| depuis(c, rayon, t));
    let [mut entree, mut sortie] = [[f64::INFINI; 2]; 2];
    let (mut dehors, mut dedans) = (false, true);
    for &(n, l) in faces {
        let profondeur = |x| scalaire(triple(-n), x).plus(Double::de(l)).bornes();
        let ([s_bas, s_haut], [bas, haut]) = (profondeur(depart), profondeur(point));
        let [v_bas, v_haut] = scalaire(triple(-n), triple(rayon.direction())).bornes();
        let (lent, vite) = (v_bas.max(-v_haut), v_haut.max(-v_bas));
        if lent <= 0.0 {
            // Parallel, or nearly: whether the ray comes nearer to the face or leaves it is unknown.
            let loin = if bas > 0.0 { bas / vite } else { haut / vite };
            if s_bas >= 0.0 && (bas > 0.0 || vite == 0.0) {
                // For so long it has been under the face, and will be; in its plane 0/0 is no bound.
                [entree[0], sortie[0]] = [entree[0], sortie[0]].map(|t| t.min(loin.next_down()));
            } else if vite > 0.0 && s_haut < 0.0 && haut < 0.0 {
                // It never enters, or not for so long.
                entree = [-f64::INFINI, entree[1].min(loin.next_up())];
                dedans = false;
            } else {
                let a_cote = vite == 0.0 && s_haut < 0.0;
                return Jugement { entre: a_cote.then_some(false), ecart: f64::INFINI };
            }
            continue;
        }
        let duree = if v_bas > 0.0 { &mut entree } else { &mut sortie };
        duree[0] = duree[0].min((bas / if bas > 0.0 { vite } else { lent }).next_down());
        duree[1] = duree[1].min((haut / if haut > 0.0 { lent } else { vite }).next_up());
        dehors |= v_bas > 0.0 && s_haut < 0.0;
        dedans &= v_bas < 0.0 || s_bas >= 0.0;
    }
    let touche = dehors && entree[0] + sortie[0] >= 0.0;
    let manque = dedans || entree[1] + sortie[1] < 0.0;
    Jugement { entre: (touche || manque).then_some(touche), ecart: entree[1].max(-entree[0]) }
}
