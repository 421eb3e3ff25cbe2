//! Valleys of the overlap, and how much of a node stands in each.
//!
//! Where two intervals of overlap join, a node stays between them. It fades as the valley fills up or becomes one with a peak beside it, so
//! that nodes do not jump.

use crate::math::real::Real;

/// Most valleys of one rail; further ones have no node.
pub(super) const MOST_VALLEYS: usize = 64;
/// Overlap in a valley over that at the edge of an ellipse at which half a node is left for it: hardly loaded, with other nodes near by.
const SHALLOW: f64 = 0.6;

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
    /// Takes how many nodes stand in it, `edge` being the overlap at the edge of an ellipse [m]: one where two intervals have just joined, the less the more the valley
    /// is filled, and next to nothing before it ceases.
    pub fn stand(&mut self, edge: T) {
        let edge = edge * SHALLOW;
        // A valley that has just come has no rise.
        let rise = ((self.peak - self.overlap) / edge).at_least(0.0);
        let filled = (self.overlap / edge).at_least(0.0) * (rise + 1.0);
        let [rise, filled] = [rise, filled].map(|share| share.powi(8));
        let sum = rise + filled;
        self.standing = if sum.value() > 0.0 { rise / sum } else { rise };
    }
}
