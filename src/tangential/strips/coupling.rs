//! The system of equations that couples the strips, (1 + C R) z = b, by GMRES (Saad and Schultz
//! 1986).
//!
//! C gives the gradients of all strips by the moments of their tractions, R, in blocks, the moments
//! of each strip by the gradients that it sees from others.

use super::equations::dot;
use super::sizes::{ALL, NODES, PAIR};

/// Most directions.
const MAX_DIRECTIONS: usize = 40;

pub(super) type Lane = [f64; NODES];
pub(super) type Vector = [f64; ALL];

/// Responses of the moments of strips to the gradients: `[moment][gradient][i]`.
pub(super) type Responses = [[Lane; PAIR]; PAIR];

/// Scratch memory.
#[derive(Clone, Debug)]
pub(super) struct Coupling {
    basis: Vec<Vector>,
}

impl Coupling {
    pub fn new() -> Self {
        Self { basis: vec![[0.0; ALL]; MAX_DIRECTIONS + 1] }
    }

    /// Solves with the matrix `coupling` by rows, to `share` of the `right` side, which becomes the
    /// solution.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn solve(
        &mut self,
        coupling: &[Vector],
        responses: &Responses,
        right: &mut Vector,
        share: f64,
    ) {
        let norm = dot(right, right).sqrt();
        if !(norm > f64::MIN_POSITIVE && norm.is_finite()) {
            *right = [0.0; ALL];
            return;
        }
        for (b, r) in self.basis[0].iter_mut().zip(right.iter()) {
            *b = r / norm;
        }
        let mut hessenberg = [[0.0; MAX_DIRECTIONS + 1]; MAX_DIRECTIONS];
        let mut turns = [[0.0; 2]; MAX_DIRECTIONS];
        let mut left = [0.0; MAX_DIRECTIONS + 1];
        left[0] = norm;
        let mut used = 0;
        while used < MAX_DIRECTIONS {
            let k = used;
            let mut next = apply(coupling, responses, &self.basis[k]);
            let column = &mut hessenberg[k];
            for (h, basis) in column.iter_mut().zip(&self.basis[..=k]) {
                *h = dot(&next, basis);
                for (next, basis) in next.iter_mut().zip(basis) {
                    *next -= *h * basis;
                }
            }
            let size = dot(&next, &next).sqrt();
            for (j, [c, s]) in turns[..k].iter().enumerate() {
                let (a, b) = (column[j], column[j + 1]);
                (column[j], column[j + 1]) = (c * a + s * b, c * b - s * a);
            }
            let whole = column[k].hypot(size).max(f64::MIN_POSITIVE);
            turns[k] = [column[k] / whole, size / whole];
            column[k] = whole;
            (left[k], left[k + 1]) = (turns[k][0] * left[k], -turns[k][1] * left[k]);
            used += 1;
            let rest = left[k + 1].abs();
            if rest <= share * norm || rest.is_nan() {
                break;
            }
            for (b, next) in self.basis[used].iter_mut().zip(&next) {
                *b = next / size;
            }
        }
        for k in (0..used).rev() {
            let known: f64 = (k + 1..used).map(|j| hessenberg[j][k] * left[j]).sum();
            left[k] = (left[k] - known) / hessenberg[k][k];
        }
        *right = [0.0; ALL];
        for (by, basis) in left[..used].iter().zip(&self.basis) {
            for (right, basis) in right.iter_mut().zip(basis) {
                *right += by * basis;
            }
        }
    }
}

/// (1 + C R) x.
#[allow(clippy::inline_always)]
#[inline(always)]
fn apply(coupling: &[Vector], responses: &Responses, x: &Vector) -> Vector {
    let mut moments = [0.0; ALL];
    for (moments, responses) in moments.chunks_exact_mut(NODES).zip(responses) {
        for (x, response) in x.chunks_exact(NODES).zip(responses) {
            for ((moment, x), response) in moments.iter_mut().zip(x).zip(response) {
                *moment += response * x;
            }
        }
    }
    let mut result = *x;
    for (result, row) in result.iter_mut().zip(coupling) {
        *result += dot(row, &moments);
    }
    result
}
