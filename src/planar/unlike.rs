//! Planar problems on boundary elements of bodies of unlike materials, whose pressure and tractions
//! act on each other.

use super::line::PlanarLine;
use super::{friction_at, rolling_state, tangential_of};
use crate::boundary_element::grid::Grid;
use crate::boundary_element::unlike::{
    Press, UnlikeProblem, UnlikeSolution, steady_rolling_unlike,
};
use crate::friction::StripFriction;
use crate::material::MaterialPair;
use crate::normal::boundary_element::{distances, fill_rows};
use crate::normal::{ElementPressure, NormalModel, NormalProblem, Strips};
use crate::planar::{Indentation, PlanarCase};
use crate::tangential::TangentialModel;
use crate::tangential::field::ContactField;

/// Elements that the grid of like bodies gets more on each side: room for what tractions do.
const MORE: usize = 2;

/// Whether pressure and tractions of `case` act on each other, and its models can tell.
pub(super) fn is_coupled(case: &PlanarCase, material: &MaterialPair) -> bool {
    case.normal_model == NormalModel::BoundaryElement
        && case.tangential_model == TangentialModel::BoundaryElement
        && material.coupling.abs() > 0.0
}

/// Puts the solution of `case` in the place of that of like bodies, which is in `strips` and belongs
/// to `problem`; returns its pressure and tractions, or nothing where there is no contact.
pub(super) fn couple(
    case: &PlanarCase,
    problem: &NormalProblem,
    line: &mut PlanarLine,
    material: &MaterialPair,
    strips: &mut Strips,
) -> Option<(Grid, UnlikeSolution)> {
    let alone = strips.elements.as_ref()?;
    let more = MORE as f64;
    let Grid { along, across, dx, dy, leading_x, left_y } = alone.grid;
    let grid = Grid {
        along: along + 2 * MORE,
        across: across + 2 * MORE,
        leading_x: leading_x + more * dx,
        left_y: left_y - more * dy,
        dx,
        dy,
    };
    let (separation, rows) = distances(&grid, problem, line);
    let contact_y = line.contact;
    let laws = strips.zones.iter().map(|zone| {
        let state = rolling_state(case, contact_y + zone.y);
        (zone.y, tangential_of(case).under_law(zone, strips, material, &state))
    });
    let laws: Vec<_> = laws.collect();
    let (mut friction, mut rigid) = (Vec::with_capacity(grid.len()), Vec::new());
    for j in 0..grid.across {
        let y = grid.y(j);
        let nearest = |a: &&(f64, _), b: &&(f64, _)| (a.0 - y).abs().total_cmp(&(b.0 - y).abs());
        let (_, law) = laws.iter().min_by(nearest)?;
        let own = friction_at(case, contact_y + y)
            .map_or(law.state.friction, |own: StripFriction| own.under(&law.factors));
        let creepage = rolling_state(case, contact_y + y).creepage;
        for i in 0..grid.along {
            friction.push(own);
            rigid.push([creepage.longitudinal, creepage.lateral + creepage.spin * grid.x(i)]);
        }
    }
    let press = match case.indentation {
        Indentation::Load(load) => Press::Load(load, problem.approach),
        Indentation::Approach(_) => Press::Approach(problem.approach),
    };
    let (_, law) = laws.first()?;
    let solution = steady_rolling_unlike(&UnlikeProblem {
        grid: &grid,
        material,
        shearing: &law.material,
        separation: &separation,
        press,
        friction: &friction,
        rigid: &rigid,
    });
    let field = ElementPressure {
        grid,
        pressure: solution.pressure.pressure.clone(),
        strip_of_row: vec![None; grid.across],
        iterations: solution.pressure.iterations,
    };
    let u: Vec<f64> = rows.iter().map(|row| row.0).collect();
    strips.clear();
    fill_rows(strips, field, &u);
    Some((grid, solution))
}

/// Creep forces along x and y and moment about the origin of the separation, on the wheel [N, N m].
pub(super) fn forces(grid: &Grid, solution: &UnlikeSolution, contact_y: f64) -> [f64; 3] {
    let mut sum = [0.0; 3];
    let tractions = solution.tractions.x.iter().zip(&solution.tractions.y);
    for (k, (x, y)) in tractions.enumerate() {
        let place = [grid.x(k % grid.along), contact_y + grid.y(k / grid.along)];
        let moment = place[0] * y - place[1] * x;
        let area = grid.element_area();
        sum = [sum[0] + area * x, sum[1] + area * y, sum[2] + area * moment];
    }
    sum
}

/// Pressure and tractions element by element.
pub(super) fn field(grid: &Grid, solution: UnlikeSolution) -> ContactField {
    let mut field = ContactField::of_pressure(*grid, solution.pressure.pressure);
    field.take(&solution.tractions);
    field
}
