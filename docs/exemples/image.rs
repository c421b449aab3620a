//! Pictures as PNG files, and the command line of the programs that make them.

use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;
use std::process::ExitCode;

use png::Compression;

/// Writes rows of pixels from the top left, each as red, green and blue; makes the folder if need be.
pub fn ecrire(
    chemin: &str,
    (largeur, hauteur): (u32, u32),
    compression: Compression,
    octets: &[u8],
) -> Result<(), Box<dyn Error>> {
    if let Some(dossier) = Path::new(chemin).parent() {
        std::fs::create_dir_all(dossier)?;
    }
    let mut png = png::Encoder::new(BufWriter::new(File::create(chemin)?), largeur, hauteur);
    png.set_color(png::ColorType::Rgb);
    png.set_compression(compression);
    let mut png = png.write_header()?;
    png.write_image_data(octets)?;
    Ok(png.finish()?)
}

/// Calls `peindre` with the scene and the image that `arguments` names, or else with these two, and prints its error.
/// Without a `peindre`, or with arguments that it does not know, it prints the usage instead.
pub fn programme(
    arguments: &[String],
    [scene, image]: [&str; 2],
    usage: &str,
    peindre: Option<impl FnOnce(&str, &str) -> Result<(), Box<dyn Error>>>,
) -> ExitCode {
    let usage = format!("usage: {usage} [scene.ron] [image.png]\nby default {scene} and {image}");
    if arguments.iter().any(|argument| argument == "--help" || argument == "-h") {
        println!("{usage}");
        return ExitCode::SUCCESS;
    }
    let inconnue = arguments.iter().any(|argument| argument.starts_with('-'));
    let resultat = match (arguments, peindre.filter(|_| !inconnue)) {
        ([], Some(peindre)) => peindre(scene, image),
        ([scene], Some(peindre)) => peindre(scene, image),
        ([scene, image], Some(peindre)) => peindre(scene, image),
        ([_, _, _, ..], Some(_)) | (_, None) => Err(usage.into()),
    };
    match resultat {
        Ok(()) => ExitCode::SUCCESS,
        Err(erreur) => {
            eprintln!("{erreur}");
            ExitCode::FAILURE
        }
    }
}
