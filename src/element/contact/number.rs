//! Numbers with which contacts are brought to forces: plain ones, and ones with derivatives.

use super::models::Models;
use super::zone_surface::ZoneSurface;
use crate::element::parameters::NormalModel;
use crate::element::wear_sums::ZoneWear;
use crate::geometry::contacts::line_separation::{Lifting, LineSeparation, RailSeparation};
use crate::geometry::contacts::moving_separation::MovingSeparation;
use crate::geometry::wheel::contact_line::ContactLine;
use crate::math::dual::Dual;
use crate::math::tape::Taped;
use crate::normal::Zone;
use crate::normal::piotrowski_kik::Influence;
use crate::tangential::{CreepNumber, UnderLaw};

/// Numbers with which contacts are brought to forces; deviations along the track and wear are those
/// of plain ones alone.
pub trait ElementNumber: CreepNumber + Influence {
    /// The separation of wheel and rail in the frame of a contact.
    type Separation<'a>: RailSeparation<'a, Self> + Clone;

    /// The surface of an uneven wheel with the contact line `line` in `zone`; `contact_u` is the
    /// parameter of the line in the contact.
    fn zone_surface(
        _line: &ContactLine<Self>,
        _contact_u: Self,
        _: &Lifting,
        _: &Zone<Self>,
        _: &Models<Self>,
    ) -> ZoneSurface<Self> {
        ZoneSurface::even()
    }

    /// Records the wear of zone number `index` on rail number `k`, from 0, which rolls as `law`
    /// says.
    fn record(
        _line: &ContactLine<Self>,
        _k: usize,
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

impl ElementNumber for Taped {
    type Separation<'a> = MovingSeparation<'a, Self>;
}

impl ElementNumber for f64 {
    type Separation<'a> = LineSeparation<'a>;

    fn zone_surface(
        line: &ContactLine,
        contact_u: f64,
        lifting: &Lifting,
        zone: &Zone,
        models: &Models,
    ) -> ZoneSurface {
        // All of an ellipse lies over its contact point.
        let is_ellipse = models.normal == NormalModel::Hertz;
        ZoneSurface::new(lifting, zone, &models.strips, |u| {
            line.even_at(if is_ellipse { contact_u } else { u }).x
        })
    }

    fn record(
        line: &ContactLine,
        k: usize,
        index: usize,
        law: &UnderLaw,
        models: &mut Models,
        separation: &mut LineSeparation,
    ) {
        let Models { wear, strips, .. } = models;
        let Some(wear) = wear else { return };
        let zone = &strips.zones[index];
        let state = ZoneWear {
            law: *law,
            section_radius: line.wheel_point(zone.u).section_radius,
            range: line.range(),
        };
        wear.record(k, index, strips, &state, separation);
    }
}
