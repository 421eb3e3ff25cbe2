//! Derivatives of a solution of the strips.
//!
//! The solution fulfils a system of equations r(z, p) = 0 in the unknowns z and the pose p. With the unknowns as dual numbers, whose
//! derivatives z' are wanted, the residual has the derivatives r' = (∂r/∂z) z' + (∂r/∂p) p', which have to vanish:
//!
//! ```text
//! z' ← z' - M^-1 r'(z'),   M the Newton matrix at the solution
//! ```
//!
//! M leaves out a little of ∂r/∂z (how radius, tangent and place along the track change with a node that moves), so that this takes a few turns,
//! and ends where r' vanishes. Conditions of edges are linear: their r' is that row of M.

use std::f64::consts::PI;

use super::cell::Cell;
use super::influence::{STATION, centred_at, fall, own_at, shifted_at, shifted_fall};
use super::nodes::Lobe;
use super::solver::StripSolver;
use super::system::{Assembly, SHAPE_REGULARISATION};
use super::zones::greatest_pressure;
use crate::math::dual::Dual;
use crate::math::linear_system::Factors;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// What is to be known about one place of a contact line that moves, at given arc across.
#[derive(Clone, Copy, Debug)]
pub struct MovingPlace<T> {
    /// Parameter of the line [m].
    pub u: T,
    /// Overlap [m].
    pub overlap: T,
    /// Place along the track [m].
    pub x: T,
    /// Unit tangent (y, z) across.
    pub tangent: [T; 2],
    /// Radius of the normal section of the wheel along x [m].
    pub radius: T,
}

/// The overlap along a contact line that moves.
pub trait MovingLine<T> {
    /// The place at coordinate `y` across, near parameter `u`; nothing where a body ends or the lines fold.
    fn across(&mut self, u: f64, y: T) -> Option<MovingPlace<T>>;

    /// Coordinate across of the ridge at parameter `u` of the line; nothing where that is none.
    fn ridge(&mut self, u: f64, y: f64) -> Option<T>;
}

/// One node with derivatives.
#[derive(Clone, Copy, Debug)]
struct Node<T> {
    place: MovingPlace<T>,
    y: T,
    width: T,
    pressure: T,
    half_length: T,
}

/// Memory for derivatives of solutions of the strips; empty before the first.
#[derive(Clone, Debug)]
pub struct StripFollower<T> {
    nodes: Vec<Node<T>>,
    /// Unknowns of all lobes: their values and derivatives.
    unknowns: Vec<T>,
    residuals: Vec<T>,
    matrix: Vec<f64>,
    factors: Factors,
    right: Vec<f64>,
}

impl<T> Default for StripFollower<T> {
    fn default() -> Self {
        Self {
            nodes: Vec::new(),
            unknowns: Vec::new(),
            residuals: Vec::new(),
            matrix: Vec::new(),
            factors: Factors::default(),
            right: Vec::new(),
        }
    }
}

/// Most turns, and the last change of derivatives, over the greatest of the same kind.
const MOST_TURNS: usize = 30;
const LAST_CHANGE: f64 = 1e-9;

/// The solution whose derivatives are wanted, and the scales of its equations.
struct Solution<'a> {
    solver: &'a StripSolver,
    skewed: bool,
    depth: f64,
    scale: f64,
}

impl<const N: usize> StripFollower<Dual<N>> {
    /// Fills `strips` with the zones of `found`, the last solution of `solver`, as they move with `line`; false where they have no derivatives.
    pub fn follow(
        &mut self,
        solver: &mut StripSolver,
        line: &mut impl MovingLine<Dual<N>>,
        contact_modulus: f64,
        found: &Strips,
        strips: &mut Strips<Dual<N>>,
    ) -> bool {
        let has_gap =
            |cell: &Cell| cell.load_ends[0] > cell.edges[0] || cell.load_ends[1] < cell.edges[1];
        if solver.is_mixed || solver.lobes.iter().any(|lobe| has_gap(&solver.cells[lobe.cell])) {
            return false;
        }
        let nodes = &solver.nodes;
        let skewed = nodes.x.iter().any(|x| (x - nodes.x[0]).abs() > 0.0);
        let scale = nodes.ratio.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let deepest = solver.lobes.iter().map(|l| solver.cells[l.cell].deepest[1]);
        let depth = deepest.fold(0.0, f64::max);
        let assembly = Assembly {
            rule: &solver.rule,
            integrals: &solver.integrals,
            cells: &solver.cells,
            lobes: &solver.lobes,
            nodes: &solver.nodes,
            skewed,
            depth,
            scale,
        };
        let size = solver.lobes.len() * assembly.unknowns_per_lobe();
        assembly.assemble(&mut solver.matrices);
        self.matrix.clear();
        for row in 0..size {
            let entry = |column| solver.matrices.newton[assembly.entry(row, column)];
            self.matrix.extend((0..size).map(entry));
        }
        if !self.factors.of(&self.matrix, size) {
            return false;
        }
        let at = Solution { solver, skewed, depth, scale };
        self.begin(&at);
        for _ in 0..MOST_TURNS {
            if !self.place(&at, line) || !self.evaluate(&at, line) {
                return false;
            }
            let change = self.turn(&at);
            if change < LAST_CHANGE {
                return self.place(&at, line) && self.emit(&at, contact_modulus, found, strips);
            }
        }
        false
    }

    /// Takes the unknowns without derivatives.
    fn begin(&mut self, at: &Solution) {
        let (n, terms) = (at.solver.rule.count(), at.solver.rule.terms);
        self.unknowns.clear();
        for lobe in at.solver.lobes.iter() {
            let cell = &at.solver.cells[lobe.cell];
            let ratios = &at.solver.nodes.ratio[lobe.first..lobe.first + n];
            let all = ratios.iter().chain(&cell.edges).chain(&cell.shape[..terms]);
            self.unknowns.extend(all.map(|value| Dual::from(*value)));
        }
    }

    /// Ends of a lobe.
    fn edges(&self, at: &Solution, lobe: usize) -> [Dual<N>; 2] {
        let n = at.solver.rule.count();
        let first = lobe * (n + 2 + at.solver.rule.terms) + n;
        [self.unknowns[first], self.unknowns[first + 1]]
    }

    /// Places all nodes; false where one has no derivatives.
    fn place(&mut self, at: &Solution, line: &mut impl MovingLine<Dual<N>>) -> bool {
        let rule = &at.solver.rule;
        let n = rule.count();
        let block = n + 2 + rule.terms;
        self.nodes.clear();
        for (number, lobe) in at.solver.lobes.iter().enumerate() {
            let [left, right] = self.edges(at, number);
            let (middle, half) = ((left + right) * 0.5, (right - left) * 0.5);
            let unknowns = &self.unknowns[number * block..(number + 1) * block];
            for t in 0..n {
                let i = lobe.first + t;
                let y = middle + half * rule.nodes[t];
                let Some(place) = line.across(at.solver.nodes.u[i], y) else { return false };
                let exponent: Dual<N> =
                    (0..rule.terms).map(|l| unknowns[n + 2 + l] * rule.legendre[t][l]).sum();
                let pressure = unknowns[t].at_least(0.0) * at.solver.nodes.edge_shape[i];
                let per_pressure = place.radius * (2.0 * PI) * (-exponent).exp();
                let half_length = (pressure * per_pressure).max(half * 1e-12);
                let width = half * rule.weights[t];
                self.nodes.push(Node { place, y, width, pressure, half_length });
            }
        }
        true
    }

    /// Residuals of all equations; false where a ridge has no derivatives.
    fn evaluate(&mut self, at: &Solution, line: &mut impl MovingLine<Dual<N>>) -> bool {
        let rule = &at.solver.rule;
        let (n, block) = (rule.count(), rule.count() + 2 + rule.terms);
        let size = self.unknowns.len();
        self.residuals.clear();
        self.residuals.resize(size, Dual::from(0.0));
        for (number, lobe) in at.solver.lobes.iter().enumerate() {
            let begin = number * block;
            let nodes = &self.nodes[lobe.first..lobe.first + n];
            let load: Dual<N> = nodes.iter().map(|a| a.width * a.pressure * a.half_length).sum();
            let cell = &at.solver.cells[lobe.cell];
            for t in 0..n {
                let i = lobe.first + t;
                let [displacement, fall] = self.sums(at, number, t);
                let node = &self.nodes[i];
                let is_loaded = self.unknowns[begin + t] > 0.0;
                let mut rest = (displacement - node.place.overlap) / at.depth;
                let finds_edge = (t == 1 && cell.is_free(0)) || (t == n - 2 && cell.is_free(1));
                if !is_loaded && !finds_edge {
                    rest += self.unknowns[begin + t] / at.scale;
                }
                self.residuals[begin + t] = rest;
                if is_loaded && (rule.outer..n - rule.outer).contains(&t) {
                    let squared = node.half_length * node.half_length;
                    let error = fall * node.place.radius / squared - 0.5 * STATION * STATION;
                    let share = node.width * node.pressure * node.half_length / load;
                    for l in 0..rule.terms {
                        self.residuals[begin + n + 2 + l] += share * error * rule.legendre[t][l];
                    }
                }
            }
            for l in 1..rule.terms {
                let row = begin + n + 2 + l;
                let shape = self.unknowns[row];
                self.residuals[row] += shape * SHAPE_REGULARISATION;
            }
            // What closes an edge is linear.
            for side in 0..2 {
                let outermost = begin + if side == 0 { 0 } else { n - 1 };
                self.residuals[outermost] = self.linear(outermost);
                let row = begin + n + side;
                self.residuals[row] = self.linear(row);
                if side == 1 && !cell.is_free(1) {
                    let Some(ridge) = line.ridge(cell.range[1], cell.bounds[1]) else {
                        return false;
                    };
                    let [first, joint] = self.edges(at, number);
                    let [_, last] = self.edges(at, number + 1);
                    self.residuals[row] = (joint - ridge) / (last - first);
                }
            }
        }
        true
    }

    /// A row of the Newton matrix times the unknowns.
    fn linear(&self, row: usize) -> Dual<N> {
        let size = self.unknowns.len();
        let factors = &self.matrix[row * size..(row + 1) * size];
        factors.iter().zip(&self.unknowns).map(|(factor, unknown)| *unknown * *factor).sum()
    }

    /// Displacement at node `t` of a lobe and its fall: the sums of [`system`](super::system).
    fn sums(&self, at: &Solution, lobe: usize, t: usize) -> [Dual<N>; 2] {
        let rule = &at.solver.rule;
        let n = rule.count();
        let Lobe { first, .. } = at.solver.lobes[lobe];
        let i = first + t;
        let own = &self.nodes[i];
        let (mut displacement, mut fallen) = (Dual::from(0.0), Dual::from(0.0));
        let [left, right] = self.edges(at, lobe);
        let half = (right - left) * 0.5;
        let (mut taken_out, mut fall_out) = (Dual::from(0.0), Dual::from(0.0));
        for (j, node) in self.nodes.iter().enumerate() {
            if j == i {
                continue;
            }
            let [a, b] = [own.place.tangent, node.place.tangent];
            let cosine = (a[0] * b[0] + a[1] * b[1]).at_least(0.0);
            let (dy, dx) = (own.y - node.y, own.place.x - node.place.x);
            let inverse = Dual::from(1.0) / node.half_length;
            let (sigma, station) = (dy * inverse, own.half_length * inverse * STATION);
            let (centre, less) = if at.skewed {
                let xi = dx * inverse;
                let centre = shifted_at(xi, sigma);
                (centre, shifted_fall(&centre, station, xi, sigma))
            } else {
                let centre = centred_at(sigma);
                (centre, fall(&centre, station, sigma))
            };
            let load = node.width * cosine * node.pressure;
            displacement += load * centre.d;
            fallen += load * less.d;
            let Some(k) = j.checked_sub(first).filter(|&k| k < n) else { continue };
            let logarithm = half * (-2.0 * rule.corrections_of(k)[rule.target_of_node(t)]);
            let mended = logarithm * node.pressure;
            displacement += mended * centre.log;
            fallen += mended * less.log;
            let out = own_at(dy / own.half_length);
            taken_out += node.width * out.d + logarithm * out.log;
            fall_out += node.width * out.fall + logarithm * out.log_fall;
        }
        displacement -= own.pressure * taken_out;
        fallen -= own.pressure * fall_out;
        for edge in [left, right] {
            let sigma = (edge - own.y).abs() / own.half_length;
            let [[integral, _], [less, _]] = at.solver.integrals.at(sigma);
            displacement += own.pressure * own.half_length * integral;
            fallen += own.pressure * own.half_length * less;
        }
        [displacement, fallen]
    }

    /// Takes what is left of the residuals' derivatives off those of the unknowns; the greatest change over the greatest of the same kind.
    fn turn(&mut self, at: &Solution) -> f64 {
        let n = at.solver.rule.count();
        let block = n + 2 + at.solver.rule.terms;
        let mut worst: f64 = 0.0;
        for direction in 0..N {
            self.right.clear();
            self.right.extend(self.residuals.iter().map(|r| r.slopes[direction]));
            self.factors.solve(&mut self.right);
            let (mut change, mut greatest) = ([0.0f64; 3], [0.0f64; 3]);
            for (row, (unknown, step)) in self.unknowns.iter_mut().zip(&self.right).enumerate() {
                let slope = &mut unknown.slopes[direction];
                *slope -= step;
                let kind = match row % block {
                    place if place < n => 0,
                    place if place < n + 2 => 1,
                    _ => 2,
                };
                change[kind] = change[kind].max(step.abs());
                greatest[kind] = greatest[kind].max(slope.abs());
            }
            for (change, greatest) in change.into_iter().zip(greatest) {
                // Not a number is no end.
                let share = if change == 0.0 { 0.0 } else { change / greatest };
                worst = if share <= worst { worst } else { share };
            }
        }
        worst
    }

    /// Hands the nodes over as the zones of `found`.
    fn emit(
        &self,
        at: &Solution,
        contact_modulus: f64,
        found: &Strips,
        strips: &mut Strips<Dual<N>>,
    ) -> bool {
        let StripSolver { rule, lobes, nodes, .. } = at.solver;
        let n = rule.count();
        let modulus = PI * contact_modulus;
        for zone in found.zones.iter() {
            let starts =
                |lobe: &Lobe| nodes.y[lobe.first].to_bits() == found.y[zone.first].to_bits();
            let Some(begin) = lobes.iter().position(starts) else { return false };
            let end = begin + zone.count / n;
            let mut own: Zone<Dual<N>> =
                Zone { first: strips.y.len(), count: zone.count, ..Zone::default() };
            for lobe in &lobes[begin..end] {
                for node in &self.nodes[lobe.first..lobe.first + n] {
                    strips.y.push(node.y);
                    strips.width.push(node.width);
                    strips.x.push(node.place.x);
                    strips.half_length.push(node.half_length);
                    strips.pressure.push(node.pressure * modulus);
                    strips.u.push(node.place.u);
                    own.length = own.length.max(node.half_length * 2.0);
                }
                let pressure = |t: usize| self.nodes[lobe.first + t].pressure;
                let greatest = greatest_pressure(&rule.nodes, pressure) * modulus;
                own.max_pressure = own.max_pressure.max(greatest);
            }
            own.width = self.edges(at, end - 1)[1] - self.edges(at, begin)[0];
            strips.summarise(&mut own);
            strips.zones.push(own);
        }
        true
    }
}
