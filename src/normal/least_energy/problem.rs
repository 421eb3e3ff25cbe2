//! What is fixed while one problem is solved, node by node.

use super::hat::Hat;
use super::lattice::Lattice;
use super::scales::Scales;
use super::shape::Knots;
use crate::math::fixed_vec::FixedVec;

/// A node of a problem.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    /// What its distance to others follows from.
    pub hat: Hat,
    /// Width of the hat [m], and overlap in units of the ellipse [-].
    pub width: f64,
    pub overlap: f64,
    /// π/(8 R) over the load of the ellipse [m^-2].
    pub bending: f64,
    /// The mean over hats, T: its diagonal and what ties the node to the one before it [1/m].
    pub diagonal: f64,
    pub before: f64,
    /// Number of steps of the measure from its mean, and number of the interval of overlap.
    pub place: (f64, usize),
}

/// The nodes of a problem, and its knots.
#[derive(Clone, Debug)]
pub(super) struct Problem {
    pub points: FixedVec<Point>,
    pub knots: Knots,
    pub scales: Scales,
    /// Whether strips are displaced along x.
    pub is_skewed: bool,
}

/// Most load per width of the start over that of the ellipse.
const MOST_START: f64 = 1.5;

impl Problem {
    pub fn new(most: usize) -> Self {
        Self {
            points: FixedVec::new(most),
            knots: Knots::new(most),
            scales: Scales::default(),
            is_skewed: false,
        }
    }

    /// Takes the nodes of `lattice`.
    pub fn take(&mut self, lattice: &Lattice) {
        let scales = lattice.scales;
        self.scales = scales;
        self.knots.place(lattice);
        self.points.clear();
        let mut before = 0.0;
        for (i, node) in lattice.nodes.iter().enumerate() {
            let next = if i + 1 < lattice.nodes.len() { lattice.tie(i + 1) } else { 0.0 };
            self.points.push(Point {
                hat: Hat::new(lattice, i),
                width: node.width,
                overlap: node.overlap * scales.unit,
                bending: scales.unit / (8.0 * node.radius),
                diagonal: node.own_share / node.width,
                before,
                place: (node.number, node.interval),
            });
            before = next;
        }
        let first = &lattice.nodes[0];
        let same = |a: f64, b: f64| a.to_bits() == b.to_bits();
        self.is_skewed = lattice.nodes.iter().any(|node| !same(node.x, first.x));
    }

    /// Puts the loads to start with into `loads`: those of the ellipse, cut to the overlap [m].
    pub fn start(&self, lattice: &Lattice, loads: &mut FixedVec<f64>) {
        let level = self.scales.level;
        let (share, depth) = (1.0 / (1.0 - level), 1.0 / lattice.depth);
        loads.clear();
        loads.extend(lattice.nodes.iter().map(|node| {
            let per_width = (node.depth * depth - level) * share;
            node.width * per_width.clamp(0.0, MOST_START)
        }));
    }

    /// Whether the nodes of `lattice` are those that were taken, moved.
    pub fn has_nodes_of(&self, lattice: &Lattice) -> bool {
        let nodes = lattice.nodes.iter().map(|node| (node.number, node.interval));
        nodes.eq(self.points.iter().map(|point| point.place))
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.points.len()
    }
}
