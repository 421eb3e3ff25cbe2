//! Profiles, the placed wheel and rail, and where they touch.

pub mod curve;
pub mod profile;
pub mod separation;
