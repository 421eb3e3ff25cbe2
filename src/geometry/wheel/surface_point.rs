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
pub struct Below<T = f64> {
    /// How far below [m].
    pub depth: T,
    /// Derivatives of that along the track and to the right [-].
    pub slopes: [T; 2],
    /// Second derivative along the track, but for what the section is curved across a wheel that
    /// yaws [1/m].
    pub bend: T,
    /// What a round wheel that yaws is curved across adds to that; 0 where it varies around [1/m].
    pub across: T,
}
