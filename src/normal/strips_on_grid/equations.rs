//! The equations of the strips.
//!
//! Unknowns are z at each node and χ at each knot. Between nodes z is linear:
//!
//! ```text
//! u - overlap - K max(0, -z)^(3/2) = 0                                       at each node
//! Σ_i h_k(i) ω_i (2 R (u(0) - u(0.7 a))/(0.7 a)² - 1) + penalty = 0          for each knot k
//! l = max(0, z),   a² = (2/π) l e^-χ,   ω_i ~ w_i l_i^(3/2)
//! ```
//!
//! | symbol | quantity | unit |
//! |---|---|---|
//! | z | load per width over E* where positive; where negative a measure of the gap | m |
//! | l | load per width over E*, P/E* | m |
//! | χ | ln(c/E*), c the peak pressure of a strip over its half length | ln 1/m |
//! | a | half length of a strip | m |
//! | u, overlap | displacement of both bodies and overlap, along the normal of the node | m |
//! | K | gap over (-z)^(3/2), [`Scales::gap`] | m^-1/2 |
//! | R | radius of the normal section of the wheel along x | m |
//! | h_k | hat function: 1 at knot k, 0 at the others, linear in the number of the node between | - |
//! | w_i | half of the loaded parts of the two cells beside node i | m |
//! | ω_i | weight of node i, [`Scales::weight`] | - |
//! | penalty | on differences of χ between knots, for knots without load | - |
//!
//! So the complementarity l ≥ 0, gap ≥ 0, l · gap = 0 is one smooth equation (a normal map:
//! Robinson, Mathematics of Operations Research 17 (1992) 691), and the edges of contact are the
//! roots of z: beside an edge the load goes linearly and the gap with the power 3/2, and K is such
//! that z has no bend there on an ellipse. A source of the width b with l and a displaces a node at
//! the distance d by
//!
//! ```text
//! u = (2/π²) b l D(d/a)/a     both bodies together, D of `influence`
//! ```
//!
//! Sources are the points of [`RULE`] in the loaded parts of the two cells beside the node, and the
//! middles of all other cells. The slope of the load in these acts by its moment, with the half
//! length of the ellipse.

use std::f64::consts::PI;

use super::grid::{Cell, Grid, Node};
use super::influence::{Influence, STATION, centred_at, shifted_at};
use super::scales::Scales;
use super::shape::Knots;
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;

/// Points of a cell beside a node, from the node over the width of the cell, with their weights:
/// exact for 1, t, ln t and t ln t (Ma, Rokhlin and Wandzura, SIAM Journal on Numerical Analysis 33
/// (1996) 971).
pub(super) const RULE: [[f64; 2]; 2] =
    [[0.088_296_865_1, 0.298_499_89], [0.675_186_490_9, 0.701_500_11]];
/// (2/π²).
pub(super) const INFLUENCE: f64 = 2.0 / (PI * PI);

/// Half of the loaded parts of both cells beside a node with `own` z, its neighbours having the
/// `others` [m]; and its derivatives by all three.
pub(super) fn loaded_width<T: Real>(node: &Node<T>, own: T, others: [T; 2]) -> [T; 4] {
    let sides = [0, 1].map(|side| {
        let [_, part] = loaded_part(own, others[side]);
        let half = (node.reach[side] - node.y).abs() * 0.5;
        part.map(|part| part * half)
    });
    let [[one, by_own, by_one], [two, by_own_too, by_two]] = sides;
    [one + two, by_own + by_own_too, by_one, by_two]
}

/// The strip that a load per width makes: half length and what it changes by.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Strip<T = f64> {
    /// Load per width [m].
    pub load: T,
    /// Half length [m].
    pub half_length: T,
    /// Derivative of the logarithm of the half length by the load per width [1/m]; by χ it is minus
    /// this times the load.
    pub length_by_load: T,
}

impl<T: Real> Strip<T> {
    /// From its load per width and half length over pressure, 1/c [m].
    pub fn new(load: T, length_per_pressure: T, least_square: T) -> Self {
        let by_load = length_per_pressure * (1.0 / PI);
        let square = load * by_load * 2.0 + least_square;
        Self { load, half_length: square.sqrt(), length_by_load: by_load / square }
    }
}

/// Drop of displacement between the centre and the station of the strip at a node that the section
/// of the wheel requires: that of x²/(2 R) [m].
pub(super) fn required_drop<T: Real>(strip: &Strip<T>, node: &Node<T>) -> T {
    strip.half_length * strip.half_length * (0.5 * STATION * STATION) / node.radius
}

/// Where a source is, from a node, and how much it counts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair<T = f64> {
    /// Distances along and across [m].
    pub along: T,
    pub across: T,
    /// Influence per load per width: (2/π²) h cos of the angle between their normals [m].
    pub factor: T,
}

impl<T: Real> Pair<T> {
    /// Where it is if distances are `scale` times as large and the source counts with a share
    /// `part`.
    pub fn in_part(self, scale: T, part: T) -> Self {
        Self { along: self.along * scale, across: self.across * scale, factor: self.factor * part }
    }
}

/// A `cell` beside which the node (x, y, tangent) is not, as that sees it; and the displacement by
/// the slope of the load in the cell, per difference of its loads per width: its moment times the
/// derivative of the influence.
///
/// The latter is that of a cell of the half length `length`, as -σ ∂D/∂σ = 2/sqrt(1 + (4 σ/π)²):
/// right at both ends and 4 % off at most.
#[allow(clippy::inline_always)]
#[inline(always)]
pub(super) fn far_pair<T: Real>([x, y, a, b]: [T; 4], cell: &Cell<T>, length: T) -> (Pair<T>, T) {
    let away = y - cell.y;
    let [c, d] = cell.tangent;
    let factor = (a * c + b * d).at_least(0.0) * cell.width * INFLUENCE;
    let reach = (length * length + away * away * (16.0 / (PI * PI))).sqrt();
    let moment = factor * cell.width * (1.0 / 6.0) / (away * reach);
    (Pair { along: x - cell.x, across: cell.distance(away.abs(), length), factor }, moment)
}

/// Cosine of the angle between two normals.
fn cosine<T: Real>(one: &Node<T>, other: &Node<T>) -> T {
    let ([a, b], [c, d]) = (one.place.tangent, other.place.tangent);
    a * c + b * d
}

/// Point number `k` of the rule on a side of node `i`.
pub(super) fn near_pair<T: Real>(nodes: &[Node<T>], i: usize, side: usize, k: usize) -> Pair<T> {
    let node = &nodes[i];
    let [t, weight] = RULE[k];
    let width = (node.reach[side] - node.y).abs();
    let turn = node.neighbours[side].map_or(T::from(0.0), |j| (cosine(node, &nodes[j]) - 1.0) * t);
    Pair {
        along: (node.place.x - node.reach_x[side]) * t,
        across: width * t,
        factor: (turn + 1.0).at_least(0.0) * width * (weight * INFLUENCE),
    }
}

/// Displacement of a node by a source per factor and load per width, and its derivative by the
/// logarithm of the half length of the source.
#[derive(Clone, Copy, Debug)]
pub(super) struct Displacement<T = f64> {
    pub value: T,
    pub by_source: T,
}

/// How much less that is at the station of the node's own half length, and its derivatives by the
/// logarithms of the half lengths of the source and of the node.
#[derive(Clone, Copy, Debug)]
pub(super) struct DisplacementDrop<T = f64> {
    pub value: T,
    pub by_source: T,
    pub by_node: T,
}

impl<T: Real> Displacement<T> {
    /// From the influence of a source of half length 1/`inverse`.
    // Inside each instruction set or not at all: a call would not be vectorised.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn of([d, slope]: [T; 2], inverse: T) -> Self {
        Self { value: d * inverse, by_source: (slope - d * 2.0) * inverse }
    }
}

impl<T: Real> DisplacementDrop<T> {
    /// From the influence `centre`, D and d(a D)/da, of a source of half length 1/`inverse` at
    /// distances `along` and `across` for a node of half length `length`: the mean of the drops to
    /// both stations.
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
        let Influence { d, slope, along } = shifted_at(station, sigma);
        Self::of(centre, [d, slope], along * station, inverse)
    }

    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn of(centre: [T; 2], at: [T; 2], pull: T, inverse: T) -> Self {
        let [d, slope] = [centre[0] - at[0], centre[1] - at[1]];
        Self {
            value: d * inverse,
            by_source: (slope - d * 2.0) * inverse,
            by_node: -(pull * inverse),
        }
    }
}

/// Both of them for a `pair`.
fn influence<T: Real>(
    pair: &Pair<T>,
    half_length: T,
    length: T,
    is_skewed: bool,
) -> (Displacement<T>, DisplacementDrop<T>) {
    let inverse = T::from(1.0) / half_length;
    let (xi, sigma) = (pair.along * inverse, pair.across * inverse);
    let at = if is_skewed { shifted_at(xi, sigma) } else { centred_at(sigma) };
    let centre = [at.d, at.slope];
    let drop = if is_skewed {
        DisplacementDrop::shifted(centre, pair.along, pair.across, inverse, length)
    } else {
        DisplacementDrop::straight(centre, pair.across, inverse, length)
    };
    (Displacement::of(centre, inverse), drop)
}

/// The load of a cell: the positive part of the line between z at its ends.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct CellLoad<T = f64> {
    /// Its mean over the cell, and that weighted by itself, which the half length goes by [m].
    pub mean: T,
    pub weighted: T,
    /// Its first moment, as the difference of the ends of a line [m].
    pub moment: T,
    /// Derivatives of the three by z at both ends.
    pub slopes: [[T; 3]; 2],
}

impl<T: Real> CellLoad<T> {
    /// Of z at both ends.
    pub fn new([a, b]: [T; 2]) -> Self {
        let (zero, one) = (T::from(0.0), T::from(1.0));
        if a <= 0.0 && b <= 0.0 {
            return Self::default();
        }
        if a >= 0.0 && b >= 0.0 {
            let sum = a + b;
            let weighted = (a * a + a * b + b * b) / sum * (2.0 / 3.0);
            let slope = |own: T, other: T| ((own * 2.0 + other) * (2.0 / 3.0) - weighted) / sum;
            let half = T::from(0.5);
            let slopes = [[half, slope(a, b), -one], [half, slope(b, a), one]];
            return Self { mean: sum * 0.5, weighted, moment: b - a, slopes };
        }
        // One end carries load as far as the root.
        let (side, sign) = if a > b { (0, -1.0) } else { (1, 1.0) };
        let [own, other] = if side == 0 { [a, b] } else { [b, a] };
        let rate = one / (own - other);
        let t = own * rate;
        let by_own =
            [t * (-t * 0.5 + 1.0), T::from(2.0 / 3.0), t * (t * t * 4.0 - t * 9.0 + 6.0) * sign];
        let by_other = [t * t * 0.5, zero, t * t * (-(t * 4.0) + 3.0) * sign];
        Self {
            mean: own * t * 0.5,
            weighted: own * (2.0 / 3.0),
            moment: own * t * (-(t * 2.0) + 3.0) * sign,
            slopes: if side == 0 { [by_own, by_other] } else { [by_other, by_own] },
        }
    }
}

/// The part of a cell that carries load, from the node with `own` z to the one with `other`: where
/// it begins and how long it is, as shares of the cell, and the derivatives of both by both.
pub(super) fn loaded_part<T: Real>(own: T, other: T) -> [[T; 3]; 2] {
    let (zero, one) = (T::from(0.0), T::from(1.0));
    if own > 0.0 && other < 0.0 {
        let rate = one / (own - other);
        let t = own * rate;
        return [[zero; 3], [t, -other * rate * rate, t * rate]];
    }
    if own < 0.0 && other > 0.0 {
        let rate = one / (own - other);
        let (t, rest) = (own * rate, -other * rate);
        let (by_own, by_other) = (rest * rate, t * rate);
        return [[t, by_own, by_other], [rest, -by_own, -by_other]];
    }
    [[zero; 3], [one, zero, zero]]
}

/// 1/c in a cell with the loads and 1/c of the nodes `a` and `b`: their mean, weighted by the
/// squares of loads, so that a node without load does not count; and the weight of the first.
pub(super) fn length_per_pressure<T: Real>([load_a, a]: [T; 2], [load_b, b]: [T; 2]) -> [T; 2] {
    let (square_a, square_b) = (load_a * load_a, load_b * load_b);
    let sum = square_a + square_b;
    if sum > 0.0 {
        let share = square_a / sum;
        [b + (a - b) * share, share]
    } else {
        [a, T::from(1.0)]
    }
}

/// The residuals of all equations at `z` and `shape`, nodes first; with derivatives where the
/// numbers have them.
pub(super) fn residuals<T: Real>(
    grid: &Grid<T>,
    knots: &Knots,
    z: &[T],
    shape: &[T],
    per_pressure: &mut FixedVec<T>,
    out: &mut Vec<T>,
) {
    let scales = Scales::new(&grid.samples);
    let nodes = &grid.nodes;
    let n = nodes.len();
    let zero = T::from(0.0);
    let is_skewed = T::HAS_SLOPES || grid.is_skewed();
    per_pressure.clear();
    per_pressure.extend(nodes.iter().map(|node| (-node.between.value(shape)).exp()));
    out.clear();
    out.resize(n + knots.count(), zero);
    let end = |node: Option<usize>| node.map_or(-scales.load, |j| z[j]);
    let of =
        |node: Option<usize>| node.map_or([zero, zero], |j| [z[j].at_least(0.0), per_pressure[j]]);
    for (i, node) in nodes.iter().enumerate() {
        let own = Strip::new(z[i].at_least(0.0), per_pressure[i], scales.least_square);
        let length = own.half_length;
        let (mut displacement, mut total_drop, mut moments) = (zero, zero, zero);
        let mut add = |pair: &Pair<T>, load: T, half_length: T| {
            if load > 0.0 {
                let (own, drop) = influence(pair, half_length, length, is_skewed);
                displacement += pair.factor * load * own.value;
                total_drop += pair.factor * load * drop.value;
            }
        };
        let [c, d] = node.place.tangent;
        let is_away = |cell: &&Cell<T>| cell.width > 0.0 && !cell.nodes.contains(&Some(i));
        for cell in grid.cells.iter().filter(is_away) {
            let (pair, moment) = far_pair([node.place.x, node.y, c, d], cell, scales.length);
            let load = CellLoad::new(cell.nodes.map(end));
            moments += moment * load.moment;
            let [per_pressure, _] = length_per_pressure(of(cell.nodes[0]), of(cell.nodes[1]));
            let strip = Strip::new(load.weighted, per_pressure, scales.least_square);
            add(&pair, load.mean, strip.half_length);
        }
        for side in [0, 1] {
            let beside = node.neighbours[side];
            let [[from, ..], [part, ..]] = loaded_part(z[i], end(beside));
            let [[own, _], [other, _]] = [of(Some(i)), of(beside)];
            let [per_pressure, _] = length_per_pressure(of(Some(i)), of(beside));
            for (k, [t, _]) in RULE.into_iter().enumerate() {
                let pair = near_pair(nodes, i, side, k).in_part((from + part * t) / t, part);
                let load = own + (other - own) * t;
                add(&pair, load, Strip::new(load, per_pressure, scales.least_square).half_length);
            }
        }
        let below = (-z[i]).at_least(0.0);
        out[i] = (displacement + moments - node.place.overlap - scales.gap * below.three_halves())
            / grid.samples.depth;
        if z[i] > 0.0 {
            let error = total_drop / required_drop(&own, node) - 1.0;
            let [width, ..] = loaded_width(node, z[i], node.neighbours.map(end));
            for (k, share) in node.between.weights() {
                out[n + k] += scales.weight(width, z[i]) * error * share;
            }
        }
    }
    for k in 0..knots.count() {
        for (l, &shape) in shape.iter().enumerate() {
            out[n + k] += shape * knots.penalty(k, l);
        }
    }
}
