//! Steady rolling of bodies of unlike materials: pressure and tractions act on each other.
//!
//! A pressure draws both surfaces towards it, the softer body's more, and a traction lifts one behind
//! itself and lowers it ahead (Johnson 1985, eqs 3.18 and 3.75; Kalker 1990, eq. 1.44). With ρ from
//! the loaded point, differences wheel minus rail and the gap growing
//!
//! ```text
//! u_x = -K/(π G) ∬ x/ρ² p_n      u_y = -K/(π G) ∬ y/ρ² p_n      u_n = K/(π G) ∬ (x p_x + y p_y)/ρ²
//! ```
//!
//! Pressure and tractions are found in turns, each with what the other one does (Panagiotopoulos 1975);
//! for like bodies K = 0, and there is nothing to take turns about.
//!
//! Antiderivative of x/ρ² in x and y: y ln ρ + x atan(y/x).

use std::f64::consts::PI;

use super::convolution::{Convolution, Spectrum};
use super::friction::{self, FrictionProblem, MAX_SWEEPS, Tractions};
use super::grid::Grid;
use super::influence::{Influence, TangentialInfluence};
use super::pressure::{self, PressureSolution, PressureSolver};
use super::rolling::steady_rolling;
use crate::material::MaterialPair;
use crate::math::root::bracketed;

/// How deep the bodies are pressed together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Press {
    /// Approach from a distance of 0 [m].
    Approach(f64),
    /// Normal force, > 0 [N], and about the approach at which it is there [m].
    Load(f64, f64),
}

/// A problem of steady rolling towards +x.
#[derive(Clone, Copy, Debug)]
pub struct UnlikeProblem<'a> {
    /// The elements, a few more on each side than the bodies touch on.
    pub grid: &'a Grid,
    /// The bodies.
    pub material: &'a MaterialPair,
    /// The same as tractions find them: softer in shear by what lies between them.
    pub shearing: &'a MaterialPair,
    /// Undeformed distance at the centres of the elements [m].
    pub separation: &'a [f64],
    /// Approach or load.
    pub press: Press,
    /// Coefficient of friction of each element, ≥ 0 [-].
    pub friction: &'a [f64],
    /// Rigid slip of each element over the rolling speed, wheel minus rail [-].
    pub rigid: &'a [[f64; 2]],
}

/// What a problem leads to.
#[derive(Clone, Debug)]
pub struct UnlikeSolution {
    /// Pressure and approach.
    pub pressure: PressureSolution,
    /// Tractions on the wheel, and slip.
    pub tractions: Tractions,
    /// Turns taken.
    pub turns: usize,
    /// Whether they came to an end, and with them pressure and tractions.
    pub converged: bool,
    /// Largest distance left between surfaces that carry pressure, or overlap left of others, over
    /// the approach [-].
    pub residual: f64,
}

impl UnlikeProblem<'_> {
    /// The solution for bodies that roll towards -x.
    pub fn backward(&self) -> UnlikeSolution {
        let grid = self.grid;
        let found = steady_rolling_unlike(&UnlikeProblem {
            separation: &grid.mirrored(self.separation),
            friction: &grid.mirrored(self.friction),
            rigid: &grid.mirrored_vectors(self.rigid),
            ..*self
        });
        let pressure = grid.mirrored(&found.pressure.pressure);
        UnlikeSolution {
            pressure: PressureSolution { pressure, ..found.pressure },
            tractions: found.tractions.mirrored(grid),
            ..found
        }
    }
}

/// Most turns.
const MAX_TURNS: usize = 40;
/// Change of the distance between the bodies in a turn, over the approach, that ends them: that which
/// pressures of like bodies leave.
const SETTLED: f64 = pressure::TOLERANCE;
/// Distance left in the contact over the approach, and change of tractions in a sweep over their sum,
/// in each turn: a tenth of those of like bodies, so that turns are not about them.
const TOLERANCES: [f64; 2] = [1e-6, 1e-5];
/// Width of the bracket of an approach, over the approach.
const APPROACH: f64 = 1e-10;

/// Solves a problem.
pub fn steady_rolling_unlike(problem: &UnlikeProblem<'_>) -> UnlikeSolution {
    let &UnlikeProblem { grid, material, shearing, separation, press, friction, rigid } = problem;
    let mut coupling = Coupling::new(grid, material);
    let solver = PressureSolver::new(*grid, material.contact_modulus);
    let mut solver = solver.with_tolerance(TOLERANCES[0]);
    let influence = TangentialInfluence::rolling_slip(grid, shearing);
    let mut distance = separation.to_vec();
    let mut pressure = pressed(&mut solver, grid, &distance, press, None);
    let mut tractions = None::<Tractions>;
    let mut turns = 0;
    loop {
        turns += 1;
        let bound: Vec<f64> = pressure.pressure.iter().zip(friction).map(|(p, f)| p * f).collect();
        let mut slip = coupling.slip(&pressure.pressure);
        for (slip, rigid) in slip.iter_mut().zip(rigid) {
            *slip = [slip[0] + rigid[0], slip[1] + rigid[1]];
        }
        let own = match tractions {
            None => steady_rolling(grid, shearing, &bound, &slip),
            Some(last) => {
                let start: Vec<[f64; 2]> =
                    last.x.iter().zip(&last.y).map(|(x, y)| [*x, *y]).collect();
                let problem = FrictionProblem {
                    grid,
                    influence: &influence,
                    bound: &bound,
                    rigid: &slip,
                    rolling: true,
                    tolerance: TOLERANCES[1],
                    max_sweeps: MAX_SWEEPS,
                };
                friction::solve(&problem, Some(&start))
            }
        };
        let lifted = coupling.lift([&own.x, &own.y]);
        let wanted: Vec<f64> =
            separation.iter().zip(lifted).map(|(given, lifted)| given + lifted).collect();
        let changes = wanted.iter().zip(&distance).map(|(wanted, now)| (wanted - now).abs());
        let change = changes.fold(0.0, f64::max);
        distance = wanted;
        let is_settled = change <= SETTLED * pressure.approach.abs();
        if is_settled || turns == MAX_TURNS {
            let are_found = pressure.converged && own.change <= friction::TOLERANCE;
            let converged = is_settled && are_found;
            let residual = left(&mut solver, &distance, &pressure);
            return UnlikeSolution { pressure, tractions: own, turns, converged, residual };
        }
        tractions = Some(own);
        pressure = pressed(&mut solver, grid, &distance, press, Some(&pressure));
    }
}

/// The pressure at the given approach or load, sought from the `last` one.
fn pressed(
    solver: &mut PressureSolver,
    grid: &Grid,
    distance: &[f64],
    press: Press,
    last: Option<&PressureSolution>,
) -> PressureSolution {
    let start = last.map(|last| &last.pressure[..]);
    let (load, about) = match press {
        Press::Approach(approach) => return solver.at_approach(distance, approach, start),
        Press::Load(load, about) => (load, last.map_or(about, |last| last.approach)),
    };
    let least = distance.iter().copied().fold(f64::INFINITY, f64::min);
    let mut found = None;
    let mut missing = |approach: f64| {
        let own = solver.at_approach(distance, approach, start);
        let carried = own.pressure.iter().sum::<f64>() * grid.element_area();
        found = Some(own);
        // The power 2/3 of the load is nearly straight.
        (carried / load).powf(2.0 / 3.0) - 1.0
    };
    let mut high = about;
    let mut beyond = missing(high);
    let mut low = (least, -1.0);
    while beyond < 0.0 {
        low = (high, beyond);
        high += 0.1 * (high - least);
        beyond = missing(high);
    }
    let approach = bracketed(low, (high, beyond), APPROACH * (high - least), &mut missing);
    missing(approach);
    found.unwrap_or_else(|| solver.at_approach(distance, approach, start))
}

/// Largest distance left where `pressure` acts, or overlap left elsewhere, over the approach.
fn left(solver: &mut PressureSolver, distance: &[f64], pressure: &PressureSolution) -> f64 {
    let PressureSolution { pressure, approach, .. } = pressure;
    let mut displacement = vec![0.0; pressure.len()];
    solver.displace(pressure, &mut displacement);
    let left = pressure.iter().zip(distance).zip(displacement).map(|((p, distance), pressed)| {
        let overlap = approach - distance - pressed;
        if *p > 0.0 { overlap.abs() } else { overlap.max(0.0) }
    });
    let most = left.fold(0.0, f64::max);
    if *approach == 0.0 { 0.0 } else { most / approach.abs() }
}

/// What pressure and tractions do to each other.
struct Coupling {
    convolution: Convolution,
    /// On the gap, what p_x and p_y do.
    lift: [Spectrum; 2],
    /// On slip over the rolling speed along x and y, what pressure does.
    slip: [Spectrum; 2],
}

impl Coupling {
    fn new(grid: &Grid, material: &MaterialPair) -> Self {
        let scale = material.coupling / (PI * material.shear_modulus);
        let per_step = 2.0 / grid.dx;
        // -∂/∂x as in steady rolling.
        let slope = [(0, 1.5 * per_step), (1, -2.0 * per_step), (2, 0.5 * per_step)];
        let mut convolution = Convolution::new(grid.along, grid.across);
        let mut spectrum = |axis: usize, scale: f64, weights: &[(isize, f64)]| {
            let influence = Influence::new(grid, |i, j| {
                let parts = weights.iter().map(|&(ahead, weight)| {
                    let place = [-0.5 * grid.dx * (2 * i - ahead) as f64, grid.dy * j as f64];
                    weight * drawn(place, [grid.dx, grid.dy], axis)
                });
                scale * parts.sum::<f64>()
            });
            convolution.spectrum_of(&influence)
        };
        let lift = [0, 1].map(|axis| spectrum(axis, scale, &[(0, 1.0)]));
        let slip = [0, 1].map(|axis| spectrum(axis, -scale, &slope));
        Self { convolution, lift, slip }
    }

    /// Slip by the displacement under `pressure`, over the rolling speed [-].
    fn slip(&mut self, pressure: &[f64]) -> Vec<[f64; 2]> {
        let parts = [0, 1].map(|axis| {
            let mut part = vec![0.0; pressure.len()];
            self.convolution.apply(&self.slip[axis], pressure, &mut part);
            part
        });
        parts[0].iter().zip(&parts[1]).map(|(x, y)| [*x, *y]).collect()
    }

    /// What tractions add to the gap [m].
    fn lift(&mut self, tractions: [&[f64]; 2]) -> Vec<f64> {
        let mut sum = vec![0.0; tractions[0].len()];
        let mut part = sum.clone();
        for (spectrum, traction) in self.lift.iter().zip(tractions) {
            self.convolution.apply(spectrum, traction, &mut part);
            sum.iter_mut().zip(&part).for_each(|(sum, part)| *sum += part);
        }
        sum
    }
}

/// ∬ x/ρ² (`axis` 0) or ∬ y/ρ² (1) over an element of these `sides` at the origin, from the loaded
/// point to `place`.
fn drawn(place: [f64; 2], sides: [f64; 2], axis: usize) -> f64 {
    let primitive = |x: f64, y: f64| {
        let (x, y) = if axis == 0 { (x, y) } else { (y, x) };
        let turned = if x == 0.0 { 0.0 } else { x * (y / x).atan() };
        // y ln ρ → 0 on the corner of the element itself.
        let square = x * x + y * y;
        turned + if square > 0.0 { 0.5 * y * square.ln() } else { 0.0 }
    };
    let at = |k: f64, l: f64| primitive(place[0] + k * sides[0], place[1] + l * sides[1]);
    at(0.5, 0.5) - at(-0.5, 0.5) - at(0.5, -0.5) + at(-0.5, -0.5)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::Material;
    use crate::math::quadrature::GaussLegendre;
    use approx::assert_relative_eq;

    #[test]
    fn the_closed_form_is_the_integral() {
        let rule = GaussLegendre::new(24);
        let sides = [0.7, 0.4];
        for place in [[1.3, 0.2], [-0.9, 0.5], [0.4, -0.8], [0.0, 1.1], [2.0, 0.0]] {
            for axis in 0..2 {
                let mut sum = 0.0;
                for (a, wa) in rule.nodes.iter().zip(&rule.weights) {
                    for (b, wb) in rule.nodes.iter().zip(&rule.weights) {
                        let x = [place[0] - 0.5 * sides[0] * a, place[1] - 0.5 * sides[1] * b];
                        sum += wa * wb * x[axis] / (x[0] * x[0] + x[1] * x[1]);
                    }
                }
                let expected = 0.25 * sides[0] * sides[1] * sum;
                let found = drawn(place, sides, axis);
                assert_relative_eq!(found, expected, max_relative = 1e-8, epsilon = 1e-12);
            }
        }
        assert_relative_eq!(drawn([0.0; 2], sides, 0), 0.0, epsilon = 1e-15);
    }

    /// CONTACT's example of two rollers, aluminium on steel (Bentall and Johnson 1967), its version of
    /// July 2025: half width 0.1 mm, 200 elements over it, 1 m across; mm, N, MPa.
    fn rollers(friction: f64, creepage: f64) -> (Grid, UnlikeSolution) {
        let body = |shear: f64, poisson_ratio: f64| Material {
            young_modulus: 2.0 * shear * (1.0 + poisson_ratio),
            poisson_ratio,
        };
        let material = MaterialPair::new(body(23_000.0, 0.31), body(82_000.0, 0.28));
        assert!((material.coupling - 0.1002).abs() < 5e-5, "{}", material.coupling);
        let grid = Grid::over([-0.108, 0.108], [-500.0, 500.0], 216, 1);
        let separation = grid.sample(|x, _| 0.02 * x * x);
        let solution = steady_rolling_unlike(&UnlikeProblem {
            grid: &grid,
            material: &material,
            shearing: &material,
            separation: &separation,
            press: Press::Load(16_201.9, 2.08e-3),
            friction: &vec![friction; grid.len()],
            rigid: &vec![[creepage, 0.0]; grid.len()],
        });
        (grid, solution)
    }

    /// Creepage at which the tractions carry `share` of the friction limit, the solution there and the
    /// greatest pressure.
    fn creepage_for(friction: f64, share: f64) -> (f64, UnlikeSolution) {
        let carried = |creepage: f64| {
            let (grid, own) = rollers(friction, creepage);
            assert!(own.converged, "{creepage}: {} turns", own.turns);
            own.tractions.x.iter().sum::<f64>() * grid.element_area() / (friction * 16_201.9)
                - share
        };
        let ends = [-1e-3, 1e-3].map(|creepage| (creepage, carried(creepage)));
        let creepage = bracketed(ends[0], ends[1], 1e-8, carried);
        (creepage, rollers(friction, creepage).1)
    }

    #[test]
    fn turns_come_to_an_end() {
        for friction in [0.05, 0.1] {
            for creepage in [-1e-3, -4e-4, 0.0, 1e-3] {
                let (_, own) = rollers(friction, creepage);
                assert!(own.converged, "{friction} {creepage}: {} turns", own.turns);
            }
        }
    }

    #[test]
    fn rollers_of_aluminium_and_steel_roll_as_contact_says() {
        // Friction, force over the limit, creepage, greatest pressure. CONTACT rolls towards -x, which
        // turns the sign of creepages and forces.
        for (friction, share, creepage, pressure) in [
            (1e-4, 0.0, 5.260e-4, 103.1),
            (0.05, 0.0, 4.294e-4, 103.6),
            (0.05, 0.75, 2.108e-4, 103.2),
            (0.05, -0.75, 5.392e-4, 103.3),
        ] {
            let (found, own) = creepage_for(friction, -share);
            let greatest = own.pressure.pressure.iter().copied().fold(0.0, f64::max);
            // A hundredth of the creepage of free rolling, and the last digit.
            assert!((found + creepage).abs() < 5.3e-6, "{friction} {share}: {found} {creepage}");
            assert!((greatest - pressure).abs() < 0.1, "{greatest} {pressure}");
        }
    }
}
