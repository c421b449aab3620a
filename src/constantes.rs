//! The constants of the proofs in `docs/preuves.md`, under one roof for the test that holds them to
//! their lemmas; and the numbers of lemma 18.

pub use crate::double::{BORNE_DOUBLE, Double, Intervalle, PERTE_DOUBLE, PRODUIT_DOUBLE};
pub use crate::forme::{ARRONDI_HAUTEUR, PENCHE, RETRAIT, SEUIL, VERS_LE_HAUT};
pub use crate::hierarchie::repere::{JEU_F32, JEU_TOUCHE};
pub use crate::hierarchie::sonde::{ENTREE_AVANT, JEU_BLOC, JEU_FIXE};
pub use crate::jugement::ERREUR_ARRONDIE;
pub use crate::jugement::coup_d_oeil::{
    VUE_DISTANCE, VUE_HAUTEUR, VUE_LONGUEUR, VUE_QUOTIENT, VUE_SPHERE, VUE_VITESSE, coup_d_oeil,
};
pub use crate::jugement::loupe::ECART_ARRONDI;
pub use crate::lot::faisceau::{COURT, COURT_M, JEU_BOULE, ORIGINES, PENTE};
pub use crate::objet::ETENDUE;
pub use crate::rayon::DEJA_UNITAIRE;
pub use crate::rotation::DEJA_ORTHONORMALE;
pub use crate::secondaire::{PAS_ARRONDI, PAS_NORMAL, REDRESSE, TANGENT};
pub use crate::sphere::{ARRONDI_PERDU, LONGUEUR, PAR_RAYON, PUISSANCE_PERDUE, TRAVERS_PERDU};
