//! A row where it meets the other body.

use super::along::Along;

/// A row that the wheel meets.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::geometry) struct Met<T = f64> {
    pub row: usize,
    pub point: [T; 2],
    /// F_v and F_x.
    pub direction: [T; 2],
    pub first: [T; 2],
    /// Where it is, from the wheel marker [m].
    pub x: T,
    pub along: Along<T>,
    /// Parameter of the wheel opposite and coordinate to the right there; nothing where it is not
    /// looked for.
    pub opposite: Option<[T; 2]>,
}
