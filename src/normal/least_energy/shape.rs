//! The logarithm χ of pressure over half length, over that of the ellipse, as a field over the
//! nodes.
//!
//! It is zero on an ellipse and varies over lengths of the order of the half length, so that a few
//! numbers do: it is linear between knots, which stand every three steps of the measure of nodes on
//! both sides of its mean, but not at the ends of the overlaps, where nothing is loaded and the
//! field is constant. A knot comes in with the value of its neighbour, to which a penalty ties it
//! that falls from infinity: so all is continuous as the measure grows.

use super::lattice::Lattice;
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;

/// Steps of the measure between knots, and from the outermost ones to the ends of the overlaps at
/// least.
const SPACING: f64 = 3.0;
const END: f64 = 1.5;
/// What squared first and second differences between knots cost over the energy of the ellipse:
/// they decide where there is no load.
const PENALTIES: [f64; 2] = [1.2e-4, 1.8e-5];
/// First and second differences.
const DIFFERENCES: [&[f64]; 2] = [&[-1.0, 1.0], &[1.0, -2.0, 1.0]];
/// Least freedom of a knot.
const MIN_FREEDOM: f64 = 1e-3;

/// The knots of a problem.
#[derive(Clone, Debug)]
pub(super) struct Knots<T = f64> {
    pub count: usize,
    /// The first of the two knots of each node, and the share of the second.
    pub between: FixedVec<(usize, f64)>,
    /// Second derivatives of the penalty by the values at knots, by rows.
    pub penalties: FixedVec<T>,
}

impl<T: Real> Knots<T> {
    pub fn new(most: usize) -> Self {
        let knots = Self::most(most);
        Self { count: 0, between: FixedVec::new(most), penalties: FixedVec::new(knots * knots) }
    }

    /// Most knots of so many nodes.
    pub fn most(nodes: usize) -> usize {
        nodes / SPACING as usize + 3
    }

    /// Places the knots.
    pub fn place(&mut self, lattice: &Lattice<T>) {
        // How many knots are beyond the one on a side that is always there, and how far the last one
        // is from where it came in, over the spacing.
        let side = |extent: T| {
            let room = (extent - END) * (1.0 / SPACING) - 0.5;
            let beyond = room.value().floor().max(0.0);
            (beyond, (room - beyond).within(MIN_FREEDOM, 1.0))
        };
        let [low, high] = lattice.extent;
        let [(before, first_freedom), (behind, last_freedom)] = [side(-low), side(high)];
        let first = -before - 0.5;
        let m = (before + behind) as usize + 2;
        self.count = m;
        self.between.clear();
        self.between.extend(lattice.nodes.iter().map(|node| {
            let at = (node.number / SPACING - first).clamp(0.0, (m - 1) as f64);
            let knot = (at as usize).min(m - 2);
            (knot, at - knot as f64)
        }));
        self.penalties.clear();
        self.penalties.resize(m * m, T::from(0.0));
        for (difference, weight) in DIFFERENCES.into_iter().zip(PENALTIES) {
            for begin in 0..(m + 1).saturating_sub(difference.len()) {
                let mut freedom = T::from(1.0);
                if begin == 0 {
                    freedom *= first_freedom;
                }
                if begin + difference.len() == m {
                    freedom *= last_freedom;
                }
                let weight = if difference.len() == 2 {
                    T::from(weight) / freedom
                } else {
                    freedom * weight
                };
                for (k, &one) in difference.iter().enumerate() {
                    for (l, &other) in difference.iter().enumerate() {
                        self.penalties[(begin + k) * m + begin + l] += weight * (one * other);
                    }
                }
            }
        }
    }

    /// The field at node `i` for the values `at` the knots.
    pub fn value(&self, i: usize, at: &[T]) -> T {
        let (knot, share) = self.between[i];
        at[knot] * (1.0 - share) + at[knot + 1] * share
    }
}
