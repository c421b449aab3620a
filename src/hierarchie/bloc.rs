//! A block of rays and the nodes that its beam crosses.

use crate::hierarchie::construction::{Arbre, Colonne, ENFANTS, Noeud, somme};
use crate::hierarchie::parcours::{Pile, le_premier};
use crate::intersection::rang;
use crate::lot::colonnes::VOIES;
use crate::lot::faisceau::Faisceau;
use crate::lot::groupe::Groupe;
use crate::lot::proposer;
use crate::objet::ObjetRay;
use crate::rayon::Rayon;
use crate::reel::{Reel, fois_u};
use crate::vecteur::Vecteur;

/// Up to so many objects a block without a beam is asked about all of them; of more, each ray walks alone
/// (measured).
const SEUIL_SEULS: usize = 130;

/// Of the children of the root, how many a beam may cross; the rays of a wider one walk alone (measured).
const LARGE: u32 = 8;

impl<R: Reel> Arbre<'_, R> {
    /// Finds the first object of each ray of a block.
    #[inline(always)]
    pub(crate) fn chercher(
        &self,
        objets: &[ObjetRay<R>],
        bloc: &mut [Groupe<R>],
        rayons: &[Rayon<R>],
    ) {
        let sonde = Faisceau::du_bloc(rayons, bloc).map(|faisceau| SondeDeBloc::new(faisceau, self));
        let mut profondeurs = [R::ZERO; ENFANTS];
        let racine = self.racine.and_then(|racine| Some((racine, self.noeuds.get(racine)?)));
        let sonde = sonde.filter(|sonde| {
            racine.is_none_or(|(_, noeud)| {
                sonde.traverse(noeud, R::INFINI, &mut profondeurs).count_ones() <= LARGE
            })
        });
        let nombreux = self.objets > SEUIL_SEULS;
        // The half-spaces stand behind the objects with an end.
        let premier = match &sonde {
            Some(_) => self.bornes,
            None if nombreux => self.objets,
            None => 0,
        };
        for place in premier..self.objets {
            let Some([.., indices]) = self.noeuds.get(place / ENFANTS) else { return };
            let indice = indices[place % ENFANTS].indice();
            if let Some(objet) = objets.get(indice) {
                proposer(bloc, objet, rang(indice));
            }
        }
        let Some(sonde) = sonde else {
            if nombreux {
                for (groupe, rayons) in bloc.iter_mut().zip(rayons.chunks(VOIES)) {
                    for (voie, rayon) in rayons.iter().enumerate() {
                        if let (Some(rang), t) = self.premier(objets, rayon) {
                            groupe.retenir(voie, t, rang);
                        }
                    }
                }
            }
            return;
        };
        let Some((racine, _)) = racine else { return };
        let mut pile = Pile::VIDE;
        pile.poser(R::ZERO, racine as u32, 0);
        let mut plafond = le_plus_loin(bloc);
        while let Some((profondeur, rang_noeud)) = pile.prendre() {
            if profondeur > plafond {
                continue;
            }
            let Some(noeud) = self.noeuds.get(rang_noeud as usize) else { return };
            let mut traverses = sonde.traverse(noeud, plafond, &mut profondeurs);
            let [.., indices] = noeud;
            if (rang_noeud as usize) < self.feuilles {
                if traverses == 0 {
                    continue;
                }
                while traverses != 0 {
                    let indice = indices[le_premier(traverses)].indice();
                    traverses &= traverses - 1;
                    if let Some(objet) = objets.get(indice) {
                        proposer(bloc, objet, rang(indice));
                    }
                }
                plafond = le_plus_loin(bloc);
            } else {
                let base = pile.hauteur;
                while traverses != 0 {
                    let enfant = le_premier(traverses);
                    traverses &= traverses - 1;
                    pile.poser(profondeurs[enfant], indices[enfant].indice() as u32, base);
                }
            }
        }
    }
}

/// The largest distance of a first object so far.
#[inline(always)]
fn le_plus_loin<R: Reel>(bloc: &[Groupe<R>]) -> R {
    let mut loin = R::ZERO;
    for groupe in bloc {
        let t = groupe.le_plus_loin();
        loin = if t > loin { t } else { loin };
    }
    loin
}

/// A beam as the boxes see it.
struct SondeDeBloc<R> {
    faisceau: Faisceau<R>,
    /// What is added to each w (`docs/conception.md`, "Hierarchy").
    jeu: R,
}

impl<R: Reel> SondeDeBloc<R> {
    #[inline(always)]
    fn new(faisceau: Faisceau<R>, arbre: &Arbre<'_, R>) -> Self {
        let loin = somme(faisceau.s0 - arbre.milieu) + faisceau.ecart * R::depuis_f64(4.0);
        let jeu = (arbre.etendue + loin * R::depuis_f64(32.0)) * fois_u(8.0);
        Self { faisceau, jeu }
    }

    /// Which children some ray may enter no later than `plafond`, a bit for each, and a distance before
    /// which none does.
    #[inline(always)]
    fn traverse(&self, noeud: &Noeud<R>, plafond: R, profondeurs: &mut Colonne<R>) -> u32 {
        let Faisceau { s0, plans, .. } = self.faisceau;
        let mut coins = [[R::ZERO; ENFANTS]; 6];
        for (mot, (coin, &origine)) in
            coins.iter_mut().zip([s0.x, s0.y, s0.z, s0.x, s0.y, s0.z].iter()).enumerate()
        {
            for i in 0..ENFANTS {
                coin[i] = noeud[mot][i] - origine;
            }
        }
        // Beyond which plane a child lies, by how much at most.
        let mut dehors = [-R::INFINI; ENFANTS];
        for (p, w) in plans {
            let (x, y, z) = au_plus_pres(&coins, p);
            let limite = w + self.jeu;
            for i in 0..ENFANTS {
                let h = p.produit_scalaire(Vecteur::new(x[i], y[i], z[i])) - limite;
                dehors[i] = if h > dehors[i] { h } else { dehors[i] };
            }
        }
        let (moins_m, w) = plans[4];
        let m = -moins_m;
        let (x, y, z) = au_plus_pres(&coins, m);
        let limite = w + self.jeu;
        for i in 0..ENFANTS {
            let h = m.produit_scalaire(Vecteur::new(x[i], y[i], z[i])) - limite;
            profondeurs[i] = if h > R::ZERO { h } else { R::ZERO };
        }
        let mut traverses = 0;
        for i in 0..ENFANTS {
            let devant = (dehors[i] <= R::ZERO) & (profondeurs[i] <= plafond);
            traverses |= u32::from(devant) << i;
        }
        traverses
    }
}

/// The columns of the corners that lie lowest along P.
#[inline(always)]
fn au_plus_pres<R: Reel>(
    [bx, by, bz, hx, hy, hz]: &[Colonne<R>; 6],
    p: Vecteur<R>,
) -> (&Colonne<R>, &Colonne<R>, &Colonne<R>) {
    (
        if p.x < R::ZERO { hx } else { bx },
        if p.y < R::ZERO { hy } else { by },
        if p.z < R::ZERO { hz } else { bz },
    )
}
