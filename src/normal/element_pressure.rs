//! Pressure on the elements from which strips were made.

use crate::boundary_element::grid::Grid;

/// Pressure on elements, from which strips were made.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ElementPressure {
    /// The elements; x from the wheel marker, y in the contact frame.
    pub grid: Grid,
    /// Pressure on each [Pa].
    pub pressure: Vec<f64>,
    /// The strip of each row; nothing where the row is not loaded.
    pub strip_of_row: Vec<Option<usize>>,
    /// Iterations of conjugate gradients on this grid.
    pub iterations: usize,
}
