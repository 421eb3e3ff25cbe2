//! Mathematics without railway words.

pub mod elliptic;
pub mod root;
pub mod spline;
