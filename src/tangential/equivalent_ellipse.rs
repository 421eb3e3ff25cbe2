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
use super::tables::tabulated::Tabulated;
use super::tables::{CreepForceTable, EllipseForce};
use super::{CreepForce, Creepage, Rolling};
use crate::material::MaterialPair;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// Semi-axes of an ellipse that is loaded like a zone, or like a part of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EquivalentEllipse<T = f64> {
    /// Along rolling, > 0 [m].
    pub along: T,
    /// Across, > 0 [m].
    pub across: T,
}

/// A part of a zone: its load, where that is, and its ellipse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadedPart<T = f64> {
    /// Share of the zone's load, above 0 to 1.
    pub share: T,
    /// Centroid of its load along the track and across, from that of the zone [m].
    pub centre: [T; 2],
    /// The ellipse.
    pub ellipse: EquivalentEllipse<T>,
    /// Mean creepage, weighted by load.
    pub creepage: Creepage<T>,
}

/// Greatest ratio of the semi-axes.
const MOST_RATIO: f64 = 1e6;

impl<T: Real> LoadedPart<T> {
    /// The whole of `zone`, which carries load, with the creepage `creepage` at its centroid.
    #[must_use]
    pub fn whole(zone: &Zone<T>, strips: &Strips<T>, creepage: Creepage<T>) -> Self {
        let (mut load, mut along, mut across) = (T::from(0.0), T::from(0.0), T::from(0.0));
        for j in zone.first..zone.first + zone.count {
            let weight = strips.half_length[j] * strips.width[j] * strips.pressure[j];
            let arm = strips.y[j] - zone.y;
            load += weight;
            along += weight * strips.half_length[j] * strips.half_length[j];
            across += weight * arm * arm;
        }
        let ellipse = EquivalentEllipse::of_moments(along / load, across / load, zone.width);
        Self { share: T::from(1.0), centre: [T::from(0.0); 2], ellipse, creepage }
    }

    /// The part of which strips at y belong to `member(y)`, 0 to 1; nothing where it carries no load.
    #[must_use]
    pub fn of(
        zone: &Zone<T>,
        strips: &Strips<T>,
        slip: &impl RigidSlip<T>,
        member: impl Fn(T) -> T,
    ) -> Option<Self> {
        let [mut total, mut load, mut along, mut x, mut y] = [T::from(0.0); 5];
        let mut creepage = Creepage::<T>::default();
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
        if load <= total * LEAST_SHARE {
            return None;
        }
        let y = y / load;
        let across: T =
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

impl<T: Real> EquivalentEllipse<T> {
    /// From the means of x_l² and y² over the load [m²]; without a moment across, as a single row of elements has none, from the `width` [m].
    fn of_moments(along: T, across: T, width: T) -> Self {
        let along = (along * 1.25).sqrt();
        let across = if across > 0.0 { (across * 5.0).sqrt() } else { width * 0.5 };
        Self { along, across: across.max(along / MOST_RATIO) }
    }

    /// c = sqrt(a b) [m].
    #[must_use]
    pub fn mean_radius(&self) -> T {
        (self.along * self.across).sqrt()
    }
}

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

impl<T: Tabulated> RollingEllipse<'_, T> {
    /// Creep force on the wheel from `table`, moment about the centre; `area` is that of which a share slips [m²].
    #[must_use]
    pub fn tabulated_force(&self, table: &CreepForceTable, area: T) -> CreepForce<T> {
        let &Self { ellipse, material, creepage, rolling, limit } = self;
        let c = ellipse.mean_radius();
        // However little the limit is, creepages stay finite.
        let scale = (material.shear_modulus * c * c / limit).at_most(1e60);
        // Backwards the ellipse is the same seen in a mirror along x.
        let direction = rolling.direction();
        let Creepage { longitudinal, lateral, spin } = creepage;
        let v = [longitudinal * direction, lateral, c * direction * spin]
            .map(|v| (scale * v).within(-1e100, 1e100));
        let log_ratio = (ellipse.along / ellipse.across).ln();
        let EllipseForce { force, slip_share } =
            T::tabulated(table, log_ratio, material.poisson_ratio, v);
        CreepForce {
            longitudinal: limit * direction * force[0],
            lateral: limit * force[1],
            spin_moment: limit * direction * c * force[2],
            slip_area: slip_share * area,
            fell_back: false,
        }
    }
}
