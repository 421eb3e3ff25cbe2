//! Tractions of a zone element by element, for figures and tables.

use crate::boundary_element::friction::Tractions;
use crate::boundary_element::grid::Grid;

/// Whether the surfaces of an element adhere.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Adherence {
    /// Not in contact, or no tractions asked for.
    #[default]
    None,
    /// They adhere.
    Adhesion,
    /// They slip.
    Slip,
}

/// Pressure and tractions on the elements of a contact.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ContactField {
    /// The elements; y in the contact frame from the contact point.
    pub grid: Grid,
    /// Pressure of each element [Pa].
    pub pressure: Vec<f64>,
    /// Traction (x, y) on the wheel [Pa].
    pub traction: Vec<[f64; 2]>,
    /// Slip of wheel against rail over the rolling speed, if the model has it [-].
    pub slip: Option<Vec<[f64; 2]>>,
    /// Adhesion or slip.
    pub adherence: Vec<Adherence>,
}

impl ContactField {
    /// A field with this `pressure` on `grid` and no tractions.
    pub(crate) fn of_pressure(grid: Grid, pressure: Vec<f64>) -> Self {
        let count = grid.len();
        Self {
            grid,
            pressure,
            traction: vec![[0.0; 2]; count],
            slip: None,
            adherence: vec![Adherence::None; count],
        }
    }

    /// Enters the traction of the element at `i` along row `row`, and whether it slips; nothing
    /// where there is no pressure.
    pub(super) fn enter(&mut self, row: usize, i: usize, traction: [f64; 2], slips: bool) {
        let k = row * self.grid.along + i;
        if self.pressure[k] > 0.0 {
            self.traction[k] = traction;
            self.set_adherence(k, slips);
        }
    }

    /// Enters the tractions and the slip that boundary elements have.
    pub(crate) fn take(&mut self, found: &Tractions) {
        let pairs = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| [*x, *y]).collect();
        self.traction = pairs(&found.x, &found.y);
        self.slip = Some(pairs(&found.slip_x, &found.slip_y));
        for (k, &slips) in found.slips.iter().enumerate() {
            self.set_adherence(k, slips);
        }
    }

    /// Enters whether element `k` slips, if there is pressure on it.
    pub(crate) fn set_adherence(&mut self, k: usize, slips: bool) {
        if self.pressure[k] > 0.0 {
            self.adherence[k] = if slips { Adherence::Slip } else { Adherence::Adhesion };
        }
    }
}
