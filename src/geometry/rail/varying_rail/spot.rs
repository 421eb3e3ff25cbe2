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

use super::about_axle::{OnProfile, Parts, Polar, Raised};
use super::over::{Over, Way};
use crate::geometry::sections::rows::along::Along;
use crate::geometry::sections::rows::met::{Gap, Met, Opposite, Untouched};
use crate::geometry::sections::rows::plane::dot;
use crate::geometry::sections::rows::surface::{RowPoint, Surface};
use crate::math::real::Real;

/// Least bend of a row against the wheel where it is met, over that of the wheel: by less it lies
/// flat on it, and any place is as good.
const MIN_BEND: f64 = 1e-3;

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

    /// Its point (y, z) there alone [m].
    pub fn point(&self, over: &Over, place: f64) -> [f64; 2] {
        self.surface.point(self.number, self.run, over.station + place, over.within.slice)
    }
}

/// A place of a row with the point of the wheel that is opposite.
#[derive(Clone, Copy)]
pub(super) struct Spot<T = f64> {
    /// Place along the track [m], and the row there.
    pub place: T,
    pub point: RowPoint<T>,
    /// h, its derivative along the track and that of it [m, -, 1/m].
    pub gap: T,
    pub slope: T,
    pub bend: T,
    /// cos γ, and by how much the wheel gets larger along the axle and around.
    cosine: T,
    grows: [T; 2],
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
        let profile = OnProfile::at(over.line(), s, polar.axial);
        Self::opposite(over, place, point, polar, profile)
    }

    fn opposite(
        over: &Over<T>,
        place: T,
        point: RowPoint<T>,
        polar: Polar<T>,
        profile: OnProfile<T>,
    ) -> Self {
        let raised = Raised::at(over, &polar);
        let along = polar.parts(over, [T::from(1.0), point.first[0], point.first[1]]);
        let turn = polar.parts_across(over, point.second);
        let around = along.around / polar.radius;
        let turned = turn.radial + along.around * around
            - raised.bend * along.around * along.around
            - raised.slope * (turn.around - along.radial * around * 2.0);
        let grows = [profile.slope, raised.slope];
        Self {
            place,
            point,
            gap: polar.radius - raised.height - profile.radius,
            slope: apart(along, grows),
            bend: turned - profile.slope * turn.axial - profile.bend * along.axial * along.axial,
            cosine: T::from(1.0) / (profile.slope * profile.slope + 1.0).sqrt(),
            grows,
            polar,
            profile,
            raised,
            along,
        }
    }

    /// Parameter of the profile about opposite after a `way` along the track [m].
    pub fn parameter_after(&self, way: T) -> T {
        self.profile.s + way * self.along.axial * self.profile.rate
    }

    /// The Newton step along the track to where the bodies are nearest [m].
    pub fn rest(&self, over: &Over<T>) -> T {
        -self.slope / self.bend.at_least(MIN_BEND / over.nominal_radius())
    }

    /// Row `number` as it is met the way `rest` along the track from here [m], so short that all
    /// goes along with it evenly; here, where the row ends, if nothing is left.
    pub fn met(&self, over: &Over<T>, number: usize, rest: Option<T>) -> Met<T> {
        let Self { point, polar, profile, raised, along, .. } = self;
        let way = rest.unwrap_or_default();
        let Way { x, rate, first: before, second } = over.way(self.place, point);
        let step = way * rate;
        let first = [0, 1].map(|i| before[i] + step * second[i]);
        let here = over.beside(self.place, [point.value[0], point.value[1]]);
        let here = [0, 1].map(|i| here[i] + step * (before[i] + first[i]) * 0.5);
        let aside = way * along.axial;
        let (s, steeper) = (profile.s + aside * profile.rate, aside * profile.bend);
        let slope = profile.slope + steeper;
        let cosine = self.cosine * (-(profile.slope * steeper * self.cosine * self.cosine) + 1.0);
        let (line, straight) = over.opposite(here, s);
        let [dy, dz] = line.derivative;
        let size = T::from(1.0) / (dy * dy + dz * dz).sqrt();
        let tangent = [dy * size, dz * size];
        let normal = [-tangent[1], tangent[0]];
        let share = dot(normal, over.down);
        let nearest = self.gap + way * self.slope * 0.5;
        let lower = (nearest * cosine / line.cosine - straight) / dot(line.radial, over.down);
        // From row to row: how the gap grows, how its slope does, by how much the place of touch
        // moves along the rows with that, and the outline with it.
        let [_, _, y, z] = point.value;
        let across = polar.parts_across(over, [y, z]);
        let twist = polar.parts_across(over, [point.first[2], point.first[3]]);
        let turn = twist.radial - profile.slope * twist.axial
            + along.around * across.around * (T::from(1.0) / polar.radius - raised.bend)
            - profile.bend * along.axial * across.axial;
        let growth = (apart(across, self.grows) + way * turn) * cosine;
        let moved = rest
            .map_or(T::from(0.0), |_| -turn / self.bend.at_least(MIN_BEND / over.nominal_radius()));
        let on = [0, 1].map(|i| {
            let along = point.first[i] + way * point.second[i];
            moved * along + point.value[2 + i] + way * point.first[2 + i]
        });
        let on = over.across([moved, on[0], on[1]]);
        let sideways =
            (dot(on, over.right) - dot(normal, over.right) * growth) / dot(tangent, over.right);
        let (lean, drift) = (-dot(normal, first), dot(tangent, first));
        // The section of the wheel along the outline's axes.
        let [axle, forward, _] = over.line().axes();
        let sine = polar.sine + way * along.around * polar.cosine / polar.radius;
        let fall = (slope * axle[0] - sine * forward[0]) / polar.cosine;
        let skew = slope * axle[0];
        let radius = (profile.radius + raised.height) * polar.cosine;
        let section = (forward[0] * forward[0] + fall * fall - skew * skew)
            / (radius * (fall * fall + 1.0).three_halves());
        let met = Along {
            ahead: x + step - self.gap * forward[0] * sine - line.at.x,
            curvature: dot(normal, second) + line.curvature * drift * drift,
            lean,
            drift,
            gap: rest.map_or_else(|| self.slope * self.cosine / rate, |_| T::from(0.0)),
            raised: raised.height,
            lever: raised.by_arc * polar.cosine * forward[0] * over.nominal_radius(),
            bulge: share * (section - line.section),
            waves: share * raised.curvature,
        };
        let height = (dot(here, over.down) + lower) - dot(line.at.point, over.down);
        let gap = Gap { height: height.value(), share: share.value(), growth: growth.value() };
        let opposite = Opposite {
            place: self.place.value(),
            s: profile.s.value(),
            axial: polar.axial.value(),
            rest: way.value(),
        };
        Met {
            row: number,
            point: [0, 1].map(|i| here[i] + over.down[i] * lower),
            direction: [0, 1].map(|i| tangent[i] * sideways + normal[i] * growth),
            x: x + step,
            gap,
            along: met,
            opposite: Some(opposite),
            untouched: Untouched::default(),
        }
    }
}

/// How fast the gap along the radius grows in a direction, where the wheel `grows` along the axle and
/// around.
fn apart<T: Real>(direction: Parts<T>, grows: [T; 2]) -> T {
    direction.radial - grows[0] * direction.axial - grows[1] * direction.around
}

impl<T: Real> Over<'_, T> {
    /// Row `number` where it is `untouched`, of which the `point` there is that: as far from the
    /// wheel as it is there.
    pub fn aside(&self, number: usize, untouched: Untouched, point: &RowPoint<T>) -> Met<T> {
        let [y, z, dy, dz] = point.value;
        let place = T::from(untouched.place);
        let (x, direction) = match self.course() {
            None => (place, [dy, dz]),
            Some(course) => (self.way(place, point).x, course.straight_across(point)),
        };
        let here = self.beside(place, [y, z]);
        let depth = dot(self.seen_from_marker(here), self.down);
        let raised = Raised::at(self, &Polar::of(self, place, [y, z])).height;
        let away = untouched.ahead;
        let lower = (depth * depth + away * away).sqrt() - depth - raised;
        Met {
            row: number,
            point: [0, 1].map(|i| here[i] + lower * self.down[i]),
            direction,
            x,
            gap: Gap { height: f64::INFINITY, share: 1.0, growth: 0.0 },
            untouched,
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
        let profile = OnProfile::find(over.line(), polar.axial, near(polar.axial)?)?;
        let spot = Self::opposite(over, place, point, polar, profile);
        if over.varies_around() { spot.around(over) } else { Some(spot) }
    }

    /// The place of a kink, with the row behind it here and ahead of it `there`: it goes on there as
    /// the wheel does, of which the slope lies between those of the row.
    pub fn at_kink(&self, over: &Over, there: &Self) -> Option<Self> {
        let share = self.slope / (self.slope - there.slope);
        let between = |a: f64, b: f64| a + share * (b - a);
        let (a, b) = (&self.point, &there.point);
        let point = RowPoint {
            first: std::array::from_fn(|i| between(a.first[i], b.first[i])),
            second: std::array::from_fn(|i| between(a.second[i], b.second[i])),
            ..*a
        };
        let spot = Self::opposite(over, self.place, point, self.polar, self.profile);
        if over.varies_around() { spot.around(over) } else { Some(spot) }
    }

    /// The same place opposite to a wheel whose section varies around.
    fn around(self, over: &Over) -> Option<Self> {
        let Polar { sine, cosine, .. } = self.polar;
        let found = over.line().along_radius(self.polar.place(), [self.s(), -self.gap])?;
        let Raised { height, slope, .. } = self.raised;
        let gap = -found.depth - height;
        let [side, ahead, below] = found.normal;
        let facing = ahead * sine + below * cosine;
        let around = ahead * cosine - below * sine;
        let grows = [-side / facing, slope - around / facing];
        Some(Self {
            gap,
            slope: apart(self.along, grows),
            cosine: facing,
            grows,
            profile: OnProfile { s: found.s, ..self.profile },
            raised: Raised { height: height + self.gap - gap, ..self.raised },
            ..self
        })
    }

    /// Row `number` as it is met here: of a wheel whose section varies around by how that goes on.
    pub fn found(&self, over: &Over, number: usize, rest: Option<f64>) -> Met {
        let met = self.met(over, number, rest);
        if !over.varies_around() {
            return met;
        }
        let line = over.line();
        // At the point of the wheel that is opposite.
        let across = over.seen_from_marker(line.at(self.s()).point);
        let [y, z] = [over.right, over.down].map(|axis| dot(across, axis));
        let beside = over.beside_marker(y);
        let below = |x: f64| line.wheel_below(x, beside, [over.right, over.down], [self.s(), z]);
        let on_line = met.x - met.along.ahead;
        let (Some(here), Some(there)) = (below(met.x), below(on_line)) else { return met };
        let [here_bent, there_bent] =
            [here, there].map(|b| -b.bend / (b.slopes[0] * b.slopes[0] + 1.0).three_halves());
        // How far the wheel is beyond the circle of its contact line there, and the round one beyond
        // its own.
        let ahead = line.ahead_of_round(self.s());
        let beyond = |away: f64, depth: f64| (away * away + depth * depth).sqrt() - z;
        let round = line.round_below(met.x, y, self.s());
        let round = round.map_or(0.0, |depth| beyond(met.x - on_line + ahead, depth));
        let along = Along {
            raised: beyond(met.x - on_line, here.depth) - round,
            lever: line.lever([met.x, y], &here) - ahead,
            bulge: met.gap.share * (here_bent - there_bent),
            ..met.along
        };
        Met { along, ..met }
    }

    /// How far the row is from the wheel along the radius at the `point` (y, z) at `place`, whose
    /// profile goes on straight from here [m].
    pub fn height(&self, over: &Over, place: f64, point: [f64; 2]) -> f64 {
        let polar = Polar::of(over, place, point);
        let raised = Raised::height_at(over, &polar);
        let away = polar.radius - raised - self.profile.radius;
        let aside = polar.axial - self.polar.axial;
        let straight = away - self.profile.slope * aside;
        if !over.varies_around() {
            return straight;
        }
        let found = over.line().along_radius(polar.place(), [self.s(), -straight]);
        found.map_or(straight, |found| -found.depth - raised)
    }

    /// Parameter of the wheel opposite [m].
    pub fn s(&self) -> f64 {
        self.profile.s
    }

    /// Coordinate of the row along the axle [m].
    pub fn axial(&self) -> f64 {
        self.polar.axial
    }

    /// By how much the wheel is larger here than the round one [m].
    pub fn raised(&self) -> f64 {
        self.raised.height
    }
}
