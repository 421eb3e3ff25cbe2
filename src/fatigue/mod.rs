//! Rolling contact fatigue from the stresses below the surface of a wheel or a rail.
//!
//! A passage takes each particle through the stresses along its line below the contact
//! ([`crate::subsurface`]). What they do to it is judged in three ways:
//!
//! - the shakedown map (Johnson 1989): whether the material yields at all, and whether residual
//!   stresses can keep it from yielding in every passage ([`ContactFatigue`]);
//! - the indices of Ekberg, Kabo and Andersson (2002) ([`ContactFatigue`]);
//! - the equivalent stress of Dang Van over the passage, particle by particle ([`DangVan`]), summed
//!   over passages in a [`FatigueMap`].
//!
//! Stresses are those of an elastic half-space. Strengths are the user's ([`Strength`]).

mod contact;
mod dang_van;
mod map;
mod smallest_ball;
mod strength;

pub use contact::{ContactFatigue, Response};
pub use dang_van::{DangVan, Equivalent};
pub use map::{Cell, FatigueMap, Passage};
pub use strength::Strength;
