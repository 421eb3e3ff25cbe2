//! Loaded zones out of the loads of the nodes.
//!
//! A zone is a run of nodes that carry load. Pressure and half length follow from the load per width
//! l less a quarter of what a mean over hats takes from it, so that neighbours do not alternate.
//!
//! The field χ is too stiff to give each strip its best length, in saddles between lobes above all.
//! At the best one the energy rests when the length of that strip alone changes: the displacement
//! is as curved along the strip, in the mean, as the wheel is. From the curvature q of the
//! displacement over that of the wheel a strip gets a χ of its own,
//!
//! ```text
//! χ - v/sqrt(1 + v²),  v = 2.75 (q - 1),      q_i = -(8 R_i/π) Σ_j w_j l_j ∂K_ij/∂(a_i²)
//! ```
//!
//! A longer strip is less curved: q falls by 0.4 to 0.8 times as much as a² grows, which calls for
//! 1/0.55 (q - 1), and half as much again as the strips beside it grow too. No χ changes by more
//! than 1, as q says little of strips that have hardly any load. Loads stay as they are: they are
//! right to second order.
//!
//! An edge lies where the parabola ends that has the load per width l and its slope l' of the node
//! before the outermost one, and the load L that is left beyond that node,
//!
//! ```text
//! 2/3 l t + l' t²/6 = L
//! ```
//!
//! t from that node on. Nodes at edges have less load than the ellipse there, which puts it h 0.17 (1 -
//! r)⁴ further out, r the load per width of the outermost node over that of the one before it, h the
//! width of the panel: fitted to ellipses of a/b 0.06 to 16. It lies no further out than the next node
//! but for that, and at least h r: over a panel falls no more load than the node before has.

use std::f64::consts::{FRAC_PI_2, PI};

use super::lattice::{Lattice, Node};
use super::scales::Scales;
use super::shape::Knots;
use crate::leaves::CONTACT_MODULUS;
use crate::math::fixed_vec::FixedVec;
use crate::math::real::{Function, Real};
use crate::normal::{LoadedStrip, Strips, Zone};

/// Share of the mean over hats in the load per width that lengths and pressures are taken from.
const SMOOTHING: f64 = 0.25;
/// What χ of a strip's own changes by the curvature of the displacement over that of the wheel.
const OWN_SHAPE: f64 = 2.75;
/// What an edge lies further out, over the width of the panel, than the parabola of its load says,
/// where the outermost node has no load.
const EDGE: f64 = 0.17;
/// Nodes and weights of Gauss and Legendre on [0, 1].
const GAUSS: [[f64; 2]; 4] = [
    [0.069_431_844_202_973_71, 0.173_927_422_568_726_93],
    [0.330_009_478_207_571_87, 0.326_072_577_431_273_07],
    [0.669_990_521_792_428_1, 0.326_072_577_431_273_07],
    [0.930_568_155_797_026_3, 0.173_927_422_568_726_93],
];

/// Memory of what is read off.
#[derive(Clone, Debug)]
pub(super) struct Zones<T = f64> {
    /// Load per width over E*, and the same smoothed [m].
    load: FixedVec<T>,
    smooth: FixedVec<T>,
    /// Square of the half length over the smoothed load per width [m].
    square_over_load: FixedVec<T>,
    /// Coordinates across and squares of half lengths of the zone under way, with its edges.
    outline: FixedVec<[T; 2]>,
    /// Slopes of the curve through them.
    slopes: FixedVec<T>,
}

impl<T: Real> Zones<T> {
    pub fn new(most: usize) -> Self {
        Self {
            load: FixedVec::new(most),
            smooth: FixedVec::new(most),
            square_over_load: FixedVec::new(most),
            outline: FixedVec::new(most + 2),
            slopes: FixedVec::new(most + 2),
        }
    }

    /// Hands runs of loaded nodes over as the strips of a zone each. A `solution` is the loads of the
    /// nodes over that of the ellipse [m], χ at the knots, and the curvatures of the displacement
    /// along the nodes over that of the wheel [-]. Returns the number of zones that found no room.
    pub fn emit(
        &mut self,
        lattice: &Lattice<T>,
        scales: &Scales<T>,
        knots: &Knots<T>,
        solution: [&[T]; 3],
        contact_modulus: f64,
        strips: &mut Strips<T>,
    ) -> usize {
        let loads = solution[0];
        self.take(lattice, scales, knots, solution);
        let nodes = &lattice.nodes;
        let mut left_out = 0;
        let mut end = 0;
        while end < nodes.len() {
            let begin = end;
            end += 1;
            // Not a number is no load.
            let is_loaded = loads[begin] > 0.0;
            if !is_loaded {
                continue;
            }
            while end < nodes.len()
                && loads[end] > 0.0
                && nodes[end].interval == nodes[begin].interval
            {
                end += 1;
            }
            if !strips.has_room_for(end - begin) {
                left_out += 1;
                continue;
            }
            let mut zone: Zone<T> =
                Zone { first: strips.y.len(), count: end - begin, ..Zone::default() };
            for i in begin..end {
                // By its own load: a strip comes in without length.
                let half_length = (self.load[i] * self.square_over_load[i]).sqrt();
                let pressure = (self.load[i] / half_length)
                    .scaled(2.0 / PI * contact_modulus, CONTACT_MODULUS);
                let Node { y, width, x, u, .. } = nodes[i];
                strips.push(LoadedStrip { y, width, x, half_length, pressure, u });
            }
            strips.summarise(&mut zone);
            zone.off = self.mean_off(nodes, begin, end);
            let edges = self.edges(nodes, begin, end);
            zone.width = edges[1] - edges[0];
            zone.beyond = [nodes[begin].y - edges[0], edges[1] - nodes[end - 1].y];
            zone.length = self.length(nodes, begin, end, edges);
            let max_pressure = self.max_pressure(nodes, begin, end, edges);
            zone.max_pressure = max_pressure.scaled(contact_modulus, CONTACT_MODULUS);
            zone.area = self.area(nodes, begin, end, edges);
            strips.zones.push(zone);
        }
        left_out
    }

    /// Loads per width of all nodes.
    fn take(
        &mut self,
        lattice: &Lattice<T>,
        scales: &Scales<T>,
        knots: &Knots<T>,
        [loads, shape, curvatures]: [&[T]; 3],
    ) {
        let nodes = &lattice.nodes;
        self.load.clear();
        self.smooth.clear();
        self.square_over_load.clear();
        self.load
            .extend(nodes.iter().zip(loads).map(|(node, &load)| load * scales.load / node.width));
        for (i, &load) in self.load.iter().enumerate() {
            let is_loaded = load > 0.0;
            if !is_loaded {
                // Nothing is read off there.
                self.smooth.push(load);
                self.square_over_load.push(load);
                continue;
            }
            let mean = lattice.mean_over_hats(i, loads) * scales.load;
            self.smooth.push(load + (mean - load) * SMOOTHING);
            let shape = knots.value(i, shape) + own_shape(curvatures[i]);
            self.square_over_load.push((-shape).exp() * scales.square_over_load);
        }
    }

    /// How far the load of the nodes from `begin` to `end` is off the line of greatest overlap along
    /// the track [m].
    fn mean_off(&self, nodes: &[Node<T>], begin: usize, end: usize) -> T {
        let (mut sum, mut all) = (T::from(0.0), T::from(0.0));
        for (node, &load) in nodes[begin..end].iter().zip(&self.load[begin..end]) {
            let load = load * node.width;
            sum += load * node.off;
            all += load;
        }
        sum / all
    }

    /// Square of the half length of node `i` [m²].
    fn length_square(&self, i: usize) -> T {
        self.square_over_load[i] * self.smooth[i]
    }

    /// Square of the greatest pressure of node `i` over E*.
    fn pressure_square(&self, i: usize) -> T {
        self.smooth[i] / self.square_over_load[i] * (4.0 / (PI * PI))
    }

    /// Length of the longest strip of the nodes from `begin` to `end`: the top of a smooth curve
    /// through the squares of half lengths, which is a parabola on ellipses.
    fn length(&mut self, nodes: &[Node<T>], begin: usize, end: usize, edges: [T; 2]) -> T {
        self.top_of(nodes, begin, end, edges, Self::length_square).sqrt() * 2.0
    }

    /// Greatest pressure over the contact modulus of the nodes from `begin` to `end`: the top of a
    /// smooth curve through its squares, which is a parabola on ellipses.
    fn max_pressure(&mut self, nodes: &[Node<T>], begin: usize, end: usize, edges: [T; 2]) -> T {
        self.top_of(nodes, begin, end, edges, Self::pressure_square).sqrt()
    }

    /// Top of a smooth curve through the `heights` of the nodes from `begin` to `end`, which is zero
    /// at the edges.
    fn top_of(
        &mut self,
        nodes: &[Node<T>],
        begin: usize,
        end: usize,
        [low, high]: [T; 2],
        height: impl Fn(&Self, usize) -> T,
    ) -> T {
        let zero = T::from(0.0);
        self.outline.clear();
        self.outline.push([low, zero]);
        for (i, node) in nodes.iter().enumerate().take(end).skip(begin) {
            let height = height(self, i);
            self.outline.push([node.y, height]);
        }
        self.outline.push([high, zero]);
        self.put_slopes();
        let tops = (0..self.outline.len() - 1).map(|k| top(&self.outline, k, self.slopes_at(k)));
        tops.fold(zero, Real::max)
    }

    /// Where the zone of the nodes from `begin` to `end` ends, before and behind them [m].
    fn edges(&self, nodes: &[Node<T>], begin: usize, end: usize) -> [T; 2] {
        let last = end - 1;
        // Place, load per width, and the same smoothed, so many nodes further inside; nothing is
        // loaded beyond the other edge.
        [0, 1].map(|side| {
            let (outermost, other) = if side == 0 { (begin, last) } else { (last, begin) };
            let outward = if side == 0 { -1.0 } else { 1.0 };
            let panel = nodes[outermost].reach[side];
            let inside = |count: usize| {
                if count < end - begin {
                    let i = if side == 0 { begin + count } else { last - count };
                    return [
                        (nodes[i].y - nodes[outermost].y) * outward,
                        self.load[i],
                        self.smooth[i],
                    ];
                }
                let beyond = (count + 1 - (end - begin)) as f64;
                let to = (nodes[other].y - nodes[outermost].y) * outward;
                [to - nodes[other].reach[1 - side] * beyond, T::from(0.0), T::from(0.0)]
            };
            let [own, base, next] = [0, 1, 2].map(inside);
            let share = edge_share(panel, own, base, next);
            nodes[outermost].y + panel * share * outward
        })
    }

    /// Area of the nodes from `begin` to `end`: the square of the half length is a smooth curve
    /// through them and the edges.
    fn area(&mut self, nodes: &[Node<T>], begin: usize, end: usize, [low, high]: [T; 2]) -> T {
        let width = high - low;
        let zero = T::from(0.0);
        if end - begin < 3 {
            // Half an ellipse of the same load.
            let sum: T = (begin..end).map(|i| self.length_square(i) * nodes[i].width).sum();
            return (sum * 1.5 / width).sqrt() * width * FRAC_PI_2;
        }
        // Without the outermost nodes, whose load the edges take up.
        self.outline.clear();
        self.outline.push([low, zero]);
        for (i, node) in nodes.iter().enumerate().take(end - 1).skip(begin + 1) {
            let square = self.length_square(i);
            self.outline.push([node.y, square]);
        }
        self.outline.push([high, zero]);
        self.put_slopes();
        let points = &self.outline;
        let mut area = zero;
        let panels = points.len() - 1;
        for k in 0..panels {
            let h = points[k + 1][0] - points[k][0];
            let (slopes, mut sum) = (self.slopes_at(k), zero);
            for [at, weight] in GAUSS {
                // A root at the edges becomes a line.
                let (t, weight) = if k == 0 {
                    (at * at, 2.0 * at * weight)
                } else if k + 1 == panels {
                    (1.0 - at * at, 2.0 * at * weight)
                } else {
                    (at, weight)
                };
                let square = curve(points, k, slopes, points[k][0] + h * t).at_least(0.0);
                sum += square.sqrt() * weight;
            }
            area += h * sum * 2.0;
        }
        area
    }

    /// Finds the slopes of the curve through the outline, at least three points: at each that of the
    /// parabola through it and its neighbours; at the ends such that the parabola goes on.
    fn put_slopes(&mut self) {
        let Self { outline, slopes, .. } = self;
        let step = |k: usize| {
            let [[from, a], [to, b]] = [outline[k], outline[k + 1]];
            [to - from, (b - a) / (to - from)]
        };
        let mut before = step(0);
        let first = before[1];
        slopes.clear();
        slopes.push(first);
        for k in 1..outline.len() - 1 {
            let behind = step(k);
            let weighted = before[1] * behind[0] + behind[1] * before[0];
            slopes.push(weighted / (before[0] + behind[0]));
            before = behind;
        }
        slopes[0] = (first * 2.0 - slopes[1]).max(first * 0.5);
        let last = before[1];
        let own = (last * 2.0 - slopes[slopes.len() - 1]).min(last * 0.5);
        slopes.push(own);
    }

    /// Slopes of the curve at points `k` and `k` + 1 of the outline.
    fn slopes_at(&self, k: usize) -> [T; 2] {
        [self.slopes[k], self.slopes[k + 1]]
    }
}

/// Place of an edge beyond the outermost node over its `panel`: of that node, and of the first and
/// second ones inside, place from it outward, load per width and the same smoothed.
fn edge_share<T: Real>(panel: T, own: [T; 3], base: [T; 3], next: [T; 3]) -> T {
    let (outer, inner) = (-base[0], base[0] - next[0]);
    let beyond = own[1] * panel * 0.5 + (own[1] + base[1]) * outer * 0.5;
    let rise = (own[2] - base[2]) / outer * inner + (base[2] - next[2]) / inner * outer;
    let slope = rise / (outer + inner);
    // Of 2/3 l t + l' t²/6 = L, which holds at the edge of a parabola.
    let line = base[2] * (1.0 / 3.0);
    let root = (line * line + slope * beyond * (1.0 / 6.0)).at_least(f64::MIN_POSITIVE).sqrt();
    let distance = beyond / (line + root);
    let share = ((distance - outer) / panel).within(0.0, 1.0);
    let unequal = outer / panel + 1.0;
    let ratio = (own[1] / base[1] * unequal * 0.5).at_most(1.0);
    let square = (-ratio + 1.0) * (-ratio + 1.0);
    (share + square * square * EDGE).max(ratio)
}

/// What χ of a strip's own is more than the field, by the curvature of the displacement along it
/// over that of the wheel.
fn own_shape<T: Real>(curvature: T) -> T {
    let step = (curvature - 1.0) * OWN_SHAPE;
    -step / (step * step + 1.0).sqrt()
}

/// Greatest value of the curve from point `k` on to before the next one, where it has these slopes at
/// both.
fn top<T: Real>(points: &[[T; 2]], k: usize, slopes: [T; 2]) -> T {
    let h = points[k + 1][0] - points[k][0];
    let [rise, fall] = slopes.map(|slope| slope * h);
    if rise <= 0.0 || fall >= 0.0 {
        return points[k][1];
    }
    let step = points[k + 1][1] - points[k][1];
    let (square, cube) = (step * 3.0 - rise * 2.0 - fall, rise + fall - step * 2.0);
    let t = rise / ((square * square - cube * rise * 3.0).sqrt() - square);
    curve(points, k, slopes, points[k][0] + h * t)
}

/// Value of the curve at `x` between points `k` and `k` + 1, where it has these slopes.
fn curve<T: Real>(points: &[[T; 2]], k: usize, [left, right]: [T; 2], x: T) -> T {
    let [[from, a], [to, b]] = [points[k], points[k + 1]];
    let [found] = T::as_whole([from, a, to, b, left, right, x], &Curve);
    found
}

/// The curve between two points with these slopes there, at a place.
struct Curve;

impl Function<7, 1> for Curve {
    #[inline]
    fn at<T: Real>(&self, [from, a, to, b, left, right, x]: [T; 7]) -> [T; 1] {
        let h = to - from;
        let t = (x - from) / h;
        let rest = -t + 1.0;
        [a * (t * 2.0 + 1.0) * rest * rest
            + b * t * t * (-(t * 2.0) + 3.0)
            + h * t * rest * (left * rest - right * t)]
    }
}
