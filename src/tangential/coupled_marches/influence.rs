//! All functions of one variable that couple strips and give them their flexibilities.
//!
//! Two strips with different half lengths are taken as two of one half length A, close to the greater
//! one: the moments of the tractions and the gradient as a polynomial along the track stay what they
//! are. What one does to the other is a function of their distance over A then, times powers of A.

use super::adhesion::{flexibilities, weights};
use super::band::{Projected, band, narrow, projected};
use super::functions::{Four, Functions};
use crate::math::real::Real;
use crate::math::until_unload::UntilUnload;

/// Distances of strips over their half length: those of the nodes of the most slender ellipses, and
/// as far as anything is felt.
const DISTANCES: [f64; 2] = [4e-3, 1e3];
/// Widths of bands over the half length: beyond them strips are infinitely long.
const WIDTHS: [f64; 2] = [4e-3, WIDEST];
/// The greatest of them.
pub(super) const WIDEST: f64 = 60.0;

/// The functions.
#[derive(Debug)]
pub(super) struct Influence {
    /// Of the square of the distance of two strips: P, R, and S in two parts, arranged as in [`Pair`].
    narrow: Functions<4>,
    /// The same of a band that begins at the receiving strip, of the square of the distance of its end.
    band: Functions<4>,
    /// Of the square of the width of a band: flexibilities at four ratios, and P and R.
    own: Functions<6>,
}

/// 1/A² of the half length A that stands for two strips of the half lengths `a` and `b` > 0,
///
/// ```text
/// A² = (a⁶ + b⁶)/(a⁴ + b⁴)
/// ```
///
/// What a strip does to one beside it that is shorter is the slope of its tractions, which goes with
/// its own length; what it does to a longer one is felt in the mean over that. Their mean square
/// instead makes more of it, and takes force from the strips at the edges of a patch.
#[inline(always)]
pub(super) fn inverse_square<T: Real>(a: T, b: T) -> T {
    let (a, b) = (a * a, b * b);
    let sum = a + b;
    let share = a / sum;
    let product = share - share * share;
    // By shares, as sixth powers of small lengths vanish.
    (-product * 2.0 + 1.0) / (sum * (-product * 3.0 + 1.0))
}

/// What two strips add to each other's gradients by the moments of their tractions, over the factor
/// -2/(π² G): along the track by tractions along, across by tractions across, and the one by the
/// other.
///
/// Coefficients of the gradient by moments stand in this order, which takes them in by products
/// lane by lane; lanes 1 and 3 add up:
///
/// ```text
/// along, across:  (0 by 1, 1 by 0, 2 by 1, 1 by 2)
/// crossed:        (0 by 0, 1 by 1, 2 by 0, -),  (0 by 2, -, 2 by 2, -)
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Pair<T = f64> {
    pub along: Four<T>,
    pub across: Four<T>,
    pub crossed: [Four<T>; 2],
}

/// Numbers of a material that enter.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ratio<T> {
    poisson: T,
    /// Weights of the functions at four ratios for flexibilities along and across.
    weights: [Four<T>; 2],
}

impl<T: Real> Ratio<T> {
    pub fn of(poisson: T) -> Self {
        Self { poisson, weights: [poisson / (-poisson + 1.0), -poisson].map(weights) }
    }
}

/// What a strip does to itself beyond what it does in its march, and its flexibilities.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Own<T> {
    /// L G, k₁, k₂ and nothing along and across [m, -, -, -].
    pub flexibility: [Four<T>; 2],
    /// As in [`Pair`].
    pub along: Four<T>,
    pub across: Four<T>,
}

fn odd(of: &[[f64; 3]; 3]) -> Four<f64> {
    [of[0][1], of[1][0], of[2][1], of[1][2]]
}

impl Influence {
    /// The functions, made on first use in the process; takes some tens of milliseconds then.
    pub fn shared() -> &'static Self {
        static SHARED: UntilUnload<Influence> = UntilUnload::new();
        SHARED.get_or_init(Self::new)
    }

    fn new() -> Self {
        let squares = |ends: [f64; 2]| ends.map(|end| end * end);
        let arranged = |kernel| {
            move |square: f64| {
                let [p, r, c]: Projected = projected(kernel, square.sqrt());
                let crossed = [[c[0][0], c[1][1], c[2][0], 0.0], [c[0][2], 0.0, c[2][2], 0.0]];
                [odd(&p), odd(&r), crossed[0], crossed[1]]
            }
        };
        let pairs = Functions::through(squares(DISTANCES), arranged(narrow));
        let bands = Functions::through(squares(DISTANCES), arranged(band));
        let own = Functions::through(squares(WIDTHS), |square| {
            let s = square.sqrt();
            let [p, r, _] = projected(band, s);
            let [first, second, third, fourth] = flexibilities(s);
            [first, second, third, fourth, odd(&p), odd(&r)]
        });
        Self { narrow: pairs, band: bands, own }
    }

    /// What a narrow strip does to another one at the `distance` > 0 in the direction of greater y,
    /// over its width, with 1/A² `inverse`; in the other direction what is crossed has the other
    /// sign.
    #[inline(always)]
    pub fn narrow<const F: bool, T: Real>(
        &self,
        distance: T,
        inverse: T,
        ratio: &Ratio<T>,
    ) -> Pair<T> {
        let root = inverse.sqrt();
        // A to the power of -2 - m - k, of which one is left for the width.
        let found = self.narrow.at::<F, T>(distance * distance * inverse);
        scaled::<F, T>(&found, inverse, root, ratio)
    }

    /// As [`narrow`](Self::narrow), of a strip of the width `width` > 0 over it.
    #[inline(always)]
    pub fn wide<const F: bool, T: Real>(
        &self,
        distance: T,
        width: T,
        inverse: T,
        ratio: &Ratio<T>,
    ) -> Pair<T> {
        let root = inverse.sqrt();
        let near = ((distance - width * 0.5) * root).at_least(0.0);
        let far = (distance + width * 0.5) * root;
        let near = self.band_to::<F, T>(near);
        let far = self.band_to::<F, T>(far);
        let of = |v: usize| std::array::from_fn(|lane| far[v][lane] - near[v][lane]);
        scaled::<F, T>(&[of(0), of(1), of(2), of(3)], root / width, root, ratio)
    }

    /// What a band that begins at the receiving strip does, to its `end` >= 0 over the half length.
    #[inline(always)]
    fn band_to<const F: bool, T: Real>(&self, end: T) -> [Four<T>; 4] {
        let mut found = self.band.at::<F, T>(end * end);
        // Below the least distance what is along and across is in proportion to it; what is crossed
        // is that of the edge alone there, which both ends of a strip's band have in common.
        let share = (end / DISTANCES[0]).at_most(1.0);
        for component in &mut found[..2] {
            for lane in component {
                *lane *= share;
            }
        }
        found
    }

    /// What a strip of the half length `a` and the width `width` has of its own, where the band of
    /// its march ends at the distances `reach` > 0 to either side.
    #[inline(always)]
    pub fn own<const F: bool, T: Real>(
        &self,
        a: T,
        width: T,
        reach: [T; 2],
        ratio: &Ratio<T>,
    ) -> Own<T> {
        let inverse = T::from(1.0) / a;
        let [left, right] = [reach[0] * inverse, reach[1] * inverse];
        let left = self.own.at::<F, T>(left * left);
        let right = self.own.at::<F, T>(right * right);
        let strip = width * 0.5 * inverse;
        let narrow = self.own.at::<F, T>(strip * strip);
        // Below the least width a band does in proportion to it.
        let share = (strip / WIDTHS[0]).at_most(1.0) * 2.0;
        let mut found = Own::default();
        for (component, weights) in ratio.weights.iter().enumerate() {
            let sum: &mut Four<T> = &mut found.flexibility[component];
            for n in 0..4 {
                for lane in 0..4 {
                    let both = left[n][lane] + right[n][lane];
                    sum[lane] = sum[lane].add_product::<F>(both, weights[n] * 0.5);
                }
            }
        }
        found.flexibility[0][0] *= a * (-ratio.poisson + 1.0);
        found.flexibility[1][0] *= a;
        let nu = ratio.poisson;
        let second = inverse * inverse;
        let fourth = second * second;
        let powers = [second, second, fourth, fourth].map(|power| power / width);
        for lane in 0..4 {
            let beyond = |n: usize| narrow[n][lane] * share - left[n][lane] - right[n][lane];
            let (p, r) = (beyond(4), beyond(5));
            found.along[lane] = (p + (r - p) * nu) * powers[lane];
            found.across[lane] = (p - r * nu) * powers[lane];
        }
        found
    }
}

/// Functions of the distance over A, times `factor` and as many powers of 1/A, which is `root`, as
/// moments and coefficients have.
#[inline(always)]
fn scaled<const F: bool, T: Real>(
    [p, r, first, second]: &[Four<T>; 4],
    factor: T,
    root: T,
    ratio: &Ratio<T>,
) -> Pair<T> {
    let nu = ratio.poisson;
    let square = root * root;
    let once = factor * root;
    let thrice = once * square;
    let odd = [once, once, thrice, thrice];
    let zeroth = factor * nu;
    let twice = zeroth * square;
    let four_times = twice * square;
    let even = [[zeroth, twice, twice, twice], [twice, twice, four_times, four_times]];
    let mut found = Pair::default();
    for lane in 0..4 {
        found.along[lane] = p[lane].add_product::<F>(r[lane] - p[lane], nu) * odd[lane];
    }
    for lane in 0..4 {
        found.across[lane] = p[lane].add_product::<F>(r[lane], -nu) * odd[lane];
    }
    for lane in 0..4 {
        found.crossed[0][lane] = first[lane] * even[0][lane];
    }
    for lane in 0..4 {
        found.crossed[1][lane] = second[lane] * even[1][lane];
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    /// On patches hundreds of times as long as wide, whose strips are closer than the functions reach.
    #[test]
    fn what_is_crossed_vanishes_between_strips_that_are_close() {
        let (influence, ratio) = (Influence::shared(), Ratio::of(0.28));
        let crossed = |distance: f64, width: f64| {
            let pair = influence.wide::<false, f64>(distance, width, 1.0, &ratio);
            // Per width, as a band of any width does as much as its edges.
            pair.crossed.iter().flatten().map(|c| (c * width).abs()).fold(0.0, f64::max)
        };
        let edge = crossed(1.0, 2.0);
        for width in [4e-3, 1e-3, 1e-4, 1e-6] {
            assert!(crossed(width, width) < 2.0 * width.max(DISTANCES[0]) * edge, "{width}");
        }
    }
}
