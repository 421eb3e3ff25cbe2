//! Of which body a profile is.

use std::fmt;

/// Of which body a profile is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProfileKind {
    /// Origin on the nominal rolling circle: the local rolling radius is the nominal radius plus z.
    Wheel,
    /// Origin at the top of the rail head, before inclination; text and SIMPACK files as they
    /// stand.
    Rail,
}

impl ProfileKind {
    /// The side of the curve that is outside the body, as of
    /// [`Curve::normal`](crate::geometry::curve::Curve::normal): a wheel lies above its profile, a
    /// rail below it.
    pub(crate) fn outside(self) -> f64 {
        match self {
            Self::Wheel => 1.0,
            Self::Rail => -1.0,
        }
    }
}

impl fmt::Display for ProfileKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Wheel => "wheel",
            Self::Rail => "rail",
        })
    }
}
