//! The renderer of `../rendu.rs`.

fn main() -> std::process::ExitCode {
    exemples::rendu::programme()
}
