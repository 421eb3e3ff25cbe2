//! The distance of two strips, as their mutual potential is tabulated over it.
//!
//! A load per width that is linear between nodes is a sum of hats. The potential of two strips is
//! averaged over both hats, for hats of equal widths that are up to four nodes apart in tables, else
//! as that of two points. Other hats get the spacing h of equal ones with the same mean logarithm of
//! the distance, from the distance D of their centroids and their variances v:
//!
//! ```text
//! h² = (D² - v_i - v_j)/(k² - 1/3)                                        k ≥ 2 nodes apart
//! h² = D² (1 + 3/2 (-0.4836 e + 1.9765 e² - 0.3389 q))                    beside each other
//! h² = w² (1 + 0.1821 r²)                                                 a hat and itself
//! e = (v_i + v_j)/D² - 1/3,  q = (μ_i - μ_j)/D³ (third moments),  r = (right - left)/(right + left)
//! ```
//!
//! Strips of a yawed wheel are displaced along x by Δx as well: see `displaced`.

use super::displaced::Growth;
use super::kernel::{Kernel, ROWS};
use super::lattice::Lattice;
use crate::math::real::{Function, Linear, Real};

/// Row of the table for pairs far apart.
pub(super) const FAR: usize = ROWS - 1;

const BESIDE: [f64; 3] = [-0.4836, 1.9765, -0.3389];
const ITSELF: f64 = 0.1821;
/// k² and 1/(k² - 1/3) of nodes k apart.
pub(super) const APART: [[f64; 2]; 3] = [[4.0, 3.0 / 11.0], [9.0, 3.0 / 26.0], [16.0, 3.0 / 47.0]];
/// Least square of the distance of two hats over the sum of their variances: where a line folds,
/// those of two intervals may lie in one place.
pub(super) const CLOSEST: f64 = 2.0;
/// Places from one interval of overlap to the next: none of their nodes are near each other.
const INTERVAL: f64 = 1e6;
/// What the distance of a strip to others follows from.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Hat<T = f64> {
    /// Number of the node, with a leap from one interval of overlap to the next.
    pub place: T,
    /// Centroid [m] and variance of the hat [m²].
    pub centre: T,
    pub variance: T,
    /// Squares of the spacings of the hat and itself, and of the one before it [m²].
    pub own: T,
    pub beside: T,
    /// Place along the track [m].
    pub x: T,
}

impl<T: Real> Hat<T> {
    /// The hat of node `i` of `lattice`.
    pub fn new(lattice: &Lattice<T>, i: usize) -> Self {
        let node = &lattice.nodes[i];
        let [centre, variance, third] = moments(node.y, node.reach);
        let beside = if i > 0 {
            let node = &lattice.nodes[i - 1];
            let before = moments(node.y, node.reach);
            beside(centre - before[0], variance + before[1], third - before[2])
        } else {
            T::from(0.0)
        };
        Self {
            place: T::from(i as f64 + INTERVAL * node.interval as f64),
            centre,
            variance,
            own: own_square(node.reach),
            beside,
            x: node.x,
        }
    }

    /// Potential K of its strip and that of `other` with these squares of the half lengths, and
    /// its derivatives by these; what may have been `kept` is that of the same strips with the same
    /// lengths.
    pub fn potential(
        &self,
        other: &Self,
        kernel: &Kernel,
        squares: [T; 2],
        kept: &mut KeptPair,
    ) -> [T; 3] {
        let (away, shift) = (other.centre - self.centre, other.x - self.x);
        let place = other.place.value() - self.place.value();
        let variances = other.variance + self.variance;
        let near = match place {
            0.0 => self.own,
            1.0 => other.beside,
            -1.0 => self.beside,
            _ => T::from(0.0),
        };
        let numbers = [away, shift, variances, near, squares[0], squares[1]];
        T::as_whole_again(numbers, &PairOf { kernel, place }, kept)
    }
}

/// What was found of a pair of strips, for derivatives backwards.
pub(super) type KeptPair = Option<[Linear<6>; 3]>;

/// The potential of a pair of strips and its derivatives by the squares of their half lengths, as
/// functions of the distance of their centroids, of how far one is ahead of the other, of the sum of
/// their variances, of the square of the spacing where they are beside each other and of the squares of
/// their half lengths.
struct PairOf<'a> {
    kernel: &'a Kernel,
    /// How many places they are apart.
    place: f64,
}

impl Function<6, 3> for PairOf<'_> {
    fn at<T: Real>(&self, numbers: [T; 6]) -> [T; 3] {
        let &Self { kernel, place } = self;
        let [away, shift, variances, near, p, q] = numbers;
        let distance = (away * away).max(variances * CLOSEST);
        let far = distance - variances;
        let mut square = if place.abs() < 1.5 {
            near
        } else {
            let apart = APART.into_iter().find(|apart| (apart[0] - place * place).abs() < 0.5);
            apart.map_or(far, |[_, inverse]| far * inverse)
        };
        let sum = p + q;
        let mut growth = None;
        if place != 0.0 && shift.value() != 0.0 {
            let own = Growth::new(shift * shift / distance, sum * 0.5 / distance);
            square *= own.factor;
            growth = Some(own);
        }
        let inverse = T::from(1.0) / square;
        let row = FAR.min(place.abs() as usize);
        let [value, by_p, by_q] = kernel.value(row, [p, q], inverse * 0.5, inverse.sqrt());
        let Some(Growth { rate, .. }) = growth else { return [value, by_p, by_q] };
        // K goes with the inverse of all lengths.
        let by_distance = -(value * 0.5) - p * by_p - q * by_q;
        let more = rate / sum * by_distance;
        [value, by_p + more, by_q + more]
    }
}

/// Centroid of a hat, and second and third moments about it.
fn moments<T: Real>(y: T, [l, r]: [T; 2]) -> [T; 3] {
    let (skew, squares) = (r - l, l * l + l * r + r * r);
    let third = skew * (squares * 2.0 + l * r * 3.0) * (1.0 / 270.0);
    [y + skew * (1.0 / 3.0), squares * (1.0 / 18.0), third]
}

/// Square of the spacing for a hat and itself.
fn own_square<T: Real>([left, right]: [T; 2]) -> T {
    let (width, skew) = ((left + right) * 0.5, (right - left) * 0.5);
    width * width + skew * skew * ITSELF
}

/// Square of the spacing for hats beside each other, `away` from each other, from the sum of their
/// variances and the difference of their third moments.
fn beside<T: Real>(away: T, variances: T, thirds: T) -> T {
    let square = away * away;
    let inverse = T::from(1.0) / square;
    let e = variances * inverse - 1.0 / 3.0;
    let q = thirds * inverse / away;
    square * (q * (1.5 * BESIDE[2]) + e * (e * (1.5 * BESIDE[1]) + 1.5 * BESIDE[0]) + 1.0)
}
