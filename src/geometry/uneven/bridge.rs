//! The parabola that a strip over waves is taken for.
//!
//! With the overlap g(x) of a circle of radius r over waves, of which e(x) is the height (larger
//! bodies are positive), m the middle of the circle and δ the greatest overlap,
//!
//! ```text
//! g(x) = δ - (max M - M(x)),   M(x) = e(x) - (x - m)²/(2 r)
//! ```
//!
//! a strip is that of the parabola which has the same integrals of the square and the cube of g where
//! g > 0, and the same middle of its square. Over an even body that is g itself. Where a wheel stands on
//! a flat, on two crests or across a trough, all that overlaps counts, and nothing jumps as one
//! place or another becomes the nearest.
//!
//! Between samples M is the cubic with the values and slopes of both: the integrals are exact for
//! that.

use crate::math::parabola::{DEPTH_OVER_MEAN, HALF_WIDTH_OVER_INTEGRAL};
use crate::math::real::Real;
use crate::math::root::bracketed;

/// Most samples: beyond them they are farther apart.
const MOST: usize = 32;
/// Distance of samples over that between which at most one wave is: an eighth of a wave λ, of which
/// cubics err by (2π/8)⁴/384, a thousandth.
const APART: f64 = 2.0;
/// Nodes and weights of Gauss and Legendre's rule of five points on 0 to 1: exact for the cube of a
/// cubic.
const GAUSS: [[f64; 2]; 5] = [
    [0.046_910_077_030_668_004, 0.118_463_442_528_094_54],
    [0.230_765_344_947_158_45, 0.239_314_335_249_683_23],
    [0.5, 0.284_444_444_444_444_44],
    [0.769_234_655_052_841_5, 0.239_314_335_249_683_23],
    [0.953_089_922_969_332, 0.118_463_442_528_094_54],
];
/// Bracket of an edge over the distance of samples: integrals go with its third power.
const EDGE: f64 = 1e-9;
/// Overlap below which a parabola is that of the place itself [m]: the ends of its stretch would be
/// lost in the rounding of heights.
const LEAST_DEPTH: f64 = 1e-12;

/// The parabola.
#[derive(Clone, Copy, Debug)]
pub struct Bridge<T> {
    /// Its middle, from that of the circle [m].
    pub middle: T,
    /// Its greatest overlap [m].
    pub overlap: T,
    /// Radius of its circle [m].
    pub radius: T,
    /// Slopes of the waves of rail and wheel, in the mean over the square of the overlap [-].
    pub slopes: [T; 2],
}

/// M at a sample [m], its slope [-], and that of the waves of the rail [-].
#[derive(Clone, Copy, Default)]
struct Sample<T> {
    height: T,
    slope: T,
    of_rail: T,
}

/// M between two samples, as a cubic of the share of the way.
struct Piece<'a, T> {
    from: &'a Sample<T>,
    to: &'a Sample<T>,
    coefficients: [T; 4],
}

impl<'a, T: Real> Piece<'a, T> {
    fn new(from: &'a Sample<T>, to: &'a Sample<T>, step: T) -> Self {
        let (rise, a, b) = (to.height - from.height, from.slope * step, to.slope * step);
        let coefficients = [from.height, a, rise * 3.0 - a * 2.0 - b, a + b - rise * 2.0];
        Self { from, to, coefficients }
    }

    fn at(&self, t: f64) -> T {
        let [a, b, c, d] = self.coefficients;
        a + (b + (c + d * t) * t) * t
    }

    /// Slope of the waves of the rail [-].
    fn of_rail(&self, t: f64) -> T {
        self.from.of_rail + (self.to.of_rail - self.from.of_rail) * t
    }

    /// Where it is highest, if that is inside.
    fn top(&self, step: f64) -> Option<f64> {
        let [a, b] = [self.from, self.to].map(|sample| sample.slope.value() * step);
        if a <= 0.0 || b > 0.0 {
            return None;
        }
        let [_, one, two, three] = self.coefficients.map(T::value);
        let slope = |t: f64| one + (2.0 * two + 3.0 * three * t) * t;
        Some(bracketed((0.0, a), (1.0, b), EDGE, slope))
    }

    /// Curvature at a share of the way [1/m].
    fn bend(&self, t: f64, step: T) -> T {
        let [.., two, three] = self.coefficients;
        (two * 2.0 + three * (6.0 * t)) / (step * step)
    }
}

/// Integrals of the overlap: of its square, its cube, its square times x, and times the slope of the
/// rail.
#[derive(Default)]
struct Sums<T> {
    square: T,
    cube: T,
    place: T,
    of_rail: T,
}

impl<T: Real> Bridge<T> {
    /// The same in other numbers, without derivatives.
    pub fn fixed<U: Real>(&self) -> Bridge<U> {
        let number = |x: T| U::from(x.value());
        Bridge {
            middle: number(self.middle),
            overlap: number(self.overlap),
            radius: number(self.radius),
            slopes: self.slopes.map(number),
        }
    }

    /// That of a circle of `radius` with the greatest overlap `depth` over `waves`, of which value
    /// [m] and slope [-] of rail and wheel are told by the distance from the middle of the circle
    /// and all of which vary by up to `range` [m]; `spacing` is the distance of samples between which
    /// at most one wave is [m].
    pub fn new(
        [radius, depth]: [T; 2],
        [range, spacing]: [f64; 2],
        waves: impl Fn(f64) -> [[T; 2]; 2],
    ) -> Self {
        let spacing = APART * spacing;
        // Nothing overlaps beyond.
        let deepest = depth.value().max(0.0) + range;
        let reach = (2.0 * radius.value() * deepest).sqrt();
        let side = ((reach / spacing).ceil() as usize).clamp(2, (MOST - 1) / 2);
        let step = (reach / side as f64).max(spacing);
        let count = 2 * side + 1;
        let place = |k: usize| (k as f64 - side as f64) * step;
        let mut samples = [Sample::default(); MOST];
        for (k, sample) in samples[..count].iter_mut().enumerate() {
            let x = place(k);
            let [rail, wheel] = waves(x);
            let rise = T::from(x) / radius;
            *sample = Sample {
                height: rail[0] + wheel[0] - rise * (0.5 * x),
                slope: rail[1] + wheel[1] - rise,
                of_rail: rail[1],
            };
        }
        let step = T::from(step);
        let pieces =
            || samples[..count].windows(2).map(|pair| Piece::new(&pair[0], &pair[1], step));
        let tops = pieces()
            .enumerate()
            .filter_map(|(k, piece)| piece.top(step.value()).map(|t| (k, t, piece)));
        let highest = tops.max_by(|(_, a, one), (_, b, other)| {
            one.at(*a).value().total_cmp(&other.at(*b).value())
        });
        let Some((k, t, top)) = highest else {
            // No circle without an end has none.
            return Self::at([T::from(0.0), depth, radius], T::from(0.0), radius);
        };
        let level = depth - top.at(t);
        let mut sums = Sums::default();
        for (k, piece) in pieces().enumerate() {
            piece.add_to(&mut sums, place(k), step, level);
        }
        if depth.value() <= LEAST_DEPTH || sums.square.value() <= 0.0 {
            let bend = top.bend(t, step).at_most(-1.0 / reach.max(spacing));
            let own = [T::from(place(k)) + step * t, depth, T::from(-1.0) / bend];
            return Self::at(own, top.of_rail(t), radius);
        }
        let overlap = sums.cube / sums.square * DEPTH_OVER_MEAN;
        let half_width = sums.square / (overlap * overlap) * HALF_WIDTH_OVER_INTEGRAL;
        let own = [sums.place / sums.square, overlap, half_width * half_width / (overlap * 2.0)];
        Self::at(own, sums.of_rail / sums.square, radius)
    }

    /// That of this middle, overlap and radius, over waves of a rail of this mean slope, under a circle
    /// of radius `circle`: both are as steep in the mean, as the cube of the overlap is none at either
    /// end.
    fn at([middle, overlap, radius]: [T; 3], of_rail: T, circle: T) -> Self {
        Self { middle, overlap, radius, slopes: [of_rail, middle / circle - of_rail] }
    }
}

impl<T: Real> Piece<'_, T> {
    /// Adds what overlaps above a `level`, of a piece that begins at the place `from`.
    fn add_to(&self, sums: &mut Sums<T>, from: f64, step: T, level: T) {
        let overlap = |t: f64| (self.at(t) + level).value();
        let [start, end] = [self.from, self.to].map(|sample| (sample.height + level).value());
        let edge =
            |inside: (f64, f64), outside: (f64, f64)| bracketed(inside, outside, EDGE, overlap);
        let stretch = match (start > 0.0, end > 0.0) {
            (true, true) => [0.0, 1.0],
            (true, false) => [0.0, edge((0.0, start), (1.0, end))],
            (false, true) => [edge((1.0, end), (0.0, start)), 1.0],
            (false, false) => {
                let Some(top) = self.top(step.value()).map(|t| (t, overlap(t))) else { return };
                if top.1 <= 0.0 {
                    return;
                }
                [edge(top, (0.0, start)), edge(top, (1.0, end))]
            }
        };
        let length = stretch[1] - stretch[0];
        for [node, weight] in GAUSS {
            let t = stretch[0] + node * length;
            let own = (self.at(t) + level).at_least(0.0);
            let square = own * own * step * (weight * length);
            sums.square += square;
            sums.cube += square * own;
            sums.place += square * (step * t + from);
            sums.of_rail += square * self.of_rail(t);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const RADIUS: f64 = 0.46;

    #[test]
    fn an_even_circle_is_its_own_bridge() {
        for depth in [1e-9, 1e-6, 1e-4] {
            // An eccentric wheel is a round one in another place.
            let waves = |x: f64| [[0.0; 2], [2e-3 * x, 2e-3]];
            let found = Bridge::new([RADIUS, depth], [1e-4, 1e-3], waves);
            assert_relative_eq!(found.overlap, depth, max_relative = 1e-9);
            assert_relative_eq!(found.radius, RADIUS, max_relative = 1e-9);
            assert_relative_eq!(found.middle, 2e-3 * RADIUS, max_relative = 1e-9);
            assert_relative_eq!(found.slopes[1], 2e-3, max_relative = 1e-12);
        }
    }

    #[test]
    fn on_two_crests_it_lies_between_them() {
        // A wave of 20 mm and 0.1 mm, its trough below the middle of the circle.
        let waves = |x: f64| {
            let k = 100.0 * std::f64::consts::PI;
            [[-5e-5 * (k * x).cos(), 5e-5 * k * (k * x).sin()], [0.0; 2]]
        };
        let shifted = |by: f64| {
            let moved = move |x: f64| waves(x - by);
            Bridge::new([RADIUS, 5e-5], [1e-4, 1.25e-3], moved)
        };
        let [behind, middle, ahead] = [-1e-9, 0.0, 1e-9].map(shifted);
        assert!(middle.middle.abs() < 1e-9, "{middle:?}");
        // Neither side jumps to its own crest.
        assert!((ahead.middle - behind.middle).abs() < 1e-6, "{behind:?} {ahead:?}");
        assert_relative_eq!(ahead.overlap, behind.overlap, max_relative = 1e-6);
        assert_relative_eq!(ahead.radius, behind.radius, max_relative = 1e-6);
    }
}
