//! What tests and measurements need of this crate and its callers do not: the answers with other
//! instructions, what no answer tells, the constants of the proofs in `docs/preuves`, which a
//! test compares with their lemmas, and the numbers of lemma 16.

use fearless_simd::Level;

use crate::arbre::sonde::Sonde;
use crate::cote_a_cote::bloc::{Bloc, Ensemble, GROUPES, Groupes};
use crate::cote_a_cote::colonne::LARGEUR;
use crate::cote_a_cote::groupe::VOIES;
use crate::cote_a_cote::niveau::{AVEC_AVX_512, meilleur_niveau, selon_le_niveau};
use crate::monde::reponses::Sujet;
use crate::{Monde, Nombre, Rayon, Reel};

pub use crate::algebre::arrondis::*;
pub use crate::algebre::double::{Double, Intervalle};
pub use crate::algebre::nombre::{PLANCHER, Scelle};
pub use crate::algebre::rotation::{
    composee, tour_autour, tour_de_camera, tour_du_quaternion, tour_vers, trois_tours,
};
pub use crate::question::jugement::juge::coup_d_oeil;

/// The instructions to use; no answer depends on them.
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

    /// The same objects, asked with these instructions.
    pub fn monde<R: Nombre, C>(self, mut monde: Monde<'_, R, C>) -> Monde<'_, R, C> {
        monde.niveau = self.niveau;
        monde
    }
}

/// How many groups of sixteen of these rays, one to sixty-four, come to the end of the tree
/// together. No answer shows it.
pub fn groupes_au_bout<R: Reel>(monde: &Monde<'_, R>, rayons: &[Rayon<R>]) -> usize {
    let Sujet { liste, arbre, niveau, .. } = monde.sujet();
    let mut groupes = Groupes::new_const();
    let bloc = &mut Bloc::new(&mut groupes, false);
    let ensemble: [Ensemble; GROUPES] = selon_le_niveau!(niveau, AVEC_AVX_512, simd => {
        arbre.chercher_ensemble(simd, &liste, (&mut arbre.budget(simd, &liste), bloc), rayons)
    });
    let groupes = ensemble[..rayons.len().div_ceil(VOIES)].iter();
    groupes.filter(|groupe| matches!(groupe, Ensemble::JusquAuBout)).count()
}

/// What a probe says of the children of a node: those that a ray may enter before a distance, one
/// bit for each, and where.
pub type Sondage = (u32, [f32; LARGEUR]);

/// What the probe of these rays, one to sixty-four, and those of each of them alone say of each
/// node of a tree, for hits up to `t`; entries count from the same point. `None` if they have no
/// probe.
pub fn sonder<R: Reel>(
    monde: &Monde<'_, R>,
    rayons: &[Rayon<R>],
    t: R,
    mut voir: impl FnMut(Sondage, Sondage),
) -> Option<()> {
    let Sujet { arbre, niveau, .. } = monde.sujet();
    let repere = arbre.repere;
    let mut groupes = Groupes::new_const();
    let mut tous = Bloc::new(&mut groupes, false);
    tous.charger(rayons);
    fearless_simd::dispatch!(niveau, simd => {
        let tau0 = Sonde::tau0_commun(tous.groupes_demandes(), repere);
        let sonde = Sonde::de_groupes(simd, tous.groupes_demandes(), tau0, repere).0?;
        for rayon in rayons {
            let la_sienne = Sonde::d_un_rayon(rayon, tau0, repere)?;
            for noeud in arbre.noeuds {
                let [de_tous, de_lui] = [&sonde, &la_sienne].map(|sonde| {
                    let (enfants, entrees) = sonde.traverse(simd, noeud, sonde.plafond(repere, t));
                    (enfants, entrees.0)
                });
                voir(de_tous, de_lui);
            }
        }
        Some(())
    })
}
