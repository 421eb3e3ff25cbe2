//! Waves of wheel and rail along the track in a contact.

use crate::geometry::contacts::contact::Contact;
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::geometry::rail::varying_rail::Along;
use crate::geometry::uneven::wavy_section::WavySection;
use crate::geometry::wheel::contact_line::ContactLine;

/// Newton steps to where a circle is nearest to a row: each squares an error of some hundredths.
const NEWTON_STEPS: usize = 3;
/// Square of the least height of the axle above such a place, over that of the radius: no wheel is
/// met farther ahead [-].
const LEAST: f64 = 0.1;

/// Waves of wheel and rail along the track, as the frame of a contact sees them.
#[derive(Clone, Copy, Debug)]
pub struct WavesAlong<'a> {
    /// The waves of both bodies.
    pub section: WavySection<'a>,
    /// Radius r of the circle of the even bodies together, so that r/share is that of the normal
    /// section [m].
    pub radius: f64,
    /// Component along the normal of a unit of height, the cosine of the contact angle [-].
    pub share: f64,
    /// How far the middle of that circle is ahead of the contact line [m].
    pub ahead: f64,
    /// Slopes of the waves of rail and wheel that the outline has in the contact [-].
    pub slopes: [f64; 2],
}

impl<'a> WavesAlong<'a> {
    /// Those of the wheel with the contact line `line` and the `rail` in a `contact`, the even
    /// curvature at least the share `least` of that of the wheel; nothing where there are none.
    pub fn of(
        line: &ContactLine,
        rail: &'a PlacedRail,
        contact: &Contact,
        least: f64,
    ) -> Option<Self> {
        let varying = rail.variation().filter(|varying| varying.has_waves())?;
        // From one row, as neighbouring ones may touch other waves.
        let row = varying.met_near(contact.rail_s)?;
        let xl = row.x - row.along.ahead;
        let section = varying.waves_about([xl, row.point[0], row.point[1]]);
        let share = line.share_of_height(contact.normal());
        let wheel = line.wheel_point(contact.u).section_radius;
        // The row without its corrugation.
        let curvature = row.along.curvature + share * section.rail(row.x)[2];
        let even = Along { curvature, waves: 0.0, ..row.along }.relative(wheel);
        let radius = share * wheel / even.max(least);
        let slopes = section.slopes(row.x);
        let slope = row.along.lean / share - slopes[0];
        let circle = share * wheel;
        let ahead = nearest_to_even(circle, [row.along.ahead, slope, curvature / share]);
        let here = varying.along(contact.rail_s);
        let lever = section.lever_per_slope(line.nominal_radius());
        let slopes = [slopes[0] + (here.lean - row.along.lean) / share, here.lever / lever];
        Some(Self { section, radius, share, ahead, slopes })
    }
}

/// How far ahead of its middle a circle of the radius `circle` is nearest to a row without waves, of
/// which slope and curvature along its normal are known at the place `from` ahead of there [m].
fn nearest_to_even(circle: f64, [from, slope, curvature]: [f64; 3]) -> f64 {
    let bend = curvature * (1.0 + slope * slope).powf(1.5);
    let mut ahead = from;
    for _ in 0..NEWTON_STEPS {
        let height = (circle * circle - ahead * ahead).max(LEAST * circle * circle).sqrt();
        let steeper = ahead / height - slope + bend * (ahead - from);
        ahead -= steeper / ((circle / height).powi(2) / height + bend);
    }
    ahead
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn a_circle_is_nearest_to_a_row_where_it_is_as_steep() {
        for (from, slope) in [(0.02, 0.05), (-0.03, 0.0), (0.0, -0.1)] {
            let found = nearest_to_even(0.46, [from, slope, 0.0]);
            assert_relative_eq!(found, 0.46 * f64::atan(slope).sin(), epsilon = 1e-12);
        }
        // A roller, the middle of which is 30 mm ahead: on the line through both axles.
        let (wheel, roller, middle) = (0.46_f64, 0.8_f64, 0.03_f64);
        let nearest = wheel * middle / (wheel + roller);
        let from = nearest + 1e-3;
        let beside: f64 = from - middle;
        let slope = -beside / (roller * roller - beside * beside).sqrt();
        let found = nearest_to_even(wheel, [from, slope, 1.0 / roller]);
        assert_relative_eq!(found, nearest, epsilon = 1e-7);
    }
}
