//! How many unknowns the strips have.

use super::points::MOMENTS;

/// Strips on which tractions are sought.
pub(super) const NODES: usize = 10;

/// Coefficients of both components, and of all nodes.
pub(super) const PAIR: usize = 2 * MOMENTS;

pub(super) const ALL: usize = PAIR * NODES;
