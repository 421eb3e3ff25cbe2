//! Motion of wheel and rail against each other at a contact.

pub mod creepage;
pub mod motion;
mod rigid_body;
