//! What is odd about the place in which a wheel starts: nothing that is refused, but a host should hear of it before it wonders at the forces.

use std::fmt;

use super::evaluate::{Element, first_touch};
use super::input::Input;
use super::output::Output;
use super::parameters::{FoundationModel, Side, VerticalMode};

/// Height above first touch from which on a wheel counts as far from its rails [m]: more than any bounce.
const FAR_ABOVE: f64 = 0.01;
/// Depth below first touch from which on a wheel counts as inside its rails [m]: it would press with a hundred times its load.
const INSIDE: f64 = 2e-3;
/// Steepness of a contact with rail 2 from which on it is one from the side: a tongue that carries the wheel is no hindrance [rad].
const FROM_THE_SIDE: f64 = std::f64::consts::FRAC_PI_4;

/// Something odd about the place in which a wheel starts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StartWarning {
    /// It stands beside all rails, at this y, or is on the other side of the track.
    BesideTheRails {
        /// Lateral position of the wheel marker [m].
        y: f64,
        /// Side of the track that the parameters name.
        side: Side,
    },
    /// It hangs far above the height of first touch.
    InTheAir {
        /// Height of the wheel marker [m].
        z: f64,
        /// Height at which the wheel would just touch [m].
        nominal: f64,
    },
    /// It is far below the height of first touch.
    InsideARail {
        /// Height of the wheel marker [m].
        z: f64,
        /// Height at which the wheel would just touch [m].
        nominal: f64,
    },
    /// Where it stands on rail 1 it overlaps rail 2 from the side.
    InRail2 {
        /// By how much [m].
        overlap: f64,
    },
}

impl StartWarning {
    /// The words for it; `prefix` stands before the names of variables of this wheel in a wheelset.
    #[must_use]
    pub fn message(&self, prefix: &str) -> String {
        let of = |name: &str| {
            if prefix.is_empty() { format!("wheel.{name}") } else { format!("wheelset.{name}") }
        };
        match *self {
            Self::BesideTheRails { y, side } => {
                let (side, sign) = match side {
                    Side::Right => ("right", "positive"),
                    Side::Left => ("left", "negative"),
                };
                format!(
                    "the wheel on the {side} side starts beside its rails, with its marker at y = {y} m: it carries nothing there; on this side y \
                     is {sign}, about half the gauge: set {}",
                    of("y")
                )
            }
            Self::InTheAir { z, nominal } | Self::InsideARail { z, nominal } => {
                let mm = 1e3 * (z - nominal).abs();
                let (place, what) = if z < nominal {
                    ("above", "it hangs in the air")
                } else {
                    ("below", "it is inside the rail")
                };
                format!(
                    "the wheel starts with its marker at z = {z} m, {mm:.1} mm {place} {prefix}nominal.wheel_z = {nominal:.6} m, where it would \
                     just touch: {what}; set {} from that height",
                    of("z")
                )
            }
            Self::InRail2 { overlap } => format!(
                "where the wheel stands on {prefix}rail[1] it overlaps {prefix}rail[2] by {:.1} mm from the side: move it by {prefix}rail[2].position.y, which counts with {prefix}rail[2].placement = position",
                1e3 * overlap
            ),
        }
    }
}

/// The words for a wheel that is `depth` [m] below the top of its rail, as [`Element::sunk`] has it; `prefix` as in
/// [`StartWarning::message`].
#[must_use]
pub fn sunk_message(depth: f64, prefix: &str) -> impl fmt::Display {
    SunkMessage { depth, prefix }
}

/// Written where it goes, during a run, so that nothing is allocated for it.
struct SunkMessage<'a> {
    depth: f64,
    prefix: &'a str,
}

impl fmt::Display for SunkMessage<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the wheel is {:.1} mm below the top of its rail, deeper than the outlines tell a force: it carries nothing there, and is not \
             lifted; see {}nominal.wheel_z for where it would just touch",
            1e3 * self.depth,
            self.prefix
        )
    }
}

impl Element {
    /// What is odd about the place in which the wheel starts, if anything is.
    #[must_use]
    pub fn start_warning(&self) -> Option<StartWarning> {
        self.start_warning
    }

    /// Looks at the place of `start`; `touching` is the height of first touch, if there is one.
    pub(super) fn look_at_start(&mut self, start: &Input, touching: Option<f64>) {
        if self.rails.iter().all(Option::is_none) {
            return;
        }
        let [_, y, z] = start.wheel.position;
        // What is told is the cause: a rail in the way also changes the height of first touch.
        self.start_warning = match (self.overlap_of_rail_2(start), touching) {
            (Some(overlap), _) => Some(StartWarning::InRail2 { overlap }),
            (None, None) => Some(StartWarning::BesideTheRails { y, side: self.side }),
            // Where a load is given the height follows from it.
            (None, Some(_)) if self.vertical_mode == VerticalMode::Load => None,
            (None, Some(nominal)) if nominal - z > FAR_ABOVE => {
                Some(StartWarning::InTheAir { z, nominal })
            }
            (None, Some(nominal)) if z - nominal - self.way_down(start) > INSIDE => {
                Some(StartWarning::InsideARail { z, nominal })
            }
            (None, Some(_)) => None,
        };
    }

    /// How far rails on a foundation sink under the wheel that starts [m].
    fn way_down(&mut self, start: &Input) -> f64 {
        if self.foundation.model == FoundationModel::Rigid {
            return 0.0;
        }
        let mut input = if self.side == Side::Left { start.mirrored() } else { *start };
        let mut output = Output::default();
        self.respond(&mut input, &mut output);
        output.foundation.deflection[1]
    }

    /// How far rail 2 reaches into the wheel from the side where it just touches rail 1.
    fn overlap_of_rail_2(&mut self, start: &Input) -> Option<f64> {
        let mut at = if self.side == Side::Left { start.mirrored() } else { *start };
        let (first, second) = self.rails.split_at_mut(1);
        let second = second[0].as_mut()?;
        at.wheel.position[2] = first_touch(first, &at)?;
        second.search_contacts(1, &at);
        let contacts = second.search.contacts.iter();
        let from_the_side = contacts.filter(|contact| contact.angle().abs() > FROM_THE_SIDE);
        from_the_side.map(|contact| contact.penetration).max_by(f64::total_cmp)
    }
}
