//! Tractions by a semi-smooth Newton method on all strips.
//!
//! Each step eliminates the tractions of every strip by static condensation, which leaves one
//! system in the few coefficients of the gradients that the strips impose on each other. A slipping
//! point has one unknown, the direction of its traction; an adhering one has two.

use super::coupling::{Coupling, Lane, Responses};
use super::equations::{Equations, Strip, dot};
use super::linear_strip::{Column, EMPTY, LinearStrip};
use super::points::{LANES, MOMENTS, Row};
use super::sizes::{ALL, NODES, PAIR};
use crate::tangential::convergence::Convergence;

/// Most steps.
const MAX_STEPS: usize = 30;
/// Largest part of the bound that is left of the equations.
const LEFT: f64 = 1e-10;
/// What is left of the system that couples strips, as a share of its right side, at least and at
/// most: as much as of the equations, so that steps stay quadratic.
const COUPLING_LEFT: [f64; 2] = [1e-4, 3e-2];
/// Magnitude that tractions over their bounds keep in the iteration.
const LARGEST: f64 = 1.5;

/// Part of what is left that a whole step has to take off, as a share of it a part of one (Armijo's
/// rule).
const MIN_GAIN: f64 = 0.05;
/// Share of a step from which on it is taken although it gains nothing: what is left falls again
/// once other points adhere.
const MIN_SHARE: f64 = 0.05;

/// How a solution was found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Settled {
    /// Newton steps.
    pub steps: usize,
    /// Largest part of the bound that is left of the equations [-].
    pub left: f64,
}

impl Settled {
    /// Whether the equations are fulfilled, and what is left of them.
    #[must_use]
    pub fn convergence(&self) -> Convergence {
        Convergence { fallbacks: u64::from(self.left > LEFT), residual: self.left }
    }
}

/// Solver with its scratch memory.
#[derive(Clone, Debug)]
pub(super) struct Newton {
    pub strips: Vec<Strip>,
    tried: Vec<Strip>,
    /// Change of the tractions of each strip by each coefficient from others, and by what is left:
    /// `[i][column][component]`.
    responses: Vec<[[Row; 2]; PAIR + 1]>,
    coupling: Coupling,
    /// Columns of the equations of one strip.
    matrix: Box<[Column; 2 * LANES]>,
}

impl Newton {
    pub fn new() -> Self {
        Self {
            strips: vec![Strip::default(); NODES],
            tried: vec![Strip::default(); NODES],
            responses: vec![[[[0.0; LANES]; 2]; PAIR + 1]; NODES],
            coupling: Coupling::new(),
            matrix: Box::new([EMPTY; 2 * LANES]),
        }
    }

    /// Solves from tractions of half their bounds on.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn solve(&mut self, equations: &Equations) -> Settled {
        equations.begin(&mut self.strips);
        let [mut left, mut norm] = equations.evaluate(&mut self.strips);
        let mut steps = 0;
        while steps < MAX_STEPS && left > LEFT && left.is_finite() {
            steps += 1;
            let share = left.clamp(COUPLING_LEFT[0], COUPLING_LEFT[1]);
            self.direction(equations, share, |_, strip| strip.left());
            let mut share = 1.0;
            loop {
                self.advance(equations, share);
                let [new_left, new_norm] = equations.evaluate(&mut self.tried);
                if new_norm < (1.0 - MIN_GAIN * share) * norm || share < MIN_SHARE {
                    (left, norm) = (new_left, new_norm);
                    break;
                }
                share *= 0.5;
            }
            std::mem::swap(&mut self.strips, &mut self.tried);
        }
        // Within their bounds to rounding, however little is left.
        for strip in &mut self.strips {
            strip.r = strip.bounded;
        }
        Settled { steps, left }
    }

    /// Change of the tractions of strip `i`, to be taken off, by the last
    /// [`direction`](Self::direction).
    pub fn step(&self, i: usize) -> &[Row; 2] {
        &self.responses[i][PAIR]
    }

    /// Solves the linear equations at the tractions of all strips for the `right` side of each;
    /// what couples strips to a `share` of it.
    #[allow(clippy::inline_always, clippy::needless_range_loop)]
    #[inline(always)]
    pub fn direction(
        &mut self,
        equations: &Equations,
        share: f64,
        right: impl Fn(usize, &Strip) -> [Row; 2],
    ) {
        let &Equations { nodes, points, influence, .. } = equations;
        let (n, count) = (NODES, points.count);
        let mut sums: [[Lane; PAIR + 1]; PAIR] = [[[0.0; NODES]; PAIR + 1]; PAIR];
        for (i, node) in nodes.iter().enumerate() {
            let strip = &self.strips[i];
            let own = [0, 1].map(|b| &influence.own[b][i * count..(i + 1) * count]);
            let responses = &mut self.responses[i];
            LinearStrip::of(strip, points).solve(
                own,
                &right(i, strip),
                &mut self.matrix,
                responses,
            );
            for (column, response) in responses.iter().enumerate() {
                for component in 0..2 {
                    for k in 0..MOMENTS {
                        let mut sum = [0.0; 4];
                        for l in 0..LANES {
                            sum[l % 4] += response[component][l] * points.coefficients[k][l];
                        }
                        let sum = (sum[0] + sum[1]) + (sum[2] + sum[3]);
                        sums[component * MOMENTS + k][column][i] = sum * node.strength;
                    }
                }
            }
        }
        let mut responses: Responses = [[[0.0; NODES]; PAIR]; PAIR];
        let mut moments = [0.0; ALL];
        for (row, sums) in sums.iter().enumerate() {
            responses[row].copy_from_slice(&sums[..PAIR]);
            for (i, node) in nodes.iter().enumerate() {
                moments[row * n + i] = sums[PAIR][i] * node.bound;
            }
        }
        let mut change = [0.0; ALL];
        for (change, row) in change.iter_mut().zip(&influence.coupling) {
            *change = -dot(row, &moments);
        }
        self.coupling.solve(&influence.coupling, &responses, &mut change, share);
        for (i, node) in nodes.iter().enumerate() {
            let (by, step) = self.responses[i].split_at_mut(PAIR);
            for (k, by) in by.iter().enumerate() {
                let change = change[k * n + i] / node.bound;
                for component in 0..2 {
                    for m in 0..LANES {
                        step[0][component][m] += by[component][m] * change;
                    }
                }
            }
        }
    }

    /// Goes a `share` of the step.
    #[allow(clippy::inline_always, clippy::needless_range_loop)]
    #[inline(always)]
    fn advance(&mut self, equations: &Equations, share: f64) {
        let n = equations.nodes.len();
        let states = self.tried.iter_mut().zip(&self.strips).zip(&self.responses);
        for ((new, old), responses) in states.take(n) {
            let step = &responses[PAIR];
            for m in 0..LANES {
                let x = old.r[0][m] - share * step[0][m];
                let y = old.r[1][m] - share * step[1][m];
                let within = (LARGEST / (x * x + y * y).sqrt()).min(1.0);
                (new.r[0][m], new.r[1][m]) = (x * within, y * within);
            }
        }
    }
}
