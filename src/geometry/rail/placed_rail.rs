//! A rail as it stands under the wheel: its curve in the frame of its marker.

use crate::geometry::curves::arc_length::ArcLength;
use crate::geometry::curves::curve::{Curve, Knot};
pub use crate::geometry::curves::nearest_point::Nearest;
use crate::geometry::curves::nearest_point::{CoarsePoints, nearest};
use crate::geometry::profiles::profile::Profile;
use crate::geometry::rail::course::Course;
use crate::geometry::rail::gauge_face::{GaugeFace, gauge_face};
use crate::geometry::rail::varying_rail::{VaryingRail, WheelAbove};
use crate::geometry::sections::slices::Slices;
use crate::geometry::uneven::waviness::Waviness;
use crate::geometry::wheel::contact_line::{ContactLine, WheelPose};
use crate::leaves;
use crate::math::real::Real;

/// A rail profile turned by its inclination, with its highest point as origin.
#[derive(Clone, Debug)]
pub struct PlacedRail {
    curve: Curve,
    /// Marker in the track frame in design position (right side) [m].
    pub marker: [f64; 2],
    /// Sine and cosine of the inclination.
    pub(super) inclination: [f64; 2],
    /// Highest point of the inclined profile, in the inclined profile frame, and its parameter there
    /// [m].
    pub(super) top: [f64; 2],
    pub(super) top_s: f64,
    /// Number among the rails of an element, from 0.
    pub number: u32,
    /// 1, or -1 where the profile is turned left to right after it was inclined.
    hand: f64,
    pub(super) stands: Stands,
    /// Greatest concave curvature of the head, ≥ 0 [1/m].
    pub concavity: f64,
    coarse: CoarsePoints,
    /// The surface of a rail whose section varies along the track.
    varying: Option<Box<VaryingRail>>,
}

/// What says where a rail stands.
#[derive(Clone, Copy, Debug)]
pub(super) enum Stands {
    /// Its marker.
    Marker,
    /// The origin of its profile.
    Origin,
    /// Its gauge face.
    Gauge(GaugeFace),
}

/// Why a rail cannot be placed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GaugeFaceMissing;

impl PlacedRail {
    /// Places the right rail with profile `curve`: leaned by `inclination` (the tangent, 1:40 is
    /// 0.025) towards the track centre, then `mirrored` left to right where asked for, highest
    /// point at z = 0, gauge face `gauge_depth` below it at y = `gauge`/2 [m].
    ///
    /// # Errors
    /// When the profile has no gauge face at that depth.
    pub fn by_gauge(
        curve: &Curve,
        inclination: f64,
        gauge: f64,
        gauge_depth: f64,
        mirrored: bool,
    ) -> Result<Self, GaugeFaceMissing> {
        let rail = Self::at_marker(curve, inclination, [0.0; 2], mirrored);
        let face = gauge_face(&rail.curve, gauge_depth).ok_or(GaugeFaceMissing)?;
        let [y, top] = face.place;
        Ok(Self { marker: [0.5 * gauge - y, 0.0 - top], stands: Stands::Gauge(face), ..rail })
    }

    /// Places a rail with profile `curve`, leaned by `inclination` (the tangent) as a right rail
    /// towards the track centre, then `mirrored` left to right where asked for, so that its highest
    /// point lies at `marker` (y, z) of the track frame [m].
    pub fn at_marker(curve: &Curve, inclination: f64, marker: [f64; 2], mirrored: bool) -> Self {
        // Towards the track centre is a negative turn about x for a right rail.
        let angle = -inclination.atan();
        let (sine, cosine) = angle.sin_cos();
        let turn = |p: [f64; 2]| [p[0] * cosine - p[1] * sine, p[0] * sine + p[1] * cosine];
        let mut knots: Vec<Knot> = curve
            .knots()
            .map(|s| {
                let p = curve.at(s);
                Knot { s, point: turn(p.point), tangent: turn(p.first) }
            })
            .collect();
        let leaned = Curve::through(&knots);
        let (top, top_s) = highest_point(&leaned);
        for knot in &mut knots {
            knot.point = [knot.point[0] - top[0], knot.point[1] - top[1]];
        }
        if mirrored {
            // The parameter changes its sign with y, so that the curve still runs to the field
            // side.
            knots.reverse();
            for Knot { s, point, tangent } in &mut knots {
                (*s, *point, *tangent) = (-*s, [-point[0], point[1]], [tangent[0], -tangent[1]]);
            }
        }
        let curve = Curve::through(&knots);
        let (concavity, coarse) = (greatest_concavity(&curve), CoarsePoints::of(&curve));
        let hand = if mirrored { -1.0 } else { 1.0 };
        Self {
            curve,
            marker,
            inclination: [sine, cosine],
            top,
            top_s,
            number: 0,
            hand,
            stands: Stands::Marker,
            concavity,
            coarse,
            varying: None,
        }
    }

    /// As [`at_marker`](Self::at_marker), with the origin of the profile, about which it is
    /// inclined, at `origin` (y, z) [m]: for profiles that stand where they are in a frame of their
    /// own, and for those without a highest point of the head.
    pub fn at_origin(curve: &Curve, inclination: f64, origin: [f64; 2], mirrored: bool) -> Self {
        let rail = Self::at_marker(curve, inclination, [0.0; 2], mirrored);
        let [y, z] = rail.top;
        let marker = [origin[0] + rail.hand * y, origin[1] + z];
        Self { marker, stands: Stands::Origin, ..rail }
    }

    /// 1, or -1 where the rail is turned left to right [-].
    pub fn hand(&self) -> f64 {
        self.hand
    }

    /// The curve in the frame of the rail marker [m].
    pub fn curve(&self) -> &Curve {
        &self.curve
    }

    /// Puts another curve in the place of the rail's, in the frame of the marker; the marker stays
    /// where it is.
    ///
    /// `put` fills it in; allocates nothing itself.
    pub fn put_curve<T>(&mut self, put: impl FnOnce(&mut Curve) -> T) -> T {
        let put = put(&mut self.curve);
        self.concavity = greatest_concavity(&self.curve);
        self.coarse.take(&self.curve);
        put
    }

    /// Makes room for curves through `knots` knots.
    pub fn reserve(&mut self, knots: usize) {
        self.curve.reserve(knots);
    }

    /// A curve in the frame of the marker as it was before it was inclined, placed and mirrored.
    pub fn unplaced(&self, curve: &Curve) -> Curve {
        let knots: Vec<Knot> = curve
            .knots()
            .map(|s| {
                let p = curve.at(s);
                let direction = [self.hand * p.first[0], p.first[1]];
                Knot { s, point: self.profile_point(p.point), tangent: self.unturned(direction) }
            })
            .collect();
        if self.hand > 0.0 {
            return Curve::through(&knots);
        }
        let backwards = knots.iter().rev().map(|k| Knot {
            s: -k.s,
            tangent: [-k.tangent[0], -k.tangent[1]],
            ..*k
        });
        Curve::through(&backwards.collect::<Vec<Knot>>())
    }

    /// Point on the rail profile as given, before inclination, of a `point` in the frame of the
    /// marker [m].
    pub fn profile_point(&self, point: [f64; 2]) -> [f64; 2] {
        self.unturned([self.hand * point[0] + self.top[0], point[1] + self.top[1]])
    }

    /// A vector turned back by the inclination.
    fn unturned(&self, [y, z]: [f64; 2]) -> [f64; 2] {
        let [sine, cosine] = self.inclination;
        [y * cosine + z * sine, z * cosine - y * sine]
    }

    /// A point of a profile as given in the frame of the marker [m].
    pub fn placed_point(&self, [y, z]: [f64; 2]) -> [f64; 2] {
        let [sine, cosine] = self.inclination;
        let turned = [y * cosine - z * sine, y * sine + z * cosine];
        [self.hand * (turned[0] - self.top[0]), turned[1] - self.top[1]]
    }

    /// A direction of a profile as given in the frame of the marker.
    pub fn placed_direction(&self, [y, z]: [f64; 2]) -> [f64; 2] {
        let [sine, cosine] = self.inclination;
        [self.hand * (y * cosine - z * sine), y * sine + z * cosine]
    }

    /// The rail whose section varies as `slices` say, which stands as that of their first one does,
    /// with its `corrugation` over the station on top, under the `wheel`.
    #[must_use]
    pub fn varying(self, slices: &Slices, corrugation: Waviness, wheel: &WheelAbove) -> Self {
        self.of_slices(slices, wheel, 0.0, corrugation)
    }

    /// The rail with `profile` around a roller, whose axle crosses the origin of the track frame
    /// `radius` [m] below the marker, with its `corrugation` over the arc of the marker's circle,
    /// under the `wheel`.
    #[must_use]
    pub fn on_roller(
        self,
        profile: &Profile,
        corrugation: Waviness,
        wheel: &WheelAbove,
        radius: f64,
    ) -> Self {
        let slices = Slices::even(profile, VaryingRail::range_of_roller(radius));
        self.of_slices(&slices, wheel, radius, corrugation)
    }

    fn of_slices(
        mut self,
        slices: &Slices,
        wheel: &WheelAbove,
        roller_radius: f64,
        corrugation: Waviness,
    ) -> Self {
        let varying = VaryingRail::new(
            slices,
            |point| self.placed_point(point),
            |direction| self.placed_direction(direction),
            self.hand < 0.0,
            wheel,
            roller_radius,
            corrugation,
        );
        self.reserve(varying.most_knots());
        let hollow = |profile: &Profile| greatest_concavity(&profile.curve);
        let hollowest = slices.slices().iter().map(|slice| hollow(&slice.profile));
        self.concavity = hollowest.fold(self.concavity, f64::max);
        self.varying = Some(Box::new(varying));
        self
    }

    /// What varies along the track, where anything does.
    pub fn variation(&self) -> Option<&VaryingRail> {
        self.varying.as_deref()
    }

    /// Places on the section by their arc, which stays on the rail as a wheel moves on one that
    /// varies.
    pub fn arcs(&self) -> ArcLength<'_> {
        let arcs = ArcLength::new(&self.curve);
        match self.variation() {
            None => arcs,
            Some(varying) => {
                let [s, arc] = varying.mark();
                arcs.counted(s, arc)
            }
        }
    }

    /// Distance of the marker from the axle of a roller; 0 for a rail [m].
    pub fn roller_radius(&self) -> f64 {
        self.varying.as_ref().map_or(0.0, |varying| varying.roller_radius())
    }

    /// Whether the section is another one at other stations.
    pub fn varies_along_track(&self) -> bool {
        self.varying.is_some() && self.roller_radius() == 0.0
    }

    /// Whether the wheel above has waves.
    pub fn wheel_has_waves(&self) -> bool {
        self.varying.as_ref().is_some_and(|varying| varying.wheel_has_waves())
    }

    /// Takes axes along the rows of a rail that varies near a wheel that stands at `pose`, `x` from
    /// the origin of a track that is at the station `origin` [m]; nothing for others.
    pub fn approach(&mut self, pose: &WheelPose, place: [f64; 2]) {
        if let Some(varying) = &mut self.varying {
            varying.approach(pose, place);
        }
    }

    /// The axes along the rows near the wheel that was to pass last, where these drift or rise: its
    /// outline and the wheel are seen in these.
    pub fn course(&self) -> Option<&Course> {
        self.varying.as_ref()?.course()
    }

    /// Takes the outline of a rail that varies as the wheel of `line` meets it, after
    /// [`approach`](Self::approach): it stands at `pose` in the axes along the rows, `x` from the
    /// origin of a track that is at the station `origin` [m], turned by `pitch` [rad]; nothing for
    /// others. False where there is no rail within reach.
    pub fn pass(
        &mut self,
        line: &ContactLine,
        pose: &WheelPose,
        [origin, x]: [f64; 2],
        pitch: f64,
    ) -> bool {
        let Self { curve, coarse, varying, .. } = self;
        let Some(varying) = varying else { return true };
        let is_there = varying.pass(line, pose, [origin, x], pitch, curve);
        coarse.take(curve);
        is_there
    }

    /// Lateral coordinate on the rail profile as given, before inclination, of a `point` in the
    /// frame of the marker [m].
    pub fn profile_y_of<T: Real>(&self, [y, z]: [T; 2]) -> T {
        let [sine, cosine] = self.inclination;
        if T::IS_BACKWARD {
            let place = leaves::of_rail(self.number);
            let constants = [sine, cosine, self.top[0], self.top[1]];
            let [sine, cosine, top_y, top_z] =
                [0, 1, 2, 3].map(|n| T::known(constants[n], place[n]));
            return (y * self.hand + top_y) * cosine + (z + top_z) * sine;
        }
        (y * self.hand + self.top[0]) * cosine + (z + self.top[1]) * sine
    }

    /// Curvature at `s`, positive where the rail bulges [1/m].
    pub fn curvature<T: Real>(&self, s: T) -> T {
        self.curve.at(s).curvature()
    }

    /// A parameter near the point of the rail nearest to `point`, for a search without a neighbour.
    pub fn coarse_nearest(&self, point: [f64; 2]) -> f64 {
        self.coarse.nearest(&self.curve, point)
    }

    /// The point of the rail nearest to `point` [m] of all, to within `tolerance` [m].
    pub fn nearest_of_all(&self, point: [f64; 2], tolerance: f64) -> Nearest {
        self.coarse.nearest_of_all(&self.curve, point, tolerance)
    }

    /// Whether a `point` lies across within what the rail's curve ends at: below the curve it is
    /// inside then.
    pub fn is_between_ends(&self, [y, _]: [f64; 2]) -> bool {
        let [a, b] = [self.curve.start(), self.curve.end()].map(|s| self.curve.at(s).point[0]);
        y > a.min(b) && y < a.max(b)
    }

    /// The point of the rail nearest to `point` [m], found from the parameter `guess` near it, to
    /// within `tolerance` [m].
    #[inline]
    pub fn nearest(&self, point: [f64; 2], guess: f64, tolerance: f64) -> Nearest {
        nearest(&self.curve, point, guess, tolerance)
    }
}

/// The point of least z, exact within its cubic piece, and its parameter.
fn highest_point(curve: &Curve) -> ([f64; 2], f64) {
    let knots: Vec<f64> = curve.knots().collect();
    let mut best = (curve.at(knots[0]).point, knots[0]);
    for pair in knots.windows(2) {
        let mut consider = |s: f64| {
            let p = curve.at(s).point;
            if p[1] < best.0[1] {
                best = (p, s);
            }
        };
        consider(pair[1]);
        let slope = |s: f64| curve.at(s).first[1];
        // The piece of the left knot is meant at its right end too.
        let inner = pair[1] - 1e-9 * (pair[1] - pair[0]);
        let (a, b) = (slope(pair[0]), slope(inner));
        if a < 0.0 && b > 0.0 {
            consider(crate::math::root::bracketed((pair[0], a), (inner, b), 1e-16, slope));
        }
    }
    best
}

/// Greatest concave curvature over the ends and middles of all pieces, ≥ 0.
fn greatest_concavity(curve: &Curve) -> f64 {
    curve
        .spans()
        .flat_map(|k| [0.001, 0.25, 0.5, 0.75, 0.999].map(|share| k[0] + share * (k[1] - k[0])))
        .map(|s| -curve.at(s).curvature())
        .fold(0.0, f64::max)
}
