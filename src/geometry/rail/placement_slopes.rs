//! Derivatives by what a rail is placed by, and by the points of its profile as it is placed anew.
//!
//! With the knots q of the placed curve, those of the inclined profile l, its highest point t and
//! the hand h, q = (h (l_y - t_y), l_z - t_z). The highest point moves with the profile: at its
//! parameter z' stays zero. So does the gauge face, at which z stays as deep as the gauge is
//! measured.

use super::gauge_face::GaugeFace;
use super::placed_rail::{PlacedRail, Stands};
use crate::geometry::curves::knot_slopes::{ByKnot, KnotSlopes};
use crate::geometry::profiles::profile_kind::ProfileKind;

/// Slope of the inclined profile up to which its highest point is a level place and no end of it.
const LEVEL: f64 = 1e-6;

/// Derivatives by what a rail is placed by, and by its profile.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ByPlacement {
    /// By the inclination, a tangent.
    pub inclination: f64,
    /// By gauge and depth at which it is measured, where these place it.
    pub gauge: f64,
    pub gauge_depth: f64,
    /// By y and z of the position, where that places it, in the frame of a right rail.
    pub position: [f64; 2],
}

impl PlacedRail {
    /// Whether the gauge says where it stands.
    pub(crate) fn is_placed_by_gauge(&self) -> bool {
        matches!(self.stands, Stands::Gauge(_))
    }

    /// Derivatives from those by the knots of the placed curve, by the marker and by sine, cosine
    /// and highest point (y, z) of the inclined profile. A rail that `stays` is not placed anew
    /// when its profile changes. Those by normal displacements of the points of the profile go to
    /// `points`.
    pub(crate) fn back_to_placement(
        &self,
        knots: &mut KnotSlopes,
        marker: [f64; 2],
        [by_sine, by_cosine, top_y, top_z]: [f64; 4],
        stays: bool,
        points: &mut Vec<f64>,
    ) -> ByPlacement {
        let (curve, hand, zero) = (self.curve(), self.hand(), [0.0; 2]);
        let mut found = ByPlacement::default();
        let mut top = [top_y, top_z];
        match self.stands {
            Stands::Marker => found.position = marker,
            Stands::Origin => {
                found.position = marker;
                top = [top[0] + hand * marker[0], top[1] + marker[1]];
            }
            Stands::Gauge(GaugeFace { face, top: head, .. }) => {
                found.gauge = 0.5 * marker[0];
                if !stays {
                    let [y, z] = curve.at(face).first;
                    let by_face = -marker[0];
                    found.gauge_depth = by_face * y / z;
                    knots.add_at(curve, face, [[by_face, -found.gauge_depth], zero, zero]);
                    if let Some(head) = head {
                        let by_top = [0.0, found.gauge_depth - marker[1]];
                        knots.add_at(curve, head, [by_top, zero, zero]);
                    }
                }
            }
        }
        if !stays {
            for knot in &knots.knots {
                let [y, z] = self.inclined(knot).point;
                top = [top[0] - y, top[1] - z];
            }
            let at = curve.at(hand * self.top_s);
            let level = at.first[1].abs() < LEVEL && at.second[1] > 0.0;
            let along = if level { -hand * top[0] * at.first[0] / at.second[1] } else { 0.0 };
            let seen = [[hand * top[0], top[1]], [0.0, along], zero];
            knots.add_at(curve, hand * self.top_s, seen);
        }
        let [sine, cosine] = self.inclination;
        let mut angle = by_sine * cosine - by_cosine * sine;
        for (knot, s) in knots.knots.iter().zip(curve.knots()) {
            let (by, at) = (self.inclined(knot), curve.at(s));
            let [y, z] = [hand * at.point[0] + self.top[0], at.point[1] + self.top[1]];
            let [ty, tz] = [at.first[0], hand * at.first[1]];
            angle += by.point[1] * y - by.point[0] * z + by.tangent[1] * ty - by.tangent[0] * tz;
        }
        found.inclination = -angle * cosine * cosine;
        knots.by_displacements(curve, ProfileKind::Rail.outside(), points);
        if hand < 0.0 {
            points.reverse();
        }
        found
    }

    /// Derivatives by a knot of the placed curve as those by the same knot of the inclined profile
    /// that stays in place.
    fn inclined(&self, knot: &ByKnot) -> ByKnot {
        let hand = self.hand();
        let ByKnot { point, tangent } = knot;
        ByKnot { point: [hand * point[0], point[1]], tangent: [tangent[0], hand * tangent[1]] }
    }
}
