//! From a normal problem to loaded zones, by the model that is asked for.

use super::problem::{NormalModel, NormalProblem};
use super::shape_correction::ShapeFit;
use super::strips::Strips;
use super::{boundary_element, hertz, piotrowski_kik};
use crate::geometry::contacts::separation::{FrameSeparation, Probe, Separation};
use crate::math::real::Real;

/// Fills the empty `strips` with the loaded zones of `problem` by `model`; `virtual_penetration` is
/// ε of Piotrowski and Kik, `shape_fit` the ratio that their corrected contact area gets.
///
/// `probes` bracket the zones: see [`Probe`]. Returns the number of zones that found no room, or 1
/// where a solution did not converge and the simpler model took its place.
pub fn solve(
    model: NormalModel,
    virtual_penetration: f64,
    shape_fit: ShapeFit,
    problem: &NormalProblem,
    separation: &mut impl Separation,
    probes: &[Probe],
    strips: &mut Strips,
) -> usize {
    if model != NormalModel::BoundaryElement {
        let epsilon = virtual_penetration;
        return solve_in_frame(model, epsilon, shape_fit, problem, separation, probes, strips);
    }
    boundary_element::solve(problem, problem.elements, separation, probes, strips).unwrap_or_else(
        || {
            let epsilon = virtual_penetration;
            1 + piotrowski_kik::solve(problem, epsilon, None, separation, probes, strips)
        },
    )
}

/// As [`solve`], with derivatives where the numbers have them, by Hertz or Piotrowski and Kik, to
/// whom the others fall back.
pub fn solve_in_frame<T: Real>(
    model: NormalModel,
    virtual_penetration: f64,
    shape_fit: ShapeFit,
    problem: &NormalProblem<T>,
    separation: &mut impl FrameSeparation<T>,
    probes: &[Probe],
    strips: &mut Strips<T>,
) -> usize {
    let shape = match model {
        NormalModel::Hertz => {
            hertz::solve(problem, separation, strips);
            return 0;
        }
        NormalModel::PiotrowskiKikCorrected => Some(shape_fit),
        NormalModel::PiotrowskiKik | NormalModel::Strips | NormalModel::BoundaryElement => None,
    };
    piotrowski_kik::solve(problem, virtual_penetration, shape, separation, probes, strips)
}
