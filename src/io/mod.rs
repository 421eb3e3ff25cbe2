//! Files: the only place that reads and writes them, and the only one with millimetres in it.

mod deviation_file;
mod deviation_rows;
mod draft;
mod friction_file;
mod irregularity_file;
mod miniprof;
pub(crate) mod named_file;
mod point_lines;
mod profile_file;
mod section_table;
mod simpack;
mod slice_list;
mod slice_tokens;
mod slices_file;
mod stated;
mod table;
mod two_column;

pub use deviation_file::{Deviations, load_deviations};
pub use draft::{Draft, write as write_whole};
pub use friction_file::load_friction;
pub use irregularity_file::load_irregularities;
#[doc(hidden)]
pub use named_file::full_name;
pub(crate) use profile_file::{can_be_written, profile_file};
pub use profile_file::{load_profile, save_profile};
pub use slices_file::load_slices;
pub use table::number;
