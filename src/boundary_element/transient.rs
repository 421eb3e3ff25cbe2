//! One step of contact with memory: bodies that are shifted against each other, roll, or both.
//!
//! Particles that are at x after a step over the distance q slip against each other by (Kalker
//! 1990, section 4.2.1)
//!
//! ```text
//! S(x) = w + u(x) - u'(x + q)        w: rigid displacement of the step [m]
//! ```
//!
//! with u the difference of displacement now and u' that before, and the friction law is that of
//! [`super::rolling`] with S. Where particles were is not looked up. What carries them through the
//! contact is the operator D of steady rolling, which stands for -∂/∂x there, taken between the
//! beginning and the end of the step:
//!
//! ```text
//! S = w + u - u' + q D (θ u + (1 - θ) u')        θ = max(1/2, 1 - dx/(2 q))
//! ```
//!
//! - q = 0 is a shift: S = w + u - u'.
//! - The state that a step of any length leaves as it is, u = u', meets w/q + D u = S/q, which is
//!   steady rolling with the operator that it has everywhere else.
//! - For q far beyond the length of the contact, S/q = w/q + D u: steady rolling at once. Nothing is
//!   left of the history.
//! - Up to an element a step, θ is ½ and the error of second order in q, as D is in dx. Smaller
//!   steps need no rule for what enters: D always reaches half an element and an element ahead.
//!
//! Backward rolling, q < 0, is the mirror image along x of rolling forward over -q.
//!
//! u' is that of all surface, so that particles that come into contact bring with them what the
//! tractions beside them did before.

use super::convolution::{Convolution, Spectrum};
use super::friction::{self, FrictionProblem, Tractions};
use super::grid::Grid;
use super::influence::TangentialInfluence;
use crate::material::MaterialPair;

/// Change in a sweep, over the sum of the tractions, at which those of a step are accepted [-]:
/// what steps leave out adds up.
pub const TOLERANCE: f64 = 1e-9;

/// Sweeps after which the search ends: 20 to 100 are usual.
const MAX_SWEEPS: usize = 2000;

/// Elements a step beyond which tractions are sought as in steady rolling, with those that particles
/// carry behind them [-].
const CARRIED: f64 = 2.0;

/// Steps of one length on one grid.
pub struct TransientStep {
    grid: Grid,
    rolled: f64,
    backward: bool,
    /// What tractions at the end add to the slip distance.
    own: TangentialInfluence,
}

impl TransientStep {
    /// Over the distance `rolled` [m] towards +x.
    pub fn new(grid: &Grid, material: &MaterialPair, rolled: f64) -> Self {
        let (backward, rolled) = (rolled < 0.0, rolled.abs());
        let own =
            TangentialInfluence::displacement_and_slip(grid, material, late(grid, rolled) * rolled);
        Self { grid: *grid, rolled, backward, own }
    }

    /// Tractions at the end, and the slip distance of the step [m].
    ///
    /// `bound` is μ p_n of each element [Pa], `rigid` its rigid displacement in the step, wheel
    /// against rail, less what [`Memory::carried`] says [m]; `start` are tractions to begin with.
    pub fn solve(&self, bound: &[f64], rigid: &[[f64; 2]], start: &[[f64; 2]]) -> Tractions {
        if !self.backward {
            return self.solve_forward(bound, rigid, start);
        }
        let grid = &self.grid;
        let (rigid, start) = (grid.mirrored_vectors(rigid), grid.mirrored_vectors(start));
        self.solve_forward(&grid.mirrored(bound), &rigid, &start).mirrored(grid)
    }

    fn solve_forward(&self, bound: &[f64], rigid: &[[f64; 2]], start: &[[f64; 2]]) -> Tractions {
        let problem = FrictionProblem {
            grid: &self.grid,
            influence: &self.own,
            bound,
            rigid,
            rolling: self.rolled > CARRIED * self.grid.dx,
            tolerance: TOLERANCE,
            max_sweeps: MAX_SWEEPS,
        };
        friction::solve(&problem, Some(start))
    }
}

/// What the tractions before a step take off its slip.
pub struct Memory {
    grid: Grid,
    backward: bool,
    convolution: Convolution,
    /// Of xx, xy and yy.
    spectra: [Spectrum; 3],
}

impl Memory {
    /// For steps over the distance `rolled` [m] on `grid`.
    pub fn new(grid: &Grid, material: &MaterialPair, rolled: f64) -> Self {
        let (backward, rolled) = (rolled < 0.0, rolled.abs());
        let early = late(grid, rolled) - 1.0;
        let old = TangentialInfluence::displacement_and_slip(grid, material, early * rolled);
        let mut convolution = Convolution::new(grid.along, grid.across);
        let spectra = [&old.xx, &old.xy, &old.yy].map(|part| convolution.spectrum_of(part));
        Self { grid: *grid, backward, convolution, spectra }
    }

    /// u' - q (1 - θ) D u' of each element under its tractions `before` [m].
    pub fn carried(&mut self, before: &[[f64; 2]]) -> Vec<[f64; 2]> {
        if !self.backward {
            return self.carried_forward(before);
        }
        let seen = self.carried_forward(&self.grid.mirrored_vectors(before));
        self.grid.mirrored_vectors(&seen)
    }

    fn carried_forward(&mut self, before: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let mut sum = vec![[0.0; 2]; before.len()];
        if before.iter().flatten().all(|&p| p == 0.0) {
            return sum;
        }
        let [xx, xy, yy] = &self.spectra;
        let [x, y] = [0, 1].map(|c| before.iter().map(|p| p[c]).collect::<Vec<f64>>());
        let mut part = vec![0.0; before.len()];
        for (spectrum, tractions, c) in [(xx, &x, 0), (xy, &y, 0), (xy, &x, 1), (yy, &y, 1)] {
            self.convolution.apply(spectrum, tractions, &mut part);
            for (sum, part) in sum.iter_mut().zip(&part) {
                sum[c] += part;
            }
        }
        sum
    }
}

/// θ: the share of the end of a step in what carries particles.
fn late(grid: &Grid, rolled: f64) -> f64 {
    if rolled > grid.dx { 1.0 - 0.5 * grid.dx / rolled } else { 0.5 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::boundary_element::rolling::steady_rolling_within;
    use crate::material::Material;
    use approx::assert_relative_eq;

    /// Half width 1 mm of steel cylinders, 0.1 m long, on one row of elements: R = 500 mm, μ = 0.3.
    struct Cylinders {
        grid: Grid,
        material: MaterialPair,
        bound: Vec<f64>,
        limit: f64,
    }

    /// Creepage at which the stick area is 0.6 mm wide on each side and the force 0.64 μ N.
    const CREEPAGE: f64 = -0.00024;

    impl Cylinders {
        fn new(along: usize) -> Self {
            let steel = Material { young_modulus: 2.0 * 1.28 * 82e9, poisson_ratio: 0.28 };
            let material = MaterialPair::new(steel, steel);
            let grid = Grid::over([-1e-3, 1e-3], [-0.05, 0.05], along, 1);
            let greatest = 0.3 * 0.5 * material.contact_modulus * 1e-3 / 0.5;
            // Mean over the element.
            let integral = |x: f64| {
                let t = (x / 1e-3).clamp(-1.0, 1.0);
                0.5 * (t * (1.0 - t * t).sqrt() + t.asin()) * 1e-3
            };
            let half = 0.5 * grid.dx;
            let bound =
                grid.sample(|x, _| greatest * (integral(x + half) - integral(x - half)) / grid.dx);
            let limit = bound.iter().sum::<f64>() * grid.element_area();
            Self { grid, material, bound, limit }
        }

        fn force(&self, tractions: &[[f64; 2]]) -> f64 {
            tractions.iter().map(|p| p[0]).sum::<f64>() * self.grid.element_area() / self.limit
        }

        /// Tractions after `steps` from rest.
        fn rolled(&self, step: f64, steps: usize) -> Vec<[f64; 2]> {
            let operator = TransientStep::new(&self.grid, &self.material, step);
            let mut memory = Memory::new(&self.grid, &self.material, step);
            let mut before = vec![[0.0; 2]; self.grid.len()];
            for _ in 0..steps {
                let carried = memory.carried(&before);
                let rigid: Vec<_> =
                    carried.iter().map(|u| [step * CREEPAGE - u[0], -u[1]]).collect();
                let found = operator.solve(&self.bound, &rigid, &before);
                assert!(found.converged);
                before = found.x.iter().zip(&found.y).map(|(x, y)| [*x, *y]).collect();
            }
            before
        }
    }

    #[test]
    fn from_rest_force_grows_to_carters() {
        let cylinders = Cylinders::new(40);
        let dx = cylinders.grid.dx;
        let mut last = 0.0;
        for steps in [1, 2, 5, 10, 20, 40, 80, 160] {
            let force = cylinders.force(&cylinders.rolled(dx, steps));
            assert!(force > last, "{steps} steps: {force} after {last}");
            last = force;
        }
        let rigid = vec![[CREEPAGE, 0.0]; 40];
        let Cylinders { grid, material, bound, .. } = &cylinders;
        let steady = steady_rolling_within(1e-10, grid, material, bound, &rigid);
        for (step, steps) in [(dx, 1400), (0.3 * dx, 4700), (3.0 * dx, 500)] {
            let found = cylinders.rolled(step, steps);
            for (k, p) in found.iter().enumerate() {
                let greatest = bound[20];
                let error = (p[0] - steady.x[k]) / greatest;
                assert!(error.abs() < 1e-6, "{step}, element {k}: {error:e}");
            }
            let expected = steady.x.iter().map(|&p| [p, 0.0]).collect::<Vec<_>>();
            let (found, expected) = (cylinders.force(&found), cylinders.force(&expected));
            assert_relative_eq!(found, expected, epsilon = 1e-6);
        }
        let steady_force = steady.x.iter().sum::<f64>() * grid.element_area() / cylinders.limit;
        assert_relative_eq!(steady_force, 0.64, epsilon = 0.0064);
        let sticks = (0..40).filter(|&k| steady.x[k] < 0.999_999 * bound[k]).count();
        assert_relative_eq!(sticks as f64 * dx, 1.2e-3, epsilon = dx);
    }

    #[test]
    fn errors_fall_with_the_step_and_vanish_at_an_element_a_step() {
        let cylinders = Cylinders::new(40);
        let dx = cylinders.grid.dx;
        let force =
            |parts: usize| cylinders.force(&cylinders.rolled(32.0 * dx / parts as f64, parts));
        let limit = force(512);
        let errors = [2, 4, 8, 16, 32, 64].map(|parts| (force(parts) - limit).abs());
        // From 16 elements a step down to half of one.
        assert!(errors[0] < 0.015, "{errors:?}");
        for pair in errors.windows(2) {
            assert!(pair[1] < 0.6 * pair[0], "{errors:?}");
        }
        assert!(errors[4] < 2e-5, "{errors:?}");
    }

    #[test]
    fn a_step_over_nothing_changes_nothing() {
        let cylinders = Cylinders::new(20);
        let dx = cylinders.grid.dx;
        let before = cylinders.rolled(dx, 12);
        for step in [0.0, 1e-12 * dx, 1e-6 * dx] {
            let carried = Memory::new(&cylinders.grid, &cylinders.material, step).carried(&before);
            let rigid: Vec<_> = carried.iter().map(|u| [step * CREEPAGE - u[0], -u[1]]).collect();
            let operator = TransientStep::new(&cylinders.grid, &cylinders.material, step);
            let found = operator.solve(&cylinders.bound, &rigid, &before);
            for (k, p) in before.iter().enumerate() {
                assert!((found.x[k] - p[0]).abs() < 2e-6 * cylinders.bound[10], "{step} {k}");
            }
        }
    }

    /// Bounds, ways either way, displacements and the elements in contact change at random. The slip
    /// is that of the displacements, whatever a step reports as work.
    #[test]
    fn friction_takes_energy_on_each_element_in_each_step() {
        let steel = Material { young_modulus: 2.1e11, poisson_ratio: 0.28 };
        let material = MaterialPair::new(steel, steel);
        let grid = Grid::over([-2e-3, 2.5e-3], [-1.5e-3, 1.5e-3], 9, 6);
        let mut state = 54_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let mut displaced = Memory::new(&grid, &material, 0.0);
        let mut before = vec![[0.0; 2]; grid.len()];
        let (mut slipped, mut stuck, mut worst, mut least) = (0, 0, 0.0_f64, 0.0_f64);
        for step in 0..240 {
            let way = [0.0, 1e-7, 0.3, 1.0, 3.0, 100.0][step % 6] * grid.dx;
            let way = if step % 4 == 3 { -way } else { way };
            let bound: Vec<f64> =
                (0..grid.len()).map(|_| 4e8 * (random() - 0.3).max(0.0)).collect();
            let [x, y, turn] = [0; 3].map(|_| 2e-5 * (random() - 0.5));
            let own: Vec<[f64; 2]> = (0..grid.len())
                .map(|k| {
                    let [along, across] =
                        [grid.x(k % grid.along), grid.y(k / grid.along)].map(|c| 1e3 * turn * c);
                    [x - across, y + along]
                })
                .collect();
            let carried = Memory::new(&grid, &material, way).carried(&before);
            let rigid: Vec<[f64; 2]> =
                own.iter().zip(&carried).map(|(w, u)| [w[0] - u[0], w[1] - u[1]]).collect();
            let found = TransientStep::new(&grid, &material, way).solve(&bound, &rigid, &before);
            assert!(found.converged, "step {step}");
            let largest = rigid.iter().map(|w| w[0].hypot(w[1])).fold(0.0, f64::max);
            let p: Vec<[f64; 2]> = found.x.iter().zip(&found.y).map(|(x, y)| [*x, *y]).collect();
            let now = displaced.carried(&p);
            let earlier = displaced.carried(&before);
            for k in 0..grid.len() {
                let s = [found.slip_x[k], found.slip_y[k]];
                let size = p[k][0].hypot(p[k][1]);
                assert!(size <= bound[k] * (1.0 + 1e-9), "step {step}, element {k}");
                if bound[k] <= 0.0 {
                    continue;
                }
                let length = s[0].hypot(s[1]) / largest;
                if found.slips[k] {
                    // Against the traction, of the size of the bound.
                    let power = (p[k][0] * s[0] + p[k][1] * s[1]) / (bound[k] * largest);
                    (worst, slipped) = (worst.max(power + length), slipped + 1);
                    least = least.min(power);
                } else {
                    (worst, stuck) = (worst.max(length), stuck + 1);
                }
                if way.abs() <= 0.0 {
                    // Of a shift by the displacements themselves.
                    for c in 0..2 {
                        let shift = own[k][c] + now[k][c] - earlier[k][c];
                        assert!((s[c] - shift).abs() <= 1e-9 * largest, "step {step}, element {k}");
                    }
                }
            }
            before = p;
        }
        println!("{slipped} slip, {stuck} adhere, off by {worst:e} of the displacement");
        assert!(slipped > 1000 && stuck > 1000 && least < -0.1, "{slipped} {stuck} {least}");
        assert!(worst <= 1e-7, "{worst:e}");
    }
}
