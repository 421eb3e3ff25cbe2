//! Contact area from virtual penetration, semi-elliptical pressure along rolling.
//!
//! Source: Piotrowski and Kik, Vehicle System Dynamics 46 (2008) 27-48, sections 2.2 and 2.3. With
//! the separation f(y) from the contact point, the approach δ and the radius R of the normal
//! section along x
//!
//! ```text
//! g(y) = max(0, δ0 - f(y)), δ0 = ε δ            x_l(y) = sqrt(2 R g(y))                       (7), (8)
//! p(x, y) = (p0 / x_l(0)) sqrt(x_l(y)² - x²)                                                   (9)
//! N = π E* δ I1 / I2,  p0 = N x_l(0) / I1                                                     (12), (13)
//! I1 = ∬ sqrt(x_l² - x²) dx dy = π R ∫ g dy
//! I2 = ∬ sqrt((x_l² - x²) / (x² + y²)) dx dy = ∫ 2 s (K(m) - E(m)) dy, s² = x_l² + y², m = x_l²/s²
//! ```
//!
//! The displacement of the half-space equals the approach at one point, the contact point, which is
//! that of least separation. All zones with g > 0 belong to one half-space and act on this point.
//! With a [`ShapeFit`] the area gets the ratio of length to width of a Hertzian ellipse before its
//! pressure is found.
//!
//! **Pressure and force.** [`solve`] computes p0/x_l(0) = π E* δ/I2, `scale` in the code: times the
//! half length it is the pressure of a strip. N is the sum over the strips of each zone
//! (`Strips::summarise`), which is the formula above with I1 as a sum.
//!
//! # How the integral I2 is evaluated
//!
//! **Sum over strips.** The strips are the nodes u_j of a Gauss-Legendre rule in the parameter u of
//! the contact line, with the weights w_j. For I2 they are taken as centred above the contact
//! point, also on a yawed wheel.
//!
//! **Singularity.** The integrand has a logarithmic singularity at the contact point u_c. The rule
//! integrates this logarithm with an error that is known in closed form (`logarithm_error`), and
//! the sum is corrected by it:
//!
//! ```text
//! I2 = Σ w_j y'(u_j) 2 s_j (K - E)_j + x_l(0) y'(u_c) (Σ w_j ln((u_j - u_c)²) - ∫ ln((u - u_c)²) du)
//! ```
//!
//! The correction needs the outline at u_c only. So it also holds where the outline of a yawed
//! wheel folds: there y(u) turns back, and the widths do not add up to the distance of the edges.
//!
//! **Lower bound.** Each strip gives at least
//!
//! ```text
//! ∫ sqrt((x_l² - x²)/(x² + y²)) dx ≥ π x_l²/(2 s)   and hence   N ≤ π E* δ max(s)
//! ```
//!
//! Where an outline has a kink between two strips the corrected sum may be less than the sum of
//! these bounds; the larger of the two is used.

use super::shape_correction::{self, ShapeFit};
use super::zones::{Edge, for_each_zone};
use super::{NormalProblem, Strips, Zone};
use crate::geometry::contacts::separation::{FrameSeparation, Probe, SeparationPoint};
use crate::leaves::{CONTACT_MODULUS, VIRTUAL_PENETRATION};
use crate::math::elliptic::first_minus_second_split;
use crate::math::quadrature::GaussLegendre;
use crate::math::real::Real;
use crate::math::vectors::with_vectors;

/// Solves for the zones of one contact frame; `virtual_penetration` is ε, 0 < ε < 1; `shape`
/// corrects the shape of the contact area where it is given.
///
/// Returns the number of zones that found no room in `strips` (they are left out of the load).
pub fn solve<T: Real>(
    problem: &NormalProblem<T>,
    virtual_penetration: f64,
    shape: Option<ShapeFit>,
    separation: &mut impl FrameSeparation<T>,
    probes: &[Probe],
    strips: &mut Strips<T>,
) -> usize {
    let depth = problem.approach.times(virtual_penetration, VIRTUAL_PENETRATION);
    let mut longest = (problem.radius * 2.0 * depth).sqrt();
    let mut left_out = 0;
    // Without the contact point in a zone (it is the deepest place of the probes) there is no load.
    let mut load_integral = T::from(0.0);
    let mut rule_error = T::from(0.0);
    let contact_dy = separation.point(problem.contact_u).dy;
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
        // The strips straddle the deepest place: its depth is exact where the separation was
        // probed.
        let inside = probes.iter().filter(|p| edge.left < p.u && edge.right > p.u);
        if let Some(lowest) = inside.min_by(|a, b| a.f.total_cmp(&b.f))
            && depth - lowest.f > deepest
        {
            deepest = depth - separation.minimum(lowest);
        }
        let length = (problem.radius * 2.0 * deepest).sqrt() * 2.0;
        let zone = Zone { first, count, length, ..Zone::default() };
        let least = longest * MIN_DISTANCE / contact_dy;
        rule_error += logarithm_error(problem.rule, &edge, problem.contact_u, least);
        // Where the outline folds, edges may lie in the wrong order; what turns back is not loaded.
        let loaded = (first..first + count).filter(|&j| strips.half_length[j] > 0.0);
        let width = loaded.map(|j| strips.width[j]).sum();
        strips.zones.push(Zone { width, ..zone });
    });
    let uncorrected = longest;
    if let Some(fit) = shape {
        longest *= shape_correction::apply(fit, longest * 2.0, problem.rule, separation, strips);
    }
    let [sum, least] = influence(&strips.half_length, &strips.y, &strips.width, longest);
    // The singularity is -L ln(y²) dy; a correction of the shape leaves the product of its length
    // and width.
    let displacement_integral = (sum + uncorrected * contact_dy * rule_error).max(least);
    // p = scale · sqrt(x_l² - x²)
    let scale = if displacement_integral > 0.0 && load_integral > 0.0 {
        problem.approach.scaled(std::f64::consts::PI * problem.contact_modulus, CONTACT_MODULUS)
            / displacement_integral
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

/// Sum over strips of width times the integrand of I2, 2 s (K - E), and of the least that it can
/// be.
///
/// The order of the sums is fixed by [`LANES`].
fn influence<T: Real>(half_lengths: &[T], ys: &[T], widths: &[T], longest: T) -> [T; 2] {
    with_vectors(
        #[inline(always)]
        || {
            let scale = T::from(1.0) / (longest * longest);
            let term = |half_length: T, y: T, width: T| {
                let y_squared = (y * y * scale).at_least(MIN_DISTANCE * MIN_DISTANCE);
                let a_squared = half_length * half_length * scale;
                let sum = a_squared + y_squared;
                let complement = y_squared / sum;
                let (regular, logarithmic) = first_minus_second_split(complement);
                let s = sum.sqrt();
                let width = width * longest;
                [
                    width * s * 2.0 * (regular - complement.normal_ln() * logarithmic),
                    width * a_squared * std::f64::consts::FRAC_PI_2 / s,
                ]
            };
            let mut sums = [[T::from(0.0); LANES]; 2];
            let blocks = half_lengths.chunks_exact(LANES);
            let rest = half_lengths.len() - blocks.remainder().len();
            for ((a, y), w) in blocks.zip(ys.chunks_exact(LANES)).zip(widths.chunks_exact(LANES)) {
                for lane in 0..LANES {
                    let [own, least] = term(a[lane], y[lane], w[lane]);
                    sums[0][lane] += own;
                    sums[1][lane] += least;
                }
            }
            for j in rest..half_lengths.len() {
                let [own, least] = term(half_lengths[j], ys[j], widths[j]);
                sums[0][j - rest] += own;
                sums[1][j - rest] += least;
            }
            sums.map(|lanes| lanes.iter().copied().sum())
        },
    )
}

/// What the rule makes of ∫ ln((u - u_c)²) du over a zone, less the integral; nodes are no nearer
/// to u_c than `least` [m].
pub(super) fn logarithm_error<T: Real>(
    rule: &GaussLegendre,
    edge: &Edge<T>,
    contact_u: T,
    least: T,
) -> T {
    with_vectors(
        #[inline(always)]
        || {
            let (middle, half) = ((edge.left + edge.right) * 0.5, (edge.right - edge.left) * 0.5);
            // In units of half the zone, which the error is proportional to.
            let (contact, least) = ((contact_u - middle) / half, least / half);
            let least_squared = least * least;
            let term = |node: f64, weight: f64| {
                let away = contact - node;
                (away * away).max(least_squared).normal_ln() * weight
            };
            let mut sums = [T::from(0.0); LANES];
            let blocks = rule.nodes.chunks_exact(LANES);
            let rest = rule.nodes.len() - blocks.remainder().len();
            for (nodes, weights) in blocks.zip(rule.weights.chunks_exact(LANES)) {
                for lane in 0..LANES {
                    sums[lane] += term(nodes[lane], weights[lane]);
                }
            }
            for j in rest..rule.nodes.len() {
                sums[j - rest] += term(rule.nodes[j], rule.weights[j]);
            }
            let antiderivative = |t: T| {
                let size = t.abs();
                if size > 0.0 { t * 2.0 * (size.ln() - 1.0) } else { T::from(0.0) }
            };
            let exact = antiderivative(-contact + 1.0) - antiderivative(-contact - 1.0);
            half * (sums.iter().copied().sum::<T>() - exact)
        },
    )
}

/// Strips whose separation is looked up at once.
const POINTS: usize = 32;

/// Strips whose influence is summed at once.
const LANES: usize = 8;

/// Distance of a strip from the contact point, over the longest strip, below which it counts as
/// this: both logarithms stay finite [-].
pub(super) const MIN_DISTANCE: f64 = 1e-12;
