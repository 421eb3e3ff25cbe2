//! The ellipse that stands for a zone, or for a lobe of it, in the table of creep forces: its
//! moments, creepage and friction, and its force.
//!
//! It is centred at the centroid of the load and has the second moments of the load. The ellipse of
//! the flexibilities L1, L2 and L3 has those of the outline instead: that one, and the formulas of
//! the semi-axes for both, are in [`outline`](super::outline).
//!
//! That strips of a yawed wheel are shifted against each other along rolling is left out: particles
//! cross each of them alone. Moments of the load give the least error for the table,
//! moments of the outline for the flexibilities (docs/validation.md).

use super::neck::Extent;
pub use super::outline::EquivalentEllipse;
use super::tables::EllipseForce;
use super::tables::tabulated::{ForceTable, tabulated};
use super::{Convergence, CreepForce, Creepage, LoadedZone, Rolling};
use crate::material::MaterialPair;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// A part of a zone: its load and its ellipse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadedPart<T = f64> {
    /// Share of the zone's load, above 0 to 1.
    pub share: T,
    /// The ellipse.
    pub ellipse: EquivalentEllipse<T>,
    /// Mean creepage, weighted by load.
    pub creepage: Creepage<T>,
    /// Mean coefficient of friction over that of the zone, weighted by load [-].
    pub friction: T,
}

impl<T: Real> LoadedPart<T> {
    /// The whole of `zone`, which carries load, with the creepage `creepage` at its centroid.
    pub fn whole(zone: &Zone<T>, strips: &Strips<T>, creepage: Creepage<T>) -> Self {
        let [mut load, mut along, mut across, mut within] = [T::from(0.0); 4];
        for j in zone.range() {
            let (half_length, width) = (strips.half_length[j], strips.width[j]);
            let weight = strips.weight(j);
            let arm = strips.y[j] - zone.y;
            load += weight;
            along += weight * half_length * half_length;
            across += weight * arm * arm;
            within += weight * width * width;
        }
        let ellipse = EquivalentEllipse::of_load(along / load, across / load, within / load);
        let one = T::from(1.0);
        Self { share: one, ellipse, creepage, friction: one }
    }

    /// The part that belongs to `extent`; nothing where it carries no load.
    pub fn of(loaded: &LoadedZone<'_, T>, extent: &Extent<T>) -> Option<Self> {
        let &LoadedZone { zone, strips, slip, friction, own_friction, .. } = loaded;
        let [mut total, mut load, mut along, mut within, mut y] = [T::from(0.0); 5];
        let mut excess = T::from(0.0);
        let mut creepage = Creepage::<T>::default();
        let range = zone.range();
        for j in range.clone() {
            let whole = strips.weight(j);
            let weight = whole * extent.member(strips.y[j]);
            total += whole;
            load += weight;
            along += weight * strips.half_length[j] * strips.half_length[j];
            within += weight * strips.width[j] * strips.width[j];
            y += weight * strips.y[j];
            let own = slip.creepage(j);
            creepage.longitudinal += weight * own.longitudinal;
            creepage.lateral += weight * own.lateral;
            creepage.spin += weight * own.spin;
            if let Some(own) = own_friction.coefficient(j) {
                excess += weight * (own - friction);
            }
        }
        if load <= total * MIN_SHARE {
            return None;
        }
        let y = y / load;
        let across: T = range
            .map(|j| strips.weight(j) * extent.member(strips.y[j]) * (strips.y[j] - y).powi(2))
            .sum();
        Some(Self {
            share: load / total,
            ellipse: EquivalentEllipse::of_load(along / load, across / load, within / load),
            creepage: Creepage {
                longitudinal: creepage.longitudinal / load,
                lateral: creepage.lateral / load,
                spin: creepage.spin / load,
            },
            friction: if friction > 0.0 { excess / (load * friction) + 1.0 } else { T::from(1.0) },
        })
    }
}

/// Parts that carry less of the load are nothing.
const MIN_SHARE: f64 = 1e-9;

/// An ellipse that rolls under load.
#[derive(Clone, Copy, Debug)]
pub struct RollingEllipse<'a, T = f64> {
    /// The ellipse.
    pub ellipse: EquivalentEllipse<T>,
    /// Elastic constants of both bodies.
    pub material: &'a MaterialPair<T>,
    /// Creepage at its centre.
    pub creepage: Creepage<T>,
    /// Which end leads.
    pub rolling: Rolling,
    /// Friction limit μ N > 0 [N].
    pub limit: T,
}

impl<T: Real> RollingEllipse<'_, T> {
    /// Creep force on the wheel from `table`, moment about the centre; `area` is that of which a
    /// share slips [m²].
    pub fn tabulated_force(&self, table: &impl ForceTable, area: T) -> CreepForce<T> {
        let &Self { ellipse, material, creepage, rolling, limit } = self;
        // Backwards the ellipse is the same seen in a mirror along x.
        let direction = rolling.direction();
        let forward = Creepage {
            longitudinal: creepage.longitudinal * direction,
            spin: creepage.spin * direction,
            ..creepage
        };
        let (poisson_ratio, modulus) = (material.poisson_ratio, material.shear_modulus);
        let EllipseForce { force, slip_share } =
            ellipse.tabulated(table, poisson_ratio, modulus, &forward, limit);
        CreepForce {
            longitudinal: force[0] * direction,
            lateral: force[1],
            spin_moment: force[2] * direction,
            slip_area: slip_share * area,
            convergence: Convergence::default(),
        }
    }
}

impl<T: Real> EquivalentEllipse<T> {
    /// Longitudinal and lateral force and moment about the centre from `table` on the body that
    /// creeps, rolling forward under a friction `limit` > 0 [N], with the shear modulus of the bodies
    /// [Pa]; forces in N and N m.
    pub fn tabulated(
        &self,
        table: &impl ForceTable,
        poisson_ratio: T,
        shear_modulus: T,
        &Creepage { longitudinal, lateral, spin }: &Creepage<T>,
        limit: T,
    ) -> EllipseForce<T> {
        let c = self.mean_radius();
        // However little the limit is, creepages stay finite.
        let scale = (shear_modulus * c * c / limit).at_most(1e60);
        let v = [longitudinal, lateral, c * spin].map(|v| (scale * v).within(-1e100, 1e100));
        let log_ratio = (self.along / self.across).ln();
        let EllipseForce { force: [x, y, moment], slip_share } =
            tabulated(table, log_ratio, poisson_ratio, v);
        EllipseForce { force: [limit * x, limit * y, limit * c * moment], slip_share }
    }
}
