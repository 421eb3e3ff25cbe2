//! Newton's method for the least energy over loads that are not negative.
//!
//! Each step goes to the least value of the quadratic model of the energy: loads that would become
//! negative are held at zero, and those at zero that are pushed away stay there. Where the model is
//! not convex its diagonal is raised until it is; where the energy rises the step is shortened. Near
//! the end the factor of the last step serves again.

mod again;
mod choice;
mod short_steps;

#[cfg(target_arch = "x86_64")]
use pulp::x86::V3;

use super::factor::{Factor, KeptFactor};
use super::kernel::{Kernel, Table};
use super::lanes::{FEW, LANES, Lanes, Plain, Simd, by_blocks};
use super::lattice::Lattice;
use super::problem::Problem;
use super::shape::Knots;
use super::system::System;
use crate::math::fixed_vec::FixedVec;

/// Most steps with a new factor.
pub(super) const MAX_STEPS: usize = 40;
/// Greatest change of a load per width over that of the ellipse, and of χ, in one step.
const MAX_CHANGE: [f64; 2] = [1.5, 1.0];
/// Steps without second derivatives before the first one with them, and the change of a load per
/// width over that of the ellipse at which there are enough of them.
const MOST_RELAXED: usize = 4;
const RELAXED: f64 = 0.1;
/// What a change of χ counts against one of a load per width over that of the ellipse.
const SHAPE_WEIGHT: f64 = 0.05;
/// Expected error of a load per width over that of the ellipse at which it ends.
const LAST_ERROR: f64 = 5e-10;
/// Change below which the factor of a step serves again, and by how much it has to get less then.
const OLD_FACTOR: f64 = 2e-2;
const MIN_GAIN: f64 = 0.1;
/// Most steps with the same factor.
const MOST_SHORT: usize = 5;
/// Rise of the energy that rounding may cause, over the energy.
const ROUNDING: f64 = 1e-10;
/// Range of the factors by which a step is shortened.
const SHORTER: [f64; 2] = [0.1, 0.5];
/// What a diagonal is raised by over itself, and by how much more if that is not enough.
const RAISE: [f64; 2] = [0.01, 3.0];
const MOST_RAISE: f64 = 1e3;
/// Times that loads are held in one step.
const MOST_HELD: usize = 3;

/// Solver of one problem, with its memory.
#[derive(Clone, Debug)]
pub(super) struct Newton {
    pub problem: Problem,
    pub system: System,
    /// Loads of all nodes over that of the ellipse [m].
    pub load: FixedVec<f64>,
    /// Curvature of the displacement along each node that carries load, over that of the wheel [-].
    pub curvature: FixedVec<f64>,
    pub factor: Factor,
    /// Whether nodes that are left out would stay without load.
    is_checked: bool,
    /// The step of χ and the loads, four by four.
    step: Vec<Lanes>,
    /// What squares of its numbers count, and the last step with a new factor and those after it.
    metric: Vec<Lanes>,
    past: [Vec<Lanes>; MOST_SHORT + 1],
    /// Nodes to be taken though neither they nor those beside them are loaded.
    extra: FixedVec<bool>,
    /// Nodes to be taken.
    wanted: FixedVec<usize>,
    /// The point before the last step.
    last: Point,
    /// The solution at the pose that overlaps are lowered from, if they are.
    above: Solution,
    /// Steps with a new factor, and with an old one, so far.
    pub steps: u64,
    pub short_steps: u64,
    /// Greatest displacement left of the overlap at a node that carries load, over the depth,
    /// before the last step.
    pub residual: f64,
}

/// A point on the way.
#[derive(Clone, Debug)]
struct Point {
    at: Solution,
    energy: f64,
    /// What the energy was to change by, to first order.
    slope: f64,
}

/// Loads and χ.
#[derive(Clone, Debug)]
struct Solution {
    load: FixedVec<f64>,
    shape: FixedVec<f64>,
}

impl Solution {
    fn new(nodes: usize, knots: usize) -> Self {
        Self { load: FixedVec::new(nodes), shape: FixedVec::new(knots) }
    }

    fn keep(&mut self, load: &[f64], shape: &[f64]) {
        self.load.clear();
        self.load.extend_from_slice(load);
        self.shape.clear();
        self.shape.extend_from_slice(shape);
    }
}

/// What a step changed.
#[derive(Clone, Copy, Debug)]
struct Change {
    /// Greatest change of a load per width over that of the ellipse, or of χ as it counts.
    greatest: f64,
    /// Whether a load went to zero, or the model was not convex.
    is_rough: bool,
}

/// Calls a function of [`Newton`] with the best instructions there are.
macro_rules! with_simd {
    ($newton:ident.$function:ident($($argument:expr),*)) => {{
        #[cfg(target_arch = "x86_64")]
        if let Some(simd) = V3::try_new() {
            return simd.apart(#[inline(always)] || $newton.$function(simd, $($argument),*));
        }
        $newton.$function(Plain, $($argument),*)
    }};
}

impl Newton {
    pub fn new(most: usize) -> Self {
        let knots = Knots::<f64>::most(most);
        let blocks = most.div_ceil(LANES) + knots.div_ceil(LANES);
        Self {
            problem: Problem::new(most),
            system: System::new(most),
            load: FixedVec::new(most),
            curvature: FixedVec::new(most),
            factor: Factor::new(most + knots),
            is_checked: false,
            step: vec![[0.0; LANES]; blocks],
            metric: vec![[0.0; LANES]; blocks],
            past: std::array::from_fn(|_| vec![[0.0; LANES]; blocks]),
            extra: FixedVec::new(most),
            wanted: FixedVec::new(most),
            last: Point { at: Solution::new(most, knots), energy: 0.0, slope: 0.0 },
            above: Solution::new(most, knots),
            steps: 0,
            short_steps: 0,
            residual: 0.0,
        }
    }

    /// Solves the problem of the nodes of `lattice`, from the last solution where that is one of
    /// nearly the same pose and has the same nodes; false where it does not converge.
    pub fn solve(&mut self, lattice: &Lattice, is_near: bool) -> bool {
        with_simd!(self.solve_with(lattice, is_near))
    }

    /// Keeps the solution before it is lowered: the next one nearby begins from there.
    pub fn keep_pose(&mut self) {
        self.above.keep(&self.load, &self.system.shape);
    }

    /// Moves to the solution with overlaps that are greater by `way` times the `cosines` of the
    /// nodes [m]; false where it does not converge.
    pub fn lower(&mut self, cosines: &[f64], way: f64) -> bool {
        with_simd!(self.lower_with(cosines, way))
    }

    /// The same by the derivatives of the solution alone; the sum of the loads over that of the
    /// ellipse, times the `cosines` [m].
    pub fn look_down(&mut self, cosines: &[f64], way: f64) -> f64 {
        self.grow(cosines, way);
        self.load.iter().zip(cosines).map(|(load, cosine)| load * cosine).sum()
    }

    fn grow(&mut self, cosines: &[f64], way: f64) -> Change {
        with_simd!(self.grow_with(cosines, way))
    }

    /// What is read off a solution besides loads and χ, after a look whether nodes that were left out
    /// stay without load; false where Newton's method does not converge.
    pub fn finish(&mut self) -> bool {
        with_simd!(self.finish_with())
    }

    /// Factorises the second derivatives by χ and the loads that are not zero, at the present
    /// unknowns; false where they are not positive definite.
    pub fn factorise(&mut self) -> bool {
        with_simd!(self.factorise_with())
    }

    /// Solves with what was factorised, in place, for `loads` of all nodes and `shape` of all
    /// knots; loads that are zero stay as they are.
    pub fn solve_linear(&mut self, loads: &mut [f64], shape: &mut [f64]) {
        with_simd!(self.solve_linear_with(loads, shape));
    }

    /// Keeps what was factorised, whose unknowns are the loads that are not zero and χ.
    pub fn keep(&self, kept: &mut KeptFactor) {
        let Self { system, factor, load, .. } = self;
        let loads = system.nodes.iter().map(|&i| (i, load[i] > 0.0));
        kept.keep(factor, system.shape.len(), loads);
    }

    /// Solves with what was factorised for what is in `step`.
    fn solve_step(&mut self) {
        with_simd!(self.solve_step_with());
    }

    #[inline(always)]
    fn solve_step_with<S: Simd>(&mut self, simd: S) {
        self.factor.solve(simd, &mut self.step);
    }

    #[inline(always)]
    fn solve_with<S: Simd>(&mut self, simd: S, lattice: &Lattice, is_near: bool) -> bool {
        let table = &Kernel::shared().coefficients;
        if is_near && !self.above.load.is_empty() && self.problem.has_nodes_of(lattice) {
            return self.solve_again(simd, table, lattice);
        }
        self.above.load.clear();
        self.problem.take(lattice);
        self.problem.start(lattice, &mut self.load);
        self.system.shape.clear();
        self.system.shape.resize(self.problem.knots.count, 0.0);
        self.curvature.clear();
        self.curvature.resize(self.load.len(), 1.0);
        self.system.nodes.clear();
        self.mark_tops();
        self.choose_nodes(simd, table);
        for _ in 0..MOST_RELAXED {
            if self.system.relax(simd, table, &self.problem) < RELAXED {
                break;
            }
        }
        self.system.give_loads(&mut self.load);
        self.iterate(simd, table)
    }

    /// Newton's method from the present unknowns on; false where it does not converge.
    #[inline(always)]
    fn iterate<S: Simd>(&mut self, simd: S, table: &Table) -> bool {
        self.last.energy = f64::INFINITY;
        for _ in 0..MAX_STEPS {
            self.steps += 1;
            self.choose_nodes(simd, table);
            self.system.differentiate::<S, true>(simd, table, &self.problem);
            if self.system.energy > self.last.energy + ROUNDING * self.last.energy.abs() {
                self.retreat();
                continue;
            }
            let Self { system, factor, problem, .. } = self;
            simd.apart(
                #[inline(always)]
                || system.assemble(simd, problem, factor),
            );
            let Some(change) = self.full_step(simd) else { return false };
            if change.greatest > OLD_FACTOR || change.is_rough {
                continue;
            }
            let is_near = change.greatest * change.greatest < LAST_ERROR;
            if (is_near || self.short_steps(simd, table, change, change.greatest))
                && self.is_complete(simd, table)
            {
                self.is_checked = true;
                return true;
            }
        }
        false
    }

    #[inline(always)]
    fn finish_with<S: Simd>(&mut self, simd: S) -> bool {
        let table = &Kernel::shared().coefficients;
        let settled = self.is_checked || self.is_complete(simd, table) || self.iterate(simd, table);
        let Self { system, problem, curvature, .. } = self;
        system.give_curvatures(simd, table, problem, curvature);
        settled
    }

    /// Goes part of the last step back.
    #[inline(always)]
    fn retreat(&mut self) {
        let Self { system, load, last, .. } = self;
        let rise = system.energy - last.energy - last.slope;
        let part = (-0.5 * last.slope / rise).clamp(SHORTER[0], SHORTER[1]);
        last.slope *= part;
        let between = |now: &mut FixedVec<f64>, last: &FixedVec<f64>| {
            for (now, last) in now.iter_mut().zip(last.iter()) {
                *now = last + part * (*now - last);
            }
        };
        between(load, &last.at.load);
        between(&mut system.shape, &last.at.shape);
    }

    /// One step of Newton's method, or nothing where the equations have no solution.
    #[inline(always)]
    fn full_step<S: Simd>(&mut self, simd: S) -> Option<Change> {
        let Self { system, factor, step, .. } = self;
        let (first, blocks) = (factor.first, system.blocks);
        let free = &mut factor.free[first..];
        by_blocks!(blocks => B, system.release::<S, B>(simd, free));
        self.residual = system.residual(simd) / self.problem.scales.depth;
        let mut raise = 0.0;
        for _ in 0..MOST_HELD {
            while !simd.apart(
                #[inline(always)]
                || factor.factorise(simd, raise),
            ) {
                raise = RAISE[0].max(raise * RAISE[1]);
                if raise > MOST_RAISE {
                    return None;
                }
            }
            by_blocks!(blocks => B, system.load_up::<S, B>(simd, factor, step));
            simd.apart(
                #[inline(always)]
                || factor.solve(simd, step),
            );
            let free = &mut factor.free[first..];
            if !by_blocks!(blocks => B, system.hold::<S, B>(simd, &step[first..], free)) {
                break;
            }
        }
        self.last.at.keep(&self.load, &self.system.shape);
        self.last.energy = self.system.energy;
        let mut change = self.change(simd, f64::INFINITY);
        change.is_rough |= raise > 0.0;
        change.greatest.is_finite().then_some(change)
    }

    /// Takes the step if it changes less than `most`.
    #[inline(always)]
    fn change<S: Simd>(&mut self, simd: S, most: f64) -> Change {
        let Self { system, factor, step, load, last, .. } = self;
        let (first, blocks) = (factor.first, system.blocks);
        let (shape_step, step) = step.split_at(first);
        let [greatest, slope] = by_blocks!(blocks => B, system.measure::<S, B>(simd, step));
        let (mut greatest_shape, mut slope) = (0.0_f64, slope);
        for (by, gradient) in shape_step.as_flattened().iter().zip(system.shape_gradient.iter()) {
            greatest_shape = greatest_shape.max(by.abs());
            slope += by * gradient;
        }
        let part = (MAX_CHANGE[0] / greatest).min(MAX_CHANGE[1] / greatest_shape).min(1.0);
        let greatest = part * greatest.max(SHAPE_WEIGHT * greatest_shape);
        // A step that is not a number is never taken.
        let greatest = if slope.is_finite() { greatest } else { f64::INFINITY };
        if greatest > most || greatest.is_infinite() {
            return Change { greatest, is_rough: false };
        }
        last.slope = slope * part;
        for (shape, by) in system.shape.iter_mut().zip(shape_step.as_flattened()) {
            *shape += part * by;
        }
        let free = &factor.free[first..];
        let lost = by_blocks!(blocks => B, system.change::<S, B>(simd, step, free, part));
        system.give_loads(load);
        Change { greatest, is_rough: lost }
    }

    #[inline(always)]
    fn factorise_with<S: Simd>(&mut self, simd: S) -> bool {
        let table = &Kernel::shared().coefficients;
        self.choose_nodes(simd, table);
        self.system.differentiate::<S, true>(simd, table, &self.problem);
        self.system.assemble(simd, &self.problem, &mut self.factor);
        let Self { system, factor, .. } = self;
        let first = factor.first;
        let free = factor.free[first..].as_flattened_mut();
        for (free, &i) in free.iter_mut().zip(system.nodes.iter()) {
            *free = f64::from(u8::from(self.load[i] > 0.0));
        }
        factor.factorise(simd, 0.0)
    }

    #[inline(always)]
    fn solve_linear_with<S: Simd>(&mut self, simd: S, loads: &mut [f64], shape: &mut [f64]) {
        let Self { system, factor, step, load, .. } = self;
        let first = factor.first * LANES;
        let loaded = || system.nodes.iter().enumerate().filter(|&(_, &i)| load[i] > 0.0);
        let rows = step.as_flattened_mut();
        rows.fill(0.0);
        rows[..shape.len()].copy_from_slice(shape);
        loaded().for_each(|(k, &i)| rows[first + k] = loads[i]);
        factor.solve(simd, step);
        let rows = step.as_flattened();
        shape.copy_from_slice(&rows[..shape.len()]);
        loaded().for_each(|(k, &i)| loads[i] = rows[first + k]);
    }
}
