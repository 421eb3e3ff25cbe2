//! Sizes that the energy is scaled by: those of the ellipse of the parabola with the same moments
//! of the overlap.

use std::f64::consts::PI;

use crate::math::real::Real;
use crate::normal::hertz;

/// Least half length over that of the ellipse: strips that hardly carry load stay longer than
/// nothing.
const MIN_LENGTH: f64 = 0.02;
/// Range of the ratio of the curvatures of the ellipse.
const MAX_RATIO: f64 = 1e4;

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Scales<T = f64> {
    /// Load per width over E* in the middle of the ellipse [m].
    pub load: T,
    /// Square of half length over load per width over E*, [m], without shape.
    pub square_over_load: T,
    /// Overlap at its ends over that in the middle [-].
    pub level: T,
    /// Square of the least half length [m²].
    pub least_square: T,
    /// π over `load`, by which overlaps become displacements of unit loads [1/m].
    pub unit: T,
    /// What penalties are multiplied by: energy in the same units [m].
    pub energy: T,
    /// Depth of the parabola in the same units [-].
    pub depth: T,
}

impl<T: Real> Scales<T> {
    /// Those of a parabola of so much depth and half width, and the radius along it [m].
    pub fn new(depth: T, half_width: T, radius: T) -> Self {
        let [along, across] = curvatures(depth, half_width, radius);
        let ellipse = hertz::ellipse(along, across, depth, 1.0);
        let (a, b) = (ellipse.semi_axis_along, ellipse.semi_axis_across);
        let load = ellipse.max_pressure * a * (0.5 * PI);
        let pressure_over_length = ellipse.max_pressure / a;
        let unit = T::from(PI) / load;
        Self {
            load,
            square_over_load: T::from(2.0 / PI) / pressure_over_length,
            level: -(across * b * b / depth) + 1.0,
            least_square: a * a * (MIN_LENGTH * MIN_LENGTH),
            unit,
            energy: unit * depth * half_width * 2.0,
            depth: unit * depth,
        }
    }
}

/// Load over E* of the ellipse that a parabola of so much depth and half width touches in, with the
/// radius along it [m²].
pub(super) fn load<T: Real>(depth: T, half_width: T, radius: T) -> T {
    let [along, across] = curvatures(depth, half_width, radius);
    hertz::ellipse(along, across, depth, 1.0).load
}

/// Half the curvatures of such a parabola along and across [1/m].
fn curvatures<T: Real>(depth: T, half_width: T, radius: T) -> [T; 2] {
    let along = T::from(0.5) / radius;
    let across = depth / (half_width * half_width);
    [along, across.max(along / MAX_RATIO).min(along * MAX_RATIO)]
}
