//! The height at which one rail carries a given load, by the stiffness of its contacts.
//!
//! At a pose near it strips say how far down the wheel has to go for a vertical force of theirs, with
//! the geometry as it is ([`Descent`]). What creep forces add is known after them, and
//! hardly changes with the way: so the force that is asked for follows. The geometry of a pose is
//! wrong by a thousandth of the way or so; that is how much nearer the next pose is, and two poses
//! tell it, for the third one to be nearer still. Contacts by themselves, with their creep forces,
//! say where the first pose is. Normal models that solve contacts by themselves go on from there by
//! secants of whole evaluations.

use super::input::Input;
use super::output::Output;
use super::parameters::{FoundationModel, Side};
use super::vertical_load::{FIRST_STEP, LONGEST_STEP, MAX_STEPS, STIFFNESS};
use super::wheel_on_rails::Element;
use crate::normal::{Descent, Pose};

/// Most ways down that are tried.
const MOST_TRIALS: usize = 12;
/// Share of the load that may be missing, and that forces may be off because of the geometry.
const MISSING: f64 = 1e-10;
const MISPLACED: f64 = 1e-10;
/// Share of a way that the geometry is wrong by at least, whatever two poses tell, and where there
/// is one pose alone: what lateral forces on flanges change by.
const WRONG: [f64; 2] = [1e-3, 0.05];
/// Depth over that of the load about from which on a pose is too far for a guess.
const FAR: f64 = 3.0;
/// Greatest share that two poses are believed to tell.
const MOST_WRONG: f64 = 0.5;

/// A pose, and what its geometry led to.
#[derive(Clone, Copy)]
struct Placed {
    /// Height of the marker, and the way down from it [m].
    z: f64,
    way: f64,
    /// Vertical force of the normal loads after that, and of all forces [N].
    normal: f64,
    carried: f64,
    /// Lateral force over the vertical one [-].
    aside: f64,
    /// Derivative of the normal one by the way [N/m].
    stiffness: f64,
    /// Contacts and zones that found no room.
    left_out: u64,
}

impl Placed {
    /// How the force of all grows with that of the normal loads: as friction does that bears a share
    /// of the load, or as another state at the same pose tells.
    fn rate(&self, other: Option<&Self>) -> f64 {
        let ratio = self.carried / self.normal;
        let secant = |other: &Self| (self.carried - other.carried) / (self.normal - other.normal);
        // Friction does not bear half of a load: beyond that the difference is one of rounding.
        let rate = other.map(secant).filter(|rate| (rate / ratio - 1.0).abs() < 0.5);
        rate.unwrap_or(ratio)
    }

    /// The way from here to another `normal` force [m].
    fn way_to(&self, normal: f64) -> f64 {
        way_between(self.normal, self.stiffness, normal)
    }

    /// How far the wheel has to go down over the way that the geometry of the pose tells, by the
    /// ways from two poses [-].
    fn growth(&self, before: Option<&Self>) -> f64 {
        let growth = before.map(|before| {
            let told = before.way + before.way_to(self.normal) - self.way;
            (self.z - before.z) / told
        });
        growth.filter(|growth| (growth - 1.0).abs() < MOST_WRONG).unwrap_or(1.0)
    }

    /// What is known of how the load is carried, at another height and normal force.
    fn carried_at(&self, z: f64, normal: f64) -> Carried {
        let (stiffness, ratio) = (self.stiffness, self.carried / self.normal);
        Carried { z, normal, stiffness, ratio, aside: None }
    }

    /// Share of the load by which forces are off because of the geometry, as far as the pose before
    /// tells: the vertical one by what the way was wrong, the lateral one by how much it changed.
    fn error(&self, load: f64, before: Option<&Self>) -> f64 {
        let [share, turned] = before.map_or([WRONG[1], 0.0], |before| {
            let told = before.way + before.way_to(self.normal);
            [(self.way / told).abs(), (self.aside - before.aside).abs()]
        });
        let lowered = (self.way * self.stiffness / load).abs();
        lowered * share.max(WRONG[0]) + share * turned
    }
}

/// The way from where the normal loads have the vertical force `from`, and so much `stiffness`, to
/// where it is `to`: it grows with the power 3/2 of a depth [m].
fn way_between(from: f64, stiffness: f64, to: f64) -> f64 {
    1.5 * from / stiffness * ((to / from).powf(2.0 / 3.0) - 1.0)
}

/// About how a load is carried: height of the marker [m], vertical force of the normal loads there
/// [N], its derivative by the height [N/m], how many times as much all forces bear [-], and the
/// deflection aside of rails without mass, where they are to be sought beside it [m].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Carried {
    pub z: f64,
    normal: f64,
    stiffness: f64,
    ratio: f64,
    pub aside: Option<f64>,
}

impl Carried {
    /// The same on rails that are to be sought beside a deflection `aside`, if there is one [m].
    #[must_use]
    pub fn on_rails(self, aside: Option<f64>) -> Self {
        Self { aside, ..self }
    }

    /// The same lower by `way` [m].
    #[must_use]
    pub fn lower(self, way: f64) -> Self {
        Self { z: self.z + way, ..self }
    }
}

impl Element {
    /// Says about how the load of the next evaluation will be carried, if that is known, at a pose
    /// near that of the last one.
    pub(crate) fn expect(&mut self, carried: Option<Carried>) {
        self.expected = carried;
    }

    /// Puts the wheel of `input` (right side) at the height at which one rail carries its load, and
    /// leaves the forces there, from the height `clear` on; returns how many fallbacks that took, or
    /// nothing where it does not lead there.
    pub(super) fn load_by_stiffness(
        &mut self,
        clear: f64,
        expected: Option<Carried>,
        input: &mut Input,
        output: &mut Output,
    ) -> Option<u64> {
        let found = expected.and_then(|about| self.load_from(about, Pose::Near, input, output));
        found.or_else(|| {
            let about = self.guess(clear, input, output)?;
            self.load_from(about, Pose::New, input, output)
        })
    }

    /// The same from `about` how it is carried on, by what the normal model tells.
    fn load_from(
        &mut self,
        about: Carried,
        pose: Pose,
        input: &mut Input,
        output: &mut Output,
    ) -> Option<u64> {
        if self.models.strip_solver.is_some() {
            self.load_about(about, pose, input, output)
        } else {
            self.load_by_secants(about, input, output)
        }
    }

    /// The same by the forces of whole evaluations, for normal models that solve each contact by
    /// itself, which takes them little more than the search for it.
    fn load_by_secants(
        &mut self,
        about: Carried,
        input: &mut Input,
        output: &mut Output,
    ) -> Option<u64> {
        let load = input.wheel_load;
        let mut z = about.z;
        let mut before = None::<[f64; 2]>;
        for _ in 0..MOST_TRIALS {
            input.wheel.position[2] = z;
            let left_out = self.forces(input, output);
            let carried = -output.wheel.force[2];
            if (carried - load).abs() <= MISSING * load {
                let Carried { stiffness, ratio, .. } = about;
                let normal = carried / ratio;
                self.carried = Some(Carried { z, normal, stiffness, ratio, aside: None });
                return Some(left_out);
            }
            // The power 2/3 of the force is nearly straight.
            let straight = (carried / load).powf(2.0 / 3.0);
            let guessed = about.ratio * about.stiffness / (1.5 * load);
            let rate = before.map_or(guessed, |[last, at]| (straight - at) / (z - last));
            let is_pressed = carried > 0.0 && rate > 0.0;
            if !is_pressed {
                break;
            }
            before = Some([z, straight]);
            z += (1.0 - straight) / rate;
        }
        None
    }

    /// How one rail carries the load of `input`, where that is `expected` about so, near the pose of
    /// the last evaluation, or from a guess on: of strips about, by one pose; on rails without mass,
    /// which are sought beside where they are expected. Of `output` the first patch is then the
    /// heaviest one there. Nothing where rails have a mass or the stiffness does not lead to it.
    pub(crate) fn nearly_carried(
        &mut self,
        input: &Input,
        expected: Option<Carried>,
        output: &mut Output,
    ) -> Option<Carried> {
        if input.wheel_load <= 0.0 {
            return None;
        }
        if expected.is_none() {
            // What an earlier search left must not count.
            self.rested = None;
        }
        let mirrored = self.side == Side::Left;
        let mut input = if mirrored { input.mirrored() } else { *input };
        let carried = match self.foundation.model {
            FoundationModel::Rigid if self.models.strip_solver.is_some() => {
                self.nearly_carried_by_one_pose(&mut input, expected, output)
            }
            FoundationModel::Rigid => {
                self.expect(expected);
                let fallbacks = self.respond_to_rails(&mut input, output);
                self.carried.filter(|_| fallbacks == 0)
            }
            FoundationModel::Massless => self.carried_at_rest(&mut input, expected, output),
            FoundationModel::Mass => None,
        };
        self.models.patches.sort_unstable_by(|a, b| b.normal_force.total_cmp(&a.normal_force));
        output.patches[0] = *self.models.patches.first()?;
        if mirrored {
            *output = output.mirrored();
        }
        carried
    }

    /// The same for the input of a right side on rails that do not give way.
    fn nearly_carried_by_one_pose(
        &mut self,
        input: &mut Input,
        expected: Option<Carried>,
        output: &mut Output,
    ) -> Option<Carried> {
        let (about, pose) = if let Some(about) = expected {
            (about, Pose::Near)
        } else {
            input.wheel.position[2] = -self.nominal_radius;
            let clear = self.height_near_touch(input);
            (clear.is_finite().then(|| self.guess(clear, input, output))??, Pose::New)
        };
        input.wheel.position[2] = about.z;
        let descent = Descent::to(about.normal).from(pose, 0.0);
        let here = self.press(descent, input, output)?;
        let normal = here.normal + (input.wheel_load - here.carried) / here.rate(None);
        Some(here.carried_at(here.z + here.way + here.way_to(normal), normal))
    }

    /// The same by the poses that strips tell the way from.
    fn load_about(
        &mut self,
        about: Carried,
        mut pose: Pose,
        input: &mut Input,
        output: &mut Output,
    ) -> Option<u64> {
        let load = input.wheel_load;
        let (Carried { mut z, mut normal, .. }, mut way) = (about, 0.0);
        let (mut before, mut last) = (None::<Placed>, None::<Placed>);
        for _ in 0..MOST_TRIALS {
            input.wheel.position[2] = z;
            let descent = Descent::to(normal).from(pose, way);
            let here = self.press(descent, input, output)?;
            let missing = load - here.carried;
            let is_placed = here.error(load, before.as_ref()) <= MISPLACED;
            if is_placed && missing.abs() <= MISSING * load {
                z += here.growth(before.as_ref()) * here.way;
                input.wheel.position[2] = z;
                self.carried = Some(here.carried_at(z, here.normal));
                return Some(here.left_out);
            }
            normal = here.normal + missing / here.rate(last.as_ref());
            if is_placed {
                (pose, way, last) = (Pose::Same, here.way, Some(here));
            } else {
                z = here.z + here.growth(before.as_ref()) * (here.way + here.way_to(normal));
                (pose, way, before, last) = (Pose::Near, 0.0, Some(here), None);
            }
        }
        None
    }

    /// Forces after a `descent` from the pose of `input`; nothing where it is not one rail that
    /// presses, or not the deeper the more.
    fn press(&mut self, descent: Descent, input: &Input, output: &mut Output) -> Option<Placed> {
        self.models.descent = Some(descent);
        let left_out = self.forces(input, output);
        let Descent { way, reached: normal, stiffness, rails, .. } = self.models.descent.take()?;
        let (z, [_, lateral, vertical]) = (input.wheel.position[2], output.wheel.force);
        let (carried, aside) = (-vertical, lateral / vertical);
        let is_one = rails == 1 && stiffness > 0.0 && carried > 0.0;
        is_one.then_some(Placed { z, way, normal, carried, aside, stiffness, left_out })
    }

    /// About how the load is carried by one rail, by contacts each by itself, found at a height
    /// below `clear` [m].
    fn guess(&mut self, clear: f64, input: &mut Input, output: &mut Output) -> Option<Carried> {
        let load = input.wheel_load;
        let depth = (load / STIFFNESS).powf(2.0 / 3.0);
        let mut step = depth.clamp(FIRST_STEP[0], FIRST_STEP[1]);
        let (mut z, mut most_lift) = (clear, FAR * depth);
        for _ in 0..MAX_STEPS {
            z += step;
            input.wheel.position[2] = z;
            output.clear();
            self.models.patches.clear();
            let Self { rails, models, work, .. } = self;
            let rails = rails.iter_mut().enumerate();
            let mut met = rails.filter_map(|(k, rail)| {
                rail.as_mut()?.way_down(k, input, [load, most_lift], models, output, work)
            });
            let descent = match met.next() {
                None => {
                    step = (2.0 * step).min(LONGEST_STEP);
                    continue;
                }
                // Once: what is left is a matter of the geometry.
                Some(Err(lift)) => {
                    (step, most_lift) = (depth - lift, f64::INFINITY);
                    continue;
                }
                Some(Ok(descent)) => descent,
            };
            if met.next().is_some() {
                return None;
            }
            let Descent { way, reached, stiffness, .. } = descent;
            let ratio = -output.wheel.force[2] / reached;
            let normal = load / ratio;
            let z = z + way + way_between(reached, stiffness, normal);
            let is_there = ratio > 0.0 && stiffness > 0.0 && z.is_finite();
            return is_there.then_some(Carried { z, normal, stiffness, ratio, aside: None });
        }
        None
    }
}
