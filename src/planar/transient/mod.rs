//! A planar contact problem followed through a series of states: contact with memory.
//!
//! Each step has a state (separation, radius, indentation, creepage, friction), the distance rolled
//! since the state before, and a shift. The pressure is that of the state; tractions follow from
//! those of the step before ([`crate::boundary_element::transient`]), on elements of one endless
//! lattice, in steps of any length ([`crate::boundary_element::steps`]).

mod check;
mod given_force;
mod history;
mod pressed;
mod step;
mod substep;
mod walk;

pub use history::History;
pub use step::{StepMotion, TransientField, TransientResult};

use super::PlanarCase;
use crate::boundary_element::grid::Grid;
use crate::boundary_element::steps::Lattice;
use crate::error::ContactError;
use check::{check, first_force};
use pressed::{Pressed, first_lattice, press_on};
use step::displacement;
use walk::Walk;

/// A planar problem that is followed through a series of states.
#[derive(Clone, Debug, Default)]
pub struct TransientContact {
    history: History,
    last: Option<TransientField>,
}

/// Least and greatest size of an element [m].
const SIZES: (f64, f64) = (1e-7, 1.0);

impl TransientContact {
    /// A contact whose elements are those of its first state: [`PlanarCase::elements`] over the
    /// extent of all zones. Later states have elements of the same size.
    pub fn new() -> Self {
        Self::default()
    }

    /// A contact with elements of the length and width `size` [m], one of them centred at x = 0 on
    /// the origin of the separation.
    ///
    /// # Errors
    /// A size that is not positive, or that is beyond 0.1 μm to 1 m.
    pub fn with_element_size(size: [f64; 2]) -> Result<Self, ContactError> {
        for (name, size) in ["element_length", "element_width"].into_iter().zip(size) {
            if !(SIZES.0..=SIZES.1).contains(&size) {
                return Err(ContactError::bad_value(name, size, "a size in metres, 1e-7 to 1"));
            }
        }
        let lattice = Some(Lattice { size, origin: [0.0; 2] });
        Ok(Self { history: History { lattice, ..History::default() }, last: None })
    }

    /// What the next step depends on.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// Goes back, or on, to another history: steps after it are those after it before, to the bit.
    pub fn set_history(&mut self, history: History) {
        *self = Self { history, last: None };
    }

    /// Pressure, tractions and slip of the last step; nothing before the first, after a new history
    /// and without contact.
    pub fn field(&self) -> Option<&TransientField> {
        self.last.as_ref()
    }

    /// Goes one step on, to the state `case`. The models of `case` are boundary elements, its
    /// friction does not fall.
    ///
    /// # Errors
    /// A value that is not admitted, a load that no approach carries or a creep force that the
    /// contact cannot carry, each by its name. The history stays as it was.
    pub fn step(
        &mut self,
        case: &PlanarCase,
        motion: &StepMotion,
    ) -> Result<TransientResult, ContactError> {
        check(case, motion, &self.history)?;
        let mut history = self.history.clone();
        history.materials = Some([case.wheel_material, case.rail_material]);
        if history.lattice.is_none() {
            history.lattice = first_lattice(case)?;
        }
        let pressed = match &history.lattice {
            Some(lattice) => press_on(lattice, case)?,
            None => None,
        };
        let Some((lattice, Pressed { strips, contact_y, field, window, left_out })) =
            history.lattice.zip(pressed)
        else {
            if let Some((name, force)) = first_force(motion) {
                return Err(ContactError::bad_value(name, force, "0 where there is no contact"));
            }
            history.kept.clear();
            *self = Self { history, last: None };
            let displacement = displacement(case, motion);
            return Ok(TransientResult { displacement, converged: true, ..Default::default() });
        };
        let grid = Grid { left_y: field.grid.left_y + contact_y, ..field.grid };
        let mut walk = Walk::new(case, motion, grid, window, &field)?;
        walk.go(&history, lattice)?;
        let mut result = walk.result(&strips);
        result.contact.fallback = left_out > 0;
        history.kept.window = window;
        history.kept.tractions = walk.tractions().to_vec();
        let last = walk.field(field.pressure);
        *self = Self { history, last: Some(last) };
        Ok(result)
    }
}
