//! Writes the figures of `../figures.rs`.

fn main() -> Result<(), Box<dyn std::error::Error>> {
    exemples::figures::ecrire()
}
