//! The height at which one rail carries a given load, by the stiffness of its contacts.
//!
//! At a pose near it strips say how far down the wheel has to go for a vertical force of theirs, with
//! the geometry as it is ([`Descent`]), and what creep forces add there. Both change a little with
//! the height and with the normal force: two equations in two unknowns, which Broyden's method
//! solves from what they would be if the geometry and the share of creep forces stayed. Contacts by
//! themselves, with their creep forces, say where the first pose is. Normal models that solve
//! contacts by themselves go on from there by secants of whole evaluations.

use super::input::Input;
use super::output::Output;
use super::parameters::{FoundationModel, Side};
use super::quasi_static_rails::solve;
use super::vertical_load::{FIRST_STEP, LONGEST_STEP, MAX_STEPS, STIFFNESS};
use super::wheel_on_rails::Element;
use crate::normal::{Descent, Pose};

/// Most ways down that are tried.
const MOST_TRIALS: usize = 12;
/// Share of the load that may be missing, and that forces may be off because of the geometry.
const MISSING: f64 = 1e-10;
const MISPLACED: f64 = 1e-9;
/// Share of a way that the geometry is wrong by at least, whatever poses tell, and where there is
/// one pose alone: what lateral forces on flanges change by.
const WRONG: [f64; 2] = [1e-3, 0.05];
/// Depth over that of the load about from which on a pose is too far for a guess.
const FAR: f64 = 3.0;
/// Greatest way over the depth of the load that stays within what poses have told.
const LONGEST: f64 = 0.5;

/// A pose, and what its geometry led to.
#[derive(Clone, Copy, Debug)]
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
    /// How many times as much as the normal loads all forces bear [-].
    fn ratio(&self) -> f64 {
        self.carried / self.normal
    }

    /// What is known of how the load is carried, at another height and normal force.
    fn carried_at(&self, z: f64, normal: f64) -> Carried {
        Carried { z, normal, stiffness: self.stiffness, ratio: self.ratio(), aside: None }
    }

    /// Height and normal force at which the load is carried if the geometry and the share of creep
    /// forces stay [m, N].
    fn next(&self, load: f64) -> [f64; 2] {
        let normal = load / self.ratio();
        [self.z + self.way + way_between(self.normal, self.stiffness, normal), normal]
    }
}

/// The two equations of a load: no way is to be left from a pose down to where it has its normal
/// force, and nothing is to be missing of the load there. Unknowns and residuals are over the load
/// and its depth, load over stiffness.
struct Balance {
    load: f64,
    depth: f64,
    /// What a step of height and normal force takes off each residual.
    matrix: [[f64; 2]; 2],
    last: Placed,
    /// Share of the load by which forces are off because of the geometry, as far as poses tell: the
    /// vertical one by what the way was wrong, the lateral one by how much it changed.
    error: f64,
}

impl Balance {
    fn at(first: Placed, load: f64) -> Self {
        let depth = load / first.stiffness;
        let matrix = [[1.0, -1.0], [0.0, first.ratio()]];
        let error = (first.way / depth).abs() * WRONG[1];
        Self { load, depth, matrix, last: first, error }
    }

    /// Way and load left at a pose.
    fn left(&self, at: &Placed) -> [f64; 2] {
        [at.way / self.depth, (self.load - at.carried) / self.load]
    }

    /// Takes over what another pose tells (Broyden 1965).
    fn take(&mut self, here: Placed) {
        let (left, before) = (self.left(&here), self.left(&self.last));
        let last = &self.last;
        let step = [(here.z - last.z) / self.depth, (here.normal - last.normal) / self.load];
        let square = step[0] * step[0] + step[1] * step[1];
        if square > 0.0 {
            for (i, row) in self.matrix.iter_mut().enumerate() {
                let off = before[i] - left[i] - row[0] * step[0] - row[1] * step[1];
                row[0] += off * step[0] / square;
                row[1] += off * step[1] / square;
            }
        }
        let share = (self.matrix[0][0] - 1.0).abs().max(WRONG[0]);
        let turned = (here.aside - last.aside) * left[0] / (before[0] - left[0]);
        self.error = (share * left[0]).abs() + turned.abs();
        self.last = here;
    }

    fn is_met(&self) -> bool {
        self.error <= MISPLACED && self.left(&self.last)[1].abs() <= MISSING
    }

    /// Height and normal force to be tried next, after at least two poses [m, N].
    fn next(&self) -> [f64; 2] {
        let step = solve(self.matrix, self.left(&self.last));
        step.filter(|[down, _]| down.abs() < LONGEST).map_or_else(
            || self.last.next(self.load),
            |[down, more]| [self.last.z + down * self.depth, self.last.normal + more * self.load],
        )
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
        let descent = Descent::to(about.normal).at(pose);
        let here = self.press(descent, input, output)?;
        let [z, normal] = here.next(input.wheel_load);
        Some(here.carried_at(z, normal))
    }

    /// The same by the poses that strips tell the way from.
    fn load_about(
        &mut self,
        about: Carried,
        mut pose: Pose,
        input: &mut Input,
        output: &mut Output,
    ) -> Option<u64> {
        let Carried { mut z, mut normal, .. } = about;
        let mut balance = None::<Balance>;
        for _ in 0..MOST_TRIALS {
            input.wheel.position[2] = z;
            let here = self.press(Descent::to(normal).at(pose), input, output)?;
            if let Some(balance) = &mut balance {
                balance.take(here);
            }
            let told = balance.is_some();
            let balance = balance.get_or_insert_with(|| Balance::at(here, input.wheel_load));
            if balance.is_met() {
                z += here.way;
                input.wheel.position[2] = z;
                self.carried = Some(here.carried_at(z, here.normal));
                return Some(here.left_out);
            }
            [z, normal] = if told { balance.next() } else { here.next(input.wheel_load) };
            pose = Pose::Near;
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
