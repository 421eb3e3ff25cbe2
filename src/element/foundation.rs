//! What the rails of a side rest on: nothing that yields, springs, or springs and dampers under a mass.
//!
//! All rails of the side are one body on it, which moves sideways and up and down in their frame. Without mass they rest in equilibrium with the
//! contact forces (`resting_rails`), and those with a mass do so until their first step ([`Element::move_rails`]).

use super::evaluate::Element;
use super::input::{INPUTS, Input};
use super::output::Output;
use super::parameters::VerticalMode;

/// What of the foundation is taken into account.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FoundationModel {
    /// Rails do not yield.
    #[default]
    Rigid,
    /// Rails on springs, in equilibrium with the contact forces at every moment.
    Massless,
    /// Rails with a mass on springs and dampers, which run along with the wheel.
    Mass,
}

/// What the rails of a side rest on; pairs are lateral and vertical.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foundation {
    /// What is taken into account.
    pub model: FoundationModel,
    /// Stiffness against the ground, > 0 [N/m].
    pub stiffness: [f64; 2],
    /// Damping against the ground of rails with a mass, ≥ 0 [N s/m].
    pub damping: [f64; 2],
    /// Mass that moves with the rails, > 0 [kg].
    pub mass: f64,
    /// Longest step in which rails with a mass are moved on by the units, > 0 [s].
    pub longest_step: f64,
}

impl Default for Foundation {
    /// Rigid; the numbers are of the size that ballasted track has under one wheel.
    fn default() -> Self {
        Self {
            model: FoundationModel::Rigid,
            stiffness: [2e7, 7e7],
            damping: [5e4, 1e5],
            mass: 150.0,
            longest_step: 1e-4,
        }
    }
}

/// Where the rails of a side with a mass are; pairs are lateral and vertical, of a right side.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TrackState {
    /// Deflection from where they rest without a wheel [m].
    pub deflection: [f64; 2],
    /// Velocity [m/s].
    pub velocity: [f64; 2],
    /// Estimated error that the last step left in the deflection [m].
    pub step_error: f64,
}

/// Moves all rails of an array of inputs, or of their rates, by `way`; `first` is the place of the component of rail 1.
pub(super) fn move_all(numbers: &mut [f64; INPUTS], first: usize, way: f64) {
    numbers[first] += way;
    numbers[first + RAIL] += way;
}

/// Places among the inputs: lateral and vertical coordinate of rail 1, its velocities, and how far behind it rail 2 is.
pub(super) const PLACES: [usize; 2] = [12, 13];
pub(super) const VELOCITIES: [usize; 2] = [15, 16];
const RAIL: usize = 6;

impl Input {
    /// The same with all rails of the side moved.
    pub(super) fn with_rails_moved(&self, deflection: [f64; 2], velocity: [f64; 2]) -> Self {
        let mut moved = *self;
        for rail in &mut moved.rails {
            (rail.y, rail.z) = (rail.y + deflection[0], rail.z + deflection[1]);
            (rail.vy, rail.vz) = (rail.vy + velocity[0], rail.vz + velocity[1]);
        }
        moved
    }
}

impl Element {
    /// Where rails with a mass are since their first step; before it they rest in equilibrium.
    #[must_use]
    pub fn track_state(&self) -> Option<TrackState> {
        self.track
    }

    /// Goes back to an earlier [`track_state`](Self::track_state).
    pub fn set_track_state(&mut self, state: Option<TrackState>) {
        self.track = state;
    }

    /// Whether the rails have a mass.
    #[must_use]
    pub fn has_moving_rails(&self) -> bool {
        self.foundation.model == FoundationModel::Mass
    }

    /// Longest step in which a unit moves rails with a mass on [s].
    #[must_use]
    pub fn longest_step(&self) -> f64 {
        self.foundation.longest_step
    }

    /// Where the rails are, if that does not follow from an equilibrium.
    pub(super) fn rails_at(&self) -> Option<TrackState> {
        match self.foundation.model {
            FoundationModel::Rigid => Some(TrackState::default()),
            FoundationModel::Massless => None,
            FoundationModel::Mass => self.track,
        }
    }

    /// Puts the rails of `input` (right side) where they are on their foundation and the wheel at the height that carries its load, and leaves
    /// the forces there; returns how many fallbacks that took.
    pub(super) fn respond(&mut self, input: &mut Input, output: &mut Output) -> u64 {
        if self.foundation.model == FoundationModel::Rigid {
            return self.respond_to_rails(input, output);
        }
        let (state, fallbacks) = match self.rails_at() {
            Some(state) => {
                *input = input.with_rails_moved(state.deflection, state.velocity);
                (state, self.respond_to_rails(input, output))
            }
            None => self.rest(input, output),
        };
        output.foundation = state.into();
        fallbacks
    }

    /// The same on rails where `input` has them.
    pub(super) fn respond_to_rails(&mut self, input: &mut Input, output: &mut Output) -> u64 {
        match self.vertical_mode {
            VerticalMode::Penetration => self.forces(input, output),
            VerticalMode::Load => self.carry_load(input, output),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_places_among_the_inputs_are_those_of_the_rails() {
        let moved = Input::default().with_rails_moved([1e-3, 2e-3], [3e-3, 4e-3]);
        let mut numbers = Input::default().to_array();
        for (place, way) in PLACES.into_iter().chain(VELOCITIES).zip([1e-3, 2e-3, 3e-3, 4e-3]) {
            move_all(&mut numbers, place, way);
        }
        for (number, moved) in numbers.into_iter().zip(moved.to_array()) {
            assert_eq!(number.to_bits(), moved.to_bits());
        }
    }
}
