//! The parts of a page that a program writes, between two comments that stay, and the files of figures of the pages.

use std::path::{Path, PathBuf};
use std::{io, iter};

use banc::circonstances::Circonstances;

/// A path below the root of the repository.
pub(crate) fn chemin(relatif: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(relatif)
}

/// Puts `texte` between `<!-- begin nom -->` and `<!-- end nom -->`.
pub(crate) fn remplacer(page: &str, nom: &str, texte: &str) -> io::Result<()> {
    let [avant, apres] = autour(page, nom)?;
    std::fs::write(chemin(page), format!("{avant}\n{texte}\n\n{apres}"))
}

/// What stands before the part `nom` and after it, with the comments; an error if the page has no place for the part.
pub(crate) fn autour(page: &str, nom: &str) -> io::Result<[String; 2]> {
    let contenu = std::fs::read_to_string(chemin(page))?;
    let (debut, fin) = (format!("<!-- begin {nom} -->\n"), format!("<!-- end {nom} -->"));
    let manque = || io::Error::other(format!("{page} has no place for {nom}"));
    let (avant, reste) = contenu.split_once(&debut).ok_or_else(manque)?;
    let (_, apres) = reste.split_once(&fin).ok_or_else(manque)?;
    Ok([format!("{avant}{debut}"), format!("{fin}{apres}")])
}

/// The text, followed by the day, the machine and the compiler of its measurement.
pub(crate) fn datee(texte: &str) -> String {
    let Circonstances { jour, processeur, compilateur, .. } = Circonstances::presentes();
    format!("{texte}\n\n{jour}, {processeur}, {compilateur}, `comparaison documents`.")
}

/// Writes `benches/mesures/nom.csv`. The first line names the columns.
pub(crate) fn csv(nom: &str, lignes: &[String]) -> io::Result<()> {
    let circonstances = Circonstances::presentes().colonnes();
    let suites = iter::once(Circonstances::TITRES).chain(iter::repeat(&*circonstances));
    let lignes = lignes.iter().zip(suites);
    let texte: String = lignes.map(|(ligne, suite)| format!("{ligne},{suite}\n")).collect();
    std::fs::write(chemin(&format!("benches/mesures/{nom}.csv")), texte)
}
