//! Steps of an element whose contacts remember those before.
//!
//! [`Element::evaluate`] leaves the history as it is: it is a step of no length from it. Whoever
//! knows that time has passed says so with [`Element::advance`]. All trials on the way to a step,
//! as of a given load, begin with the same history.

use super::contact_history::ContactHistory;
use super::{Element, Input, Output};
use crate::error::ContactError;
use crate::tangential::field::ContactField;

impl Element {
    /// Whether tractions follow from those of the steps before.
    pub(crate) fn remembers(&self) -> bool {
        self.models.memory.is_some()
    }

    /// What contacts remember, if they do.
    pub fn contact_history(&self) -> Option<&ContactHistory> {
        self.models.memory.as_ref().map(|memory| &memory.history)
    }

    /// Goes back, or on, to another history of an element with the same parameters; whether there is
    /// one. Steps after it are those after it before, to the bit.
    pub fn set_contact_history(&mut self, history: &ContactHistory) -> bool {
        let Some(memory) = &mut self.models.memory else { return false };
        memory.history.copy_from(history);
        true
    }

    /// Pressure and tractions on the wheel as an evaluation of `input` has them, where contacts
    /// remember: after a step, for its inputs, those that it has left. One field for each rail that
    /// the wheel touches, the most loaded one first, with all its contacts: the arc of the rail laid
    /// flat, from the centre of the most loaded of them. A left wheel is seen as a right one.
    /// Allocates.
    ///
    /// # Errors
    /// As [`evaluate`](Self::evaluate); an element that does not remember, or a pose at which
    /// boundary elements do not settle.
    pub fn remembered_fields(&mut self, input: &Input) -> Result<Vec<ContactField>, ContactError> {
        let Some(memory) = &mut self.models.memory else {
            return Err(ContactError::BadText {
                name: "tangential.history".into(),
                value: "steady".into(),
                allowed: "transient, for tractions that are remembered".into(),
            });
        };
        memory.is_shown = true;
        let done = self.evaluate(input, &mut Output::default());
        let memory = self.models.memory.iter_mut();
        let mut fields: Vec<ContactField> = memory
            .flat_map(|memory| {
                memory.is_shown = false;
                memory.take_shown()
            })
            .collect();
        done?;
        let touches = |rail: i32| self.models.patches.iter().any(|patch| patch.rail == rail);
        let touched = (1..=self.rails.len() as i32).filter(|rail| touches(*rail)).count();
        if fields.len() != touched {
            let z = input.wheel.position[2];
            let allowed = "a pose at which boundary elements settle";
            return Err(ContactError::bad_value("wheel.z", z, allowed));
        }
        let load =
            |field: &ContactField| field.pressure.iter().sum::<f64>() * field.grid.element_area();
        fields.sort_by(|a, b| load(b).total_cmp(&load(a)));
        Ok(fields)
    }

    /// Makes the next evaluations ends of a step of `duration` ≥ 0 [s]; the history stays until
    /// [`end_step`](Self::end_step).
    pub(crate) fn begin_step(&mut self, duration: f64) {
        if let Some(memory) = &mut self.models.memory {
            memory.duration = duration;
        }
    }

    /// Ends the step under way; where it `is_made`, what the last evaluation left is remembered.
    pub(crate) fn end_step(&mut self, is_made: bool) {
        if let Some(memory) = &mut self.models.memory {
            memory.duration = 0.0;
            if is_made {
                memory.commit();
            }
        }
    }

    /// Evaluates the forces at the end of a step of `duration` ≥ 0 [s], and remembers it.
    pub(super) fn step(
        &mut self,
        input: &Input,
        output: &mut Output,
        duration: f64,
    ) -> Result<(), ContactError> {
        self.begin_step(duration);
        let done = self.evaluate(input, output);
        self.end_step(done.is_ok());
        done
    }
}

/// Whether a step may be so long.
///
/// # Errors
/// A duration that is negative or not finite.
pub(crate) fn check_duration(duration: f64) -> Result<(), ContactError> {
    if duration.is_finite() && duration >= 0.0 {
        return Ok(());
    }
    let allowed = "a finite time in seconds, at least 0";
    Err(ContactError::bad_value("duration", duration, allowed))
}
