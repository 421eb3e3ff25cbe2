//! Where a value of the stress is greatest.

use super::load::{Part, SurfaceLoad};
use super::state::{Measure, State};

/// A greatest value and its place.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Greatest {
    /// The value [Pa].
    pub value: f64,
    /// Where: x, y, depth [m].
    pub point: [f64; 3],
    /// Displacement and stress there.
    pub state: State,
}

/// Columns that a search looks down along a part of the surface, and across, at most.
pub(crate) const COLUMNS: usize = 14;
/// Depths in each, from the size of an element to that of the part.
pub(crate) const DEPTHS: usize = 12;
/// A place is found when steps are smaller than this, over the size of an element.
pub(crate) const FOUND: f64 = 1e-3;

impl SurfaceLoad {
    /// The greatest value of `measure` in the body, and its place; none without load.
    ///
    /// From one element's size downwards it is looked for in the volume: below every few elements at
    /// depths that grow by a factor, then from the best place at each depth in steps that are halved.
    /// Between there and the surface tractions that jump between elements would be seen: it is looked
    /// for below the centres of elements.
    pub fn greatest(&self, measure: Measure) -> Option<Greatest> {
        let parts = self.parts.iter().filter(|part| !part.loaded.is_empty());
        let best = parts.flat_map(|part| {
            let search = Search { load: self, measure, part };
            [search.near_surface(), search.in_volume()]
        });
        let best = best.flatten().max_by(|a, b| a.1.total_cmp(&b.1))?;
        let state = self.state(best.0);
        Some(Greatest { value: measure.of(&state.stress), point: best.0, state })
    }
}

/// A place and the size of the value there.
pub(crate) type Found = ([f64; 3], f64);

/// From `best` in `step`s along the axes to places where the value that `at` finds is greater, and in
/// halves of them where there are none, until all are shorter than `found`.
pub(crate) fn climb(
    mut best: Found,
    mut step: [f64; 3],
    depths: &std::ops::RangeInclusive<f64>,
    found: f64,
    at: impl Fn([f64; 3]) -> Found,
) -> Found {
    while step.iter().any(|step| *step > found) {
        let before = best.1;
        for axis in (0..3).filter(|&axis| step[axis] > 0.0) {
            for sign in [1.0, -1.0] {
                let mut point = best.0;
                point[axis] += sign * step[axis];
                point[2] = point[2].clamp(*depths.start(), *depths.end());
                let other = at(point);
                if other.1 > best.1 {
                    best = other;
                    break;
                }
            }
        }
        if best.1 <= before {
            step = step.map(|step| 0.5 * step);
        }
    }
    best
}

struct Search<'a> {
    load: &'a SurfaceLoad,
    measure: Measure,
    part: &'a Part,
}

impl Search<'_> {
    fn at(&self, point: [f64; 3]) -> Found {
        (point, self.measure.of(&self.load.state(point).stress).abs())
    }

    /// Smaller side of an element.
    fn element(&self) -> f64 {
        self.part.grid.dx.min(self.part.grid.dy)
    }

    fn centre(&self, k: usize) -> [f64; 2] {
        let grid = &self.part.grid;
        [grid.x(k % grid.along), grid.y(k / grid.along)]
    }

    /// Under the centre of the element on whose surface the value is greatest.
    fn near_surface(&self) -> Option<Found> {
        let surface = self.part.loaded.iter().map(|&k| {
            let [x, y] = self.centre(k);
            self.at([x, y, 0.0])
        });
        let best = surface.max_by(|a, b| a.1.total_cmp(&b.1))?;
        let deepest = self.element();
        Some(self.climb(best, [0.0, 0.0, 0.25 * deepest], &(0.0..=deepest)))
    }

    /// From one element's size downwards.
    fn in_volume(&self) -> Option<Found> {
        let (grid, least) = (&self.part.grid, self.element());
        let every = [grid.along.div_ceil(COLUMNS), grid.across.div_ceil(COLUMNS)];
        let chosen = |k: &&usize| {
            [*k % grid.along, *k / grid.along].iter().zip(every).all(|(n, every)| n % every == 0)
        };
        let sides = [grid.along as f64 * grid.dx, grid.across as f64 * grid.dy];
        let size = sides[0].max(sides[1]).max(2.0 * least);
        let factor = (size / least).powf(1.0 / (DEPTHS - 1) as f64);
        let steps = [every[0] as f64 * grid.dx, every[1] as f64 * grid.dy];
        let layers = (0..DEPTHS).filter_map(|layer| {
            let depth = least * factor.powi(layer as i32);
            let columns = self.part.loaded.iter().filter(chosen).map(|&k| {
                let [x, y] = self.centre(k);
                self.at([x, y, depth])
            });
            let best = columns.max_by(|a, b| a.1.total_cmp(&b.1))?;
            let step = [0.5 * steps[0], 0.5 * steps[1], 0.5 * depth * (factor - 1.0)];
            Some(self.climb(best, step, &(least..=2.0 * size)))
        });
        layers.max_by(|a, b| a.1.total_cmp(&b.1))
    }

    fn climb(&self, best: Found, step: [f64; 3], depths: &std::ops::RangeInclusive<f64>) -> Found {
        climb(best, step, depths, FOUND * self.element(), |point| self.at(point))
    }
}
