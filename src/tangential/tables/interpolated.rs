//! Forces between what they are for small and for great creepages, from splines, without and with
//! derivatives.

use std::f64::consts::{FRAC_PI_2, PI};

use super::coefficients::{self, Place};
use super::direction::Direction;
use super::ellipse_force::{EllipseForce, ForceSlopes};
use super::nodes::{
    AZIMUTH_CELLS, ELEVATION_CELLS, HALF, LOG_RATIO, RATIO_CELLS, SATURATION_CELLS,
    SLIDING_AZIMUTH_CELLS, SLIDING_ELEVATION_CELLS,
};
use super::scales::Scales;
use super::splines::Splines;
use crate::math::b_spline;

/// How far ln(a/b) goes on beyond the ends of the table before it rests; splines are carried on
/// that far.
const END: f64 = 0.1;

/// Creepages beyond this are full sliding to rounding.
const MAX_CREEPAGE: f64 = 1e60;

/// Nodes per unit of ln(a/b), elevation and azimuth.
pub const PER_RATIO: f64 = RATIO_CELLS as f64 / (2.0 * LOG_RATIO);
const PER_ELEVATION: [f64; 2] =
    [ELEVATION_CELLS as f64 / FRAC_PI_2, SLIDING_ELEVATION_CELLS as f64 / FRAC_PI_2];
const PER_AZIMUTH: [f64; 2] = [AZIMUTH_CELLS as f64 / PI, SLIDING_AZIMUTH_CELLS as f64 / PI];

/// A coordinate that is not there.
const NONE: Place = Place { first: 0, weights: [1.0, 0.0, 0.0, 0.0], slopes: [0.0; 4] };

/// Creepages as the splines have them.
#[derive(Clone, Copy, Debug)]
pub struct Query {
    /// ln(a/b) brought to rest beyond the ends of the table, and its derivative.
    pub log_ratio: [f64; 2],
    /// Creepages v that are small enough to be squared.
    pub v: [f64; 3],
    scaled: [f64; 3],
}

/// Force and moment on either side: linear for small creepages, and of what slides the part that is
/// known in closed form.
#[derive(Clone, Copy, Debug, Default)]
pub struct Limits {
    /// Linear force for v.
    pub linear: [f64; 3],
    /// Part of full sliding.
    pub sliding: [f64; 3],
}

/// Their derivatives by v and ln(a/b); of the part of full sliding as the table has it at rest.
#[derive(Clone, Copy, Debug, Default)]
pub struct LimitSlopes {
    /// Of the linear force.
    pub linear: [[f64; 4]; 3],
    /// Of the part of full sliding.
    pub sliding: [[f64; 4]; 3],
}

/// What is interpolated.
#[derive(Clone, Copy, Debug)]
pub struct Interpolated {
    /// Force, moment and share of slip, without bounds.
    pub found: EllipseForce,
    /// 1 - s.
    pub left: f64,
}

fn place(u: f64, cells: usize) -> Place {
    let (first, fraction) = b_spline::locate(u, cells);
    Place { first, weights: b_spline::weights(fraction), slopes: b_spline::weight_slopes(fraction) }
}

/// Place of ln(a/b).
pub fn ratio_place(log_ratio: f64) -> Place {
    place((log_ratio + LOG_RATIO) * PER_RATIO, RATIO_CELLS)
}

/// Folds or unfolds the signs of longitudinal force, lateral force and moment.
fn signs([mirror, turn]: [f64; 2]) -> [f64; 3] {
    [mirror, turn, turn]
}

impl Query {
    /// ln(a/b) brought to rest beyond the ends of the table, and its derivative.
    pub fn at_rest(log_ratio: f64) -> [f64; 2] {
        at_rest_beyond(log_ratio)
    }

    /// Nothing where creepages are so small that their squares vanish.
    pub fn of(scales: &Scales, v: [f64; 3]) -> Option<Self> {
        let most = v.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
        let v = if most > MAX_CREEPAGE { v.map(|v| v / most * MAX_CREEPAGE) } else { v };
        (most > 1e-60).then(|| Self {
            log_ratio: at_rest_beyond(scales.log_ratio),
            v,
            scaled: scales.scaled(v),
        })
    }
}

/// ln(a/b) brought to rest beyond the ends of the table, and its derivative.
fn at_rest_beyond(log_ratio: f64) -> [f64; 2] {
    let over = log_ratio.abs() - LOG_RATIO;
    if over <= 0.0 {
        return [log_ratio, 1.0];
    }
    let over = over.min(2.0 * END);
    let inside = LOG_RATIO + over - over * over / (4.0 * END);
    [inside.copysign(log_ratio), 1.0 - over / (2.0 * END)]
}

impl Splines {
    /// The force between its `limits`.
    pub fn between(&self, query: &Query, limits: &Limits) -> Interpolated {
        let &Query { v, scaled, log_ratio: [inside, _] } = query;
        let along = Direction::of(scaled);
        let saturation = along.length / (along.length + HALF);
        let left = HALF / (along.length + HALF);
        let ratio = ratio_place(inside);
        let radius = place(saturation * SATURATION_CELLS as f64, SATURATION_CELLS);
        let rest = self.creep.value(&[
            ratio,
            radius,
            place(along.elevation * PER_ELEVATION[0], ELEVATION_CELLS),
            place(along.azimuth * PER_AZIMUTH[0], AZIMUTH_CELLS),
        ]);
        let planes = self.planes.plane_value([&ratio, &radius]);
        let unfold = signs(along.signs);
        let [y, z] = [scaled[1] / along.length, scaled[2] / along.length];
        let plane = [0.0, planes[0] * y + planes[1] * z, planes[2] * y + planes[3] * z];

        let slip = Direction::of(v);
        let sliding = self.sliding.value(&[
            ratio,
            NONE,
            place(slip.elevation * PER_ELEVATION[1], SLIDING_ELEVATION_CELLS),
            place(slip.azimuth * PER_AZIMUTH[1], SLIDING_AZIMUTH_CELLS),
        ]);
        let unfold_slip = signs(slip.signs);
        let mut force = [0.0; 3];
        for k in 0..3 {
            let correction = unfold[k] * rest[k] + plane[k];
            let full = limits.sliding[k] + unfold_slip[k] * sliding[k];
            force[k] = left * left * limits.linear[k]
                + saturation * saturation * (full + left * correction);
        }
        let found = EllipseForce { force, slip_share: rest[3].clamp(0.0, 1.0) };
        Interpolated { found, left }
    }

    /// The same with its derivatives, and those of 1 - s, by v and ln(a/b).
    pub fn between_with_slopes(
        &self,
        scales: &Scales,
        query: &Query,
        limits: &Limits,
        slopes: &LimitSlopes,
    ) -> (Interpolated, ForceSlopes, [f64; 4]) {
        let &Query { v, scaled, log_ratio: [inside, inside_slope] } = query;
        let by_limit = slopes;
        let along = Direction::of(scaled);
        let length = along.length;
        let saturation = length / (length + HALF);
        let left = HALF / (length + HALF);
        let ratio = ratio_place(inside);
        let by_ratio = PER_RATIO * inside_slope;
        let radius = place(saturation * SATURATION_CELLS as f64, SATURATION_CELLS);
        let rest = self.creep.value_and_slopes(&[
            ratio,
            radius,
            place(along.elevation * PER_ELEVATION[0], ELEVATION_CELLS),
            place(along.azimuth * PER_AZIMUTH[0], AZIMUTH_CELLS),
        ]);
        let planes = self.planes.plane_value_and_slopes([&ratio, &radius]);
        let unfold = signs(along.signs);
        let unit = scaled.map(|x| x / length);
        let slip = Direction::of(v);
        let sliding = self.sliding.value_and_slopes(&[
            ratio,
            NONE,
            place(slip.elevation * PER_ELEVATION[1], SLIDING_ELEVATION_CELLS),
            place(slip.azimuth * PER_AZIMUTH[1], SLIDING_AZIMUTH_CELLS),
        ]);
        let unfold_slip = signs(slip.signs);
        let &Limits { linear, sliding: closed } = limits;
        // dX/dv is diagonal; dX/dt.
        let scale = [scales.kalker[0], scales.kalker[1], scales.spin];
        let scaled_by_t = [
            scales.kalker_slopes[0] * v[0],
            scales.kalker_slopes[1] * v[1],
            scales.spin_slope * v[2],
        ];
        let ds_dlength = left / (length + HALF);
        let mut force = [0.0; 3];
        let mut slopes = [[0.0; 4]; 4];
        for k in 0..3 {
            let plane_of = |sum: &[f64; 4]| match k {
                0 => 0.0,
                k => sum[2 * k - 2] * unit[1] + sum[2 * k - 1] * unit[2],
            };
            let correction = unfold[k] * rest[0][k] + plane_of(&planes[0]);
            let full = closed[k] + unfold_slip[k] * sliding[0][k];
            force[k] =
                left * left * linear[k] + saturation * saturation * (full + left * correction);
            // Derivatives of the correction by s, and of the force by s at fixed direction.
            let by_s = SATURATION_CELLS as f64 * (unfold[k] * rest[2][k] + plane_of(&planes[2]));
            let force_by_s = -2.0 * left * linear[k]
                + 2.0 * saturation * (full + left * correction)
                + saturation * saturation * (left * by_s - correction);
            let correction_by = |n: usize| {
                let angles = PER_ELEVATION[0] * along.slopes[0][n] * rest[3][k]
                    + PER_AZIMUTH[0] * along.slopes[1][n] * rest[4][k];
                let plane = if k == 0 {
                    0.0
                } else {
                    let of = |m: usize| if m == n { 1.0 } else { 0.0 } - unit[m] * unit[n];
                    (planes[0][2 * k - 2] * of(1) + planes[0][2 * k - 1] * of(2)) / length
                };
                unfold[k] * angles + plane
            };
            // By X.
            let by_x = [0, 1, 2].map(|n| {
                force_by_s * ds_dlength * unit[n]
                    + saturation * saturation * left * correction_by(n)
            });
            let squared = saturation * saturation;
            for n in 0..3 {
                let full_by = by_limit.sliding[k][n]
                    + unfold_slip[k]
                        * (PER_ELEVATION[1] * slip.slopes[0][n] * sliding[3][k]
                            + PER_AZIMUTH[1] * slip.slopes[1][n] * sliding[4][k]);
                slopes[k][n] =
                    left * left * by_limit.linear[k][n] + squared * full_by + scale[n] * by_x[n];
            }
            let by_t = by_limit.sliding[k][3] * inside_slope
                + by_ratio * unfold_slip[k] * sliding[1][k]
                + left * by_ratio * (unfold[k] * rest[1][k] + plane_of(&planes[1]));
            slopes[k][3] = left * left * by_limit.linear[k][3]
                + squared * by_t
                + (0..3).map(|n| by_x[n] * scaled_by_t[n]).sum::<f64>();
        }
        slopes[3] = slip_slopes(&rest, &along, [ds_dlength, by_ratio], unit, scale, scaled_by_t);
        let left_by = |n: usize| -ds_dlength * unit[n];
        let left_slopes = [
            scale[0] * left_by(0),
            scale[1] * left_by(1),
            scale[2] * left_by(2),
            (0..3).map(|n| scaled_by_t[n] * left_by(n)).sum(),
        ];
        let found = EllipseForce { force, slip_share: rest[0][3].clamp(0.0, 1.0) };
        (Interpolated { found, left }, slopes, left_slopes)
    }
}

/// Derivatives of the share of slip, the last channel of `rest`, by the three creepages v and
/// ln(a/b): with those of the saturation by ρ and of the place in the table by ln(a/b), of X by v,
/// and of X by ln(a/b).
fn slip_slopes(
    rest: &coefficients::Sums,
    along: &Direction,
    [by_length, by_ratio]: [f64; 2],
    unit: [f64; 3],
    scale: [f64; 3],
    scaled_by_t: [f64; 3],
) -> [f64; 4] {
    if rest[0][3] <= 0.0 || rest[0][3] >= 1.0 {
        return [0.0; 4];
    }
    // Of an even function: what was folded does not count.
    let by_x = [0, 1, 2].map(|n| {
        SATURATION_CELLS as f64 * rest[2][3] * by_length * unit[n]
            + PER_ELEVATION[0] * along.slopes[0][n] * rest[3][3]
            + PER_AZIMUTH[0] * along.slopes[1][n] * rest[4][3]
    });
    let by_t: f64 = (0..3).map(|n| by_x[n] * scaled_by_t[n]).sum();
    let [x, y, z] = [0, 1, 2].map(|n| scale[n] * by_x[n]);
    [x, y, z, by_t + by_ratio * rest[1][3]]
}
