//! Steps of Newton's method, node by node: which loads are free, what is to become zero, and what a
//! step changes.

use super::super::factor::Factor;
use super::super::lanes::{Lanes, Simd, first, first_mut};
use super::System;

impl System {
    /// Frees the loads that are positive or would grow in `free`.
    #[inline(always)]
    pub fn release<S: Simd, const B: usize>(&self, simd: S, free: &mut [Lanes]) {
        let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
        let rows = first_mut::<B, _>(free, self.blocks).iter_mut();
        for ((free, state), gradient) in rows.zip(&self.state).zip(&self.gradient) {
            let gradient = simd.four(gradient);
            let is_loaded = zero.where_less(simd.four(&state.load), one, zero);
            *free = gradient.where_less(zero, one, is_loaded).lanes();
        }
    }

    /// The greatest gradient by a load that is positive.
    #[inline(always)]
    pub fn residual<S: Simd>(&self, simd: S) -> f64 {
        let zero = simd.splat(0.0);
        let mut greatest = zero;
        for (state, gradient) in self.state[..self.blocks].iter().zip(&self.gradient) {
            let gradient = simd.four(gradient).abs();
            greatest = greatest.max(zero.where_less(simd.four(&state.load), gradient, zero));
        }
        greatest.greatest()
    }

    /// Whether a load that is held would grow.
    #[inline(always)]
    pub fn is_pulled<S: Simd, const B: usize>(&self, simd: S, free: &[Lanes]) -> bool {
        let zero = simd.splat(0.0);
        let mut pulled = zero;
        let rows = first::<B, _>(free, self.blocks).iter();
        for (free, gradient) in rows.zip(&self.gradient) {
            let held = simd.splat(1.0) - simd.four(free);
            pulled = pulled.max(simd.four(gradient).where_less(zero, held, zero));
        }
        pulled.greatest() > 0.0
    }

    /// Puts what the step is to make zero into `right`: the gradients by what is free, and loads
    /// that are held times what holds them.
    #[inline(always)]
    pub fn load_up<S: Simd, const B: usize>(&self, simd: S, factor: &Factor, right: &mut [Lanes]) {
        let zero = simd.splat(0.0);
        let (head, right) = right.split_at_mut(factor.first);
        for (head, gradient) in head.as_flattened_mut().iter_mut().zip(self.shape_gradient.iter()) {
            *head = -gradient;
        }
        let right = first_mut::<B, _>(right, self.blocks);
        let (free, shift) = (&factor.free[factor.first..], &factor.shift[factor.first..]);
        for b in 0..right.len() {
            let held = simd.four(&shift[b]) * simd.four(&self.state[b].load);
            let force = simd.four(&free[b]).where_equal(1.0, simd.four(&self.gradient[b]), held);
            right[b] = (zero - force).lanes();
        }
    }

    /// Holds the loads that are free and would become negative with `step`; whether there are any.
    #[inline(always)]
    pub fn hold<S: Simd, const B: usize>(
        &self,
        simd: S,
        step: &[Lanes],
        free: &mut [Lanes],
    ) -> bool {
        let zero = simd.splat(0.0);
        let mut below = zero;
        let rows = first_mut::<B, _>(free, self.blocks).iter_mut();
        for ((free, state), step) in rows.zip(&self.state).zip(step) {
            let new = simd.four(&state.load) + simd.four(step);
            let own = new.where_less(zero, simd.four(free), zero);
            *free = (simd.four(free) - own).lanes();
            below = below.max(own);
        }
        below.greatest() > 0.0
    }

    /// Puts the inverse squares of the widths of the hats into `weights`.
    #[inline(always)]
    pub fn weigh(&self, weights: &mut [Lanes]) {
        for (weights, fixed) in weights.iter_mut().zip(&self.fixed[..self.blocks]) {
            *weights = fixed.inverse_width.map(|inverse| inverse * inverse);
        }
    }

    /// Greatest change of a load over the width of its hat by `step`, and what the energy changes by
    /// to first order.
    #[inline(always)]
    pub fn measure<S: Simd, const B: usize>(&self, simd: S, step: &[Lanes]) -> [f64; 2] {
        let (mut greatest, mut slope) = (simd.splat(0.0), simd.splat(0.0));
        let rows = first::<B, _>(step, self.blocks).iter().zip(&self.fixed).zip(&self.gradient);
        for ((step, fixed), gradient) in rows {
            let step = simd.four(step);
            greatest = greatest.max((step * simd.four(&fixed.inverse_width)).abs());
            slope = slope.add_product(step, simd.four(gradient));
        }
        [greatest.greatest(), slope.sum()]
    }

    /// Adds `part` of `step` to the loads, which do not become negative, and those held by a whole
    /// step become zero; whether a load is lost.
    #[inline(always)]
    pub fn change<S: Simd, const B: usize>(
        &mut self,
        simd: S,
        step: &[Lanes],
        free: &[Lanes],
        part: f64,
    ) -> bool {
        let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
        let mut lost = zero;
        let rows = first_mut::<B, _>(&mut self.state, self.blocks).iter_mut();
        for ((state, step), free) in rows.zip(step).zip(free) {
            let old = simd.four(&state.load);
            let mut new = old.add_product(simd.four(step), simd.splat(part)).max(zero);
            if part >= 1.0 {
                new = new * simd.four(free);
            }
            state.load = new.lanes();
            lost = lost.max(new.where_equal(0.0, zero.where_less(old, one, zero), zero));
        }
        lost.greatest() > 0.0
    }
}
