//! A few rows of a rail that tell where the wheel may touch it.
//!
//! Between two of them the distance of the bodies is about the cubic through both ends and the
//! slopes there. What rail and wheel do beside their own such cubics is known beforehand.

use super::wheel_above::WheelAbove;
use crate::geometry::curves::curve::{Curve, Knot};
use crate::geometry::sections::rows::envelope::TREND;
use crate::geometry::sections::rows::met::Met;
use crate::geometry::sections::slices::Rows;
use crate::math::real::Real;

/// Distance of these rows [m].
const WIDE: f64 = 3e-3;
/// Rows are met each up to this distance from a wheel that touches, so that the outline beside a
/// contact is that of neighbouring rows: on a crown of 300 mm one or two of them [m].
const BESIDE: f64 = 2e-5;
/// The same where two of the few rows are met in other places, so that nothing is known of those
/// between: what a corner of 13 mm and the tip of a flange stand out between two rows, with room [m].
pub(super) const NEAR: f64 = 3e-4;
/// Distance of the samples of a profile [m].
const SAMPLE: f64 = 2e-4;

/// The few rows.
#[derive(Clone, Debug)]
pub(super) struct Few {
    /// Their numbers.
    pub rows: Vec<usize>,
    /// By rows: how far those up to the next one of the few, on any slice, and the profile of the
    /// wheel over as long a way go beside the cubics between both ends, at most [m].
    ripples: Vec<f64>,
}

impl Few {
    /// Those of `rows` under a `wheel`.
    pub fn new(rows: &Rows, wheel: &WheelAbove) -> Self {
        let Rows { parameter, parts, .. } = rows;
        let count = parameter.len();
        let is_end = |j: usize| j == 0 || j + 1 == count || parts[j - 1] != parts[j + 1];
        let mut few: Vec<usize> = Vec::new();
        for j in 0..count {
            let goes_far = few
                .last()
                .is_none_or(|&k| j + 1 < count && parameter[j + 1] - parameter[k] > WIDE && j > k);
            if goes_far || is_end(j) {
                few.push(j);
            }
        }
        let of_wheel = if wheel.around.is_some() { NEAR } else { ripple_of(wheel.profile) };
        let mut ripples = vec![0.0; count];
        for pair in few.windows(2) {
            ripples[pair[0]] = of_wheel + ripple_between(rows, [pair[0], pair[1]]);
        }
        Self { rows: few, ripples }
    }

    /// Whether any row from one of the few to the next one may be near a wheel that was lowered by
    /// `way` [m].
    pub fn is_near(&self, rows: &Rows, [from, to]: [&Met; 2], way: f64) -> bool {
        let [a, b] = [from, to].map(|met| met.gap.lowered(way));
        let nearest = a.min(b);
        let goes_on = from.opposite.is_some()
            && to.opposite.is_some()
            && (from.x - to.x).abs() < TREND
            && rows.parts[from.row] == rows.parts[to.row];
        if !goes_on {
            return nearest < NEAR;
        }
        let length = rows.parameter[to.row] - rows.parameter[from.row];
        // A cubic is nowhere farther below the straight line between its ends.
        let rise = (b - a) / length;
        let sag = 4.0 / 27.0
            * length
            * ((rise - from.gap.growth).max(0.0) + (to.gap.growth - rise).max(0.0));
        nearest - sag < BESIDE + self.ripples[from.row]
    }
}

/// How far a profile goes beside the cubics through any two of its points as far from each other as
/// the few rows, at most [m].
fn ripple_of(profile: &Curve) -> f64 {
    let knot = |s: f64| {
        let p = profile.at(s);
        Knot { s, point: p.point, tangent: p.first }
    };
    let length = profile.end() - profile.start();
    let count = (length / SAMPLE) as usize;
    let at = |i: usize| profile.start() + i as f64 * SAMPLE;
    let wide = (WIDE / SAMPLE).ceil() as usize;
    let own = (0..count.saturating_sub(wide)).map(|i| {
        let ends = [knot(at(i)), knot(at(i + wide))];
        let between = (i + 1..i + wide).map(|k| knot(at(k)));
        beside(&Curve::through(&ends), between)
    });
    own.fold(0.0, f64::max)
}

/// How far the rows between two go beside the cubics through these, at most on any slice [m].
fn ripple_between(rows: &Rows, [from, to]: [usize; 2]) -> f64 {
    let count = rows.parameter.len();
    let own = rows.knots.chunks(count).map(|slice| {
        let knot = |j: usize| {
            let [y, z, dy, dz] = slice[j].value;
            Knot { s: rows.parameter[j], point: [y, z], tangent: [dy, dz] }
        };
        let ends = [knot(from), knot(to)];
        let is_there = ends.iter().all(|end| end.point[0].is_finite()) && ends[1].s > ends[0].s;
        if !is_there {
            return 0.0;
        }
        beside(&Curve::through(&ends), (from + 1..to).map(knot))
    });
    own.fold(0.0, f64::max)
}

/// How far `knots` stand beside a curve at their parameters, along its normal [m].
fn beside(curve: &Curve, knots: impl Iterator<Item = Knot>) -> f64 {
    let away = knots.map(|knot| {
        let p = curve.at(knot.s);
        let [dy, dz] = p.first;
        let to = [knot.point[0] - p.point[0], knot.point[1] - p.point[1]];
        (to[1] * dy - to[0] * dz).abs() / dy.hypotenuse(dz)
    });
    // Not a number where the row is not there.
    away.fold(0.0, f64::max)
}
