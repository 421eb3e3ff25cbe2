//! From one solution to one beside it, with the factor of the last step.

use super::super::kernel::{Kernel, Table};
use super::super::lanes::{FEW, LANES, Simd, by_blocks};
use super::super::lattice::Lattice;
use super::{Change, LAST_ERROR, MIN_GAIN, Newton, OLD_FACTOR};

impl Newton {
    /// Solves for the nodes of `lattice`, which are those of the last problem, moved.
    #[inline(always)]
    pub(super) fn solve_again<S: Simd>(
        &mut self,
        simd: S,
        table: &Table,
        lattice: &Lattice,
    ) -> bool {
        let Self { problem, system, load, above, .. } = self;
        // Solutions are alike, each about its own nodes: a deeper wheel has the same χ, and loads per
        // width over those of the ellipse. Nodes that were taken on the way are those of the factor.
        system.shape.copy_from_slice(&above.shape);
        load.fill(0.0);
        for &i in system.nodes.iter() {
            load[i] = above.load[i] * lattice.nodes[i].width / problem.points[i].width;
        }
        problem.take(lattice);
        simd.apart(
            #[inline(always)]
            || system.take(simd, problem, load),
        );
        system.differentiate::<S, false>(simd, table, problem);
        let Self { system, factor, step, .. } = self;
        let blocks = system.blocks;
        by_blocks!(blocks => B, system.load_up::<S, B>(simd, factor, step));
        simd.apart(
            #[inline(always)]
            || factor.solve(simd, step),
        );
        let change = self.change(simd, OLD_FACTOR);
        self.is_checked = false;
        let is_far = change.greatest > OLD_FACTOR;
        !is_far && self.go_on(simd, table, change) || self.iterate(simd, table)
    }

    /// Goes on with the last factor after a first step with it.
    #[inline(always)]
    fn go_on<S: Simd>(&mut self, simd: S, table: &Table, change: Change) -> bool {
        let is_near = MIN_GAIN * change.greatest < LAST_ERROR;
        !change.is_rough && (is_near || self.short_steps(simd, table, change, MIN_GAIN))
    }

    /// Sum of the loads over that of the ellipse, times the `cosines` of their nodes [m], and its
    /// derivative by a way by which each overlap grows with its cosine [-], by the last factor.
    pub fn carried(&mut self, cosines: &[f64]) -> [f64; 2] {
        self.go_down(cosines);
        let Self { system, factor, step, load, .. } = self;
        let rows = step.as_flattened()[factor.first * LANES..].iter();
        let taken = system.nodes.iter().zip(rows).filter(|&(&i, _)| load[i] > 0.0);
        let sums = taken.map(|(&i, rate)| [load[i] * cosines[i], rate * cosines[i]]);
        sums.fold([0.0; 2], |[a, b], [c, d]| [a + c, b + d])
    }

    /// Puts the derivatives of the unknowns by the way into `step`, by the last factor.
    fn go_down(&mut self, cosines: &[f64]) {
        let unit = self.problem.scales.unit;
        let Self { system, factor, step, load, .. } = self;
        let first = factor.first * LANES;
        let rows = step.as_flattened_mut();
        rows.fill(0.0);
        for (row, &i) in rows[first..].iter_mut().zip(system.nodes.iter()) {
            if load[i] > 0.0 {
                *row = cosines[i] * unit;
            }
        }
        self.solve_step();
    }

    /// Moves on to where overlaps are greater by `way` times the `cosines`, right after
    /// [`carried`](Self::carried).
    #[inline(always)]
    pub(super) fn lower_with<S: Simd>(&mut self, simd: S, cosines: &[f64], way: f64) -> bool {
        let table = &Kernel::shared().coefficients;
        let change = self.grow_with(simd, cosines, way);
        self.go_on(simd, table, change) || self.iterate(simd, table)
    }

    /// Lets overlaps grow by `way` times the `cosines`, and the unknowns by their derivatives.
    #[inline(always)]
    pub(super) fn grow_with<S: Simd>(&mut self, simd: S, cosines: &[f64], way: f64) -> Change {
        let grown = way * self.problem.scales.unit;
        for (point, cosine) in self.problem.points.iter_mut().zip(cosines) {
            point.overlap += grown * cosine;
        }
        self.system.put_overlaps(&self.problem);
        for number in self.step.as_flattened_mut() {
            *number *= way;
        }
        self.is_checked = false;
        self.change(simd, f64::INFINITY)
    }
}
