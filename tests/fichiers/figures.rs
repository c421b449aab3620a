//! The figures of `docs/conventions.md` are what the library answers today.

#[path = "../../docs/exemples/figures.rs"]
#[expect(dead_code, reason = "of the program all but its `main`")]
mod dessin;

#[test]
fn les_figures_sont_a_jour() {
    for (nom, svg) in dessin::figures().unwrap() {
        let chemin = format!("docs/images/{nom}");
        let dessinee = std::fs::read_to_string(&chemin).unwrap_or_default();
        assert!(dessinee == svg, "docs/images/{nom} is stale: `cargo run --bin figures`");
    }
}
