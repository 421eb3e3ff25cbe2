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

/// The surface of the wheel straight below a point.
#[derive(Clone, Copy, Debug)]
pub struct Below {
    /// How far below [m].
    pub depth: f64,
    /// Derivatives of that along the track and to the right [-].
    pub slopes: [f64; 2],
    /// Second derivative along the track, but for what the section is curved across a wheel that
    /// yaws [1/m].
    pub bend: f64,
}
