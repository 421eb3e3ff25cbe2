//! All contact points and penetrated intervals of a wheel's contact line and a rail, on tread and
//! flange together.
//!
//! The signed distance d(u) of the points of the contact line from the rail is followed along the
//! line. Its derivative is the sine of the angle between the two lines, so that local minima are
//! where the tangents are parallel. Where d > 0 the curvature of both bodies bounds how soon d can
//! vanish: the step takes that bound, and intervals that cannot touch are passed over.
//!
//! An interval with d < 0 is one patch with one contact frame at its deepest minimum, whatever
//! loaded zones it has; where the normals at two neighbouring minima differ by more than 30
//! degrees, as tread and flange do, it is split at the ridge in between, because no common tangent
//! plane makes sense.

mod interval;
mod sample;
#[cfg(test)]
mod tests;
mod wheel_bounds;

use crate::geometry::contacts::contact::Contact;
use crate::geometry::contacts::separation::{Probe, Separation};
use crate::geometry::curves::curve::Curve;
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::geometry::wheel::contact_line::ContactLine;
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;
use crate::math::root::{bracketed, interpolated_step};
use interval::{IntervalProbe, Kind, deepest, last_of_group};
use sample::{Sample, hidden_turn};
use wheel_bounds::{BIN, WheelBounds};

/// Most patches of one wheel on one rail.
pub const MAX_CONTACTS: usize = 16;
/// Most probes of one wheel on one rail.
pub const MAX_PROBES: usize = 2048;
/// Depth from which on the nearest point of the rail is looked for all around it [m]: wheels that
/// are loaded stay far above, and gauge corners are rounded by twice as much.
const DEEP: f64 = 5e-3;
/// How far a point of the rail may be from straight on if it is the nearest one [m].
const ASKEW: f64 = 1e-4;
/// Distance along the rail over which its nearest point moves within one step only where it goes
/// over to another side [m].
const OTHER_SIDE: f64 = 1e-2;
/// Last Newton step towards a nearest point while searching, and where a minimum is pinned down;
/// what is then left is about its square times a curvature [m].
const COARSE: f64 = 3e-5;
const FINE: f64 = 1e-9;
/// Bracket within which a minimum is interpolated [m]: on a flank against a rail edge of 13 mm each
/// nanometre would turn the frame, and the force with it, by 1e-7.
const EXTREMUM_BRACKET: f64 = 1e-11;
/// Last step of interpolation towards a minimum or maximum [m], and most of them; three are the
/// rule. They get shorter so fast that the last one leaves nothing but rounding.
const EXTREMUM_STEP: f64 = 1e-10;
const MAX_INTERPOLATIONS: usize = 6;

/// Finds contacts; keeps what it needs from call to call, but no result.
#[derive(Clone, Debug)]
pub struct ContactSearch {
    bounds: WheelBounds,
    interval: FixedVec<IntervalProbe>,
    /// Separation at the probes of all contacts; see [`Contact::probes`].
    pub probes: FixedVec<Probe>,
    /// The contacts found, in growing y.
    pub contacts: FixedVec<Contact>,
    /// Points of the line at which the distance was evaluated.
    pub evaluations: u64,
    /// Contacts or probes for which there was no room.
    pub left_out: u64,
    /// Least distance of the points at which it was evaluated in the last search [m].
    pub least_distance: f64,
}

impl ContactSearch {
    /// A search for wheels with the profile `wheel`.
    pub fn new(wheel: &Curve) -> Self {
        let mut search = Self {
            bounds: WheelBounds::default(),
            interval: FixedVec::new(MAX_PROBES),
            probes: FixedVec::new(MAX_PROBES),
            contacts: FixedVec::new(MAX_CONTACTS),
            evaluations: 0,
            left_out: 0,
            least_distance: f64::INFINITY,
        };
        search.put_wheel(wheel);
        search
    }

    /// Becomes a new search for wheels with another profile; allocates nothing within the room that
    /// there is.
    pub fn put_wheel(&mut self, wheel: &Curve) {
        self.follow_wheel(wheel);
        self.interval.clear();
        self.probes.clear();
        self.contacts.clear();
        (self.evaluations, self.left_out) = (0, 0);
    }

    /// Goes on with another profile, as that of a wheel whose section varies; allocates nothing
    /// within the room that there is.
    pub fn follow_wheel(&mut self, wheel: &Curve) {
        self.bounds.follow(wheel);
    }

    /// Makes room for wheels whose profile is `longer` [m] than the one there is.
    pub fn reserve(&mut self, longer: f64) {
        self.bounds.reserve(longer);
    }

    /// Fills `contacts` and `probes` for a wheel in the pose of `line` on `rail`, from the given
    /// stretches of the line, which are in growing u and apart; `[line.range()]` stands for all of
    /// it.
    pub fn search(&mut self, line: &ContactLine, rail: &PlacedRail, ranges: &[[f64; 2]]) {
        self.contacts.clear();
        self.probes.clear();
        self.least_distance = f64::INFINITY;
        let [start, end] = line.range();
        for range in ranges {
            self.interval.clear();
            let (first, last) = (range[0].max(start), range[1].min(end));
            let near = rail.coarse_nearest(line.at(first).point);
            let mut from = self.sample(line, rail, first, near, COARSE);
            if from.distance <= 0.0 {
                self.record(from, Kind::Step);
            }
            while from.u < last {
                let step = self.bounds.step(&from, line, rail.concavity);
                let u = (from.u + step).min(last);
                // After a long step the nearest point may be anywhere.
                let guess = if step < 2.0 * BIN && !from.beyond_end {
                    from.rail_s + from.rail_rate * (u - from.u)
                } else {
                    rail.coarse_nearest(line.at(u).point)
                };
                let to = self.sample(line, rail, u, guess, COARSE);
                if from.beyond_end == to.beyond_end {
                    self.advance(line, rail, &from, &to);
                } else {
                    self.pass_end(line, rail, &from, &to);
                }
                from = to;
            }
            self.close_interval();
        }
    }

    #[inline]
    fn sample(
        &mut self,
        line: &ContactLine,
        rail: &PlacedRail,
        u: f64,
        guess: f64,
        tolerance: f64,
    ) -> Sample {
        self.evaluations += 1;
        let at = line.at(u);
        let mut nearest = rail.nearest(at.point, guess, tolerance);
        if nearest.distance < 0.0 {
            let to = [0, 1].map(|i| at.point[i] - nearest.point[i]);
            let squared = to[0] * to[0] + to[1] * to[1];
            let askew = squared - nearest.distance * nearest.distance;
            if squared > DEEP * DEEP || askew > ASKEW * ASKEW {
                // So deep inside, the guess may hold on to a side that is no longer the nearest
                // one; or the line has gone so far at once, about the rim of a flange, that it is
                // outside; or it is before a wall, and what was found is the wall behind; or steps
                // about an edge did not settle, and what was found is not straight on.
                let anywhere = rail.nearest_of_all(at.point, tolerance);
                let is_on_a_side = !anywhere.beyond_end || !rail.is_between_ends(at.point);
                if is_on_a_side && anywhere.distance * anywhere.distance < squared {
                    nearest = anywhere;
                }
            }
        }
        self.least_distance = self.least_distance.min(nearest.distance);
        let away = if nearest.beyond_end {
            let to = [at.point[0] - nearest.point[0], at.point[1] - nearest.point[1]];
            let length = nearest.distance.max(f64::MIN_POSITIVE);
            [to[0] / length, to[1] / length]
        } else {
            [nearest.tangent[1], -nearest.tangent[0]]
        };
        Sample {
            u,
            distance: nearest.distance,
            slope: at.tangent[0] * away[0] + at.tangent[1] * away[1],
            rail_s: nearest.s,
            rail_point: nearest.point,
            rail_tangent: nearest.tangent,
            rail_rate: nearest.ratio
                * (at.tangent[0] * nearest.tangent[0] + at.tangent[1] * nearest.tangent[1]),
            beyond_end: nearest.beyond_end,
        }
    }

    /// Deals with the line between two neighbouring samples of which one lies beyond an end of the
    /// rail: what is inside the rail ends exactly there.
    fn pass_end(&mut self, line: &ContactLine, rail: &PlacedRail, from: &Sample, to: &Sample) {
        let inside = if from.beyond_end { to } else { from };
        let (mut end, mut beyond) = (*inside, from.u + to.u - inside.u);
        // The distance changes no faster than the line runs.
        let rate = stretch(line, from.u).max(stretch(line, to.u));
        while (beyond - end.u).abs() * rate > end.distance.max(EXTREMUM_BRACKET) {
            let middle = 0.5 * (end.u + beyond);
            let here = self.sample(line, rail, middle, end.rail_s, FINE);
            if here.beyond_end {
                beyond = middle;
            } else {
                end = here;
            }
        }
        if from.beyond_end {
            self.advance(line, rail, &end, to);
        } else {
            self.advance(line, rail, from, &end);
            self.close_interval();
        }
    }

    /// Deals with the line between two neighbouring samples.
    fn advance(&mut self, line: &ContactLine, rail: &PlacedRail, from: &Sample, to: &Sample) {
        let dips = from.slope < 0.0 && to.slope > 0.0;
        if from.distance > 0.0 && to.distance > 0.0 {
            if !dips {
                return;
            }
            // Where the distance is convex along the line it lies above its two tangents, and the
            // line goes on no faster than at one of its ends.
            let length = (to.u - from.u) * stretch(line, from.u).max(stretch(line, to.u));
            let crossing = from.distance * to.slope - to.distance * from.slope
                + from.slope * to.slope * length;
            if crossing <= 0.1 * (to.slope - from.slope) * from.distance.min(to.distance) {
                let lowest = self.extremum(line, rail, from, to);
                if lowest.distance < 0.0 {
                    self.record(*from, Kind::Step);
                    self.record(lowest, Kind::Minimum);
                    self.record(*to, Kind::Step);
                    self.close_interval();
                }
            }
            return;
        }
        if let Some(u) = hidden_turn(from, to) {
            let between =
                self.sample(line, rail, u, from.rail_s + from.rail_rate * (u - from.u), COARSE);
            if between.slope * from.slope < 0.0 {
                self.advance(line, rail, from, &between);
                self.advance(line, rail, &between, to);
                return;
            }
        }
        if self.interval.is_empty() {
            self.record(*from, Kind::Step);
        }
        if dips || (from.slope > 0.0 && to.slope < 0.0) {
            let extremum = self.extremum(line, rail, from, to);
            // Where the nearest point goes over to another side of the rail the depth has an edge,
            // but nothing touches there.
            let goes_over = (to.rail_s - from.rail_s).abs() > OTHER_SIDE;
            let kind = match (dips, goes_over) {
                (true, true) => Kind::Step,
                (true, false) => Kind::Minimum,
                (false, _) => Kind::Maximum,
            };
            self.record(extremum, kind);
            if kind == Kind::Maximum && extremum.distance > 0.0 {
                // Two intervals with a gap between them that is shorter than a step.
                self.close_interval();
                self.record(extremum, kind);
            }
        }
        self.record(*to, Kind::Step);
        if to.distance > 0.0 {
            self.close_interval();
        }
    }

    /// The place between two samples at which the slope changes its sign.
    fn extremum(
        &mut self,
        line: &ContactLine,
        rail: &PlacedRail,
        from: &Sample,
        to: &Sample,
    ) -> Sample {
        let (mut left, mut right) = ((from.u, from.slope), (to.u, to.slope));
        let mut before = [left, right];
        let mut near = *from;
        let mut u = from.u - from.slope * (to.u - from.u) / (to.slope - from.slope);
        for _ in 0..MAX_INTERPOLATIONS {
            near = self.sample(line, rail, u, near.rail_s + near.rail_rate * (u - near.u), FINE);
            let here = (u, near.slope);
            let step = interpolated_step(before, here);
            if step.abs() <= EXTREMUM_STEP {
                let u = u + step;
                return self.sample(line, rail, u, near.rail_s + near.rail_rate * step, FINE);
            }
            if (near.slope < 0.0) == (left.1 < 0.0) {
                left = here;
            } else {
                right = here;
            }
            u += step;
            if !(u > left.0 && u < right.0) {
                break;
            }
            before = [before[1], here];
        }
        // A kink, or the end of a body.
        let u = bracketed(left, right, EXTREMUM_BRACKET, |u| {
            near = self.sample(line, rail, u, near.rail_s + near.rail_rate * (u - near.u), FINE);
            near.slope
        });
        self.sample(line, rail, u, near.rail_s + near.rail_rate * (u - near.u), FINE)
    }

    fn record(&mut self, sample: Sample, kind: Kind) {
        if self.interval.len() < self.interval.capacity() {
            self.interval.push(IntervalProbe { sample, kind });
        } else {
            self.left_out += 1;
        }
    }

    /// Turns the interval followed so far into contacts.
    fn close_interval(&mut self) {
        let mut first = 0;
        while first < self.interval.len() {
            let last = last_of_group(&self.interval, first);
            self.add_contact(first, last);
            if last + 1 >= self.interval.len() {
                break;
            }
            // The ridge belongs to both neighbours.
            first = last;
        }
        self.interval.clear();
    }

    fn add_contact(&mut self, first: usize, last: usize) {
        let group = &self.interval[first..=last];
        let sample = deepest(group);
        if sample.distance >= 0.0 {
            return;
        }
        let begin = self.probes.len();
        if self.contacts.len() == self.contacts.capacity()
            || begin + group.len() + 1 > self.probes.capacity()
        {
            self.left_out += 1;
            return;
        }
        let probe =
            |sample: &Sample, lowest: f64| Probe { u: sample.u, f: sample.distance - lowest };
        self.probes.extend(group.iter().map(|p| probe(&p.sample, sample.distance)));
        self.contacts.push(Contact {
            u: sample.u,
            rail_s: sample.rail_s,
            penetration: -sample.distance,
            origin: sample.rail_point,
            tangent: sample.rail_tangent,
            probes: [begin, self.probes.len()],
        });
    }

    /// Replaces the estimates at the local minima and maxima of the probes by the separation in the
    /// contact frame.
    pub fn refine_probes(&mut self, contact: &Contact, separation: &mut impl Separation) {
        let probes = &mut self.probes[contact.probes[0]..contact.probes[1]];
        for i in 0..probes.len() {
            let f = probes[i].f;
            let lower = |j: usize| probes.get(j).is_none_or(|p| f <= p.f);
            let higher = |j: usize| probes.get(j).is_none_or(|p| f >= p.f);
            let (before, after) = (i.wrapping_sub(1), i + 1);
            let inner = i > 0 && after < probes.len();
            if inner && (lower(before) && lower(after) || higher(before) && higher(after)) {
                probes[i].f = separation.at(probes[i].u).f;
            }
        }
    }
}

/// Length of the line over its parameter at `u` [-]: a yawed one runs fast where the profile is
/// steep and curved.
fn stretch(line: &ContactLine, u: f64) -> f64 {
    let (_, [dy, dz]) = line.with_derivative(u);
    dy.hypotenuse(dz)
}
