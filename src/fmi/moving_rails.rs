//! Rails with a mass: what `fmi2DoStep` does with them.

use super::error::FmiError;
use super::instance::Instance;
use super::life_cycle::Purpose;
use super::snapshot::MAX_ELEMENTS;
use crate::element::parameters::FoundationModel;
use crate::element::subject::Subject;
use crate::element::{Element, TrackState};
use crate::variables::Described;

/// Most parts of one step: longer ones are made then, which the method survives and tells as an
/// error.
const MAX_PARTS: f64 = 1000.0;

impl<S: Described> Instance<S> {
    /// Refuses rails with a mass to a host that integrates by itself.
    pub(super) fn check_foundation(&self) -> Result<(), FmiError> {
        let all = S::parameters_of_elements(&self.values.parameters);
        let is_moving = all.iter().any(|own| own.foundation.model == FoundationModel::Mass);
        if is_moving && self.purpose == Purpose::ModelExchange {
            return Err(FmiError::unfit(
                "track.foundation.model",
                "mass",
                "in model exchange rigid or massless: a host that integrates by itself has the rails among its own bodies and moves them \
                 by rail[1].y, rail[1].vy and so on",
            ));
        }
        Ok(())
    }

    /// Whether there are rails with a mass.
    pub(super) fn has_moving_rails(&self) -> bool {
        self.element.iter().flat_map(Subject::elements).any(Element::has_moving_rails)
    }

    /// Moves inputs and rails on over a step [s]; refused, with nothing changed, where an input
    /// leaves its range.
    pub(super) fn move_rails(&mut self, step: f64) -> Result<(), FmiError> {
        let Some(element) = &mut self.element else { return Ok(()) };
        let longest = element.elements().iter().map(Element::longest_step);
        let parts = (step / longest.fold(f64::INFINITY, f64::min)).ceil().clamp(1.0, MAX_PARTS);
        let start = self.values.input;
        let mut states = [None; MAX_ELEMENTS];
        for (state, element) in states.iter_mut().zip(element.elements()) {
            *state = element.track_state();
        }
        let mut errors = [0.0_f64; MAX_ELEMENTS];
        for part in 1..=parts as u32 {
            let from = std::mem::replace(&mut self.values.input, start);
            let end = if f64::from(part) < parts { step * f64::from(part) / parts } else { step };
            let applied = self.extrapolation.apply(end, &mut self.values);
            let moved = applied.and_then(|_| {
                let to = &self.values.input;
                Ok(element.move_all_rails(&from, to, step / parts)?)
            });
            if let Err(error) = moved {
                self.values.input = start;
                for (element, state) in element.elements_mut().iter_mut().zip(states) {
                    element.set_track_state(state);
                }
                return Err(error);
            }
            for (most, element) in errors.iter_mut().zip(element.elements()) {
                *most = element.track_state().map_or(0.0, |state| state.step_error.max(*most));
            }
        }
        for (step_error, element) in errors.into_iter().zip(element.elements_mut()) {
            let state = element.track_state();
            element.set_track_state(state.map(|state| TrackState { step_error, ..state }));
        }
        // On rails elsewhere.
        self.slopes_at = None;
        self.outputs_stale = true;
        Ok(())
    }
}
