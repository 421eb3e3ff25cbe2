//! Where one wheel carries a given load, by the stiffness of its contacts: its height, and the
//! deflection aside of rails without mass.
//!
//! The [`balance`](super::balance) of a pose says which one to try next, each but the first from the
//! solution of the one before. Where the first one is say the ellipses of the overlaps that strips are
//! pressed by, or contacts by themselves, with creep forces. Where the geometry of a pose will do and
//! load is missing, it is its forces that are found anew, or, where little is, all of them take the
//! last step at once.

use nalgebra::SMatrix;

use super::balance::{Balance, Carried, Expected, Held, LONGEST, MOST_POSES, Placed};
use super::input::Input;
use super::output::{Output, heaviest};
use super::parameters::{FoundationModel, Side};
use super::pose_under_load::normal_force_down;
use super::vertical_load::{FIRST_STEP, LONGEST_STEP, MAX_STEPS, STIFFNESS};
use super::wheel_on_rails::Element;
use crate::math::broyden::Broyden;
use crate::normal::{Descent, Pose, way_between};

/// Depth over that of the load about from which on a pose is too far for a guess.
const FAR: f64 = 3.0;
/// Way over that depth up to which an overlap tells how strips would press farther down: a thirtieth
/// of its square or so is left of it, little enough for the first pose.
const NEAR: f64 = 0.7;
/// Way aside over that depth that a guess of how far rails without mass are aside may be off: about as
/// much as friction bears on a tread.
const NEAR_ASIDE: f64 = 0.1;
/// Most guesses of how far rails without mass are aside: on flanges forces fall steeply as they go.
const MOST_GUESSES: usize = 6;

/// How far a balance is sought.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum To {
    /// To the pose that has the forces.
    TheEnd,
    /// To where that is, for an evaluation there by itself.
    OneBefore,
}

/// Where a balance is sought from, and how far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Way {
    /// What is known about how the load is carried.
    pub about: Carried,
    /// What the first pose has to do with that of the last problem.
    pub pose: Pose,
    pub to: To,
}

/// How a wheel is carried where nothing is left of its balance.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    pub carried: Carried,
    /// Contacts and zones that found no room.
    pub left_out: u64,
}

/// A pose of one of several wheels under its load.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PosedWheel {
    held: Held,
    /// What was known about how it is carried there.
    pub about: Carried,
    pub placed: Placed,
    /// How far down it may go with the roll of its axle, as its place of contact turns about the
    /// marker [m].
    pub down_with_roll: f64,
}

impl PosedWheel {
    /// Its balance, with this as the first pose.
    pub fn balance(&self) -> Balance {
        Balance::at(&self.placed, self.held, self.about.aside)
    }

    /// Where the balance is taken.
    pub fn tried(&self) -> Carried {
        Carried { normal: self.placed.normal, ..self.about }
    }
}

impl Element {
    /// Says how the load of the next evaluation is carried, if that is known.
    pub(crate) fn expect(&mut self, expected: Option<Expected>) {
        self.expected = expected;
    }

    /// What this wheel and its rails are held by under the load of `input`; nothing where rails have
    /// a mass.
    pub(super) fn held_under_load(&self, input: &Input) -> Option<Held> {
        let lateral_stiffness = match self.foundation.model {
            FoundationModel::Rigid => None,
            FoundationModel::Massless => Some(self.foundation.stiffness[0]),
            FoundationModel::Mass => return None,
        };
        Some(Held { load: input.wheel_load, lateral_stiffness })
    }

    /// The pose of `given` (right side) for the unknowns of a balance.
    fn put(&self, given: &Input, held: &Held, at: &Carried) -> Input {
        let mut input = if held.lateral_stiffness.is_some() {
            let sunk = held.load / self.foundation.stiffness[1];
            given.with_rails_moved([at.aside, sunk], [0.0; 2])
        } else {
            *given
        };
        input.wheel.position[2] = at.z;
        input
    }

    /// Puts the wheel of `input` (right side) at the height at which one rail carries its load, and
    /// leaves the forces there, from the height `clear` on; returns how many fallbacks that took, or
    /// nothing where it does not lead there.
    pub(super) fn load_by_stiffness(
        &mut self,
        clear: f64,
        expected: Option<Expected>,
        input: &mut Input,
        output: &mut Output,
    ) -> Option<u64> {
        let held = Held { load: input.wheel_load, lateral_stiffness: None };
        let given = *input;
        let mut found = None;
        if let Some(Expected::About(about, pose)) = expected {
            let way = Way { about, pose, to: To::TheEnd };
            found = self.balanced(held, way, &given, input, output);
        }
        if found.is_none() {
            let about = self.guess(clear, input, output)?;
            let way = Way { about, pose: Pose::New, to: To::TheEnd };
            found = self.balanced(held, way, &given, input, output);
        }
        let Found { carried, left_out, .. } = found?;
        input.wheel.position[2] = carried.z;
        self.carried = Some(carried);
        Some(left_out)
    }

    /// Where the wheel of `given` (right side) is carried as it is `held`, near what is known
    /// `about` that, with the forces there, or with those of the pose before if that is what it is
    /// sought `to`; nothing where poses do not lead to it.
    pub(super) fn balanced(
        &mut self,
        held: Held,
        way: Way,
        given: &Input,
        input: &mut Input,
        output: &mut Output,
    ) -> Option<Found> {
        let mut search = None::<(Balance, Broyden<3>)>;
        let Way { mut about, mut pose, to } = way;
        let mut before = None::<Placed>;
        for _ in 0..MOST_POSES {
            *input = self.put(given, &held, &about);
            let here = self.press(&about, pose, input, output)?;
            let Placed { way, normal, stiffness, left_out, .. } = here;
            let tried = Carried { normal, ..about };
            let is_first = search.is_none();
            let (balance, search) = search.get_or_insert_with(|| begin(&here, held, &tried));
            if !is_first {
                let left = balance.take(&here, about.aside);
                search.take(balance.unknowns(&tried).into(), left.into());
            }
            let is_placed = balance.is_placed();
            if is_placed && balance.is_carried() {
                let carried =
                    Carried { z: balance.height_of(here.pressed()), normal, stiffness, ..about };
                return Some(Found { carried, left_out });
            }
            if to == To::TheEnd {
                let Self { models, pose_forces, .. } = self;
                let last = before.replace(here).filter(|last| last.left_out + left_out == 0);
                let further = last.and_then(|last| Some((last, balance.further(&last, false)?)));
                if let Some((last, part)) = further
                    && pose_forces.go_on(part, output, &mut models.patches)
                {
                    let normal = here.pressed() + part * (here.pressed() - last.pressed());
                    let carried =
                        Carried { z: balance.height_of(normal), normal, stiffness, ..about };
                    return Some(Found { carried, left_out });
                }
                pose_forces.keep(output, &models.patches);
            }
            // Contacts that found no room are told by a search alone.
            if is_placed && left_out == 0 {
                // The geometry is that of the pose: it is the load alone that has to change.
                let [z, _, aside] = balance.unknowns(&tried);
                let normal = balance.carried([z, search.next_alone(1), aside]).normal;
                (about, pose) = (Carried { normal, ..tried }, Pose::Same(way));
                continue;
            }
            let [at, step] = search.next()?;
            if !is_first && step.fixed_rows::<2>(0).amax() > LONGEST {
                return None;
            }
            let next = balance.carried(at.into());
            if to == To::OneBefore && balance.is_nearly_met() {
                return Some(Found { carried: next, left_out });
            }
            (about, pose) = (next, Pose::Near);
        }
        None
    }

    /// About how this wheel carries the load of `input`, and how far down it may go with the roll of
    /// its axle there, as its place of contact turns about the marker [m]; nothing where its rails
    /// have a mass or where it is not one rail that carries it.
    pub(crate) fn guess_load(
        &mut self,
        input: &Input,
        output: &mut Output,
    ) -> Option<(Carried, f64)> {
        let given = self.side.mirror(*input);
        let held = self.held_under_load(&given).filter(|_| input.wheel_load > 0.0)?;
        let (about, _) = self.guess_held(&held, &given, output)?;
        let [_, y, _] = given.wheel.position;
        let down_with_roll = self.down_with_roll([y, about.z])?;
        Some((about, down_with_roll))
    }

    /// How far down this wheel may go with the roll of its axle, which is not mirrored, as the place
    /// of the heaviest of its patches turns about the marker (y, z) of a right side [m].
    fn down_with_roll(&self, [y, z]: [f64; 2]) -> Option<f64> {
        let patch = heaviest(&self.models.patches)?;
        let [_, across, down] = patch.position;
        let turned = (z - down) * patch.contact_angle.tan() + y - across;
        Some(if self.side == Side::Left { -turned } else { turned })
    }

    /// The same for `given` (right side), which is `held` so, with the forces of all patches; and how
    /// far aside the forces on rails that have not gone aside would put them [m].
    pub(super) fn guess_held(
        &mut self,
        held: &Held,
        given: &Input,
        output: &mut Output,
    ) -> Option<(Carried, f64)> {
        // From above, whatever the height given.
        let nowhere = Carried { z: -self.nominal_radius, normal: 0.0, stiffness: 0.0, aside: 0.0 };
        let (mut aside, mut guessed, mut before) = (0.0, None, None::<[f64; 2]>);
        for _ in 0..MOST_GUESSES {
            let mut input = self.put(given, held, &Carried { aside, ..nowhere });
            let clear = self.height_near_touch(&input);
            if !clear.is_finite() {
                return None;
            }
            let about = Carried { aside, ..self.guess(clear, &mut input, output)? };
            let Some(lateral_stiffness) = held.lateral_stiffness else { return Some((about, 0.0)) };
            let [_, lateral, vertical] = output.wheel.force;
            let to = lateral / vertical * held.load / lateral_stiffness;
            let at_once = guessed.map_or(to, |(_, at_once)| at_once);
            guessed = Some((about, at_once));
            let left = to - aside;
            if left.abs() <= NEAR_ASIDE * held.load / about.stiffness {
                break;
            }
            let share = before.map_or(1.0, |[y, before]| (aside - y) / (before - left));
            before = Some([aside, left]);
            aside += share * left;
        }
        guessed
    }

    /// The pose of `input` under its load, with what is known `about` how it is carried there; but
    /// for a new one `output` has the forces of the one before.
    pub(crate) fn pose_under_load(
        &mut self,
        input: &Input,
        about: &Carried,
        pose: Pose,
        output: &mut Output,
    ) -> Option<PosedWheel> {
        if pose != Pose::New {
            self.pose_forces.keep(output, &self.models.patches);
        }
        let given = self.side.mirror(*input);
        let held = self.held_under_load(&given)?;
        let input = self.put(&given, &held, about);
        let placed = self.press(about, pose, &input, output)?;
        let [_, y, z] = input.wheel.position;
        let down_with_roll = self.down_with_roll([y, z])?;
        let posed = PosedWheel { held, about: *about, placed, down_with_roll };
        (placed.left_out == 0).then_some(posed)
    }

    /// Lets the forces of `output`, which are those of the last pose, go on by `part` of what the last
    /// two poses under a load changed them by; false, and nothing changed, where that is not told.
    pub(crate) fn go_on(&mut self, part: f64, output: &mut Output) -> bool {
        self.pose_forces.go_on(part, output, &mut self.models.patches)
    }

    /// About how the load is carried by one rail, by contacts each by itself, found at a height
    /// below `clear` [m].
    fn guess(&mut self, clear: f64, input: &mut Input, output: &mut Output) -> Option<Carried> {
        let load = input.wheel_load;
        let depth = (load / STIFFNESS).powf(2.0 / 3.0);
        let mut step = depth.clamp(FIRST_STEP[0], FIRST_STEP[1]);
        let is_of_overlap = self.models.strip_solver.is_some();
        let mut longest = if is_of_overlap { NEAR * depth } else { f64::INFINITY };
        let (mut z, mut most_lift) = (clear, FAR * depth);
        for _ in 0..MAX_STEPS {
            z += step;
            input.wheel.position[2] = z;
            output.clear();
            self.models.patches.clear();
            let Self { rails, models, work, .. } = self;
            let (mut met, mut nearest) = (None, f64::NEG_INFINITY);
            for (k, rail) in rails.iter_mut().enumerate() {
                let Some(rail) = rail else { continue };
                let bounds = [load, most_lift, longest];
                match rail.way_down(k, input, bounds, models, output, work) {
                    Err(lift) => nearest = nearest.max(lift),
                    Ok(_) if met.is_some() => return None,
                    Ok(descent) => met = Some(descent),
                }
            }
            if nearest > 0.0 {
                // Once: what is left is a matter of the geometry.
                (step, most_lift) = (depth - nearest, f64::INFINITY);
                continue;
            }
            let Some(descent) = met else {
                step = (depth - nearest).max(2.0 * step).min(LONGEST_STEP);
                continue;
            };
            let Descent { way, reached, stiffness, .. } = descent;
            if way.abs() > longest {
                // Once as well.
                (step, longest) = (way, f64::INFINITY);
                continue;
            }
            let ratio = -output.wheel.force[2] / normal_force_down(&self.models.patches);
            let normal = load / ratio;
            let z = z + way + way_between(reached, stiffness, normal);
            let is_there = ratio > 0.0 && stiffness > 0.0 && z.is_finite();
            return is_there.then_some(Carried { z, normal, stiffness, aside: 0.0 });
        }
        None
    }
}

/// A balance at the first pose, and the search that goes on from it.
fn begin(here: &Placed, held: Held, tried: &Carried) -> (Balance, Broyden<3>) {
    let balance = Balance::at(here, held, tried.aside);
    let rows = balance.matrix();
    let matrix = SMatrix::from_fn(|i, j| rows[i][j]);
    let at = balance.unknowns(tried).into();
    (balance, Broyden::new(matrix, at, balance.left().into()))
}
