//! Places of a row about the axle of the wheel above it, and points of the wheel opposite.

use super::over::Over;
use super::waves::WheelWaves;
use crate::geometry::curves::curve::CurvePoint;
use crate::geometry::wheel::contact_line::ContactLine;
use crate::math::real::Real;

/// Newton steps to a point of the profile, the longest of them, and the way over which its slope
/// changes evenly [m].
const MAX_STEPS: usize = 12;
const LONGEST_STEP: f64 = 1e-3;
const PARABOLA: f64 = 1e-8;
/// Least share of its parameter by which the profile goes across: a flank that stands upright is
/// not looked at.
const MIN_RATE: f64 = 0.1;

/// A vector by its parts along the axle, along the radius and around.
#[derive(Clone, Copy)]
pub(super) struct Parts<T> {
    pub axial: T,
    pub radial: T,
    pub around: T,
}

/// A place of a row about the axle.
#[derive(Clone, Copy)]
pub(super) struct Polar<T> {
    /// Coordinate along the axle and distance from it [m].
    pub axial: T,
    pub radius: T,
    /// Of the angle forward from straight below.
    pub sine: T,
    pub cosine: T,
}

impl<T: Real> Polar<T> {
    /// That of a point across the track at `place` under the wheel `over` it [m].
    pub fn of(over: &Over<T>, place: T, point: [T; 2]) -> Self {
        let [axial, forward, below] = over.about_axle(place, point);
        let radius = (forward * forward + below * below).sqrt();
        Self { axial, radius, sine: forward / radius, cosine: below / radius }
    }

    /// Its coordinates along the axle, forward and down [m].
    pub fn place(&self) -> [T; 3] {
        [self.axial, self.radius * self.sine, self.radius * self.cosine]
    }

    /// The parts of a vector of the track.
    pub fn parts(&self, over: &Over<T>, v: [T; 3]) -> Parts<T> {
        let [axial, forward, below] = over.axes.map(|a| a[0] * v[0] + a[1] * v[1] + a[2] * v[2]);
        self.turned([axial, forward, below])
    }

    /// Those of a vector across it.
    pub fn parts_across(&self, over: &Over<T>, v: [T; 2]) -> Parts<T> {
        self.turned(over.axes.map(|a| a[1] * v[0] + a[2] * v[1]))
    }

    fn turned(&self, [axial, forward, below]: [T; 3]) -> Parts<T> {
        Parts {
            axial,
            radial: self.sine * forward + self.cosine * below,
            around: self.cosine * forward - self.sine * below,
        }
    }
}

/// How much larger the wheel is at an angle [m], with derivatives by the way around there.
#[derive(Clone, Copy, Default)]
pub(super) struct Raised<T> {
    pub height: T,
    pub slope: T,
    pub bend: T,
    /// Derivative by the arc of the nominal rolling circle [-], and curvature of the surface, more
    /// than that of the round wheel [1/m].
    pub by_arc: T,
    pub curvature: T,
}

impl Raised<f64> {
    /// How much larger the wheel is alone [m].
    pub fn height_at(over: &Over, polar: &Polar<f64>) -> f64 {
        let of = |waves: &WheelWaves| {
            let angle = (polar.sine / polar.cosine).atan();
            waves.surface.height(waves.below + over.nominal_radius() * angle)
        };
        over.waves().map_or(0.0, of)
    }
}

impl<T: Real> Raised<T> {
    /// By the waves of the wheel `over` a place.
    pub fn at(over: &Over<T>, polar: &Polar<T>) -> Self {
        let Some(waves) = over.waves() else { return Self::default() };
        let nominal = over.nominal_radius();
        let angle = polar.sine.atan2(polar.cosine);
        let [height, slope, bend] = waves.surface.moving(waves.below + angle * nominal);
        let scale = T::from(nominal) / polar.radius;
        Self {
            height,
            slope: slope * scale,
            bend: scale * scale * bend,
            by_arc: slope,
            // Of a polar curve, whose circles beside the axle are as round.
            curvature: -(height + bend * nominal * nominal) / (polar.radius * polar.radius),
        }
    }
}

/// The point of the profile of the wheel at a coordinate along the axle.
#[derive(Clone, Copy)]
pub(super) struct OnProfile<T> {
    /// Its parameter [m].
    pub s: T,
    /// Distance from the axle [m].
    pub radius: T,
    /// dr/dt, d²r/dt² and one over dt/ds.
    pub slope: T,
    pub bend: T,
    pub rate: T,
}

impl<T: Real> OnProfile<T> {
    /// That of the wheel of `line` at the coordinate `axial`, to which the parameter `s` belongs
    /// [m].
    pub fn at(line: &ContactLine<T>, s: T, axial: T) -> Self {
        Self::beside(line, s, axial, &line.profile().at(s))
    }

    /// The same by the point `p` of the profile at the parameter `s` beside; the wheel goes on level
    /// where it ends.
    fn beside(line: &ContactLine<T>, s: T, axial: T, p: &CurvePoint<T>) -> Self {
        let rate = T::from(1.0) / p.first[0];
        let slope = p.first[1] * rate;
        let bend = (p.second[1] - slope * p.second[0]) * rate * rate;
        let missing = axial - p.point[0];
        let is_near = missing.value().abs() <= PARABOLA;
        let missing = if is_near { missing } else { T::from(0.0) };
        Self {
            s: s + missing * rate,
            radius: p.point[1] + line.nominal_radius() + missing * (slope + missing * bend * 0.5),
            slope: slope + missing * bend,
            bend,
            rate,
        }
    }
}

impl OnProfile<f64> {
    /// That of the wheel of `line` at the coordinate `axial`, sought near the parameter `s` [m]; the
    /// end of the profile where that is beside it, nothing where it stands upright.
    pub fn find(line: &ContactLine, axial: f64, s: f64) -> Option<Self> {
        let profile = line.profile();
        let mut s = profile.within(s);
        for _ in 0..MAX_STEPS {
            let p = profile.at(s);
            if p.first[0] < MIN_RATE {
                return None;
            }
            let missing = axial - p.point[0];
            let step = missing / p.first[0];
            let next = profile.within(s + step.clamp(-LONGEST_STEP, LONGEST_STEP));
            if missing.abs() <= PARABOLA || (next - s).abs() <= 0.0 {
                return Some(Self::beside(line, s, axial, &p));
            }
            s = next;
        }
        None
    }
}
