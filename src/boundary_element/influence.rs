//! Influence of one loaded rectangular element on the displacements at the centres of all others.
//!
//! Half-spaces in contact, constant traction on the element, ρ² = x² + y² from the element's centre
//! to the point (Boussinesq and Cerruti; Johnson, Contact Mechanics, 1985, sections 3.2 and 3.6;
//! closed forms after Love 1929 and Kalker 1990). The displacement differences wheel minus rail are
//!
//! ```text
//! u_n = 1/(π E*) ∬ p_n/ρ
//! u_x = 1/(π G) ∬ [(1-ν)/ρ + ν x²/ρ³] p_x + [ν x y/ρ³] p_y      u_y likewise, x and y exchanged
//! ```
//!
//! with the combined constants of the two bodies. What normal pressure does to u_x and u_y (and
//! tractions to u_n) where the bodies are of unlike materials is in [`super::unlike`].
//!
//! Antiderivatives in x and y: x²/ρ³ from y asinh(x/|y|), y²/ρ³ from x asinh(y/|x|), 1/ρ from their
//! sum, x y/ρ³ from -ρ.

use std::f64::consts::PI;

use super::grid::Grid;
use crate::material::MaterialPair;

/// A quantity for every offset between two elements of a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Influence {
    along: usize,
    across: usize,
    /// Rows of offsets across, -(across - 1) first; in each the offsets along, -(along - 1) first.
    values: Vec<f64>,
}

impl Influence {
    /// Builds the table from `value(along, across)`.
    pub(super) fn new(grid: &Grid, value: impl Fn(isize, isize) -> f64) -> Self {
        let (along, across) = (grid.along as isize, grid.across as isize);
        let mut values = Vec::with_capacity(((2 * along - 1) * (2 * across - 1)) as usize);
        for j in 1 - across..across {
            values.extend((1 - along..along).map(|i| value(i, j)));
        }
        Self { along: grid.along, across: grid.across, values }
    }

    /// The value at an element `along` columns behind and `across` rows to the right of the loaded
    /// one.
    ///
    /// # Panics
    /// If no two elements of the grid are that far apart.
    pub fn at(&self, along: isize, across: isize) -> f64 {
        self.row(across)[(along + self.along as isize - 1) as usize]
    }

    /// The values at all offsets along, the farthest ahead first, in the row `across` rows to the
    /// right of the loaded element.
    ///
    /// # Panics
    /// If no two elements of the grid are that far apart.
    pub fn row(&self, across: isize) -> &[f64] {
        let length = 2 * self.along - 1;
        let first = (across + self.across as isize - 1) as usize * length;
        &self.values[first..first + length]
    }

    /// Columns and rows of the grid it belongs to.
    pub fn extent(&self) -> [usize; 2] {
        [self.along, self.across]
    }
}

/// Influence of tangential tractions.
#[derive(Clone, Debug, PartialEq)]
pub struct TangentialInfluence {
    /// On the x component of what p_x does.
    pub xx: Influence,
    /// On the x component of what p_y does, and the y component of what p_x does.
    pub xy: Influence,
    /// On the y component of what p_y does.
    pub yy: Influence,
}

impl TangentialInfluence {
    /// Displacements [m/Pa] between the elements of `grid` of bodies of `material`.
    pub fn displacement(grid: &Grid, material: &MaterialPair) -> Self {
        Self::combination(grid, material, &[(0, 1.0)])
    }

    /// Slip of steady rolling by elastic deformation, over the rolling speed [1/Pa]: -∂u/∂x for
    /// particles that come from ahead.
    ///
    /// Second-order difference over half elements, h = dx/2: (3 u(x) - 4 u(x + h) + u(x + 2 h))/(2
    /// h).
    pub fn rolling_slip(grid: &Grid, material: &MaterialPair) -> Self {
        let per_step = 2.0 / grid.dx;
        let weights = [(0, 1.5 * per_step), (1, -2.0 * per_step), (2, 0.5 * per_step)];
        Self::combination(grid, material, &weights)
    }

    /// Displacement and, over the distance `rolled`, slip of steady rolling [m/Pa]: what tractions
    /// add to the slip distance of a step at whose end, or with a negative distance at whose
    /// beginning, they act.
    pub fn displacement_and_slip(grid: &Grid, material: &MaterialPair, rolled: f64) -> Self {
        let per_step = 2.0 * rolled / grid.dx;
        let weights = [(0, 1.0 + 1.5 * per_step), (1, -2.0 * per_step), (2, 0.5 * per_step)];
        Self::combination(grid, material, &weights)
    }

    /// Sum of displacements at points a number of half elements ahead of the centres, each with its
    /// weight.
    fn combination(grid: &Grid, material: &MaterialPair, weights: &[(isize, f64)]) -> Self {
        let corners = Corners::new(grid);
        let scale = 1.0 / (PI * material.shear_modulus);
        let nu = material.poisson_ratio;
        let sum = |i: isize, of: &dyn Fn(isize) -> f64| {
            weights.iter().map(|&(ahead, weight)| weight * of(2 * i - ahead)).sum::<f64>()
        };
        let squared = |weight_x: f64, weight_y: f64| {
            let corners = &corners;
            Influence::new(grid, |i, j| {
                scale
                    * sum(i, &|halves| {
                        let [squared_x, squared_y] = corners.squared(halves, j);
                        weight_x * squared_x + weight_y * squared_y
                    })
            })
        };
        Self {
            xx: squared(1.0, 1.0 - nu),
            yy: squared(1.0 - nu, 1.0),
            xy: Influence::new(grid, |i, j| {
                scale * nu * sum(i, &|halves| corners.mixed(halves, j))
            }),
        }
    }
}

/// Influence of pressure on the approach of the two surfaces [m/Pa].
pub fn normal_influence(grid: &Grid, contact_modulus: f64) -> Influence {
    let corners = Corners::new(grid);
    let scale = 1.0 / (PI * contact_modulus);
    Influence::new(grid, |i, j| scale * corners.squared(2 * i, j).iter().sum::<f64>())
}

/// Antiderivatives at the corners of elements: corner (k, l) is k dx/2, (l + ½) dy from the centre
/// of the loaded one.
struct Corners {
    across: usize,
    /// Of x²/ρ³, of y²/ρ³, and ρ.
    values: Vec<[f64; 3]>,
}

impl Corners {
    /// For points up to two half elements ahead of the centres of `grid`.
    fn new(grid: &Grid) -> Self {
        let along = 2 * grid.along + 2;
        let mut values = Vec::with_capacity(along * grid.across);
        for k in 0..along {
            let x = k as f64 * 0.5 * grid.dx;
            for l in 0..grid.across {
                let y = (l as f64 + 0.5) * grid.dy;
                let rho = (x * x + y * y).sqrt();
                let of_y = if k == 0 { 0.0 } else { x * ((y + rho) / x).ln() };
                values.push([y * ((x + rho) / y).ln(), of_y, rho]);
            }
        }
        Self { across: grid.across, values }
    }

    fn at(&self, k: usize, l: usize) -> &[f64; 3] {
        &self.values[k * self.across + l]
    }

    /// ∬ x²/ρ³ and ∬ y²/ρ³ over an element, seen from `halves` half elements and j rows away. Both
    /// antiderivatives are odd in x and in y.
    fn squared(&self, halves: isize, j: isize) -> [f64; 2] {
        let (k, l) = (halves.unsigned_abs(), j.unsigned_abs());
        let (k0, sign_k) = if k == 0 { (1, -1.0) } else { (k - 1, 1.0) };
        let (l0, sign_l) = if l == 0 { (0, -1.0) } else { (l - 1, 1.0) };
        let corners = [self.at(k + 1, l), self.at(k0, l), self.at(k + 1, l0), self.at(k0, l0)];
        [0, 1].map(|c| {
            corners[0][c] - sign_k * corners[1][c] - sign_l * corners[2][c]
                + sign_k * sign_l * corners[3][c]
        })
    }

    /// ∬ x y/ρ³ over an element, seen from `halves` half elements behind and j rows to the right.
    fn mixed(&self, halves: isize, j: isize) -> f64 {
        if halves == 0 || j == 0 {
            return 0.0;
        }
        let (k, l) = (halves.unsigned_abs(), j.unsigned_abs());
        let rho = |k, l| self.at(k, l)[2];
        let value = rho(k - 1, l) + rho(k + 1, l - 1) - rho(k + 1, l) - rho(k - 1, l - 1);
        // Behind is negative x.
        if (halves > 0) == (j > 0) { -value } else { value }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::Material;
    use crate::math::quadrature::GaussLegendre;
    use approx::assert_relative_eq;

    const GRID: Grid = Grid { along: 6, across: 4, dx: 0.7, dy: 0.4, leading_x: 0.0, left_y: 0.0 };

    fn pair() -> MaterialPair {
        let steel = Material { young_modulus: 2.1, poisson_ratio: 0.28 };
        let soft = Material { young_modulus: 0.9, poisson_ratio: 0.4 };
        MaterialPair::new(steel, soft)
    }

    /// Integral over the element at the origin of `kernel(x, y)` from the loaded point to (x, y).
    fn integral(x: f64, y: f64, kernel: impl Fn(f64, f64) -> f64) -> f64 {
        let rule = GaussLegendre::new(20);
        let mut sum = 0.0;
        for (a, wa) in rule.nodes.iter().zip(&rule.weights) {
            for (b, wb) in rule.nodes.iter().zip(&rule.weights) {
                sum += wa * wb * kernel(x - 0.5 * GRID.dx * a, y - 0.5 * GRID.dy * b);
            }
        }
        0.25 * GRID.dx * GRID.dy * sum
    }

    /// Kernels of u_x by p_x, u_y by p_y and u_x by p_y.
    fn cerruti(x: f64, y: f64) -> [f64; 3] {
        let material = pair();
        let nu = material.poisson_ratio;
        let kernels: [fn(f64, f64) -> f64; 3] = [|x, _| x * x, |_, y| y * y, |x, y| x * y];
        let mut result =
            kernels.map(|kernel| nu * integral(x, y, |x, y| kernel(x, y) / x.hypot(y).powi(3)));
        let round = (1.0 - nu) * integral(x, y, |x, y| 1.0 / x.hypot(y));
        result[0] += round;
        result[1] += round;
        result.map(|value| value / (PI * material.shear_modulus))
    }

    #[test]
    fn closed_forms_are_the_integrals_of_boussinesq_and_cerruti() {
        let material = pair();
        let normal = normal_influence(&GRID, material.contact_modulus);
        let found = TangentialInfluence::displacement(&GRID, &material);
        for (i, j) in [(2, 0), (-5, 1), (1, 3), (-2, -3), (4, -2), (0, 2)] {
            let (x, y) = (-(i as f64) * GRID.dx, j as f64 * GRID.dy);
            let n = integral(x, y, |x, y| 1.0 / x.hypot(y)) / (PI * material.contact_modulus);
            assert_relative_eq!(normal.at(i, j), n, max_relative = 1e-10);
            let [xx, yy, xy] = cerruti(x, y);
            assert_relative_eq!(found.xx.at(i, j), xx, max_relative = 1e-10);
            assert_relative_eq!(found.yy.at(i, j), yy, max_relative = 1e-10);
            assert_relative_eq!(found.xy.at(i, j), xy, max_relative = 1e-9, epsilon = 1e-15);
        }
    }

    #[test]
    fn slip_is_the_difference_to_where_the_particle_came_from() {
        let slip = TangentialInfluence::rolling_slip(&GRID, &pair());
        for (i, j) in [(3, 1), (-4, -2), (2, -3), (-3, 0)] {
            let (x, y) = (-(i as f64) * GRID.dx, j as f64 * GRID.dy);
            let h = 0.5 * GRID.dx;
            let u = [0.0, h, 2.0 * h].map(|ahead| cerruti(x + ahead, y));
            let expected = [0, 1, 2].map(|c| (3.0 * u[0][c] - 4.0 * u[1][c] + u[2][c]) / (2.0 * h));
            let found = [slip.xx.at(i, j), slip.yy.at(i, j), slip.xy.at(i, j)];
            for (found, expected) in found.into_iter().zip(expected) {
                assert_relative_eq!(found, expected, max_relative = 1e-8, epsilon = 1e-12);
            }
        }
    }

    #[test]
    fn under_itself_a_square_gives_the_closed_form() {
        // Johnson (3.26): 1/ρ over a square of side 2a seen from its centre is 8 a ln(1 + sqrt 2).
        let grid = Grid { along: 1, across: 1, dx: 2.0, dy: 2.0, leading_x: 0.0, left_y: 0.0 };
        let own = normal_influence(&grid, 1.0).at(0, 0);
        assert_relative_eq!(own, 8.0 * (1.0 + 2f64.sqrt()).ln() / PI, max_relative = 1e-14);
    }
}
