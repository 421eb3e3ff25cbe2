//! FaStrip: magnitude of the tractions from strip theory, their direction where they slip from FASTSIM.
//!
//! Source: Sichani, Enblom and Berg (2016), in the form it has in CONTACT; on patches of any outline each strip has the
//! amplitude of its own pressure. With t = x/a_j along rolling, q the pressure at the centre of the strip, a the semi-axis of
//! the equivalent ellipse, and A, B, C the growth of tractions along the strip ([`Growth`]), which hold creepages and Kalker's
//! coefficients together, the normalised slip of a strip is
//!
//! ```text
//! ξ = -k A,  η = -k B,  k = 16 (1-ν) a_j / (3 π² μ q),      φ = -3 a a_j C / (8 μ q)
//! D = (sqrt(η² + (1-φ²) ξ²) + η φ) / (1-φ²),  d = D a / ((1-ν) a_j)
//! ```
//!
//! The strip adheres for t > -1 + 2 d, where
//!
//! ```text
//! p_x = μ q κ (S - S_a),  p_y = μ q (λ (S - S_a) + φ S_a),  κ = ξ/D,  λ = η/D + φ
//! S = sqrt(1 - t²),  S_a = sqrt((1-d)² - (t-d)²)
//! ```
//!
//! and slips behind, where the traction is μ p in the direction that FASTSIM gives it. Where strip theory
//! exceeds μ p, which spin can make it do, it is cut back to it. It has no solution for |φ| ≥ 1, where spin alone makes the strip
//! slip: from 0.85 to 0.98 it is faded into FASTSIM.
//!
//! Departure from the source: FASTSIM marches with the elliptic bound and, if asked for, blended flexibilities. With a parabola
//! and three flexibilities the error on 300 Hertzian ellipses is 2.0 % of the friction limit in the mean, 8 % at 95 %; so it is
//! 1.2 and 3.7 %.

use std::f64::consts::PI;

use multiversion::multiversion;

use super::flexibility::ZoneFlexibility;
use super::rigid_slip::{Growth, RigidSlip};
use super::{Rolling, StripForce};
use crate::normal::{Strips, Zone};

/// Normalised spin of a strip from which on FASTSIM takes over [-].
const SPIN_FROM: f64 = 0.85;
/// Normalised spin of a strip from which on it is FASTSIM alone [-].
const SPIN_TO: f64 = 0.98;

/// Strips that are marched together.
const LANES: usize = 32;
type Lanes = [f64; LANES];

/// FaStrip with a fixed number of elements along each strip.
#[derive(Clone, Debug)]
pub struct Fastrip {
    /// The elements of a strip, leading edge first.
    elements: Vec<Element>,
}

/// One element, in units of the strip's half length and greatest bound.
#[derive(Clone, Copy, Debug)]
struct Element {
    /// Abscissa of its middle, 1 at the leading edge.
    middle: f64,
    /// Abscissa of the middle of the step to it.
    step_middle: f64,
    /// sqrt(1 - t²) at its middle.
    height: f64,
    /// Integral of sqrt(1 - t²) from the centre of the strip to its rear and front edge.
    integral: [f64; 2],
}

/// Integral of sqrt(1 - t²) from 0 to `t`.
fn ellipse_integral(t: f64) -> f64 {
    0.5 * (t * (1.0 - t * t).max(0.0).sqrt() + t.asin())
}

impl Fastrip {
    /// `elements` ≥ 1 along each strip.
    #[must_use]
    pub fn new(elements: usize) -> Self {
        let n = elements as f64;
        let edge = |i: usize| (1.0 - 2.0 * i as f64 / n).max(-1.0);
        let element = |i: usize| {
            let middle = 1.0 - (2.0 * i as f64 + 1.0) / n;
            Element {
                middle,
                step_middle: if i == 0 { 1.0 - 0.5 / n } else { middle + 1.0 / n },
                height: (1.0 - middle * middle).sqrt(),
                integral: [i + 1, i].map(|i| ellipse_integral(edge(i))),
            }
        };
        Self { elements: (0..elements).map(element).collect() }
    }

    /// Hands the force of each strip of `zone` on the wheel to `each`.
    ///
    /// Strip theory has the three flexibilities of `flexibility`, the march of FASTSIM those of `marching`.
    /// `friction` > 0 is the coefficient of friction [-], times the factor of the pressure where damping forces act on top of
    /// the elastic load.
    #[allow(clippy::too_many_arguments)] // what a zone is, how it moves, and where its forces go
    pub fn strip_forces(
        &self,
        zone: &Zone,
        strips: &Strips,
        flexibility: &ZoneFlexibility,
        marching: &ZoneFlexibility,
        slip: &impl RigidSlip,
        rolling: Rolling,
        friction: f64,
        poisson_ratio: f64,
        mut each: impl FnMut(usize, StripForce),
    ) {
        let range = zone.first..zone.first + zone.count;
        let step = 2.0 / self.elements.len() as f64;
        let direction = rolling.direction();
        for start in range.clone().step_by(LANES) {
            let mut march = March::default();
            let mut theory = [StripTheory::default(); LANES];
            let lanes = (range.end - start).min(LANES);
            for (lane, own) in theory.iter_mut().enumerate().take(lanes) {
                let j = start + lane;
                let a = strips.half_length[j];
                let bound = friction * strips.pressure[j];
                if bound <= 0.0 || a <= 0.0 {
                    continue;
                }
                let growth = slip.growth(j, marching);
                march.bound[lane] = bound;
                march.step_x[lane] = -step * a * growth.longitudinal;
                march.step_y[lane] = -step * a * growth.lateral;
                march.step_y_per_abscissa[lane] = -step * a * direction * a * growth.twist;
                let growth = slip.growth(j, flexibility);
                // However little the bound is, its inverse can be squared.
                let per_bound = (a / bound).min(1e60);
                let twist = direction * flexibility.semi_axis_along * growth.twist;
                *own = StripTheory::new(&growth, twist, per_bound, poisson_ratio)
                    .on_strip(flexibility.semi_axis_along / a);
                march.adhesion_x[lane] = own.kappa;
                march.adhesion_y[lane] = own.lambda;
                march.spin[lane] = own.spin;
                march.slip_length[lane] = own.slip_length;
                march.slip_integral[lane] = own.slip_integral;
            }
            let (fastsim, behind) = march_strips(&march, &self.elements, step);
            for (lane, own) in theory.iter().enumerate().take(lanes) {
                let j = start + lane;
                let a = strips.half_length[j];
                let [x, y, moment] = own.adhesion();
                let bound = march.bound[lane];
                // FASTSIM in the first place, strip theory in the second.
                let mix = |f: f64, s: f64| own.fastsim_share * f + (1.0 - own.fastsim_share) * s;
                let area = strips.width[j] * a;
                let arm = direction * a;
                each(
                    j,
                    StripForce {
                        longitudinal: area * mix(fastsim.x[lane], behind.x[lane] + bound * x),
                        lateral: area * mix(fastsim.y[lane], behind.y[lane] + bound * y),
                        moment: area
                            * arm
                            * mix(fastsim.moment[lane], behind.moment[lane] + bound * moment),
                        slip_area: area * mix(fastsim.slipping[lane], 2.0 * own.slip_length),
                    },
                );
            }
        }
    }
}

/// Strip theory of one strip.
#[derive(Clone, Copy, Debug, Default)]
struct StripTheory {
    /// κ.
    kappa: f64,
    /// λ.
    lambda: f64,
    /// φ.
    spin: f64,
    /// d, at most 1: then the whole strip slips.
    slip_length: f64,
    /// Integral of sqrt(1 - t²) from the centre of the strip to where adhesion begins.
    slip_integral: f64,
    /// Share of FASTSIM in the tractions.
    fastsim_share: f64,
}

impl StripTheory {
    /// In terms of the zone: `slip_length` over the semi-axis a of the ellipse. `twist` is a C along rolling, `per_bound` a_j/(μ q).
    fn new(growth: &Growth, twist: f64, per_bound: f64, poisson_ratio: f64) -> Self {
        let k = 16.0 * (1.0 - poisson_ratio) / (3.0 * PI * PI) * per_bound;
        let (xi, eta) = (-k * growth.longitudinal, -k * growth.lateral);
        let spin = -3.0 / 8.0 * per_bound * twist;
        let fading = ((spin.abs() - SPIN_FROM) / (SPIN_TO - SPIN_FROM)).clamp(0.0, 1.0);
        let spin = spin.clamp(-SPIN_TO, SPIN_TO);
        let rest = 1.0 - spin * spin;
        let slip = ((eta * eta + rest * xi * xi).sqrt() + eta * spin) / rest;
        // Without any slip both directions are 0/0, and multiply nothing.
        let slip = slip.max(f64::MIN_POSITIVE);
        Self {
            kappa: xi / slip,
            lambda: eta / slip + spin,
            spin,
            slip_length: slip / (1.0 - poisson_ratio),
            slip_integral: 0.0,
            fastsim_share: fading * fading * (3.0 - 2.0 * fading),
        }
    }

    /// The same over the half length of the strip; `semi_axes` is a/a_j.
    fn on_strip(self, semi_axes: f64) -> Self {
        let slip_length = (self.slip_length * semi_axes).min(1.0);
        Self { slip_length, slip_integral: ellipse_integral(2.0 * slip_length - 1.0), ..self }
    }

    /// Integrals over the adhesion area of p_x, p_y and t p_y, in units of μ q.
    fn adhesion(&self) -> [f64; 3] {
        let d = self.slip_length;
        let height = 0.25 * PI - self.slip_integral;
        let inner = 0.5 * PI * (1.0 - d) * (1.0 - d);
        // 1 - t² where adhesion begins is 4 d (1 - d).
        let (first, inner_first) = ((4.0 * d * (1.0 - d)).powf(1.5) / 3.0, d * inner);
        let difference = height - inner;
        [
            self.kappa * difference,
            self.lambda * difference + self.spin * inner,
            self.lambda * (first - inner_first) + self.spin * inner_first,
        ]
    }
}

/// What the march of up to [`LANES`] strips needs.
#[derive(Clone, Copy, Debug, Default)]
struct March {
    /// Traction increments of FASTSIM for each element.
    step_x: Lanes,
    step_y: Lanes,
    step_y_per_abscissa: Lanes,
    /// μ q.
    bound: Lanes,
    /// κ, λ, φ and d, and the integral to where adhesion begins.
    adhesion_x: Lanes,
    adhesion_y: Lanes,
    spin: Lanes,
    slip_length: Lanes,
    slip_integral: Lanes,
}

/// Integrals over each strip, over t.
#[derive(Clone, Copy, Debug, Default)]
struct Integrals {
    x: Lanes,
    y: Lanes,
    /// Of t p_y.
    moment: Lanes,
    slipping: Lanes,
}

/// Marches the strips of all lanes at once; `step` is the length of an element. Gives the tractions of FASTSIM, and those of
/// FaStrip less the closed form of [`StripTheory::adhesion`]: where the strip slips, and what is cut off where it adheres.
///
/// Compiled for several instruction sets, the widest one chosen at run time. No operation is fused or reordered,
/// so that all of them give the same bits.
#[multiversion(targets("x86_64+avx512f", "x86_64+avx2", "aarch64+neon"))]
fn march_strips(march: &March, elements: &[Element], step: f64) -> (Integrals, Integrals) {
    let (mut fastsim, mut behind) = (Integrals::default(), Integrals::default());
    let (mut px, mut py) = ([0.0; LANES], [0.0; LANES]);
    let mut length = 0.5;
    for element in elements {
        let [rear, front] = element.integral;
        let mean = (front - rear) / step;
        for lane in 0..LANES {
            let bound = march.bound[lane];
            let twist = element.step_middle * march.step_y_per_abscissa[lane];
            let trial_x = px[lane] + length * march.step_x[lane];
            let trial_y = py[lane] + length * (march.step_y[lane] + twist);
            let magnitude = (trial_x * trial_x + trial_y * trial_y).sqrt();
            let size = magnitude.max(f64::MIN_POSITIVE);
            let scale = (bound * mean / size).min(1.0);
            px[lane] = trial_x * scale;
            py[lane] = trial_y * scale;
            fastsim.x[lane] += step * px[lane];
            fastsim.y[lane] += step * py[lane];
            fastsim.moment[lane] += step * element.middle * py[lane];
            fastsim.slipping[lane] += if scale < 1.0 { step } else { 0.0 };
            // Behind the place where adhesion begins.
            let limit = bound * (front.min(march.slip_integral[lane]) - rear).max(0.0) / size;
            // In front of it: what strip theory has beyond the bound.
            let d = march.slip_length[lane];
            let (from_middle, half) = (element.middle - d, 1.0 - d);
            let inner = (half * half - from_middle * from_middle).max(0.0).sqrt();
            let difference = element.height - inner;
            let stick_x = march.adhesion_x[lane] * difference;
            let stick_y = march.adhesion_y[lane] * difference + march.spin[lane] * inner;
            let size = (stick_x * stick_x + stick_y * stick_y).sqrt().max(f64::MIN_POSITIVE);
            let share = ((element.middle + 1.0 - 2.0 * d) / step + 0.5).clamp(0.0, 1.0);
            let cut = bound * share * step * ((element.height / size).min(1.0) - 1.0);
            let y = limit * trial_y + cut * stick_y;
            behind.x[lane] += limit * trial_x + cut * stick_x;
            behind.y[lane] += y;
            behind.moment[lane] += element.middle * y;
        }
        length = 1.0;
    }
    (fastsim, behind)
}
