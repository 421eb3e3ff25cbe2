//! The contact element: one wheel and the rails under it.

mod adjoint;
mod contact;
mod derivative_memory;
mod derivatives;
mod evaluate;
mod free_rolling;
mod gradient;
pub mod input;
mod load_by_stiffness;
mod moving_rails;
pub mod output;
pub mod parameters;
mod prepare;
mod quasi_static_rails;
mod rail;
mod remark;
mod remarks;

mod start;
mod start_warning;
mod step_limit;
mod stiffness;
pub mod subject;
pub(crate) mod vertical_load;
mod wear_sums;
mod wheel_on_rails;
mod work;
pub(crate) mod work_pairs;
mod worn_profiles;

pub(crate) use free_rolling::FreeRolling;
pub use gradient::{Gradient, ParameterSlopes};
pub use input::Input;
pub(crate) use load_by_stiffness::Carried;
pub use output::Output;
pub use parameters::Parameters;
pub use parameters::foundation::TrackState;
pub use rail::flattened::FlatContact;
pub use remark::Remark;
pub use remarks::{place_remark, remarks, without_effect};
pub use start_warning::StartWarning;
pub use step_limit::{Inertia, StepLimit};
pub use stiffness::ContactSlopes;
pub use wear_sums::WearState;
pub use wheel_on_rails::Element;
pub use work::Work;
pub use worn_profiles::WornBody;
