//! The equations of steady rolling on strips.
//!
//! With the gradients g_m of displacement against the rigid slip, over bound and shear modulus, the
//! tractions r over their bounds fulfil
//!
//! ```text
//! v = r_m + ρ_m g_m,  h = ρ_m (g_{m+1} - g_m)/2,  s = clamp((|v| - 1)/RAMP, 0, 1)
//! r_m = v where |v| ≤ 1,  else (v + s h)/|v + s h|
//! ```
//!
//! A point adheres by the gradient just ahead of it, so that tractions begin at zero at the leading
//! edge and end with the bound at the trailing one; where it slips its direction is that of the
//! slip at the point itself, the mean of the gradients on both sides, without which the error would
//! be of first order in the distance of points. s goes from the one to the other.

use super::influence::Influence;
use super::layout::Node;
use super::points::{LANES, MOMENTS, Points, Row};
use super::sizes::{ALL, NODES};
use crate::math::real::Real;

/// Overshoot of |v| over which the direction of slip goes over from the gradient ahead to the one
/// in place.
pub(super) const RAMP: f64 = 0.5;

/// Rigid slip over bound and shear modulus that counts: squares of it are numbers.
const MAX_SLIP: f64 = 1e100;

/// State of one strip.
#[derive(Clone, Copy, Debug)]
pub(super) struct Strip<T = f64> {
    /// Tractions over their bounds, along and across.
    pub r: [Row<T>; 2],
    pub v: [Row<T>; 2],
    /// h.
    pub turn: [Row<T>; 2],
    /// Where the tractions should be.
    pub bounded: [Row<T>; 2],
}

impl<T: Real> Default for Strip<T> {
    fn default() -> Self {
        let none = [[T::from(0.0); LANES]; 2];
        Self { r: none, v: none, turn: none, bounded: none }
    }
}

impl Strip {
    /// What is left of the equations.
    #[inline]
    pub fn left(&self) -> [Row; 2] {
        std::array::from_fn(|b| std::array::from_fn(|m| self.r[b][m] - self.bounded[b][m]))
    }
}

/// What the tractions follow from.
#[derive(Clone, Copy)]
pub(super) struct Equations<'a, T = f64> {
    pub nodes: &'a [Node<T>; NODES],
    pub points: &'a Points,
    pub influence: &'a Influence<T>,
    /// [Pa].
    pub shear_modulus: T,
}

impl Equations<'_> {
    /// Tractions along the rigid slip of each strip at its leading edge, half as large as their
    /// bounds: from there it takes the fewest steps, whether strips adhere or slip.
    pub fn begin(&self, strips: &mut [Strip]) {
        for (strip, node) in strips.iter_mut().zip(self.nodes) {
            let x = node.creepage.longitudinal;
            let y = node.creepage.lateral + node.creepage.spin * node.half_length;
            let size = 2.0 * x.hypot(y).max(f64::MIN_POSITIVE);
            for m in 0..self.points.count {
                (strip.r[0][m], strip.r[1][m]) = (x / size, y / size);
            }
        }
    }
}

impl<T: Real> Equations<'_, T> {
    /// Evaluates the equations at the tractions of `strips`; what is left of them, at most and as a
    /// norm.
    #[allow(clippy::inline_always, clippy::needless_range_loop)]
    #[inline(always)]
    pub fn evaluate(&self, strips: &mut [Strip<T>]) -> [f64; 2] {
        let &Equations { nodes, points, influence, shear_modulus } = self;
        let (n, count, zero) = (NODES, points.count, T::from(0.0));
        let (mut moments, mut gradients) = ([zero; ALL], [zero; ALL]);
        for (i, (strip, node)) in strips.iter().zip(nodes).enumerate() {
            let scale = node.strength * node.bound;
            for component in 0..2 {
                for k in 0..MOMENTS {
                    let by = &points.coefficients[k];
                    let mut sums = [zero; 4];
                    for l in 0..LANES {
                        sums[l % 4] += strip.r[component][l] * by[l];
                    }
                    let sum = (sums[0] + sums[1]) + (sums[2] + sums[3]);
                    moments[(component * MOMENTS + k) * n + i] = sum * scale;
                }
            }
        }
        for (z, row) in gradients.iter_mut().zip(&influence.coupling) {
            *z = dot(row, &moments);
        }
        let (mut worst, mut norm) = (0.0f64, 0.0);
        for (i, (strip, node)) in strips.iter_mut().zip(nodes).enumerate() {
            let inverse = T::from(1.0) / node.bound;
            let scale = shear_modulus * inverse;
            let mut g = [[zero; LANES]; 2];
            let rigid = [
                [node.creepage.longitudinal * scale, zero],
                [node.creepage.lateral * scale, node.creepage.spin * node.half_length * scale],
            ]
            .map(|slip| slip.map(|s| s.within(-MAX_SLIP, MAX_SLIP)));
            for (component, g) in g.iter_mut().enumerate() {
                for k in 0..MOMENTS {
                    let z = gradients[(component * MOMENTS + k) * n + i] * inverse;
                    let by = if k < 2 { rigid[component][k] - z } else { -z };
                    for m in 0..LANES {
                        g[m] += by * points.polynomials[k][m];
                    }
                }
                for l in 0..count {
                    let (own, r) =
                        (&influence.own[component][i * count + l], strip.r[component][l]);
                    for m in 0..LANES {
                        g[m] += -(own[m] * r);
                    }
                }
            }
            for m in 0..LANES - 1 {
                let rho = points.steps[m];
                let (x, y) = (strip.r[0][m] + g[0][m] * rho, strip.r[1][m] + g[1][m] * rho);
                let turn = [0, 1].map(|b| (g[b][m + 1] - g[b][m]) * (0.5 * rho));
                let size = (x * x + y * y).sqrt();
                let share = ((size - 1.0) / RAMP).within(0.0, 1.0);
                let slip = [x + share * turn[0], y + share * turn[1]];
                let over = (slip[0] * slip[0] + slip[1] * slip[1]).sqrt();
                let over = if size > 1.0 { over.at_least(f64::MIN_POSITIVE) } else { T::from(1.0) };
                let inverse = T::from(1.0) / over;
                (strip.v[0][m], strip.v[1][m]) = (x, y);
                for b in 0..2 {
                    strip.turn[b][m] = turn[b];
                    strip.bounded[b][m] = slip[b] * inverse;
                }
            }
            for b in 0..2 {
                for m in 0..LANES - 1 {
                    let left = (strip.r[b][m] - strip.bounded[b][m]).value();
                    worst = worst.max(left.abs());
                    norm += left * left;
                }
            }
        }
        let norm = norm.sqrt();
        [if norm.is_finite() { worst } else { f64::INFINITY }, norm]
    }
}

/// Sum of products, in eight parts.
#[allow(clippy::inline_always, clippy::needless_range_loop)]
#[inline(always)]
pub(super) fn dot<T: Real, const N: usize>(a: &[T; N], b: &[T; N]) -> T {
    let mut sums = [T::from(0.0); 8];
    let mut k = 0;
    while k + 8 <= N {
        for lane in 0..8 {
            sums[lane] += a[k + lane] * b[k + lane];
        }
        k += 8;
    }
    while k < N {
        sums[k % 8] += a[k] * b[k];
        k += 1;
    }
    let four: [T; 4] = std::array::from_fn(|k| sums[k] + sums[k + 4]);
    (four[0] + four[2]) + (four[1] + four[3])
}
