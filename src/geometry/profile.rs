//! A wheel or rail profile: a named curve in its own frame.

use crate::geometry::curve::Curve;

/// Of which body a profile is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProfileKind {
    /// Origin on the running circle: the local rolling radius is the nominal radius plus z.
    Wheel,
    /// Origin at the top of the rail head, before inclination.
    Rail,
}

/// What is wrong with a profile.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ProfileError {
    /// Neither the name of a built-in profile nor a file.
    #[error("\"{name}\" is neither a built-in profile nor a file")]
    Unknown {
        /// The name or path asked for.
        name: String,
    },
}

/// A right-side profile: y to the field side, z down [m]; the curve runs from the flange back
/// (the gauge side of a rail) to the field side.
#[derive(Clone, Debug)]
pub struct Profile {
    /// Built-in name or file, for messages.
    pub name: String,
    /// Of which body.
    pub kind: ProfileKind,
    /// The curve in the profile frame [m].
    pub curve: Curve,
}
