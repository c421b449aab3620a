//! Pictures as PNG files.

use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

use png::Compression;

/// Writes rows of pixels from the top left, red, green and blue each; makes the folder if need be.
pub(crate) fn ecrire(
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
