//! Wear depth between two profiles at hand, whatever made the second of the first.

use crate::geometry::curves::curve::Curve;
use crate::geometry::profiles::profile::{Profile, ProfileKind};
use crate::math::real::Real;

/// Distance of the places at which the depth is measured [m].
const SPACING: f64 = 1e-4;
/// Newton steps towards the normal of a place; two or three are the rule.
const MAX_STEPS: usize = 20;
/// Last step of those [m].
const ACCURACY: f64 = 1e-10;
/// Greatest distance at which a point of the worn profile is looked for [m].
const FARTHEST: f64 = 0.02;

/// A place of an unworn profile and what is missing there.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct DepthPoint {
    /// Point (y, z) of the unworn profile [m].
    pub point: [f64; 2],
    /// Distance of the worn profile along the inward normal there; negative where there is more
    /// material [m].
    pub depth: f64,
    /// Length of the unworn profile that the place stands for [m].
    pub length: f64,
}

/// Wear depth of `worn` against `unworn`, profiles of the same body in the same frame, along the
/// unworn one from the flange (gauge side) to the field side; places opposite to which the worn one
/// has ended are left out.
pub fn wear_depth(unworn: &Profile, worn: &Profile) -> Vec<DepthPoint> {
    let (base, other) = (&unworn.curve, &worn.curve);
    let length = base.end() - base.start();
    let count = (length / SPACING).ceil();
    let inward = match unworn.kind {
        ProfileKind::Rail => 1.0,
        ProfileKind::Wheel => -1.0,
    };
    let mut guess = None;
    (0..count as usize)
        .filter_map(|i| {
            let at = base.at(base.start() + (i as f64 + 0.5) / count * length);
            let speed = at.first[0].hypotenuse(at.first[1]);
            let tangent = at.first.map(|t| t / speed);
            let normal = [-inward * tangent[1], inward * tangent[0]];
            let start = guess.unwrap_or_else(|| nearest(other, at.point));
            let found = opposite(other, at.point, tangent, start)
                .or_else(|| opposite(other, at.point, tangent, nearest(other, at.point)));
            // The next place is as much further on.
            guess = found.map(|s| s + length / count);
            let to = other.at(found?).point;
            let depth = (to[0] - at.point[0]) * normal[0] + (to[1] - at.point[1]) * normal[1];
            (depth.abs() < FARTHEST).then_some(DepthPoint {
                point: at.point,
                depth,
                length: length / count,
            })
        })
        .collect()
}

/// Parameter at which a curve crosses the normal of a place with `tangent`, from a guess near it.
fn opposite(curve: &Curve, point: [f64; 2], tangent: [f64; 2], guess: f64) -> Option<f64> {
    let mut s = guess.clamp(curve.start(), curve.end());
    for _ in 0..MAX_STEPS {
        let at = curve.at(s);
        let along = |v: [f64; 2]| v[0] * tangent[0] + v[1] * tangent[1];
        let rate = along(at.first);
        if rate < 0.2 {
            return None;
        }
        let step = -along([at.point[0] - point[0], at.point[1] - point[1]]) / rate;
        s += step;
        if s < curve.start() - ACCURACY || s > curve.end() + ACCURACY {
            return None;
        }
        if step.abs() <= ACCURACY {
            return Some(s);
        }
    }
    None
}

/// Parameter of the point of a curve nearest to `point`, among points a spacing apart.
fn nearest(curve: &Curve, point: [f64; 2]) -> f64 {
    let count = ((curve.end() - curve.start()) / SPACING).ceil();
    let place = |i: usize| curve.start() + (curve.end() - curve.start()) * i as f64 / count;
    let distance = |s: &f64| {
        let at = curve.at(*s).point;
        (at[0] - point[0]).hypotenuse(at[1] - point[1])
    };
    let places = (0..=count as usize).map(place);
    places.min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(curve.start())
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::geometry::profiles::standard_profiles::built_in;
    use crate::wear::WornArc;
    use crate::wear::worn_arc::Body;

    #[test]
    fn the_depth_that_was_worn_off_is_found_again() {
        for (name, kind, body) in [
            ("S1002", ProfileKind::Wheel, Body::Wheel { nominal_radius: 0.46 }),
            ("60E1", ProfileKind::Rail, Body::Rail { distance: 1.0 }),
        ] {
            let unworn = built_in(name, kind).unwrap().unwrap();
            let mut arc = WornArc::new(&unworn.curve, body);
            let s = unworn.curve.start() + 0.4 * (unworn.curve.end() - unworn.curve.start());
            let spread =
                if kind == ProfileKind::Wheel { std::f64::consts::TAU * 0.46 } else { 1.0 };
            arc.deposit(s, s + 1e-2, 3e-4 * 1e-2 * spread);
            arc.take_pending();
            let (curve, _) = arc.worn_curve(2e-3);
            let worn = Profile { curve, ..unworn.clone() };
            let found = wear_depth(&unworn, &worn);
            let deepest = found.iter().map(|p| p.depth).fold(0.0, f64::max);
            assert_relative_eq!(deepest, arc.depth(), max_relative = 1e-3);
            let area: f64 = found.iter().map(|p| p.depth * p.length).sum();
            assert_relative_eq!(area, arc.area(), max_relative = 0.02);
            assert!(wear_depth(&unworn, &unworn).iter().all(|p| p.depth.abs() < 1e-12));
        }
    }
}
