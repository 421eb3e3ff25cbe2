//! The nodes of a lobe, -1 to 1 between its edges, and what goes with them.

use super::cell::TERMS;
use super::influence::logarithm_corrections;
use super::pair_sums::{LANES, MOST_TARGETS};
use crate::math::quadrature::GaussLegendre;

/// Least nodes of a lobe whose displacement is compared along x without the outer ones, which have 0.7 % of the load then; more than can be
/// targets at once have all compared.
const LEAST_WITHOUT_OUTER: usize = 9;

/// Quadrature and extrapolation on the nodes of a lobe.
#[derive(Clone, Debug)]
pub struct LobeRule {
    /// Nodes t = sin(π s/2) and weights: Gauss-Legendre in s, in which the root at an edge is smooth.
    pub nodes: Vec<f64>,
    /// Weights, with dt/ds in them.
    pub weights: Vec<f64>,
    /// Weights of the polynomial in s through values at the nodes, in its barycentric form.
    pub barycentric: Vec<f64>,
    /// Terms of the shape, as many as the nodes carry.
    pub terms: usize,
    /// See [`logarithm_corrections`]: source by source, whole vectors of targets.
    corrections: Vec<f64>,
    /// Nodes at each end at which the displacement is not compared along x: what little load they have does not matter there.
    pub outer: usize,
    /// What the values of the two outermost nodes are beyond the parabola through the next three: factors of each and of the three.
    pub outer_closures: [[f64; 4]; 2],
    /// Legendre polynomials at the nodes.
    pub legendre: Vec<[f64; TERMS]>,
    /// Roots of the distances of the nodes from the left and the right end.
    pub roots: Vec<[f64; 2]>,
    /// How far a node travels with the left and the right edge.
    pub travel: [Vec<f64>; 2],
}

impl LobeRule {
    /// A rule of `count` ≥ 7 nodes.
    #[must_use]
    pub fn new(count: usize) -> Self {
        let gauss = GaussLegendre::new(count);
        let angle = |s: &f64| std::f64::consts::FRAC_PI_2 * s;
        let rate: Vec<f64> =
            gauss.nodes.iter().map(|s| std::f64::consts::FRAC_PI_2 * angle(s).cos()).collect();
        let t: Vec<f64> = gauss.nodes.iter().map(|s| angle(s).sin()).collect();
        let weights: Vec<f64> = gauss.weights.iter().zip(&rate).map(|(w, r)| w * r).collect();
        let sign = |k: usize| if k.is_multiple_of(2) { 1.0 } else { -1.0 };
        let pairs = gauss.nodes.iter().zip(&gauss.weights).enumerate();
        let barycentric = pairs.map(|(k, (s, w))| sign(k) * ((1.0 - s * s) * w).sqrt()).collect();
        let by_target = logarithm_corrections(&gauss);
        let stride = count.next_multiple_of(LANES);
        let outer = if (LEAST_WITHOUT_OUTER..=MOST_TARGETS).contains(&count) { 2 } else { 0 };
        let mut corrections = vec![0.0; count * stride];
        for target in 0..count {
            let i = node_of_target(target, outer, count);
            for j in 0..count {
                corrections[j * stride + target] = by_target[i * count + j] * rate[j];
            }
        }
        let terms = TERMS.min(count - 3);
        let legendre = t.iter().map(|&t| legendre(t)).collect();
        let roots = t.iter().map(|t| [(1.0 + t).sqrt(), (1.0 - t).sqrt()]).collect();
        let outer_closures = [0, 1].map(|outer| lagrange_closure([t[2], t[3], t[4]], t[outer]));
        let travel = [
            t.iter().map(|t| 0.5 * (1.0 - t)).collect(),
            t.iter().map(|t| 0.5 * (1.0 + t)).collect(),
        ];
        Self {
            terms,
            barycentric,
            corrections,
            outer,
            outer_closures,
            legendre,
            roots,
            travel,
            nodes: t,
            weights,
        }
    }

    /// Number of nodes.
    #[must_use]
    pub fn count(&self) -> usize {
        self.nodes.len()
    }

    /// Node that is target `k` of the sums: from the first inner node on, the outer ones of the left end last.
    #[must_use]
    pub fn node_of_target(&self, k: usize) -> usize {
        node_of_target(k, self.outer, self.count())
    }

    /// Target that node `t` is.
    #[must_use]
    pub fn target_of_node(&self, t: usize) -> usize {
        if t < self.outer { t + self.count() - self.outer } else { t - self.outer }
    }

    /// Corrections for the logarithm with node `k` as source, for each target, and zeros to the end of the last vector.
    #[must_use]
    pub fn corrections_of(&self, k: usize) -> &[f64] {
        let stride = self.count().next_multiple_of(LANES);
        &self.corrections[k * stride..(k + 1) * stride]
    }
}

fn node_of_target(k: usize, outer: usize, count: usize) -> usize {
    if k + outer < count { k + outer } else { k + outer - count }
}

/// Factors of the values at `to` and at three nodes in what the first is beyond the parabola through the three.
fn lagrange_closure(nodes: [f64; 3], to: f64) -> [f64; 4] {
    let factor = |k: usize| -> f64 {
        let others = (0..3).filter(|&l| l != k);
        others.map(|l| (to - nodes[l]) / (nodes[k] - nodes[l])).product()
    };
    [1.0, -factor(0), -factor(1), -factor(2)]
}

/// Legendre polynomials at `t`, as many as a lobe has shape terms.
pub fn legendre(t: f64) -> [f64; TERMS] {
    [1.0, t, 1.5 * t * t - 0.5, (2.5 * t * t - 1.5) * t]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn targets_are_all_nodes_with_the_inner_ones_first() {
        for count in [7, 8, 9, 11, 32, 33, 40] {
            let rule = LobeRule::new(count);
            for k in 0..count {
                assert_eq!(rule.target_of_node(rule.node_of_target(k)), k);
            }
            let inner = |k| (rule.outer..count - rule.outer).contains(&rule.node_of_target(k));
            assert!((0..count - 2 * rule.outer).all(inner));
        }
    }

    #[test]
    fn parabolas_close_free_ends() {
        let rule = LobeRule::new(12);
        let f = |t: f64| 1.0 + t * (0.5 - 2.0 * t);
        let at = |k: usize| f(rule.nodes[k]);
        for (closure, nodes) in rule.outer_closures.iter().zip([[0, 2, 3, 4], [1, 2, 3, 4]]) {
            let free: f64 = closure.iter().zip(nodes).map(|(c, k)| c * at(k)).sum();
            approx::assert_abs_diff_eq!(free, 0.0, epsilon = 1e-14);
        }
    }
}
