//! What the test files share: how a property is run, where its values come from, and how much
//! rounding it may see.
#![allow(clippy::incompatible_msrv, reason = "tests need the Rust that proptest needs")]
#![allow(dead_code, reason = "each test file uses its own part")]

pub(crate) mod conversion;
pub(crate) mod mesure;
pub(crate) mod oracle;
pub(crate) mod regimes;
pub(crate) mod scenes;
pub(crate) mod strategies;
pub(crate) mod tolerances;

pub(crate) use conversion::{Bits, arrondi};
use proptest::strategy::Strategy;
use proptest::test_runner::{Config, TestCaseResult, TestRunner};

/// Runs a property on random values; it may throw away a tenth of them at most.
/// `PROPTEST_CASES` sets how many.
pub(crate) fn pour_tout<S: Strategy>(strategie: S, propriete: impl Fn(S::Value) -> TestCaseResult) {
    let cas = Config::default();
    let rejets = cas.cases / 10;
    let config = Config {
        max_global_rejects: rejets,
        max_local_rejects: rejets,
        failure_persistence: None,
        ..cas
    };
    if let Err(echec) = TestRunner::new(config).run(&strategie, propriete) {
        panic!("{echec}");
    }
}
