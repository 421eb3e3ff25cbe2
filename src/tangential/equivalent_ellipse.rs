//! The ellipse that stands for a loaded zone in the table of creep forces.
//!
//! Centred at the centroid of the load, with the second moments of the load: for a Hertzian pressure
//!
//! ```text
//! <x²> = a²/5,  <y²> = b²/5
//! ```
//!
//! and a semi-ellipse of half length x_l along rolling has <x²> = x_l²/4 about its own centre. That strips of a yawed wheel are shifted
//! against each other along rolling is left out: particles cross each of them alone. Of the ellipses tried (moments of load, of area,
//! length to width with the area, greatest length with the area) this one has the least error: see docs/validation.md.

use super::rigid_slip::RigidSlip;
use super::tables::{CreepForceTable, EllipseForce, scales};
use super::{CreepForce, Creepage, Rolling};
use crate::material::MaterialPair;
use crate::normal::{Strips, Zone};

/// Semi-axes of an ellipse that is loaded like a zone, or like a part of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EquivalentEllipse {
    /// Along rolling, > 0 [m].
    pub along: f64,
    /// Across, > 0 [m].
    pub across: f64,
}

/// A part of a zone: its load, where that is, and its ellipse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadedPart {
    /// Share of the zone's load, above 0 to 1.
    pub share: f64,
    /// Centroid of its load along the track and across, from that of the zone [m].
    pub centre: [f64; 2],
    /// The ellipse.
    pub ellipse: EquivalentEllipse,
    /// Mean creepage, weighted by load.
    pub creepage: Creepage,
}

/// Greatest ratio of the semi-axes.
const MOST_RATIO: f64 = 1e6;

impl LoadedPart {
    /// The whole of `zone`, which carries load, with the creepage `creepage` at its centroid.
    #[must_use]
    pub fn whole(zone: &Zone, strips: &Strips, creepage: Creepage) -> Self {
        let (mut load, mut along, mut across) = (0.0, 0.0, 0.0);
        for j in zone.first..zone.first + zone.count {
            let weight = strips.half_length[j] * strips.width[j] * strips.pressure[j];
            let arm = strips.y[j] - zone.y;
            load += weight;
            along += weight * strips.half_length[j] * strips.half_length[j];
            across += weight * arm * arm;
        }
        let ellipse = EquivalentEllipse::of_moments(along / load, across / load, zone.width);
        Self { share: 1.0, centre: [0.0; 2], ellipse, creepage }
    }

    /// The part of which strips at y belong to `member(y)`, 0 to 1; nothing where it carries no load.
    #[must_use]
    pub fn of(
        zone: &Zone,
        strips: &Strips,
        slip: &impl RigidSlip,
        member: impl Fn(f64) -> f64,
    ) -> Option<Self> {
        let (mut total, mut load, mut along, mut x, mut y) = (0.0, 0.0, 0.0, 0.0, 0.0);
        let mut creepage = Creepage::default();
        let range = zone.first..zone.first + zone.count;
        let weight_of = |j: usize| strips.half_length[j] * strips.width[j] * strips.pressure[j];
        for j in range.clone() {
            let whole = weight_of(j);
            let weight = whole * member(strips.y[j]);
            total += whole;
            load += weight;
            along += weight * strips.half_length[j] * strips.half_length[j];
            x += weight * strips.x[j];
            y += weight * strips.y[j];
            let own = slip.creepage(j);
            creepage.longitudinal += weight * own.longitudinal;
            creepage.lateral += weight * own.lateral;
            creepage.spin += weight * own.spin;
        }
        if load <= LEAST_SHARE * total {
            return None;
        }
        let y = y / load;
        let across: f64 =
            range.map(|j| weight_of(j) * member(strips.y[j]) * (strips.y[j] - y).powi(2)).sum();
        Some(Self {
            share: load / total,
            centre: [x / load - zone.x, y - zone.y],
            ellipse: EquivalentEllipse::of_moments(along / load, across / load, zone.width),
            creepage: Creepage {
                longitudinal: creepage.longitudinal / load,
                lateral: creepage.lateral / load,
                spin: creepage.spin / load,
            },
        })
    }
}

/// Parts that carry less of the load are nothing.
const LEAST_SHARE: f64 = 1e-9;

impl EquivalentEllipse {
    /// From the means of x_l² and y² over the load [m²]; without a moment across, as a single row of elements has none, from the `width` [m].
    fn of_moments(along: f64, across: f64, width: f64) -> Self {
        let along = (1.25 * along).sqrt();
        let across = if across > 0.0 { (5.0 * across).sqrt() } else { 0.5 * width };
        Self { along, across: across.max(along / MOST_RATIO) }
    }

    /// c = sqrt(a b) [m].
    #[must_use]
    pub fn mean_radius(&self) -> f64 {
        (self.along * self.across).sqrt()
    }

    /// Creep force on the wheel from `table`, for a creepage at the centre and the friction limit μ N > 0 [N]; `area` is that of which a share
    /// slips [m²].
    #[must_use]
    pub fn tabulated_force(
        &self,
        table: &CreepForceTable,
        material: &MaterialPair,
        creepage: &Creepage,
        rolling: Rolling,
        limit: f64,
        area: f64,
    ) -> CreepForce {
        let c = self.mean_radius();
        // However little the limit is, creepages stay finite.
        let scale = (material.shear_modulus * c * c / limit).min(1e60);
        // Backwards the ellipse is the same seen in a mirror along x.
        let direction = rolling.direction();
        let Creepage { longitudinal, lateral, spin } = *creepage;
        let v = [direction * longitudinal, lateral, direction * c * spin]
            .map(|v| (scale * v).clamp(-1e100, 1e100));
        let scales = scales((self.along / self.across).ln(), material.poisson_ratio);
        let EllipseForce { force, slip_share } = table.force(&scales, v);
        CreepForce {
            longitudinal: direction * limit * force[0],
            lateral: limit * force[1],
            spin_moment: direction * limit * c * force[2],
            slip_area: slip_share * area,
            fell_back: false,
        }
    }
}
