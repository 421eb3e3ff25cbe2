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
    /// How far the rows between each of them and those beside it go beside cubics [m].
    pub edges: Vec<f64>,
    /// By rows: how far those up to the next one of the few go beside the cubic between both on any
    /// slice, at most [m].
    ripples: Vec<f64>,
    of_wheel: WheelRipples,
}

/// How far the profile of a wheel goes beside cubics between two of its points, at most.
#[derive(Clone, Debug)]
enum WheelRipples {
    /// Over ways as long as between two of the few rows: from samples of the profile on, the first
    /// of which is at its `start` [m].
    From { start: f64, samples: Vec<f64> },
    /// Of a wheel whose section varies around, anywhere [m].
    Anywhere(f64),
}

impl WheelRipples {
    /// Those of a `profile`.
    fn of(profile: &Curve) -> Self {
        let knot = |s: f64| {
            let p = profile.at(s);
            Knot { s, point: p.point, tangent: p.first }
        };
        let start = profile.start();
        let count = ((profile.end() - start) / SAMPLE) as usize;
        let at = |i: usize| start + i as f64 * SAMPLE;
        let wide = (WIDE / SAMPLE).ceil() as usize;
        let own = (0..count.saturating_sub(wide)).map(|i| {
            let ends = [knot(at(i)), knot(at(i + wide))];
            let between = (i + 1..i + wide).map(|k| knot(at(k)));
            beside(&Curve::through(&ends), between)
        });
        Self::From { start, samples: own.collect() }
    }

    /// Between two parameters of the profile [m].
    fn between(&self, [from, to]: [f64; 2]) -> f64 {
        match self {
            Self::Anywhere(most) => *most,
            Self::From { start, samples } => {
                let [first, last] = [from.min(to) - WIDE, from.max(to)];
                let sample = |s: f64| (((s - start) / SAMPLE).max(0.0) as usize).min(samples.len());
                let own = &samples[sample(first)..sample(last + SAMPLE)];
                let most = own.iter().copied().fold(0.0, f64::max);
                // Where the profile bends it goes aside with the square of the way.
                let longer = ((to - from).abs() / WIDE).max(1.0);
                most * longer * longer
            }
        }
    }
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
        let of_wheel = match wheel.around {
            Some(_) => WheelRipples::Anywhere(NEAR),
            None => WheelRipples::of(wheel.profile),
        };
        let mut ripples = vec![0.0; count];
        for pair in few.windows(2) {
            ripples[pair[0]] = ripple_between(rows, [pair[0], pair[1]]);
        }
        let beside = |k: usize| ripples[few[k]].max(if k > 0 { ripples[few[k - 1]] } else { 0.0 });
        let edges = (0..few.len()).map(beside).collect();
        Self { rows: few, edges, ripples, of_wheel }
    }

    /// Whether any row from one of the few to the next one may be near a wheel that was lowered by
    /// `way` [m].
    pub fn is_near(&self, rows: &Rows, [from, to]: [&Met; 2], way: f64) -> bool {
        let [a, b] = [from, to].map(|met| met.gap.lowered(way));
        let nearest = a.min(b);
        let opposite = from.opposite.zip(to.opposite);
        let Some((a_side, b_side)) = opposite.filter(|_| goes_on(rows, [from, to])) else {
            return nearest - self.ripples[from.row] < NEAR;
        };
        let length = rows.parameter[to.row] - rows.parameter[from.row];
        // A cubic is nowhere farther below the straight line between its ends.
        let rise = (b - a) / length;
        let sag = 4.0 / 27.0
            * length
            * ((rise - from.gap.growth).max(0.0) + (to.gap.growth - rise).max(0.0));
        nearest - sag
            < BESIDE + self.ripples[from.row] + self.of_wheel.between([a_side.s, b_side.s])
    }
}

/// Whether two rows are met in places that go on from one to the other.
pub(super) fn goes_on(rows: &Rows, [from, to]: [&Met; 2]) -> bool {
    from.opposite.is_some()
        && to.opposite.is_some()
        && (from.x - to.x).abs() < TREND
        && rows.parts[from.row] == rows.parts[to.row]
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
