//! A step of tangential loading without rolling.
//!
//! The bodies are shifted against each other by w; particles slip by s = w + A (p - p_before), and
//! the same friction law holds as in rolling (Kalker 1990, section 4.2.1). A is symmetric and
//! positive definite.

use super::friction::{self, FrictionProblem, TOLERANCE, Tractions};
use super::grid::Grid;
use super::influence::TangentialInfluence;
use crate::material::MaterialPair;

/// Tractions of bodies of `material` after a shift from `before` (traction x, y of each element
/// [Pa]; `None`: none).
///
/// `bound` is μ p_n of each element [Pa], `shift` that of the wheel against the rail in this step
/// [m]; the slip is that of this step [m].
#[must_use]
pub fn shift(
    grid: &Grid,
    material: &MaterialPair,
    bound: &[f64],
    shift: [f64; 2],
    before: Option<&[[f64; 2]]>,
) -> Tractions {
    let influence = TangentialInfluence::displacement(grid, material);
    let mut rigid = vec![shift; grid.len()];
    if let Some(before) = before {
        let column = |c: usize| before.iter().map(|p| p[c]).collect::<Vec<f64>>();
        let (x, y) = (column(0), column(1));
        let mut convolution = super::convolution::Convolution::new(grid.along, grid.across);
        let [xx, xy, yy] = [&influence.xx, &influence.xy, &influence.yy]
            .map(|influence| convolution.spectrum_of(influence));
        let mut displaced = vec![0.0; grid.len()];
        for (spectrum, tractions, c) in [(&xx, &x, 0), (&xy, &y, 0), (&xy, &x, 1), (&yy, &y, 1)] {
            convolution.apply(spectrum, tractions, &mut displaced);
            for (w, u) in rigid.iter_mut().zip(&displaced) {
                w[c] -= u;
            }
        }
    }
    let problem = FrictionProblem {
        grid,
        influence: &influence,
        bound,
        rigid: &rigid,
        rolling: false,
        tolerance: SETTLED * TOLERANCE,
    };
    friction::solve(&problem, before)
}

/// Without particles that carry news along, changes are passed on from element to element and
/// shrink slowly: a finer tolerance.
const SETTLED: f64 = 1e-2;
