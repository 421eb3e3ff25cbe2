//! What can be wrong with a profile, and what to do about it.

use crate::geometry::profiles::profile_kind::ProfileKind;

/// What is wrong with a profile. Coordinates in messages are in millimetres, as in the files.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
// Fields are what the text says of them.
#[allow(missing_docs)]
pub enum ProfileError {
    /// Neither the name of a built-in profile nor a file that exists.
    #[error(
        "\"{name}\" is neither a built-in {kind} profile ({built_in}) nor a file that exists \
         (looked for {looked_for}); give one of these names, put the file there or give its full path"
    )]
    Unknown { name: String, kind: ProfileKind, built_in: &'static str, looked_for: String },
    /// A built-in profile of the other body.
    #[error(
        "\"{name}\" is the profile of the other body; a {kind} profile is wanted: {built_in} or a file"
    )]
    OtherBody { name: String, kind: ProfileKind, built_in: &'static str },
    /// An analytic profile whose number is missing or not admitted.
    #[error("\"{name}\" has no admitted number after the colon: give {allowed}")]
    BadNumber { name: String, allowed: &'static str },
    /// A file that cannot be read.
    #[error("{file}: cannot be read: {reason}; check the path and the permissions of the file")]
    Unreadable { file: String, reason: String },
    /// A file that cannot be written.
    #[error("{file}: cannot be written: {reason}; name a file in a folder that exists")]
    Unwritable { file: String, reason: String },
    /// A file that is of none of the known formats.
    #[error("{file}:{line}: not a profile: {what}")]
    UnknownFormat { file: String, line: usize, what: String },
    /// A line that should hold a point and does not.
    #[error("{file}:{line}: \"{text}\" is not a point: {expected}")]
    BadLine { file: String, line: usize, text: String, expected: &'static str },
    /// A coordinate that is not a finite number.
    #[error("{file}:{line}: \"{text}\" is not finite; delete the point or measure it again")]
    NotFinite { file: String, line: usize, text: String },
    /// An entry of the header that is not admitted.
    #[error("{file}:{line}: \"{text}\" is not admitted; {allowed}")]
    BadHeader { file: String, line: usize, text: String, allowed: &'static str },
    /// A file whose header or extension says that it is of the other body.
    #[error(
        "{file}:{line}: by its header or its extension this is not a {kind} profile; name another file, \
         or correct the type"
    )]
    WrongKind { file: String, line: usize, kind: ProfileKind },
    /// A file that ends before its profile does.
    #[error("{file}:{line}: the file is cut off: {what}; copy it again from its source")]
    Truncated { file: String, line: usize, what: String },
    /// A file of slices or a table of sections that is not as it should be.
    #[error("{file}:{line}: {what}")]
    BadSlices { file: String, line: usize, what: String },
    /// Fewer points than a profile can be made of.
    #[error(
        "{file}:{line}: too few points: {found} different ones up to here, {needed} are needed; \
         check that all points are in the file"
    )]
    TooFewPoints { file: String, line: usize, found: usize, needed: usize },
    /// A profile far smaller or larger than any wheel or rail.
    #[error(
        "{file}:{line}: the units look wrong: the profile is {extent_mm} mm across, a wheel or rail 10 to \
         1000; {remedy}"
    )]
    WrongUnits { file: String, line: usize, extent_mm: f64, remedy: &'static str },
    /// Points that are not in order along the profile.
    #[error(
        "{file}:{line}: the profile doubles back at y = {y_mm} mm, z = {z_mm} mm; put the points in order \
         along the profile and delete stray ones, or, if this is noise, raise profile.smoothing"
    )]
    DoublesBack { file: String, line: usize, y_mm: f64, z_mm: f64 },
    /// A profile that crosses itself.
    #[error(
        "{file}:{line}: the profile crosses itself: the stretch after this line meets the one after line \
         {other_line}; put the points in order along the profile, or delete the loop"
    )]
    SelfCrossing { file: String, line: usize, other_line: usize },
    /// A wheel profile that does not reach its nominal rolling circle.
    #[error(
        "{file}:{line}: the wheel does not reach its nominal rolling circle, y = 0: it spans y = {from_mm} to {to_mm} mm; \
         shift y so that 0 is the nominal rolling circle (or the flange back, then all y are positive)"
    )]
    OffRunningCircle { file: String, line: usize, from_mm: f64, to_mm: f64 },
    /// A wheel that is measured from its field side.
    #[error(
        "{file}:{line}: y counts from the field side, {from_mm} to {to_mm} mm, with the flange at its far end: which circle is the nominal running \
         circle is not said; mirror the file and shift it so that y = 0 is there: {remedy}"
    )]
    FlangeFar { file: String, line: usize, from_mm: f64, to_mm: f64, remedy: &'static str },
    /// A rail whose gauge cannot be measured.
    #[error(
        "\"{name}\" has no gauge face {depth_mm} mm below its top; give a profile that reaches down there on its gauge side \
         (negative y), a smaller track.gauge_depth, or {placement} = position or origin"
    )]
    NoGaugeFace { name: String, depth_mm: f64, placement: String },
}

const MM: f64 = 1e-3;

/// A length in millimetres with the digits that a message needs.
pub(crate) fn rounded_mm(length: f64) -> f64 {
    let digits = 1e4;
    (length / MM * digits).round() / digits
}
