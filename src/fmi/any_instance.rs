//! An instance of any of the units in this library.

use std::path::PathBuf;

use super::error::FmiError;
use super::instance::Instance;
use super::interface::Interface;
use super::life_cycle::{Purpose, State};
use super::starts::Starts;
use crate::element::Element;
use crate::variables::{Described, Unit};
use crate::wheelset::Wheelset;

/// What an `fmi2Component` or an `fmi3Instance` stands for.
#[derive(Debug)]
pub enum AnyInstance {
    /// Of `WheelRail.fmu`.
    Wheel(Box<Instance<Element>>),
    /// Of `WheelSet.fmu`.
    Wheelset(Box<Instance<Wheelset>>),
}

/// Runs the same lines on an instance of any unit.
macro_rules! on_instance {
    ($any:expr, |$instance:tt| $body:expr) => {
        match $any {
            $crate::fmi::any_instance::AnyInstance::Wheel($instance) => $body,
            $crate::fmi::any_instance::AnyInstance::Wheelset($instance) => $body,
        }
    };
}
pub(super) use on_instance;

impl AnyInstance {
    /// An instance of `unit` with the start values of the crate, or of a packed unit.
    pub fn new(
        unit: &Unit,
        interface: Interface,
        purpose: Purpose,
        profile_folders: Vec<PathBuf>,
        starts: &Starts,
        has_state: bool,
    ) -> Result<Self, FmiError> {
        let made = (interface, purpose, profile_folders, has_state);
        Ok(if unit.guid == Wheelset::UNIT.guid {
            Self::Wheelset(Box::new(instance(starts, made)?))
        } else {
            Self::Wheel(Box::new(instance(starts, made)?))
        })
    }

    /// Place in the life cycle.
    #[inline]
    pub fn state(&self) -> State {
        on_instance!(self, |instance| instance.state)
    }

    /// Through which it was made.
    #[inline]
    pub fn interface(&self) -> Interface {
        on_instance!(self, |instance| instance.interface)
    }

    /// Moves to another place in the life cycle.
    pub fn put_into(&mut self, state: State) {
        on_instance!(self, |instance| instance.state = state);
    }
}

fn instance<S: Described>(
    starts: &Starts,
    (interface, purpose, folders, has_state): (Interface, Purpose, Vec<PathBuf>, bool),
) -> Result<Instance<S>, FmiError> {
    Ok(Instance::new(interface, purpose, folders, Box::new(starts.values()?), has_state))
}
