//! The two lobes of a zone with a neck, and the ellipse of each.

use super::LoadedZone;
use super::equivalent_ellipse::LoadedPart;
use super::neck::{Extent, Neck, Side};
use crate::math::real::Real;

/// The two lobes of a zone with a neck.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lobes<T = f64> {
    /// What is between them.
    pub neck: Neck<T>,
    /// The left and the right one, as far as they carry load.
    pub parts: [Option<LoadedPart<T>>; 2],
}

impl<T: Real> Lobes<T> {
    /// Those of a zone, if it has a neck.
    pub fn of(loaded: &LoadedZone<'_, T>) -> Option<Self> {
        let neck = Neck::of(loaded.zone, loaded.strips)?;
        let part = |side| LoadedPart::of(loaded, &Extent::Lobe(neck, side));
        let parts = [Side::Left, Side::Right].map(part);
        Some(Self { neck, parts })
    }
}
