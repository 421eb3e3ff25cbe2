//! Derivatives of a solution by whatever its problem depends on.
//!
//! At the least energy the gradient G by the loads that are there and by χ is zero. With dual
//! numbers for the problem and the unknowns held, G has the slopes ∂G/∂p; the unknowns move by
//!
//! ```text
//! -H^-1 ∂G/∂p,   H the Hessian at the solution
//! ```
//!
//! Backwards that is one solution with the factor of H for all that the problem depends on.
//!
//! Nodes have derivatives too: they move with the pose as they are laid. Curvatures, which lengths
//! and pressures are read off with, are found anew from the unknowns as they move.

use super::StripSolver;
use super::factor::KeptFactor;
use super::hat::{Hat, KeptPair};
use super::kernel::Kernel;
use super::lattice::Lattice;
use super::line::OverlapLine;
use super::shape::Knots;
use super::zones::Zones;
use crate::math::dual::Dual;
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;
use crate::math::tape::{self, Taped};
use crate::normal::Strips;

/// Memory for derivatives of solutions.
#[derive(Clone, Debug)]
pub struct StripFollower<T> {
    lattice: Lattice<T>,
    hats: FixedVec<Hat<T>>,
    knots: Knots<T>,
    zones: Zones<T>,
    load: FixedVec<T>,
    shape: FixedVec<T>,
    gradient: Gradient<T>,
    /// Right side of one direction: loads and χ.
    right: [FixedVec<f64>; 2],
    /// Factors of all solutions since they were forgotten, for derivatives backwards, and how many
    /// these are.
    kept: Vec<KeptFactor>,
    kept_count: usize,
}

/// The gradient of the energy, in numbers of any kind, and what it follows from.
#[derive(Clone, Debug)]
struct Gradient<T> {
    smooth: FixedVec<T>,
    square: FixedVec<T>,
    rate: FixedVec<T>,
    by_load: FixedVec<T>,
    by_square: FixedVec<T>,
    curvature: FixedVec<T>,
    by_shape: FixedVec<T>,
    /// Pairs of loaded nodes, for derivatives backwards.
    pairs: Vec<KeptPair>,
}

impl<T: Real> StripFollower<T> {
    /// With room for the solutions of a solver.
    pub fn new(solver: &StripSolver) -> Self {
        let most = solver.lattice.nodes.capacity();
        let knots = Knots::<T>::most(most);
        let column = || FixedVec::new(most);
        Self {
            lattice: Lattice::new(solver.lattice.wanted, most),
            hats: FixedVec::new(most),
            knots: Knots::new(most),
            zones: Zones::new(most),
            load: column(),
            shape: FixedVec::new(knots),
            gradient: Gradient {
                smooth: column(),
                square: column(),
                rate: column(),
                by_load: column(),
                by_square: column(),
                curvature: column(),
                by_shape: FixedVec::new(knots),
                pairs: Vec::new(),
            },
            right: [FixedVec::new(most), FixedVec::new(knots)],
            kept: Vec::new(),
            kept_count: 0,
        }
    }
}

impl<T: Real> Gradient<T> {
    /// Displacements by loads that are not zero, and their curvatures along the nodes.
    fn sum_up(
        &mut self,
        lattice: &Lattice<T>,
        hats: &[Hat<T>],
        knots: &Knots<T>,
        load: &[T],
        shape: &[T],
    ) {
        let (n, zero, scales) = (load.len(), T::from(0.0), &lattice.scales);
        let kernel = Kernel::shared();
        for column in [&mut self.smooth, &mut self.square, &mut self.rate] {
            column.clear();
        }
        for column in [&mut self.by_load, &mut self.by_square] {
            column.clear();
            column.resize(n, zero);
        }
        for i in 0..n {
            let smooth = lattice.mean_over_hats(i, load);
            let rate = (-knots.value(i, shape)).exp() * scales.load * scales.square_over_load;
            self.smooth.push(smooth);
            self.rate.push(rate);
            self.square.push(scales.least_square + smooth * rate);
        }
        let is_loaded = |i: &usize| load[*i] > 0.0;
        let mut none = None;
        let mut pair = 0;
        for j in (0..n).filter(is_loaded) {
            for i in (0..=j).filter(is_loaded) {
                if T::IS_BACKWARD && pair == self.pairs.len() {
                    self.pairs.push(None);
                }
                let kept = self.pairs.get_mut(pair).unwrap_or(&mut none);
                pair += 1;
                let squares = [self.square[i], self.square[j]];
                let [value, by_p, by_q] = hats[j].potential(&hats[i], kernel, squares, kept);
                self.by_load[i] += value * load[j];
                self.by_square[i] += by_p * load[j];
                if i < j {
                    self.by_load[j] += value * load[i];
                    self.by_square[j] += by_q * load[i];
                }
            }
        }
        self.curvature.clear();
        let pairs = self.by_square.iter().zip(lattice.nodes.iter());
        self.curvature.extend(pairs.map(|(&by, node)| -by * node.radius * 8.0 / scales.unit));
    }

    /// The gradient by loads that are not zero, and by χ.
    fn find(
        &mut self,
        lattice: &Lattice<T>,
        hats: &[Hat<T>],
        knots: &Knots<T>,
        load: &[T],
        shape: &[T],
    ) {
        self.sum_up(lattice, hats, knots, load, shape);
        let (n, zero, scales) = (load.len(), T::from(0.0), &lattice.scales);
        // Of the energy by s now.
        for (i, by) in self.by_square.iter_mut().enumerate() {
            let bending = scales.unit / (lattice.nodes[i].radius * 8.0);
            self.by_load[i] += bending * self.square[i] - lattice.nodes[i].overlap * scales.unit;
            *by = (*by + bending) * load[i] * self.rate[i];
        }
        self.by_shape.clear();
        self.by_shape.resize(shape.len(), zero);
        for i in 0..n {
            self.by_load[i] += lattice.mean_over_hats(i, &self.by_square);
            let by = self.by_square[i] * self.smooth[i];
            let (knot, share) = knots.between[i];
            self.by_shape[knot] -= by * (1.0 - share);
            self.by_shape[knot + 1] -= by * share;
        }
        let m = shape.len();
        for (by, stiffness) in self.by_shape.iter_mut().zip(knots.penalties.chunks_exact(m)) {
            let sum: T = stiffness.iter().zip(shape).map(|(&a, &x)| x * a).sum();
            *by += sum * scales.energy;
        }
    }
}

/// Numbers in which solutions are followed.
pub trait StripNumber: Real {
    /// Moves loads and χ of `follower`, which have the values of the solution of `solver`, so that
    /// its gradient stays zero.
    fn move_unknowns(follower: &mut StripFollower<Self>, solver: &mut StripSolver);
}

impl<const N: usize> StripNumber for Dual<N> {
    fn move_unknowns(follower: &mut StripFollower<Self>, solver: &mut StripSolver) {
        let StripFollower { gradient, load, shape: knots, right, .. } = follower;
        for direction in 0..N {
            let slopes = |right: &mut FixedVec<f64>, gradient: &[Self]| {
                right.clear();
                right.extend(gradient.iter().map(|by| -by.slopes[direction]));
            };
            let [loads, shape] = right;
            slopes(loads, &gradient.by_load);
            slopes(shape, &gradient.by_shape);
            solver.newton.solve_linear(loads, shape);
            // Loads that are zero stay so.
            let loaded = load.iter_mut().zip(loads.iter()).filter(|(load, _)| **load > 0.0);
            for (unknown, step) in loaded.chain(knots.iter_mut().zip(shape.iter())) {
                unknown.slopes[direction] = *step;
            }
        }
    }
}

impl StripNumber for Taped {
    fn move_unknowns(follower: &mut StripFollower<Self>, solver: &mut StripSolver) {
        let StripFollower { gradient, load, shape, kept, kept_count, .. } = follower;
        if kept.len() == *kept_count {
            kept.push(KeptFactor::like(&solver.newton.factor));
        }
        let own = &mut kept[*kept_count];
        *kept_count += 1;
        solver.newton.keep(own);
        let (loaded, knots) = own.unknowns();
        let rights = loaded.iter().map(|&i| gradient.by_load[i]);
        tape::unknowns(
            rights.chain(gradient.by_shape.iter().copied()),
            loaded.len() + knots,
            |n, moving| match loaded.get(n) {
                Some(&i) => moving.enter(&mut load[i]),
                None => moving.enter(&mut shape[n - loaded.len()]),
            },
        );
    }
}

impl StripFollower<Taped> {
    /// Forgets the solutions that were followed.
    pub fn forget(&mut self) {
        self.kept_count = 0;
    }

    /// Solves with the factor of solution number `n` since they were forgotten, in place.
    pub fn solve_kept(&mut self, n: usize, right: &mut [f64]) {
        self.kept[n].solve(right);
    }
}

impl<T: StripNumber> StripFollower<T> {
    /// Fills `strips` with the zones of the last solution of `solver` as they move with `line`;
    /// false where that was not one.
    pub fn follow(
        &mut self,
        solver: &mut StripSolver,
        line: &mut impl OverlapLine<T>,
        contact_modulus: f64,
        strips: &mut Strips<T>,
    ) -> bool {
        let count = solver.lattice.nodes.len();
        if count == 0 {
            return true;
        }
        self.lattice.lay(line, &solver.overlaps);
        if self.lattice.nodes.len() != count || !solver.newton.factorise() {
            return false;
        }
        self.hats.clear();
        self.hats.extend((0..count).map(|i| Hat::new(&self.lattice, i)));
        self.knots.place(&self.lattice);
        let knots = &self.knots;
        self.load.clear();
        self.load.extend(solver.newton.load.iter().map(|&load| T::from(load)));
        self.shape.clear();
        self.shape.extend(solver.newton.system.shape.iter().map(|&shape| T::from(shape)));
        self.gradient.pairs.clear();
        self.gradient.find(&self.lattice, &self.hats, knots, &self.load, &self.shape);
        T::move_unknowns(self, solver);
        // Curvatures move with the unknowns too.
        let (lattice, scales, knots) = (&self.lattice, &self.lattice.scales, &self.knots);
        self.gradient.sum_up(lattice, &self.hats, knots, &self.load, &self.shape);
        let solution = [&self.load[..], &self.shape, &self.gradient.curvature];
        self.zones.emit(lattice, scales, knots, solution, contact_modulus, strips);
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::contacts::separation::Probe;
    use crate::normal::least_energy::{LinePlace, Section};
    use approx::assert_relative_eq;

    /// Two humps, the second one shifted by `tilt` against the first one, `depth` deep; all of it
    /// tilted.
    #[derive(Clone, Copy)]
    struct Humps<T> {
        depth: T,
        tilt: T,
    }

    impl<T: Real> OverlapLine<T> for Humps<T> {
        fn place(&mut self, u: T) -> LinePlace<T> {
            let (wave, cosine) = (u * 600.0).sin_cos();
            let (sine, tangent) = (u * 20.0).sin_cos();
            LinePlace {
                u,
                y: u,
                dy: T::from(1.0),
                overlap: self.depth + self.tilt * u - u * u * 0.4 + cosine * 8e-6,
                overlap_slope: self.tilt - u * 0.8 - wave * (600.0 * 8e-6),
                x: u * u * 2.0,
                tangent: [tangent, sine],
            }
        }

        fn section(&mut self, at: &LinePlace<T>) -> Section<T> {
            Section::even(at.u + 0.46)
        }
    }

    fn solve(solver: &mut StripSolver, depth: f64, tilt: f64) -> Strips {
        let mut line = Humps { depth, tilt };
        let probes: Vec<Probe> = (-300..=300)
            .map(|i| 1e-4 * f64::from(i))
            .map(|u| Probe { u, f: -line.place(u).overlap })
            .collect();
        let mut strips = Strips::with_capacity(8, 480);
        solver.solve(&mut line, &probes, 0.0, 1.0, None, &mut strips);
        strips
    }

    #[test]
    fn derivatives_are_those_of_the_solution() {
        let mut solver = StripSolver::new(20);
        for (depth, tilt) in [(6e-5, 0.0), (3e-5, 1e-3), (1.2e-4, -2e-3), (1.5e-5, 4e-4)] {
            let sums = |strips: &Strips| -> [f64; 6] {
                let moment: f64 = strips.zones.iter().map(|zone| zone.load * zone.y).sum();
                let (middle, zone) = (strips.y.len() / 2, &strips.zones[0]);
                let [length, u] = [strips.half_length[middle], strips.u[middle]];
                [strips.load(), moment, length, u, zone.max_pressure, zone.area]
            };
            let step = 1e-9;
            let difference = |solver: &mut StripSolver, way: [f64; 2]| -> [f64; 6] {
                let at = |solver: &mut StripSolver, k: f64| {
                    sums(&solve(solver, depth + k * step * way[0], tilt + k * step * way[1]))
                };
                let [a, b] = [at(solver, 1.0), at(solver, -1.0)];
                [0, 1, 2, 3, 4, 5].map(|i| (a[i] - b[i]) / (2.0 * step))
            };
            let differences = [[1.0, 0.0], [0.0, 1.0]].map(|way| difference(&mut solver, way));
            let found = solve(&mut solver, depth, tilt);
            let mut line = Humps { depth: Dual::variable(depth, 0), tilt: Dual::variable(tilt, 1) };
            let mut strips = Strips::with_capacity(8, 480);
            let mut follower = StripFollower::new(&solver);
            assert!(follower.follow(&mut solver, &mut line, 1.0, &mut strips));
            assert_relative_eq!(strips.load().value, found.load(), max_relative = 1e-12);
            let moment: Dual<2> = strips.zones.iter().map(|zone| zone.load * zone.y).sum();
            let (middle, zone) = (strips.y.len() / 2, &strips.zones[0]);
            let [length, u] = [strips.half_length[middle], strips.u[middle]];
            let numbers = [strips.load(), moment, length, u, zone.max_pressure, zone.area];
            for (k, number) in numbers.into_iter().enumerate() {
                // Moments are those of loads millimetres away; lengths have slopes of their own.
                let scale = if k < 2 {
                    [1.0, 5e-3][k] * differences[0][0].abs().max(differences[1][0].abs())
                } else {
                    differences[0][k].abs().max(differences[1][k].abs())
                };
                for (slope, difference) in number.slopes.iter().zip(differences) {
                    println!("{k} {slope} {} {:e}", difference[k], (slope - difference[k]) / scale);
                    assert_relative_eq!(*slope, difference[k], epsilon = 1e-6 * scale);
                }
            }
        }
    }
}
