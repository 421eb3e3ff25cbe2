//! Elastically supported rails: in equilibrium on springs, and with a mass that runs along.

mod massless;
mod masters;
mod with_mass;
