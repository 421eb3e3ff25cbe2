//! A row where it meets the other body.

use super::along::Along;

/// How far a row is from the wheel that is to meet it.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::geometry) struct Gap {
    /// Straight below the axle; at least where nothing is opposite [m].
    pub height: f64,
    /// Component of the wheel's normal down [-].
    pub share: f64,
    /// How fast the gap along that normal grows with the row parameter [-].
    pub growth: f64,
}

impl Gap {
    /// Along the normal of the wheel, after that was lowered by `way` [m]: as far where the wheel
    /// faces up.
    pub fn lowered(&self, way: f64) -> f64 {
        self.share.abs() * (self.height - way)
    }
}

/// Where a row was looked at, and the wheel opposite.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::geometry) struct Opposite {
    /// Along the track, from the wheel marker [m].
    pub place: f64,
    /// Parameter of the wheel, and coordinate along the axle [m].
    pub s: f64,
    pub axial: f64,
    /// The way along the track from there to where the row is met, so short that all goes along
    /// with it evenly [m].
    pub rest: f64,
}

/// Where a row is taken that nothing touches.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::geometry) struct Untouched {
    /// Along the track, from the wheel marker [m].
    pub place: f64,
    /// How far ahead of the contact line that is taken to be [m].
    pub ahead: f64,
}

/// A row that the wheel meets.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::geometry) struct Met<T = f64> {
    pub row: usize,
    pub point: [T; 2],
    /// How the outline goes on to the next row.
    pub direction: [T; 2],
    /// Where it is along the axes of the outline, from the wheel marker [m].
    pub x: T,
    pub gap: Gap,
    pub along: Along<T>,
    /// Nothing where the wheel is not looked for.
    pub opposite: Option<Opposite>,
    /// Where it is taken then.
    pub untouched: Untouched,
}
