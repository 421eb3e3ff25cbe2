//! Points along a strip, and what belongs to their number alone.
//!
//! Tractions are at the zeros t_l = cos(l π/(N+1)) of the Chebyshev polynomial U_N, gradients of
//! displacement at the zeros ξ_m of T_{N+1} between them and beside the outer ones, both from the
//! leading edge on: with these (Erdogan and Gupta 1972) the quadrature of the singular kernel is
//! exact for polynomials.

use std::f64::consts::PI;

/// Chebyshev coefficients of the tractions of a strip that other strips feel, and of the gradient
/// that they have there.
pub(super) const MOMENTS: usize = 3;
/// Places along a strip in which the gradients that come from others are taken.
pub(super) const PLACES: usize = 4;
/// Numbers along a strip: of all points, and zeros behind them.
pub(super) const LANES: usize = 16;
pub(super) type Row<T = f64> = [T; LANES];
/// Most tractions along a strip; there is one gradient more.
pub const MAX_POINTS: usize = LANES - 1;

/// Points of tractions and of gradients along a strip, in half lengths from its middle; the leading
/// edge is at 1.
#[derive(Clone, Debug)]
pub(super) struct Points {
    /// Number of tractions.
    pub count: usize,
    /// Places of the tractions t_l.
    pub tractions: Row,
    /// Places of the gradients ξ_m, one more.
    pub gradients: Row,
    /// Weights of ∫ sqrt(1 - t²) f(t) dt in the places of tractions.
    pub weights: Row,
    /// Coefficients of U_k of what has the value one in place l and none in the others: `[k][l]`.
    pub coefficients: Vec<Row>,
    /// T_k at the places of gradients.
    pub polynomials: [Row; MOMENTS],
    /// T_{k+1} there: what strip theory has of U_k.
    pub singular: Vec<Row>,
    /// Traction by which the gradient just ahead of it changes by one, in strip theory.
    pub steps: Row,
    /// T_k, from T_0 on, in the places where gradients that come from others are taken.
    pub places: [[f64; MOMENTS + 1]; PLACES],
    /// Length of strip that belongs to a place of traction, over that of the strip.
    pub shares: Row,
}

impl Points {
    /// `count` tractions along a strip, 4 to [`MAX_POINTS`].
    pub fn new(count: usize) -> Self {
        let count = count.clamp(4, MAX_POINTS);
        let n = (count + 1) as f64;
        let angle = |l: usize| PI * (l + 1) as f64 / n;
        let between = |m: usize| PI * (m as f64 + 0.5) / n;
        let row = |count: usize, f: &dyn Fn(usize) -> f64| {
            std::array::from_fn(|l| if l < count { f(l) } else { 0.0 })
        };
        let coefficient =
            |k: usize, l: usize| 2.0 / n * ((k + 1) as f64 * angle(l)).sin() * angle(l).sin();
        let at = |k: usize, m: usize| (k as f64 * between(m)).cos();
        // ∫ sqrt(1-t²) U_k(t)/(ξ - t) dt = π T_{k+1}(ξ), twice over π times the shear modulus.
        let own = |m: usize| (0..count).map(|k| at(k + 1, m) * coefficient(k, m)).sum::<f64>();
        Self {
            count,
            tractions: row(count, &|l| angle(l).cos()),
            gradients: row(count + 1, &|m| between(m).cos()),
            weights: row(count, &|l| PI / n * angle(l).sin().powi(2)),
            coefficients: (0..count).map(|k| row(count, &|l| coefficient(k, l))).collect(),
            polynomials: std::array::from_fn(|k| row(count + 1, &|m| at(k, m))),
            singular: (1..=count).map(|k| row(count + 1, &|m| at(k, m))).collect(),
            steps: row(count, &|m| 0.5 / own(m)),
            places: std::array::from_fn(|q| {
                let angle = PI * (q as f64 + 0.5) / PLACES as f64;
                std::array::from_fn(|k| (k as f64 * angle).cos())
            }),
            shares: row(count, &|l| 0.5 * (between(l).cos() - between(l + 1).cos())),
        }
    }
}
