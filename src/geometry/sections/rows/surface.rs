//! The surface of a rail that varies along the track, row by row.
//!
//! Rows of a roller go around its axle. Corrugation lifts all rows alike, over the station, on top
//! of what the slices say.

use super::roller::{Around, Roller};
use crate::geometry::sections::slices::{RowKnot, Rows};
use crate::geometry::uneven::waviness::Waviness;
use crate::math::real::Real;

/// Farthest place of touch from the axle [m].
pub(in crate::geometry) const REACH: f64 = 0.12;
/// The same along rows that drift or rise: flanges touch rows that come from the side far ahead [m].
pub(in crate::geometry) const REACH_ALONG: f64 = 0.3;

/// A row at one place: point and derivative across, both with their derivatives along the track.
#[derive(Clone, Copy, Debug)]
pub(in crate::geometry) struct RowPoint<T = f64> {
    /// y, z, and their derivatives across.
    pub value: [T; 4],
    /// Derivatives of these along the track.
    pub first: [T; 4],
    /// Second derivatives of y and z along the track.
    pub second: [T; 2],
}

/// Slices around a station.
#[derive(Clone, Copy, Debug)]
pub(in crate::geometry) struct Within {
    /// Number of the slice before the station.
    pub slice: usize,
    /// Numbers of the slices around all that is within reach.
    pub ends: [usize; 2],
}

/// Rows of a rail.
#[derive(Clone, Debug)]
pub(in crate::geometry) struct Surface {
    pub rows: Rows,
    /// The roller that the rows go around, of which they are the section at the top; nothing for a
    /// rail.
    pub roller: Option<Roller>,
    /// Height of the rail over the station on top of that of its rows; of a roller, over its arc.
    pub corrugation: Waviness,
}

/// Greatest place along the track on a roller, over its radius: a wheel never goes there from above
/// [-].
pub(in crate::geometry) const MAX_SHARE_OF_ROLLER: f64 = 0.8;

impl Surface {
    /// Number of rows.
    pub fn count(&self) -> usize {
        self.rows.parameter.len()
    }

    /// Whether all rows are higher by a corrugation.
    pub fn is_corrugated(&self) -> bool {
        !self.corrugation.is_empty()
    }

    /// The slices around `station` [m].
    pub fn within(&self, station: f64) -> Within {
        let places = &self.rows.places;
        let before = |s: f64| places.partition_point(|p| *p <= s).max(1) - 1;
        let behind = places.partition_point(|p| *p < station + REACH).min(places.len() - 1);
        Within { slice: before(station), ends: [before(station - REACH), behind] }
    }

    /// Faces between neighbouring slices and rows that a wheel between two stations may touch [m],
    /// by their corners (y, z) [m].
    pub fn faces_near(
        &self,
        [from, to]: [f64; 2],
    ) -> impl Iterator<Item = [[f64; 2]; 4]> + Clone + '_ {
        let count = self.count();
        let last = self.within(to + REACH_ALONG).slice + 1;
        let first = self.within(from - REACH_ALONG).slice;
        let slices = self.rows.knots.chunks(count).skip(first).take(last - first);
        slices
            .zip(self.rows.knots.chunks(count).skip(first + 1))
            .flat_map(|(here, next)| {
                here.windows(2).zip(next.windows(2)).map(|(a, b)| {
                    [a[0], a[1], b[0], b[1]].map(|knot| [knot.value[0], knot.value[1]])
                })
            })
            .filter(|face| face.iter().all(|corner| corner[0].is_finite()))
    }

    /// Row `j` at a `station` [m] of a `run` of slices, looked for from the slice `near`; the
    /// surface of the slices is held at the ends of the rail.
    pub fn at<T: Real>(&self, j: usize, run: [usize; 2], station: T, near: usize) -> RowPoint<T> {
        if let Some(roller) = &self.roller {
            return self.on_roller(roller, j, station);
        }
        let mut point = self.at_without_waves(j, run, station, near);
        if !self.corrugation.is_empty() {
            let [height, slope, curvature] = self.corrugation.moving(station);
            point.value[1] -= height;
            point.first[1] -= slope;
            point.second[1] -= curvature;
        }
        point
    }

    /// Its point (y, z) alone.
    pub fn point(&self, j: usize, run: [usize; 2], station: f64, near: usize) -> [f64; 2] {
        if let Some(roller) = &self.roller {
            let [y, z, ..] = self.on_roller(roller, j, station).value;
            return [y, z];
        }
        let [y, z] = self.point_at(j, run, station, near);
        let lifted =
            if self.corrugation.is_empty() { 0.0 } else { self.corrugation.height(station) };
        [y, z - lifted]
    }

    /// As [`at`](Self::at), of a rail without corrugation.
    pub fn at_without_waves<T: Real>(
        &self,
        j: usize,
        run: [usize; 2],
        station: T,
        near: usize,
    ) -> RowPoint<T> {
        let places = &self.rows.places;
        let zero = T::from(0.0);
        let (i, ends) = match self.between_slices(j, run, station.value(), near) {
            Ok(found) => found,
            Err(held) => {
                let value = held.value.map(T::from);
                return RowPoint { value, first: [zero; 4], second: [zero; 2] };
            }
        };
        let [from, to] = ends;
        let inverse = 1.0 / (places[i + 1] - places[i]);
        let u = station - places[i];
        let mut point = RowPoint { value: [zero; 4], first: [zero; 4], second: [zero; 2] };
        for c in 0..4 {
            let rise = (to.value[c] - from.value[c]) * inverse;
            let (a, b) = (from.slope[c], to.slope[c]);
            let c2 = (3.0 * rise - 2.0 * a - b) * inverse;
            let c3 = (a + b - 2.0 * rise) * inverse * inverse;
            point.value[c] = u * (u * (u * c3 + c2) + a) + from.value[c];
            point.first[c] = u * (u * (3.0 * c3) + 2.0 * c2) + a;
            if c < 2 {
                point.second[c] = u * (6.0 * c3) + 2.0 * c2;
            }
        }
        point
    }

    /// The slice behind which row `j` is at `place` [m] on a `run` of slices, looked for from the
    /// slice `near`, and the row on that and the next one; where it is held, the row there.
    fn between_slices(
        &self,
        j: usize,
        [first, last]: [usize; 2],
        place: f64,
        near: usize,
    ) -> Result<(usize, [&RowKnot; 2]), &RowKnot> {
        let (places, count) = (&self.rows.places, self.count());
        let knot = |i: usize| &self.rows.knots[i * count + j];
        // What ends within the rail has its slope up to there, and is met no farther.
        if place <= places[first] && first == 0 {
            return Err(knot(first));
        }
        if place >= places[last] && last + 1 == places.len() || first == last {
            return Err(knot(last));
        }
        let mut i = near.clamp(first, last - 1);
        while i > first && places[i] > place {
            i -= 1;
        }
        while i + 1 < last && places[i + 1] <= place {
            i += 1;
        }
        Ok((i, [knot(i), knot(i + 1)]))
    }

    /// The point (y, z) of row `j`, as [`at_without_waves`](Self::at_without_waves).
    pub fn point_at<T: Real>(&self, j: usize, run: [usize; 2], station: T, near: usize) -> [T; 2] {
        let (i, [from, to]) = match self.between_slices(j, run, station.value(), near) {
            Ok(found) => found,
            Err(held) => return [held.value[0].into(), held.value[1].into()],
        };
        let places = &self.rows.places;
        let inverse = 1.0 / (places[i + 1] - places[i]);
        let u = station - places[i];
        [0, 1].map(|c| {
            let rise = (to.value[c] - from.value[c]) * inverse;
            let (a, b) = (from.slope[c], to.slope[c]);
            let c2 = (3.0 * rise - 2.0 * a - b) * inverse;
            u * (u * (u * ((a + b - 2.0 * rise) * inverse * inverse) + c2) + a) + from.value[c]
        })
    }

    /// Row `j` at `x` from the axle of a `roller` [m].
    fn on_roller<T: Real>(&self, roller: &Roller, j: usize, x: T) -> RowPoint<T> {
        let [y, depth, dy, dz] = self.rows.knots[j].value;
        let Around { z, by_row, first, second } = roller.row(depth, &self.corrugation, x);
        let zero = T::from(0.0);
        RowPoint {
            value: [y.into(), z, dy.into(), by_row * dz],
            first: [zero, first[0], zero, first[1] * dz],
            second: [zero, second],
        }
    }

    /// The surface at the row parameter `v` and at a `station` [m], by cubics across through the
    /// rows beside it, which a body over the place `over` [m] behind the slice `near` meets;
    /// nothing where one of them is not there.
    pub fn between(&self, v: f64, station: f64, over: f64, near: usize) -> Option<RowPoint> {
        let parameter = &self.rows.parameter;
        let i = parameter.partition_point(|p| *p <= v).clamp(1, parameter.len() - 1) - 1;
        let beside = |j: usize| Some(self.at(j, self.run(j, over, near)?, station, near));
        let (a, b) = (beside(i)?, beside(i + 1)?);
        let h = parameter[i + 1] - parameter[i];
        let t = (v - parameter[i]) / h;
        // Value and slope of a cubic by those at its ends.
        let cubic = |[p, m, q, n]: [f64; 4]| {
            let (m, n, rise) = (h * m, h * n, q - p);
            let (c2, c3) = (3.0 * rise - 2.0 * m - n, m + n - 2.0 * rise);
            [p + t * (m + t * (c2 + t * c3)), (m + t * (2.0 * c2 + 3.0 * t * c3)) / h]
        };
        let across = |a: [f64; 4], b: [f64; 4]| {
            let [y, z] = [0, 1].map(|c| cubic([a[c], a[c + 2], b[c], b[c + 2]]));
            [y[0], z[0], y[1], z[1]]
        };
        Some(RowPoint {
            value: across(a.value, b.value),
            first: across(a.first, b.first),
            second: [0, 1].map(|c| a.second[c] + t * (b.second[c] - a.second[c])),
        })
    }

    /// The run of slices of row `j` that a wheel at `station` [m] is over, or the nearest one
    /// within reach.
    pub fn run(&self, j: usize, station: f64, slice: usize) -> Option<[usize; 2]> {
        let (places, count) = (&self.rows.places, self.count());
        let of = |i: usize| self.rows.runs[i * count + j].map(|run| run.map(|i| i as usize));
        let (before, after) = (slice, (slice + 1).min(places.len() - 1));
        match (of(before), of(after)) {
            (Some(a), Some(b)) if a != b => {
                let middle = 0.5 * (places[before] + places[after]);
                Some(if station < middle { a } else { b })
            }
            (Some(run), _) | (None, Some(run)) => Some(run),
            (None, None) => {
                let behind = (0..before).rev().take_while(|&i| station - places[i] < REACH);
                let ahead = (after..places.len()).take_while(|&i| places[i] - station < REACH);
                behind.chain(ahead).find_map(of)
            }
        }
    }

    /// From where to where a run of slices is within reach of a wheel at `station` [m]; nothing
    /// where it is not.
    pub fn reach<T: Real>(&self, [first, last]: [usize; 2], station: T) -> Option<[T; 2]> {
        let places = &self.rows.places;
        let at = |i: usize| -station + places[i];
        if self.roller.is_some() {
            return within(at(first).at_least(-REACH), at(last).at_most(REACH));
        }
        // A row that goes on to the end of the rail is held there.
        let from = if first == 0 { T::from(-REACH) } else { at(first).at_least(-REACH) };
        let to = if last + 1 == places.len() { T::from(REACH) } else { at(last).at_most(REACH) };
        within(from, to)
    }

    /// From where to where row `j` is there on a run of slices, from `station` [m]: without end
    /// where it goes on to the end of the rail, or where the surface is broken and another run
    /// follows.
    pub fn ends(&self, j: usize, [first, last]: [usize; 2], station: f64) -> [f64; 2] {
        let places = &self.rows.places;
        let from = if first == 0 || self.is_there(j, first - 1) {
            f64::NEG_INFINITY
        } else {
            places[first] - station
        };
        let to = if last + 1 == places.len() || self.is_there(j, last + 1) {
            f64::INFINITY
        } else {
            places[last] - station
        };
        [from, to]
    }

    /// Places at which rows begin or end within the rail [m].
    pub fn free_ends(&self) -> Vec<f64> {
        let is_end = |i: &usize| {
            let is_there = |j: usize, i: usize| self.is_there(j, i);
            (0..self.count())
                .any(|j| is_there(j, *i) && !(is_there(j, *i - 1) && is_there(j, *i + 1)))
        };
        let places = &self.rows.places;
        (1..places.len() - 1).filter(is_end).map(|i| places[i]).collect()
    }

    /// Whether row `j` is there on slice number `i`.
    fn is_there(&self, j: usize, i: usize) -> bool {
        self.rows.runs[i * self.count() + j].is_some()
    }

    /// How fast the section of the pattern passes row `j` [-].
    pub fn pattern_speed(&self, j: usize) -> f64 {
        let [_, _, dy, dz] = self.rows.pattern[j];
        (dy * dy + dz * dz).sqrt()
    }
}

/// From one place to another one; nothing where there is nothing between them.
fn within<T: Real>(from: T, to: T) -> Option<[T; 2]> {
    (from <= to).then_some([from, to])
}
