//! Tractions bounded by friction: block Gauss-Seidel for s = w + B p.
//!
//! Find on every element in contact |p| ≤ g with s = 0 where |p| < g, and s = -λ p, λ ≥ 0,
//! where |p| = g; w is the rigid slip, B what the tractions add to it. Where the symmetric part of
//! B is positive definite this is a strongly monotone variational inequality and has one solution
//! for every w.
//!
//! Elements are visited row by row from the leading edge. One that sticks changes its traction
//! together with those of all sticking elements behind it, up to the next that slips: in rolling,
//! that is what the particles carry with them. One that slips turns its traction alone. Both steps
//! are shortened by a damping, which grows when the sweeps do not settle.

use super::grid::Grid;
use super::influence::TangentialInfluence;
use super::received::{Received, TractionRows};
use crate::math::real::Real;

/// Tractions on the wheel and slip of the wheel against the rail on all elements of a grid.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tractions {
    /// Longitudinal traction [Pa].
    pub x: Vec<f64>,
    /// Lateral traction [Pa].
    pub y: Vec<f64>,
    /// Longitudinal slip, in the unit of the rigid slip.
    pub slip_x: Vec<f64>,
    /// Lateral slip, in the unit of the rigid slip.
    pub slip_y: Vec<f64>,
    /// Elements that slip.
    pub slips: Vec<bool>,
    /// Sweeps through all elements.
    pub sweeps: usize,
    /// Change of the tractions in the last sweep, as a share of their sum [-].
    pub change: f64,
    /// Whether that is within the tolerance.
    pub converged: bool,
    /// Largest slip that contradicts the friction law, over the largest rigid slip [-]: all slip
    /// where an element adheres, what is not opposite to the traction where it slips.
    pub residual: f64,
}

impl Tractions {
    /// The same seen in a mirror across x.
    pub fn mirrored(&self, grid: &Grid) -> Self {
        let seen = |field: &[f64], sign: f64| {
            grid.mirrored(field).iter().map(|value| sign * value).collect()
        };
        Self {
            x: seen(&self.x, -1.0),
            y: seen(&self.y, 1.0),
            slip_x: seen(&self.slip_x, -1.0),
            slip_y: seen(&self.slip_y, 1.0),
            slips: grid.mirrored(&self.slips),
            ..*self
        }
    }
}

/// Change in a sweep, over the sum of the tractions, at which they are accepted [-].
pub const TOLERANCE: f64 = 1e-4;

/// Sweeps after which the search ends in steady rolling: 10 to 30 are usual.
pub const MAX_SWEEPS: usize = 400;

/// Sweeps without a new least change after which the damping grows, and by how much.
const PATIENCE: usize = 8;
const MORE_DAMPING: f64 = 1.6;

/// What is given: bounds g, rigid slip, and how tractions act.
pub struct FrictionProblem<'a> {
    /// The elements.
    pub grid: &'a Grid,
    /// What a traction adds to the slip.
    pub influence: &'a TangentialInfluence,
    /// Greatest traction of each element, μ p_n ≥ 0; elements with 0 are not in contact [Pa].
    pub bound: &'a [f64],
    /// Rigid slip of each element.
    pub rigid: &'a [[f64; 2]],
    /// Whether particles carry their traction along the rows: steady rolling.
    pub rolling: bool,
    /// Change in a sweep, over the sum of the tractions, at which to stop [-].
    pub tolerance: f64,
    /// Sweeps after which to stop in any case.
    pub max_sweeps: usize,
}

/// Solves `problem` from the tractions `start` (x, y) of each element.
pub fn solve(problem: &FrictionProblem<'_>, start: Option<&[[f64; 2]]>) -> Tractions {
    let FrictionProblem { grid, influence, bound, rigid, .. } = *problem;
    let mut rows = TractionRows::new(grid, bound);
    let stride = rows.stride;
    let mut sticks = vec![false; rows.x.len()];
    if let Some(start) = start {
        for (k, p) in start.iter().enumerate().filter(|&(k, _)| bound[k] > 0.0) {
            let at = k / grid.along * stride + k % grid.along;
            [rows.x[at], rows.y[at]] = *p;
            sticks[at] = p[0].hypotenuse(p[1]) < STICKING * bound[k];
        }
    }
    let mut received = Received::new(influence, &rows);
    let carried = carried_influence(influence, grid.along);
    let mut damping = if problem.rolling { ROLLING_DAMPING } else { LOCAL_DAMPING };
    let loaded = bound.iter().any(|&g| g > 0.0);
    let loaded_rows: Vec<bool> = (0..grid.across).map(|j| rows.is_loaded(j)).collect();
    let (mut sweeps, mut change, mut least, mut stale) = (0, f64::INFINITY, f64::INFINITY, 0);
    while loaded && change > problem.tolerance && sweeps < problem.max_sweeps {
        sweeps += 1;
        let (mut moved, mut total) = (0.0, 0.0);
        for j in (0..grid.across).filter(|&j| loaded_rows[j]) {
            received.begin_row(j, &rows);
            let mut end = 0;
            for i in 0..grid.along {
                let k = j * grid.along + i;
                let g = bound[k];
                if g <= 0.0 {
                    continue;
                }
                let at = j * stride + i;
                let own = received.at(i, j, &rows);
                let s = [rigid[k][0] + own[0], rigid[k][1] + own[1]];
                end = end.max(i + 1);
                while problem.rolling && sticks[j * stride + end] {
                    end += 1;
                }
                let p = [rows.x[at], rows.y[at]];
                let stiffness = carried[end - i - 1].map(|c| damping * c);
                let step = [-s[0] / stiffness[0], -s[1] / stiffness[1]];
                let trial = [p[0] + step[0], p[1] + step[1]];
                let step = if trial[0] * trial[0] + trial[1] * trial[1] <= g * g {
                    sticks[at] = true;
                    for m in at..at + end - i {
                        rows.x[m] += step[0];
                        rows.y[m] += step[1];
                    }
                    step
                } else {
                    sticks[at] = false;
                    end = i + 1;
                    let stiffness =
                        if problem.rolling { carried[grid.along - 1] } else { carried[0] };
                    let turned = at_the_bound(p, s, stiffness.map(|c| damping * c), g);
                    [rows.x[at], rows.y[at]] = turned;
                    [turned[0] - p[0], turned[1] - p[1]]
                };
                moved += step[0].abs().max(step[1].abs());
                total += rows.x[at].abs().max(rows.y[at].abs());
            }
            received.renew(j, &rows);
        }
        // Nothing moves without slip.
        change = if total > 0.0 { moved / total } else { 0.0 };
        if change < 0.9 * least {
            (least, stale) = (change, 0);
        } else {
            stale += 1;
            if stale >= PATIENCE {
                (damping, least, stale) = (damping * MORE_DAMPING, change, 0);
            }
        }
    }
    let (slip, residual) = slips(problem, &mut received, &rows, &sticks);
    let of_grid = |field: &[f64]| -> Vec<f64> {
        field.chunks_exact(stride).flat_map(|row| row[..grid.along].iter().copied()).collect()
    };
    let slips = (0..grid.len())
        .map(|k| bound[k] > 0.0 && !sticks[k / grid.along * stride + k % grid.along]);
    Tractions {
        slips: slips.collect(),
        x: of_grid(&rows.x),
        y: of_grid(&rows.y),
        slip_x: slip.iter().map(|s| s[0]).collect(),
        slip_y: slip.iter().map(|s| s[1]).collect(),
        sweeps,
        change: if loaded { change } else { 0.0 },
        converged: !loaded || change <= problem.tolerance,
        residual,
    }
}

/// Slip of all elements, and the largest that contradicts the friction law over the largest rigid
/// slip.
fn slips(
    problem: &FrictionProblem<'_>,
    received: &mut Received,
    rows: &TractionRows,
    sticks: &[bool],
) -> (Vec<[f64; 2]>, f64) {
    let FrictionProblem { grid, bound, rigid, .. } = *problem;
    let mut slip = vec![[0.0; 2]; grid.len()];
    let (mut contradiction, mut largest) = (0.0_f64, 0.0_f64);
    for j in (0..grid.across).filter(|&j| rows.is_loaded(j)) {
        received.begin_row(j, rows);
        for i in (0..grid.along).filter(|i| bound[j * grid.along + i] > 0.0) {
            let (k, at) = (j * grid.along + i, j * rows.stride + i);
            let own = received.at(i, j, rows);
            let s = [rigid[k][0] + own[0], rigid[k][1] + own[1]];
            let opposite = if sticks[at] { 0.0 } else { s[0].hypotenuse(s[1]) / bound[k] };
            let left = [s[0] + opposite * rows.x[at], s[1] + opposite * rows.y[at]];
            slip[k] = s;
            contradiction = contradiction.max(left[0].hypotenuse(left[1]));
            largest = largest.max(rigid[k][0].hypotenuse(rigid[k][1]));
        }
    }
    (slip, if largest > 0.0 { contradiction / largest } else { 0.0 })
}

/// Share of the bound below which an element of a start sticks [-].
const STICKING: f64 = 0.999;

/// Damping of steady rolling to begin with [-]: undamped, traction turns in waves through the slip
/// area.
const ROLLING_DAMPING: f64 = 2.0;

/// The same where elements change alone [-].
const LOCAL_DAMPING: f64 = 1.6;

/// What an element receives when it and the m elements behind it change by a unit, for m from 0.
fn carried_influence(influence: &TangentialInfluence, along: usize) -> Vec<[f64; 2]> {
    let mut sum = [0.0; 2];
    (0..along as isize)
        .map(|m| {
            sum[0] += influence.xx.at(-m, 0);
            sum[1] += influence.yy.at(-m, 0);
            sum
        })
        .collect()
}

/// The traction of magnitude `g` that is opposite to the slip s + D (p_new - p), D the diagonal
/// `stiffness`.
fn at_the_bound(p: [f64; 2], s: [f64; 2], stiffness: [f64; 2], g: f64) -> [f64; 2] {
    // (D + λ) p_new = D p - s with λ ≥ 0 such that |p_new| = g; 1/|p_new| is almost linear in λ.
    let pull = [stiffness[0] * p[0] - s[0], stiffness[1] * p[1] - s[1]];
    let mut lambda = (pull[0].hypotenuse(pull[1]) / g - stiffness[0].max(stiffness[1])).max(0.0);
    let mut new = [0.0; 2];
    let mut size = 0.0;
    for _ in 0..20 {
        let inverse = [1.0 / (stiffness[0] + lambda), 1.0 / (stiffness[1] + lambda)];
        new = [pull[0] * inverse[0], pull[1] * inverse[1]];
        let square = new[0] * new[0] + new[1] * new[1];
        size = square.sqrt();
        let error = size / g - 1.0;
        if error.abs() < 1e-10 || square == 0.0 {
            break;
        }
        let slope = (new[0] * new[0] * inverse[0] + new[1] * new[1] * inverse[1]) / square;
        lambda = (lambda + error / slope).max(0.0);
    }
    if size > 0.0 { [new[0] * g / size, new[1] * g / size] } else { p }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::{Material, MaterialPair};
    use approx::assert_relative_eq;

    fn solved(rigid: [f64; 2], tolerance: f64) -> (Grid, Tractions) {
        let steel = Material { young_modulus: 2.0, poisson_ratio: 0.3 };
        let grid = Grid::over([-1.0, 1.0], [-1.0, 1.0], 6, 5);
        let influence = TangentialInfluence::rolling_slip(&grid, &MaterialPair::new(steel, steel));
        let bound = grid.sample(|x, y| if x * x + y * y < 1.0 { 0.1 } else { 0.0 });
        let problem = FrictionProblem {
            grid: &grid,
            influence: &influence,
            bound: &bound,
            rigid: &vec![rigid; grid.len()],
            rolling: true,
            tolerance,
            max_sweeps: MAX_SWEEPS,
        };
        (grid, solve(&problem, None))
    }

    #[test]
    fn sweeps_that_do_not_reach_the_tolerance_say_so() {
        let (_, found) = solved([0.02, 0.01], -1.0);
        assert!(!found.converged && found.sweeps == MAX_SWEEPS);
        assert!(found.x.iter().chain(&found.y).all(|p| p.is_finite()));
    }

    #[test]
    fn without_slip_nothing_moves_and_with_much_all_slides() {
        let (_, still) = solved([0.0; 2], TOLERANCE);
        assert!(still.converged && still.sweeps == 1);
        assert!(still.x.iter().all(|&p| p == 0.0));
        let (_, sliding) = solved([30.0, -40.0], TOLERANCE);
        assert!(sliding.converged);
        for k in (0..sliding.x.len()).filter(|&k| sliding.slips[k]) {
            assert_relative_eq!(sliding.x[k], -0.06, max_relative = 0.02);
            assert_relative_eq!(sliding.y[k], 0.08, max_relative = 0.02);
        }
    }

    #[test]
    fn the_traction_at_the_bound_is_opposite_to_the_slip_it_leaves() {
        let (p, s, stiffness, g) = ([0.3, 0.1], [2.0, -1.0], [1.5, 1.1], 0.4);
        let new = at_the_bound(p, s, stiffness, g);
        assert_relative_eq!(new[0].hypotenuse(new[1]), g, max_relative = 1e-12);
        let left = [0, 1].map(|c| s[c] + stiffness[c] * (new[c] - p[c]));
        assert_relative_eq!(left[0] * new[1], left[1] * new[0], epsilon = 1e-9);
        assert!(left[0] * new[0] + left[1] * new[1] < 0.0);
    }
}
