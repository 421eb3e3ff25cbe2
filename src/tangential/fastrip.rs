//! FaStrip: magnitude of the tractions from strip theory, their direction where they slip from
//! FASTSIM.
//!
//! Source: Sichani, Enblom and Berg (2016), in the form it has in CONTACT; on patches of any
//! outline each strip has the amplitude of its own pressure. With t = x/a_j along rolling, q the
//! pressure at the centre of the strip, a the semi-axis of the equivalent ellipse, and A, B, C the
//! growth of tractions along the strip ([`Growth`]), which hold creepages and Kalker's coefficients
//! together, the normalised slip of a strip is
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
//! and slips behind, where the traction is μ p in the direction that FASTSIM gives it. Where strip
//! theory exceeds μ p, as it may with spin, it is cut back to that. It has no solution for |φ| ≥ 1,
//! where spin alone makes the strip slip: from 0.85 to 0.98 it is blended into FASTSIM.
//!
//! Departure from the source: FASTSIM marches with the elliptic bound and, if asked for, blended
//! flexibilities. On 300 Hertzian ellipses the error with the elliptic bound and blended
//! flexibilities is 1.2 % of the friction limit in the mean and 3.7 % at 95 %; with three
//! flexibilities it is 1.8 and 6.8 %.

use std::f64::consts::PI;

use super::flexibility::ZoneFlexibility;
use super::rigid_slip::Growth;
use super::rule::Rule;
use super::{LoadedZone, Rolling, StripForce};
use crate::math::real::Real;
use crate::math::smooth_step::smooth_step;
use crate::math::vectors::with_vectors;

/// Normalised spin of a strip from which on FASTSIM takes over [-].
const SPIN_FROM: f64 = 0.85;
/// Normalised spin of a strip from which on it is FASTSIM alone [-].
const SPIN_TO: f64 = 0.98;

/// Strips that are marched together.
const LANES: usize = 32;
type Lanes<T> = [T; LANES];

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
fn ellipse_integral<T: Real>(t: T) -> T {
    (t * (-(t * t) + 1.0).at_least(0.0).sqrt() + t.asin()) * 0.5
}

impl Fastrip {
    /// `elements` ≥ 1 along each strip.
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
}

impl<T: Real> Rule<T> for Fastrip {
    /// Strip theory has the flexibilities `three`, the march of FASTSIM those of `blended`. The
    /// friction of `loaded` is above 0.
    fn strip_forces(
        &self,
        loaded: &LoadedZone<'_, T>,
        rolling: Rolling,
        three: &ZoneFlexibility<T>,
        blended: &ZoneFlexibility<T>,
        mut each: impl FnMut(usize, StripForce<T>),
    ) {
        let &LoadedZone { zone, strips, material, slip, .. } = loaded;
        let range = zone.range();
        let step = 2.0 / self.elements.len() as f64;
        let direction = rolling.direction();
        for start in range.clone().step_by(LANES) {
            let mut input = LaneInput::<T>::default();
            let mut theory = [StripTheory::<T>::default(); LANES];
            let lanes = (range.end - start).min(LANES);
            for (lane, own) in theory.iter_mut().enumerate().take(lanes) {
                let j = start + lane;
                let a = strips.half_length[j];
                let bound = loaded.friction_coefficient(j) * strips.pressure[j];
                if bound <= 0.0 || a <= 0.0 {
                    continue;
                }
                let growth = slip.growth(j, blended);
                input.bound[lane] = bound;
                input.step_x[lane] = a * -step * growth.longitudinal;
                input.step_y[lane] = a * -step * growth.lateral;
                input.step_y_per_abscissa[lane] = a * -step * direction * a * growth.twist;
                let growth = slip.growth(j, three);
                // However little the bound is, its inverse can be squared.
                let per_bound = (a / bound).at_most(1e60);
                let twist = three.semi_axis_along * direction * growth.twist;
                *own = StripTheory::new(&growth, twist, per_bound, material.poisson_ratio)
                    .on_strip(three.semi_axis_along / a);
                input.adhesion_x[lane] = own.kappa;
                input.adhesion_y[lane] = own.lambda;
                input.spin[lane] = own.spin;
                input.slip_length[lane] = own.slip_length;
                input.slip_integral[lane] = own.slip_integral;
            }
            let (fastsim, behind) = march_strips(&input, &self.elements, step);
            for (lane, own) in theory.iter().enumerate().take(lanes) {
                let j = start + lane;
                let a = strips.half_length[j];
                let [x, y, moment] = own.adhesion();
                let bound = input.bound[lane];
                // FASTSIM in the first place, strip theory in the second.
                let mix = |f: T, s: T| own.fastsim_share * f + (-own.fastsim_share + 1.0) * s;
                let area = strips.width[j] * a;
                let arm = a * direction;
                each(
                    j,
                    StripForce {
                        longitudinal: area * mix(fastsim.x[lane], behind.x[lane] + bound * x),
                        lateral: area * mix(fastsim.y[lane], behind.y[lane] + bound * y),
                        moment: area
                            * arm
                            * mix(fastsim.moment[lane], behind.moment[lane] + bound * moment),
                        slip_area: area * mix(fastsim.slipping[lane].into(), own.slip_length * 2.0),
                    },
                );
            }
        }
    }
}

/// Strip theory of one strip.
#[derive(Clone, Copy, Debug, Default)]
struct StripTheory<T> {
    /// κ.
    kappa: T,
    /// λ.
    lambda: T,
    /// φ.
    spin: T,
    /// d, at most 1: then the whole strip slips.
    slip_length: T,
    /// Integral of sqrt(1 - t²) from the centre of the strip to where adhesion begins.
    slip_integral: T,
    /// Share of FASTSIM in the tractions.
    fastsim_share: T,
}

impl<T: Real> StripTheory<T> {
    /// In terms of the zone: `slip_length` over the semi-axis a of the ellipse. `twist` is a C
    /// along rolling, `per_bound` a_j/(μ q).
    fn new(growth: &Growth<T>, twist: T, per_bound: T, poisson_ratio: T) -> Self {
        let plane = -poisson_ratio + 1.0;
        let k = per_bound * (plane * 16.0 / (3.0 * PI * PI));
        let (xi, eta) = (-k * growth.longitudinal, -k * growth.lateral);
        let spin = per_bound * (-3.0 / 8.0) * twist;
        let fading = ((spin.abs() - SPIN_FROM) / (SPIN_TO - SPIN_FROM)).within(0.0, 1.0);
        let spin = spin.within(-SPIN_TO, SPIN_TO);
        let rest = -(spin * spin) + 1.0;
        let slip = ((eta * eta + rest * xi * xi).sqrt() + eta * spin) / rest;
        // Without any slip both directions are 0/0, and multiply nothing.
        let slip = slip.at_least(f64::MIN_POSITIVE);
        Self {
            kappa: xi / slip,
            lambda: eta / slip + spin,
            spin,
            slip_length: slip / plane,
            slip_integral: T::from(0.0),
            fastsim_share: smooth_step(fading),
        }
    }

    /// The same over the half length of the strip; `semi_axes` is a/a_j.
    fn on_strip(self, semi_axes: T) -> Self {
        let slip_length = (self.slip_length * semi_axes).at_most(1.0);
        Self { slip_length, slip_integral: ellipse_integral(slip_length * 2.0 - 1.0), ..self }
    }

    /// Integrals over the adhesion area of p_x, p_y and t p_y, in units of μ q.
    fn adhesion(&self) -> [T; 3] {
        let d = self.slip_length;
        let height = -self.slip_integral + 0.25 * PI;
        let rest = -d + 1.0;
        let inner = rest * (0.5 * PI) * rest;
        // 1 - t² where adhesion begins is 4 d (1 - d).
        let (first, inner_first) = ((d * 4.0 * rest).three_halves() / 3.0, d * inner);
        let difference = height - inner;
        [
            self.kappa * difference,
            self.lambda * difference + self.spin * inner,
            self.lambda * (first - inner_first) + self.spin * inner_first,
        ]
    }
}

/// What the march of up to `LANES` strips needs.
#[derive(Clone, Copy, Debug, Default)]
struct LaneInput<T> {
    /// Traction increments of FASTSIM for each element.
    step_x: Lanes<T>,
    step_y: Lanes<T>,
    step_y_per_abscissa: Lanes<T>,
    /// μ q.
    bound: Lanes<T>,
    /// κ, λ, φ and d, and the integral to where adhesion begins.
    adhesion_x: Lanes<T>,
    adhesion_y: Lanes<T>,
    spin: Lanes<T>,
    slip_length: Lanes<T>,
    slip_integral: Lanes<T>,
}

/// Integrals over each strip, over t.
#[derive(Clone, Copy, Debug, Default)]
struct Integrals<T> {
    x: Lanes<T>,
    y: Lanes<T>,
    /// Of t p_y.
    moment: Lanes<T>,
    slipping: Lanes<f64>,
}

/// Marches the strips of all lanes at once; `step` is the length of an element. Gives the tractions
/// of FASTSIM, and those of FaStrip less the closed form of [`StripTheory::adhesion`]: where the
/// strip slips, and what is cut off where it adheres.
fn march_strips<T: Real>(
    input: &LaneInput<T>,
    elements: &[Element],
    step: f64,
) -> (Integrals<T>, Integrals<T>) {
    with_vectors(
        #[inline(always)]
        || {
            let (mut fastsim, mut behind) = (Integrals::<T>::default(), Integrals::<T>::default());
            let (mut px, mut py) = ([T::from(0.0); LANES], [T::from(0.0); LANES]);
            let mut length = 0.5;
            for element in elements {
                let [rear, front] = element.integral;
                let mean = (front - rear) / step;
                for lane in 0..LANES {
                    let bound = input.bound[lane];
                    let twist = input.step_y_per_abscissa[lane] * element.step_middle;
                    let trial_x = px[lane] + input.step_x[lane] * length;
                    let trial_y = py[lane] + (input.step_y[lane] + twist) * length;
                    let magnitude = (trial_x * trial_x + trial_y * trial_y).sqrt();
                    let size = magnitude.at_least(f64::MIN_POSITIVE);
                    let scale = (bound * mean / size).at_most(1.0);
                    px[lane] = trial_x * scale;
                    py[lane] = trial_y * scale;
                    fastsim.x[lane] += px[lane] * step;
                    fastsim.y[lane] += py[lane] * step;
                    fastsim.moment[lane] += py[lane] * (step * element.middle);
                    fastsim.slipping[lane] += if scale < 1.0 { step } else { 0.0 };
                    // Behind the place where adhesion begins.
                    let reach = input.slip_integral[lane].at_most(front);
                    let limit = bound * (reach - rear).at_least(0.0) / size;
                    // In front of it: what strip theory has beyond the bound.
                    let d = input.slip_length[lane];
                    let (from_middle, half) = (-d + element.middle, -d + 1.0);
                    let inner = (half * half - from_middle * from_middle).at_least(0.0).sqrt();
                    let difference = -inner + element.height;
                    let stick_x = input.adhesion_x[lane] * difference;
                    let stick_y = input.adhesion_y[lane] * difference + input.spin[lane] * inner;
                    let size =
                        (stick_x * stick_x + stick_y * stick_y).sqrt().at_least(f64::MIN_POSITIVE);
                    let share =
                        ((-(d * 2.0) + (element.middle + 1.0)) / step + 0.5).within(0.0, 1.0);
                    let excess = (T::from(element.height) / size).at_most(1.0) - 1.0;
                    let cut = bound * share * step * excess;
                    let y = limit * trial_y + cut * stick_y;
                    behind.x[lane] += limit * trial_x + cut * stick_x;
                    behind.y[lane] += y;
                    behind.moment[lane] += y * element.middle;
                }
                length = 1.0;
            }
            (fastsim, behind)
        },
    )
}
