//! A step of tangential loading without rolling.
//!
//! The bodies are shifted against each other by w; particles slip by s = w + A (p - p_before), and
//! the same friction law holds as in rolling (Kalker 1990, section 4.2.1). A is symmetric and
//! positive definite. It is a [`super::transient`] step over no distance.

use super::friction::Tractions;
use super::grid::Grid;
use super::transient::{Memory, TransientStep};
use crate::material::MaterialPair;

/// Tractions of bodies of `material` after a shift from `before` (traction x, y of each element
/// [Pa]; `None`: none).
///
/// `bound` is μ p_n of each element [Pa], `shift` that of the wheel against the rail in this step
/// [m]; the slip is that of this step [m].
pub fn shift(
    grid: &Grid,
    material: &MaterialPair,
    bound: &[f64],
    shift: [f64; 2],
    before: Option<&[[f64; 2]]>,
) -> Tractions {
    let none = vec![[0.0; 2]; grid.len()];
    let before = before.unwrap_or(&none);
    let mut rigid = vec![shift; grid.len()];
    for (w, carried) in rigid.iter_mut().zip(Memory::new(grid, material, 0.0).carried(before)) {
        *w = [w[0] - carried[0], w[1] - carried[1]];
    }
    TransientStep::new(grid, material, 0.0).solve(bound, &rigid, before)
}
