//! The mean course of the rows of a rail near a wheel.
//!
//! Each row goes by its chord over a finger's breadth about the place at which it would be met if
//! it went along the track, and weighs by how near it is to the wheel there,
//!
//! ```text
//! w = exp(-(g - min g)/h)
//! ```
//!
//! g its distance from the wheel along the normal of that. Rows that go apart, as those of a nose and
//! of the wing beside it, have no course in common: by 1/(1 + (σ/0.01)²), with σ their standard
//! deviation about the mean, it goes back to the track. Chords bridge kinks, as at the ends of
//! the rail, and rows that come within reach do so far below the wheel, so that the mean is a
//! smooth function of the pose.

use super::over::Over;
use super::wheel_table::WheelTable;
use crate::geometry::curves::curve::Curve;
use crate::geometry::rail::course::Course;
use crate::geometry::sections::rows::plane::dot;
use crate::geometry::sections::rows::surface::{REACH, Surface};
use crate::geometry::wheel::contact_line::ContactLine;
use crate::geometry::wheel::wheel_pose::WheelPose;
use crate::math::real::Real;

/// Half of a chord [m].
const CHORD: f64 = 0.01;
/// Distance h over which a row weighs less, by e [m], and multiples of it beyond which it does not
/// count: a weight below rounding.
const FADES: f64 = 5e-4;
const FARTHEST: f64 = 40.0;
/// How far the rows may go apart, by their standard deviation, so that half of their course counts:
/// rails that drift by as much are right in the axes of the track [-].
const APART: f64 = 0.01;
/// Rows of which one is asked for its course.
const STRIDE: usize = 3;

/// How the rows of a rail go.
#[derive(Clone, Debug)]
pub(super) struct Courses {
    /// For each slice the number of slices up to it before which any row drifts or rises.
    turns: Vec<u32>,
    /// The even wheel that is to meet them.
    wheel: WheelTable,
}

/// Course and nearness of one row.
struct RowCourse<T> {
    gap: T,
    rates: [T; 2],
}

impl Courses {
    /// Those of the rows of `surface` under a wheel with the profile `wheel`.
    pub fn new(surface: &Surface, wheel: &Curve) -> Self {
        let rows = &surface.rows;
        let count = surface.count();
        let mut turns = vec![0; rows.places.len()];
        for i in 1..rows.places.len() {
            let turning = (0..count).any(|j| {
                let [a, b] = [i - 1, i].map(|i| &rows.knots[i * count + j]);
                let is_there = a.value[0].is_finite() && b.value[0].is_finite();
                let goes = |c: usize| {
                    let changes = [a.value[c] - b.value[c], a.slope[c], b.slope[c]];
                    changes.iter().any(|change| change.abs() > 0.0)
                };
                is_there && (goes(0) || goes(1))
            });
            turns[i] = turns[i - 1] + u32::from(turning);
        }
        Self { turns, wheel: WheelTable::new(wheel, std::iter::empty()) }
    }

    /// Whether any row within reach of a wheel at `station` [m] drifts or rises.
    fn turn(&self, surface: &Surface, station: f64) -> bool {
        let places = &surface.rows.places;
        let reach = REACH + CHORD;
        let from = places.partition_point(|p| *p <= station - reach).max(1) - 1;
        let to = places.partition_point(|p| *p < station + reach).min(places.len() - 1);
        surface.roller.is_none() && self.turns[to] > self.turns[from]
    }

    /// Axes along the rows near the wheel of the even `line` that stands at `pose` above `station`
    /// [m]; nothing where these do not drift or rise.
    pub fn near<T: Real>(
        &self,
        surface: &Surface,
        line: &ContactLine<T>,
        pose: &WheelPose<T>,
        station: T,
    ) -> Option<Course<T>> {
        if !self.turn(surface, station.value()) {
            return None;
        }
        let within = surface.within(station.value());
        let over = Over::new(line, pose, station, within);
        let fixed_line = line.value();
        let fixed_pose = WheelPose {
            marker: pose.marker.map(T::value),
            roll: pose.roll.value(),
            yaw: pose.yaw.value(),
        };
        let fixed = Over::new(&fixed_line, &fixed_pose, station.value(), within);
        let rows = || (0..surface.count()).step_by(STRIDE);
        let gap = |j: usize| own(surface, &self.wheel, &fixed, &fixed, j).map(|row| row.gap);
        let least = rows().filter_map(gap).fold(f64::INFINITY, f64::min);
        let (mut sum, mut squares, mut total) = ([T::from(0.0); 2], T::from(0.0), T::from(0.0));
        for j in rows() {
            let Some(row) = own(surface, &self.wheel, &fixed, &over, j) else { continue };
            let beyond = (row.gap - least) / FADES;
            if beyond.value() > FARTHEST {
                continue;
            }
            let weight = (T::from(0.0) - beyond).exp();
            total += weight;
            sum = [0, 1].map(|c| sum[c] + weight * row.rates[c]);
            squares += weight * dot(row.rates, row.rates);
        }
        if total.value() <= 0.0 {
            return None;
        }
        let mean = sum.map(|sum| sum / total);
        let spread = (squares / total - dot(mean, mean)).at_least(0.0);
        let agreement = T::from(1.0) / (spread / (APART * APART) + 1.0);
        let rates = mean.map(|rate| rate * agreement);
        let goes = rates.iter().any(|rate| rate.value() != 0.0);
        (goes || T::HAS_SLOPES).then(|| Course::new(rates, pose.marker))
    }
}

/// Row `j` where the wheel `over` it would meet it along the track, by its `table` and the same
/// wheel at rest, `fixed`; nothing where the row is not there or the wheel stands upright.
fn own<T: Real>(
    surface: &Surface,
    table: &WheelTable,
    fixed: &Over,
    over: &Over<T>,
    j: usize,
) -> Option<RowCourse<T>> {
    let slice = over.within.slice;
    let run = surface.run(j, fixed.station, slice)?;
    let [from, to] = surface.reach(run, over.station)?;
    let at = |x: T| surface.at_without_waves(j, run, over.station + x, slice);
    let clamped = |x: T| {
        if x < from {
            from
        } else if x > to {
            to
        } else {
            x
        }
    };
    // Opposite to the row below the axle; where that would be met; opposite to it there.
    let mut x = clamped(T::from(0.0));
    let mut p = at(x);
    let [across, _] = over.in_wheel(&p);
    let mut u = table.parameter(across.value())?;
    for _ in 0..2 {
        let [across, _] = over.in_wheel(&p);
        u = fixed.opposite(u, across.value())?.u;
        let met = over.to_across(u, across);
        x = clamped(met.x);
        p = at(x);
    }
    let [across, _] = over.in_wheel(&p);
    u = fixed.opposite(u, across.value())?.u;
    let met = over.to_across(u, across);
    let to_row = [p.value[0] - met.point[0], p.value[1] - met.point[1]];
    let [a, b] = [x - CHORD, x + CHORD].map(clamped);
    let length = b - a;
    if length.value() <= 0.0 {
        return None;
    }
    let [p, q] = [a, b].map(at);
    let rates = [0, 1].map(|c| (q.value[c] - p.value[c]) / length);
    Some(RowCourse { gap: dot(met.normal, to_row), rates })
}
