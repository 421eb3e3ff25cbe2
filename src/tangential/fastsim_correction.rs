//! FASTSIM on the equivalent ellipse of a zone. Its error there, against the force of the table,
//! corrects FASTSIM on the zone.
//!
//! FASTSIM marches over the ellipse of the zone with the bound, the resolution along and the way of
//! blending flexibilities that it has on the zone itself. The strips of all ellipses are those of
//! one circle, stretched.

use super::equivalent_ellipse::{EquivalentEllipse, RollingEllipse};
use super::fastsim::{Fastsim, Marched};
use super::flexibility::ZoneFlexibility;
use super::rigid_slip::Growth;
use super::{CreepForce, Creepage, Flexibilities};
use crate::math::quadrature::GaussLegendre;
use crate::math::real::Real;

/// Strips of the ellipse: as many as are marched at once.
const STRIPS: usize = 32;

/// The strips of a circle of radius 1 with Hertzian pressure of amplitude 1.
#[derive(Clone, Debug)]
pub struct EllipseStrips {
    strips: [CircleStrip; STRIPS],
    load: f64,
}

/// Its place across, its width, and its half length, which is its pressure too.
#[derive(Clone, Copy, Debug)]
struct CircleStrip {
    y: f64,
    width: f64,
    half_length: f64,
}

impl Default for EllipseStrips {
    fn default() -> Self {
        let rule = GaussLegendre::new(STRIPS);
        let strips = std::array::from_fn(|j| {
            let (y, width) = (rule.nodes[j], rule.weights[j]);
            CircleStrip { y, width, half_length: (1.0 - y * y).sqrt() }
        });
        let load = |CircleStrip { width, half_length, .. }: &CircleStrip| {
            std::f64::consts::FRAC_PI_2 * width * half_length * half_length
        };
        let load = strips.iter().map(load).sum();
        Self { strips, load }
    }
}

impl EllipseStrips {
    /// The force of FASTSIM on the ellipse `rolling`, moment about its centre.
    pub fn force<T: Real>(
        &self,
        fastsim: &Fastsim,
        flexibilities: Flexibilities,
        rolling: &RollingEllipse<'_, T>,
    ) -> CreepForce<T> {
        let &RollingEllipse { ellipse, material, creepage, rolling, limit } = rolling;
        let mut flexibility = ZoneFlexibility::of_ellipse(ellipse.along, ellipse.across, material);
        if flexibilities == Flexibilities::Blended {
            flexibility = flexibility.blended(&creepage, limit);
        }
        let circle = &self.strips;
        let EquivalentEllipse { along, across } = ellipse;
        let area = along * across;
        // Times the amplitude of the pressure, which the circle has as 1.
        let friction = limit / (area * self.load);
        let parabola = fastsim
            .parabola(self.load, circle.iter().map(|strip| [strip.half_length, strip.width]));
        // Lengths along in units of a, across in units of b.
        let strip = |j: usize| {
            let CircleStrip { y, width, half_length } = circle[j];
            let Creepage { longitudinal, lateral, spin } = creepage;
            let growth = Growth {
                longitudinal: along
                    * (longitudinal / flexibility.longitudinal
                        - spin * (across * y) / flexibility.spin),
                lateral: along * lateral / flexibility.lateral,
                twist: along * along * spin / flexibility.spin,
            };
            // Pressure of amplitude 1.
            let bound = fastsim.bounding_pressure(parabola, half_length, half_length);
            Marched {
                half_length: half_length.into(),
                width: width.into(),
                growth,
                bound: friction * bound,
            }
        };
        let mut total = CreepForce::<T>::default();
        fastsim.march(0..STRIPS, rolling, strip, |j, f| {
            total.longitudinal += area * f.longitudinal;
            total.lateral += area * f.lateral;
            total.spin_moment += area * (along * f.moment - across * circle[j].y * f.longitudinal);
            total.slip_area += area * f.slip_area;
        });
        total
    }
}
