//! Memory of an element for evaluations with derivatives.

use super::contact::models::Models;
use super::output::Output;
use crate::math::dual::Dual;

/// Directions that are followed at once for a whole Jacobian.
pub(super) const DIRECTIONS: usize = 7;

/// Memory for evaluations with derivatives.
#[derive(Clone, Debug)]
pub(super) struct DerivativeMemory {
    /// For one direction, and one more for the height that carries a load.
    pub one: Models<Dual<2>>,
    pub one_output: Output<Dual<2>>,
    /// For many at once.
    pub all: Models<Dual<DIRECTIONS>>,
    pub all_output: Output<Dual<DIRECTIONS>>,
}
