//! Where the wheel touches first: the least Q.
//!
//! The minimum is found without fail and cheaply: it lies within `reach` of x_l, because there e
//! falls off less than the circle rises; samples as close as the deviations are smooth tell the
//! valleys of Q apart; the lowest ones are pinned down by the exact derivative. Samples are taken
//! once for an evaluation.

use super::Longitudinal;
use crate::math::root::bracketed;

/// Last Newton step towards a minimum, and bracket within which one is interpolated [m].
const BRACKET: f64 = 1e-9;
/// Newton steps towards a minimum; two or three are the rule.
const NEWTON_STEPS: usize = 6;

/// The lift of a wheel at one place of its contact line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lift {
    /// How much nearer the surfaces are than those of even bodies, M [m].
    pub height: f64,
    /// Where they are nearest, from the wheel marker [m].
    pub x: f64,
}

impl Longitudinal {
    /// The lift at the place `centre` = x_l of the contact line for a circle of radius `radius`
    /// [m].
    #[must_use]
    pub fn lift(&self, centre: f64, radius: f64) -> Lift {
        let first = self.before(centre - self.reach);
        let last = self.before(centre + self.reach) + 1;
        let at = |i: i64| self.sampled_distance(centre, radius, i);
        let lowest = (first..=last).map(at).fold(f64::INFINITY, f64::min);
        let level = lowest + self.dip(radius);
        let mut best = Lift { height: f64::NEG_INFINITY, x: centre };
        let (mut before, mut here) = (at(first - 1), at(first));
        for i in first..=last {
            let after = at(i + 1);
            if here <= level && here <= before && here <= after {
                let lift = self.valley(centre, radius, i, [before, here, after]);
                if lift.height > best.height {
                    best = lift;
                }
            }
            (before, here) = (here, after);
        }
        if best.height == f64::NEG_INFINITY {
            // A section flatter than any circle of the wheel, as that of a flange back near its
            // rim: lowest at an end of the reach.
            let x = [first, last].map(|i| self.place_of(i));
            let [left, right] = x.map(|x| -self.distance(centre, radius, x));
            let (height, x) = if left > right { (left, x[0]) } else { (right, x[1]) };
            return Lift { height, x };
        }
        best
    }

    /// Where Q is stationary near sample `i`, which is lower, or higher, than its neighbours, given
    /// Q at all three, and -Q there.
    pub(super) fn valley(&self, centre: f64, radius: f64, i: i64, around: [f64; 3]) -> Lift {
        let (left, right) = (self.place_of(i - 1), self.place_of(i + 1));
        // From the parabola through the samples Newton's method needs two or three steps.
        let [before, here, after] = around;
        let bend = before - 2.0 * here + after;
        let mut x = self.place_of(i);
        if bend.abs() > 0.0 {
            x += 0.5 * self.spacing * ((before - after) / bend).clamp(-1.0, 1.0);
        }
        for _ in 0..NEWTON_STEPS {
            let [e, slope, curvature] = self.nearness(x);
            let to = x - centre;
            let (rise, bend) = (to / radius - slope, 1.0 / radius - curvature);
            let step = -rise / bend;
            if step.abs() < BRACKET {
                // The rest of the way changes Q by less than rounding.
                let height = e - 0.5 * to * to / radius - 0.5 * rise * step;
                return Lift { height, x: x + step };
            }
            let next = x + step;
            if !(next > left && next < right) {
                break;
            }
            x = next;
        }
        // Flat or kinked: by bisection.
        let slope = |x: f64| (x - centre) / radius - self.nearness(x)[1];
        let (a, b) = (slope(left), slope(right));
        let x = if a * b > 0.0 {
            self.place_of(i)
        } else {
            bracketed((left, a), (right, b), BRACKET, slope)
        };
        Lift { height: -self.distance(centre, radius, x), x }
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{RADIUS, cases};

    #[test]
    fn first_touch_is_where_a_scan_of_the_surfaces_finds_it() {
        for mut case in cases() {
            for step in 0..24 {
                let station = 2.7e-3 * f64::from(step) - 0.03;
                case.place(station, -station / RADIUS, 0.01);
                for centre in [0.0, -0.004, 0.3] {
                    let lift = case.lift(centre, RADIUS);
                    let scan = (-6000..=6000)
                        .map(|i| centre + 2e-5 * f64::from(i))
                        .map(|x| -case.distance(centre, RADIUS, x))
                        .fold(f64::NEG_INFINITY, f64::max);
                    assert!((lift.height - scan).abs() < 1e-9, "{} {scan}", lift.height);
                    assert!((lift.x - centre).abs() <= case.reach() + 1e-9);
                }
            }
        }
    }

    #[test]
    fn sections_flatter_than_the_wheel_are_lifted_as_well() {
        for mut case in cases() {
            for step in 0..24 {
                let station = 2.7e-3 * f64::from(step) - 0.03;
                case.place(station, -station / RADIUS, 0.01);
                for radius in [1.0, 10.0, 1e3, 1e6] {
                    let lift = case.lift(0.0, radius);
                    assert!(lift.height.abs() < 0.01, "{radius}: {}", lift.height);
                    assert!(lift.x.abs() <= case.reach() + 2.0 * case.spacing());
                }
            }
        }
    }
}
