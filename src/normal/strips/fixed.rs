//! Strips that stay where they are: what takes over where the edges of the lobes are not found.
//!
//! Every interval of overlap is cut into strips of equal width, each with even pressure across. The conditions are those of the lobes, a
//! strip with no pressure left being free to lie apart:
//!
//! ```text
//! q_i ≥ 0,  u_i ≥ overlap_i,  one of them equal         u_i = Σ_j q_j a_j cos_ij [Ψ((Δy_ij + h/2)/a_j) - Ψ((Δy_ij - h/2)/a_j)]
//! ```
//!
//! No edge is looked for and no set of lobes chosen, so that there is nothing that could cycle but single strips. Then the strips are laid anew, twice,
//! finer towards the ends of the load, and lobes are begun with what they show. Where these have no solution either the strips are the result: their load
//! is 0.02 % off that of lobes in the median, up to 2.5 % on slender flanges, where κ has not settled after so many rounds.

use std::f64::consts::PI;

use super::Line;
use super::cell::{self, TERMS};
use super::influence::{STATION, shifted_at, shifted_fall, skewed, straight};
use super::rule::legendre;
use super::solver::{LEAST_SHARE, STARTS, StripSolver};
use crate::geometry::separation::Probe;
use crate::math::linear_system;
use crate::normal::Strips;

/// How often the strips are laid: evenly at first, then finer towards the ends of the load as found before.
const LAYOUTS: usize = 3;
/// Rounds of pressures and shape; steps of the pressures in the first and in the later ones.
const ROUNDS: usize = 16;
const FIRST_STEPS: usize = 25;
const LATER_STEPS: usize = 1;
/// Least half length over the width of a strip: what has less is about to be unloaded.
const LEAST_LENGTH: f64 = 0.25;
/// Share by which the shape follows the fall along x: its even part answers with a power of 1 (wide patches) to 2 (long ones), the
/// next ones with up to 3.
const FOLLOWING: f64 = 0.35;
/// It follows less when the last change is no smaller than this share of the one before.
const SLOW: f64 = 0.95;
const SLOWER: f64 = 0.7;
/// Change of a pressure over the greatest, and of a shape, at which rounds end.
const SETTLED: f64 = 1e-7;
const SETTLED_SHAPE: f64 = 1e-3;

impl StripSolver {
    /// Fills `strips` with zones of strips that stay where they are, as [`solve`](Self::solve) does with lobes.
    pub(super) fn solve_fixed(
        &mut self,
        line: &mut impl Line,
        (probes, level): (&[Probe], f64),
        contact_modulus: f64,
        strips: &mut Strips,
    ) -> bool {
        cell::fill(probes, level, LEAST_SHARE, &mut self.cells);
        self.begin(line, (probes, level), STARTS[0]);
        for i in 0..self.cells.len() {
            if !self.cells[i].active {
                let depth = self.cells[i].deepest[1];
                self.start_lobe(line, (probes, level), i, depth);
            }
        }
        self.lay_strips(line, probes, level);
        if self.nodes.y.is_empty() || !self.fit_strips(ROUNDS / 2) {
            return false;
        }
        for layout in 1..LAYOUTS {
            self.lay_strips_anew(line);
            if !self.fit_strips(if layout + 1 < LAYOUTS { ROUNDS / 2 } else { ROUNDS }) {
                return false;
            }
        }
        self.emit_fixed(contact_modulus, strips);
        strips.load() > 0.0 && strips.load().is_finite()
    }

    /// Finds the pressures and shapes of the strips that are laid; false where there are none.
    fn fit_strips(&mut self, rounds: usize) -> bool {
        let (mut following, mut before) = (FOLLOWING, f64::INFINITY);
        for round in 0..rounds {
            let steps = if round == 0 { FIRST_STEPS } else { LATER_STEPS };
            let change = self.fit_pressures(steps);
            if !change.is_finite() {
                return false;
            }
            let moved = self.follow_fall(following);
            if moved < SETTLED_SHAPE {
                break;
            }
            if moved > SLOW * before {
                following *= SLOWER;
            }
            before = moved;
        }
        true
    }

    /// Half lengths for the present pressures and shapes.
    pub(super) fn lengths(&mut self) {
        for i in 0..self.nodes.y.len() {
            let cell = &self.cells[self.nodes.lobe[i]];
            let polynomials = legendre(self.abscissa(i));
            let exponent: f64 = cell.shape.iter().zip(polynomials).map(|(s, p)| s * p).sum();
            let nodes = &mut self.nodes;
            // One over κ.
            nodes.edge_shape[i] = 2.0 * PI * nodes.radius[i] * (-exponent).exp();
            nodes.half_length[i] =
                (nodes.pressure[i] * nodes.edge_shape[i]).max(LEAST_LENGTH * nodes.width[i]);
        }
    }

    /// Place of strip `i` between the ends of the lobe with which its cell began, -1 to 1.
    fn abscissa(&self, i: usize) -> f64 {
        let [left, right] = self.cells[self.nodes.lobe[i]].edges;
        ((2.0 * self.nodes.y[i] - left - right) / (right - left)).clamp(-1.0, 1.0)
    }

    /// Influences of strip columns on row `i`: displacement by unit pressure, its derivative, and its fall to the stations.
    fn row(&mut self, i: usize) {
        let nodes = &self.nodes;
        let count = nodes.y.len();
        let m = &mut self.matrices;
        let (d, slope) = (&mut m.d[..count], &mut m.slope[..count]);
        let own_d = &mut m.straight_d[..count];
        let own_slope = &mut m.straight_slope[..count];
        let at = [nodes.x[i], nodes.y[i]];
        skewed(at, &nodes.x, &nodes.y, &nodes.half_length, d, slope);
        straight(at[1], &nodes.y, &nodes.half_length, own_d, own_slope);
        for j in 0..count {
            let (a, h) = (nodes.half_length[j], 0.5 * nodes.width[j]);
            let distance = (nodes.y[j] - at[1]).abs();
            let [far, far_fall] = self.integrals.at((distance + h) / a);
            let [near, near_fall] = self.integrals.at((distance - h).abs() / a);
            let side = if distance < h { -1.0 } else { 1.0 };
            let (outer, inner) = ((distance + h) / a, (distance - h).abs() / a);
            // Strips shifted along x.
            let ratio = if i == j { 1.0 } else { d[j] / own_d[j] };
            let [t, s] = [nodes.tangent[i], nodes.tangent[j]];
            let cosine = (t[0] * s[0] + t[1] * s[1]).max(0.0) * ratio;
            let psi = a * (far[0] - side * near[0]);
            let held = nodes.pressure[j] * nodes.edge_shape[j] <= a * (1.0 - 1e-12);
            let turn = if held { 0.0 } else { a * (outer * far[1] - side * inner * near[1]) - psi };
            d[j] = cosine * psi;
            slope[j] = cosine * (psi - turn);
            // How much the displacement falls along the strip of the row.
            let fall = if i == j {
                a * (far_fall[0] - side * near_fall[0])
            } else {
                let (xi, sigma) = ((nodes.x[j] - at[0]) / a, (nodes.y[j] - at[1]) / a);
                let centre = shifted_at(xi, sigma);
                let station = STATION * nodes.half_length[i] / a;
                psi * shifted_fall(&centre, station, xi, sigma).d / centre.d
            };
            own_d[j] = cosine * fall;
        }
    }

    /// Newton's method for the pressures with the shapes held, and the fall before its last step over that of the wheel; the last change over the
    /// greatest pressure.
    fn fit_pressures(&mut self, most_steps: usize) -> f64 {
        let count = self.nodes.y.len();
        let mut change = f64::INFINITY;
        for _ in 0..most_steps {
            let greatest = self.nodes.pressure.iter().fold(0.0, |a: f64, &b| a.max(b));
            // Strips have no width where an overlap has none, centimetres inside a rail.
            let is_laid = self.nodes.half_length.iter().all(|a| a.is_finite() && *a > 0.0);
            if !is_laid || greatest.is_nan() || greatest <= 0.0 {
                return f64::NAN;
            }
            // Rows of loaded strips, and of those that overlap more than they are displaced.
            let mut rows = 0;
            self.nodes.spare.clear();
            self.nodes.spare.resize(count, -1.0);
            for i in 0..count {
                self.row(i);
                let m = &mut self.matrices;
                let q = &self.nodes.pressure;
                let u: f64 = m.d[..count].iter().zip(q).map(|(d, q)| d * q).sum();
                let error = self.nodes.overlap[i] - u;
                let fall: f64 = m.straight_d[..count].iter().zip(q).map(|(c, q)| c * q).sum();
                let distance = STATION * self.nodes.half_length[i];
                self.nodes.ratio[i] = fall * 2.0 * self.nodes.radius[i] / (distance * distance);
                if q[i] > 0.0 || error > 0.0 {
                    self.nodes.spare[i] = rows as f64;
                    m.right[rows] = error;
                    m.newton[rows * count..(rows + 1) * count].copy_from_slice(&m.slope[..count]);
                    rows += 1;
                }
            }
            // Columns of the same strips, moved together.
            let m = &mut self.matrices;
            for row in 0..rows {
                let mut column = 0;
                for j in 0..count {
                    if self.nodes.spare[j] >= 0.0 {
                        m.newton[row * count + column] = m.newton[row * count + j];
                        column += 1;
                    }
                }
            }
            if !linear_system::solve(&mut m.newton, count, &mut m.right[..rows]) {
                return f64::NAN;
            }
            change = 0.0;
            for i in 0..count {
                let row = self.nodes.spare[i];
                if row < 0.0 {
                    continue;
                }
                let q = self.nodes.pressure[i];
                let next = (q + m.right[row as usize])
                    .clamp(0.3 * q - 1e-3 * greatest, 2.0 * q + 0.2 * greatest);
                let next = next.max(0.0);
                change = change.max((next - q).abs() / greatest);
                self.nodes.pressure[i] = next;
            }
            self.lengths();
            if change < SETTLED {
                break;
            }
        }
        change
    }

    /// Lets the shapes follow the fall of the displacement along x; the greatest change.
    fn follow_fall(&mut self, following: f64) -> f64 {
        let count = self.nodes.y.len();
        let mut moved: f64 = 0.0;
        // Load-weighted least squares of the logarithm of the fall over that of the wheel.
        for cell in 0..self.cells.len() {
            let mut matrix = [0.0; TERMS * TERMS];
            let mut right = [0.0; TERMS];
            let mut load = 0.0;
            for i in 0..count {
                if self.nodes.lobe[i] != cell || self.nodes.pressure[i] <= 0.0 {
                    continue;
                }
                let error = self.nodes.ratio[i].max(0.1).ln();
                let weight = self.nodes.pressure[i].powi(2) * self.nodes.half_length[i];
                let p = legendre(self.abscissa(i));
                for k in 0..TERMS {
                    right[k] += weight * error * p[k];
                    for l in 0..TERMS {
                        matrix[k * TERMS + l] += weight * p[k] * p[l];
                    }
                }
                load += weight;
            }
            if load <= 0.0 {
                continue;
            }
            for k in 0..TERMS {
                matrix[k * TERMS + k] += 1e-3 * load;
            }
            if !linear_system::solve(&mut matrix, TERMS, &mut right) {
                continue;
            }
            for (shape, change) in self.cells[cell].shape.iter_mut().zip(right) {
                let change = (following * change).clamp(-0.5, 0.5);
                *shape -= change;
                moved = moved.max(change.abs());
            }
        }
        self.lengths();
        moved
    }

    /// Hands neighbouring loaded strips over as zones.
    fn emit_fixed(&self, contact_modulus: f64, strips: &mut Strips) {
        let nodes = &self.nodes;
        let count = nodes.y.len();
        let mut i = 0;
        while i < count {
            if nodes.pressure[i] <= 0.0 {
                i += 1;
                continue;
            }
            let begin = i;
            i += 1;
            while i < count && nodes.pressure[i] > 0.0 && nodes.follows(i) {
                i += 1;
            }
            if !strips.has_room_for(i - begin) {
                continue;
            }
            let mut zone = self.push_zone(begin..i, contact_modulus, strips);
            zone.width =
                nodes.y[i - 1] - nodes.y[begin] + 0.5 * (nodes.width[i - 1] + nodes.width[begin]);
            strips.summarise(&mut zone);
            strips.zones.push(zone);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    use crate::geometry::separation::{Separation, SeparationPoint};
    use crate::normal::hertz;
    use crate::normal::strips::FrameLine;

    struct Parabola(f64);

    impl Separation for Parabola {
        fn at(&mut self, u: f64) -> SeparationPoint {
            SeparationPoint { y: u, dy: 1.0, f: self.0 * u * u, x: 0.0 }
        }
    }

    #[test]
    fn ellipses_are_close_to_those_of_hertz() {
        for across in [0.2, 1.0, 20.0, 300.0] {
            let (approach, along) = (5e-5f64, 1.0);
            let ellipse = hertz::ellipse(along, across, approach, 1e11);
            let reach = 1.1 * (approach / across).sqrt();
            let probes: Vec<Probe> = (-20..=20)
                .map(|i| f64::from(i) / 20.0 * reach)
                .map(|u| Probe { u, f: across * u * u })
                .collect();
            let separation = &mut Parabola(across);
            let mut line = FrameLine { separation, approach, radius: 0.5 / along };
            let mut solver = StripSolver::new(15);
            let mut strips = Strips::with_capacity(4, 15);
            assert!(solver.solve_fixed(&mut line, (&probes, approach), 1e11, &mut strips));
            assert_eq!(strips.zones.len(), 1);
            assert_relative_eq!(strips.load(), ellipse.load, max_relative = 2e-2);
            let greatest = strips.zones[0].max_pressure;
            assert_relative_eq!(greatest, ellipse.max_pressure, max_relative = 1e-2);
        }
    }
}
