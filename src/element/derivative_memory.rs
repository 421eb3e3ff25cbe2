//! Memory of an element for evaluations with derivatives.

use super::contact::models::Models;
use super::input::INPUTS;
use super::output::Output;
use super::parameters::RAILS;
use crate::geometry::curves::knot_slopes::KnotSlopes;
use crate::leaves;
use crate::math::dual::Dual;
use crate::math::tape::{Tape, Taped};

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

/// Memory for derivatives backwards, which grows with the longest evaluation.
#[derive(Clone, Debug)]
pub(super) struct AdjointMemory {
    pub tape: Tape,
    pub models: Models<Taped>,
    pub output: Output<Taped>,
    pub seeds: Vec<(Taped, f64)>,
    pub wheel: KnotSlopes,
    pub rails: [KnotSlopes; RAILS],
}

impl AdjointMemory {
    /// Goes back from `seeds` and from the forces on the wheel across and down, each times its
    /// weight; returns the derivatives by the inputs.
    pub fn sweep(&mut self, is_seeded: bool, forces: [f64; 2]) -> [f64; INPUTS] {
        let Self { tape, models, output, seeds, .. } = self;
        let [_, y, z] = output.wheel.force;
        let own = seeds.iter().copied().take(if is_seeded { usize::MAX } else { 0 });
        let all = own.chain([y, z].into_iter().zip(forces));
        tape.sweep(all, |n, right| {
            if let Some(follower) = &mut models.strip_follower {
                follower.solve_kept(n, right);
            }
        });
        std::array::from_fn(|i| tape.slope_of(leaves::input(i)))
    }
}
