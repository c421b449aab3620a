//! What the test files share: how a property is run, where its values come from, how much rounding it
//! may see, and what every hit is.
#![allow(dead_code, unused_imports, unused_macros, reason = "each test file uses its own part")]

pub(crate) mod conversion;
pub(crate) mod double;
pub(crate) mod litteral;
pub(crate) mod mesure;
pub(crate) mod oracle;
pub(crate) mod regimes;
pub(crate) mod scenes;
pub(crate) mod strategies;
pub(crate) mod tolerances;

pub(crate) use conversion::{Bits, arrondi};
use lancer_rayon::{Intersection, Rayon, Reel};
use proptest::prop_assert;
use proptest::strategy::Strategy;
use proptest::test_runner::{Config, TestCaseResult, TestRunner};
use tolerances::{NORMALE_UNITAIRE, u};

/// `en_f32_et_f64!(nom);` makes of the function `nom::<R>()` the two tests `nom::f32` and `nom::f64`.
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
pub(crate) use en_f32_et_f64;

/// Runs a property on random values; `PROPTEST_CASES` sets how many.
pub(crate) fn pour_tout<S: Strategy>(strategie: S, propriete: impl Fn(S::Value) -> TestCaseResult) {
    let config = Config { failure_persistence: None, ..Config::default() };
    if let Err(echec) = TestRunner::new(config).run(&strategie, propriete) {
        panic!("{echec}");
    }
}

/// How many cases to run: `LANCER_RAYON_CAS`, or so many.
pub(crate) fn cas(defaut: u32) -> u32 {
    std::env::var("LANCER_RAYON_CAS").map_or(defaut, |cas| cas.parse().expect("a number of cases"))
}

/// What every hit is, whatever was asked.
pub(crate) fn est_une_entree<R: Reel>(
    rayon: &Rayon<R>,
    touche: &Intersection<R>,
) -> TestCaseResult {
    prop_assert!(touche.distance() > R::ZERO && touche.distance() < R::INFINI);
    prop_assert!(touche.normale().produit_scalaire(rayon.direction()) < R::ZERO);
    let longueur = touche.normale().longueur().vers_f64();
    prop_assert!((longueur - 1.0).abs() <= NORMALE_UNITAIRE * u::<R>());
    Ok(())
}
