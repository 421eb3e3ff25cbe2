//! Where wheel and rail touch, and how far apart they are around these places.

#[doc(hidden)]
pub mod clearance;
pub(crate) mod clearances;
#[doc(hidden)]
pub mod contact;
#[doc(hidden)]
pub mod contact_search;
pub(crate) mod line_separation;
pub(crate) mod moving_contact;
pub(crate) mod moving_separation;
#[doc(hidden)]
pub mod separation;
pub(crate) mod waves_along;
