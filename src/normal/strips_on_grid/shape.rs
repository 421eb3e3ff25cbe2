//! The logarithm of pressure over half length, χ = ln c, as a field over the nodes.
//!
//! It is constant on an ellipse and varies over lengths of the order of the half length, so that a
//! few numbers do: it is linear in the number of the node between knots.

use crate::math::real::Real;

/// Nodes for each knot, of which a field has some more besides; but two nodes for each at least, or
/// the drops of few nodes do not tell them apart.
const NODES_PER_KNOT: f64 = 3.5;
const MORE_KNOTS: usize = 2;
const MIN_NODES_PER_KNOT: usize = 2;
/// Weights of squared second and first differences of the field between knots against squared
/// relative errors of the drop of the displacement, weighted by the share of load: they matter
/// where there is no load, and extend the field there.
const PENALTIES: [f64; 2] = [1e-3, 1e-4];

/// Knots over a number of nodes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Knots {
    nodes: usize,
    count: usize,
}

/// The first of the two knots of a node, and the share of the second.
#[derive(Clone, Copy, Debug)]
pub(super) struct Between<T = f64> {
    pub first: usize,
    pub share: T,
}

impl<T: Real> Between<T> {
    /// Knots and their weights.
    pub fn weights(&self) -> [(usize, T); 2] {
        [(self.first, T::from(1.0) - self.share), (self.first + 1, self.share)]
    }

    /// The field with the values `at` the knots.
    pub fn value(&self, at: &[T]) -> T {
        self.weights().iter().map(|&(k, share)| at[k] * share).sum()
    }
}

impl Knots {
    /// Knots for `nodes` nodes.
    pub fn new(nodes: usize) -> Self {
        let wanted = MORE_KNOTS + (nodes as f64 / NODES_PER_KNOT) as usize;
        Self { nodes, count: wanted.min(nodes / MIN_NODES_PER_KNOT) }
    }

    /// Number of knots.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.nodes
    }

    /// Where node number `number`, from 1 on, is; beyond the first and the last one the field is as
    /// there.
    pub fn between<T: Real>(&self, number: T) -> Between<T> {
        let last = self.count - 1;
        let rate = last as f64 / (self.nodes - 1) as f64;
        let at = ((number - 1.0) * rate).at_least(0.0).at_most(last as f64);
        let first = (at.value() as usize).min(last - 1);
        Between { first, share: at - first as f64 }
    }

    /// Second derivatives of the penalty by the values at knots `k` and `l`, halved.
    pub fn penalty(&self, k: usize, l: usize) -> f64 {
        const DIFFERENCES: [&[f64]; 2] = [&[1.0, -2.0, 1.0], &[1.0, -1.0]];
        let mut sum = 0.0;
        for (difference, weight) in DIFFERENCES.into_iter().zip(PENALTIES) {
            for first in 0..=self.count - difference.len() {
                let of = |knot: usize| {
                    knot.checked_sub(first).and_then(|i| difference.get(i)).copied().unwrap_or(0.0)
                };
                sum += weight * of(k) * of(l);
            }
        }
        sum
    }
}
