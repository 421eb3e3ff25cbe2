//! The nodes that are taken: others neither act nor are acted on.

use super::super::kernel::Table;
use super::super::lanes::{LANES, Simd};
use super::Newton;

impl Newton {
    /// Takes the nodes where the overlap is greatest around as extra ones.
    #[inline(always)]
    pub(super) fn mark_tops(&mut self) {
        let Self { problem, extra, .. } = self;
        let overlap = |i: usize| problem.points.get(i).map_or(0.0, |point| point.overlap);
        extra.clear();
        extra.extend(
            (0..problem.len()).map(|i| overlap(i) > overlap(i.wrapping_sub(1)).max(overlap(i + 1))),
        );
    }

    /// Takes the nodes that are loaded, those beside them that would be, and the extra ones; none
    /// anew if those that are there will do.
    #[inline(always)]
    pub(super) fn choose_nodes<S: Simd>(&mut self, simd: S, table: &Table) {
        let Self { problem, system, load, extra, wanted, .. } = self;
        let is_first = system.nodes.is_empty();
        if !is_first {
            system.put_loads(load);
            system.stretch(simd, problem);
        }
        let is_loaded = |i: usize| load.get(i).is_some_and(|&load| load > 0.0);
        wanted.clear();
        let mut place = 0;
        for i in 0..load.len() {
            let is_taken = system.nodes.get(place) == Some(&i);
            place += usize::from(is_taken);
            let is_beside = !is_first && (is_loaded(i + 1) || is_loaded(i.wrapping_sub(1)));
            let mut grows = || {
                let by_load = if is_taken {
                    system.gradient(place - 1)
                } else {
                    system.pull(simd, table, problem, i)
                };
                by_load < 0.0
            };
            if extra[i] || is_loaded(i) || is_beside && grows() {
                wanted.push(i);
            }
        }
        let nodes = &mut system.nodes;
        let mut taken = nodes.iter();
        let will_do = wanted.iter().all(|i| taken.any(|taken| taken == i));
        if !will_do || nodes.len().div_ceil(LANES) > wanted.len().div_ceil(LANES) {
            nodes.clear();
            nodes.extend_from_slice(wanted);
            simd.apart(
                #[inline(always)]
                || system.take(simd, problem, load),
            );
        }
    }

    /// Whether no node that is left out would be loaded; those that would are taken from now on.
    #[inline(always)]
    pub(super) fn is_complete<S: Simd>(&mut self, simd: S, table: &Table) -> bool {
        let Self { system, problem, load, extra, .. } = self;
        let mut is_complete = true;
        let mut next = 0;
        for i in 0..load.len() {
            if system.nodes.get(next) == Some(&i) {
                next += 1;
            } else if system.pull(simd, table, problem, i) < 0.0 {
                (extra[i], is_complete) = (true, false);
            }
        }
        is_complete
    }
}
