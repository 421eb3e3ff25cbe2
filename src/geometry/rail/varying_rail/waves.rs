//! Deviations of a wheel by its angle, as it stands above a rail that varies.

use crate::geometry::sections::rows::surface::REACH;
use crate::geometry::uneven::waviness::Waviness;
use crate::math::real::Real;

/// Deviations of a wheel over the arc of its nominal rolling circle, and how it stands.
#[derive(Clone, Copy)]
pub(super) struct WheelWaves<'a, T = f64> {
    /// The deviations [m].
    pub surface: &'a Waviness,
    /// Place of the nominal rolling circle straight below the axle [m].
    pub below: T,
    /// Whether the wheel may be hollow within reach.
    is_hollow: bool,
}

/// Curvature of deviations from which on the wheel may be hollow for a rail that is not hollow for
/// a round one, over that of the wheel [-].
const HOLLOW_SHARE: f64 = 0.25;
/// Least distance of samples of the deviations [m].
const SHORTEST: f64 = 2.5e-4;
/// Farthest place of touch along the nominal rolling circle [m].
const FARTHEST: f64 = 1.2 * REACH;

impl<'a, T: Real> WheelWaves<'a, T> {
    /// Those of the `surface` of a wheel, where it has any, turned by `pitch` [rad] with the radius `nominal_radius`
    /// [m].
    pub fn of(surface: &'a Waviness, nominal_radius: f64, pitch: T) -> Option<Self> {
        if surface.is_empty() {
            return None;
        }
        let below = -pitch * nominal_radius;
        let (from, to) = (below.value() - FARTHEST, below.value() + FARTHEST);
        let curvature = surface.curvature_within([from, to]);
        let is_hollow = curvature > HOLLOW_SHARE / nominal_radius;
        Some(Self { surface, below, is_hollow })
    }

    /// Whether the wheel may be hollow within reach.
    pub fn is_hollow(&self) -> bool {
        self.is_hollow
    }

    /// Distance of samples between which at most one wave is [m].
    pub fn spacing(&self) -> f64 {
        self.surface.bounds().spacing.max(SHORTEST)
    }
}
