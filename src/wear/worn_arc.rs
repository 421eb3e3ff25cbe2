//! Sums of worn material along one profile, on a fixed grid over the arc of the unworn curve.
//!
//! Cells of equal length hold the volume worn off per length of arc, so that what a law takes away
//! is kept to rounding. The grid belongs to the unworn profile; places are given by parameters of
//! the curve in use and carried over. Depths are those of the layer along the inward normal of the
//! unworn profile.

use serde::{Deserialize, Serialize};

pub use super::body::Body;
use super::scratch::Scratch;
use super::section::{POINTS, Station, bulge, shrinking, stations};
use crate::geometry::curves::curve::Curve;
use crate::math::quadrature::GaussLegendre;

/// Length of the cells [m]: the narrowest patches of a flange are ten of them.
pub const CELL: f64 = 2e-4;

/// What a profile has lost: all that has to be remembered of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct ArcState {
    /// Volume per length of arc that the curve in use has lost, for each cell [m³/m].
    pub total: Vec<f64>,
    /// The same since the last update of the curve [m³/m].
    pub pending: Vec<f64>,
    /// Worn volume, both together [m³].
    pub volume: f64,
    /// Worn area of the cross section since the last update [m²].
    pub pending_area: f64,
    /// Greatest depth in `pending` [m].
    pub most_pending: f64,
}

impl ArcState {
    /// Copies `other` over it, without allocating if both are of the same grid.
    pub fn copy_from(&mut self, other: &Self) {
        self.total.clone_from(&other.total);
        self.pending.clone_from(&other.pending);
        (self.volume, self.pending_area, self.most_pending) =
            (other.volume, other.pending_area, other.most_pending);
    }
}

/// The sums along one profile and the way from the curve in use to the grid.
#[derive(Clone, Debug)]
pub struct WornArc {
    pub(super) body: Body,
    pub(super) base: Curve,
    /// Parameter at which the first cell begins, and length of all of them [m].
    pub(super) start: f64,
    pub(super) cell: f64,
    /// What the volume of each cell is spread over: circumference or distance [m].
    pub(super) spread: Vec<f64>,
    /// Mean curvature in the middle of each cell, positive where the body bulges, and share by
    /// which the circumference shrinks with the depth [1/m].
    pub(super) bending: Vec<[f64; 2]>,
    /// The knots of the worn curve on the unworn one, and the moments of the piece before each.
    pub(super) stations: Vec<Station>,
    /// Parameters of the knots of the worn curve, on the unworn and on the worn one [m].
    pub(super) base_knots: Vec<f64>,
    pub(super) worn_knots: Vec<f64>,
    /// What is worn off.
    pub(super) state: ArcState,
    /// Worn area of the cross section and greatest depth of the curve in use [m², m].
    pub(super) area: f64,
    pub(super) depth: f64,
    pub(super) rule: GaussLegendre,
    pub(super) scratch: Scratch,
}

impl WornArc {
    /// No wear yet of the profile with the curve `base`.
    pub fn new(base: &Curve, body: Body) -> Self {
        let (start, length) = (base.start(), base.end() - base.start());
        let count = (length / CELL).ceil().max(4.0) as usize;
        let cell = length / count as f64;
        let spread = (0..count)
            .map(|i| match body {
                Body::Rail { distance } => distance,
                Body::Wheel { nominal_radius } => {
                    let z = base.at(start + (i as f64 + 0.5) * cell).point[1];
                    std::f64::consts::TAU * (nominal_radius + z)
                }
            })
            .collect();
        let base_knots = knots(base, cell);
        let bending = (0..count)
            .map(|i| {
                let s = start + (i as f64 + 0.5) * cell;
                [bulge(base, body, s), shrinking(base, body, s)]
            })
            .collect();
        let stations = stations(base, body, &base_knots);
        let knot_count = base_knots.len();
        let state = ArcState {
            total: vec![0.0; count],
            pending: vec![0.0; count],
            volume: 0.0,
            pending_area: 0.0,
            most_pending: 0.0,
        };
        Self {
            body,
            base: base.clone(),
            start,
            cell,
            spread,
            bending,
            stations,
            worn_knots: base_knots.clone(),
            base_knots,
            state,
            area: 0.0,
            depth: 0.0,
            rule: GaussLegendre::new(POINTS),
            scratch: Scratch::new(count, knot_count),
        }
    }

    /// Number of knots of the worn curve.
    pub fn knot_count(&self) -> usize {
        self.base_knots.len()
    }

    /// What is worn off.
    pub fn state(&self) -> &ArcState {
        &self.state
    }

    /// Whether `state` is of this grid.
    pub fn fits(&self, state: &ArcState) -> bool {
        let count = self.spread.len();
        state.total.len() == count && state.pending.len() == count
    }

    /// Puts an earlier [`state`](Self::state) in place; whether its totals are those of the curve
    /// in use.
    pub fn set_state(&mut self, state: &ArcState) -> bool {
        let is_same =
            self.state.total.iter().zip(&state.total).all(|(a, b)| a.to_bits() == b.to_bits());
        self.state.copy_from(state);
        is_same
    }

    /// Worn volume, what is not in the curve yet included [m³].
    pub fn volume(&self) -> f64 {
        self.state.volume
    }

    /// Worn area of the cross section, what is not in the curve yet included [m²].
    pub fn area(&self) -> f64 {
        self.area + self.state.pending_area
    }

    /// Greatest depth of the curve in use [m].
    pub fn depth(&self) -> f64 {
        self.depth
    }

    /// Length of the cells [m].
    pub fn cell(&self) -> f64 {
        self.cell
    }

    /// The unworn curve.
    pub fn base(&self) -> &Curve {
        &self.base
    }

    /// Parameter on the unworn curve of the one `s` on the curve in use [m].
    pub fn to_base(&self, s: f64) -> f64 {
        let knots = &self.worn_knots;
        let i = knots.partition_point(|&k| k <= s).clamp(1, knots.len() - 1) - 1;
        let share = ((s - knots[i]) / (knots[i + 1] - knots[i])).clamp(0.0, 1.0);
        self.base_knots[i] + share * (self.base_knots[i + 1] - self.base_knots[i])
    }

    /// Adds a worn volume of `volume` [m³], evenly between two parameters of the unworn curve, in
    /// either order [m].
    pub fn deposit(&mut self, from: f64, to: f64, volume: f64) {
        if volume.is_nan() || volume <= 0.0 {
            return;
        }
        let count = self.spread.len();
        let place = |s: f64| ((s - self.start) / self.cell).clamp(0.0, count as f64);
        let [a, b] = if from <= to { [place(from), place(to)] } else { [place(to), place(from)] };
        let first = (a as usize).min(count - 1);
        let last = (b as usize).min(count - 1);
        let per_arc = volume / self.cell;
        for i in first..=last {
            let share = if last == first {
                1.0
            } else {
                (b.min((i + 1) as f64) - a.max(i as f64)) / (b - a)
            };
            let added = share * per_arc;
            self.state.pending[i] += added;
            let depth = self.state.pending[i] / self.spread[i];
            self.state.pending_area += added / self.spread[i] * self.cell;
            self.state.most_pending = self.state.most_pending.max(depth);
        }
        self.state.volume += volume;
    }

    /// Depth that is not in the curve yet at a parameter of the unworn curve [m].
    pub fn pending_depth(&self, s: f64) -> f64 {
        let count = self.spread.len();
        let place = ((s - self.start) / self.cell - 0.5).clamp(0.0, (count - 1) as f64);
        let i = (place as usize).min(count - 2);
        let depth = |i: usize| self.state.pending[i] / self.spread[i];
        let share = place - i as f64;
        depth(i) + share * (depth(i + 1) - depth(i))
    }

    /// Greatest depth that is not in the curve yet [m].
    pub fn most_pending(&self) -> f64 {
        self.state.most_pending
    }

    /// Adds what another arc of the same grid has worn off since its last update; for one body in
    /// several simulations at once.
    ///
    /// # Panics
    /// If the grids differ.
    pub fn add_pending(&mut self, other: &ArcState) {
        assert_eq!(self.state.pending.len(), other.pending.len(), "arcs of the same profile");
        for (own, added) in self.state.pending.iter_mut().zip(&other.pending) {
            *own += added;
        }
        let mut most: f64 = 0.0;
        let (mut volume, mut area) = (0.0, 0.0);
        for ((own, added), spread) in
            self.state.pending.iter().zip(&other.pending).zip(&self.spread)
        {
            most = most.max(own / spread);
            volume += added * self.cell;
            area += added / spread * self.cell;
        }
        self.state.most_pending = most;
        self.state.volume += volume;
        self.state.pending_area += area;
    }
}

/// Knots of the curve and as many in between that no piece is longer than `longest` [m].
fn knots(curve: &Curve, longest: f64) -> Vec<f64> {
    let own: Vec<f64> = curve.knots().collect();
    let mut knots = Vec::new();
    for pair in own.windows(2) {
        let pieces = ((pair[1] - pair[0]) / longest).ceil().max(1.0);
        knots.extend(
            (0..pieces as usize).map(|i| pair[0] + (pair[1] - pair[0]) * i as f64 / pieces),
        );
    }
    knots.extend(own.last());
    knots
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::geometry::profiles::profile::ProfileKind;
    use crate::geometry::profiles::standard_profiles::built_in;

    #[test]
    fn deposits_are_kept_wherever_they_fall() {
        let curve = built_in("60E1", ProfileKind::Rail).unwrap().unwrap().curve;
        let mut arc = WornArc::new(&curve, Body::Rail { distance: 100.0 });
        let (start, end) = (curve.start(), curve.end());
        let middle = 0.5 * (start + end);
        let places = [
            [middle, middle + 1e-3],
            [middle + 1e-3, middle],
            [middle, middle],
            [start - 1.0, start + 1e-5],
            [end, end + 1.0],
            [start, end],
            [middle + 3.3e-5, middle + 3.4e-5],
        ];
        for [from, to] in places {
            arc.deposit(from, to, 2e-9);
        }
        let kept: f64 = arc.state().pending.iter().sum::<f64>() * arc.cell();
        assert_relative_eq!(kept, 2e-9 * places.len() as f64, max_relative = 1e-14);
        assert_relative_eq!(arc.volume(), kept, max_relative = 1e-14);
        assert_relative_eq!(arc.area(), kept / 100.0, max_relative = 1e-14);
        let deepest = (0..20_000)
            .map(|i| arc.pending_depth(start + (end - start) * f64::from(i) / 2e4))
            .fold(0.0, f64::max);
        assert!(deepest <= arc.most_pending() && deepest > 0.9 * arc.most_pending());
    }
}
