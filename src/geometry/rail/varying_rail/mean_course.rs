//! The mean course of the rows of a rail near a wheel.
//!
//! Each of some rows goes by its chord over a finger's breadth about the place at which it would be
//! met if it went along the track, and weighs by how near it is to the wheel there,
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

use super::about_axle::Polar;
use super::over::Over;
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
/// count: by a weight of 1e-7 the mean turns by 1e-9 at most. How much nearer than straight below
/// the axle a row may be where it is met, by which it is looked at [m].
const FADES: f64 = 5e-4;
const FARTHEST: f64 = 16.0;
const NEARER: f64 = 4e-3;
/// Distance of the samples of the wheel [m].
const SAMPLE: f64 = 1e-3;
/// How far the rows may go apart, by their standard deviation, so that half of their course counts:
/// rails that drift by as much are right in the axes of the track [-].
const APART: f64 = 0.01;

/// How the rows of a rail go.
#[derive(Clone, Debug)]
pub(super) struct Courses {
    /// The rows that tell.
    rows: Vec<usize>,
    /// For each slice the number of slices up to it before which any row drifts or rises.
    turns: Vec<u32>,
    wheel: EvenWheel,
}

/// The even wheel that is to meet the rows: heights of its profile across [m].
#[derive(Clone, Debug)]
struct EvenWheel {
    start: f64,
    heights: Vec<f64>,
}

impl EvenWheel {
    /// That with the `profile`, of which the lowest point counts where it stands upright.
    fn new(profile: &Curve) -> Self {
        let count = ((profile.end() - profile.start()) / (0.1 * SAMPLE)).ceil();
        let at = |i: usize| profile.start() + (profile.end() - profile.start()) * i as f64 / count;
        let points: Vec<[f64; 2]> = (0..=count as usize).map(|i| profile.at(at(i)).point).collect();
        let ys = points.iter().map(|p| p[0]);
        let [start, end] = ys.fold([f64::MAX, f64::MIN], |[a, b], y| [a.min(y), b.max(y)]);
        let mut heights = vec![f64::MIN; ((end - start) / SAMPLE) as usize + 1];
        for pair in points.windows(2) {
            let [a, b] = [pair[0], pair[1]];
            let [from, to] = [a[0].min(b[0]), a[0].max(b[0])].map(|y| (y - start) / SAMPLE);
            for k in from.ceil() as usize..=(to as usize).min(heights.len() - 1) {
                let share = (k as f64 * SAMPLE + start - a[0]) / (b[0] - a[0]);
                let height = a[1] + share.clamp(0.0, 1.0) * (b[1] - a[1]);
                heights[k] = heights[k].max(height);
            }
        }
        Self { start, heights }
    }

    /// Its height and slope at the coordinate `y` along the axle, by cubics between the samples,
    /// and how far it is beside the wheel [m].
    fn at<T: Real>(&self, y: T) -> ([T; 2], T) {
        let last = self.heights.len() - 1;
        let place = (y - self.start) / SAMPLE;
        let inside = place.within(0.0, last as f64);
        let k = (inside.value() as usize).min(last - 1);
        let [before, a, b, behind] =
            [k.saturating_sub(1), k, k + 1, (k + 2).min(last)].map(|k| self.heights[k]);
        let (t, rise) = (inside - k as f64, b - a);
        let (m, n) = (0.5 * (b - before), 0.5 * (behind - a));
        let (c2, c3) = (3.0 * rise - 2.0 * m - n, m + n - 2.0 * rise);
        let height = t * (t * (t * c3 + c2) + m) + a;
        let slope = (t * (t * (3.0 * c3) + 2.0 * c2) + m) / SAMPLE;
        ([height, slope], (place - inside).abs() * SAMPLE)
    }
}

/// Course and nearness of one row.
struct RowCourse<T> {
    gap: T,
    rates: [T; 2],
}

impl Courses {
    /// Those of the rows of `surface` under a wheel with the profile `wheel`, by every third one of
    /// a `few` of them.
    pub fn new(surface: &Surface, few: &[usize], wheel: &Curve) -> Self {
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
        let rows = few.iter().copied().step_by(3).collect();
        Self { rows, turns, wheel: EvenWheel::new(wheel) }
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
        let mut sums = Sums { least: f64::INFINITY, ..Sums::default() };
        for &j in &self.rows {
            if let Some(row) = own(surface, &self.wheel, &over, j, sums.least) {
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

/// Row `j` about where the contact line of the wheel `over` it would meet it along the track; nothing
/// where the row is not there, or so far below that it does not count beside one that is by `least`
/// [m].
fn own<T: Real>(
    surface: &Surface,
    wheel: &EvenWheel,
    over: &Over<T>,
    j: usize,
    least: f64,
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
    let below = clamped(T::from(0.0));
    let [axial, _, depth] = over.about_axle(below, at(below));
    let ([height, slope], beside) = wheel.at(axial);
    let gap = depth - height - over.nominal_radius() + beside;
    if gap.value() > least + FARTHEST * FADES + NEARER {
        return None;
    }
    let x = over.line().place_on_circle(axial, height, slope);
    let [a, b] = [x - CHORD, x + CHORD].map(clamped);
    let length = b - a;
    if length.value() <= 0.0 {
        return None;
    }
    let [p, q] = [a, b].map(at);
    let rates = [0, 1].map(|c| (q[c] - p[c]) / length);
    let middle = [0, 1].map(|c| (p[c] + q[c]) * 0.5);
    let Polar { axial, radius, .. } = Polar::of(over, (a + b) * 0.5, middle);
    let ([height, _], beside) = wheel.at(axial);
    Some(RowCourse { gap: radius - height - over.nominal_radius() + beside, rates })
}
