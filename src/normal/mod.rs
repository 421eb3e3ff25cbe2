//! Normal contact: from the separation of wheel and rail to loaded zones of strips with their
//! pressure.
//!
//! Every model fills the same [`Strips`]: strips along rolling, each with a semi-elliptical
//! pressure, grouped in separate loaded zones. Tangential models see nothing else.

pub(crate) mod boundary_element;
pub mod damping;
mod descent;
mod element_pressure;
pub mod hertz;
pub mod least_energy;
pub(crate) mod piotrowski_kik;
mod problem;
pub(crate) mod rail_elements;
pub(crate) mod shape_correction;
mod solve;
mod strips;
pub(crate) mod uneven;
mod zones;

pub use descent::{Descent, Pose, Slope, way_between};
pub use element_pressure::ElementPressure;
pub use problem::{NormalModel, NormalProblem, strips_of_rule};
pub use shape_correction::ShapeFit;
pub use solve::{solve, solve_in_frame};
pub use strips::{LoadedStrip, Strips, Zone};
pub use zones::Edge;
