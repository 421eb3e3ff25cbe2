//! A Newton step on one strip: its linear equations, and their solution by elimination.

use std::ops::Range;

use super::equations::{RAMP, Strip};
use super::points::{LANES, MOMENTS, Points, Row};
use super::sizes::PAIR;

/// Equations of one strip in blocks of four.
const BLOCKS: usize = 2 * LANES / 4;

pub(super) type Column = [[f64; 4]; BLOCKS];

pub(super) const EMPTY: Column = [[0.0; 4]; BLOCKS];

/// The linear equations of one strip.
pub(super) struct LinearStrip<'a> {
    points: &'a Points,
    slips: [bool; LANES],
    /// Direction of the bounded traction, and across it, where a point slips.
    along: [Row; 2],
    across: [Row; 2],
    /// Of the equation of each point, across its traction where it slips and along x where it
    /// adheres: factors of the gradients ahead and behind, by component.
    ahead: [Row; 2],
    behind: [Row; 2],
    /// And of the traction itself across and along its direction.
    by_across: Row,
    by_along: Row,
    /// Points that adhere, which have an equation along y besides.
    adheres: [usize; LANES],
    adhering: usize,
}

impl<'a> LinearStrip<'a> {
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn of(strip: &Strip, points: &'a Points) -> Self {
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
    pub fn solve(
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

/// Solves for all columns of `right` in place by elimination with row pivots; the `matrix` by
/// columns is lost.
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
