//! Tractions of steady rolling with Coulomb friction.
//!
//! A particle that is at x now was at x + h a moment before: the surface of the wheel slips against
//! that of the rail, over the rolling speed, by (Kalker 1990, section 4.2.2, in the steady state)
//!
//! ```text
//! s = w - ∂u/∂x          w: rigid slip, w_x = ξ - φ y, w_y = η + φ x
//! |p| ≤ g = μ p_n;   s = 0 where |p| < g;   s = -λ p, λ ≥ 0, where |p| = g
//! ```
//!
//! Kalker takes the difference u(x) - u(x + h) with h of about an element, which is of first order
//! in h. Here it is that of second order over half elements, (3 u(x) - 4 u(x + h) + u(x + 2 h))/2h,
//! h = dx/2: on 22x22 elements it is twice as close to its own limit. In both the particle's past
//! alone counts, and the operator stays monotone: its symbol has the real part Â(k) (1 - cos k h)
//! or Â(k) (1 - cos k h)², so that there is one solution for every creepage.
//!
//! The tractions come from [`super::friction`]; starts come from grids of half the resolution.

use super::friction::{self, FrictionProblem, MAX_SWEEPS, TOLERANCE, Tractions};
use super::grid::Grid;
use super::influence::TangentialInfluence;
use crate::material::MaterialPair;

/// Elements along and across from which on a coarser grid is solved first.
const MIN_NESTED_ELEMENTS: usize = 24;

/// Tractions of bodies of `material` that roll towards +x.
///
/// `bound` is μ p_n of each element [Pa], `rigid` its rigid slip over the rolling speed, wheel
/// minus rail [-]; the slip of the result is over the rolling speed, too.
pub fn steady_rolling(
    grid: &Grid,
    material: &MaterialPair,
    bound: &[f64],
    rigid: &[[f64; 2]],
) -> Tractions {
    steady_rolling_within(TOLERANCE, grid, material, bound, rigid)
}

/// The same within another change of the last sweep, over the sum of the tractions [-].
pub fn steady_rolling_within(
    tolerance: f64,
    grid: &Grid,
    material: &MaterialPair,
    bound: &[f64],
    rigid: &[[f64; 2]],
) -> Tractions {
    let start = (grid.along >= MIN_NESTED_ELEMENTS && grid.across >= MIN_NESTED_ELEMENTS)
        .then(|| Coarse::of(grid, bound, rigid))
        .map(|coarse| {
            let tractions = steady_rolling(&coarse.grid, material, &coarse.bound, &coarse.rigid);
            coarse.prolong(&tractions, grid, bound)
        });
    let influence = TangentialInfluence::rolling_slip(grid, material);
    let problem = FrictionProblem {
        grid,
        influence: &influence,
        bound,
        rigid,
        rolling: true,
        tolerance,
        max_sweeps: MAX_SWEEPS,
    };
    friction::solve(&problem, start.as_deref())
}

/// The problem on elements of twice the size.
struct Coarse {
    grid: Grid,
    bound: Vec<f64>,
    rigid: Vec<[f64; 2]>,
}

impl Coarse {
    fn of(fine: &Grid, bound: &[f64], rigid: &[[f64; 2]]) -> Self {
        let grid = Grid {
            along: fine.along.div_ceil(2),
            across: fine.across.div_ceil(2),
            dx: 2.0 * fine.dx,
            dy: 2.0 * fine.dy,
            leading_x: fine.leading_x - 0.5 * fine.dx,
            left_y: fine.left_y + 0.5 * fine.dy,
        };
        let mut coarse =
            Self { grid, bound: vec![0.0; grid.len()], rigid: vec![[0.0; 2]; grid.len()] };
        let mut children = vec![0.0; grid.len()];
        for k in 0..fine.len() {
            let at = k / fine.along / 2 * grid.along + k % fine.along / 2;
            coarse.bound[at] += 0.25 * bound[k];
            children[at] += 1.0;
            let [x, y] = &mut coarse.rigid[at];
            *x += rigid[k][0];
            *y += rigid[k][1];
        }
        for (rigid, children) in coarse.rigid.iter_mut().zip(children) {
            *rigid = rigid.map(|w| w / children);
        }
        coarse
    }

    /// The share of the bound that is used up, interpolated between the elements in contact.
    fn prolong(&self, tractions: &Tractions, fine: &Grid, bound: &[f64]) -> Vec<[f64; 2]> {
        let neighbours = |n: usize, count: usize| {
            let own = n / 2;
            let other = if n.is_multiple_of(2) { own.checked_sub(1) } else { Some(own + 1) };
            [(Some(own), 0.75), (other.filter(|&m| m < count), 0.25)]
        };
        let mut start = vec![[0.0; 2]; fine.len()];
        for (k, p) in start.iter_mut().enumerate().filter(|&(k, _)| bound[k] > 0.0) {
            let mut share = [0.0; 3];
            for (i, weight_i) in neighbours(k % fine.along, self.grid.along) {
                for (j, weight_j) in neighbours(k / fine.along, self.grid.across) {
                    let Some((i, j)) = i.zip(j) else { continue };
                    let at = j * self.grid.along + i;
                    if self.bound[at] > 0.0 {
                        let weight = weight_i * weight_j;
                        share[0] += weight * tractions.x[at] / self.bound[at];
                        share[1] += weight * tractions.y[at] / self.bound[at];
                        share[2] += weight;
                    }
                }
            }
            if share[2] > 0.0 {
                *p = [share[0], share[1]].map(|s| bound[k] * s / share[2]);
            }
        }
        start
    }
}
