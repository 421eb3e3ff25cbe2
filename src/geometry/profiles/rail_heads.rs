//! Rail heads made of arcs that meet with a common tangent, as rail standards draw them.
//!
//! From the centre line outwards: arcs of shrinking radius, each to a given half width, a last arc
//! until the side line is met, the side line 1:20, and on the built-in rails the fillet and the
//! underside 1:2.75.

use std::f64::consts::FRAC_PI_2;

use crate::geometry::curves::curve::Curve;
use crate::geometry::curves::curve_sections::{Section, arc, curve_of, line, mirrored};
use crate::geometry::profiles::profile::{Profile, ProfileKind};

/// Half width gained by the side line for each unit of depth.
const SIDE_SLOPE: f64 = 1.0 / 20.0;
/// Radius of the fillet between side and underside [m].
const FILLET_RADIUS: f64 = 0.003;
/// Depth gained by the underside for each unit of half width lost.
const UNDERSIDE_SLOPE: f64 = 1.0 / 2.75;
/// How far across the underside is followed, after the fillet [m]. Nothing touches further in.
const UNDERSIDE_WIDTH: f64 = 0.003;

/// Where the side line of a rail head ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum SideEnd {
    /// At this depth below the top [m].
    Depth(f64),
    /// At the fillet to an underside that aims at the centre line at this depth [m].
    Underside(f64),
}

impl Profile {
    /// A symmetric rail head of arcs, with its origin on the centre line at the top and not
    /// inclined.
    ///
    /// * `arcs`: radius and half width at the outer end of each [m], from the top outwards, half
    ///   widths growing
    /// * `corner_radius` [m]: radius of the last arc, which ends where it meets the side line 1:20
    /// * `side_depth` [m]: depth below the top to which the side line goes
    ///
    /// # Panics
    /// If the arcs cannot be drawn: half widths that do not grow or that an arc does not reach, or
    /// a side that ends above the last arc.
    pub fn rail_from_arcs(
        name: &str,
        arcs: &[[f64; 2]],
        corner_radius: f64,
        side_depth: f64,
    ) -> Self {
        let curve = head(arcs, corner_radius, SideEnd::Depth(side_depth));
        Self { name: name.into(), kind: ProfileKind::Rail, curve, remarks: Vec::new() }
    }
}

/// Curve of a rail head from the gauge to the field side.
pub(crate) fn head(arcs: &[[f64; 2]], corner_radius: f64, side_end: SideEnd) -> Curve {
    let side_angle = FRAC_PI_2 - SIDE_SLOPE.atan();
    let mut right: Vec<Section> = Vec::new();
    let mut centre = [0.0, arcs.first().map_or(corner_radius, |a| a[0])];
    let mut radius = centre[1];
    let mut angle = 0.0;
    for &[next, half_width] in arcs.iter().chain([&[corner_radius, f64::INFINITY]]) {
        // The common normal at the joint goes through both centres.
        centre = [
            centre[0] + (radius - next) * f64::sin(angle),
            centre[1] - (radius - next) * f64::cos(angle),
        ];
        radius = next;
        let end = if half_width.is_finite() {
            ((half_width - centre[0]) / radius).asin()
        } else {
            side_angle
        };
        assert!(end > angle, "half width {half_width} m is not on its arc of radius {radius} m");
        right.push(arc(centre, radius, angle - FRAC_PI_2, end - FRAC_PI_2));
        angle = end;
    }
    let (sin, cos) = side_angle.sin_cos();
    let corner = [centre[0] + radius * sin, centre[1] - radius * cos];
    match side_end {
        SideEnd::Depth(depth) => {
            assert!(depth > corner[1], "the side ends above its beginning");
            right.push(line(corner, [corner[0] + (depth - corner[1]) * SIDE_SLOPE, depth]));
        }
        SideEnd::Underside(aim) => right.extend(underside(corner, aim)),
    }
    let mut sections: Vec<Section> = right.iter().rev().map(|s| mirrored(s)).collect();
    sections.extend(right);
    curve_of(&sections)
}

/// Side line from its beginning, fillet and the outer part of the underside.
fn underside(from: [f64; 2], aim: f64) -> [Section; 3] {
    // The two lines: y = y0 + (z - z0) / 20 and z = aim - y / 2.75.
    let y = (from[0] + (aim - from[1]) * SIDE_SLOPE) / (1.0 + UNDERSIDE_SLOPE * SIDE_SLOPE);
    let edge = [y, aim - y * UNDERSIDE_SLOPE];
    let side_angle = FRAC_PI_2 - SIDE_SLOPE.atan();
    let underside_angle = std::f64::consts::PI - UNDERSIDE_SLOPE.atan();
    let tangent_length = FILLET_RADIUS * (0.5 * (underside_angle - side_angle)).tan();
    let along =
        |angle: f64, length: f64| [edge[0] + length * angle.cos(), edge[1] + length * angle.sin()];
    let (start, end) = (along(side_angle, -tangent_length), along(underside_angle, tangent_length));
    let centre =
        [start[0] - FILLET_RADIUS * side_angle.sin(), start[1] + FILLET_RADIUS * side_angle.cos()];
    let inner = [end[0] - UNDERSIDE_WIDTH, end[1] + UNDERSIDE_WIDTH * UNDERSIDE_SLOPE];
    [
        line(from, start),
        arc(centre, FILLET_RADIUS, side_angle - FRAC_PI_2, underside_angle - FRAC_PI_2),
        line(end, inner),
    ]
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    #[test]
    fn a_rail_from_arcs_is_symmetric_and_ends_where_asked() {
        let rail = Profile::rail_from_arcs(
            "benchmark",
            &[[0.3, 0.010_499_81], [0.08, 0.025_988_03]],
            0.013,
            0.030,
        );
        let bounds = rail.bounds();
        assert_relative_eq!(bounds.z[0], 0.0, epsilon = 1e-12);
        assert_relative_eq!(bounds.z[1], 0.030, epsilon = 1e-12);
        assert_relative_eq!(bounds.y[0], -bounds.y[1], epsilon = 1e-12);
        let (start, end) = (rail.curve.start(), rail.curve.end());
        for i in 0..=400 {
            let s = (end - start) * f64::from(i) / 400.0;
            let (a, b) = (rail.curve.at(start + s).point, rail.curve.at(end - s).point);
            assert_relative_eq!(a[0], -b[0], epsilon = 1e-12);
            assert_relative_eq!(a[1], b[1], epsilon = 1e-12);
        }
    }

    #[test]
    #[should_panic(expected = "is not on its arc")]
    fn a_half_width_beyond_its_arc_is_refused() {
        let _ = Profile::rail_from_arcs("impossible", &[[0.3, 0.02], [0.01, 0.06]], 0.005, 0.03);
    }
}
