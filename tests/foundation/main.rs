//! Rails that give way: in equilibrium on springs, and with a mass that runs along.

#[path = "../common/mod.rs"]
mod common;
mod massless;
mod masters;
#[path = "../tolerance/mod.rs"]
mod tolerance;
mod with_mass;
