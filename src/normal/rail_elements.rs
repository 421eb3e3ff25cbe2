//! Boundary elements on the arc of a rail: the normal problem of one wheel and one rail, all
//! overlaps together.
//!
//! An element is a stretch dx along the track by a stretch of the arc of the rail's section, with
//! the rail's own normal. The overlap b of the undeformed bodies is the distance along that normal
//! to the surface of the wheel. Pressures p ≥ 0 act along the normals, and b - A p ≤ 0, with
//! equality where p > 0. A is the influence of the half-space with the length of the arc as the
//! distance across, as the surface were laid flat: on a surface that bends away from the pressure
//! the material beneath is stiffer towards the side where it bulges and softer where it is hollow,
//! and to first order in the curvature the two bodies of like materials differ by opposite signs.
//!
//! **Energy.** A does not depend on where the wheel is, as long as elements lie on the same places
//! of the rail. So the elastic energy
//!
//! ```text
//! E = max over p ≥ 0 of  Σ a (p b - ½ p A p)        a: area of an element
//! F = -dE/dq = -Σ a p ∂b/∂q,   ∂b/∂q = N/(N·n)
//! ```
//!
//! with N the normal of the wheel where the normal n of the rail meets it: the force on the wheel
//! is the exact derivative of an energy, and as every N meets the axle, it has no moment about it.
//! Summed along n instead it differs by what Σ a p tan(N, n) leaves, which vanishes where A is a
//! convolution (Σ p ∂(A p)/∂y = 0). Elements therefore lie on a lattice that is fixed to the rail
//! across and to the wheel's centre along, with sizes from a ladder, so that the solution is that
//! of one lattice under small movements.
//!
//! **Rails whose section varies along the track.** The section is the outline that the wheel meets
//! (`geometry::rail::varying_rail`): each row of the surface lies in it where along the track the
//! bodies are nearest, x_m. A row of elements follows that row, which may drift across. With W(x) the
//! overlap with an even rail of that outline, lean λ and curvature κ of the row along the track,
//!
//! ```text
//! b(x) = W(x) + (b(x_m) - W(x_m)) + λ (x - x_m) - ½ κ (x - x_m)²
//! ```
//!
//! along the normal of the section, and the cosine of the lean times that along the normal that
//! leans with the rail. Beyond the end of a row there is nothing to touch; an end within the overlap
//! is a border of elements, so that none is cut. A is as if the rows did not drift: an angle δ between row and track changes
//! distances by shares of δ²/2.

mod lattice;
mod overlaps;
mod section;

pub use section::{Opposite, Row};

use super::Strips;
use super::boundary_element::fill_rows;
use super::element_pressure::ElementPressure;
use crate::boundary_element::grid::Grid;
use crate::boundary_element::pressure::{PressureSolver, TOLERANCE};
use crate::geometry::contacts::contact_search::ContactSearch;
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::geometry::wheel::contact_line::ContactLine;
use lattice::{beyond, coarse_grid, element_size, extent_of};
use overlaps::Overlap;
use section::Section;

/// The solution on the elements of a rail.
#[derive(Clone, Debug)]
pub struct RailElements {
    /// The elements: x from the wheel marker, across the arc of the rail [m].
    pub grid: Grid,
    /// Pressure on each [Pa].
    pub pressure: Vec<f64>,
    /// The places of the rows; nothing where the rail ends or no wheel lies opposite.
    pub rows: Vec<Option<Row>>,
    /// The wheel opposite to each element, where the bodies overlap.
    pub opposite: Vec<Option<Opposite>>,
    /// Greatest overlap [m].
    pub approach: f64,
    /// Iterations of conjugate gradients.
    pub iterations: usize,
    /// Largest distance left between surfaces that carry pressure, or overlap left of others, over
    /// the greatest overlap [-].
    pub residual: f64,
}

/// How often the grid grows when the contact reaches its border.
const MAX_GROWTHS: usize = 6;
/// Distance left in the contact, over the overlap, at which iterations end [-]: forces of poses 0.1
/// µm apart then differ by what the poses do. What rounding keeps from that is taken if it is
/// within the usual tolerance.
const CLOSED: f64 = 1e-8;

/// Solves for all that `line` and `rail` overlap where `search` has found them in contact, with
/// about `elements` along and across each zone, of bodies with the contact modulus `modulus` [Pa],
/// on a grid with room for a contact that is `room` elements wider on each side; nothing where the
/// iteration did not converge or no place was found. `sized` makes of the length and width of
/// elements that these would have those that they have.
pub fn solve(
    line: &ContactLine,
    rail: &PlacedRail,
    search: &ContactSearch,
    elements: [usize; 2],
    modulus: f64,
    room: usize,
    sized: impl Fn([f64; 2]) -> [f64; 2],
) -> Option<RailElements> {
    let arcs = rail.arcs();
    let section = Section { line, rail, arcs: &arcs };
    let overlaps = section.overlaps(search);
    if overlaps.is_empty() {
        return None;
    }
    // Each overlap by itself tells the extent of its zones: that of all together is no greater.
    let mut zones = Vec::new();
    for overlap in &overlaps {
        let alone = std::slice::from_ref(overlap);
        let found = section.solve_on(coarse_grid(overlap), alone, modulus)?;
        zones.extend(lattice::zones(&found.grid, &found.pressure));
    }
    let mut box_of_load = extent_of(&zones)?;
    let size = sized(element_size(&zones, box_of_load, elements));
    let origin = overlaps.iter().find_map(|overlap| overlap.end).unwrap_or(0.0);
    for _ in 0..MAX_GROWTHS {
        let grid = lattice::covering(box_of_load, size, origin, room);
        let found = section.solve_on(grid, &overlaps, modulus)?;
        match beyond(&found.grid, &found.pressure, box_of_load) {
            Some(grown) => box_of_load = grown,
            None => return Some(found),
        }
    }
    None
}

impl Section<'_> {
    /// The solution on `grid` for `overlaps`; nothing where it does not converge.
    fn solve_on(&self, grid: Grid, overlaps: &[Overlap], modulus: f64) -> Option<RailElements> {
        let rows: Vec<Option<Row>> =
            (0..grid.across).map(|j| self.row_near(grid.y(j), overlaps)).collect();
        let mut opposite = vec![None; grid.len()];
        for (row, opposite) in rows.iter().zip(opposite.chunks_exact_mut(grid.along)) {
            let Some(row) = row.filter(|row| row.overlap > 0.0) else { continue };
            self.meet_row(&grid, &row, opposite);
        }
        let approach = opposite.iter().flatten().map(|o: &Opposite| o.overlap).fold(0.0, f64::max);
        if approach <= 0.0 {
            return None;
        }
        let distance = distances(&opposite, approach);
        let mut solver = PressureSolver::new(grid, modulus).with_tolerance(CLOSED);
        let solution = solver.at_approach(&distance, approach, None);
        if solution.residual > TOLERANCE {
            return None;
        }
        let mut displacement = vec![0.0; grid.len()];
        solver.displace(&solution.pressure, &mut displacement);
        let left = (0..grid.len()).map(|k| {
            let overlap = approach - distance[k] - displacement[k];
            if solution.pressure[k] > 0.0 { overlap.abs() } else { overlap.max(0.0) }
        });
        Some(RailElements {
            residual: left.fold(0.0, f64::max) / approach,
            grid,
            pressure: solution.pressure,
            rows,
            opposite,
            approach,
            iterations: solution.iterations,
        })
    }
}

/// Undeformed distance of the elements with these `opposite`, that of the overlap `approach` as 0
/// [m].
fn distances(opposite: &[Option<Opposite>], approach: f64) -> Vec<f64> {
    // What does not overlap is as far apart as the bodies overlap elsewhere.
    opposite.iter().map(|o| o.map_or(2.0 * approach, |o| approach - o.overlap)).collect()
}

impl RailElements {
    /// Undeformed distance of the elements, from an approach of 0 on [m].
    pub fn distances(&self) -> Vec<f64> {
        distances(&self.opposite, self.approach)
    }

    /// Greatest angle between the normals of rows that carry pressure [rad].
    pub fn turn_of_normals(&self) -> f64 {
        let rows = self.rows.iter().zip(self.pressure.chunks(self.grid.along));
        let loaded = rows.filter(|(_, pressure)| pressure.iter().any(|&p| p > 0.0));
        let angles =
            loaded.filter_map(|(row, _)| row.map(|row| row.tangent[1].atan2(row.tangent[0])));
        let [least, most] = angles
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], angle| [a.min(angle), b.max(angle)]);
        (most - least).max(0.0)
    }

    /// Fills the empty `strips` with the loaded rows; returns the number of zones that found no
    /// room.
    pub fn fill(&self, strips: &mut Strips) -> usize {
        let u: Vec<f64> = self.rows.iter().map(|row| row.map_or(0.0, |row| row.u)).collect();
        let field = ElementPressure {
            grid: self.grid,
            pressure: self.pressure.clone(),
            strip_of_row: vec![None; self.grid.across],
            iterations: self.iterations,
        };
        fill_rows(strips, field, &u)
    }
}
