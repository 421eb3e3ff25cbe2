//! Flexibilities of a strip: what a march needs to have the force of full adhesion.
//!
//! A long strip under a band of tractions like its own has, with the gradients 1, t and T₂(t) of the
//! rigid displacement, forces that follow from an integral equation, solved here by Chebyshev
//! polynomials (Erdogan and Gupta 1972). The march has the same ones with the flexibility L for the
//! first and with the second and the third gradient times k₁ and k₂.
//!
//! Along the track and across, the kernels are those of one family, P + κ R, with κ = ν/(1 - ν) and
//! the factor 1 - ν, and with κ = -ν.

use super::band::{band, quadrature, zero};
use super::functions::Four;
use crate::math::linear_system;
use crate::math::real::Real;

/// Ratios κ at which functions are known: zeros of a Chebyshev polynomial on [-1/2, 1], where all
/// Poisson's ratios have theirs.
pub(super) fn ratios() -> Four<f64> {
    std::array::from_fn(|i| 0.25 + 0.75 * zero(4, i))
}

/// Weights with which functions at [`ratios`] make up those at `ratio`: of the cubic through them.
pub(super) fn weights<T: Real>(ratio: T) -> Four<T> {
    let at = ratios();
    std::array::from_fn(|i| {
        let factors = (0..4).filter(|&k| k != i).map(|k| (ratio - at[k]) / (at[i] - at[k]));
        factors.fold(T::from(1.0), |product, factor| product * factor)
    })
}

/// Polynomials of the tractions.
const ORDER: usize = 12;

/// Flexibility over the half length and the inverse shear modulus, k₁, k₂ and nothing at each of the
/// four ratios, under a band that ends at `s` half lengths to one side, and at as many to the other.
pub(super) fn flexibilities(s: f64) -> [Four<f64>; 4] {
    let places: [f64; ORDER] = std::array::from_fn(|m| zero(ORDER + 1, m));
    // [P or R][place][polynomial]
    let mut kernels = [[[0.0; ORDER]; ORDER]; 2];
    for [t, weight] in quadrature(ORDER + 1, s) {
        let mut polynomials = [0.0; ORDER];
        let (mut before, mut own) = (0.0, weight);
        for polynomial in &mut polynomials {
            *polynomial = own;
            (before, own) = (own, 2.0 * t * own - before);
        }
        for (m, at) in places.iter().enumerate() {
            let [p, r, _] = band(at - t, s);
            for (kernel, value) in kernels.iter_mut().zip([p, r]) {
                for (sum, polynomial) in kernel[m].iter_mut().zip(polynomials) {
                    *sum += value * polynomial;
                }
            }
        }
    }
    ratios().map(|ratio| {
        let force = |gradient: fn(f64) -> f64| {
            let entry = |m: usize, k: usize| kernels[0][m][k] + ratio * kernels[1][m][k];
            let scale = -4.0 / std::f64::consts::PI.powi(2);
            let mut matrix: Vec<f64> =
                (0..ORDER * ORDER).map(|n| scale * entry(n / ORDER, n % ORDER)).collect();
            let mut right = places.map(gradient);
            let is_solved = linear_system::solve(&mut matrix, ORDER, &mut right);
            debug_assert!(is_solved, "the kernel of a strip is regular");
            right[0]
        };
        let even = force(|_| 1.0);
        let (linear, square) = (force(|t| t), force(|t| 2.0 * t * t - 1.0));
        // Marches without bound have the forces 2, 2/3 and -2/3 over L.
        [2.0 / even, linear / even * 3.0, square / even * -3.0, 0.0]
    })
}
