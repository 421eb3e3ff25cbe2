//! The contact line of a yawed and rolled wheel: the points at which it can touch a rail that is a
//! cylinder along x.
//!
//! The wheel is the surface of revolution X(s, α) = M + y_w(s) u + r(s) n(α) about the axle
//! direction u through the marker M, with n(α) the radial direction. A cylinder along x can only be
//! touched where the normal of the wheel has no component along x. The normal is y_w' n - r' u, so
//! that with n = e1 sin α + e2 cos α (e1 the projection of x on the plane of the rolling circles,
//! e2 perpendicular to x in that plane, down)
//!
//! ```text
//! sin α = r' u_x / (y_w' c),  c = sqrt(1 - u_x²)
//! ```
//!
//! This is the outline of the wheel as seen along the rail (Piotrowski and Kik 2008, figure 16).
//! Its points lie ahead of or behind the axle by r tan(contact angle) sin(yaw), which the lowest
//! points of the rolling circles would miss. A face steeper than 87 degrees, a flange back, touches
//! with its rim: see `contact_line::rim`.

mod around;
mod normal_section;
mod rim;
pub mod surface;

use crate::geometry::curves::curve::{Curve, CurvePoint};
use crate::geometry::wheel::varying_wheel::VaryingWheel;
pub use crate::geometry::wheel::wheel_pose::WheelPose;
use crate::math::numbers::{Numbers, numbers};
use crate::math::real::Real;

/// Below this cosine of the profile's slope (87 degrees) the line is followed by height instead of
/// by slope.
const MIN_SLOPE_COSINE: f64 = 0.05;
/// Largest |sin α|: contact never comes near the height of the axle.
const MAX_SINE: f64 = 0.9;
/// Half length of the profile over which its curvature is averaged at a rim, where it varies around
/// and where a flange back ends: profiles jump in curvature, and the force must not [m].
const CURVATURE_REACH: f64 = 2e-3;
/// Half length along x over which the section of a yawed wheel is taken for an arc, that of a strip;
/// it passes over the profile by its share. Least half length of the profile that tells its
/// curvature [m].
const SECTION_REACH: f64 = 5e-3;
const LEAST_REACH: f64 = 1e-4;
/// Least curvature of the section along x over that of the straight wheel: in a flange root at
/// large yaw the outline folds.
const MIN_SECTION_SHARE: f64 = 0.1;

/// The contact line of a wheel in a given pose.
#[derive(Clone, Copy, Debug)]
pub struct ContactLine<'a, T = f64> {
    profile: &'a Curve,
    nominal_radius: f64,
    marker: [T; 3],
    /// Axle direction u.
    axle: [T; 3],
    /// c = sqrt(1 - u_x²).
    cosine: T,
    /// u_x / c.
    lead: T,
    /// (y, z) of e1, the projection of x on the planes of the rolling circles.
    ahead: [T; 2],
    /// (y, z) of e2, the direction down, across x and the axle.
    down: [T; 2],
    /// The wheel whose section varies around, of which the profile is that of the round wheel that
    /// takes its place.
    around: Option<&'a VaryingWheel>,
}

numbers!(
    ContactLine<'a>: marker, axle, cosine, lead, ahead, down; kept profile, nominal_radius, around
);

/// The point of a rolling circle that belongs to the line.
struct OnCircle<T> {
    radius: T,
    /// One over y_w', as far as the slope is followed.
    flatness: T,
    /// Slope of the profile.
    slope: T,
    /// sin α and cos α.
    sine: T,
    cosine: T,
    /// (y, z) of the radial direction n.
    radial: [T; 2],
}

/// A point of the contact line.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct LinePoint<T = f64> {
    /// Coordinate along the track [m].
    pub x: T,
    /// Point (y, z) across [m].
    pub point: [T; 2],
    /// Tangent (y, z), towards the field side, of length close to one.
    pub tangent: [T; 2],
}

/// A point of the contact line of a round wheel with its derivatives by the parameter.
pub(in crate::geometry) struct Followed<T> {
    pub at: LinePoint<T>,
    /// Derivative of (y, z).
    pub derivative: [T; 2],
    /// (y, z) of the radial direction, and the derivative of that [1/m].
    pub radial: [T; 2],
    pub turning: [T; 2],
    /// Cosine of the profile's slope.
    pub cosine: T,
    /// Curvature of the profile, positive where it bulges [1/m].
    pub curvature: T,
    /// Curvature of the section along the track, but for what the profile is curved across a wheel
    /// that yaws; positive where it bulges [1/m].
    pub section: T,
}

impl<'a, T: Real> ContactLine<'a, T> {
    /// The contact line of the wheel with profile `profile` and radius `nominal_radius` of its
    /// nominal rolling circle [m].
    pub fn new(profile: &'a Curve, nominal_radius: f64, pose: &WheelPose<T>) -> Self {
        let (sin_roll, cos_roll) = pose.roll.sin_cos();
        let (sin_yaw, cos_yaw) = pose.yaw.sin_cos();
        // R_x(roll) R_z(yaw) e_y
        let axle = [-sin_yaw, cos_yaw * cos_roll, cos_yaw * sin_roll];
        // An axle along the track has no such line: kept away from zero, the result stays finite.
        let cosine = axle[1].hypotenuse(axle[2]).at_least(1e-9);
        Self {
            profile,
            nominal_radius,
            marker: pose.marker,
            axle,
            cosine,
            lead: axle[0] / cosine,
            ahead: [-axle[0] * axle[1] / cosine, -axle[0] * axle[2] / cosine],
            down: [-axle[2] / cosine, axle[1] / cosine],
            around: None,
        }
    }

    /// Radius of the nominal rolling circle [m].
    pub fn nominal_radius(&self) -> f64 {
        self.nominal_radius
    }

    /// Range of the parameter of the line, which is that of the profile [m].
    pub fn range(&self) -> [f64; 2] {
        [self.profile.start(), self.profile.end()]
    }

    /// The point at parameter `s` [m].
    #[inline]
    pub fn at(&self, s: T) -> LinePoint<T> {
        let p = self.profile.at(s);
        let on = self.circle(&p);
        let point =
            if self.follows_rim(&p) { self.rim(s, &p, &on).point() } else { self.point(&p, &on) };
        self.met(s, point)
    }

    /// The point at parameter `s` [m] and the derivative of its (y, z).
    #[inline]
    pub fn with_derivative(&self, s: T) -> (LinePoint<T>, [T; 2]) {
        let p = self.profile.at(s);
        if self.follows_rim(&p) {
            let rim = self.rim(s, &p, &self.circle(&p));
            return (self.met(s, rim.point()), rim.derivative());
        }
        let (point, derivative) = self.outline_with_derivative(&p);
        (self.met(s, point), derivative)
    }

    /// The point at parameter `s` [m] with its derivatives.
    pub(in crate::geometry) fn followed(&self, s: T) -> Followed<T> {
        let p = self.profile.at(s);
        let on = self.circle(&p);
        let curvature = -p.curvature();
        if self.follows_rim(&p) {
            let rim = self.rim(s, &p, &on);
            return Followed {
                at: self.met(s, rim.point()),
                derivative: rim.derivative(),
                radial: on.radial,
                turning: [T::from(0.0); 2],
                cosine: slope_cosine(&p),
                curvature,
                section: T::from(0.0),
            };
        }
        let (point, derivative) = self.outline_with_derivative(&p);
        let across = on.slope * self.axle[0];
        let turning = self.turning(&p, &on);
        Followed {
            at: self.met(s, point),
            derivative,
            radial: on.radial,
            turning: [0, 1].map(|i| turning * (self.ahead[i] - self.down[i] * on.sine / on.cosine)),
            cosine: slope_cosine(&p),
            curvature,
            section: (self.cosine * self.cosine - across * across) / (on.radius * on.cosine),
        }
    }

    /// Directions along the axle, forward and down.
    pub(in crate::geometry) fn axes(&self) -> [[T; 3]; 3] {
        let zero = T::from(0.0);
        [self.axle, [self.cosine, self.ahead[0], self.ahead[1]], [zero, self.down[0], self.down[1]]]
    }

    /// Place along the track of the point of the line on the rolling circle at the coordinate
    /// `axial` along the axle, where the profile has the `height` and the `slope` [m].
    pub(in crate::geometry) fn place_on_circle(&self, axial: T, height: T, slope: T) -> T {
        let sine = (slope * self.lead).within(-MAX_SINE, MAX_SINE);
        self.marker[0] + axial * self.axle[0] + (height + self.nominal_radius) * self.cosine * sine
    }

    /// Place along the track of the line of a round wheel at parameter `s` [m].
    pub fn place(&self, s: T) -> T {
        let p = self.profile.at(s);
        if self.follows_rim(&p) {
            return self.at(s).x;
        }
        let slope = p.first[1] / p.first[0].at_least(MIN_SLOPE_COSINE);
        self.place_on_circle(p.point[0], p.point[1], slope)
    }

    /// The profile of the wheel.
    pub(in crate::geometry) fn profile(&self) -> &'a Curve {
        self.profile
    }

    /// The point that belongs to the profile point `p`, which is on no rim, and the derivative of
    /// its (y, z).
    // Inside each instruction set or not at all: a call would not be vectorised.
    #[inline(always)]
    pub(in crate::geometry) fn outline_with_derivative(
        &self,
        p: &CurvePoint<T>,
    ) -> (LinePoint<T>, [T; 2]) {
        let on = self.circle(p);
        let [_, uy, uz] = self.axle;
        let turning = self.turning(p, &on);
        let sideways = on.radius * turning / on.cosine;
        let across = |i: usize, axle: T| {
            p.first[0] * axle
                + p.first[1] * on.radial[i]
                + sideways * (self.ahead[i] * on.cosine - self.down[i] * on.sine)
        };
        (self.point(p, &on), [across(0, uy), across(1, uz)])
    }

    /// d sin α/ds where neither bound is active.
    #[inline(always)]
    fn turning(&self, p: &CurvePoint<T>, on: &OnCircle<T>) -> T {
        if on.sine.value().abs() < MAX_SINE && p.first[0] > MIN_SLOPE_COSINE {
            self.lead * (p.second[1] - on.slope * p.second[0]) * on.flatness
        } else {
            T::from(0.0)
        }
    }

    /// Where on its rolling circle the profile point `p` belongs to the line.
    #[inline(always)]
    fn circle(&self, p: &CurvePoint<T>) -> OnCircle<T> {
        let radius = p.point[1] + self.nominal_radius;
        let flatness = T::from(1.0) / p.first[0].at_least(MIN_SLOPE_COSINE);
        let slope = p.first[1] * flatness;
        let sine = (slope * self.lead).within(-MAX_SINE, MAX_SINE);
        let cosine = (-(sine * sine) + 1.0).sqrt();
        let radial = [
            self.ahead[0] * sine + self.down[0] * cosine,
            self.ahead[1] * sine + self.down[1] * cosine,
        ];
        OnCircle { radius, flatness, slope, sine, cosine, radial }
    }

    #[inline(always)]
    fn point(&self, p: &CurvePoint<T>, on: &OnCircle<T>) -> LinePoint<T> {
        let [ux, uy, uz] = self.axle;
        LinePoint {
            x: self.marker[0] + p.point[0] * ux + on.radius * self.cosine * on.sine,
            point: [
                self.marker[1] + p.point[0] * uy + on.radius * on.radial[0],
                self.marker[2] + p.point[0] * uz + on.radius * on.radial[1],
            ],
            // The normal y_w' n - r' u, turned by a quarter; as long as the profile's derivative,
            // which is close to one.
            tangent: [
                p.first[0] * on.radial[1] - p.first[1] * uz,
                p.first[1] * uy - p.first[0] * on.radial[0],
            ],
        }
    }

    /// Profile point of parameter `s`: lateral coordinate, rolling radius and the radius R of the
    /// normal section along x [m].
    ///
    /// ```text
    /// 1/R = cos γ cos α c²/r + κ (u_x/cos γ)²/cos α
    /// ```
    ///
    /// with γ the slope of the profile and κ its curvature: beside its place on the circle, a point
    /// ahead of the axle is one of another circle of a yawed wheel. On a straight wheel R = r/cos
    /// γ.
    pub fn wheel_point(&self, s: T) -> WheelPoint<T> {
        let p = self.profile.at(s);
        if self.follows_rim(&p) {
            return self.rim(s, &p, &self.circle(&p)).wheel_point();
        }
        let radius = p.point[1] + self.nominal_radius;
        let slope_cosine = (p.first[0] / speed_squared(p.first).sqrt()).at_least(MIN_SLOPE_COSINE);
        let straight = slope_cosine / radius;
        let section_curvature = if self.is_straight() {
            straight
        } else {
            let on = self.circle(&p);
            let across = self.cosine * self.lead / slope_cosine;
            let reach = (across * SECTION_REACH).hypotenuse(T::from(LEAST_REACH));
            let bent = straight * on.cosine * self.cosine * self.cosine
                + self.mean_curvature_over(s, reach) * across * across / on.cosine;
            bent.max(straight * MIN_SECTION_SHARE)
        };
        let section_curvature = self.section_around(s, section_curvature, straight);
        WheelPoint {
            y: p.point[0],
            rolling_radius: radius,
            section_radius: T::from(1.0) / section_curvature,
        }
    }

    /// Curvature of the profile about `s`, from its turn over [`CURVATURE_REACH`] to either side;
    /// positive where it bulges [1/m].
    fn mean_curvature(&self, s: T) -> T {
        self.mean_curvature_over(s, T::from(CURVATURE_REACH))
    }

    /// The same from its turn over `reach` to either side.
    fn mean_curvature_over(&self, s: T, reach: T) -> T {
        let [start, end] = self.range();
        let (from, to) = ((s - reach).at_least(start), (s + reach).at_most(end));
        let (a, b) = (self.profile.at(from).first, self.profile.at(to).first);
        // The sine of the turn, which stays far below a right angle.
        (a[1] * b[0] - a[0] * b[1]) / ((speed_squared(a) * speed_squared(b)).sqrt() * (to - from))
    }

    /// Curvature of the profile at `s`, positive where it bulges out of the wheel [1/m].
    pub fn curvature(&self, s: T) -> T {
        -self.profile.at(s).curvature()
    }

    /// Whether the wheel does not yaw, and would not if it yawed a little: derivatives by yaw are
    /// those of a line that leads.
    #[inline]
    fn is_straight(&self) -> bool {
        !T::HAS_SLOPES && self.lead == 0.0
    }

    /// The same line without derivatives.
    pub fn value(&self) -> ContactLine<'a> {
        self.each(&mut T::value)
    }
}

impl<'a> ContactLine<'a> {
    /// The same line in other numbers, which do not move.
    pub fn fixed<T: Real>(&self) -> ContactLine<'a, T> {
        self.each(&mut T::from)
    }

    /// What the profile at `p` contributes to the length of the line per parameter beyond one,
    /// times [`stretch_per_factor`](Self::stretch_per_factor): a yawed outline runs fast where the
    /// profile is steep and curved [1/m].
    pub fn stretch_factor(p: &CurvePoint) -> f64 {
        if p.first[0] <= MIN_SLOPE_COSINE {
            return 0.0;
        }
        let slope = p.first[1] / p.first[0];
        let turning = (p.second[1] - slope * p.second[0]).abs() / p.first[0];
        turning * (1.0 + slope.abs())
    }

    /// Bound of the length of (y, z) of the line per parameter beyond one, over
    /// [`stretch_factor`](Self::stretch_factor) [m].
    pub fn stretch_per_factor(&self) -> f64 {
        let least_cosine = (1.0 - MAX_SINE * MAX_SINE).sqrt();
        // No profile reaches beyond twice the nominal radius.
        2.0 * self.nominal_radius * self.lead * self.lead / least_cosine
    }
}

/// Cosine of the slope of a profile.
fn slope_cosine<T: Real>(p: &CurvePoint<T>) -> T {
    p.first[0] / speed_squared(p.first).sqrt()
}

/// Square of the length of a profile's derivative, which is close to one.
#[inline]
fn speed_squared<T: Real>(first: [T; 2]) -> T {
    first[0] * first[0] + first[1] * first[1]
}

/// A point of the wheel's profile.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct WheelPoint<T = f64> {
    /// Lateral coordinate on the wheel profile [m].
    pub y: T,
    /// Distance from the axle [m].
    pub rolling_radius: T,
    /// Radius of the wheel's normal section along x [m].
    pub section_radius: T,
}
