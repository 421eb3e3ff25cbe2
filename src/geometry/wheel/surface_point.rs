//! A point of a wheel's surface.

/// A point of the wheel's surface on a line across the track.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// Parameter of the wheel's profile [m].
    pub s: f64,
    /// Distance along the line [m].
    pub depth: f64,
    /// Normal out of the wheel, of length one.
    pub normal: [f64; 3],
}
