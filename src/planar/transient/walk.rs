//! One step: its substeps, and what they add up to.

use super::check::first_force;
use super::lattice::{Lattice, Window};
use super::substep::{Advanced, Given, advance, force_of};
use super::{History, StepMotion, TransientField, TransientResult, displacement};
use crate::boundary_element::grid::Grid;
use crate::boundary_element::rolling::{steady_rolling, steady_rolling_within};
use crate::boundary_element::transient::{Memory, TOLERANCE, TransientStep};
use crate::error::ContactError;
use crate::material::MaterialPair;
use crate::normal::{ElementPressure, Strips};
use crate::planar::{PlanarCase, friction_at, without_creep_forces};
use crate::tangential::field::ContactField;

/// Lengths of the contact, as wide as long, after which nothing is left of its history: it falls to
/// 1/e in about 0.6 of them. In wider ones it takes longer, as the logarithm of the width.
const FORGOTTEN: f64 = 20.0;

/// Share of the way behind it in the step that a further substep may be long, beyond the length of
/// the contact.
const GROWTH: f64 = 0.1;

/// Most elements between a contact and that of the step before.
const MAX_BETWEEN: usize = 4000;

/// One step from its first substep to its last.
pub struct Walk {
    grid: Grid,
    window: Window,
    material: MaterialPair,
    /// μ p_n of each element [Pa].
    bound: Vec<f64>,
    /// Friction limit [N].
    limit: f64,
    /// Distance rolled, either way [m].
    rolled: f64,
    backward: bool,
    force: [Option<f64>; 2],
    displacement: [f64; 3],
    // What has been found on the way.
    /// Traction (x, y) of each element at the end [Pa].
    pub tractions: Vec<[f64; 2]>,
    slips: Vec<bool>,
    slip: Vec<[f64; 2]>,
    work: Vec<f64>,
    found: [f64; 3],
    substeps: usize,
    sweeps: usize,
    converged: bool,
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
        let count = grid.len();
        Ok(Self {
            grid,
            window,
            material: MaterialPair::new(case.wheel_material, case.rail_material),
            bound,
            limit,
            rolled: motion.rolled.abs(),
            backward: motion.rolled < 0.0,
            force: motion.force,
            displacement: displacement(case, motion),
            tractions: vec![[0.0; 2]; count],
            slips: vec![false; count],
            slip: vec![[0.0; 2]; count],
            work: vec![0.0; count],
            found: [0.0; 3],
            substeps: 0,
            sweeps: 0,
            converged: true,
        })
    }

    pub fn go(&mut self, history: &History, lattice: Lattice) -> Result<(), ContactError> {
        self.tractions = self.window.values_of(&history.window, &history.tractions);
        let length = self.grid.along as f64 * self.grid.dx;
        let width = self.grid.across as f64 * self.grid.dy;
        let slower = 1.0 + 0.5 * (width / length).max(1.0).ln();
        if self.rolled > FORGOTTEN * slower * length {
            return self.steady();
        }
        // Tractions of before may act on elements that are in contact no more.
        let both = if history.tractions.is_empty() {
            self.window
        } else {
            self.window.with(&history.window)
        };
        for axis in 0..2 {
            if both.count[axis] > MAX_BETWEEN {
                let name = ["radius", "separation y"][axis];
                let moved = (both.count[axis] - self.window.count[axis]) as f64;
                let allowed = "a contact within 4000 elements of that of the step before";
                return Err(ContactError::bad_value(name, moved * lattice.size[axis], allowed));
            }
        }
        let before = both.values_of(&history.window, &history.tractions);
        let both_grid = lattice.grid(&both, 0.0);
        let mut rest = self.rolled;
        // Of the length of the substep before.
        let mut operator: Option<(f64, TransientStep)> = None;
        let mut memory: Option<(f64, Memory)> = None;
        loop {
            let behind = self.rolled - rest;
            let longest = self.grid.dx.max(GROWTH * (behind - length));
            // No crumbs at the end.
            let parts = (rest / longest - 1e-9).ceil();
            let rolled = if parts > 2.0 { longest } else { rest / parts.max(1.0) };
            let share = if self.rolled > 0.0 { rolled / self.rolled } else { 1.0 };
            let (grid, material) = (&self.grid, &self.material);
            let forward = if self.backward { -rolled } else { rolled };
            let carried = if behind > 0.0 {
                memory = memory.filter(|(of, _)| same(*of, rolled));
                let new = || (rolled, Memory::new(grid, material, forward));
                memory.get_or_insert_with(new).1.carried(&self.tractions)
            } else {
                let carried = Memory::new(&both_grid, material, forward).carried(&before);
                self.window.values_of(&both, &carried)
            };
            operator = operator.filter(|(of, _)| same(*of, rolled));
            let new = || (rolled, TransientStep::new(grid, material, forward));
            let step = &operator.get_or_insert_with(new).1;
            let mut solve = |rigid: &[[f64; 2]], start: &[[f64; 2]], _: bool| {
                step.solve(&self.bound, rigid, start)
            };
            let stiffness = self.stiffness();
            let done = advance(
                &self.grid,
                &self.tractions,
                &carried,
                self.displacement.map(|d| share * d),
                &Given { force: self.force, limit: self.limit, compliance: 1.0 / stiffness },
                &mut solve,
            )?;
            self.take(&done, 1.0);
            self.substeps += 1;
            rest -= rolled;
            if parts <= 1.0 || rest <= 0.0 {
                return Ok(());
            }
        }
    }

    /// The whole step as steady rolling.
    fn steady(&mut self) -> Result<(), ContactError> {
        let carried = vec![[0.0; 2]; self.grid.len()];
        let (grid, material, bound) = (&self.grid, &self.material, &self.bound);
        let forward = |bound: &[f64], rigid: &[[f64; 2]], slopes: bool| {
            // Slopes of forces need tractions that have settled well.
            if slopes {
                steady_rolling_within(TOLERANCE, grid, material, bound, rigid)
            } else {
                steady_rolling(grid, material, bound, rigid)
            }
        };
        let backward = self.backward;
        let mut solve = |rigid: &[[f64; 2]], _: &[[f64; 2]], slopes: bool| {
            if !backward {
                return forward(bound, rigid, slopes);
            }
            let (bound, rigid) = (grid.mirrored(bound), grid.mirrored_vectors(rigid));
            forward(&bound, &rigid, slopes).mirrored(grid)
        };
        let length = self.grid.along as f64 * self.grid.dx;
        let compliance = 1.0 / (self.stiffness() * length);
        let done = advance(
            grid,
            &self.tractions,
            &carried,
            self.displacement.map(|d| d / self.rolled),
            &Given { force: self.force, limit: self.limit, compliance },
            &mut solve,
        )?;
        self.take(&done, self.rolled);
        Ok(())
    }

    /// About the force over the displacement of a contact that adheres [N/m].
    fn stiffness(&self) -> f64 {
        let loaded = self.bound.iter().filter(|&&g| g > 0.0).count() as f64;
        let radius = (loaded * self.grid.element_area() / std::f64::consts::PI).sqrt();
        4.0 * self.material.shear_modulus * radius / (2.0 - self.material.poisson_ratio)
    }

    /// Takes over what a substep leads to; displacements and slip count `times`.
    fn take(&mut self, done: &Advanced, times: f64) {
        let Advanced { tractions: found, displacement } = done;
        self.sweeps += found.sweeps;
        self.converged &= found.converged;
        for (sum, part) in self.found.iter_mut().zip(displacement) {
            *sum += times * part;
        }
        let area = self.grid.element_area();
        for k in 0..self.grid.len() {
            let p = [found.x[k], found.y[k]];
            self.tractions[k] = p;
            self.slips[k] = found.slips[k];
            let square = p[0] * p[0] + p[1] * p[1];
            if !found.slips[k] || square <= 0.0 {
                continue;
            }
            // Against the traction, as the law has it: what the iteration leaves besides is error.
            let s = [found.slip_x[k], found.slip_y[k]];
            let against = (-(s[0] * p[0] + s[1] * p[1]) / square).max(0.0) * times;
            for (slip, p) in self.slip[k].iter_mut().zip(p) {
                *slip -= against * p;
            }
            self.work[k] += against * square * area;
        }
    }

    pub fn result(&self, strips: &Strips) -> TransientResult {
        let mut contact = without_creep_forces(strips);
        let [fx, fy] = force_of(&self.grid, &self.tractions);
        (contact.fx, contact.fy) = (fx, fy);
        let area = self.grid.element_area();
        contact.mz = self.tractions.iter().enumerate().fold(0.0, |sum, (k, p)| {
            let (x, y) = (self.grid.x(k % self.grid.along), self.grid.y(k / self.grid.along));
            sum + area * (x * p[1] - y * p[0])
        });
        TransientResult {
            contact,
            displacement: self.found,
            work: self.work.iter().sum(),
            substeps: self.substeps,
            sweeps: self.sweeps,
            converged: self.converged,
        }
    }

    pub fn field(self, pressure: Vec<f64>) -> TransientField {
        let mut contact = ContactField::of_pressure(self.grid, pressure);
        contact.traction = self.tractions;
        for (k, &slips) in self.slips.iter().enumerate() {
            contact.set_adherence(k, slips);
        }
        if self.rolled > 0.0 {
            let over = self.slip.iter().map(|s| s.map(|s| s / self.rolled));
            contact.slip = Some(over.collect());
        }
        TransientField { contact, slip: self.slip, work: self.work }
    }
}

/// Whether two distances are the same but for rounding.
fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * a.abs()
}
