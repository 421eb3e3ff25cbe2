//! The strips on which tractions are sought: fewer than those of the normal problem, and all of
//! them in between.
//!
//! They stand at equal shares of the integral of the root of the half length across the zone:
//! denser than at equal shares of the area towards the lateral edges, and yet continuous in the
//! strips of the normal problem, of which one more comes out of nothing where it begins to carry
//! load. Half length and pressure are interpolated: the square of the half length a and the ratio
//! of bound to half length are linear between strips, and a² falls to zero at the lateral edges.
//! Tractions over their bound are linear between the strips sought, at equal shares of the half
//! length, and constant beyond the outer ones.

use std::ops::Range;

use super::sizes::NODES;
use crate::kinematics::creepage::Creepage;
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;

/// A strip on which tractions are sought.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Node<T = f64> {
    /// Middle along rolling, ahead of the wheel marker, and place across [m].
    pub x: T,
    pub y: T,
    /// Half length > 0 [m].
    pub half_length: T,
    /// Greatest traction in its middle > 0 [Pa].
    pub bound: T,
    /// Bound of the load that it stands for over that of a band with its own profile [-].
    pub strength: T,
    /// Edges of that band [m].
    pub edges: [T; 2],
    /// Distances to both sides over which tractions are like its own [m].
    pub reach: [T; 2],
    /// Rigid slip in its middle, and its rate along x [-, 1/m].
    pub creepage: Creepage<T>,
}

/// A strip of the normal problem, or stretches of it together.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Carrier<T> {
    /// Middle along rolling, and place across [m].
    pub x: T,
    pub y: T,
    pub half_length: T,
    /// Greatest traction in its middle [Pa].
    pub bound: T,
    pub width: T,
    /// Rigid slip in its middle, and its rate along rolling.
    pub creepage: Creepage<T>,
    /// Integral of the root of the half length over all before it and half of its own width
    /// [m^(3/2)].
    pub passed: T,
}

/// Between which nodes a strip of the zone is.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Between<T = f64> {
    /// The first of two.
    pub node: usize,
    /// Share of the next one.
    pub share: T,
}

/// The nodes of a zone, and where its strips are between them.
#[derive(Clone, Debug)]
pub(super) struct Layout<T = f64> {
    pub nodes: [Node<T>; NODES],
    /// Of each strip of the zone, in their order.
    pub places: FixedVec<Between<T>>,
    carriers: FixedVec<Carrier<T>>,
    /// Of each carrier.
    between: FixedVec<Between<T>>,
}

/// Least bound over the greatest one: what has no friction slides.
const MIN_BOUND: f64 = 1e-9;

impl<T: Real> Layout<T> {
    /// Room for zones of `strips` strips.
    pub fn with_capacity(strips: usize) -> Self {
        Self {
            nodes: [Node::default(); NODES],
            places: FixedVec::new(strips),
            carriers: FixedVec::new(strips),
            between: FixedVec::new(strips),
        }
    }

    /// Lays nodes over the strips with the numbers `strips`, which end at `edges` and roll forward;
    /// false where they have no area or no bound.
    pub fn lay(
        &mut self,
        strips: Range<usize>,
        edges: [T; 2],
        carrier: impl Fn(usize) -> Carrier<T>,
    ) -> bool {
        self.gather(strips, carrier);
        let Some((first, last)) = self.carriers.first().copied().zip(self.carriers.last().copied())
        else {
            return false;
        };
        let total = last.passed + last.half_length.sqrt() * last.width * 0.5;
        let most = self.carriers.iter().fold(0.0, |most: f64, c| most.max(c.bound.value()));
        if !(total > 0.0 && total.value().is_finite() && most > 0.0 && most.is_finite()) {
            return false;
        }
        let [left, right] = edges;
        let mut next = 0;
        for i in 0..NODES {
            let wanted = total * ((i as f64 + 0.5) / NODES as f64);
            while next < self.carriers.len() && self.carriers[next].passed < wanted {
                next += 1;
            }
            let node = if next == 0 {
                first.towards_edge(left, wanted / first.passed)
            } else if next == self.carriers.len() {
                last.towards_edge(right, (total - wanted) / (total - last.passed))
            } else {
                let [a, b] = [&self.carriers[next - 1], &self.carriers[next]];
                a.between(b, (wanted - a.passed) / (b.passed - a.passed))
            };
            self.nodes[i] = Node { bound: node.bound.at_least(MIN_BOUND * most), ..node };
        }
        self.share_out(edges);
        self.reach();
        true
    }

    /// Takes the strips of a zone; stretches of one strip count together.
    fn gather(&mut self, strips: Range<usize>, carrier: impl Fn(usize) -> Carrier<T>) {
        self.carriers.clear();
        self.places.clear();
        let mut passed = T::from(0.0);
        for own in strips.map(carrier) {
            match self.carriers.last_mut() {
                Some(last) if last.y == own.y => last.join(&own),
                _ => self.carriers.push(own),
            }
            self.places.push(Between { node: self.carriers.len() - 1, share: T::from(0.0) });
        }
        for carrier in self.carriers.iter_mut() {
            let half = carrier.half_length.sqrt() * carrier.width * 0.5;
            carrier.passed = passed + half;
            passed += half * 2.0;
        }
    }

    /// Bands of the nodes, and the load that each stands for.
    fn share_out(&mut self, ends: [T; 2]) {
        let nodes = &mut self.nodes;
        let last = NODES - 1;
        for i in 0..=last {
            let middle = |k: usize| (nodes[k].y + nodes[k + 1].y) * 0.5;
            let low = if i == 0 { ends[0].min(nodes[0].y) } else { middle(i - 1) };
            let high = if i == last { ends[1].max(nodes[last].y) } else { middle(i) };
            nodes[i].edges = [low, high];
            nodes[i].strength = T::from(0.0);
        }
        self.between.clear();
        let mut next = 0;
        for carrier in self.carriers.iter() {
            while next + 2 < NODES && nodes[next + 1].y < carrier.y {
                next += 1;
            }
            let width = (nodes[next + 1].y - nodes[next].y).at_least(f64::MIN_POSITIVE);
            let share = ((carrier.y - nodes[next].y) / width).within(0.0, 1.0);
            let place = Between { node: next, share };
            self.between.push(place);
            let bound = carrier.half_length * carrier.width * carrier.bound;
            nodes[place.node].strength += bound * (-place.share + 1.0);
            nodes[place.node + 1].strength += bound * place.share;
        }
        for node in nodes.iter_mut() {
            let band = node.half_length * node.bound * (node.edges[1] - node.edges[0]);
            node.strength /= band.at_least(f64::MIN_POSITIVE);
        }
        for place in self.places.iter_mut() {
            *place = self.between[place.node];
        }
    }

    /// The distances over which others have tractions like those of a node: by as much less as
    /// their bounds are lower.
    fn reach(&mut self) {
        let nodes = &mut self.nodes;
        for i in 0..NODES {
            let own = nodes[i];
            let mut reach = [own.y - own.edges[0], own.edges[1] - own.y];
            for (k, other) in nodes.iter().enumerate() {
                if k != i {
                    let share = (other.bound / own.bound).at_most(1.0);
                    reach[usize::from(k > i)] += (other.edges[1] - other.edges[0]) * share;
                }
            }
            nodes[i].reach = reach.map(|e| e.at_least(f64::MIN_POSITIVE));
        }
    }
}

impl<T: Real> Carrier<T> {
    /// Takes in another stretch of the same strip.
    fn join(&mut self, other: &Self) {
        let [own, new] = [&*self, other].map(|c| c.half_length * c.bound);
        let sum = (own + new).at_least(f64::MIN_POSITIVE);
        let mean = |a: T, b: T| (a * own + b * new) / sum;
        self.x = mean(self.x, other.x);
        self.half_length = mean(self.half_length, other.half_length);
        self.creepage = Creepage {
            longitudinal: mean(self.creepage.longitudinal, other.creepage.longitudinal),
            lateral: mean(self.creepage.lateral, other.creepage.lateral),
            spin: mean(self.creepage.spin, other.creepage.spin),
        };
        self.bound = sum / self.half_length.at_least(f64::MIN_POSITIVE);
    }

    /// A node on the way from it to `other`.
    fn between(&self, other: &Self, share: T) -> Node<T> {
        let mix = |a: T, b: T| a + (b - a) * share;
        let square =
            mix(self.half_length * self.half_length, other.half_length * other.half_length);
        let half_length = square.at_least(f64::MIN_POSITIVE).sqrt();
        let per_length = |c: &Self| c.bound / c.half_length.at_least(f64::MIN_POSITIVE);
        Node {
            x: mix(self.x, other.x),
            y: mix(self.y, other.y),
            half_length,
            bound: mix(per_length(self), per_length(other)) * half_length,
            creepage: Creepage {
                longitudinal: mix(self.creepage.longitudinal, other.creepage.longitudinal),
                lateral: mix(self.creepage.lateral, other.creepage.lateral),
                spin: mix(self.creepage.spin, other.creepage.spin),
            },
            ..Node::default()
        }
    }

    /// A node between it and the `edge` of the zone, which is at the share 0; the rigid slip is its
    /// own.
    fn towards_edge(&self, edge: T, share: T) -> Node<T> {
        let root = share.at_least(f64::MIN_POSITIVE).sqrt();
        Node {
            x: self.x,
            y: edge + (self.y - edge) * share,
            half_length: self.half_length * root,
            bound: self.bound * root,
            creepage: self.creepage,
            ..Node::default()
        }
    }
}
