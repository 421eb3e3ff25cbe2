//! Steps with the factor of the last one.

use super::super::kernel::Table;
use super::super::lanes::{FEW, LANES, Lanes, Simd, by_blocks, first, first_mut};
use super::{Change, LAST_ERROR, MIN_GAIN, MOST_SHORT, Newton, SHAPE_WEIGHT};

impl Newton {
    /// Steps with the factor of the last one, which changed by `before`; whether they came to an
    /// end. Each of them leaves about the share `gain` of what it changes. What the steps have told
    /// of the equations since is taken up as in Broyden's method.
    #[inline(always)]
    pub(super) fn short_steps<S: Simd>(
        &mut self,
        simd: S,
        table: &Table,
        before: Change,
        gain: f64,
    ) -> bool {
        let mut last = before.greatest;
        let rows = self.factor.first + self.system.blocks;
        self.past[0][..rows].copy_from_slice(&self.step[..rows]);
        let (shape, loads) = self.metric.split_at_mut(self.factor.first);
        shape.fill([SHAPE_WEIGHT * SHAPE_WEIGHT; LANES]);
        self.system.weigh(loads);
        for k in 1..=MOST_SHORT {
            self.short_steps += 1;
            self.system.differentiate::<S, false>(simd, table, &self.problem);
            let Self { system, factor, step, .. } = self;
            let (first, blocks) = (factor.first, system.blocks);
            let free = &factor.free[first..];
            if by_blocks!(blocks => B, system.is_pulled::<S, B>(simd, free)) {
                return false;
            }
            self.residual = system.residual(simd) / self.problem.scales.depth;
            by_blocks!(blocks => B, system.load_up::<S, B>(simd, factor, step));
            simd.apart(
                #[inline(always)]
                || factor.solve(simd, step),
            );
            by_blocks!(first + blocks => B, self.recall::<S, B>(simd, k));
            let most = MIN_GAIN * last;
            let change = self.change(simd, most);
            if change.is_rough || change.greatest > most {
                return false;
            }
            if change.greatest * gain < LAST_ERROR {
                return true;
            }
            last = change.greatest;
        }
        false
    }

    /// Corrects the step by the `count` ones before it with the same factor: where they would have
    /// gone on in one direction, it goes all the way.
    #[inline(always)]
    fn recall<S: Simd, const B: usize>(&mut self, simd: S, count: usize) {
        let rows = self.factor.first + self.system.blocks;
        let metric = first::<B, _>(&self.metric, rows);
        let step = first_mut::<B, _>(&mut self.step, rows);
        let product = |a: &[Lanes], b: &[Lanes]| {
            let mut sum = simd.splat(0.0);
            for ((a, b), metric) in a.iter().zip(b).zip(metric) {
                sum = sum.add_product(simd.four(a) * simd.four(metric), simd.four(b));
            }
            sum.sum()
        };
        for k in 1..=count {
            let past = first::<B, _>(&self.past[k - 1], rows);
            let share = product(past, step) / product(past, past);
            if k == count {
                let scale = 1.0 / (1.0 - share);
                for step in step.iter_mut() {
                    *step = (simd.four(step) * scale).lanes();
                }
            } else {
                let next = first::<B, _>(&self.past[k], rows);
                for (step, next) in step.iter_mut().zip(next) {
                    let all = simd.four(step).add_product(simd.splat(share), simd.four(next));
                    *step = all.lanes();
                }
            }
        }
        first_mut::<B, _>(&mut self.past[count], rows).copy_from_slice(step);
    }
}
