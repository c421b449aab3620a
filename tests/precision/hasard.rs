//! A failure shows its smallest case: of two hundred numbers only those that matter, as round as they can be.

use std::panic::catch_unwind;

use commun::hasard::{Hasard, Tirage, pour_chaque};

#[test]
fn deux_cents_nombres_se_reduisent_a_ceux_qui_comptent() {
    let echec = catch_unwind(|| {
        let faire = |alea: &mut Hasard| {
            let nombres = alea.liste(200, |alea, _| alea.f64());
            // An empty list offers no choice.
            let un = *alea.choix(&nombres);
            (nombres, un, alea.i8(-8..=8))
        };
        pour_chaque(20, faire, |(nombres, _, _)| {
            assert!(nombres.iter().filter(|x| **x >= 0.75).count() < 2, "{nombres:?}");
        });
    });
    let message = echec.unwrap_err().downcast::<String>().unwrap();
    assert!(message.starts_with("Test failed: [0.75, 0.75].\n"), "{message}");
    let cas = "minimal failing input: ([0.75, 0.75], 0.75, -8)";
    assert!(message.trim_end().ends_with(cas), "{message}");
}
