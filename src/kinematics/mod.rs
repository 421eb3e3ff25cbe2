//! Motion of wheel and rail against each other at a contact.

pub mod creepage;
pub(crate) mod motion;
mod rigid_body;
