//! Lobes of the overlap: how deep each is by itself or with its neighbours, and how much of a node stands between them.
//!
//! Both are continuous where lobes join, fill up and become one, so that the nodes laid by them do not jump.

use super::line::OverlapLine;
use super::overlap::{Lobe, Turn};
use super::samples::DEPTH_OVER_MEAN;
use crate::math::real::Real;

/// Overlap in a valley over that at the edge of an ellipse at which half a node is left for it: hardly loaded, with other nodes near by.
const SHALLOW_VALLEY: f64 = 0.6;
/// Distance from a valley at which its place is seen to move, over that of samples: near enough for a parabola, and far above rounding.
const NEAR_VALLEY: f64 = 1e-3;

/// A lobe as nodes are laid by it.
#[derive(Clone, Copy, Debug)]
pub(super) struct LobeSize<T> {
    /// Number of its interval of overlap.
    pub interval: usize,
    /// Integrals of the square and the cube of the overlap [m^3, m^4].
    sums: [T; 2],
    /// Overlap at its peak and in the valley behind it, none where there is none [m].
    peak: T,
    valley: T,
    /// Coordinate across of that valley [m].
    pub behind: Option<T>,
    /// Depth of the parabola of these integrals, together with those of lobes that it has grown together with [m].
    pub depth: T,
    /// How much of a node stands in that valley.
    pub standing: T,
}

impl<T: Real> LobeSize<T> {
    /// Of a `lobe` of `line`, with samples at the distance `spacing` [m].
    pub fn new(lobe: &Lobe, line: &mut impl OverlapLine<T>, spacing: T) -> Self {
        let zero = T::from(0.0);
        let behind = lobe.valley.map(|valley| valley.moving(line, spacing.value() * NEAR_VALLEY));
        let valley = behind.zip(lobe.valley).map_or(zero, |(y, turn)| line.at(y, turn.u).overlap);
        Self {
            interval: lobe.interval,
            sums: [zero; 2],
            peak: line.at(T::from(lobe.peak.y), lobe.peak.u).overlap,
            valley,
            behind,
            depth: zero,
            standing: zero,
        }
    }

    /// Adds a `share` of the integrals `sums`.
    pub fn add(&mut self, sums: [T; 2], share: T) {
        for (own, sum) in self.sums.iter_mut().zip(sums) {
            *own += sum * share;
        }
    }

    /// Its integrals with those of an `other` lobe, the least overlap on the way to which is `least`: all of these where both are one, nothing where they part; in between
    /// a greater one counts as much as the own one, or it would come in by a jump. A valley is seen when it has some depth already: at first nothing is parted by it.
    fn with(&self, sums: [T; 2], other: &Self, least: T) -> [T; 2] {
        let grown = (least / self.peak.min(other.peak)).at_least(0.0).at_most(1.0);
        if grown <= 0.0 {
            return sums;
        }
        let apart = (-grown + 1.0) * (-grown + 1.0) * other.sums[0]
            / self.sums[0].at_least(f64::MIN_POSITIVE);
        let share = grown / (grown + apart);
        [0, 1].map(|n| sums[n] + other.sums[n] * share)
    }
}

impl Turn {
    /// Coordinate across as it moves with `line`, by the vertex of a parabola through places `near` by [m].
    fn moving<T: Real>(&self, line: &mut impl OverlapLine<T>, near: f64) -> T {
        if !T::HAS_SLOPES {
            return T::from(self.y);
        }
        let [before, here, behind] =
            [-near, 0.0, near].map(|way| line.at(T::from(self.y + way), self.u).overlap);
        let bend = (behind - here * 2.0 + before) / (near * near);
        let slope = (behind - before) / (2.0 * near);
        if bend.value() > 0.0 { T::moving(self.y, -(slope / bend)) } else { T::from(self.y) }
    }
}

/// Takes the depths of all `lobes` from their integrals.
pub(super) fn grow_together<T: Real>(lobes: &mut [LobeSize<T>]) {
    for i in 0..lobes.len() {
        let own = lobes[i];
        let mut sums = own.sums;
        let mut least = own.peak;
        for pair in lobes[i..].windows(2).take_while(|pair| pair[1].interval == own.interval) {
            least = least.min(pair[0].valley);
            sums = own.with(sums, &pair[1], least);
        }
        let mut least = own.peak;
        let before = lobes[..=i].windows(2).rev();
        for pair in before.take_while(|pair| pair[0].interval == own.interval) {
            least = least.min(pair[0].valley);
            sums = own.with(sums, &pair[0], least);
        }
        // A lobe may have nothing but rounding.
        let mean = sums[1] / sums[0].at_least(f64::MIN_POSITIVE);
        lobes[i].depth = (mean * DEPTH_OVER_MEAN).at_least(f64::MIN_POSITIVE);
    }
}

/// Takes how much of a node stands in the valleys, the `level` being the overlap at the edge of an ellipse over its depth: all of one where two intervals have just
/// joined, the less the more the valley is filled, and next to nothing before it ceases or is too small to be seen.
pub(super) fn stand_between<T: Real>(lobes: &mut [LobeSize<T>], level: T) {
    for i in 1..lobes.len() {
        let [own, next] = [lobes[i - 1], lobes[i]];
        if own.interval == next.interval {
            let rise = own.peak.min(next.peak) - own.valley;
            let edge = level * SHALLOW_VALLEY * own.depth.min(next.depth);
            let filled = own.valley / edge + own.valley / rise;
            let square = filled * filled;
            let fourth = square * square;
            lobes[i - 1].standing = T::from(1.0) / (fourth * fourth + 1.0);
        }
    }
}
