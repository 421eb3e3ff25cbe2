//! The place in which a wheel starts: the height at which it first touches its rails, and whether
//! anything is odd about it.

use super::input::Input;
use super::output::Output;
use super::parameters::{FoundationModel, VerticalMode};
use super::rail::rail_contact::RailContact;
use super::start_warning::StartWarning;
use super::vertical_load::LONGEST_STEP;
use super::wheel_on_rails::Element;

/// Height above first touch from which on a wheel counts as far from its rails [m]: more than any
/// bounce.
pub(super) const FAR_ABOVE: f64 = 0.01;
/// Depth below first touch from which on a wheel counts as inside its rails [m]: it would press
/// with a hundred times its load.
const INSIDE: f64 = 2e-3;
/// Overlap with which a contact may begin at first touch before that is told [m]: some hundred
/// newtons. It begins with more where a yawed wheel comes over the side of its rail, and the contact
/// line folds.
const AT_ONCE: f64 = 1e-5;
/// Steepness of a contact with rail 2 from which on it is one from the side: a tongue that carries
/// the wheel is no hindrance [rad].
const FROM_THE_SIDE: f64 = std::f64::consts::FRAC_PI_4;
/// Least step of the descent onto the rail [m].
const LEAST_STEP: f64 = 2e-4;
/// Steps after which the wheel stands beside the rail: 0.15 m, more than any flange is high.
const MAX_DESCENT_STEPS: usize = 750;
/// Twice the least radius of bodies against each other that a guess of first touch allows for [m]:
/// penetration goes with the height, but for its square over this; and the greatest share of it.
const TWICE_RADIUS: f64 = 1e-2;
const MOST_ALLOWED: f64 = 0.5;
/// By how much more a guess that was clear is allowed for, and a way that led to no clear height is
/// lengthened.
const FARTHER: f64 = 4.0;
/// Every so many trials the middle is taken, should the guesses be none.
const BISECT_EVERY: usize = 8;
/// From the step of the descent to rounding it takes 45 bisections; half a dozen trials are the rule.
const MAX_TRIALS: usize = BISECT_EVERY * 45;

impl Element {
    /// Takes `start` as the place in which the wheel starts:
    /// [`nominal_wheel_z`](Self::nominal_wheel_z) and [`start_warning`](Self::start_warning) are
    /// then those of it.
    pub fn set_start(&mut self, start: &Input) {
        let touching = self.touch_with_overlap(start);
        self.nominal_wheel_z = touching.map_or(start.wheel.position[2], |touch| touch.height);
        self.start_warning = self.look_at_start(start, touching);
    }

    /// What is odd about the place in which the wheel starts, if anything is.
    pub fn start_warning(&self) -> Option<StartWarning> {
        self.start_warning
    }

    /// What is odd about the place of `input` as one in which a wheel starts.
    pub(super) fn odd_place(&mut self, input: &Input) -> Option<StartWarning> {
        let touching = self.touch_with_overlap(input);
        self.look_at_start(input, touching)
    }

    /// Looks at the place of `start`; `touching` is its first touch, if there is one.
    fn look_at_start(&mut self, start: &Input, touching: Option<Touch>) -> Option<StartWarning> {
        if self.rails.iter().all(Option::is_none) {
            return None;
        }
        let [_, y, z] = start.wheel.position;
        // What is told is the cause: a rail in the way also changes the height of first touch.
        match (self.overlap_of_rail_2(start), touching) {
            (Some(overlap), _) => Some(StartWarning::InRail2 { overlap }),
            (None, None) => Some(StartWarning::BesideTheRails { y, side: self.side }),
            // Where a load is given the height follows from it.
            (None, Some(_)) if self.vertical_mode == VerticalMode::Load => None,
            (None, Some(Touch { height: nominal, .. })) if nominal - z > FAR_ABOVE => {
                Some(StartWarning::InTheAir { z, nominal })
            }
            (None, Some(Touch { height: nominal, .. }))
                if z - nominal - self.way_down(start) > INSIDE =>
            {
                Some(StartWarning::InsideARail { z, nominal })
            }
            (None, Some(Touch { overlap, .. })) if overlap > AT_ONCE => {
                Some(StartWarning::BeginsAtOnce { overlap })
            }
            (None, Some(_)) => None,
        }
    }

    /// How far rails on a foundation sink under the wheel that starts [m].
    fn way_down(&mut self, start: &Input) -> f64 {
        if self.foundation.model == FoundationModel::Rigid {
            return 0.0;
        }
        let mut input = self.side.mirror(*start);
        let mut output = Output::default();
        self.respond(&mut input, &mut output);
        output.foundation.deflection[1]
    }

    /// How far rail 2 reaches into the wheel from the side where it just touches rail 1.
    fn overlap_of_rail_2(&mut self, start: &Input) -> Option<f64> {
        let mut at = self.side.mirror(*start);
        let (first, second) = self.rails.split_at_mut(1);
        let second = second[0].as_mut()?;
        at.wheel.position[2] = first_touch(first, &at)?.height;
        second.search_contacts(1, &at);
        let contacts = second.search.contacts.iter();
        let from_the_side = contacts.filter(|contact| contact.angle().abs() > FROM_THE_SIDE);
        from_the_side.map(|contact| contact.penetration).max_by(f64::total_cmp)
    }

    /// The marker height at which the first contact appears when the wheel comes down from above,
    /// at the y, roll and yaw of `start`; its own height where it stands beside the rails, and not a
    /// number where [`evaluate`](Self::evaluate) refuses the input [m].
    ///
    /// A little below it, the wheel moved sideways, poses with several contacts are found:
    ///
    /// ```
    /// use wheelrail::element::{Element, Input, Output, Parameters};
    ///
    /// let mut input = Input::default();
    /// let mut element = Element::new(&Parameters::default(), &input, &[])?;
    /// let mut output = Output::default();
    /// let mut found = Vec::new();
    /// for step in 0..20 {
    ///     input.wheel.position[1] = 0.75 + 5e-4 * f64::from(step);
    ///     input.wheel.position[2] = element.touching_height(&input) + 1e-4;
    ///     element.evaluate(&input, &mut output)?;
    ///     if output.patch_count > 1 {
    ///         found.push(input.wheel.position[1]);
    ///     }
    /// }
    /// // S1002 on 60E1 at 1:40: tread and flange root, some 5 mm from the middle.
    /// assert!(found.iter().all(|y| (0.754..0.757).contains(y)) && found.len() > 1);
    /// # Ok::<(), wheelrail::error::ContactError>(())
    /// ```
    pub fn touching_height(&mut self, start: &Input) -> f64 {
        let beside = start.check().map_or(f64::NAN, |()| start.wheel.position[2]);
        self.touch(start).unwrap_or(beside)
    }

    /// As [`touching_height`](Self::touching_height); nothing where the wheel stands beside the
    /// rails or the input is refused.
    pub fn touch(&mut self, start: &Input) -> Option<f64> {
        self.touch_with_overlap(start).map(|touch| touch.height)
    }

    fn touch_with_overlap(&mut self, start: &Input) -> Option<Touch> {
        let input = self.side.mirror(start.admitted().ok()?);
        first_touch(&mut self.rails, &input)
    }

    /// As [`touching_height`](Self::touching_height) for the input of a right side; nothing where
    /// the wheel stands beside the rails.
    pub(super) fn first_touch(&mut self, input: &Input) -> Option<f64> {
        first_touch(&mut self.rails, input).map(|touch| touch.height)
    }
}

/// First touch of a wheel that comes down from above.
#[derive(Clone, Copy, Debug)]
struct Touch {
    /// Height of the wheel marker [m].
    height: f64,
    /// How far it would have to be lifted from there by the contacts that it has: nothing, unless
    /// they begin at once [m].
    overlap: f64,
}

/// First touch of one of the `rails` by a wheel that comes down from above, for the input of a right
/// side; nothing where it stands beside them.
fn first_touch(rails: &mut [Option<RailContact>], input: &Input) -> Option<Touch> {
    let highest = (rails.iter().enumerate())
        .filter_map(|(k, rail)| Some(rail.as_ref()?.clear_height(k, input)))
        .fold(f64::INFINITY, f64::min);
    if !highest.is_finite() {
        return None;
    }
    let mut lift = |z: f64| {
        let mut at = *input;
        at.wheel.position[2] = z;
        let rails = rails.iter_mut().enumerate();
        let lifts = rails.filter_map(|(k, rail)| Some(rail.as_mut()?.lift(k, &at)));
        lifts.reduce(|one, other| match (one, other) {
            (Ok(lift), Ok(other)) => Ok(lift.max(other)),
            (Err(apart), Err(other)) => Err(apart.min(other)),
            (Ok(lift), Err(_)) | (Err(_), Ok(lift)) => Ok(lift),
        })
    };
    // A counted descent ends, whatever the numbers: no rail, or a start so far away that a step is
    // lost in rounding.
    let (mut clear, mut touching) = (highest, highest + LEAST_STEP);
    let mut met = None;
    for _ in 0..MAX_DESCENT_STEPS {
        match lift(touching)? {
            Ok(to_lift) => {
                met = Some(to_lift);
                break;
            }
            Err(apart) => {
                clear = touching;
                touching += apart.clamp(LEAST_STEP, LONGEST_STEP);
            }
        }
    }
    let mut to_lift = met?;
    // Down to neighbouring numbers: from within by the penetration, which leaves about its square,
    // and from the last of these guesses up until it is clear.
    let rounding = touching - touching.next_down();
    let (mut allowed, mut way) = (1.0, rounding);
    for trial in 1..=MAX_TRIALS {
        let share = (to_lift / TWICE_RADIUS).min(MOST_ALLOWED);
        let guess = touching - to_lift + allowed * (share * to_lift).max(rounding);
        let is_inside = |z: f64| z > clear && z < touching;
        let middle = 0.5 * (clear + touching);
        let z = if trial % BISECT_EVERY == 0 {
            middle
        } else if is_inside(guess) {
            guess
        } else {
            let above = touching - way;
            way *= FARTHER;
            if is_inside(above) { above } else { middle }
        };
        if !is_inside(z) {
            break;
        }
        if let Some(Ok(found)) = lift(z) {
            (touching, to_lift) = (z, found);
        } else {
            (clear, allowed) = (z, FARTHER * allowed);
        }
    }
    Some(Touch { height: touching, overlap: to_lift })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::parameters::Parameters;
    use crate::element::{Remark, place_remark};
    use crate::error::ContactError;

    /// What is told of a row with a worn wheel at this yaw, 10 µm below first touch.
    fn told_at(yaw: f64) -> Result<Vec<Remark>, ContactError> {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/fmu/resources/profiles");
        let mut parameters = Parameters::default();
        parameters.wheel.profile = "S1002_worn.txt".into();
        let mut input = Input::default();
        input.wheel.position[1] = 0.747_32;
        (input.wheel.yaw, input.wheel.roll) = (yaw, -0.0032);
        let mut element = Element::new(&parameters, &input, &[folder.into()])?;
        input.wheel.position[2] = element.nominal_wheel_z() + 1e-5;
        let mut output = Output::default();
        element.evaluate(&input, &mut output)?;
        let mut told = Vec::new();
        place_remark(&mut element, &parameters, &input, &output, |_, remark| told.push(remark));
        Ok(told)
    }

    #[test]
    fn a_force_begins_with_nothing_where_a_yawed_line_runs_fast() -> Result<(), ContactError> {
        // A search that misses the dip here begins with an overlap of 20 µm, which is told.
        assert_eq!(told_at(-0.1188)?, []);
        assert_eq!(told_at(0.04)?, []);
        Ok(())
    }
}
