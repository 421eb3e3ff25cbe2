//! Numbers with which contacts are brought to forces: plain ones, and ones with derivatives.

use super::models::Models;
use crate::element::wear_sums::ZoneWear;
use crate::geometry::contacts::line_separation::{LineSeparation, RailSeparation};
use crate::geometry::contacts::moving_separation::MovingSeparation;
use crate::geometry::wheel::contact_line::ContactLine;
use crate::math::dual::Dual;
use crate::math::tape::Taped;
use crate::tangential::{CreepNumber, UnderLaw};

/// Numbers with which contacts are brought to forces; wear is that of plain ones alone.
pub trait ElementNumber: CreepNumber {
    /// The separation of wheel and rail in the frame of a contact.
    type Separation<'a>: RailSeparation<Self> + Clone;

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
