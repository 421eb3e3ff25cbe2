//! Derivatives of a solution backwards: those by all that the nodes of the layout are, one after the
//! other and exact as those in one direction, which are few however many numbers these follow from.

use super::layout::Node;
use super::newton::Settled;
use super::points::Row;
use super::sizes::NODES;
use super::solver::{One, TractionStrips, carrier, solve};
use super::span::Span;
use super::{equations::Strip, layout::Layout};
use crate::kinematics::creepage::Creepage;
use crate::math::real::Real;
use crate::math::tape::Taped;
use crate::tangential::rigid_slip::RigidSlip;
use crate::tangential::{LoadedZone, Rolling, StripForce};

/// Numbers of a node.
const NUMBERS: usize = 12;

impl TractionStrips {
    /// As [`strip_forces`](Self::strip_forces), with derivatives backwards.
    pub fn taped_strip_forces(
        &mut self,
        loaded: &LoadedZone<'_, impl RigidSlip<Taped>, Taped>,
        span: &Span<Taped>,
        rolling: Rolling,
        mut each: impl FnMut(usize, StripForce<Taped>),
    ) -> Option<Settled> {
        let value = |j| carrier(loaded, span, rolling, j, Taped::value);
        if !self.layout.lay(span.strips.clone(), span.edges.map(Taped::value), value) {
            return None;
        }
        let material = loaded.material;
        let (poisson_ratio, shear_modulus) = (material.poisson_ratio, material.shear_modulus);
        let settled = solve(self, poisson_ratio, shear_modulus.value);
        settled.left.is_finite().then_some(())?;
        let mut layout = Layout::with_capacity(span.strips.len());
        let moving = |j| carrier(loaded, span, rolling, j, |x| x);
        if !layout.lay(span.strips.clone(), span.edges, moving) {
            return None;
        }
        let states = self.taped_states(&layout.nodes, poisson_ratio, shear_modulus);
        for (place, j) in layout.places.iter().zip(span.strips.clone()) {
            let strips = loaded.strips;
            let bound = loaded.friction_coefficient(j) * strips.pressure[j];
            let sizes = [bound, strips.half_length[j], strips.width[j]];
            each(j, self.resultant(sizes, rolling, place, &states));
        }
        Some(settled)
    }

    /// The solved tractions as they move with `nodes` and the shear modulus.
    fn taped_states(
        &mut self,
        nodes: &[Node<Taped>; NODES],
        poisson_ratio: f64,
        shear_modulus: Taped,
    ) -> Vec<Strip<Taped>> {
        let operands: Vec<Taped> = nodes.iter().flat_map(numbers).chain([shear_modulus]).collect();
        // By operand: the rates of all tractions.
        let mut rates = Vec::with_capacity(operands.len());
        for moved in 0..operands.len() {
            let to = |n: usize, x: Taped| One {
                value: x.value,
                slopes: [f64::from(u8::from(n == moved))],
            };
            for (i, (node, own)) in self.moving.layout.nodes.iter_mut().zip(nodes).enumerate() {
                let own = numbers(own);
                *node = of_numbers(&std::array::from_fn(|n| to(i * NUMBERS + n, own[n])));
            }
            self.follow(poisson_ratio, to(NODES * NUMBERS, shear_modulus));
            let slopes = |row: &Row<One>| row.map(|one| one.slopes[0]);
            let all: [[Row; 2]; NODES] =
                std::array::from_fn(|i| self.moving.strips[i].r.each_ref().map(slopes));
            rates.push(all);
        }
        let mut states = vec![Strip::<Taped>::default(); NODES];
        for (i, state) in states.iter_mut().enumerate() {
            let solved = &self.newton.strips[i];
            for component in 0..2 {
                for m in 0..self.points.count {
                    let slopes = rates.iter().map(|all| all[i][component][m]);
                    state.r[component][m] =
                        Taped::combined(solved.r[component][m], operands.iter().zip(slopes));
                }
            }
            // What slips has no derivatives.
            state.v = solved.v.map(|row| row.map(Taped::from));
        }
        states
    }
}

fn numbers<T: Copy>(node: &Node<T>) -> [T; NUMBERS] {
    let &Node { x, y, half_length, bound, strength, edges, reach, creepage } = node;
    let Creepage { longitudinal, lateral, spin } = creepage;
    let [low, high] = edges;
    let [before, behind] = reach;
    [x, y, half_length, bound, strength, low, high, before, behind, longitudinal, lateral, spin]
}

fn of_numbers<T: Copy>(numbers: &[T; NUMBERS]) -> Node<T> {
    let &[
        x,
        y,
        half_length,
        bound,
        strength,
        low,
        high,
        before,
        behind,
        longitudinal,
        lateral,
        spin,
    ] = numbers;
    Node {
        x,
        y,
        half_length,
        bound,
        strength,
        edges: [low, high],
        reach: [before, behind],
        creepage: Creepage { longitudinal, lateral, spin },
    }
}
