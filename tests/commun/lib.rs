//! What the test files share: how a property is run, where its values come from, how much rounding it may see, and what
//! every answer must satisfy.

#![allow(missing_docs, reason = "not published: what a name does not say has a comment")]

pub mod chemins;
pub mod choisis;
pub mod conversion;
pub mod fabrique;
pub mod facons;
pub mod hasard;
pub mod litteral;
pub mod mesure;
pub mod oracle;
pub mod passages;
pub mod promesses;
pub mod regimes;
pub mod scenes;
pub mod strategies;
pub mod tolerances;

pub use crate::conversion::{Bits, arrondi};

/// `en_f32_et_f64!(nom);` makes of the function `nom::<R>()` the two tests `nom::f32` and `nom::f64`.
#[macro_export]
macro_rules! en_f32_et_f64 {
    ($(#[$attribut:meta])? $nom:ident) => {
        mod $nom {
            #[test]
            $(#[$attribut])?
            fn f32() {
                super::$nom::<f32>();
            }

            #[test]
            $(#[$attribut])?
            fn f64() {
                super::$nom::<f64>();
            }
        }
    };
}

/// The number of random cases: `combien`, times the whole number `LANCER_RAYON_CAS` if it is set, as `.ci/run` does. A
/// trial with planted faults found with one time all that it found with four.
pub fn cas(combien: u32) -> u32 {
    let fois = std::env::var("LANCER_RAYON_CAS").ok();
    fois.map_or(1, |fois| fois.parse().expect("a whole number of times")) * combien
}

/// FNV-1a, 64 bits.
pub fn empreinte(octets: impl IntoIterator<Item = u8>) -> u64 {
    octets.into_iter().fold(0xcbf2_9ce4_8422_2325, |empreinte, octet| {
        (empreinte ^ u64::from(octet)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}
