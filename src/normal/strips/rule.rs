//! The nodes of a lobe, -1 to 1 between its edges, and what goes with them.

use super::cell::TERMS;
use super::influence::logarithm_corrections;
use super::pair_sums::LANES;
use crate::math::quadrature::GaussLegendre;

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
        let mut corrections = vec![0.0; count * stride];
        for i in 0..count {
            for j in 0..count {
                corrections[j * stride + i] = by_target[i * count + j] * rate[j];
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

    /// Corrections for the logarithm with node `k` as source, for each target, and zeros to the end of the last vector.
    #[must_use]
    pub fn corrections_of(&self, k: usize) -> &[f64] {
        let stride = self.count().next_multiple_of(LANES);
        &self.corrections[k * stride..(k + 1) * stride]
    }
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
