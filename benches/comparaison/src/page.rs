//! The parts of a page that a program writes, between two comments that stay.

use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A path below the root of the repository.
pub(crate) fn chemin(relatif: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(relatif)
}

/// Puts `texte` between `<!-- begin nom -->` and `<!-- end nom -->`.
pub(crate) fn remplacer(page: &str, nom: &str, texte: &str) -> io::Result<()> {
    let [avant, apres] = autour(page, nom)?;
    std::fs::write(chemin(page), format!("{avant}\n{texte}\n\n{apres}"))
}

/// What stands before the part `nom` and after it, comments included; an error if the page has no place for it.
pub(crate) fn autour(page: &str, nom: &str) -> io::Result<[String; 2]> {
    let contenu = std::fs::read_to_string(chemin(page))?;
    let (debut, fin) = (format!("<!-- begin {nom} -->\n"), format!("<!-- end {nom} -->"));
    let manque = || io::Error::other(format!("{page} has no place for {nom}"));
    let (avant, reste) = contenu.split_once(&debut).ok_or_else(manque)?;
    let (_, apres) = reste.split_once(&fin).ok_or_else(manque)?;
    Ok([format!("{avant}{debut}"), format!("{fin}{apres}")])
}

/// The text, with the machine, the compiler and the day that it was measured on.
pub(crate) fn datee(texte: &str) -> String {
    let sortie = |programme: &str, arguments: &[&str]| {
        let sortie = Command::new(programme).args(arguments).output().ok()?;
        Some(String::from_utf8_lossy(&sortie.stdout).trim().to_owned())
    };
    let cpu = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let cpu = cpu.lines().find_map(|ligne| ligne.strip_prefix("model name"));
    let cpu = cpu.map_or("an unknown processor", |nom| nom.trim_start_matches(['\t', ' ', ':']));
    let rustc = sortie("rustc", &["--version"]).unwrap_or_default();
    let rustc = rustc.split(" (").next().unwrap_or_default();
    let jour = sortie("date", &["+%Y-%m-%d"]).unwrap_or_default();
    format!("{texte}\n\n{jour}, {cpu}, {rustc}, `comparaison documents`.")
}
