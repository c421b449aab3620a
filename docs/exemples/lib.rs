//! What the programs of this folder share with each other and with tests and benches. `scene.rs` and `surete.rs` stand
//! alone, and may be copied as they are.

#![allow(missing_docs, reason = "not published: what a name does not say has a comment")]

pub mod image;
pub mod scene;
pub mod surete;
