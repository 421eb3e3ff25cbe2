//! Lines, arcs and graphs as knots of a curve, and the curve of several of them in a row.
//!
//! All tangents have length one. Where two sections meet, tangent and position are continuous;
//! curvature jumps there if the sections' curvatures differ, as on every standard profile.

use crate::geometry::curves::curve::{Curve, Knot};
use crate::math::real::Real;
use crate::math::spline::{SplineEnd, interpolating_slopes};

/// Largest angle of a cubic piece of an arc [rad]. The radius then errs by 2e-11 and the curvature
/// by 4e-7 of their values.
const ARC_PIECE: f64 = 0.1;

/// Largest gap that is closed without a word where two sections meet [m]: the digits of the
/// standards.
const CLOSED_GAP: f64 = 1e-9;

/// Part of a curve whose parameter starts at zero.
pub(crate) type Section = Vec<Knot>;

/// A straight line.
pub(crate) fn line(from: [f64; 2], to: [f64; 2]) -> Section {
    let d = [to[0] - from[0], to[1] - from[1]];
    let length = d[0].hypotenuse(d[1]);
    let tangent = d.map(|d| d / length);
    vec![Knot { s: 0.0, point: from, tangent }, Knot { s: length, point: to, tangent }]
}

/// A circular arc from one polar angle about its centre to another [rad].
///
/// Angles count from the y axis towards the z axis. The parameter runs `4 tan(φ/4)/φ` times as far
/// as the arc, φ the angle of a piece: with tangents of length one the pieces are then the best
/// cubics for an arc.
pub(crate) fn arc(centre: [f64; 2], radius: f64, from: f64, to: f64) -> Section {
    let pieces = ((to - from).abs() / ARC_PIECE).ceil().max(1.0);
    let step = (to - from) / pieces;
    let parameter_step = 4.0 * radius * (step.abs() / 4.0).tan();
    let direction = step.signum();
    (0..=pieces as usize)
        .map(|i| {
            let (sin, cos) = (from + step * i as f64).sin_cos();
            Knot {
                s: parameter_step * i as f64,
                point: [centre[0] + radius * cos, centre[1] + radius * sin],
                tangent: [-direction * sin, direction * cos],
            }
        })
        .collect()
}

/// The graph z(y) over growing `y`, by a spline through exact points that starts and ends with the
/// exact slopes. `graph` gives z and dz/dy.
pub(crate) fn graph(y: &[f64], graph: impl Fn(f64) -> [f64; 2]) -> Section {
    // Two-point Gauss quadrature of the arc length.
    let offset = 0.5 / 3f64.sqrt();
    let mut s = vec![0.0];
    for pair in y.windows(2) {
        let (middle, h) = (0.5 * (pair[0] + pair[1]), pair[1] - pair[0]);
        let speed = |at: f64| 1f64.hypotenuse(graph(at)[1]);
        let length = 0.5 * h * (speed(middle - offset * h) + speed(middle + offset * h));
        s.push(s[s.len() - 1] + length);
    }
    let end_tangent = |y: f64| {
        let slope = graph(y)[1];
        let length = 1f64.hypotenuse(slope);
        [1.0 / length, slope / length]
    };
    let (first, last) = (end_tangent(y[0]), end_tangent(y[y.len() - 1]));
    let z: Vec<f64> = y.iter().map(|&y| graph(y)[0]).collect();
    let ends = |i: usize| [SplineEnd::Clamped(first[i]), SplineEnd::Clamped(last[i])];
    let along_y = interpolating_slopes(&s, y, ends(0));
    let along_z = interpolating_slopes(&s, &z, ends(1));
    (0..y.len())
        .map(|i| Knot { s: s[i], point: [y[i], z[i]], tangent: [along_y[i], along_z[i]] })
        .collect()
}

/// The same section run through the other way and mirrored in y.
pub(crate) fn mirrored(section: &[Knot]) -> Section {
    let length = section[section.len() - 1].s;
    section
        .iter()
        .rev()
        .map(|k| Knot {
            s: length - k.s,
            point: [-k.point[0], k.point[1]],
            tangent: [k.tangent[0], -k.tangent[1]],
        })
        .collect()
}

/// The curve of sections in a row, each starting where the one before ends.
pub(crate) fn curve_of(sections: &[Section]) -> Curve {
    let mut knots: Vec<Knot> = Vec::new();
    for section in sections {
        let before_last = knots.len().checked_sub(2).map_or(0.0, |i| knots[i].s);
        let Some(joint) = knots.last_mut() else {
            knots.extend_from_slice(section);
            continue;
        };
        let first = section[0];
        debug_assert!(
            (0..2).all(|i| (joint.point[i] - first.point[i]).abs() < CLOSED_GAP),
            "sections do not meet: {joint:?} {first:?}"
        );
        // The two agree to the digits of the standards. A piece of length h bends by 2/h of a
        // change of its tangent, so that of the shorter piece is kept.
        joint.point = [0, 1].map(|i| 0.5 * (joint.point[i] + first.point[i]));
        let length_before = joint.s - before_last;
        if section[1].s < length_before {
            joint.tangent = first.tangent;
        }
        let start = joint.s;
        knots.extend(section[1..].iter().map(|k| Knot { s: start + k.s, ..*k }));
    }
    Curve::through(&knots)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn curvature(curve: &Curve, s: f64) -> f64 {
        let p = curve.at(s);
        (p.first[0] * p.second[1] - p.first[1] * p.second[0])
            / p.first[0].hypotenuse(p.first[1]).powi(3)
    }

    #[test]
    fn arcs_keep_their_radius_and_their_curvature() {
        for direction in [-1.0, 1.0] {
            let section = arc([0.02, 0.3], 0.013, 0.4, 0.4 + direction * 1.5);
            let curve = Curve::through(&section);
            for i in 0..=1000 {
                let s = curve.start() + (curve.end() - curve.start()) * f64::from(i) / 1000.0;
                let p = curve.at(s).point;
                assert_relative_eq!((p[0] - 0.02).hypotenuse(p[1] - 0.3), 0.013, epsilon = 1e-12);
                assert_relative_eq!(curvature(&curve, s) * 0.013, direction, max_relative = 4e-7);
            }
            assert_relative_eq!(curve.end(), 0.013 * 1.5, max_relative = 3e-4);
        }
    }

    #[test]
    fn sections_in_a_row_are_smooth_where_they_meet() {
        let half = std::f64::consts::FRAC_PI_2;
        let right = [arc([0.0, 1.0], 1.0, -half, 0.0), line([1.0, 1.0], [1.0, 2.0])];
        let sections =
            [mirrored(&right[1]), mirrored(&right[0]), right[0].clone(), right[1].clone()];
        let curve = curve_of(&sections);
        let knots: Vec<f64> = curve.knots().collect();
        for s in &knots[1..knots.len() - 1] {
            let (before, after) = (curve.at(s - 1e-9), curve.at(s + 1e-9));
            for i in 0..2 {
                assert_relative_eq!(before.first[i], after.first[i], epsilon = 1e-8);
            }
        }
        assert_relative_eq!(curve.at(curve.start()).point[0], -1.0, epsilon = 1e-15);
        assert_relative_eq!(curve.at(curve.end()).point[1], 2.0, epsilon = 1e-15);
    }

    #[test]
    fn a_graph_is_met_between_its_points() {
        let f = |y: f64| [y.sin(), y.cos()];
        let y: Vec<f64> = (0..=200).map(|i| 0.01 * f64::from(i)).collect();
        let curve = curve_of(&[graph(&y, f)]);
        for i in 0..=1999 {
            let p = curve.at(curve.end() * f64::from(i) / 1999.0);
            // A spline errs by up to h⁴/384 of a fourth derivative of one: 1.0e-10 at h = 0.014.
            assert_relative_eq!(p.point[1], p.point[0].sin(), epsilon = 2e-10);
            assert_relative_eq!(p.first[0].hypotenuse(p.first[1]), 1.0, epsilon = 1e-5);
        }
    }
}
