//! Gauss-Legendre quadrature.

/// Nodes on (-1, 1), growing, and weights that sum to two.
#[derive(Clone, Debug)]
pub struct GaussLegendre {
    /// Nodes.
    pub nodes: Vec<f64>,
    /// Weights.
    pub weights: Vec<f64>,
}

impl GaussLegendre {
    /// The rule of `count` ≥ 1 points, exact for polynomials of degree 2 count - 1.
    pub fn new(count: usize) -> Self {
        let n = count as f64;
        let (mut nodes, mut weights) = (vec![0.0; count], vec![0.0; count]);
        for i in 0..count {
            // Start of Tricomi, then Newton on the Legendre polynomial.
            let mut x = -((i as f64 + 0.75) * std::f64::consts::PI / (n + 0.5)).cos();
            let mut slope = 1.0;
            for _ in 0..10 {
                let (mut below, mut value) = (1.0, x);
                for k in 2..=count {
                    let k = k as f64;
                    (below, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * below) / k);
                }
                slope = n * (below - x * value) / (1.0 - x * x);
                x -= value / slope;
            }
            nodes[i] = x;
            weights[i] = 2.0 / ((1.0 - x * x) * slope * slope);
        }
        Self { nodes, weights }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_up_to_the_stated_degree_are_exact() {
        for count in [1, 2, 5, 30, 101] {
            let rule = GaussLegendre::new(count);
            let degree = (2 * count - 2) as i32;
            let sum: f64 =
                rule.nodes.iter().zip(&rule.weights).map(|(x, w)| w * x.powi(degree)).sum();
            approx::assert_relative_eq!(sum, 2.0 / f64::from(degree + 1), max_relative = 1e-12);
        }
    }
}
