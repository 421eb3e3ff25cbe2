//! One wheel over one rail: the pose of the wheel, where the search for contacts looks, and how far
//! the wheel is from first touch.

use crate::element::contact::rail_frame::RailFrame;
use crate::element::contact::rail_friction::RailFriction;
use crate::element::input::Input;
use crate::element::parameters::Parameters;
use crate::geometry::contacts::clearance::Clearance;
use crate::geometry::contacts::clearances::Clearances;
use crate::geometry::contacts::contact_search::{ContactSearch, MAX_PROBES};
use crate::geometry::contacts::separation::Probe;
use crate::geometry::curves::curve::Curve;
use crate::geometry::profiles::profile::{Profile, ProfileKind};
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::geometry::rail::varying_rail::VaryingRail;
use crate::geometry::wheel::contact_line::{ContactLine, WheelPose};
use crate::geometry::wheel::varying_wheel::VaryingWheel;
use crate::math::fixed_vec::FixedVec;

/// One rail and what is prepared for its contact with the wheel.
#[derive(Clone, Debug)]
pub struct RailContact {
    pub(in crate::element) wheel: Profile,
    /// Name of the rail's profile.
    rail_name: String,
    pub(in crate::element) nominal_radius: f64,
    pub(in crate::element) rail: PlacedRail,
    clearances: Clearances,
    /// The same for a rail that varies along the track as it is where the wheel is, for wheels that
    /// are inside.
    here: Option<Clearance>,
    /// The wheel, if its section varies around.
    pub(in crate::element) around: Option<Box<Around>>,
    /// Stretches of the contact line that may touch.
    ranges: FixedVec<[f64; 2]>,
    pub(in crate::element) search: ContactSearch,
    /// Distance of the contact line from the rail over all contacts.
    pub(in crate::element) probes: FixedVec<Probe>,
    /// Friction over the surface of the rail, where it is not the same everywhere.
    pub(in crate::element) friction: Option<RailFriction>,
}

/// A wheel whose section varies around, which is laid into the profile of the wheel for each pose.
#[derive(Clone, Debug)]
pub(in crate::element) struct Around {
    wheel: VaryingWheel,
    /// Where the wheel as it stands can touch the rail.
    clearances: Clearances,
}

/// Least cosine of a contact angle for a guess of how far penetration goes with height.
pub(super) const STEEPEST: f64 = 0.05;
/// Room for what wear, which goes 10 mm deep at most, adds to the width of a profile on either side
/// and to the length of its arc [m].
const MAX_ADDED_WIDTH: f64 = 0.01;
const MAX_ADDED_ARC: f64 = 0.1;
/// Most stretches of a contact line that are searched apart from each other.
const MAX_RANGES: usize = 32;

impl RailContact {
    /// Prepares the contact of the wheel with profile `wheel` and a placed rail.
    pub fn new(
        wheel: &Profile,
        rail_name: &str,
        parameters: &Parameters,
        rail: PlacedRail,
        friction: Option<RailFriction>,
    ) -> Self {
        let nominal_radius = parameters.wheel.nominal_radius;
        let even = Clearance::new(&wheel.curve, nominal_radius, rail.curve());
        let (clearances, here) = match rail.variation() {
            None => (Clearances::even(even), None),
            Some(varying) => {
                let (along, wider) = Clearances::along(&even, varying);
                let mut here = even;
                here.reserve(wider);
                (along, Some(here))
            }
        };
        Self {
            clearances,
            here,
            around: None,
            ranges: FixedVec::new(MAX_RANGES),
            search: ContactSearch::new(&wheel.curve),
            probes: FixedVec::new(MAX_PROBES),
            wheel: wheel.clone(),
            rail_name: rail_name.into(),
            nominal_radius,
            rail,
            friction,
        }
    }

    /// The same for a wheel whose section varies around; its profile so far is the first section.
    #[must_use]
    pub fn with_wheel(mut self, wheel: &VaryingWheel) -> Self {
        let mut clearances = self.clearances.clone();
        clearances.reserve(self.clearances.lower(&wheel.sides()));
        self.wheel.curve.reserve(wheel.most_knots());
        self.search.reserve(MAX_ADDED_ARC + wheel.longer());
        self.around = Some(Box::new(Around { wheel: wheel.clone(), clearances }));
        self
    }

    /// Whether the section of the wheel varies around.
    pub fn wheel_varies(&self) -> bool {
        self.around.is_some()
    }

    /// Whether the rail is a roller with a corrugation.
    pub fn is_corrugated_roller(&self) -> bool {
        let varying = self.rail.variation();
        varying.is_some_and(|rail| rail.is_corrugated() && rail.roller_radius() > 0.0)
    }

    /// The wheel.
    pub fn wheel_profile(&self) -> &Profile {
        &self.wheel
    }

    /// The curve of the placed rail.
    pub fn rail_curve(&self) -> &Curve {
        self.rail.curve()
    }

    /// The profile of the rail as it was before it was placed, with `curve` in the place of its own
    /// if there is one.
    pub fn rail_profile(&self, curve: Option<&Curve>) -> Profile {
        Profile {
            name: self.rail_name.clone(),
            kind: ProfileKind::Rail,
            curve: self.rail.unplaced(curve.unwrap_or(self.rail.curve())),
            remarks: Vec::new(),
        }
    }

    /// A point of the placed rail on its profile [m].
    pub fn profile_point(&self, point: [f64; 2]) -> [f64; 2] {
        self.rail.profile_point(point)
    }

    /// Puts other curves in the place of those of wheel and placed rail; nothing moves. `rail`
    /// fills in that of the rail. Within the room of [`reserve_for_wear`](Self::reserve_for_wear)
    /// nothing is allocated.
    pub fn put_curves<T>(&mut self, wheel: &Curve, rail: impl FnOnce(&mut Curve) -> T) -> T {
        self.wheel.curve.copy_from(wheel);
        let put = self.rail.put_curve(rail);
        self.clearances.put_curves(wheel, self.rail.curve());
        self.search.put_wheel(wheel);
        put
    }

    /// Makes room for curves of wheel and rail through so many knots, and for what wear may make of
    /// their lengths.
    pub fn reserve_for_wear(&mut self, wheel_knots: usize, rail_knots: usize) {
        self.wheel.curve.reserve(wheel_knots);
        self.rail.reserve(rail_knots);
        self.clearances.reserve(MAX_ADDED_WIDTH);
        self.search.reserve(MAX_ADDED_ARC);
    }

    /// How far the wheel of `input` (right side) has to be lifted off rail number `k` until no
    /// contact is left, by their penetrations and angles as they are [m].
    ///
    /// # Errors
    /// About how far the wheel is from touching, where it does not, or how far it surely is [m].
    pub fn lift(&mut self, k: usize, input: &Input) -> Result<f64, f64> {
        if !self.search_contacts(k, input) {
            let apart = self.height_near_touch(k, input) - input.wheel.position[2];
            return Err(apart.max(0.0));
        }
        let contacts = self.search.contacts.iter();
        let lifts = contacts.map(|contact| contact.penetration / contact.normal()[1].max(STEEPEST));
        lifts.reduce(f64::max).ok_or(self.search.least_distance)
    }

    /// Searches for the contacts with rail number `k` for `input` (right side); false where bounds
    /// show that there are none.
    pub(in crate::element) fn search_contacts(&mut self, k: usize, input: &Input) -> bool {
        // Where bounds show that there are none, none of another pose are left.
        self.search.contacts.clear();
        let level = RailFrame::new(&self.rail, &input.rails[k]).pose(&input.wheel);
        if self.around.is_none() && !self.find_ranges(input, &level) {
            return false;
        }
        let place = [input.track_s, input.wheel.position[0]];
        self.rail.approach(&level, place);
        let pose = self.frame(k, input).pose(&input.wheel);
        let turned = self.rail.course().map_or(0.0, |course| course.pitch(&level, &pose));
        let pitch = input.wheel.pitch - turned;
        let station = self.station(input);
        if !self.turn_wheel(pitch, &pose, station) {
            return false;
        }
        if self.around.is_some() && !self.find_ranges(input, &level) {
            return false;
        }
        let line = ContactLine::new(&self.wheel.curve, self.nominal_radius, &pose);
        let line = varying(line, self.around.as_deref());
        if !self.rail.pass(&line, &pose, place, pitch) {
            return false;
        }
        self.search.search(&line, &self.rail, &self.ranges);
        true
    }

    /// The frame of rail number `k` for the `input` of the last search, along its rows.
    pub(in crate::element) fn frame(&self, k: usize, input: &Input) -> RailFrame {
        RailFrame::new(&self.rail, &input.rails[k]).along_rows(self.rail.course().copied())
    }

    /// Turns a wheel whose section varies around to `pitch` at `pose`; false where there is nothing
    /// of it.
    fn turn_wheel(&mut self, pitch: f64, pose: &WheelPose, station: f64) -> bool {
        let Some(around) = &mut self.around else { return true };
        let Around { wheel, clearances } = around.as_mut();
        let is_there = wheel.pass(pose, pitch, &mut self.wheel.curve);
        if is_there {
            clearances.at_mut(station).put_wheel(&self.wheel.curve);
            self.search.follow_wheel(&self.wheel.curve);
        }
        is_there
    }

    /// Fills `ranges` with the stretches of the contact line that may touch; false where there are
    /// none.
    fn find_ranges(&mut self, input: &Input, pose: &WheelPose) -> bool {
        let mut lowest = *pose;
        lowest.marker[2] += self.highest();
        let around = self.around.as_deref();
        let clearances = around.map_or(&self.clearances, |around| &around.clearances);
        clearances.at(self.station(input)).ranges(&lowest, &mut self.ranges);
        !self.ranges.is_empty()
    }

    /// A marker height from which a wheel coming down at the y, roll and yaw of `input` (right side)
    /// is surely clear of rail number `k`; infinite where it stands beside the rail [m].
    pub fn clear_height(&self, k: usize, input: &Input) -> f64 {
        let frame = RailFrame::new(&self.rail, &input.rails[k]);
        if frame.roll == 0.0 {
            return self.height_near_touch(k, input);
        }
        let pose = frame.pose(&input.wheel);
        // A rolled rail turns the height about its marker, and moves the wheel aside on its way down.
        let highest = self.highest();
        let clearance = self.clearances.at(self.station(input));
        frame.marker.z + clearance.clear_height(pose.roll)
            - pose.marker[1].abs() * frame.roll.abs()
            - highest
    }

    /// A marker height a little above that of first touch for `input` (right side) with rail number
    /// `k`, by the bounds of [`Clearance`]; infinite where the wheel stands beside the rail [m].
    pub fn height_near_touch(&self, k: usize, input: &Input) -> f64 {
        let frame = RailFrame::new(&self.rail, &input.rails[k]);
        let clearance = self.clearances.at(self.station(input));
        let near = clearance.height_near_touch(&frame.pose(&input.wheel));
        frame.marker.z + near - self.highest()
    }

    /// Station of the wheel of `input` on the rail; 0 on one that is even [m].
    fn station(&self, input: &Input) -> f64 {
        let along = |varying: &VaryingRail| varying.station(input.track_s, input.wheel.position[0]);
        self.rail.variation().map_or(0.0, along)
    }

    /// How much nearer the bodies can be than the profiles of the clearance [m].
    fn highest(&self) -> f64 {
        self.rail.variation().map_or(0.0, VaryingRail::highest)
    }

    /// How deep the wheel of `input` (right side) is below the top of rail number `k`, none if it
    /// is not [m].
    pub(in crate::element) fn depth(&mut self, k: usize, input: &Input) -> f64 {
        let pose = self.frame(k, input).pose(&input.wheel);
        let station = self.station(input);
        let clearance = match (&mut self.here, &self.around) {
            (None, None) => self.clearances.at(station),
            (None, Some(around)) => around.clearances.at(station),
            (Some(here), _) => {
                here.put_curves(&self.wheel.curve, self.rail.curve());
                here
            }
        };
        clearance.sunk(&pose).unwrap_or(0.0)
    }
}

/// The `line` of a wheel that varies `around`, if it does.
pub(in crate::element) fn varying<'a>(
    line: ContactLine<'a>,
    around: Option<&'a Around>,
) -> ContactLine<'a> {
    around.map_or(line, |around| line.varying(&around.wheel))
}
