//! Where a yawed wheel shows the rail the rim of a steep face, such as the back of a flange.
//!
//! A flat face stands square to the axle: none of its normals is across x once the wheel is yawed,
//! and what the rail sees of it is its rim, half a chord ahead of the axle or behind. The line is
//! followed there by height: at the height H below the axle the rim lies where the rounding below
//! the face fulfils the condition of the outline,
//!
//! ```text
//! r(s) cos α = H,  sin α = |u_x / c| |r'(s) / y_w'(s)|
//! ```
//!
//! so that the line is the outline of the turned wheel, up to the top of the face. The face of a
//! straight wheel would touch all along its chord, and at the least yaw the rim on one end of it.
//! Within some tenths of a milliradian the place therefore moves smoothly from the one end to the
//! other.

use super::{CURVATURE_REACH, ContactLine, LinePoint, MIN_SLOPE_COSINE, OnCircle, WheelPoint};
use crate::geometry::curves::curve::CurvePoint;
use crate::math::dual::Dual;
use crate::math::real::Real;
use crate::math::root::bracketed;

/// Yaw at which a steep face touches at 1/√2 of its half chord: half a chord of 0.2 m then leans
/// over by the 40 µm that loaded faces overlap. At any yaw the line lies at most 12 µm inside the
/// outline by that [rad].
const TURNING_YAW: f64 = 2e-4;
/// Step along the profile while looking for the rim [m].
const RIM_STEP: f64 = 1e-3;
/// Bracket in which the rim is interpolated [m].
const RIM_BRACKET: f64 = 1e-10;

/// A point of the line on the rim of a steep face.
pub(super) struct Rim<'a, T> {
    line: &'a ContactLine<'a, T>,
    /// Point of the profile that touches.
    edge: CurvePoint<T>,
    edge_s: T,
    /// How far ahead of the axle along e1, and how far down along e2 [m].
    ahead: T,
    height: T,
    /// Derivatives of `ahead` and of the profile's lateral coordinate with respect to the height.
    ahead_rate: T,
    lateral_rate: T,
    /// Derivative of the height with respect to the parameter of the line.
    height_rate: T,
}

impl<'a, T: Real> ContactLine<'a, T> {
    /// Whether at profile point `p` the line runs along a rim.
    #[inline(always)]
    pub(in crate::geometry) fn follows_rim(&self, p: &CurvePoint<T>) -> bool {
        p.first[0] < MIN_SLOPE_COSINE && self.lead != 0.0
    }

    /// The point for the parameter `s` with profile point `p`, a place of which the bound of the
    /// slope makes `on`.
    #[cold]
    pub(super) fn rim(&'a self, s: T, p: &CurvePoint<T>, on: &OnCircle<T>) -> Rim<'a, T> {
        let height = on.radius * on.cosine;
        let (start, end) = (self.profile.start(), self.profile.end());
        let radius_of = |p: &CurvePoint<T>| p.point[1] + self.nominal_radius;
        let (lead, level) = (self.lead.value(), height.value());
        let beyond = |s: f64| self.beyond(s, lead, level);
        // The rounding is on the side of the larger radii.
        let step = RIM_STEP.copysign(p.first[1].value());
        // Searches may ask for a place beyond the ends of the profile.
        let from = s.value().clamp(start, end);
        let (mut above, mut below) = ((from, beyond(from)), from);
        let mut reached = above;
        while reached.1 < 0.0 && below > start - RIM_STEP && below < end + RIM_STEP {
            above = reached;
            below += step;
            let within = below.clamp(start, end);
            reached = (within, beyond(within));
        }
        let edge_s = if reached.1 > 0.0 && (above.0 - reached.0).abs() > 0.0 {
            let found = bracketed(above, reached, RIM_BRACKET, beyond);
            self.moving_edge(found, height)
        } else {
            reached.0.into()
        };
        let edge = self.profile.at(edge_s);
        let radius = radius_of(&edge);
        let half_chord = (radius * radius - height * height).at_least(0.0).sqrt();
        let share = self.lead.abs() / self.lead.hypotenuse(TURNING_YAW.into());
        let regular = on.radius * on.sine;
        let side = self.lead.signum() * p.first[1].signum();
        let ahead = regular + share * (half_chord * side - regular);
        // d sin α/ds of the outline, and with it how fast the edge moves along the profile.
        let flatness = T::from(1.0) / edge.first[0].at_least(1e-9);
        let sine = (half_chord / radius).at_most(0.999_999);
        let cosine = (-(sine * sine) + 1.0).sqrt();
        let turning = self.lead.abs()
            * (edge.second[1] * edge.first[0] - edge.first[1] * edge.second[0]).abs()
            * flatness
            * flatness;
        let fall = edge.first[1].abs() * cosine + radius * sine / cosine * turning;
        Rim {
            line: self,
            edge,
            edge_s,
            ahead,
            height,
            ahead_rate: (-share + 1.0) * on.sine / on.cosine
                - share * side * height / half_chord.at_least(1e-9),
            lateral_rate: (-share + 1.0) * edge.first[0]
                / fall.at_least(1e-9).copysign(p.first[1].value()),
            height_rate: p.first[1] * on.cosine,
        }
    }

    /// How far below the height H the outline of a line with this lead is at profile parameter `s`,
    /// above it on the face, below it on the rounding.
    fn beyond<S: Real>(&self, s: S, lead: S, height: S) -> S {
        let p = self.profile.at(s);
        let lead = lead * p.first[1];
        if p.first[0] <= lead.abs() {
            return -height;
        }
        let sine = lead / p.first[0];
        let radius = p.point[1] + self.nominal_radius;
        radius * (-(sine * sine) + 1.0).sqrt() - height
    }

    /// The rim that was found at `edge` as it moves with lead and height.
    fn moving_edge(&self, edge: f64, height: T) -> T {
        if !T::HAS_SLOPES {
            return edge.into();
        }
        let rate = self.beyond(edge.into(), self.lead, height);
        let (lead, level) = (self.lead.value().into(), height.value().into());
        let slope = self.beyond(Dual::<1>::variable(edge, 0), lead, level);
        T::moving(edge, rate / -slope.slopes[0])
    }
}

impl<T: Real> Rim<'_, T> {
    /// Derivative of (y, z) with respect to the height.
    fn along_height(&self) -> [T; 2] {
        let ContactLine { axle: [_, uy, uz], ahead, down, .. } = *self.line;
        let axle = [uy, uz];
        // At the edge of the outline only the height moves the point: the profile's own slope is
        // made up for by the chord.
        [0, 1].map(|i| self.lateral_rate * axle[i] + self.ahead_rate * ahead[i] + down[i])
    }

    /// The point of the line.
    pub(super) fn point(&self) -> LinePoint<T> {
        let ContactLine { marker, axle, ahead, down, cosine, .. } = *self.line;
        let [tangent_y, tangent_z] = self.along_height();
        let length = tangent_y.hypotenuse(tangent_z).copysign(self.height_rate.value());
        let place = |i: usize| {
            marker[i + 1]
                + self.edge.point[0] * axle[i + 1]
                + self.ahead * ahead[i]
                + self.height * down[i]
        };
        LinePoint {
            x: marker[0] + self.edge.point[0] * axle[0] + self.ahead * cosine,
            point: [place(0), place(1)],
            tangent: [tangent_y / length, tangent_z / length],
        }
    }

    /// Derivative of (y, z) with respect to the parameter of the line.
    pub(super) fn derivative(&self) -> [T; 2] {
        self.along_height().map(|rate| rate * self.height_rate)
    }

    /// The wheel at the rim.
    pub(super) fn wheel_point(&self) -> WheelPoint<T> {
        let radius = self.edge.point[1] + self.line.nominal_radius;
        let sine = self.ahead / radius;
        let middle = if self.edge.first[1] > 0.0 { CURVATURE_REACH } else { -CURVATURE_REACH };
        // The rounding below the face, which has no curvature of its own.
        let rounding = self.line.mean_curvature(self.edge_s + middle).at_least(0.0);
        WheelPoint {
            y: self.edge.point[0],
            rolling_radius: self.ahead.hypotenuse(self.height),
            section_radius: T::from(1.0)
                / (T::from(MIN_SLOPE_COSINE) / radius + rounding * sine * sine),
        }
    }
}
