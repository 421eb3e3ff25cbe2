//! Tractions by a semi-smooth Newton method on all strips.
//!
//! A step solves each strip for its own tractions and its response to the coefficients of the gradients from others, then one system for these. Where a point slips its traction
//! is as large as its bound: one unknown is left, the direction; where it adheres there are two.

use std::ops::Range;

use super::coupling::{Coupling, Lane, Responses};
use super::equations::{Equations, RAMP, Strip, dot};
use super::points::{LANES, MOMENTS, Points, Row};
use super::{ALL, NODES, PAIR};

/// Most steps.
const MOST_STEPS: usize = 30;
/// Largest part of the bound that is left of the equations.
const LEFT: f64 = 1e-10;
/// What is left of the system that couples strips, as a share of its right side, at least and at most: as much as of the equations, so that steps stay quadratic.
const COUPLING_LEFT: [f64; 2] = [1e-4, 3e-2];
/// Magnitude that tractions over their bounds keep in the iteration.
const LARGEST: f64 = 1.5;

/// Part of what is left that a whole step has to take off, as a share of it a part of one (Armijo's rule).
const LEAST_GAIN: f64 = 0.05;
/// Share of a step from which on it is taken although it gains nothing: what is left falls again once other points adhere.
const LEAST_SHARE: f64 = 0.05;

/// How a solution was found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Settled {
    /// Newton steps.
    pub steps: usize,
    /// Largest part of the bound that is left of the equations [-].
    pub left: f64,
}

impl Settled {
    /// Whether the equations are fulfilled.
    #[must_use]
    pub fn converged(&self) -> bool {
        self.left <= LEFT
    }
}

/// Equations of one strip in blocks of four.
const BLOCKS: usize = 2 * LANES / 4;
type Column = [[f64; 4]; BLOCKS];
const EMPTY: Column = [[0.0; 4]; BLOCKS];

/// Solver with its scratch memory.
#[derive(Clone, Debug)]
pub(super) struct Newton {
    pub strips: Vec<Strip>,
    tried: Vec<Strip>,
    /// Change of the tractions of each strip by each coefficient from others, and by what is left: `[i][column][component]`.
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
        while steps < MOST_STEPS && left > LEFT && left.is_finite() {
            steps += 1;
            let share = left.clamp(COUPLING_LEFT[0], COUPLING_LEFT[1]);
            self.direction(equations, share, |_, strip| strip.left());
            let mut share = 1.0;
            loop {
                self.advance(equations, share);
                let [new_left, new_norm] = equations.evaluate(&mut self.tried);
                if new_norm < (1.0 - LEAST_GAIN * share) * norm || share < LEAST_SHARE {
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

    /// Change of the tractions of strip `i`, to be taken off, by the last [`direction`](Self::direction).
    pub fn step(&self, i: usize) -> &[Row; 2] {
        &self.responses[i][PAIR]
    }

    /// Solves the linear equations at the tractions of all strips for the `right` side of each; what couples strips to a `share` of it.
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
            Local::of(strip, points).solve(own, &right(i, strip), &mut self.matrix, responses);
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

/// The linear equations of one strip.
struct Local<'a> {
    points: &'a Points,
    slips: [bool; LANES],
    /// Direction of the bounded traction, and across it, where a point slips.
    along: [Row; 2],
    across: [Row; 2],
    /// Of the equation of each point, across its traction where it slips and along x where it adheres: factors of the gradients ahead and behind, by component.
    ahead: [Row; 2],
    behind: [Row; 2],
    /// And of the traction itself across and along its direction.
    by_across: Row,
    by_along: Row,
    /// Points that adhere, which have an equation along y besides.
    adheres: [usize; LANES],
    adhering: usize,
}

impl<'a> Local<'a> {
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn of(strip: &Strip, points: &'a Points) -> Self {
        let none = [[0.0; LANES]; 2];
        let mut own = Self {
            points,
            slips: [false; LANES],
            along: none,
            across: none,
            ahead: none,
            behind: none,
            by_across: [0.0; LANES],
            by_along: [0.0; LANES],
            adheres: [0; LANES],
            adhering: 0,
        };
        for m in 0..points.count {
            let (v, turn) = ([strip.v[0][m], strip.v[1][m]], [strip.turn[0][m], strip.turn[1][m]]);
            let rho = points.steps[m];
            let size = (v[0] * v[0] + v[1] * v[1]).sqrt();
            if size <= 1.0 {
                own.ahead[0][m] = rho;
                own.adheres[own.adhering] = m;
                own.adhering += 1;
                continue;
            }
            let share = ((size - 1.0) / RAMP).clamp(0.0, 1.0);
            let e = [strip.bounded[0][m], strip.bounded[1][m]];
            let n = [-e[1], e[0]];
            let slip = [v[0] + share * turn[0], v[1] + share * turn[1]];
            let over = (slip[0] * slip[0] + slip[1] * slip[1]).sqrt().max(f64::MIN_POSITIVE);
            let bend = if share < 1.0 { 1.0 / (RAMP * size) } else { 0.0 };
            let turned = (n[0] * turn[0] + n[1] * turn[1]) * bend;
            let scale = rho / over;
            for b in 0..2 {
                own.along[b][m] = e[b];
                own.across[b][m] = n[b];
                own.ahead[b][m] = scale * ((1.0 - 0.5 * share) * n[b] + turned * v[b]);
                own.behind[b][m] = scale * 0.5 * share * n[b];
            }
            let along = turned * (v[0] * e[0] + v[1] * e[1]);
            let across = turned * (v[0] * n[0] + v[1] * n[1]);
            own.by_across[m] = 1.0 - (1.0 + across) / over;
            own.by_along[m] = -along / over;
            own.slips[m] = true;
        }
        own
    }

    /// Tractions by the coefficients of the gradient from others, and by the `right` side.
    #[allow(clippy::inline_always, clippy::needless_range_loop)]
    #[inline(always)]
    fn solve(
        &self,
        own: [&[Row]; 2],
        right: &[Row; 2],
        matrix: &mut [Column; 2 * LANES],
        responses: &mut [[Row; 2]; PAIR + 1],
    ) {
        let count = self.points.count;
        let size = count + self.adhering;
        let adheres = &self.adheres[..self.adhering];
        // Rows behind the last one hold what was left there and count for nothing.
        let mut sides = [EMPTY; PAIR + 1];
        let mut second = count;
        for l in 0..count {
            // By the traction along x and along y.
            let by: [Row; 2] = std::array::from_fn(|b| self.equations(b, &own[b][l]));
            if self.slips[l] {
                let n = [self.across[0][l], self.across[1][l]];
                let column = matrix[l].as_flattened_mut();
                for m in 0..LANES {
                    column[m] = by[0][m] * n[0] + by[1][m] * n[1];
                }
                column[l] += self.by_across[l];
                for (value, &m) in column[count..].iter_mut().zip(adheres) {
                    *value = self.points.steps[m] * own[1][l][m] * n[1];
                }
            } else {
                let column = matrix[l].as_flattened_mut();
                column[..LANES].copy_from_slice(&by[0]);
                column[count..].fill(0.0);
                let column = matrix[second].as_flattened_mut();
                column[..LANES].copy_from_slice(&by[1]);
                for (value, &m) in column[count..].iter_mut().zip(adheres) {
                    *value = self.points.steps[m] * own[1][l][m];
                }
                second += 1;
            }
        }
        for b in 0..2 {
            for (k, polynomial) in self.points.polynomials.iter().enumerate() {
                let side = sides[b * MOMENTS + k].as_flattened_mut();
                side[..LANES].copy_from_slice(&self.equations(b, polynomial));
                side[count..].fill(0.0);
                if b == 1 {
                    for (value, &m) in side[count..].iter_mut().zip(adheres) {
                        *value = self.points.steps[m] * polynomial[m];
                    }
                }
            }
        }
        // Where a point slips the change along its traction is known.
        let (mut known, mut gradients) = ([[0.0; LANES]; 2], [[0.0; LANES]; 2]);
        let side = sides[PAIR].as_flattened_mut();
        for m in 0..count {
            if self.slips[m] {
                let (e, n) =
                    ([self.along[0][m], self.along[1][m]], [self.across[0][m], self.across[1][m]]);
                let along = e[0] * right[0][m] + e[1] * right[1][m];
                side[m] = n[0] * right[0][m] + n[1] * right[1][m] - self.by_along[m] * along;
                (known[0][m], known[1][m]) = (e[0] * along, e[1] * along);
            } else {
                side[m] = right[0][m];
            }
        }
        for b in 0..2 {
            for (own, known) in own[b].iter().zip(known[b]) {
                for m in 0..LANES {
                    gradients[b][m] += own[m] * known;
                }
            }
            let by = self.equations(b, &gradients[b]);
            for m in 0..count {
                side[m] -= by[m];
            }
        }
        for (value, &m) in side[count..].iter_mut().zip(adheres) {
            *value = right[1][m] - self.points.steps[m] * gradients[1][m];
        }
        eliminate(&mut matrix[..size], &mut sides);
        for (column, (response, side)) in responses.iter_mut().zip(&sides).enumerate() {
            let side = side.as_flattened();
            *response = if column == PAIR { known } else { [[0.0; LANES]; 2] };
            let mut second = count;
            for m in 0..count {
                if self.slips[m] {
                    response[0][m] += self.across[0][m] * side[m];
                    response[1][m] += self.across[1][m] * side[m];
                } else {
                    (response[0][m], response[1][m]) = (side[m], side[second]);
                    second += 1;
                }
            }
        }
    }

    /// What a gradient of the component `b` adds to the first equations.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn equations(&self, b: usize, gradient: &Row) -> Row {
        let mut by = [0.0; LANES];
        for m in 0..LANES - 1 {
            by[m] = self.ahead[b][m] * gradient[m] + self.behind[b][m] * gradient[m + 1];
        }
        by
    }
}

/// Solves for all columns of `right` in place by elimination with row pivots; the `matrix` by columns is lost.
#[allow(clippy::inline_always, clippy::needless_range_loop)]
#[inline(always)]
fn eliminate(matrix: &mut [Column], right: &mut [Column; PAIR + 1]) {
    let size = matrix.len();
    let blocks = size.div_ceil(4);
    for k in 0..size {
        let (head, tail) = matrix.split_at_mut(k + 1);
        let column = head[k].as_flattened_mut();
        let mut pivot = k;
        for row in k + 1..size {
            if column[row].abs() > column[pivot].abs() {
                pivot = row;
            }
        }
        if pivot != k {
            column.swap(k, pivot);
            for other in tail.iter_mut().chain(right.iter_mut()) {
                other.as_flattened_mut().swap(k, pivot);
            }
        }
        // A point whose equation says nothing stays as it is.
        let inverse = if column[k].abs() > f64::MIN_POSITIVE { 1.0 / column[k] } else { 0.0 };
        let mut factors = EMPTY;
        for (factor, value) in
            factors.as_flattened_mut()[k + 1..size].iter_mut().zip(&column[k + 1..size])
        {
            *factor = value * inverse;
        }
        column[k] = inverse;
        let of = k / 4..blocks;
        let mut columns = tail.chunks_exact_mut(4);
        for four in &mut columns {
            take_off::<4>(four, k, &factors, of.clone());
        }
        for one in columns.into_remainder().chunks_exact_mut(1) {
            take_off::<1>(one, k, &factors, of.clone());
        }
        take_off::<{ PAIR + 1 }>(right, k, &factors, of);
    }
    for k in (0..size).rev() {
        let inverse = matrix[k].as_flattened()[k];
        // Of the rows before it alone.
        let mut factors = EMPTY;
        factors.as_flattened_mut()[..k].copy_from_slice(&matrix[k].as_flattened()[..k]);
        for other in right.iter_mut() {
            other[k / 4][k % 4] *= inverse;
        }
        take_off::<{ PAIR + 1 }>(right, k, &factors, 0..k / 4 + 1);
    }
}

/// Takes row `k` times the `factors` off the `blocks` of each of `N` columns.
#[allow(clippy::inline_always, clippy::needless_range_loop)]
#[inline(always)]
fn take_off<const N: usize>(
    columns: &mut [Column],
    k: usize,
    factors: &Column,
    blocks: Range<usize>,
) {
    let Ok(columns) = <&mut [Column; N]>::try_from(columns) else { return };
    let by: [f64; N] = std::array::from_fn(|c| columns[c][k / 4][k % 4]);
    for q in blocks.start..blocks.end.min(BLOCKS) {
        let factors = factors[q];
        for c in 0..N {
            for lane in 0..4 {
                columns[c][q][lane] -= by[c] * factors[lane];
            }
        }
    }
}
