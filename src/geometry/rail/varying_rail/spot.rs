//! A place of a row, and the point of the wheel opposite to it.
//!
//! In coordinates about the axle a place of the row has the axial coordinate t, the distance ρ and
//! the angle α. The wheel has the radius r(t) there, larger by its waves e(α), so that the row is
//!
//! ```text
//! h = ρ - r(t) - e(α)
//! ```
//!
//! away from it along the radius, and p = h cos γ along the normal, γ the slope of the profile.
//! Where h is least along the row the bodies are nearest, and where they touch their normals are the
//! same.
//!
//! Seen along the rows the wheel is its contact line L(u), and the row is a point P beside it. A
//! straight row through that would be met where it is h' away along the radius of the point L(u)
//! opposite,
//!
//! ```text
//! P = L(u) + h' e_r(u)
//! ```
//!
//! and a row that bends is met elsewhere and is nearer. It is put as much lower, where it is across,
//! so that rail and contact line are as far apart as row and wheel are in space,
//!
//! ```text
//! F = P + D e,   D e_r · e = p/cos γ(u) - h'
//! ```
//!
//! with e the direction down in the plane of the rolling circles.

use super::about_axle::{OnProfile, Parts, Polar, Raised, parameter_at};
use super::over::{Over, Way};
use crate::geometry::sections::rows::along::Along;
use crate::geometry::sections::rows::met::{Gap, Met};
use crate::geometry::sections::rows::plane::dot;
use crate::geometry::sections::rows::surface::{RowPoint, Surface};
use crate::math::real::Real;

/// Least bend of a row against the wheel, over that of the wheel.
pub(super) const MIN_BEND: f64 = 0.1;

/// A row of a surface on a run of slices.
#[derive(Clone, Copy)]
pub(super) struct Row<'a> {
    pub surface: &'a Surface,
    pub number: usize,
    pub run: [usize; 2],
}

impl Row<'_> {
    /// Its point at a `place` along the track under the wheel that is `over` it [m].
    pub fn at<T: Real>(&self, over: &Over<T>, place: T) -> RowPoint<T> {
        self.surface.at(self.number, self.run, over.station + place, over.within.slice)
    }
}

/// A place of a row with the point of the wheel that is opposite.
#[derive(Clone, Copy)]
pub(super) struct Spot<T = f64> {
    /// Place along the track [m], and the row there.
    pub place: T,
    pub point: RowPoint<T>,
    /// Parameter of the profile of the wheel [m].
    pub s: T,
    /// h, its derivative along the track and that of it [m, -, 1/m].
    pub gap: T,
    pub slope: T,
    pub bend: T,
    /// The step along the track to where the bodies are nearest, if it is so short that all goes
    /// along with it evenly [m].
    pub rest: T,
    /// cos γ, and the derivatives of p by the place in space, in the axes of the track.
    cosine: T,
    normal: [T; 3],
    polar: Polar<T>,
    profile: OnProfile<T>,
    raised: Raised<T>,
    along: Parts<T>,
}

impl<T: Real> Spot<T> {
    /// The place of a row at `place` under the wheel `over` it, opposite to the parameter `s` of its
    /// profile.
    pub fn at(over: &Over<T>, row: &Row, place: T, s: T) -> Self {
        let point = row.at(over, place);
        let polar = Polar::of(over, place, [point.value[0], point.value[1]]);
        Self::opposite(over, place, point, polar, s)
    }

    fn opposite(over: &Over<T>, place: T, point: RowPoint<T>, polar: Polar<T>, s: T) -> Self {
        let raised = Raised::at(over, &polar);
        let profile = OnProfile::at(over.line(), s, polar.axial);
        let along = polar.parts(over, [T::from(1.0), point.first[0], point.first[1]]);
        let turn = polar.parts_across(over, point.second);
        let around = along.around / polar.radius;
        let rise = along.radial - raised.slope * along.around;
        let turned = turn.radial + along.around * around
            - raised.bend * along.around * along.around
            - raised.slope * (turn.around - along.radial * around * 2.0);
        let cosine = T::from(1.0) / (profile.slope * profile.slope + 1.0).sqrt();
        let (out, side) = (cosine, -(profile.slope * cosine));
        let around = -(raised.slope * cosine);
        let ahead = out * polar.sine + around * polar.cosine;
        let below = out * polar.cosine - around * polar.sine;
        Self {
            place,
            point,
            s,
            gap: polar.radius - raised.height - profile.radius,
            slope: rise - profile.slope * along.axial,
            bend: turned - profile.slope * turn.axial - profile.bend * along.axial * along.axial,
            rest: T::from(0.0),
            cosine,
            normal: over.in_space([side, ahead, below]),
            polar,
            profile,
            raised,
            along,
        }
    }

    /// How far the point of the profile is beside the row along the axle [m], and the slope of the
    /// gap: where both vanish the wheel meets the row.
    pub fn equations(&self) -> [T; 2] {
        [self.profile.missing, self.slope]
    }

    /// Derivatives of both by the place and by the parameter of the profile.
    pub fn rates(&self) -> [[T; 2]; 2] {
        let Self { profile, along: Parts { axial, .. }, .. } = self;
        let bent = profile.bend * *axial;
        [
            [*axial, T::from(-1.0) / profile.rate],
            [self.bend + bent * *axial, -(bent / profile.rate)],
        ]
    }

    /// Row `number` as it is met here, where the row ends if it `is_held`.
    pub fn met(&self, over: &Over<T>, number: usize, is_held: bool) -> Met<T> {
        let Self { point, polar, profile, raised, along, normal: space, rest, .. } = self;
        let place = self.place + *rest;
        let Way { x, rate, first: before, second } = over.way(place, point);
        let first = [0, 1].map(|i| before[i] + *rest * rate * second[i]);
        let here = self.seen(over);
        let here = [0, 1].map(|i| here[i] + *rest * rate * before[i]);
        let s = self.s + *rest * along.axial * profile.rate;
        let (line, straight) = over.opposite(here, s);
        let [dy, dz] = line.derivative;
        let size = T::from(1.0) / (dy * dy + dz * dz).sqrt();
        let tangent = [dy * size, dz * size];
        let normal = [-tangent[1], tangent[0]];
        let share = dot(normal, over.down);
        let slope = profile.slope + *rest * profile.bend * along.axial;
        let steep = |slope: T| (slope * slope + 1.0).sqrt();
        let cosine = self.cosine * steep(profile.slope) / steep(slope);
        let apart = (self.gap + *rest * self.slope * 0.5) * cosine / line.cosine;
        let lower = (apart - straight) / dot(line.radial, over.down);
        // From row to row: how the gap grows, how its slope does, by how much the place of touch
        // moves along the rows with that, and the outline with it.
        let [_, _, y, z] = point.value;
        let across = polar.parts_across(over, [y, z]);
        let twist = polar.parts_across(over, [point.first[2], point.first[3]]);
        let turn = twist.radial - profile.slope * twist.axial
            + along.around * across.around * (T::from(1.0) / polar.radius - raised.bend)
            - profile.bend * along.axial * across.axial;
        let growth = ((space[1] * y + space[2] * z) / self.cosine + *rest * turn) * cosine;
        let moved = if is_held {
            T::from(0.0)
        } else {
            -turn / self.bend.at_least(MIN_BEND / over.nominal_radius())
        };
        let on = over.across([moved, moved * point.first[0] + y, moved * point.first[1] + z]);
        let sideways =
            (dot(on, over.right) - dot(normal, over.right) * growth) / dot(tangent, over.right);
        let (lean, drift) = (-dot(normal, first), dot(tangent, first));
        // The section of the wheel along the outline's axes.
        let [axle, forward, _] = over.line().axes();
        let fall = (profile.slope * axle[0] - polar.sine * forward[0]) / polar.cosine;
        let across = profile.slope * axle[0];
        let radius = (profile.radius + raised.height) * polar.cosine;
        let section = (forward[0] * forward[0] + fall * fall - across * across)
            / (radius * (fall * fall + 1.0).three_halves());
        let sine = polar.sine + *rest * along.around * polar.cosine / polar.radius;
        let aside = self.gap * forward[0] * sine;
        let along = Along {
            ahead: x - aside - line.at.x,
            curvature: dot(normal, second) + line.curvature * drift * drift,
            lean,
            drift,
            gap: if is_held { self.slope * self.cosine / rate } else { T::from(0.0) },
            raised: raised.height,
            lever: raised.by_arc * polar.cosine * forward[0] * over.nominal_radius(),
            bulge: share * (section - line.section),
            waves: share * raised.curvature,
        };
        let height = (dot(here, over.down) + lower) - dot(line.at.point, over.down);
        let gap = Gap { height: height.value(), share: share.value(), growth: growth.value() };
        Met {
            row: number,
            point: [0, 1].map(|i| here[i] + over.down[i] * lower),
            direction: [0, 1].map(|i| tangent[i] * sideways + normal[i] * growth),
            place,
            x,
            gap,
            along,
            opposite: Some([s, polar.axial + *rest * self.along.axial]),
        }
    }

    /// Where the row is across, in the axes of the outline [m].
    fn seen(&self, over: &Over<T>) -> [T; 2] {
        let [y, z, ..] = self.point.value;
        over.beside(self.place, [y, z])
    }
}

impl<T: Real> Over<'_, T> {
    /// Row `number` at a `place` where nothing touches it, of which the `point` is that: as far from
    /// the wheel as it is there.
    pub fn aside(&self, number: usize, place: T, point: &RowPoint<T>) -> Met<T> {
        let [_, _, dy, dz] = point.value;
        let (x, direction) = match self.course() {
            None => (place, [dy, dz]),
            Some(course) => (self.way(place, point).x, course.straight_across(point)),
        };
        let [y, z, ..] = point.value;
        let here = self.beside(place, [y, z]);
        let depth = dot(self.seen_from_marker(here), self.down);
        let raised =
            Raised::at(self, &Polar::of(self, place, [point.value[0], point.value[1]])).height;
        let lower = (x * x + depth * depth).sqrt() - depth - raised;
        Met {
            row: number,
            point: [0, 1].map(|i| here[i] + lower * self.down[i]),
            direction,
            place,
            x,
            gap: Gap { height: f64::INFINITY, share: 1.0, growth: 0.0 },
            ..Met::default()
        }
    }
}

impl Spot {
    /// The place of a row at `place` under the wheel `over` it, with the point of the wheel
    /// opposite, sought near the parameter of its profile that `near` tells by the axial coordinate;
    /// nothing where the wheel stands upright or nothing of it is opposite.
    pub fn find(
        over: &Over,
        row: &Row,
        place: f64,
        near: impl FnOnce(f64) -> Option<f64>,
    ) -> Option<Self> {
        let point = row.at(over, place);
        let polar = Polar::of(over, place, [point.value[0], point.value[1]]);
        let s = parameter_at(over.line(), polar.axial, near(polar.axial)?)?;
        let spot = Self::opposite(over, place, point, polar, s);
        if over.varies_around() { spot.around(over) } else { Some(spot) }
    }

    /// The same place opposite to a wheel whose section varies around.
    fn around(self, over: &Over) -> Option<Self> {
        let Polar { sine, cosine, .. } = self.polar;
        let found = over.line().along_radius(self.polar.place(), [self.s, -self.gap])?;
        let Raised { height, slope, .. } = self.raised;
        let gap = -found.depth - height;
        let [_, ahead, below] = found.normal;
        let facing = ahead * sine + below * cosine;
        let normal = over.in_space(found.normal);
        let [y, z] = [self.point.first[0], self.point.first[1]];
        let rise = (normal[0] + normal[1] * y + normal[2] * z) / facing;
        Some(Self {
            s: found.s,
            gap,
            slope: rise - slope * self.along.around,
            cosine: facing,
            normal,
            raised: Raised { height: height + self.gap - gap, ..self.raised },
            ..self
        })
    }

    /// Row `number` as it is met here: of a wheel whose section varies around by how that goes on.
    pub fn found(&self, over: &Over, number: usize, is_held: bool) -> Met {
        let met = self.met(over, number, is_held);
        if !over.varies_around() {
            return met;
        }
        let line = over.line();
        // At the point of the wheel that is opposite.
        let across = over.seen_from_marker(line.even_at(self.s).point);
        let [y, z] = [over.right, over.down].map(|axis| dot(across, axis));
        let beside = over.beside_marker(y);
        let below = |x: f64| line.wheel_below(x, beside, [over.right, over.down], [self.s, z]);
        let on_line = met.x - met.along.ahead;
        let (Some(here), Some(there)) = (below(met.x), below(on_line)) else { return met };
        let [here_bent, there_bent] =
            [here, there].map(|b| -b.bend / (b.slopes[0] * b.slopes[0] + 1.0).three_halves());
        // How far the wheel is beyond the circle of its contact line there, and the round one beyond
        // its own.
        let ahead = line.ahead_of_round(self.s);
        let beyond = |away: f64, depth: f64| (away * away + depth * depth).sqrt() - z;
        let round = line.round_below(met.x, y, self.s);
        let round = round.map_or(0.0, |depth| beyond(met.x - on_line + ahead, depth));
        let along = Along {
            raised: beyond(met.x - on_line, here.depth) - round,
            lever: line.lever([met.x, y], &here) - ahead,
            bulge: met.gap.share * (here_bent - there_bent),
            ..met.along
        };
        Met { along, ..met }
    }

    /// How far the row is from the wheel along the radius at the `point` at `place`, whose profile
    /// goes on straight from here [m].
    pub fn height(&self, over: &Over, place: f64, point: &RowPoint) -> f64 {
        let polar = Polar::of(over, place, [point.value[0], point.value[1]]);
        let raised = Raised::at(over, &polar).height;
        let away = polar.radius - raised - self.profile.radius;
        let aside = polar.axial - self.polar.axial;
        let straight = away - self.profile.slope * aside;
        if !over.varies_around() {
            return straight;
        }
        let found = over.line().along_radius(polar.place(), [self.s, -straight]);
        found.map_or(straight, |found| -found.depth - raised)
    }

    /// Coordinate of the row along the axle [m].
    pub fn axial(&self) -> f64 {
        self.polar.axial
    }

    /// Parameter of the profile about opposite after a `way` along the track [m].
    pub fn parameter_after(&self, way: f64) -> f64 {
        self.s + way * self.along.axial * self.profile.rate
    }

    /// By how much the wheel is larger here than the round one [m].
    pub fn raised(&self) -> f64 {
        self.raised.height
    }
}
