//! Profiles, the placed wheel and rail, and where they touch.

#[doc(hidden)]
pub mod contacts;
#[doc(hidden)]
pub mod curves;
#[doc(hidden)]
pub mod profiles;
#[doc(hidden)]
pub mod rail;
pub(crate) mod sections;
pub(crate) mod uneven;
#[doc(hidden)]
pub mod wheel;

pub use curves::curve;
pub use profiles::profile;
pub use profiles::standard_profiles;
#[doc(hidden)]
pub use wheel::contact_line;
