//! One substep, with creepage or forces given.

use super::check::FORCES;
use super::given_force::{Forces, displacement_for};
use crate::boundary_element::friction::Tractions;
use crate::boundary_element::grid::Grid;
use crate::boundary_element::steps::Solve;
use crate::error::ContactError;

/// Sum of the tractions [N].
pub fn force_of(grid: &Grid, tractions: &[[f64; 2]]) -> [f64; 2] {
    let area = grid.element_area();
    [0, 1].map(|c| tractions.iter().map(|p| p[c]).sum::<f64>() * area)
}

/// What a substep leads to.
pub struct Advanced {
    /// Tractions at its end, and its slip [m].
    pub tractions: Tractions,
    /// Rigid displacement (x, y, turn).
    pub displacement: [f64; 3],
}

/// Forces that are given.
pub struct Given {
    /// Longitudinal and lateral force, where it is given [N].
    pub force: [Option<f64>; 2],
    /// Friction limit [N].
    pub limit: f64,
    /// About the displacement of the substep over the force without slip [m/N].
    pub compliance: f64,
}

/// Solves a substep with the rigid displacement (x, y, turn), of which a component whose `force` is
/// given is found, less what is `carried`.
///
/// # Errors
/// A force that the contact does not carry.
pub fn advance(
    grid: &Grid,
    before: &[[f64; 2]],
    carried: &[[f64; 2]],
    displacement: [f64; 3],
    given: &Given,
    solve: &mut Solve<'_>,
) -> Result<Advanced, ContactError> {
    let turn = displacement[2];
    let rigid = |d: [f64; 2]| -> Vec<[f64; 2]> {
        let carried = carried.iter().enumerate();
        let rigid = carried.map(|(k, carried)| {
            let (x, y) = (grid.x(k % grid.along), grid.y(k / grid.along));
            [d[0] - turn * y - carried[0], d[1] + turn * x - carried[1]]
        });
        rigid.collect()
    };
    let start = [displacement[0], displacement[1]];
    let Some((name, value)) =
        FORCES.into_iter().zip(given.force).find_map(|(name, force)| Some((name, force?)))
    else {
        let tractions = solve(&rigid(start), before, false);
        return Ok(Advanced { tractions, displacement });
    };
    let mut problem = Solved { grid, before, rigid, solve, sweeps: 0 };
    let found = displacement_for(&mut problem, given.force, start, given.limit, given.compliance);
    let Some(([x, y], mut tractions)) = found else {
        let allowed = "a creep force that the contact carries";
        return Err(ContactError::bad_value(name, value, allowed));
    };
    tractions.sweeps = problem.sweeps;
    Ok(Advanced { tractions, displacement: [x, y, turn] })
}

/// A substep as forces by displacements.
struct Solved<'a, R> {
    grid: &'a Grid,
    before: &'a [[f64; 2]],
    rigid: R,
    solve: &'a mut Solve<'a>,
    sweeps: usize,
}

impl<R: Fn([f64; 2]) -> Vec<[f64; 2]>> Forces for Solved<'_, R> {
    type Found = Tractions;

    fn at(&mut self, displacement: [f64; 2], near: Option<&Tractions>) -> (Tractions, [f64; 2]) {
        let start = near.map(|t| t.x.iter().zip(&t.y).map(|(x, y)| [*x, *y]).collect::<Vec<_>>());
        let start = start.as_deref().unwrap_or(self.before);
        let found = (self.solve)(&(self.rigid)(displacement), start, true);
        self.sweeps += found.sweeps;
        let area = self.grid.element_area();
        let force = [&found.x, &found.y].map(|p| p.iter().sum::<f64>() * area);
        (found, force)
    }
}
