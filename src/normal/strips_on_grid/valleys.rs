//! Valleys of the overlap, and the share of a node in each.
//!
//! Where two intervals of overlap join, a node stays between them. It fades as the valley fills up
//! or becomes one with a peak beside it, so that nodes do not jump.

use crate::math::real::Real;

/// Most valleys of one rail; further ones have no node.
pub(super) const MAX_VALLEYS: usize = 64;
/// Overlap in a valley over that at the edge of an ellipse at which half a node is left for it:
/// hardly loaded, with other nodes near by.
const SHALLOW: f64 = 0.6;
/// How much a valley is filled at which nothing is left of its node; its eighth power is still a
/// number.
const FILLED: f64 = 1e30;

/// A place of least overlap between two peaks of one interval.
#[derive(Clone, Copy, Debug)]
pub(super) struct Valley<T> {
    /// Number of the interval.
    pub interval: usize,
    /// Coordinate across [m].
    pub y: T,
    /// Overlap there, and at the lower one of the peaks beside it [m].
    pub overlap: T,
    pub peak: T,
    /// Nodes that stand in it.
    pub standing: T,
}

impl<T: Real> Valley<T> {
    /// Takes how many nodes stand in it, `edge` being the overlap at the edge of an ellipse [m]:
    /// one where two intervals have just joined, the less the more the valley is filled, and next
    /// to nothing before it ceases.
    pub fn stand(&mut self, edge: T) {
        let rise = self.peak - self.overlap;
        // A valley that has just come has no rise.
        self.standing = if rise.value() > 0.0 {
            let edge = (edge * SHALLOW).at_least(f64::MIN_POSITIVE);
            let overlap = self.overlap.at_least(0.0);
            let filled = (overlap / edge + overlap / rise).at_most(FILLED);
            T::from(1.0) / (filled.powi(8) + 1.0)
        } else {
            T::from(0.0)
        };
    }
}
