//! The contact element: one wheel and the rails under it.

mod boundary_contact;
mod chosen_models;
mod contact_forces;
mod curved_zone;
mod derivatives;
mod evaluate;
mod flattened;
pub mod input;
mod models;
mod moving_contact;
mod number;
pub mod output;
pub mod parameters;
mod rail_contact;
mod rail_frame;
mod rail_friction;
mod rail_walk;
mod ranges;
mod start;
mod stiffness;
mod strip_contact;
mod strip_damping;
pub mod subject;
mod uneven;
pub(crate) mod vertical_load;
mod wear_sums;
pub mod work_pairs;
mod worn_profiles;

pub use evaluate::{Element, Work};
pub use flattened::FlatContact;
pub use input::Input;
pub use output::Output;
pub use parameters::Parameters;
pub use start::{StartWarning, sunk_message};
pub use wear_sums::WearState;
pub use worn_profiles::WornBody;
