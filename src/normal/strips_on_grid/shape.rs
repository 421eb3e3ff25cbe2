//! The logarithm of pressure over half length, χ = ln c, as a field over the nodes.
//!
//! It is constant on an ellipse and varies over lengths of the order of the half length, so that a few numbers do: it is linear in the number of
//! the node between knots.

use crate::math::real::Real;

/// Nodes for each knot, of which a field has some more besides; but two nodes for each at least, or the falls of few nodes do not tell them apart.
const NODES_PER_KNOT: f64 = 3.5;
const MORE_KNOTS: usize = 2;
const LEAST_NODES_PER_KNOT: usize = 2;
/// Weights of squared second and first differences of the field between knots against squared relative errors of the fall of the displacement, weighted by the
/// share of load: they matter where there is no load, and extend the field there.
const PENALTIES: [f64; 2] = [1e-3, 1e-4];

/// Knots over a number of nodes.
#[derive(Clone, Debug)]
pub(super) struct Knots {
    /// The first of the two knots of each node, and the share of the second.
    places: Vec<(usize, f64)>,
    count: usize,
}

impl Knots {
    /// Knots for `nodes` nodes.
    pub fn new(nodes: usize) -> Self {
        let wanted = MORE_KNOTS + (nodes as f64 / NODES_PER_KNOT) as usize;
        let count = wanted.min(nodes / LEAST_NODES_PER_KNOT);
        let place = |i: usize| {
            let at = (i * (count - 1)) as f64 / (nodes - 1) as f64;
            let first = (at as usize).min(count - 2);
            (first, at - first as f64)
        };
        Self { places: (0..nodes).map(place).collect(), count }
    }

    /// Number of knots.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.places.len()
    }

    /// The field with the values `at` the knots, at node `i`.
    pub fn value<T: Real>(&self, i: usize, at: &[T]) -> T {
        self.of(i).iter().map(|&(k, share)| at[k] * share).sum()
    }

    /// Knots and weights of node `i`.
    pub fn of(&self, i: usize) -> [(usize, f64); 2] {
        let (first, share) = self.places[i];
        [(first, 1.0 - share), (first + 1, share)]
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
