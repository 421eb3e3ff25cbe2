//! Rails and wheels that are not even along the track: what is given of them.

use crate::defaults::with_defaults;
use crate::geometry::uneven::waviness::FlatShape;

with_defaults! {
    /// Corrugation of a rail: its height over the station, a cosine and what a file holds on top.
    #[derive(Clone, Debug, PartialEq)]
    pub struct Corrugation {
        /// Half the height from trough to crest, 0 for none [m].
        pub amplitude: f64 = 0.0,
        /// Wavelength, > 0 [m].
        pub wavelength: f64 = 0.033,
        /// Phase at station 0, where a wave of phase 0 has a crest [rad].
        pub phase: f64 = 0.0,
        /// File with the columns `station_m` and `height_mm`, up positive; empty for none.
        pub file: String = String::new(),
    }
}

with_defaults! {
    /// Deviation of a wheel from a circle: one harmonic of its radius, and what a file holds on
    /// top.
    #[derive(Clone, Debug, PartialEq)]
    pub struct OutOfRound {
        /// Half the difference from least to greatest radius, 0 for none [m].
        pub amplitude: f64 = 0.0,
        /// Number of waves around the wheel, ≥ 1.
        pub order: usize = 1,
        /// Phase of the wave at the point that is lowest at pitch 0 [rad].
        pub phase: f64 = 0.0,
        /// File with the columns `angle_deg` and `radius_mm`, the deviation of the radius; empty
        /// for none.
        pub file: String = String::new(),
    }
}

with_defaults! {
    /// A flat of a wheel.
    #[derive(Clone, Debug, PartialEq)]
    pub struct WheelFlat {
        /// Length along the nominal rolling circle, 0 for none [m].
        pub length: f64 = 0.0,
        /// Place of its middle: the angle by which the wheel has to roll forward from pitch 0 until
        /// it stands on it [rad].
        pub angle: f64 = 0.0,
        /// Greatest depth of a worn flat, 0 for L²/(16 R); that of a fresh one is L²/(8 R) [m].
        pub depth: f64 = 0.0,
        /// Fresh or worn.
        pub shape: FlatShape = FlatShape::Fresh,
    }
}
