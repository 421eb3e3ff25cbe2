//! One step: friction, forces that may be given, and what the parts of the step add up to.

use super::check::first_force;
use super::history::History;
use super::step::{StepMotion, TransientField, TransientResult, displacement};
use super::substep::{Advanced, Given, advance, force_of};
use crate::boundary_element::grid::Grid;
use crate::boundary_element::steps::{self, Lattice, Window};
use crate::error::ContactError;
use crate::material::MaterialPair;
use crate::normal::{ElementPressure, Strips};
use crate::planar::{PlanarCase, friction_at, without_creep_forces};
use crate::tangential::field::ContactField;

/// One step from its first part to its last.
pub struct Walk {
    parts: steps::Walk,
    /// Friction limit [N].
    limit: f64,
    /// Distance rolled, either way [m].
    rolled: f64,
    force: [Option<f64>; 2],
    displacement: [f64; 3],
    /// What has been found of it on the way.
    found: [f64; 3],
}

impl Walk {
    pub fn new(
        case: &PlanarCase,
        motion: &StepMotion,
        grid: Grid,
        window: Window,
        field: &ElementPressure,
    ) -> Result<Self, ContactError> {
        let mut bound = field.pressure.clone();
        for (j, row) in bound.chunks_exact_mut(grid.along).enumerate() {
            let friction = friction_at(case, grid.y(j));
            let friction = friction.map_or(case.friction, |own| own.under(&[1.0; 2]));
            for bound in row {
                *bound *= friction;
            }
        }
        let limit = bound.iter().sum::<f64>() * grid.element_area();
        let [x, y] = motion.force.map(|force| force.unwrap_or(0.0));
        if x.hypot(y) >= limit
            && let Some((name, force)) = first_force(motion)
        {
            let allowed = "a creep force below the friction limit, that of both components";
            return Err(ContactError::bad_value(name, force, allowed));
        }
        let material = MaterialPair::new(case.wheel_material, case.rail_material);
        Ok(Self {
            parts: steps::Walk::new(grid, window, material, bound, motion.rolled),
            limit,
            rolled: motion.rolled.abs(),
            force: motion.force,
            displacement: displacement(case, motion),
            found: [0.0; 3],
        })
    }

    pub fn go(&mut self, history: &History, lattice: Lattice) -> Result<(), ContactError> {
        let Self { parts, limit, force, displacement, found, .. } = self;
        if let Some((axis, elements)) = parts.too_far(&history.kept) {
            let name = ["radius", "separation y"][axis];
            let moved = elements as f64 * lattice.size[axis];
            let allowed = "a contact within 4000 elements of that of the step before";
            return Err(ContactError::bad_value(name, moved, allowed));
        }
        parts.go(&history.kept, lattice, |part, solve| {
            let given = Given { force: *force, limit: *limit, compliance: part.compliance };
            let own = displacement.map(|d| part.of(d));
            let Advanced { tractions, displacement } =
                advance(part.grid, part.before, part.carried, own, &given, solve)?;
            for (sum, own) in found.iter_mut().zip(displacement) {
                *sum += part.times() * own;
            }
            Ok(tractions)
        })
    }

    /// Tractions at the end [Pa].
    pub fn tractions(&self) -> &[[f64; 2]] {
        &self.parts.tractions
    }

    pub fn result(&self, strips: &Strips) -> TransientResult {
        let steps::Walk { grid, tractions, work, substeps, sweeps, converged, .. } = &self.parts;
        let mut contact = without_creep_forces(strips);
        let [fx, fy] = force_of(grid, tractions);
        (contact.fx, contact.fy) = (fx, fy);
        let area = grid.element_area();
        contact.mz = tractions.iter().enumerate().fold(0.0, |sum, (k, p)| {
            let (x, y) = (grid.x(k % grid.along), grid.y(k / grid.along));
            sum + area * (x * p[1] - y * p[0])
        });
        TransientResult {
            contact,
            displacement: self.found,
            work: work.iter().sum(),
            substeps: *substeps,
            sweeps: *sweeps,
            converged: *converged,
        }
    }

    pub fn field(self, pressure: Vec<f64>) -> TransientField {
        let steps::Walk { grid, tractions, slips, slip, work, .. } = self.parts;
        let mut contact = ContactField::of_pressure(grid, pressure);
        contact.traction = tractions;
        for (k, &slips) in slips.iter().enumerate() {
            contact.set_adherence(k, slips);
        }
        if self.rolled > 0.0 {
            let over = slip.iter().map(|s| s.map(|s| s / self.rolled));
            contact.slip = Some(over.collect());
        }
        TransientField { contact, slip, work }
    }
}
