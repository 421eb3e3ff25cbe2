//! Tractions of all zones of a rail that follow from those of the step before.

use std::convert::Infallible;

use super::{RailRolling, Slipped, ZoneState, bound, heaviest, zone_of_row};
use crate::boundary_element::friction::Tractions as ElementTractions;
use crate::boundary_element::grid::Grid;
use crate::boundary_element::steps::{Kept, Lattice, Part, Solve, Walk};
use crate::element::contact::given_tractions::GivenTractions;
use crate::element::contact::models::Models;
use crate::element::contact_history::{RailHistory, Remembering};
use crate::normal::rail_elements::RailElements;
use crate::tangential::Rolling;
use crate::tangential::boundary_element::rolling_tractions;
use crate::tangential::field::ContactField;

/// Longest way of a step that is told from longer ones [m].
const MAX_WAY: f64 = 1e6;

impl RailRolling<'_> {
    /// Tractions of all zones together, one for each of `zones`, that follow from those of the step
    /// before; before the first step those of [`tractions`](Self::tractions). What they leave behind
    /// goes to `memory`.
    pub(in crate::element::rail) fn remembered(
        &self,
        elements: &RailElements,
        zones: &[ZoneState],
        models: &Models,
        memory: &mut Remembering,
    ) -> Option<Vec<GivenTractions>> {
        let law = &heaviest(zones, models)?.law;
        let slipping = self.loaded(elements, zones, models);
        let (bound, rigid) = (bound(&slipping, elements), slipping.rigid());
        let (grid, k) = (&elements.grid, self.forces.k);
        let size = [grid.dx, grid.dy];
        let lattice = Lattice::with_borders_at_multiples(size);
        let window = lattice.window_of(grid);
        // Of the contact over the material of the bodies, by the speed that creepages refer to.
        let direction = 2.0 * law.state.forward_share - 1.0;
        if memory.is_new() && direction.abs() >= 1.0 {
            let rolling = if direction > 0.0 { Rolling::Forward } else { Rolling::Backward };
            let solution = rolling_tractions(grid, &law.material, &bound, &rigid, rolling);
            if !solution.converged {
                return None;
            }
            if memory.is_shown {
                memory.show(k, field(elements, zones, models, &solution));
            }
            let tractions = solution.x.iter().zip(&solution.y).map(|(x, y)| [*x, *y]).collect();
            memory.leave(k, RailHistory { size, kept: Kept { window, tractions } });
            let found = [(1.0, solution)];
            return Some(self.sums_of(&slipping, elements, zones, models, &found, Slipped::Rigid));
        }
        let way = (law.state.speed * memory.duration).min(MAX_WAY);
        let (mut before, own) = memory.before(k).on_elements(size);
        let is_coarse = own.into_iter().zip(size).any(|(own, size)| own > size);
        let mut walk = Walk::new(*grid, window, law.material, bound, direction * way);
        if !is_coarse && walk.has_jumped(&before) {
            before.clear();
        }
        if is_coarse || way > 0.0 || !walk.rests(&before) {
            let advance = |part: &Part<'_>, solve: &mut Solve<'_>| {
                let displaced = rigid.iter().zip(part.carried);
                let displaced: Vec<_> = displaced
                    .map(|(w, carried)| [0, 1].map(|c| part.of(way * w[c]) - carried[c]))
                    .collect();
                Ok::<_, Infallible>(solve(&displaced, part.before, false))
            };
            let Ok(()) = if is_coarse {
                let coarse = Lattice::with_borders_at_multiples(own);
                walk.go_from_coarse(&before, coarse, lattice, advance)
            } else {
                walk.go(&before, lattice, advance)
            };
        }
        let work: Vec<f64> = if way > 0.0 {
            walk.work.iter().map(|work| work / way).collect()
        } else {
            vec![0.0; grid.len()]
        };
        let [x, y] = [0, 1].map(|c| walk.tractions.iter().map(|p| p[c]).collect());
        let solution = ElementTractions {
            x,
            y,
            slips: walk.slips,
            residual: walk.residual,
            ..ElementTractions::default()
        };
        if memory.is_shown {
            memory.show(k, field(elements, zones, models, &solution));
        }
        let left = Kept { window, tractions: walk.tractions };
        memory.leave(k, RailHistory { size, kept: left });
        let slipped = Slipped::Step(&work);
        let mut found =
            self.sums_of(&slipping, elements, zones, models, &[(1.0, solution)], slipped);
        if !walk.converged {
            for GivenTractions { convergence, .. } in &mut found {
                convergence.fallbacks = 1;
            }
        }
        Some(found)
    }
}

/// The pressure, that of damping with it, and the tractions of `solution`, seen from the centre of
/// the heaviest zone.
fn field(
    elements: &RailElements,
    zones: &[ZoneState],
    models: &Models,
    solution: &ElementTractions,
) -> ContactField {
    let (grid, zone_of_row) = (&elements.grid, zone_of_row(&models.rail_strips));
    let factor = |row: usize| zone_of_row[row].map_or(1.0, |z| zones[z].law.state.load_factor);
    let pressure = elements.pressure.iter().enumerate();
    let pressure = pressure.map(|(k, p)| p * factor(k / grid.along)).collect();
    let [x, y] = heaviest(zones, models).map_or([0.0; 2], |zone| zone.centre);
    let grid = Grid { leading_x: grid.leading_x - x, left_y: grid.left_y - y, ..*grid };
    let mut field = ContactField::of_pressure(grid, pressure);
    for (k, traction) in field.traction.iter_mut().enumerate() {
        *traction = [solution.x[k], solution.y[k]];
    }
    for (k, &slips) in solution.slips.iter().enumerate() {
        field.set_adherence(k, slips);
    }
    field
}
