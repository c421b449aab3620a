//! What tests and measurements need of this crate and its callers do not: the batch and the hierarchy with
//! other instructions; what no answer tells; and, under one roof for the test that holds them to their
//! lemmas, the constants of the proofs in `docs/preuves.md` and the numbers of lemma 18.

use core::slice;

use fearless_simd::Level;

use crate::hierarchie::Hierarchie;
use crate::hierarchie::construction::Arbre;
use crate::hierarchie::noeud::{VIDE, en_mot};
use crate::hierarchie::repere::Repere;
use crate::hierarchie::sonde::SondeDeBloc;
use crate::liste::Liste;
use crate::lot::bloc::{Bloc, Groupes};
use crate::niveau::{meilleur_niveau, selon_le_niveau};
use crate::objet::ObjetRay;
use crate::rayon::Rayon;
use crate::reel::Reel;
use crate::vecteur::Vecteur;

pub use crate::double::{BORNE_DOUBLE, Double, Intervalle, PERTE_DOUBLE, PRODUIT_DOUBLE};
pub use crate::forme::{ARRONDI_HAUTEUR, PENCHE, PLANCHER, RETRAIT, VERS_LE_HAUT};
pub use crate::hierarchie::repere::{JEU_DISTANCE, JEU_F32, JEU_LARGEUR};
pub use crate::hierarchie::sonde::{JEU_FACE, JEU_FAISCEAU};
pub use crate::jugement::ERREUR_ARRONDIE;
pub use crate::jugement::coup_d_oeil::{
    VUE_DISTANCE, VUE_HAUTEUR, VUE_LONGUEUR, VUE_QUOTIENT, VUE_SPHERE, VUE_VITESSE, coup_d_oeil,
};
pub use crate::jugement::loupe::ECART_ARRONDI;
pub use crate::lot::faisceau::{COURT, COURT_OMEGA, ORIGINES, PENTE};
pub use crate::objet::ETENDUE;
pub use crate::rayon::DEJA_UNITAIRE;
pub use crate::rotation::DEJA_ORTHONORMALE;
pub use crate::secondaire::{PAS_ARRONDI, PAS_NORMAL, REDRESSE, TANGENT};
pub use crate::sphere::{ARRONDI_PERDU, LONGUEUR, PAR_RAYON, PUISSANCE_PERDUE, TRAVERS_PERDU};

/// Which instructions are taken: no answer depends on it.
#[derive(Debug, Clone, Copy)]
pub struct Reglage {
    niveau: Level,
}

impl Reglage {
    /// Each instruction set of this machine, the best first, by name.
    pub fn tous() -> impl Iterator<Item = (&'static str, Self)> {
        let niveau = meilleur_niveau();
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        let niveaux = [
            ("AVX-512", niveau.as_avx512().map(Level::Avx512)),
            ("AVX2", niveau.as_avx2().map(Level::Avx2)),
            ("SSE2", niveau.as_sse2().map(Level::Sse2)),
        ];
        #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
        let niveaux = [("the only one", Some(niveau))];
        niveaux.into_iter().filter_map(|(nom, niveau)| Some((nom, Self { niveau: niveau? })))
    }

    /// The same hierarchy with these instructions.
    pub fn hierarchie<R: Reel>(self, mut hierarchie: Hierarchie<'_, R>) -> Hierarchie<'_, R> {
        hierarchie.niveau = self.niveau;
        hierarchie
    }

    /// The same hierarchy with these instructions, and one without a tree that asks the same choice of its list.
    pub fn facons<R: Reel>(self, hierarchie: Hierarchie<'_, R>) -> [Hierarchie<'_, R>; 2] {
        let hierarchie = self.hierarchie(hierarchie);
        let arbre = Arbre::sans_noeuds(hierarchie.arbre.liste);
        [hierarchie, Hierarchie { arbre, ..hierarchie }]
    }
}

/// Whether the beam of these shadow rays, one to sixty-four, leaves out the box around this object. It
/// ends at the lamps, unless one is infinitely far. No answer shows it.
pub fn evite<R: Reel>(ombres: &[(Rayon<R>, R)], objet: &ObjetRay<R>) -> bool {
    let mut groupes = Groupes::new_const();
    let mut bloc = Bloc::new(Liste::entiere(&[]), &mut groupes);
    bloc.charger(ombres);
    bloc.faisceau().is_some_and(|faisceau| {
        let mut repere = Repere::autour(slice::from_ref(objet));
        repere.jeu_maximal = 1.0;
        let sonde = SondeDeBloc::new(&faisceau, repere);
        let mut noeud = VIDE;
        if let Some((c, h)) = objet.boite_englobante() {
            let (bas, haut) = repere.boite_elargie((c, h), (Vecteur::NUL, h));
            [noeud[0][0], noeud[1][0], noeud[2][0]] = bas.into();
            [noeud[3][0], noeud[4][0], noeud[5][0]] = haut.into();
        }
        let plafond = repere.distance(bloc.le_plus_loin());
        selon_le_niveau!(meilleur_niveau(), simd => {
            sonde.as_ref().is_some_and(|sonde| sonde.traverse(simd, &noeud, plafond).0 == 0)
        })
    })
}

/// Whether these rays, one to sixty-four, come to the end of the tree of this hierarchy together. No answer
/// shows it.
pub fn vont_au_bout<R: Reel>(hierarchie: &Hierarchie<'_, R>, rayons: &[Rayon<R>]) -> bool {
    let Hierarchie { arbre, niveau } = hierarchie;
    let mut groupes = Groupes::new_const();
    let mut bloc = Bloc::new(arbre.liste, &mut groupes);
    selon_le_niveau!(*niveau, simd => arbre.chercher_ensemble(simd, &mut bloc, rayons))
}

/// How many nodes the tree of this hierarchy has; 0 if it has none and asks its list.
pub fn noeuds<R: Reel>(hierarchie: &Hierarchie<'_, R>) -> usize {
    hierarchie.arbre.noeuds.len()
}

/// This hierarchy as if none of its objects had a box; it needs a number for each.
pub fn sans_boites<'a, R: Reel>(
    hierarchie: Hierarchie<'a, R>,
    indices: &'a mut [f32],
) -> Hierarchie<'a, R> {
    for (place, indice) in indices.iter_mut().zip(0..) {
        *place = en_mot(indice);
    }
    let arbre = Arbre { noeuds: &[VIDE], feuilles: 1, sans_boite: indices, ..hierarchie.arbre };
    Hierarchie { arbre, ..hierarchie }
}
