//! All contact points and penetrated intervals of a wheel's contact line and a rail, on tread and flange together.
//!
//! The signed distance d(u) of the points of the contact line from the rail is followed along the line. Its derivative is the
//! sine of the angle between the two lines, so that local minima are where the tangents are parallel. Where d > 0 the curvature
//! of both bodies bounds how soon d can vanish: the step takes that bound, and intervals that cannot touch are passed over.
//!
//! An interval with d < 0 is one patch with one contact frame at its deepest minimum, whatever loaded zones it has; where the
//! normals at two neighbouring minima differ by more than 30 degrees, as tread and flange do, it is split at the ridge in
//! between, because no common tangent plane makes sense.

use crate::geometry::contact::Contact;
use crate::geometry::contact_line::ContactLine;
use crate::geometry::curve::Curve;
use crate::geometry::placed_rail::PlacedRail;
use crate::geometry::separation::{Probe, Separation};
use crate::math::fixed_vec::FixedVec;
use crate::math::root::{bracketed, interpolated_step};

/// Most patches of one wheel on one rail.
pub const MOST_CONTACTS: usize = 16;
/// Most probes of one wheel on one rail.
pub const MOST_PROBES: usize = 2048;
/// Step inside an interval of penetration: waves of a profile that are shorter are not told apart [m].
const INSIDE_STEP: f64 = 1.5e-3;
/// The same where a yawed wheel also passes deviations along the track, faster than its own waves [m].
const KINKED_STEP: f64 = 5e-4;
/// Least step outside [m]; a dip that fits into it is found where the slope changes sign.
const LEAST_STEP: f64 = 5e-4;
/// Length of the bins for which the concavity of the wheel is kept [m].
const BIN: f64 = 4e-3;
/// Concavity times distance up to which the curvature of a hollow rail bounds the step.
const MOST_HOLLOW: f64 = 0.5;
/// Share of the bound that a step takes: the contact line of a yawed wheel is a little more curved than the profile.
const STEP_SHARE: f64 = 0.9;
/// Depth from which on the nearest point of the rail is looked for all around it [m]: wheels that are loaded stay far above, and gauge corners are
/// rounded by twice as much.
const DEEP: f64 = 5e-3;
/// Distance along the rail over which its nearest point moves within one step only where it goes over to another side [m].
const OTHER_SIDE: f64 = 1e-2;
/// Patches are split where neighbouring normals differ by more [rad].
const MOST_ANGLE: f64 = std::f64::consts::FRAC_PI_6;
/// Last Newton step towards a nearest point while searching, and where a minimum is pinned down; what is then left is about its
/// square times a curvature [m].
const COARSE: f64 = 3e-5;
const FINE: f64 = 1e-9;
/// Bracket within which a minimum is interpolated [m]: on a flank against a rail edge of 13 mm each nanometre would turn the frame, and
/// the force with it, by 1e-7.
const EXTREMUM_BRACKET: f64 = 1e-11;
/// Last step of interpolation towards a minimum or maximum [m], and most of them; three are the rule. They get shorter so fast that the last one
/// leaves nothing but rounding.
const EXTREMUM_STEP: f64 = 1e-10;
const MOST_INTERPOLATIONS: usize = 6;

/// Distance of one point of the line from the rail.
#[derive(Clone, Copy, Debug)]
struct Sample {
    u: f64,
    distance: f64,
    /// Derivative of the distance along the line, -1 to 1.
    slope: f64,
    rail_s: f64,
    rail_point: [f64; 2],
    rail_tangent: [f64; 2],
    /// Derivative of `rail_s` with respect to `u`.
    rail_rate: f64,
    beyond_end: bool,
}

/// A probe of an interval and what it is.
#[derive(Clone, Copy, Debug)]
struct IntervalProbe {
    sample: Sample,
    kind: Kind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Step,
    Minimum,
    Maximum,
}

/// Where the slope may have another sign than at two neighbouring samples, where it has the same: where that of the cubic through both is
/// farthest from it. A wave of the profile that is shorter than a step shows there.
fn hidden_turn(from: &Sample, to: &Sample) -> Option<f64> {
    let (a, b) = (from.slope, to.slope);
    if a * b <= 0.0 {
        return None;
    }
    let mean = (to.distance - from.distance) / (to.u - from.u);
    // Slope a + p t + q t², t from 0 to 1.
    let (p, q) = (6.0 * mean - 4.0 * a - 2.0 * b, 3.0 * (a + b) - 6.0 * mean);
    let t = -0.5 * p / q;
    let turns = t > 0.0 && t < 1.0 && a * (a + 0.5 * p * t) < 0.0;
    turns.then_some(from.u + t * (to.u - from.u))
}

/// Finds contacts; keeps what it needs from call to call, but no result.
#[derive(Clone, Debug)]
pub struct ContactSearch {
    /// Greatest concave curvature of the wheel over each bin and the next [1/m].
    concavity: Vec<f64>,
    /// Greatest factor of the wheel in [`ContactLine::stretch_per_factor`] over each bin and the next [1/m].
    stretch: Vec<f64>,
    interval: FixedVec<IntervalProbe>,
    /// Separation at the probes of all contacts; see [`Contact::probes`].
    pub probes: FixedVec<Probe>,
    /// The contacts found, in growing y.
    pub contacts: FixedVec<Contact>,
    /// Points of the line at which the distance was evaluated.
    pub evaluations: u64,
    /// Contacts or probes for which there was no room.
    pub left_out: u64,
}

impl ContactSearch {
    /// A search for wheels with the profile `wheel`.
    #[must_use]
    pub fn new(wheel: &Curve) -> Self {
        let mut search = Self {
            concavity: Vec::new(),
            stretch: Vec::new(),
            interval: FixedVec::new(MOST_PROBES),
            probes: FixedVec::new(MOST_PROBES),
            contacts: FixedVec::new(MOST_CONTACTS),
            evaluations: 0,
            left_out: 0,
        };
        search.put_wheel(wheel);
        search
    }

    /// Becomes a new search for wheels with another profile; allocates nothing within the room that there is.
    pub fn put_wheel(&mut self, wheel: &Curve) {
        self.follow_wheel(wheel);
        self.interval.clear();
        self.probes.clear();
        self.contacts.clear();
        (self.evaluations, self.left_out) = (0, 0);
    }

    /// Goes on with another profile, as that of a wheel whose section varies; allocates nothing within the room that there is.
    pub fn follow_wheel(&mut self, wheel: &Curve) {
        let count = ((wheel.end() - wheel.start()) / BIN).ceil() as usize + 1;
        let Self { concavity: concave, stretch, .. } = self;
        for bins in [&mut *concave, &mut *stretch] {
            bins.clear();
            bins.resize(count + 1, 0.0);
        }
        for pair in wheel.spans() {
            // Curvature is close to linear over a piece; a long one still has to reach every bin.
            let count = ((pair[1] - pair[0]) / (0.5 * BIN)) as usize + 4;
            for i in 0..=count {
                let share = (i as f64 / count as f64).clamp(0.001, 0.999);
                let s = pair[0] + share * (pair[1] - pair[0]);
                let p = wheel.at(s);
                let bin = ((s - wheel.start()) / BIN) as usize;
                concave[bin] = concave[bin].max(p.curvature());
                stretch[bin] = stretch[bin].max(ContactLine::stretch_factor(&p));
            }
        }
        // Each bin with the next.
        for bins in [concave, stretch] {
            for i in 0..count {
                bins[i] = bins[i].max(bins[i + 1]);
            }
            bins.truncate(count);
        }
    }

    /// Makes room for wheels whose profile is `longer` [m] than the one there is.
    pub fn reserve(&mut self, longer: f64) {
        let bins = (longer / BIN).ceil() as usize + 1;
        self.concavity.reserve(bins);
        self.stretch.reserve(bins);
    }

    /// Fills `contacts` and `probes` for a wheel in the pose of `line` on `rail`, from the given stretches of the line, which are in
    /// growing u and apart; `[line.range()]` stands for all of it.
    pub fn search(&mut self, line: &ContactLine, rail: &PlacedRail, ranges: &[[f64; 2]]) {
        self.contacts.clear();
        self.probes.clear();
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
                let step = self.step(&from, line, rail.concavity);
                let u = (from.u + step).min(last);
                // After a long step the nearest point may be anywhere.
                let guess = if step < 2.0 * BIN && !from.beyond_end {
                    from.rail_s + from.rail_rate * (u - from.u)
                } else {
                    rail.coarse_nearest(line.at(u).point)
                };
                let to = self.sample(line, rail, u, guess, COARSE);
                self.advance(line, rail, &from, &to);
                from = to;
            }
            self.close_interval();
        }
    }

    /// How far the line may be followed without passing a penetration.
    fn step(&self, from: &Sample, line: &ContactLine, rail_concavity: f64) -> f64 {
        if from.distance <= 0.0 {
            return self.inside_step(from, line);
        }
        let [start, end] = line.range();
        let per_factor = line.stretch_per_factor();
        let last = self.concavity.len() - 1;
        let here = (((from.u - start) / BIN) as usize).min(last);
        let stretch_over = |bin: usize| 1.0 + per_factor * self.stretch[bin];
        // The distance is 1-Lipschitz: go on until the line may have become as long as it.
        let (mut u, mut left, mut bin) = (from.u, STEP_SHARE * from.distance, here);
        loop {
            let stretch = stretch_over(bin);
            let edge = start + (bin + 1) as f64 * BIN;
            if left < stretch * (edge - u) || bin == last {
                u += left / stretch;
                break;
            }
            left -= stretch * (edge - u);
            u = edge;
            bin += 1;
        }
        let mut step = u.min(end) - from.u;
        // From afar a hollow of the rail bends the distance more, 1/(1 - concavity·d), and beyond its centre without bound.
        let hollow = rail_concavity * from.distance;
        if !from.beyond_end && hollow < MOST_HOLLOW {
            let concavity = self.concavity[here] + rail_concavity / (1.0 - hollow);
            // A lift may turn from rising to falling at any kink.
            let slope = from.slope - 2.0 * line.most_lift_slope(self.stretch[here]);
            // d + slope·t - concavity·t²/2 vanishes no sooner than at:
            let root = (slope * slope + 2.0 * concavity * from.distance).sqrt();
            let bound = if slope < 0.0 {
                2.0 * from.distance / (root - slope)
            } else {
                (slope + root) / concavity.max(1e-3)
            };
            // The bounds hold to the end of the next bin.
            let reach = start + (here + 2) as f64 * BIN - from.u;
            step = step.max(STEP_SHARE * bound.min(reach) / stretch_over(here));
        }
        step.max(LEAST_STEP)
    }

    /// Step inside an interval of penetration [m].
    fn inside_step(&self, from: &Sample, line: &ContactLine) -> f64 {
        let Some(deviations) = line.deviations() else { return INSIDE_STEP };
        let last = self.stretch.len() - 1;
        let here = (((from.u - line.range()[0]) / BIN) as usize).min(last);
        // A yawed wheel passes several waves along the track where its line runs ahead fast.
        let quarter_wave = 4.0 * deviations.spacing();
        (quarter_wave / line.most_advance(self.stretch[here])).clamp(KINKED_STEP, INSIDE_STEP)
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
        if nearest.distance < -DEEP {
            // So deep inside, the guess may hold on to a side that is no longer the nearest one.
            let anywhere = rail.nearest(at.point, rail.coarse_nearest(at.point), tolerance);
            if anywhere.distance < 0.0 && anywhere.distance > nearest.distance {
                nearest = anywhere;
            }
        }
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

    /// Deals with the line between two neighbouring samples.
    fn advance(&mut self, line: &ContactLine, rail: &PlacedRail, from: &Sample, to: &Sample) {
        let dips = from.slope < 0.0 && to.slope > 0.0;
        if from.distance > 0.0 && to.distance > 0.0 {
            // Where the distance is convex it lies above its two tangents.
            let crossing = from.distance * to.slope - to.distance * from.slope
                + from.slope * to.slope * (to.u - from.u);
            if dips && crossing <= 0.1 * (to.slope - from.slope) * from.distance.min(to.distance) {
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
            // Where the nearest point goes over to another side of the rail the depth has an edge, but nothing touches there.
            let goes_over = (to.rail_s - from.rail_s).abs() > OTHER_SIDE;
            let kind = match (dips, goes_over) {
                (true, true) => Kind::Step,
                (true, false) => Kind::Minimum,
                (false, _) => Kind::Maximum,
            };
            self.record(extremum, kind);
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
        for _ in 0..MOST_INTERPOLATIONS {
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
            let last = self.last_of_group(first);
            self.add_contact(first, last);
            if last + 1 >= self.interval.len() {
                break;
            }
            // The ridge belongs to both neighbours.
            first = last;
        }
        self.interval.clear();
    }

    /// The probe at which the contact that starts at probe `first` ends: the last one or a ridge to split at.
    fn last_of_group(&self, first: usize) -> usize {
        let mut minimum: Option<usize> = None;
        let mut ridge = first;
        for i in first + 1..self.interval.len() {
            let probe = &self.interval[i];
            if probe.sample.distance >= self.interval[ridge].sample.distance || minimum.is_none() {
                ridge = i;
            }
            if probe.kind == Kind::Minimum {
                if let Some(before) = minimum {
                    let [a, b] = [before, i].map(|k| self.interval[k].sample.rail_tangent);
                    let cosine = a[0] * b[0] + a[1] * b[1];
                    if cosine < MOST_ANGLE.cos() && ridge > first && ridge < i {
                        return ridge;
                    }
                }
                minimum = Some(i);
                ridge = i;
            }
        }
        self.interval.len() - 1
    }

    fn add_contact(&mut self, first: usize, last: usize) {
        let group = &self.interval[first..=last];
        // Where a body ends inside the interval there may be no minimum: the deepest probe then stands for it.
        let (mut deepest, mut lowest) = (&group[0].sample, None::<&Sample>);
        for IntervalProbe { sample, kind } in group {
            if sample.distance < deepest.distance {
                deepest = sample;
            }
            let is_lower = lowest.is_none_or(|lowest| sample.distance < lowest.distance);
            if *kind == Kind::Minimum && is_lower {
                lowest = Some(sample);
            }
        }
        let sample = match lowest {
            Some(lowest) if lowest.distance <= 0.5 * deepest.distance => *lowest,
            _ => *deepest,
        };
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

    /// Replaces the estimates at the local minima and maxima of the probes by the separation in the contact frame.
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
