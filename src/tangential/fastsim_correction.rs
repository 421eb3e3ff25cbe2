//! FASTSIM on the equivalent ellipse of a zone. Its error there, against the force of the table,
//! corrects FASTSIM on the zone.
//!
//! FASTSIM marches over the ellipse of the zone with the bound, the resolution along and the way of
//! blending flexibilities that it has on the zone itself. The strips of all ellipses are those of
//! one circle, stretched.

use super::equivalent_ellipse::{EquivalentEllipse, RollingEllipse};
use super::fastsim::Fastsim;
use super::flexibility::ZoneFlexibility;
use super::own_friction::OwnFriction;
use super::rigid_slip::{Growth, RigidSlip};
use super::{CreepForce, Creepage, Flexibilities, LoadedZone};
use crate::math::quadrature::GaussLegendre;
use crate::math::real::Real;
use crate::normal::{LoadedStrip, Strips, Zone};

/// Strips of the ellipse: as many as are marched at once.
const STRIPS: usize = 32;

/// The strips of a circle of radius 1 with Hertzian pressure of amplitude 1.
#[derive(Clone, Debug)]
pub struct EllipseStrips {
    strips: Strips,
    zone: Zone,
}

impl Default for EllipseStrips {
    fn default() -> Self {
        let mut strips = Strips::with_capacity(1, STRIPS);
        let rule = GaussLegendre::new(STRIPS);
        let mut load = 0.0;
        for (y, width) in rule.nodes.iter().zip(&rule.weights) {
            let half_length = (1.0 - y * y).sqrt();
            let (y, width, pressure) = (*y, *width, half_length);
            strips.push(LoadedStrip { y, width, x: 0.0, half_length, pressure, u: y });
            load += std::f64::consts::FRAC_PI_2 * width * half_length * half_length;
        }
        Self { strips, zone: Zone { count: STRIPS, load, ..Zone::default() } }
    }
}

/// Rigid slip of an ellipse seen on the circle: lengths along in units of a, across in units of b.
#[derive(Clone, Copy, Debug)]
struct StretchedSlip<'a, T> {
    circle: &'a Strips,
    ellipse: EquivalentEllipse<T>,
    creepage: Creepage<T>,
}

impl<T: Real> RigidSlip<T> for StretchedSlip<'_, T> {
    fn mean(&self) -> Creepage<T> {
        self.creepage
    }

    fn growth(&self, j: usize, flexibility: &ZoneFlexibility<T>) -> Growth<T> {
        let EquivalentEllipse { along, across } = self.ellipse;
        let Creepage { longitudinal, lateral, spin } = self.creepage;
        let y = across * self.circle.y[j];
        Growth {
            longitudinal: along
                * (longitudinal / flexibility.longitudinal - spin * y / flexibility.spin),
            lateral: along * lateral / flexibility.lateral,
            twist: along * along * spin / flexibility.spin,
        }
    }

    fn creepage(&self, _: usize) -> Creepage<T> {
        self.creepage
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
        let area = ellipse.along * ellipse.across;
        let loaded = LoadedZone {
            zone: &Zone { count: STRIPS, load: self.zone.load.into(), ..Zone::default() },
            strips: circle,
            material,
            slip: StretchedSlip { circle, ellipse, creepage },
            // Times the amplitude of the pressure, which the circle has as 1.
            friction: limit / (area * self.zone.load),
            own_friction: OwnFriction::none(),
            load_factor: T::from(1.0),
        };
        let mut total = CreepForce::<T>::default();
        fastsim.strip_forces(&loaded, rolling, &flexibility, |j, f| {
            total.longitudinal += area * f.longitudinal;
            total.lateral += area * f.lateral;
            total.spin_moment +=
                area * (ellipse.along * f.moment - ellipse.across * circle.y[j] * f.longitudinal);
            total.slip_area += area * f.slip_area;
        });
        total
    }
}
