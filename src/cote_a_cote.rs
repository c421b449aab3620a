//! Many rays at once: a picture of 600 × 400 pixels is 240,000 of them.
//!
//! Sixteen numbers stand in a **column** (`colonne.rs`), and loops over columns are compiled for
//! each instruction set (`niveau.rs`). A **group** of sixteen rays goes side by side through the
//! formulae of a shape (`groupe.rs`). A **block** of up to four groups, a tile of 8 × 8 pixels,
//! takes one object at a time (`bloc.rs`): from a list every object, from a tree those in the
//! leaves that some ray of the block may enter (`arbre/parcours_de_bloc.rs`). Shadow rays from hits
//! are made side by side as well (`eclairage.rs`).

pub(crate) mod bloc;
pub(crate) mod colonne;
pub(crate) mod eclairage;
pub(crate) mod groupe;
pub(crate) mod niveau;
