//! From inputs to outputs.

use super::input::Input;
use super::output::Output;
use super::parameters::foundation::TrackState;
use super::parameters::{FoundationModel, VerticalMode};
use super::rail::flattened::FlatContact;
use super::wheel_on_rails::Element;
use crate::error::ContactError;

impl Element {
    /// The contacts for `input` as planar problems, as a right wheel has them; allocates. An overlap
    /// that several reach is part of the deepest of them alone. In load mode the height has to be
    /// that found. Poses with several contacts: [`touching_height`](Self::touching_height).
    ///
    /// # Errors
    /// The input at fault, by its FMU name.
    pub fn flat_contacts(&mut self, input: &Input) -> Result<Vec<FlatContact>, ContactError> {
        input.check()?;
        let input = self.turning(*input);
        let mut input = self.side.mirror(input);
        if self.foundation.model != FoundationModel::Rigid {
            let work = self.work;
            self.respond(&mut input, &mut Output::default());
            self.work = work;
        }
        let speed = self.models.minimum_speed;
        let rails = self.rails.iter_mut().enumerate();
        Ok(rails
            .filter_map(|(k, rail)| Some(rail.as_mut()?.flattened(k, &input, speed)))
            .flatten()
            .collect())
    }

    /// The input as it is evaluated, or rates of it, with the pitch rate of a wheel that rolls where
    /// it does.
    pub(super) fn turning(&self, input: Input) -> Input {
        self.rolling.map_or(input, |rolling| rolling.turning(input))
    }

    /// The input as it is evaluated.
    ///
    /// # Errors
    /// The input at fault, by its FMU name.
    pub(super) fn admitted(&self, input: &Input) -> Result<Input, ContactError> {
        input.admitted().map(|input| self.turning(input))
    }

    /// Evaluates the forces; allocates nothing, but with boundary elements.
    ///
    /// # Errors
    /// The input at fault, by its FMU name; `output` is then as before.
    pub fn evaluate(&mut self, input: &Input, output: &mut Output) -> Result<(), ContactError> {
        self.evaluate_at(input, output).map(|_| ())
    }

    /// The same; the input of a right side at which the forces were found, with the height of the
    /// wheel and the place of the rails.
    pub(super) fn evaluate_at(
        &mut self,
        input: &Input,
        output: &mut Output,
    ) -> Result<Input, ContactError> {
        let admitted = self.admitted(input).inspect_err(|_| self.expected = None)?;
        self.work.evaluations += 1;
        let mut input = self.side.mirror(admitted);
        // Nothing can fail from here on.
        self.fallbacks += self.respond(&mut input, output);
        output.report(&input, &mut self.models.patches);
        output.patch_count = self.models.patches.len() as i32;
        output.fallback_count = self.fallback_count();
        self.side.mirror_in_place(output);
        self.report_wear(output);
        Ok(input)
    }

    /// Sums the forces of all rails for the `input` of a right side; returns how many contacts or
    /// zones found no room.
    pub(super) fn forces(&mut self, input: &Input, output: &mut Output) -> u64 {
        self.models.turn_of_normals = 0.0;
        self.models.is_uncoupled = false;
        output.clear();
        self.models.patches.clear();
        self.sunk = None;
        if let Some(memory) = &mut self.models.memory {
            memory.begin();
        }
        let mut left_out = 0;
        for (k, rail) in self.rails.iter_mut().enumerate() {
            if let Some(rail) = rail {
                left_out += rail.evaluate(
                    k,
                    input,
                    &mut self.models,
                    output,
                    &mut self.work,
                    &mut self.sunk,
                );
            }
        }
        left_out
    }

    /// Where the rails are, if that does not follow from an equilibrium.
    pub(super) fn rails_at(&self) -> Option<TrackState> {
        match self.foundation.model {
            FoundationModel::Rigid => Some(TrackState::default()),
            FoundationModel::Massless => None,
            FoundationModel::Mass => self.track,
        }
    }

    /// Puts the rails of `input` (right side) where they are on their foundation and the wheel at
    /// the height that carries its load, and leaves the forces there; returns how many fallbacks
    /// that took.
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
