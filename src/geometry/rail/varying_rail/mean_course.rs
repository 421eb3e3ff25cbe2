//! The mean course of the rows of a rail near a wheel.
//!
//! Each row goes by its chord over a finger's breadth about the place at which it would be met if
//! it went along the track, and weighs by how near it is to the wheel there,
//!
//! ```text
//! w = exp(-(g - min g)/h)
//! ```
//!
//! g how far below the wheel it is. Rows that go apart, as those of a nose and
//! of the wing beside it, have no course in common: by 1/(1 + (σ/0.01)²), with σ their standard
//! deviation about the mean, it goes back to the track. Chords bridge kinks, as at the ends of
//! the rail, and rows that come within reach do so far below the wheel, so that the mean is a
//! smooth function of the pose.

use super::about_axle::{OnProfile, Polar, parameter_at};
use super::over::Over;
use super::touch::CLOSE;
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
/// count: by a weight of 1e-7 the mean turns by 1e-9 at most.
const FADES: f64 = 5e-4;
const FARTHEST: f64 = 16.0;
/// How far the rows may go apart, by their standard deviation, so that half of their course counts:
/// rails that drift by as much are right in the axes of the track [-].
const APART: f64 = 0.01;

/// How the rows of a rail go.
#[derive(Clone, Debug)]
pub(super) struct Courses {
    /// For each slice the number of slices up to it before which any row drifts or rises.
    turns: Vec<u32>,
    /// The even wheel that is to meet them.
    wheel: WheelTable,
}

/// Course and nearness of one row, and where it is met.
struct RowCourse<T> {
    gap: T,
    rates: [T; 2],
    met: Beside<T>,
}

/// Where a row is met: along the track and along the axle [m], and the parameter of the wheel
/// opposite.
#[derive(Clone, Copy)]
struct Beside<T> {
    x: T,
    axial: f64,
    u: f64,
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
    /// [m], as a few `rows` tell, which are at least as far below it as their `lows` say; nothing
    /// where these do not drift or rise.
    pub fn near<T: Real>(
        &self,
        surface: &Surface,
        (rows, lows): (&[usize], &[f64]),
        line: &ContactLine<T>,
        pose: &WheelPose<T>,
        station: T,
    ) -> Option<Course<T>> {
        if !self.turn(surface, station.value()) {
            return None;
        }
        let within = surface.within(station.value());
        let over = Over::new(line, pose, station, within);
        // The row that may be nearest tells which ones need not be looked at.
        let course_of = |j: usize, beside| own(surface, &self.wheel, &over, (j, beside));
        let rows = rows.iter().copied().zip(lows);
        let (first, _) = rows.clone().min_by(|a, b| a.1.total_cmp(b.1))?;
        let near = course_of(first, None).map_or(f64::INFINITY, |row| row.gap.value());
        let (mut sums, mut beside) = (Sums { least: f64::INFINITY, ..Sums::default() }, None);
        for (j, _) in rows.filter(|(_, low)| **low < near + FARTHEST * FADES) {
            if let Some(row) = course_of(j, beside) {
                beside = Some(row.met);
                sums.add(&row);
            }
        }
        let rates = sums.common()?;
        let goes = rates.iter().any(|rate| rate.value() != 0.0);
        (goes || T::HAS_SLOPES).then(|| Course::new(rates, pose.marker))
    }
}

/// Sums over rows, weighted by how near they are.
#[derive(Default)]
struct Sums<T> {
    /// The gap of the row whose weight is one [m].
    least: f64,
    total: T,
    rates: [T; 2],
    squares: T,
}

impl<T: Real> Sums<T> {
    fn add(&mut self, row: &RowCourse<T>) {
        let gap = row.gap.value();
        if gap < self.least {
            // Weights count from the nearest row.
            let fade = ((gap - self.least) / FADES).exp();
            self.least = gap;
            self.total *= fade;
            self.rates = self.rates.map(|sum| sum * fade);
            self.squares *= fade;
        }
        let beyond = (row.gap - self.least) / FADES;
        if beyond.value() > FARTHEST {
            return;
        }
        let weight = (-beyond).exp();
        self.total += weight;
        self.rates = [0, 1].map(|c| self.rates[c] + weight * row.rates[c]);
        self.squares += weight * dot(row.rates, row.rates);
    }

    /// The rates that the rows have in common; nothing without rows.
    fn common(&self) -> Option<[T; 2]> {
        if self.total.value() <= 0.0 {
            return None;
        }
        let mean = self.rates.map(|sum| sum / self.total);
        let spread = (self.squares / self.total - dot(mean, mean)).at_least(0.0);
        let agreement = T::from(1.0) / (spread / (APART * APART) + 1.0);
        Some(mean.map(|rate| rate * agreement))
    }
}

/// Row `j` where the contact line of the wheel `over` it would meet it along the track, by its
/// `table` and where the row `beside` is met; nothing where the row is not there or the wheel stands
/// upright.
fn own<T: Real>(
    surface: &Surface,
    table: &WheelTable,
    over: &Over<T>,
    (j, beside): (usize, Option<Beside<T>>),
) -> Option<RowCourse<T>> {
    let (slice, station) = (over.within.slice, over.station);
    let run = surface.run(j, station.value(), slice)?;
    let [from, to] = surface.reach(run, station)?;
    let at = |x: T| surface.point_at(j, run, station + x, slice);
    let clamped = |x: T| {
        if x < from {
            from
        } else if x > to {
            to
        } else {
            x
        }
    };
    // Opposite to the row where that beside it is met; where it would be met; opposite to it there.
    let x = clamped(beside.map_or(T::from(0.0), |b| b.x));
    let Polar { axial, .. } = Polar::of(over, x, at(x));
    let near = beside.filter(|b| (b.axial - axial.value()).abs() < CLOSE);
    let u = match near {
        Some(near) => near.u + axial.value() - near.axial,
        None => table.parameter(axial.value())?,
    };
    let [s, _] = opposite(over, axial, u)?;
    let x = clamped(over.line().even_at(s).x);
    let Polar { axial, radius: distance, .. } = Polar::of(over, x, at(x));
    let [s, radius] = opposite(over, axial, s.value())?;
    let [a, b] = [x - CHORD, x + CHORD].map(clamped);
    let length = b - a;
    if length.value() <= 0.0 {
        return None;
    }
    let [p, q] = [a, b].map(at);
    let rates = [0, 1].map(|c| (q[c] - p[c]) / length);
    let met = Beside { x, axial: axial.value(), u: s.value() };
    Some(RowCourse { gap: distance - radius, rates, met })
}

/// Parameter of the wheel, and its radius, at a coordinate along the axle, sought near the parameter
/// `u` [m]; nothing where it stands upright.
fn opposite<T: Real>(over: &Over<T>, axial: T, u: f64) -> Option<[T; 2]> {
    let found = parameter_at(over.line(), axial.value(), u)?;
    let on = OnProfile::at(over.line(), found.into(), axial);
    Some([on.missing * on.rate + found, on.radius + on.missing * on.slope])
}
