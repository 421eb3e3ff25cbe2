//! What the rails of a side rest on: nothing that yields, springs, or springs and dampers under a
//! mass.
//!
//! All rails of the side are one body on it, which moves sideways and up and down in their frame.
//! Without mass they rest in equilibrium with the contact forces (`quasi_static_rails`), and those
//! with a mass do so until their first step (`moving_rails`).

use serde::{Deserialize, Serialize};

use crate::defaults::with_defaults;
use crate::open::Open;

/// What of the foundation is taken into account.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum FoundationModel {
    /// Rails do not yield.
    #[default]
    Rigid,
    /// Rails on springs, in equilibrium with the contact forces at every moment.
    Massless,
    /// Rails with a mass on springs and dampers, which run along with the wheel.
    Mass,
}

with_defaults! {
    /// What the rails of a side rest on; pairs are lateral and vertical. The numbers by default are
    /// of the size that ballasted track has under one wheel.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Foundation {
        /// What is taken into account.
        pub model: FoundationModel = FoundationModel::Rigid,
        /// Stiffness against the ground, > 0 [N/m].
        pub stiffness: [f64; 2] = [2e7, 7e7],
        /// Damping against the ground of rails with a mass, ≥ 0 [N s/m].
        pub damping: [f64; 2] = [5e4, 1e5],
        /// Mass that moves with the rails, > 0 [kg].
        pub mass: f64 = 150.0,
        /// Longest step in which rails with a mass are moved on by the units, > 0 [s].
        pub longest_step: f64 = 1e-4,
        #[doc(hidden)]
        pub open: Open = Open::default(),
    }
}

/// Where the rails of a side with a mass are; pairs are lateral and vertical, of a right side.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TrackState {
    /// Deflection from where they rest without a wheel [m].
    pub deflection: [f64; 2],
    /// Velocity [m/s].
    pub velocity: [f64; 2],
    /// Estimated error that the last step left in the deflection [m].
    pub step_error: f64,
}
