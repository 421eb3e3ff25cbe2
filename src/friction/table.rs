//! Tables over the surface of a rail, as they are looked up strip by strip.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::math::real::Real;

/// Direction of a tangent (y, z) as a number that grows with its inclination and takes no angle:
/// z/(|y| + |z|) where it points to the field side, from -2 to 2 all the way round [-].
#[inline]
pub fn direction<T: Real>([y, z]: [T; 2]) -> T {
    let share = z / (y.abs() + z.abs());
    if y >= 0.0 {
        return share;
    }
    -share + if z >= 0.0 { 2.0 } else { -2.0 }
}

/// That of a tangent with the `inclination` [rad], which is taken as at most half a turn, and its
/// derivative by the inclination.
fn direction_of(inclination: f64) -> [f64; 2] {
    let (sine, cosine) = inclination.sin_cos();
    let sum = sine.abs() + cosine.abs();
    // At half a turn the sine is that of a rounded number.
    let exact = if inclination.abs() >= PI {
        2f64.copysign(inclination)
    } else {
        direction([cosine, sine])
    };
    [exact, 1.0 / (sum * sum)]
}

/// A stretch of a table.
#[derive(Clone, Copy, Debug)]
struct Piece {
    /// Where it begins; the first one has no beginning.
    start: f64,
    /// Where the next one begins; not a number for the last one, so that nothing is beyond it.
    next: f64,
    /// From where its argument counts.
    origin: f64,
    /// Of growing powers of the argument.
    coefficients: [f64; 4],
}

/// A function of one number by pieces, continuous, constant beyond the ends of its points.
#[derive(Clone, Debug)]
pub struct Table {
    pieces: Vec<Piece>,
}

/// Longest piece over which a line over the inclination is a cubic over the direction: to 3e-7 rad
/// [rad].
const TURN: f64 = 0.04;
/// What a place may be off in the inclination by that [rad].
#[cfg(test)]
pub(crate) const OFF: f64 = 3e-7;

impl Table {
    /// Linear between `points` of place and value, of which there is at least one and whose places
    /// grow.
    pub fn over_place(points: &[[f64; 2]]) -> Self {
        let mut table = Self::constant(points[0][1]);
        for pair in points.windows(2) {
            let [[from, value], [to, other]] = [pair[0], pair[1]];
            table.add(from, [value, (other - value) / (to - from), 0.0, 0.0]);
        }
        table.end(points[points.len() - 1])
    }

    /// Linear over the inclination between `points` of inclination [rad] and value, of which there
    /// is at least one and whose inclinations grow; its argument is the [`direction`] of the
    /// tangent.
    pub fn over_inclination(points: &[[f64; 2]]) -> Self {
        let mut table = Self::constant(points[0][1]);
        for pair in points.windows(2) {
            let [[from, value], [to, other]] = [pair[0], pair[1]];
            let rate = (other - value) / (to - from);
            // The direction has other curvatures from one quarter to the next.
            for quarter in -2..2 {
                let first = FRAC_PI_2 * f64::from(quarter);
                let (from_here, to_here) = (from.max(first), to.min(first + FRAC_PI_2));
                let count = ((to_here - from_here) / TURN).ceil();
                for k in 0..count as usize {
                    let at = |k: usize| from_here + (to_here - from_here) * (k as f64 / count);
                    table.add_cubic([at(k), at(k + 1)], rate, value + rate * (at(k) - from));
                }
            }
        }
        let [last, value] = points[points.len() - 1];
        table.end([direction_of(last.clamp(-PI, PI))[0], value])
    }

    fn constant(value: f64) -> Self {
        let coefficients = [value, 0.0, 0.0, 0.0];
        let (start, next, origin) = (f64::NEG_INFINITY, f64::NAN, 0.0);
        Self { pieces: vec![Piece { start, next, origin, coefficients }] }
    }

    fn add(&mut self, start: f64, coefficients: [f64; 4]) {
        if let Some(before) = self.pieces.last_mut() {
            before.next = start;
        }
        self.pieces.push(Piece { start, next: f64::NAN, origin: start, coefficients });
    }

    /// What begins with `value` and grows with the inclination by `rate`, between the inclinations
    /// `from` and `to` [rad].
    fn add_cubic(&mut self, [from, to]: [f64; 2], rate: f64, value: f64) {
        let [[start, first], [end, last]] = [from, to].map(direction_of);
        let length = end - start;
        let mean = rate * (to - from) / length;
        let slopes = [rate / first, rate / last];
        let coefficients = [
            value,
            slopes[0],
            (3.0 * mean - 2.0 * slopes[0] - slopes[1]) / length,
            (slopes[0] + slopes[1] - 2.0 * mean) / (length * length),
        ];
        // Ends too near for different directions are one.
        if length > 0.0 {
            self.add(start, coefficients);
        }
    }

    fn end(mut self, [place, value]: [f64; 2]) -> Self {
        self.add(place, [value, 0.0, 0.0, 0.0]);
        self
    }

    /// The value at `x` [-]. `last`, the number of the piece that was looked up last, is where the
    /// search begins, and becomes that of this one.
    // Inside the loop over strips: a call would cost as much as the look-up.
    #[inline(always)]
    pub fn at<T: Real>(&self, x: T, last: &mut usize) -> T {
        let mut number = (*last).min(self.pieces.len() - 1);
        while self.pieces[number].next <= x.value() {
            number += 1;
        }
        while self.pieces[number].start > x.value() {
            number -= 1;
        }
        *last = number;
        let Piece { origin, coefficients: [c0, c1, c2, c3], .. } = self.pieces[number];
        let u = x - origin;
        u * (u * (u * c3 + c2) + c1) + c0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dual::Dual;
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    fn linear(points: &[[f64; 2]], x: f64) -> f64 {
        let next = points.partition_point(|point| point[0] <= x);
        let (Some(after), Some(k)) = (points.get(next), next.checked_sub(1)) else {
            return points[next.min(points.len() - 1)][1];
        };
        let [from, value] = points[k];
        value + (x - from) / (after[0] - from) * (after[1] - value)
    }

    #[test]
    fn tables_are_linear_between_their_points_and_constant_beyond() {
        let tables = [
            vec![[-0.4, 0.2], [-0.2, 0.3]],
            vec![[0.1, 0.5]],
            vec![[-0.9, 0.1], [-0.1, 0.4], [0.3, 0.2], [0.3 + 1e-6, 0.5], [1.0, 0.3]],
            vec![[-3.5, 0.0], [-1.9, 1.0], [2.0, 0.4], [3.6, 0.1]],
        ];
        for points in tables {
            let (place, turned) = (Table::over_place(&points), Table::over_inclination(&points));
            let (mut last, mut worst) = ([0; 2], 0.0f64);
            // To and fro, by steps of all sizes.
            for i in 0..20_000 {
                let x = PI * (0.37 * f64::from(i)).sin() * (0.001 * f64::from(i)).sin();
                assert_relative_eq!(place.at(x, &mut last[0]), linear(&points, x), epsilon = 1e-15);
                let tangent = [x.cos(), x.sin()].map(|part| 1.01 * part);
                let found = turned.at(direction(tangent), &mut last[1]);
                worst = worst.max((found - linear(&points, x)).abs());
            }
            // The steepest line has a slope of 0.75 to the inclination, but for the step within
            // 1e-6 rad.
            assert!(worst < OFF, "{worst:e}");
        }
    }

    #[test]
    fn derivatives_are_the_slopes_of_the_table() {
        let points = [[-0.4, 0.2], [-0.2, 0.3]];
        let number = |value: f64, slope: f64| Dual::<1> { value, slopes: [slope] };
        let at = -0.3f64;
        let found = Table::over_place(&points).at(number(at, 1.0), &mut 0);
        assert_relative_eq!(found.slopes[0], 0.5, max_relative = 1e-12);
        let tangent = [number(at.cos(), -at.sin()), number(at.sin(), at.cos())];
        let found = Table::over_inclination(&points).at(direction(tangent), &mut 0);
        assert_abs_diff_eq!(found.slopes[0], 0.5, epsilon = 1e-5);
    }

    #[test]
    fn a_constant_table_is_constant_to_the_last_bit() {
        let constant = 1.0 / 3.0;
        let points = [-0.7, -0.31, 0.02].map(|x| [x, constant]);
        for table in [Table::over_place(&points), Table::over_inclination(&points)] {
            let mut last = 0;
            for i in 0..100 {
                let x = -1.0 + 0.017 * f64::from(i);
                assert_eq!(table.at(x, &mut last).to_bits(), constant.to_bits());
            }
        }
    }
}
