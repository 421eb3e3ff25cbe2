//! Strips at the end of a rail, or of a part of it: they carry load as far as the rail goes.
//!
//! With t along the track from where the bodies are nearest, the depth δ of a contact and the slope
//! g of the gap there, which is zero but where the wheel stands on the end itself, and the radius R
//! of the section of both bodies together, the wheel is lowest at t = -g R and Δ = δ + g² R/2 deep
//! there. The undeformed section overlaps to h = sqrt(2 R Δ) on either side of that place, and the
//! load of a ball goes to a = h/√2. With an end at b ahead of it
//!
//! ```text
//! b ≥ a        the contact is whole
//! 0 ≤ b < a    it goes from -a to b
//! -h < b < 0   the wheel stands on the end, with load from b - (h + b)/√2 to b
//! ```
//!
//! and mirrored with an end behind. What is left is an ellipse of its own: its strips lie in the
//! middle of that stretch, and their sections get the radius f² R, with f its length over 2 a, by
//! which they are f times as long as whole ones. Under a whole ball the mean overlap along its
//! length is 5/6 of the depth. Let m be the mean overlap over the remaining stretch: if 6/5 m is
//! less than the depth δ, all overlaps are reduced by δ - 6/5 m. All of that is continuous in b, and
//! the load goes to zero with the overlap.

use std::f64::consts::FRAC_1_SQRT_2;

use crate::math::real::Real;
use crate::normal::least_energy::LinePlace;

/// Least length of strips, over that of whole ones: shorter ones have next to no load, and their
/// radius stays a length.
const MIN_SHARE: f64 = 0.1;
/// Depth of a whole ball over its mean overlap along its length: 1/(1 - a²/(3 h²)).
const DEPTH_OVER_MEAN: f64 = 6.0 / 5.0;

/// What an end leaves of a strip.
#[derive(Clone, Copy, Debug)]
pub(in crate::element) struct CutStrip<T> {
    /// How far ahead of where the bodies are nearest its middle is [m].
    pub ahead: T,
    /// What it overlaps less [m].
    pub less: T,
    /// Share of the radius of its section [-].
    pub radius_share: T,
}

impl<T: Real> CutStrip<T> {
    /// What it leaves of the strip at `place`.
    pub fn of(&self, place: LinePlace<T>) -> LinePlace<T> {
        LinePlace { overlap: place.overlap - self.less, x: place.x + self.ahead, ..place }
    }
}

/// What is left of a strip of a contact of a `depth` [m] with a `slope` of the gap [-] where the
/// bodies are nearest and the `radius` [m] of its section, where the rail goes `from` one place to
/// another one, from there [m]; nothing where it is whole or there is no contact.
pub(in crate::element) fn cut<T: Real>(
    depth: T,
    slope: T,
    radius: T,
    [from, to]: [T; 2],
) -> Option<CutStrip<T>> {
    if depth <= 0.0 {
        return None;
    }
    let lowest = -(slope * radius);
    let deepest = depth - lowest * slope * 0.5;
    let half = (radius * deepest * 2.0).sqrt();
    let whole = half * FRAC_1_SQRT_2;
    let [behind, ahead] = [lowest - from, to - lowest];
    if behind >= whole && ahead >= whole {
        return None;
    }
    let [behind, ahead] = [behind, ahead].map(|end| end.at_least(-half.value()));
    // How far from an end that the wheel stands on the load goes.
    let from_end = |end: T| (half + end) * FRAC_1_SQRT_2;
    let first = if ahead < 0.0 { ahead - from_end(ahead) } else { -whole };
    let last = if behind < 0.0 { from_end(behind) - behind } else { whole };
    let (first, last) = (first.max(-behind), last.min(ahead));
    let share = ((last - first) / (whole * 2.0)).at_least(MIN_SHARE);
    let square = (first * first + first * last + last * last) / 3.0;
    let mean = deepest - square / (radius * 2.0);
    Some(CutStrip {
        ahead: lowest + (first + last) * 0.5,
        less: (depth - mean * DEPTH_OVER_MEAN).at_least(0.0),
        radius_share: share * share,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const RADIUS: f64 = 0.46;
    const DEPTH: f64 = 1e-4;
    const INFINITE: f64 = f64::INFINITY;

    /// How far the overlap and the load of a whole contact go.
    fn halves() -> [f64; 2] {
        let half = (2.0 * RADIUS * DEPTH).sqrt();
        [half, half * FRAC_1_SQRT_2]
    }

    /// What an end at `b` ahead of the lowest point leaves, and its first and last place from that.
    fn before(b: f64) -> (CutStrip<f64>, [f64; 2]) {
        // Beyond the end the wheel stands on that.
        let beyond = (-b).max(0.0);
        let depth = DEPTH - 0.5 * beyond * beyond / RADIUS;
        let strip = cut(depth, -beyond / RADIUS, RADIUS, [-INFINITE, b + beyond]).unwrap();
        let [_, whole] = halves();
        let (middle, length) = (strip.ahead - beyond, strip.radius_share.sqrt() * whole);
        (strip, [middle - length, middle + length])
    }

    #[test]
    fn an_end_beyond_the_load_cuts_nothing() {
        let [_, whole] = halves();
        let beyond = whole * 1.000_001;
        assert!(cut(DEPTH, 0.0, RADIUS, [-beyond, beyond]).is_none());
        assert!(cut(0.0, 0.0, RADIUS, [0.0, INFINITE]).is_none());
        let (strip, _) = before(0.999_999 * whole);
        assert!(strip.less.abs() <= 0.0);
        assert_relative_eq!(strip.radius_share, 1.0, max_relative = 1e-5);
    }

    #[test]
    fn contacts_end_at_the_end_and_go_over_it_steadily() {
        let [half, whole] = halves();
        for b in [0.7 * whole, 0.2 * whole, 0.0, -0.2 * half, -0.7 * half] {
            let (strip, [first, last]) = before(b);
            assert_relative_eq!(last, b, epsilon = 1e-12);
            let expected = if b < 0.0 { b - (half + b) * FRAC_1_SQRT_2 } else { -whole };
            assert_relative_eq!(first, expected, epsilon = 1e-12);
            let depth = DEPTH - 0.5 * b.min(0.0).powi(2) / RADIUS;
            assert!(strip.less >= 0.0 && strip.less < 0.5 * depth);
        }
        for b in [0.0, -0.3 * half] {
            let [(one, _), (other, _)] = [-1e-9, 1e-9].map(|by| before(b + by));
            assert_relative_eq!(one.less, other.less, epsilon = 1e-10);
            assert_relative_eq!(one.radius_share, other.radius_share, epsilon = 1e-6);
        }
    }

    #[test]
    fn a_piece_with_two_ends_carries_between_them() {
        let [_, whole] = halves();
        let strip = cut(DEPTH, 0.0, RADIUS, [-0.5 * whole, 0.7 * whole]).unwrap();
        assert_relative_eq!(strip.ahead, 0.1 * whole, max_relative = 1e-12);
        assert_relative_eq!(strip.radius_share, 0.36, max_relative = 1e-12);
        let behind = cut(DEPTH, 0.0, RADIUS, [-0.5 * whole, INFINITE]).unwrap();
        let ahead = cut(DEPTH, 0.0, RADIUS, [-INFINITE, 0.5 * whole]).unwrap();
        assert_relative_eq!(behind.ahead, -ahead.ahead, max_relative = 1e-12);
    }
}
