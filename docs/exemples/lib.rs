//! What the programs of this folder share, and the tests and benches with them: `scene.rs` and
//! `surete.rs` stand alone, and may be taken as they are.

pub mod figures;
pub mod image;
pub mod rendu;
pub mod scenario;
pub mod scene;
pub mod surete;
