//! Gradients of displacement by tractions over their bounds: of a strip on itself, and of all
//! strips on each other.
//!
//! With the traction -q sqrt(1 - t²) r(t) on a strip of the half length a and the bound q in its
//! middle, its own gradient is that of a band with the same traction out to the reach of the strip
//! on both sides: it holds the whole singularity. What the half-space adds, all other strips and on
//! itself the difference between its true band and that one, is smooth along the strip: a few
//! coefficients of T_k(t), by a few moments of the tractions (coefficients of U_k).

use super::kernel::{FIRST, POLES, SECOND, THIRD, WIDTHS, inside};
use super::layout::Node;
use super::points::{LANES, MAX_POINTS, MOMENTS, PLACES, Points, Row};
use super::sizes::{ALL, NODES};
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;

/// Power of what lies inside the unit circle from which on it is nothing.
const NOTHING: f64 = -34.5;

/// Influence of strips on themselves and on each other, over the shear modulus [-].
#[derive(Clone, Debug)]
pub(super) struct Influence<T = f64> {
    /// Gradients along and across at the places ξ_m of strip i by its own r_x and r_y in the places
    /// t_l: `[component][i, l][m]`.
    pub own: [FixedVec<Row<T>>; 2],
    /// Coefficients of the gradients by the moments of the tractions times strength and bound:
    /// `[component][k][i]` by rows, `[component][k][j]` by columns.
    pub coupling: Vec<[T; ALL]>,
}

/// What one Lorentz curve adds to the gradient of each component by the traction of each.
#[derive(Clone, Copy)]
struct Kernels<T> {
    xx: T,
    yy: T,
    xy: T,
}

/// What the Lorentz curve number `p` adds to the gradients.
fn kernels(p: usize, poisson_ratio: f64) -> Kernels<f64> {
    let nu = poisson_ratio;
    Kernels {
        xx: -(1.0 - nu) * FIRST[p] + nu * SECOND[p],
        yy: -FIRST[p] - nu * SECOND[p],
        xy: nu * THIRD[p],
    }
}

impl<T: Real> Influence<T> {
    /// With room for `points` along each strip.
    pub fn with_capacity(points: usize) -> Self {
        let own = || FixedVec::new(NODES * points);
        Self { own: [own(), own()], coupling: vec![[T::from(0.0); ALL]; ALL] }
    }

    /// Fills all of it for `nodes` with `points` along each.
    // Loops by index over several rows at once become vector instructions.
    #[allow(clippy::inline_always, clippy::needless_range_loop)]
    #[inline(always)]
    pub fn fill(&mut self, nodes: &[Node<T>; NODES], points: &Points, poisson_ratio: f64) {
        for own in &mut self.own {
            own.clear();
        }
        for node in nodes {
            self.fill_own(node, points, poisson_ratio);
        }
        self.fill_coupling(nodes, points, poisson_ratio);
    }

    // Loops by index over several rows at once become vector instructions.
    #[allow(clippy::inline_always, clippy::needless_range_loop)]
    #[inline(always)]
    fn fill_own(&mut self, node: &Node<T>, points: &Points, poisson_ratio: f64) {
        let (count, zero) = (points.count, T::from(0.0));
        // By coefficients of U_k.
        let mut by_power = [[[zero; LANES]; MAX_POINTS]; 2];
        for (by_power, factor) in by_power.iter_mut().zip([1.0 - poisson_ratio, 1.0]) {
            for (row, singular) in by_power.iter_mut().zip(&points.singular) {
                for (value, &whole) in row.iter_mut().zip(singular) {
                    *value = T::from(2.0 * factor * whole);
                }
            }
        }
        let [along, across] = &mut by_power;
        for reach in node.reach {
            let reach = reach / node.half_length;
            for p in 0..POLES {
                let Kernels { xx, yy, .. } = kernels(p, poisson_ratio);
                let y = reach * WIDTHS[p];
                let mut w = [[zero; LANES]; 2];
                for (m, &xi) in points.gradients.iter().enumerate() {
                    let [re, im] = inside(T::from(xi), y);
                    (w[0][m], w[1][m]) = (re, im);
                }
                let mut power = w;
                let far = y.value();
                let needed = NOTHING / ((1.0 + far * far).sqrt() - far).max(1e-300).ln();
                let needed = if needed < count as f64 { needed.ceil() as usize + 1 } else { count };
                for k in 0..needed.min(count) {
                    for m in 0..LANES {
                        along[k][m] += power[0][m] * xx;
                        across[k][m] += power[0][m] * yy;
                        let (re, im) = (power[0][m], power[1][m]);
                        power[0][m] = re * w[0][m] - im * w[1][m];
                        power[1][m] = re * w[1][m] + im * w[0][m];
                    }
                }
            }
        }
        for (own, by_power) in self.own.iter_mut().zip(&by_power) {
            for l in 0..count {
                let mut column = [zero; LANES];
                for k in 0..count {
                    let by = points.coefficients[k][l];
                    for (value, &power) in column.iter_mut().zip(&by_power[k]) {
                        *value += power * by;
                    }
                }
                own.push(column);
            }
        }
    }

    // Loops by index over several rows at once become vector instructions.
    #[allow(clippy::inline_always, clippy::needless_range_loop)]
    #[inline(always)]
    fn fill_coupling(&mut self, nodes: &[Node<T>; NODES], points: &Points, poisson_ratio: f64) {
        let (n, zero) = (NODES, T::from(0.0));
        self.coupling.fill([zero; ALL]);
        let kernels: [Kernels<f64>; POLES] = std::array::from_fn(|p| kernels(p, poisson_ratio));
        let (mut inverse, mut middle) = ([zero; NODES], [zero; NODES]);
        for (j, node) in nodes.iter().enumerate() {
            inverse[j] = T::from(1.0) / node.half_length;
            middle[j] = node.x;
        }
        for (i, node) in nodes.iter().enumerate() {
            // Distances to the edges of all bands, and with which sign the odd kernels of these
            // count.
            let (mut away, mut sign) = ([[zero; NODES]; 2], [[0.0; NODES]; 2]);
            for (j, other) in nodes.iter().enumerate() {
                for side in 0..2 {
                    let e = (node.y - other.edges[side]).abs().at_least(f64::MIN_POSITIVE);
                    away[side][j] = e * inverse[j];
                }
                sign[0][j] = if j <= i { 1.0 } else { -1.0 };
                sign[1][j] = if j < i { -1.0 } else { 1.0 };
            }
            for polynomials in &points.places {
                let t = polynomials[1];
                let mut at = [zero; NODES];
                for j in 0..n {
                    at[j] = (node.x + node.half_length * t - middle[j]) * inverse[j];
                }
                let mut sums = [[[zero; NODES]; MOMENTS]; 3];
                for side in 0..2 {
                    let even = if side == 0 { 1.0 } else { -1.0 };
                    for (p, kernel) in kernels.iter().enumerate() {
                        for j in 0..n {
                            let [re, im] = inside(at[j], away[side][j] * WIDTHS[p]);
                            let odd = sign[side][j];
                            let (mut re_power, mut im_power) = (re, im);
                            for l in 0..MOMENTS {
                                sums[0][l][j] += re_power * (odd * kernel.xx);
                                sums[1][l][j] += re_power * (odd * kernel.yy);
                                sums[2][l][j] += im_power * (-even * kernel.xy);
                                let next = re_power * re - im_power * im;
                                im_power = re_power * im + im_power * re;
                                re_power = next;
                            }
                        }
                    }
                }
                // Of its own band only what its tractions do beyond it is missing.
                for reach in node.reach {
                    let reach = reach * inverse[i];
                    for (p, kernel) in kernels.iter().enumerate() {
                        let [re, im] = inside(T::from(t), reach * WIDTHS[p]);
                        let (mut re_power, mut im_power) = (re, im);
                        for l in 0..MOMENTS {
                            let share = T::from(1.0) / node.strength.at_least(f64::MIN_POSITIVE);
                            sums[0][l][i] += -(re_power * kernel.xx * share);
                            sums[1][l][i] += -(re_power * kernel.yy * share);
                            let next = re_power * re - im_power * im;
                            im_power = re_power * im + im_power * re;
                            re_power = next;
                        }
                    }
                }
                // And the difference of the two strip theories, which is all that a strength other
                // than one leaves.
                let excess = -(T::from(1.0) / node.strength.at_least(f64::MIN_POSITIVE)) + 1.0;
                for l in 0..MOMENTS {
                    let whole = 2.0 * polynomials[l + 1];
                    sums[0][l][i] += excess * (whole * (1.0 - poisson_ratio));
                    sums[1][l][i] += excess * whole;
                }
                for k in 0..MOMENTS {
                    let weight = (if k == 0 { 1.0 } else { 2.0 }) / PLACES as f64 * polynomials[k];
                    for (row, columns) in [(0, [0, 2]), (1, [2, 1])] {
                        let target = &mut self.coupling[(row * MOMENTS + k) * n + i];
                        for (column, sum) in columns.into_iter().enumerate() {
                            for l in 0..MOMENTS {
                                let from = (column * MOMENTS + l) * n;
                                let target = &mut target[from..from + n];
                                for (c, s) in target.iter_mut().zip(&sums[sum][l]) {
                                    *c += *s * weight;
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}
