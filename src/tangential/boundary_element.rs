//! Steady rolling on boundary elements as a tangential contact model.
//!
//! Where the pressure is that of boundary elements, the tractions of all zones of the contact are
//! solved together on the same elements; the zones beside the one asked for move with the creepage
//! of that one. The pressure of other models is put on a grid over the zone: along a strip the mean
//! over each element, across interpolated between strips, and scaled to the load of the zone.
//!
//! Backward rolling is the mirror image along x.

use super::rigid_slip::RigidSlip;
use super::{Creepage, LoadedZone, Rolling, StripForce};
use crate::boundary_element::friction::Tractions;
use crate::boundary_element::grid::Grid;
use crate::boundary_element::rolling::steady_rolling;
use crate::boundary_element::unlike::{UnlikeProblem, UnlikeSolution, steady_rolling_unlike};
use crate::material::MaterialPair;
use crate::normal::{Strips, Zone};

/// Pressure on elements and the strips that their rows belong to.
#[derive(Clone, Debug)]
pub struct LoadedElements {
    /// The elements; x from the wheel marker, y in the contact frame.
    pub grid: Grid,
    /// Pressure on each [Pa].
    pub pressure: Vec<f64>,
    /// For each loaded row its place between strips.
    rows: Vec<Option<Row>>,
}

/// A row between two strips, or on one.
#[derive(Clone, Copy, Debug)]
struct Row {
    strips: [usize; 2],
    /// Share of the second.
    share: f64,
}

impl LoadedElements {
    /// Those of the normal model, or the pressure of `zone` on `elements` along and across it.
    pub fn of(zone: &Zone, strips: &Strips, elements: [usize; 2]) -> Self {
        let Some(field) = &strips.elements else {
            return Self::spread(zone, strips, elements);
        };
        let rows = field.strip_of_row.iter();
        Self {
            grid: field.grid,
            pressure: field.pressure.clone(),
            rows: rows.map(|j| j.map(|j| Row { strips: [j, j], share: 0.0 })).collect(),
        }
    }

    fn spread(zone: &Zone, strips: &Strips, elements: [usize; 2]) -> Self {
        let range = zone.range();
        let mut x = [f64::INFINITY, f64::NEG_INFINITY];
        for j in range.clone() {
            x[0] = x[0].min(strips.x[j] - strips.half_length[j]);
            x[1] = x[1].max(strips.x[j] + strips.half_length[j]);
        }
        let (first, last) = (range.start, range.end - 1);
        // The widths of the strips sum to that of the zone, and are alike on both sides.
        let width: f64 = strips.width[range].iter().sum();
        let middle = 0.5 * (strips.y[first] + strips.y[last]);
        let y = [middle - 0.5 * width, middle + 0.5 * width];
        let grid = Grid::over(x, y, elements[0], elements[1]);
        let mut pressure = vec![0.0; grid.len()];
        let mut rows = Vec::with_capacity(grid.across);
        let mut j = first;
        for row in 0..grid.across {
            let at = grid.y(row);
            while j < last && strips.y[j + 1] < at {
                j += 1;
            }
            // Before the first strip and behind the last the zone ends at its edge.
            let (from, to, share) = if at < strips.y[first] {
                (None, first, (at - y[0]) / (strips.y[first] - y[0]))
            } else if j == last {
                (Some(last), last, (at - strips.y[last]) / (y[1] - strips.y[last]))
            } else {
                let share = (at - strips.y[j]) / (strips.y[j + 1] - strips.y[j]);
                (Some(j), j + 1, share)
            };
            let ends = at < strips.y[first] || from == Some(to);
            let per_length = |j: usize| strips.pressure[j] / strips.half_length[j];
            let square = |j: usize| strips.half_length[j].powi(2);
            let (square, per_length, on) = if ends {
                let left = if from.is_none() { share } else { 1.0 - share };
                (square(to) * left, per_length(to), Row { strips: [to, to], share: 0.0 })
            } else {
                let j = from.unwrap_or(to);
                let mix = |f: &dyn Fn(usize) -> f64| (1.0 - share) * f(j) + share * f(to);
                (mix(&square), mix(&per_length), Row { strips: [j, to], share })
            };
            let half_length = square.max(0.0).sqrt();
            let centre = on.mix(|j| strips.x[j]);
            let line = &mut pressure[row * grid.along..(row + 1) * grid.along];
            for (i, p) in line.iter_mut().enumerate() {
                let t = |x: f64| ((x - centre) / half_length).clamp(-1.0, 1.0);
                let (front, back) = (grid.x(i) + 0.5 * grid.dx, grid.x(i) - 0.5 * grid.dx);
                let integral = |t: f64| 0.5 * (t * (1.0 - t * t).max(0.0).sqrt() + t.asin());
                let mean = integral(t(front)) - integral(t(back));
                *p = (per_length * square * mean / grid.dx).max(0.0);
                if !p.is_finite() {
                    *p = 0.0;
                }
            }
            rows.push(line.iter().any(|&p| p > 0.0).then_some(on));
        }
        let load: f64 = pressure.iter().sum::<f64>() * grid.element_area();
        if load > 0.0 {
            for p in &mut pressure {
                *p *= zone.load / load;
            }
        }
        Self { grid, pressure, rows }
    }

    /// Tractions of all elements for the slip and the friction of `loaded`.
    pub fn tractions(&self, loaded: &LoadedZone<'_>, rolling: Rolling) -> Tractions {
        let &LoadedZone { strips, material, slip, .. } = loaded;
        let grid = &self.grid;
        let mut bound = vec![0.0; grid.len()];
        let mut rigid = vec![[0.0; 2]; grid.len()];
        for (j, row) in self.rows.iter().enumerate() {
            let Some(row) = row else { continue };
            let [from, to] = row.strips.map(|j| loaded.friction_coefficient(j));
            // From the first on, so that strips alike give the same to the last bit.
            let friction = from + row.share * (to - from);
            let own = j * grid.along..(j + 1) * grid.along;
            for (bound, p) in bound[own.clone()].iter_mut().zip(&self.pressure[own]) {
                *bound = friction * p;
            }
            let creepage = row.creepage(&slip);
            let centre = row.mix(|j| strips.x[j]);
            for i in 0..grid.along {
                let lateral = creepage.lateral + creepage.spin * (grid.x(i) - centre);
                rigid[j * grid.along + i] = [creepage.longitudinal, lateral];
            }
        }
        rolling_tractions(grid, material, &bound, &rigid, rolling)
    }

    /// The rows on `zone`, each with the strip nearest to it.
    pub fn rows_of(&self, zone: &Zone) -> impl Iterator<Item = (usize, usize)> {
        let own = zone.range();
        let rows = self.rows.iter().enumerate();
        let nearest = rows.filter_map(|(j, row)| Some((j, row.as_ref()?.nearest())));
        nearest.filter(move |(_, strip)| own.contains(strip))
    }

    /// Hands the force of each row of `zone` on the wheel to `each`, shared by the strips between
    /// which the row lies as their creepage is.
    pub fn strip_forces(
        &self,
        zone: &Zone,
        strips: &Strips,
        tractions: &Tractions,
        each: &mut dyn FnMut(usize, StripForce),
    ) {
        let grid = &self.grid;
        let area = grid.element_area();
        let own = zone.range();
        for (j, row) in self.rows.iter().enumerate() {
            let Some(row) = row else { continue };
            for (strip, share) in row.strips.into_iter().zip([1.0 - row.share, row.share]) {
                if share <= 0.0 || !own.contains(&strip) {
                    continue;
                }
                let arm_y = grid.y(j) - strips.y[strip];
                let mut force = StripForce::default();
                for i in 0..grid.along {
                    let k = j * grid.along + i;
                    let (x, y) = (share * area * tractions.x[k], share * area * tractions.y[k]);
                    force.longitudinal += x;
                    force.lateral += y;
                    force.moment += (grid.x(i) - strips.x[strip]) * y - arm_y * x;
                    force.slip_area += if tractions.slips[k] { share * area } else { 0.0 };
                }
                each(strip, force);
            }
        }
    }
}

/// Tractions of the elements of `grid` that roll either way; see [`steady_rolling`].
pub fn rolling_tractions(
    grid: &Grid,
    material: &MaterialPair,
    bound: &[f64],
    rigid: &[[f64; 2]],
    rolling: Rolling,
) -> Tractions {
    match rolling {
        Rolling::Forward => steady_rolling(grid, material, bound, rigid),
        Rolling::Backward => {
            let (bound, rigid) = (grid.mirrored(bound), grid.mirrored_vectors(rigid));
            steady_rolling(grid, material, &bound, &rigid).mirrored(grid)
        }
    }
}

/// Pressure and tractions of bodies of unlike materials that roll either way.
pub fn rolling_unlike(problem: &UnlikeProblem<'_>, rolling: Rolling) -> UnlikeSolution {
    match rolling {
        Rolling::Forward => steady_rolling_unlike(problem),
        Rolling::Backward => problem.backward(),
    }
}

impl Row {
    fn nearest(&self) -> usize {
        self.strips[usize::from(self.share > 0.5)]
    }

    fn mix(&self, of: impl Fn(usize) -> f64) -> f64 {
        (1.0 - self.share) * of(self.strips[0]) + self.share * of(self.strips[1])
    }

    fn creepage(&self, slip: &RigidSlip<'_>) -> Creepage {
        let [a, b] = self.strips.map(|j| slip.creepage(j));
        let mix = |a: f64, b: f64| (1.0 - self.share) * a + self.share * b;
        Creepage {
            longitudinal: mix(a.longitudinal, b.longitudinal),
            lateral: mix(a.lateral, b.lateral),
            spin: mix(a.spin, b.spin),
        }
    }
}
