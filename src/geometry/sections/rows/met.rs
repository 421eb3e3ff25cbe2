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
    /// Along the normal of the wheel, after that was lowered by `way` [m].
    pub fn lowered(&self, way: f64) -> f64 {
        self.share * (self.height - way)
    }
}

/// A row that the wheel meets.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::geometry) struct Met<T = f64> {
    pub row: usize,
    pub point: [T; 2],
    /// How the outline goes on to the next row.
    pub direction: [T; 2],
    /// Where it is along the track, and along the axes of the outline, from the wheel marker [m].
    pub place: T,
    pub x: T,
    pub gap: Gap,
    pub along: Along<T>,
    /// Parameter of the wheel opposite and coordinate along the axle there; nothing where it is not
    /// looked for [m].
    pub opposite: Option<[T; 2]>,
}
