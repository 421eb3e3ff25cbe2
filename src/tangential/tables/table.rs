//! The table in memory: interpolation of its splines, without and with derivatives.

use std::f64::consts::{FRAC_PI_2, PI};

use super::bound::Bound;
use super::coefficients::{self, Place};
use super::direction::Direction;
use super::nodes::{
    AZIMUTH_CELLS, ELEVATION_CELLS, HALF, LOG_RATIO, Nodes, RATIO_CELLS, SATURATION_CELLS,
    SLIDING_AZIMUTH_CELLS, SLIDING_ELEVATION_CELLS,
};
use super::scales::Scales;
use super::splines::Splines;

use super::ellipse_force::{EllipseForce, ForceSlopes};
use super::sliding;
use crate::math::b_spline;
use crate::math::until_unload::UntilUnload;

/// The committed table.
const FILE: &[u8] = include_bytes!("creep_forces.table");

/// How far ln(a/b) goes on beyond the ends of the table before it rests; splines are carried on
/// that far.
const END: f64 = 0.1;

/// Creepages beyond this are full sliding to rounding.
const MAX_CREEPAGE: f64 = 1e60;

/// The table in memory.
#[derive(Clone, Debug)]
pub struct CreepForceTable {
    splines: Splines,
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

fn place(u: f64, cells: usize) -> Place {
    let (first, fraction) = b_spline::locate(u, cells);
    Place { first, weights: b_spline::weights(fraction), slopes: b_spline::weight_slopes(fraction) }
}

/// A coordinate that is not there.
const NONE: Place = Place { first: 0, weights: [1.0, 0.0, 0.0, 0.0], slopes: [0.0; 4] };

/// Nodes per unit of ln(a/b), elevation and azimuth.
const PER_RATIO: f64 = RATIO_CELLS as f64 / (2.0 * LOG_RATIO);
const PER_ELEVATION: [f64; 2] =
    [ELEVATION_CELLS as f64 / FRAC_PI_2, SLIDING_ELEVATION_CELLS as f64 / FRAC_PI_2];
const PER_AZIMUTH: [f64; 2] = [AZIMUTH_CELLS as f64 / PI, SLIDING_AZIMUTH_CELLS as f64 / PI];

/// Folds or unfolds the signs of longitudinal force, lateral force and moment.
fn signs([mirror, turn]: [f64; 2]) -> [f64; 3] {
    [mirror, turn, turn]
}

impl CreepForceTable {
    /// The committed table, laid out on first use in the process; takes some milliseconds then.
    ///
    /// # Panics
    /// If the file in the library has another size than the code, which a test excludes.
    #[must_use]
    pub fn shared() -> &'static Self {
        static TABLE: UntilUnload<CreepForceTable> = UntilUnload::new();
        TABLE.get_or_init(|| {
            let nodes = Nodes::from_bytes(FILE).expect("the table in the library is whole");
            Self::new(&nodes)
        })
    }

    /// A table of these numbers.
    #[must_use]
    pub fn new(nodes: &Nodes) -> Self {
        Self { splines: Splines::new(nodes) }
    }

    /// The numbers of the committed table, with their error estimates.
    #[must_use]
    pub fn committed_nodes() -> Option<Nodes> {
        Nodes::from_bytes(FILE)
    }

    /// Creep force of an ellipse with these `scales` for finite creepages `v`.
    #[must_use]
    pub fn force(&self, scales: &Scales, v: [f64; 3]) -> EllipseForce {
        let Some((v, scaled)) = within_range(scales, v) else { return EllipseForce::default() };
        let along = Direction::of(scaled);
        let saturation = along.length / (along.length + HALF);
        let left = HALF / (along.length + HALF);
        let [inside, _] = at_rest_beyond(scales.log_ratio);
        let ratio = place((inside + LOG_RATIO) * PER_RATIO, RATIO_CELLS);
        let radius = place(saturation * SATURATION_CELLS as f64, SATURATION_CELLS);
        let rest = self.splines.creep.value(&[
            ratio,
            radius,
            place(along.elevation * PER_ELEVATION[0], ELEVATION_CELLS),
            place(along.azimuth * PER_AZIMUTH[0], AZIMUTH_CELLS),
        ]);
        let planes = self.splines.planes.plane_value([&ratio, &radius]);
        let unfold = signs(along.signs);
        let [y, z] = [scaled[1] / along.length, scaled[2] / along.length];
        let plane = [0.0, planes[0] * y + planes[1] * z, planes[2] * y + planes[3] * z];

        let slip = Direction::of(v);
        let sliding = self.splines.sliding.value(&[
            ratio,
            NONE,
            place(slip.elevation * PER_ELEVATION[1], SLIDING_ELEVATION_CELLS),
            place(slip.azimuth * PER_AZIMUTH[1], SLIDING_AZIMUTH_CELLS),
        ]);
        let unfold_slip = signs(slip.signs);
        let closed = sliding::closed_form(inside, v);
        let linear = scales.linear(v);
        let mut force = [0.0; 3];
        for k in 0..3 {
            let correction = unfold[k] * rest[k] + plane[k];
            let full = closed[k] + unfold_slip[k] * sliding[k];
            force[k] =
                left * left * linear[k] + saturation * saturation * (full + left * correction);
        }
        let bound = Bound::of(&force, left);
        EllipseForce { force: bound.applied(force), slip_share: rest[3].clamp(0.0, 1.0) }
    }

    /// The same with its derivatives.
    #[must_use]
    pub fn force_and_slopes(&self, scales: &Scales, v: [f64; 3]) -> (EllipseForce, ForceSlopes) {
        let Some((v, scaled)) = within_range(scales, v) else {
            let [x, y, moment] = scales.linear_slopes([0.0; 3]);
            return (EllipseForce::default(), [x, y, moment, [0.0; 4]]);
        };
        let along = Direction::of(scaled);
        let length = along.length;
        let saturation = length / (length + HALF);
        let left = HALF / (length + HALF);
        let [inside, inside_slope] = at_rest_beyond(scales.log_ratio);
        let ratio = place((inside + LOG_RATIO) * PER_RATIO, RATIO_CELLS);
        let by_ratio = PER_RATIO * inside_slope;
        let radius = place(saturation * SATURATION_CELLS as f64, SATURATION_CELLS);
        let rest = self.splines.creep.value_and_slopes(&[
            ratio,
            radius,
            place(along.elevation * PER_ELEVATION[0], ELEVATION_CELLS),
            place(along.azimuth * PER_AZIMUTH[0], AZIMUTH_CELLS),
        ]);
        let planes = self.splines.planes.plane_value_and_slopes([&ratio, &radius]);
        let unfold = signs(along.signs);
        let unit = scaled.map(|x| x / length);
        let slip = Direction::of(v);
        let sliding = self.splines.sliding.value_and_slopes(&[
            ratio,
            NONE,
            place(slip.elevation * PER_ELEVATION[1], SLIDING_ELEVATION_CELLS),
            place(slip.azimuth * PER_AZIMUTH[1], SLIDING_AZIMUTH_CELLS),
        ]);
        let unfold_slip = signs(slip.signs);
        let (closed, closed_slopes) = sliding::closed_form_and_slopes(inside, v);
        let (linear, linear_slopes) = (scales.linear(v), scales.linear_slopes(v));
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
                let full_by = closed_slopes[k][n]
                    + unfold_slip[k]
                        * (PER_ELEVATION[1] * slip.slopes[0][n] * sliding[3][k]
                            + PER_AZIMUTH[1] * slip.slopes[1][n] * sliding[4][k]);
                slopes[k][n] =
                    left * left * linear_slopes[k][n] + squared * full_by + scale[n] * by_x[n];
            }
            let by_t = closed_slopes[k][3] * inside_slope
                + by_ratio * unfold_slip[k] * sliding[1][k]
                + left * by_ratio * (unfold[k] * rest[1][k] + plane_of(&planes[1]));
            slopes[k][3] = left * left * linear_slopes[k][3]
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
        let bound = Bound::of(&force, left);
        let slopes = bound.applied_to_slopes(&force, slopes, left_slopes);
        let force = bound.applied(force);
        (EllipseForce { force, slip_share: rest[0][3].clamp(0.0, 1.0) }, slopes)
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

/// Creepages that are small enough to be squared, and X; nothing where they are so small that their
/// squares vanish.
fn within_range(scales: &Scales, v: [f64; 3]) -> Option<([f64; 3], [f64; 3])> {
    let most = v.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    let v = if most > MAX_CREEPAGE { v.map(|v| v / most * MAX_CREEPAGE) } else { v };
    (most > 1e-60).then(|| (v, scales.scaled(v)))
}
