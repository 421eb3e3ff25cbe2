//! Potentials of strips that are displaced along x against each other.
//!
//! Strips of a yawed wheel lie D apart across and Δx along. They act on each other as if they lay
//! abreast, h apart, where h² is h_0², which it is without Δx, times
//!
//! ```text
//! 1 + m² (1 + φ)/(1 + φ + 0.2204 ω + 0.7926 ω^½),   φ = (0.0226 m² + 0.429) m²/ω
//! m = Δx/D,   ω = (a_i² + a_j²)/(2 D²)
//! ```
//!
//! That makes D² + Δx² of D² where strips are short, and little of Δx where long ones pass each other
//! closely. The numbers are fitted to the potential of two strips of equal length at distances of
//! 0.01 to 4 half lengths: within 1 % for displacements of up to as much, 4 % for up to ten times as
//! much (the tests below).
//!
//! As h depends on the lengths, derivatives of K by their squares p and q have more than they have at
//! the same h. K goes with the inverse of all lengths, so that with L = ln(p + q) at the same t, H =
//! ln h², and γ = dH/dL
//!
//! ```text
//! K_L = p K_p + q K_q,   K_H = -½ K - K_L,   dK/dp = K_p + γ K_H/(p + q)
//! ```

use super::lanes::{Four, Lanes, Simd};
use crate::math::real::Real;

const NUMBERS: [f64; 4] = [0.0226, 0.429, 0.2204, 0.7926];

/// What h² grows by.
pub(super) struct Growth<T> {
    /// h² over h_0².
    pub factor: T,
    /// γ, the derivative of its logarithm by ln ω.
    pub rate: T,
}

impl<T: Real> Growth<T> {
    /// For (Δx/D)² and ω.
    pub fn new(displacement: T, lengths: T) -> Self {
        let one = T::from(1.0);
        let near = displacement * (displacement * NUMBERS[0] + NUMBERS[1]) / lengths;
        let (square, root) = (lengths * NUMBERS[2], lengths.sqrt() * NUMBERS[3]);
        let (above, below) = (one + near, one + near + square + root);
        let below_rate = square + root * 0.5 - near;
        let inverse = one / below;
        let share = above * inverse;
        let factor = one + displacement * share;
        let slope = displacement * inverse * (-near - share * below_rate);
        Self { factor, rate: slope / factor }
    }
}

/// How four pairs are displaced.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Displacement {
    /// (Δx/D)² [-].
    square: Lanes,
    /// 1/(2 D²) [m^-2].
    half_inverse_distance: Lanes,
    /// φ (p + q) [m²].
    nearness: Lanes,
}

impl Displacement {
    /// That of these squares (Δx/D)², with 1/(2 D²).
    #[inline(always)]
    pub fn new<S: Simd>(square: Four<S>, half_inverse_distance: Four<S>) -> Self {
        let nearness = square * (square * NUMBERS[0] + NUMBERS[1]) / half_inverse_distance;
        Self {
            square: square.lanes(),
            half_inverse_distance: half_inverse_distance.lanes(),
            nearness: nearness.lanes(),
        }
    }
}

/// What h² of four pairs grows by.
pub(super) struct Growths<S: Simd> {
    /// h_0² over h².
    pub inverse: Four<S>,
    /// γ and dγ/dL.
    pub rate: Four<S>,
    pub bend: Four<S>,
}

impl<S: Simd> Growths<S> {
    /// For pairs of which the sum of the squares of the half lengths and its reciprocal are these.
    #[inline(always)]
    pub fn new(simd: S, displaced: &Displacement, [sum, reciprocal]: [Four<S>; 2]) -> Self {
        let one = simd.splat(1.0);
        let displacement = simd.four(&displaced.square);
        let lengths = sum * simd.four(&displaced.half_inverse_distance);
        let near = simd.four(&displaced.nearness) * reciprocal;
        let (square, root) = (lengths * NUMBERS[2], lengths.sqrt() * NUMBERS[3]);
        let above = one + near;
        let below = above + square + root;
        let below_rate = square + root * 0.5 - near;
        let below_bend = square + root * 0.25 + near;
        let per_below = one / below;
        let share = above * per_below;
        // Derivatives of the share by ln ω.
        let slope = per_below * (simd.splat(0.0) - near - share * below_rate);
        let bend = per_below * (near - share * below_bend - slope * below_rate * 2.0);
        let inverse = one / one.add_product(displacement, share);
        let per_factor = displacement * inverse;
        let rate = per_factor * slope;
        Self { inverse, rate, bend: (per_factor * bend).sub_product(rate, rate) }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::super::{LinePlace, OverlapLine, Section, StripSolver};
    use super::Growth;
    use crate::geometry::contacts::separation::Probe;
    use crate::normal::{Strips, hertz};

    const RADIUS: f64 = 0.46;
    const APPROACH: f64 = 5e-5;

    /// Two quadratic bodies whose greatest overlaps along x lie on a line x = `slope` y.
    struct Turned {
        across: f64,
        slope: f64,
    }

    impl OverlapLine for Turned {
        fn place(&mut self, u: f64) -> LinePlace {
            LinePlace {
                u,
                y: u,
                dy: 1.0,
                overlap: APPROACH - self.across * u * u,
                overlap_slope: -2.0 * self.across * u,
                x: self.slope * u,
                tangent: [1.0, 0.0],
            }
        }

        fn section(&mut self, _: &LinePlace) -> Section {
            Section::even(RADIUS)
        }
    }

    /// Potential of two semi-elliptic unit loads of half length 1, `away` across and `shift` along:
    /// of the share of pairs that lie ξ apart along both, over their distance.
    fn exact(away: f64, shift: f64) -> f64 {
        let share = |apart: f64| {
            let reach = (1.0 - 0.5 * apart.abs()).max(0.0);
            let middle = -0.5 * apart;
            (0..200)
                .map(|k| PI * (f64::from(k) + 0.5) / 200.0)
                .map(|angle| (middle + reach * angle.cos(), reach * angle.sin() * PI / 200.0))
                .map(|(x, weight)| {
                    let densities = (1.0 - x * x).max(0.0) * (1.0 - (x + apart).powi(2)).max(0.0);
                    weight * densities.sqrt() * 4.0 / (PI * PI)
                })
                .sum::<f64>()
        };
        // Steps of the inverse hyperbolic sine take the peak of the inverse distance up.
        let [from, to] = [shift - 2.0, shift + 2.0].map(|place| (place / away).asinh());
        let step = (to - from) / 1000.0;
        (0..1000)
            .map(|k| share(away * (from + step * (f64::from(k) + 0.5)).sinh() - shift) * step)
            .sum()
    }

    #[test]
    fn displaced_strips_have_the_potential_of_their_loads() {
        for away in [0.01, 0.03, 0.1, 0.3, 1.0, 3.0_f64] {
            for slope in [0.25, 0.5, 1.0, 2.0, 4.0, 10.0_f64] {
                let shift = slope * away;
                if shift > 2.5 {
                    continue;
                }
                let growth = Growth::new(slope * slope, 1.0 / (away * away));
                let abreast = exact(away * growth.factor.sqrt(), 0.0);
                let error = abreast / exact(away, shift) - 1.0;
                println!("{away} {slope}: {:.2} %", 100.0 * error);
                let most = if slope > 1.0 { 0.04 } else { 0.01 };
                assert!(error.abs() < most, "{away} {slope}: {error}");
            }
        }
    }

    #[test]
    fn ellipses_turned_against_the_track_carry_what_hertz_says() {
        let along = 0.5 / RADIUS;
        // Where strips are shorter than their neighbours are displaced, the fit of their potential ends.
        for (ratio, steepest) in [(0.2, 2.0), (1.0, 4.0), (5.0, 6.0), (25.0, 6.0), (100.0, 6.0)] {
            for slope in [0.0, 0.25, 0.5, 1.0, 2.0, 4.0, 6.0_f64] {
                if slope > steepest {
                    continue;
                }
                let across = ratio * along;
                // Principal curvatures of along (x - slope y)² + across y².
                let half_sum: f64 = 0.5 * (along * (1.0 + slope * slope) + across);
                let root = (half_sum * half_sum - along * across).sqrt();
                let more = half_sum + root;
                let exact = hertz::ellipse(along * across / more, more, APPROACH, 1.0);
                let mut line = Turned { across, slope };
                let half = (APPROACH / across).sqrt();
                let probes: Vec<Probe> = (-30..=30)
                    .map(|k| {
                        let u = f64::from(k) * half / 20.0;
                        Probe { u, f: -line.place(u).overlap }
                    })
                    .collect();
                let mut strips = Strips::with_capacity(4, 320);
                let left =
                    StripSolver::new(20).solve(&mut line, &probes, 0.0, 1.0, None, &mut strips);
                let load = exact.load;
                assert_eq!((left, strips.zones.len()), (0, 1));
                let error = strips.load() / load - 1.0;
                let pressure = strips.zones[0].max_pressure / exact.max_pressure - 1.0;
                let percent = [error, pressure].map(|error| 100.0 * error);
                println!(
                    "{ratio:5} {slope:5}: load {:+.2}, pressure {:+.2} %",
                    percent[0], percent[1]
                );
                // Targets of planar problems and, at steep slopes, of the worst of kinked rails.
                let most = if slope > 1.0 { 0.02 } else { 0.005 };
                assert!(error.abs() < most, "{ratio} {slope}: {error}");
                assert!(pressure.abs() < 0.05, "{ratio} {slope}: {pressure}");
            }
        }
    }
}
