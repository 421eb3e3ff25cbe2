//! The equations of the strips.
//!
//! Unknowns are z at each node and χ at each knot. The load per width, over the contact modulus E*, is l = plus(z); what z is below zero is a gap:
//!
//! ```text
//! u(l, χ) - overlap - κ (plus(z) - z) = 0                                                   at each node
//! Σ_i h_k(i) ω_i (2 R (u(0) - u(0.7 a))/(0.7 a)² - 1) + penalty = 0,  ω_i = w_i l_i/L       for each knot k, with its hat h_k
//! ```
//!
//! so that the complementarity l ≥ 0, gap ≥ 0, l · gap = 0 is one smooth equation (a normal map: Robinson, Mathematics of Operations Research 17
//! (1992) 691). A panel with the load per width l, the half length a, a² = 2 l/(π c), and the width h displaces the node at a distance d by
//!
//! ```text
//! u = (2/π²) h l D(d/a)/a     in units of E*, both bodies together
//! ```

use std::f64::consts::PI;

use super::grid::{Grid, Node, Panel};
use super::influence::{Integrals, STATION, shifted_at};
use super::shape::Knots;
use crate::math::real::Real;
use crate::normal::hertz;

/// Half of the width of the corner of plus, over the load per width in the middle of an ellipse of the same depth and area of overlap: narrower corners take
/// Newton's method more steps and change nothing else.
const CORNER: f64 = 0.05;
/// Scale κ of what z is below zero: gap over depth for z over the load per width in the middle. Of the order of the influence of a
/// node on itself, so that one step leads over the corner from either side.
const GAP_SCALE: f64 = 0.3;
/// Least half length over that of the ellipse: panels that hardly carry load stay wider than nothing.
const LEAST_LENGTH: f64 = 0.02;
/// Range of the ratio of the curvatures of the ellipse.
const MOST_RATIO: f64 = 1e4;
/// (2/π²).
pub(super) const INFLUENCE: f64 = 2.0 / (PI * PI);

/// Sizes that the equations are scaled by, from the ellipse of the parabola with the same depth and area of overlap.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scales<T = f64> {
    /// Load per width in its middle [m].
    pub load: T,
    /// χ = ln of its pressure over half length [ln 1/m].
    pub shape: T,
    /// Overlap at its ends over that in the middle [-].
    pub level: T,
    /// Half width of the corner of plus [m].
    pub corner: T,
    /// κ [-].
    pub gap: T,
    /// Square of the least half length [m²].
    pub least_square: T,
    /// Its load, which the weights of the fall of the displacement refer to [m²].
    pub total: T,
}

impl<T: Real> Scales<T> {
    pub fn new(grid: &Grid<T>) -> Self {
        let along = T::from(0.5) / grid.radius;
        let half_width = grid.area / grid.depth * 0.75;
        let across = grid.depth / (half_width * half_width);
        let across = across.max(along / MOST_RATIO).min(along * MOST_RATIO);
        let ellipse = hertz::ellipse(along, across, grid.depth, 1.0);
        let (a, b) = (ellipse.semi_axis_along, ellipse.semi_axis_across);
        let load = ellipse.max_pressure * a * (0.5 * PI);
        Self {
            load,
            shape: (ellipse.max_pressure / a).ln(),
            level: -(across * b * b / grid.depth) + 1.0,
            corner: load * CORNER,
            gap: grid.depth / load * GAP_SCALE,
            least_square: a * a * (LEAST_LENGTH * LEAST_LENGTH),
            total: ellipse.load,
        }
    }
}

/// max(0, z), its corner rounded by a quartic within `corner` of it, and its derivative.
pub(super) fn plus<T: Real>(z: T, corner: T) -> [T; 2] {
    if z >= corner {
        return [z, T::from(1.0)];
    }
    if z <= -corner {
        return [T::from(0.0); 2];
    }
    let x = z / corner;
    let (up, square) = (x + 1.0, (x + 1.0) * (x + 1.0));
    [corner * square * up * (-x + 3.0) * (1.0 / 16.0), square * (-x + 2.0) * 0.25]
}

/// The strip that a load per width makes: half length and what it changes by.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Strip<T = f64> {
    /// Load per width [m].
    pub load: T,
    /// Half length [m].
    pub half_length: T,
    /// Derivative of the logarithm of the half length by the load per width [1/m]; by χ it is minus this times the load.
    pub length_by_load: T,
}

impl<T: Real> Strip<T> {
    pub fn new(load: T, shape: T, least_square: T) -> Self {
        let by_load = (-shape).exp() * (1.0 / PI);
        let square = load * by_load * 2.0 + least_square;
        Self { load, half_length: square.sqrt(), length_by_load: by_load / square }
    }
}

/// Fall of the displacement to the station of the strip at a node that the wheel wants: that of x²/(2 R) [m].
pub(super) fn wanted_fall<T: Real>(strip: &Strip<T>, node: &Node<T>) -> T {
    strip.half_length * strip.half_length * (0.5 * STATION * STATION) / node.radius
}

/// Influence of a panel on a node per load per width: (2/π²) h cos of the angle between their normals.
pub(super) fn factor<T: Real>(node: &Node<T>, panel: &Panel<T>) -> T {
    let ([a, b], [c, d]) = (node.place.tangent, panel.tangent);
    (a * c + b * d).at_least(0.0) * panel.width * INFLUENCE
}

/// Displacement of a node by a panel per (2/π²) h and load per width, and its derivative by the logarithm of the half length of the panel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Displacement<T = f64> {
    pub value: T,
    pub by_panel: T,
}

/// How much less that is at the station of the node's own half length, and its derivatives by the logarithms of the half lengths of the panel and of
/// the node.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fall<T = f64> {
    pub value: T,
    pub by_panel: T,
    pub by_node: T,
}

/// Both for a panel of half length `a` that ends at the node, whose half length is `length`: the mean over its width.
pub(super) fn touching<T: Real>(
    integrals: &Integrals,
    panel: &Panel<T>,
    a: T,
    length: T,
) -> (Displacement<T>, Fall<T>) {
    let inverse = T::from(1.0) / a;
    let sigma = panel.width * inverse;
    let [[displacement, d], [fall, w]] = integrals.at(sigma);
    let ratio = length * inverse;
    // The fall goes with the square of the station.
    let square = ratio * ratio * inverse;
    let mean = fall / sigma;
    (
        Displacement { value: displacement / sigma * inverse, by_panel: -(d * inverse) },
        Fall {
            value: square * mean,
            by_panel: -(square * (mean * 2.0 + w)),
            by_node: square * mean * 2.0,
        },
    )
}

impl<T: Real> Displacement<T> {
    /// From the influence `d` of a panel of half length 1/`inverse`, and `slope`, d(a D)/da.
    // Inside each instruction set or not at all: a call would not be vectorised.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn of(d: T, slope: T, inverse: T) -> Self {
        Self { value: d * inverse, by_panel: (slope - d * 2.0) * inverse }
    }
}

impl<T: Real> Fall<T> {
    /// From the influence `centre`, D and d(a D)/da, of a panel of half length 1/`inverse` at distances `along` and `across` for a node of half
    /// length `length`: the mean of the falls to both stations.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn shifted(centre: [T; 2], along: T, across: T, inverse: T, length: T) -> Self {
        let (xi, sigma, station) = (along * inverse, across * inverse, length * inverse * STATION);
        let [a, b] = [shifted_at(xi + station, sigma), shifted_at(xi - station, sigma)];
        let mean = |a: T, b: T| (a + b) * 0.5;
        let at = [mean(a.d, b.d), mean(a.slope, b.slope)];
        Self::of(centre, at, mean(a.along, -b.along) * station, inverse)
    }

    /// The same straight across, where both stations are alike.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn straight(centre: [T; 2], across: T, inverse: T, length: T) -> Self {
        let (sigma, station) = (across * inverse, length * inverse * STATION);
        let at = shifted_at(station, sigma);
        Self::of(centre, [at.d, at.slope], at.along * station, inverse)
    }

    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn of(centre: [T; 2], at: [T; 2], pull: T, inverse: T) -> Self {
        let [d, slope] = [centre[0] - at[0], centre[1] - at[1]];
        Self {
            value: d * inverse,
            by_panel: (slope - d * 2.0) * inverse,
            by_node: -(pull * inverse),
        }
    }
}

/// The residuals of all equations at `z` and `shape`, nodes first; with derivatives where the numbers have them.
pub(super) fn residuals<T: Real>(
    grid: &Grid<T>,
    integrals: &Integrals,
    knots: &Knots,
    z: &[T],
    shape: &[T],
    out: &mut Vec<T>,
) {
    let scales = Scales::new(grid);
    let n = grid.nodes.len();
    let zero = T::from(0.0);
    let loads: Vec<T> = z.iter().map(|&z| plus(z, scales.corner)[0]).collect();
    let shapes: Vec<T> = (0..n).map(|i| knots.value(i, shape)).collect();
    let strips: Vec<Option<Strip<T>>> = grid
        .panels
        .iter()
        .map(|panel| {
            let load = panel.sum(panel.shares, &loads);
            let shape = panel.sum(panel.shape_shares, &shapes);
            (load > 0.0 && panel.width > 0.0).then(|| Strip::new(load, shape, scales.least_square))
        })
        .collect();
    out.clear();
    out.resize(n + knots.count(), zero);
    for (i, node) in grid.nodes.iter().enumerate() {
        let own = Strip::new(loads[i], shapes[i], scales.least_square);
        let (mut displacement, mut fallen) = (zero, zero);
        for (panel, strip) in grid.panels.iter().zip(&strips) {
            let Some(strip) = strip else { continue };
            let (a, length) = (strip.half_length, own.half_length);
            let (own, fall) = if panel.touches == Some(i) {
                touching(integrals, panel, a, length)
            } else {
                let inverse = T::from(1.0) / a;
                let (along, across) = (node.place.x - panel.x, panel.distance(node.y));
                let at = shifted_at(along * inverse, across * inverse);
                let centre = [at.d, at.slope];
                (
                    Displacement::of(at.d, at.slope, inverse),
                    Fall::shifted(centre, along, across, inverse, length),
                )
            };
            let load = factor(node, panel) * strip.load;
            displacement += load * own.value;
            fallen += load * fall.value;
        }
        out[i] = (displacement - node.place.overlap - scales.gap * (loads[i] - z[i])) / grid.depth;
        if loads[i] > 0.0 {
            let wanted = wanted_fall(&own, node);
            let error = fallen / wanted - 1.0;
            let weight = node.width * loads[i] / scales.total;
            for (k, share) in knots.of(i) {
                out[n + k] += weight * error * share;
            }
        }
    }
    for k in 0..knots.count() {
        for (l, &shape) in shape.iter().enumerate() {
            out[n + k] += shape * knots.penalty(k, l);
        }
    }
}
