//! Derivatives of a solution, one direction after the other.
//!
//! The equations R(r, p) = 0 hold for all p. With tractions that do not move their rates are R',
//! all of which has to vanish:
//!
//! ```text
//! r' = -(∂R/∂r)^-1 R'
//! ```

use super::equations::Equations;
use super::newton::Settled;
use super::solver::{One, TractionStrips, carrier, solve};
use super::span::Span;
use crate::math::dual::Dual;
use crate::math::real::Real;
use crate::tangential::rigid_slip::RigidSlip;
use crate::tangential::{LoadedZone, Rolling, StripForce};

/// What is left of the system that couples strips, as a share of its right side.
const COUPLING_LEFT: f64 = 1e-12;

impl TractionStrips {
    /// As [`strip_forces`](Self::strip_forces), with derivatives: a strip comes once for each
    /// direction.
    pub fn moving_strip_forces<const N: usize>(
        &mut self,
        loaded: &LoadedZone<'_, impl RigidSlip<Dual<N>>, Dual<N>>,
        span: &Span<Dual<N>>,
        rolling: Rolling,
        mut each: impl FnMut(usize, StripForce<Dual<N>>),
    ) -> Option<Settled> {
        let value = |j| carrier(loaded, span, rolling, j, |x: Dual<N>| x.value);
        if !self.layout.lay(span.strips.clone(), span.edges.map(|edge| edge.value), value) {
            return None;
        }
        let material = loaded.material;
        let settled = solve(self, material.poisson_ratio, material.shear_modulus.value);
        settled.left.is_finite().then_some(())?;
        for direction in 0..N {
            let to = |x: Dual<N>| One { value: x.value, slopes: [x.slopes[direction]] };
            let moving = |j| carrier(loaded, span, rolling, j, to);
            if !self.moving.layout.lay(span.strips.clone(), span.edges.map(to), moving) {
                return None;
            }
            self.follow(material.poisson_ratio, to(material.shear_modulus));
            for (place, j) in self.moving.layout.places.iter().zip(span.strips.clone()) {
                let strips = loaded.strips;
                let bound = to(loaded.friction_coefficient(j) * strips.pressure[j]);
                let sizes = [bound, to(strips.half_length[j]), to(strips.width[j])];
                let force = self.resultant(sizes, rolling, place, &self.moving.strips);
                let back = |one: One| {
                    let mut number = Dual::from(if direction == 0 { one.value } else { 0.0 });
                    number.slopes[direction] = one.slopes[0];
                    number
                };
                each(
                    j,
                    StripForce {
                        longitudinal: back(force.longitudinal),
                        lateral: back(force.lateral),
                        moment: back(force.moment),
                        slip_area: back(force.slip_area),
                    },
                );
            }
        }
        Some(settled)
    }

    /// Moves the tractions with the layout.
    pub(super) fn follow(&mut self, poisson_ratio: f64, shear_modulus: One) {
        let Self { points, layout, influence, newton, moving, .. } = self;
        let nodes = &moving.layout.nodes;
        moving.influence.fill(nodes, points, poisson_ratio);
        for (strip, solved) in moving.strips.iter_mut().zip(&newton.strips) {
            strip.r = solved.r.map(|row| row.map(One::from));
        }
        let equations = Equations { nodes, points, influence: &moving.influence, shear_modulus };
        equations.evaluate(&mut moving.strips);
        let rates = &moving.strips;
        let fixed = Equations {
            nodes: &layout.nodes,
            points,
            influence,
            shear_modulus: shear_modulus.value(),
        };
        newton.direction(&fixed, COUPLING_LEFT, |i, _| {
            let strip = &rates[i];
            std::array::from_fn(|b| {
                std::array::from_fn(|m| (strip.r[b][m] - strip.bounded[b][m]).slopes[0])
            })
        });
        for (i, strip) in moving.strips.iter_mut().enumerate() {
            for (row, step) in strip.r.iter_mut().zip(newton.step(i)) {
                for (r, step) in row.iter_mut().zip(step) {
                    r.slopes[0] = -step;
                }
            }
        }
    }
}
