//! What is measured (`familles`, `image`), who competes (`concurrents`, with us as `nous`), the clock, and the columns
//! that end a measured row (`circonstances`).

#![allow(missing_docs, reason = "not published: what a name does not say has a comment")]

pub mod circonstances;
pub mod concurrents;
pub mod familles;
pub mod horloge;
pub mod image;

pub use lancer_rayon as version;
pub mod nous;
