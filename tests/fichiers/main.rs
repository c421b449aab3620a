//! What is read and written: scene files, single values, pictures, pages.

mod dossiers;
mod etages;
mod etiquettes;
mod figures;
mod lexique;
mod mesures;
mod nombres;
mod pages;
mod pixels;
mod programmes;
mod rendu;
mod scenario;
mod scenes;
mod serde;
