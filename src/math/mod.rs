//! Mathematics without railway words.

pub mod spline;
