//! Numbers with which contacts are brought to forces: plain ones, and ones with derivatives.

use super::contact_forces::ContactForces;
use super::models::Models;
use super::parameters::NormalModel;
use super::uneven::ZoneSurface;
use super::wear_sums::ZoneWear;
use crate::geometry::line_separation::{Lifting, LineSeparation, RailSeparation};
use crate::geometry::moving_separation::MovingSeparation;
use crate::math::dual::Dual;
use crate::normal::Zone;
use crate::normal::piotrowski_kik::Influence;
use crate::tangential::{CreepNumber, UnderLaw};

/// Numbers with which contacts are brought to forces; deviations along the track and wear are those of plain ones alone.
pub trait ElementNumber: CreepNumber + Influence {
    /// The separation of wheel and rail in the frame of a contact.
    type Separation<'a>: RailSeparation<'a, Self> + Clone;

    /// The surface of an uneven wheel in `zone`.
    fn zone_surface(
        _: &ContactForces<Self>,
        _: &Lifting,
        _: &Zone<Self>,
        _: &Models<Self>,
    ) -> ZoneSurface<Self> {
        ZoneSurface::even()
    }

    /// Records the wear of zone number `index`, which rolls as `law` says.
    fn record(
        _: &ContactForces<Self>,
        _index: usize,
        _law: &UnderLaw<Self>,
        _: &mut Models<Self>,
        _: &mut Self::Separation<'_>,
    ) {
    }
}

impl<const N: usize> ElementNumber for Dual<N> {
    type Separation<'a> = MovingSeparation<'a, Self>;
}

impl ElementNumber for f64 {
    type Separation<'a> = LineSeparation<'a>;

    fn zone_surface(
        forces: &ContactForces,
        lifting: &Lifting,
        zone: &Zone,
        models: &Models,
    ) -> ZoneSurface {
        // All of an ellipse lies over its contact point.
        let is_ellipse = models.normal == NormalModel::Hertz;
        ZoneSurface::new(lifting, zone, &models.strips, |u| {
            forces.line.even_at(if is_ellipse { forces.contact.u } else { u }).x
        })
    }

    fn record(
        forces: &ContactForces,
        index: usize,
        law: &UnderLaw,
        models: &mut Models,
        separation: &mut LineSeparation,
    ) {
        let Models { wear, strips, .. } = models;
        let (Some(wear), line) = (wear, &forces.line) else { return };
        let zone = &strips.zones[index];
        let state = ZoneWear {
            law: *law,
            section_radius: line.wheel_point(zone.u).section_radius,
            range: line.range(),
        };
        wear.record(forces.k, index, strips, &state, separation);
    }
}
