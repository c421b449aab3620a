//! What `docs/precision.md` promises, against an oracle in exact integers.

mod adversaire;
mod besoins;
mod budget;
mod certificat;
mod certitude;
mod conclusion;
mod constantes;
mod doubles;
mod etapes;
mod hasard;
mod intervalle;
mod oracle;
mod pentes;
mod preuves;
mod promesses;
mod ruban;
