//! The height at which one rail carries a given load, by the stiffness of its contacts.
//!
//! At a pose near it the normal models say how far down the wheel has to go for a vertical force of
//! theirs, with the geometry as it is ([`Descent`]). What creep forces add is known after them, and
//! hardly changes with the way: so the force that is asked for follows. The geometry of a pose is
//! wrong by a thousandth of the way or so; that is how much nearer the next pose is, and two poses
//! tell it, for the third one to be nearer still.

use super::input::Input;
use super::output::Output;
use super::parameters::{FoundationModel, Side};
use super::vertical_load::{FIRST_STEP, LONGEST_STEP, MAX_STEPS, STIFFNESS};
use super::wheel_on_rails::Element;
use crate::normal::{Descent, Pose};

/// Most ways down that are tried.
const MOST_TRIALS: usize = 12;
/// Share of the load that may be missing, and that the geometry may be wrong by.
const MISSING: f64 = 1e-10;
const MISPLACED: f64 = 3e-10;
/// Share of a way that the geometry is wrong by where nothing tells more.
const WRONG: f64 = 1e-3;

/// A pose, and what its geometry led to.
#[derive(Clone, Copy)]
struct Placed {
    /// Height of the marker, and the way down from it [m].
    z: f64,
    way: f64,
    /// Vertical force of the normal loads after that, and of all forces [N].
    normal: f64,
    carried: f64,
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

    /// The way from here to another `normal` force, which grows with the power 3/2 of a depth [m].
    fn way_to(&self, normal: f64) -> f64 {
        1.5 * self.normal / self.stiffness * ((normal / self.normal).powf(2.0 / 3.0) - 1.0)
    }

    /// The height at which the normal force is that of this state, by the ways from two poses.
    fn height(&self, before: Option<&Self>) -> f64 {
        let secant = before.map(|before| {
            let moved = before.z + (self.normal - before.normal) / self.stiffness;
            (before.way * self.z - self.way * moved) / (before.way - self.way)
        });
        secant.filter(|z| z.is_finite()).unwrap_or(self.z + self.way)
    }

    /// Share of the load by which the geometry of the pose is wrong, as far as the one before tells.
    fn error(&self, load: f64, before: Option<&Self>) -> f64 {
        let share = before.map_or(0.0, |before| (self.way / before.way).abs());
        (self.way * self.stiffness / load).abs() * share.max(WRONG)
    }
}

/// About how a load is carried: height of the marker [m] and vertical force of the normal loads
/// there [N].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Carried {
    pub z: f64,
    normal: f64,
}

impl Carried {
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
        self.models.strip_solver.as_ref()?;
        let found = expected.and_then(|about| self.load_about(about, Pose::Near, input, output));
        found.or_else(|| {
            let about = Carried { z: self.guess(clear, input)?, normal: input.wheel_load };
            self.load_about(about, Pose::New, input, output)
        })
    }

    /// About how one rail carries the load of `input`, by one pose: at the height that is `expected`,
    /// near the pose of the last evaluation, or at a guess. Of `output` the first patch is then the
    /// heaviest one there. Nothing where rails give way or strips do not tell.
    pub(crate) fn nearly_carried(
        &mut self,
        input: &Input,
        expected: Option<Carried>,
        output: &mut Output,
    ) -> Option<Carried> {
        let is_told = self.models.strip_solver.is_some() && input.wheel_load > 0.0;
        if !is_told || self.foundation.model != FoundationModel::Rigid {
            return None;
        }
        let mirrored = self.side == Side::Left;
        let mut input = if mirrored { input.mirrored() } else { *input };
        let (about, pose) = if let Some(about) = expected {
            (about, Pose::Near)
        } else {
            input.wheel.position[2] = -self.nominal_radius;
            let clear = self.height_near_touch(&input);
            let z = clear.is_finite().then(|| self.guess(clear, &mut input))??;
            (Carried { z, normal: input.wheel_load }, Pose::New)
        };
        input.wheel.position[2] = about.z;
        let descent = Descent::to(about.normal).from(pose, 0.0);
        let here = self.press(descent, &input, output)?;
        let normal = here.normal + (input.wheel_load - here.carried) / here.rate(None);
        self.models.patches.sort_unstable_by(|a, b| b.normal_force.total_cmp(&a.normal_force));
        output.patches[0] = *self.models.patches.first()?;
        if mirrored {
            *output = output.mirrored();
        }
        Some(Carried { z: here.z + here.way + here.way_to(normal), normal })
    }

    /// The same from `about` how it is carried on.
    fn load_about(
        &mut self,
        about: Carried,
        mut pose: Pose,
        input: &mut Input,
        output: &mut Output,
    ) -> Option<u64> {
        let load = input.wheel_load;
        let (Carried { mut z, mut normal }, mut way) = (about, 0.0);
        let (mut before, mut last) = (None::<Placed>, None::<Placed>);
        for _ in 0..MOST_TRIALS {
            input.wheel.position[2] = z;
            let descent = Descent::to(normal).from(pose, way);
            let here = self.press(descent, input, output)?;
            let missing = load - here.carried;
            let is_placed = here.error(load, before.as_ref()) <= MISPLACED;
            if is_placed && missing.abs() <= MISSING * load {
                input.wheel.position[2] += here.way;
                return Some(here.left_out);
            }
            normal = here.normal + missing / here.rate(last.as_ref());
            if is_placed {
                (pose, way, last) = (Pose::Same, here.way, Some(here));
            } else {
                z = here.height(before.as_ref()) + here.way_to(normal);
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
        let (z, carried) = (input.wheel.position[2], -output.wheel.force[2]);
        let is_one = rails == 1 && stiffness > 0.0 && carried > 0.0;
        is_one.then_some(Placed { z, way, normal, carried, stiffness, left_out })
    }

    /// A height at which the load about is carried by one rail, by contacts each by itself, found at
    /// a height below `clear` [m].
    fn guess(&mut self, clear: f64, input: &mut Input) -> Option<f64> {
        let depth = (input.wheel_load / STIFFNESS).powf(2.0 / 3.0);
        let mut step = depth.clamp(FIRST_STEP[0], FIRST_STEP[1]);
        let mut z = clear;
        for _ in 0..MAX_STEPS {
            z += step;
            input.wheel.position[2] = z;
            let Self { rails, models, .. } = self;
            let rails = rails.iter_mut().enumerate();
            let mut ways = rails.filter_map(|(k, rail)| {
                rail.as_mut()?.way_down(k, input, models, input.wheel_load)
            });
            if let Some(way) = ways.next() {
                return ways.next().is_none().then_some(z + way);
            }
            step = (2.0 * step).min(LONGEST_STEP);
        }
        None
    }
}
