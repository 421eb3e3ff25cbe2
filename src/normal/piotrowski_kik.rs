//! Contact area from virtual penetration, semi-elliptical pressure along rolling.
//!
//! Source: Piotrowski and Kik, Vehicle System Dynamics 46 (2008) 27-48, sections 2.2 and 2.3. With the separation
//! f(y) from the contact point, the approach δ and the radius R of the normal section along x
//!
//! ```text
//! g(y) = max(0, δ0 - f(y)), δ0 = ε δ            x_l(y) = sqrt(2 R g(y))                       (7), (8)
//! p(x, y) = (p0 / x_l(0)) sqrt(x_l(y)² - x²)                                                   (9)
//! N = π E* δ I1 / I2,  p0 = N x_l(0) / I1                                                     (12), (13)
//! I1 = ∬ sqrt(x_l² - x²) dx dy = π R ∫ g dy
//! I2 = ∬ sqrt((x_l² - x²) / (x² + y²)) dx dy = ∫ 2 s (K(m) - E(m)) dy, s² = x_l² + y², m = x_l²/s²
//! ```
//!
//! All zones with g > 0 belong to one half-space and to the one contact point at which the displacement meets the
//! approach. For the influence on that point strips are taken as centred above it, also on a yawed wheel. With a
//! [`ShapeFit`] the area gets the ratio of length to width of a Hertzian ellipse before its pressure is found.

use multiversion::multiversion;

use super::shape_correction::{self, ShapeFit};
use super::zones::for_each_zone;
use super::{NormalProblem, Strips, Zone};
use crate::geometry::separation::{FrameSeparation, Probe, SeparationPoint};
use crate::math::dual::Dual;
use crate::math::elliptic::first_minus_second_split;
use crate::math::quadrature::GaussLegendre;
use crate::math::real::Real;

/// Solves for the zones of one contact frame; `virtual_penetration` is ε, 0 < ε < 1; `shape` corrects the shape of the
/// contact area where it is given.
///
/// Returns the number of zones that found no room in `strips` (they are left out of the load).
pub fn solve<T: Influence>(
    problem: &NormalProblem<T>,
    virtual_penetration: f64,
    shape: Option<ShapeFit>,
    separation: &mut impl FrameSeparation<T>,
    probes: &[Probe],
    strips: &mut Strips<T>,
) -> usize {
    let depth = problem.approach * virtual_penetration;
    let mut longest = (problem.radius * 2.0 * depth).sqrt();
    let mut left_out = 0;
    // Without the contact point in a zone (it is the deepest place of the probes) there is no load.
    let mut load_integral = T::from(0.0);
    for_each_zone(separation, probes, depth, |separation, edge| {
        let count = problem.rule.nodes.len();
        if !strips.has_room_for(count) {
            left_out += 1;
            return;
        }
        let first = strips.y.len();
        let (middle, half) = ((edge.left + edge.right) * 0.5, (edge.right - edge.left) * 0.5);
        strips.u.extend(problem.rule.nodes.iter().map(|node| middle + half * *node));
        let mut deepest = T::from(0.0);
        let mut points = [SeparationPoint::default(); POINTS];
        for (index, weights) in problem.rule.weights.chunks(POINTS).enumerate() {
            let points = &mut points[..weights.len()];
            let begin = first + index * POINTS;
            separation.points(&strips.u[begin..begin + points.len()], points);
            for (at, weight) in points.iter().zip(weights) {
                let g = (depth - at.f).at_least(0.0);
                let width = half * *weight * at.dy;
                let half_length = (problem.radius * 2.0 * g).sqrt();
                load_integral += problem.radius * std::f64::consts::PI * g * width;
                deepest = deepest.max(g);
                strips.width.push(width);
                strips.half_length.push(half_length);
                strips.pressure.push(half_length);
            }
            strips.y.extend(points.iter().map(|at| at.y));
            strips.x.extend(points.iter().map(|at| at.x));
        }
        // The strips straddle the deepest place: its depth is exact where the separation was probed.
        let inside = probes.iter().filter(|p| edge.left < p.u && edge.right > p.u);
        if let Some(lowest) = inside.min_by(|a, b| a.f.total_cmp(&b.f)) {
            if depth - lowest.f > deepest {
                deepest = depth - separation.minimum(lowest);
            }
            deepest = deepest.min(depth);
        }
        let length = (problem.radius * 2.0 * deepest).sqrt() * 2.0;
        let zone = Zone { first, count, length, ..Zone::default() };
        let [left, right] = edges(&zone, strips, problem.rule);
        strips.zones.push(Zone { width: right - left, ..zone });
    });
    if let Some(fit) = shape {
        longest *= shape_correction::apply(fit, longest * 2.0, problem.rule, separation, strips);
    }
    let mut displacement_integral = T::from(0.0);
    for zone in strips.zones.iter() {
        let range = zone.first..zone.first + zone.count;
        displacement_integral += T::regular_influence(
            &strips.half_length[range.clone()],
            &strips.y[range.clone()],
            &strips.width[range],
            longest,
        );
        let [left, right] = edges(zone, strips, problem.rule);
        displacement_integral += singular_influence(left, right, longest);
    }
    // p = scale · sqrt(x_l² - x²)
    let scale = if displacement_integral > 0.0 && load_integral > 0.0 {
        problem.approach * (std::f64::consts::PI * problem.contact_modulus) / displacement_integral
    } else {
        // Zones without width at the limit of what is resolved; they count as left out.
        left_out += strips.zones.len();
        T::from(0.0)
    };
    for pressure in strips.pressure.iter_mut() {
        *pressure *= scale;
    }
    for i in 0..strips.zones.len() {
        let mut zone = strips.zones[i];
        zone.max_pressure = zone.length * 0.5 * scale;
        strips.summarise(&mut zone);
        strips.zones[i] = zone;
    }
    left_out
}

/// Left and right edge of a zone [m]: from the outermost strips, a few micrometres away, they are reached along the tangent.
pub(super) fn edges<T: Real>(zone: &Zone<T>, strips: &Strips<T>, rule: &GaussLegendre) -> [T; 2] {
    let last = zone.count - 1;
    [(0, -1.0), (last, 1.0)].map(|(i, end)| {
        let j = zone.first + i;
        strips.y[j] + strips.width[j] * (end - rule.nodes[i]) / rule.weights[i]
    })
}

/// Sum over strips of width times the integrand of I2, 2 s (K - E), plus `longest`·ln(y²/longest²): what is left is smooth enough
/// for Gauss-Legendre.
///
/// The order of the sums is fixed by [`LANES`].
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
fn regular_influence<T: Real>(half_lengths: &[T], ys: &[T], widths: &[T], longest: T) -> T {
    let scale = T::from(1.0) / (longest * longest);
    let term = |half_length: T, y: T, width: T| {
        // The logarithm is kept finite; at y = 0 its two occurrences cancel.
        let y_squared = (y * y * scale).at_least(1e-24);
        let sum = half_length * half_length * scale + y_squared;
        let (regular, logarithmic) = first_minus_second_split(y_squared / sum);
        let (log_y, log_sum) = (y_squared.normal_ln(), sum.normal_ln());
        width * longest * (sum.sqrt() * 2.0 * (regular - (log_y - log_sum) * logarithmic) + log_y)
    };
    let mut sums = [T::from(0.0); LANES];
    let blocks = half_lengths.chunks_exact(LANES);
    let rest = half_lengths.len() - blocks.remainder().len();
    for ((a, y), w) in blocks.zip(ys.chunks_exact(LANES)).zip(widths.chunks_exact(LANES)) {
        for lane in 0..LANES {
            sums[lane] += term(a[lane], y[lane], w[lane]);
        }
    }
    for j in rest..half_lengths.len() {
        sums[j - rest] += term(half_lengths[j], ys[j], widths[j]);
    }
    sums.iter().copied().sum()
}

/// Numbers over which the influence of strips is summed.
pub trait Influence: Real {
    /// See `regular_influence`.
    fn regular_influence(
        half_lengths: &[Self],
        ys: &[Self],
        widths: &[Self],
        longest: Self,
    ) -> Self {
        regular_influence(half_lengths, ys, widths, longest)
    }
}

impl<const N: usize> Influence for Dual<N> {}

impl Influence for f64 {
    fn regular_influence(half_lengths: &[f64], ys: &[f64], widths: &[f64], longest: f64) -> f64 {
        fast_influence(half_lengths, ys, widths, longest)
    }
}

/// Compiled for several instruction sets, the widest one chosen at run time; all of them give the same bits.
#[multiversion(targets("x86_64+avx512f+avx512dq", "x86_64+avx2", "aarch64+neon"))]
fn fast_influence(half_lengths: &[f64], ys: &[f64], widths: &[f64], longest: f64) -> f64 {
    regular_influence(half_lengths, ys, widths, longest)
}

/// Strips whose separation is looked up at once.
const POINTS: usize = 32;

/// Strips whose influence is summed at once.
const LANES: usize = 8;

/// -longest · ∫ ln(y²/longest²) dy from `left` to `right`: what [`regular_influence`] has taken out.
fn singular_influence<T: Real>(left: T, right: T, longest: T) -> T {
    let antiderivative = |y: T| {
        let t = y.abs() / longest;
        if t > 0.0 { y * 2.0 * (t.ln() - 1.0) } else { T::from(0.0) }
    };
    -longest * (antiderivative(right) - antiderivative(left))
}
