//! Sizes that the equations of the strips are scaled by.

use std::f64::consts::PI;

use super::samples::Samples;
use crate::math::real::Real;
use crate::normal::hertz;

/// Least half length over that of the ellipse: strips that hardly carry load stay longer than
/// nothing.
const MIN_LENGTH: f64 = 0.02;
/// Range of the ratio of the curvatures of the ellipse.
const MAX_RATIO: f64 = 1e4;

/// Sizes that the equations are scaled by, from the ellipse of the parabola with the same integrals
/// of the square and the cube of the overlap.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scales<T = f64> {
    /// Load per width in its middle [m].
    pub load: T,
    /// Its semi-axis along [m].
    pub length: T,
    /// χ = ln of its pressure over half length [ln 1/m].
    pub shape: T,
    /// Overlap at its ends over that in the middle [-].
    pub level: T,
    /// K: gap over the power 3/2 of what z is below zero [m^-1/2].
    pub gap: T,
    /// Square of the least half length [m²].
    pub least_square: T,
    /// Its load, which the weights of the drop of the displacement refer to [m²].
    pub total: T,
}

impl<T: Real> Scales<T> {
    pub fn new(grid: &Samples<T>) -> Self {
        let along = T::from(0.5) / grid.radius;
        let across = grid.depth / (grid.half_width * grid.half_width);
        let across = across.max(along / MAX_RATIO).min(along * MAX_RATIO);
        let ellipse = hertz::ellipse(along, across, grid.depth, 1.0);
        let (a, b) = (ellipse.semi_axis_along, ellipse.semi_axis_across);
        let load = ellipse.max_pressure * a * (0.5 * PI);
        let level = -(across * b * b / grid.depth) + 1.0;
        // Beside the edge of a strip of pressure q sqrt(s) the gap is (4/3) q s^(3/2)/E*, and the
        // load per width falls by 2 load/b.
        let gap = (ellipse.max_pressure / a * (2.0 / PI)).sqrt() * (2.0 / 3.0) * b / load;
        Self {
            load,
            length: a,
            shape: (ellipse.max_pressure / a).ln(),
            level,
            gap,
            least_square: a * a * (MIN_LENGTH * MIN_LENGTH),
            total: ellipse.load,
        }
    }

    /// What the drop of the displacement at a node counts with that has the load per width `load`
    /// and half of both loaded parts beside it as its `width`: its share of the load, times the
    /// root of the load, so that a node comes in without a bend.
    pub fn weight(&self, width: T, load: T) -> T {
        width * load * (load / self.load).sqrt() / self.total
    }
}
